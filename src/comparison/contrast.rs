//! What two samples of runs differ by, and what it could as well have been.

use serde::Serialize;

use super::claim::Direction;
use super::measure::RunMeasure;
use super::statistics::{Difference, draw, minus, quantile, resamples, rounded, sorted};
use crate::rng::{Stream, Streams};

/// By which part of the baseline's value two entries differ; of shares of runs, and of nothing else, the difference itself.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EffectSize {
    /// What it is.
    pub value: f64,
    /// Lower end of its 95 % interval.
    pub low: f64,
    /// Upper end of that.
    pub high: f64,
    /// Lower end of its 90 % interval: two one-sided tests at 5 % go by this one.
    pub inner_low: f64,
    /// Upper end of that.
    pub inner_high: f64,
}

impl EffectSize {
    /// Counted so that what the claim says is positive.
    pub(super) fn signed(self, direction: Direction) -> Self {
        let Self { value, low, high, inner_low, inner_high } = self;
        let of = |effect| direction.signed(effect) + 0.0;
        match direction {
            Direction::More => self,
            Direction::Less => {
                Self { value: of(value), low: of(high), high: of(low), inner_low: of(inner_high), inner_high: of(inner_low) }
            }
        }
    }

    /// With intervals that reach at least to 0: the difference may be chance.
    pub(super) fn to_nothing(self) -> Self {
        let Self { value, low, high, inner_low, inner_high } = self;
        Self { value, low: low.min(0.0), high: high.max(0.0), inner_low: inner_low.min(0.0), inner_high: inner_high.max(0.0) }
    }

    /// Whether all of its numbers are finite.
    pub(super) fn is_finite(&self) -> bool {
        [self.value, self.low, self.high, self.inner_low, self.inner_high].iter().all(|v| v.is_finite())
    }
}

/// Improved less baseline, in the measure's unit and as an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contrast {
    pub difference: Difference,
    pub effect: EffectSize,
}

/// What is compared: the improved entry's runs, then the baseline's.
#[derive(Debug, Clone, Default)]
pub(super) struct TwoSamples<T> {
    pub improved: Vec<T>,
    pub baseline: Vec<T>,
    /// Whether runs at the same place are of the same seed and draw alike, as of one planner with two settings. Two planners draw from
    /// different streams even with one seed: their samples are independent.
    pub paired: bool,
}

impl<T: Copy> TwoSamples<T> {
    /// Both, without the runs that do not count; of pairs both must.
    pub fn only(&self, counts: impl Fn(T) -> bool) -> Self {
        let paired = self.paired;
        if paired {
            let pairs = self.improved.iter().copied().zip(self.baseline.iter().copied());
            let (improved, baseline) = pairs.filter(|&(a, b)| counts(a) && counts(b)).unzip();
            return Self { improved, baseline, paired };
        }
        let of = |sample: &[T]| sample.iter().copied().filter(|&v| counts(v)).collect();
        Self { improved: of(&self.improved), baseline: of(&self.baseline), paired }
    }

    /// How many runs each has.
    pub fn runs(&self) -> [usize; 2] {
        [self.improved.len(), self.baseline.len()]
    }

    /// Draws with replacement: pairs stay together, and independent samples are drawn each by itself, the improved entry's first.
    fn draw(&self, dice: &mut Stream, improved: &mut [T], baseline: &mut [T]) {
        if self.paired {
            for (a, b) in improved.iter_mut().zip(baseline.iter_mut()) {
                let at = draw(dice, self.improved.len());
                (*a, *b) = (self.improved[at], self.baseline[at]);
            }
            return;
        }
        improved.iter_mut().for_each(|a| *a = self.improved[draw(dice, self.improved.len())]);
        baseline.iter_mut().for_each(|b| *b = self.baseline[draw(dice, self.baseline.len())]);
    }
}

/// The percentile bootstrap of [`super::statistics`] of what a statistic of two samples differs by. The statistic may reorder what it is
/// given. `None` where one has no runs.
pub(super) fn contrast<T: Copy>(
    samples: &TwoSamples<T>,
    measure: RunMeasure,
    name: &str,
    mut statistic: impl FnMut(&mut [T]) -> Option<f64>,
) -> Option<Contrast> {
    let (mut improved, mut baseline) = (samples.improved.clone(), samples.baseline.clone());
    let mut of = |a: &mut [T], b: &mut [T]| {
        let (a, b) = (statistic(a)?, statistic(b)?);
        Some((minus(a, b), effect(measure, a, b)))
    };
    let found = of(&mut improved, &mut baseline)?;
    let mut dice = Streams::new(0, name, 0).ant(0, 0);
    let count = resamples(improved.len().max(baseline.len()));
    let (mut differences, mut effects) = (Vec::with_capacity(count as usize), Vec::with_capacity(count as usize));
    for _ in 0..count {
        samples.draw(&mut dice, &mut improved, &mut baseline);
        let drawn = of(&mut improved, &mut baseline)?;
        differences.push(drawn.0);
        effects.push(drawn.1);
    }
    let (differences, effects) = (sorted(differences), sorted(effects));
    let [difference, within] = [&differences, &effects].map(|all| move |p| quantile(all, p));
    Some(Contrast {
        difference: Difference { value: found.0, low: difference(0.025)?, high: difference(0.975)? },
        effect: EffectSize {
            value: found.1,
            low: within(0.025)?,
            high: within(0.975)?,
            inner_low: within(0.05)?,
            inner_high: within(0.95)?,
        },
    })
}

/// Improved less baseline as a part of the baseline; of shares the difference. Of an infinite baseline there is no part: an improved value
/// that is finite saves all of it, and is better than any where the baseline is −∞, which is worst where more is better.
fn effect(measure: RunMeasure, improved: f64, baseline: f64) -> f64 {
    let difference = minus(improved, baseline);
    if difference == 0.0 || measure.is_share() {
        difference
    } else if baseline.is_infinite() {
        if baseline > 0.0 { -1.0 } else { f64::INFINITY }
    } else {
        rounded(difference / baseline)
    }
}

#[cfg(test)]
mod tests;
