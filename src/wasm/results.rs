//! Results from elsewhere: looked at, and joined to a comparison's document.

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::{Bytes, Text};
use super::{Answer, object, throw};
use crate::comparison::imported::{self, ImportedEntry};
use crate::error::Notice;
use crate::formats::{comparison_json, import_results};

/// What a file of results holds.
#[derive(Serialize, Tsify)]
pub struct ResultsSurvey {
    /// Whose runs they are.
    pub entries: Vec<SurveyedEntry>,
    /// The names of maps that stand in the file; empty where it names none.
    pub instances: Vec<String>,
    /// What was assumed or left out.
    pub warnings: Vec<Notice>,
}

/// The runs of one entry of a file.
#[derive(Serialize, Tsify)]
pub struct SurveyedEntry {
    /// Its name in the file.
    pub label: String,
    /// Its runs.
    pub runs: u32,
    /// Those that found a path.
    pub with_path: u32,
}

/// Looks at a file of results (a table, or a data file of IOHanalyzer) without joining it.
#[wasm_bindgen]
pub fn survey_results(bytes: &Bytes, name: &Text) -> Answer<Ts<ResultsSurvey>> {
    let results = import_results(&bytes.read("bytes")?, &name.read("name")?).map_err(throw)?;
    let entry = |e: &ImportedEntry| SurveyedEntry {
        label: e.label.clone(),
        runs: e.runs.len() as u32,
        with_path: e.runs.iter().filter(|run| !run.steps.is_empty()).count() as u32,
    };
    let entries = results.entries.iter().map(entry).collect();
    Ok(object(&ResultsSurvey { entries, instances: results.instances, warnings: results.notices }))
}

/// Adds the entries of a file of results to a document (`formicarium/comparison@1`) and gives the new document, with the runs that it had.
/// `instance` is the id of the map for runs that name none, and for a file that names a single other one; it may be left out where the question
/// has one map.
#[wasm_bindgen]
pub fn join_results(document: &Text, bytes: &Bytes, name: &Text, instance: Option<Text>) -> Answer<String> {
    let opened = comparison_json::open(&document.read("document")?).map_err(throw)?;
    let results = import_results(&bytes.read("bytes")?, &name.read("name")?).map_err(throw)?;
    let instance = instance.map(|id| id.read("instance")).transpose()?;
    let place = instance.map(|id| opened.comparison.question.place(&id)).transpose().map_err(throw)?;
    let comparison = imported::join(opened.comparison, &results, place).map_err(throw)?;
    Ok(comparison_json::write(&comparison, &opened.rows, true))
}
