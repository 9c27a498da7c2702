//! Against values by hand and SciPy's.

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
