//! The length of the shortest path with 8 moves on a plane, by jump points: Harabor, Grastien, "Online graph pruning for pathfinding on
//! grid maps", Proceedings of AAAI 25 (2011) 1114–1119, doi:10.1609/aaai.v25i1.7994, with the block-based scanning and without the
//! intermediate points of the same authors' paper of 2014 (see [`super::jump_map`]).
//!
//! Of many equally short paths only those are followed that take their diagonal steps first. Their corners are jump points; all cells
//! between them are passed over. What can follow a step, by corner rule:
//!
//! | step | `both-free` | `always`, `one-free` |
//! |---|---|---|
//! | straight | on; past a corner also to its side and diagonally around it | on; before a corner also diagonally around it |
//! | diagonal | on, and straight along both of its axes | the same; past a blocked cell also diagonally around it |
//!
//! The second column is printed in 2011; the first is what the same reasoning gives where no corner is cut. Under `one-free` the second
//! holds as under `always`: a step around a corner passes the cell ahead, which must be free, and each step is tried by its rule.
//!
//! A cell can be reached by equally short ways in several directions. Each of them is followed: what may follow one need not follow
//! another.
//!
//! Steps are counted, straight and diagonal ones, and lengths computed from the counts: different lengths differ by far more than rounding
//! does, equal ones not at all. So nothing here needs a tolerance, and the length has the bits of [`Scenario::path_length`].
//!
//! [`Scenario::path_length`]: crate::scenario::Scenario::path_length

use super::jump_map::{JumpMap, beside};
use crate::map::{CornerRule, DIRECTIONS, Direction, Grid, Point, counted_length, is_diagonal, offset};

/// How many steps a way has. Both numbers stay below 2²⁵: a shortest path enters no cell twice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Steps {
    straight: u32,
    diagonal: u32,
}

impl Steps {
    const BITS: u32 = 28;

    /// With the least that is left to the goal: on an open map.
    #[inline(always)]
    fn with_rest(self, from: Point, goal: Point) -> Self {
        let (dx, dy) = (from.x.abs_diff(goal.x), from.y.abs_diff(goal.y));
        Self { straight: self.straight + dx.abs_diff(dy), diagonal: self.diagonal + dx.min(dy) }
    }

    #[inline(always)]
    fn length(self) -> f64 {
        counted_length(self.straight, self.diagonal)
    }

    /// In one number with the directions in which the cell was reached, never 0: there is one at least.
    #[inline(always)]
    fn packed(self, directions: u8) -> u64 {
        u64::from(self.straight) << (8 + Self::BITS) | u64::from(self.diagonal) << 8 | u64::from(directions)
    }

    #[inline(always)]
    fn unpacked(number: u64) -> Self {
        Self { straight: (number >> (8 + Self::BITS)) as u32, diagonal: (number >> 8) as u32 & ((1 << Self::BITS) - 1) }
    }
}

/// A jump point that waits to be expanded, with the direction in which it was reached.
#[derive(Debug, Clone, Copy)]
struct Open {
    /// Length of the way to it and the least that is left.
    f: f64,
    cell: u32,
    direction: Direction,
}

/// Buckets of the queue to a cell of f. Wider ones are expanded in looser order, narrower ones are more.
const BUCKETS_PER_CELL: f64 = 4.0;

/// What shortest paths on one map are found with; the map's own part is worked out once.
#[derive(Debug, Clone)]
pub(super) struct JumpPoints {
    map: JumpMap,
    /// Width of the map with its border.
    stride: u32,
    /// By cell, border included: the shortest way to it and in which directions it arrives; 0 where none is known.
    reached: Vec<u64>,
    /// The cells whose entry is not 0.
    touched: Vec<u32>,
    /// Jump points to be expanded, by f. A bucket is worked off last in, first out.
    buckets: Vec<Vec<Open>>,
    /// The bucket at work, and the f at which bucket 0 begins.
    bucket: usize,
    base: f64,
    goal: Point,
    /// Length of the shortest path so far.
    bound: f64,
    expansions: u64,
}

impl JumpPoints {
    /// On a map as a plane, with 8 moves.
    pub(super) fn new(grid: &Grid, rule: CornerRule) -> Self {
        let stride = grid.width() + 2;
        let cells = stride as usize * (grid.height() as usize + 2);
        Self {
            map: JumpMap::new(grid, rule),
            stride,
            reached: vec![0; cells],
            touched: Vec::new(),
            buckets: Vec::new(),
            bucket: 0,
            base: 0.0,
            goal: Point::new(0, 0),
            bound: f64::INFINITY,
            expansions: 0,
        }
    }

    /// Jump points that were expanded, in all searches so far.
    pub(super) fn expansions(&self) -> u64 {
        self.expansions
    }

    /// Length in cells of the shortest path between two points of the map; `None` where there is none.
    pub(super) fn shortest(&mut self, start: Point, goal: Point) -> Option<f64> {
        if start == goal {
            return Some(0.0);
        }
        let within_border = |p: Point| Point::new(p.x + 1, p.y + 1);
        let start = within_border(start);
        self.goal = within_border(goal);
        if self.map.is_blocked(start) || self.map.is_blocked(self.goal) {
            return None;
        }
        self.touched.drain(..).for_each(|cell| self.reached[cell as usize] = 0);
        self.buckets.iter_mut().for_each(Vec::clear);
        self.bucket = 0;
        self.base = libm::floor(Steps::default().with_rest(start, self.goal).length());
        self.bound = f64::INFINITY;
        self.expansions += 1;
        for d in 0..DIRECTIONS as Direction {
            self.follow(start, d, Steps::default());
        }
        while let Some((at, d, steps)) = self.pop() {
            self.expand(at, d, steps);
        }
        self.bound.is_finite().then_some(self.bound)
    }

    /// The next jump point that can lead to a shorter path; those to which a shorter way has turned up are left out.
    fn pop(&mut self) -> Option<(Point, Direction, Steps)> {
        while self.bucket < self.buckets.len() && self.base + self.bucket as f64 / BUCKETS_PER_CELL < self.bound {
            let Some(Open { f, cell, direction }) = self.buckets[self.bucket].pop() else {
                self.bucket += 1;
                continue;
            };
            if f >= self.bound {
                continue;
            }
            let at = Point::new(cell % self.stride, cell / self.stride);
            let steps = Steps::unpacked(self.reached[cell as usize]);
            if steps.with_rest(at, self.goal).length() == f {
                return Some((at, direction, steps));
            }
        }
        None
    }

    /// Follows what can come after a jump point that was reached in direction d.
    fn expand(&mut self, at: Point, d: Direction, steps: Steps) {
        self.expansions += 1;
        self.follow(at, d, steps);
        let (dx, dy) = offset(d);
        if is_diagonal(d) {
            // What stands beside the step that led here is walked around.
            for (turned, past) in [((dx, -dy), (0, -dy)), ((-dx, dy), (-dx, 0))] {
                if self.map.is_blocked(beside(at, direction(past))) {
                    self.diagonal(at, direction(turned), steps);
                }
            }
            return;
        }
        let before = beside(at, direction((-dx, -dy)));
        for (sx, sy) in [(dy, dx), (-dy, -dx)] {
            let (side, around) = (direction((sx, sy)), direction((dx + sx, dy + sy)));
            if self.map.cuts() {
                if self.map.is_blocked(beside(at, side)) {
                    self.diagonal(at, around, steps);
                }
            } else if self.map.is_blocked(beside(before, side)) && !self.map.is_blocked(beside(at, side)) {
                self.straight(at, side, steps);
                self.diagonal(at, around, steps);
            }
        }
    }

    #[inline(always)]
    fn follow(&mut self, at: Point, d: Direction, steps: Steps) {
        if is_diagonal(d) { self.diagonal(at, d, steps) } else { self.straight(at, d, steps) }
    }

    /// Walks straight to the first stop: the goal, a jump point, or a blocked cell, where nothing follows.
    #[inline(always)]
    fn straight(&mut self, from: Point, d: Direction, steps: Steps) {
        let to = self.map.stop(from, d);
        let after = |p: Point| Steps { straight: steps.straight + p.x.abs_diff(from.x) + p.y.abs_diff(from.y), ..steps };
        if lies_between(self.goal, from, to) {
            self.bound = self.bound.min(after(self.goal).length());
        } else if !self.map.is_blocked(to) {
            self.push(to, d, after(to));
        }
    }

    /// Walks diagonally, and straight along both axes from every cell on the way.
    fn diagonal(&mut self, from: Point, d: Direction, mut steps: Steps) {
        let (dx, dy) = offset(d);
        let (across, along) = (direction((dx, 0)), direction((0, dy)));
        let mut at = from;
        while self.map.allows(at, d) {
            at = beside(at, d);
            steps.diagonal += 1;
            if at == self.goal {
                self.bound = self.bound.min(steps.length());
                return;
            }
            self.straight(at, across, steps);
            self.straight(at, along, steps);
            if self.map.cuts() && self.passes_a_corner(at, (dx, dy)) {
                self.push(at, d, steps);
                return;
            }
        }
    }

    /// Whether beside the diagonal step that led here a cell is blocked that can be walked around.
    #[inline(always)]
    fn passes_a_corner(&self, at: Point, (dx, dy): (i32, i32)) -> bool {
        let blocked = |by| self.map.is_blocked(beside(at, direction(by)));
        (blocked((-dx, 0)) && !blocked((-dx, dy))) || (blocked((0, -dy)) && !blocked((dx, -dy)))
    }

    /// Takes note of a jump point, if no shorter way to it is known and it can lead to a shorter path.
    #[inline(always)]
    fn push(&mut self, at: Point, d: Direction, steps: Steps) {
        let f = steps.with_rest(at, self.goal).length();
        if f >= self.bound {
            return;
        }
        let cell = at.y * self.stride + at.x;
        let known = &mut self.reached[cell as usize];
        let (before, bit) = (Steps::unpacked(*known), 1 << d);
        if *known == 0 {
            self.touched.push(cell);
            *known = steps.packed(bit);
        } else if before == steps && *known & u64::from(bit) == 0 {
            *known |= u64::from(bit);
        } else if steps.length() < before.length() {
            *known = steps.packed(bit);
        } else {
            return;
        }
        // No way on has a smaller f, but for rounding.
        let bucket = (((f - self.base) * BUCKETS_PER_CELL) as usize).max(self.bucket);
        if bucket >= self.buckets.len() {
            self.buckets.resize_with(bucket + 1, Vec::new);
        }
        self.buckets[bucket].push(Open { f, cell, direction: d });
    }
}

/// The direction of a step to a neighbour.
#[inline(always)]
fn direction((dx, dy): (i32, i32)) -> Direction {
    // In reading order, without the cell itself.
    let place = (dy + 1) * 3 + dx + 1;
    (place - i32::from(place > 4)) as Direction
}

/// Whether a cell lies on a straight walk behind its first cell.
#[inline(always)]
fn lies_between(cell: Point, from: Point, to: Point) -> bool {
    let within = |v: u32, a: u32, b: u32| a.min(b) <= v && v <= a.max(b);
    cell != from && within(cell.x, from.x, to.x) && within(cell.y, from.y, to.y)
}

#[cfg(test)]
mod tests;
