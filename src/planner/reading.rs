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

param_choice! {
    /// What a formula that divides by the distance to the goal means for the step onto the goal, where that distance is 0.
    pub enum GoalStep {
        /// the goal is weighed as any other cell, by a small distance that stands for 0
        Weighed = "weighed",
        /// beside the goal, where the step is allowed, it is taken without a choice
        Enter = "enter",
    }
}

/// The distance in cells that stands for 0 at the goal: 1 / 0.01 = 100 there, as in the textbook MATLAB program.
pub const AT_GOAL: f64 = 0.01;
