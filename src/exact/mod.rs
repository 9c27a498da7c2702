//! Searches with a proof: their length is the yardstick for everything else.

pub mod astar;
pub mod dijkstra;
mod search;

pub use astar::Distance;
pub use search::Estimate;

use std::sync::Arc;

use serde::Serialize;

use crate::metrics::path_length;
use crate::planner::Objective;
use crate::scenario::Scenario;

/// The yardstick of an objective on a scenario: the value of the best result there is, in cells.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Reference {
    /// No result can be better.
    Proven {
        /// In cells.
        value: f64,
    },
    /// A good result; a better one may exist.
    Unproven {
        /// In cells.
        value: f64,
    },
    /// There is no path.
    NoPath,
    /// Nothing to compare with at this size.
    Unknown,
}

impl Reference {
    /// The value, proven or not.
    pub fn value(self) -> Option<f64> {
        match self {
            Self::Proven { value } | Self::Unproven { value } => Some(value),
            Self::NoPath | Self::Unknown => None,
        }
    }
}

/// The yardstick of an objective on a scenario.
pub fn reference(scenario: &Arc<Scenario>, objective: Objective) -> Reference {
    if !scenario.reachable() {
        return Reference::NoPath;
    }
    let proven = match objective {
        Objective::Length => optimum(scenario),
        Objective::PolylineLength | Objective::TurnIndex | Objective::TourLength | Objective::TourWeight => None,
    };
    proven.map_or(Reference::Unknown, |value| Reference::Proven { value })
}

/// Length in cells of the shortest path; `None` when there is none.
pub fn optimum(scenario: &Arc<Scenario>) -> Option<f64> {
    let mut search = search::Search::new(Arc::clone(scenario), astar::Distance::of(scenario));
    crate::planner::Planner::run(&mut search);
    crate::planner::Planner::best(&search).map(|s| path_length(scenario.grid.width(), &s.path))
}
