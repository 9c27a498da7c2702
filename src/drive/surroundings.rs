//! The map around the robot, step by step.

use crate::map::{Cell, Direction, Grid, Point, mean_factor, step_length};
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

/// Whether ways cost more than their length: on ground that is drawn dearer, or near obstacles. On a terrain they do not.
pub(super) fn is_weighted(scenario: &Scenario) -> bool {
    scenario.drawn.factors().is_some() || scenario.spec.robot.is_some_and(|robot| robot.inflation.is_some())
}

/// Whether a step between two cells is allowed on a map that the scenario's has become.
pub(super) fn is_allowed(scenario: &Scenario, grid: &Grid, from: Cell, to: Cell) -> bool {
    let (a, b) = (grid.point(from), grid.point(to));
    let goes = |d: Direction| scenario.spec.movement.allows(grid, i64::from(a.x), i64::from(a.y), d);
    direction_between(a, b).is_some_and(goes) && is_passable(scenario, from, to)
}

/// Whether the ground between two cells is not too steep.
pub(super) fn is_passable(scenario: &Scenario, from: Cell, to: Cell) -> bool {
    scenario.moves.relief().is_none_or(|relief| relief.is_passable(from, to))
}

/// Length and cost of an allowed step, in cells, the cost on a map as it is felt and none where ways cost their length.
pub(super) fn step_between(scenario: &Scenario, felt: &Grid, from: Cell, to: Cell) -> (f64, Option<f64>) {
    // The map has changed: what is allowed on the scenario's own says nothing.
    let Some(d) = direction_between(felt.point(from), felt.point(to)) else { return (0.0, None) };
    if !is_weighted(scenario) {
        return (scenario.moves.length(from, d), None);
    }
    let by = |dx: i32, dy: i32| from.wrapping_add_signed(dy * felt.width() as i32 + dx) as usize;
    let factor = |dx, dy| felt.factors().map_or(1.0, |factors| f64::from(factors[by(dx, dy)]));
    (step_length(d), Some(step_length(d) * mean_factor(d, factor)))
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
