//! Bootstrap intervals that are known already: they take long, and most samples stay as they are while the page asks again.

use std::collections::BTreeMap;

use super::contrast::Contrast;
use super::statistics::{mean_interval, median_interval};
use crate::digest::Digest;

/// Intervals by their names, as long as their samples are the same.
#[derive(Debug, Default)]
pub struct Intervals {
    contrasts: Kept<Contrast>,
    ranges: Kept<[f64; 2]>,
}

impl Intervals {
    /// A contrast of a kind, of samples whose values these are.
    pub(super) fn contrast(
        &mut self,
        kind: &str,
        name: &str,
        values: impl Iterator<Item = f64>,
        draw: impl FnOnce() -> Option<Contrast>,
    ) -> Option<Contrast> {
        self.contrasts.get(kind, name, values, draw)
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
    use crate::comparison::contrast::{TwoSamples, contrast};
    use crate::comparison::measure::RunMeasure;
    use crate::comparison::statistics::mean;

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
        let two = |baseline: f64| TwoSamples { improved: vec![1.0, 5.0, 2.0], baseline: vec![baseline; 3], paired: true };
        let drawn = |of: &TwoSamples<f64>| contrast(of, RunMeasure::Length, "a", |sample| mean(sample));
        let mut kept = |of: TwoSamples<f64>| intervals.contrast("mean", "a", of.baseline.iter().copied(), || drawn(&of));
        assert_eq!([kept(two(2.0)), kept(two(2.0)), kept(two(3.0))], [two(2.0), two(2.0), two(3.0)].map(|of| drawn(&of)));
        assert_eq!(intervals.mean(&[], "c"), None);
    }
}
