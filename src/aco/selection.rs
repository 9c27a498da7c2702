//! The rules by which an ant selects a step, given the weights of the steps from its cell.

use crate::map::{DIRECTIONS, Direction};
use crate::rng::{Stream, unit_f32};
use rand::Rng;

use super::tabu::{SEEN, Seen};
use super::trails::Row;
use wide::{bytemuck::cast, f32x4, u32x4};

/// Blanks the steps whose bit is set.
#[inline(always)]
pub fn without(row: &Row, visited: u8) -> Row {
    std::array::from_fn(|d| if visited >> d & 1 == 1 { 0.0 } else { row[d] })
}

/// The same for what an ant has seen, as two halves of a row.
#[inline(always)]
pub(super) fn left(row: &Row, seen: Seen) -> [f32x4; 2] {
    const LOW: u32x4 = u32x4::new([SEEN[0], SEEN[1], SEEN[2], SEEN[3]]);
    const HIGH: u32x4 = u32x4::new([SEEN[4], SEEN[5], SEEN[6], SEEN[7]]);
    let seen = u32x4::splat(seen);
    let [low, high]: [f32x4; 2] = cast(*row);
    [low & is_zero(seen & LOW), high & is_zero(seen & HIGH)]
}

#[inline(always)]
fn is_zero(bits: u32x4) -> f32x4 {
    cast(bits.simd_eq(u32x4::ZERO))
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
    let threshold = f32x4::splat(unit_f32(stream.next_u32()) * total);
    // Sums do not fall, so those at or below it are the first ones.
    let [low, high]: [f32x4; 2] = cast(sums);
    let below = low.simd_le(threshold).to_bitmask() | high.simd_le(threshold).to_bitmask() << 4;
    Some(below.trailing_ones() as Direction)
}

/// Threshold rule (Lai and Guo 2014, step 5): random proportional among the steps with probability w_d / Σ w ≤ λ; if there is none, any
/// feasible step, uniformly. `None` when no step is left.
#[inline]
pub fn threshold(weights: &Row, lambda: f64, stream: &mut Stream) -> Option<Direction> {
    let limit = f32x4::splat(largest_candidate(weights.iter().map(|&w| f64::from(w)).sum(), lambda));
    let [low, high]: [f32x4; 2] = cast(*weights);
    let candidates: Row = cast([low & low.simd_le(limit), high & high.simd_le(limit)]);
    random_proportional(&candidates, stream).or_else(|| random_proportional(&feasible(weights), stream))
}

/// The largest weight that a candidate of the threshold rule may have, as the weights have 32 bits. In f64: beside a step of weight 1, a
/// probability of 1 − 1e-8 is not yet 1.
#[inline(always)]
fn largest_candidate(total: f64, lambda: f64) -> f32 {
    let (limit, near) = (lambda * total, (lambda * total) as f32);
    if f64::from(near) > limit { near.next_down() } else { near }
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
    let [low, high]: [f32x4; 2] = cast(*weights);
    let largest = low.fast_max(high).to_array().into_iter().fold(0.0f32, |m, w| if w > m { w } else { m });
    let is_largest = |half: f32x4| half.simd_ge(f32x4::splat(largest)).to_bitmask();
    (largest, is_largest(low) | is_largest(high) << 4)
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
}
