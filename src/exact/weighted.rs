//! The path of steps with the smallest weighted sum J ([`WeightedSum`]) on a plane. A* over states of a cell and the direction of the step that
//! led there: length, turns, angles and closeness to obstacles are all known of a step and the one before it, so that J is a sum over states.
//! The estimate is the octile or Manhattan distance times what a cell of straight way in the open costs. (Dijkstra 1959 and Hart, Nilsson,
//! Raphael 1968 on this graph.)
//!
//! Of the states of a cell the first expanded has the least J. Another one can save at most what the dearest turn costs, and is left out
//! where that is not enough.

use std::sync::Arc;

use super::best_first::{BestFirst, Rules, State, Tree};
use super::directed::{Costs, SumCosts};
use crate::map::{Cell, DIRECTIONS, Direction};
use crate::metrics::{SAME_LENGTH, WeightedSum};
use crate::planner::{Objective, Status, held};
use crate::scenario::Scenario;

/// A cell's state at the start, which no step led to.
const NO_DIRECTION: Direction = DIRECTIONS as Direction;

/// The rules of the search: states are cell · 9 + direction.
#[derive(Clone)]
pub(super) struct Weighted {
    costs: SumCosts,
    /// J at the first expansion by cell.
    first: Vec<f64>,
}

impl Weighted {
    /// Whether a way of this J to a cell can still be better than the first one there.
    fn may_save(&self, cell: Cell, j: f64) -> bool {
        // Of an infinite first one everything may.
        j < self.first[cell as usize] + self.costs.dearest_turn() - SAME_LENGTH
    }
}

impl Rules for Weighted {
    const OBJECTIVE: Objective = Objective::Weighted;
    const FOUND: Status = Status::Optimal;
    const STATES_PER_CELL: u32 = DIRECTIONS as u32 + 1;

    fn prepare(&mut self, scenario: &Scenario) {
        self.costs.prepare(scenario);
        self.first = vec![f64::INFINITY; scenario.grid.len()];
    }

    fn bytes(&self) -> usize {
        held(&self.first) + self.costs.bytes()
    }

    fn sum(&self) -> Option<WeightedSum> {
        Some(self.costs.sum())
    }

    fn start(&self, scenario: &Scenario) -> State {
        scenario.start * Self::STATES_PER_CELL + State::from(NO_DIRECTION)
    }

    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64 {
        self.costs.to_goal(scenario, cell)
    }

    fn expand(&mut self, scenario: &Scenario, state: State, tree: &mut Tree) {
        let (cell, came) = (state / Self::STATES_PER_CELL, (state % Self::STATES_PER_CELL) as Direction);
        let g = tree.g(state);
        if self.first[cell as usize].is_infinite() {
            self.first[cell as usize] = g;
        } else if !self.may_save(cell, g) {
            return;
        }
        let came = (came != NO_DIRECTION).then_some(came);
        for d in scenario.moves.directions(cell) {
            let next = scenario.moves.step(cell, d);
            let j = g + self.costs.step(scenario, cell, came, d);
            if self.may_save(next, j) {
                let to = next * Self::STATES_PER_CELL + State::from(d);
                tree.relax(to, j, self.costs.to_goal(scenario, next), state, next == scenario.goal);
            }
        }
    }
}

/// The search for the least J; only on a plane.
pub(super) fn search(scenario: &Arc<Scenario>, sum: WeightedSum) -> BestFirst<Weighted> {
    let rules = Weighted { costs: SumCosts::new(scenario, sum), first: Vec::new() };
    BestFirst::new(Arc::clone(scenario), rules)
}
