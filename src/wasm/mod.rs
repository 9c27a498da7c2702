//! The whole browser boundary: types and functions as `pkg/formicarium.d.ts` shows them.
//!
//! Nothing is decided here. Every function throws an `EngineError` object (see [`crate::error::ErrorReport`]) for what it cannot use; nothing
//! panics on what a script may send (see [`arguments`]).

#[cfg(feature = "whole")]
mod ahead;
mod arguments;
#[cfg(feature = "whole")]
mod campaign;
#[cfg(feature = "whole")]
mod certificate;
#[cfg(feature = "whole")]
mod changes;
mod colours;
#[cfg(feature = "whole")]
mod comparison;
#[cfg(feature = "whole")]
mod drawn;
#[cfg(feature = "whole")]
mod drive;
#[cfg(feature = "whole")]
mod figure;
#[cfg(feature = "whole")]
mod ground;
#[cfg(feature = "whole")]
mod maps;
#[cfg(feature = "whole")]
mod order;
mod paint;
#[cfg(feature = "whole")]
mod path_file;
mod playback;
#[cfg(feature = "whole")]
mod results;
mod run;
#[cfg(feature = "whole")]
mod smoothed;

use std::sync::Arc;

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use self::arguments::{Bytes, Heights};
use crate::error::{Error, Notice};
use crate::exact::Reference;
use crate::map::Grid;
use crate::planner::Objective;
use crate::scenario::{Scenario, ScenarioSpec};

#[cfg(feature = "whole")]
pub use ahead::LookAhead;
#[cfg(feature = "whole")]
pub use campaign::{journal_digest, most_shards};
#[cfg(feature = "whole")]
pub use colours::{map_colors, weight_colors};
#[cfg(feature = "whole")]
pub use comparison::{Comparison, ablation, formats};
#[cfg(feature = "whole")]
pub use drawn::HandPath;
#[cfg(feature = "whole")]
pub use drive::{DriveRun, drive_params};
#[cfg(feature = "whole")]
pub use figure::{figure_map, find_figure, read_figure, show_picture};
#[cfg(feature = "whole")]
pub use ground::ContourLines;
#[cfg(feature = "whole")]
pub use maps::{
    export_geotiff, export_map, export_ros, felt_map, fitting_slices, generate, import_map, import_scen, import_terrain,
    list_matrices, recognise, ros_image, survey_terrain, unpack,
};
#[cfg(feature = "whole")]
pub use order::{OrderRun, read_order};
#[cfg(feature = "whole")]
pub use path_file::{path_formats, read_path, write_path};
#[cfg(feature = "whole")]
pub use results::{join_results, match_results, results_template};
pub use run::{Run, paint_map};

/// No signature mentions what is thrown, so its type is written out here.
#[wasm_bindgen(typescript_custom_section)]
const ENGINE_ERROR: &str = r#"
/** Thrown by every function that can fail. */
export interface EngineError {
  /** Stable key of the message, e.g. `out-of-range`. */
  kind: string
  /** The field at fault, e.g. `rho`, `start`, `line 12`. */
  field: string
  /** The sentence in English. */
  message: string
  /** What to do next, in English. */
  hint: string
  /** Values for a translated message. */
  args: Record<string, string>
}
"#;

/// What a fallible function returns; the error is an `EngineError` object.
type Answer<T> = Result<T, JsValue>;

/// A value as a plain JS object: maps become objects, `None` becomes null, bytes become a Uint8Array.
fn plain(value: &impl Serialize) -> JsValue {
    let serializer = serde_wasm_bindgen::Serializer::new().serialize_maps_as_objects(true).serialize_missing_as_null(true);
    value.serialize(&serializer).unwrap_or_else(JsValue::from)
}

/// The same with its type.
fn object<T: Serialize + Tsify>(value: &T) -> Ts<T> {
    Ts::new_unchecked(plain(value))
}

/// Throws an engine error.
fn throw(error: impl Into<Error>) -> JsValue {
    plain(&error.into().report())
}

/// The map from what the page holds: one byte a cell, on a terrain one height, on weighted ground one factor.
fn grid(width: u32, height: u32, cells: &Bytes, [heights, factors]: [Option<&Heights>; 2]) -> Answer<Grid> {
    let grid = Grid::from_bytes(width, height, &cells.read("cells")?).map_err(throw)?;
    let grid = match heights {
        Some(heights) => grid.with_heights(heights.read("heights")?).map_err(throw)?,
        None => grid,
    };
    match factors {
        #[cfg(feature = "whole")]
        Some(factors) => grid.with_factors(factors.read("factors")?).map_err(throw),
        _ => Ok(grid),
    }
}

/// A validated scenario from what the page holds.
fn scenario(spec: &Ts<ScenarioSpec>, cells: &Bytes, numbers: [Option<&Heights>; 2]) -> Answer<Arc<Scenario>> {
    let spec = arguments::value(spec, "spec")?;
    let grid = grid(spec.width, spec.height, cells, numbers)?;
    Ok(Arc::new(Scenario::new(grid, spec).map_err(throw)?))
}

/// Version of the engine.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").into()
}

/// A fresh seed, 0..=2³²−1, from the operating system: the only place that asks it.
#[wasm_bindgen]
pub fn propose_seed() -> Answer<u32> {
    getrandom::u32().map_err(|e| arguments::argument("seed", &e.to_string()))
}

/// THE list of planners.
#[wasm_bindgen]
pub fn catalog() -> Ts<crate::catalog::Catalog> {
    object(&crate::catalog::catalog())
}

/// Throws when a scenario cannot be used; otherwise tells what is worth saying, e.g. that the goal cannot be reached.
#[wasm_bindgen]
pub fn check_scenario(
    spec: Ts<ScenarioSpec>,
    cells: &Bytes,
    heights: Option<Heights>,
    factors: Option<Heights>,
) -> Answer<Vec<Ts<Notice>>> {
    Ok(scenario(&spec, cells, [heights.as_ref(), factors.as_ref()])?.notices().iter().map(object).collect())
}

/// The yardstick of an objective on a scenario: what results are compared with. The core of the engine knows that of `length` alone; to it
/// the others are `unknown`.
#[wasm_bindgen]
pub fn reference(
    spec: Ts<ScenarioSpec>,
    cells: &Bytes,
    heights: Option<Heights>,
    factors: Option<Heights>,
    objective: Ts<Objective>,
) -> Answer<Ts<Reference>> {
    let objective = arguments::word(&objective.js_value(), "objective")?;
    Ok(object(&yardstick(&scenario(&spec, cells, [heights.as_ref(), factors.as_ref()])?, objective)))
}

#[cfg(feature = "whole")]
use crate::exact::reference as yardstick;

/// Without the searches behind the other objectives: no planner of this build is measured by them.
#[cfg(not(feature = "whole"))]
fn yardstick(scenario: &Arc<Scenario>, objective: Objective) -> Reference {
    match objective {
        Objective::Length => crate::exact::optimum(scenario).map_or(Reference::NoPath, |value| Reference::Proven { value }),
        _ => Reference::Unknown,
    }
}
