//! From degrees to metres.

use crate::error::{FormatError, Notice};

/// Metres of a degree of latitude on a sphere of the Earth's size, and of a degree of longitude at the equator.
const METRES: f64 = 111_320.0;

/// Metres of a cell of `degrees` (longitude, latitude) in the latitude of the raster's middle; with a notice.
///
/// # Errors
/// [`FormatError::Field`] where a cell has no width: the middle of the raster is a pole, or lies beyond.
pub(super) fn cell(degrees: [f64; 2], latitude: f64) -> Result<([f64; 2], Notice), FormatError> {
    let shrink = libm::cos(latitude.to_radians());
    if !(latitude.abs() < 90.0 && shrink > 0.0) {
        return Err(FormatError::field("latitude", format!("the middle lies at {latitude}°"), "a latitude between −90° and 90°"));
    }
    let cell = [METRES * degrees[0] * shrink, METRES * degrees[1]];
    let message =
        format!("cells are in degrees: at latitude {latitude:.2}° they are {:.2} m wide and {:.2} m high", cell[0], cell[1]);
    let notice = Notice::new("terrain-geographic", message).with("latitude", format!("{latitude:.2}"));
    Ok((cell, notice.with("x", format!("{:.2}", cell[0])).with("y", format!("{:.2}", cell[1]))))
}

/// Sizes of cells, in metres or degrees: beyond them the products and quotients of lengths are none.
const SIZES: std::ops::RangeInclusive<f64> = 1e-9..=1e9;

/// # Errors
/// [`FormatError::Field`] for a size of a cell that is no positive number, or beyond all lengths.
pub(super) fn check_cell(field: &'static str, cell: [f64; 2]) -> Result<[f64; 2], FormatError> {
    if cell.iter().all(|side| SIZES.contains(side)) {
        return Ok(cell);
    }
    Err(FormatError::field(field, format!("cells of {} × {}", cell[0], cell[1]), "positive numbers, from 1e-9 to 1e9"))
}
