//! The question of a comparison: read and narrowed by the arguments, or made from them, with its maps.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::comparison::imported::{self, ImportedResults};
use crate::comparison::{Budget, Comparison, Instance, Question, Record, Row, Seeds, Verification, ablation};
use crate::error::{Error, FormatError, QuestionError};
use crate::formats::{MAX_BYTES, MAX_TEXT_BYTES, comparison_json, import_results};
use crate::scenario::Scenario;

use super::args::Args;
use crate::cli::error::CliError;
use crate::cli::input::{file_name, stem};
use crate::cli::reading::ReadingArgs;
use crate::cli::{input, text};

/// What a file tells of runs that were done before.
pub struct Before {
    record: Record,
    rows: Vec<Row>,
    /// Whether it tells of any.
    is_any: bool,
    /// Whether the arguments ask for what the file asks.
    is_same: bool,
    /// What the file lets a run spend.
    budget: Option<Budget>,
}

impl Before {
    /// Whether they come out again. Under another budget other runs are asked for: there is nothing to compare them with.
    pub fn verify(&self, comparison: &Comparison, done: &[Row]) -> Option<Verification> {
        let is_comparable = self.is_any && comparison.question.budget == self.budget;
        is_comparable.then(|| self.record.verify(comparison, &self.rows, done))
    }

    /// Whether new results have all that the file has, so that they can take its place.
    pub fn stands(&self, verification: Option<&Verification>) -> bool {
        match verification {
            Some(told) => told.deviations.is_empty() && told.runs == told.of,
            None => !self.is_any && self.is_same,
        }
    }
}

/// What is compared.
pub struct Asked {
    /// The question with its maps and the results from elsewhere.
    pub comparison: Comparison,
    /// What was recorded of it.
    pub before: Option<Before>,
    /// Every file that was read for it, except a comparison's own.
    pub inputs: Vec<PathBuf>,
}

/// Reads what the arguments ask.
pub fn load(args: &Args) -> Result<Asked, CliError> {
    let asked = asked(args)?;
    let files = args.map.iter().chain(&args.results).map(|(_, file)| file.clone());
    let inputs = asked.inputs.into_iter().chain(files).collect();
    Ok(Asked { comparison: joined(args, asked.comparison)?, before: asked.before, inputs })
}

fn asked(args: &Args) -> Result<Asked, CliError> {
    let mut left_out = Vec::new();
    let mut question = match (&args.ablate, &args.question) {
        (Some(planner), _) => components(args, planner).map_err(|e| args.wrong(e))?,
        (None, Some(file)) if file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json")) => {
            return reopen(args, file);
        }
        (None, Some(file)) => committed(args, file, &mut left_out)?,
        (None, None) => return Err(CliError::usage("there is no question", "name its file, or a planner by --ablate")),
    };
    let scenarios = question.instances.iter().map(|i| scenario(Path::new(&i.map))).collect::<Result<Vec<_>, _>>()?;
    let mut inputs: Vec<PathBuf> =
        question.instances.iter().map(|i| PathBuf::from(&i.map)).chain(args.question.clone()).collect();
    // From here on maps are known by their names: folders are this machine's.
    question.instances.iter_mut().for_each(|i| i.map = file_name(Path::new(&i.map)));
    let files: Vec<Option<PathBuf>> = question.entries.iter().map(|e| e.results.as_ref().map(PathBuf::from)).collect();
    question.entries.iter_mut().flat_map(|e| &mut e.results).for_each(|file| *file = file_name(Path::new(file)));
    let mut comparison = Comparison::new(question, scenarios).map_err(|e| args.wrong(e))?;
    for (entry, file) in files.iter().enumerate().filter_map(|(entry, file)| Some((entry, file.as_ref()?))) {
        let mut results = results(file)?;
        results.leave_out(&left_out);
        comparison = imported::fill(comparison, entry, &results).map_err(|e| in_results(file, e))?;
    }
    inputs.extend(files.into_iter().flatten());
    Ok(Asked { comparison, before: None, inputs })
}

/// With the entries of `--results`.
fn joined(args: &Args, mut comparison: Comparison) -> Result<Comparison, CliError> {
    for (instance, file) in &args.results {
        let place = instance.as_ref().map(|id| comparison.question.place(id)).transpose().map_err(|e| args.wrong(e))?;
        comparison = imported::join(comparison, &results(file)?, place).map_err(|e| in_results(file, e))?;
    }
    Ok(comparison)
}

/// Reads results from elsewhere.
fn results(file: &Path) -> Result<ImportedResults, CliError> {
    let results = input::in_file(file, MAX_TEXT_BYTES, |bytes, name| Ok(import_results(bytes, name)?))?;
    text::notes(&results.notices);
    Ok(results)
}

fn in_results(file: &Path, error: QuestionError) -> CliError {
    CliError::Contents { path: file.display().to_string(), error: error.into() }
}

/// A question from a file; `left_out` takes the names of the maps that the arguments leave out.
fn committed(args: &Args, file: &Path, left_out: &mut Vec<String>) -> Result<Question, CliError> {
    let mut question = input::in_file(file, MAX_TEXT_BYTES, |bytes, _| read(bytes))?;
    question.check().map_err(|e| args.wrong(e))?;
    let folder = file.parent().unwrap_or(Path::new(""));
    // A map that is named here is looked for here, a question's own beside it.
    question.instances.iter_mut().for_each(|i| i.map = folder.join(&i.map).display().to_string());
    question.entries.iter_mut().flat_map(|e| &mut e.results).for_each(|file| *file = folder.join(&*file).display().to_string());
    if let Some((_, map)) = args.map.iter().find(|(id, _)| id.is_none()) {
        let message = format!("`{}` stands in for no map", map.display());
        return Err(CliError::usage(message, "write ID=FILE such as ship-20x20-01=mine.csv, or GROUP/ID=FILE"));
    }
    let all = question.instances.clone();
    narrow(args, &mut question).map_err(|e| args.wrong(e))?;
    let is_asked = |i: &&Instance| question.instances.iter().any(|left| left.id == i.id);
    left_out.extend(all.iter().filter(|i| !is_asked(i)).map(|i| i.id.clone()));
    Ok(question)
}

/// What each component of a planner does, on the maps that are named.
fn components(args: &Args, planner: &str) -> Result<Question, QuestionError> {
    let instance = |(id, file): &(Option<String>, PathBuf)| Instance {
        id: id.clone().unwrap_or_else(|| instance_id(&stem(file))),
        map: file.display().to_string(),
        note: String::new(),
        group: None,
    };
    let (seeds, set) = (Seeds { from: 1, count: args.seeds.unwrap_or(100) }, args.set.iter().cloned().collect());
    let instances = args.map.iter().map(instance).collect();
    let mut question = ablation::question(planner, args.preset.as_deref(), &set, instances, seeds)?;
    question.check()?;
    if !args.only.is_empty() {
        question.keep_instances(&args.only)?;
    }
    Ok(question)
}

/// A map's name as the id of an instance: small letters and digits, `-` for every other letter.
fn instance_id(name: &str) -> String {
    let keep = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    let id: String = name.chars().map(keep).collect();
    if id.is_empty() { "map".into() } else { id }
}

/// A comparison that was written before, its maps in it.
fn reopen(args: &Args, file: &Path) -> Result<Asked, CliError> {
    let map = |(id, map): &(Option<String>, PathBuf)| id.clone().unwrap_or_else(|| map.display().to_string());
    if let Some(id) = args.only.first().cloned().or_else(|| args.map.first().map(map)) {
        let message =
            format!("`{id}` cannot be chosen, replaced or added: the file has its maps in it, and results on all of them");
        return Err(CliError::usage(message, "leave out --only and --map, or give a question as TOML"));
    }
    let opened = input::in_file(file, MAX_BYTES, |bytes, _| {
        let text = std::str::from_utf8(bytes).map_err(|_| FormatError::NotText { found: "binary data".into() })?;
        comparison_json::open(text)
    })?;
    let record = opened.record();
    let is_any = opened.recorded.is_some() || !opened.rows.is_empty();
    let mut comparison = opened.comparison;
    let question = comparison.question.clone();
    narrow(args, &mut comparison.question).map_err(|e| args.wrong(e))?;
    let is_same = comparison.question == question;
    let before = Before { record, rows: opened.rows, is_any, is_same, budget: question.budget };
    Ok(Asked { comparison, before: Some(before), inputs: Vec::new() })
}

fn read(bytes: &[u8]) -> Result<Question, Error> {
    let text = std::str::from_utf8(bytes).map_err(|_| FormatError::NotText { found: "binary data".into() })?;
    toml::from_str(text).map_err(|e| {
        let line = e.span().map_or(0, |s| 1 + text.bytes().take(s.start).filter(|&b| b == b'\n').count());
        FormatError::syntax(line, e.message(), "a question as docs/methodology.md describes it").into()
    })
}

/// What the arguments leave of a question.
fn narrow(args: &Args, question: &mut Question) -> Result<(), QuestionError> {
    if let Some(seeds) = args.seeds.filter(|_| args.ablate.is_none()) {
        if seeds > question.seeds.count {
            return Err(QuestionError::field("--seeds", seeds, format!("at most {}, as the question has", question.seeds.count)));
        }
        question.seeds.count = seeds;
    }
    question.budget = args.budget.or(question.budget);
    for (id, file) in args.map.iter().filter_map(|(id, file)| Some((id.as_ref()?, file))) {
        let (stem, map) = (stem(file), file.display().to_string());
        if let Some((group, id)) = id.split_once('/') {
            let note = format!("{stem} beside the question's maps of {group}.");
            question.add_instance(Instance { id: id.into(), map, note, group: Some(group.into()) })?;
        } else {
            let instance = question.instance_mut(id)?;
            (instance.map, instance.note) = (map, format!("{stem} in place of the question's map."));
        }
    }
    if args.only.is_empty() { Ok(()) } else { question.keep_instances(&args.only) }
}

fn scenario(path: &Path) -> Result<Arc<Scenario>, CliError> {
    let map = ReadingArgs::default().import(path)?;
    let name = file_name(path);
    text::notes_of(&name, &map.notices);
    let scenario = Scenario::new(map.grid, map.spec)
        .map_err(|error| CliError::Contents { path: path.display().to_string(), error: error.into() })?;
    text::notes_of(&name, &scenario.notices());
    Ok(Arc::new(scenario))
}
