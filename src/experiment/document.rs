//! An experiment in one file: `formicarium/result@1`. The question, its maps and, as far as they are done, its runs; with them what is needed to
//! tell whether they come out again: the engine's version, every parameter's value, and a digest of each entry's runs on each map.
//!
//! Without its runs the same document is short enough for a link.

use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use serde_json::Value as Json;

use super::question::Question;
use super::row::Row;
use super::setting::Experiment;
use crate::catalog;
use crate::digest::Digest;
use crate::error::{Error, FormatError};
use crate::formats;
use crate::params::Values;
use crate::scenario::Scenario;

/// What `format` must say.
pub const FORMAT: &str = "formicarium/result@1";

/// As it stands in the file.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    format: String,
    question: Question,
    /// A scenario for each instance, as docs/schema/scenario@1.json says.
    maps: Vec<Json>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    recorded: Option<Recorded>,
    /// Runs from elsewhere: they are part of what is asked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    given: Vec<Row>,
    /// Runs that are done, in the order of the tasks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    rows: Vec<Row>,
}

/// What whoever ran it had, and what came out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Recorded {
    /// The engine's version.
    pub engine: String,
    /// Digest over question and maps, 16 hexadecimal digits.
    pub experiment: String,
    /// For each entry every parameter's value, also those that nobody has set; none where nothing is run.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "(Record<string, number | string | boolean> | null)[]"))]
    pub parameters: Vec<Option<Values>>,
    /// For each instance and entry how many runs were done, and the digest over them; none where there is none.
    pub runs: Vec<Vec<Option<Runs>>>,
}

/// Some runs, told apart from any other ones.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Runs {
    /// How many.
    pub count: u32,
    /// Over their rows, 16 hexadecimal digits.
    pub digest: String,
}

/// Where a result is not what was recorded, and what may be the cause.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Deviation {
    /// The engine is another version.
    Version {
        /// The one that was recorded.
        recorded: String,
        /// This one.
        now: String,
    },
    /// Question or maps were changed after the runs had been recorded.
    Experiment {
        /// Digest that was recorded.
        recorded: String,
        /// Digest now.
        now: String,
    },
    /// A parameter has another value: a default has changed, or the question.
    Parameter {
        /// Id of the entry.
        entry: String,
        /// Its key.
        key: String,
        /// The value that was recorded; none where there was no such parameter.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "number | string | boolean | null"))]
        recorded: Json,
        /// Its value now; none where there is no such parameter any more.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "number | string | boolean | null"))]
        now: Json,
    },
    /// Runs do not have the bits that were recorded.
    Bits {
        /// Id of the instance.
        instance: String,
        /// Id of the entry.
        entry: String,
        /// Digest that was recorded.
        recorded: String,
        /// Digest now.
        now: String,
    },
}

impl fmt::Display for Deviation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Version { recorded, now } => write!(f, "engine: recorded with version {recorded}, this is {now}"),
            Self::Experiment { recorded, now } => write!(f, "question or maps: {recorded} was recorded, this is {now}"),
            Self::Parameter { entry, key, recorded, now } => {
                write!(f, "parameter {entry}.{key}: recorded with {recorded}, now {now}")
            }
            Self::Bits { instance, entry, recorded, now } => {
                write!(f, "runs of {entry} on {instance}: digest {recorded} was recorded, now {now}")
            }
        }
    }
}

/// How far a result has been verified.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Verification {
    /// Pairs of instance and entry whose runs are all done again and are the same, bit for bit.
    pub same: u32,
    /// Pairs whose runs are not all done yet.
    pub open: u32,
    /// Every difference, possible causes first.
    pub deviations: Vec<Deviation>,
}

/// What a file holds.
#[derive(Debug)]
pub struct Opened {
    /// The question with its maps and the runs from elsewhere.
    pub experiment: Experiment,
    /// What was recorded, if anything had been run.
    pub recorded: Option<Recorded>,
    /// The recorded runs; of no other experiment.
    pub rows: Vec<Row>,
}

/// Reads an experiment.
///
/// # Errors
/// [`FormatError`] for another format or version and for broken JSON; [`super::QuestionError`] for a question that cannot be asked.
pub fn open(text: &str) -> Result<Opened, Error> {
    let document: Document = serde_json::from_str(text).map_err(|e| match formats::format_of(text) {
        Some(format) if format == FORMAT => FormatError::syntax(e.line(), e.to_string(), "the fields of docs/formats.md"),
        Some(format) => FormatError::Version { found: format.chars().take(60).collect(), expected: FORMAT },
        None => FormatError::syntax(e.line(), e.to_string(), format!(r#"an object with "format": "{FORMAT}""#)),
    })?;
    if document.format != FORMAT {
        return Err(FormatError::Version { found: document.format.chars().take(60).collect(), expected: FORMAT }.into());
    }
    let Document { question, maps, recorded, given, mut rows, .. } = document;
    if maps.len() != question.instances.len() {
        let what = format!("`maps` has {} maps where the question has {} instances", maps.len(), question.instances.len());
        return Err(FormatError::syntax(0, what, "one map for each instance").into());
    }
    let scenarios = maps.iter().map(scenario).collect::<Result<Vec<_>, _>>()?;
    let experiment = Experiment::new(question, scenarios)?.with_given(given)?;
    let tasks = experiment.tasks();
    rows.retain(|row| tasks.binary_search(&row.task).is_ok());
    rows.sort_by_key(|row| row.task);
    rows.dedup_by_key(|row| row.task);
    Ok(Opened { experiment, recorded, rows })
}

fn scenario(map: &Json) -> Result<Arc<Scenario>, Error> {
    let (grid, spec) = formats::read_scenario(&map.to_string())?;
    Ok(Arc::new(Scenario::new(grid, spec)?))
}

/// Writes an experiment with the runs that are done; `with_rows` false: their digests alone, for a link.
pub fn write(experiment: &Experiment, rows: &[Row], with_rows: bool) -> String {
    let maps = experiment.maps.iter().map(|m| formats::export(&m.scenario.grid, &m.scenario.spec, formats::Export::Scenario));
    let list = |items: Vec<String>| items.join(",\n");
    let mut out = format!("{{\"format\": \"{FORMAT}\",\n\"question\": {},\n", json(&experiment.question));
    out += &format!("\"maps\": [\n{}]", list(maps.map(|m| m.trim_end().to_owned()).collect()));
    if !rows.is_empty() {
        out += &format!(",\n\"recorded\": {}", json(&recorded(experiment, rows)));
    }
    for (name, rows) in [("given", &experiment.given[..]), ("rows", if with_rows { rows } else { &[] })] {
        if !rows.is_empty() {
            out += &format!(",\n\"{name}\": [\n{}]", list(rows.iter().map(json).collect()));
        }
    }
    out + "}\n"
}

/// On one line.
fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

/// What is written down of an experiment and its runs, so that others can tell whether theirs are the same.
pub fn recorded(experiment: &Experiment, rows: &[Row]) -> Recorded {
    let q = &experiment.question;
    let of_instance = |instance| (0..q.entries.len()).map(|entry| runs(rows, instance, entry)).collect();
    Recorded {
        engine: env!("CARGO_PKG_VERSION").into(),
        experiment: experiment.digest().hex(),
        parameters: parameters(q),
        runs: (0..q.instances.len()).map(of_instance).collect(),
    }
}

fn parameters(question: &Question) -> Vec<Option<Values>> {
    let of = |e: &super::Contender| {
        let planner = e.planner.as_deref()?;
        catalog::values(planner, e.preset.as_deref(), &e.set).ok()
    };
    question.entries.iter().map(of).collect()
}

fn runs(rows: &[Row], instance: usize, entry: usize) -> Option<Runs> {
    let mut digest = Digest::default();
    let mut count = 0;
    for row in rows.iter().filter(|row| (row.task.instance, row.task.entry) == (instance, entry)) {
        digest.bytes(&serde_json::to_vec(row).unwrap_or_default());
        count += 1;
    }
    (count > 0).then(|| Runs { count, digest: digest.hex() })
}

/// Compares what was recorded with what the same question gives here and now, as far as it has been run.
pub fn verify(experiment: &Experiment, then: &Recorded, rows: &[Row]) -> Verification {
    let now = recorded(experiment, rows);
    let mut deviations = Vec::new();
    if then.engine != now.engine {
        deviations.push(Deviation::Version { recorded: then.engine.clone(), now: now.engine.clone() });
    }
    if then.experiment != now.experiment {
        deviations.push(Deviation::Experiment { recorded: then.experiment.clone(), now: now.experiment.clone() });
    }
    let none = Values::new();
    for ((entry, then), now) in experiment.question.entries.iter().zip(&then.parameters).zip(&now.parameters) {
        changed(&entry.id, then.as_ref().unwrap_or(&none), now.as_ref().unwrap_or(&none), &mut deviations);
    }
    let (mut same, mut open) = (0, 0);
    for (instance, (then, now)) in then.runs.iter().zip(&now.runs).enumerate() {
        for (entry, (then, now)) in then.iter().zip(now).enumerate() {
            let Some(then) = then else { continue };
            match now {
                Some(now) if now == then => same += 1,
                Some(now) if now.count >= then.count => deviations.push(Deviation::Bits {
                    instance: experiment.question.instances[instance].id.clone(),
                    entry: experiment.question.entries[entry].id.clone(),
                    recorded: then.digest.clone(),
                    now: now.digest.clone(),
                }),
                _ => open += 1,
            }
        }
    }
    Verification { same, open, deviations }
}

fn changed(entry: &str, then: &Values, now: &Values, out: &mut Vec<Deviation>) {
    let keys: BTreeSet<&String> = then.keys().chain(now.keys()).collect();
    for key in keys.into_iter().filter(|key| then.get(*key) != now.get(*key)) {
        let [recorded, now] = [then, now].map(|values| values.get(key).map_or(Json::Null, |v| serde_json::json!(v)));
        out.push(Deviation::Parameter { entry: entry.into(), key: key.clone(), recorded, now });
    }
}

#[cfg(test)]
mod tests {
    use super::super::question::{Axis, Budget};
    use super::*;
    use crate::map::{Grid, Point};
    use crate::scenario::ScenarioSpec;
    use serde_json::json;

    fn experiment(budget: Option<Budget>) -> Experiment {
        let question: Question = serde_json::from_value(json!({
            "format": super::super::question::FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 2 },
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
        Experiment::new(Question { budget, ..question }, vec![scenario]).unwrap()
    }

    fn run_all(experiment: &Experiment) -> Vec<Row> {
        experiment.tasks().into_iter().map(|task| experiment.run(task, &mut || 0.0).unwrap().row).collect()
    }

    #[test]
    fn a_document_is_itself_again_and_verifies() {
        let first = experiment(None);
        let rows = run_all(&first);
        let text = write(&first, &rows, true);
        let again = open(&text).unwrap();
        assert_eq!(again.rows, rows);
        assert_eq!(again.experiment.digest().hex(), first.digest().hex());
        assert_eq!(write(&again.experiment, &again.rows, true), text);
        let then = again.recorded.unwrap();
        assert_eq!(then.parameters[0].as_ref().unwrap().get("ants"), Some(&crate::params::Value::from(4.0)));
        let verified = verify(&again.experiment, &then, &run_all(&again.experiment));
        assert_eq!(verified, Verification { same: 2, open: 0, deviations: vec![] });
        // A link has the digests alone, and one run of two leaves its entry open.
        let link = open(&write(&first, &rows, false)).unwrap();
        assert!(link.rows.is_empty() && link.recorded.as_ref() == Some(&then));
        assert_eq!(verify(&again.experiment, &then, &rows[1..]), Verification { same: 1, open: 1, deviations: vec![] });
    }

    #[test]
    fn every_difference_is_told_with_what_may_be_its_cause() {
        let now = experiment(None);
        let rows = run_all(&now);
        let mut then = recorded(&now, &rows);
        then.engine = "0.0.1".into();
        then.parameters[0].as_mut().unwrap().insert("ants".into(), crate::params::Value::from(7.0));
        then.runs[0][0] = Some(Runs { count: 2, digest: "00".into() });
        let told: Vec<String> = verify(&now, &then, &rows).deviations.iter().map(ToString::to_string).collect();
        assert_eq!(told.len(), 3, "{told:?}");
        assert_eq!(told[0], format!("engine: recorded with version 0.0.1, this is {}", env!("CARGO_PKG_VERSION")));
        assert_eq!(told[1], "parameter ants.ants: recorded with 7.0, now 4.0");
        assert!(told[2].starts_with("runs of ants on open: digest 00 was recorded, now "));
    }

    #[test]
    fn a_budget_ends_runs_and_counts_no_more_than_it_allows() {
        let rows = run_all(&experiment(Some(Budget { axis: Axis::ConstructedPaths, amount: 9 })));
        // Four ants an iteration: two iterations end within nine paths, the third one does not count.
        let ants = &rows[0];
        assert_eq!(ants.effort.constructed_paths, Some(12));
        assert!(ants.trace.iter().all(|i| i.spent.constructed_paths.unwrap() <= 8));
        assert_eq!(ants.found.unwrap().value, ants.trace.last().unwrap().value);
        // A search that is not done within its budget has found nothing.
        let rows = run_all(&experiment(Some(Budget { axis: Axis::CellExpansions, amount: 2 })));
        assert_eq!(rows[2].found, None);
        assert!(rows[0].found.is_some());
    }

    #[test]
    fn what_cannot_be_opened_is_refused_by_name() {
        let text = write(&experiment(None), &[], true);
        let refused = |text: &str| open(text).unwrap_err().report();
        assert_eq!(refused(&text.replace("result@1", "result@9")).kind, "version");
        assert!(refused(&text.replace("\"maps\"", "\"mops\"")).message.contains("mops"));
        assert!(refused(&text.replace("ant-system", "bee-system")).field.starts_with("entries.ants"));
        assert!(refused("{").message.contains("EOF"));
    }
}
