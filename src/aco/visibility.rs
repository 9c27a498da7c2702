//! (η/η_max)^β of the steps from a cell: worked out when an ant first stands there, and kept.
//!
//! On a large map ants come by few cells: neither time nor memory is spent on the others. Rows are kept in chunks, which snapshots of a
//! colony share until one of them learns more.

use std::sync::Arc;

use crate::map::{Cell, DIRECTIONS, Direction};
use crate::planner::held;
use crate::scenario::Scenario;

use super::trails::Row;
use super::weights::{FLOOR, power};

/// η(i, direction, j) of a feasible step. Borrowed as an object: one copy of the loops over the map serves all variants.
pub type Eta<'a> = dyn Fn(Cell, Direction, Cell) -> f64 + 'a;

/// What ants see of a map.
#[derive(Clone, Copy)]
pub struct Sight<'a> {
    /// The map.
    pub scenario: &'a Scenario,
    /// η.
    pub eta: &'a Eta<'a>,
    /// β.
    pub beta: f64,
    /// Whether beside the goal the step onto it is the only one.
    pub enters_goal: bool,
}

impl Sight<'_> {
    /// (η/η_max)^β of every step of a cell; 0 where the step is infeasible.
    pub fn row(&self, c: Cell) -> Row {
        let Self { scenario, eta, beta, enters_goal } = *self;
        let mut seen = [0.0f64; DIRECTIONS];
        for d in scenario.moves.directions(c) {
            seen[d as usize] = eta(c, d, scenario.moves.step(c, d));
        }
        let largest = seen.iter().fold(0.0f64, |m, &e| m.max(e));
        let mut row = [0.0; DIRECTIONS];
        for d in scenario.moves.directions(c) {
            row[d as usize] = (power(seen[d as usize] / largest, beta) as f32).max(FLOOR);
        }
        if enters_goal {
            only_onto_the_goal(scenario, c, &mut row);
        }
        row
    }
}

/// Where one of a cell's steps leads onto the goal, has that step alone feasible.
pub(super) fn only_onto_the_goal(scenario: &Scenario, c: Cell, row: &mut Row) {
    if let Some(onto) = scenario.moves.directions(c).find(|&d| scenario.moves.step(c, d) == scenario.goal) {
        *row = std::array::from_fn(|d| f32::from(u8::from(d == onto as usize)));
    }
}

/// Rows that come and go together.
const CHUNK: usize = 128;

/// A row that nobody has asked for.
const UNKNOWN: Row = [f32::NAN; DIRECTIONS];

/// The rows that are known.
#[derive(Debug, Clone)]
pub(super) struct Visibility {
    /// Of those without a known row, all are the same one.
    chunks: Vec<Arc<[Row; CHUNK]>>,
    unknown: Arc<[Row; CHUNK]>,
}

impl Visibility {
    /// Of a map of this many cells, with nothing known.
    pub fn new(cells: usize) -> Self {
        let unknown = Arc::new([UNKNOWN; CHUNK]);
        Self { chunks: vec![Arc::clone(&unknown); cells.div_ceil(CHUNK)], unknown }
    }

    /// The row of a cell where it is known.
    #[inline(always)]
    pub fn row(&self, c: Cell) -> Option<&Row> {
        let row = &self.chunks[c as usize / CHUNK][c as usize % CHUNK];
        if row[0].is_nan() { None } else { Some(row) }
    }

    /// The row of a cell, known from now on.
    #[inline(never)]
    pub fn learn(&mut self, sight: &Sight, c: Cell) -> &Row {
        let row = &mut Arc::make_mut(&mut self.chunks[c as usize / CHUNK])[c as usize % CHUNK];
        *row = sight.row(c);
        row
    }

    /// Nothing is known any longer.
    pub fn forget_all(&mut self) {
        self.chunks.fill(Arc::clone(&self.unknown));
    }

    /// This row is not known any longer.
    #[cfg(feature = "whole")]
    pub fn forget(&mut self, c: Cell) {
        if self.row(c).is_some() {
            Arc::make_mut(&mut self.chunks[c as usize / CHUNK])[c as usize % CHUNK] = UNKNOWN;
        }
    }

    /// What it holds, in bytes, without the chunks, which snapshots share.
    pub fn bytes(&self) -> usize {
        held(&self.chunks)
    }
}
