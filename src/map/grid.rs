//! The occupancy grid: free and blocked cells, row by row from the upper left.

use serde::{Deserialize, Serialize};

use crate::error::ScenarioError;

/// Index of a cell: `y * width + x`. Always `u32`, so that hashes agree on every platform.
pub type Cell = u32;

/// Largest number of cells a side (4096 × 4096 = 16.8 million cells).
pub const MAX_SIDE: u32 = 4096;

/// A cell by column and row; (0, 0) is the upper left. Serialized as `[x, y]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(from = "[u32; 2]", into = "[u32; 2]")]
pub struct Point {
    /// Column, from 0 at the left.
    pub x: u32,
    /// Row, from 0 at the top.
    pub y: u32,
}

impl Point {
    /// The cell in column `x` and row `y`.
    pub const fn new(x: u32, y: u32) -> Self {
        Self { x, y }
    }
}

impl From<[u32; 2]> for Point {
    fn from([x, y]: [u32; 2]) -> Self {
        Self { x, y }
    }
}

impl From<Point> for [u32; 2] {
    fn from(p: Point) -> Self {
        [p.x, p.y]
    }
}

/// A rectangular map of free and blocked cells.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Grid {
    width: u32,
    height: u32,
    blocked: Vec<bool>,
}

impl Grid {
    /// A map without obstacles.
    ///
    /// # Errors
    /// [`ScenarioError::MapSize`] when a side is 0 or above [`MAX_SIDE`].
    pub fn open(width: u32, height: u32) -> Result<Self, ScenarioError> {
        check_size(u64::from(width), u64::from(height))?;
        Ok(Self { width, height, blocked: vec![false; width as usize * height as usize] })
    }

    /// A map from one byte a cell, row by row: 0 = free, anything else = blocked.
    ///
    /// # Errors
    /// [`ScenarioError::MapSize`] or [`ScenarioError::CellCount`].
    pub fn from_bytes(width: u32, height: u32, cells: &[u8]) -> Result<Self, ScenarioError> {
        check_size(u64::from(width), u64::from(height))?;
        if cells.len() != width as usize * height as usize {
            return Err(ScenarioError::CellCount { width, height, got: cells.len() });
        }
        Ok(Self { width, height, blocked: cells.iter().map(|&c| c != 0).collect() })
    }

    /// One byte a cell, row by row: 0 = free, 1 = blocked.
    pub fn to_bytes(&self) -> Vec<u8> {
        self.blocked.iter().map(|&b| u8::from(b)).collect()
    }

    /// Width in cells.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in cells.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.blocked.len()
    }

    /// Never true: a map has at least one cell.
    pub fn is_empty(&self) -> bool {
        self.blocked.is_empty()
    }

    /// Whether the point lies on the map.
    pub fn contains(&self, p: Point) -> bool {
        p.x < self.width && p.y < self.height
    }

    /// Index of a point of the map.
    pub fn cell(&self, p: Point) -> Cell {
        debug_assert!(self.contains(p));
        p.y * self.width + p.x
    }

    /// The point of a cell index.
    pub fn point(&self, cell: Cell) -> Point {
        Point { x: cell % self.width, y: cell / self.width }
    }

    /// Whether a cell is blocked.
    pub fn is_blocked(&self, cell: Cell) -> bool {
        self.blocked[cell as usize]
    }

    /// Whether a point is on the map and free; signed, so that neighbours need no care at the border.
    pub fn is_free_at(&self, x: i64, y: i64) -> bool {
        (0..i64::from(self.width)).contains(&x)
            && (0..i64::from(self.height)).contains(&y)
            && !self.blocked[y as usize * self.width as usize + x as usize]
    }

    /// Blocks or frees a cell.
    pub fn set_blocked(&mut self, cell: Cell, blocked: bool) {
        self.blocked[cell as usize] = blocked;
    }

    /// Number of free cells.
    pub fn free_count(&self) -> usize {
        self.blocked.iter().filter(|&&b| !b).count()
    }
}

/// # Errors
/// [`ScenarioError::MapSize`] when a side is 0 or above [`MAX_SIDE`]. `u64`, so that a file's claim can be checked before it is believed.
pub fn check_size(width: u64, height: u64) -> Result<(), ScenarioError> {
    let side = 1..=u64::from(MAX_SIDE);
    if side.contains(&width) && side.contains(&height) { Ok(()) } else { Err(ScenarioError::MapSize { width, height }) }
}
