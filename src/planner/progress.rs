//! Where a planner stands: its effort, its history, its best path; and how a planner that works in iterations goes on.

use serde::Serialize;

use super::{Granularity, Status, held};
use crate::digest::Digest;
use crate::path::Path;
#[cfg(feature = "whole")]
use crate::scenario::Change;
use crate::scenario::Scenario;

/// The fair-budget axes: what has been spent so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Effort {
    /// Finished iterations.
    pub iterations: u32,
    /// Walks that were begun and ended: at the goal, at a dead end, or at the cap on moves. Of sampling trees, samples.
    pub constructed_paths: u64,
    /// Moves of ants: steps, steps back, and the move in which an ant finds itself lost at a dead end. Of swarms, the steps and steps back
    /// by which positions are decoded into paths; of sampling trees, the cells along which sight was tried.
    pub ant_moves: u64,
    /// Cells taken from the open list of a search.
    pub cell_expansions: u64,
}

impl Effort {
    /// Both together.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            iterations: self.iterations + other.iterations,
            constructed_paths: self.constructed_paths + other.constructed_paths,
            ant_moves: self.ant_moves + other.ant_moves,
            cell_expansions: self.cell_expansions + other.cell_expansions,
        }
    }

    /// What of it was spent after it was `before`.
    #[cfg(feature = "whole")]
    #[must_use]
    pub fn since(self, before: Self) -> Self {
        Self {
            iterations: self.iterations - before.iterations,
            constructed_paths: self.constructed_paths - before.constructed_paths,
            ant_moves: self.ant_moves - before.ant_moves,
            cell_expansions: self.cell_expansions - before.cell_expansions,
        }
    }
}

/// One finished iteration. Lengths in cells; `None` where no ant has arrived.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Record {
    /// From 1.
    pub iteration: u32,
    /// Length of the best path of all iterations so far: the shortest, unless more than its length makes a path the best.
    pub best_so_far: Option<f64>,
    /// Shortest length of this iteration.
    pub iteration_best: Option<f64>,
    /// Mean length of this iteration's arrived ants.
    pub iteration_mean: Option<f64>,
    /// Longest length of this iteration's arrived ants.
    pub iteration_worst: Option<f64>,
    /// Ants that arrived.
    pub arrived: u32,
}

impl Record {
    /// Of a search, which has one path or none; length in cells.
    pub fn of_search(iteration: u32, length: Option<f64>) -> Self {
        Self {
            iteration,
            best_so_far: length,
            iteration_best: length,
            iteration_mean: length,
            iteration_worst: length,
            arrived: u32::from(length.is_some()),
        }
    }

    /// With the length in cells of a path that a search has made of the ants' ways, which counts as the iteration's, too; its mean where no ant has
    /// arrived.
    #[must_use]
    pub fn with_found(self, length: f64) -> Self {
        let best = self.iteration_best.map_or(length, |best| best.min(length));
        let worst = self.iteration_worst.map_or(length, |worst| worst.max(length));
        let mean = self.iteration_mean.or(Some(length));
        Self { iteration_best: Some(best), iteration_mean: mean, iteration_worst: Some(worst), ..self }
    }
}

/// Lengths of the paths that arrive in one iteration, taken in one by one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tally {
    arrived: u32,
    sum: f64,
    best: Option<f64>,
    worst: Option<f64>,
}

impl Tally {
    /// Takes in the length of another path, in cells.
    pub fn add(&mut self, length: f64) {
        self.arrived += 1;
        self.sum += length;
        self.best = Some(self.best.map_or(length, |best| best.min(length)));
        self.worst = Some(self.worst.map_or(length, |worst| worst.max(length)));
    }

    /// The record of iteration `iteration` (from 1), whose best path so far is `best`. The mean adds in the order of [`Tally::add`].
    pub fn record(&self, iteration: u32, best: Option<&Solution>) -> Record {
        Record {
            iteration,
            best_so_far: best.map(|b| b.length),
            iteration_best: self.best,
            iteration_mean: (self.arrived > 0).then(|| self.sum / f64::from(self.arrived)),
            iteration_worst: self.worst,
            arrived: self.arrived,
        }
    }
}

impl FromIterator<f64> for Tally {
    fn from_iter<I: IntoIterator<Item = f64>>(lengths: I) -> Self {
        let mut tally = Self::default();
        lengths.into_iter().for_each(|length| tally.add(length));
        tally
    }
}

/// The best path so far.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Cells from start to goal, as the planner found them; a polyline where [`Planner::objective`] says so; by slices its places.
    pub path: Path,
    /// Its length in cells; by slices its cost by the scenario's measure.
    pub length: f64,
    /// The iteration (from 1) that found it; 0 where none was needed, because the start is the goal.
    pub iteration: u32,
    /// The same path after line-of-sight refinement, where that is part of the planner.
    pub refined: Option<Refined>,
}

/// What line-of-sight refinement makes of a path of steps.
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    /// A polyline from start to goal.
    pub path: Path,
    /// Its length in cells.
    pub length: f64,
}

impl Solution {
    /// The planner's result: the refined path where there is one. Cells, kind and length in cells.
    pub fn result(&self) -> (&Path, f64) {
        self.refined.as_ref().map_or((&self.path, self.length), |r| (&r.path, r.length))
    }
}

/// In which order several goals are visited, and what each leg costs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Tour {
    /// The goals' indices in the scenario, in visiting order.
    pub order: Vec<u32>,
    /// Length of each leg in cells, by which the order was chosen.
    pub planned: Vec<f64>,
    /// Length of each leg in cells as walked on the best path; empty while there is none.
    pub walked: Vec<f64>,
    /// Σ of the planned lengths.
    pub planned_length: f64,
    /// Σ R of the planned lengths.
    pub planned_weight: f64,
    /// Σ R of the walked lengths; none while there is no path.
    pub walked_weight: Option<f64>,
}

/// Where a planner stands; every planner keeps one.
#[derive(Debug, Clone)]
pub struct Progress {
    /// Whether and how it has ended.
    pub status: Status,
    /// The best path of the finished iterations.
    pub best: Option<Solution>,
    /// What has been spent.
    pub effort: Effort,
    /// The order of the goals, of planners that choose one.
    pub tour: Option<Tour>,
    pub(super) history: Vec<Record>,
    /// The iteration after which the map has changed last; 0 = never.
    changed: u32,
    /// Over the history and the changes of the map, kept up to date so that a long one is not hashed again for every question.
    digest: Digest,
}

impl Default for Progress {
    fn default() -> Self {
        let (effort, history, digest) = (Effort::default(), Vec::new(), Digest::default());
        Self { status: Status::Running, best: None, effort, tour: None, history, changed: 0, digest }
    }
}

impl Progress {
    /// Answers what needs no search for a path to one goal: a start that is the goal, and a goal that nobody can reach.
    pub fn settle(&mut self, scenario: &Scenario) {
        let (start, goal) = scenario.by_slices().map_or((scenario.start, scenario.goal), |s| (s.start(), s.goal()));
        if start == goal {
            self.best = Some(Solution { path: vec![start], length: 0.0, iteration: 0, refined: None });
            self.status = Status::Optimal;
        } else if !scenario.connected() {
            self.status = Status::NoPath;
        }
    }

    /// Whether a planner with a budget of iterations goes on after one of them; `stagnation` iterations without improvement on the same map
    /// end it, 0 = never.
    pub fn after_iteration(&self, budget: u32, stagnation: u32) -> Status {
        let done = self.effort.iterations;
        match &self.best {
            Some(best) if stagnation > 0 && done - best.iteration.max(self.changed) >= stagnation => Status::Stagnated,
            _ if done >= budget => Status::BudgetSpent,
            _ => Status::Running,
        }
    }

    /// Goes on from a map that has changed, for a planner with a budget of iterations: there may be a way where there was none, or none where
    /// there was one, and who had waited long enough waits again.
    #[cfg(feature = "whole")]
    pub(crate) fn go_on(&mut self, change: &Change, scenario: &Scenario, budget: u32) {
        self.note(change);
        self.status = match self.status {
            Status::Optimal => Status::Optimal,
            _ if !scenario.connected() => Status::NoPath,
            _ if self.effort.iterations >= budget => Status::BudgetSpent,
            _ => Status::Running,
        };
    }

    /// Searches on, on a map that has changed: effort and history stay, and what the search knows besides.
    #[cfg(feature = "whole")]
    pub(crate) fn search_on(&mut self, change: &Change) {
        self.note(change);
        (self.status, self.best) = (Status::Running, None);
    }

    /// Begins anew on a map that has changed: effort and history stay.
    #[cfg(feature = "whole")]
    pub(super) fn begin_anew(&mut self, change: &Change) {
        // A move of a search may have closed contours behind the change.
        self.effort.iterations = self.history.last().map_or(0, |last| last.iteration).min(self.effort.iterations);
        self.note(change);
        (self.status, self.best, self.tour) = (Status::Running, None, None);
    }

    /// Takes a change of the map into the digest, whatever order its cells are listed in.
    #[cfg(feature = "whole")]
    fn note(&mut self, change: &Change) {
        self.changed = self.effort.iterations;
        self.digest.u32(self.changed);
        for cells in [&change.blocked, &change.freed] {
            let mut places: Vec<[u32; 2]> = cells.iter().map(|p| [p.y, p.x]).collect();
            places.sort_unstable();
            self.digest.u32(places.len() as u32);
            places.as_flattened().iter().for_each(|&v| self.digest.u32(v));
        }
    }

    /// With those of the records that are of this iteration or one before.
    #[cfg(feature = "whole")]
    pub(super) fn up_to(iteration: u32, records: &[Record], effort: Effort) -> Self {
        let mut progress = Self { effort, ..Self::default() };
        records.iter().filter(|r| r.iteration <= iteration).for_each(|&record| progress.record(record));
        progress
    }

    /// What it holds in bytes, its own size not counted.
    pub(crate) fn bytes(&self) -> usize {
        let best = self.best.as_ref().map_or(0, |b| held(&b.path) + b.refined.as_ref().map_or(0, |r| held(&r.path)));
        let tour = self.tour.as_ref().map_or(0, |t| held(&t.order) + held(&t.planned) + held(&t.walked));
        held(&self.history) + best + tour
    }

    /// Adds a finished iteration to the history.
    pub fn record(&mut self, r: Record) {
        self.digest.u32(r.iteration);
        for v in [r.best_so_far, r.iteration_best, r.iteration_mean, r.iteration_worst] {
            self.digest.f64(v.unwrap_or(f64::NAN));
        }
        self.digest.u32(r.arrived);
        self.history.push(r);
    }

    /// Digest over the history with the changes of the map, the best path and its length, the refined path and its length, and the order of the goals.
    pub(super) fn digest(&self) -> Digest {
        let mut digest = self.digest;
        let paths = self
            .best
            .iter()
            .flat_map(|b| std::iter::once((&b.path, b.length)).chain(b.refined.as_ref().map(|r| (&r.path, r.length))));
        for (path, length) in paths {
            digest.u32(path.len() as u32);
            path.iter().for_each(|&c| digest.u32(c));
            digest.f64(length);
        }
        self.tour.iter().flat_map(|t| &t.order).for_each(|&goal| digest.u32(goal));
        digest
    }
}

/// A planner that works in iterations, each of many moves: what [`advance`] needs of it.
pub(crate) trait Iterations {
    /// Where it stands, and on what.
    fn parts(&mut self) -> (&mut Progress, &Scenario);
    /// Whether its tables stand.
    fn is_prepared(&self) -> bool;
    /// Makes its tables; there is something to search for.
    fn prepare(&mut self);
    /// Begins an iteration, unless one is at work.
    fn begin_iteration(&mut self) {}
    /// One move; true when the iteration is complete.
    fn move_all(&mut self) -> bool;
    /// All moves that are left of the iteration.
    fn move_to_the_end(&mut self) {
        while !self.move_all() {}
    }
    /// Takes in the complete iteration.
    fn end_iteration(&mut self);
}

/// Gets ready to move: with its tables made, and an iteration begun.
#[inline(always)]
pub(crate) fn stand_ready<P: Iterations>(planner: &mut P) -> Status {
    let is_prepared = planner.is_prepared();
    let (progress, scenario) = planner.parts();
    if !is_prepared && !progress.status.is_finished() {
        progress.settle(scenario);
    }
    if progress.status.is_finished() {
        return progress.status;
    }
    if !is_prepared {
        planner.prepare();
    }
    planner.begin_iteration();
    Status::Running
}

/// One step further, for every planner that works in iterations: tables are made at the first one, so that a planner that is only shown
/// costs nothing, and not at all where no search is needed.
#[inline(always)]
pub(crate) fn advance<P: Iterations>(planner: &mut P, by: Granularity) -> Status {
    if stand_ready(planner).is_finished() {
        return planner.parts().0.status;
    }
    let done = match by {
        Granularity::Move => planner.move_all(),
        Granularity::Iteration => {
            planner.move_to_the_end();
            true
        }
    };
    if done {
        planner.end_iteration();
    }
    planner.parts().0.status
}
