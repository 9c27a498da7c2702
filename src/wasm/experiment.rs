//! Many runs: an experiment's tasks for a pool of workers, and what its rows say.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::{Answer, argument, object, throw};
use crate::error::FormatError;
use crate::experiment::{self, Recorded, Row, Task, Timed, Verification, document, judge, report};

/// A run that is done.
#[derive(Serialize, Tsify)]
pub struct DoneRun {
    /// Its place among the tasks.
    pub index: u32,
    /// Its row as one line of JSON: what a journal keeps, and what `keep` takes.
    pub row: String,
    /// Seconds from its beginning to each improvement, and to its end.
    pub seconds: Vec<f64>,
    /// Whether it has found a path.
    pub found: bool,
}

/// The files of an experiment's results.
#[derive(Deserialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum ResultFile {
    /// One line a run.
    Csv,
    /// Tables and verdicts, as Markdown.
    Markdown,
    /// Rank tests of every pair, as Markdown.
    Tests,
    /// Question, maps and all runs: opens again.
    Json,
    /// Question, maps and digests of the runs, for a link.
    Link,
}

/// A question with its maps and the runs of it that are done.
#[wasm_bindgen]
pub struct Experiment {
    inner: experiment::Experiment,
    recorded: Option<Recorded>,
    tasks: Vec<Task>,
    done: BTreeMap<usize, Timed>,
}

#[wasm_bindgen]
impl Experiment {
    /// Opens a document (`formicarium/result@1`); the runs in it are kept.
    #[wasm_bindgen(constructor)]
    pub fn new(document: &str) -> Answer<Experiment> {
        let opened = document::open(document).map_err(throw)?;
        let tasks = opened.experiment.tasks();
        let place = |row: Row| Some((tasks.binary_search(&row.task).ok()?, Timed { row, seconds: Vec::new() }));
        let done = opened.rows.into_iter().filter_map(place).collect();
        Ok(Experiment { inner: opened.experiment, recorded: opened.recorded, tasks, done })
    }

    /// Number of runs that are to be done, the done ones among them.
    pub fn tasks(&self) -> usize {
        self.tasks.len()
    }

    /// The places of the tasks that are not done yet.
    pub fn open_tasks(&self) -> Vec<u32> {
        (0..self.tasks.len()).filter(|i| !self.done.contains_key(i)).map(|i| i as u32).collect()
    }

    /// The rows that are done, as lines of JSON in the order of the tasks.
    pub fn rows(&self) -> Vec<String> {
        self.done.values().map(|timed| line(&timed.row)).collect()
    }

    /// 16 hexadecimal digits over question and maps: experiments with equal digests have equal runs, under one version of the engine.
    pub fn digest(&self) -> String {
        self.inner.digest().hex()
    }

    /// Does one run to its end; `now` tells seconds. It is not kept.
    pub fn run(&self, index: usize, now: &js_sys::Function) -> Answer<Ts<DoneRun>> {
        let task = *self.tasks.get(index).ok_or_else(|| argument("index", "there is no such run"))?;
        let mut clock = || now.call0(&JsValue::NULL).ok().and_then(|t| t.as_f64()).unwrap_or(0.0);
        let Timed { row, seconds } = self.inner.run(task, &mut clock).map_err(throw)?;
        Ok(object(&DoneRun { index: index as u32, row: line(&row), found: row.found.is_some(), seconds }))
    }

    /// Takes in a run that is done, from any worker or from before; `seconds` as `run` tells them, empty where they are not known.
    pub fn keep(&mut self, row: &str, seconds: Vec<f64>) -> Answer<()> {
        let row: Row = serde_json::from_str(row).map_err(|e| throw(FormatError::syntax(1, e.to_string(), "a run's row")))?;
        let index = self.tasks.binary_search(&row.task).map_err(|_| argument("row", "the experiment has no such run"))?;
        self.done.insert(index, Timed { row, seconds });
        Ok(())
    }

    /// One of the result files; the same bytes as the command line writes. `command` is how Markdown says that it was made.
    pub fn file(&self, file: Ts<ResultFile>, command: &str) -> Answer<String> {
        let file = file.to_rust().map_err(|e| argument("file", &e.to_string()))?;
        let done = self.done_rows();
        let rows = self.inner.all_rows(&done);
        Ok(match file {
            ResultFile::Csv => report::csv(&self.inner, &rows),
            ResultFile::Markdown => report::markdown(&self.inner, &rows, &judge(&self.inner, &rows), command),
            ResultFile::Tests => report::tests(&self.inner, &rows),
            ResultFile::Json => document::write(&self.inner, &done, true),
            ResultFile::Link => document::write(&self.inner, &done, false),
        })
    }

    /// What was recorded when the document was written; null where nothing had been run.
    pub fn recorded(&self) -> Option<Ts<Recorded>> {
        self.recorded.as_ref().map(object)
    }

    /// How far the kept runs are those that were recorded; null where nothing was.
    pub fn verify(&self) -> Option<Ts<Verification>> {
        self.recorded.as_ref().map(|then| object(&document::verify(&self.inner, then, &self.done_rows())))
    }
}

impl Experiment {
    fn done_rows(&self) -> Vec<Row> {
        self.done.values().map(|timed| timed.row.clone()).collect()
    }
}

fn line(row: &Row) -> String {
    serde_json::to_string(row).unwrap_or_default()
}
