//! The map around the robot, step by step.

use crate::map::{ALL_DIRECTIONS, Cell, Direction, Grid, Point, offset};
use crate::path::direction_between;
use crate::scenario::{DriveChange, Scenario, ScenarioSpec, Track};

/// Squared distance in cells up to which a robot always sees: a step of two cells by one touches nothing farther.
const ALWAYS_SEEN: f64 = 5.0;

/// The walls of a drive, from step to step.
#[derive(Clone)]
pub(super) struct Walls {
    grid: Grid,
    /// Changes made.
    made: usize,
}

impl Walls {
    /// Before all changes.
    pub(super) fn new(grid: Grid) -> Self {
        Self { grid, made: 0 }
    }

    /// The walls of a step; steps never go back.
    pub(super) fn at(&mut self, step: u32, changes: &[DriveChange]) -> &Grid {
        while let Some(change) = changes.get(self.made).filter(|change| change.at_step <= step) {
            change.make(&mut self.grid);
            self.made += 1;
        }
        &self.grid
    }
}

/// The map of a step: walls and obstacles. Of a robot all keep clear.
pub(super) fn map_at(spec: &ScenarioSpec, walls: &Grid, tracks: &[Track], step: u32, robot: Option<Point>) -> Grid {
    let mut grid = walls.clone();
    for track in tracks {
        let centre = robot.map_or_else(|| track.at(step), |robot| track.clear_of(step, robot, |squared| spec.touches(squared)));
        let covered = centre.into_iter().flat_map(|centre| track.covered(centre, walls));
        covered.for_each(|p| grid.set_blocked(grid.cell(p), true));
    }
    if let Some(robot) = robot {
        grid.set_blocked(grid.cell(robot), false);
    }
    grid
}

/// Whether a step between two cells is allowed on a map that the scenario's has become.
pub(super) fn is_allowed(scenario: &Scenario, grid: &Grid, from: Cell, to: Cell) -> bool {
    let (a, b) = (grid.point(from), grid.point(to));
    let goes = |d: Direction| scenario.spec.movement.allows(grid, i64::from(a.x), i64::from(a.y), d);
    let passable = || scenario.moves.relief().is_none_or(|relief| relief.is_passable(from, to));
    direction_between(a, b).is_some_and(goes) && passable()
}

/// Length in cells of a step between two cells; 0 where no step leads from one to the other.
pub(super) fn step_length(scenario: &Scenario, from: Cell, to: Cell) -> f64 {
    // The map has changed: what is allowed on the scenario's own says nothing.
    let direction = direction_between(scenario.grid.point(from), scenario.grid.point(to));
    direction.map_or(0.0, |d| scenario.moves.length(from, d))
}

/// The steps from a cell that are allowed on such a map, each with the cell that it leads to.
pub(super) fn steps<'a>(scenario: &'a Scenario, grid: &'a Grid, from: Cell) -> impl Iterator<Item = (Direction, Cell)> + 'a {
    let at = grid.point(from);
    (0..ALL_DIRECTIONS as Direction).filter_map(move |d| {
        let (dx, dy) = offset(d);
        let to = Point::new(at.x.checked_add_signed(dx)?, at.y.checked_add_signed(dy)?);
        let to = grid.contains(to).then(|| grid.cell(to))?;
        is_allowed(scenario, grid, from, to).then_some((d, to))
    })
}

/// What a robot comes to know of the map as it is; true where that is news. Without `sight` it sees all of it.
pub(super) fn look(known: &mut Grid, now: &Grid, at: Point, sight: Option<f64>) -> bool {
    let Some(sight) = sight else {
        let news = known != now;
        *known = now.clone();
        return news;
    };
    let most = (sight * sight).max(ALWAYS_SEEN);
    // Not farther than the map is wide, whatever was asked for.
    let reach = libm::ceil(sight.max(3.0)).min(f64::from(now.width().max(now.height()))) as u32;
    let mut news = false;
    for y in at.y.saturating_sub(reach)..=(at.y + reach).min(now.height() - 1) {
        for x in at.x.saturating_sub(reach)..=(at.x + reach).min(now.width() - 1) {
            let (dx, dy) = (f64::from(x.abs_diff(at.x)), f64::from(y.abs_diff(at.y)));
            let cell = now.cell(Point::new(x, y));
            if dx * dx + dy * dy <= most && known.is_blocked(cell) != now.is_blocked(cell) {
                known.set_blocked(cell, now.is_blocked(cell));
                news = true;
            }
        }
    }
    news
}

/// The cells in which two maps of one size differ: those that became blocked, and those that became free.
pub(super) fn differences(before: &Grid, now: &Grid) -> (Vec<Point>, Vec<Point>) {
    let cells = before.blocked().iter().zip(now.blocked()).enumerate();
    let differing = cells.filter(|(_, (before, now))| before != now).map(|(c, (_, &now))| (before.point(c as Cell), now));
    let (blocked, freed): (Vec<_>, Vec<_>) = differing.partition(|(_, now)| *now);
    let points = |cells: Vec<(Point, bool)>| cells.into_iter().map(|(p, _)| p).collect();
    (points(blocked), points(freed))
}
