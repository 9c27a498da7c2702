//! Four ants side by side in 128-bit lanes: the walk of Ant System, with the very same numbers as one ant at a time.
//!
//! Every lane sums its weights in the same order, draws from its own ant's stream and compares in the same way as
//! [`super::choice::random_proportional`]; so which lane an ant walks in, and beside whom, changes nothing. An ant that has ended is
//! replaced by the next one that waits; the last ones finish alone.

use rand::Rng;
use wide::f32x4;

use super::ant::{Ant, Fate, Walk};
use super::choice::{Weights, random_proportional, without};
use crate::map::{DIRECTIONS, Direction};
use crate::rng::unit_f32;

const LANES: usize = 4;

/// Lets all walking ants walk to their end. One copy for all variants that select by this rule.
#[inline(never)]
pub(super) fn walk_all<W: Weights>(weights: &mut W, walk: &Walk, ants: &mut [Ant]) {
    let mut waiting = ants.iter_mut().filter(|a| a.fate() == Fate::Walking);
    let mut lanes: Vec<&mut Ant> = waiting.by_ref().take(LANES).collect();
    while let Ok(four) = <&mut [&mut Ant; LANES]>::try_from(lanes.as_mut_slice()) {
        walk_until_one_ends(weights, walk, four);
        lanes.retain(|a| a.fate() == Fate::Walking);
        lanes.extend(waiting.by_ref().take(LANES - lanes.len()));
    }
    lanes.into_iter().for_each(|ant| walk_alone(weights, walk, ant));
}

/// The last ants, with the same numbers.
fn walk_alone<W: Weights>(weights: &mut W, walk: &Walk, ant: &mut Ant) {
    while ant.fate() == Fate::Walking {
        let left = without(weights.row(ant.cell()), ant.visited());
        let step = random_proportional(&left, &mut ant.stream);
        ant.go(walk, step);
    }
}

fn walk_until_one_ends<W: Weights>(weights: &mut W, walk: &Walk, ants: &mut [&mut Ant; LANES]) {
    while ants.iter().all(|a| a.fate() == Fate::Walking) {
        let (steps, totals) = select(weights, ants);
        for lane in 0..LANES {
            let step = (totals[lane] > 0.0).then_some(steps[lane]);
            ants[lane].go(walk, step);
        }
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
