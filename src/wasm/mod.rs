//! The whole browser boundary: types and functions as `pkg/formicarium.d.ts` shows them.
//!
//! Nothing is decided here. Every fallible function throws an `EngineError` object (see [`crate::error::ErrorReport`]); nothing panics on
//! what a page may send.

mod paint;
mod run;

use std::sync::Arc;

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use crate::error::{Error, ErrorReport, Notice};
use crate::formats::{self, Export, Kind, ScenFile};
use crate::map::{Generator, Grid, Movement, Point};
use crate::scenario::{Scenario, ScenarioSpec};

pub use run::Run;

/// What a fallible function returns; the error is an `EngineError` object.
type Answer<T> = Result<T, JsValue>;

/// A value as a plain JS object: maps become objects, `None` becomes null, bytes become a Uint8Array.
fn object<T: Serialize + Tsify>(value: &T) -> Answer<Ts<T>> {
    let serializer = serde_wasm_bindgen::Serializer::new().serialize_maps_as_objects(true).serialize_missing_as_null(true);
    let js = value.serialize(&serializer).map_err(|e| argument("result", &e.to_string()))?;
    Ok(Ts::new_unchecked(js))
}

/// Throws an engine error.
fn throw(error: impl Into<Error>) -> JsValue {
    thrown(&error.into().report())
}

fn thrown(report: &ErrorReport) -> JsValue {
    object(report).map_or_else(|e| e, JsValue::from)
}

/// Throws for an argument of the wrong shape.
fn argument(field: &str, message: &str) -> JsValue {
    thrown(&ErrorReport::new("bad-argument", field, message, "see the types of the package"))
}

/// A validated scenario from what the page holds.
fn scenario(spec: &Ts<ScenarioSpec>, cells: &[u8]) -> Answer<Arc<Scenario>> {
    let spec = spec.to_rust().map_err(|e| argument("spec", &e.to_string()))?;
    let grid = Grid::from_bytes(spec.width, spec.height, cells).map_err(throw)?;
    Ok(Arc::new(Scenario::new(grid, spec).map_err(throw)?))
}

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
    /// A free cell near the upper left.
    #[tsify(type = "[number, number]")]
    pub start: Point,
    /// A free cell near the lower right, reachable from `start`.
    #[tsify(type = "[number, number]")]
    pub goal: Point,
}

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
    /// Everything.
    Scenario,
}

/// Version of the engine.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").into()
}

/// A fresh seed, 0..=2³²−1, from the operating system: the only place that asks it.
#[wasm_bindgen]
pub fn propose_seed() -> Answer<u32> {
    getrandom::u32().map_err(|e| argument("seed", &e.to_string()))
}

/// THE list of planners.
#[wasm_bindgen]
pub fn catalog() -> Answer<Ts<crate::catalog::Catalog>> {
    object(&crate::catalog::catalog())
}

/// Tells a file's format; contents decide, the name helps.
#[wasm_bindgen]
pub fn sniff(bytes: &[u8], name: &str) -> Answer<Ts<Kind>> {
    object(&formats::sniff(bytes, name))
}

/// Reads a map or scenario of any known format.
#[wasm_bindgen]
pub fn import_map(bytes: &[u8], name: &str) -> Answer<Ts<Imported>> {
    let formats::Imported { kind, grid, spec, notices } = formats::import(bytes, name).map_err(throw)?;
    object(&Imported { kind, spec, cells: grid.to_bytes(), warnings: notices })
}

/// Reads the lines of a MovingAI .scen file.
#[wasm_bindgen]
pub fn import_scen(bytes: &[u8]) -> Answer<Ts<ScenFile>> {
    object(&formats::import_scen(bytes).map_err(throw)?)
}

/// Writes a map or scenario. A .scen line carries the exact optimum of its format's rule (8 moves, no corner cut), computed here; it throws
/// when there is no path to write down.
#[wasm_bindgen]
pub fn export_map(spec: Ts<ScenarioSpec>, cells: &[u8], format: Ts<ExportFormat>) -> Answer<String> {
    let scenario = scenario(&spec, cells)?;
    let (grid, spec) = (&scenario.grid, &scenario.spec);
    let format = match format.to_rust().map_err(|e| argument("format", &e.to_string()))? {
        ExportFormat::MovingaiMap => Export::MovingaiMap,
        ExportFormat::MovingaiScen => Export::MovingaiScen { optimal: movingai_optimum(grid, spec)? },
        ExportFormat::Matrix => Export::Matrix,
        ExportFormat::Scenario => Export::Scenario,
    };
    Ok(formats::export(grid, spec, format))
}

fn movingai_optimum(grid: &Grid, spec: &ScenarioSpec) -> Answer<f64> {
    let spec = ScenarioSpec { movement: Movement::default(), ..spec.clone() };
    let scenario = Arc::new(Scenario::new(grid.clone(), spec).map_err(throw)?);
    crate::exact::optimum(&scenario).ok_or_else(|| {
        let message = "a .scen line needs a length, and no path leads from start to goal without cutting a corner";
        thrown(&ErrorReport::new("no-path", "goal", message, "open a way, or export the scenario as JSON"))
    })
}

/// Makes a seeded map; `density` (0..=0.9) counts for `random` only.
#[wasm_bindgen]
pub fn generate(kind: Ts<Generator>, width: u32, height: u32, seed: u32, density: f64) -> Answer<Ts<Generated>> {
    let kind = kind.to_rust().map_err(|e| argument("kind", &e.to_string()))?;
    let made = crate::map::generate(kind, width, height, seed, density).map_err(throw)?;
    object(&Generated { cells: made.grid.to_bytes(), start: made.start, goal: made.goal })
}

/// Throws when a scenario cannot be used; otherwise tells what is worth saying, e.g. that the goal cannot be reached.
#[wasm_bindgen]
pub fn check_scenario(spec: Ts<ScenarioSpec>, cells: &[u8]) -> Answer<Vec<Ts<Notice>>> {
    scenario(&spec, cells)?.notices().iter().map(object).collect()
}
