//! Results from elsewhere: looked at, and joined to a comparison's document.

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::{self, Bytes, Text};
use super::{Answer, object, throw};
use crate::comparison::imported::{self, Matched};
use crate::error::Notice;
use crate::formats::{comparison_json, import_results, results_table};

/// What of a file of results belongs where, before it is joined.
#[derive(Serialize, Tsify)]
pub struct ResultsMatch {
    /// Whose runs they are, and on which maps.
    pub matched: Matched,
    /// What was assumed or left out on reading.
    pub warnings: Vec<Notice>,
}

/// Names of maps in a file of results.
#[derive(serde::Deserialize, Tsify)]
#[serde(transparent)]
pub struct MapNames(#[tsify(type = "string[]")] Vec<String>);

/// Looks at a file of results (a table, or a data file of IOHanalyzer or COCO) beside a document (`formicarium/comparison@1`) without joining
/// it.
#[wasm_bindgen]
pub fn match_results(document: &Text, bytes: &Bytes, name: &Text) -> Answer<Ts<ResultsMatch>> {
    let opened = comparison_json::open(&document.read("document")?).map_err(throw)?;
    let results = import_results(&bytes.read("bytes")?, &name.read("name")?).map_err(throw)?;
    let matched = imported::matched(&opened.comparison, &results);
    Ok(object(&ResultsMatch { matched, warnings: results.notices }))
}

/// A table for results from elsewhere: its columns, and a line for each map and seed of a document, to be filled in.
#[wasm_bindgen]
pub fn results_template(document: &Text) -> Answer<String> {
    let opened = comparison_json::open(&document.read("document")?).map_err(throw)?;
    Ok(results_table(&opened.comparison.question))
}

/// Adds the entries of a file of results to a document (`formicarium/comparison@1`) and gives the new document, with the runs that it had.
/// `instance` is the id of the map for runs that name none, and for a file that names a single other one; it may be left out where the question
/// has one map. Runs on the maps that `leave_out` names, as they stand in the file, are left out.
#[wasm_bindgen]
pub fn join_results(
    document: &Text,
    bytes: &Bytes,
    name: &Text,
    instance: Option<Text>,
    leave_out: Option<Ts<MapNames>>,
) -> Answer<String> {
    let opened = comparison_json::open(&document.read("document")?).map_err(throw)?;
    let mut results = import_results(&bytes.read("bytes")?, &name.read("name")?).map_err(throw)?;
    let instance = instance.map(|id| id.read("instance")).transpose()?;
    let place = instance.map(|id| opened.comparison.question.place(&id)).transpose().map_err(throw)?;
    if let Some(names) = leave_out {
        let MapNames(names) = arguments::value(&names, "leave_out")?;
        results.leave_out(&names);
    }
    let comparison = imported::join(opened.comparison, &results, place).map_err(throw)?;
    Ok(comparison_json::write(&comparison, &opened.rows, true))
}
