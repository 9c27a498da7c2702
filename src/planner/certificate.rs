//! What a planner has proven.

/// A lower bound of every result: with the planner's best one an interval in which the optimum lies.
///
/// ```
/// # use std::sync::Arc;
/// # use formicarium::map::{Grid, Movement, Point};
/// # use formicarium::{catalog, params::Values, scenario::Scenario};
/// let scenario = Scenario::on(Grid::open(9, 9)?, Movement::default(), Point::new(0, 0), Point::new(3, 4))?;
/// let mut search = catalog::build(&Arc::new(scenario), "any-angle", None, &Values::new(), 1)?;
/// assert!(search.certificate().is_none(), "nothing is proven yet");
/// search.run();
/// assert!(search.certificate().is_some_and(|certificate| certificate.is_proven && certificate.bound == 5.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    /// No result is smaller, in the unit of the planner's objective.
    pub bound: f64,
    /// Cells that were expanded to prove it.
    pub expansions: u64,
    /// Whether the planner's best result is proven to be the optimum; else its budget was spent before.
    pub is_proven: bool,
}
