//! The shortest drive of somebody who knows in advance what will move.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::surroundings::{Walls, map_at, steps};
use crate::exact::Reference;
use crate::map::{Cell, Grid};
use crate::scenario::{DriveSpec, Scenario};

/// Most states, cells times steps, that are searched: one to five seconds.
pub const MOST_STATES: u64 = 1 << 22;

/// Length in cells of the shortest drive to the goal of a robot that knows every change and every timetable. It may wait wherever it likes;
/// a wait costs no length, and of drives of equal length the one of fewer steps counts. Unknown for more than [`MOST_STATES`] states.
///
/// Dijkstra over (cell, step). Once all walls have changed and all tracks are gone through, the map repeats itself with the least common
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
    length: f64,
    taken: u32,
    step: u32,
    cell: Cell,
}

impl Ord for Open {
    /// The shortest first, of equals the one of fewer steps, then in the order of steps and cells.
    fn cmp(&self, other: &Self) -> Ordering {
        let rest = |open: &Self| (open.taken, open.step, open.cell);
        other.length.total_cmp(&self.length).then_with(|| rest(other).cmp(&rest(self)))
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
        Self { scenario, moving, time, walls, maps, known, open: BinaryHeap::new() }
    }

    fn run(mut self) -> Option<f64> {
        self.offer(Open { length: 0.0, taken: 0, step: 0, cell: self.scenario.start });
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

    fn offer(&mut self, open: Open) {
        let state = self.state(open.step, open.cell);
        let (length, taken) = self.known[state];
        if open.length < length || (open.length == length && open.taken < taken) {
            self.known[state] = (open.length, open.taken);
            self.open.push(open);
        }
    }

    /// Where the robot is in the way of what moves, that gives way to it: there the map is another one.
    fn expand(&mut self, open: Open) {
        let Open { length, taken, step, cell } = open;
        let later = Open { length, taken: taken + 1, step: self.time.after(step), cell };
        let timetable = &self.maps[step as usize];
        let gives_way = timetable.is_blocked(cell);
        let robot = timetable.point(cell);
        let (scenario, walls) = (self.scenario, &self.walls[step as usize]);
        let spec = &scenario.spec;
        let around = gives_way.then(|| spec.felt(&map_at(spec, walls, &self.moving.tracks, step, Some(robot))));
        let map = around.as_ref().unwrap_or(timetable);
        let ways: Vec<Open> = steps(scenario, map, cell)
            .map(|(d, to)| Open { length: length + scenario.moves.length(cell, d), cell: to, ..later })
            .collect();
        self.offer(later);
        ways.into_iter().for_each(|way| self.offer(way));
    }
}

#[cfg(test)]
mod tests;
