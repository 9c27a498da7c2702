//! Heights in rows and columns, in every spelling that [`super::super::numbers`] reads. −9999 stands for no data.

use std::fmt::Write;

use super::super::numbers::Found;
use super::super::{Kind, matrix};
use super::{Raster, check_claim};
use crate::error::{FormatError, Notice};

/// Stands for no data, as in the grids of Esri.
pub(super) const NO_DATA: f32 = -9999.0;

/// Reads a table of heights.
///
/// # Errors
/// [`FormatError`] with the line of a ragged row.
pub(in crate::formats) fn read(found: Found) -> Result<Raster, FormatError> {
    found.check_heights()?;
    let table = &found.table;
    let (width, height) = table.size()?;
    let (width, height) = check_claim(width as u64, height as u64)?;
    let mut heights = Vec::with_capacity(width as usize * height as usize);
    heights.extend(table.numbers().map(|value| if value == NO_DATA { f32::NAN } else { value }));
    let message = "the numbers were read as heights in metres, since a map holds 0 and 1";
    let mut notices = found.notices;
    notices.push(Notice::new("heights-in-table", message));
    let message = "a table does not say how large its cells are: 1 m is assumed; set the resolution";
    notices.push(Notice::new("terrain-cell-size", message));
    notices.extend(matrix::rest_notice(&found.table));
    Ok(Raster { kind: Kind::HeightTable, width, height, heights, cell: [1.0, 1.0], unit: 1.0, notices })
}

/// Heights as CSV, in metres.
pub(in crate::formats) fn write(heights: &[f32], width: u32) -> String {
    rows(heights, width, ",", NO_DATA)
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
