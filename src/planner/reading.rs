//! Which way of understanding a publication a planner follows.

use crate::param_choice;

param_choice! {
    /// How to take the places where a paper contradicts itself; every file lists its own.
    pub enum Reading {
        /// formulas mean what the paper's own text says
        Repaired = "repaired",
        /// formulas are taken literally
        Printed = "printed",
    }
}
