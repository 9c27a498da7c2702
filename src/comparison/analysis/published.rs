//! What is published of an entry, beside our runs.

use serde::Serialize;

use crate::comparison::gap::is_below;
use crate::comparison::maps::Map;
use crate::comparison::printed_digits::half_unit;
use crate::comparison::question::Published;
use crate::exact::Reference;

/// Published numbers, and where they lie among our runs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct PublishedAnalysis {
    /// By the map's measure.
    pub value: Option<f64>,
    /// Turns.
    pub turns: Option<f64>,
    /// Iterations until the final best was found.
    pub iterations: Option<f64>,
    /// The proven optimum that the value is compared with; null where none is known.
    pub optimum: Option<f64>,
    /// Whether the value is below that optimum by more than its rounding: no path on this map, under its rule, has it.
    pub impossible: bool,
    /// Whether it is below every run by more than its rounding; false without runs.
    pub below_all: bool,
    /// Share of the runs that, rounded like it, are as good or better; null without runs.
    pub share_at_or_below: Option<f64>,
}

/// Of `values`, one for each run; none without a path.
pub(super) fn analyse(map: &Map, entry: usize, row: &Published, values: &[Option<f64>]) -> PublishedAnalysis {
    let value = map.measure().published(row);
    let most = value.map(|v| v + half_unit(std::iter::once(v)));
    let optimum = optimum(map, entry);
    let at_or_below = values.iter().flatten().filter(|v| most.is_some_and(|most| **v <= most)).count();
    let found = values.iter().flatten().count();
    PublishedAnalysis {
        value,
        turns: row.turns,
        iterations: row.iterations,
        optimum,
        impossible: most.zip(optimum).is_some_and(|(most, optimum)| is_below(most, optimum)),
        below_all: value.is_some() && found > 0 && at_or_below == 0,
        share_at_or_below: value.filter(|_| !values.is_empty()).map(|_| at_or_below as f64 / values.len() as f64),
    }
}

/// The best that an entry's paths could have by the map's measure: the reference of its objective; where that is about something else, or
/// nothing can be run, the best of any kind of path that an entry of the question has. Only what is proven.
fn optimum(map: &Map, entry: usize) -> Option<f64> {
    let proven = |reference| match reference {
        Reference::Proven { value } => Some(value),
        _ => None,
    };
    if map.objective(entry).is_some_and(|o| map.measure_of(o) == map.measure()) {
        return proven(map.reference(entry));
    }
    let of_measure = map.yardsticks().iter().filter(|y| y.measure == map.measure());
    let all: Option<Vec<f64>> = of_measure.map(|y| proven(y.reference)).collect();
    all?.into_iter().reduce(f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn below_by_more_than_its_rounding() {
        // √2 · 20 = 28.2842712…: printed as 28.284 it is possible, as 28.283 it is not.
        let optimum = 20.0 * std::f64::consts::SQRT_2;
        let impossible = |v: f64| is_below(v + half_unit(std::iter::once(v)), optimum);
        assert_eq!([28.284, 28.28, 28.283, 28.0, 27.0].map(impossible), [false, false, true, false, true]);
    }
}
