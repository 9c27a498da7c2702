//! Searches with a proof: their length is the yardstick for everything else.

pub mod astar;
pub mod dijkstra;
mod search;

pub use astar::Distance;
pub use search::Estimate;

use std::sync::Arc;

use crate::metrics::path_length;
use crate::scenario::Scenario;

/// Length in cells of the shortest path; `None` when there is none.
pub fn optimum(scenario: &Arc<Scenario>) -> Option<f64> {
    let mut search = search::Search::new(Arc::clone(scenario), astar::Distance::of(scenario));
    crate::planner::Planner::run(&mut search);
    crate::planner::Planner::best(&search).map(|s| path_length(scenario.grid.width(), &s.path))
}
