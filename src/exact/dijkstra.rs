//! Dijkstra, "A note on two problems in connexion with graphs", Numerische Mathematik 1 (1959) 269–271.
//!
//! Expands by cost from the start alone; on a grid of steps 1 and √2 the length is exact.

use std::sync::Arc;

use super::SEARCH;
use super::astar::Distance;
use super::search::Search;
use crate::error::ParamError;
use crate::params::{Values, check_keys};
use crate::planner::{Planner, PlannerEntry};
use crate::scenario::Scenario;

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    check_keys(ENTRY.id, &[], values)?;
    Ok(Box::new(Search::new(Arc::clone(scenario), Distance::unknown(scenario))))
}

/// Dijkstra in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "dijkstra",
    name: "Dijkstra",
    summary: "Explores in rings of equal cost until the goal is reached; always the shortest path.",
    source: "Dijkstra 1959, Numerische Mathematik 1, 269–271, doi:10.1007/BF01386390",
    build,
    ..SEARCH
};
