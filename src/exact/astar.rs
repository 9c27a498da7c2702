//! Hart, Nilsson, Raphael, "A formal basis for the heuristic determination of minimum cost paths", IEEE Transactions on Systems Science
//! and Cybernetics 4 (1968) 100–107.
//!
//! Estimate: octile distance with 8 moves, Manhattan distance with 4. Both are consistent under every corner rule, because a stricter
//! rule only removes steps; so the length is exact.

use std::f64::consts::SQRT_2;
use std::sync::Arc;

use super::search::{Estimate, Search};
use crate::error::ParamError;
use crate::map::{Cell, Moves, Point};
use crate::params::{Values, check_keys};
use crate::planner::{Entry, Family, Layer, Planner};
use crate::scenario::Scenario;

/// Length of the shortest path on an open map: Σ of both axes, less what each diagonal step saves.
pub struct Distance {
    goal: Point,
    saved_by_diagonal: f64,
}

impl Distance {
    /// To the scenario's goal, with its number of moves.
    pub fn of(scenario: &Scenario) -> Self {
        Self::to(scenario, scenario.goal)
    }

    /// To any cell of the scenario's map.
    pub fn to(scenario: &Scenario, goal: Cell) -> Self {
        let saved_by_diagonal = match scenario.spec.movement.moves {
            Moves::Four => 0.0,
            Moves::Eight => 2.0 - SQRT_2,
        };
        Self { goal: scenario.grid.point(goal), saved_by_diagonal }
    }
}

impl Estimate for Distance {
    #[inline(always)]
    fn to_goal(&self, x: u32, y: u32) -> f64 {
        let (dx, dy) = (x.abs_diff(self.goal.x), y.abs_diff(self.goal.y));
        f64::from(dx + dy) - self.saved_by_diagonal * f64::from(dx.min(dy))
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    check_keys(ENTRY.id, &[], values)?;
    Ok(Box::new(Search::new(Arc::clone(scenario), Distance::of(scenario))))
}

/// A* in the catalog.
pub const ENTRY: Entry = Entry {
    id: "astar",
    name: "A*",
    family: Family::Exact,
    summary: "Explores by cost so far plus a lower bound of what remains; always the shortest path, usually with fewer cells.",
    source: "Hart, Nilsson, Raphael 1968, IEEE Trans. Systems Science and Cybernetics 4, 100–107, doi:10.1109/TSSC.1968.300136",
    presets: &[],
    layers: &[Layer::Cost, Layer::Visits],
    max_goals: 1,
    specs: Vec::new,
    build,
};
