//! Many runs: a comparison's tasks for a pool of workers, and what its rows say.

use std::collections::BTreeMap;

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;

use super::arguments::{self, Clock, Flag, Number, ParamValues, Seconds, Text, argument, not};
use super::{Answer, object, throw};
use crate::comparison::report::{ReportLanguage, Reports, ResultFile};
use crate::comparison::{
    self, Ablated, AblationRole, Analysis, Axis, Entry, FrontQuestion, Intervals, MapFronts, Record, Recorded, Row, RunMeasure,
    Samples, Seen, Task, Timed, Verification, analyse, analysis,
};
use crate::error::FormatError;
use crate::formats::comparison_json;

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

/// What the page must know of a comparison before anything has run. Of entries and instances it tells their places in the question.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct ComparisonOutline {
    /// The entries that can be run; the others have their results from elsewhere, or none.
    pub runnable: Vec<usize>,
    /// For each entry its part in an ablation; null for one that has no part in it, and for all where the question is none.
    pub ablation_roles: Vec<Option<AblationRole>>,
    /// Runs of each runnable entry on each map.
    pub seeds: u32,
    /// The measures by which its runs can be traded off.
    pub front_measures: Vec<RunMeasure>,
    /// What is traded off where nobody says otherwise.
    pub fronts: FrontQuestion,
}

/// What the documents that a page writes say under `format`.
#[derive(Serialize, Tsify)]
pub struct Formats {
    /// Of a question.
    #[tsify(type = "Question[\"format\"]")]
    pub question: &'static str,
    /// Of a question with its maps and runs.
    #[tsify(type = "ComparisonDocument[\"format\"]")]
    pub comparison: &'static str,
}

/// What the documents that a page writes say under `format`.
#[wasm_bindgen]
pub fn formats() -> Ts<Formats> {
    object(&Formats { question: comparison::question::FORMAT, comparison: comparison_json::FORMAT })
}

/// One entry of an ablation.
#[derive(Serialize, Tsify)]
pub struct AblationEntry {
    /// The entry, as a question has it.
    pub entry: Entry,
    /// Its part.
    pub role: AblationRole,
}

/// The entries of a question that asks what each component of a planner does: the full planner with these values first, then the same without
/// each component. Throws where the catalog refuses planner, preset or values, and where nothing can be taken out.
#[wasm_bindgen]
pub fn ablation(planner: &Text, preset: Option<Text>, set: &ParamValues) -> Answer<Vec<Ts<AblationEntry>>> {
    let planner = planner.read("planner")?;
    let preset = preset.map(|name| name.read("preset")).transpose()?;
    let set = set.read("set")?;
    let entries = comparison::ablation::ablation(&planner, preset.as_deref(), &set).map_err(throw)?;
    Ok(entries.into_iter().map(|(entry, role)| object(&AblationEntry { entry, role })).collect())
}

/// A question with its maps and the runs of it that are done.
#[wasm_bindgen]
pub struct Comparison {
    pub(super) inner: comparison::Comparison,
    /// What the document told of runs.
    record: Record,
    tasks: Vec<Task>,
    pub(super) done: BTreeMap<usize, Timed>,
    /// The runs among them that were not done in this browser, or had not been: as they came.
    pub(super) brought: BTreeMap<usize, Row>,
    /// Runs that were done again, to be compared with those.
    pub(super) again: BTreeMap<usize, Row>,
    /// Those of the runs as they were when somebody asked last.
    intervals: Intervals,
}

#[wasm_bindgen]
impl Comparison {
    /// Opens a document (`formicarium/comparison@1`); the runs in it are kept.
    #[wasm_bindgen(constructor)]
    pub fn new(document: &Text) -> Answer<Comparison> {
        let opened = comparison_json::open(&document.read("document")?).map_err(throw)?;
        let (record, tasks) = (opened.record(), opened.comparison.tasks());
        let place = |row: Row| Some((tasks.binary_search(&row.task).ok()?, Timed { row, seconds: Vec::new() }));
        let done: BTreeMap<usize, Timed> = opened.rows.into_iter().filter_map(place).collect();
        let brought = done.iter().map(|(&place, timed)| (place, timed.row.clone())).collect();
        Ok(Comparison {
            inner: opened.comparison,
            record,
            tasks,
            done,
            brought,
            again: BTreeMap::new(),
            intervals: Intervals::default(),
        })
    }

    /// Number of runs that are to be done, the done ones among them.
    pub fn tasks(&self) -> usize {
        self.tasks.len()
    }

    /// What must be known of the comparison before anything has run.
    pub fn outline(&self) -> Ts<ComparisonOutline> {
        let question = &self.inner.question;
        object(&ComparisonOutline {
            runnable: question.runnable(),
            ablation_roles: comparison::ablation::roles(question),
            seeds: question.seeds.count,
            front_measures: FrontQuestion::measures_of(&self.inner),
            fronts: FrontQuestion::default(),
        })
    }

    /// Every task in its place, three numbers each: instance and entry as places in the question, and the seed.
    pub fn task_table(&self) -> Vec<u32> {
        self.tasks.iter().flat_map(|task| [task.instance as u32, task.entry as u32, task.seed]).collect()
    }

    /// The places of the tasks in the order in which they are handed out: seed by seed, so that every entry is seen early on every map. Of each
    /// entry and map only the first `seeds` seeds; all where it is left out.
    pub fn seed_by_seed(&self, seeds: Option<Number>) -> Answer<Vec<u32>> {
        let seeds = seeds.map_or(Ok(u32::MAX), |seeds| seeds.whole("seeds"))?;
        Ok(self.inner.seed_by_seed(seeds).into_iter().map(|place| place as u32).collect())
    }

    /// The places of the tasks that are not done yet.
    pub fn open_tasks(&self) -> Vec<u32> {
        (0..self.tasks.len()).filter(|i| !self.done.contains_key(i)).map(|i| i as u32).collect()
    }

    /// The rows that are done, as lines of JSON in the order of the tasks.
    pub fn rows(&self) -> Vec<String> {
        self.done.values().map(|timed| timed.row.to_line()).collect()
    }

    /// 16 hexadecimal digits over question and maps: comparisons with equal digests have equal runs, under one version of the engine.
    pub fn digest(&self) -> String {
        self.inner.digest().hex()
    }

    /// Does one run to its end; `now` tells seconds. It is not kept.
    pub fn run(&self, index: &Number, now: &Clock) -> Answer<Ts<DoneRun>> {
        let now: &js_sys::Function = now.dyn_ref().ok_or_else(|| not("now", "a function"))?;
        let index = index.whole("index")?;
        let task = *self.tasks.get(index as usize).ok_or_else(|| argument("index", "there is no such run"))?;
        let mut clock = || now.call0(&JsValue::NULL).ok().and_then(|t| t.as_f64()).unwrap_or(0.0);
        let Timed { row, seconds } = self.inner.run(task, &mut clock).map_err(throw)?;
        Ok(object(&DoneRun { index, row: row.to_line(), found: row.found.is_some(), seconds }))
    }

    /// Takes in a run that is done, from any worker or from before; `seconds` as `run` tells them, empty for a run that somebody else has done.
    pub fn keep(&mut self, row: &Text, seconds: &Seconds) -> Answer<()> {
        let seconds = seconds.read("seconds")?;
        let (index, row) = self.placed(&row.read("row")?)?;
        if seconds.is_empty() {
            self.brought.insert(index, row.clone());
        }
        self.done.insert(index, Timed { row, seconds });
        Ok(())
    }

    /// Takes in a run that was done again, only to be compared: the one that somebody else has done stays.
    pub fn check(&mut self, row: &Text) -> Answer<()> {
        let (index, row) = self.placed(&row.read("row")?)?;
        self.again.insert(index, row);
        Ok(())
    }

    /// What the runs so far say, the imported ones among them, with effort counted on an axis. Bootstrap intervals and the verdicts that
    /// follow from them take long, but only once for the same runs.
    pub fn analysis(&mut self, axis: Ts<Axis>, intervals: &Flag) -> Answer<Ts<Analysis>> {
        let (axis, intervals) = (arguments::word(&axis.js_value(), "axis")?, intervals.read("intervals")?);
        let runs = self.done.values().map(Seen::from).chain(self.inner.imported.iter().map(Seen::from));
        let samples = Samples::new(&self.inner, runs);
        Ok(object(&analyse(&samples, axis, intervals.then_some(&mut self.intervals))))
    }

    /// One of the result files; the same bytes as the command line writes. `command` is how Markdown says that it was made; `language` is what
    /// Markdown and LaTeX are written in; `fronts` is what those of fronts trade off, length and turns where it is left out.
    pub fn file(
        &mut self,
        file: Ts<ResultFile>,
        command: &Text,
        language: Ts<ReportLanguage>,
        fronts: Option<Ts<FrontQuestion>>,
    ) -> Answer<String> {
        let fronts = fronts.map_or_else(|| Ok(FrontQuestion::default()), |asked| front_question(&asked))?;
        let (file, command) = (arguments::word(&file.js_value(), "file")?, command.read("command")?);
        let language: ReportLanguage = arguments::word(&language.js_value(), "language")?;
        let done = self.done_rows();
        let rows = self.inner.all_rows(&done);
        let analysis = analysis::whole(&Samples::new(&self.inner, rows.iter().map(Seen::from)), &mut self.intervals);
        let recorded = self.recorded_now(&done);
        let document = |with_rows| comparison_json::write_as(&self.inner, &done, with_rows, recorded.as_ref());
        let (comparison, rows, analysis, command, document) = (&self.inner, &*rows, &analysis, &*command, &document);
        let reports = Reports { comparison, rows, analysis, command, language, fronts: &fronts, document };
        Ok(reports.contents(file))
    }

    /// What the kept runs trade off on each map. Throws what cannot be asked: fewer than two or more than three measures, one that a run has no
    /// value of, a reference point of another size.
    pub fn fronts(&self, asked: Ts<FrontQuestion>) -> Answer<Vec<Ts<MapFronts>>> {
        let asked = front_question(&asked)?;
        let runs = self.done.values().map(Seen::from).chain(self.inner.imported.iter().map(Seen::from));
        Ok(comparison::fronts(&Samples::new(&self.inner, runs), &asked).iter().map(object).collect())
    }

    /// What each component does, on each map, by the kept runs; empty where the question is no ablation. Infinite: half of the runs or more
    /// found no path.
    pub fn effects(&self) -> Vec<Ts<Ablated>> {
        let done = self.done_rows();
        let rows = self.inner.all_rows(&done);
        comparison::effects(&Samples::new(&self.inner, rows.iter().map(Seen::from))).iter().map(object).collect()
    }

    /// What was recorded when the document was written; null where nothing had been run.
    pub fn recorded(&self) -> Option<Ts<Recorded>> {
        self.record.recorded().map(object)
    }

    /// How far runs that somebody else has done come out again in those done here: kept with their seconds, or checked. Null where nobody has
    /// done any.
    pub fn verify(&self) -> Option<Ts<Verification>> {
        if self.record.recorded().is_none() && self.brought.is_empty() {
            return None;
        }
        let then: Vec<Row> = self.brought.values().cloned().collect();
        let done_here = self.done.values().filter(|timed| !timed.seconds.is_empty()).map(|timed| &timed.row);
        let now: Vec<Row> = done_here.chain(self.again.values()).cloned().collect();
        Some(object(&self.record.verify(&self.inner, &then, &now)))
    }
}

impl Comparison {
    /// A row of JSON, and its place among the tasks.
    fn placed(&self, row: &str) -> Answer<(usize, Row)> {
        let row: Row = serde_json::from_str(row).map_err(|e| throw(FormatError::syntax(1, e.to_string(), "a run's row")))?;
        let index = self.tasks.binary_search(&row.task).map_err(|_| argument("row", "the comparison has no such run"))?;
        Ok((index, row))
    }

    /// What is recorded of the runs: by this engine, or as it came with those that were done elsewhere, perhaps by another engine.
    fn recorded_now(&self, done: &[Row]) -> Option<Recorded> {
        let then = self.record.recorded();
        let foreign = self.done.values().filter(|timed| timed.seconds.is_empty()).count();
        match then {
            Some(then) if foreign == done.len() => Some(then.clone()),
            Some(then) if foreign > 0 => Some(Recorded::of(&self.inner, done).with_runs_of(then)),
            _ => (!done.is_empty()).then(|| Recorded::of(&self.inner, done)),
        }
    }

    fn done_rows(&self) -> Vec<Row> {
        self.done.values().map(|timed| timed.row.clone()).collect()
    }
}

/// What fronts are asked over.
fn front_question(given: &Ts<FrontQuestion>) -> Answer<FrontQuestion> {
    let asked = arguments::value(given, "fronts")?;
    asked.check().map_err(throw)?;
    Ok(asked)
}
