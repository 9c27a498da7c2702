//! How a run got to its best path: its improvements over the effort, and what it has spent.

use super::budget::{Axis, Budget};
use super::gap::reaches;
use super::samples::Seen;

/// The effort until a run found its best path; none without one, or where it is not told.
pub(super) fn to_best(seen: Seen, axis: Axis) -> Option<f64> {
    seen.row.found?;
    at(seen, seen.row.trace.len().checked_sub(1)?, axis)
}

/// The effort of a whole run.
pub(super) fn end(seen: Seen, axis: Axis) -> Option<f64> {
    if axis == Axis::Time { seen.seconds.last().copied() } else { seen.row.effort.on(axis) }
}

/// What a run may spend on an axis; infinite where the budget is none of it.
pub(super) fn most(budget: Option<Budget>, axis: Axis) -> f64 {
    budget.filter(|b| b.axis == axis).map_or(f64::INFINITY, |b| b.amount as f64)
}

/// The effort until an improvement.
fn at(seen: Seen, improvement: usize, axis: Axis) -> Option<f64> {
    if axis == Axis::Time {
        // The last one is the end of the run.
        return seen.seconds.get(improvement).copied().filter(|_| improvement + 1 < seen.seconds.len());
    }
    seen.row.trace.get(improvement)?.spent.on(axis)
}

/// The improvements of one run as (effort, value), and its whole effort.
pub(super) struct Course {
    pub steps: Vec<(f64, f64)>,
    pub end: Option<f64>,
}

impl Course {
    /// None where the run found a path and does not tell when, and where it spends nothing on this axis. Of an effort beyond the budget only
    /// what the budget allows counts: what the last iteration found does not, either.
    pub fn of(seen: Seen, axis: Axis, most: f64) -> Option<Self> {
        let (trace, end) = (&seen.row.trace, end(seen, axis).map(|end| end.min(most)));
        if end == Some(0.0) && axis != Axis::Time {
            return None;
        }
        if seen.row.found.is_none() {
            return Some(Self { steps: Vec::new(), end });
        }
        let steps: Option<Vec<_>> = trace.iter().enumerate().map(|(i, step)| Some((at(seen, i, axis)?, step.value))).collect();
        steps.filter(|steps| !steps.is_empty()).map(|steps| Self { steps, end })
    }

    /// The effort until a target is reached for good: a planner that chooses by length before refinement may give up a better answer.
    pub fn hit(&self, target: f64) -> Option<f64> {
        let reaching = self.steps.iter().rev().take_while(|step| reaches(step.1, target));
        reaching.last().map(|step| step.0)
    }

    /// The effort until a target is reached, or without it until the end.
    pub fn spent(&self, target: f64) -> Option<f64> {
        self.hit(target).or(self.end)
    }

    /// The effort to the end, or as much of it as is known.
    pub fn last(&self) -> Option<f64> {
        self.end.or_else(|| self.steps.last().map(|step| step.0))
    }
}
