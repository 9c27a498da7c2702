//! The question of a comparison: read, narrowed by the arguments, with its maps.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use formicarium::error::{Error, FormatError};
use formicarium::experiment::{Experiment, Question, QuestionError, Recorded, document};
use formicarium::scenario::Scenario;

use super::compare::Args;
use super::error::CliError;
use super::{input, text};

/// The question with its maps, and what was recorded of it.
pub fn load(args: &Args) -> Result<(Experiment, Option<Recorded>), CliError> {
    if args.question.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json")) {
        return reopen(args);
    }
    let mut question = input::in_file(&args.question, |bytes, _| read(bytes))?;
    question.check().map_err(|e| in_question(args, e))?;
    let folder = args.question.parent().unwrap_or(Path::new(""));
    // A map that is named here is looked for here, a question's own beside it.
    question.instances.iter_mut().for_each(|i| i.map = folder.join(&i.map).display().to_string());
    narrow(args, &mut question).map_err(|e| in_question(args, e))?;
    let scenarios = question.instances.iter().map(|i| scenario(Path::new(&i.map))).collect::<Result<Vec<_>, _>>()?;
    // From here on maps are known by their names: folders are this machine's.
    question.instances.iter_mut().for_each(|i| i.map = file_name(Path::new(&i.map)));
    let experiment = Experiment::new(question, scenarios).map_err(|e| in_question(args, e))?;
    Ok((experiment, None))
}

/// An experiment that was written before, its maps in it.
fn reopen(args: &Args) -> Result<(Experiment, Option<Recorded>), CliError> {
    if let Some(id) = args.only.first().or_else(|| args.map.first().map(|(id, _)| id)) {
        let message = format!("`{id}` cannot be chosen or replaced: the file has its maps in it, and results on all of them");
        return Err(CliError::usage(message, "leave out --only and --map, or give a question as TOML"));
    }
    let opened = input::in_file(&args.question, |bytes, _| {
        let text = std::str::from_utf8(bytes).map_err(|_| FormatError::NotText { found: "binary data".into() })?;
        document::open(text)
    })?;
    let mut experiment = opened.experiment;
    narrow(args, &mut experiment.question).map_err(|e| in_question(args, e))?;
    Ok((experiment, opened.recorded))
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
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
    question.seeds.count = question.seeds.count.min(args.seeds.unwrap_or(u32::MAX));
    for (id, file) in &args.map {
        let instance = question.instance_mut(id)?;
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        (instance.map, instance.note) = (file.display().to_string(), format!("{stem} in place of the question's map."));
    }
    if args.only.is_empty() { Ok(()) } else { question.keep_instances(&args.only) }
}

fn scenario(path: &Path) -> Result<Arc<Scenario>, CliError> {
    let map = input::import(path)?;
    text::notes(&map.notices);
    let scenario = Scenario::new(map.grid, map.spec)
        .map_err(|error| CliError::Contents { path: path.display().to_string(), error: error.into() })?;
    text::notes(&scenario.notices());
    Ok(Arc::new(scenario))
}

pub fn in_question(args: &Args, error: QuestionError) -> CliError {
    CliError::Contents { path: args.question.display().to_string(), error: error.into() }
}

/// `ID=FILE` of `--map`.
pub fn stand_in(text: &str) -> Result<(String, PathBuf), String> {
    let split = text.split_once('=').filter(|(id, file)| !id.is_empty() && !file.is_empty());
    let (id, file) = split.ok_or_else(|| format!("`{text}` names no map: write ID=FILE such as ship-20x20=mine.csv"))?;
    Ok((id.into(), file.into()))
}
