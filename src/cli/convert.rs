//! `convert`: from any map format to any other.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::ValueEnum;
use formicarium::exact;
use formicarium::formats::{self, Export, Imported};
use formicarium::map::Movement;
use formicarium::scenario::{Scenario, ScenarioSpec};

use super::error::CliError;
use super::{Outcome, input, text};

/// Converts a map to another format, told by the output's ending
#[derive(clap::Args)]
#[command(after_help = "\
Endings: .map and .scen (MovingAI; a .scen lists start and goal with the exact optimum),
.csv .txt .m (matrix), .json (scenario)

Examples:
  formicarium convert grid.m grid.map
  formicarium convert grid.csv grid.json --invert
  formicarium convert arena2.map - --as matrix | head")]
pub struct Args {
    /// The file to read
    input: PathBuf,
    /// The file to write; `-` needs --as
    output: PathBuf,
    /// movingai-map, movingai-scen, matrix or scenario, whatever the ending
    #[arg(long = "as", value_enum, hide_possible_values = true, value_name = "FORMAT")]
    format: Option<Format>,
    /// Swap free and blocked cells
    #[arg(long)]
    invert: bool,
}

/// A format that can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    MovingaiMap,
    MovingaiScen,
    Matrix,
    Scenario,
}

impl Format {
    /// The format of a file name's ending.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "map" => Some(Self::MovingaiMap),
            "scen" => Some(Self::MovingaiScen),
            "csv" | "txt" | "m" => Some(Self::Matrix),
            "json" => Some(Self::Scenario),
            _ => None,
        }
    }

    /// The text of a map in this format.
    pub fn write(self, map: &Imported) -> Result<String, CliError> {
        let export = match self {
            Self::MovingaiMap => Export::MovingaiMap,
            Self::MovingaiScen => Export::MovingaiScen { optimal: listed_optimum(map)? },
            Self::Matrix => Export::Matrix,
            Self::Scenario => Export::Scenario,
        };
        Ok(formats::export(&map.grid, &map.spec, export))
    }

    /// Whether start and goal are lost.
    fn drops_ends(self) -> bool {
        matches!(self, Self::MovingaiMap | Self::Matrix)
    }
}

/// The optimum under the benchmark's rules: 8 moves, both cells beside a diagonal step free.
fn listed_optimum(map: &Imported) -> Result<f64, CliError> {
    let spec = ScenarioSpec { movement: Movement::default(), ..map.spec.clone() };
    let scenario = Arc::new(Scenario::new(map.grid.clone(), spec)?);
    exact::optimum(&scenario).ok_or_else(|| {
        CliError::usage("no path leads from start to goal, so there is no optimum to list", "choose other ends, or write a .map")
    })
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let format = args.format.or_else(|| Format::of(&args.output)).ok_or_else(|| {
        let message = format!("the ending of `{}` tells no format", args.output.display());
        CliError::usage(message, "use .map, .scen, .csv or .json, or name the format with --as")
    })?;
    let mut map = input::import(&args.input)?;
    if args.invert {
        map = map.invert()?;
    }
    text::notes(&map.notices);
    if format.drops_ends() && !map.ends_were_chosen() {
        let (start, goal) = (text::cell(map.spec.start), text::cell(map.spec.goals[0].at));
        eprintln!("note: this format holds the cells alone, not start {start} and goal {goal}; a .json keeps them");
    }
    let written = format.write(&map)?;
    input::write(Some(&args.output), written).map(Outcome::fine)
}
