//! What a search knows of every cell: the cheapest way there so far, and whether the cell was expanded.

use wide::f64x2;

use crate::map::{Cell, DIRECTIONS, Direction};
use crate::metrics::SAME_LENGTH;

/// Parent of the start, and of cells that were not seen.
pub(super) const NO_PARENT: Direction = Direction::MAX;

/// The ways known so far; empty until they are needed.
#[derive(Debug, Clone, Default)]
pub(super) struct Ways {
    /// Cost from the start by cell, with so many cells before the first and behind the last that one step from any cell leads to a place of
    /// the table. At the sides that is a cell of another row, so only allowed steps say anything.
    g: Vec<f64>,
    margin: usize,
    /// Direction of the step that led to each cell.
    parent: Vec<Direction>,
    expanded: Vec<bool>,
}

impl Ways {
    /// None known, on a map of this width with so many cells.
    pub(super) fn new(width: u32, cells: usize) -> Self {
        let margin = 2 * (width as usize + 1);
        let g = vec![f64::INFINITY; cells + 2 * margin];
        Self { g, margin, parent: vec![NO_PARENT; cells], expanded: vec![false; cells] }
    }

    /// Cost from the start, in cells; infinite where the search has not been.
    #[inline(always)]
    pub(super) fn g(&self, cell: Cell) -> f64 {
        self.g[cell as usize + self.margin]
    }

    /// The costs of all cells.
    pub(super) fn costs(&self) -> &[f64] {
        self.g.get(self.margin..).map_or(&[], |g| &g[..self.parent.len()])
    }

    /// Direction of the step that led to a cell, or [`NO_PARENT`].
    pub(super) fn parent(&self, cell: Cell) -> Direction {
        self.parent[cell as usize]
    }

    /// Which cells were expanded.
    pub(super) fn expanded(&self) -> &[bool] {
        &self.expanded
    }

    #[inline(always)]
    pub(super) fn note_expansion(&mut self, cell: Cell) {
        self.expanded[cell as usize] = true;
    }

    /// Takes note of a way to a cell, by the step that ends it.
    #[inline(always)]
    pub(super) fn note(&mut self, cell: Cell, g: f64, parent: Direction) {
        self.g[cell as usize + self.margin] = g;
        self.parent[cell as usize] = parent;
    }

    /// Whether a way of cost g to a cell is cheaper than the one known.
    #[inline(always)]
    pub(super) fn is_cheaper(&self, cell: Cell, g: f64) -> bool {
        g < self.g(cell) - SAME_LENGTH
    }

    /// Which of eight steps, each by what it adds to a cell's index and by the cost of the way with it, lead to a cell more cheaply than the way
    /// known there, as bits. Those of steps that are not allowed say nothing. Without a branch, two steps at once.
    #[inline(always)]
    pub(super) fn cheaper(&self, cell: Cell, delta: &[i32], g: [f64; DIRECTIONS]) -> u8 {
        let from = cell as usize + self.margin;
        let known = |k: usize| self.g[from.wrapping_add_signed(delta[k] as isize)];
        let pair = |k: usize| {
            let known = f64x2::new([known(k), known(k + 1)]) - f64x2::splat(SAME_LENGTH);
            f64x2::new([g[k], g[k + 1]]).simd_lt(known).to_bitmask() << k
        };
        (pair(0) | pair(2) | pair(4) | pair(6)) as u8
    }

    /// What it holds, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.g.capacity() * size_of::<f64>() + self.parent.capacity() + self.expanded.capacity()
    }
}
