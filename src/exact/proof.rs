//! What an exact search has proven: all of it at its end, before that what the open states leave possible.
//!
//! Some state on a best way is open, reached at its true cost, until the best way is found (Hart, Nilsson, Raphael 1968, lemma 1). So nothing is
//! better than the least f of what is open, whatever the order of expansions. States that are left out because another one of their cell is
//! never worse do not matter: of that other one the same way on is as good.

use crate::metrics::SAME_LENGTH;
use crate::planner::{Certificate, Progress, Status};

/// What a search has proven, given what its result comes to and a bound of what it may still come to, each asked only where it is told.
/// None where there is no path, and while nothing bounds it.
pub(super) fn certificate(
    progress: &Progress,
    value: impl FnOnce() -> Option<f64>,
    bound: impl FnOnce() -> Option<f64>,
) -> Option<Certificate> {
    let (complete, lower_bound) = match progress.status {
        Status::Optimal => (true, value()?),
        Status::Running | Status::BudgetSpent => (false, bound().filter(|bound| bound.is_finite())?),
        Status::Complete | Status::Stagnated | Status::NoPath => return None,
    };
    Some(Certificate { lower_bound, expansions: progress.effort.cell_expansions, complete })
}

/// A sum of steps that cost 1 at least, each of which may be counted too dear by the tolerance, as a bound.
pub(super) fn surely(least: f64) -> f64 {
    least * (1.0 - SAME_LENGTH)
}
