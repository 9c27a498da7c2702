//! Which steps are allowed on a grid, and how long they are: 4, 8 or 16 moves, the corner rule for those that squeeze past obstacles, and on
//! a terrain the slope.
//!
//! None of the papers states its corner rule, yet lengths change by up to 86 % with it; so it belongs to the scenario.

use std::f64::consts::SQRT_2;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::grid::{Cell, Grid, Point};
use super::relief::Relief;
use super::weights::Weights;

/// A direction index: 0..8 in reading order of the neighbours, NW, N, NE, W, E, SW, S, SE; with 16 moves 8..16 for [`FAR`].
pub type Direction = u8;

/// Number of directions to neighbouring cells.
pub const DIRECTIONS: usize = 8;
/// Number of directions with 16 moves.
pub const ALL_DIRECTIONS: usize = 16;

/// (dx, dy) of each direction; y grows downwards.
pub const OFFSETS: [(i32, i32); DIRECTIONS] = [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)];

/// (dx, dy) of the directions 8..16: one cell along one axis and two along the other, in reading order.
pub const FAR: [(i32, i32); DIRECTIONS] = [(-1, -2), (1, -2), (-2, -1), (2, -1), (-2, 1), (2, 1), (-1, 2), (1, 2)];

/// (dx, dy) of any direction.
pub const fn offset(d: Direction) -> (i32, i32) {
    if (d as usize) < DIRECTIONS { OFFSETS[d as usize] } else { FAR[d as usize - DIRECTIONS] }
}

/// Whether a direction is diagonal.
pub const fn is_diagonal(d: Direction) -> bool {
    0b1010_0101u32 >> d & 1 == 1
}

/// The direction that leads back.
pub const fn opposite(d: Direction) -> Direction {
    if (d as usize) < DIRECTIONS { 7 - d } else { 23 - d }
}

/// Length of one step on the plane in cells: 1, √2, or √5 where two cells along one axis are taken at once.
pub const fn step_length(d: Direction) -> f64 {
    const SQRT_5: f64 = 2.236_067_977_499_79;
    if d as usize >= DIRECTIONS {
        SQRT_5
    } else if is_diagonal(d) {
        SQRT_2
    } else {
        1.0
    }
}

/// Octile distance in cells: the length of the shortest path with 8 moves on an open map.
pub fn octile(a: Point, b: Point) -> f64 {
    let (dx, dy) = (f64::from(a.x.abs_diff(b.x)), f64::from(a.y.abs_diff(b.y)));
    (dx - dy).abs() + dx.min(dy) * SQRT_2
}

/// How many moves a cell offers. Serialized as the number 4, 8 or 16.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(try_from = "u8", into = "u8")]
pub enum Moves {
    /// N, E, S, W.
    Four,
    /// With the diagonals.
    #[default]
    Eight,
    /// With the steps of [`FAR`] as well, along which no cell may be blocked.
    Sixteen,
}

impl TryFrom<u8> for Moves {
    type Error = String;
    fn try_from(n: u8) -> Result<Self, String> {
        match n {
            4 => Ok(Self::Four),
            8 => Ok(Self::Eight),
            16 => Ok(Self::Sixteen),
            _ => Err(format!("moves = {n}: it must be 4, 8 or 16")),
        }
    }
}

impl From<Moves> for u8 {
    fn from(m: Moves) -> u8 {
        match m {
            Moves::Four => 4,
            Moves::Eight => 8,
            Moves::Sixteen => 16,
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
    /// 4, 8 or 16 moves.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "4 | 8 | 16"))]
    pub moves: Moves,
    /// The rule for diagonal moves; without effect on 4 moves.
    pub corner_rule: CornerRule,
}

impl Movement {
    /// Whether the step from a free cell (x, y) in direction `d` is allowed.
    pub fn allows(self, grid: &Grid, x: i64, y: i64, d: Direction) -> bool {
        self.allows_where(d, |dx, dy| grid.is_free_at(x + i64::from(dx), y + i64::from(dy)))
    }

    /// The same on a map that is told cell by cell: whether the one by (dx, dy) from where the step begins is free.
    pub fn allows_where(self, d: Direction, is_free: impl Fn(i32, i32) -> bool) -> bool {
        let (dx, dy) = offset(d);
        if !is_free(dx, dy) {
            return false;
        }
        if d as usize >= DIRECTIONS {
            return self.moves == Moves::Sixteen && beside_far(d).iter().all(|&(bx, by)| is_free(bx, by));
        }
        !is_diagonal(d) || (self.moves != Moves::Four && self.corner_rule.allows(is_free(dx, 0), is_free(0, dy)))
    }
}

impl Movement {
    /// The allowed steps of a row's cells as bits, given whether cells are free, 1 or 0, in the row above, in this one and in the one
    /// below, each with a border cell on both sides. Without a branch, so that many cells are worked out at once.
    fn steps(self, [up, row, down]: [&[u8]; 3], out: &mut [u8]) {
        let diagonal = u8::from(self.moves != Moves::Four);
        let one = u8::from(self.corner_rule != CornerRule::BothFree);
        let always = u8::from(self.corner_rule == CornerRule::Always);
        let allowed = |to: u8, a: u8, b: u8| to & diagonal & ((a & b) | ((a | b) & one) | always);
        let width = out.len();
        let (up, row, down) = (&up[..width + 2], &row[..width + 2], &down[..width + 2]);
        for x in 0..width {
            let (nw, n, ne) = (up[x], up[x + 1], up[x + 2]);
            let (w, free, e) = (row[x], row[x + 1], row[x + 2]);
            let (sw, s, se) = (down[x], down[x + 1], down[x + 2]);
            let straight = n << 1 | w << 3 | e << 4 | s << 6;
            let aside = allowed(nw, n, w) | allowed(ne, n, e) << 2 | allowed(sw, s, w) << 5 | allowed(se, s, e) << 7;
            out[x] = (straight | aside) * free;
        }
    }
}

/// The two cells that a step of [`FAR`] passes between its ends, as offsets: the straight line crosses both.
pub(super) const fn beside_far(d: Direction) -> [(i32, i32); 2] {
    let (dx, dy) = offset(d);
    // The nearer one along the long axis, then the one beside the end.
    let (long_x, long_y) = (dx / 2, dy / 2);
    [(long_x, long_y), (dx - long_x, dy - long_y)]
}

/// The allowed steps of every cell, as bits: the one neighbourhood that all planners share. Its copies share the bits.
#[derive(Debug, Clone)]
pub struct MoveSet {
    /// Bit `d` of entry `c`: direction `d` may be taken from cell `c`. Blocked cells have none.
    pub bits: Arc<[u8]>,
    /// The same for the directions 8..16; empty unless there are 16 moves.
    far: Arc<[u8]>,
    /// What to add to a cell index for each direction.
    pub delta: [i32; ALL_DIRECTIONS],
    /// What makes steps longer or dearer than they are on a plane; none there, and none in the opening build.
    #[cfg(feature = "whole")]
    uneven: Option<Uneven>,
}

/// Ground on which a step is not just as long as it looks on the map.
#[derive(Debug, Clone)]
#[cfg_attr(not(feature = "whole"), expect(dead_code, reason = "the opening build makes none"))]
enum Uneven {
    /// A terrain: steps go up and down.
    Relief(Relief),
    /// Weighted ground: cells have factors.
    Weights(Weights),
}

impl MoveSet {
    /// Derives the steps of every cell. Works on a copy of the map with a blocked border, so that no neighbour needs a range check.
    pub fn new(grid: &Grid, movement: Movement) -> Self {
        let (w, h) = (grid.width() as usize, grid.height() as usize);
        let stride = w + 2;
        let mut free = vec![0u8; stride * (h + 2)];
        for (y, row) in free.chunks_exact_mut(stride).skip(1).take(h).enumerate() {
            row[1..=w].iter_mut().zip(grid.row(y as u32)).for_each(|(free, &blocked)| *free = u8::from(!blocked));
        }
        let mut bits = vec![0u8; grid.len()];
        for (y, out) in bits.chunks_exact_mut(w).enumerate() {
            movement.steps([y, y + 1, y + 2].map(|row| &free[row * stride..][..stride]), out);
        }
        let delta = std::array::from_fn(|d| {
            let (dx, dy) = offset(d as Direction);
            dy * grid.width() as i32 + dx
        });
        let far = if movement.moves == Moves::Sixteen { far_steps(grid, movement) } else { Vec::new() };
        Self {
            bits: bits.into(),
            far: far.into(),
            delta,
            #[cfg(feature = "whole")]
            uneven: None,
        }
    }

    /// On a terrain: steps go over its ground, and those that are too steep are not allowed.
    #[cfg(feature = "whole")]
    #[must_use]
    pub fn over(mut self, relief: Relief) -> Self {
        let (mut bits, mut far) = (self.bits.to_vec(), self.far.to_vec());
        for c in 0..self.bits.len() as Cell {
            for d in self.directions(c) {
                if !relief.passable(c, self.step(c, d), d) {
                    let (set, bit) = if d < DIRECTIONS as u8 { (&mut bits, d) } else { (&mut far, d - 8) };
                    set[c as usize] &= !(1 << bit);
                }
            }
        }
        (self.bits, self.far) = (bits.into(), far.into());
        self.uneven = Some(Uneven::Relief(relief));
        self
    }

    /// The same without the steps that take two cells at once.
    #[must_use]
    pub fn to_neighbours(&self) -> Self {
        Self { far: Arc::default(), ..self.clone() }
    }

    /// On weighted ground: steps cost what these factors say.
    #[cfg(feature = "whole")]
    #[must_use]
    pub fn weighing(self, weights: Weights) -> Self {
        Self { uneven: Some(Uneven::Weights(weights)), ..self }
    }

    /// What makes steps longer or dearer than on a plane, if anything does. The opening build knows no such ground and is spared its code.
    #[inline(always)]
    fn uneven(&self) -> Option<&Uneven> {
        #[cfg(feature = "whole")]
        return self.uneven.as_ref();
        #[cfg(not(feature = "whole"))]
        None
    }

    /// Whether every step costs the length that it has on the map: on a plane whose cells all count the same.
    #[inline(always)]
    pub fn is_plain(&self) -> bool {
        self.uneven().is_none()
    }

    /// The ground of a terrain; none on a plane.
    #[inline(always)]
    pub fn relief(&self) -> Option<&Relief> {
        match self.uneven() {
            Some(Uneven::Relief(relief)) => Some(relief),
            _ => None,
        }
    }

    /// The factors of weighted ground; none on any other.
    #[inline(always)]
    pub fn weights(&self) -> Option<&Weights> {
        match self.uneven() {
            Some(Uneven::Weights(weights)) => Some(weights),
            _ => None,
        }
    }

    /// What an allowed step costs, in cells: its length, along the ground of a terrain; on weighted ground its length times its factor.
    #[inline(always)]
    pub fn length(&self, from: Cell, d: Direction) -> f64 {
        match self.uneven() {
            Some(Uneven::Relief(relief)) => relief.step(from, self.step(from, d), d).length,
            Some(Uneven::Weights(weights)) => weights.step(from, self.step(from, d), d),
            None => step_length(d),
        }
    }

    /// The allowed directions of a cell as bits, all 16.
    #[inline(always)]
    pub fn all_bits(&self, c: Cell) -> u16 {
        u16::from(self.bits[c as usize]) | u16::from(self.far.get(c as usize).copied().unwrap_or(0)) << 8
    }

    /// The cell one step away; the step must be allowed.
    #[inline(always)]
    pub fn step(&self, c: Cell, d: Direction) -> Cell {
        c.wrapping_add_signed(self.delta[d as usize % ALL_DIRECTIONS])
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
        let mut bits = self.all_bits(c);
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

/// The allowed steps of [`FAR`] of every cell.
fn far_steps(grid: &Grid, movement: Movement) -> Vec<u8> {
    let steps = |c: Cell| {
        let p = grid.point(c);
        let allowed = |k: u8| !grid.is_blocked(c) && movement.allows(grid, i64::from(p.x), i64::from(p.y), 8 + k);
        (0..DIRECTIONS as u8).fold(0, |bits, k| bits | u8::from(allowed(k)) << k)
    };
    (0..grid.len() as Cell).map(steps).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_agree_with_the_rule_cell_by_cell() {
        let cells: Vec<u8> = (0..11 * 7u32).map(|i| u8::from(i.wrapping_mul(2_654_435_761) >> 30 == 0)).collect();
        let grid = Grid::from_bytes(11, 7, &cells).unwrap();
        for moves in [Moves::Four, Moves::Eight, Moves::Sixteen] {
            for corner_rule in CornerRule::ALL {
                let movement = Movement { moves, corner_rule };
                let set = MoveSet::new(&grid, movement);
                for c in 0..grid.len() as Cell {
                    let p = grid.point(c);
                    for d in 0..ALL_DIRECTIONS as u8 {
                        let slow = !grid.is_blocked(c) && movement.allows(&grid, i64::from(p.x), i64::from(p.y), d);
                        assert_eq!(set.all_bits(c) >> d & 1 == 1, slow, "{movement:?} {p:?} {d}");
                    }
                }
            }
        }
    }

    #[test]
    fn steps_lead_back() {
        for d in 0..ALL_DIRECTIONS as u8 {
            let (a, b) = (offset(d), offset(opposite(d)));
            assert_eq!((a.0 + b.0, a.1 + b.1), (0, 0));
        }
    }
}
