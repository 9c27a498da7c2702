//! What runs may spend, and what effort is counted in.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::row::MAX_COUNT;
use crate::error::QuestionError;

/// What a run may spend. It ends runs, it does not lengthen them: a planner whose own parameters end it earlier ends earlier.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Budget {
    /// What is counted; not [`Axis::Time`], by which no two machines agree.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Exclude<Axis, \"time\">"))]
    pub axis: Axis,
    /// How much of it, from 1 to 2⁵³. Only iterations that end within the budget count.
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
        // A formatter takes the name of a variant as serde has it.
        self.axis.serialize(&mut *f)?;
        write!(f, "={}", self.amount)
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
    /// What may stand where seconds may not.
    pub(super) const BY_NO_CLOCK: &'static str =
        "iterations, constructed-paths, ant-moves, cell-expansions or moves: by time no two machines agree";

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

impl Budget {
    /// Whether runs can be ended by it.
    pub(super) fn check(self) -> Result<(), QuestionError> {
        match self {
            Self { axis: Axis::Time, .. } => Err(QuestionError::field("budget.axis", "time", Axis::BY_NO_CLOCK)),
            Self { amount: 1..=MAX_COUNT, .. } => Ok(()),
            Self { amount, .. } => Err(QuestionError::field("budget.amount", amount, format!("1 to {MAX_COUNT}"))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_reads_what_it_prints() {
        let budget = Budget { axis: Axis::ConstructedPaths, amount: 5000 };
        assert_eq!(budget.to_string(), "constructed-paths=5000");
        assert_eq!(budget.to_string().parse(), Ok(budget));
        for wrong in ["constructed-paths", "paths=3", "time=3", "moves=0", "moves=-1", "moves=9007199254740993"] {
            assert!(wrong.parse::<Budget>().is_err(), "{wrong}");
        }
        assert!("moves=9007199254740992".parse::<Budget>().is_ok());
    }
}
