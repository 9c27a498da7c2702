//! Whether two planners, or several, differ: rank tests, and what many of them at once ask for.
//!
//! Rank tests need no distribution of the values, and a run without a path (an infinite value) keeps its place in them. All are two-sided,
//! by the normal or χ² approximation with the usual corrections for ties, as SciPy computes them; below [`MIN_RUNS`] runs the approximation
//! is too coarse, and there is no answer. Of pairs only those that differ count in a test: where they are fewer, its p is exact. Friedman's
//! test counts maps, of which there are few. Only `libm`, so that a p-value has the same bits everywhere.

use serde::Serialize;

use super::statistics::{minus, rounded, sorted};

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
    let ascending = sorted(values.clone());
    let below = |v: f64| ascending.partition_point(|a| a.total_cmp(&v).is_lt());
    let upto = |v: f64| ascending.partition_point(|a| a.total_cmp(&v).is_le());
    let rank = |&v: &f64| (below(v) + upto(v) + 1) as f64 / 2.0;
    let mut ties = 0.0;
    let mut at = 0;
    while at < ascending.len() {
        let next = upto(ascending[at]);
        let t = (next - at) as f64;
        ties += t * t * t - t;
        at = next;
    }
    (values.iter().map(rank).collect(), ties)
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
mod tests {
    use super::*;

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-9 * b.abs().max(1e-30), "{a} is not {b}");
    }

    /// Two samples with many ties; the references below are SciPy 1.17's.
    fn tied(n: u32, factor: u32, modulus: u32, shift: f64) -> Vec<f64> {
        (0..n).map(|i| f64::from(i * factor % modulus) / 2.0 - shift).collect()
    }

    #[test]
    fn mann_whitney_is_scipys() {
        // SciPy's documentation of mannwhitneyu, method = "asymptotic".
        let test = mann_whitney_of_any(&[19.0, 22.0, 16.0, 29.0, 24.0], &[20.0, 11.0, 17.0, 12.0]);
        assert_eq!(test.statistic, 17.0);
        close(test.p, 0.111_346_886_533_140_41);
        let test = mann_whitney(&tied(40, 7919, 23, 0.0), &tied(35, 104_729, 29, 1.0)).unwrap();
        assert_eq!(test.statistic, 690.0);
        close(test.p, 0.919_585_051_422_806);
        assert_eq!(mann_whitney(&[1.0; 19], &[2.0; 30]), None);
        assert_eq!(mann_whitney(&[1.0; 20], &[1.0; 30]).unwrap().p, 1.0);
    }

    #[test]
    #[expect(clippy::approx_constant, reason = "3.14 is what was measured")]
    fn wilcoxon_is_scipys() {
        // Hollander and Wolfe 1973, depression scale (R's example of wilcox.test): W = 5.
        let first = [1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30];
        let second = [0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29];
        let test = wilcoxon_of_any(&first.into_iter().zip(second).collect::<Vec<_>>());
        assert!((test.statistic - 5.0).abs() < 1e-12);
        // Of 2⁹ ways to put signs to the ranks 10 give 5 or less.
        close(test.p, 2.0 * 10.0 / 512.0);
        // Darwin's maize, SciPy's documentation of wilcoxon: W = 24.
        let maize = [6.0, 8.0, 14.0, 16.0, 23.0, 24.0, 28.0, 29.0, 41.0, -48.0, 49.0, 56.0, 60.0, -67.0, 75.0];
        let test = wilcoxon_of_any(&maize.map(|d| (d, 0.0)));
        assert_eq!(test.statistic, 24.0);
        close(test.p, 0.041_259_765_625);
        let pairs: Vec<_> = tied(40, 7919, 23, 0.0).into_iter().zip(tied(40, 104_729, 29, 1.0)).collect();
        let test = wilcoxon(&pairs).unwrap();
        assert_eq!(test.statistic, 408.0);
        close(test.p, 0.978_541_745_142_374_5);
    }

    #[test]
    fn few_pairs_that_differ_are_counted_exactly() {
        let of = |differences: &[f64]| {
            let same = (0..30).map(|_| (7.0, 7.0));
            wilcoxon(&differences.iter().map(|d| (7.0 + d, 7.0)).chain(same).collect::<Vec<_>>()).unwrap()
        };
        // Five equal signs: 2 of 32, where the normal approximation says 0.0253. Six: 2 of 64.
        assert_eq!([of(&[1.0; 5]).p, of(&[1.0; 6]).p, of(&[-1.0; 6]).p], [0.0625, 0.03125, 0.03125]);
        // Ranks 2.5, 2.5, 2.5, 6, 6, 2.5, 8, 6, 9, so W⁻ = 8.5: SciPy's PermutationMethod, all of 2⁹.
        let test = of(&[1.0, 1.0, 1.0, 2.0, 2.0, -1.0, 3.0, -2.0, 4.0]);
        assert_eq!((test.statistic, test.p), (8.5, 0.121_093_75));
        assert_eq!(of(&[]).p, 1.0);
    }

    #[test]
    fn equal_differences_are_ties_whatever_their_last_bits() {
        // 30.1 − 30 = 0.10000000000000142, 0.3 − 0.2 = 0.09999999999999998, 5 − 5.1 = −0.09999999999999964; 0.1 + 0.2 is 0.3.
        let pairs = [(30.1, 30.0), (0.3, 0.2), (0.3, 0.1 + 0.2), (5.0, 5.1)];
        // Three ties of rank 2: (4 − 2) / 6.
        assert_eq!(rank_biserial(&pairs), 1.0 / 3.0);
        // The same in other tests: 0.1 + 0.2 ranks as 0.3 does.
        assert_eq!(ranks(&[0.1 + 0.2, 0.3, 0.0, -1e-12, f64::INFINITY]), (vec![3.5, 3.5, 1.5, 1.5, 5.0], 12.0));
    }

    #[test]
    fn runs_without_a_path_are_ranked_last() {
        let inf = f64::INFINITY;
        // Every finite value is beaten by none of the failures; two failures do not differ.
        let test = wilcoxon(&[[(1.0, inf); 15], [(inf, inf); 15]].concat()).unwrap();
        assert!(test.statistic == 0.0 && test.p < 0.001);
        assert_eq!(wilcoxon(&[(inf, inf); 30]).unwrap().p, 1.0);
        let test = mann_whitney(&[1.0; 20], &[inf; 20]).unwrap();
        assert!(test.statistic == 0.0 && test.p < 1e-8);
    }

    #[test]
    fn friedman_is_hollander_and_wolfes() {
        // Rounding first base (R's example of friedman.test): χ² = 11.1429, p = 0.003805.
        let times = [
            [5.40, 5.50, 5.55],
            [5.85, 5.70, 5.75],
            [5.20, 5.60, 5.50],
            [5.55, 5.50, 5.40],
            [5.90, 5.85, 5.70],
            [5.45, 5.55, 5.60],
            [5.40, 5.40, 5.35],
            [5.45, 5.50, 5.35],
            [5.25, 5.15, 5.00],
            [5.85, 5.80, 5.70],
            [5.25, 5.20, 5.10],
            [5.65, 5.55, 5.45],
            [5.60, 5.35, 5.45],
            [5.05, 5.00, 4.95],
            [5.50, 5.50, 5.40],
            [5.45, 5.55, 5.50],
            [5.55, 5.55, 5.35],
            [5.45, 5.50, 5.55],
            [5.50, 5.45, 5.25],
            [5.65, 5.60, 5.40],
            [5.70, 5.65, 5.55],
            [6.30, 6.30, 6.25],
        ];
        let result = friedman(&times.map(Vec::from)).unwrap();
        assert!((result.test.statistic - 11.142_857_142_857_132).abs() < 1e-12);
        close(result.test.p, 0.003_805_040_775_511_383);
        let expected = [53.0, 47.0, 32.0].map(|sum| sum / 22.0);
        assert_eq!(result.mean_ranks, expected);
        // z = (53 − 32)/22 / √(3·4/(6·22)) = 3.1659…
        close(result.between(0, 2).unwrap(), libm::erfc(21.0 / 22.0 / libm::sqrt(2.0 * 12.0 / 132.0)));
        assert_eq!(friedman(&[vec![1.0, 2.0]]), None);
        assert_eq!(friedman(&[vec![1.0, 1.0], vec![2.0, 2.0]]), None);
    }

    #[test]
    fn the_leaning_of_pairs_by_hand() {
        // Differences 1, −2, 3, 0: ranks 1, 2, 3, so (4 − 2) / 6. Two runs without a path do not differ; one is the largest difference.
        let inf = f64::INFINITY;
        assert_eq!(rank_biserial(&[(2.0, 1.0), (1.0, 3.0), (4.0, 1.0), (5.0, 5.0)]), 1.0 / 3.0);
        assert_eq!(rank_biserial(&[(inf, inf), (inf, 7.0), (6.0, 7.0), (6.0, 8.0)]), 0.0);
        assert_eq!((rank_biserial(&[(1.0, 2.0)]), rank_biserial(&[(2.0, 2.0)]), rank_biserial(&[])), (-1.0, 0.0, 0.0));
    }

    #[test]
    fn holm_by_hand() {
        // Sorted 0.01, 0.02, 0.03, 0.04 times 4, 3, 2, 1: 0.04, 0.06, 0.06, 0.06.
        assert_eq!(holm(&[0.04, 0.01, 0.03, 0.02]), [0.06, 0.04, 0.06, 0.06]);
        assert_eq!(holm(&[0.9, 0.8]), [1.0, 1.0]);
        assert_eq!(holm(&[]), Vec::<f64>::new());
    }

    #[test]
    fn the_tail_of_chi_squared_is_scipys() {
        for (x, degrees, p) in [
            (0.5, 1, 0.479_500_122_186_953_37),
            (30.0, 5, 1.474_858_103_844_307_3e-5),
            (3.3, 7, 0.855_933_047_251_493_2),
            (200.0, 4, 3.757_276_735_781_06e-42),
        ] {
            close(chi_squared_beyond(x, degrees), p);
        }
        assert_eq!(chi_squared_beyond(0.0, 3), 1.0);
    }
}
