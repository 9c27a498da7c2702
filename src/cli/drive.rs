//! `drive`: a robot that drives where things move.

mod obstacle;
mod report;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Serialize;

use super::Outcome;
use super::error::CliError;
use super::input::{self, ScenarioArgs};
use super::plan_format::{self, Format, write_path};
use super::planner_args::PlannerArgs;
use super::streams::say;
use super::text;
use crate::drive::{DRIVE, Drive, DriveParams, DriveStep, Driver, End};
use crate::error::{Error, FormatError};
use crate::formats::{MAX_TEXT_BYTES, PathFormat, PlannedPath};
use crate::map::Cell;
use crate::params::{Params, Value, Values};
use crate::scenario::{DriveSpec, Scenario, ScenarioSpec, Track};
use obstacle::Obstacle;

/// Has a robot drive where walls change and obstacles move, planning again on its way
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  formicarium drive maze.csv --planner d-star-lite --from 0,0 --to 19,19 --obstacle 10,3:10,15
  formicarium drive maze.csv --planner ant-system --from 0,0 --to 19,19 --obstacle 4,4:12,4,end=leave,from=3 --iterations 10
  formicarium drive site.json --planner astar --sight 5 --hold 3 --format json
  formicarium drive arena.map --scen arena.map.scen:200 --planner d-star-lite --drive traffic.json
  formicarium drive lab.yaml --planner d-star-lite --from -2m,-0.5m --to 2m,0.5m --obstacle 0m,-1m:0m,1m --format nav-msgs

An obstacle goes in straight lines from cell to cell: X,Y:X,Y:…, in cells or in metres, then size=N, from=STEP, each=STEPS on a cell,
end=stay|back-and-forth|loop|leave. --drive is a JSON object as `drive` in a scenario; docs/formats.md has its fields.
Exit code 1 when the robot gave up.")]
pub struct Args {
    #[command(flatten)]
    scenario: ScenarioArgs,
    #[command(flatten)]
    planner: PlannerArgs,
    /// What moves, in place of the scenario's `drive`
    #[arg(long, value_name = "F.json")]
    drive: Option<PathBuf>,
    /// One more obstacle that moves, there and back unless `end` says otherwise; may be repeated
    #[arg(long, value_name = "X,Y:X,Y…[,KEY=VALUE…]", value_parser = obstacle::read, allow_hyphen_values = true)]
    obstacle: Vec<Obstacle>,
    /// From how far the robot sees a change, in cells [default: the scenario's, else it knows at once]
    #[arg(long, value_name = "CELLS", allow_negative_numbers = true)]
    sight: Option<f64>,
    /// Iterations of each planning, of planners that have them [default: 20]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    iterations: Option<f64>,
    /// Begins anew at each planning, instead of going on with trails or costs
    #[arg(long)]
    forget: bool,
    /// When it plans again: changed (with every change it learns of) or blocked [default: changed]
    #[arg(long, value_name = "WHEN")]
    replan: Option<String>,
    /// Steps for which it waits for the next cell before it looks for another way [default: 0]
    #[arg(long, value_name = "STEPS", allow_negative_numbers = true)]
    hold: Option<f64>,
    /// Waits in a row after which it gives up [default: 100]
    #[arg(long, value_name = "STEPS", allow_negative_numbers = true)]
    patience: Option<f64>,
    /// Moves and waits after which it gives up [default: 10000]
    #[arg(long, value_name = "STEPS", allow_negative_numbers = true)]
    longest: Option<f64>,
    /// text, or json with every step; or the way that was driven for other programs: path-csv, path-json, nav-msgs (ROS 2), geojson, svg
    #[arg(long, hide_possible_values = true, default_value = "text", value_parser = plan_format::of_drives())]
    format: Format,
}

impl Args {
    pub fn wants_json(&self) -> bool {
        self.format == Format::Json
    }

    fn params(&self) -> Result<DriveParams, CliError> {
        let numbers =
            [("iterations", self.iterations), ("hold", self.hold), ("patience", self.patience), ("longest", self.longest)];
        let numbers = numbers.into_iter().filter_map(|(key, number)| Some((key.to_owned(), Value::Number(number?))));
        let replan = self.replan.iter().map(|when| ("replan".to_owned(), Value::Text(when.clone())));
        let keep = ("keep".to_owned(), Value::Flag(!self.forget));
        Ok(DriveParams::read(DRIVE, &numbers.chain(replan).chain([keep]).collect::<Values>())?)
    }

    /// The scenario with what moves in it.
    fn load(&self) -> Result<Arc<Scenario>, CliError> {
        if self.scenario.asks_for_a_curve() {
            let message = "a robot drives from cell to cell: --smooth has no effect on its way";
            return Err(CliError::usage(message, "leave it out; `plan --smooth` has the curve of a path"));
        }
        let scenario = self.scenario.load()?;
        let mut moving = match &self.drive {
            Some(path) => read(path)?,
            None => scenario.spec.drive.clone().unwrap_or_default(),
        };
        let tracks = self.obstacle.iter().map(|obstacle| obstacle.on(&scenario.spec));
        moving.tracks.extend(tracks.collect::<Result<Vec<Track>, _>>()?);
        moving.sight = self.sight.or(moving.sight);
        let spec = ScenarioSpec { drive: Some(moving), ..scenario.spec.clone() };
        Ok(Arc::new(Scenario::new(scenario.drawn.clone(), spec)?))
    }
}

/// What moves, from a file of its own.
fn read(path: &Path) -> Result<DriveSpec, CliError> {
    input::in_file(path, MAX_TEXT_BYTES, |bytes, _| {
        let syntax = |e: serde_json::Error| FormatError::syntax(e.line(), e.to_string(), r#"{"changes": […], "tracks": […]}"#);
        serde_json::from_slice(bytes).map_err(|e| Error::from(syntax(e)))
    })
}

/// A drive as `drive --format json` prints it.
#[derive(Serialize)]
struct DriveResult<'a> {
    format: &'static str,
    planner: &'a str,
    seed: u32,
    #[serde(flatten)]
    drive: &'a Drive,
    steps: &'a [DriveStep],
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let params = args.params()?;
    let PlannerArgs { preset, seed, .. } = &args.planner;
    let (entry, values) = (args.planner.entry()?, args.planner.values());
    let scenario = args.load()?;
    args.format.check(&scenario.spec)?;
    let mut driver = Driver::new(&scenario, entry.id, preset.as_deref(), &values, *seed, params)?;
    if let Format::Path(format) = args.format {
        while driver.step().is_some() {}
        return way_file(format, &scenario, &driver);
    }
    let (drive, steps) = (driver.run(), driver.steps());
    let text = match args.format {
        Format::Json => {
            let result = DriveResult { format: "formicarium/drive@1", planner: entry.id, seed: *seed, drive: &drive, steps };
            text::json(&result, 2)
        }
        _ => report::text(&scenario, entry.name, *seed, &drive, steps),
    };
    Ok(Outcome { text, fine: drive.end == Some(End::Arrived) })
}

/// The way that was driven, on the map before its first step.
fn way_file(format: PathFormat, scenario: &Scenario, driver: &Driver) -> Result<Outcome, CliError> {
    let mut cells: Vec<Cell> = driver.steps().iter().map(|step| scenario.grid.cell(step.at)).collect();
    cells.dedup();
    let arrived = driver.end() == Some(End::Arrived);
    if !arrived {
        say("note: the robot gave up; this is its way until then");
    }
    let written = write_path(format, &PlannedPath::driven(scenario, &cells, driver.last().length))?;
    Ok(Outcome { fine: arrived, ..written })
}
