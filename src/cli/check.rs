//! `check`: is this a path, and how good is it?

use std::path::PathBuf;

use crate::error::{FormatError, Notice};
use crate::formats::{Imported, MAX_TEXT_BYTES, names_columns, path_kind, read_places, read_world_path};
use crate::map::{Grid, Movement, Point};
use crate::metrics::Metrics;
use crate::path::{PathKind, audit_slices, direction_between, in_sight};
use crate::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};
use serde::Serialize;

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
    let findings = Findings::of(&map, &path, kind);
    let text = match args.format {
        TextOrJson::Text => findings.text(&map, path.len()),
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

/// A cell of the path, counted from 0.
#[derive(Serialize)]
struct At {
    index: usize,
    at: Point,
}

/// A step or segment of the path, counted from 0.
#[derive(Serialize)]
struct Step {
    step: usize,
    from: Point,
    to: Point,
}

/// Everything that is wrong with a path, and its measures where they make sense.
#[derive(Serialize)]
struct Findings {
    format: &'static str,
    kind: PathKind,
    ok: bool,
    wrong_ends: Vec<String>,
    outside: Vec<At>,
    collisions: Vec<At>,
    jumps: Vec<Step>,
    corner_cuts: Vec<Step>,
    too_steep: Vec<Step>,
    out_of_sight: Vec<Step>,
    metrics: Option<Metrics>,
}

impl Findings {
    fn of(map: &Imported, path: &[Point], kind: PathKind) -> Self {
        let (grid, movement) = (&map.grid, map.spec.movement);
        let cells = |wrong: &dyn Fn(Point) -> bool| -> Vec<At> {
            path.iter().enumerate().filter(|(_, p)| wrong(**p)).map(|(index, &at)| At { index, at }).collect()
        };
        let all = |wrong: &dyn Fn(Point, Point) -> bool| -> Vec<Step> {
            let all = path.windows(2).enumerate().map(|(step, s)| Step { step, from: s[0], to: s[1] });
            all.filter(|s| wrong(s.from, s.to)).collect()
        };
        let joints = |of: PathKind, wrong: &dyn Fn(Point, Point) -> bool| if kind == of { all(wrong) } else { Vec::new() };
        let outside = cells(&|p| !grid.contains(p));
        let collisions = cells(&|p| grid.contains(p) && grid.is_blocked(grid.cell(p)));
        let jumps = joints(PathKind::Steps, &|from, to| direction_between(from, to).is_none());
        let corner_cuts = joints(PathKind::Steps, &|from, to| cuts_corner(grid, movement, from, to));
        let out_of_sight = joints(PathKind::Polyline, &|from, to| hidden(grid, movement, from, to));
        let ground = Scenario::unvalidated(map.grid.clone(), map.spec.clone(), 0, 0);
        let too_steep = all(&|from, to| is_too_steep(&ground, from, to));
        let wrong_ends = wrong_ends(map, path);
        let measurable = outside.is_empty() && jumps.is_empty();
        let joined = corner_cuts.is_empty() && out_of_sight.is_empty() && too_steep.is_empty();
        let ok = measurable && joined && collisions.is_empty() && wrong_ends.is_empty() && !path.is_empty();
        let metrics = if measurable { measure(map, path) } else { None };
        let format = "formicarium/check@1";
        Self { format, kind, ok, wrong_ends, outside, collisions, jumps, corner_cuts, too_steep, out_of_sight, metrics }
    }

    fn text(&self, map: &Imported, points: usize) -> String {
        let rule =
            format!("{} moves, corner rule {}", u8::from(map.spec.movement.moves), input::rule_id(map.spec.movement.corner_rule));
        let (what, valid) = match self.kind {
            PathKind::Steps => (text::count(points as u64, "cell", "cells"), "a valid path"),
            PathKind::Polyline => (text::count(points as u64, "point", "points") + " of a polyline", "a valid polyline"),
        };
        let mut out = format!("{what} on {} ({rule})\n\n", map.spec.name);
        row(&mut out, "verdict", if self.ok { valid.into() } else { format!("not {valid}") });
        for end in &self.wrong_ends {
            row(&mut out, "ends", end);
        }
        self.counts(&mut out, map.spec.terrain.is_some());
        if !self.jumps.is_empty() {
            row(&mut out, "", "for the corners of a polyline, add --polyline");
        }
        if let Some(metrics) = &self.metrics {
            text::metrics(&mut out, metrics);
        }
        out
    }

    /// A line for each kind of flaw that this kind of path can have.
    fn counts(&self, out: &mut String, on_terrain: bool) {
        let at = |found: &[At]| (found.len(), found.first().map(|f| format!("cell {} {}", f.index, text::cell(f.at))));
        let step = |found: &[Step], name: &str| {
            (found.len(), found.first().map(|f| format!("{name} {} {} → {}", f.step, text::cell(f.from), text::cell(f.to))))
        };
        let steep = on_terrain.then(|| ("too steep", step(&self.too_steep, "step")));
        let (cells, joints) = (
            [("outside", at(&self.outside)), ("collisions", at(&self.collisions))],
            match self.kind {
                PathKind::Steps => vec![("jumps", step(&self.jumps, "step")), ("corner cuts", step(&self.corner_cuts, "step"))],
                PathKind::Polyline => vec![("out of sight", step(&self.out_of_sight, "segment"))],
            },
        );
        for (label, (count, first)) in cells.into_iter().chain(joints).chain(steep) {
            row(out, label, first.map_or("none".into(), |first| format!("{count}, first at {first}")));
        }
    }
}

/// What is wrong with a path by slices, and its measures when nothing is.
#[derive(Serialize)]
struct SliceFindings {
    format: &'static str,
    kind: &'static str,
    ok: bool,
    flaw: Option<String>,
    metrics: Option<Metrics>,
}

/// Audits a path by slices.
fn by_slices(args: &Args, mut map: Imported, path: &[(Point, Option<u32>)]) -> Result<Outcome, CliError> {
    let name = map.spec.name.clone();
    let places: Option<Vec<(Point, u32)>> = path.iter().map(|&(at, level)| Some((at, level?))).collect();
    let places = places.ok_or_else(|| {
        CliError::usage("the path has no levels, and the map is one by slices", "write x,y,level, or add --model surface")
    })?;
    args.take_levels(&mut map, &places);
    let scenario = Scenario::new(map.grid, map.spec)?;
    let flaw = audit_slices(&scenario, &places).err().map(|flaw| flaw.to_string());
    let area = scenario.grid.len() as u32;
    let path =
        |places: &[(Point, u32)]| places.iter().map(|&(at, level)| scenario.grid.cell(at) + area * level).collect::<Vec<_>>();
    let metrics = flaw.is_none().then(|| Metrics::of(&scenario, &path(&places)));
    let findings = SliceFindings { format: "formicarium/check@1", kind: "slices", ok: flaw.is_none(), flaw, metrics };
    let text = match args.format {
        TextOrJson::Text => findings.text(&name, places.len()),
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

impl SliceFindings {
    fn text(&self, name: &str, places: usize) -> String {
        let mut out = format!("{} on {name} (by slices)\n\n", text::count(places as u64, "place", "places"));
        row(&mut out, "verdict", if self.ok { "a valid path" } else { "not a valid path" });
        if let Some(flaw) = &self.flaw {
            row(&mut out, "flaw", flaw);
        }
        if let Some(metrics) = &self.metrics {
            text::metrics(&mut out, metrics);
        }
        out
    }
}

/// A path's points where no level is asked for.
fn on_the_ground(path: &[(Point, Option<u32>)]) -> Result<Vec<Point>, CliError> {
    if path.iter().any(|(_, level)| level.is_some()) {
        let message = "the path has levels, and here one moves on the ground";
        return Err(CliError::usage(message, "add --model slices, or leave the levels out"));
    }
    Ok(path.iter().map(|&(at, _)| at).collect())
}

/// A step or segment between free cells over ground that is steeper than allowed.
fn is_too_steep(ground: &Scenario, from: Point, to: Point) -> bool {
    let free = |p: Point| ground.grid.is_free_at(i64::from(p.x), i64::from(p.y));
    let passable = || ground.moves.relief().is_none_or(|r| r.is_passable(ground.grid.cell(from), ground.grid.cell(to)));
    free(from) && free(to) && !passable()
}

/// Two free cells that do not see each other.
fn hidden(grid: &Grid, movement: Movement, from: Point, to: Point) -> bool {
    let free = |p: Point| grid.is_free_at(i64::from(p.x), i64::from(p.y));
    free(from) && free(to) && !in_sight(grid, movement, from, to)
}

/// A step between neighbouring free cells that the movement does not allow.
fn cuts_corner(grid: &Grid, movement: Movement, from: Point, to: Point) -> bool {
    let free = |p: Point| grid.is_free_at(i64::from(p.x), i64::from(p.y));
    let step = direction_between(from, to);
    free(from) && free(to) && step.is_some_and(|d| !movement.allows(grid, i64::from(from.x), i64::from(from.y), d))
}

/// Where the path does not begin, end or come by as the map's file says.
fn wrong_ends(map: &Imported, path: &[Point]) -> Vec<String> {
    let (Some(&first), Some(&last)) = (path.first(), path.last()) else { return vec!["the path is empty".into()] };
    if map.ends_were_chosen() {
        return Vec::new();
    }
    let (start, goals) = (map.spec.start, &map.spec.goals);
    let mut wrong = Vec::new();
    if first != start {
        wrong.push(format!("the path begins at {}, not at the start {}", text::cell(first), text::cell(start)));
    }
    if goals.iter().all(|g| g.at != last) {
        let places: Vec<_> = goals.iter().map(|g| text::cell(g.at)).collect();
        wrong.push(format!("the path ends at {}, not at the goal {}", text::cell(last), places.join(" or ")));
    }
    // Of one goal the end tells already.
    let missed = goals.iter().filter(|g| goals.len() > 1 && !path.contains(&g.at));
    wrong.extend(missed.map(|g| format!("the path misses the goal {}", text::cell(g.at))));
    wrong
}

/// The metrics of a path of neighbouring cells or of a polyline on the map. It need not be valid, so no validated scenario can be asked for.
fn measure(map: &Imported, path: &[Point]) -> Option<Metrics> {
    let cells: Vec<_> = path.iter().map(|&p| map.grid.cell(p)).collect();
    let (&start, &goal) = (cells.first()?, cells.last()?);
    let scenario = Scenario::unvalidated(map.grid.clone(), map.spec.clone(), start, goal);
    Some(Metrics::of(&scenario, &cells))
}
