//! What an ant does when every neighbour is blocked or on its tabu list. Most papers are silent; it decides how many ants arrive.

use crate::param_choice;

param_choice! {
    /// Behaviour at a dead end.
    pub enum DeadEnd {
        /// the ant steps back, cell by cell, until a free neighbour is left; what it left stays on its tabu list
        Backtrack = "backtrack",
        /// the ant dies and deposits nothing
        Die = "die",
    }
}
