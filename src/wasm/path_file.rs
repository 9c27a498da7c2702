//! Paths as files of other programs.

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::{self, Bytes, Heights};
use super::drawn::Cells;
use super::{Answer, object, scenario, throw};
use crate::error::{Error, ErrorReport, Notice};
use crate::formats::{PathFormat, PlannedPath, read_steps_on};
use crate::map::Point;
use crate::planner::Objective;
use crate::scenario::ScenarioSpec;

/// A format of paths, and whether a map can give it.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct PathFormatFacts {
    /// What `write_path` takes.
    pub format: PathFormat,
    /// How the names of its files end, with the first point.
    pub ending: String,
    /// What a browser calls its files.
    pub media_type: String,
    /// Why paths of this map cannot be written so; null where they can.
    #[tsify(type = "EngineError | null")]
    pub refusal: Option<ErrorReport>,
}

/// A path as a file.
#[derive(Serialize, Tsify)]
pub struct PathText {
    /// What it holds.
    pub text: String,
    /// What was assumed.
    pub warnings: Vec<Notice>,
}

/// A path that a file holds.
#[derive(Serialize, Tsify)]
pub struct PathSteps {
    /// Its cells, from neighbour to neighbour.
    #[tsify(type = "[number, number][]")]
    pub path: Vec<Point>,
    /// What was assumed.
    pub warnings: Vec<Notice>,
}

/// Reads a path of this map, to be measured as one by hand; see [`read_steps_on`]. Throws for what is none, and for places beside the map.
#[wasm_bindgen]
pub fn read_path(spec: Ts<ScenarioSpec>, file: &Bytes) -> Answer<Ts<PathSteps>> {
    let spec: ScenarioSpec = arguments::value(&spec, "spec")?;
    let (path, warnings) = read_steps_on(&file.read("file")?, &spec).map_err(throw)?;
    Ok(object(&PathSteps { path, warnings }))
}

/// Every format of paths, with why this map cannot give it.
#[wasm_bindgen]
pub fn path_formats(spec: Ts<ScenarioSpec>) -> Answer<Vec<Ts<PathFormatFacts>>> {
    let spec: ScenarioSpec = arguments::value(&spec, "spec")?;
    let facts = |format: PathFormat| PathFormatFacts {
        format,
        ending: format.ending().into(),
        media_type: format.media_type().into(),
        refusal: format.check(&spec).err().map(|error| error.report()),
    };
    Ok(PathFormat::ALL.into_iter().map(|format| object(&facts(format))).collect())
}

/// Writes a path with its altitudes as `Run.best_path` and `Run.best_altitudes` give them; `objective` tells whether it is a polyline. Throws
/// for what is no path on this map.
#[wasm_bindgen]
#[allow(clippy::too_many_arguments, reason = "a map crosses as its parts")]
pub fn write_path(
    spec: Ts<ScenarioSpec>,
    cells: &Bytes,
    heights: Option<Heights>,
    factors: Option<Heights>,
    path: Ts<Cells>,
    altitudes: Option<Heights>,
    objective: Ts<Objective>,
    format: Ts<PathFormat>,
) -> Answer<Ts<PathText>> {
    let scenario = scenario(&spec, cells, [heights.as_ref(), factors.as_ref()])?;
    let Cells(path) = arguments::value(&path, "path")?;
    let altitudes = altitudes.map_or_else(|| Ok(Vec::new()), |altitudes| altitudes.read("altitudes"))?;
    let objective: Objective = arguments::word(&objective.js_value(), "objective")?;
    let format: PathFormat = arguments::word(&format.js_value(), "format")?;
    let planned = PlannedPath::of_points(&scenario, &path, &altitudes, objective.path_kind());
    let file = planned.and_then(|path| format.write(&path)).map_err(|error| throw(Error::from(error)))?;
    Ok(object(&PathText { text: file.text, warnings: file.notices }))
}
