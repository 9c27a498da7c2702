//! One planner on one map.

use std::num::NonZero;
use std::thread;

use formicarium::catalog;
use formicarium::formats::run_result::RunResult;
use formicarium::params::{Value, Values};
use formicarium::planner::Granularity;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use super::errors::Refusal;
use super::map::{Map, json};
use super::patience;

/// Runs a planner to its end: `formicarium/result@1`, as `plan --format json` prints it. `threads`: 0 for all cores.
#[pyfunction]
#[pyo3(signature = (map, planner, seed, preset, params, threads))]
pub fn plan(
    py: Python<'_>,
    map: &Map,
    planner: &str,
    seed: u32,
    preset: Option<&str>,
    params: &Bound<'_, PyDict>,
    threads: usize,
) -> PyResult<String> {
    let (values, scenario) = (values(params)?, &map.scenario);
    let entry = catalog::find(planner).map_err(Refusal::from)?;
    let built = py.detach(|| catalog::build(scenario, entry.id, preset, &values, seed));
    let mut planner = built.map_err(Refusal::from)?;
    if threads != 1 {
        // Whether it can: its results are the same anyway.
        let _ = planner.walk_on(cores(threads));
    }
    patience::work(py, || planner.advance(Granularity::Iteration).is_finished())?;
    Ok(py.detach(move || json(&RunResult::of(entry.id, seed, scenario, planner.as_ref()))))
}

/// So many, or one for each core.
pub fn cores(asked: usize) -> NonZero<usize> {
    NonZero::new(asked).or_else(|| thread::available_parallelism().ok()).unwrap_or(NonZero::<usize>::MIN)
}

/// Parameters by key: numbers, flags, ids of choices.
fn values(params: &Bound<'_, PyDict>) -> PyResult<Values> {
    params.iter().map(|(key, value)| Ok((key.extract::<String>()?, self::value(&key, &value)?))).collect()
}

fn value(key: &Bound<'_, PyAny>, value: &Bound<'_, PyAny>) -> PyResult<Value> {
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(Value::from(text.to_cow()?.as_ref()));
    }
    if let Ok(flag) = value.extract::<bool>() {
        return Ok(Value::from(flag));
    }
    value.extract::<f64>().map(Value::from).map_err(|_| {
        let message = format!("params[{key:?}] = {value:?} cannot be used");
        Refusal::argument("params", message, "give a number, a flag, or the id of a choice").into()
    })
}
