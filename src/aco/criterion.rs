//! What an ant's finished path is judged by: which one is the best, and what a paper's deposit is divided by.

use crate::map::Cell;
use crate::metrics::{WeightedSum, turn_index};
use crate::param_choice;
use crate::planner::{Solution, Weighed};
use crate::scenario::Scenario;

use super::ant::Ant;

param_choice! {
    /// What makes one path better than another.
    pub enum Criterion {
        /// its length
        Length = "length",
        /// V(d, r), its length in which a turning step counts 1.2 times: equation 10 of the fire-fighting paper
        TurnIndex = "turn-index",
        /// J, the weighted sum of length, turns, closeness to obstacles and energy: our addition
        Weighted = "weighted-sum",
    }
}

param_choice! {
    /// What an ant's deposit is divided by.
    pub enum DepositBy {
        /// the criterion
        Criterion = "criterion",
        /// the length, as eq. 5 is printed
        Length = "length",
    }
}

/// A criterion at work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Judge {
    /// Length.
    Length,
    /// V(d, r).
    TurnIndex,
    /// J, by these weights.
    Weighted(WeightedSum),
}

impl Criterion {
    /// With the weights that it may need.
    pub fn by(self, sum: WeightedSum) -> Judge {
        match self {
            Self::Length => Judge::Length,
            Self::TurnIndex => Judge::TurnIndex,
            Self::Weighted => Judge::Weighted(sum),
        }
    }
}

impl Judge {
    /// Of an arrived ant, in cells; the less, the better. None of a lost one.
    #[inline]
    pub fn of_ant(self, scenario: &Scenario, ant: &Ant) -> Option<f64> {
        match self {
            Self::Length => ant.length(),
            Self::TurnIndex => ant.length().map(|_| turn_index(scenario, &way(scenario, ant))),
            Self::Weighted(sum) => ant.length().map(|_| sum.of(scenario, &way(scenario, ant))),
        }
    }

    /// Of a path that was found, in cells.
    #[inline]
    pub fn of_solution(self, scenario: &Scenario, found: &Solution) -> f64 {
        match self {
            Self::Length => found.length,
            Self::TurnIndex => turn_index(scenario, &found.path),
            Self::Weighted(sum) => sum.of(scenario, &found.path),
        }
    }

    /// What a result comes to by the weighted sum; none by another criterion.
    pub(super) fn weighed(self, scenario: &Scenario, best: Option<&Solution>) -> Option<Weighed> {
        let Self::Weighted(sum) = self else { return None };
        Some(Weighed { sum, value: best.map(|found| sum.of(scenario, &found.path)) })
    }
}

/// An ant's way as cells.
#[inline(never)]
pub(super) fn way(scenario: &Scenario, ant: &Ant) -> Vec<Cell> {
    let mut at = scenario.start;
    let rest = ant.steps().iter().map(|&d| {
        at = scenario.moves.step(at, d);
        at
    });
    std::iter::once(scenario.start).chain(rest).collect()
}
