//! Dynamic programming over slices: Bellman, "Dynamic Programming", Princeton University Press 1957.
//!
//! Every path by slices takes one step for each column, so the cheapest way to each place of a column follows from the column before. The
//! result is exact for either measure of the scenario; ties fall to the first step in the order of [`Slices::offset`].

mod within;

use std::sync::Arc;

use super::SEARCH;
use crate::error::ParamError;
use crate::map::{Cell, Slices, Way};
use crate::params::{Values, check_keys};
use crate::planner::{Granularity, Ground, Layer, Objective, Planner, PlannerEntry, Progress, Record, Solution, Status, held};
use crate::scenario::Scenario;
#[cfg(feature = "whole")]
use crate::{
    exact::proof::{self, surely},
    planner::Certificate,
};

pub use within::{SliceEstimate, SlicesWithin};

/// Predecessor of a place that nothing leads to.
const NONE: Cell = Cell::MAX;

/// The search at work: one column an iteration.
#[derive(Clone)]
struct SliceSearch {
    slices: Arc<Slices>,
    /// Cost of the cheapest way to each place; empty until the first step.
    cost: Vec<f64>,
    parent: Vec<Cell>,
    /// The places of the column reached, in ascending order.
    front: Vec<Cell>,
    progress: Progress,
}

impl SliceSearch {
    fn new(slices: Arc<Slices>) -> Self {
        let front = vec![slices.start()];
        Self { slices, cost: Vec::new(), parent: Vec::new(), front, progress: Progress::default() }
    }

    /// Allocates at the first step, so that a planner that is only shown costs nothing.
    fn prepare(&mut self) {
        self.cost = vec![f64::INFINITY; self.slices.places()];
        self.parent = vec![NONE; self.slices.places()];
        self.cost[self.slices.start() as usize] = 0.0;
    }

    /// Relaxes all steps into the next column.
    fn next_column(&mut self) {
        let mut next = Vec::new();
        for &from in &self.front {
            self.progress.effort.cell_expansions += 1;
            let so_far = self.cost[from as usize];
            for to in (0..self.slices.directions()).filter_map(|k| self.slices.step(from, k, Way::Forward)) {
                let cost = so_far + self.slices.cost(from, to);
                if self.parent[to as usize] == NONE {
                    next.push(to);
                }
                if cost < self.cost[to as usize] {
                    self.cost[to as usize] = cost;
                    self.parent[to as usize] = from;
                }
            }
        }
        next.sort_unstable();
        self.front = next;
    }

    /// No path is cheaper: each goes by a place of the column reached, and every step costs 1 at least. None before the first step.
    #[cfg(feature = "whole")]
    fn bound(&self) -> Option<f64> {
        let so_far = |&place: &Cell| self.cost.get(place as usize).copied();
        let least = self.front.iter().filter_map(so_far).min_by(f64::total_cmp)?;
        let left = self.slices.slices() - self.progress.effort.iterations;
        Some(surely(least + f64::from(left)))
    }

    /// The answer, once the goal's column is reached or nothing leads on.
    fn finish(&mut self) {
        let goal = self.slices.goal();
        if !self.front.contains(&goal) {
            self.progress.status = Status::NoPath;
            return;
        }
        let parents = std::iter::successors(Some(goal), |&at| Some(self.parent[at as usize]).filter(|&p| p != NONE));
        let mut path: Vec<Cell> = parents.collect();
        path.reverse();
        let (length, iteration) = (self.slices.value(&path), self.progress.effort.iterations);
        self.progress.effort.constructed_paths = 1;
        self.progress.best = Some(Solution { path, length, iteration, refined: None });
        self.progress.status = Status::Optimal;
    }
}

impl Planner for SliceSearch {
    /// A move is an iteration: one column.
    fn advance(&mut self, _by: Granularity) -> Status {
        if self.progress.status.is_finished() {
            return self.progress.status;
        }
        if self.cost.is_empty() {
            self.prepare();
        }
        if self.slices.slices() > 0 {
            self.next_column();
        }
        self.progress.effort.iterations += 1;
        if self.front.is_empty() || self.progress.effort.iterations >= self.slices.slices() {
            self.finish();
        }
        let length = self.progress.best.as_ref().map(|b| b.length);
        self.progress.record(Record::of_search(self.progress.effort.iterations, length));
        self.progress.status
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.progress.bytes() + held(&self.cost) + held(&self.parent) + held(&self.front)
    }

    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        proof::certificate(&self.progress, || self.best().map(|best| best.length), || self.bound())
    }

    fn objective(&self) -> Objective {
        Objective::SliceCost
    }

    /// Of each cell the cheapest of its places.
    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        if !matches!(kind, Layer::Cost | Layer::Visits) {
            return false;
        }
        out.clear();
        out.resize(self.slices.area() as usize, f32::INFINITY);
        for (place, &cost) in self.cost.iter().enumerate() {
            let least = &mut out[self.slices.cell(place as Cell) as usize];
            *least = least.min(cost as f32);
        }
        if kind == Layer::Visits {
            out.iter_mut().for_each(|v| *v = f32::from(u8::from(v.is_finite())));
        }
        true
    }
}

/// The cheapest path's cost by the scenario's measure; `None` when there is no path, or where one does not move by slices.
pub fn optimum(scenario: &Scenario) -> Option<f64> {
    let mut search = SliceSearch::new(Arc::clone(scenario.slices.as_ref()?));
    search.run();
    search.best().map(|best| best.length)
}

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    check_keys(ENTRY.id, &[], values)?;
    // The catalog lets nothing else through.
    let slices = scenario.slices.as_ref().expect("a scenario by slices");
    Ok(Box::new(SliceSearch::new(Arc::clone(slices))))
}

/// Dynamic programming over slices in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "slices-exact",
    name: "Slices, exact",
    summary: "Dynamic programming from column to column; always the cheapest path by slices over a terrain.",
    source: "Bellman 1957, Dynamic Programming, Princeton University Press",
    grounds: &[Ground::Slices],
    build,
    ..SEARCH
};
