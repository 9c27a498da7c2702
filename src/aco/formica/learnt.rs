//! What the colony has learnt of one scenario, from iteration to iteration.

use std::borrow::Cow;
use std::sync::Arc;

use crate::aco::criterion::Judge;
use crate::aco::variant::Iteration;
use crate::exact::Distance;
use crate::metrics::SAME_LENGTH;
use crate::path::Path;
use crate::scenario::Scenario;

use super::merge::{Corridor, Merge};
use super::params::{FormicaParams, Paths};
use super::scent::Scent;
use super::straight::{by_steps, straightened};

/// What is known once the map was looked at.
#[derive(Clone)]
pub(super) struct Learnt {
    pub(super) scent: Scent,
    /// To the goal in a straight line of steps, for who smells nothing.
    pub(super) open_map: Distance,
    paths: Paths,
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
            paths: params.paths,
            merge: Merge::of(params.paths, criterion, scenario, corridor),
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
            self.merge.follow(&self.on_cells(iteration.scenario, &best.path));
        }
        let straight = self.straighten(iteration);
        let solved = self.merge.solve().filter(|(_, length)| *length < known - SAME_LENGTH);
        let found = straight.into_iter().chain(solved).reduce(|a, b| if b.1 < a.1 { b } else { a });
        let path = found.as_ref().map(|(path, _)| path).or(iteration.best_so_far.map(|best| &best.path));
        self.path = path.map(|path| self.on_cells(iteration.scenario, path).into_owned()).unwrap_or_default();
        found
    }

    /// Where paths are polylines, the way of the iteration's best ant as one, if it is shorter than what is known; the search need not find
    /// longer ones.
    pub(super) fn straighten(&mut self, iteration: &Iteration) -> Option<(Path, f64)> {
        if self.paths == Paths::Steps {
            return None;
        }
        let known = self.value(iteration).unwrap_or(f64::INFINITY);
        let straight = straightened(iteration).filter(|(_, length)| *length < known - SAME_LENGTH);
        self.merge.bound_by(straight.as_ref().map_or(known, |(_, length)| *length));
        straight
    }

    /// A path by its steps.
    fn on_cells<'a>(&self, scenario: &Scenario, path: &'a Path) -> Cow<'a, Path> {
        match self.paths {
            Paths::Steps => Cow::Borrowed(path),
            Paths::Polylines => Cow::Owned(by_steps(scenario, path)),
        }
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
