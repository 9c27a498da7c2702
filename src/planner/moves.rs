//! What an ant weighs where it stands.

use crate::map::Cell;

/// A move that an ant may choose, with what it goes by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoveOdds {
    /// Which of the planner's colonies would choose: with several goals the leg, from 0 in visiting order; of two teams 0 is the one from
    /// the start, 1 the one from the goal. The probabilities of each colony add up to 1.
    pub colony: u32,
    /// The cell (by slices the place) to which it leads.
    pub to: Cell,
    /// τ, above 0.
    pub trail: f64,
    /// η, above 0.
    pub heuristic: f64,
    /// τ^α·η^β as the ants weigh it: τ and η each divided by the largest of the moves first. 0 for a move to what an ant has visited.
    pub weight: f64,
    /// From 0 to 1, by the planner's own rule of selection, what it takes greedily (q0, r0) included.
    pub probability: f64,
}
