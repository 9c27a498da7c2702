//! The ground of a terrain as steps and segments feel it: how long they are, and how steep.
//!
//! A segment between the centres of two cells is followed in max(|dx|, |dy|) equal parts. Between them the ground is interpolated linearly
//! between the two cells beside it; so a step to a neighbour is the straight line between two heights, and a step of [`super::FAR`] has a
//! joint halfway.

use std::sync::Arc;

use super::grid::Cell;
use super::movement::{Direction, offset, step_length};

/// Heights as lengths in cells, and the steepest ground that may be walked.
#[derive(Debug, Clone)]
pub struct Relief {
    heights: Arc<[f32]>,
    width: u32,
    /// Cells per unit of the heights.
    scale: f64,
    /// Largest rise over run; infinite where there is no limit.
    steepest: f64,
}

/// What a segment is on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// True length in cells.
    pub length: f64,
    /// Cells up, at least 0.
    pub climb: f64,
    /// Cells down, at least 0.
    pub descent: f64,
    /// Largest rise over run, either way.
    pub steepness: f64,
}

impl Relief {
    /// Of a map of this width; `scale` is cells per unit of the heights, `steepest` the largest rise over run.
    pub fn new(heights: Arc<[f32]>, width: u32, scale: f64, steepest: f64) -> Self {
        Self { heights, width, scale, steepest }
    }

    /// Largest rise over run that may be walked; infinite where there is no limit.
    #[cfg(feature = "whole")]
    pub fn steepest(&self) -> f64 {
        self.steepest
    }

    /// Height of a cell in cells.
    #[inline(always)]
    pub fn height(&self, c: Cell) -> f64 {
        f64::from(self.heights[c as usize]) * self.scale
    }

    /// A step in direction `d` from one cell to another.
    #[inline(always)]
    pub fn step(&self, from: Cell, to: Cell, d: Direction) -> Stretch {
        if (d as usize) < super::DIRECTIONS {
            part(step_length(d), self.height(to) - self.height(from))
        } else {
            self.far_step(from, to, d)
        }
    }

    /// A step of two cells: as [`Relief::segment`], whose only joint lies halfway between the two cells that the step passes.
    #[inline]
    fn far_step(&self, from: Cell, to: Cell, d: Direction) -> Stretch {
        let (dx, dy) = offset(d);
        let half = dy / 2 * self.width as i32 + dx / 2;
        let (one, other) = (from.wrapping_add_signed(half), to.wrapping_add_signed(-half));
        let middle = self.mixed(one.min(other), one.max(other), 0.5);
        let run = step_length(d) / 2.0;
        let (before, after) = (part(run, middle - self.height(from)), part(run, self.height(to) - middle));
        Stretch {
            length: before.length + after.length,
            climb: before.climb + after.climb,
            descent: before.descent + after.descent,
            steepness: before.steepness.max(after.steepness),
        }
    }

    /// Height in cells between two cells, this share of the way from the first; where one has no data, the other's. The nearer of the two
    /// is one that the segment comes through, so it has.
    #[inline]
    fn mixed(&self, low: Cell, high: Cell, share: f64) -> f64 {
        let (low, high) = (self.height(low), self.height(high));
        match (low.is_nan(), high.is_nan()) {
            (true, _) => high,
            (_, true) => low,
            _ => low + (high - low) * share,
        }
    }

    /// Whether a step is not too steep.
    #[cfg(feature = "whole")]
    #[inline]
    pub(super) fn passable(&self, from: Cell, to: Cell, d: Direction) -> bool {
        self.steepest.is_infinite() || self.step(from, to, d).steepness <= self.steepest
    }

    /// Whether a segment is not too steep anywhere.
    pub fn is_passable(&self, from: Cell, to: Cell) -> bool {
        self.steepest.is_infinite() || self.segment(from, to).steepness <= self.steepest
    }

    /// The straight segment between the centres of two cells, along the ground.
    pub fn segment(&self, from: Cell, to: Cell) -> Stretch {
        let (dx, dy) = (column(self, to) - column(self, from), row(self, to) - row(self, from));
        let parts = dx.abs().max(dy.abs());
        let run = libm::sqrt((dx * dx + dy * dy) as f64) / (parts.max(1)) as f64;
        let mut whole = Stretch { length: 0.0, climb: 0.0, descent: 0.0, steepness: 0.0 };
        let mut before = self.height(from);
        for k in 1..=parts {
            let here = self.between(from, (dx, dy), k, parts);
            let next = part(run, here - before);
            whole.length += next.length;
            whole.climb += next.climb;
            whole.descent += next.descent;
            whole.steepness = whole.steepness.max(next.steepness);
            before = here;
        }
        whole
    }

    /// Heights in cells along a segment at the ends of its equal parts, without its first end.
    pub fn profile(&self, from: Cell, to: Cell) -> impl Iterator<Item = f64> + use<'_> {
        let offset = (column(self, to) - column(self, from), row(self, to) - row(self, from));
        let parts = offset.0.abs().max(offset.1.abs());
        (1..=parts).map(move |k| self.between(from, offset, k, parts))
    }

    /// Height in cells where part `k` of a segment ends: along the long axis that is at a cell's centre, along the other between two.
    fn between(&self, from: Cell, (dx, dy): (i64, i64), k: i64, parts: i64) -> f64 {
        let (x, y) = (column(self, from), row(self, from));
        // Twice the way along each axis, in whole numbers: floor and remainder are exact.
        let (across_x, across_y) = (dx * k, dy * k);
        let (low_x, low_y) = (x + across_x.div_euclid(parts), y + across_y.div_euclid(parts));
        let (over_x, over_y) = (across_x.rem_euclid(parts), across_y.rem_euclid(parts));
        let at = |x: i64, y: i64| (y * i64::from(self.width) + x) as Cell;
        let low = at(low_x, low_y);
        if over_x == 0 && over_y == 0 {
            return self.height(low);
        }
        // One axis is the long one and has no remainder.
        let high = at(low_x + i64::from(over_x > 0), low_y + i64::from(over_y > 0));
        self.mixed(low, high, (over_x + over_y) as f64 / parts as f64)
    }
}

fn column(relief: &Relief, c: Cell) -> i64 {
    i64::from(c % relief.width)
}

fn row(relief: &Relief, c: Cell) -> i64 {
    i64::from(c / relief.width)
}

/// A straight part of this run and rise.
#[inline(always)]
fn part(run: f64, rise: f64) -> Stretch {
    Stretch {
        length: libm::sqrt(run * run + rise * rise),
        climb: rise.max(0.0),
        descent: (-rise).max(0.0),
        steepness: rise.abs() / run,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn relief(heights: &[f32], width: u32) -> Relief {
        Relief::new(heights.into(), width, 0.5, f64::INFINITY)
    }

    #[test]
    fn steps_and_segments_by_hand() {
        // 3 × 2, half a cell per unit.
        let r = relief(&[0.0, 2.0, 6.0, 4.0, 8.0, 0.0], 3);
        assert_eq!(r.step(0, 1, 4), Stretch { length: 2f64.sqrt(), climb: 1.0, descent: 0.0, steepness: 1.0 });
        assert!((r.step(4, 2, 2).length - 3f64.sqrt()).abs() < 1e-12);
        assert_eq!(r.segment(0, 1), r.step(0, 1, 4));
        assert_eq!(r.segment(3, 1).length, r.step(3, 1, 2).length);
        // (0,0) → (2,1): halfway between (1,0) and (1,1), at (1 + 4) / 2 = 2.5 cells; then down to 0.
        let far = r.step(0, 5, 13);
        let run = 5f64.sqrt() / 2.0;
        assert!((far.length - 2.0 * (run * run + 2.5 * 2.5).sqrt()).abs() < 1e-12);
        assert_eq!((far.climb, far.descent), (2.5, 2.5));
        assert_eq!(r.profile(0, 5).collect::<Vec<_>>(), [2.5, 0.0]);
        assert_eq!(far, r.segment(0, 5));
        // Backwards it is as long.
        assert_eq!(r.segment(5, 0).length, far.length);
        // A corner may hide the farther of the two cells, which then need not have data: 2 up to (1,0), 2.5 up to (2,1), 1 down.
        let hidden = relief(&[0.0, 4.0, f32::NAN, f32::NAN, f32::NAN, f32::NAN, 9.0, 7.0], 4).segment(0, 7);
        let run = 10f64.sqrt() / 3.0;
        let long = |rise: f64| (run * run + rise * rise).sqrt();
        assert!((hidden.length - long(2.0) - long(2.5) - long(1.0)).abs() < 1e-12);
        assert_eq!((hidden.climb, hidden.descent), (4.5, 1.0));
        assert_eq!(r.segment(2, 2), Stretch { length: 0.0, climb: 0.0, descent: 0.0, steepness: 0.0 });
    }
}
