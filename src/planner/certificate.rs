//! What a planner has proven of its result.

use serde::Serialize;

/// A proof, as far as it goes: no result is smaller than the bound, so that with the planner's best one the optimum lies in an interval. Whoever
/// repeats the run repeats it.
///
/// ```
/// # use std::sync::Arc;
/// # use formicarium::map::{Grid, Movement, Point};
/// # use formicarium::{catalog, params::Values, scenario::Scenario};
/// let scenario = Scenario::on(Grid::open(9, 9)?, Movement::default(), Point::new(0, 0), Point::new(3, 4))?;
/// let mut search = catalog::build(&Arc::new(scenario), "any-angle", None, &Values::new(), 1)?;
/// assert!(search.certificate().is_none(), "nothing is proven yet");
/// search.run();
/// assert!(search.certificate().is_some_and(|certificate| certificate.complete && certificate.lower_bound == 5.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Certificate {
    /// No result can have a smaller value by the planner's objective, in cells.
    pub lower_bound: f64,
    /// Cells that were expanded for it.
    pub expansions: u64,
    /// Whether the proof is complete: the bound is the value of the best result; else the planner is at work, or its budget was spent before.
    pub complete: bool,
}
