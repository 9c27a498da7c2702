//! Maps from and to files, and made-up ones. Left out of the core that a page loads first (feature `maps`).

use std::sync::Arc;

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::{Answer, argument, object, plain, scenario, throw};
use crate::error::{ErrorReport, Notice};
use crate::formats::{self, Export, Kind, ScenFile};
use crate::map::{Generator, Grid, Movement, Point};
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

/// Tells a file's format; contents decide, the name helps.
#[wasm_bindgen]
pub fn sniff(bytes: &[u8], name: &str) -> Ts<Kind> {
    object(&formats::sniff(bytes, name))
}

/// Reads a map or scenario of any known format.
#[wasm_bindgen]
pub fn import_map(bytes: &[u8], name: &str) -> Answer<Ts<Imported>> {
    let formats::Imported { kind, grid, spec, notices } = formats::import(bytes, name).map_err(throw)?;
    Ok(object(&Imported { kind, spec, cells: grid.to_bytes(), heights: height_bytes(&grid), warnings: notices }))
}

/// The heights of a terrain as little-endian f32; empty on a plane.
fn height_bytes(grid: &Grid) -> Vec<u8> {
    grid.heights().iter().flat_map(|heights| heights.iter().flat_map(|h| h.to_le_bytes())).collect()
}

/// Reads the lines of a MovingAI .scen file.
#[wasm_bindgen]
pub fn import_scen(bytes: &[u8]) -> Answer<Ts<ScenFile>> {
    Ok(object(&formats::import_scen(bytes).map_err(throw)?))
}

/// Writes a map or scenario. A .scen line carries the exact optimum of its format's rule (8 moves, no corner cut), computed here; it throws
/// when there is no path to write down.
#[wasm_bindgen]
pub fn export_map(spec: Ts<ScenarioSpec>, cells: &[u8], heights: Option<Vec<f32>>, format: Ts<ExportFormat>) -> Answer<String> {
    let scenario = scenario(&spec, cells, heights)?;
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
        plain(&ErrorReport::new("no-path", "goal", message, "open a way, or export the scenario as JSON"))
    })
}

/// Makes a seeded map; `density` (0..=0.9) counts for `random` only.
#[wasm_bindgen]
pub fn generate(kind: Ts<Generator>, width: u32, height: u32, seed: u32, density: f64) -> Answer<Ts<Generated>> {
    let kind = kind.to_rust().map_err(|e| argument("kind", &e.to_string()))?;
    let made = crate::map::generate(kind, width, height, seed, density).map_err(throw)?;
    Ok(object(&Generated { cells: made.grid.to_bytes(), start: made.start, goal: made.goal }))
}
