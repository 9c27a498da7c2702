//! SRTM `.hgt`: one degree by one degree in 1201 or 3601 samples a side, big-endian 16-bit integers row by row from the north, in metres;
//! −32768 stands for no data. The size tells the format, the name (`N40W106.hgt`: the lower left corner) the latitude.

use super::super::Kind;
use super::{Raster, ground};
use crate::comparison::names::stem;
use crate::error::{FormatError, Notice};
use crate::map::Grid;

/// Samples a side: three and one seconds of arc apart.
const SIDES: [u32; 2] = [1201, 3601];

/// Stands for no data.
const NO_DATA: i16 = -32768;

/// Samples a side of a file of this many bytes, if it can be one.
pub(in crate::formats) fn side_of(bytes: usize) -> Option<u32> {
    SIDES.into_iter().find(|&side| bytes == 2 * side as usize * side as usize)
}

/// Reads a tile.
///
/// # Errors
/// [`FormatError::Field`] for a size that no tile has, or a name that names no latitude on Earth.
pub(in crate::formats) fn read(bytes: &[u8], name: &str) -> Result<Raster, FormatError> {
    let side = side_of(bytes.len()).ok_or_else(|| {
        let expected = "1201 × 1201 or 3601 × 3601 samples of two bytes: 2,884,802 or 25,934,402 bytes";
        FormatError::field("size", format!("{} bytes", bytes.len()), expected)
    })?;
    let height = |pair: &[u8]| match i16::from_be_bytes([pair[0], pair[1]]) {
        NO_DATA => f32::NAN,
        metres => f32::from(metres),
    };
    let heights = bytes.chunks_exact(2).map(height).collect();
    let degrees = 1.0 / f64::from(side - 1);
    let corner = latitude(stem(name));
    let (cell, mut notice) = ground::cell([degrees; 2], corner.map_or(0.0, |south| south + 0.5))?;
    if corner.is_none() {
        let message = "the name tells no latitude, as N40W106.hgt does: cells are taken for those of the equator";
        notice = Notice::new("terrain-no-latitude", message);
    }
    Ok(Raster { kind: Kind::Srtm, width: side, height: side, heights, cell, unit: 1.0, notices: vec![notice] })
}

/// The latitude of the lower left corner: `N40…` is 40, `S12…` is −12.
fn latitude(stem: &str) -> Option<f64> {
    let (side, rest) = (stem.as_bytes().first()?.to_ascii_uppercase(), stem.get(1..3)?);
    let degrees = rest.bytes().all(|b| b.is_ascii_digit()).then(|| rest.parse::<u8>().ok())??;
    match side {
        b'N' if degrees < 90 => Some(f64::from(degrees)),
        b'S' if degrees <= 90 => Some(-f64::from(degrees)),
        _ => None,
    }
}

/// A terrain of 1201 or 3601 cells a side as a tile, rounded to metres.
///
/// # Errors
/// [`FormatError::Field`] for another size, or a height beyond 16 bits.
pub(in crate::formats) fn write(grid: &Grid, heights: &[f32]) -> Result<Vec<u8>, FormatError> {
    let (width, height) = (grid.width(), grid.height());
    if width != height || !SIDES.contains(&width) {
        let what = format!("{width} × {height} cells");
        return Err(FormatError::field("size", what, "1201 × 1201 or 3601 × 3601 cells; resample, or write a GeoTIFF"));
    }
    let mut bytes = Vec::with_capacity(2 * heights.len());
    for &height in heights {
        let metres = if height.is_nan() { f32::from(NO_DATA) } else { libm::roundf(height) };
        if metres < f32::from(NO_DATA) || metres > f32::from(i16::MAX) || (metres == f32::from(NO_DATA) && !height.is_nan()) {
            return Err(FormatError::field("heights", format!("{height} m"), "heights from −32767 to 32767 m; write a GeoTIFF"));
        }
        bytes.extend((metres as i16).to_be_bytes());
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_tell_the_latitude() {
        assert_eq!(["N40W106", "s12e001", "S90W180", "N00E010"].map(latitude), [Some(40.0), Some(-12.0), Some(-90.0), Some(0.0)]);
        assert_eq!(["", "N", "N4", "N4xW106", "E40", "N90E000", "S91", "Nö1"].map(latitude), [None; 8]);
    }
}
