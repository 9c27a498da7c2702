//! The weights τ^α·η^β of every step, kept by cell and direction: what the rules of [`super::selection`] choose by.
//!
//! τ and η are divided by the largest of the cell's feasible steps before they are raised: selection compares steps of one cell only,
//! plain powers would leave the range of f32 (β = 25), and trails far from all paths evaporate for hundreds of iterations. So the best
//! step of a cell weighs about 1 whatever the scale of its trails; a feasible step keeps at least [`FLOOR`], an infeasible one has 0.

use wide::{bytemuck::cast, f32x4};

use crate::map::Cell;
#[cfg(test)]
use crate::map::DIRECTIONS;
use crate::planner::held;

use super::trails::{Row, Trails};
use super::visibility::{Sight, Visibility};

/// Smallest weight of a feasible step: it can always be taken when nothing else is left.
pub(super) const FLOOR: f32 = 1e-30;

/// Where a walk reads the weights of the steps from a cell.
pub trait Weights {
    /// Of the steps from a cell; 0 for infeasible ones, and for all where they are not known yet.
    fn row(&mut self, c: Cell) -> &Row;

    /// Works out the weights of a cell that are not known yet; false where they are. Whoever finds all of a row to be 0 asks, and so no
    /// time is spent on asking elsewhere.
    fn learn(&mut self, _c: Cell) -> bool {
        false
    }

    /// Whether the weights of a cell are known, or could be learnt. Otherwise an ant there has to wait.
    fn knows(&self, _c: Cell) -> bool {
        true
    }
}

/// A table that others read at the same time: nothing can be learnt.
impl Weights for &WeightTable {
    #[inline(always)]
    fn row(&mut self, c: Cell) -> &Row {
        WeightTable::row(self, c)
    }

    fn knows(&self, c: Cell) -> bool {
        self.visibility.row(c).is_some()
    }
}

/// The weights of every step of a map, 8 a cell: of a cell by which no ant has come they are not known.
#[derive(Debug, Clone)]
pub struct WeightTable {
    alpha: f64,
    visibility: Visibility,
    /// τ^α·(η/η_max)^β; all 0 where they are not known.
    weights: Vec<Row>,
    /// The cells that are.
    known: Vec<Cell>,
}

impl WeightTable {
    /// Empty tables for a map of this many cells.
    pub fn new(cells: usize, alpha: f64) -> Self {
        Self { alpha, visibility: Visibility::new(cells), weights: vec![Row::default(); cells], known: Vec::new() }
    }

    /// The same for who only asks for [`WeightTable::weigh_now`].
    pub fn passing(cells: usize, alpha: f64) -> Self {
        Self { visibility: Visibility::new(cells), ..Self::new(0, alpha) }
    }

    /// The weights of a cell, known from now on; false where they were.
    #[inline(never)]
    pub fn learn(&mut self, sight: &Sight, trails: &Trails, c: Cell) -> bool {
        if self.visibility.row(c).is_some() {
            return false;
        }
        self.known.push(c);
        let seen = self.visibility.learn(sight, c);
        self.weights[c as usize] = weigh(&trails.relative(c), self.alpha, seen);
        true
    }

    /// The weights of the steps from a cell; all 0 where they are not known.
    #[inline(always)]
    pub fn row(&self, c: Cell) -> &Row {
        &self.weights[c as usize]
    }

    /// Everything is to be learnt again: η has changed.
    pub fn forget_all(&mut self) {
        self.known.drain(..).for_each(|c| self.weights[c as usize] = Row::default());
        self.visibility.forget_all();
    }

    /// The same for these cells alone.
    #[cfg(feature = "whole")]
    pub fn forget(&mut self, cells: &[Cell]) {
        for &c in cells {
            self.visibility.forget(c);
            if let Some(weights) = self.weights.get_mut(c as usize) {
                *weights = Row::default();
            }
        }
        self.known.retain(|&c| self.visibility.row(c).is_some());
    }

    /// The weights of a cell as its trails are now: worked out, and not kept.
    #[inline(always)]
    pub(super) fn weigh_now(&mut self, sight: &Sight, trails: &mut Trails, c: Cell) -> Row {
        let seen = match self.visibility.row(c) {
            Some(seen) => seen,
            None => self.visibility.learn(sight, c),
        };
        weigh_here(trails.here(c), self.alpha, seen)
    }

    /// Recomputes the weights whose trail has changed.
    #[inline(never)]
    pub fn refresh(&mut self, trails: &mut Trails) {
        let Self { alpha, visibility, weights, known } = self;
        trails.take_changes(known.iter().copied(), |trail, c| {
            if let Some(seen) = visibility.row(c) {
                weights[c as usize] = weigh(trail, *alpha, seen);
            }
        });
    }

    /// What it holds, in bytes, without what snapshots share.
    pub fn bytes(&self) -> usize {
        held(&self.weights) + held(&self.known) + self.visibility.bytes()
    }
}

/// The weights as a walk reads them, with all that is needed to learn more.
pub(super) struct Now<'a> {
    pub table: &'a mut WeightTable,
    pub trails: &'a Trails,
    pub sight: Sight<'a>,
}

impl Weights for Now<'_> {
    #[inline(always)]
    fn row(&mut self, c: Cell) -> &Row {
        self.table.row(c)
    }

    fn learn(&mut self, c: Cell) -> bool {
        self.table.learn(&self.sight, self.trails, c)
    }
}

/// (τ/τ_max)^α · (η/η_max)^β of every step of a cell; 0 where the step is infeasible (`seen` is 0).
#[inline(never)]
pub(super) fn weigh(trail: &Row, alpha: f64, seen: &Row) -> Row {
    weigh_here(trail, alpha, seen)
}

/// [`weigh`], inlined.
#[inline(always)]
fn weigh_here(trail: &Row, alpha: f64, seen: &Row) -> Row {
    let ([a, b], [seen_a, seen_b]): ([f32x4; 2], [f32x4; 2]) = (cast(*trail), cast(*seen));
    let (feasible_a, feasible_b) = (seen_a.simd_gt(f32x4::ZERO), seen_b.simd_gt(f32x4::ZERO));
    let largest = (a & feasible_a).fast_max(b & feasible_b).to_array();
    let largest = f32x4::splat(largest.into_iter().fold(f32::MIN_POSITIVE, |m, t| if t > m { t } else { m }));
    let (mut a, mut b) = (a / largest, b / largest);
    if alpha != 1.0 {
        (a, b) = (raised(a, alpha), raised(b, alpha));
    }
    let floor = f32x4::splat(FLOOR);
    cast([(a * seen_a).fast_max(floor) & feasible_a, (b * seen_b).fast_max(floor) & feasible_b])
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
