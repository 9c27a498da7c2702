//! Whether two planners, or several, differ: rank tests, and what many of them at once ask for.
//!
//! Rank tests need no distribution of the values, and a run without a path (an infinite value) keeps its place in them. All are two-sided,
//! by the normal or χ² approximation with the usual corrections for ties, as SciPy computes them; below [`MIN_RUNS`] runs the approximation
//! is too coarse, and there is no answer. Of pairs only those that differ count in a test: where they are fewer, its p is exact. Friedman's
//! test counts maps, of which there are few. Only `libm`, so that a p-value has the same bits everywhere.

use serde::Serialize;

use super::statistics::{minus, rounded};

/// Fewest runs of a sample.
pub const MIN_RUNS: usize = 20;

/// A test statistic and how likely one as extreme is where nothing differs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Test {
    /// U, W or χ².
    pub statistic: f64,
    /// Between 0 and 1.
    pub p: f64,
}

/// Mid-ranks of a sample, in its order, from 1; and Σ (t³ − t) over its ties.
fn ranks(values: &[f64]) -> (Vec<f64>, f64) {
    let values: Vec<f64> = values.iter().copied().map(rounded).collect();
    let mut ascending: Vec<usize> = (0..values.len()).collect();
    ascending.sort_unstable_by(|&a, &b| values[a].total_cmp(&values[b]));
    let (mut ranks, mut ties, mut at) = (vec![0.0; values.len()], 0.0, 0);
    for equal in ascending.chunk_by(|&a, &b| values[a].total_cmp(&values[b]).is_eq()) {
        let next = at + equal.len();
        equal.iter().for_each(|&index| ranks[index] = (at + next + 1) as f64 / 2.0);
        let t = equal.len() as f64;
        ties += t * t * t - t;
        at = next;
    }
    (ranks, ties)
}

/// Mid-ranks of a sample, in its order, from 1 for the smallest; ties share theirs.
pub fn mid_ranks(values: &[f64]) -> Vec<f64> {
    ranks(values).0
}

/// Mann and Whitney 1947: U of the first of two independent samples, with tie and continuity correction. `None` below [`MIN_RUNS`].
pub fn mann_whitney(first: &[f64], second: &[f64]) -> Option<Test> {
    let enough = first.len().min(second.len()) >= MIN_RUNS;
    enough.then(|| mann_whitney_of_any(first, second))
}

fn mann_whitney_of_any(first: &[f64], second: &[f64]) -> Test {
    let (n1, n2) = (first.len() as f64, second.len() as f64);
    let n = n1 + n2;
    let (ranks, ties) = ranks(&[first, second].concat());
    let u = ranks[..first.len()].iter().sum::<f64>() - n1 * (n1 + 1.0) / 2.0;
    let variance = n1 * n2 / 12.0 * (n + 1.0 - ties / (n * (n - 1.0)));
    let beyond = (u - n1 * n2 / 2.0).abs() - 0.5;
    Test { statistic: u, p: two_sided(beyond.max(0.0), variance) }
}

/// Wilcoxon 1945, signed ranks: W, the smaller rank sum of the differences of paired samples. Pairs without a difference are left out
/// (two runs without a path do not differ); where fewer than [`MIN_RUNS`] are left, p is exact. `None` below [`MIN_RUNS`] pairs.
pub fn wilcoxon(pairs: &[(f64, f64)]) -> Option<Test> {
    (pairs.len() >= MIN_RUNS).then(|| wilcoxon_of_any(pairs))
}

fn wilcoxon_of_any(pairs: &[(f64, f64)]) -> Test {
    let SignedRanks { above, whole, ranks, ties } = signed_ranks(pairs);
    let statistic = above.min(whole - above);
    if ranks.len() < MIN_RUNS {
        return Test { statistic, p: by_enumeration(&ranks, statistic) };
    }
    let n = ranks.len() as f64;
    let variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ties / 48.0;
    Test { statistic, p: two_sided((statistic - whole / 2.0).abs(), variance) }
}

/// Two-sided p of a rank sum where each rank is as likely on either side: all ways to divide them are counted. Twice a mid-rank is whole.
fn by_enumeration(ranks: &[f64], statistic: f64) -> f64 {
    let doubled = ranks.iter().map(|rank| (2.0 * rank) as usize);
    let whole: usize = doubled.clone().sum();
    let mut ways = vec![0.0; whole + 1];
    ways[0] = 1.0;
    for rank in doubled {
        (rank..=whole).rev().for_each(|sum| ways[sum] += ways[sum - rank]);
    }
    let beyond: f64 = ways.iter().take((2.0 * statistic) as usize + 1).sum();
    (2.0 * beyond / ways.iter().sum::<f64>()).min(1.0)
}

/// Which way paired samples differ, by the signed ranks of [`wilcoxon`]: (W⁺ − W⁻) / (W⁺ + W⁻), the matched-pairs rank-biserial correlation
/// (Kerby 2014). From −1, the first is always smaller, to 1, always larger; 0 where no pair differs.
pub fn rank_biserial(pairs: &[(f64, f64)]) -> f64 {
    let SignedRanks { above, whole, .. } = signed_ranks(pairs);
    if whole > 0.0 { (2.0 * above - whole) / whole } else { 0.0 }
}

/// The ranks of what pairs differ by.
struct SignedRanks {
    /// W⁺, the rank sum of the positive differences.
    above: f64,
    /// All ranks together.
    whole: f64,
    /// The ranks of the pairs that differ.
    ranks: Vec<f64>,
    /// Σ (t³ − t) over the ties.
    ties: f64,
}

fn signed_ranks(pairs: &[(f64, f64)]) -> SignedRanks {
    let differences: Vec<f64> = pairs.iter().map(|&(a, b)| minus(a, b)).filter(|d| *d != 0.0).collect();
    let (ranks, ties) = ranks(&differences.iter().map(|d| d.abs()).collect::<Vec<_>>());
    let n = differences.len() as f64;
    // The sum of nothing is −0.
    let above = 0.0 + differences.iter().zip(&ranks).filter(|(d, _)| **d > 0.0).map(|(_, r)| r).sum::<f64>();
    SignedRanks { above, whole: n * (n + 1.0) / 2.0, ranks, ties }
}

/// What a Friedman test says of several planners on several maps.
#[derive(Debug, Clone, PartialEq)]
pub struct Friedman {
    /// χ² and p.
    pub test: Test,
    /// Mean rank of each planner, 1 = best (smallest).
    pub mean_ranks: Vec<f64>,
    /// For each map the rank of each planner; ties share theirs.
    pub ranks: Vec<Vec<f64>>,
}

/// Friedman 1937, with tie correction: one row a map, one value a planner, smaller is better. `None` below two maps or two planners, or
/// where all rows are ties.
pub fn friedman(rows: &[Vec<f64>]) -> Option<Friedman> {
    let k = rows.first()?.len();
    if rows.len() < 2 || k < 2 || rows.iter().any(|row| row.len() != k) {
        return None;
    }
    let ranked: Vec<(Vec<f64>, f64)> = rows.iter().map(|row| ranks(row)).collect();
    let (n, kf) = (rows.len() as f64, k as f64);
    let sums: Vec<f64> = (0..k).map(|j| ranked.iter().map(|(r, _)| r[j]).sum()).collect();
    let ties: f64 = ranked.iter().map(|(_, t)| t).sum();
    let spread = 12.0 / (n * kf * (kf + 1.0)) * sums.iter().map(|s| s * s).sum::<f64>() - 3.0 * n * (kf + 1.0);
    let correction = 1.0 - ties / (n * kf * (kf * kf - 1.0));
    if correction <= 0.0 {
        return None;
    }
    let statistic = spread / correction;
    let test = Test { statistic, p: chi_squared_beyond(statistic, k as u32 - 1) };
    Some(Friedman { test, mean_ranks: sums.iter().map(|s| s / n).collect(), ranks: ranked.into_iter().map(|(r, _)| r).collect() })
}

impl Friedman {
    /// Post hoc (Demšar 2006): p of the difference of two planners' mean ranks, uncorrected.
    pub fn between(&self, first: usize, second: usize) -> Option<f64> {
        let (a, b) = (self.mean_ranks.get(first)?, self.mean_ranks.get(second)?);
        let k = self.mean_ranks.len() as f64;
        Some(two_sided((a - b).abs(), k * (k + 1.0) / (6.0 * self.ranks.len() as f64)))
    }
}

/// Holm 1979: p-values of tests made together, so adjusted that the chance of any false alarm is at most the level; in the order given.
pub fn holm(p: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..p.len()).collect();
    order.sort_by(|&a, &b| p[a].total_cmp(&p[b]).then(a.cmp(&b)));
    let mut adjusted = vec![0.0; p.len()];
    let mut largest = 0.0f64;
    for (place, &index) in order.iter().enumerate() {
        largest = largest.max(((p.len() - place) as f64 * p[index]).min(1.0));
        adjusted[index] = largest;
    }
    adjusted
}

/// Two-sided p of a deviation from 0 under a normal distribution of this variance; 1 where there is no variance.
fn two_sided(deviation: f64, variance: f64) -> f64 {
    if variance <= 0.0 { 1.0 } else { libm::erfc(deviation / libm::sqrt(2.0 * variance)).min(1.0) }
}

/// P(χ² ≥ x) with whole degrees of freedom: Q(k/2, x/2), by the recurrence from Q(1/2, y) = erfc √y or Q(1, y) = e^−y upwards.
fn chi_squared_beyond(x: f64, degrees: u32) -> f64 {
    if x <= 0.0 {
        return 1.0;
    }
    let y = x / 2.0;
    let odd = degrees % 2 == 1;
    let (mut sum, mut a) = if odd { (libm::erfc(libm::sqrt(y)), 0.5) } else { (libm::exp(-y), 1.0) };
    while a + 0.5 < f64::from(degrees) / 2.0 {
        // Q(a + 1, y) = Q(a, y) + y^a e^−y / Γ(a + 1).
        sum += libm::exp(a * libm::log(y) - y - libm::lgamma(a + 1.0));
        a += 1.0;
    }
    sum.min(1.0)
}

#[cfg(test)]
mod tests;
