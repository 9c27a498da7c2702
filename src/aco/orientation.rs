//! Steps by where they lead beside another direction: that to the goal, or that from start to goal.

use crate::map::{OFFSETS, Point};

use super::trails::Row;

/// Which way to go from one point to another: the sign of each coordinate's difference, 0 where there is none.
pub fn signs(from: Point, to: Point) -> (i32, i32) {
    let sign = |a: u32, b: u32| i32::from(b > a) - i32::from(b < a);
    (sign(from.x, to.x), sign(from.y, to.y))
}

/// The angle between two of the eight directions in eighths of a circle, 0 to 4; the second may be (0, 0), none.
pub fn eighths(a: (i32, i32), b: (i32, i32)) -> u32 {
    if a == b { 0 } else { 4 - (a.0 + b.0).unsigned_abs() - (a.1 + b.1).unsigned_abs() }
}

/// Leaves of the steps from `here` the three whose directions are nearest to that of the goal; of equal ones the first.
#[inline(always)]
pub fn nearest_three(weights: &mut Row, here: Point, goal: Point) {
    let to_goal = signs(here, goal);
    let angles = OFFSETS.map(|step| eighths(step, to_goal));
    let mut kept = 0;
    for angle in 0..=4 {
        for (weight, _) in weights.iter_mut().zip(angles).filter(|(weight, a)| *a == angle && **weight > 0.0) {
            kept += 1;
            if kept > 3 {
                *weight = 0.0;
            }
        }
    }
}

/// Leaves of the steps from `here` those that lead in neither coordinate against the way from start to goal; where there is none, not against
/// that from here; where there is none, all.
#[inline(always)]
pub fn onward(weights: &mut Row, here: Point, start: Point, goal: Point) {
    for (x, y) in [signs(start, goal), signs(here, goal)] {
        let left: Row = std::array::from_fn(|d| {
            let (dx, dy) = OFFSETS[d];
            if dx * x < 0 || dy * y < 0 { 0.0 } else { weights[d] }
        });
        if left.iter().any(|&weight| weight > 0.0) {
            *weights = left;
            return;
        }
    }
}
