//! What describes a sample of runs and the difference of two: quantiles, mean, deviation, paired bootstrap, Vargha and Delaney's A.
//!
//! Values may be infinite: a run that found no path has an infinite length. They order like any others, so that medians, quartiles and A
//! keep their meaning; NaN must not come in. Only arithmetic with one result everywhere, and one order of every sum.

use rand::Rng;
use serde::Serialize;

use crate::rng::{Stream, Streams};

/// Resamples of a bootstrap.
pub const RESAMPLES: u32 = 10_000;

/// The confidence of an interval.
pub const CONFIDENCE: f64 = 0.95;

/// A sample in ascending order.
pub fn sorted(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_unstable_by(f64::total_cmp);
    values
}

/// Quantile `p` (0 to 1) of an ascending sample, type 7 of Hyndman and Fan 1996 (the default of R and NumPy): linear between the two
/// order statistics around 1 + (n − 1)·p. `None` of an empty sample.
pub fn quantile(ascending: &[f64], p: f64) -> Option<f64> {
    let last = ascending.len().checked_sub(1)?;
    let place = p.clamp(0.0, 1.0) * last as f64;
    let below = place as usize;
    let (low, high) = (*ascending.get(below)?, *ascending.get((below + 1).min(last))?);
    let share = place - below as f64;
    // Between equal infinities, and from −∞ on, a difference would be no number.
    Some(if low == high || share == 0.0 || low == f64::NEG_INFINITY { low } else { low + share * (high - low) })
}

/// The median; reorders the sample. `None` of an empty one.
fn median_of(values: &mut [f64]) -> Option<f64> {
    let half = values.len().checked_sub(1)? / 2;
    let even = values.len().is_multiple_of(2);
    let (_, &mut low, above) = values.select_nth_unstable_by(half, f64::total_cmp);
    let next = above.iter().copied().fold(f64::INFINITY, f64::min);
    Some(if even && low != next && low != f64::NEG_INFINITY { low + 0.5 * (next - low) } else { low })
}

/// Arithmetic mean; `None` of an empty sample.
pub fn mean(values: &[f64]) -> Option<f64> {
    mean_of(values.iter().copied())
}

fn mean_of(values: impl ExactSizeIterator<Item = f64>) -> Option<f64> {
    let count = values.len();
    (count > 0).then(|| values.sum::<f64>() / count as f64)
}

/// Standard deviation with n − 1; `None` below two values.
pub fn deviation(values: &[f64]) -> Option<f64> {
    let mean = mean(values).filter(|_| values.len() > 1)?;
    let squares: f64 = values.iter().map(|v| (v - mean) * (v - mean)).sum();
    Some(libm::sqrt(squares / (values.len() - 1) as f64))
}

/// A sample in five numbers and two.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Summary {
    /// Number of values.
    pub count: usize,
    /// The smallest.
    pub least: f64,
    /// First quartile.
    pub lower: f64,
    /// The middle.
    pub median: f64,
    /// Third quartile.
    pub upper: f64,
    /// The largest.
    pub greatest: f64,
    /// Arithmetic mean.
    pub mean: f64,
    /// Standard deviation with n − 1; of a single value none.
    pub deviation: Option<f64>,
}

impl Summary {
    /// Of a sample; `None` of an empty one.
    pub fn of(values: &[f64]) -> Option<Self> {
        let ascending = sorted(values.to_vec());
        let at = |p| quantile(&ascending, p);
        Some(Self {
            count: values.len(),
            least: at(0.0)?,
            lower: at(0.25)?,
            median: at(0.5)?,
            upper: at(0.75)?,
            greatest: at(1.0)?,
            mean: mean(values)?,
            deviation: deviation(values),
        })
    }
}

/// A difference and what it could as well have been.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Difference {
    /// Of the two samples.
    pub value: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

/// A value without the last bits of its sum, which depend on the sum's order: paths of the same steps are equally long. Below 10⁻⁹ cells
/// nothing differs, and nothing is ranked.
pub fn rounded(value: f64) -> f64 {
    const SCALE: f64 = 1e9;
    let scaled = libm::round(value * SCALE);
    // Plus 0: without −0, which orders before it.
    if scaled.is_finite() { scaled / SCALE + 0.0 } else { value }
}

/// First value minus the second one, [`rounded`]. Two infinite ones do not differ.
pub fn minus(first: f64, second: f64) -> f64 {
    if first == second { 0.0 } else { rounded(first - second) }
}

/// Difference of the medians of paired samples (first − second) with its bootstrap interval. `None` without pairs.
pub fn median_difference(pairs: &[(f64, f64)], name: &str) -> Option<Difference> {
    let (mut first, mut second): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
    let difference = |drawn: &[(f64, f64)]| {
        for (at, pair) in drawn.iter().enumerate() {
            (first[at], second[at]) = *pair;
        }
        Some(minus(median_of(&mut first)?, median_of(&mut second)?))
    };
    bootstrap(pairs, name, difference)
}

/// Difference of the means of paired samples (first − second) with its bootstrap interval. Only finite values. `None` without pairs.
pub fn mean_difference(pairs: &[(f64, f64)], name: &str) -> Option<Difference> {
    bootstrap(pairs, name, |drawn| Some(minus(mean_of(drawn.iter().map(|p| p.0))?, mean_of(drawn.iter().map(|p| p.1))?)))
}

/// The bootstrap interval of a sample's median. `None` of an empty one.
pub fn median_interval(values: &[f64], name: &str) -> Option<[f64; 2]> {
    let mut copy = values.to_vec();
    let median = |drawn: &[f64]| {
        copy.copy_from_slice(drawn);
        median_of(&mut copy)
    };
    bootstrap(values, name, median).map(|d| [d.low, d.high])
}

/// The bootstrap interval of a sample's mean. Only finite values. `None` of an empty one.
pub fn mean_interval(values: &[f64], name: &str) -> Option<[f64; 2]> {
    bootstrap(values, name, mean).map(|d| [d.low, d.high])
}

/// Percentile bootstrap (Efron and Tibshirani 1993, ch. 13): items (values, or pairs of them) are drawn with replacement [`RESAMPLES`] times;
/// the interval lies between the quantiles of the statistic. The stream follows from the name, so that no comparison changes another's
/// interval.
fn bootstrap<T: Copy>(items: &[T], name: &str, mut statistic: impl FnMut(&[T]) -> Option<f64>) -> Option<Difference> {
    let value = statistic(items)?;
    let mut dice = Streams::new(0, name, 0).ant(0, 0);
    let mut sample = items.to_vec();
    let mut drawn = Vec::with_capacity(RESAMPLES as usize);
    for _ in 0..RESAMPLES {
        for item in &mut sample {
            *item = items[draw(&mut dice, items.len())];
        }
        drawn.push(statistic(&sample)?);
    }
    let ascending = sorted(drawn);
    let tail = 0.5 * (1.0 - CONFIDENCE);
    Some(Difference { value, low: quantile(&ascending, tail)?, high: quantile(&ascending, 1.0 - tail)? })
}

/// One of `n` places; as good as uniform for n far below 2³².
fn draw(dice: &mut Stream, n: usize) -> usize {
    ((u64::from(dice.next_u32()) * n as u64) >> 32) as usize
}

/// The normal distribution's quantile at 97.5 %: the half width of a [`CONFIDENCE`] interval in standard deviations.
const Z: f64 = 1.959_963_984_540_054;

/// What the true share may be where `hits` of `of` were counted: Wilson's score interval at [`CONFIDENCE`] (Wilson 1927), which keeps its
/// meaning near 0 and 1. From 0 to 1 where nothing was counted.
pub fn wilson(hits: usize, of: usize) -> [f64; 2] {
    if of == 0 {
        return [0.0, 1.0];
    }
    let (n, p) = (of as f64, hits as f64 / of as f64);
    let squared = Z * Z / n;
    let middle = p + squared / 2.0;
    let half = Z * libm::sqrt(p * (1.0 - p) / n + squared / (4.0 * n));
    // At the ends the formula gives 0 and 1, but for a rounding.
    let low = if hits == 0 { 0.0 } else { (middle - half) / (1.0 + squared) };
    [low, if hits == of { 1.0 } else { (middle + half) / (1.0 + squared) }]
}

/// A of Vargha and Delaney 2000: how likely a value of the first sample is larger than one of the second, ties counted half. ½ means no
/// difference. `None` of an empty sample.
pub fn a12(first: &[f64], second: &[f64]) -> Option<f64> {
    let half_points = |a: &f64, b: &f64| match a.total_cmp(b) {
        std::cmp::Ordering::Less => 0u64,
        std::cmp::Ordering::Equal => 1,
        std::cmp::Ordering::Greater => 2,
    };
    let [first, second] = [first, second].map(|values| values.iter().copied().map(rounded).collect::<Vec<f64>>());
    let sum: u64 = first.iter().map(|a| second.iter().map(|b| half_points(a, b)).sum::<u64>()).sum();
    let most = 2 * first.len() as u64 * second.len() as u64;
    (most > 0).then(|| sum as f64 / most as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Student 1908, hours of sleep won by two drugs (R's data set `sleep`): the classic paired sample.
    const SLEEP: [(f64, f64); 10] = [
        (1.9, 0.7),
        (0.8, -1.6),
        (1.1, -0.2),
        (0.1, -1.2),
        (-0.1, -0.1),
        (4.4, 3.4),
        (5.5, 3.7),
        (1.6, 0.8),
        (4.6, 0.0),
        (3.4, 2.0),
    ];

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
}
