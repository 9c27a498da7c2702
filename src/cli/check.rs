//! `check`: is this a path, and how good is it?

mod price;
mod way;

use std::path::PathBuf;

use crate::findings::{At, Findings, SliceFindings, Step};
use crate::formats::{Imported, MAX_TEXT_BYTES, PathOnMap, read_path_on};
use crate::map::{CornerRule, Moves, Point};
use crate::metrics::Metrics;
use crate::path::PathKind;
use crate::scenario::{CostRule, Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};
use serde::Serialize;

use super::driving::{self, DrivingArgs};
use super::error::CliError;
use super::input::{self, MovementArgs};
use super::reading::ReadingArgs;
use super::robot::RobotArgs;
use super::terrain::TerrainArgs;
use super::{Outcome, text, text::TextOrJson, text::row};
use price::Price;

/// Audits a path: collisions, cut corners, slopes, jumps, sight, ends; and measures it
#[derive(clap::Args)]
#[command(after_help = "\
The path: JSON [[x, y], …], CSV lines x,y, MATLAB [x y; x y], or what `plan` writes as json, path-csv, path-json,
nav-msgs, geojson or svg. Metres of a ROS path or of GeoJSON become the cells in which they lie; where they are no
centres of cells, as those of a smoothed path, it is measured as it is.
Its points are neighbouring cells, or with --polyline the corners of a polyline; json, path-json, geojson and svg
say which themselves.
By slices each place has its level: [[x, y, level], …], lines x,y,level, a result's path and levels, or z in metres.
The ends are checked only where the map's file names them.
With --cost, or --costs for a costmap, the path is counted as that planner of Nav2 counts, and compared with the least
cost between its ends: 8 moves and corner rule always, as SmacPlanner2D has no corner check, unless asked otherwise.

Examples:
  formicarium check path.csv --map arena2.map
  formicarium check route.txt --map grid.csv --one-based --rows-first --corner-rule always
  formicarium check corners.csv --map arena2.map --polyline
  formicarium check plan.yaml --map map.yaml --cost nav2-smac-2d --robot-radius 0.22
  formicarium plan a.json --planner astar --format json | formicarium check - --map a.json

Exit code 1 when the path is none.")]
pub struct Args {
    /// The path to check
    path: PathBuf,
    /// The map it belongs to
    #[arg(long)]
    map: PathBuf,
    #[command(flatten)]
    movement: MovementArgs,
    #[command(flatten)]
    robot: RobotArgs,
    #[command(flatten)]
    terrain: TerrainArgs,
    /// The path's points are joined by straight segments in line of sight, not by steps
    #[arg(long)]
    polyline: bool,
    #[command(flatten)]
    driving: DrivingArgs,
    /// The path counts cells from 1, as MATLAB does
    #[arg(long)]
    one_based: bool,
    /// The path names the row before the column
    #[arg(long)]
    rows_first: bool,
    #[command(flatten)]
    reading: ReadingArgs,
    /// text or json
    #[arg(long, value_enum, hide_possible_values = true, default_value_t = TextOrJson::Text)]
    format: TextOrJson,
}

impl Args {
    pub fn wants_json(&self) -> bool {
        self.format == TextOrJson::Json
    }
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let mut map = args.reading.import_still(&args.map)?;
    args.movement.apply(&mut map);
    args.judge_as_nav2(&mut map);
    let spec = &map.spec;
    let read = |bytes: &[u8], _: &str| Ok(read_path_on(bytes, spec)?);
    let PathOnMap { places: mut path, kind, metres, names_columns, notices } = input::in_file(&args.path, MAX_TEXT_BYTES, read)?;
    text::notes(&notices);
    if args.rows_first && names_columns {
        let message = "the path's file says itself which number is the row; --rows-first would turn them once more";
        return Err(CliError::usage(message, "leave out --rows-first"));
    }
    let kind = if args.polyline { PathKind::Polyline } else { kind };
    path.iter_mut().try_for_each(|(p, _)| args.shift(p))?;
    if let (true, Some(&(first, _)), Some(&(last, _))) = (map.ends_were_chosen(), path.first(), path.last()) {
        // The ends of the path are as good as any; by slices their levels follow.
        map.spec.start = first;
        map.spec.goals.iter_mut().for_each(|goal| goal.at = last);
    }
    args.terrain.apply(&mut map)?;
    let between = metres.as_ref().and_then(|metres| metres.between_centres(&map.spec));
    if let Some(metres) = metres {
        // Only now it is known how high a level is.
        path = metres.on(&map.spec)?;
    }
    args.driving.apply(&mut map.spec.vehicle);
    map.spec.check(&map.grid)?;
    if let Some(TerrainSpec { moves: TerrainMoves::Slices(_), .. }) = map.spec.terrain {
        return by_slices(args, map, &path);
    }
    let path = on_the_ground(&path)?;
    if let Some(outcome) = between.and_then(|places| way::check(args, &map, &places)) {
        return Ok(outcome);
    }
    let findings = Findings::of(&map.grid, &map.spec, !map.ends_were_chosen(), &path, kind);
    let price = Price::of(&map, &path, &findings, args.judged());
    let (fine, checked) = (findings.ok, Checked { findings, price });
    let text = match args.format {
        TextOrJson::Text => whole_text(&checked, &map, path.len()),
        TextOrJson::Json => text::json(&checked, 2),
    };
    Ok(Outcome { text, fine })
}

/// What is wrong with a path, and what it costs.
#[derive(Serialize)]
struct Checked {
    #[serde(flatten)]
    findings: Findings,
    #[serde(skip_serializing_if = "Option::is_none")]
    price: Option<Price>,
}

impl Args {
    /// The planner of Nav2 as which the path is counted.
    fn judged(&self) -> Option<CostRule> {
        self.robot.cost().or(self.reading.costs())
    }

    /// Lets the robot's arguments and, where a planner of Nav2 is the judge, its way of moving override the map's; says what was assumed.
    fn judge_as_nav2(&self, map: &mut Imported) {
        let of_costs = map.notices.iter().filter(|notice| notice.kind.starts_with("costs-")).cloned();
        text::notes(&of_costs.chain(self.robot.apply(&mut map.spec)).collect::<Vec<_>>());
        if self.judged().is_some() {
            let movement = &mut map.spec.movement;
            movement.moves = self.movement.moves.unwrap_or(Moves::Eight);
            movement.corner_rule = self.movement.corner_rule.unwrap_or(CornerRule::Always);
        }
    }

    /// Brings a point into column, row, from 0.
    fn shift(&self, p: &mut Point) -> Result<(), CliError> {
        if self.rows_first {
            *p = Point::new(p.y, p.x);
        }
        if self.one_based {
            let less = |v: u32| {
                let hint = "leave out --one-based";
                v.checked_sub(1).ok_or_else(|| CliError::usage("the path has a 0, so it does not count from 1", hint))
            };
            *p = Point::new(less(p.x)?, less(p.y)?);
        }
        Ok(())
    }
}

/// What `check` prints.
fn whole_text(Checked { findings, price }: &Checked, map: &Imported, points: usize) -> String {
    let rule =
        format!("{} moves, corner rule {}", u8::from(map.spec.movement.moves), input::rule_id(map.spec.movement.corner_rule));
    let (what, valid) = match findings.kind {
        PathKind::Steps => (text::count(points as u64, "cell", "cells"), "a valid path"),
        PathKind::Polyline => (text::count(points as u64, "point", "points") + " of a polyline", "a valid polyline"),
    };
    let mut out = format!("{what} on {} ({rule})\n\n", map.spec.name);
    row(&mut out, "verdict", if findings.ok { valid.into() } else { format!("not {valid}") });
    for end in &findings.wrong_ends {
        row(&mut out, "ends", end);
    }
    counts(findings, &mut out, map);
    if !findings.jumps.is_empty() {
        row(&mut out, "", "for the corners of a polyline, add --polyline");
    }
    if let Some(metrics) = findings.metrics {
        // Its price tells the cost, with what it is compared with.
        text::metrics(&mut out, &Metrics { cost: metrics.cost.filter(|_| price.is_none()), ..metrics }, map.spec.scale());
    }
    if let Some(price) = price {
        price.text(&mut out);
    }
    driving::smoothed(&mut out, &map.spec.vehicle, findings.smoothed.as_ref(), map.spec.scale());
    out
}

/// A line for each kind of flaw that this kind of path can have.
fn counts(findings: &Findings, out: &mut String, map: &Imported) {
    let at = |found: &[At]| (found.len(), found.first().map(|f| format!("cell {} {}", f.index, text::cell(f.at))));
    let step = |found: &[Step], name: &str| {
        (found.len(), found.first().map(|f| format!("{name} {} {} → {}", f.step, text::cell(f.from), text::cell(f.to))))
    };
    let narrow = map.spec.robot.map(|_| ("too narrow", at(&findings.narrow)));
    let steep = map.spec.terrain.map(|_| ("too steep", step(&findings.too_steep, "step")));
    let (cells, joints) = (
        [("outside", at(&findings.outside)), ("collisions", at(&findings.collisions))],
        match findings.kind {
            PathKind::Steps => {
                vec![("jumps", step(&findings.jumps, "step")), ("corner cuts", step(&findings.corner_cuts, "step"))]
            }
            PathKind::Polyline => vec![("out of sight", step(&findings.out_of_sight, "segment"))],
        },
    );
    for (label, (count, first)) in cells.into_iter().chain(narrow).chain(joints).chain(steep) {
        row(out, label, first.map_or("none".into(), |first| format!("{count}, first at {first}")));
    }
}

/// Audits a path by slices.
fn by_slices(args: &Args, mut map: Imported, path: &[(Point, Option<u32>)]) -> Result<Outcome, CliError> {
    let places: Option<Vec<(Point, u32)>> = path.iter().map(|&(at, level)| Some((at, level?))).collect();
    let places = places.ok_or_else(|| {
        CliError::usage("the path has no levels, and the map is one by slices", "write x,y,level, or add --model surface")
    })?;
    args.take_levels(&mut map, &places);
    let scenario = Scenario::new(map.grid, map.spec)?;
    let findings = SliceFindings::of(&scenario, &places);
    let text = match args.format {
        TextOrJson::Text => slices_text(&findings, &scenario.spec, places.len()),
        TextOrJson::Json => text::json(&findings, 2),
    };
    Ok(Outcome { text, fine: findings.ok })
}

impl Args {
    /// Where the map's file does not say how one moves, the levels of the path's ends are taken, unless others are asked for.
    fn take_levels(&self, map: &mut Imported, places: &[(Point, u32)]) {
        let (chosen, ends) = (map.ends_were_chosen(), places.first().zip(places.last()));
        let (Some(TerrainSpec { moves: TerrainMoves::Slices(rules), .. }), Some((first, last))) = (&mut map.spec.terrain, ends)
        else {
            return;
        };
        if chosen {
            rules.start_level = self.terrain.from_level.unwrap_or(first.1);
            rules.goal_level = self.terrain.to_level.unwrap_or(last.1);
        }
    }
}

/// The same of a path by slices.
fn slices_text(findings: &SliceFindings, spec: &ScenarioSpec, places: usize) -> String {
    let mut out = format!("{} on {} (by slices)\n\n", text::count(places as u64, "place", "places"), spec.name);
    row(&mut out, "verdict", if findings.ok { "a valid path" } else { "not a valid path" });
    if let Some(flaw) = &findings.flaw {
        row(&mut out, "flaw", flaw);
    }
    if let Some(metrics) = &findings.metrics {
        text::metrics(&mut out, metrics, spec.scale());
    }
    out
}

/// A path's points where no level is asked for.
fn on_the_ground(path: &[(Point, Option<u32>)]) -> Result<Vec<Point>, CliError> {
    if path.iter().any(|(_, level)| level.is_some()) {
        let message = "the path has levels, and here one moves on the ground";
        return Err(CliError::usage(message, "add --model slices, or leave the levels out"));
    }
    Ok(path.iter().map(|&(at, _)| at).collect())
}
