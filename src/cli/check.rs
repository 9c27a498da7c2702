//! `check`: is this a path, and how good is it?

use std::path::PathBuf;

use crate::error::{FormatError, Notice};
use crate::findings::{At, Findings, SliceFindings, Step};
use crate::formats::{Imported, MAX_TEXT_BYTES, names_columns, path_kind, read_places, read_world_path};
use crate::map::Point;
use crate::path::PathKind;
use crate::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

use super::error::CliError;
use super::input::{self, MovementArgs};
use super::reading::ReadingArgs;
use super::terrain::TerrainArgs;
use super::{Outcome, text, text::TextOrJson, text::row};

/// Audits a path: collisions, cut corners, slopes, jumps, sight, ends; and measures it
#[derive(clap::Args)]
#[command(after_help = "\
The path: JSON [[x, y], …] or the output of `plan --format json`, CSV lines x,y, or MATLAB [x y; x y].
Its points are neighbouring cells, or with --polyline the corners of a polyline; a result says which itself.
By slices each place has its level: [[x, y, level], …], lines x,y,level, or a result's path and levels.
The ends are checked only where the map's file names them.

Examples:
  formicarium check path.csv --map arena2.map
  formicarium check route.txt --map grid.csv --one-based --rows-first --corner-rule always
  formicarium check corners.csv --map arena2.map --polyline
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
    terrain: TerrainArgs,
    /// The path's points are joined by straight segments in line of sight, not by steps
    #[arg(long)]
    polyline: bool,
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
    let spec = &map.spec;
    let read = |bytes: &[u8], _: &str| Ok((places(bytes, spec)?, path_kind(bytes), names_columns(bytes)?));
    let (mut path, kind, named) = input::in_file(&args.path, MAX_TEXT_BYTES, read)?;
    if args.rows_first && named {
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
    map.spec.check(&map.grid)?;
    if let Some(TerrainSpec { moves: TerrainMoves::Slices(_), .. }) = map.spec.terrain {
        return by_slices(args, map, &path);
    }
    let path = on_the_ground(&path)?;
    let findings = Findings::of(&map.grid, &map.spec, !map.ends_were_chosen(), &path, kind);
    let text = match args.format {
        TextOrJson::Text => whole_text(&findings, &map, path.len()),
        TextOrJson::Json => text::json(&findings, 2),
    };
    Ok(Outcome { text, fine: findings.ok })
}

/// The places of a file; of a Path message of ROS the cells in which its poses lie, one for each run of poses in the same cell.
fn places(bytes: &[u8], spec: &ScenarioSpec) -> Result<Vec<(Point, Option<u32>)>, FormatError> {
    let Some(path) = read_world_path(bytes)? else { return read_places(bytes) };
    text::notes(&spec.world.as_ref().and_then(|world| other_frame(&path.frame, &world.frame)).into_iter().collect::<Vec<_>>());
    let mut places = Vec::with_capacity(path.metres.len());
    for (index, [x, y]) in path.metres.into_iter().enumerate() {
        let expected = "poses on the map; the map must say where it lies: check against the ROS map";
        let cell = spec.to_cell([x, y]);
        places.push((
            cell.ok_or_else(|| FormatError::field("poses", format!("pose {index} ({x}, {y}) lies beside the map"), expected))?,
            None,
        ));
    }
    places.dedup();
    Ok(places)
}

/// That a path and its map name different frames; a ROS map alone names none.
fn other_frame(path: &str, map: &str) -> Option<Notice> {
    (!path.is_empty() && !map.is_empty() && path != map).then(|| {
        let message = format!("the path is in the frame {path}, the map in {map}: their metres were taken for the same");
        Notice::new("path-frame", message).with("path", path).with("map", map)
    })
}

impl Args {
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
fn whole_text(findings: &Findings, map: &Imported, points: usize) -> String {
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
    counts(findings, &mut out, map.spec.terrain.is_some());
    if !findings.jumps.is_empty() {
        row(&mut out, "", "for the corners of a polyline, add --polyline");
    }
    if let Some(metrics) = &findings.metrics {
        text::metrics(&mut out, metrics, map.spec.scale());
    }
    out
}

/// A line for each kind of flaw that this kind of path can have.
fn counts(findings: &Findings, out: &mut String, on_terrain: bool) {
    let at = |found: &[At]| (found.len(), found.first().map(|f| format!("cell {} {}", f.index, text::cell(f.at))));
    let step = |found: &[Step], name: &str| {
        (found.len(), found.first().map(|f| format!("{name} {} {} → {}", f.step, text::cell(f.from), text::cell(f.to))))
    };
    let steep = on_terrain.then(|| ("too steep", step(&findings.too_steep, "step")));
    let (cells, joints) = (
        [("outside", at(&findings.outside)), ("collisions", at(&findings.collisions))],
        match findings.kind {
            PathKind::Steps => {
                vec![("jumps", step(&findings.jumps, "step")), ("corner cuts", step(&findings.corner_cuts, "step"))]
            }
            PathKind::Polyline => vec![("out of sight", step(&findings.out_of_sight, "segment"))],
        },
    );
    for (label, (count, first)) in cells.into_iter().chain(joints).chain(steep) {
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
