//! The rules of `selection.rs` for four ants at once, in SIMD lanes: with the very same numbers as one ant at a time.

use wide::{bytemuck::cast, f32x4, u32x4};

use super::draws::Draws;
use super::selection::{maximal, pseudo_random_proportional, random_proportional};
use super::trails::Row;
use crate::map::{DIRECTIONS, Direction};
use crate::rng::Stream;

/// A rule of selection for four ants at once.
pub(super) trait Rule: Copy {
    /// The chosen steps of the lanes with a positive total, given the partial sums of the weights by direction.
    fn choose(self, weights: &[f32x4; DIRECTIONS], sums: &Sums, draws: &mut Draws) -> u32x4;

    /// The same for one ant.
    fn choose_one(self, weights: &Row, stream: &mut Stream) -> Option<Direction>;
}

/// The random proportional rule: [`random_proportional`].
#[derive(Clone, Copy)]
pub(super) struct Proportional;

/// [`pseudo_random_proportional`].
#[derive(Clone, Copy)]
pub(super) struct PseudoProportional {
    q0: f64,
    /// The largest draw that is at most q0.
    greedy: f32,
}

impl PseudoProportional {
    pub fn new(q0: f64) -> Self {
        // A draw has 24 bits.
        let units = f64::from(1 << 24);
        Self { q0, greedy: (libm::floor(q0 * units) / units) as f32 }
    }
}

/// [`maximal`].
#[derive(Clone, Copy)]
pub(super) struct Maximal;

/// The weights of four ants, summed from direction 0 upwards.
pub(super) struct Sums {
    partial: [f32x4; DIRECTIONS],
    /// The lanes whose total is positive, as a mask.
    pub alive: u32x4,
    /// Whether all lanes are.
    pub all_alive: bool,
}

impl Sums {
    #[inline(always)]
    pub fn of(weights: &[f32x4; DIRECTIONS]) -> Self {
        let mut partial = *weights;
        for d in 1..DIRECTIONS {
            partial[d] += partial[d - 1];
        }
        let alive: u32x4 = cast(partial[DIRECTIONS - 1].simd_gt(f32x4::ZERO));
        Self { partial, alive, all_alive: alive.all() }
    }

    /// How many partial sums are at or below a part of the total below 1. The total itself never is.
    #[inline(always)]
    fn at_or_below(&self, part: f32x4) -> u32x4 {
        let threshold = part * self.partial[DIRECTIONS - 1];
        let [a, b, c, d, e, f, g, _] = self.partial;
        let below = ((is_below(a, threshold) + is_below(b, threshold)) + (is_below(c, threshold) + is_below(d, threshold)))
            + ((is_below(e, threshold) + is_below(f, threshold)) + is_below(g, threshold));
        u32x4::ZERO - below
    }
}

/// All ones, which is −1, in the lanes that are at or below a threshold.
#[inline(always)]
fn is_below(sum: f32x4, threshold: f32x4) -> u32x4 {
    cast(sum.simd_le(threshold))
}

impl Rule for Proportional {
    #[inline(always)]
    fn choose(self, _: &[f32x4; DIRECTIONS], sums: &Sums, draws: &mut Draws) -> u32x4 {
        sums.at_or_below(draws.next(sums.alive, sums.all_alive))
    }

    #[inline(always)]
    fn choose_one(self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        random_proportional(weights, stream)
    }
}

impl Rule for PseudoProportional {
    #[inline(always)]
    fn choose(self, weights: &[f32x4; DIRECTIONS], sums: &Sums, draws: &mut Draws) -> u32x4 {
        let q = draws.next(sums.alive, sums.all_alive);
        let greedy: u32x4 = cast(q.simd_le(f32x4::splat(self.greedy)));
        let first = first_largest(weights);
        let others = sums.alive & !greedy;
        if !others.any() {
            return first;
        }
        greedy.bitselect(first, sums.at_or_below(draws.next(others, false)))
    }

    #[inline(always)]
    fn choose_one(self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        pseudo_random_proportional(weights, self.q0, stream)
    }
}

impl Rule for Maximal {
    /// The random proportional rule over 1 for each step of the largest weight.
    #[inline(always)]
    fn choose(self, weights: &[f32x4; DIRECTIONS], sums: &Sums, draws: &mut Draws) -> u32x4 {
        let largest = largest(weights);
        let mut equal = *weights;
        for weight in &mut equal {
            *weight = f32x4::ONE & weight.simd_ge(largest);
        }
        Sums::of(&equal).at_or_below(draws.next(sums.alive, sums.all_alive))
    }

    #[inline(always)]
    fn choose_one(self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        maximal(weights, stream)
    }
}

#[inline(always)]
fn largest(weights: &[f32x4; DIRECTIONS]) -> f32x4 {
    let [a, b, c, d, e, f, g, h] = *weights;
    a.fast_max(b).fast_max(c.fast_max(d)).fast_max(e.fast_max(f).fast_max(g.fast_max(h)))
}

/// The first direction of the largest weight.
#[inline(always)]
fn first_largest(weights: &[f32x4; DIRECTIONS]) -> u32x4 {
    let largest = largest(weights);
    let (mut passed, mut first) = (u32x4::MAX, u32x4::ZERO);
    for weight in &weights[..DIRECTIONS - 1] {
        passed &= cast::<f32x4, u32x4>(weight.simd_lt(largest));
        first -= passed;
    }
    first
}

#[cfg(test)]
mod tests {
    use rand::Rng;

    use super::*;
    use crate::rng::Streams;

    /// Rows of all kinds: dead ends, single steps, equal weights, weights far apart.
    fn row(stream: &mut Stream) -> Row {
        const WEIGHTS: [f32; 5] = [0.0, 1e-30, 0.25, 0.25, 1.0];
        let (kind, feasible) = (stream.next_u32() % 4, stream.next_u32());
        std::array::from_fn(|d| match (kind, feasible >> d & 1) {
            (0, _) | (_, 0) => 0.0,
            (1, _) => crate::rng::unit_f32(stream.next_u32()),
            _ => WEIGHTS[stream.next_u32() as usize % WEIGHTS.len()],
        })
    }

    fn chooses_as_alone(rule: impl Rule) {
        let streams = Streams::new(5, "test", 0);
        let mut alone: [Stream; 4] = std::array::from_fn(|k| streams.ant(1, k as u32));
        let mut draws = Draws::of(alone.each_ref());
        let mut made = streams.daemon(0);
        for _ in 0..5000 {
            let rows: [Row; 4] = std::array::from_fn(|_| row(&mut made));
            let weights = std::array::from_fn(|d| f32x4::new(rows.map(|row| row[d])));
            let sums = Sums::of(&weights);
            let (steps, alive) = (rule.choose(&weights, &sums, &mut draws).to_array(), sums.alive.to_array());
            for k in 0..4 {
                let step = (alive[k] != 0).then_some(steps[k] as Direction);
                assert_eq!(step, rule.choose_one(&rows[k], &mut alone[k]), "{:?}", rows[k]);
            }
        }
        assert_eq!(draws.streams(), alone);
    }

    #[test]
    fn four_choose_as_each_alone() {
        chooses_as_alone(Proportional);
        for q0 in [0.0, 1e-9, 0.3, 0.7, 0.9, 1.0 - 1e-9, 1.0] {
            chooses_as_alone(PseudoProportional::new(q0));
        }
        chooses_as_alone(Maximal);
    }
}
