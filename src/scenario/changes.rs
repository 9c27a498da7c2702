//! Walls that change while planners are at work: which cells, and at the end of which iteration.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};

use super::{Scenario, ScenarioSpec};
use crate::error::ScenarioError;
use crate::map::{Cell, Grid, Point};

/// Most changes of one scenario.
pub const MAX_CHANGES: usize = 1000;

/// How far, in cells, a wall is felt: a step from beside it, and what an ant sees at that step's end (eight cells around).
const FELT: u32 = 2;

/// Cells that are blocked or freed between two iterations. Start and goals stay free, and as wide as the robot needs.
///
/// ```
/// use formicarium::map::{Grid, Point};
/// use formicarium::scenario::{Change, Scenario, ScenarioSpec};
///
/// let grid = Grid::open(3, 1)?;
/// let mut spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(2, 0));
/// spec.changes = vec![Change { at: 12, blocked: vec![Point::new(1, 0)], freed: vec![] }];
/// let scenario = Scenario::new(grid, spec)?;
/// assert!(scenario.reachable(), "the map is the one before the first change");
/// assert!(!scenario.changed(&scenario.spec.changes[0])?.reachable());
/// # Ok::<(), formicarium::error::ScenarioError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Change {
    /// It happens at the end of this iteration, counted from 1; 0 = before the first. A planner that ends earlier has it at its end.
    pub at: u32,
    /// Free cells that become blocked.
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number][]"))]
    pub blocked: Vec<Point>,
    /// Blocked cells that become free.
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number][]"))]
    pub freed: Vec<Point>,
}

impl Change {
    /// All its cells.
    pub fn cells(&self) -> impl Iterator<Item = Point> + use<'_> {
        self.blocked.iter().chain(&self.freed).copied()
    }

    /// The cells of a map whose steps it concerns, or what is seen of them, in the map's order: around its own cells and, where the robot
    /// needs room, around all that it has made narrow or wide, dear or cheap.
    pub fn felt(&self, before: &Grid, now: &Grid) -> Vec<Cell> {
        let mut cells = BTreeSet::new();
        for p in self.cells().chain(differing(before, now)) {
            for y in p.y.saturating_sub(FELT)..=(p.y + FELT).min(now.height() - 1) {
                let row = y * now.width();
                cells.extend(row + p.x.saturating_sub(FELT)..=row + (p.x + FELT).min(now.width() - 1));
            }
        }
        cells.into_iter().collect()
    }

    /// Makes it on a map, after a check; `index` is its number in errors.
    ///
    /// # Errors
    /// [`ScenarioError::Change`] names the field, the value and what is allowed.
    pub fn make(&self, grid: &mut Grid, spec: &ScenarioSpec, index: usize) -> Result<(), ScenarioError> {
        if self.cells().next().is_none() {
            return Err(wrong(index, "", "no cells", "a change of one cell or more"));
        }
        let mut seen = BTreeSet::new();
        for (field, cells, blocked) in [("blocked", &self.blocked, true), ("freed", &self.freed, false)] {
            for (i, &cell) in cells.iter().enumerate() {
                if let Some(allowed) = refusal(grid, spec, cell, blocked) {
                    return Err(wrong(index, &format!(".{field}[{i}]"), said(cell), allowed));
                }
                if !seen.insert((cell.y, cell.x)) {
                    return Err(wrong(
                        index,
                        &format!(".{field}[{i}]"),
                        said(cell),
                        "a cell that the change does not name twice",
                    ));
                }
            }
        }
        self.blocked.iter().for_each(|&p| grid.set_blocked(grid.cell(p), true));
        self.freed.iter().for_each(|&p| grid.set_blocked(grid.cell(p), false));
        Ok(())
    }
}

/// The cells that two maps of one size differ in.
fn differing<'a>(before: &'a Grid, now: &'a Grid) -> impl Iterator<Item = Point> + use<'a> {
    let factor = |grid: &Grid, cell: usize| grid.factors().map_or(1.0, |factors| factors[cell]);
    let differs = move |&cell: &usize| before.blocked()[cell] != now.blocked()[cell] || factor(before, cell) != factor(now, cell);
    (0..now.len()).filter(differs).map(|cell| now.point(cell as Cell))
}

/// What is allowed in the place of a cell that cannot be blocked, or freed; none where it can.
fn refusal(grid: &Grid, spec: &ScenarioSpec, cell: Point, block: bool) -> Option<&'static str> {
    if grid.contains(cell) && (cell == spec.start || spec.goals.iter().any(|goal| goal.at == cell)) {
        return Some("neither the start nor a goal");
    }
    if block && takes_room(spec, cell) {
        return Some("a cell that leaves the robot its room at start and goals");
    }
    unfit_for_change(grid, cell, block)
}

/// Whether a robot that stands at the start or a goal would touch a wall in this cell.
fn takes_room(spec: &ScenarioSpec, cell: Point) -> bool {
    let squared = |end: Point| {
        let (dx, dy) = (u64::from(end.x.abs_diff(cell.x)), u64::from(end.y.abs_diff(cell.y)));
        u32::try_from(dx.saturating_mul(dx).saturating_add(dy.saturating_mul(dy))).unwrap_or(u32::MAX)
    };
    let mut ends = spec.goals.iter().map(|goal| goal.at).chain([spec.start]);
    spec.robot.is_some() && ends.any(|end| spec.touches(squared(end)))
}

/// The same whatever stands on the cell.
pub(super) fn unfit_for_change(grid: &Grid, cell: Point, block: bool) -> Option<&'static str> {
    if !grid.contains(cell) {
        return Some("a cell of the map");
    }
    let index = grid.cell(cell);
    match (block, grid.is_blocked(index)) {
        (true, true) => Some("a cell that is free until then"),
        (false, false) => Some("a cell that is blocked until then"),
        (false, true) if grid.heights().is_some_and(|h| h[index as usize].is_nan()) => Some("a cell whose height is known"),
        _ => None,
    }
}

fn said(cell: Point) -> String {
    format!("({}, {})", cell.x, cell.y)
}

fn wrong(index: usize, field: &str, value: impl ToString, allowed: &'static str) -> ScenarioError {
    ScenarioError::Change { field: format!("changes[{index}]{field}"), value: value.to_string(), allowed }
}

/// Whether the changes can be made one after the other.
pub(super) fn check_changes(grid: &Grid, spec: &ScenarioSpec) -> Result<(), ScenarioError> {
    let changes = &spec.changes;
    if changes.len() > MAX_CHANGES {
        let (field, value) = ("changes".into(), changes.len().to_string());
        return Err(ScenarioError::Change { field, value, allowed: "a list of at most 1000" });
    }
    if changes.is_empty() {
        return Ok(());
    }
    let mut map = grid.clone();
    let mut before = 0;
    for (index, change) in changes.iter().enumerate() {
        if change.at < before {
            return Err(wrong(index, ".at", change.at, "no iteration before that of the change before it"));
        }
        before = change.at;
        change.make(&mut map, spec, index)?;
    }
    Ok(())
}

impl Scenario {
    /// The scenario on the map as a change leaves it, without changes to come.
    ///
    /// # Errors
    /// [`ScenarioError::Change`] names the field, the value and what is allowed.
    pub fn changed(&self, change: &Change) -> Result<Self, ScenarioError> {
        let mut grid = self.drawn.clone();
        change.make(&mut grid, &self.spec, 0)?;
        Self::new(grid, ScenarioSpec { changes: Vec::new(), ..self.spec.clone() })
    }
}
