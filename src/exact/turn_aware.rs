//! The path of steps with the smallest turn index V(d, r) = Σ dᵢ·rᵢ, rᵢ = 1.2 where step i turns, else 1: equation (10) of the
//! fire-fighting paper. A* over states of a cell and the direction of the step that led there, by the octile or Manhattan distance, which
//! V cannot undercut; so V is exact. On weighted ground dᵢ is what step i costs. (Dijkstra 1959 and Hart, Nilsson, Raphael 1968 on this graph.)
//!
//! Of the states of a cell the first expanded has the least V. Another one can save at most the surcharge of the next step, and only
//! straight on: every other step costs the first state no more. So the others are followed straight on alone, while they save anything.
//!
//! With `criterion=weighted-sum` it is the search of `weighted.rs`.

use std::sync::Arc;

use super::SEARCH;
use super::best_first::{BestFirst, Rules, State, Tree};
use super::directed::{Costs, TurnCosts};
use super::weighted;
use crate::error::ParamError;
use crate::map::{Cell, DIRECTIONS, Direction};
use crate::metrics::{SAME_LENGTH, TURN_WEIGHT, WeightedSum};
use crate::params::{Params, Values};
use crate::planner::{Ground, Objective, Planner, PlannerEntry, Status, held};
use crate::scenario::Scenario;
use crate::{param_choice, params};

param_choice! {
    /// What is made small.
    pub enum Criterion {
        /// V(d, r), the length in which a turning step counts 1.2 times: equation 10 of the fire-fighting paper
        TurnIndex = "turn-index",
        /// J, the weighted sum of length, turns, closeness to obstacles and energy: our addition
        Weighted = "weighted-sum",
    }
}

params! {
    /// Parameters of the turn-aware search.
    pub struct TurnAwareParams {
        /// what makes one path better than another
        criterion: Criterion = Criterion::TurnIndex, "", [], "", "our addition";
        ..sum: WeightedSum;
    }
}

/// A cell's state at the start, which no step led to.
const NO_DIRECTION: Direction = DIRECTIONS as Direction;

/// The rules of the search: states are cell · 9 + direction.
#[derive(Clone)]
struct TurnAware {
    costs: TurnCosts,
    /// V at the first expansion by cell.
    first: Vec<f64>,
}

impl TurnAware {
    /// Relaxes the step in direction `d`; `came` is the direction of the step before.
    fn step(&self, scenario: &Scenario, state: State, came: Direction, d: Direction, tree: &mut Tree) {
        let cell = state / Self::STATES_PER_CELL;
        let next = scenario.moves.step(cell, d);
        let came = (came != NO_DIRECTION).then_some(came);
        let v = tree.g(state) + self.costs.step(scenario, cell, came, d);
        let to = next * Self::STATES_PER_CELL + State::from(d);
        if tree.is_cheaper(to, v) && self.may_save(scenario, next, d, v) {
            tree.relax(to, v, self.to_goal(scenario, next), state, next == scenario.goal);
        }
    }

    /// Whether a way of this V that enters a cell in direction `d` can still be better than the first one there: straight on.
    fn may_save(&self, scenario: &Scenario, cell: Cell, d: Direction, v: f64) -> bool {
        let first = self.first[cell as usize];
        let straight_on = scenario.moves.bits[cell as usize] >> d & 1 == 1;
        first.is_infinite() || (straight_on && v < first + (TURN_WEIGHT - 1.0) * scenario.moves.length(cell, d) - SAME_LENGTH)
    }
}

impl Rules for TurnAware {
    const OBJECTIVE: Objective = Objective::TurnIndex;
    const FOUND: Status = Status::Optimal;
    const STATES_PER_CELL: u32 = DIRECTIONS as u32 + 1;

    fn prepare(&mut self, scenario: &Scenario) {
        self.first = vec![f64::INFINITY; scenario.grid.len()];
    }

    fn bytes(&self) -> usize {
        held(&self.first)
    }

    fn start(&self, scenario: &Scenario) -> State {
        scenario.start * Self::STATES_PER_CELL + State::from(NO_DIRECTION)
    }

    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64 {
        self.costs.to_goal(scenario, cell)
    }

    fn expand(&mut self, scenario: &Scenario, state: State, tree: &mut Tree) {
        let (cell, came) = (state / Self::STATES_PER_CELL, (state % Self::STATES_PER_CELL) as Direction);
        if self.first[cell as usize].is_infinite() {
            self.first[cell as usize] = tree.g(state);
            scenario.moves.directions(cell).for_each(|d| self.step(scenario, state, came, d, tree));
        } else if self.may_save(scenario, cell, came, tree.g(state)) {
            self.step(scenario, state, came, came, tree);
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let params = TurnAwareParams::read(ENTRY.id, values)?;
    if params.criterion == Criterion::Weighted {
        return Ok(Box::new(weighted::search(scenario, params.sum)));
    }
    let rules = TurnAware { costs: TurnCosts::new(scenario), first: Vec::new() };
    Ok(Box::new(BestFirst::new(Arc::clone(scenario), rules)))
}

/// The turn-aware search in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "turn-aware",
    name: "Turn-aware A*",
    summary: "Explores cells by the direction in which they are entered; always the path with the smallest turn index V, in which a turning step counts 1.2 times, or with the smallest weighted sum J.",
    source: "V(d, r): the fire-fighting paper, equation (10); the search is ours: A* (Hart, Nilsson, Raphael 1968) on (cell, direction)",
    grounds: Ground::WEIGHTED_PLANE,
    specs: TurnAwareParams::specs,
    build,
    ..SEARCH
};
