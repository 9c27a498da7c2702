//! What one input may cost. All limits stand here.

use std::time::Duration;

/// More than any input may take, in bytes: the program ends itself.
pub const MOST_BYTES: usize = 3 << 30;

/// An input that stands still for so long is killed: a loop without an end, whatever the load of the machine.
pub const STANDSTILL: Duration = Duration::from_secs(300);

/// Stack of the thread that reads, as in a browser.
pub const STACK: usize = 1 << 20;

/// Longest input that is made, except for rasters whose format has fixed sizes.
pub const LONGEST: usize = 96 << 10;

/// Most cells of a raster (docs/formats.md), and most for each byte of a file, by the best that deflate can do.
pub const MOST_CELLS: u64 = 1 << 26;
pub const MOST_CELLS_PER_BYTE: u64 = 1100;

#[derive(Clone, Copy)]
pub struct Limits {
    pub bytes: usize,
    pub time: Duration,
}

impl Limits {
    /// Text: four times its length, and 16 MiB for tables of constant size.
    pub fn text(len: usize) -> Self {
        Self { bytes: 4 * len + (16 << 20), time: Duration::from_millis(200) }
    }

    /// Rasters and pictures may take what their headers honestly claim: for each cell its height as read and as resampled, or a pixel as it
    /// is unpacked and as red, green, blue and alpha, and the block of the file that
    /// is being unpacked, as large as `geotiff.rs` allows, twice: packed numbers, and as they are decoded.
    pub fn raster(len: usize, cells: u64) -> Self {
        const BYTES_PER_CELL: usize = 16;
        const BLOCK: usize = 128 << 20;
        let text = Self::text(len);
        let bytes = text.bytes + 2 * BLOCK + BYTES_PER_CELL * cells as usize;
        Self { bytes, time: text.time + Duration::from_micros(cells) + Duration::from_nanos(500 * len as u64) }
    }

    /// A planner on a small map, a few iterations of up to 1024 ants: far from what the catalog refuses, in a few seconds.
    pub fn planner() -> Self {
        Self { bytes: 256 << 20, time: Duration::from_secs(10) }
    }
}
