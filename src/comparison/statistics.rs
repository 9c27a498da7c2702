//! What describes a sample of runs and the difference of two: quantiles, mean, deviation, paired bootstrap, Vargha and Delaney's A.
//!
//! Values may be infinite: a run that found no path has an infinite length. They order like any others, so that medians, quartiles and A
//! keep their meaning; NaN must not come in. Only arithmetic with one result everywhere, and one order of every sum.

use rand::Rng;
use serde::Serialize;

use crate::rng::{Stream, Streams};

/// Resamples of a bootstrap, for samples of up to [`MOST_DRAWS`] / [`RESAMPLES`] = 10,000 items.
pub const RESAMPLES: u32 = 10_000;

/// Most items that a bootstrap draws: of larger samples fewer resamples are drawn, down to [`FEWEST_RESAMPLES`].
pub const MOST_DRAWS: u64 = 100_000_000;

/// Resamples of the largest samples. The ends of an interval are then known to about a fifth of its half width, which itself is a hundredth
/// of what it is for a hundred runs.
pub const FEWEST_RESAMPLES: u32 = 100;

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
    quantile_of(ascending.len(), p, |place| ascending[place])
}

/// The same of `count` values, of which `value` tells the one at a place of their ascending order.
pub(super) fn quantile_of(count: usize, p: f64, value: impl Fn(usize) -> f64) -> Option<f64> {
    let last = count.checked_sub(1)?;
    let place = p.clamp(0.0, 1.0) * last as f64;
    let below = (place as usize).min(last);
    let (low, high) = (value(below), value((below + 1).min(last)));
    let share = place - below as f64;
    // Between equal infinities, and from −∞ on, a difference would be no number.
    Some(if low == high || share == 0.0 || low == f64::NEG_INFINITY { low } else { low + share * (high - low) })
}

/// The median; reorders the sample. `None` of an empty one.
pub(super) fn median_of(values: &mut [f64]) -> Option<f64> {
    let half = values.len().checked_sub(1)? / 2;
    let even = values.len().is_multiple_of(2);
    let (_, &mut low, above) = values.select_nth_unstable_by(half, f64::total_cmp);
    let next = above.iter().copied().fold(f64::INFINITY, f64::min);
    Some(if even { between(low, next) } else { low })
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
///
/// Places among the distinct values are drawn and counted: what is drawn need not be sorted anew each time.
pub fn median_interval(values: &[f64], name: &str) -> Option<[f64; 2]> {
    let mut distinct = sorted(values.to_vec());
    distinct.dedup_by(|a, b| a.total_cmp(b).is_eq());
    let place = |value: &f64| distinct.partition_point(|other| other.total_cmp(value).is_lt()) as u32;
    let places: Vec<u32> = values.iter().map(place).collect();
    let mut counts = vec![0u32; distinct.len()];
    let median = |drawn: &[u32]| {
        counts.fill(0);
        drawn.iter().for_each(|&place| counts[place as usize] += 1);
        let half = drawn.len().checked_sub(1)? / 2;
        let low = counted(&counts, half);
        let next = if drawn.len().is_multiple_of(2) { counted(&counts, half + 1) } else { low };
        Some(between(distinct[low], distinct[next]))
    };
    bootstrap(&places, name, median).map(|d| [d.low, d.high])
}

/// In which class, each with its count, the item of this number is, from 0; the last one beyond all.
fn counted(counts: &[u32], number: usize) -> usize {
    let mut before = 0;
    let within = |count: &u32| {
        before += *count as usize;
        before > number
    };
    counts.iter().position(within).unwrap_or(counts.len().saturating_sub(1))
}

/// Half way between the two values in the middle.
fn between(low: f64, next: f64) -> f64 {
    if low != next && low != f64::NEG_INFINITY { low + 0.5 * (next - low) } else { low }
}

/// The bootstrap interval of a sample's mean. Only finite values. `None` of an empty one.
pub fn mean_interval(values: &[f64], name: &str) -> Option<[f64; 2]> {
    bootstrap(values, name, mean).map(|d| [d.low, d.high])
}

/// Percentile bootstrap (Efron and Tibshirani 1993, ch. 13): items (values, or pairs of them) are drawn with replacement [`RESAMPLES`] times,
/// of more than 10,000 items less often ([`MOST_DRAWS`]); the interval lies between the quantiles of the statistic. The stream follows from
/// the name, so that no comparison changes another's interval. Its work is bounded: 10⁸ draws, or 100 for each item.
fn bootstrap<T: Copy>(items: &[T], name: &str, mut statistic: impl FnMut(&[T]) -> Option<f64>) -> Option<Difference> {
    let value = statistic(items)?;
    let mut dice = Streams::new(0, name, 0).ant(0, 0);
    let mut sample = items.to_vec();
    let resamples = resamples(items.len());
    let mut drawn = Vec::with_capacity(resamples as usize);
    for _ in 0..resamples {
        for item in &mut sample {
            *item = items[draw(&mut dice, items.len())];
        }
        drawn.push(statistic(&sample)?);
    }
    let ascending = sorted(drawn);
    let tail = 0.5 * (1.0 - CONFIDENCE);
    Some(Difference { value, low: quantile(&ascending, tail)?, high: quantile(&ascending, 1.0 - tail)? })
}

/// How often a sample of `n` items is drawn.
pub(super) fn resamples(n: usize) -> u32 {
    let within = MOST_DRAWS / (n as u64).max(1);
    within.clamp(FEWEST_RESAMPLES.into(), RESAMPLES.into()) as u32
}

/// One of `n` places; as good as uniform for n far below 2³².
pub(super) fn draw(dice: &mut Stream, n: usize) -> usize {
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
    let [first, second] = [first, second].map(|values| sorted(values.iter().copied().map(rounded).collect()));
    // How many of the second are smaller than the value at hand of the first, and how many are not larger: neither falls.
    let (mut below, mut upto, mut sum) = (0, 0, 0u64);
    for a in &first {
        below += second[below..].iter().take_while(|b| b.total_cmp(a).is_lt()).count();
        upto += second[upto..].iter().take_while(|b| b.total_cmp(a).is_le()).count();
        // Half a point each: two for a smaller one, one for an equal one.
        sum += (below + upto) as u64;
    }
    let most = 2 * first.len() as u64 * second.len() as u64;
    (most > 0).then(|| sum as f64 / most as f64)
}

#[cfg(test)]
mod tests;
