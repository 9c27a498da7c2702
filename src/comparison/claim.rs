//! What a question claims of two of its entries.

use serde::{Deserialize, Serialize};

use super::budget::Axis;
use super::measure::RunMeasure;
use super::question::Instance;
use super::statistics::{mean, quantile, sorted};
use crate::planner::PaperReading;

/// Which way the improved entry is said to differ from the baseline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Direction {
    /// Its values are smaller.
    Less,
    /// Its values are larger.
    More,
}

impl Direction {
    /// A difference, counted so that what the claim says is positive.
    pub fn signed(self, difference: f64) -> f64 {
        match self {
            Self::Less => -difference,
            Self::More => difference,
        }
    }
}

/// What stands for all runs of an entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Statistic {
    /// The middle run; a run without a path counts as longer than any.
    Median,
    /// The mean over the pairs of runs that both found a path.
    Mean,
}

impl Statistic {
    /// The number that stands for a sample; none for an empty one. Runs without a path may be in it as infinite values.
    pub fn of(self, sample: &[f64]) -> Option<f64> {
        match self {
            Self::Median => quantile(&sorted(sample.to_vec()), 0.5),
            Self::Mean => mean(sample),
        }
    }
}

/// What is expected of two entries: one is said to have smaller or larger values than the other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Claim {
    /// Stable id: small letters, digits, `-`. The bootstrap draws from a stream of this name.
    pub id: String,
    /// The claim in words.
    pub says: String,
    /// What a reader of the verdict must know.
    #[serde(default)]
    pub note: String,
    /// Id of the entry that is said to differ.
    pub improved: String,
    /// Id of the entry it is compared with.
    pub baseline: String,
    /// What is compared.
    pub measure: RunMeasure,
    /// Which way it is said to differ.
    pub direction: Direction,
    /// By which part of the baseline's value, above 0. Absent: what the published numbers of both entries say, if there are any.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub size: Option<f64>,
    /// What decides; absent: the mean where every run has a value, else the median.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Statistic | null"))]
    pub statistic: Option<Statistic>,
    /// Ids of the instances it is about, or of their groups; empty: all.
    #[serde(default)]
    pub instances: Vec<String>,
    /// The smallest effect that matters, as a part of the baseline's value; of shares a difference, where 0.05 is five points. Absent: what
    /// the measure says.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub relevant: Option<f64>,
    /// Of a running time: how near to the best known value the target is, as a part of it. Absent: [`Claim::TARGET`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub target: Option<f64>,
    /// Of a running time: what it is counted in, not in seconds. Absent: constructed paths.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Exclude<Axis, \"time\"> | null"))]
    pub axis: Option<Axis>,
    /// The reading of the publication that its entries are run by. Claims that say the same of several readings stand side by side.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "PaperReading | null"))]
    pub reading: Option<PaperReading>,
}

impl Claim {
    /// How near to the best known value a running time's target is.
    pub const TARGET: f64 = 0.01;

    /// The smallest effect that matters.
    pub fn relevant(&self) -> f64 {
        self.relevant.unwrap_or_else(|| self.measure.relevant())
    }

    /// How near to the best known value the target of its running times is.
    pub fn target(&self) -> f64 {
        self.target.unwrap_or(Self::TARGET)
    }

    /// What its running times are counted in.
    pub fn axis(&self) -> Axis {
        self.axis.unwrap_or(Axis::ConstructedPaths)
    }

    /// What decides. Means tell small shifts of values that come in few steps, which medians and their bootstrap do not; but a mean
    /// over the runs that happened to find a path would favour the entry that fails on the hard ones. Then medians decide, whatever was asked for.
    pub fn statistic(&self, every_run_counts: bool) -> Statistic {
        if every_run_counts { self.statistic.unwrap_or(Statistic::Mean) } else { Statistic::Median }
    }

    /// Whether another claim says the same, be it of another reading, of other entries or of other maps.
    pub fn says_the_same(&self, other: &Self) -> bool {
        let said = |claim: &Self| (claim.measure, claim.direction, claim.axis());
        self.says == other.says && said(self) == said(other) && self.target().total_cmp(&other.target()).is_eq()
    }

    /// Whether it is about an instance.
    pub fn is_about(&self, instance: &Instance) -> bool {
        self.instances.is_empty() || self.instances.iter().any(|id| instance.goes_by(id))
    }
}
