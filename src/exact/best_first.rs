//! Best-first search over a heap, for rules that the bucket queue of `search.rs` does not fit: segments of any length, states that are
//! more than a cell.
//!
//! A state is expanded when no open one has a smaller f = g + estimate; it is opened again when a shorter way to it turns up. The search
//! ends when no open state can beat the goal's cost: exact where the rules offer every step and the estimate is a lower bound.

mod tree;

use std::sync::Arc;

pub(super) use self::tree::{Open, State, Tree};
use super::contours::{self, Contours};
use crate::map::Cell;
use crate::metrics::WeightedSum;
use crate::path::Path;
use crate::planner::{Granularity, Layer, Objective, Planner, Progress, Record, Solution, Status, Weighed};
use crate::scenario::Scenario;
#[cfg(feature = "whole")]
use crate::{
    exact::proof::{self, surely},
    metrics::{SAME_LENGTH, turn_index},
    planner::Certificate,
};

/// A way that is known before a search begins.
#[derive(Debug, Clone)]
pub(super) struct Known {
    pub(super) path: Path,
    /// In cells.
    pub(super) length: f64,
    /// Cells that were expanded to find it.
    pub(super) expansions: u64,
}

/// What a search does.
pub(super) trait Rules: Clone + Send {
    /// What the result is measured by.
    const OBJECTIVE: Objective;
    /// What a path that it has found to the end is.
    const FOUND: Status;
    /// States for each cell.
    const STATES_PER_CELL: u32 = 1;

    /// Before the first step: tables.
    fn prepare(&mut self, _scenario: &Scenario) {}
    /// The state in which the search begins.
    fn start(&self, scenario: &Scenario) -> State {
        scenario.start * Self::STATES_PER_CELL
    }
    /// A way to the goal that was found while it was prepared: no longer one is looked for.
    fn known(&self) -> Option<&Known> {
        None
    }
    /// The weights, where its objective is the weighted sum.
    fn sum(&self) -> Option<WeightedSum> {
        None
    }
    /// What its tables hold, in bytes.
    fn bytes(&self) -> usize {
        0
    }
    /// Whether it has done all the work that it may do.
    fn is_spent(&self) -> bool {
        false
    }
    /// A lower bound of the cost from a cell to the goal.
    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64;
    /// Relaxes what can follow a state.
    fn expand(&mut self, scenario: &Scenario, state: State, tree: &mut Tree);
}

/// Longer than what rounding and [`SAME_LENGTH`] make of a way's length, in cells.
const HAIR: f64 = 1e-6;

/// A search at work.
#[derive(Clone)]
pub(super) struct BestFirst<R> {
    scenario: Arc<Scenario>,
    rules: R,
    tree: Tree,
    /// f at which the contour at work ends.
    contour: f64,
    progress: Progress,
}

impl<R: Rules> BestFirst<R> {
    pub(super) fn new(scenario: Arc<Scenario>, rules: R) -> Self {
        Self { scenario, rules, tree: Tree::new(0), contour: 0.0, progress: Progress::default() }
    }

    pub(super) fn rules(&self) -> &R {
        &self.rules
    }

    fn close_contour(&mut self, least: Option<f64>) {
        self.progress.effort.iterations += 1;
        match least {
            Some(f) => self.contour = libm::floor(f) + 1.0,
            None => self.finish(Status::NoPath, R::FOUND),
        }
        self.record();
    }

    /// Ends the search where it stands: the goal may not be reached, and a better way may be open.
    fn stop(&mut self) {
        self.progress.effort.iterations += 1;
        self.finish(Status::BudgetSpent, Status::BudgetSpent);
        self.record();
    }

    fn record(&mut self) {
        let length = self.progress.best.as_ref().map(|b| b.length);
        self.progress.record(Record::of_search(self.progress.effort.iterations, length));
    }

    /// The way to the goal that the search has found, or the one that was known.
    fn best_way(&self) -> Option<Path> {
        let known = || self.rules.known().map(|known| known.path.clone());
        if self.tree.has_arrived() {
            Some(self.tree.way().iter().map(|state| state / R::STATES_PER_CELL).collect())
        } else {
            known()
        }
    }

    /// Its result's value, where that is proven.
    #[cfg(feature = "whole")]
    fn proven_value(&self) -> Option<f64> {
        let best = self.progress.best.as_ref()?;
        match R::OBJECTIVE {
            Objective::TurnIndex => Some(turn_index(&self.scenario, &best.path)),
            Objective::Weighted => self.rules.sum().map(|sum| sum.of(&self.scenario, &best.path)),
            _ => Some(best.length),
        }
    }

    /// No result has a smaller value, while it is at work or where it had to stop.
    #[cfg(feature = "whole")]
    fn bound(&self) -> f64 {
        let least = self.tree.least_open();
        if R::OBJECTIVE == Objective::Weighted {
            // Its steps may cost less than 1, so the tolerance is that of as many steps as there are states.
            return (least.min(self.tree.bound) - SAME_LENGTH * self.tree.g.len() as f64).max(0.0);
        }
        let arrived = if self.tree.has_arrived() { surely(self.tree.bound()) } else { f64::INFINITY };
        let known = self.rules.known().map_or(f64::INFINITY, |known| known.length);
        let reached = self.progress.best.as_ref().map_or(arrived.min(surely(known)), |best| best.length);
        reached.min(surely(least))
    }

    /// `lost` or `found` is what it is without a way to the goal, or with one.
    fn finish(&mut self, lost: Status, found: Status) {
        let Some(path) = self.best_way() else {
            self.progress.status = lost;
            return;
        };
        let length = self.scenario.path_length(&path);
        // Nothing is shorter than not to move at all.
        self.progress.status = if length == 0.0 { Status::Optimal } else { found };
        self.progress.effort.constructed_paths = 1;
        self.progress.best = Some(Solution { path, length, iteration: self.progress.effort.iterations, refined: None });
    }
}

impl<R: Rules> Contours for BestFirst<R> {
    fn status(&self) -> Status {
        self.progress.status
    }

    fn is_prepared(&self) -> bool {
        !self.tree.g.is_empty()
    }

    fn prepare(&mut self) {
        let scenario = &*self.scenario;
        self.rules.prepare(scenario);
        let to_goal = self.rules.to_goal(scenario, scenario.start);
        self.tree = Tree::along(scenario, scenario.grid.len() * R::STATES_PER_CELL as usize, to_goal);
        if let Some(known) = self.rules.known() {
            // A hair longer, so that the best way is found even where it is the known one.
            self.tree.bound = known.length + HAIR;
            self.progress.effort.cell_expansions += known.expansions;
        }
        self.tree.begin(self.rules.start(scenario), to_goal, scenario.start == scenario.goal);
        self.contour = libm::floor(to_goal) + 1.0;
    }

    fn advance_one(&mut self) -> bool {
        let least = self.tree.least();
        let Some((state, _)) = least.filter(|&(_, f)| f < self.contour) else {
            self.close_contour(least.map(|(_, f)| f));
            return false;
        };
        if self.rules.is_spent() {
            self.stop();
            return false;
        }
        self.tree.open.pop();
        self.tree.expanded[state as usize] = true;
        self.progress.effort.cell_expansions += 1;
        self.rules.expand(&self.scenario, state, &mut self.tree);
        true
    }
}

impl<R: Rules + 'static> Planner for BestFirst<R> {
    fn advance(&mut self, by: Granularity) -> Status {
        contours::advance(self, by)
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.progress.bytes() + self.rules.bytes() + self.tree.bytes()
    }

    fn objective(&self) -> Objective {
        R::OBJECTIVE
    }

    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        if R::FOUND != Status::Optimal || !self.is_prepared() {
            return None;
        }
        proof::certificate(&self.progress, || self.proven_value(), || Some(self.bound()))
    }

    fn weighed(&self) -> Option<Weighed> {
        let sum = self.rules.sum()?;
        Some(Weighed { sum, value: self.best().map(|best| sum.of(&self.scenario, &best.path)) })
    }

    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        let per_cell = R::STATES_PER_CELL as usize;
        out.clear();
        match kind {
            Layer::Visits => {
                out.extend(self.tree.expanded.chunks(per_cell).map(|states| f32::from(u8::from(states.contains(&true)))));
            }
            Layer::Cost => {
                out.extend(self.tree.g.chunks(per_cell).map(|g| g.iter().copied().fold(f64::INFINITY, f64::min) as f32));
            }
            _ => return false,
        }
        out.resize(self.scenario.grid.len(), contours::untouched(kind));
        true
    }
}
