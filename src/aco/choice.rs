//! Choice information τ^α·η^β, cached per cell and direction, and the rules that select a step from it.
//!
//! τ and η are divided by the largest of the cell's feasible steps before they are raised: selection compares steps of one cell only,
//! plain powers would leave the range of f32 (β = 25), and trails far from all paths evaporate for hundreds of iterations. So the best
//! step of a cell weighs about 1 whatever the scale of its trails; a feasible step keeps at least [`FLOOR`], an infeasible one has 0.

use std::sync::Arc;

use crate::map::{Cell, DIRECTIONS, Direction};
use crate::planner::held;
use crate::rng::{Stream, unit_f32};
use crate::scenario::Scenario;
use rand::Rng;

use super::trails::{Row, Trails};

/// Smallest weight of a feasible step: it can always be taken when nothing else is left.
pub(super) const FLOOR: f32 = 1e-30;

/// Where a walk reads the weights of the steps from a cell.
pub trait Weights {
    /// Of the steps from a cell; 0 for infeasible ones.
    fn row(&mut self, c: Cell) -> &Row;
}

/// Ready before the walk begins.
impl Weights for &Choice {
    #[inline(always)]
    fn row(&mut self, c: Cell) -> &Row {
        Choice::row(self, c)
    }
}

/// η(i, direction, j) of a feasible step. Borrowed as an object: one copy of the loops over the map serves all variants.
pub type Eta<'a> = dyn Fn(Cell, Direction, Cell) -> f64 + 'a;

/// Cached weights of every step.
#[derive(Debug, Clone)]
pub struct Choice {
    alpha: f64,
    beta: f64,
    /// (η/η_max)^β by cell and direction; 0 for infeasible steps. Snapshots share it: it hardly ever changes.
    visibility: Arc<Vec<Row>>,
    /// τ^α·(η/η_max)^β.
    weights: Vec<Row>,
}

impl Choice {
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

    /// Recomputes the weights whose trail has changed.
    #[inline(never)]
    pub fn refresh(&mut self, trails: &mut Trails) {
        let (alpha, visibility, weights) = (self.alpha, &self.visibility, &mut self.weights);
        trails.take_changes(|row, c| weights[c as usize] = weigh(row, alpha, &visibility[c as usize]));
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

/// (τ/τ_max)^α · (η/η_max)^β of every step of a cell; 0 where the step is infeasible (`seen` is 0).
#[inline]
pub(super) fn weigh(trail: &Row, alpha: f64, seen: &Row) -> Row {
    let mut largest = f32::MIN_POSITIVE;
    for d in 0..DIRECTIONS {
        largest = if seen[d] > 0.0 && trail[d] > largest { trail[d] } else { largest };
    }
    std::array::from_fn(|d| {
        let ratio = trail[d] / largest;
        let strength = if alpha == 1.0 { ratio } else { power(f64::from(ratio), alpha) as f32 };
        if seen[d] > 0.0 { (strength * seen[d]).max(FLOOR) } else { 0.0 }
    })
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

/// Blanks the steps whose bit is set.
#[inline(always)]
pub fn without(row: &Row, visited: u8) -> Row {
    std::array::from_fn(|d| if visited >> d & 1 == 1 { 0.0 } else { row[d] })
}

/// Random proportional rule (Ant System): step d with probability w_d / Σ w. `None` when no step is left.
///
/// Weights are summed from direction 0 upwards; u·Σw < Σw for every u < 1, so the first partial sum above it belongs to a positive weight.
#[inline(always)]
pub fn random_proportional(weights: &Row, stream: &mut Stream) -> Option<Direction> {
    let mut sums = *weights;
    for d in 1..DIRECTIONS {
        sums[d] += sums[d - 1];
    }
    let total = sums[DIRECTIONS - 1];
    if total <= 0.0 {
        return None;
    }
    let threshold = unit_f32(stream.next_u32()) * total;
    Some(sums.iter().map(|&s| u8::from(s <= threshold)).sum())
}

/// Threshold rule (Lai and Guo 2014, step 5): random proportional among the steps with probability w_d / Σ w ≤ λ; if there is none, any
/// feasible step, uniformly. `None` when no step is left.
#[inline]
pub fn threshold(weights: &Row, lambda: f64, stream: &mut Stream) -> Option<Direction> {
    // In f64: beside a step of weight 1, a probability of 1 − 1e-8 is not yet 1.
    let total: f64 = weights.iter().map(|&w| f64::from(w)).sum();
    let candidates = weights.map(|w| if f64::from(w) <= lambda * total { w } else { 0.0 });
    random_proportional(&candidates, stream).or_else(|| random_proportional(&feasible(weights), stream))
}

/// The step of the largest weight; equal ones are drawn from uniformly. `None` when no step is left.
#[inline(always)]
pub fn maximal(weights: &Row, stream: &mut Stream) -> Option<Direction> {
    let (largest, mut equal) = largest(weights);
    if largest <= 0.0 {
        return None;
    }
    // The random proportional rule over weights of 1: as many of the first ones are passed over as whole units are drawn.
    let units = unit_f32(stream.next_u32()) * equal.count_ones() as f32;
    for _ in 0..units as u32 {
        equal &= equal - 1;
    }
    Some(equal.trailing_zeros() as Direction)
}

/// The largest weight, and as bits by direction the steps that have it.
#[inline(always)]
fn largest(weights: &Row) -> (f32, u32) {
    let largest = weights.iter().fold(0.0f32, |m, &w| if w > m { w } else { m });
    let equal = (0..DIRECTIONS).fold(0, |bits, d| bits | u32::from(weights[d] >= largest) << d);
    (largest, equal)
}

/// 1 for the feasible steps, 0 for the others.
fn feasible(weights: &Row) -> Row {
    weights.map(|w| f32::from(u8::from(w > 0.0)))
}

/// Pseudo-random proportional rule (Ant Colony System): with probability q0 the step of the largest weight, the first of equals;
/// otherwise the random proportional rule. `None` when no step is left.
///
/// Draws q first, and for the random proportional rule a second number; at a dead end none at all.
#[inline(always)]
pub fn pseudo_random_proportional(weights: &Row, q0: f64, stream: &mut Stream) -> Option<Direction> {
    let (largest, equal) = largest(weights);
    if largest <= 0.0 {
        None
    } else if f64::from(unit_f32(stream.next_u32())) <= q0 {
        Some(equal.trailing_zeros() as Direction)
    } else {
        random_proportional(weights, stream)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Streams;

    #[test]
    fn random_proportional_follows_the_weights() {
        let weights = [0.0, 1.0, 0.0, 2.0, 0.0, 0.0, 5.0, 0.0];
        let mut stream = Streams::new(1, "test", 0).ant(0, 0);
        let mut counts = [0u32; DIRECTIONS];
        for _ in 0..80_000 {
            counts[random_proportional(&weights, &mut stream).unwrap() as usize] += 1;
        }
        for d in 0..DIRECTIONS {
            let expected = f64::from(weights[d]) * 10_000.0;
            assert!((f64::from(counts[d]) - expected).abs() <= 3.5 * expected.sqrt(), "direction {d}: {}", counts[d]);
        }
    }

    #[test]
    fn never_selects_a_weight_of_zero_and_reports_a_dead_end() {
        let mut stream = Streams::new(2, "test", 0).ant(0, 0);
        for case in 0..255u8 {
            let weights: Row = std::array::from_fn(|d| if case >> d & 1 == 1 { 1e-30 * 10f32.powi(d as i32 * 4) } else { 0.0 });
            for _ in 0..200 {
                match random_proportional(&weights, &mut stream) {
                    None => assert_eq!(case, 0),
                    Some(d) => assert!(case >> d & 1 == 1),
                }
            }
        }
    }

    #[test]
    fn pseudo_random_proportional_takes_the_first_of_the_best_with_q0() {
        let weights = [0.0, 1.0, 0.0, 2.0, 0.0, 2.0, 0.0, 0.0];
        let mut stream = Streams::new(3, "test", 0).ant(0, 0);
        let mut counts = [0u32; DIRECTIONS];
        for _ in 0..50_000 {
            assert_eq!(pseudo_random_proportional(&weights, 1.0, &mut stream), Some(3));
            counts[pseudo_random_proportional(&weights, 0.5, &mut stream).unwrap() as usize] += 1;
        }
        // Half of the draws go to direction 3; the other half is shared 1 : 2 : 2.
        for (d, expected) in [(1, 5_000.0), (3, 35_000.0), (5, 10_000.0)] {
            assert!((f64::from(counts[d]) - expected).abs() <= 3.5 * f64::sqrt(expected), "direction {d}: {}", counts[d]);
        }
    }

    #[test]
    fn pseudo_random_proportional_draws_q_then_the_roulette_and_nothing_at_a_dead_end() {
        let fresh = || Streams::new(4, "test", 0).ant(0, 0);
        for (weights, q0, draws) in [([0.0; DIRECTIONS], 0.5, 0), ([1.0; DIRECTIONS], 1.0, 1), ([1.0; DIRECTIONS], 0.0, 2)] {
            let (mut used, mut counted) = (fresh(), fresh());
            pseudo_random_proportional(&weights, q0, &mut used);
            let skipped = (0..draws).map(|_| counted.next_u32()).count();
            assert_eq!(skipped, draws);
            assert_eq!(used.next_u32(), counted.next_u32(), "q0 = {q0}");
        }
    }

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
