//! Heights in rows and columns, in every spelling that [`super::super::table`] reads. −9999 stands for no data.

use std::fmt::Write;

use super::super::table::{Sink, Table};
use super::super::{Kind, matrix};
use super::{Raster, check_claim};
use crate::error::{FormatError, Notice};

/// Stands for no data, as in the grids of Esri.
pub(super) const NO_DATA: f64 = -9999.0;

/// Reads a table of heights.
///
/// # Errors
/// [`FormatError`] with the line of a ragged row or of a number that is no height.
pub(in crate::formats) fn read(table: &Table) -> Result<Raster, FormatError> {
    let (width, height) = table.size()?;
    let (width, height) = check_claim(width as u64, height as u64)?;
    let mut read = Heights { heights: Vec::with_capacity(width as usize * height as usize), wrong: None };
    table.read(&mut read)?;
    let message = "the numbers were read as heights in metres, since a map holds 0 and 1";
    let mut notices = vec![Notice::new("heights-in-table", message)];
    let message = "a table does not say how large its cells are: 1 m is assumed; set the resolution";
    notices.push(Notice::new("terrain-cell-size", message));
    notices.extend(matrix::rest_notice(table));
    Ok(Raster { kind: Kind::HeightTable, width, height, heights: read.heights, cell: [1.0, 1.0], notices })
}

/// Heights on their way in.
struct Heights {
    heights: Vec<f32>,
    /// The first number of the row at hand that is no height.
    wrong: Option<f64>,
}

impl Sink for Heights {
    fn number(&mut self, value: f64) {
        let height = if value == NO_DATA { f32::NAN } else { value as f32 };
        if height.is_infinite() {
            self.wrong = self.wrong.or(Some(value));
        }
        self.heights.push(height);
    }

    fn end_row(&mut self, line: usize) -> Result<(), FormatError> {
        let Some(value) = self.wrong else { return Ok(()) };
        Err(FormatError::syntax(line, format!("{value} is no height"), "a number below 3.4e38"))
    }
}

/// Heights as CSV, in metres.
pub(in crate::formats) fn write(heights: &[f32], width: u32) -> String {
    rows(heights, width, ",", NO_DATA as f32)
}

/// Rows of numbers, in the fewest digits that give back the same f32.
pub(super) fn rows(heights: &[f32], width: u32, between: &str, no_data: f32) -> String {
    let mut text = String::with_capacity(7 * heights.len());
    for row in heights.chunks(width as usize) {
        for (x, &height) in row.iter().enumerate() {
            let height = if height.is_nan() { no_data } else { height };
            let _ = write!(text, "{}{height}", if x == 0 { "" } else { between });
        }
        text.push('\n');
    }
    text
}
