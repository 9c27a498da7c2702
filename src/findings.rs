//! Everything that is wrong with a path, not the first thing alone ([`crate::path::audit`]): `formicarium/check@1`.

mod way;

use serde::Serialize;

use crate::map::{Cell, Grid, Movement, Point};
use crate::metrics::Metrics;
use crate::path::{PathKind, audit_slices, direction_between, in_sight};
use crate::scenario::{Scenario, ScenarioSpec};
use crate::smoothing::Smoothed;

pub use way::WayFindings;

/// What `format` says.
const FORMAT: &str = "formicarium/check@1";

/// A cell of the path, counted from 0.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct At {
    /// Its place in the path.
    pub index: usize,
    /// Where it is.
    pub at: Point,
}

/// A step or segment of the path, counted from 0.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// Its place in the path.
    pub step: usize,
    /// From here.
    pub from: Point,
    /// To there.
    pub to: Point,
}

/// Everything that is wrong with a path, and its measures where they make sense.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Findings {
    format: &'static str,
    /// How its points follow each other.
    pub kind: PathKind,
    /// Whether nothing is wrong.
    pub ok: bool,
    /// Where it does not begin, end or come by as asked, in words.
    pub wrong_ends: Vec<String>,
    /// Cells beside the map.
    pub outside: Vec<At>,
    /// Cells on obstacles.
    pub collisions: Vec<At>,
    /// Free cells in which the robot does not fit; always empty where it is a point.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub narrow: Vec<At>,
    /// Steps to a cell that is no neighbour.
    pub jumps: Vec<Step>,
    /// Steps between free neighbours that the movement does not allow.
    pub corner_cuts: Vec<Step>,
    /// Steps or segments over ground that is too steep.
    pub too_steep: Vec<Step>,
    /// Segments whose ends do not see each other.
    pub out_of_sight: Vec<Step>,
    /// Its measures, where no cell lies beside the map and no step jumps.
    pub metrics: Option<Metrics>,
    /// The path as a smooth curve, where nothing is wrong with it and the vehicle has a rule of smoothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub smoothed: Option<Smoothed>,
}

impl Findings {
    /// Audits a path on a map that need not be a usable scenario. Its ends count only where `has_ends`: the map's file names them.
    pub fn of(drawn: &Grid, spec: &ScenarioSpec, has_ends: bool, path: &[Point], kind: PathKind) -> Self {
        let ground = Scenario::unvalidated(drawn.clone(), spec.clone(), 0, 0);
        let (grid, movement) = (&ground.grid, spec.movement);
        let cells = |wrong: &dyn Fn(Point) -> bool| -> Vec<At> {
            path.iter().enumerate().filter(|(_, p)| wrong(**p)).map(|(index, &at)| At { index, at }).collect()
        };
        let all = |wrong: &dyn Fn(Point, Point) -> bool| -> Vec<Step> {
            let all = path.windows(2).enumerate().map(|(step, s)| Step { step, from: s[0], to: s[1] });
            all.filter(|s| wrong(s.from, s.to)).collect()
        };
        let joints = |of: PathKind, wrong: &dyn Fn(Point, Point) -> bool| if kind == of { all(wrong) } else { Vec::new() };
        let outside = cells(&|p| !grid.contains(p));
        let collisions = cells(&|p| blocked_at(drawn, p));
        let narrow = cells(&|p| blocked_at(grid, p) && !blocked_at(drawn, p));
        let jumps = joints(PathKind::Steps, &|from, to| direction_between(from, to).is_none());
        let corner_cuts = joints(PathKind::Steps, &|from, to| cuts_corner(grid, movement, from, to));
        let out_of_sight = joints(PathKind::Polyline, &|from, to| hidden(grid, movement, from, to));
        let too_steep = all(&|from, to| is_too_steep(&ground, from, to));
        let wrong_ends = wrong_ends(spec, has_ends, path);
        let measurable = outside.is_empty() && jumps.is_empty();
        let joined = corner_cuts.is_empty() && out_of_sight.is_empty() && too_steep.is_empty();
        let fits = collisions.is_empty() && narrow.is_empty();
        let ok = measurable && joined && fits && wrong_ends.is_empty() && !path.is_empty();
        let open = fits && out_of_sight.is_empty();
        let metrics = measurable.then(|| measure(&ground, path, open)).flatten();
        let smoothed = if ok { smooth(ground, path) } else { None };
        Self {
            format: FORMAT,
            kind,
            ok,
            wrong_ends,
            outside,
            collisions,
            narrow,
            jumps,
            corner_cuts,
            too_steep,
            out_of_sight,
            metrics,
            smoothed,
        }
    }
}

fn blocked_at(grid: &Grid, p: Point) -> bool {
    grid.contains(p) && grid.is_blocked(grid.cell(p))
}

/// The curve of a valid path, which comes by all goals of the scenario.
fn smooth(ground: Scenario, path: &[Point]) -> Option<Smoothed> {
    let cell = |p: &Point| ground.grid.cell(*p);
    let goals = ground.spec.goals.iter().map(|goal| cell(&goal.at)).collect();
    let path: Vec<Cell> = path.iter().map(cell).collect();
    Smoothed::of(&Scenario { goals, ..ground }, &path)
}

/// What is wrong with a path by slices, and its measures when nothing is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SliceFindings {
    format: &'static str,
    kind: &'static str,
    /// Whether nothing is wrong.
    pub ok: bool,
    /// The first thing that is wrong, in words.
    pub flaw: Option<String>,
    /// Its measures, where nothing is wrong.
    pub metrics: Option<Metrics>,
}

impl SliceFindings {
    /// Audits a path by slices: columns, rows and levels.
    pub fn of(scenario: &Scenario, path: &[(Point, u32)]) -> Self {
        let flaw = audit_slices(scenario, path).err().map(|flaw| flaw.to_string());
        let area = scenario.grid.len() as Cell;
        let places = || path.iter().map(|&(at, level)| scenario.grid.cell(at) + area * level).collect::<Vec<_>>();
        let metrics = flaw.is_none().then(|| Metrics::of(scenario, &places()));
        Self { format: FORMAT, kind: "slices", ok: flaw.is_none(), flaw, metrics }
    }
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
fn wrong_ends(spec: &ScenarioSpec, has_ends: bool, path: &[Point]) -> Vec<String> {
    let (Some(&first), Some(&last)) = (path.first(), path.last()) else { return vec!["the path is empty".into()] };
    if !has_ends {
        return Vec::new();
    }
    let (start, goals) = (spec.start, &spec.goals);
    let mut wrong = Vec::new();
    if first != start {
        wrong.push(format!("the path begins at {}, not at the start {}", cell(first), cell(start)));
    }
    if goals.iter().all(|g| g.at != last) {
        let places: Vec<_> = goals.iter().map(|g| cell(g.at)).collect();
        wrong.push(format!("the path ends at {}, not at the goal {}", cell(last), places.join(" or ")));
    }
    // Of one goal the end tells already.
    let missed = goals.iter().filter(|g| goals.len() > 1 && !path.contains(&g.at));
    wrong.extend(missed.map(|g| format!("the path misses the goal {}", cell(g.at))));
    wrong
}

/// The metrics of a path of neighbouring cells or of a polyline on the map. It need not be valid, so no validated scenario can be asked for.
/// `open`: no part of it lies where nothing can go; any other path costs nothing that could be told.
fn measure(ground: &Scenario, path: &[Point], open: bool) -> Option<Metrics> {
    let cells: Vec<Cell> = path.iter().map(|&p| ground.grid.cell(p)).collect();
    (!cells.is_empty()).then(|| {
        let measured = Metrics::of(ground, &cells);
        Metrics { cost: measured.cost.filter(|_| open), ..measured }
    })
}

/// A cell in words.
fn cell(p: Point) -> String {
    format!("({}, {})", p.x, p.y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_is_wrong_is_told_with_its_place() {
        let grid = Grid::from_bytes(3, 2, &[0, 1, 0, 0, 0, 0]).unwrap();
        let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(2, 0));
        let points = |path: &[(u32, u32)]| path.iter().map(|&(x, y)| Point::new(x, y)).collect::<Vec<_>>();
        let of = |path: &[(u32, u32)], has_ends| Findings::of(&grid, &spec, has_ends, &points(path), PathKind::Steps);
        let fine = of(&[(0, 0), (0, 1), (1, 1), (2, 1), (2, 0)], true);
        assert!(fine.ok && fine.metrics.unwrap().length == 4.0);
        let wrong = of(&[(1, 0), (0, 1), (2, 1), (9, 9)], true);
        assert_eq!((wrong.collisions.len(), wrong.jumps.len(), wrong.outside[0].index), (1, 2, 3));
        assert_eq!(wrong.wrong_ends.len(), 2);
        assert!(of(&[(0, 1), (1, 1)], false).ok && !of(&[], false).ok);
    }
}
