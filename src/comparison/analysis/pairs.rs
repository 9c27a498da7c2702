//! Every two entries on a map.

use serde::Serialize;

use crate::comparison::inference::{Test, holm, mann_whitney, wilcoxon};
use crate::comparison::samples::{Samples, paired, without_seeds};
use crate::comparison::statistics::a12;

/// Two entries on one map, compared by the map's measure; runs without a path rank last.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Pair {
    /// The first entry, as its place in the question.
    pub first: usize,
    /// The second one.
    pub second: usize,
    /// A of Vargha and Delaney: how likely a run of the first is the better (smaller) one, ties half.
    pub a12: f64,
    /// Whether they have seeds in common; only these runs are paired.
    pub paired: bool,
    /// Of the pairs of equal seed; null where there are too few.
    pub wilcoxon: Option<Test>,
    /// Its p, adjusted by Holm over all pairs of the map.
    pub wilcoxon_holm: Option<f64>,
    /// U of the first, without regard to seeds; null where there are too few runs.
    pub mann_whitney: Option<Test>,
    /// Its p, adjusted by Holm over all pairs of the map.
    pub mann_whitney_holm: Option<f64>,
}

/// Each two indices below `n`.
pub(super) fn indices(n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).flat_map(move |a| (a + 1..n).map(move |b| (a, b)))
}

/// Every two entries that have runs on a map, of which none is impossible.
pub(super) fn all(samples: &Samples, map: usize) -> Vec<Pair> {
    let comparison = samples.comparison();
    let measure = comparison.maps[map].measure();
    let possible = |entry| if samples.impossible(map, entry) == 0 { samples.values(map, entry, measure) } else { Vec::new() };
    let values: Vec<_> = (0..comparison.question.entries.len()).map(possible).collect();
    let sample = |of: usize, pair: [usize; 2]| -> Vec<(u32, f64)> {
        values[of].iter().map(|&(seed, value)| (seed, comparison.in_common_digits(&pair, measure, value))).collect()
    };
    let both = |(a, b)| pair(a, b, [sample(a, [a, b]), sample(b, [a, b])]);
    let mut pairs: Vec<Pair> = indices(values.len()).filter_map(both).collect();
    let signed = adjusted(pairs.iter().map(|p| p.wilcoxon));
    let ranked = adjusted(pairs.iter().map(|p| p.mann_whitney));
    for ((pair, signed), ranked) in pairs.iter_mut().zip(signed).zip(ranked) {
        (pair.wilcoxon_holm, pair.mann_whitney_holm) = (signed, ranked);
    }
    pairs
}

fn pair(first: usize, second: usize, values: [Vec<(u32, f64)>; 2]) -> Option<Pair> {
    let [a, b] = values.each_ref().map(|sample| without_seeds(sample));
    let pairs = paired(&values[0], &values[1]);
    Some(Pair {
        first,
        second,
        a12: a12(&b, &a)?,
        paired: !pairs.is_empty(),
        wilcoxon: wilcoxon(&pairs),
        wilcoxon_holm: None,
        mann_whitney: mann_whitney(&a, &b),
        mann_whitney_holm: None,
    })
}

/// By Holm, over those that are there.
fn adjusted(tests: impl Iterator<Item = Option<Test>>) -> Vec<Option<f64>> {
    let tests: Vec<Option<Test>> = tests.collect();
    let mut adjusted = holm(&tests.iter().flatten().map(|t| t.p).collect::<Vec<_>>()).into_iter();
    tests.iter().map(|test| test.and_then(|_| adjusted.next())).collect()
}
