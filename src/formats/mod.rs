//! Files: what a page or a command line is handed, and what it hands out.
//!
//! [`sniff`] tells what a file is by its contents, [`import`] reads a map, [`import_scen`] a list of scenarios, [`read_path`] a
//! path, [`import_results`] results of runs from elsewhere, [`comparison_json`] a whole comparison; [`survey`] looks at a raster of heights and [`import_terrain`] reads a piece of
//! it; [`export`] writes. No bytes make any of them panic; what is accepted with a remark comes with a [`Notice`].
//! docs/formats.md describes each format.

pub mod comparison_json;
mod ends;
mod matrix;
mod movingai;
mod path_list;
mod results;
mod scen;
mod scenario_json;
mod table;
mod terrain;
mod text;

use serde::{Deserialize, Serialize};

use crate::comparison::names::stem;
use crate::error::{Error, FormatError, Notice};
use crate::map::{Grid, Point, Window};
use crate::scenario::{Goal, ScenarioSpec, TerrainMoves};

pub use comparison_json::ComparisonDocument;
pub use path_list::{path_kind, read_path, read_places};
pub use results::{MAX_ENTRIES, MAX_INSTANCES, MAX_ROWS, import_results};
pub use scen::{ScenFile, ScenLine, check_scen, misfit};
pub use terrain::{Survey, TerrainOptions, import_terrain, survey};

/// What a file is. Serialized as `movingai-map`, `movingai-scen`, `matrix`, `esri-ascii`, `height-table`, `geotiff`, `srtm`, `scenario`,
/// `session`, `comparison`, `results`, `unknown`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Kind {
    /// A map of the MovingAI benchmarks.
    MovingaiMap,
    /// A list of scenarios of the MovingAI benchmarks.
    MovingaiScen,
    /// Numbers in rows and columns.
    Matrix,
    /// Heights as an ESRI ASCII grid.
    EsriAscii,
    /// Heights in rows and columns.
    HeightTable,
    /// Heights as a GeoTIFF.
    Geotiff,
    /// Heights as an SRTM tile.
    Srtm,
    /// A scenario with its map, as JSON.
    Scenario,
    /// A race as it is shared (`formicarium/experiment@1`), as JSON.
    Session,
    /// Many runs with their question and maps, as JSON.
    Comparison,
    /// Runs from elsewhere, as a table or a data file of IOHanalyzer.
    Results,
    /// None of these.
    Unknown,
}

/// A map with everything that can be planned on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// What the file was.
    pub kind: Kind,
    /// The map.
    pub grid: Grid,
    /// The question asked on it; its name is the file's where the format has none.
    pub spec: ScenarioSpec,
    /// What was assumed, chosen or left out.
    pub notices: Vec<Notice>,
}

impl Kind {
    /// Whether files of this kind are rasters of heights.
    pub const fn is_raster(self) -> bool {
        matches!(self, Self::EsriAscii | Self::HeightTable | Self::Geotiff | Self::Srtm)
    }
}

impl Imported {
    /// Whether start or goal had to be chosen because the file names none.
    pub fn ends_were_chosen(&self) -> bool {
        self.notices.iter().any(|n| n.kind == ends::CHOSEN)
    }

    /// A window of the map, and the same ground in another number of cells.
    fn piece(mut self, TerrainOptions { crop, size }: TerrainOptions) -> Result<Self, FormatError> {
        let window = crop.unwrap_or(Window { x: 0, y: 0, width: self.grid.width(), height: self.grid.height() });
        self.grid = self.grid.cropped(window)?;
        let (width, height) = size.unwrap_or((window.width, window.height));
        self.grid = self.grid.resampled(width, height)?;
        let scaled = |at: u32, from: u32, of: u32, to: u32| {
            (u64::from(at.checked_sub(from)?) * u64::from(to) / u64::from(of)).try_into().ok()
        };
        let moved = |p: Point| {
            let x = scaled(p.x, window.x, window.width, width)?;
            let y = scaled(p.y, window.y, window.height, height)?;
            Some(Point::new(x, y)).filter(|&p| self.grid.is_free_at(i64::from(p.x), i64::from(p.y)))
        };
        let [of, to] = [f64::from(window.width) * f64::from(window.height), f64::from(width) * f64::from(height)];
        let chosen = self.ends_were_chosen();
        let mut goals = Vec::new();
        for goal in self.spec.goals.drain(..).filter(|_| !chosen) {
            let at = moved(goal.at).filter(|&at| goals.iter().all(|g: &Goal| g.at != at));
            goals.extend(at.map(|at| Goal { at, ..goal }));
        }
        let start = moved(self.spec.start).filter(|_| !chosen);
        let ends = ends::complete(&self.grid, start, goals.first().map(|g| g.at))?;
        if goals.is_empty() {
            goals.push(Goal::new(ends.goal, ""));
        }
        let resolution = self.spec.resolution * libm::sqrt(of / to);
        self.spec = ScenarioSpec { width, height, resolution, start: ends.start, goals, ..self.spec };
        lift_ends(&self.grid, &mut self.spec);
        self.notices.retain(|n| n.kind != ends::CHOSEN);
        self.notices.extend(ends.notice);
        Ok(self)
    }

    /// Swaps free and blocked cells. Ends that the file names stay free, others are chosen anew.
    ///
    /// # Errors
    /// [`FormatError::NoFreeCell`].
    pub fn invert(mut self) -> Result<Self, FormatError> {
        let chosen = self.ends_were_chosen();
        let goal = self.spec.goals.first().map_or(self.spec.start, |g| g.at);
        for cell in 0..self.grid.len() as u32 {
            let point = self.grid.point(cell);
            let is_end = !chosen && (point == self.spec.start || point == goal);
            let blocked = !is_end && !self.grid.is_blocked(cell);
            self.grid.set_blocked(cell, blocked);
        }
        if chosen {
            let ends = ends::complete(&self.grid, None, None)?;
            self.spec = ScenarioSpec { start: ends.start, ..self.spec };
            self.spec.goals.iter_mut().for_each(|g| g.at = ends.goal);
            self.notices.retain(|n| n.kind != ends::CHOSEN);
            self.notices.extend(ends.notice);
        }
        Ok(self)
    }
}

/// By slices: raises the levels of start and goal to the ground on which they have come to lie.
fn lift_ends(grid: &Grid, spec: &mut ScenarioSpec) {
    let (Some(heights), Some(terrain)) = (grid.heights(), &mut spec.terrain) else { return };
    let TerrainMoves::Slices(rules) = &mut terrain.moves else { return };
    let (level, unit) = (rules.level, terrain.vertical_unit);
    let lowest = |at: Point| libm::ceil(f64::from(heights[grid.cell(at) as usize]) * unit / level) as u32;
    rules.start_level = rules.start_level.max(lowest(spec.start));
    rules.goal_level = spec.goals.first().map_or(rules.goal_level, |goal| rules.goal_level.max(lowest(goal.at)));
}

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

/// Tells what a file is. Its contents decide; the name only lets a `.scen` pass that lacks its version line.
pub fn sniff(bytes: &[u8], name: &str) -> Kind {
    match kind_of(bytes, name) {
        Kind::Matrix if holds_heights(bytes) => Kind::HeightTable,
        kind => kind,
    }
}

/// The same, except that a table may be a map or hold heights.
fn kind_of(bytes: &[u8], name: &str) -> Kind {
    if terrain::geotiff::looks_like(bytes) {
        return Kind::Geotiff;
    }
    let text = text::decode_up_to(bytes, text::MAX_RASTER_BYTES);
    let called_hgt = name.to_ascii_lowercase().ends_with(".hgt");
    if terrain::srtm::side_of(bytes.len()).is_some() && (called_hgt || text.is_err()) {
        return Kind::Srtm;
    }
    text.map_or(Kind::Unknown, |text| sniff_text(&text, name))
}

fn holds_heights(bytes: &[u8]) -> bool {
    text::decode(bytes).is_ok_and(|text| table::read(&text).is_ok_and(|table| !matrix::is_map(&table)))
}

fn sniff_text(text: &str, name: &str) -> Kind {
    if text.trim_start().starts_with('{') {
        return sniff_json(text);
    }
    let called_scen = name.to_ascii_lowercase().ends_with(".scen");
    if scen::has_version(text) || (called_scen && scen::has_fields(text)) {
        Kind::MovingaiScen
    } else if movingai::looks_like(text) {
        Kind::MovingaiMap
    } else if results::looks_like(text) {
        Kind::Results
    } else if terrain::esri_ascii::looks_like(text) {
        Kind::EsriAscii
    } else if table::looks_like(text) {
        Kind::Matrix
    } else {
        Kind::Unknown
    }
}

fn sniff_json(text: &str) -> Kind {
    // Broken JSON still tells what it was meant to be, so that the error is about the line and not about the format.
    let format = scenario_json::format_of(text).unwrap_or_else(|| text.into());
    let place = |word| format.find(word).unwrap_or(usize::MAX);
    let named = [
        (place("formicarium/scenario@"), Kind::Scenario),
        (place("formicarium/experiment@"), Kind::Session),
        (place("formicarium/comparison@"), Kind::Comparison),
        // Of a single run: the reader of comparisons says so.
        (place("formicarium/result@"), Kind::Comparison),
    ];
    let first = named.into_iter().filter(|(place, _)| *place < usize::MAX).min_by_key(|(place, _)| *place);
    first.map_or(Kind::Unknown, |(_, kind)| kind)
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

/// Reads a scenario with its map from JSON, as docs/schema/scenario@1.json says.
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
