//! From priorities to a path: Zhou, Mu, Zhang 2019, Eq. 1.
//!
//! From the start on, the next cell is the one with the largest P(j) = a_j·L(j, e) / Σ_k a_k·L(k, e) among the allowed neighbours, L being
//! 1 / (distance to the goal). The sum is common to all candidates, so the largest a_j·L(j, e) decides; the first in order of directions
//! of equal ones. Allowed is what this path has not visited. Where nothing is left the path steps back, cell by cell, until something is,
//! and what it left stays visited: so it reaches every goal that can be reached. At the goal L would be 1 / 0: a goal that is allowed is
//! taken (`decode_goal`), or L is 1 / 0.01 there, and its priority counts as any other.
//!
//! Priorities lie between the limits of Eq. 6. Their ratio decides how far a path may leave the greedy one, which goes to the nearest cell
//! to the goal: a cell is preferred to one that is nearer by at most x_max / x_min.

use std::f64::consts::SQRT_2;

use crate::map::{Cell, DIRECTIONS, Direction, Moves, Point, step_length};
use crate::params;
use crate::planner::{AT_GOAL, GoalStep, held};
use crate::scenario::Scenario;

use super::search::{Decode, Settings};

params! {
    /// What all planners over cell priorities share.
    pub struct DecodeRows {
        /// largest priority of a cell. Only its ratio to the radius of explosions matters
        range: f64 = 1.0, "x_max", [1e-3..=1e3], "", "our choice: eq. 6 names limits, no value is given";
        /// smallest priority of a cell, as a share of the largest; the nearer to 1, the straighter paths lead to the goal
        range_min: f64 = 0.0, "x_min", [0.0..=0.999], "× x_max", "our choice: eq. 6 names limits, no value is given";
        /// what eq. 1 means for a step onto the goal, where it divides by 0
        decode_goal: GoalStep = GoalStep::Enter, "", [], "", "our choice: L of eq. 1 is 1 / 0 at the goal";
        /// a decoding gives up after this many times width + height moves; 0 = never
        decode_limit: f64 = 0.0, "", [0.0..=1000.0], "× (width + height)", "our addition; the paper has no cap";
    }
}

impl DecodeRows {
    /// x_min and x_max of Eq. 6.
    pub fn limits(&self) -> Limits {
        Limits { min: self.range_min * self.range, max: self.range }
    }
}

/// Between which numbers the dimensions of a position lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The smallest.
    pub min: f64,
    /// The largest.
    pub max: f64,
}

impl Limits {
    /// From 0 to this number.
    pub fn up_to(max: f64) -> Self {
        Self { min: 0.0, max }
    }

    /// x_max − x_min.
    pub fn span(self) -> f64 {
        self.max - self.min
    }
}

/// L(j, e): 1 / Euclidean distance in cells; at the goal 1 / 0.01.
pub fn nearness(j: Point, goal: Point) -> f64 {
    1.0 / j.distance(goal).max(AT_GOAL)
}

/// The dimensions of a position: the free cells, in index order.
pub fn free_cells(scenario: &Scenario) -> impl Iterator<Item = Cell> + use<'_> {
    (0..scenario.grid.len() as Cell).filter(|&c| !scenario.grid.is_blocked(c))
}

/// Length in cells that no step exceeds.
fn longest_step(scenario: &Scenario) -> f64 {
    let moves = &scenario.moves;
    let on_plane = if scenario.spec.movement.moves == Moves::Sixteen { step_length(DIRECTIONS as Direction) } else { SQRT_2 };
    let cells = if !moves.is_plain() { 0..scenario.grid.len() as Cell } else { 0..0 };
    cells.flat_map(|c| moves.directions(c).map(move |d| moves.length(c, d))).fold(on_plane, f64::max)
}

/// Decodes positions on one map, again and again, without allocating.
#[derive(Debug, Clone)]
pub struct Decoder {
    /// The cell of each dimension.
    free: Vec<Cell>,
    /// L(j, e) of each dimension.
    nearness: Vec<f32>,
    /// a_j·L(j, e) by cell.
    scores: Vec<f32>,
    /// The decoding that visited a cell last.
    visited: Vec<u32>,
    /// Number of the decoding at work.
    decoding: u32,
    path: Vec<Cell>,
    moves: u32,
    max_moves: u32,
    goal_step: GoalStep,
    /// No path of this map is that long, in cells.
    never: f64,
}

impl Decoder {
    /// For a map; `limit` as in [`DecodeRows::decode_limit`], `goal_step` as in [`DecodeRows::decode_goal`].
    pub fn new(scenario: &Scenario, limit: f64, goal_step: GoalStep) -> Self {
        let free: Vec<Cell> = free_cells(scenario).collect();
        let (cells, goal) = (scenario.grid.len(), scenario.grid.point(scenario.goal));
        let nearness = free.iter().map(|&c| nearness(scenario.grid.point(c), goal) as f32).collect();
        let cap = limit * f64::from(scenario.grid.width() + scenario.grid.height());
        Self {
            free,
            nearness,
            scores: vec![0.0; cells],
            visited: vec![0; cells],
            decoding: 0,
            path: Vec::new(),
            moves: 0,
            max_moves: if limit == 0.0 { u32::MAX } else { cap as u32 },
            goal_step,
            never: cells as f64 * longest_step(scenario),
        }
    }

    /// Number of free cells: the length of a position.
    pub fn dimensions(&self) -> usize {
        self.free.len()
    }

    /// Cells of the last decoded path, without what it took back.
    pub fn path(&self) -> &[Cell] {
        &self.path
    }

    /// Moves of the last decoding, steps back included.
    pub fn moves(&self) -> u32 {
        self.moves
    }

    /// Decodes a position (one number of at least 0 for each dimension). Length in cells; `None` if no path was found within the cap.
    pub fn decode(&mut self, scenario: &Scenario, position: &[f32]) -> Option<f64> {
        for ((&cell, &near), &a) in self.free.iter().zip(&self.nearness).zip(position) {
            self.scores[cell as usize] = a * near;
        }
        self.begin(scenario.start);
        while let Some(&here) = self.path.last() {
            if here == scenario.goal {
                return Some(scenario.path_length(&self.path));
            }
            if self.moves >= self.max_moves {
                return None;
            }
            self.moves += 1;
            match self.largest(scenario, here) {
                Some(next) => self.visit(next),
                None => drop(self.path.pop()),
            }
        }
        None
    }

    fn begin(&mut self, start: Cell) {
        if self.decoding == u32::MAX {
            self.visited.fill(0);
            self.decoding = 0;
        }
        self.decoding += 1;
        self.moves = 0;
        self.path.clear();
        self.visit(start);
    }

    #[inline]
    fn visit(&mut self, cell: Cell) {
        self.visited[cell as usize] = self.decoding;
        self.path.push(cell);
    }

    /// Eq. 1: the allowed neighbour with the largest a_j·L(j, e).
    #[inline]
    fn largest(&self, scenario: &Scenario, here: Cell) -> Option<Cell> {
        let (mut best, mut largest) = (None, f32::NEG_INFINITY);
        for d in scenario.moves.directions(here) {
            let j = scenario.moves.step(here, d);
            if j == scenario.goal && self.goal_step == GoalStep::Enter {
                return Some(j);
            }
            if self.visited[j as usize] != self.decoding && self.scores[j as usize] > largest {
                (best, largest) = (Some(j), self.scores[j as usize]);
            }
        }
        best
    }
}

impl Decode for Decoder {
    fn new(scenario: &Scenario, settings: &Settings) -> Self {
        Self::new(scenario, settings.decode_limit, settings.goal_step)
    }

    fn dimensions(&self) -> usize {
        self.dimensions()
    }

    fn decode(&mut self, scenario: &Scenario, position: &mut [f32]) -> Option<f64> {
        self.decode(scenario, position)
    }

    fn lost(&self) -> f64 {
        self.never
    }

    fn path(&self) -> &[Cell] {
        &self.path
    }

    fn moves(&self) -> u32 {
        self.moves
    }

    fn bytes(&self) -> usize {
        held(&self.free) + held(&self.nearness) + held(&self.scores) + held(&self.visited) + held(&self.path)
    }

    fn draw(&self, _: &Scenario, position: &[f32], out: &mut [f32]) {
        self.free.iter().zip(position).for_each(|(&c, &a)| out[c as usize] = a);
    }
}
