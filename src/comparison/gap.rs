//! How far a run is from the best there is, and whether it can be where it is.

use super::{Comparison, Row, RunMeasure};
use crate::exact::Reference;

/// The part of a value by which two ways to sum up the same path may differ: a smaller difference is none.
pub const ROUNDING: f64 = 1e-9;

/// Relative distance of a value to the best one, value / best − 1; 0 within a rounding, and where the best is 0. Both in the same unit, at
/// least 0. Below 0 where the value is the better one.
pub fn relative_gap(value: f64, best: f64) -> f64 {
    let gap = if best > 0.0 { value / best - 1.0 } else { 0.0 };
    if gap.abs() < ROUNDING { 0.0 } else { gap }
}

/// Whether a value is below the least one possible, by more than a rounding.
pub fn is_below(value: f64, least: f64) -> bool {
    value < least * (1.0 - ROUNDING)
}

/// Whether a value is as small as a target, within a rounding.
pub fn reaches(value: f64, target: f64) -> bool {
    value <= target + target.abs() * ROUNDING
}

impl Comparison {
    /// Relative distance of a run's value to the reference, value / reference − 1; none without a path or a reference. Below 0 only where the
    /// reference is not proven, or the run is imported. An imported value that is the reference within the digits it was printed with has no
    /// distance.
    pub fn gap(&self, row: &Row) -> Option<f64> {
        let best = self.reference(row).value()?;
        let value = row.found?.value;
        let is_same = (value - best).abs() <= self.slack(row.task.entry, best);
        Some(if is_same { 0.0 } else { relative_gap(value, best) })
    }

    /// Whether a run claims a path that cannot be: better than the exact optimum, by more than the digits it was printed with. It was searched
    /// for under other rules (moves, corners, measure), or on another map.
    pub fn impossible(&self, row: &Row) -> bool {
        let reference = self.reference(row);
        let nowhere = reference == Reference::NoPath && row.found.is_some();
        nowhere || (reference.is_proven() && self.gap(row).is_some_and(|gap| gap < 0.0))
    }

    /// A measure of a run, as [`Row::value`] tells it, whether it found the proven optimum, or when the map's vehicle arrives. A planner
    /// without iterations has no iteration of the best; those of a first stage are not counted, and a run whose best is of that stage tells no
    /// iteration of the next.
    pub fn value(&self, row: &Row, measure: RunMeasure) -> Option<f64> {
        match measure {
            RunMeasure::Optimal => {
                let is_optimal = self.reference(row).is_proven() && self.gap(row) == Some(0.0);
                Some(f64::from(u8::from(is_optimal)))
            }
            RunMeasure::ArrivalTime => self.arrival_time(row),
            RunMeasure::IterationOfBest if self.needs_no_seed(row.task.entry) => None,
            RunMeasure::IterationOfBest => {
                let before = self.question.entries.get(row.task.entry).and_then(|entry| entry.first_stage).unwrap_or(0);
                row.value(measure)
                    .map(|iteration| iteration - f64::from(before))
                    .filter(|iteration| before == 0 || (*iteration > 0.0 && iteration.is_finite()))
            }
            other => row.value(other),
        }
    }

    /// Seconds that the map's vehicle takes, infinite without a path. None where turns are not told, and by slices, where the levels' metres
    /// are not part of a row.
    fn arrival_time(&self, row: &Row) -> Option<f64> {
        let scenario = &self.maps.get(row.task.instance)?.scenario;
        let Some(found) = &row.found else { return Some(f64::INFINITY) };
        let metres = found.length * scenario.spec.resolution;
        scenario.by_slices().is_none().then_some(scenario.spec.vehicle.travel_time(metres, found.turns?))
    }

    /// As [`crate::comparison::Entry::needs_no_seed`]; false of an entry that there is not.
    pub fn needs_no_seed(&self, entry: usize) -> bool {
        self.question.entries.get(entry).is_some_and(|asked| asked.needs_no_seed())
    }

    /// What a run is compared with; unknown for a run on no map.
    fn reference(&self, row: &Row) -> Reference {
        self.maps.get(row.task.instance).map_or(Reference::Unknown, |map| map.reference(row.task.entry))
    }
}

#[cfg(test)]
mod tests;
