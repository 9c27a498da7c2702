//! All entries over all maps.

use serde::Serialize;

use super::matrix::Ranked;
use super::pairs::indices;
use crate::comparison::inference::{Friedman, friedman, holm};

/// Friedman's test over the medians of the maps: of the entries that have runs on every map, none of them impossible.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Ranks {
    /// χ², corrected for ties.
    pub statistic: f64,
    /// Its degrees of freedom.
    pub degrees: usize,
    /// How likely one as large is where nothing differs.
    pub p: f64,
    /// Number of maps.
    pub maps: usize,
    /// The entries, as their places in the question.
    pub entries: Vec<usize>,
    /// Mean rank of each of them, 1 = best (smallest).
    pub mean_ranks: Vec<f64>,
    /// For each map the rank of each of them; ties share theirs.
    pub by_map: Vec<Vec<f64>>,
    /// Every two of them.
    pub pairs: Vec<RankPair>,
}

/// Two mean ranks, compared post hoc.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RankPair {
    /// The first entry, as its place in the question.
    pub first: usize,
    /// The second one.
    pub second: usize,
    /// How likely mean ranks as different are where nothing differs.
    pub p: f64,
    /// The same, adjusted by Holm over all pairs.
    pub holm: f64,
}

/// None where nothing can be ranked.
pub(super) fn over_maps(ranked: &Ranked) -> Option<Ranks> {
    friedman(&ranked.medians).map(|result| ranks(result, ranked.entries.clone()))
}

fn ranks(result: Friedman, entries: Vec<usize>) -> Ranks {
    let of: Vec<(usize, usize)> = indices(entries.len()).collect();
    let raw: Vec<f64> = of.iter().map(|&(a, b)| result.between(a, b).unwrap_or(1.0)).collect();
    let pair = |((&(a, b), &p), holm)| RankPair { first: entries[a], second: entries[b], p, holm };
    Ranks {
        statistic: result.test.statistic,
        degrees: entries.len() - 1,
        p: result.test.p,
        maps: result.ranks.len(),
        pairs: of.iter().zip(&raw).zip(holm(&raw)).map(pair).collect(),
        mean_ranks: result.mean_ranks,
        by_map: result.ranks,
        entries,
    }
}
