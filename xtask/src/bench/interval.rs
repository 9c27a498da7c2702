//! The median of some rounds, with an interval that rests on their order alone.

use std::fmt;

/// A median, and between which numbers it lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    pub median: f64,
    low: f64,
    high: f64,
}

impl Interval {
    /// The narrowest pair of order statistics that holds the true median with a probability of at least 95 %, whatever the distribution;
    /// of fewer than six numbers the smallest and the largest, which hold it less often.
    pub fn of(numbers: impl IntoIterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = numbers.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        let (n, cut) = (sorted.len(), cut(sorted.len()));
        let median = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2.0;
        Self { median, low: sorted[cut], high: sorted[n - 1 - cut] }
    }

    /// In another unit.
    pub fn times(self, factor: f64) -> Self {
        Self { median: self.median * factor, low: self.low * factor, high: self.high * factor }
    }
}

/// How many numbers can be left out at each end: so many or fewer of n lie on one side of the median with a probability of at most 2.5 %.
fn cut(n: usize) -> usize {
    let mut binomial = 1.0;
    let mut tail = 0.0;
    for k in 0..n / 2 {
        tail += binomial / 2f64.powi(n as i32);
        if tail > 0.025 {
            return k.saturating_sub(1);
        }
        binomial *= (n - k) as f64 / (k + 1) as f64;
    }
    0
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} [{}, {}]", short(self.median), short(self.low), short(self.high))
    }
}

/// Three figures; nothing is 0.
pub fn short(number: f64) -> String {
    if number == 0.0 {
        return "0".into();
    }
    let digits = 2 - number.abs().max(1e-9).log10().floor() as i32;
    format!("{number:.*}", digits.clamp(0, 6) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_figures() {
        assert_eq!([0.0, 0.01234, 9.876, 1234.5].map(short), ["0", "0.0123", "9.88", "1234"]);
    }

    #[test]
    fn order_statistics_of_the_sign_test() {
        // The tables of the sign test: none of 5, the outermost of 6 to 8, the second of 9 to 11, the third of 12.
        let cuts = [5, 6, 8, 9, 11, 12].map(cut);
        assert_eq!(cuts, [0, 0, 0, 1, 1, 2]);
    }

    #[test]
    fn a_median_between_its_neighbours() {
        let interval = Interval::of((1..=11).map(f64::from));
        assert_eq!((interval.low, interval.median, interval.high), (2.0, 6.0, 10.0));
        assert_eq!(interval.times(2.0).to_string(), "12.0 [4.00, 20.0]");
    }

    #[test]
    fn three_figures() {
        assert_eq!([1234.5, 12.345, 0.012345].map(short), ["1234", "12.3", "0.0123"]);
    }
}
