//! What reports say of claims, on one map and over maps.

mod en;
mod zh_cn;

use super::{With, WithTwo};
use crate::comparison::budget::Axis;
use crate::comparison::over_maps::{OverallVerdict, VerdictCounts};
use crate::comparison::verdict::Verdict;
use crate::planner::PaperReading;

pub(super) use en::CLAIMS as EN;
pub(super) use zh_cn::CLAIMS as ZH_CN;

/// What became of the claims.
pub(in crate::comparison::report) struct Claims {
    pub title: &'static str,
    /// On single maps.
    pub by_map: &'static str,
    /// Of the table of single maps, with the confidence of the intervals.
    pub columns: fn(f64) -> [String; 11],
    /// What is said, of whom, against whom.
    pub against: fn([&str; 3]) -> String,
    /// A measure that is a running time, with how near its target is and what it is counted in.
    pub to_target: fn(&str, &str, Axis) -> String,
    /// An expected running time where no run arrives.
    pub never: &'static str,
    /// How many runs the means are over, where not all count: of pairs, or of the improved entry and of the baseline.
    pub runs: fn([usize; 2], bool) -> String,
    /// A difference of shares.
    pub points: With,
    /// The verdict on one map, and whether a size is claimed.
    pub verdict: fn(Verdict, bool) -> String,
    /// All on single maps.
    pub totals: fn(&VerdictCounts) -> String,
    /// Of the table over maps, with the confidence of the intervals.
    pub over_columns: fn(f64) -> [String; 6],
    /// On so many of so many maps.
    pub on_maps: fn(usize, usize) -> String,
    /// On how many maps it came to what.
    pub counts: fn(&VerdictCounts) -> String,
    /// The verdict over maps, whether a size is claimed, and the fewest maps.
    pub overall: fn(OverallVerdict, bool, usize) -> String,
    /// What the table over maps has, for its caption.
    pub about: &'static str,
    pub readings_title: &'static str,
    /// What is claimed, and by which measure.
    pub readings_columns: [&'static str; 2],
    pub reading: fn(PaperReading) -> &'static str,
    /// What the table of readings has, for its caption.
    pub readings_about: &'static str,
    pub unfit_title: &'static str,
    /// Map, what it contradicts, where the publication says it.
    pub unfit_columns: [&'static str; 3],
    /// The optimum, and the greatest one that could be.
    pub optimum_above: WithTwo,
    /// The greatest optimum that could be, where no path exists.
    pub no_path: With,
    /// Who, in which share of the runs, and the least one.
    pub does_not_arrive: fn([&str; 3]) -> String,
}
