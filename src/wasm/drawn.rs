//! Paths that are drawn by hand.

use std::sync::Arc;

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::{self, Bytes, Heights, Number};
use super::{Answer, object, plain, scenario};
use crate::drawn::{self, Standing};
use crate::error::{DrawnError, Notice};
use crate::map::{Cell, Point};
use crate::metrics::Metrics;
use crate::planner::Objective;
use crate::scenario::{Scenario, ScenarioSpec};

/// A path as cells, in order.
#[derive(serde::Deserialize, Tsify)]
#[serde(transparent)]
pub struct Cells(#[tsify(type = "[number, number][]")] pub(super) Vec<Point>);

/// What a drawn path is worth.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Drawn {
    /// Whether it leads from the start by every goal.
    pub complete: bool,
    /// The goal that it has still to come by; null for a complete path, and for one that is none.
    #[tsify(type = "[number, number] | null")]
    pub missing: Option<Point>,
    /// Why it is no path on this map; null for one that is, as far as it goes.
    pub flaw: Option<Notice>,
    /// As planners' paths are measured, as far as it goes; null for one that is no path.
    pub metrics: Option<Metrics>,
    /// Its value by each objective that the path alone decides, once it is complete.
    pub values: Vec<DrawnValue>,
}

/// The value of a path by an objective.
#[derive(Serialize, Tsify)]
pub struct DrawnValue {
    /// By what it is measured.
    pub objective: Objective,
    /// In cells.
    pub value: f64,
}

/// A map to draw a path on.
#[wasm_bindgen]
pub struct HandPath {
    scenario: Arc<Scenario>,
}

#[wasm_bindgen]
impl HandPath {
    /// Throws where a scenario cannot be used, and by slices, where a path has levels that a pointer does not tell.
    #[wasm_bindgen(constructor)]
    pub fn new(spec: Ts<ScenarioSpec>, cells: &Bytes, heights: Option<Heights>, factors: Option<Heights>) -> Answer<HandPath> {
        let scenario = scenario(&spec, cells, [heights.as_ref(), factors.as_ref()])?;
        if scenario.by_slices().is_some() {
            return Err(plain(&DrawnError::Slices.report()));
        }
        Ok(Self { scenario })
    }

    /// The cells that lead straight on from one cell to another by allowed steps, x and y each, without the first.
    pub fn towards(&self, x: &Number, y: &Number, to_x: &Number, to_y: &Number) -> Answer<Vec<u32>> {
        let from = Point::new(x.whole("x")?, y.whole("y")?);
        let to = Point::new(to_x.whole("to_x")?, to_y.whole("to_y")?);
        let way = drawn::towards(&self.scenario, from, to).map_err(|error| plain(&error.report()))?;
        Ok(way.into_iter().flat_map(|at| [at.x, at.y]).collect())
    }

    /// Measures a path.
    pub fn measure(&self, path: Ts<Cells>) -> Answer<Ts<Drawn>> {
        let Cells(path) = arguments::value(&path, "path")?;
        let standing = drawn::standing(&self.scenario, &path);
        let measured = || {
            let cells: Vec<Cell> = path.iter().map(|&at| self.scenario.grid.cell(at)).collect();
            Metrics::of(&self.scenario, &cells)
        };
        let (missing, flaw) = match standing {
            Standing::Complete => (None, None),
            Standing::Unfinished(goal) => (Some(goal), None),
            Standing::Flawed(flaw) => (None, Some(Notice::new("drawn-flaw", flaw.to_string()))),
        };
        let metrics = flaw.is_none().then(measured);
        let complete = standing == Standing::Complete;
        let value = |objective: Objective| Some(DrawnValue { objective, value: objective.of_steps(metrics.as_ref()?)? });
        let values = if complete { Objective::ALL.into_iter().filter_map(value).collect() } else { Vec::new() };
        Ok(object(&Drawn { complete, missing, flaw, metrics, values }))
    }
}
