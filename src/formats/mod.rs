//! Files: what a page or a command line is handed, and what it hands out.
//!
//! [`recognise`] tells what a file is by its contents, [`import`] reads a map, [`import_with`] one that leaves a choice or comes in two files, [`import_scen`] a list of scenarios, [`read_path`] a
//! path, [`PathFormat`] writes one, [`import_results`] results of runs from elsewhere, [`session`] a race as the page shares it, [`tsplib`] order problems, [`comparison_json`] a whole comparison; [`survey`] looks at a raster of heights and [`import_terrain`] reads a piece of
//! it; [`export`] writes. No bytes make any of them panic; what is accepted with a remark comes with a [`Notice`].
//! docs/formats.md describes each format.

mod archive;
pub mod comparison_json;
pub mod comparison_rows;
mod drawing;
mod ends;
pub mod figure;
mod foreign;
mod imported_map;
pub mod journal;
mod kind;
mod matrix;
mod movingai;
mod numbers;
mod options;
mod path_list;
mod path_out;
pub mod picture;
mod recognise;
mod results;
pub mod ros;
pub mod run_result;
mod scen;
mod scenario_json;
pub mod session;
mod terrain;
mod text;
pub mod tsplib;

use serde::Serialize;

use crate::comparison::names::stem;
use crate::error::{Error, FormatError, Notice};
use crate::map::{Grid, Point};
use crate::scenario::ScenarioSpec;

pub use archive::{NamedFile, unpack};
pub use comparison_json::ComparisonDocument;
pub use imported_map::Imported;
pub use kind::Kind;
pub use options::{FigureOptions, ReadOptions};
pub use path_list::{PathOnMap, WorldPath, path_kind, read_path, read_path_on, read_places, read_steps_on, read_world_path};
pub use path_out::{PathFile, PathFormat, PlannedPath};
use picture::PictureOptions;
pub use recognise::{Recognition, recognise, sniff};
pub use results::{MAX_ENTRIES, MAX_INSTANCES, MAX_ROWS, import_results, results_table};
pub use scen::{ScenFile, ScenLine, check_scen, misfit};
pub use terrain::{FARTHEST, Survey, TerrainOptions, import_terrain, survey};
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
    import_with(bytes, name, &ReadOptions::default(), None)
}

/// A file that came with others, e.g. the picture of a ROS map.
#[derive(Debug, Clone, Copy)]
pub struct Companion<'a> {
    /// Its name, perhaps with folders.
    pub name: &'a str,
    /// What it holds.
    pub bytes: &'a [u8],
}

/// Reads a map as [`import`] does, with what was chosen where the file leaves a choice, and with the file that belongs to it.
///
/// # Errors
/// As [`import`]; [`FormatError::Needs`] where another file belongs to it; [`FormatError::Several`] where nothing says which matrix is meant.
pub fn import_with(bytes: &[u8], name: &str, options: &ReadOptions, beside: Option<Companion<'_>>) -> Result<Imported, Error> {
    let found = match recognise(bytes, name) {
        Ok(found) => found,
        // An object without a format: the error names what is missing.
        Err(FormatError::Unknown { begins }) if begins.starts_with('{') => return Ok(scenario(&text::decode(bytes)?)?),
        Err(error) => return Err(error.into()),
    };
    let mut imported = read(found.kind, bytes, name, options, beside)?;
    if !found.is_certain {
        let message = format!("it was read as {}, told by {}", found.kind.name(), found.why);
        imported.notices.insert(0, Notice::new("read-as", message).with("kind", found.kind.name()).with("why", found.why));
    }
    Ok(imported)
}

/// Reads a file of this kind as a map.
fn read(kind: Kind, bytes: &[u8], name: &str, options: &ReadOptions, beside: Option<Companion<'_>>) -> Result<Imported, Error> {
    options.check(kind)?;
    if kind.is_raster() {
        return import_terrain(bytes, name, TerrainOptions::default());
    }
    if kind == Kind::Archive {
        return archive::import_archive(bytes, name, options);
    }
    let decoded = || text::decode(bytes);
    let imported = match kind {
        Kind::MovingaiMap => {
            let file = movingai::read(&decoded()?, options.swamp_factor)?;
            complete(kind, name, file.grid, None, None, file.notices)?
        }
        Kind::Matrix => table(&decoded()?, name, options.matrix)?,
        Kind::Drawing => {
            let file = drawing::read(&decoded()?)?;
            complete(kind, name, file.grid, file.start, file.goal, file.notices)?
        }
        Kind::Picture => match &options.figure {
            Some(figure) => figure::import(bytes, name, figure, &options.picture)?,
            None => picture(bytes, name, &options.picture)?,
        },
        Kind::RosMap => match beside {
            Some(image) => ros::read_map(bytes, image.bytes, name, options)?,
            None => return Err(FormatError::Needs { found: kind.name(), other: ros::image_of(bytes)? }.into()),
        },
        Kind::OccupancyGrid => ros::read_message(&decoded()?, name, options)?,
        Kind::Mapf => ros::read_mapf(&decoded()?, name)?,
        Kind::Scenario => scenario(&decoded()?)?,
        Kind::Tsplib => {
            let hint = format!("put its places in an order: formicarium order {name}").into();
            return Err(FormatError::Foreign { found: kind.name(), hint }.into());
        }
        Kind::TsplibTour => {
            let hint =
                "open it together with its instance; on the command line: formicarium order INSTANCE.tsp --tour FILE".into();
            return Err(FormatError::Foreign { found: kind.name(), hint }.into());
        }
        _ => return Err(FormatError::NotAMap { found: kind.name() }.into()),
    };
    Ok(imported)
}

/// A matrix of a text that may hold several.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatrixInfo {
    /// Its number, from 1: what [`ReadOptions::matrix`] takes.
    pub number: u32,
    /// What it is called in the text, or nothing.
    pub name: String,
    /// Its first line, from 1.
    pub line: u32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// Which matrices a text holds.
///
/// # Errors
/// [`FormatError`]: it holds none, or what looks like one is broken.
pub fn list_matrices(bytes: &[u8]) -> Result<Vec<MatrixInfo>, Error> {
    let found = numbers::find(&text::decode(bytes)?)?;
    let info = |(index, one): (usize, &numbers::Found)| MatrixInfo {
        number: index as u32 + 1,
        name: one.name.clone(),
        line: one.table.line(0) as u32,
        width: one.table.row(0).len() as u32,
        height: one.table.height() as u32,
    };
    Ok(found.iter().enumerate().map(info).collect())
}

/// A picture by its threshold.
fn picture(bytes: &[u8], name: &str, options: &PictureOptions) -> Result<Imported, FormatError> {
    let picture::Cells { width, height, blocked, resolution, notices, .. } =
        picture::to_cells(&picture::decode(bytes)?, options)?;
    let grid = Grid::from_bytes(width, height, &blocked)?;
    let mut imported = complete(Kind::Picture, name, grid, None, None, notices)?;
    imported.spec.resolution = resolution.unwrap_or(imported.spec.resolution);
    Ok(imported)
}

/// Reads a map as [`import`] does, and of it a window, or the same ground in another number of cells. Ends that lie outside the window or
/// come to lie on an obstacle are chosen anew.
///
/// # Errors
/// As [`import`]; [`FormatError::Window`], or [`crate::error::ScenarioError::MapSize`].
pub fn import_piece(bytes: &[u8], name: &str, options: TerrainOptions) -> Result<Imported, Error> {
    let kind = sniff(bytes, name);
    if kind == Kind::Archive {
        let files = archive::unpack(bytes, name)?;
        let one = archive::only(&files)?;
        return import_piece(&one.bytes, &one.name, options);
    }
    if kind.is_raster() {
        return import_terrain(bytes, name, options);
    }
    Ok(import(bytes, name)?.piece(options)?)
}

/// A map, or heights.
fn table(text: &str, name: &str, matrix: Option<u32>) -> Result<Imported, FormatError> {
    let found = numbers::read(text, matrix)?;
    if !matrix::is_map(&found.table) {
        return terrain::terrain(terrain::height_table::read(found)?, name, TerrainOptions::default());
    }
    let file = matrix::read(found)?;
    complete(Kind::Matrix, name, file.grid, file.start, file.goal, file.notices)
}

/// Reads a scenario with its map from JSON, as docs/schema/scenario.schema.json says.
///
/// # Errors
/// [`FormatError`] with the line of broken JSON, or the name of the field at fault.
pub fn read_scenario(text: &str) -> Result<(Grid, ScenarioSpec), FormatError> {
    scenario_json::read(text)
}

/// Reads the fields of a scenario without its map from JSON.
///
/// # Errors
/// [`FormatError`] with the name of the field at fault.
pub fn read_spec(text: &str) -> Result<ScenarioSpec, FormatError> {
    scenario_json::read_spec_alone(text)
}

/// A map of cells that come from no file, and ends for it: those that are not given are chosen as [`import`] chooses them.
///
/// # Errors
/// [`FormatError::NoFreeCell`].
pub fn of_cells(grid: Grid, name: &str, start: Option<Point>, goal: Option<Point>) -> Result<Imported, FormatError> {
    complete(Kind::Matrix, name, grid, start, goal, Vec::new())
}

/// What the field `format` of a JSON object says.
pub fn format_of(text: &str) -> Option<String> {
    scenario_json::format_of(text)
}

fn scenario(text: &str) -> Result<Imported, FormatError> {
    let (grid, spec) = scenario_json::read(text)?;
    Ok(Imported { kind: Kind::Scenario, grid, spec, notices: Vec::new(), unknown: None })
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
    Ok(Imported { kind, grid, spec, notices, unknown: None })
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
