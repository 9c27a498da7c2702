//! Which steps are allowed on a grid: 4 or 8 moves, and the corner rule for diagonal ones.
//!
//! None of the papers states its corner rule, yet lengths change by up to 86 % with it; so it belongs to the scenario.

use std::f64::consts::SQRT_2;

use serde::{Deserialize, Serialize};

use super::grid::{Cell, Grid, Point};

/// A direction index 0..8, in reading order of the neighbours: NW, N, NE, W, E, SW, S, SE. The opposite of `d` is `7 - d`.
pub type Direction = u8;

/// Number of directions.
pub const DIRECTIONS: usize = 8;

/// (dx, dy) of each direction; y grows downwards.
pub const OFFSETS: [(i32, i32); DIRECTIONS] = [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)];

/// Whether a direction is diagonal.
pub const fn is_diagonal(d: Direction) -> bool {
    0b1010_0101 >> d & 1 == 1
}

/// The direction that leads back.
pub const fn opposite(d: Direction) -> Direction {
    7 - d
}

/// Length of one step in cells: 1 or √2.
pub const fn step_length(d: Direction) -> f64 {
    if is_diagonal(d) { SQRT_2 } else { 1.0 }
}

/// Octile distance in cells: the length of the shortest path with 8 moves on an open map.
pub fn octile(a: Point, b: Point) -> f64 {
    let (dx, dy) = (f64::from(a.x.abs_diff(b.x)), f64::from(a.y.abs_diff(b.y)));
    (dx - dy).abs() + dx.min(dy) * SQRT_2
}

/// How many moves a cell offers. Serialized as the number 4 or 8.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(try_from = "u8", into = "u8")]
pub enum Moves {
    /// N, E, S, W.
    Four,
    /// With the diagonals.
    #[default]
    Eight,
}

impl TryFrom<u8> for Moves {
    type Error = String;
    fn try_from(n: u8) -> Result<Self, String> {
        match n {
            4 => Ok(Self::Four),
            8 => Ok(Self::Eight),
            _ => Err(format!("moves = {n}: it must be 4 or 8")),
        }
    }
}

impl From<Moves> for u8 {
    fn from(m: Moves) -> u8 {
        match m {
            Moves::Four => 4,
            Moves::Eight => 8,
        }
    }
}

/// When a diagonal step may pass the two cells it squeezes between. Serialized as `always`, `one-free`, `both-free`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum CornerRule {
    /// Always: the adjacency of the textbook MATLAB program.
    Always,
    /// At least one of the two is free.
    OneFree,
    /// Both are free: no corner is cut. The rule of the MovingAI benchmarks.
    #[default]
    BothFree,
}

impl CornerRule {
    /// All rules, loosest first.
    pub const ALL: [Self; 3] = [Self::Always, Self::OneFree, Self::BothFree];

    /// Whether a diagonal step is allowed, given whether each of its two orthogonal cells is free.
    pub const fn allows(self, one_free: bool, other_free: bool) -> bool {
        match self {
            Self::Always => true,
            Self::OneFree => one_free || other_free,
            Self::BothFree => one_free && other_free,
        }
    }
}

/// The movement model of a scenario.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Movement {
    /// 4 or 8 moves.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "4 | 8"))]
    pub moves: Moves,
    /// The rule for diagonal moves; without effect on 4 moves.
    pub corner_rule: CornerRule,
}

impl Movement {
    /// Whether the step from a free cell (x, y) in direction `d` is allowed.
    pub fn allows(self, grid: &Grid, x: i64, y: i64, d: Direction) -> bool {
        let (dx, dy) = OFFSETS[d as usize];
        let (dx, dy) = (i64::from(dx), i64::from(dy));
        if !grid.is_free_at(x + dx, y + dy) {
            return false;
        }
        !is_diagonal(d)
            || (self.moves == Moves::Eight && self.corner_rule.allows(grid.is_free_at(x + dx, y), grid.is_free_at(x, y + dy)))
    }
}

impl Movement {
    /// The allowed steps of a free cell as bits, given which of its eight neighbours are free.
    fn steps(self, [nw, n, ne, w, e, sw, s, se]: [bool; DIRECTIONS]) -> u8 {
        let straight = u8::from(n) << 1 | u8::from(w) << 3 | u8::from(e) << 4 | u8::from(s) << 6;
        if self.moves == Moves::Four {
            return straight;
        }
        let rule = self.corner_rule;
        straight
            | u8::from(nw && rule.allows(n, w))
            | u8::from(ne && rule.allows(n, e)) << 2
            | u8::from(sw && rule.allows(s, w)) << 5
            | u8::from(se && rule.allows(s, e)) << 7
    }
}

/// The allowed steps of every cell, as bits: the one neighbourhood that all planners share.
#[derive(Debug, Clone)]
pub struct MoveSet {
    /// Bit `d` of entry `c`: direction `d` may be taken from cell `c`. Blocked cells have none.
    pub bits: Vec<u8>,
    /// What to add to a cell index for each direction.
    pub delta: [i32; DIRECTIONS],
}

impl MoveSet {
    /// Derives the steps of every cell. Works on a copy of the map with a blocked border, so that no neighbour needs a range check.
    pub fn new(grid: &Grid, movement: Movement) -> Self {
        let (w, h) = (grid.width() as usize, grid.height() as usize);
        let stride = w + 2;
        let mut free = vec![false; stride * (h + 2)];
        for y in 0..h {
            for x in 0..w {
                free[(y + 1) * stride + x + 1] = !grid.is_blocked((y * w + x) as Cell);
            }
        }
        let around = OFFSETS.map(|(dx, dy)| dy as isize * stride as isize + dx as isize);
        let mut bits = vec![0u8; grid.len()];
        for y in 0..h {
            for x in 0..w {
                let at = (y + 1) * stride + x + 1;
                if free[at] {
                    bits[y * w + x] = movement.steps(around.map(|o| free[at.wrapping_add_signed(o)]));
                }
            }
        }
        let delta = OFFSETS.map(|(dx, dy)| dy * grid.width() as i32 + dx);
        Self { bits, delta }
    }

    /// The cell one step away; the step must be allowed.
    #[inline(always)]
    pub fn step(&self, c: Cell, d: Direction) -> Cell {
        c.wrapping_add_signed(self.delta[d as usize])
    }

    /// The direction of the step between two cells that an allowed step joins.
    ///
    /// On maps one or two cells wide several directions add the same to a cell's index; only one of them is allowed.
    pub fn direction(&self, from: Cell, to: Cell) -> Direction {
        let joins = |d: &Direction| self.step(from, *d) == to;
        self.directions(from).find(joins).expect("an allowed step joins the cells of a path")
    }

    /// The allowed directions of a cell, in index order.
    #[inline]
    pub fn directions(&self, c: Cell) -> impl Iterator<Item = Direction> + use<> {
        let mut bits = self.bits[c as usize];
        std::iter::from_fn(move || {
            (bits != 0).then(|| {
                let d = bits.trailing_zeros() as u8;
                bits &= bits - 1;
                d
            })
        })
    }

    /// Whether `goal` can be reached from `start`.
    pub fn connected(&self, start: Cell, goal: Cell) -> bool {
        self.reached_from(start)[goal as usize]
    }

    /// Which cells can be reached from `start`, itself included (flood fill).
    pub fn reached_from(&self, start: Cell) -> Vec<bool> {
        let mut reached = vec![false; self.bits.len()];
        let mut open = vec![start];
        reached[start as usize] = true;
        while let Some(c) = open.pop() {
            for d in self.directions(c) {
                let next = self.step(c, d);
                if !std::mem::replace(&mut reached[next as usize], true) {
                    open.push(next);
                }
            }
        }
        reached
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_agree_with_the_rule_cell_by_cell() {
        let cells: Vec<u8> = (0..11 * 7u32).map(|i| u8::from(i.wrapping_mul(2_654_435_761) >> 30 == 0)).collect();
        let grid = Grid::from_bytes(11, 7, &cells).unwrap();
        for moves in [Moves::Four, Moves::Eight] {
            for corner_rule in CornerRule::ALL {
                let movement = Movement { moves, corner_rule };
                let set = MoveSet::new(&grid, movement);
                for c in 0..grid.len() as Cell {
                    let p = grid.point(c);
                    for d in 0..DIRECTIONS as u8 {
                        let slow = !grid.is_blocked(c) && movement.allows(&grid, i64::from(p.x), i64::from(p.y), d);
                        assert_eq!(set.bits[c as usize] >> d & 1 == 1, slow, "{movement:?} {p:?} {d}");
                    }
                }
            }
        }
    }

    #[test]
    fn steps_lead_back() {
        for d in 0..DIRECTIONS as u8 {
            let (a, b) = (OFFSETS[d as usize], OFFSETS[opposite(d) as usize]);
            assert_eq!((a.0 + b.0, a.1 + b.1), (0, 0));
        }
    }
}
