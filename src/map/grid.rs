//! The occupancy grid: free and blocked cells, row by row from the upper left; on a terrain, with a height for each cell;
//! on weighted ground, with a factor for each cell.

use std::sync::Arc;

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

    /// Straight distance to the centre of another cell, in cells.
    #[inline]
    pub fn distance(self, to: Self) -> f64 {
        let (dx, dy) = (f64::from(self.x.abs_diff(to.x)), f64::from(self.y.abs_diff(to.y)));
        libm::sqrt(dx * dx + dy * dy)
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

/// A rectangular map of free and blocked cells. Its copies share the cells until one of them is changed.
#[derive(Debug, Clone)]
pub struct Grid {
    width: u32,
    height: u32,
    blocked: Arc<[bool]>,
    /// One a cell on a terrain, in the unit of the file; NaN where there is no data, and such a cell is blocked.
    heights: Option<Arc<[f32]>>,
    /// One a cell on weighted ground, 1 to [`super::MAX_FACTOR`]; never all 1. The opening build knows none.
    #[cfg(feature = "whole")]
    factors: Option<Arc<[f32]>>,
}

impl PartialEq for Grid {
    /// Heights by their bits, so that a map with cells that lack data equals itself.
    fn eq(&self, other: &Self) -> bool {
        let bits = |values: &Option<Arc<[f32]>>| values.as_ref().map(|v| v.iter().map(|v| v.to_bits()).collect::<Vec<_>>());
        (self.width, self.height, &self.blocked) == (other.width, other.height, &other.blocked)
            && bits(&self.heights) == bits(&other.heights)
            && self.factors() == other.factors()
    }
}

impl Eq for Grid {}

impl Grid {
    /// A map without obstacles.
    ///
    /// # Errors
    /// [`ScenarioError::MapSize`] when a side is 0 or above [`MAX_SIDE`].
    pub fn open(width: u32, height: u32) -> Result<Self, ScenarioError> {
        check_size(u64::from(width), u64::from(height))?;
        Ok(Self {
            width,
            height,
            blocked: vec![false; width as usize * height as usize].into(),
            heights: None,
            #[cfg(feature = "whole")]
            factors: None,
        })
    }

    /// A map from one byte a cell, row by row: 0 = free, anything else = blocked.
    ///
    /// ```
    /// use formicarium::map::{Grid, Point};
    ///
    /// let grid = Grid::from_bytes(3, 2, &[0, 1, 0, 0, 0, 0])?;
    /// assert!(grid.is_blocked(grid.cell(Point::new(1, 0))));
    /// assert!(Grid::from_bytes(3, 2, &[0, 1]).is_err(), "six cells are needed");
    /// # Ok::<(), formicarium::error::ScenarioError>(())
    /// ```
    ///
    /// # Errors
    /// [`ScenarioError::MapSize`] or [`ScenarioError::CellCount`].
    pub fn from_bytes(width: u32, height: u32, cells: &[u8]) -> Result<Self, ScenarioError> {
        check_size(u64::from(width), u64::from(height))?;
        if cells.len() != width as usize * height as usize {
            return Err(ScenarioError::CellCount { width, height, got: cells.len() });
        }
        Ok(Self {
            width,
            height,
            blocked: cells.iter().map(|&c| c != 0).collect(),
            heights: None,
            #[cfg(feature = "whole")]
            factors: None,
        })
    }

    /// The same map as a terrain: one height a cell, row by row, in the unit of the file. Cells whose height is not finite have no data
    /// and are blocked for good.
    ///
    /// # Errors
    /// [`ScenarioError::CellCount`].
    pub fn with_heights(mut self, heights: Vec<f32>) -> Result<Self, ScenarioError> {
        if heights.len() != self.len() {
            return Err(ScenarioError::CellCount { width: self.width, height: self.height, got: heights.len() });
        }
        let heights: Arc<[f32]> = heights.into_iter().map(|h| if h.is_finite() { h } else { f32::NAN }).collect();
        Arc::make_mut(&mut self.blocked).iter_mut().zip(heights.iter()).for_each(|(blocked, h)| *blocked |= h.is_nan());
        self.heights = Some(heights);
        Ok(self)
    }

    /// The same cells as a plane of plain ground: without heights and factors.
    #[must_use]
    pub fn cells_alone(self) -> Self {
        Self {
            heights: None,
            #[cfg(feature = "whole")]
            factors: None,
            ..self
        }
    }

    /// The heights of a terrain, one a cell; NaN where there is no data. `None` on a plane.
    pub fn heights(&self) -> Option<&Arc<[f32]>> {
        self.heights.as_ref()
    }

    /// The same map as weighted ground: one factor a cell, row by row, by which a way through it counts; what those of blocked cells are says
    /// nothing until these are freed. Where all are 1 the ground is plain.
    ///
    /// ```
    /// use formicarium::map::Grid;
    ///
    /// let grid = Grid::open(2, 1)?;
    /// assert!(grid.clone().with_factors(vec![1.0, 2.5])?.factors().is_some());
    /// assert!(grid.clone().with_factors(vec![1.0, 1.0])?.factors().is_none());
    /// assert!(grid.with_factors(vec![1.0, 0.5]).is_err(), "no ground is better than plain");
    /// # Ok::<(), formicarium::error::ScenarioError>(())
    /// ```
    ///
    /// # Errors
    /// [`ScenarioError::CellCount`], or [`ScenarioError::Factor`] with the first cell whose factor is not 1 to [`super::MAX_FACTOR`].
    #[cfg(feature = "whole")]
    pub fn with_factors(self, factors: Vec<f32>) -> Result<Self, ScenarioError> {
        if factors.len() != self.len() {
            return Err(ScenarioError::CellCount { width: self.width, height: self.height, got: factors.len() });
        }
        if let Some(cell) = factors.iter().position(|factor| !(1.0..=super::MAX_FACTOR).contains(factor)) {
            let Point { x, y } = self.point(cell as Cell);
            return Err(ScenarioError::Factor { x, y, value: factors[cell].to_string(), most: super::MAX_FACTOR });
        }
        let plain = factors.iter().all(|&factor| factor == 1.0);
        Ok(Self { factors: (!plain).then(|| factors.into()), ..self })
    }

    /// The factors of weighted ground, one a cell; `None` on plain ground.
    #[inline(always)]
    pub fn factors(&self) -> Option<&Arc<[f32]>> {
        #[cfg(feature = "whole")]
        return self.factors.as_ref();
        #[cfg(not(feature = "whole"))]
        None
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

    /// Whether each cell is blocked, row by row.
    pub fn blocked(&self) -> &[bool] {
        &self.blocked
    }

    /// Whether each cell of row y is blocked, from the left.
    pub fn row(&self, y: u32) -> &[bool] {
        let width = self.width as usize;
        &self.blocked[y as usize * width..][..width]
    }

    /// Whether a point is on the map and free; signed, so that neighbours need no care at the border.
    pub fn is_free_at(&self, x: i64, y: i64) -> bool {
        (0..i64::from(self.width)).contains(&x)
            && (0..i64::from(self.height)).contains(&y)
            && !self.blocked[y as usize * self.width as usize + x as usize]
    }

    /// Blocks or frees a cell. A cell of a terrain without data stays blocked.
    pub fn set_blocked(&mut self, cell: Cell, blocked: bool) {
        let no_data = self.heights.as_ref().is_some_and(|h| h[cell as usize].is_nan());
        Arc::make_mut(&mut self.blocked)[cell as usize] = blocked || no_data;
    }

    /// Blocks all these cells.
    #[cfg(feature = "whole")]
    pub(crate) fn block_all(&mut self, cells: impl Iterator<Item = Cell>) {
        let blocked = Arc::make_mut(&mut self.blocked);
        cells.for_each(|cell| blocked[cell as usize] = true);
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
    if side.contains(&width) && side.contains(&height) {
        Ok(())
    } else {
        Err(ScenarioError::MapSize { width, height, most: MAX_SIDE })
    }
}
