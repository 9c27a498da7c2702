//! A path as a list of cells, and its audit: is it really one, under the scenario's rules?

use crate::map::{Cell, OFFSETS, Point};
use crate::scenario::Scenario;
use thiserror::Error;

/// Cells from start to goal, both included.
pub type Path = Vec<Cell>;

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
    /// Two cells in a row are not neighbours.
    #[error("step {0} of the path leads to a cell that is no neighbour")]
    NotAdjacent(usize),
    /// A diagonal step that the movement does not allow.
    #[error("step {index} of the path, from ({}, {}) to ({}, {}), cuts a corner or is no allowed move", from.x, from.y, to.x, to.y)]
    ForbiddenMove {
        /// Which step.
        index: usize,
        /// From here.
        from: Point,
        /// To there.
        to: Point,
    },
}

/// Checks a path of points against the scenario: ends, obstacles, adjacency, corner rule.
///
/// # Errors
/// The first [`Flaw`]: cells outside or blocked come first, then the start, the steps, the goal.
pub fn audit(scenario: &Scenario, path: &[Point]) -> Result<(), Flaw> {
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
    for (index, step) in path.windows(2).enumerate() {
        let (from, to) = (step[0], step[1]);
        let d = direction_between(from, to).ok_or(Flaw::NotAdjacent(index))?;
        if !spec.movement.allows(grid, i64::from(from.x), i64::from(from.y), d) {
            return Err(Flaw::ForbiddenMove { index, from, to });
        }
    }
    if last != spec.goals[0].at {
        return Err(Flaw::WrongEnd(last));
    }
    Ok(())
}

/// The direction of the step between two neighbouring cells.
pub fn direction_between(from: Point, to: Point) -> Option<u8> {
    let step = (i64::from(to.x) - i64::from(from.x), i64::from(to.y) - i64::from(from.y));
    OFFSETS.iter().position(|&(dx, dy)| (i64::from(dx), i64::from(dy)) == step).map(|d| d as u8)
}

/// A path's cells as points.
pub fn points(scenario: &Scenario, path: &[Cell]) -> Vec<Point> {
    path.iter().map(|&c| scenario.grid.point(c)).collect()
}
