//! Merge and solve: an exact search among the cells where the ants have been, and a little more.
//!
//! What was searched stays: iteration by iteration the part of the map grows, and the search goes on where it had to stop
//! ([`Within`](crate::exact::Within), of polylines [`PolylinesWithin`](crate::exact::PolylinesWithin)). So a cell is expanded again only where a
//! better way to it has turned up, and the proof at the end begins with all that merging
//! has expanded.

use std::sync::Arc;

use crate::aco::ant::Ant;
use crate::aco::criterion::Judge;
use crate::map::Cell;
use crate::metrics::SAME_LENGTH;
use crate::path::Path;
use crate::planner::Certificate;
use crate::scenario::Scenario;

use super::inside::Inside;
use super::params::Paths;

/// The search of a colony, and how far around the best path it looks.
#[derive(Clone)]
pub struct Merge {
    search: Inside,
    corridor: Corridor,
    /// Expansions that were told already.
    told: u64,
}

impl Merge {
    /// Of lengths, on a scenario with all its steps, within a corridor.
    pub fn new(scenario: &Arc<Scenario>, corridor: Corridor) -> Self {
        Self::of(Paths::Steps, Judge::Length, scenario, corridor)
    }

    /// The same for paths of either kind by a criterion; polylines on a plane alone, by their lengths.
    pub fn of(paths: Paths, criterion: Judge, scenario: &Arc<Scenario>, corridor: Corridor) -> Self {
        Self { search: Inside::new(scenario, paths, criterion), corridor, told: 0 }
    }

    /// Takes in where an ant has been, widened by so many cells; `scenario` is the one on which it has walked.
    pub fn gather(&mut self, scenario: &Scenario, ant: &Ant, widening: u8) {
        let mut at = scenario.start;
        self.search.widen(at, widening);
        for &d in ant.steps() {
            at = scenario.moves.step(at, d);
            self.search.widen(at, widening);
        }
    }

    /// Takes in the corridor around a path.
    pub fn follow(&mut self, path: &[Cell]) {
        path.iter().for_each(|&cell| self.search.widen(cell, self.corridor.radius));
    }

    /// A path of this value, in cells, is known from elsewhere: only better ones are looked for.
    pub fn bound_by(&mut self, known: f64) {
        self.search.bound_by(known);
    }

    /// Searches among all that was taken in; the best path there, with its value by the criterion, in cells.
    pub fn solve(&mut self) -> Option<(Path, f64)> {
        self.search.go_on(u64::MAX);
        self.search.best()
    }

    /// Has the next corridor be wider, or narrow again after a better path.
    pub fn learn(&mut self, is_better: bool) {
        self.corridor.learn(is_better);
    }

    /// Searches the whole map for what is better than `known`, a value in cells, by no more than so many expansions.
    pub fn prove(&mut self, known: f64, most: u64) -> Option<(Path, f64)> {
        self.bound_by(known);
        self.search.widen_to_all();
        self.search.go_on(most);
        self.search.best()
    }

    /// Whether nothing is better than what was found.
    pub fn is_proven(&self) -> bool {
        self.search.is_proven()
    }

    /// What is proven of a best path of this value in cells.
    pub fn certificate(&self, value: f64) -> Certificate {
        let complete = self.search.is_proven();
        // What states were left out for equals may add up to as much.
        let lower_bound = if complete { value } else { self.search.lower_bound() * (1.0 - SAME_LENGTH) };
        Certificate { lower_bound, expansions: self.search.expansions(), complete }
    }

    /// Expansions since this was asked last.
    pub fn take_expansions(&mut self) -> u64 {
        let all = self.search.expansions();
        all - std::mem::replace(&mut self.told, all)
    }

    /// Whether each cell of the map was taken in, row by row.
    pub fn part(&self) -> &[bool] {
        self.search.part()
    }

    /// What it holds in bytes, its own size not counted.
    pub fn bytes(&self) -> usize {
        self.search.bytes()
    }
}

/// How far around the best path a search looks: wider while nothing better is found, narrow again after.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corridor {
    /// Cells at first, and after a better path.
    pub narrow: u8,
    /// Cells at most; where that is [`Corridor::narrow`], it never changes.
    pub wide: u8,
    /// Cells now.
    pub radius: u8,
}

impl Corridor {
    /// Twice as wide, one cell at least, or narrow again.
    pub fn learn(&mut self, is_better: bool) {
        let wider = self.radius.saturating_mul(2).max(1).min(self.wide);
        self.radius = if is_better { self.narrow } else { wider };
    }
}
