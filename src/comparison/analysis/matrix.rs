//! All maps × all entries in one table: what came out of each, and how the entries rank.
//!
//! There is one ranking: that of Friedman's test. It is among the entries that have runs on every map, of which none is impossible, so that
//! mean ranks are over the same rivals on each map.

use serde::Serialize;

use super::MapAnalysis;
use super::entry::EntryAnalysis;
use crate::comparison::inference::mid_ranks;
use crate::comparison::measure::RunMeasure;
use crate::comparison::samples::{Samples, without_seeds};
use crate::comparison::statistics::{mean, quantile, sorted};

/// Maps × entries.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Matrix {
    /// A row a map, in the order of the question.
    pub rows: Vec<MatrixRow>,
    /// All maps together: one for each entry.
    pub overall: Vec<Overall>,
}

/// One map.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatrixRow {
    /// Id of the instance.
    pub id: String,
    /// The map's name, or the id.
    pub name: String,
    /// What medians are of.
    pub measure: RunMeasure,
    /// One for each entry of the question.
    pub cells: Vec<MatrixCell>,
}

/// One entry on one map. Median and gap are over the runs that found a path; the rank is by the median of all runs, of which those without a
/// path are the longest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct MatrixCell {
    /// Runs that are done.
    pub runs: usize,
    /// Share of them that found a path; null without runs.
    pub success: Option<f64>,
    /// Median of the map's measure.
    pub median: Option<f64>,
    /// Gap of the median, by the entry's own objective.
    pub gap: Option<f64>,
    /// Place among the ranked entries, 1 = smallest; ties share theirs.
    pub rank: Option<f64>,
    /// Runs that no path on this map can have.
    pub impossible: usize,
}

/// One entry over all maps.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Overall {
    /// Mean of its ranks; null where it has none.
    pub mean_rank: Option<f64>,
    /// Why it has none; null where it has one.
    pub unranked: Option<Unranked>,
    /// Mean of the gaps of its medians; null where one map has none, and where runs are impossible.
    pub mean_gap: Option<f64>,
    /// Share of all its runs that found a path; null without runs.
    pub success: Option<f64>,
}

/// Why an entry is not ranked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Unranked {
    /// It has no runs on one of the maps.
    NotOnEveryMap,
    /// Some of its runs are better than the proven optimum.
    Impossible,
}

/// What ranks are made from.
pub(super) struct Ranked {
    /// The entries that are ranked, as places in the question.
    pub entries: Vec<usize>,
    /// For each map the median of each of them over all runs, infinite where half of them found no path.
    pub medians: Vec<Vec<f64>>,
}

impl Ranked {
    /// The entries that have runs on every map, none of them impossible.
    pub fn of(samples: &Samples) -> Self {
        let comparison = samples.comparison();
        let maps = comparison.maps.len();
        let fits = |&entry: &usize| (0..maps).all(|map| why_not(samples, map, entry).is_none());
        let entries: Vec<usize> = (0..comparison.question.entries.len()).filter(fits).collect();
        let median = |map: usize, entry| {
            let measure = comparison.maps[map].measure();
            let values = without_seeds(&samples.values(map, entry, measure));
            comparison.in_common_digits(&entries, measure, quantile(&sorted(values), 0.5).unwrap_or(f64::INFINITY))
        };
        let medians = (0..maps).map(|map| entries.iter().map(|&entry| median(map, entry)).collect()).collect();
        Self { entries, medians }
    }
}

/// Why an entry cannot be ranked on a map.
fn why_not(samples: &Samples, map: usize, entry: usize) -> Option<Unranked> {
    if samples.of(map, entry).is_empty() {
        return Some(Unranked::NotOnEveryMap);
    }
    (samples.impossible(map, entry) > 0).then_some(Unranked::Impossible)
}

/// The matrix of what is analysed.
pub(super) fn matrix(samples: &Samples, maps: &[MapAnalysis], ranked: &Ranked) -> Matrix {
    let ranks: Vec<Vec<f64>> = ranked.medians.iter().map(|medians| mid_ranks(medians)).collect();
    let rank = |map: usize, entry| {
        let place = ranked.entries.iter().position(|&e| e == entry)?;
        ranks[map].get(place).copied()
    };
    let row = |(index, map): (usize, &MapAnalysis)| MatrixRow {
        id: map.id.clone(),
        name: map.name.clone(),
        measure: map.measure,
        cells: map.entries.iter().enumerate().map(|(e, entry)| cell(entry, rank(index, e))).collect(),
    };
    let rows: Vec<MatrixRow> = maps.iter().enumerate().map(row).collect();
    let entries = 0..samples.comparison().question.entries.len();
    let overall = entries.map(|entry| overall(samples, maps, &rows, entry)).collect();
    Matrix { rows, overall }
}

fn cell(entry: &EntryAnalysis, rank: Option<f64>) -> MatrixCell {
    MatrixCell {
        runs: entry.runs,
        success: share(entry.with_path, entry.runs),
        median: entry.summary.map(|s| s.median),
        gap: entry.gap.map(|gap| gap.median),
        rank,
        impossible: entry.impossible,
    }
}

fn overall(samples: &Samples, maps: &[MapAnalysis], rows: &[MatrixRow], entry: usize) -> Overall {
    let reasons = (0..maps.len()).filter_map(|map| why_not(samples, map, entry));
    // What is impossible says more than what is missing.
    let unranked = reasons.reduce(|one, other| if other == Unranked::Impossible { other } else { one });
    let all = |number: fn(&MatrixCell) -> Option<f64>| -> Option<f64> {
        mean(&rows.iter().map(|row| number(&row.cells[entry])).collect::<Option<Vec<_>>>()?)
    };
    let count = |of: fn(&EntryAnalysis) -> usize| maps.iter().map(|map| of(&map.entries[entry])).sum();
    Overall {
        mean_rank: all(|cell| cell.rank),
        unranked,
        mean_gap: all(|cell| cell.gap).filter(|_| unranked != Some(Unranked::Impossible)),
        success: share(count(|e| e.with_path), count(|e| e.runs)),
    }
}

fn share(part: usize, whole: usize) -> Option<f64> {
    (whole > 0).then(|| part as f64 / whole as f64)
}
