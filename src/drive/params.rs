//! How a robot drives, whatever it plans with.

use crate::{param_choice, params};

param_choice! {
    /// When a robot with a path plans again.
    pub enum Replan {
        /// whenever what it knows of the map has changed
        Changed = "changed",
        /// once the rest of its path is blocked
        Blocked = "blocked",
    }
}

params! {
    /// How a robot drives.
    pub struct DriveParams {
        /// iterations of each planning, in place of the planner's own number; a search goes to its end
        iterations: u32 = 20, "", [1..=100_000], "iterations", "our choice";
        /// goes on with what the planner has learnt, where it can: a colony's trails, the costs of D* Lite; otherwise it begins anew each time
        keep: bool = true, "", [], "", "our choice";
        /// when a robot with a path plans again
        replan: Replan = Replan::Changed, "", [], "", "our choice";
        /// steps for which it waits while the next cell of its path is taken, before it looks for another way
        hold: u32 = 0, "", [0..=1000], "steps", "our choice";
        /// waits in a row after which it gives up
        patience: u32 = 100, "", [0..=100_000], "steps", "our choice";
        /// moves and waits after which it gives up
        longest: u32 = 10_000, "", [1..=1_000_000], "steps", "our choice";
    }
}
