//! Weights τ^α·η^β for an η that changes with time: computed when an ant comes by, instead of for the whole map in every iteration.
//!
//! A [`Variant::TIMED`] variant gives ln η(t) = a + b·w(t) with one w for all steps. The two numbers of a step are computed once, when an
//! ant first stands on the cell; later visits at another time cost one power of two a step. As in [`super::weights`], η^β is divided by the
//! largest of the cell, and a feasible step keeps at least the same floor. Which ant comes first changes nothing.

use crate::map::{Cell, DIRECTIONS};
use crate::planner::held;
use crate::scenario::Scenario;

use super::trails::{Row, Trails};
use super::variant::Variant;
use super::weights::{FLOOR, Weights, weigh};

/// State of a cell no ant has come by.
const UNKNOWN: u32 = 0;
/// State of a cell whose trails have changed since its weights were computed.
const OUTDATED: u32 = 1;

/// The tables of one colony.
#[derive(Debug, Clone)]
pub struct OnDemand {
    alpha: f64,
    beta: f64,
    /// β·a / ln 2 by cell and direction, the largest of a cell being 0; −∞ for infeasible steps.
    fixed: Vec<Row>,
    /// β·b / ln 2, the largest of a cell being 0.
    timed: Vec<Row>,
    /// τ^α·(η/η_max)^β.
    weights: Vec<Row>,
    /// The time at which a cell's weights were computed, or [`UNKNOWN`] or [`OUTDATED`].
    state: Vec<u32>,
    now: u32,
}

impl OnDemand {
    /// Empty tables for a map of this many cells.
    pub fn new(cells: usize, alpha: f64, beta: f64) -> Self {
        let rows = || vec![[0.0; DIRECTIONS]; cells];
        let (fixed, timed, weights) = (rows(), rows(), rows());
        Self { alpha, beta, fixed, timed, weights, state: vec![UNKNOWN; cells], now: OUTDATED + 1 }
    }

    /// Another time has come: no weight holds any longer.
    pub fn another_time(&mut self) {
        self.now += 1;
    }

    /// The weights whose trail has changed no longer hold.
    pub fn outdate(&mut self, trails: &mut Trails) {
        let state = &mut self.state;
        trails.take_changes(0..state.len() as Cell, |_, c| state[c as usize] = state[c as usize].min(OUTDATED));
    }

    /// What is known of these cells no longer holds.
    #[cfg(feature = "whole")]
    pub fn forget(&mut self, cells: &[Cell]) {
        cells.iter().for_each(|&c| self.state[c as usize] = UNKNOWN);
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.fixed) + held(&self.timed) + held(&self.weights) + held(&self.state)
    }

    /// The tables as a walk reads them now.
    pub fn now<'a, V: Variant>(&'a mut self, scenario: &'a Scenario, variant: &'a V, trails: &'a Trails) -> Now<'a, V> {
        Now { tables: self, scenario, variant, trails, time: variant.time() as f32 }
    }
}

/// [`OnDemand`] at one time, with all that its weights are computed from.
pub struct Now<'a, V> {
    tables: &'a mut OnDemand,
    scenario: &'a Scenario,
    variant: &'a V,
    trails: &'a Trails,
    /// w(t).
    time: f32,
}

impl<V: Variant> Weights for Now<'_, V> {
    #[inline(always)]
    fn row(&mut self, c: Cell) -> &Row {
        if self.tables.state[c as usize] != self.tables.now {
            self.compute(c);
        }
        &self.tables.weights[c as usize]
    }
}

impl<V: Variant> Now<'_, V> {
    /// Computes the weights of a cell.
    #[inline(never)]
    fn compute(&mut self, c: Cell) {
        let i = c as usize;
        if self.tables.state[i] == UNKNOWN {
            self.see(c);
        }
        let tables = &mut *self.tables;
        tables.state[i] = tables.now;
        let seen = at_time(&tables.fixed[i], &tables.timed[i], self.time);
        tables.weights[i] = weigh(&self.trails.relative(c), tables.alpha, &seen);
    }

    /// Takes in ln η of a cell's feasible steps.
    fn see(&mut self, c: Cell) {
        let (fixed, timed) = logs(self.scenario, self.variant, self.tables.beta, c);
        self.tables.fixed[c as usize] = fixed;
        self.tables.timed[c as usize] = timed;
    }
}

/// β·a / ln 2 and β·b / ln 2 of a cell's steps, the largest of each being 0.
fn logs<V: Variant>(scenario: &Scenario, variant: &V, beta: f64, c: Cell) -> (Row, Row) {
    let (mut fixed, mut timed) = ([f64::NEG_INFINITY; DIRECTIONS], [f64::NEG_INFINITY; DIRECTIONS]);
    let scale = beta / std::f64::consts::LN_2;
    for d in scenario.moves.directions(c) {
        let (a, b) = variant.log_heuristic(scenario, c, d, scenario.moves.step(c, d));
        (fixed[d as usize], timed[d as usize]) = (a * scale, b * scale);
    }
    let below_largest = |row: [f64; DIRECTIONS], infeasible: f32| -> Row {
        let largest = row.iter().fold(f64::NEG_INFINITY, |m, &x| if x > m { x } else { m });
        row.map(|x| if x.is_finite() { (x - largest) as f32 } else { infeasible })
    };
    (below_largest(fixed, f32::NEG_INFINITY), below_largest(timed, 0.0))
}

/// (η/η_max)^β of a cell's steps at one time; 0 for infeasible ones.
fn at_time(fixed: &Row, timed: &Row, time: f32) -> Row {
    let logs: Row = std::array::from_fn(|d| fixed[d] + timed[d] * time);
    let largest = logs.iter().fold(f32::NEG_INFINITY, |m, &x| if x > m { x } else { m });
    logs.map(|x| if x > f32::NEG_INFINITY { libm::exp2f(x - largest).max(FLOOR) } else { 0.0 })
}

/// (η/η_max)^β of a cell's steps as a walk would compute it now; 0 for infeasible ones.
pub(super) fn visibility<V: Variant>(scenario: &Scenario, variant: &V, beta: f64, c: Cell) -> Row {
    let (fixed, timed) = logs(scenario, variant, beta, c);
    at_time(&fixed, &timed, variant.time() as f32)
}
