//! Bootstrap intervals that are known already: they take long, and most samples stay as they are while the page asks again.

use std::collections::BTreeMap;

use super::statistics::{Difference, mean_difference, mean_interval, median_difference, median_interval};
use crate::digest::Digest;

/// Intervals by their names, as long as their samples are the same.
#[derive(Debug, Default)]
pub struct Intervals {
    differences: Kept<Difference>,
    ranges: Kept<[f64; 2]>,
}

impl Intervals {
    /// [`median_difference`].
    pub fn median_difference(&mut self, pairs: &[(f64, f64)], name: &str) -> Option<Difference> {
        let sample = pairs.iter().flat_map(|p| [p.0, p.1]);
        self.differences.get("median", name, sample, || median_difference(pairs, name))
    }

    /// [`mean_difference`].
    pub fn mean_difference(&mut self, pairs: &[(f64, f64)], name: &str) -> Option<Difference> {
        let sample = pairs.iter().flat_map(|p| [p.0, p.1]);
        self.differences.get("mean", name, sample, || mean_difference(pairs, name))
    }

    /// [`median_interval`].
    pub fn median(&mut self, values: &[f64], name: &str) -> Option<[f64; 2]> {
        self.ranges.get("median", name, values.iter().copied(), || median_interval(values, name))
    }

    /// [`mean_interval`].
    pub fn mean(&mut self, values: &[f64], name: &str) -> Option<[f64; 2]> {
        self.ranges.get("mean", name, values.iter().copied(), || mean_interval(values, name))
    }
}

/// Results with the digests of their samples.
#[derive(Debug)]
struct Kept<T>(BTreeMap<String, (String, Option<T>)>);

impl<T> Default for Kept<T> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<T: Copy> Kept<T> {
    fn get(&mut self, of: &str, name: &str, sample: impl Iterator<Item = f64>, draw: impl FnOnce() -> Option<T>) -> Option<T> {
        let mut digest = Digest::default();
        sample.for_each(|v| digest.f64(v));
        let (key, digest) = (format!("{of} {name}"), digest.hex());
        if let Some((_, result)) = self.0.get(&key).filter(|(known, _)| *known == digest) {
            return *result;
        }
        let result = draw();
        self.0.insert(key, (digest, result));
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_is_what_would_be_drawn() {
        let mut intervals = Intervals::default();
        let few = [1.0, 2.0, 4.0, 8.0];
        let first = intervals.mean(&few, "a");
        assert_eq!((first, intervals.mean(&few, "a")), (mean_interval(&few, "a"), first));
        // Another sample under the same name, another name, another statistic.
        let more = [1.0, 2.0, 4.0, 8.0, 16.0];
        assert_eq!(intervals.mean(&more, "a"), mean_interval(&more, "a"));
        assert_eq!(intervals.median(&more, "a"), median_interval(&more, "a"));
        let many: Vec<f64> = (0..30).map(|i| f64::from(i * i % 17)).collect();
        assert_ne!(intervals.mean(&many, "a"), intervals.mean(&many, "b"));
        let pairs = [(1.0, 2.0), (5.0, 3.0), (2.0, 2.0)];
        assert_eq!(intervals.median_difference(&pairs, "a"), median_difference(&pairs, "a"));
        assert_eq!(intervals.mean_difference(&pairs, "a"), mean_difference(&pairs, "a"));
        assert_eq!(intervals.mean(&[], "c"), None);
    }
}
