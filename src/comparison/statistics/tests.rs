//! Against values by hand, by enumeration, and SciPy's.

use super::*;

/// Student 1908, hours of sleep won by two drugs (R's data set `sleep`): the classic paired sample.
const SLEEP: [(f64, f64); 10] =
    [(1.9, 0.7), (0.8, -1.6), (1.1, -0.2), (0.1, -1.2), (-0.1, -0.1), (4.4, 3.4), (5.5, 3.7), (1.6, 0.8), (4.6, 0.0), (3.4, 2.0)];

fn close(a: f64, b: f64, within: f64) {
    assert!((a - b).abs() <= within, "{a} is not {b}");
}

#[test]
fn quantiles_are_of_type_7() {
    // NumPy's documentation of percentile: [[10, 7, 4], [3, 2, 1]], 50 % → 3.5; R: quantile(1:10) → 1, 3.25, 5.5, 7.75, 10.
    assert_eq!(quantile(&sorted(vec![10.0, 7.0, 4.0, 3.0, 2.0, 1.0]), 0.5), Some(3.5));
    let ten: Vec<f64> = (1..=10).map(f64::from).collect();
    let at = [0.0, 0.25, 0.5, 0.75, 1.0].map(|p| quantile(&ten, p).unwrap());
    assert_eq!(at, [1.0, 3.25, 5.5, 7.75, 10.0]);
    // 1 + 9·0.9 = 9.1.
    close(quantile(&ten, 0.9).unwrap(), 9.1, 1e-12);
    assert_eq!((quantile(&[], 0.5), quantile(&[7.0], 0.3)), (None, Some(7.0)));
}

#[test]
fn runs_without_a_path_keep_their_place() {
    let inf = f64::INFINITY;
    assert_eq!(quantile(&[1.0, 2.0, inf, inf], 0.25), Some(1.75));
    assert_eq!(quantile(&[1.0, 2.0, inf, inf], 0.5), Some(inf));
    assert_eq!(quantile(&[1.0, inf, inf], 0.5), Some(inf));
    // Where more is better, a run without a path counts as −∞: half of them are enough, as above.
    assert_eq!(quantile(&[-inf, -inf, 1.0, 2.0], 0.5), Some(-inf));
    assert_eq!((quantile(&[-inf, inf], 0.3), median_of(&mut [2.0, -inf, 1.0, -inf])), (Some(-inf), Some(-inf)));
    let pairs = [(1.0, inf), (2.0, inf), (3.0, inf)];
    let d = median_difference(&pairs, "t").unwrap();
    assert_eq!((d.value, d.low, d.high), (-inf, -inf, -inf));
    let none = median_difference(&[(inf, inf); 4], "t").unwrap();
    assert_eq!((none.value, none.low, none.high), (0.0, 0.0, 0.0));
}

#[test]
fn the_quick_median_is_the_quantile() {
    for n in 1..40u32 {
        let values: Vec<f64> = (0..n).map(|i| f64::from(i.wrapping_mul(2_654_435_761) >> 27)).collect();
        let slow = quantile(&sorted(values.clone()), 0.5);
        assert_eq!(median_of(&mut values.clone()), slow, "{values:?}");
    }
}

#[test]
fn mean_and_deviation_by_hand() {
    // Mean 40/8 = 5, squares 9+1+1+1+0+0+4+16 = 32, √(32/7).
    let s = Summary::of(&[2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0]).unwrap();
    assert_eq!((s.count, s.least, s.lower, s.median, s.upper, s.greatest, s.mean), (8, 2.0, 4.0, 4.5, 5.5, 9.0, 5.0));
    close(s.deviation.unwrap(), 2.138_089_935_299_395, 1e-15);
    assert_eq!(Summary::of(&[3.0]).unwrap().deviation, None);
    assert_eq!(Summary::of(&[]), None);
    // R: mean(sleep) = 2.33 and 0.75, sd = 2.002249 and 1.789010.
    let (first, second): (Vec<f64>, Vec<f64>) = SLEEP.iter().copied().unzip();
    close(mean(&first).unwrap(), 2.33, 1e-12);
    close(deviation(&first).unwrap(), 2.002_249, 5e-7);
    close(deviation(&second).unwrap(), 1.789_010, 5e-7);
}

#[test]
fn the_interval_of_a_mean_is_that_of_the_exact_bootstrap() {
    // The ten differences sum to 15.8. Convolved ten times (10¹⁰ resamples), their mean has the 2.5 % and 97.5 % quantiles 0.95 and 2.38.
    let d = mean_difference(&SLEEP, "sleep").unwrap();
    close(d.value, 1.58, 1e-12);
    close(d.low, 0.95, 0.03);
    close(d.high, 2.38, 0.05);
}

#[test]
fn the_interval_of_a_median_by_enumeration() {
    // Three pairs (k, 0): of 27 resamples the median is 1 in 7, 2 in 13, 3 in 7, so both tails beyond 2.5 % lie at 1 and 3.
    let pairs = [(1.0, 0.0), (2.0, 0.0), (3.0, 0.0)];
    let d = median_difference(&pairs, "t").unwrap();
    assert_eq!((d.value, d.low, d.high), (2.0, 1.0, 3.0));
    assert_eq!(median_difference(&[], "t"), None);
}

#[test]
fn what_differs_in_the_last_bits_does_not_differ() {
    let pairs = [(0.1 + 0.2, 0.3); 30];
    for d in [median_difference(&pairs, "t").unwrap(), mean_difference(&pairs, "t").unwrap()] {
        assert_eq!((d.value, d.low, d.high), (0.0, 0.0, 0.0));
    }
    assert_eq!([rounded(-1e-12).to_bits(), rounded(f64::INFINITY).to_bits()], [0, f64::INFINITY.to_bits()]);
    assert_eq!((rounded(1e300), rounded(33.899_494_936_611_67)), (1e300, 33.899_494_937));
}

#[test]
fn intervals_repeat_and_depend_on_their_name_alone() {
    let again = mean_difference(&SLEEP, "sleep");
    assert_eq!(mean_difference(&SLEEP, "sleep"), again);
    assert_ne!(mean_difference(&SLEEP, "awake"), again);
}

#[test]
fn the_interval_of_one_sample_is_that_of_the_exact_bootstrap() {
    // The first column, convolved ten times (10¹⁰ resamples): its mean has the 2.5 % and 97.5 % quantiles 1.19 and 3.53. SciPy 1.17's
    // bootstrap(…, method = "percentile") with 200,000 resamples gives these, and 0.6 to 4.4 for the median.
    let first: Vec<f64> = SLEEP.iter().map(|p| p.0).collect();
    let [low, high] = mean_interval(&first, "sleep").unwrap();
    close(low, 1.19, 0.03);
    close(high, 3.53, 0.05);
    let [low, high] = median_interval(&first, "sleep").unwrap();
    close(low, 0.6, 1e-12);
    close(high, 4.4, 1e-12);
    assert_eq!((median_interval(&[], "t"), mean_interval(&[], "t")), (None, None));
    assert_eq!(mean_interval(&[7.0], "t"), Some([7.0, 7.0]));
}

#[test]
fn intervals_of_shares_are_scipys() {
    // binomtest(k, n).proportion_ci(method = "wilson").
    for (hits, of, low, high) in [
        (0, 20, 0.0, 0.161_125_158_052_819_35),
        (20, 20, 0.838_874_841_947_180_8, 1.0),
        (7, 20, 0.181_191_824_101_082_1, 0.567_145_723_314_763_7),
        (97, 100, 0.915_480_635_709_472_4, 0.989_745_475_975_947_1),
        (1, 30, 0.005_908_590_381_612_441, 0.166_703_909_914_091_73),
    ] {
        let interval = wilson(hits, of);
        close(interval[0], low, 1e-12);
        close(interval[1], high, 1e-12);
    }
    assert_eq!((wilson(0, 0), wilson(0, 5)[0], wilson(5, 5)[1]), ([0.0, 1.0], 0.0, 1.0));
}

#[test]
fn a12_counts_pairs() {
    // (2 > 1), (2 = 2), (3 > 1), (3 > 2): 3.5 of 4.
    assert_eq!(a12(&[2.0, 3.0], &[1.0, 2.0]), Some(0.875));
    assert_eq!(a12(&[1.0, 2.0], &[2.0, 3.0]), Some(0.125));
    assert_eq!(a12(&[5.0, f64::INFINITY], &[f64::INFINITY, 5.0]), Some(0.5));
    assert_eq!(a12(&[], &[1.0]), None);
    assert_eq!(a12(&[0.1 + 0.2], &[0.3]), Some(0.5));
    // sleep: of 100 pairs 73 are larger and 3 equal.
    let (first, second): (Vec<f64>, Vec<f64>) = SLEEP.iter().copied().unzip();
    assert_eq!(a12(&first, &second), Some(0.745));
}

#[test]
fn a12_is_what_all_pairs_say() {
    let sample = |n: u64, seed: u64| -> Vec<f64> {
        let value = |i: u64| if (i * seed).is_multiple_of(13) { f64::INFINITY } else { ((i * seed * 7) % 31) as f64 / 3.0 - 2.0 };
        (0..n).map(value).collect()
    };
    for (n, m) in [(1, 1), (1, 40), (37, 41), (200, 3)] {
        let (first, second) = (sample(n, 5), sample(m, 11));
        let points = |a: &f64, b: &f64| if rounded(*a) > rounded(*b) { 2 } else { u64::from(rounded(*a) == rounded(*b)) };
        let sum: u64 = first.iter().map(|a| second.iter().map(|b| points(a, b)).sum::<u64>()).sum();
        assert_eq!(a12(&first, &second), Some(sum as f64 / (2 * n * m) as f64));
    }
}

#[test]
fn a_bootstrap_is_bounded_and_the_same_for_every_sample_that_can_be_run_in_time() {
    assert_eq!([0, 1, 100, 10_000].map(resamples), [RESAMPLES; 4]);
    assert_eq!([20_000, 100_000, 999_000, 2_000_000].map(resamples), [5000, 1000, FEWEST_RESAMPLES, FEWEST_RESAMPLES]);
    let many: Vec<f64> = (0..200_000u32).map(|i| f64::from(i % 1000)).collect();
    let [low, high] = mean_interval(&many, "many").unwrap();
    assert!(low < 499.5 && high > 499.5 && high - low < 4.0, "{low} to {high}");
}

#[test]
fn counted_medians_are_those_of_the_sorted_draws() {
    let sorted_draws = |values: &[f64], name: &str| {
        let median = |drawn: &[f64]| median_of(&mut drawn.to_vec());
        bootstrap(values, name, median).map(|d| [d.low, d.high])
    };
    let spread = |n: u32, distinct: u32| (0..n).map(|i| f64::from(i * 7919 % distinct) * 0.37 + 1.1).collect::<Vec<f64>>();
    let mut without_path = spread(40, 11);
    without_path.extend([f64::INFINITY; 15]);
    let odd = [f64::NEG_INFINITY, 0.0, -0.0, 3.5, f64::INFINITY];
    for values in
        [vec![], vec![2.0], vec![1.0, 2.0], spread(31, 1000), spread(100, 6), spread(301, 17), without_path, odd.to_vec()]
    {
        let bits = |range: Option<[f64; 2]>| range.map(|ends| ends.map(f64::to_bits));
        assert_eq!(bits(median_interval(&values, "a")), bits(sorted_draws(&values, "a")), "{values:?}");
    }
}
