//! The steps at which the maps of a drive differ.

use super::{MOST_STATES, TooMuch};
use crate::scenario::DriveSpec;

/// The steps at which maps differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Time {
    /// The first step of the span that repeats itself.
    pub settled: u32,
    /// Its length; 1 where nothing moves any longer.
    pub period: u32,
}

impl Time {
    /// # Errors
    /// [`TooMuch::Period`] where the span is longer than could be searched.
    pub fn of(moving: &DriveSpec) -> Result<Self, TooMuch> {
        let walls = moving.changes.last().map_or(0, |change| change.at_step);
        let settled = moving.tracks.iter().map(|track| track.settled()).fold(walls, u32::max);
        let periods = moving.tracks.iter().filter_map(|track| track.period());
        let period = periods.map(u64::from).try_fold(1, |all: u64, one| {
            let both = all / common_divisor(all, one) * one;
            (both <= MOST_STATES).then_some(both)
        });
        let period = period.ok_or(TooMuch::Period { most: MOST_STATES as u32 })?;
        Ok(Self { settled, period: period as u32 })
    }

    pub fn steps(self) -> u64 {
        u64::from(self.settled) + u64::from(self.period)
    }

    pub fn after(self, step: u32) -> u32 {
        if u64::from(step) + 1 < self.steps() { step + 1 } else { self.settled }
    }
}

fn common_divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { common_divisor(b, a % b) }
}
