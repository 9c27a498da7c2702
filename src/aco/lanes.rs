//! Four ants side by side: while one waits for memory, the others move. With the random proportional rule they share 128-bit lanes; with
//! the very same numbers as one ant at a time.
//!
//! Every lane sums its weights in the same order, draws from its own ant's stream and compares in the same way as
//! [`super::selection::random_proportional`]; so which lane an ant walks in, and beside whom, changes nothing. An ant that has ended is
//! replaced by the next one that waits; the last ones finish alone.

use rand::Rng;
use wide::f32x4;

use super::ant::{Ant, Walk};
use super::selection::{random_proportional, without};
use super::trails::Row;
use super::weights::Weights;
use crate::map::{DIRECTIONS, Direction};
use crate::planner::Fate;
use crate::rng::{Stream, unit_f32};

const LANES: usize = 4;

/// Lets all walking ants walk to their end by the random proportional rule. One copy for all variants that select by it.
#[inline(never)]
pub(super) fn walk_all<W: Weights>(weights: &mut W, walk: &Walk, ants: &mut [Ant]) {
    side_by_side(
        weights,
        ants,
        |weights, ants| move_four(weights, walk, ants),
        |weights, ant| {
            move_one(weights, walk, ant, random_proportional);
        },
    );
}

/// The same by another rule.
pub(super) fn walk_all_by<W: Weights>(
    weights: &mut W,
    walk: &Walk,
    ants: &mut [Ant],
    choose: impl Fn(&Row, &mut Stream) -> Option<Direction> + Copy,
) {
    let four =
        |weights: &mut W, ants: &mut [&mut Ant; LANES]| ants.iter_mut().for_each(|ant| move_one(weights, walk, ant, choose));
    side_by_side(weights, ants, four, |weights, ant| move_one(weights, walk, ant, choose));
}

/// Keeps four ants under way as long as there are four, then lets each of the last ones finish alone, with the same numbers.
#[inline(always)]
fn side_by_side<W>(
    weights: &mut W,
    ants: &mut [Ant],
    four: impl Fn(&mut W, &mut [&mut Ant; LANES]),
    alone: impl Fn(&mut W, &mut Ant),
) {
    let mut waiting = ants.iter_mut().filter(|a| a.fate() == Fate::Walking);
    let mut lanes: Vec<&mut Ant> = waiting.by_ref().take(LANES).collect();
    while let Ok(abreast) = <&mut [&mut Ant; LANES]>::try_from(lanes.as_mut_slice()) {
        while abreast.iter().all(|a| a.fate() == Fate::Walking) {
            four(weights, abreast);
        }
        lanes.retain(|a| a.fate() == Fate::Walking);
        lanes.extend(waiting.by_ref().take(LANES - lanes.len()));
    }
    for ant in lanes {
        while ant.fate() == Fate::Walking {
            alone(weights, ant);
        }
    }
}

/// One move of one ant.
#[inline(always)]
fn move_one<W: Weights>(weights: &mut W, walk: &Walk, ant: &mut Ant, choose: impl Fn(&Row, &mut Stream) -> Option<Direction>) {
    let left = without(weights.row(ant.cell()), ant.visited());
    let step = choose(&left, &mut ant.stream);
    ant.go(walk, step);
}

/// One move of four ants by the random proportional rule.
#[inline(always)]
fn move_four<W: Weights>(weights: &mut W, walk: &Walk, ants: &mut [&mut Ant; LANES]) {
    let (steps, totals) = select(weights, ants);
    for lane in 0..LANES {
        let step = (totals[lane] > 0.0).then_some(steps[lane]);
        ants[lane].go(walk, step);
    }
}

/// The random proportional rule for four ants at once. A lane whose total is 0 is at a dead end and draws nothing.
#[inline(always)]
fn select<W: Weights>(weights: &mut W, ants: &mut [&mut Ant; LANES]) -> ([Direction; LANES], [f32; LANES]) {
    let rows: [_; LANES] = std::array::from_fn(|k| without(weights.row(ants[k].cell()), ants[k].visited()));
    let mut sums = [f32x4::ZERO; DIRECTIONS];
    let mut sum = f32x4::ZERO;
    for d in 0..DIRECTIONS {
        sum += f32x4::new(std::array::from_fn(|k| rows[k][d]));
        sums[d] = sum;
    }
    let totals = sum.to_array();
    let draws = std::array::from_fn(|k| if totals[k] > 0.0 { unit_f32(ants[k].stream.next_u32()) } else { 0.0 });
    let threshold = f32x4::new(draws) * sum;
    let mut steps = [0; LANES];
    for partial in sums {
        let below = partial.simd_le(threshold).to_bitmask();
        for (k, step) in steps.iter_mut().enumerate() {
            *step += (below >> k & 1) as Direction;
        }
    }
    (steps, totals)
}
