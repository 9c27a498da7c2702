//! A comparison in one file: `formicarium/comparison@1`. It holds the question, its maps and, as far as they are done, its runs; with them what
//! is needed to tell whether they come out again: the engine's version, every parameter's value, and a digest of each entry's runs on each map.
//!
//! Without its runs the same document is short enough for a link.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use serde_json::Value as Json;

use super::scenario_json;
use crate::comparison::{Comparison, Question, Record, Recorded, Row, json};
use crate::error::{Error, FormatError};
use crate::scenario::Scenario;

/// What `format` must say.
pub const FORMAT: &str = "formicarium/comparison@1";

/// What the result of a single run says, which is often at hand in its place.
const ONE_RUN: &str = "formicarium/result@";

/// A comparison as it stands in a file.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ComparisonDocument {
    /// [`FORMAT`].
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"formicarium/comparison@1\""))]
    format: String,
    /// What is asked.
    question: Question,
    /// A scenario for each instance, as docs/schema/scenario.schema.json says.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, unknown>[]"))]
    maps: Vec<Json>,
    /// What was recorded of the runs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    recorded: Option<Recorded>,
    /// Runs from elsewhere: they are part of what is asked. Their name in files is older than ours.
    #[serde(rename = "given", default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "unknown[]"))]
    imported: Vec<Row>,
    /// Runs that are done, in the order of the tasks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "unknown[]"))]
    rows: Vec<Row>,
}

/// What a file holds.
#[derive(Debug)]
pub struct Opened {
    /// The question with its maps and the imported runs.
    pub comparison: Comparison,
    /// What was recorded, if anything had been run.
    pub recorded: Option<Recorded>,
    /// The runs that are done, in the order of the tasks; those that the question does not ask for are left out.
    pub rows: Vec<Row>,
}

impl Opened {
    /// What runs that are done here are compared with. Take it before the question is narrowed.
    pub fn record(&self) -> Record {
        Record::new(&self.comparison, self.recorded.clone())
    }
}

/// Reads a comparison.
///
/// # Errors
/// [`FormatError`] for another format or version and for broken JSON; [`crate::error::QuestionError`] for a question that cannot be asked.
pub fn open(text: &str) -> Result<Opened, Error> {
    let ComparisonDocument { format, question, maps, recorded, imported, mut rows } = parse(text)?;
    if format != FORMAT {
        return Err(other_version(&format).into());
    }
    if maps.len() != question.instances.len() {
        let what = format!("`maps` has {} maps where the question has {} instances", maps.len(), question.instances.len());
        return Err(FormatError::syntax(0, what, "one map for each instance").into());
    }
    let scenarios = maps.iter().map(scenario).collect::<Result<Vec<_>, _>>()?;
    let comparison = Comparison::new(question, scenarios)?.with_imported(imported)?;
    rows.retain(|row| comparison.has_task(row.task));
    rows.sort_by_key(|row| row.task);
    rows.dedup_by_key(|row| row.task);
    Ok(Opened { comparison, recorded, rows })
}

/// Reads the fields; where that fails, says what the text is instead.
fn parse(text: &str) -> Result<ComparisonDocument, FormatError> {
    serde_json::from_str(text).map_err(|e| match scenario_json::format_of(text) {
        Some(format) if format.starts_with(ONE_RUN) => FormatError::syntax(
            0,
            "this is the result of a single run, as `plan --format json` prints it",
            "a comparison as `compare` or the page writes it",
        ),
        Some(format) if format == FORMAT => FormatError::syntax(e.line(), e.to_string(), "the fields of docs/formats.md"),
        Some(format) => other_version(&format),
        None => FormatError::syntax(e.line(), e.to_string(), format!(r#"an object with "format": "{FORMAT}""#)),
    })
}

fn other_version(format: &str) -> FormatError {
    FormatError::Version { found: format.chars().take(60).collect(), expected: FORMAT }
}

fn scenario(map: &Json) -> Result<Arc<Scenario>, Error> {
    let (grid, spec) = scenario_json::read(&map.to_string())?;
    Ok(Arc::new(Scenario::new(grid, spec)?))
}

/// Writes a comparison with the runs that are done; `with_rows` false: their digests alone, for a link.
pub fn write(comparison: &Comparison, rows: &[Row], with_rows: bool) -> String {
    let recorded = (!rows.is_empty()).then(|| Recorded::of(comparison, rows));
    write_as(comparison, rows, with_rows, recorded.as_ref())
}

/// The same, with what is to be told of the runs: another engine may have done them, on another machine.
pub fn write_as(comparison: &Comparison, rows: &[Row], with_rows: bool, recorded: Option<&Recorded>) -> String {
    let maps = comparison.maps.iter().map(|m| scenario_json::write(&m.scenario.drawn, &m.scenario.spec));
    let list = |items: Vec<String>| items.join(",\n");
    let mut out = format!("{{\"format\": \"{FORMAT}\",\n\"question\": {},\n", json(&comparison.question));
    out += &format!("\"maps\": [\n{}]", list(maps.map(|m| m.trim_end().to_owned()).collect()));
    if let Some(recorded) = recorded {
        out += &format!(",\n\"recorded\": {}", json(recorded));
    }
    for (name, rows) in [("given", &comparison.imported[..]), ("rows", if with_rows { rows } else { &[] })] {
        if !rows.is_empty() {
            out += &format!(",\n\"{name}\": [\n{}]", list(rows.iter().map(json).collect()));
        }
    }
    out + "}\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::comparison::{Axis, Budget, question};
    use crate::map::{Grid, Point};
    use crate::scenario::ScenarioSpec;
    use serde_json::json;

    fn comparison(budget: Option<Budget>) -> Comparison {
        let question: Question = serde_json::from_value(json!({
            "format": question::FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 2 },
            "instances": [{ "id": "open", "map": "open.json" }],
            "entries": [
                { "id": "ants", "label": "ants", "role": "other", "planner": "ant-system", "set": { "iterations": 5, "ants": 4 } },
                { "id": "exact", "label": "exact", "role": "other", "planner": "astar" }
            ]
        }))
        .unwrap();
        let grid = Grid::from_bytes(6, 5, &[0; 30]).unwrap();
        let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(5, 4));
        let scenario = Arc::new(Scenario::new(grid, spec).unwrap());
        Comparison::new(Question { budget, ..question }, vec![scenario]).unwrap()
    }

    fn run_all(comparison: &Comparison) -> Vec<Row> {
        comparison.tasks().into_iter().map(|task| comparison.run(task, &mut || 0.0).unwrap().row).collect()
    }

    #[test]
    fn a_document_is_itself_again_and_verifies() {
        let first = comparison(None);
        let rows = run_all(&first);
        let text = write(&first, &rows, true);
        let again = open(&text).unwrap();
        assert_eq!(again.rows, rows);
        assert_eq!(again.comparison.digest().hex(), first.digest().hex());
        assert_eq!(write(&again.comparison, &again.rows, true), text);
        let then = again.recorded.as_ref().unwrap();
        assert_eq!(then.parameters[0].as_ref().unwrap().get("ants"), Some(&crate::params::Value::from(4.0)));
        // A link has the digests alone.
        let link = open(&write(&first, &rows, false)).unwrap();
        assert!(link.rows.is_empty() && link.recorded.as_ref() == Some(then));
    }

    #[test]
    fn a_budget_ends_runs_and_counts_no_more_than_it_allows() {
        let rows = run_all(&comparison(Some(Budget { axis: Axis::ConstructedPaths, amount: 9 })));
        // Four ants an iteration: two iterations end within nine paths, the third one does not count.
        let ants = &rows[0];
        assert_eq!(ants.effort.constructed_paths, Some(12));
        assert!(ants.trace.iter().all(|i| i.spent.constructed_paths.unwrap() <= 8));
        assert_eq!(ants.found.unwrap().value, ants.trace.last().unwrap().value);
        // A search that is not done within its budget has found nothing.
        let rows = run_all(&comparison(Some(Budget { axis: Axis::CellExpansions, amount: 2 })));
        assert_eq!(rows[2].found, None);
        assert!(rows[0].found.is_some());
    }

    #[test]
    fn what_cannot_be_opened_is_refused_by_name() {
        let text = write(&comparison(None), &[], true);
        let refused = |text: &str| open(text).unwrap_err().report();
        assert_eq!(refused(&text.replace("comparison@1", "comparison@9")).kind, "version");
        assert!(refused(&text.replace("\"maps\"", "\"mops\"")).message.contains("mops"));
        assert!(refused(&text.replace("ant-system", "bee-system")).field.starts_with("entries.ants"));
        assert!(refused("{").message.contains("EOF"));
    }
}
