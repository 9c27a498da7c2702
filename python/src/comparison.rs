//! Questions, run and judged.

use std::ffi::OsString;
use std::sync::Arc;

use formicarium::cli::shared::{self, heard};
use formicarium::comparison::report::{ReportLanguage, Reports, ResultFile, TRACE_HEADER, trace_lines};
use formicarium::comparison::{self, Budget, FrontQuestion, Intervals, Question, Row, Samples, Seen, analysis};
use formicarium::formats::comparison_json;
use pyo3::prelude::*;

use super::errors::{Refusal, said};
use super::map::{Map, json};
use super::plan::cores;
use super::pool;

/// A question with its maps, and once it is run its runs.
#[pyclass(frozen, module = "formicarium._engine")]
pub struct Comparison {
    pub comparison: Arc<comparison::Comparison>,
    /// The command that its reports name.
    command: String,
    /// The runs that are done here, in the order of the tasks.
    done: Vec<Row>,
}

/// What `compare` asks with these arguments, and what is worth saying about its files.
#[pyfunction]
pub fn read_question(py: Python<'_>, arguments: Vec<OsString>) -> PyResult<(Comparison, Vec<String>)> {
    let (read, said_meanwhile) = py.detach(|| heard(|| shared::read_question(arguments)));
    let (comparison, command) = read.map_err(|error| said(&error))?;
    Ok((Comparison { comparison: Arc::new(comparison), command, done: Vec::new() }, said_meanwhile))
}

/// A question as JSON (`formicarium/question@1`) with a map for each of its instances, narrowed as `compare` narrows one.
#[pyfunction]
pub fn ask(
    py: Python<'_>,
    question: &str,
    maps: Vec<PyRef<'_, Map>>,
    seeds: Option<u32>,
    budget: Option<&str>,
    only: Vec<String>,
) -> PyResult<Comparison> {
    let mut question: Question = serde_json::from_str(question)
        .map_err(|error| Refusal::argument("question", error.to_string(), "the fields of docs/methodology.md"))?;
    let mut scenarios: Vec<_> = maps.iter().map(|map| Arc::clone(&map.scenario)).collect();
    if scenarios.len() != question.instances.len() {
        return Err(Refusal::argument("instances", "there is not one map for each instance", "give each its `map`").into());
    }
    if let Some(entry) = question.entries.iter().find(|entry| entry.results.is_some()) {
        let message = format!("entries.{}.results: results from elsewhere are read with a question from a file", entry.id);
        return Err(Refusal::argument("question", message, "write the question as TOML beside them, and give its name").into());
    }
    let comparison = py.detach(|| {
        question.check()?;
        question.seeds.count = question.seeds.count.min(seeds.unwrap_or(u32::MAX));
        question.budget = budget.map(str::parse::<Budget>).transpose()?.or(question.budget);
        if !only.is_empty() {
            let all = question.instances.clone();
            question.keep_instances(&only)?;
            let mut asked = all.iter().map(|instance| question.instances.iter().any(|left| left.id == instance.id));
            scenarios.retain(|_| asked.next().unwrap_or(false));
        }
        Ok::<_, Refusal>(comparison::Comparison::new(question, scenarios)?)
    })?;
    Ok(Comparison { comparison: Arc::new(comparison), command: "formicarium.compare(…)".into(), done: Vec::new() })
}

#[pymethods]
impl Comparison {
    /// Does all runs. `jobs`: threads, 0 for all cores.
    fn run(&self, py: Python<'_>, jobs: usize, progress: Option<Py<PyAny>>) -> PyResult<Self> {
        let done = pool::run_all(py, &self.comparison, cores(jobs).get(), progress.as_ref())?;
        Ok(Self { comparison: Arc::clone(&self.comparison), command: self.command.clone(), done })
    }

    /// The question as JSON.
    #[getter]
    fn question(&self) -> String {
        json(&self.comparison.question)
    }

    /// The kinds of result files with the endings of their names.
    #[staticmethod]
    fn kinds() -> Vec<(&'static str, &'static str)> {
        ResultFile::NAMED.map(|(id, ending, _)| (id, ending)).to_vec()
    }

    /// The languages of the files that people read.
    #[staticmethod]
    fn languages() -> Vec<&'static str> {
        ReportLanguage::NAMED.map(|(code, _)| code).to_vec()
    }

    /// The contents of result files, the bytes that `compare` writes.
    fn files(&self, py: Python<'_>, kinds: Vec<String>, language: &str) -> PyResult<Vec<String>> {
        let kinds = kinds.iter().map(|kind| file(kind)).collect::<Result<Vec<_>, _>>()?;
        let languages = ReportLanguage::NAMED;
        let language = languages.iter().find(|(code, _)| *code == language).ok_or_else(|| {
            let known = languages.map(|(code, _)| code).join(", ");
            Refusal::argument("language", format!("there is no language `{language}`"), format!("one of {known}"))
        })?;
        Ok(py.detach(|| self.contents(&kinds, language.1)))
    }

    /// What the runs say, as JSON.
    fn analysis(&self, py: Python<'_>) -> String {
        py.detach(|| {
            let rows = self.comparison.all_rows(&self.done);
            json(&analysis::whole(&Samples::new(&self.comparison, rows.iter().map(Seen::from)), &mut Intervals::default()))
        })
    }

    /// Every improvement of every run, as CSV.
    fn traces(&self, py: Python<'_>) -> String {
        py.detach(|| {
            let rows = self.comparison.all_rows(&self.done);
            format!("{TRACE_HEADER}\n{}", rows.iter().map(|row| trace_lines(&self.comparison, row)).collect::<String>())
        })
    }
}

impl Comparison {
    fn contents(&self, kinds: &[ResultFile], language: ReportLanguage) -> Vec<String> {
        let comparison = &*self.comparison;
        let rows = comparison.all_rows(&self.done);
        let analysis = analysis::whole(&Samples::new(comparison, rows.iter().map(Seen::from)), &mut Intervals::default());
        let document = |with_rows| comparison_json::write(comparison, &self.done, with_rows);
        let (command, fronts) = (&self.command, &FrontQuestion::default());
        let (rows, analysis, document) = (&rows, &analysis, &document);
        let reports = Reports { comparison, rows, analysis, command, language, fronts, document };
        kinds.iter().map(|&kind| reports.contents(kind)).collect()
    }
}

fn file(kind: &str) -> Result<ResultFile, Refusal> {
    let named = ResultFile::NAMED.iter().find(|(id, ..)| *id == kind);
    named.map(|&(.., file)| file).ok_or_else(|| {
        let known = ResultFile::NAMED.map(|(id, ..)| id).join(", ");
        Refusal::argument("kind", format!("there is no result file `{kind}`"), format!("one of {known}"))
    })
}
