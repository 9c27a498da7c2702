//! What is proven of a path by all goals.

use super::Legs;
use crate::aco::variant::Variant;
use crate::metrics::SAME_LENGTH;
use crate::planner::Tour;
#[cfg(feature = "whole")]
use crate::planner::{Certificate, Planner};

impl<V: Variant + 'static> Legs<V> {
    /// Whether nothing is better by the planner's objective: the order is proven, and each leg is as short as was planned.
    pub(super) fn is_proven(&self) -> bool {
        let is_short = |tour: &Tour| {
            tour.walked.len() == tour.planned.len()
                && tour.walked.iter().zip(&tour.planned).all(|(walked, planned)| *walked < planned + SAME_LENGTH)
        };
        self.proof.is_some_and(|proof| proof.complete) && self.progress.tour.as_ref().is_some_and(is_short)
    }

    /// The bound of all orders, which are of shortest paths; expansions are those between the goals and those of the legs.
    #[cfg(feature = "whole")]
    pub(super) fn proven(&self) -> Option<Certificate> {
        let (proof, value) = (self.proof?, self.value_of_best()?);
        let complete = self.is_proven();
        let lower_bound = if complete { value } else { proof.lower_bound.min(value) };
        Some(Certificate { lower_bound, expansions: self.effort().cell_expansions, complete })
    }

    /// What the best path comes to by the planner's objective.
    #[cfg(feature = "whole")]
    fn value_of_best(&self) -> Option<f64> {
        let tour = self.progress.tour.as_ref().filter(|_| self.level.weighted);
        tour.map_or_else(|| self.progress.best.as_ref().map(|best| best.length), |tour| tour.walked_weight)
    }
}
