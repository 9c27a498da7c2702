//! `drive`: a robot that drives where things move.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Serialize;

use super::Outcome;
use super::error::CliError;
use super::input::{self, ScenarioArgs};
use super::planner_args::PlannerArgs;
use super::text::{self, TextOrJson, count, row};
use crate::drive::{DRIVE, Did, Drive, DriveParams, DriveStep, Driver, End, Stuck};
use crate::error::{Error, FormatError};
use crate::exact::Reference;
use crate::formats::MAX_TEXT_BYTES;
use crate::map::Point;
use crate::params::{Params, Value, Values};
use crate::scenario::{AtEnd, DriveSpec, Scenario, ScenarioSpec, Track};

/// Has a robot drive where walls change and obstacles move, planning again on its way
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  formicarium drive maze.csv --planner d-star-lite --from 0,0 --to 19,19 --obstacle 10,3:10,15
  formicarium drive maze.csv --planner ant-system --from 0,0 --to 19,19 --obstacle 4,4:12,4,end=leave,from=3 --iterations 10
  formicarium drive site.json --planner astar --sight 5 --hold 3 --format json
  formicarium drive arena.map --scen arena.map.scen:200 --planner d-star-lite --drive traffic.json

An obstacle goes in straight lines from cell to cell: X,Y:X,Y:…, then size=N, from=STEP, each=STEPS on a cell,
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
    #[arg(long, value_name = "X,Y:X,Y…[,KEY=VALUE…]", value_parser = obstacle)]
    obstacle: Vec<Track>,
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
    /// text, or json with every step
    #[arg(long, value_enum, hide_possible_values = true, default_value_t = TextOrJson::Text)]
    format: TextOrJson,
}

impl Args {
    pub fn wants_json(&self) -> bool {
        self.format == TextOrJson::Json
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
        let scenario = self.scenario.load()?;
        let mut moving = match &self.drive {
            Some(path) => read(path)?,
            None => scenario.spec.drive.clone().unwrap_or_default(),
        };
        moving.tracks.extend(self.obstacle.iter().cloned());
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

/// Reads `X,Y:X,Y:…` and what follows by name.
fn obstacle(text: &str) -> Result<Track, String> {
    let wrong = || format!("`{text}` is no obstacle: write cells such as 10,3:10,15 and then size=2,from=4,each=3,end=leave");
    let (cells, named) = match text.split_once('=') {
        Some((before, _)) => text.split_at(before.rfind(',').ok_or_else(wrong)?),
        None => (text, ""),
    };
    let mut track = Track { cells: Vec::new(), size: 1, from_step: 0, steps_per_cell: 1, at_end: AtEnd::BackAndForth };
    for corner in cells.split(':') {
        go_straight(&mut track.cells, input::point(corner)?).ok_or_else(wrong)?;
    }
    for pair in named.split(',').filter(|pair| !pair.is_empty()) {
        let (key, value) = pair.split_once('=').ok_or_else(wrong)?;
        let number = || value.parse().map_err(|_| wrong());
        match key {
            "size" => track.size = number()?,
            "from" => track.from_step = number()?,
            "each" => track.steps_per_cell = number()?,
            "end" => track.at_end = at_end(value).ok_or_else(wrong)?,
            _ => return Err(wrong()),
        }
    }
    Ok(track)
}

fn at_end(id: &str) -> Option<AtEnd> {
    [("stay", AtEnd::Stay), ("back-and-forth", AtEnd::BackAndForth), ("loop", AtEnd::Loop), ("leave", AtEnd::Leave)]
        .into_iter()
        .find_map(|(name, end)| (name == id).then_some(end))
}

/// Goes on to a cell along a row, a column or a diagonal; none where it lies on none of them, or beyond any map.
fn go_straight(cells: &mut Vec<Point>, to: Point) -> Option<()> {
    let from = cells.last().copied().unwrap_or(to);
    let (dx, dy) = (i64::from(to.x) - i64::from(from.x), i64::from(to.y) - i64::from(from.y));
    let far = dx.abs().max(dy.abs());
    let straight = dx == 0 || dy == 0 || dx.abs() == dy.abs();
    if !straight || far > i64::from(crate::map::MAX_SIDE) {
        return None;
    }
    let along = |v: u32, d: i64, k: i64| (i64::from(v) + d.signum() * k) as u32;
    let first = i64::from(!cells.is_empty());
    cells.extend((first..=far).map(|k| Point::new(along(from.x, dx, k), along(from.y, dy, k))));
    Some(())
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
    let mut driver = Driver::new(&scenario, entry.id, preset.as_deref(), &values, *seed, params)?;
    let drive = driver.run();
    let steps = driver.steps();
    let text = match args.format {
        TextOrJson::Text => report(&scenario, entry.name, *seed, &drive, steps),
        TextOrJson::Json => {
            let result = DriveResult { format: "formicarium/drive@1", planner: entry.id, seed: *seed, drive: &drive, steps };
            text::json(&result, 2)
        }
    };
    Ok(Outcome { text, fine: drive.end == Some(End::Arrived) })
}

fn report(scenario: &Scenario, name: &str, seed: u32, drive: &Drive, steps: &[DriveStep]) -> String {
    let (grid, spec) = (&scenario.grid, &scenario.spec);
    let on = if spec.name.is_empty() { String::new() } else { format!(" on {}", spec.name) };
    let mut out = format!("A drive by {name}{on} ({} × {})\n\n", grid.width(), grid.height());
    row(&mut out, "from, to", format!("{} → {}", text::cell(spec.start), text::cell(spec.goals[0].at)));
    if let Some(moving) = &spec.drive {
        let (walls, tracks) = (moving.changes.len() as u64, moving.tracks.len() as u64);
        let sight = moving.sight.map_or_else(String::new, |sight| format!("; it sees {sight} cells far"));
        let walls = count(walls, "change of walls", "changes of walls");
        row(&mut out, "what moves", format!("{walls}, {}{sight}", count(tracks, "obstacle", "obstacles")));
    }
    row(&mut out, "end", end(drive.end, steps));
    row(&mut out, "length", format!("{:.4} cells = {:.4} m", drive.length, drive.length * spec.resolution));
    row(
        &mut out,
        "steps",
        format!("{}, {}", count(drive.moves.into(), "move", "moves"), count(drive.waits.into(), "wait", "waits")),
    );
    row(&mut out, "in advance", in_advance(drive));
    row(&mut out, "planned again", count(drive.replans.into(), "time", "times"));
    row(&mut out, "effort", super::plan::effort_text(&drive.effort));
    row(&mut out, "way", way(steps));
    row(&mut out, "seed", seed);
    row(&mut out, "digest", &drive.digest);
    out
}

fn end(end: Option<End>, steps: &[DriveStep]) -> String {
    let at = steps.last().map_or_else(String::new, |last| format!(" at {} after {}", text::cell(last.at), last.step));
    match end {
        None => "on its way".into(),
        Some(End::Arrived) => "arrived".into(),
        Some(End::Stuck(why)) => format!(
            "gave up{at} steps: {}",
            match why {
                Stuck::NoPath => "no path leads to the goal, as far as it knows",
                Stuck::NotFound => "the planner found no path in its iterations",
                Stuck::NoRoom => "it touches a wall that was not there before",
                Stuck::GoalTaken => "something stands on the goal, as far as it knows",
                Stuck::Held => "the next cell stayed taken",
                Stuck::TooLong => "it may drive no longer",
            }
        ),
    }
}

/// What somebody would have driven who knew everything in advance.
fn in_advance(drive: &Drive) -> String {
    match (drive.clairvoyant, drive.ratio) {
        (Reference::Proven { value }, Some(ratio)) => format!("{value:.4} cells at best; this drive is {ratio:.4} times as long"),
        (Reference::Proven { value } | Reference::Unproven { value }, _) => format!("{value:.4} cells at best"),
        (Reference::NoPath, _) => "no drive arrives".into(),
        (Reference::Unknown, _) => "unknown: too many steps times cells to search".into(),
    }
}

/// Its cells; `·` for a wait.
fn way(steps: &[DriveStep]) -> String {
    let mut out = String::new();
    for step in steps {
        match step.did {
            Did::Start => out += &text::cell(step.at),
            Did::Move => out += &format!(" {}", text::cell(step.at)),
            Did::Wait => out += " ·",
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn obstacles_are_read_as_they_are_written() {
        let cells = |text| obstacle(text).map(|track| track.cells.iter().map(|p| (p.x, p.y)).collect::<Vec<_>>());
        assert_eq!(cells("3,4"), Ok(vec![(3, 4)]));
        assert_eq!(cells("3,4:5,4:5,3"), Ok(vec![(3, 4), (4, 4), (5, 4), (5, 3)]));
        assert_eq!(cells("3,4:1,2"), Ok(vec![(3, 4), (2, 3), (1, 2)]));
        let full = obstacle("3,4:5,4,size=2,from=7,each=3,end=loop").expect("an obstacle");
        assert_eq!((full.cells.len(), full.size, full.from_step, full.steps_per_cell, full.at_end), (3, 2, 7, 3, AtEnd::Loop));
        for wrong in ["", "3", "3,4:5,5:9,9", "3,4,size", "3,4,width=2", "3,4,size=x", "3,4,end=go", "0,0:99999,0", "size=2"] {
            assert!(obstacle(wrong).is_err(), "{wrong}");
        }
    }
}
