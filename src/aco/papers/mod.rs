//! Published variants, one file per paper, each to be read beside its PDF; what we measured with them is in `docs/papers`.

use crate::param_choice;

pub mod fire;
pub mod fireworks;
pub mod ship;
pub mod terrain;
pub mod threshold;

param_choice! {
    /// How to take the places where a paper contradicts itself; every file lists its own.
    pub enum Reading {
        /// formulas mean what the paper's own text says
        Repaired = "repaired",
        /// formulas are taken literally
        Printed = "printed",
    }
}
