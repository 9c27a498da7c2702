//! The best drive of somebody who knows in advance what will move.

mod moments;
mod places;
mod time;

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use serde::Serialize;

use super::surroundings::{is_passable, is_weighted};
use crate::exact::Reference;
use crate::map::{ALL_DIRECTIONS, Cell, Direction, Point, mean_factor, offset, step_length};
use crate::scenario::{DriveSpec, Scenario};

use moments::Moments;
use places::Places;
use time::Time;

/// Most states, cells at steps, that are searched; each is 16 bytes.
pub const MOST_STATES: u64 = 1 << 22;

/// Most cells of the maps of all steps that are kept, of those that can be reached; each is a byte, on weighted ground 5.
pub const MOST_KEPT: u64 = 1 << 25;

/// Most cells of all maps on which room and costs of a robot are worked out: some seconds.
pub const MOST_FELT: u64 = 1 << 28;

/// What is searched at most.
#[derive(Clone, Copy)]
struct Limits {
    states: u64,
    kept: u64,
    felt: u64,
}

const MOST: Limits = Limits { states: MOST_STATES, kept: MOST_KEPT, felt: MOST_FELT };

/// Why the best drive in advance is not searched for to the end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum TooMuch {
    /// There are more states.
    States {
        /// Cells that can be reached.
        cells: u32,
        /// Steps whose maps had been made by then.
        steps: u32,
        /// [`MOST_STATES`].
        most: u32,
    },
    /// Cells that can be reached times steps are more.
    Kept {
        /// Cells that can be reached.
        cells: u32,
        /// Steps whose maps had been made by then.
        steps: u32,
        /// [`MOST_KEPT`].
        most: u32,
    },
    /// Cells of the map times steps are more, and a robot's room is worked out on each.
    Felt {
        /// Cells of the map.
        cells: u32,
        /// Steps whose maps had been made by then.
        steps: u32,
        /// [`MOST_FELT`].
        most: u32,
    },
    /// All timetables together begin anew only after more steps.
    Period {
        /// [`MOST_STATES`].
        most: u32,
    },
}

/// Length in cells of the shortest drive to the goal of a robot that knows every change and every timetable; on weighted ground and with
/// costs near obstacles what the cheapest one costs. None where no drive arrives. The robot may wait wherever it likes; a wait costs nothing,
/// and of equal drives the one of fewer steps counts.
///
/// A* over (cell, step). Once all walls have changed and all tracks are gone through, the map repeats itself with the least common multiple
/// of their periods, and the last step leads back to the first of that span: so the search has an end and is exact all the same. It
/// estimates by the distance on an open map; where there may be too many states, and where ground is not plain, by the best path on the map
/// of all that is ever free, so that few states are searched where nothing but a wait is asked.
///
/// # Errors
/// [`TooMuch`]: it was given up.
pub fn best_in_advance(scenario: &Scenario) -> Result<Option<f64>, TooMuch> {
    best_within(scenario, MOST)
}

fn best_within(scenario: &Scenario, limits: Limits) -> Result<Option<f64>, TooMuch> {
    let nothing = DriveSpec::default();
    let moving = scenario.spec.drive.as_ref().unwrap_or(&nothing);
    Search::new(scenario, moving, Time::of(moving)?, limits).run()
}

/// The same as a reference of results, unknown where the search is given up.
pub fn clairvoyant(scenario: &Scenario) -> Reference {
    reference(best_in_advance(scenario))
}

/// What was found as a reference.
pub(super) fn reference(found: Result<Option<f64>, TooMuch>) -> Reference {
    found.map_or(Reference::Unknown, |best| best.map_or(Reference::NoPath, |value| Reference::Proven { value }))
}

/// A cell at a step, and what it costs to be there.
#[derive(Clone, Copy, PartialEq)]
struct Open {
    /// The cost and the estimate of the rest.
    f: f64,
    cost: f64,
    taken: u32,
    step: u32,
    cell: Cell,
}

impl Ord for Open {
    /// The least f first, of equals the one of fewer steps, then in the order of steps and cells.
    fn cmp(&self, other: &Self) -> Ordering {
        let rest = |open: &Self| (open.taken, open.step, open.cell);
        other.f.total_cmp(&self.f).then_with(|| rest(other).cmp(&rest(self)))
    }
}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Eq for Open {}

struct Search<'a> {
    scenario: &'a Scenario,
    time: Time,
    places: Places,
    /// By place: no way to the goal costs less.
    estimate: Vec<f64>,
    is_weighted: bool,
    moments: Moments<'a>,
    open: BinaryHeap<Open>,
    limits: Limits,
}

impl<'a> Search<'a> {
    fn new(scenario: &'a Scenario, moving: &'a DriveSpec, time: Time, limits: Limits) -> Self {
        let (places, is_weighted) = (Places::of(scenario, moving), is_weighted(scenario));
        let is_small = time.steps() * places.len() as u64 <= limits.states;
        let estimate = if is_small && !is_weighted { places.open_distances(scenario) } else { places.distances(scenario) };
        let moments = Moments::new(scenario, moving);
        Self { scenario, time, places, estimate, is_weighted, moments, open: BinaryHeap::new(), limits }
    }

    fn run(mut self) -> Result<Option<f64>, TooMuch> {
        self.offer(0.0, 0, 0, self.scenario.start);
        while let Some(open) = self.open.pop() {
            if open.cell == self.scenario.goal {
                return Ok(Some(open.cost));
            }
            let place = self.places.number(open.cell).expect("a cell that was reached");
            if (open.cost, open.taken) == self.moments.get(open.step).known(place) {
                self.expand(open);
                self.check()?;
            }
        }
        Ok(None)
    }

    /// # Errors
    /// [`TooMuch`] once more is searched than is sensible.
    fn check(&self) -> Result<(), TooMuch> {
        let (reached, all, made) = (self.places.len() as u32, self.scenario.grid.len() as u32, self.moments.count);
        let (steps, Limits { states, kept, felt }) = (made as u32, self.limits);
        if self.moments.states > states {
            return Err(TooMuch::States { cells: reached, steps, most: states as u32 });
        }
        if made * u64::from(reached) > kept {
            return Err(TooMuch::Kept { cells: reached, steps, most: kept as u32 });
        }
        if self.scenario.spec.robot.is_some() && made * u64::from(all) > felt {
            return Err(TooMuch::Felt { cells: all, steps, most: felt as u32 });
        }
        Ok(())
    }

    fn offer(&mut self, cost: f64, taken: u32, step: u32, cell: Cell) {
        let Some(place) = self.places.number(cell).filter(|&place| self.estimate[place].is_finite()) else { return };
        if self.moments.reach(step, place, (cost, taken), &self.places) {
            self.open.push(Open { f: cost + self.estimate[place], cost, taken, step, cell });
        }
    }

    /// Where the robot is in the way of what moves, that gives way to it: there the map is another one.
    fn expand(&mut self, open: Open) {
        let Open { cost, taken, step, cell, .. } = open;
        let robot = self.scenario.grid.point(cell);
        let place = |at: Point| self.places.number(self.scenario.grid.cell(at));
        let gives_way = place(robot).is_none_or(|place| self.moments.get(step).is_blocked(place));
        let steps = if gives_way {
            let around = self.moments.around(step, robot);
            self.steps(robot, |at| !around.is_blocked(at), |at| around.factor(at))
        } else {
            let timetable = self.moments.get(step);
            let is_free = |at: Point| place(at).is_some_and(|place| !timetable.is_blocked(place));
            self.steps(robot, is_free, |at| place(at).map_or(1.0, |place| timetable.factor(place)))
        };
        let later = self.time.after(step);
        self.offer(cost, taken + 1, later, cell);
        steps.into_iter().for_each(|(length, to)| self.offer(cost + length, taken + 1, later, to));
    }

    /// The steps that are allowed from a cell, each with its cost and the cell that it leads to, by what is free and dear around.
    fn steps(&self, at: Point, is_free: impl Fn(Point) -> bool, factor: impl Fn(Point) -> f64) -> Vec<(f64, Cell)> {
        let Scenario { grid, spec, moves, .. } = self.scenario;
        let near = |dx: i32, dy: i32| {
            let near = Point::new(at.x.checked_add_signed(dx)?, at.y.checked_add_signed(dy)?);
            grid.contains(near).then_some(near)
        };
        let goes = |d: Direction| spec.movement.allows_where(d, |dx, dy| near(dx, dy).is_some_and(&is_free));
        let cost = |d: Direction| match self.is_weighted {
            true => step_length(d) * mean_factor(d, |dx, dy| near(dx, dy).map_or(1.0, &factor)),
            false => moves.length(grid.cell(at), d),
        };
        let step = |d: Direction| {
            let (dx, dy) = offset(d);
            let to = near(dx, dy).map(|to| grid.cell(to)).filter(|_| goes(d))?;
            is_passable(self.scenario, grid.cell(at), to).then(|| (cost(d), to))
        };
        (0..ALL_DIRECTIONS as Direction).filter_map(step).collect()
    }
}

#[cfg(test)]
mod tests;
