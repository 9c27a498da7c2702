//! Which planner, with which values: the arguments of the commands that run one.

use crate::catalog;
use crate::error::ParamError;
use crate::params::{Value, Values};
use crate::planner::PlannerEntry;

/// A planner of the catalog and its values.
#[derive(clap::Args)]
pub struct PlannerArgs {
    /// Id in the catalog
    #[arg(long, value_name = "ID")]
    planner: String,
    /// A named parameter set of the planner
    #[arg(long, value_name = "NAME")]
    pub preset: Option<String>,
    /// The same seed gives the same result, bit for bit, on every machine
    #[arg(long, default_value_t = 1, allow_negative_numbers = true)]
    pub seed: u32,
    /// A parameter of the planner, over preset and default; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = assignment)]
    set: Vec<(String, Value)>,
}

impl PlannerArgs {
    /// # Errors
    /// [`ParamError::UnknownPlanner`].
    pub fn entry(&self) -> Result<&'static PlannerEntry, ParamError> {
        catalog::find(&self.planner)
    }

    /// What was set, by key.
    pub fn values(&self) -> Values {
        self.set.iter().cloned().collect()
    }
}

/// `KEY=VALUE` of `--set`.
pub fn assignment(text: &str) -> Result<(String, Value), String> {
    let (key, value) =
        text.split_once('=').ok_or_else(|| format!("`{text}` is no assignment: write key=value such as rho=0.1"))?;
    Ok((key.trim().into(), Value::parse(value.trim())))
}
