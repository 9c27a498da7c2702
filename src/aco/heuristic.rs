//! What an ant can see: η of a step from cell i to its neighbour j.

use crate::exact::{Distance, Estimate};
use crate::map::{Cell, Direction, Point, step_length};
use crate::param_choice;
use crate::scenario::Scenario;

param_choice! {
    /// Which η.
    pub enum Heuristic {
        /// η = 1 / (1 + c_ij + d(j, goal) − d(i, goal)): how small the detour is; d is the length on an open map
        Detour = "detour",
        /// η = 1 / d(j, goal), Euclidean: the reading of most papers; flat far from the goal, so ants get lost on big maps
        Goal = "goal",
        /// η = 1 / d_ij, the step's own length: as printed in some papers; only prefers straight steps
        Step = "step",
    }
}

/// d(goal, goal) where a formula divides by it: η = 100 at the goal.
pub use crate::planner::AT_GOAL;

/// η by goal distance: 1 / d(j, goal), Euclidean, on a terrain as on its map; `at_goal` stands for the distance 0.
pub fn goal_distance(j: Point, goal: Point, at_goal: f64) -> f64 {
    1.0 / j.distance(goal).max(at_goal)
}

/// An η that knows nothing of factors, on weighted ground: over the step's factor, so that of two steps that are seen equally well the
/// cheaper one is seen better. No publication plans on weighted ground: this is ours. On any other ground it stays.
pub fn per_factor(scenario: &Scenario, i: Cell, d: Direction, j: Cell, eta: f64) -> f64 {
    scenario.moves.weights().map_or(eta, |weights| eta * step_length(d) / weights.step(i, j, d))
}

/// η by detour: 1 / (1 + c_ij + d(j) − d(i)), c_ij = length of the step, d = length of the shortest path on an open map; on
/// weighted ground c_ij is the step's cost and d counts the smallest factor of the map. On a plane
/// between 1/(1 + 2√2) and 1.
pub fn detour(distance: &Distance, i: Point, j: Point, step: f64) -> f64 {
    let extra = step + distance.to_goal(j.x, j.y) - distance.to_goal(i.x, i.y);
    1.0 / (1.0 + extra.max(0.0))
}

impl Heuristic {
    /// η of the step in direction `d` from cell `i` to cell `j`; positive and finite.
    pub fn of(self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        let (from, to) = (scenario.grid.point(i), scenario.grid.point(j));
        match self {
            Self::Detour => detour(&Distance::of(scenario), from, to, scenario.moves.length(i, d)),
            Self::Goal => per_factor(scenario, i, d, j, goal_distance(to, scenario.grid.point(scenario.goal), AT_GOAL)),
            Self::Step => 1.0 / scenario.moves.length(i, d),
        }
    }
}
