//! Where the cells of a figure lie.

use serde::{Deserialize, Serialize};

use super::fit::Lines;
use crate::error::FormatError;

/// Most columns or rows of a figure.
pub(super) const MOST_CELLS: u32 = 512;

/// The cells of a figure in a picture. The corner between column u and row v (0 is the upper left one) lies at
/// x = `x0` + u · `dx` + v · `shear_x`, y = `y0` + v · `dy` + u · `shear_y`, in pixels: pixel (0, 0) covers 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Lattice {
    /// The upper left corner, in pixels from the left.
    pub x0: f64,
    /// The upper left corner, in pixels from above.
    pub y0: f64,
    /// Width of a cell in pixels, at least 3.
    pub dx: f64,
    /// Height of a cell in pixels, at least 3.
    pub dy: f64,
    /// Pixels that a row lies to the right of the row above it; less than half a cell either way.
    pub shear_x: f64,
    /// Pixels that a column lies below the column left of it; less than half a cell either way.
    pub shear_y: f64,
    /// Columns, 1–512.
    pub columns: u32,
    /// Rows, 1–512.
    pub rows: u32,
}

impl Lattice {
    /// The pixel coordinates of a place in cells: (0.5, 0.5) is the middle of the first.
    pub fn at(&self, u: f64, v: f64) -> (f64, f64) {
        (self.x0 + u * self.dx + v * self.shear_x, self.y0 + v * self.dy + u * self.shear_y)
    }

    /// The upper left corners of its cells, row by row, in cells.
    pub(super) fn cells(&self) -> impl Iterator<Item = (f64, f64)> + use<> {
        let (columns, rows) = (self.columns, self.rows);
        (0..rows).flat_map(move |v| (0..columns).map(move |u| (f64::from(u), f64::from(v))))
    }

    /// Whether cells can be read by it.
    ///
    /// # Errors
    /// [`FormatError::Field`] with the field that is out of its range.
    pub fn check(&self) -> Result<(), FormatError> {
        let wrong = |field, value: String, expected: &str| Err(FormatError::field(field, value, expected));
        let (x, y) = (self.x0, self.y0);
        if !(x.abs() <= 1e6 && y.abs() <= 1e6) {
            return wrong("x0", format!("({x}, {y})"), "a corner on or near the picture");
        }
        if !((3.0..=1e5).contains(&self.dx) && (3.0..=1e5).contains(&self.dy)) {
            return wrong("dx", format!("{} × {} pixels", self.dx, self.dy), "cells of at least 3 × 3 pixels");
        }
        if !(self.shear_x.abs() < self.dx / 2.0 && self.shear_y.abs() < self.dy / 2.0) {
            return wrong("shear_x", format!("{} and {} pixels", self.shear_x, self.shear_y), "less than half a cell");
        }
        if !((1..=MOST_CELLS).contains(&self.columns) && (1..=MOST_CELLS).contains(&self.rows)) {
            return wrong("columns", format!("{} × {} cells", self.columns, self.rows), "1 to 512 columns and rows");
        }
        Ok(())
    }

    /// The lattice whose corner (0, 0) is where the first of the upright lines crosses the first of the level ones.
    pub(super) fn crossing(upright: Lines, level: Lines, columns: u32, rows: u32) -> Self {
        let (s, t) = (upright.slope, level.slope);
        let by = 1.0 / (1.0 - s * t);
        Self {
            x0: (upright.start + s * level.start) * by,
            y0: (level.start + t * upright.start) * by,
            dx: upright.apart * by,
            dy: level.apart * by,
            shear_x: s * level.apart * by,
            shear_y: t * upright.apart * by,
            columns,
            rows,
        }
    }

    /// The part of it that begins at a column and row.
    pub(super) fn part(&self, (column, row): (u32, u32), columns: u32, rows: u32) -> Self {
        let (x0, y0) = self.at(f64::from(column), f64::from(row));
        Self { x0, y0, columns, rows, ..*self }
    }

    /// Columns as rows.
    pub(super) fn transposed(&self) -> Self {
        let Self { x0, y0, dx, dy, shear_x, shear_y, columns, rows } = *self;
        Self { x0: y0, y0: x0, dx: dy, dy: dx, shear_x: shear_y, shear_y: shear_x, columns: rows, rows: columns }
    }
}
