//! What `plan` prints: about the run, or its path as a file for other programs.

use clap::ValueEnum;
use clap::builder::PossibleValue;

use crate::formats::{PathFormat, PlannedPath};
use crate::planner::Planner;
use crate::scenario::{Scenario, ScenarioSpec};

use super::error::CliError;
use super::streams::say;
use super::{Outcome, text};

/// What is printed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Format {
    Text,
    Json,
    Csv,
    Path(PathFormat),
}

impl ValueEnum for Format {
    fn value_variants<'a>() -> &'a [Self] {
        const { &Self::all() }
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(match self {
            Self::Text => "text",
            Self::Json => "json",
            Self::Csv => "csv",
            Self::Path(format) => format.id(),
        }))
    }
}

impl Format {
    const fn all() -> [Self; 3 + PathFormat::ALL.len()] {
        let mut all = [Self::Text; 3 + PathFormat::ALL.len()];
        (all[1], all[2]) = (Self::Json, Self::Csv);
        let mut next = 0;
        while next < PathFormat::ALL.len() {
            all[3 + next] = Self::Path(PathFormat::ALL[next]);
            next += 1;
        }
        all
    }

    /// Whether a path on this map can be written so, before anything is planned.
    pub fn check(self, spec: &ScenarioSpec) -> Result<(), CliError> {
        match self {
            Self::Path(format) => Ok(format.check(spec)?),
            _ => Ok(()),
        }
    }
}

/// The best path of a planner that has ended, as a file; `scenario` is the map as its changes have left it.
pub fn path_file(format: PathFormat, scenario: &Scenario, planner: &dyn Planner) -> Result<Outcome, CliError> {
    let kind = planner.objective().path_kind();
    let best = planner.best().and_then(|best| PlannedPath::new(scenario, best.result().0, kind));
    let Some(path) = best else {
        say("note: no path was found, so there is none to write");
        return Ok(Outcome { text: String::new(), fine: false });
    };
    let file = format.write(&path)?;
    text::notes(&file.notices);
    Ok(Outcome::fine(file.text))
}
