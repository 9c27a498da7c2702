//! `tracker`: the best known values of planners on scenarios, each with what proves it.

mod check;
pub mod entry;
pub mod folder;
mod proof;
mod renew;
mod run;
mod table;

use std::path::PathBuf;

use clap::Subcommand;

use super::Outcome;
use super::error::CliError;
use folder::Tracker;

pub use proof::{Proof, check_session};

/// Where the tracker's files are, seen from the project's folder.
pub const FOLDER: &str = "experiments/tracker";

/// Repeats, makes and lists best known values
#[derive(clap::Args)]
#[command(after_help = "\
A tracker is a folder with scenarios/ID.toml, each naming a map, and entries/ID/PLANNER.toml or entries/ID/PLANNER--NAME.toml, each with a
value and what proves it. `submit` adds an entry to it.

Examples:
  formicarium tracker check
  formicarium tracker table > experiments/tracker/README.md
  formicarium tracker run --seeds 1-100 --only ship-20x20 --planner ant-system

Exit code 1 when an entry does not hold.")]
pub struct Args {
    #[command(subcommand)]
    what: What,
}

/// The folder that is looked at.
#[derive(clap::Args)]
pub struct Where {
    /// The tracker's folder
    #[arg(long = "tracker", value_name = "DIR", default_value = FOLDER)]
    folder: PathBuf,
}

impl Where {
    pub fn open(&self) -> Result<Tracker, CliError> {
        Tracker::open(&self.folder)
    }
}

#[derive(Subcommand)]
enum What {
    Check(check::Args),
    Renew(renew::Args),
    Run(run::Args),
    Table(table::Args),
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    match &args.what {
        What::Check(args) => check::run(args),
        What::Renew(args) => renew::run(args),
        What::Run(args) => run::run(args),
        What::Table(args) => table::run(args),
    }
}
