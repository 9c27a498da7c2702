//! A window of a map, and a map at another size: heights are interpolated, walls taken from the nearest cell.
//!
//! Cells are areas, not points: a map of 100 cells and the same map in 50 cells cover the same ground. So the centre of column i of n
//! lies at (i + ½) · N / n − ½ in the N columns of the original, where an unchanged size gives back every bit.

use serde::{Deserialize, Serialize};

use super::grid::Grid;
use crate::error::{FormatError, ScenarioError};

/// A rectangle of cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Window {
    /// First column.
    pub x: u32,
    /// First row.
    pub y: u32,
    /// Columns, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
}

impl Window {
    /// Whether the window has cells, and all of them lie within `size` (columns, rows).
    ///
    /// # Errors
    /// [`FormatError::Window`].
    pub fn check(&self, size: (u32, u32)) -> Result<(), FormatError> {
        let fits = |from: u32, length: u32, of: u32| length > 0 && from < of && length <= of - from;
        let ok = fits(self.x, self.width, size.0) && fits(self.y, self.height, size.1);
        let Self { x, y, width: columns, height: rows } = *self;
        if ok { Ok(()) } else { Err(FormatError::Window { x, y, columns, rows, width: size.0, height: size.1 }) }
    }
}

/// The cells of a window, row by row; `width` is the columns of the whole. The window must fit.
pub fn crop<T: Copy>(cells: &[T], width: u32, window: Window) -> Vec<T> {
    let row = |y: u32| {
        let from = (window.y + y) as usize * width as usize + window.x as usize;
        &cells[from..from + window.width as usize]
    };
    (0..window.height).flat_map(row).copied().collect()
}

/// Where the cells of one axis lie in the original: the two lines around each, how far between them it is, and the nearer one.
struct Axis(Vec<(usize, usize, f64, usize)>);

impl Axis {
    fn new(from: u32, to: u32) -> Self {
        let place = |i: u32| {
            let at = (f64::from(i) + 0.5) * f64::from(from) / f64::from(to) - 0.5;
            let at = at.clamp(0.0, f64::from(from - 1));
            let first = libm::floor(at) as usize;
            let second = (first + 1).min(from as usize - 1);
            let between = at - first as f64;
            (first, second, between, if between < 0.5 { first } else { second })
        };
        Self((0..to).map(place).collect())
    }
}

/// Heights at another size, `from` and `to` as (columns, rows), all at least 1; bilinear. A cell one of whose four neighbours has no data
/// takes the nearest one's height, or its lack of data.
pub fn heights(heights: &[f32], from: (u32, u32), to: (u32, u32)) -> Vec<f32> {
    if from == to {
        return heights.to_vec();
    }
    let (columns, rows) = (Axis::new(from.0, to.0), Axis::new(from.1, to.1));
    let width = from.0 as usize;
    let mut resampled = Vec::with_capacity(columns.0.len() * rows.0.len());
    for &(above, below, down, near_y) in &rows.0 {
        let (upper, lower) = (&heights[above * width..][..width], &heights[below * width..][..width]);
        for &(left, right, across, near_x) in &columns.0 {
            let four = [upper[left], upper[right], lower[left], lower[right]].map(f64::from);
            let top = four[0] + (four[1] - four[0]) * across;
            let bottom = four[2] + (four[3] - four[2]) * across;
            let height = top + (bottom - top) * down;
            // What is not a number makes the sum none.
            resampled.push(if height.is_nan() { heights[near_y * width + near_x] } else { height as f32 });
        }
    }
    resampled
}

/// Marks at another size: each cell takes the nearest one's.
pub fn nearest<T: Copy>(cells: &[T], from: (u32, u32), to: (u32, u32)) -> Vec<T> {
    let (columns, rows) = (Axis::new(from.0, to.0), Axis::new(from.1, to.1));
    let near = |y: usize| columns.0.iter().map(move |c| cells[y * from.0 as usize + c.3]);
    rows.0.iter().flat_map(|row| near(row.3)).collect()
}

impl Grid {
    /// The cells of a window, with their heights or factors.
    ///
    /// # Errors
    /// [`FormatError::Window`].
    pub fn cropped(&self, window: Window) -> Result<Self, FormatError> {
        window.check((self.width(), self.height()))?;
        let cells = crop(&self.to_bytes(), self.width(), window);
        let grid = Self::from_bytes(window.width, window.height, &cells)?;
        let cut = |values: &[f32]| crop(values, self.width(), window);
        let grid = match self.heights() {
            Some(heights) => grid.with_heights(cut(heights))?,
            None => grid,
        };
        match self.factors() {
            Some(factors) => Ok(grid.with_factors(cut(factors))?),
            None => Ok(grid),
        }
    }

    /// The same ground in another number of cells: heights are interpolated, walls and factors taken from the nearest cell.
    ///
    /// # Errors
    /// [`ScenarioError::MapSize`].
    pub fn resampled(&self, width: u32, height: u32) -> Result<Self, ScenarioError> {
        super::grid::check_size(u64::from(width), u64::from(height))?;
        let (from, to) = ((self.width(), self.height()), (width, height));
        let grid = Self::from_bytes(width, height, &nearest(&self.to_bytes(), from, to))?;
        let grid = match self.heights() {
            Some(values) => grid.with_heights(heights(values, from, to))?,
            None => grid,
        };
        match self.factors() {
            Some(factors) => grid.with_factors(nearest(factors, from, to)),
            None => Ok(grid),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NO: f32 = f32::NAN;

    #[test]
    fn a_window_is_cut_out() {
        let window = Window { x: 1, y: 1, width: 2, height: 2 };
        assert_eq!(crop(&[0, 1, 2, 3, 4, 5, 6, 7, 8], 3, window), [4, 5, 7, 8]);
        assert!(window.check((3, 3)).is_ok());
        for (x, y, width, height) in
            [(2, 1, 2, 2), (1, 1, 0, 1), (3, 0, 1, 1), (0, 0, 4, 1), (u32::MAX, 0, 2, 1), (1, 0, u32::MAX, 1)]
        {
            assert!(Window { x, y, width, height }.check((3, 3)).is_err());
        }
    }

    #[test]
    fn the_same_size_keeps_every_bit() {
        let values = [1.1f32, NO, -0.3, 1e30, 5.0, 7.25];
        let bits = |v: &[f32]| v.iter().map(|h| h.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&heights(&values, (3, 2), (3, 2))), bits(&values));
    }

    #[test]
    fn heights_between_cells_by_hand() {
        // Centres of 4 cells in the original's 2: −¼ (the border: 0), ¼, ¾, 1¼ (the border: 1).
        assert_eq!(heights(&[0.0, 8.0], (2, 1), (4, 1)), [0.0, 2.0, 6.0, 8.0]);
        // Half the cells: in the middle of each four.
        assert_eq!(heights(&[0.0, 2.0, 4.0, 6.0, 1.0, 3.0, 5.0, 7.0], (4, 2), (2, 1)), [1.5, 5.5]);
    }

    #[test]
    fn beside_no_data_the_nearest_cell_decides() {
        let found = heights(&[0.0, 8.0, NO], (3, 1), (6, 1));
        assert_eq!(found[..3], [0.0, 2.0, 6.0]);
        assert_eq!(found[3], 8.0);
        assert!(found[4].is_nan() && found[5].is_nan());
    }

    #[test]
    fn a_grid_keeps_walls_and_heights_together() {
        let grid = Grid::from_bytes(2, 1, &[0, 1]).unwrap().with_heights(vec![1.0, 3.0]).unwrap();
        let larger = grid.resampled(4, 2).unwrap();
        assert_eq!(larger.to_bytes(), [0, 0, 1, 1, 0, 0, 1, 1]);
        assert_eq!(larger.heights().unwrap()[..4], [1.0, 1.5, 2.5, 3.0]);
        let piece = grid.cropped(Window { x: 1, y: 0, width: 1, height: 1 }).unwrap();
        assert_eq!((piece.to_bytes(), piece.heights().unwrap()[0]), (vec![1], 3.0));
        assert!(grid.resampled(0, 3).is_err() && grid.resampled(5000, 3).is_err());
    }
}
