//! The weights τ^α·η^β of every step, kept by cell and direction: what the rules of [`super::selection`] choose by.
//!
//! τ and η are divided by the largest of the cell's feasible steps before they are raised: selection compares steps of one cell only,
//! plain powers would leave the range of f32 (β = 25), and trails far from all paths evaporate for hundreds of iterations. So the best
//! step of a cell weighs about 1 whatever the scale of its trails; a feasible step keeps at least [`FLOOR`], an infeasible one has 0.

use std::sync::Arc;

use wide::{bytemuck::cast, f32x4};

use crate::map::{Cell, DIRECTIONS, Direction};
use crate::planner::held;
use crate::scenario::Scenario;

use super::trails::{Row, Trails};

/// Smallest weight of a feasible step: it can always be taken when nothing else is left.
pub(super) const FLOOR: f32 = 1e-30;

/// Where a walk reads the weights of the steps from a cell.
pub trait Weights {
    /// Of the steps from a cell; 0 for infeasible ones.
    fn row(&mut self, c: Cell) -> &Row;
}

/// Ready before the walk begins.
impl Weights for &WeightTable {
    #[inline(always)]
    fn row(&mut self, c: Cell) -> &Row {
        WeightTable::row(self, c)
    }
}

/// η(i, direction, j) of a feasible step. Borrowed as an object: one copy of the loops over the map serves all variants.
pub type Eta<'a> = dyn Fn(Cell, Direction, Cell) -> f64 + 'a;

/// The weights of every step of a map: 8 a cell, ready before the walk.
#[derive(Debug, Clone)]
pub struct WeightTable {
    alpha: f64,
    beta: f64,
    /// (η/η_max)^β by cell and direction; 0 for infeasible steps. Snapshots share it: it hardly ever changes.
    visibility: Arc<Vec<Row>>,
    /// τ^α·(η/η_max)^β.
    weights: Vec<Row>,
}

impl WeightTable {
    /// Empty tables for a map of this many cells.
    pub fn new(cells: usize, alpha: f64, beta: f64) -> Self {
        let rows = || vec![[0.0; DIRECTIONS]; cells];
        Self { alpha, beta, visibility: Arc::new(rows()), weights: rows() }
    }

    /// Takes in η(i, direction, j) of every feasible step.
    #[inline(never)]
    pub fn see(&mut self, scenario: &Scenario, eta: &Eta) {
        let beta = self.beta;
        let rows = Arc::make_mut(&mut self.visibility).iter_mut();
        rows.zip(0..).for_each(|(row, c)| *row = visibility(scenario, eta, beta, c));
    }

    /// The same for these cells alone.
    #[cfg(feature = "whole")]
    pub fn see_again(&mut self, scenario: &Scenario, eta: &Eta, cells: &[Cell]) {
        let rows = Arc::make_mut(&mut self.visibility);
        cells.iter().for_each(|&c| rows[c as usize] = visibility(scenario, eta, self.beta, c));
    }

    /// From the cells beside the goal leaves the step onto it alone. Once η is known.
    pub fn enter(&mut self, scenario: &Scenario) {
        let rows = Arc::make_mut(&mut self.visibility).iter_mut();
        rows.zip(0..).for_each(|(row, c)| only_onto_the_goal(scenario, c, row));
    }

    /// Recomputes the weights whose trail has changed.
    #[inline(never)]
    pub fn refresh(&mut self, trails: &mut Trails) {
        let (alpha, visibility, weights) = (self.alpha, &self.visibility, &mut self.weights);
        trails.take_changes(|row, c| weights[c as usize] = weigh(row, alpha, &visibility[c as usize]));
    }

    /// The same where hardly more than one cell can have changed: after a move.
    #[inline(always)]
    pub fn follow(&mut self, trails: &mut Trails) {
        match trails.take_change() {
            Some((c, row)) => self.weights[c as usize] = weigh(row, self.alpha, &self.visibility[c as usize]),
            None => self.refresh(trails),
        }
    }

    /// What it holds, in bytes, without what snapshots share.
    pub fn bytes(&self) -> usize {
        held(&self.weights)
    }

    /// The weights of the steps from a cell.
    #[inline(always)]
    pub fn row(&self, c: Cell) -> &Row {
        &self.weights[c as usize]
    }
}

/// (η/η_max)^β of every step of a cell; 0 where the step is infeasible.
pub(super) fn visibility(scenario: &Scenario, eta: &Eta, beta: f64, c: Cell) -> Row {
    let mut seen = [0.0f64; DIRECTIONS];
    for d in scenario.moves.directions(c) {
        seen[d as usize] = eta(c, d, scenario.moves.step(c, d));
    }
    let largest = seen.iter().fold(0.0f64, |m, &e| m.max(e));
    let mut row = [0.0; DIRECTIONS];
    for d in scenario.moves.directions(c) {
        row[d as usize] = (power(seen[d as usize] / largest, beta) as f32).max(FLOOR);
    }
    row
}

/// Where one of a cell's steps leads onto the goal, has that step alone feasible.
pub(super) fn only_onto_the_goal(scenario: &Scenario, c: Cell, row: &mut Row) {
    if let Some(onto) = scenario.moves.directions(c).find(|&d| scenario.moves.step(c, d) == scenario.goal) {
        *row = std::array::from_fn(|d| f32::from(u8::from(d == onto as usize)));
    }
}

/// (τ/τ_max)^α · (η/η_max)^β of every step of a cell; 0 where the step is infeasible (`seen` is 0).
#[inline(never)]
pub(super) fn weigh(trail: &Row, alpha: f64, seen: &Row) -> Row {
    let (trail, seen): ([f32x4; 2], [f32x4; 2]) = (cast(*trail), cast(*seen));
    let feasible = seen.map(|seen| seen.simd_gt(f32x4::ZERO));
    let largest = (trail[0] & feasible[0]).fast_max(trail[1] & feasible[1]).to_array();
    let largest = f32x4::splat(largest.into_iter().fold(f32::MIN_POSITIVE, |m, t| if t > m { t } else { m }));
    cast([0, 1].map(|half| {
        let ratio = trail[half] / largest;
        let strength = if alpha == 1.0 { ratio } else { raised(ratio, alpha) };
        (strength * seen[half]).fast_max(f32x4::splat(FLOOR)) & feasible[half]
    }))
}

#[inline(never)]
fn raised(ratios: f32x4, alpha: f64) -> f32x4 {
    f32x4::new(ratios.to_array().map(|ratio| power(f64::from(ratio), alpha) as f32))
}

/// x^e for x ≥ 0. Whole exponents up to 64 by multiplication (libm's pow costs about 100 ns), others by libm: the same bits everywhere.
pub fn power(x: f64, e: f64) -> f64 {
    if !(0.0..=64.0).contains(&e) || e.trunc() != e {
        return libm::pow(x, e);
    }
    let (mut result, mut base, mut left) = (1.0, x, e as u32);
    while left > 0 {
        if left & 1 == 1 {
            result *= base;
        }
        base *= base;
        left >>= 1;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_are_the_same_at_every_scale_of_the_trails() {
        let seen: Row = [1.0, 0.0, 0.5, 0.25, 0.0, 0.125, 1e-11, 0.0];
        let trail: Row = [3.0, 99.0, 1.5, 0.75, 99.0, 0.375, 3.0, 99.0];
        for alpha in [0.0, 0.5, 1.0, 2.0, 5.0] {
            let weights = weigh(&trail, alpha, &seen);
            for scale in [1e-28f32, 1e-9, 1e9, 1e30] {
                let other = weigh(&trail.map(|t| t * scale), alpha, &seen);
                for d in 0..DIRECTIONS {
                    assert!((weights[d] - other[d]).abs() <= 1e-5 * weights[d], "alpha {alpha}, scale {scale}, direction {d}");
                }
            }
            assert_eq!(weights[1], 0.0);
            assert_eq!(weights[0], 1.0);
            let expected = libm::pow(0.5, alpha) * 0.5;
            assert!((f64::from(weights[2]) - expected).abs() < 1e-6);
        }
    }

    #[test]
    fn power_by_multiplication_is_the_power() {
        for e in [0.0, 1.0, 2.0, 7.0, 25.0, 2.5] {
            for x in [0.0, 1e-3, 0.7, 1.0, 3.0] {
                assert!((power(x, e) - libm::pow(x, e)).abs() <= 1e-13 * libm::pow(x, e).abs());
            }
        }
    }
}
