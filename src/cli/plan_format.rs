//! What `plan` and `drive` print: about the run, or its path as a file for other programs.

use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

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

/// Reads what `drive` prints: a drive has no rows by iteration.
pub fn of_drives() -> impl TypedValueParser<Value = Format> {
    let formats = || Format::value_variants().iter().filter(|format| **format != Format::Csv);
    PossibleValuesParser::new(formats().filter_map(ValueEnum::to_possible_value)).map(move |id| {
        let found = formats().find(|format| format.to_possible_value().is_some_and(|value| value.get_name() == id));
        found.copied().unwrap_or(Format::Text)
    })
}

/// The best path of a planner that has ended, as a file; `scenario` is the map as its changes have left it.
pub fn path_file(format: PathFormat, scenario: &Scenario, planner: &dyn Planner) -> Result<Outcome, CliError> {
    let kind = planner.objective().path_kind();
    let best = planner.best().and_then(|best| PlannedPath::new(scenario, best.result().0, kind));
    let Some(path) = best else {
        say("note: no path was found, so there is none to write");
        return Ok(Outcome { text: String::new(), fine: false });
    };
    write_path(format, &path)
}

/// A path as a file; what was assumed is said.
pub fn write_path(format: PathFormat, path: &PlannedPath<'_>) -> Result<Outcome, CliError> {
    let file = format.write(path)?;
    text::notes(&file.notices);
    Ok(Outcome::fine(file.text))
}
