//! What a planner has proven of its result.

use serde::Serialize;

/// A proof, as far as it goes: no path is shorter than the bound. Whoever repeats the run repeats it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Certificate {
    /// No result can have a smaller value, in cells.
    pub lower_bound: f64,
    /// Cells that were expanded for it.
    pub expansions: u64,
    /// Whether the proof is complete: the bound is the value of the best path.
    pub complete: bool,
}
