//! The path of steps with the smallest weighted sum J ([`WeightedSum`]) on a plane. A* over states of a cell and the direction of the step that
//! led there: length, turns, angles and closeness to obstacles are all known of a step and the one before it, so that J is a sum over states.
//! The estimate is the octile or Manhattan distance times what a cell of straight way in the open costs. (Dijkstra 1959 and Hart, Nilsson,
//! Raphael 1968 on this graph.)
//!
//! Of the states of a cell the first expanded has the least J. Another one can save at most what the dearest turn costs, and is left out
//! where that is not enough.

use std::f64::consts::PI;
use std::sync::Arc;

use super::astar::Distance;
use super::best_first::{BestFirst, Rules, State, Tree};
use super::search::Estimate;
use crate::map::{Cell, DIRECTIONS, Direction, Weights, offset, step_length};
use crate::metrics::{SAME_LENGTH, WeightedSum, angle, energy_rates};
use crate::planner::{Objective, Status, held};
use crate::scenario::Scenario;

/// A cell's state at the start, which no step led to.
const NO_DIRECTION: Direction = DIRECTIONS as Direction;

/// The rules of the search: states are cell · 9 + direction.
#[derive(Clone)]
pub(super) struct Weighted {
    sum: WeightedSum,
    /// What a cell of way and a radian of turning take.
    energy: [f64; 3],
    distance: Distance,
    /// What a turn costs, by the directions of the steps before and after it.
    turns: [[f64; DIRECTIONS]; DIRECTIONS],
    /// What a cell of way costs beyond its length because obstacles are near, by cell.
    closeness: Vec<f64>,
    /// J at the first expansion by cell.
    first: Vec<f64>,
}

impl Weighted {
    fn new(scenario: &Scenario, sum: WeightedSum) -> Self {
        let energy = energy_rates(scenario);
        let turn = |a, b| turn(&sum, energy[1], a as Direction, b as Direction);
        let turns = std::array::from_fn(|a| std::array::from_fn(|b| turn(a, b)));
        Self { sum, energy, distance: Distance::of(scenario), turns, closeness: Vec::new(), first: Vec::new() }
    }

    /// What the length of a cell of way takes in energy, whatever its factor.
    fn energy_rate(&self) -> f64 {
        self.sum.energy_weight * self.energy[0]
    }

    /// What the step in direction `d` adds to J; `came` is the direction of the step before.
    fn cost(&self, scenario: &Scenario, cell: Cell, came: Direction, d: Direction, next: Cell) -> f64 {
        let near = 0.5 * (self.closeness[cell as usize] + self.closeness[next as usize]);
        let turn = if came == NO_DIRECTION { 0.0 } else { self.turns[came as usize][d as usize] };
        self.sum.length_weight * scenario.moves.length(cell, d) + (self.energy_rate() + near) * step_length(d) + turn
    }

    /// Whether a way of this J to a cell can still be better than the first one there.
    fn may_save(&self, cell: Cell, j: f64) -> bool {
        let dearest = self.sum.turn_weight + self.sum.energy_weight * self.energy[1] * PI;
        // Of an infinite first one everything may.
        j < self.first[cell as usize] + dearest - SAME_LENGTH
    }
}

/// What a turn from one direction to another costs.
fn turn(sum: &WeightedSum, radian: f64, before: Direction, after: Direction) -> f64 {
    if before == after {
        return 0.0;
    }
    sum.turn_weight + sum.energy_weight * radian * angle(offset(before), offset(after))
}

impl Rules for Weighted {
    const OBJECTIVE: Objective = Objective::Weighted;
    const FOUND: Status = Status::Optimal;
    const STATES_PER_CELL: u32 = DIRECTIONS as u32 + 1;

    fn prepare(&mut self, scenario: &Scenario) {
        let weight = self.sum.clearance_weight;
        let near = |cell| if weight > 0.0 { weight * self.sum.shortfall(&scenario.grid, cell) } else { 0.0 };
        self.closeness = (0..scenario.grid.len() as Cell).map(near).collect();
        self.first = vec![f64::INFINITY; scenario.grid.len()];
    }

    fn bytes(&self) -> usize {
        held(&self.first) + held(&self.closeness)
    }

    fn sum(&self) -> Option<WeightedSum> {
        Some(self.sum)
    }

    fn start(&self, scenario: &Scenario) -> State {
        scenario.start * Self::STATES_PER_CELL + State::from(NO_DIRECTION)
    }

    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64 {
        let at = scenario.grid.point(cell);
        // The distance counts the smallest factor of weighted ground, which energy does not know.
        let least = scenario.moves.weights().map_or(1.0, Weights::least);
        (self.sum.length_weight + self.energy_rate() / least) * self.distance.to_goal(at.x, at.y)
    }

    fn expand(&mut self, scenario: &Scenario, state: State, tree: &mut Tree) {
        let (cell, came) = (state / Self::STATES_PER_CELL, (state % Self::STATES_PER_CELL) as Direction);
        let g = tree.g(state);
        if self.first[cell as usize].is_infinite() {
            self.first[cell as usize] = g;
        } else if !self.may_save(cell, g) {
            return;
        }
        for d in scenario.moves.directions(cell) {
            let next = scenario.moves.step(cell, d);
            let j = g + self.cost(scenario, cell, came, d, next);
            if self.may_save(next, j) {
                let to = next * Self::STATES_PER_CELL + State::from(d);
                tree.relax(to, j, self.to_goal(scenario, next), state, next == scenario.goal);
            }
        }
    }
}

/// The search for the least J; only on a plane.
pub(super) fn search(scenario: &Arc<Scenario>, sum: WeightedSum) -> BestFirst<Weighted> {
    let rules = Weighted::new(scenario, sum);
    BestFirst::new(Arc::clone(scenario), rules)
}
