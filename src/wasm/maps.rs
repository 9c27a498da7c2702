//! Maps from and to files, and made-up ones. Left out of the core that a page loads first (feature `maps`).

use std::sync::Arc;

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::{self, Bytes, Heights, Number, Text};
use super::{Answer, grid, object, plain, scenario, throw};
use crate::error::{ErrorReport, FormatError, Notice, ScenarioError};
use crate::formats::{
    self, BinaryExport, Companion, Export, Kind, MatrixInfo, NamedFile, ReadOptions, Recognition, ScenFile, TerrainOptions,
};
use crate::map::{Generator, Grid, Movement, Point, SliceRules, Window};
use crate::scenario::{Scenario, ScenarioSpec};

/// An imported map.
#[derive(Serialize, Tsify)]
pub struct Imported {
    /// The format found.
    pub kind: Kind,
    /// The scenario without its cells.
    pub spec: ScenarioSpec,
    /// Row by row; 1 = blocked.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub cells: Vec<u8>,
    /// On a terrain one height a cell as little-endian f32, NaN for no data; empty on a plane.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub heights: Vec<u8>,
    /// On weighted ground one factor a cell as little-endian f32; empty on plain ground.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub factors: Vec<u8>,
    /// What is worth saying about the file.
    pub warnings: Vec<Notice>,
}

/// A generated map.
#[derive(Serialize, Tsify)]
pub struct Generated {
    /// Row by row; 1 = blocked.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub cells: Vec<u8>,
    /// Of a terrain one height a cell in metres, as little-endian f32; empty on a plane.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub heights: Vec<u8>,
    /// Metres per cell.
    pub resolution: f64,
    /// A free cell near the upper left.
    #[tsify(type = "[number, number]")]
    pub start: Point,
    /// A free cell near the lower right, reachable from `start`.
    #[tsify(type = "[number, number]")]
    pub goal: Point,
}

/// A raster of heights before it is opened.
#[derive(Serialize, Tsify)]
pub struct Survey {
    /// The format found.
    pub kind: Kind,
    /// Columns; may be more than a map has.
    pub width: u32,
    /// Rows; may be more than a map has.
    pub height: u32,
    /// Metres per cell along a row and along a column.
    #[tsify(type = "[number, number]")]
    pub cell: [f64; 2],
    /// Metres of a height of 1.
    pub unit: f64,
    /// Lowest height, in the file's unit.
    pub lowest: f32,
    /// Highest height, in the file's unit.
    pub highest: f32,
    /// Cells without data.
    #[tsify(type = "number")]
    pub missing: u32,
    /// Columns of the preview, at most 256.
    pub preview_width: u32,
    /// Rows of the preview, at most 256.
    pub preview_height: u32,
    /// Heights of the preview as little-endian f32, NaN for no data.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub preview: Vec<u8>,
    /// What was assumed.
    pub warnings: Vec<Notice>,
}

/// Columns and rows.
#[derive(serde::Deserialize, Tsify)]
#[serde(transparent)]
pub struct Size(#[tsify(type = "[number, number]")] (u32, u32));

/// The formats that can be written.
#[derive(serde::Deserialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum ExportFormat {
    /// Cells only.
    MovingaiMap,
    /// Start, goal and the exact optimum.
    MovingaiScen,
    /// Cells only, 0 and 1.
    Matrix,
    /// Heights only, as an ESRI ASCII grid.
    EsriAscii,
    /// Heights only, as CSV.
    HeightTable,
    /// Everything.
    Scenario,
}

/// What a file is.
#[derive(Serialize, Tsify)]
pub struct Recognised {
    /// The format found; `unknown` where the import will say why.
    pub kind: Kind,
    /// Whether files of this kind are rasters of heights, which are looked at and cut to size before they are opened.
    pub raster: bool,
    /// Whether a map can be made of files of this kind.
    pub map: bool,
    /// Whether nothing else could be meant.
    pub certain: bool,
    /// By what it was told, in English.
    pub why: String,
}

/// Tells a file's format; contents decide, the name helps. Throws for a known format that is not read here, with what to do.
#[wasm_bindgen]
pub fn recognise(bytes: &Bytes, name: &Text) -> Answer<Ts<Recognised>> {
    let (bytes, name) = (bytes.read("bytes")?, name.read("name")?);
    let found = match formats::recognise(&bytes, &name) {
        Ok(found) => found,
        // The import names what is missing.
        Err(FormatError::Unknown { .. }) => Recognition { kind: Kind::Unknown, is_certain: false, why: "" },
        Err(error) => return Err(throw(error)),
    };
    let kind = if found.kind == Kind::Matrix { formats::sniff(&bytes, &name) } else { found.kind };
    // A text with several matrices is told apart by its numbers later.
    let kind = if kind == Kind::Unknown { found.kind } else { kind };
    Ok(object(&Recognised {
        kind,
        raster: kind.is_raster(),
        map: kind.holds_cells(),
        certain: found.is_certain,
        why: found.why.into(),
    }))
}

/// Reads a map or scenario of any known format. `options` say what to do where a file leaves a choice; `image` is the picture of a ROS map.
#[wasm_bindgen]
pub fn import_map(bytes: &Bytes, name: &Text, options: Option<Ts<ReadOptions>>, image: Option<Bytes>) -> Answer<Ts<Imported>> {
    let (bytes, name) = (bytes.read("bytes")?, name.read("name")?);
    let options = options.map(|options| arguments::value(&options, "options")).transpose()?.unwrap_or_default();
    let image = image.map(|image| image.read("image")).transpose()?;
    let beside = image.as_ref().map(|bytes| Companion { name: "", bytes });
    let map = formats::import_with(&bytes, &name, &options, beside).map_err(throw)?;
    if !map.spec.changes.is_empty() {
        let (field, value) = ("changes".into(), format!("a list of {}", map.spec.changes.len()));
        return Err(throw(ScenarioError::Change {
            field,
            value,
            allowed: "absent: the page opens changes with a session; `plan` runs this file",
        }));
    }
    Ok(imported(map))
}

/// Which matrices a text holds.
#[wasm_bindgen]
pub fn list_matrices(bytes: &Bytes) -> Answer<Vec<Ts<MatrixInfo>>> {
    Ok(formats::list_matrices(&bytes.read("bytes")?).map_err(throw)?.iter().map(object).collect())
}

/// The name of the picture that the description of a ROS map names, perhaps with folders.
#[wasm_bindgen]
pub fn ros_image(yaml: &Bytes) -> Answer<String> {
    formats::ros::image_of(&yaml.read("yaml")?).map_err(throw)
}

/// A file of an archive.
#[derive(Serialize, Tsify)]
pub struct Unpacked {
    /// Its name, perhaps with folders.
    pub name: String,
    /// What it holds.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub bytes: Vec<u8>,
}

/// The files of a ZIP or gzip archive: at most 1000, at most 512 MiB.
#[wasm_bindgen]
pub fn unpack(bytes: &Bytes, name: &Text) -> Answer<Vec<Ts<Unpacked>>> {
    let files = formats::unpack(&bytes.read("bytes")?, &name.read("name")?).map_err(throw)?;
    Ok(files.into_iter().map(|NamedFile { name, bytes }| object(&Unpacked { name, bytes })).collect())
}

/// A map for ROS's map_server.
#[derive(Serialize, Tsify)]
pub struct RosFiles {
    /// The description, `map.yaml`.
    pub yaml: String,
    /// The picture that it names.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub pgm: Vec<u8>,
}

/// Writes the cells and the place of a map for ROS's map_server; `image` is the name that the picture will have.
#[wasm_bindgen]
pub fn export_ros(spec: Ts<ScenarioSpec>, cells: &Bytes, image: &Text) -> Answer<Ts<RosFiles>> {
    let spec: ScenarioSpec = arguments::value(&spec, "spec")?;
    let grid = grid(spec.width, spec.height, cells, [None, None])?;
    let scenario = Scenario::new(grid, ScenarioSpec { terrain: None, ..spec }).map_err(throw)?;
    let formats::ros::RosMap { yaml, pgm } = formats::ros::write(&scenario.drawn, None, &scenario.spec, &image.read("image")?);
    Ok(object(&RosFiles { yaml, pgm }))
}

pub(super) fn imported(formats::Imported { kind, grid, spec, notices, .. }: formats::Imported) -> Ts<Imported> {
    let (heights, factors) = (height_bytes(&grid), factor_bytes(&grid));
    object(&Imported { kind, spec, cells: grid.to_bytes(), heights, factors, warnings: notices })
}

/// The heights of a terrain as little-endian f32; empty on a plane.
fn height_bytes(grid: &Grid) -> Vec<u8> {
    grid.heights().map_or_else(Vec::new, |heights| le_bytes(heights))
}

/// The factors of weighted ground as little-endian f32; empty where there are none.
fn factor_bytes(grid: &Grid) -> Vec<u8> {
    grid.factors().map_or_else(Vec::new, |factors| le_bytes(factors))
}

fn le_bytes(heights: &[f32]) -> Vec<u8> {
    heights.iter().flat_map(|h| h.to_le_bytes()).collect()
}

/// Looks at a raster of heights without opening it.
#[wasm_bindgen]
pub fn survey_terrain(bytes: &Bytes, name: &Text) -> Answer<Ts<Survey>> {
    let found = formats::survey(&bytes.read("bytes")?, &name.read("name")?).map_err(throw)?;
    Ok(object(&Survey {
        kind: found.kind,
        width: found.width,
        height: found.height,
        cell: found.cell,
        unit: found.unit,
        lowest: found.lowest,
        highest: found.highest,
        missing: found.missing,
        preview_width: found.preview_width,
        preview_height: found.preview_height,
        preview: le_bytes(&found.preview),
        warnings: found.notices,
    }))
}

/// Reads a raster of heights: all of it or a window, in its own cells or in another number of them. What a map cannot hold is shrunk by a
/// whole number.
#[wasm_bindgen]
pub fn import_terrain(bytes: &Bytes, name: &Text, crop: Option<Ts<Window>>, size: Option<Ts<Size>>) -> Answer<Ts<Imported>> {
    let (bytes, name) = (bytes.read("bytes")?, name.read("name")?);
    let crop = crop.map(|crop| arguments::value(&crop, "crop")).transpose()?;
    let size = size.map(|size| arguments::value(&size, "size")).transpose()?;
    let options = TerrainOptions { crop, size: size.map(|Size(size)| size) };
    Ok(imported(formats::import_terrain(&bytes, &name, options).map_err(throw)?))
}

/// The rules of movement by slices that suit a terrain whose heights are `vertical_unit` metres each.
#[wasm_bindgen]
pub fn fitting_slices(
    spec: Ts<ScenarioSpec>,
    cells: &Bytes,
    heights: Option<Heights>,
    factors: Option<Heights>,
    vertical_unit: &Number,
) -> Answer<Ts<SliceRules>> {
    let (spec, vertical_unit) = (arguments::value(&spec, "spec")?, vertical_unit.real("vertical_unit")?);
    let grid = grid(spec.width, spec.height, cells, [heights.as_ref(), factors.as_ref()])?;
    let goal = spec.goals.first().map_or(spec.start, |goal| goal.at);
    Ok(object(&SliceRules::fitting_map(&grid, vertical_unit, spec.start, goal, None)))
}

/// A map as the robot feels it.
#[derive(Serialize, Tsify)]
pub struct FeltMap {
    /// Row by row; 1 = blocked, by an obstacle or because the robot does not fit.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub blocked: Vec<u8>,
    /// One factor a cell as little-endian f32; empty where all ground costs its length.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub factors: Vec<u8>,
}

/// The map as the robot feels it, whether or not it has room at start and goals.
#[wasm_bindgen]
pub fn felt_map(
    spec: Ts<ScenarioSpec>,
    cells: &Bytes,
    heights: Option<Heights>,
    factors: Option<Heights>,
) -> Answer<Ts<FeltMap>> {
    let spec: ScenarioSpec = arguments::value(&spec, "spec")?;
    let drawn = grid(spec.width, spec.height, cells, [heights.as_ref(), factors.as_ref()])?;
    spec.check(&drawn).map_err(throw)?;
    let felt = spec.felt(&drawn);
    Ok(object(&FeltMap { blocked: felt.to_bytes(), factors: factor_bytes(&felt) }))
}

/// Writes the heights as a GeoTIFF of f32 in metres.
#[wasm_bindgen]
pub fn export_geotiff(
    spec: Ts<ScenarioSpec>,
    cells: &Bytes,
    heights: Option<Heights>,
    factors: Option<Heights>,
) -> Answer<Vec<u8>> {
    let scenario = scenario(&spec, cells, [heights.as_ref(), factors.as_ref()])?;
    formats::export_binary(&scenario.drawn, &scenario.spec, BinaryExport::Geotiff).map_err(throw)
}

/// Reads the lines of a MovingAI .scen file.
#[wasm_bindgen]
pub fn import_scen(bytes: &Bytes) -> Answer<Ts<ScenFile>> {
    Ok(object(&formats::import_scen(&bytes.read("bytes")?).map_err(throw)?))
}

/// Writes a map or scenario. A .scen line carries the exact optimum of its format's rule (8 moves, no corner cut), computed here; it throws
/// when there is no path to write down.
#[wasm_bindgen]
pub fn export_map(
    spec: Ts<ScenarioSpec>,
    cells: &Bytes,
    heights: Option<Heights>,
    factors: Option<Heights>,
    format: Ts<ExportFormat>,
) -> Answer<String> {
    let scenario = scenario(&spec, cells, [heights.as_ref(), factors.as_ref()])?;
    let (grid, spec) = (&scenario.drawn, &scenario.spec);
    let format = match arguments::word(&format.js_value(), "format")? {
        ExportFormat::MovingaiMap => Export::MovingaiMap,
        ExportFormat::MovingaiScen => Export::MovingaiScen { optimal: movingai_optimum(grid, spec)? },
        ExportFormat::Matrix => Export::Matrix,
        ExportFormat::EsriAscii => Export::EsriAscii,
        ExportFormat::HeightTable => Export::HeightTable,
        ExportFormat::Scenario => Export::Scenario,
    };
    Ok(formats::export(grid, spec, format))
}

fn movingai_optimum(grid: &Grid, spec: &ScenarioSpec) -> Answer<f64> {
    let spec = ScenarioSpec { movement: Movement::default(), terrain: None, robot: None, ..spec.clone() };
    let scenario = Arc::new(Scenario::new(grid.clone().cells_alone(), spec).map_err(throw)?);
    crate::exact::optimum(&scenario).ok_or_else(|| {
        let message = "a .scen line needs a length, and no path leads from start to goal without cutting a corner";
        plain(&ErrorReport::new("no-path", "goal", message, "open a way, or export the scenario as JSON"))
    })
}

/// Makes a seeded map; `density` (0..=0.9) counts for `random`, `blocks` and `bars`, and is the roughness of the terrains `fractal` and `hills`.
#[wasm_bindgen]
pub fn generate(kind: Ts<Generator>, width: &Number, height: &Number, seed: &Number, density: &Number) -> Answer<Ts<Generated>> {
    let (width, height, seed) = (width.whole("width")?, height.whole("height")?, seed.whole("seed")?);
    let kind = arguments::word(&kind.js_value(), "kind")?;
    let made = crate::map::generate(kind, width, height, seed, density.real("density")?).map_err(throw)?;
    let (cells, heights) = (made.grid.to_bytes(), height_bytes(&made.grid));
    Ok(object(&Generated { cells, heights, resolution: made.resolution, start: made.start, goal: made.goal }))
}
