//! Files: what a page or a command line is handed, and what it hands out.
//!
//! [`sniff`] tells what a file is by its contents, [`import`] reads a map, [`import_scen`] a list of scenarios, [`read_path`] a
//! path, [`import_results`] results of runs from elsewhere, [`comparison_json`] a whole comparison; [`survey`] looks at a raster of heights and [`import_terrain`] reads a piece of
//! it; [`export`] writes. No bytes make any of them panic; what is accepted with a remark comes with a [`Notice`].
//! docs/formats.md describes each format.

pub mod comparison_json;
mod ends;
pub mod figure;
mod imported_map;
mod matrix;
mod movingai;
mod path_list;
pub mod picture;
mod results;
mod scen;
mod scenario_json;
mod sniff;
mod table;
mod terrain;
mod text;

use crate::comparison::names::stem;
use crate::error::{Error, FormatError, Notice};
use crate::map::{Grid, Point};
use crate::scenario::ScenarioSpec;

pub use comparison_json::ComparisonDocument;
pub use imported_map::Imported;
pub use path_list::{path_kind, read_path, read_places};
pub use results::{MAX_ENTRIES, MAX_INSTANCES, MAX_ROWS, import_results};
pub use scen::{ScenFile, ScenLine, check_scen, misfit};
use sniff::kind_of;
pub use sniff::{Kind, sniff};
pub use terrain::{Survey, TerrainOptions, import_terrain, survey};
pub use text::{MAX_BYTES, MAX_TEXT_BYTES};

/// A format that can be written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Export {
    /// The cells alone.
    MovingaiMap,
    /// Start and goal alone, with the exact optimum for 8 moves and `both-free`.
    MovingaiScen {
        /// Its length in cells.
        optimal: f64,
    },
    /// The cells alone, as CSV of 0 and 1.
    Matrix,
    /// The heights alone, as an ESRI ASCII grid.
    EsriAscii,
    /// The heights alone, as CSV; −9999 for no data.
    HeightTable,
    /// Everything, as JSON.
    Scenario,
}

/// A binary format that can be written; it holds heights alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BinaryExport {
    /// f32 in metres.
    Geotiff,
    /// Whole metres, 1201 × 1201 or 3601 × 3601 cells.
    Srtm,
}

/// Reads a map in any format that holds one. Where the file names no start or goal, the cells nearest the upper-left and the
/// lower-right corner of the largest connected region are taken. Heights become a terrain whose surface is walked, without a limit of slope.
///
/// # Errors
/// [`FormatError`]: what is wrong, in which line or field, and what is expected there.
pub fn import(bytes: &[u8], name: &str) -> Result<Imported, Error> {
    let kind = kind_of(bytes, name);
    if kind.is_raster() {
        return import_terrain(bytes, name, TerrainOptions::default());
    }
    let text = text::decode(bytes)?;
    let imported = match kind {
        Kind::MovingaiMap => {
            let file = movingai::read(&text)?;
            complete(kind, name, file.grid, None, None, file.notices)?
        }
        Kind::Matrix => table(&text, name)?,
        Kind::Scenario => scenario(&text)?,
        Kind::MovingaiScen => return Err(FormatError::NotAMap { found: "a list of MovingAI scenarios" }.into()),
        Kind::Session => return Err(FormatError::NotAMap { found: "a session" }.into()),
        Kind::Comparison => return Err(FormatError::NotAMap { found: "a comparison" }.into()),
        Kind::Results => return Err(FormatError::NotAMap { found: "a table of results" }.into()),
        // An object without a format: the error names what is missing.
        _ if text.trim_start().starts_with('{') => scenario(&text)?,
        _ => return Err(FormatError::Unknown { begins: text::quote(&text) }.into()),
    };
    Ok(imported)
}

/// Reads a map as [`import`] does, and of it a window, or the same ground in another number of cells. Ends that lie outside the window or
/// come to lie on an obstacle are chosen anew.
///
/// # Errors
/// As [`import`]; [`FormatError::Window`], or [`crate::error::ScenarioError::MapSize`].
pub fn import_piece(bytes: &[u8], name: &str, options: TerrainOptions) -> Result<Imported, Error> {
    if sniff(bytes, name).is_raster() {
        return import_terrain(bytes, name, options);
    }
    Ok(import(bytes, name)?.piece(options)?)
}

/// A map, or heights.
fn table(text: &str, name: &str) -> Result<Imported, FormatError> {
    let table = table::read(text)?;
    if !matrix::is_map(&table) {
        return terrain::terrain(terrain::height_table::read(&table)?, name, TerrainOptions::default());
    }
    let file = matrix::read(&table)?;
    complete(Kind::Matrix, name, file.grid, file.start, file.goal, file.notices)
}

/// Reads a scenario with its map from JSON, as docs/schema/scenario.schema.json says.
///
/// # Errors
/// [`FormatError`] with the line of broken JSON, or the name of the field at fault.
pub fn read_scenario(text: &str) -> Result<(Grid, ScenarioSpec), FormatError> {
    scenario_json::read(text)
}

/// What the field `format` of a JSON object says.
pub fn format_of(text: &str) -> Option<String> {
    scenario_json::format_of(text)
}

fn scenario(text: &str) -> Result<Imported, FormatError> {
    let (grid, spec) = scenario_json::read(text)?;
    Ok(Imported { kind: Kind::Scenario, grid, spec, notices: Vec::new() })
}

fn complete(
    kind: Kind,
    name: &str,
    grid: Grid,
    start: Option<Point>,
    goal: Option<Point>,
    mut notices: Vec<Notice>,
) -> Result<Imported, FormatError> {
    let ends = ends::complete(&grid, start, goal)?;
    notices.extend(ends.notice);
    let spec = ScenarioSpec { name: stem(name).into(), ..ScenarioSpec::new(&grid, ends.start, ends.goal) };
    Ok(Imported { kind, grid, spec, notices })
}

/// Reads a MovingAI `.scen`.
///
/// # Errors
/// [`FormatError`] with the line at fault, or an unknown version.
pub fn import_scen(bytes: &[u8]) -> Result<ScenFile, FormatError> {
    scen::read(&text::decode(bytes)?)
}

/// Writes a scenario, or its map or heights alone, as text. What a format does not hold is lost: see [`Export`]. A plane has height 0 where
/// it is free, and no data where it is not.
pub fn export(grid: &Grid, spec: &ScenarioSpec, format: Export) -> String {
    match format {
        Export::MovingaiMap => movingai::write(grid),
        Export::MovingaiScen { optimal } => scen::write(spec, optimal),
        Export::Matrix => matrix::write(grid),
        Export::EsriAscii => terrain::esri_ascii::write(grid, &terrain::metres(grid, spec), spec.resolution),
        Export::HeightTable => terrain::height_table::write(&terrain::metres(grid, spec), grid.width()),
        Export::Scenario => scenario_json::write(grid, spec),
    }
}

/// Writes the heights of a scenario.
///
/// # Errors
/// [`FormatError::Field`] for a map that the format cannot hold.
pub fn export_binary(grid: &Grid, spec: &ScenarioSpec, format: BinaryExport) -> Result<Vec<u8>, FormatError> {
    let heights = terrain::metres(grid, spec);
    match format {
        BinaryExport::Geotiff => terrain::geotiff::write(grid, &heights, spec.resolution),
        BinaryExport::Srtm => terrain::srtm::write(grid, &heights),
    }
}
