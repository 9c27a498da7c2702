//! Results of runs that were made elsewhere, and how they become part of a comparison.
//!
//! What a row holds is what the file tells: nothing is run again, and nobody can tell here whether its lengths follow the scenario's rules,
//! except where one is shorter than the exact optimum ([`super::Comparison::impossible`]). Seeds keep their numbers; runs are treated as pairs
//! only where both entries have the seed.

mod join;
mod matched;
#[cfg(test)]
mod tests;

use super::row::Spent;
use crate::error::Notice;
use crate::planner::Status;

pub use join::{fill, join};
pub use matched::{Matched, MatchedEntry, MatchedMap, matched};

/// The runs of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedResults {
    /// The file's name without folders.
    pub file: String,
    /// The names of maps that stand in the file, in their order; empty where it names none.
    pub instances: Vec<String>,
    /// Whose runs they are, in the order of the file; at least one.
    pub entries: Vec<ImportedEntry>,
    /// What was assumed or left out.
    pub notices: Vec<Notice>,
}

/// The runs of one algorithm.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedEntry {
    /// Its name made plain: small letters, digits, `-`. May be the same for two of them.
    pub id: String,
    /// Its name as it stands in the file, or the file's without ending.
    pub label: String,
    /// Its runs, in the order of the file.
    pub runs: Vec<ImportedRun>,
}

/// One run.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedRun {
    /// Which of [`ImportedResults::instances`] it is on; none where the file does not say.
    pub instance: Option<usize>,
    /// Its seed; where the file does not say, runs are counted from 1.
    pub seed: u32,
    /// How it ended; where the file does not say, [`Status::Complete`] with a path and [`Status::BudgetSpent`] without.
    pub status: Status,
    /// What it had spent when it ended, as far as that is known.
    pub effort: Spent,
    /// Its improvements in the order in which they came, the last one its result; empty for a run without a path.
    pub steps: Vec<ImportedStep>,
}

/// A path that a run has found.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ImportedStep {
    /// Its length in cells.
    pub length: Option<f64>,
    /// Its value by whatever it was searched for: by slices and on weighted ground the cost. One of length and value is always there.
    pub value: Option<f64>,
    /// Its turns.
    pub turns: Option<u32>,
    /// V(d, r) in cells.
    pub turn_index: Option<f64>,
    /// Σ R in cells, of a tour by several goals.
    pub weight: Option<f64>,
    /// What had been spent when it was found, as far as that is known.
    pub spent: Spent,
}

impl ImportedStep {
    /// What it is compared by: where a map is compared by cost its value, elsewhere its length, or the only number there is. None where the
    /// cost is asked for and a length is all that is known.
    pub fn compared(&self, by_cost: bool) -> Option<f64> {
        if by_cost { self.value } else { self.length.or(self.value) }
    }

    /// Whether it has a smaller length or a smaller value than another one.
    pub(crate) fn improves(&self, than: &Self) -> bool {
        let less = |new: Option<f64>, old: Option<f64>| new.is_some_and(|n| old.is_none_or(|o| n < o));
        less(self.length, than.length) || less(self.value, than.value)
    }
}

impl ImportedResults {
    /// Number of runs of all entries.
    pub fn runs(&self) -> usize {
        self.entries.iter().map(|e| e.runs.len()).sum()
    }

    /// Leaves out the runs on maps of these names, in small or large letters.
    pub fn leave_out(&mut self, names: &[String]) {
        let is_left_out = |instance: &String| names.iter().any(|name| name.to_lowercase() == instance.to_lowercase());
        let (mut left, mut place) = (Vec::new(), Vec::new());
        for instance in std::mem::take(&mut self.instances) {
            let stays = !is_left_out(&instance);
            place.push(stays.then_some(left.len()));
            left.extend(stays.then_some(instance));
        }
        self.instances = left;
        for entry in &mut self.entries {
            entry.runs.retain_mut(|run| {
                let Some(instance) = run.instance else { return true };
                run.instance = place[instance];
                run.instance.is_some()
            });
        }
    }
}
