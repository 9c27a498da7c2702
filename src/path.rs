//! A path as a list of cells, its audit (is it really one, under the scenario's rules?), and its refinement by line of sight.

use crate::map::{ALL_DIRECTIONS, Cell, Grid, Movement, Moves, Point, Way, offset};
use crate::param_choice;
use crate::scenario::Scenario;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Cells from start to goal, both included.
pub type Path = Vec<Cell>;

/// How the cells of a path follow each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum PathKind {
    /// By allowed steps from cell to neighbouring cell.
    #[default]
    Steps,
    /// By straight segments between centres of cells in line of sight.
    Polyline,
}

/// The first thing wrong with a path. Steps and cells are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum Flaw {
    /// It has no cell at all.
    #[error("the path is empty")]
    Empty,
    /// It begins elsewhere.
    #[error("the path begins at ({}, {}), not at the start", .0.x, .0.y)]
    WrongStart(Point),
    /// It ends elsewhere.
    #[error("the path ends at ({}, {}), not at the goal", .0.x, .0.y)]
    WrongEnd(Point),
    /// A cell lies outside the map.
    #[error("cell {0} of the path lies outside the map")]
    OutsideMap(usize),
    /// A cell is an obstacle.
    #[error("cell {index} of the path, ({}, {}), is blocked", at.x, at.y)]
    Collision {
        /// Which cell of the path.
        index: usize,
        /// Where it is.
        at: Point,
    },
    /// Two cells in a row do not see each other.
    #[error("segment {index} of the path, from ({}, {}) to ({}, {}), touches an obstacle", from.x, from.y, to.x, to.y)]
    OutOfSight {
        /// Which segment.
        index: usize,
        /// From here.
        from: Point,
        /// To there.
        to: Point,
    },
    /// It does not come by a goal.
    #[error("the path misses the goal at ({}, {})", .0.x, .0.y)]
    MissedGoal(Point),
    /// Two cells in a row are not neighbours.
    #[error("step {0} of the path leads to a cell that is no neighbour")]
    NotAdjacent(usize),
    /// A step that the movement does not allow.
    #[error("step {index} of the path, from ({}, {}) to ({}, {}), cuts a corner, is too steep or is no allowed move", from.x, from.y, to.x, to.y)]
    ForbiddenMove {
        /// Which step.
        index: usize,
        /// From here.
        from: Point,
        /// To there.
        to: Point,
    },
}

/// Checks a path of points against the scenario: obstacles, ends, joints, and that it comes by every goal and ends at one.
///
/// ```
/// use formicarium::map::{Grid, Movement, Point};
/// use formicarium::path::{Flaw, PathKind, audit};
/// use formicarium::scenario::Scenario;
///
/// let grid = Grid::from_bytes(3, 2, &[0, 1, 0, 0, 0, 0])?;
/// let scenario = Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(2, 0))?;
/// let path = [(0, 0), (0, 1), (1, 1), (2, 1), (2, 0)].map(|(x, y)| Point::new(x, y));
/// assert_eq!(audit(&scenario, &path, PathKind::Steps), Ok(()));
///
/// let through = [(0, 0), (1, 0), (2, 0)].map(|(x, y)| Point::new(x, y));
/// assert_eq!(audit(&scenario, &through, PathKind::Steps), Err(Flaw::Collision { index: 1, at: Point::new(1, 0) }));
/// # Ok::<(), formicarium::error::ScenarioError>(())
/// ```
///
/// # Errors
/// The first [`Flaw`]: cells outside or blocked come first, then the start, the joints, the goals.
pub fn audit(scenario: &Scenario, path: &[Point], kind: PathKind) -> Result<(), Flaw> {
    let (grid, spec) = (&scenario.grid, &scenario.spec);
    let (Some(&first), Some(&last)) = (path.first(), path.last()) else { return Err(Flaw::Empty) };
    for (index, &at) in path.iter().enumerate() {
        if !grid.contains(at) {
            return Err(Flaw::OutsideMap(index));
        }
        if grid.is_blocked(grid.cell(at)) {
            return Err(Flaw::Collision { index, at });
        }
    }
    if first != spec.start {
        return Err(Flaw::WrongStart(first));
    }
    for (index, joint) in path.windows(2).enumerate() {
        match kind {
            PathKind::Steps => audit_step(scenario, index, joint[0], joint[1])?,
            PathKind::Polyline => audit_segment(scenario, index, joint[0], joint[1])?,
        }
    }
    if spec.goals.iter().all(|g| g.at != last) {
        return Err(Flaw::WrongEnd(last));
    }
    match spec.goals.iter().find(|g| !path.contains(&g.at)) {
        Some(missed) => Err(Flaw::MissedGoal(missed.at)),
        None => Ok(()),
    }
}

/// Checks a path by slices, as cells and levels: its ends, and that each step leads to the next column within the limits, above the ground.
///
/// # Errors
/// The first [`Flaw`]. [`Flaw::WrongStart`] where the scenario is not by slices.
pub fn audit_slices(scenario: &Scenario, path: &[(Point, u32)]) -> Result<(), Flaw> {
    let (Some(&(first, _)), Some(&(last, _))) = (path.first(), path.last()) else { return Err(Flaw::Empty) };
    let Some(slices) = &scenario.slices else { return Err(Flaw::WrongStart(first)) };
    let levels = slices.rules().levels;
    if let Some(index) = path.iter().position(|&(at, level)| !scenario.grid.contains(at) || level > levels) {
        return Err(Flaw::OutsideMap(index));
    }
    let place = |&(at, level): &(Point, u32)| slices.place(at.x, at.y, level);
    let places: Vec<Cell> = path.iter().map(place).collect();
    if places[0] != slices.start() {
        return Err(Flaw::WrongStart(first));
    }
    for (index, step) in places.windows(2).enumerate() {
        if !(0..slices.directions()).any(|k| slices.step(step[0], k, Way::Forward) == Some(step[1])) {
            return Err(Flaw::ForbiddenMove { index, from: path[index].0, to: path[index + 1].0 });
        }
    }
    if places.last() == Some(&slices.goal()) { Ok(()) } else { Err(Flaw::WrongEnd(last)) }
}

fn audit_step(scenario: &Scenario, index: usize, from: Point, to: Point) -> Result<(), Flaw> {
    let d = direction_between(from, to).ok_or(Flaw::NotAdjacent(index))?;
    let (a, b) = (scenario.grid.cell(from), scenario.grid.cell(to));
    let flat = scenario.moves.relief().is_none_or(|relief| relief.is_passable(a, b));
    let allowed = flat && scenario.spec.movement.allows(&scenario.grid, i64::from(from.x), i64::from(from.y), d);
    if allowed { Ok(()) } else { Err(Flaw::ForbiddenMove { index, from, to }) }
}

fn audit_segment(scenario: &Scenario, index: usize, from: Point, to: Point) -> Result<(), Flaw> {
    if line_of_sight(scenario, from, to) { Ok(()) } else { Err(Flaw::OutOfSight { index, from, to }) }
}

/// What a segment comes across next: a cell that it crosses, entered through a side or exactly through a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Entered {
    x: i32,
    y: i32,
    /// Through a corner: the two cells that meet there beside the segment.
    beside: Option<[(i32, i32); 2]>,
}

/// The cells that the straight segment between the centres of two cells crosses, in order, without the first.
struct Segment {
    at: (i32, i32),
    to: (i32, i32),
    sign: (i32, i32),
    /// When the segment leaves its cell by a side in x and in y, on one scale: (1 + 2·steps in x)·|dy| and (1 + 2·steps in y)·|dx|.
    leaves: (i32, i32),
    /// What a step in x and in y adds to that.
    more: (i32, i32),
}

impl Segment {
    fn new(from: Point, to: Point) -> Self {
        let (at, to) = ((from.x as i32, from.y as i32), (to.x as i32, to.y as i32));
        let (dx, dy) = (to.0 - at.0, to.1 - at.1);
        let leaves = (dy.abs(), dx.abs());
        Self { at, to, sign: (dx.signum(), dy.signum()), leaves, more: (2 * leaves.0, 2 * leaves.1) }
    }
}

impl Iterator for Segment {
    type Item = Entered;

    #[inline]
    fn next(&mut self) -> Option<Entered> {
        if self.at == self.to {
            return None;
        }
        let ((x, y), (sx, sy), order) = (self.at, self.sign, self.leaves.0.cmp(&self.leaves.1));
        if order.is_le() {
            self.at.0 += sx;
            self.leaves.0 += self.more.0;
        }
        if order.is_ge() {
            self.at.1 += sy;
            self.leaves.1 += self.more.1;
        }
        let beside = order.is_eq().then_some([(x + sx, y), (x, y + sy)]);
        Some(Entered { x: self.at.0, y: self.at.1, beside })
    }
}

/// Whether the straight segment between the centres of two cells of the map touches no obstacle, under the scenario's corner rule: every
/// cell that it crosses is free, and where it passes exactly through a corner of cells, the rule allows the diagonal step there. With
/// 4 moves there is sight along rows and columns only. Whole-number arithmetic, so it is exact.
/// On a terrain no part of it may be too steep.
pub fn line_of_sight(scenario: &Scenario, from: Point, to: Point) -> bool {
    let passable = || scenario.moves.relief().is_none_or(|r| r.is_passable(scenario.grid.cell(from), scenario.grid.cell(to)));
    in_sight(&scenario.grid, scenario.spec.movement, from, to) && passable()
}

/// [`line_of_sight`] on a map that belongs to no scenario yet.
pub fn in_sight(grid: &Grid, movement: Movement, from: Point, to: Point) -> bool {
    if movement.moves == Moves::Four && from.x != to.x && from.y != to.y {
        return false;
    }
    let free = |(x, y): (i32, i32)| grid.is_free_at(i64::from(x), i64::from(y));
    let passes = |[a, b]: [(i32, i32); 2]| movement.corner_rule.allows(free(a), free(b));
    let enters = |cell: Entered| free((cell.x, cell.y)) && cell.beside.is_none_or(passes);
    free((from.x as i32, from.y as i32)) && Segment::new(from, to).all(enters)
}

/// The cells that a path of either kind crosses, in order: those of its segments, each joint once. A corner that a segment passes
/// exactly through is no cell. All cells of the path must lie on a map of this width.
pub fn crossed(width: u32, path: &[Cell]) -> impl Iterator<Item = Cell> + use<'_> {
    let point = move |c: Cell| Point::new(c % width, c / width);
    let between = move |ends: &[Cell]| Segment::new(point(ends[0]), point(ends[1])).map(move |e| e.y as u32 * width + e.x as u32);
    path.first().copied().into_iter().chain(path.windows(2).flat_map(between))
}

param_choice! {
    /// Refinement by line of sight (engine-room paper, section 3.3): which later node follows a kept one.
    pub enum Refinement {
        /// the farthest later node in sight
        Farthest = "farthest",
        /// the last node before the first one out of sight
        Next = "next",
        /// every node is kept: the path stays cell by cell
        None = "none",
    }
}

/// What refinement makes of a path of steps: from the start on, nodes in sight are dropped and the one that [`Refinement`] names is kept.
/// The polyline is never longer than the path, nor dearer: where the straight way may lead over a hill or through a swamp, nodes in sight
/// stay if it would be.
pub fn refine(scenario: &Scenario, path: &[Cell], how: Refinement) -> Path {
    let at = |k: usize| scenario.grid.point(path[k]);
    let mut refined: Path = path.first().copied().into_iter().collect();
    let mut here = 0;
    while here + 1 < path.len() {
        let sees = |&k: &usize| line_of_sight(scenario, at(here), at(k)) && no_detour(scenario, &path[here..=k]);
        // Neighbours on a path always see each other.
        let later = here + 2..path.len();
        let follower = match how {
            Refinement::Farthest => later.rev().find(sees),
            Refinement::Next => later.take_while(sees).last(),
            Refinement::None => None,
        };
        here = follower.unwrap_or(here + 1);
        refined.push(path[here]);
    }
    refined
}

/// Whether the straight way between the ends of a path is no longer than the path, on weighted ground no dearer: always on plain ground.
fn no_detour(scenario: &Scenario, path: &[Cell]) -> bool {
    let (false, [first, .., last]) = (scenario.moves.is_plain(), path) else { return true };
    scenario.path_length(&[*first, *last]) <= scenario.path_length(path)
}

/// The cells at which a path of either kind begins, turns or ends: straight stretches become one, and a cell twice in a row counts once.
#[cfg(feature = "whole")]
pub fn corners(scenario: &Scenario, path: &[Cell]) -> Vec<Point> {
    let mut corners: Vec<Point> = Vec::new();
    for at in points(scenario, path) {
        let away = |from: Point, to: Point| (to.x as i32 - from.x as i32, to.y as i32 - from.y as i32);
        match corners[..] {
            [.., last] if last == at => continue,
            [.., before, last] if !turns(away(before, last), away(last, at)) => corners.truncate(corners.len() - 1),
            _ => {}
        }
        corners.push(at);
    }
    corners
}

/// Whether two steps or segments lead in different directions.
pub(crate) fn turns(a: (i32, i32), b: (i32, i32)) -> bool {
    let cross = i64::from(a.0) * i64::from(b.1) - i64::from(a.1) * i64::from(b.0);
    let dot = i64::from(a.0) * i64::from(b.0) + i64::from(a.1) * i64::from(b.1);
    cross != 0 || dot < 0
}

/// The direction of the step between two neighbouring cells.
pub fn direction_between(from: Point, to: Point) -> Option<u8> {
    let step = (i64::from(to.x) - i64::from(from.x), i64::from(to.y) - i64::from(from.y));
    (0..ALL_DIRECTIONS as u8).find(|&d| (i64::from(offset(d).0), i64::from(offset(d).1)) == step)
}

/// A path's cells as points.
pub fn points(scenario: &Scenario, path: &[Cell]) -> Vec<Point> {
    scenario.cells_of(path).into_iter().map(|c| scenario.grid.point(c)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::CornerRule;

    fn scenario(rows: &[&str], corner_rule: CornerRule) -> Scenario {
        let cells: Vec<u8> = rows.iter().flat_map(|r| r.bytes().map(|b| u8::from(b == b'#'))).collect();
        let grid = Grid::from_bytes(rows[0].len() as u32, rows.len() as u32, &cells).expect("a map");
        let end = Point::new(grid.width() - 1, grid.height() - 1);
        Scenario::on(grid, Movement { moves: Moves::Eight, corner_rule }, Point::new(0, 0), end).expect("usable")
    }

    #[test]
    fn sight_by_hand() {
        let seen =
            |rows: &[&str], to: (u32, u32), rule| line_of_sight(&scenario(rows, rule), Point::new(0, 0), Point::new(to.0, to.1));
        // (0,0) → (2,1) crosses (1,0) and (1,1); (0,0) → (3,1) crosses (1,0) and (2,1) and, between them, no corner.
        assert!(seen(&["...", "#..", "..."], (2, 1), CornerRule::BothFree));
        assert!(!seen(&["...", ".#.", "..."], (2, 1), CornerRule::Always));
        assert!(!seen(&[".#.", "...", "..."], (2, 1), CornerRule::Always));
        // A unit diagonal is the step that the rule allows or not, also in the middle of a longer segment.
        for (rule, one, two) in
            [(CornerRule::Always, true, true), (CornerRule::OneFree, true, false), (CornerRule::BothFree, false, false)]
        {
            assert_eq!(seen(&["...", "..#", "..."], (2, 2), rule), one, "{rule:?}");
            assert_eq!(seen(&["...", "..#", ".#."], (2, 2), rule), two, "{rule:?}");
        }
    }

    #[test]
    fn crossed_cells_by_hand() {
        // Width 5. (0,0) → (2,1) crosses (1,0) and (1,1); (2,1) → (4,3) is a diagonal; (4,3) → (4,1) a column.
        let cells: Vec<Cell> = crossed(5, &[0, 7, 19, 9]).collect();
        assert_eq!(cells, [0, 1, 6, 7, 13, 19, 14, 9]);
        assert_eq!(crossed(5, &[3]).collect::<Vec<_>>(), [3]);
        assert_eq!(crossed(5, &[]).count(), 0);
    }

    #[test]
    fn refinement_drops_what_lies_in_sight() {
        let s = scenario(&["....", ".##.", "....", "...."], CornerRule::BothFree);
        // (0,0) down to (0,2), then east to (3,2), then south: only the bend at (0,2) stays, for (0,2) sees (3,3).
        assert_eq!(refine(&s, &[0, 4, 8, 9, 10, 11, 15], Refinement::Farthest), [0, 8, 15]);
        assert_eq!(refine(&s, &[0], Refinement::Farthest), [0]);
        assert_eq!(refine(&s, &[], Refinement::Farthest), Path::new());
        assert_eq!(refine(&s, &[0, 4, 8], Refinement::None), [0, 4, 8]);
    }

    #[test]
    fn a_node_out_of_sight_ends_the_search_for_the_next_but_not_for_the_farthest() {
        let s = scenario(&["....", "#...", "...."], CornerRule::BothFree);
        // From (0,0) by (1,0), (1,1), (1,2) to (2,1): the corner of (0,1) hides (1,1) and (1,2), but not (2,1).
        let path = [0, 1, 5, 9, 6];
        assert_eq!(refine(&s, &path, Refinement::Farthest), [0, 6]);
        assert_eq!(refine(&s, &path, Refinement::Next), [0, 1, 6]);
    }
}
