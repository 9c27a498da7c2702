//! Searches, all but one with a proof: their results are the yardstick for everything else.

pub mod any_angle;
pub mod astar;
mod best_first;
mod contours;
pub mod d_star_lite;
pub mod dijkstra;
mod directed;
mod frontier;
mod geodesic;
mod glance;
mod growing;
mod jump_map;
mod jump_points;
mod obstacles;
mod optima;
pub mod order;
pub mod order_problem;
pub mod point_robot;
#[cfg(feature = "whole")]
mod proof;
mod region;
mod search;
mod sight;
pub mod slices;
pub mod theta_star;
pub mod tour;
pub mod turn_aware;
mod ways;
mod weighted;
mod within;

pub use any_angle::PolylinesWithin;
pub use astar::Distance;
pub use optima::Optima;
pub use order::distances_from;
pub use point_robot::point_robot;
pub use search::Estimate;
pub use slices::{SliceEstimate, SlicesWithin};
pub use within::Within;

use std::sync::Arc;

use serde::Serialize;

use crate::map::Cell;
use crate::metrics::{Metrics, WeightedSum};
use crate::params::Values;
use crate::path::Path;
use crate::planner::{Family, Ground, Layer, Objective, Planner, PlannerEntry};
use crate::scenario::Scenario;

/// What the entries of searches have in common: exact, from cell to cell, without parameters. Each gives its id, texts and `build`.
const SEARCH: PlannerEntry = PlannerEntry {
    id: "",
    name: "",
    family: Family::Exact,
    summary: "",
    source: "",
    presets: &[],
    components: &[],
    layers: &[Layer::Cost, Layer::Visits],
    max_goals: 1,
    grounds: Ground::STEPS,
    specs: Vec::new,
    build: |_, _, _| unreachable!("every search has a `build` of its own"),
};

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
    /// Whether no result can be better.
    pub fn is_proven(self) -> bool {
        matches!(self, Self::Proven { .. })
    }

    /// The value, proven or not.
    pub fn value(self) -> Option<f64> {
        match self {
            Self::Proven { value } | Self::Unproven { value } => Some(value),
            Self::NoPath | Self::Unknown => None,
        }
    }
}

/// The yardstick of an objective on a scenario. Objectives of planners with one goal look at the first.
///
/// ```
/// # use std::sync::Arc;
/// use formicarium::exact::{Reference, reference};
/// use formicarium::map::{Grid, Movement, Point};
/// use formicarium::{planner::Objective, scenario::Scenario};
///
/// let scenario = Scenario::on(Grid::open(4, 1)?, Movement::default(), Point::new(0, 0), Point::new(3, 0))?;
/// assert_eq!(reference(&Arc::new(scenario), Objective::Length), Reference::Proven { value: 3.0 });
/// # Ok::<(), formicarium::error::ScenarioError>(())
/// ```
pub fn reference(scenario: &Arc<Scenario>, objective: Objective) -> Reference {
    if objective == Objective::Length && scenario.goals.len() == 1 && scenario.by_slices().is_none() {
        return optimum(scenario).map_or(Reference::NoPath, |value| Reference::Proven { value });
    }
    if !scenario.reachable() {
        return Reference::NoPath;
    }
    // The opening build must stay small, and its planners are measured by their length alone.
    if !cfg!(feature = "whole") && objective != Objective::Length {
        return Reference::Unknown;
    }
    if (objective == Objective::SliceCost) != scenario.by_slices().is_some() {
        return Reference::Unknown;
    }
    let proven = match objective {
        Objective::Length => optimum(scenario),
        Objective::SliceCost => slices::optimum(scenario),
        Objective::TourLength => best_tour(scenario, false),
        Objective::TourWeight => best_tour(scenario, true),
        Objective::TurnIndex => solved(scenario, &turn_aware::ENTRY).map(|path| Metrics::of(scenario, &path).turn_index),
        Objective::PolylineLength => return polyline(scenario),
        // Which weights, the objective does not tell.
        Objective::Weighted => None,
    };
    proven.map_or(Reference::Unknown, |value| Reference::Proven { value })
}

/// The yardstick of the weighted sum by these weights, of a path to the first goal: proven on a plane with 4 or 8 moves. On a terrain, where
/// climbs are no sum over cells and directions, and with 16 moves nothing is known.
pub fn weighted_reference(scenario: &Arc<Scenario>, sum: WeightedSum) -> Reference {
    if !scenario.reachable() {
        return Reference::NoPath;
    }
    if !cfg!(feature = "whole") || Ground::of(scenario) != Ground::Plane {
        return Reference::Unknown;
    }
    let mut search = weighted::search(scenario, sum);
    search.run();
    let value = search.weighed().and_then(|weighed| weighed.value);
    value.map_or(Reference::Unknown, |value| Reference::Proven { value })
}

/// The yardstick of what a planner makes small on its scenario.
pub fn reference_of(scenario: &Arc<Scenario>, objective: Objective, sum: Option<WeightedSum>) -> Reference {
    match sum.filter(|_| objective == Objective::Weighted) {
        Some(sum) => weighted_reference(scenario, sum),
        None => reference(scenario, objective),
    }
}

/// Length in cells of the shortest path of steps from cell to cell; `None` when there is none. [`Optima`] answers many questions about one
/// map faster.
pub fn optimum(scenario: &Arc<Scenario>) -> Option<f64> {
    let (start, goal) = (scenario.start, scenario.goal);
    // The opening build has A* anyway and is spared the rest.
    if cfg!(feature = "whole") { Optima::new(scenario).between(start, goal) } else { optima::by_astar(scenario, start, goal).0 }
}

/// 1-trees after which the best order of many goals is not looked for any more just to compare with it.
const MOST_TREES_TO_COMPARE: u64 = 4_000;

/// Σ of the legs of the best tour by all goals, or Σ R; `None` where the best order of more than [`order::MAX_ORDERED`] is not soon proven.
fn best_tour(scenario: &Arc<Scenario>, weighted: bool) -> Option<f64> {
    let lengths = order::Costs::grid(scenario);
    let costs = if weighted { lengths.weighted(scenario) } else { lengths };
    let shape = order::Shape::Open;
    if let Some(order) = order::held_karp(&costs, shape) {
        return Some(costs.total(&order, shape));
    }
    let mut search = order::OrderSearch::new(&costs, shape, &order::good_order(&costs, shape))?;
    search.go_on(MOST_TREES_TO_COMPARE).then(|| search.cost())
}

/// Largest map in cells for which polylines are looked for just to compare with them: half a second.
const MOST_CELLS_TO_COMPARE: usize = 1 << 20;

/// The shortest polyline where it can be proven, else a good one: on a large terrain, whose ground Theta* does not know, the shortest path of
/// steps. On weighted ground nothing is proven: a dearest cell may be passed at any angle.
fn polyline(scenario: &Arc<Scenario>) -> Reference {
    let cells = scenario.grid.len();
    if cells > MOST_CELLS_TO_COMPARE {
        return Reference::Unknown;
    }
    if scenario.moves.is_plain() {
        return any_angle::reference(scenario);
    }
    let weighted = scenario.moves.weights().is_some();
    let proven = cells <= any_angle::MOST_CELLS_OF_TERRAIN && !weighted;
    let entry = match (proven, weighted) {
        (true, _) => &any_angle::ENTRY,
        (false, true) => &theta_star::ENTRY,
        (false, false) => &astar::ENTRY,
    };
    let value = solved(scenario, entry).map(|path| scenario.path_length(&path));
    value.map_or(Reference::Unknown, |value| if proven { Reference::Proven { value } } else { Reference::Unproven { value } })
}

/// The path of a search without parameters; none where it refuses the map or does not know how one moves there.
fn solved(scenario: &Arc<Scenario>, entry: &PlannerEntry) -> Option<Path> {
    if !Ground::all_of(scenario).all(|ground| entry.grounds.contains(&ground)) {
        return None;
    }
    let mut planner = (entry.build)(scenario, &Values::new(), 0).ok()?;
    planner.run();
    planner.best().map(|best| best.path.clone())
}

/// Straight distance between two cells' centres, in cells.
#[inline]
fn euclidean(scenario: &Scenario, a: Cell, b: Cell) -> f64 {
    scenario.grid.point(a).distance(scenario.grid.point(b))
}
