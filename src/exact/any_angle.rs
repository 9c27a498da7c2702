//! The shortest polyline through centres of free cells, consecutive ones in line of sight: the yardstick of refined and any-angle paths.
//!
//! A* in which every cell is a neighbour of every cell that it sees. No smaller graph would do: bends lie on centres, obstacles' corners
//! do not, so the best bend is where a centre happens to let the next segment pass the corner by a hair, and that may be far from every
//! obstacle (`tests/exact.rs` has such a map). On a plane `exact/sight.rs` tells all cells that a cell sees, in little more time than it takes
//! to list them. The estimate is what a point among the obstacles has still to go (`any_angle/lead.rs`), on small maps the straight line to
//! the goal; both are consistent, so the length is exact. A way of Theta* that the same estimate leads is known beforehand, and no cell
//! is looked at behind which there can be no better one (`any_angle/in_sight.rs`).
//!
//! The work still grows with how much is seen from how many cells: hence the limit of [`MOST_CELLS`], and the search ends when it has looked at
//! [`MOST_LOOKED_AT`] of them, as a run whose budget is spent, with the best way to the goal that it then knows. The smallest f of its
//! open cells is then a lower bound, which its certificate tells. `theta-star` takes any map.
//!
//! On a terrain segments follow the ground, which is no shorter than the straight line through the air: that one is the estimate, and what
//! tells whether a segment is worth following. Bends lie on cells that can be reached by steps, as those of every refined path do; with a
//! limit of slope an oblique segment may be passable where no step is. There sight is tried pair by pair, last and only where it would
//! shorten a way, on terrains of up to [`MOST_CELLS_OF_TERRAIN`].

mod in_sight;
mod lead;
mod over_ground;
mod within;

use std::sync::Arc;

use self::in_sight::InSight;
use self::over_ground::OverGround;
pub use self::within::PolylinesWithin;
use super::best_first::BestFirst;
use super::{Reference, SEARCH};
use crate::error::ParamError;
use crate::params::{Values, check_keys};
use crate::planner::{Ground, Planner, PlannerEntry, Status};
use crate::scenario::Scenario;

/// Largest plane in cells, free or not: 1024 × 1024, for which the search holds up to a quarter of a gigabyte.
pub const MOST_CELLS: usize = 1 << 20;

/// Largest terrain in cells, free or not: 64 × 64.
pub const MOST_CELLS_OF_TERRAIN: usize = 64 * 64;

/// Cells at which a search on a plane looks at most: some seconds.
const MOST_LOOKED_AT: u64 = 1 << 30;

/// Cells at which a search looks at most just to compare with its result: about a second.
const MOST_LOOKED_AT_TO_COMPARE: u64 = 1 << 27;

/// The yardstick of polylines on a plane: proven, unless the limit of work is reached before.
pub(super) fn reference(scenario: &Arc<Scenario>) -> Reference {
    let mut search = BestFirst::new(Arc::clone(scenario), InSight::new(scenario, MOST_LOOKED_AT_TO_COMPARE));
    let status = search.run();
    match (search.best().map(|best| best.length), status) {
        (Some(value), Status::Optimal) => Reference::Proven { value },
        (Some(value), _) => Reference::Unproven { value },
        (None, Status::NoPath) => Reference::NoPath,
        (None, _) => Reference::Unknown,
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    check_keys(ENTRY.id, &[], values)?;
    let on_plane = scenario.moves.relief().is_none();
    let (most, instead) = if on_plane { (MOST_CELLS, "theta-star") } else { (MOST_CELLS_OF_TERRAIN, "astar") };
    if scenario.grid.len() > most {
        let (width, height) = (scenario.grid.width(), scenario.grid.height());
        return Err(ParamError::MapTooLarge { planner: ENTRY.id.into(), width, height, most: most as u32, instead });
    }
    let scenario = Arc::clone(scenario);
    if on_plane {
        let rules = InSight::new(&scenario, MOST_LOOKED_AT);
        Ok(Box::new(BestFirst::new(scenario, rules)))
    } else {
        Ok(Box::new(BestFirst::new(scenario, OverGround::default())))
    }
}

/// The any-angle optimum in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "any-angle",
    name: "Any-angle optimum",
    summary: "A* over all pairs of cells that see each other; always the shortest polyline through cell centres, on planes of up to 1024 × 1024 cells within a limit of work, on terrains of up to 64 × 64.",
    source: "ours: A* (Hart, Nilsson, Raphael 1968) on the graph of all cells in line of sight",
    grounds: Ground::LENGTHS,
    build,
    ..SEARCH
};

#[cfg(test)]
mod tests;
