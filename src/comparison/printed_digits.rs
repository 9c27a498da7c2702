//! Imported values are known with the digits that somebody has printed, and no more.

use super::{Comparison, Row, RunMeasure};
use crate::map::Moves;

/// Half a unit of the last decimal that any of the values has, because those of one of them may end in zeros; 0 where there is no value.
pub(super) fn half_unit(values: impl Iterator<Item = f64>) -> f64 {
    values.map(decimals).max().map_or(0.0, half_of)
}

fn decimals(value: f64) -> usize {
    value.to_string().split_once('.').map_or(0, |(_, decimals)| decimals.len())
}

fn half_of(decimals: usize) -> f64 {
    (0..decimals).fold(0.5, |unit, _| unit / 10.0)
}

/// The same for each of `entries` entries, over its imported runs.
pub(super) fn half_units(entries: usize, imported: &[Row]) -> Vec<f64> {
    let mut most: Vec<Option<usize>> = vec![None; entries];
    for row in imported {
        if let (Some(most), Some(found)) = (most.get_mut(row.task.entry), row.found) {
            *most = (*most).max(Some(decimals(found.value)));
        }
    }
    most.into_iter().map(|most| most.map_or(0.0, half_of)).collect()
}

impl Comparison {
    /// How far a value of an entry may lie from another one, in cells, and still be the same: half a unit of the last digit that the entry's
    /// runs are printed with, and what a rounded √2 makes, as in a MovingAI `.scen`. 0 for what is run here.
    pub fn slack(&self, entry: usize, value: f64) -> f64 {
        const ROUNDED_ROOT: f64 = 1e-6;
        match self.half_units.get(entry) {
            // Whole numbers are all of a length by straight steps.
            Some(&unit) if unit == 0.5 && self.maps.iter().all(|m| m.scenario.spec.movement.moves == Moves::Four) => 0.0,
            Some(&unit) if unit > 0.0 => unit + ROUNDED_ROOT * value.abs(),
            _ => 0.0,
        }
    }

    /// A length or cost in the digits that all of these entries are known with, before they are ranked: digits that nobody has printed would
    /// break ties. As it is where all of them are run here, and by any other measure.
    pub fn in_common_digits(&self, entries: &[usize], measure: RunMeasure, value: f64) -> f64 {
        const MOST: f64 = 1e9;
        let coarsest = entries.iter().filter_map(|&entry| self.half_units.get(entry)).copied().fold(0.0, f64::max);
        if coarsest == 0.0 || !matches!(measure, RunMeasure::Length | RunMeasure::Cost) {
            return value;
        }
        let scale = libm::round(0.5 / coarsest).min(MOST);
        libm::round(value * scale) / scale
    }
}
