//! How far the lines of a lattice lie apart: the frequencies of a profile.

use core::f64::consts::TAU;

/// Fewest pixels of a cell.
pub(super) const LEAST: f64 = 5.0;

/// Fewest cells of a side.
pub(super) const FEWEST: f64 = 4.0;

/// A frequency that divides the strongest one is the true one, if it is at least so strong beside it: lines are combs, whose multiples are as
/// strong as they are.
const OF_STRONGEST: f64 = 0.4;

/// A sum of a profile over waves of one frequency.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wave {
    pub re: f64,
    pub im: f64,
}

impl Wave {
    /// Of `frequency` waves a pixel.
    pub(super) fn of(profile: &[f64], frequency: f64) -> Self {
        let (turn_re, turn_im) = (libm::cos(TAU * frequency), -libm::sin(TAU * frequency));
        let (mut re, mut im) = (0.0, 0.0);
        let (mut c, mut s) = (1.0, 0.0);
        for &value in profile {
            re += value * c;
            im += value * s;
            (c, s) = (c * turn_re - s * turn_im, c * turn_im + s * turn_re);
        }
        Self { re, im }
    }

    pub(super) fn strength(self) -> f64 {
        libm::sqrt(self.re * self.re + self.im * self.im)
    }

    /// Where a crest lies, in pixels, within half a wave of 0.
    pub(super) fn crest(self, frequency: f64) -> f64 {
        -libm::atan2(self.im, self.re) / (TAU * frequency)
    }
}

/// Strengths at evenly spaced frequencies.
pub(super) struct Spectrum {
    first: f64,
    step: f64,
    strengths: Vec<f64>,
}

impl Spectrum {
    /// None for a profile that is too short.
    pub(super) fn new(profile: &[f64]) -> Option<Self> {
        let length = profile.len() as f64;
        let (first, last, step) = (FEWEST / length, 1.0 / LEAST, 0.25 / length);
        if first >= last {
            return None;
        }
        let count = ((last - first) / step) as usize + 1;
        let strengths = (0..count).map(|i| Wave::of(profile, first + i as f64 * step).strength()).collect();
        Some(Self { first, step, strengths })
    }

    fn frequency(&self, i: usize) -> f64 {
        self.first + i as f64 * self.step
    }

    /// The strongest place within `spread` (a share) of a frequency.
    fn near(&self, frequency: f64, spread: f64) -> Option<usize> {
        let index = |f: f64| libm::round((f - self.first) / self.step);
        let (from, to) = (index(frequency * (1.0 - spread)).max(0.0), index(frequency * (1.0 + spread)));
        if to < 0.0 || from >= self.strengths.len() as f64 {
            return None;
        }
        let (from, to) = (from as usize, (to as usize).min(self.strengths.len() - 1));
        (from..=to).max_by(|&a, &b| self.strengths[a].total_cmp(&self.strengths[b]))
    }

    /// The lattice's own frequency: the strongest, or the lowest that it is a multiple of.
    pub(super) fn fundamental(&self) -> f64 {
        let strongest = self.near(0.1, 100.0).unwrap_or(0);
        let least = OF_STRONGEST * self.strengths[strongest];
        let part = |parts: f64| self.near(self.frequency(strongest) / parts, 0.01).filter(|&i| self.strengths[i] >= least);
        let index = [4.0, 3.0, 2.0].into_iter().find_map(part).unwrap_or(strongest);
        self.frequency(index)
    }

    /// The strongest frequency near another, as a share of the strongest of all.
    pub(super) fn beside(&self, frequency: f64) -> Option<(f64, f64)> {
        let strongest = self.strengths.iter().copied().fold(0.0, f64::max);
        self.near(frequency, 0.1).map(|i| (self.frequency(i), self.strengths[i] / strongest))
    }
}
