//! Rasters of heights, whatever file they come from: what is known before one is opened, a window of one, one at another size.

pub(super) mod esri_ascii;
pub(super) mod geotiff;
mod geotiff_tags;
pub(super) mod ground;
pub(super) mod height_table;
pub(super) mod srtm;
mod whole_tiles;

use serde::Serialize;

use super::{Imported, Kind, complete, recognise, text};
use crate::error::{Error, FormatError, Notice};
use crate::map::resample::{self, Window};
use crate::map::{Grid, MAX_SIDE, check_size};
use crate::scenario::ScenarioSpec;

/// Most cells of a raster that is read.
pub(super) const MAX_CELLS: u64 = 1 << 26;

/// Longest side of a preview, in cells.
const PREVIEW_SIDE: u32 = 256;

/// A raster as its file has it; its sides may be longer than a map's.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Raster {
    pub kind: Kind,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Row by row from the upper left; NaN where there is no data.
    pub heights: Vec<f32>,
    /// Metres per cell along a row and along a column.
    pub cell: [f64; 2],
    /// Metres of a height of 1, where the file says so.
    pub unit: f64,
    pub notices: Vec<Notice>,
}

/// No ground on Earth lies higher above the sea, or deeper below it, in metres.
pub const FARTHEST: f64 = 12_000.0;

/// What to take of a raster.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TerrainOptions {
    /// Only this window, in cells of the file.
    pub crop: Option<Window>,
    /// Columns and rows of the map; the window's own where they fit into a map.
    pub size: Option<(u32, u32)>,
}

/// What a raster is, before it is opened.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Survey {
    /// What the file is.
    pub kind: Kind,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell along a row and along a column.
    pub cell: [f64; 2],
    /// Metres of a height of 1, where the file says so; 1 where it does not.
    pub unit: f64,
    /// Lowest height, in the file's unit.
    pub lowest: f32,
    /// Highest height, in the file's unit.
    pub highest: f32,
    /// Cells without data.
    pub missing: u32,
    /// Columns of the preview, at most 256.
    pub preview_width: u32,
    /// Rows of the preview, at most 256.
    pub preview_height: u32,
    /// Heights of the preview; NaN where there is no data.
    pub preview: Vec<f32>,
    /// What was assumed.
    pub notices: Vec<Notice>,
}

/// # Errors
/// [`FormatError::TooLarge`], before anything is allocated for what a file claims.
pub(super) fn check_claim(width: u64, height: u64) -> Result<(u32, u32), FormatError> {
    match (u32::try_from(width), u32::try_from(height)) {
        (Ok(w), Ok(h)) if w > 0 && h > 0 && width * height <= MAX_CELLS => Ok((w, h)),
        (Ok(0), _) | (_, Ok(0)) => Err(FormatError::field("size", format!("{width} × {height} cells"), "at least one cell")),
        _ => {
            let max = format!("{} million cells", MAX_CELLS / 1_000_000);
            Err(FormatError::TooLarge { what: format!("a raster of {width} × {height} cells"), max })
        }
    }
}

/// Tells what a raster holds, with a small picture of it.
///
/// # Errors
/// [`FormatError`]: the file is no raster, or cannot be read.
pub fn survey(bytes: &[u8], name: &str) -> Result<Survey, Error> {
    let mut raster = read(bytes, name)?;
    raster.leave_out_impossible();
    let (lowest, highest) = raster.range()?;
    let missing = raster.heights.iter().filter(|h| h.is_nan()).count() as u32;
    let (preview_width, preview_height) = at_most(raster.size(), PREVIEW_SIDE);
    let preview = resample::heights(&raster.heights, raster.size(), (preview_width, preview_height));
    let Raster { kind, width, height, cell, unit, notices, .. } = raster;
    Ok(Survey { kind, width, height, cell, unit, lowest, highest, missing, preview_width, preview_height, preview, notices })
}

/// Reads a raster as a terrain: all of it, a window, or either in another number of cells. What does not fit into a map is made smaller by a
/// whole number.
///
/// # Errors
/// [`FormatError`]: the file is no raster, cannot be read, or the options do not suit it.
pub fn import_terrain(bytes: &[u8], name: &str, options: TerrainOptions) -> Result<Imported, Error> {
    Ok(terrain(read(bytes, name)?, name, options)?)
}

/// The raster of a file.
fn read(bytes: &[u8], name: &str) -> Result<Raster, FormatError> {
    let kind = recognise(bytes, name)?.kind;
    match kind {
        Kind::Geotiff => return geotiff::read(bytes),
        Kind::Srtm => return srtm::read(bytes, name),
        Kind::EsriAscii => return esri_ascii::read(&text::decode_up_to(bytes, text::MAX_BYTES)?),
        Kind::Matrix => {
            let found = super::numbers::read(&text::decode(bytes)?, None)?;
            if !super::matrix::is_map(&found.table) {
                return height_table::read(found);
            }
        }
        _ => {}
    }
    Err(FormatError::NotATerrain { found: kind.name() })
}

/// The scenario of a raster.
pub(super) fn terrain(mut raster: Raster, name: &str, options: TerrainOptions) -> Result<Imported, FormatError> {
    raster.leave_out_impossible();
    if let Some(window) = options.crop {
        raster = raster.cropped(window)?;
    }
    match options.size {
        Some((width, height)) => {
            check_size(u64::from(width), u64::from(height))?;
            raster = raster.resampled((width, height));
        }
        None => raster = raster.fitted(),
    }
    raster.range()?;
    raster.tell_of_cells();
    let Raster { kind, width, height, heights, cell, unit, notices } = raster;
    let grid = Grid::open(width, height)?.with_heights(heights)?;
    let mut imported = complete(kind, name, grid, None, None, notices)?;
    imported.spec.resolution = libm::sqrt(cell[0] * cell[1]);
    imported.spec.terrain.iter_mut().for_each(|terrain| terrain.vertical_unit = unit);
    Ok(imported)
}

/// The heights of a map in metres. Cells of a plane are 0 where they are free, without data where they are not.
pub(super) fn metres(grid: &Grid, spec: &ScenarioSpec) -> Vec<f32> {
    let unit = spec.terrain.map_or(1.0, |terrain| terrain.vertical_unit);
    match grid.heights() {
        // A unit of 1 keeps every bit.
        Some(heights) => heights.iter().map(|&h| (f64::from(h) * unit) as f32).collect(),
        None => grid.to_bytes().iter().map(|&blocked| if blocked == 0 { 0.0 } else { f32::NAN }).collect(),
    }
}

/// A size scaled down evenly until neither side is longer than `side`.
fn at_most((width, height): (u32, u32), side: u32) -> (u32, u32) {
    let longer = width.max(height);
    if longer <= side {
        return (width, height);
    }
    let scaled = |n: u32| (u64::from(n) * u64::from(side) / u64::from(longer)).max(1) as u32;
    (scaled(width), scaled(height))
}

impl Raster {
    fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// Lowest and highest height.
    fn range(&self) -> Result<(f32, f32), FormatError> {
        let widen = |(low, high): (f32, f32), &h: &f32| (low.min(h), high.max(h));
        let range = self.heights.iter().filter(|h| !h.is_nan()).fold((f32::INFINITY, f32::NEG_INFINITY), widen);
        if range.0 <= range.1 { Ok(range) } else { Err(FormatError::NoHeights) }
    }

    fn cropped(self, window: Window) -> Result<Self, FormatError> {
        window.check(self.size())?;
        let heights = resample::crop(&self.heights, self.width, window);
        Ok(Self { width: window.width, height: window.height, heights, ..self })
    }

    /// The same ground in another number of cells: its extent stays what it is.
    fn resampled(self, (width, height): (u32, u32)) -> Self {
        let heights = resample::heights(&self.heights, self.size(), (width, height));
        let scaled = |metres: f64, from: u32, to: u32| metres * f64::from(from) / f64::from(to);
        let cell = [scaled(self.cell[0], self.width, width), scaled(self.cell[1], self.height, height)];
        Self { width, height, heights, cell, ..self }
    }

    /// Small enough for a map, by a whole number.
    fn fitted(self) -> Self {
        let (width, height) = self.size();
        let by = width.max(height).div_ceil(MAX_SIDE);
        if by <= 1 {
            return self;
        }
        let mut fitted = self.resampled((width.div_ceil(by), height.div_ceil(by)));
        let to = format!("{} × {}", fitted.width, fitted.height);
        let message = format!(
            "{width} × {height} cells are more than a map has: every {by} became one, {to} in all; crop to keep them all"
        );
        let notice = Notice::new("terrain-shrunk", message).with("by", by).with("width", width).with("height", height);
        fitted.notices.push(notice.with("columns", fitted.width).with("rows", fitted.height));
        fitted
    }

    /// Heights that no ground can have stand for no data, whatever the file says of them.
    fn leave_out_impossible(&mut self) {
        let most = (FARTHEST / self.unit) as f32;
        let (mut count, mut example) = (0usize, 0.0);
        for height in self.heights.iter_mut().filter(|height| height.abs() > most) {
            (count, example) = (count + 1, *height);
            *height = f32::NAN;
        }
        if count > 0 {
            let hold = if count == 1 { "1 cell holds a height".to_owned() } else { format!("{count} cells hold heights") };
            let message = format!(
                "{hold} that no ground has, such as {example:e}: beyond {FARTHEST} m above or below the sea they count as without data"
            );
            let notice = Notice::new("terrain-impossible", message).with("count", count);
            self.notices.push(notice.with("value", format!("{example:e}")).with("most", FARTHEST));
        }
        self.tell_of_9999();
    }

    /// What many programs write for no data is ground where the file does not say that it is none.
    fn tell_of_9999(&mut self) {
        let count = self.heights.iter().filter(|&&height| height == -9999.0).count();
        if count > 0 {
            let hold = if count == 1 { "1 cell has".to_owned() } else { format!("{count} cells have") };
            let message = format!(
                "{hold} the height −9999, which many programs write for no data: the file does not say so, it was read as ground"
            );
            self.notices.push(Notice::new("terrain-9999", message).with("count", count));
        }
    }

    /// Says which cells have no data, and that cells are not square.
    fn tell_of_cells(&mut self) {
        let missing = self.heights.iter().filter(|h| h.is_nan()).count();
        if missing > 0 {
            let message = match missing {
                1 => "1 cell has no data: it is blocked".into(),
                _ => format!("{missing} cells have no data: they are blocked"),
            };
            self.notices.push(Notice::new("terrain-no-data", message).with("count", missing));
        }
        let [x, y] = self.cell;
        // What is less than a thousandth apart would not be heard of in any length.
        if (x / y - 1.0).abs() > 1e-3 {
            let (mean, square) = (libm::sqrt(x * y), square_size(self.cell, self.size()));
            // What is left is the rounding to whole cells.
            if square == self.size() {
                return;
            }
            let message = format!(
                "cells are {x:.4} m wide and {y:.4} m high; they are taken for squares of {mean:.4} m. In {} × {} cells they are square",
                square.0, square.1
            );
            let notice = Notice::new("terrain-cells-not-square", message);
            let notice = notice.with("x", format!("{x:.4}")).with("y", format!("{y:.4}")).with("mean", format!("{mean:.4}"));
            self.notices.push(notice.with("columns", square.0).with("rows", square.1));
        }
    }
}

impl Survey {
    /// Columns and rows in which the ground of a window, or all of it, has square cells: of the finer side of the file's cells, unless that
    /// would be more than a map has.
    pub fn square_size(&self, crop: Option<Window>) -> (u32, u32) {
        square_size(self.cell, crop.map_or((self.width, self.height), |window| (window.width, window.height)))
    }
}

/// The size in which so many cells of so many metres become square ones.
fn square_size(cell: [f64; 2], (width, height): (u32, u32)) -> (u32, u32) {
    let extent = [cell[0] * f64::from(width), cell[1] * f64::from(height)];
    let side = cell[0].min(cell[1]).max(extent[0].max(extent[1]) / f64::from(MAX_SIDE));
    let cells = |metres: f64| (libm::round(metres / side) as u32).clamp(1, MAX_SIDE);
    (cells(extent[0]), cells(extent[1]))
}
