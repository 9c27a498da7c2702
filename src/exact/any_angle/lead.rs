//! What leads the search on a plane: how far a point among the obstacles has still to go from each cell, a good way to begin with, and the
//! cells that a better one can cross.
//!
//! What is left to go for a point is never longer than what is left for a polyline, and a segment in sight is a way of a point: so the estimate
//! is a lower bound and consistent, h(a) ≤ |ab| + h(b), up to rounding.
//!
//! A way of length U crosses no cell whose centre is √½ or more off all ways of that length: where a segment passes a free cell, a point
//! could go to the centre and back within it. So all other cells block the view as obstacles do, and nothing is lost.

use std::sync::Arc;

use crate::exact::best_first::Known;
use crate::exact::geodesic::{Field, spread};
use crate::exact::obstacles::Obstacles;
use crate::exact::theta_star;
use crate::map::Cell;
use crate::scenario::Scenario;

/// Twice the distance from a cell's centre to its corner, and some rounding.
const ASIDE: f64 = std::f64::consts::SQRT_2 + 1e-6;

/// What leads the search.
#[derive(Clone)]
pub(super) struct Lead {
    /// What is left to go from each cell, infinite where no way leads.
    pub(super) rest: Arc<[f64]>,
    /// A way to begin with; none where there is none, or the limit of work was reached.
    pub(super) known: Option<Known>,
    /// Cells that were looked at for all this.
    pub(super) looked: u64,
    /// How far it is to each cell, infinite where no better way than the known one leads.
    from_start: Arc<[f64]>,
    /// A better way is shorter.
    limit: f64,
}

impl Lead {
    /// Looks at about `left` cells at most to find a way to begin with.
    pub(super) fn of(scenario: &Scenario, left: u64) -> Self {
        let (grid, map) = (&scenario.grid, Obstacles::of(&scenario.grid, scenario.spec.movement));
        let mut back = Field { lengths: vec![f64::INFINITY; grid.len()], rest: &[], limit: f64::INFINITY };
        let from_goal = spread(&map, grid, scenario.goal, &mut back);
        let rest: Arc<[f64]> = back.lengths.into();
        let (known, tried) = theta_star::led(scenario, Arc::clone(&rest), left.saturating_sub(from_goal.looked));
        let limit = known.as_ref().map_or(f64::INFINITY, |known| known.length) + ASIDE;
        let mut there = Field { lengths: vec![f64::INFINITY; grid.len()], rest: &from_goal.corners, limit };
        let from_start = spread(&map, grid, scenario.start, &mut there);
        let looked = from_goal.looked + tried + from_start.looked;
        Self { rest, known, looked, from_start: there.lengths.into(), limit }
    }

    /// Whether a way that is no longer than the known one can cross a cell.
    pub(super) fn crosses(&self, cell: Cell) -> bool {
        self.from_start[cell as usize] + self.rest[cell as usize] < self.limit
    }
}
