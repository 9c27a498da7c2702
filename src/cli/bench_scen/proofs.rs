//! What share of the shortest polylines is proven.

use serde::Serialize;

use super::Found;
use crate::cli::text::row;

/// What was proven of the shortest polylines.
#[derive(Default, Serialize)]
pub(super) struct Proofs {
    proven: u32,
    within_a_second: u32,
    /// Intervals that are left, and the sum of their widths as parts of their upper ends.
    intervals: u32,
    #[serde(skip)]
    widths: f64,
    /// Without a way, because the limit of work was reached.
    unknown: u32,
}

impl Proofs {
    /// Counts what was found on a scenario in so many milliseconds.
    pub(super) fn add(&mut self, found: &Found, milliseconds: f64) {
        match (found.certificate, found.length) {
            (Some(certificate), _) if certificate.complete => {
                self.proven += 1;
                self.within_a_second += u32::from(milliseconds <= 1000.0);
            }
            (Some(certificate), Some(length)) => {
                self.intervals += 1;
                self.widths += (length - certificate.lower_bound) / length;
            }
            _ => self.unknown += 1,
        }
    }

    /// Its rows of the table.
    pub(super) fn text(&self, out: &mut String) {
        let all = f64::from((self.proven + self.intervals + self.unknown).max(1));
        let share = |count: u32| format!("{count} scenarios, {:.1} %", 100.0 * f64::from(count) / all);
        row(out, "proven", format!("{}; within a second {}", share(self.proven), share(self.within_a_second)));
        if self.intervals > 0 {
            let width = 100.0 * self.widths / f64::from(self.intervals);
            row(out, "intervals", format!("{}, {width:.3} % wide in the mean", share(self.intervals)));
        }
    }
}
