//! The shortest drive of somebody who knows in advance what will move.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::surroundings::{Walls, map_at, steps};
use crate::exact::{Distance, Estimate, Reference};
use crate::map::{Cell, Grid};
use crate::scenario::{DriveSpec, Scenario};

/// Most states, cells times steps, that are searched; each is 16 bytes.
pub const MOST_STATES: u64 = 1 << 22;

/// Length in cells of the shortest drive to the goal of a robot that knows every change and every timetable. It may wait wherever it likes;
/// a wait costs no length, and of drives of equal length the one of fewer steps counts. Unknown for more than [`MOST_STATES`] states.
///
/// A* over (cell, step), by the distance to the goal on an open map. Once all walls have changed and all tracks are gone through, the map repeats itself with the least common
/// multiple of their periods, and the last step leads back to the first of that span: so the search has an end and is exact all the same.
pub fn clairvoyant(scenario: &Scenario) -> Reference {
    let nothing = DriveSpec::default();
    let moving = scenario.spec.drive.as_ref().unwrap_or(&nothing);
    let Some(time) = Time::of(moving).filter(|time| time.steps() * scenario.grid.len() as u64 <= MOST_STATES) else {
        return Reference::Unknown;
    };
    Search::new(scenario, moving, time).run().map_or(Reference::NoPath, |value| Reference::Proven { value })
}

/// The steps at which maps differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Time {
    /// The first step of the span that repeats itself.
    settled: u32,
    /// Its length; 1 where nothing moves any longer.
    period: u32,
}

impl Time {
    /// None where the span is longer than could be searched.
    fn of(moving: &DriveSpec) -> Option<Self> {
        let walls = moving.changes.last().map_or(0, |change| change.at_step);
        let settled = moving.tracks.iter().map(|track| track.settled()).fold(walls, u32::max);
        let periods = moving.tracks.iter().filter_map(|track| track.period());
        let period = periods.map(u64::from).try_fold(1, |all: u64, one| {
            let both = all / common_divisor(all, one) * one;
            (both <= MOST_STATES).then_some(both)
        })?;
        Some(Self { settled, period: period as u32 })
    }

    fn steps(self) -> u64 {
        u64::from(self.settled) + u64::from(self.period)
    }

    fn after(self, step: u32) -> u32 {
        if u64::from(step) + 1 < self.steps() { step + 1 } else { self.settled }
    }
}

fn common_divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { common_divisor(b, a % b) }
}

/// A cell at a step, and what it costs to be there.
#[derive(Clone, Copy, PartialEq)]
struct Open {
    /// The length and the estimate of the rest.
    f: f64,
    length: f64,
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
    moving: &'a DriveSpec,
    time: Time,
    estimate: Distance,
    /// Of each step: the walls as drawn, and the map by all timetables as the robot feels it.
    walls: Vec<Grid>,
    maps: Vec<Grid>,
    /// Least length and steps known, by step and cell.
    known: Vec<(f64, u32)>,
    open: BinaryHeap<Open>,
}

impl<'a> Search<'a> {
    fn new(scenario: &'a Scenario, moving: &'a DriveSpec, time: Time) -> Self {
        let mut all = Walls::new(scenario.drawn.clone());
        let walls: Vec<Grid> = (0..time.steps() as u32).map(|step| all.at(step, &moving.changes).clone()).collect();
        let felt = |(walls, step): (&Grid, u32)| scenario.spec.felt(&map_at(&scenario.spec, walls, &moving.tracks, step, None));
        let maps = walls.iter().zip(0..).map(felt).collect();
        let known = vec![(f64::INFINITY, u32::MAX); time.steps() as usize * scenario.grid.len()];
        let estimate = Distance::of(scenario);
        Self { scenario, moving, time, estimate, walls, maps, known, open: BinaryHeap::new() }
    }

    fn run(mut self) -> Option<f64> {
        self.offer(0.0, 0, 0, self.scenario.start);
        while let Some(open) = self.open.pop() {
            if open.cell == self.scenario.goal {
                return Some(open.length);
            }
            if (open.length, open.taken) == self.known[self.state(open.step, open.cell)] {
                self.expand(open);
            }
        }
        None
    }

    fn state(&self, step: u32, cell: Cell) -> usize {
        step as usize * self.scenario.grid.len() + cell as usize
    }

    fn offer(&mut self, length: f64, taken: u32, step: u32, cell: Cell) {
        let state = self.state(step, cell);
        let (shortest, fewest) = self.known[state];
        if length < shortest || (length == shortest && taken < fewest) {
            self.known[state] = (length, taken);
            let at = self.scenario.grid.point(cell);
            let f = length + self.estimate.to_goal(at.x, at.y);
            self.open.push(Open { f, length, taken, step, cell });
        }
    }

    /// Where the robot is in the way of what moves, that gives way to it: there the map is another one.
    fn expand(&mut self, open: Open) {
        let Open { length, taken, step, cell, .. } = open;
        let timetable = &self.maps[step as usize];
        let gives_way = timetable.is_blocked(cell);
        let robot = timetable.point(cell);
        let (scenario, walls) = (self.scenario, &self.walls[step as usize]);
        let spec = &scenario.spec;
        let around = gives_way.then(|| spec.felt(&map_at(spec, walls, &self.moving.tracks, step, Some(robot))));
        let map = around.as_ref().unwrap_or(timetable);
        let moves = steps(scenario, map, cell).map(|(d, to)| (length + scenario.moves.length(cell, d), to));
        let ways: Vec<(f64, Cell)> = std::iter::once((length, cell)).chain(moves).collect();
        let later = self.time.after(step);
        ways.into_iter().for_each(|(length, cell)| self.offer(length, taken + 1, later, cell));
    }
}

#[cfg(test)]
mod tests;
