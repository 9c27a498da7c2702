//! `compare`: a question over many seeds, on all cores; a committed one, or what each component of a planner does.

mod args;
mod journal;
mod question;
mod runs;

use std::path::Path;

use formicarium::comparison::report::{self, Reports};
use formicarium::comparison::{Comparison, Deviation, Intervals, Row, Samples, Seen, Verification, analysis, effects};
use formicarium::formats::comparison_json;

use super::error::CliError;
use super::{Outcome, text};
use journal::Journal;

pub use args::Args;

/// Runs what the arguments ask, writes its files and says what came out; or prints the document alone.
pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let (comparison, before) = question::load(args)?;
    if args.document {
        return Ok(Outcome::fine(comparison_json::write(&comparison, &[], false)));
    }
    let place = args.place();
    let (mut journal, kept) = Journal::open(place.with_extension("partial"), &comparison)?;
    let done = runs::run_all(args, &comparison, &mut journal, kept)?;
    let mut said = report(args, &comparison, &done, &place)?;
    journal.close()?;
    let verification = before.map(|before| before.verify(&comparison, &done));
    said += &verification.as_ref().map_or_else(String::new, verified);
    Ok(Outcome { text: said, fine: !verification.is_some_and(|v| v.refuted) })
}

/// Writes the files that are asked for, and says what came out in a few lines.
fn report(args: &Args, comparison: &Comparison, done: &[Row], place: &Path) -> Result<String, CliError> {
    let rows = comparison.all_rows(done);
    let samples = Samples::new(comparison, rows.iter().map(Seen::from));
    let analysis = analysis::whole(&samples, &mut Intervals::default());
    let mut said = format!("{}: {}\n", comparison.question.title, text::count(rows.len() as u64, "run", "runs"));
    said += &report::verdicts(comparison, &analysis.judged);
    said += &report::components(comparison, &effects(&samples));
    let (command, document) = (args.command(), |with_rows| comparison_json::write(comparison, done, with_rows));
    let reports = Reports { comparison, rows: &rows, analysis: &analysis, command: &command, document: &document };
    for (ending, file) in &args.files {
        let path = place.with_extension(ending);
        replace(&path, &reports.contents(*file))?;
        said += &format!("wrote {}\n", path.display());
    }
    Ok(said)
}

/// What became of the results that the file had.
fn verified(verification: &Verification) -> String {
    let Verification { runs, of, deviations, .. } = verification;
    let mut said = format!("recorded results: {runs} of {} the same, bit for bit\n", text::count((*of).into(), "run", "runs"));
    for deviation in deviations {
        said += &format!("  {deviation}\n");
    }
    if !deviations.is_empty() && deviations.iter().all(|d| matches!(d, Deviation::Bits { .. })) {
        said += "  nothing explains it: engine, question, maps and parameters are those that were recorded\n";
    }
    said
}

/// Writes beside the place first, so that a file is the old or the new one, whatever happens.
fn replace(path: &Path, contents: &str) -> Result<(), CliError> {
    let staging = path.with_extension(format!("{}.new", path.extension().unwrap_or_default().to_string_lossy()));
    let folder = path.parent().map_or(Ok(()), std::fs::create_dir_all);
    let written = folder.and_then(|()| std::fs::write(&staging, contents)).and_then(|()| std::fs::rename(&staging, path));
    written.map_err(|error| CliError::File { action: "write", path: path.display().to_string(), error })
}
