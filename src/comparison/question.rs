//! The question as it is written down: `formicarium/question@1`.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::check::QuestionError;
use crate::params::Values;

/// What `format` must say.
pub const FORMAT: &str = "formicarium/question@1";

/// What is asked of a publication, and how it is to be answered.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Question {
    /// [`FORMAT`].
    pub format: String,
    /// One line.
    pub title: String,
    /// The publication, as one cites it; empty for a question of our own.
    #[serde(default)]
    pub paper: String,
    /// The question in a sentence or two.
    pub asks: String,
    /// The seeds of every entry on every instance.
    pub seeds: Seeds,
    /// What a run may spend; absent: what its planner's own parameters say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub budget: Option<Budget>,
    /// The maps.
    pub instances: Vec<Instance>,
    /// What runs on them.
    pub entries: Vec<Entry>,
    /// What is claimed.
    #[serde(default)]
    pub claims: Vec<Claim>,
}

/// `count` seeds from `from` on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Seeds {
    /// The first.
    pub from: u32,
    /// How many, 1 to 100,000.
    pub count: u32,
}

impl Seeds {
    /// All of them.
    pub fn iter(self) -> impl Iterator<Item = u32> {
        (0..self.count).map(move |i| self.from.saturating_add(i))
    }
}

/// What a run may spend. It ends runs, it does not lengthen them: a planner whose own parameters end it earlier ends earlier.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Budget {
    /// What is counted; not [`Axis::Time`], by which no two machines agree.
    pub axis: Axis,
    /// How much of it, at least 1. Only iterations that end within the budget count.
    pub amount: u64,
}

/// What effort is counted in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Axis {
    /// Finished iterations.
    Iterations,
    /// Walks begun and ended.
    ConstructedPaths,
    /// Moves of ants, and steps by which a swarm's positions are decoded.
    AntMoves,
    /// Cells taken from the open list of a search.
    CellExpansions,
    /// Ant moves and cell expansions together: what one planner of any kind has looked at.
    Moves,
    /// Seconds on the machine that ran it. Not part of any result file.
    Time,
}

impl fmt::Display for Budget {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let id = serde_json::to_value(self.axis).unwrap_or_default();
        write!(f, "{}={}", id.as_str().unwrap_or_default(), self.amount)
    }
}

impl FromStr for Budget {
    type Err = QuestionError;

    /// Reads `AXIS=AMOUNT`, as it prints itself.
    fn from_str(text: &str) -> Result<Self, QuestionError> {
        const ALLOWED: &str = "AXIS=AMOUNT such as constructed-paths=5000";
        let wrong = || QuestionError::field("budget", text, ALLOWED);
        let (axis, amount) = text.split_once('=').ok_or_else(wrong)?;
        let axis = serde_json::from_value(axis.into()).map_err(|_| wrong())?;
        let budget = Self { axis, amount: amount.parse().map_err(|_| wrong())? };
        budget.check().map(|()| budget)
    }
}

impl Axis {
    /// Its name in tables.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Iterations => "iterations",
            Self::ConstructedPaths => "constructed paths",
            Self::AntMoves => "ant moves",
            Self::CellExpansions => "cell expansions",
            Self::Moves => "ant moves and cell expansions",
            Self::Time => "seconds",
        }
    }
}

/// One map of the question.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Instance {
    /// Stable id: small letters, digits, `-`.
    pub id: String,
    /// The map's file, seen from the question's.
    pub map: String,
    /// What it stands for, and whose it is.
    #[serde(default)]
    pub note: String,
}

/// What an entry is in the comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// What the publication compares with.
    Baseline,
    /// What the publication proposes.
    Improved,
    /// Neither: another reading, a setting.
    Other,
}

/// One algorithm with its parameters.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// Stable id: small letters, digits, `-`.
    pub id: String,
    /// Its name in tables.
    pub label: String,
    /// What it is in the comparison.
    pub role: Role,
    /// Its id in the catalog; absent where nothing can be run.
    pub planner: Option<String>,
    /// Why nothing can be run; given where neither `planner` nor `results` is.
    pub missing: Option<String>,
    /// The file whose runs it stands for: results from elsewhere, which are compared and never run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub results: Option<String>,
    /// A named parameter set of the planner.
    pub preset: Option<String>,
    /// Values over preset and default.
    #[serde(default)]
    pub set: Values,
    /// What is published of it, by the instance that stands for the publication's map.
    #[serde(default)]
    pub published: BTreeMap<String, Published>,
}

/// The numbers of one row of a published table.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Published {
    /// Path length in cells.
    pub length: Option<f64>,
    /// Cost of a path by slices, by the scenario's measure.
    pub cost: Option<f64>,
    /// Turns of the path.
    pub turns: Option<f64>,
    /// The turn-weighted index V(d, r) in cells.
    pub turn_index: Option<f64>,
    /// Σ R in cells of a tour by several goals.
    pub weight: Option<f64>,
    /// Iterations until the final best was found.
    pub iterations: Option<f64>,
}

/// What is measured on a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// Length of the path in cells.
    Length,
    /// Cost of a path by slices, by the scenario's measure; elsewhere the value by the planner's own objective.
    Cost,
    /// Its turns.
    Turns,
    /// Its turn-weighted index V(d, r) in cells.
    TurnIndex,
    /// Σ R in cells of a tour by several goals: each leg as walked times the weight of its goal.
    Weight,
    /// The iteration that found the best path.
    IterationOfBest,
    /// Constructed paths up to the end of that iteration.
    PathsToBest,
    /// Moves of all ants of the run.
    AntMoves,
    /// Whether a path was found: 1 or 0.
    Success,
    /// Whether the exact optimum was found: 1 or 0.
    Optimal,
}

impl Measure {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Length => "length",
            Self::Cost => "cost",
            Self::Turns => "turns",
            Self::TurnIndex => "turn index V",
            Self::Weight => "weight R",
            Self::IterationOfBest => "iteration of best",
            Self::PathsToBest => "constructed paths to best",
            Self::AntMoves => "ant moves",
            Self::Success => "share of runs with a path",
            Self::Optimal => "share of runs with the optimum",
        }
    }

    /// Whether it is 1 or 0 for a run, and so a share of all runs.
    pub fn is_share(self) -> bool {
        matches!(self, Self::Success | Self::Optimal)
    }

    /// The published number of this measure.
    pub fn published(self, row: &Published) -> Option<f64> {
        match self {
            Self::Length => row.length,
            Self::Cost => row.cost,
            Self::Turns => row.turns,
            Self::TurnIndex => row.turn_index,
            Self::Weight => row.weight,
            Self::IterationOfBest => row.iterations,
            Self::PathsToBest | Self::AntMoves | Self::Success | Self::Optimal => None,
        }
    }
}

/// Which way the improved entry is said to differ from the baseline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
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
pub enum Statistic {
    /// The middle run; a run without a path counts as longer than any.
    Median,
    /// The mean over the pairs of runs that both found a path.
    Mean,
}

/// A comparison of two entries that a publication (or we) expect to come out one way.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
    pub measure: Measure,
    /// Which way it is said to differ.
    pub direction: Direction,
    /// By which part of the baseline's value, above 0. Absent: what the published numbers of both entries say, if there are any.
    pub size: Option<f64>,
    /// What decides; absent: the mean where every run has a value, else the median.
    pub statistic: Option<Statistic>,
    /// Ids of the instances it is about; empty: all.
    #[serde(default)]
    pub instances: Vec<String>,
}

impl Claim {
    /// What decides. Means tell small shifts of values that come in few steps, which medians and their bootstrap do not; but a mean
    /// over the runs that happened to find a path would favour whoever fails where it is hard: then medians decide, asked for or not.
    pub fn statistic(&self, every_run_counts: bool) -> Statistic {
        if every_run_counts { self.statistic.unwrap_or(Statistic::Mean) } else { Statistic::Median }
    }

    /// Whether it is about an instance.
    pub fn is_about(&self, instance: &str) -> bool {
        self.instances.is_empty() || self.instances.iter().any(|i| i == instance)
    }
}
