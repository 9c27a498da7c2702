//! What paths cost where a step's cost depends on the step before: the turn index V(d, r) and the weighted sum J.
//!
//! Both are sums over states of a cell and the direction of the step that led there, on every ground where one moves by steps.

mod growing;

use std::f64::consts::PI;

use super::astar::Distance;
use super::search::Estimate;
use crate::map::{ALL_DIRECTIONS, Cell, Direction, Weights, offset, step_length};
use crate::metrics::{TURN_WEIGHT, WeightedSum, angle, energy_rates, turn_index};
use crate::planner::held;
use crate::scenario::Scenario;

pub(super) use growing::Directed;

/// What a path costs, step by step.
pub(super) trait Costs: Clone + Send + Sync + 'static {
    /// What the step in direction `d` from a cell adds; `came` is the direction of the step before, none at the start.
    fn step(&self, scenario: &Scenario, cell: Cell, came: Option<Direction>, d: Direction) -> f64;
    /// A lower bound of the cost from a cell to the goal, whatever led there.
    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64;
    /// The most that a step from a cell can be cheaper after one in direction `came` than after another in direction `lead`.
    fn saves(&self, scenario: &Scenario, cell: Cell, lead: Direction, came: Direction) -> f64;
    /// What a path costs, as it is measured.
    fn of(&self, scenario: &Scenario, path: &[Cell]) -> f64;
    /// What its tables hold, in bytes.
    fn bytes(&self) -> usize {
        0
    }
}

/// V(d, r).
#[derive(Clone)]
pub(super) struct TurnCosts {
    distance: Distance,
}

impl TurnCosts {
    pub(super) fn new(scenario: &Scenario) -> Self {
        Self { distance: Distance::of(scenario) }
    }
}

impl Costs for TurnCosts {
    #[inline]
    fn step(&self, scenario: &Scenario, cell: Cell, came: Option<Direction>, d: Direction) -> f64 {
        let turns = came.is_some_and(|came| came != d);
        scenario.moves.length(cell, d) * if turns { TURN_WEIGHT } else { 1.0 }
    }

    #[inline]
    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64 {
        let width = scenario.grid.width();
        self.distance.to_goal(cell % width, cell / width)
    }

    /// The surcharge of the step straight on, where there is one: every other step turns after `came` as well.
    #[inline]
    fn saves(&self, scenario: &Scenario, cell: Cell, _lead: Direction, came: Direction) -> f64 {
        let straight_on = scenario.moves.all_bits(cell) >> came & 1 == 1;
        if straight_on { (TURN_WEIGHT - 1.0) * scenario.moves.length(cell, came) } else { 0.0 }
    }

    fn of(&self, scenario: &Scenario, path: &[Cell]) -> f64 {
        turn_index(scenario, path)
    }
}

/// J.
#[derive(Clone)]
pub(super) struct SumCosts {
    sum: WeightedSum,
    /// What a cell of way, a radian of turning and a cell up take.
    energy: [f64; 3],
    distance: Distance,
    /// What a turn costs, by the directions of the steps before and after it.
    turns: [[f64; ALL_DIRECTIONS]; ALL_DIRECTIONS],
    /// What a cell of way costs beyond its length because obstacles are near, by cell; empty until it is prepared.
    closeness: Vec<f64>,
}

impl SumCosts {
    pub(super) fn new(scenario: &Scenario, sum: WeightedSum) -> Self {
        let energy = energy_rates(scenario);
        let turn = |a, b| turn(&sum, energy[1], a as Direction, b as Direction);
        let turns = std::array::from_fn(|a| std::array::from_fn(|b| turn(a, b)));
        Self { sum, energy, distance: Distance::of(scenario), turns, closeness: Vec::new() }
    }

    /// Looks how near the obstacles of every cell are.
    pub(super) fn prepare(&mut self, scenario: &Scenario) {
        let weight = self.sum.clearance_weight;
        let near = |cell| if weight > 0.0 { weight * self.sum.shortfall(&scenario.grid, cell) } else { 0.0 };
        self.closeness = (0..scenario.grid.len() as Cell).map(near).collect();
    }

    pub(super) fn sum(&self) -> WeightedSum {
        self.sum
    }

    /// The most that a turn can cost.
    pub(super) fn dearest_turn(&self) -> f64 {
        self.sum.turn_weight + self.sum.energy_weight * self.energy[1] * PI
    }

    /// What the length of a cell of way takes in energy, whatever its factor.
    fn energy_rate(&self) -> f64 {
        self.sum.energy_weight * self.energy[0]
    }

    /// What a step on a terrain takes in energy.
    fn over_ground(&self, scenario: &Scenario, cell: Cell, d: Direction) -> Option<f64> {
        let ground = scenario.moves.relief()?.step(cell, scenario.moves.step(cell, d), d);
        Some(self.energy_rate() * ground.length + self.sum.energy_weight * self.energy[2] * ground.climb)
    }
}

/// What a turn from one direction to another costs.
fn turn(sum: &WeightedSum, radian: f64, before: Direction, after: Direction) -> f64 {
    if before == after {
        return 0.0;
    }
    sum.turn_weight + sum.energy_weight * radian * angle(offset(before), offset(after))
}

impl Costs for SumCosts {
    #[inline]
    fn step(&self, scenario: &Scenario, cell: Cell, came: Option<Direction>, d: Direction) -> f64 {
        let next = scenario.moves.step(cell, d);
        let near = 0.5 * (self.closeness[cell as usize] + self.closeness[next as usize]);
        let turn = came.map_or(0.0, |came| self.turns[came as usize][d as usize]);
        let length = self.sum.length_weight * scenario.moves.length(cell, d);
        match self.over_ground(scenario, cell, d) {
            Some(energy) => length + near * step_length(d) + energy + turn,
            None => length + (self.energy_rate() + near) * step_length(d) + turn,
        }
    }

    #[inline]
    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64 {
        let width = scenario.grid.width();
        // The distance counts the smallest factor of weighted ground, which energy does not know.
        let least = scenario.moves.weights().map_or(1.0, Weights::least);
        (self.sum.length_weight + self.energy_rate() / least) * self.distance.to_goal(cell % width, cell / width)
    }

    /// A turn from `lead` to `came`: no step costs more after `lead` than this turn and the step after `came`, angles being distances.
    fn saves(&self, _scenario: &Scenario, _cell: Cell, lead: Direction, came: Direction) -> f64 {
        self.turns[lead as usize][came as usize]
    }

    fn of(&self, scenario: &Scenario, path: &[Cell]) -> f64 {
        self.sum.of(scenario, path)
    }

    fn bytes(&self) -> usize {
        held(&self.closeness)
    }
}
