//! Where a search may go: the whole map, or a part of it that grows.

use std::ops::Range;

use super::growing::Node;
use crate::map::Cell;
use crate::planner::held;

/// A part of the map.
pub(super) trait Region: Clone + Send {
    /// Whether the search may go on from a cell, to which it has found a way of this cost, in cells. What it may not, the region keeps.
    fn takes(&mut self, cell: Cell, g: f64) -> bool;
    /// What it has kept: ways, each by its cost and the cell at its end; some may be outdated.
    #[cfg(feature = "whole")]
    fn waiting(&self) -> &[(f64, Cell)] {
        &[]
    }
}

/// All of it.
#[derive(Clone)]
pub(super) struct WholeMap;

impl Region for WholeMap {
    #[inline(always)]
    fn takes(&mut self, _cell: Cell, _g: f64) -> bool {
        true
    }
}

/// Some cells, and the ways that lead out of them.
#[derive(Clone)]
pub(super) struct Part {
    width: u32,
    /// Which cells are of it.
    inside: Vec<bool>,
    /// How far around each cell it has been widened already.
    widened: Vec<u8>,
    /// Ways to cells, or to states of cells, that are not of it, with their costs; some may be outdated.
    pub(super) waiting: Vec<(f64, Node)>,
}

impl Region for Part {
    #[inline(always)]
    fn takes(&mut self, cell: Cell, g: f64) -> bool {
        let inside = self.inside[cell as usize];
        if !inside {
            self.waiting.push((g, cell));
        }
        inside
    }

    #[cfg(feature = "whole")]
    fn waiting(&self) -> &[(f64, Cell)] {
        &self.waiting
    }
}

impl Part {
    /// None of a map of this width with so many cells.
    pub(super) fn none(width: u32, cells: usize) -> Self {
        Self { width, inside: vec![false; cells], widened: vec![0; cells], waiting: Vec::new() }
    }

    /// Whether each cell is of it, row by row.
    pub(super) fn cells(&self) -> &[bool] {
        &self.inside
    }

    /// Whether a cell is of it.
    #[inline(always)]
    pub(super) fn has(&self, cell: Cell) -> bool {
        self.inside[cell as usize]
    }

    /// Takes in the square of cells up to `radius` away from a cell, diagonally too.
    pub(super) fn widen(&mut self, cell: Cell, radius: u8) {
        // One more, so that 0 is a cell around which nothing was done yet.
        let done = &mut self.widened[cell as usize];
        if *done > radius {
            return;
        }
        *done = radius.saturating_add(1);
        let (columns, rows) = self.around(cell, u32::from(radius));
        for y in rows {
            let row = y as usize * self.width as usize;
            self.inside[row + columns.start as usize..row + columns.end as usize].fill(true);
        }
    }

    /// The columns and rows of that square.
    fn around(&self, cell: Cell, radius: u32) -> (Range<u32>, Range<u32>) {
        let height = self.inside.len() as u32 / self.width;
        let span = |at: u32, end: u32| at.saturating_sub(radius)..(at + radius + 1).min(end);
        (span(cell % self.width, self.width), span(cell / self.width, height))
    }

    /// Takes in every cell.
    pub(super) fn widen_to_all(&mut self) {
        self.inside.fill(true);
    }

    /// What it holds, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.inside.capacity() + self.widened.capacity() + held(&self.waiting)
    }
}
