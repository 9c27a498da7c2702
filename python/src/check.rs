//! Is this a path?

use formicarium::findings::{Findings, SliceFindings};
use formicarium::map::Point;
use formicarium::path::PathKind;
use formicarium::scenario::Scenario;
use pyo3::prelude::*;

use super::errors::Refusal;
use super::map::{Map, json};

/// Audits a path: `formicarium/check@1`, as `check --format json` prints it. `levels` for a map by slices alone.
#[pyfunction]
pub fn check(py: Python<'_>, map: &Map, path: Vec<(u32, u32)>, levels: Option<Vec<u32>>, polyline: bool) -> PyResult<String> {
    let Scenario { drawn, spec, .. } = &*map.scenario;
    let points = path.iter().map(|&(x, y)| Point::new(x, y));
    match (map.scenario.by_slices(), levels) {
        (Some(_), Some(levels)) => {
            let places: Vec<(Point, u32)> = points.zip(levels).collect();
            Ok(py.detach(|| json(&SliceFindings::of(&map.scenario, &places))))
        }
        (None, None) => {
            let points: Vec<Point> = points.collect();
            let kind = if polyline { PathKind::Polyline } else { PathKind::Steps };
            Ok(py.detach(|| json(&Findings::of(drawn, spec, map.has_ends, &points, kind))))
        }
        (Some(_), None) => {
            let hint = "give column, row and level of each place";
            Err(Refusal::argument("path", "the path has no levels, and the map is one by slices", hint).into())
        }
        (None, Some(_)) => {
            let hint = "leave the levels out";
            Err(Refusal::argument("path", "the path has levels, and here one moves on the ground", hint).into())
        }
    }
}
