//! A path that somebody draws: piece by piece along allowed steps, and measured by what planners' paths are measured by.

use crate::error::DrawnError;
use crate::map::{Cell, Point};
use crate::path::{Flaw, PathKind, audit};
use crate::scenario::Scenario;

/// What is still to be done until a drawn path counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Standing {
    /// It leads from the start by every goal, and ends at one.
    Complete,
    /// Every step of it is allowed, but it has not come by this goal, or does not end at one.
    Unfinished(Point),
    /// It is no path on this map.
    Flawed(Flaw),
}

/// The way straight on from one cell to another: each step is the allowed one that leads closest. Without the first cell.
///
/// ```
/// use formicarium::drawn::towards;
/// use formicarium::map::{Grid, Movement, Point};
/// use formicarium::scenario::Scenario;
///
/// let scenario = Scenario::on(Grid::open(4, 2)?, Movement::default(), Point::new(0, 0), Point::new(3, 1))?;
/// let way = towards(&scenario, Point::new(0, 0), Point::new(3, 1))?;
/// assert_eq!(way, [(1, 1), (2, 1), (3, 1)].map(|(x, y)| Point::new(x, y)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`DrawnError`] where the cells cannot be stood on, and where no step leads closer.
pub fn towards(scenario: &Scenario, from: Point, to: Point) -> Result<Vec<Point>, DrawnError> {
    if scenario.by_slices().is_some() {
        return Err(DrawnError::Slices);
    }
    let (mut at, goal) = (standable(scenario, from)?, standable(scenario, to)?);
    let (grid, moves) = (&scenario.grid, &scenario.moves);
    let mut way = Vec::new();
    while at != goal {
        let closest = moves.directions(at).map(|d| moves.step(at, d)).min_by_key(|&c| squared(grid.point(c), to));
        let here = grid.point(at);
        let closer = |c: &Cell| squared(grid.point(*c), to) < squared(here, to);
        let no_way = DrawnError::NoWay { x: here.x, y: here.y, to_x: to.x, to_y: to.y };
        at = closest.filter(closer).ok_or(no_way)?;
        way.push(grid.point(at));
    }
    Ok(way)
}

/// How far a drawn path has come.
pub fn standing(scenario: &Scenario, path: &[Point]) -> Standing {
    match audit(scenario, path, PathKind::Steps) {
        Ok(()) => Standing::Complete,
        Err(Flaw::WrongEnd(_)) => {
            let missed = scenario.spec.goals.iter().find(|goal| !path.contains(&goal.at));
            Standing::Unfinished(missed.unwrap_or(&scenario.spec.goals[0]).at)
        }
        Err(Flaw::MissedGoal(goal)) => Standing::Unfinished(goal),
        Err(flaw) => Standing::Flawed(flaw),
    }
}

fn standable(scenario: &Scenario, at: Point) -> Result<Cell, DrawnError> {
    let (grid, Point { x, y }) = (&scenario.grid, at);
    if !grid.contains(at) {
        return Err(DrawnError::Outside { x, y });
    }
    let cell = grid.cell(at);
    if grid.is_blocked(cell) { Err(DrawnError::Blocked { x, y }) } else { Ok(cell) }
}

/// Squared distance.
fn squared(a: Point, b: Point) -> i64 {
    let (dx, dy) = (i64::from(a.x) - i64::from(b.x), i64::from(a.y) - i64::from(b.y));
    dx * dx + dy * dy
}
