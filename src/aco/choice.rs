//! Choice information τ^α·η^β, cached per cell and direction, and the rules that select a step from it.
//!
//! η^β is divided by the largest η^β of the cell: selection compares steps of one cell only, and with β = 25 the plain power would leave
//! the range of f32. A feasible step keeps at least [`FLOOR`], an infeasible one has 0.

use crate::map::{Cell, DIRECTIONS, Direction};
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
        &self.weights[c as usize]
    }
}

/// Cached weights of every step.
#[derive(Debug, Clone)]
pub struct Choice {
    alpha: f64,
    beta: f64,
    /// (η/η_max)^β by cell and direction; 0 for infeasible steps.
    visibility: Vec<Row>,
    /// τ^α·(η/η_max)^β.
    weights: Vec<Row>,
}

impl Choice {
    /// Empty tables for a map of this many cells.
    pub fn new(cells: usize, alpha: f64, beta: f64) -> Self {
        Self { alpha, beta, visibility: vec![[0.0; DIRECTIONS]; cells], weights: vec![[0.0; DIRECTIONS]; cells] }
    }

    /// Takes in η(i, direction, j) of every feasible step.
    pub fn see(&mut self, scenario: &Scenario, eta: impl Fn(Cell, Direction, Cell) -> f64) {
        for c in 0..scenario.grid.len() as Cell {
            let mut row = [0.0f64; DIRECTIONS];
            for d in scenario.moves.directions(c) {
                row[d as usize] = eta(c, d, scenario.moves.step(c, d));
            }
            let largest = row.iter().fold(0.0f64, |m, &e| m.max(e));
            let out = &mut self.visibility[c as usize];
            *out = [0.0; DIRECTIONS];
            for d in scenario.moves.directions(c) {
                out[d as usize] = (power(row[d as usize] / largest, self.beta) as f32).max(FLOOR);
            }
        }
    }

    /// Recomputes the weights whose trail has changed.
    pub fn refresh(&mut self, trails: &mut Trails) {
        let (alpha, visibility, weights) = (self.alpha, &self.visibility, &mut self.weights);
        trails.take_changes(|row, c, bits| {
            let (seen, out) = (&visibility[c as usize], &mut weights[c as usize]);
            for d in 0..DIRECTIONS {
                if bits >> d & 1 == 1 && seen[d] > 0.0 {
                    out[d] = weight(row[d], alpha, seen[d]);
                }
            }
        });
    }
}

/// τ^α · visibility, kept between [`FLOOR`] and what eight of can be summed.
#[inline(always)]
pub(super) fn weight(trail: f32, alpha: f64, seen: f32) -> f32 {
    let strength = if alpha == 1.0 { trail } else { power(f64::from(trail), alpha) as f32 };
    (strength * seen).clamp(FLOOR, 1e37)
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
    random_proportional(&candidates, stream).or_else(|| random_proportional(&any(weights, 0.0), stream))
}

/// The step of the largest weight; equal ones are drawn from uniformly. `None` when no step is left.
#[inline]
pub fn maximal(weights: &Row, stream: &mut Stream) -> Option<Direction> {
    let largest = weights.iter().fold(0.0f32, |m, &w| m.max(w));
    random_proportional(&any(weights, largest), stream)
}

/// 1 for the feasible steps that weigh at least this much, 0 for the others.
fn any(weights: &Row, least: f32) -> Row {
    weights.map(|w| f32::from(u8::from(w > 0.0 && w >= least)))
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
    fn power_by_multiplication_is_the_power() {
        for e in [0.0, 1.0, 2.0, 7.0, 25.0, 2.5] {
            for x in [0.0, 1e-3, 0.7, 1.0, 3.0] {
                assert!((power(x, e) - libm::pow(x, e)).abs() <= 1e-13 * libm::pow(x, e).abs());
            }
        }
    }
}
