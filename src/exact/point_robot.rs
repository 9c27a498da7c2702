//! The shortest way of a point among the obstacles: no polyline through cell centres can be shorter, whatever the corner rule.
//!
//! Blocked cells and the world beyond the border are closed unit squares whose outline may be touched, but not crossed: the edge that two
//! of them share is inside. Where two touch at a corner only, the point squeezes through under the corner rule `always`, as the polylines
//! do; under `one-free` and `both-free`, and with 4 moves, no polyline does, so neither does the point. Under `both-free` a polyline keeps
//! off corners that the point may touch, with 4 moves it runs along rows and columns only: there the bound is less tight.
//!
//! The shortest way bends at convex corners of obstacles only (Lozano-Pérez, Wesley 1979, Communications of the ACM 22, 560–570), so A*
//! over these corners is exact: `geodesic.rs`. What sees what is told in half cells and whole numbers: `glance.rs`.

use super::geodesic::{To, spread};
use super::obstacles::Obstacles;
use crate::map::Weights;
use crate::scenario::Scenario;

/// Largest map in cells: 1024 × 1024, for which it holds up to 30 megabytes while it is at work.
pub const MOST_CELLS: usize = 1 << 20;

/// The map has too many cells for the point robot's way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("its bound is computed on maps of up to {most} cells; this one has {cells}")]
pub struct TooLarge {
    /// Cells of the map.
    pub cells: usize,
    /// [`MOST_CELLS`].
    pub most: usize,
}

/// Length in cells of the shortest way of a point from the centre of the start to the centre of the (first) goal; `None` when there is
/// none, which is when no polyline leads there either. On weighted ground times the smallest factor: no polyline costs less.
///
/// # Errors
/// [`TooLarge`] beyond [`MOST_CELLS`].
pub fn point_robot(scenario: &Scenario) -> Result<Option<f64>, TooLarge> {
    let cells = scenario.grid.len();
    if cells > MOST_CELLS {
        return Err(TooLarge { cells, most: MOST_CELLS });
    }
    let map = Obstacles::of(&scenario.grid, scenario.spec.movement);
    let mut way = To::new(&scenario.grid, scenario.goal);
    spread(&map, &scenario.grid, scenario.start, &mut way);
    let least = scenario.moves.weights().map_or(1.0, Weights::least);
    Ok(Some(way.length * least).filter(|length| length.is_finite()))
}

#[cfg(test)]
mod tests;
