//! What leads the search on a plane: how far a point among the obstacles has still to go from each cell, and a good way to begin with.
//!
//! What is left to go for a point is never longer than what is left for a polyline, and a segment in sight is a way of a point: so the estimate
//! is a lower bound and consistent, h(a) ≤ |ab| + h(b), up to rounding. So is the length by steps with 4 moves, of which polylines consist there.

use std::sync::Arc;

use crate::exact::best_first::Known;
use crate::exact::distances_from;
use crate::exact::geodesic::{Field, spread};
use crate::exact::obstacles::Obstacles;
use crate::exact::theta_star;
use crate::map::Moves;
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
        let scenario = Arc::new(scenario.clone());
        let (rest, seen) = rest(&scenario);
        let (known, tried) = theta_star::led(&scenario, Arc::clone(&rest), left.saturating_sub(seen));
        Self { rest, known, looked: seen + tried }
    }

    /// Without a way to begin with: who asks has one.
    pub(super) fn alone(scenario: &Arc<Scenario>) -> Self {
        let (rest, looked) = rest(scenario);
        Self { rest, known: None, looked }
    }
}

/// What is left to go from each cell, and how many cells were looked at to know it. With 4 moves a polyline is a path of steps.
fn rest(scenario: &Arc<Scenario>) -> (Arc<[f64]>, u64) {
    let cells = scenario.grid.len();
    if scenario.spec.movement.moves == Moves::Four {
        return (distances_from(scenario, scenario.goal).into(), cells as u64);
    }
    let mut field = Field::new(cells);
    let looked = spread(&Obstacles::of(&scenario.grid, scenario.spec.movement), &scenario.grid, scenario.goal, &mut field);
    (field.lengths.into(), looked)
}
