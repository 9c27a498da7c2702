//! What describes a sample of runs and the difference of two: quantiles, mean, deviation, paired bootstrap, Vargha and Delaney's A.
//!
//! Values may be infinite: a run that found no path has an infinite length. They order like any others, so that medians, quartiles and A
//! keep their meaning; NaN must not come in. Only arithmetic with one result everywhere, and one order of every sum.

use rand::Rng;

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
    // Between equal infinities a difference would be no number.
    Some(if low == high || share == 0.0 { low } else { low + share * (high - low) })
}

/// The median; reorders the sample. `None` of an empty one.
fn median_of(values: &mut [f64]) -> Option<f64> {
    let half = values.len().checked_sub(1)? / 2;
    let even = values.len().is_multiple_of(2);
    let (_, &mut low, above) = values.select_nth_unstable_by(half, f64::total_cmp);
    let next = above.iter().copied().fold(f64::INFINITY, f64::min);
    Some(if even && low != next { low + 0.5 * (next - low) } else { low })
}

/// Arithmetic mean; `None` of an empty sample.
pub fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// Standard deviation with n − 1; `None` below two values.
pub fn deviation(values: &[f64]) -> Option<f64> {
    let mean = mean(values).filter(|_| values.len() > 1)?;
    let squares: f64 = values.iter().map(|v| (v - mean) * (v - mean)).sum();
    Some(libm::sqrt(squares / (values.len() - 1) as f64))
}

/// A sample in five numbers and two.
#[derive(Debug, Clone, Copy, PartialEq)]
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Difference {
    /// Of the two samples.
    pub value: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

/// First sample's statistic minus the second's. Two infinite medians do not differ.
fn minus(first: f64, second: f64) -> f64 {
    if first == second { 0.0 } else { first - second }
}

/// Difference of the medians of paired samples (first − second) with its bootstrap interval. `None` without pairs.
pub fn median_difference(pairs: &[(f64, f64)], name: &str) -> Option<Difference> {
    let difference = |first: &mut [f64], second: &mut [f64]| Some(minus(median_of(first)?, median_of(second)?));
    bootstrap(pairs, name, difference)
}

/// Difference of the means of paired samples (first − second) with its bootstrap interval. Only finite values. `None` without pairs.
pub fn mean_difference(pairs: &[(f64, f64)], name: &str) -> Option<Difference> {
    bootstrap(pairs, name, |first, second| Some(mean(first)? - mean(second)?))
}

/// Percentile bootstrap (Efron and Tibshirani 1993, ch. 13): pairs are drawn with replacement [`RESAMPLES`] times; the interval lies
/// between the quantiles of the differences. The stream follows from the name, so that no comparison changes another's interval.
fn bootstrap(pairs: &[(f64, f64)], name: &str, difference: impl Fn(&mut [f64], &mut [f64]) -> Option<f64>) -> Option<Difference> {
    let (mut first, mut second): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
    let value = difference(&mut first, &mut second)?;
    let mut dice = Streams::new(0, name, 0).ant(0, 0);
    let mut drawn = Vec::with_capacity(RESAMPLES as usize);
    for _ in 0..RESAMPLES {
        for (a, b) in first.iter_mut().zip(&mut second) {
            (*a, *b) = pairs[draw(&mut dice, pairs.len())];
        }
        drawn.push(difference(&mut first, &mut second)?);
    }
    let ascending = sorted(drawn);
    let tail = 0.5 * (1.0 - CONFIDENCE);
    Some(Difference { value, low: quantile(&ascending, tail)?, high: quantile(&ascending, 1.0 - tail)? })
}

/// One of `n` places; as good as uniform for n far below 2³².
fn draw(dice: &mut Stream, n: usize) -> usize {
    ((u64::from(dice.next_u32()) * n as u64) >> 32) as usize
}

/// A of Vargha and Delaney 2000: how likely a value of the first sample is larger than one of the second, ties counted half. ½ means no
/// difference. `None` of an empty sample.
pub fn a12(first: &[f64], second: &[f64]) -> Option<f64> {
    let half_points = |a: &f64, b: &f64| match a.total_cmp(b) {
        std::cmp::Ordering::Less => 0u64,
        std::cmp::Ordering::Equal => 1,
        std::cmp::Ordering::Greater => 2,
    };
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
    fn intervals_repeat_and_depend_on_their_name_alone() {
        let again = mean_difference(&SLEEP, "sleep");
        assert_eq!(mean_difference(&SLEEP, "sleep"), again);
        assert_ne!(mean_difference(&SLEEP, "awake"), again);
    }

    #[test]
    fn a12_counts_pairs() {
        // (2 > 1), (2 = 2), (3 > 1), (3 > 2): 3.5 of 4.
        assert_eq!(a12(&[2.0, 3.0], &[1.0, 2.0]), Some(0.875));
        assert_eq!(a12(&[1.0, 2.0], &[2.0, 3.0]), Some(0.125));
        assert_eq!(a12(&[5.0, f64::INFINITY], &[f64::INFINITY, 5.0]), Some(0.5));
        assert_eq!(a12(&[], &[1.0]), None);
        // sleep: of 100 pairs 73 are larger and 3 equal.
        let (first, second): (Vec<f64>, Vec<f64>) = SLEEP.iter().copied().unzip();
        assert_eq!(a12(&first, &second), Some(0.745));
    }
}
