//! Ground that costs more than its length: a factor for each cell, at least 1.
//!
//! What a segment costs is the integral of the factors along it: the length of its part in each cell, times that cell's factor. A step to a
//! neighbour lies half in one cell and half in the other, whether straight or diagonal, so it costs its length times the mean of the two
//! factors. A step of [`super::FAR`] crosses four cells in equal parts: its length times the mean of the four.

use std::sync::Arc;

use super::grid::{Cell, Grid};
use super::movement::{DIRECTIONS, Direction, beside_far, offset, step_length};

/// Largest factor of a cell: beyond it a wall is meant.
pub const MAX_FACTOR: f32 = 1000.0;

/// Which of a step's cells are charged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Charge {
    /// All that the step crosses, by the length of its part in each.
    #[default]
    Crossed,
    /// The one that it enters, for its whole length; steps to neighbours alone. So SmacPlanner2D of Nav2 counts
    /// (`Node2D::getTraversalCost`, nav2_smac_planner).
    Entered,
}

/// Mean factor of the cells that a step in direction `d` crosses, by the factor of the cell that lies by (dx, dy) from its first one.
#[inline]
pub fn mean_factor(d: Direction, factor: impl Fn(i32, i32) -> f64) -> f64 {
    let (dx, dy) = offset(d);
    if (d as usize) < DIRECTIONS {
        return (factor(0, 0) + factor(dx, dy)) * 0.5;
    }
    let [near, far] = beside_far(d).map(|(dx, dy)| factor(dx, dy));
    (factor(0, 0) + near + far + factor(dx, dy)) * 0.25
}

/// What each cell of a map costs.
#[derive(Debug, Clone)]
pub struct Weights {
    factors: Arc<[f32]>,
    width: i32,
    least: f64,
    most: f64,
    charge: Charge,
}

impl Weights {
    /// Of a map with such a factor for each cell, row by row.
    pub fn new(factors: Arc<[f32]>, grid: &Grid, charge: Charge) -> Self {
        let free = factors.iter().zip(grid.blocked()).filter(|(_, blocked)| !**blocked).map(|(&factor, _)| factor);
        let (least, most) = free.fold((MAX_FACTOR, 1.0), |(least, most), factor| (factor.min(least), factor.max(most)));
        Self { factors, width: grid.width() as i32, least: f64::from(least), most: f64::from(most), charge }
    }

    /// The factor of a cell.
    #[inline(always)]
    pub fn of(&self, c: Cell) -> f64 {
        f64::from(self.factors[c as usize])
    }

    /// The smallest factor of a free cell: no way costs less than its length times this.
    pub fn least(&self) -> f64 {
        self.least
    }

    /// The largest factor of a free cell.
    pub fn most(&self) -> f64 {
        self.most
    }

    /// Which cells are charged.
    pub fn charge(&self) -> Charge {
        self.charge
    }

    /// Cost of the step in direction `d` from one cell to another, in cells.
    #[inline]
    pub fn step(&self, from: Cell, to: Cell, d: Direction) -> f64 {
        let length = step_length(d);
        if self.charge == Charge::Entered {
            return length * self.of(to);
        }
        length * mean_factor(d, |dx, dy| self.of(from.wrapping_add_signed(dy * self.width + dx)))
    }

    /// Cost of the straight segment between the centres of two cells, in cells; of a step what [`Weights::step`] says.
    pub fn segment(&self, from: Cell, to: Cell) -> f64 {
        let at = |c: Cell| (i64::from(c as i32 % self.width), i64::from(c as i32 / self.width));
        let ((x, y), (to_x, to_y)) = (at(from), at(to));
        let (dx, dy) = (to_x - x, to_y - y);
        let length = libm::sqrt((dx * dx + dy * dy) as f64);
        if self.charge == Charge::Entered {
            return length * self.of(to);
        }
        let mut sum = 0.0;
        for (share, (over_x, over_y)) in Shares::new(dx, dy) {
            sum += share * self.of(((y + over_y) * i64::from(self.width) + x + over_x) as Cell);
        }
        length * sum
    }
}

/// The cells that a segment by (dx, dy) crosses, from the first on, each with the share of the segment that lies in it.
///
/// Times are whole numbers on the scale 2·|dx|·|dy| for the whole segment, so that shares are exact but for one division each.
struct Shares {
    at: (i64, i64),
    to: (i64, i64),
    /// When the cell is left by a side in x and in y.
    leaves: (i64, i64),
    more: (i64, i64),
    now: i64,
    whole: i64,
    done: bool,
}

impl Shares {
    fn new(dx: i64, dy: i64) -> Self {
        let (nx, ny) = (dx.abs(), dy.abs());
        // Along an axis the other one is never left.
        let whole = if nx == 0 || ny == 0 { 2 * nx.max(ny) } else { 2 * nx * ny };
        let each = |n: i64| if n == 0 { i64::MAX / 2 } else { whole / n };
        let more = (each(nx), each(ny));
        Self { at: (0, 0), to: (dx, dy), leaves: (more.0 / 2, more.1 / 2), more, now: 0, whole, done: whole == 0 }
    }
}

impl Iterator for Shares {
    type Item = (f64, (i64, i64));

    fn next(&mut self) -> Option<Self::Item> {
        if self.done {
            return None;
        }
        let (cell, until) = (self.at, self.leaves.0.min(self.leaves.1).min(self.whole));
        let share = (until - self.now) as f64 / self.whole as f64;
        self.now = until;
        self.done = cell == self.to;
        if self.leaves.0 == until {
            self.at.0 += self.to.0.signum();
            self.leaves.0 += self.more.0;
        }
        if self.leaves.1 == until {
            self.at.1 += self.to.1.signum();
            self.leaves.1 += self.more.1;
        }
        Some((share, cell))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::SQRT_2;

    use super::*;
    use crate::map::{ALL_DIRECTIONS, offset};

    fn weights(factors: &[f32], width: u32) -> Weights {
        let grid = Grid::open(width, factors.len() as u32 / width).unwrap();
        Weights::new(factors.into(), &grid, Charge::default())
    }

    #[test]
    fn steps_and_segments_by_hand() {
        // 4 × 3.
        let w = weights(&[1.0, 3.0, 1.0, 1.0, 5.0, 2.0, 1.0, 9.0, 1.0, 4.0, 7.0, 1.0], 4);
        assert_eq!((w.least(), w.most()), (1.0, 9.0));
        assert_eq!(w.step(0, 1, 4), 2.0);
        assert!((w.step(0, 5, 7) - 1.5 * SQRT_2).abs() < 1e-15);
        // (0,0) → (2,1) crosses (1,0) and (1,1): √5 · (1 + 3 + 2 + 1) / 4.
        assert!((w.step(0, 6, 13) - 5f64.sqrt() * 1.75).abs() < 1e-15);
        // (0,1) → (3,1): half of 5, all of 2 and 1, half of 9.
        assert!((w.segment(4, 7) - (2.5 + 3.0 + 4.5)).abs() < 1e-12);
        // (0,0) → (3,2): leaves (0,0) at x = ½, a sixth of the way, then (1,0) at y = ½, a quarter.
        let by_hand = 13f64.sqrt() * (1.0 / 6.0 + 3.0 / 12.0 + 2.0 / 4.0 + 1.0 / 4.0 * 1.0 + 7.0 / 12.0 + 1.0 / 6.0);
        let shares: f64 = Shares::new(3, 2).map(|(share, _)| share).sum();
        assert!((shares - 1.0).abs() < 1e-15);
        assert_eq!(Shares::new(3, 2).map(|(_, at)| at).collect::<Vec<_>>(), [(0, 0), (1, 0), (1, 1), (2, 1), (2, 2), (3, 2)]);
        assert!((w.segment(0, 11) - by_hand).abs() < 1e-12, "{} {by_hand}", w.segment(0, 11));
        assert_eq!(w.segment(3, 3), 0.0);
    }

    #[test]
    fn a_step_is_the_segment_between_its_ends() {
        let factors: Vec<f32> = (0..49u32).map(|i| 1.0 + (i.wrapping_mul(2_654_435_761) >> 24) as f32 / 16.0).collect();
        let w = weights(&factors, 7);
        for d in 0..ALL_DIRECTIONS as Direction {
            let (dx, dy) = offset(d);
            let to = (24 + dy * 7 + dx) as Cell;
            assert!((w.step(24, to, d) - w.segment(24, to)).abs() < 1e-12, "direction {d}");
            assert!((w.segment(24, to) - w.segment(to, 24)).abs() < 1e-12, "direction {d} back");
        }
    }

    #[test]
    fn a_segment_is_the_integral_along_it() {
        let factors: Vec<f32> = (0..400u32).map(|i| 1.0 + (i.wrapping_mul(2_654_435_761) >> 22) as f32 / 64.0).collect();
        let w = weights(&factors, 20);
        for (from, to) in [(0u32, 399u32), (17, 280), (380, 3), (45, 59), (21, 361)] {
            let ((x, y), (tx, ty)) = (((from % 20) as f64, (from / 20) as f64), ((to % 20) as f64, (to / 20) as f64));
            let (parts, length) = (400_000, ((tx - x).powi(2) + (ty - y).powi(2)).sqrt());
            let sum: f64 = (0..parts)
                .map(|k| {
                    let t = (f64::from(k) + 0.5) / f64::from(parts);
                    let at = |a: f64, b: f64| (a + (b - a) * t + 0.5).floor() as usize;
                    f64::from(factors[at(y, ty) * 20 + at(x, tx)])
                })
                .sum();
            let slow = length * sum / f64::from(parts);
            assert!((w.segment(from, to) / slow - 1.0).abs() < 1e-4, "{from} → {to}: {} {slow}", w.segment(from, to));
        }
    }

    #[test]
    fn entered_cells_alone_are_charged_where_that_is_asked_for() {
        let grid = Grid::open(2, 2).unwrap();
        let w = Weights::new([1.0, 3.0, 1.0, 2.0].into(), &grid, Charge::Entered);
        assert_eq!((w.step(0, 1, 4), w.step(1, 0, 3)), (3.0, 1.0));
        assert!((w.step(0, 3, 7) - 2.0 * SQRT_2).abs() < 1e-15);
    }
}
