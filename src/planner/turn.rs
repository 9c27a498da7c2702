//! One ant of a colony: its way so far, what it weighs when its turn comes, and what it then does.

use crate::map::Cell;

use super::MoveOdds;

/// What became of an ant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Fate {
    /// Still under way.
    Walking,
    /// At the goal.
    Arrived,
    /// Lost at a dead end, or at the cap on its moves.
    Lost,
}

/// How far an ant has come.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Walked {
    /// The cells (by slices the places) of its way, its origin first, without those that it took back.
    pub way: Vec<Cell>,
    /// What became of it.
    pub fate: Fate,
}

/// The next move of an ant. Ants before it in the order of moving have moved already: where ants change trails as they go, it sees what they
/// have left.
#[derive(Debug, Clone, PartialEq)]
pub struct Turn {
    /// Where it stands before the move.
    pub walked: Walked,
    /// The moves that the map allows, as this ant weighs them: those to what it has visited weigh 0. Empty once it has ended.
    pub odds: Vec<MoveOdds>,
    /// The cell to which it goes: at a dead end, where it steps back, the one before. None where it gives up, and once it has ended.
    pub next: Option<Cell>,
}

impl Turn {
    /// Of an ant that moves no more.
    pub fn over(walked: Walked) -> Self {
        Self { walked, odds: Vec::new(), next: None }
    }
}
