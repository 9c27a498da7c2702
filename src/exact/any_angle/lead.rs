//! What leads the search on a plane: how far a point among the obstacles has still to go from each cell, and a good way to begin with.
//!
//! What is left to go for a point is never longer than what is left for a polyline, and a segment in sight is a way of a point: so the estimate
//! is a lower bound and consistent, h(a) ≤ |ab| + h(b), up to rounding.

use std::sync::Arc;

use crate::exact::best_first::Known;
use crate::exact::geodesic::{Field, spread};
use crate::exact::obstacles::Obstacles;
use crate::exact::theta_star;
use crate::scenario::Scenario;

/// What leads the search.
#[derive(Clone)]
pub(super) struct Lead {
    /// What is left to go from each cell, infinite where no way leads.
    pub(super) rest: Arc<[f64]>,
    /// A way to begin with; none where there is none, or the limit of work was reached.
    pub(super) known: Option<Known>,
    /// Cells that were looked at for all this.
    pub(super) looked: u64,
}

impl Lead {
    /// Looks at about `left` cells at most to find a way to begin with.
    pub(super) fn of(scenario: &Scenario, left: u64) -> Self {
        let map = Obstacles::of(&scenario.grid, scenario.spec.movement);
        let mut field = Field::new(scenario.grid.len());
        let seen = spread(&map, &scenario.grid, scenario.goal, &mut field);
        let rest: Arc<[f64]> = field.lengths.into();
        let (known, tried) = theta_star::led(scenario, Arc::clone(&rest), left.saturating_sub(seen));
        Self { rest, known, looked: seen + tried }
    }
}
