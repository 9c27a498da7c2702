//! What the colony has learnt of one scenario, from iteration to iteration.

use std::sync::Arc;

use crate::aco::criterion::Judge;
use crate::aco::variant::Iteration;
use crate::exact::Distance;
use crate::metrics::SAME_LENGTH;
use crate::path::Path;
use crate::scenario::Scenario;

use super::merge::{Corridor, Merge};
use super::params::FormicaParams;
use super::scent::Scent;

/// What is known once the map was looked at.
#[derive(Clone)]
pub(super) struct Learnt {
    pub(super) scent: Scent,
    /// To the goal in a straight line of steps, for who smells nothing.
    pub(super) open_map: Distance,
    pub(super) merge: Merge,
    /// The path that takes the deposit; empty while there is none.
    pub(super) path: Path,
    pub(super) criterion: Judge,
    /// Value of the best path by the criterion, in cells, and the iteration that found it.
    pub(super) best: f64,
    pub(super) since: u32,
    /// Parts that were expanded for the scent and not told yet.
    pub(super) smelt: u64,
}

impl Learnt {
    pub(super) fn new(params: &FormicaParams, walked_on: &Scenario, scenario: &Arc<Scenario>) -> Self {
        let narrow = params.corridor as u8;
        let wide = if params.adaptive_corridor { params.corridor_most as u8 } else { narrow };
        let corridor = Corridor { narrow, wide: wide.max(narrow), radius: narrow };
        let scent = Scent::new(walked_on);
        let criterion = params.judge();
        Self {
            smelt: if params.scent { scent.expanded() } else { 0 },
            scent,
            open_map: Distance::of(walked_on),
            merge: Merge::by(criterion, scenario, corridor),
            path: Path::new(),
            criterion,
            best: f64::INFINITY,
            since: 0,
        }
    }

    /// Merges the ways of an iteration's ants and takes in what the search finds; the path with its value, if it is better than
    /// all before.
    pub(super) fn merge(&mut self, iteration: &Iteration, widening: u8) -> Option<(Path, f64)> {
        let known = self.value(iteration).unwrap_or(f64::INFINITY);
        iteration.ants.iter().for_each(|ant| self.merge.gather(iteration.scenario, ant, widening));
        if let Some(best) = iteration.best_so_far {
            self.merge.follow(&best.path);
        }
        let found = self.merge.solve().filter(|(_, value)| *value < known - SAME_LENGTH);
        let path = found.as_ref().map(|(path, _)| path).or(iteration.best_so_far.map(|best| &best.path));
        self.path = path.cloned().unwrap_or_default();
        found
    }

    /// Value of the best path of ants and searches so far, in cells.
    pub(super) fn value(&self, iteration: &Iteration) -> Option<f64> {
        iteration.best_so_far.map(|best| self.criterion.of_solution(iteration.scenario, best))
    }

    /// What was expanded since this was asked last.
    pub(super) fn take_expansions(&mut self) -> u64 {
        self.merge.take_expansions() + std::mem::take(&mut self.smelt)
    }

    /// Takes note of the best value after an iteration.
    pub(super) fn note(&mut self, value: f64, number: u32) {
        let is_better = value < self.best - SAME_LENGTH;
        if is_better {
            (self.best, self.since) = (value, number);
        }
        self.merge.learn(is_better);
    }
}
