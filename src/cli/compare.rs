//! `compare`: a question over many seeds, on all cores; a committed one, or what each component of a planner does.

mod args;
mod held;
mod journal;
mod merge;
mod place;
mod question;
mod recheck;
mod runs;
mod shard;

use crate::comparison::report::{self, Reports};
use crate::comparison::{Comparison, Deviation, Intervals, Row, Samples, Seen, Verification, analysis, effects};
use crate::formats::journal::JournalLines;
use crate::formats::{self, comparison_json};

use super::error::CliError;
use super::{Outcome, text};
use held::Held;
use journal::Journal;
use place::Place;
use question::Asked;

pub use args::Args;

/// Runs what the arguments ask, writes its files and says what came out; or prints the document alone.
pub fn run(args: &Args) -> Result<Outcome, CliError> {
    args.fronts().check().map_err(|error| args.wrong(error))?;
    let Asked { comparison, before, inputs } = question::load(args)?;
    if args.document {
        return Ok(Outcome::fine(comparison_json::write(&comparison, &[], false)));
    }
    if args.results_template {
        return Ok(Outcome::fine(formats::results_table(&comparison.question)));
    }
    if let Some(of) = args.list_shards {
        return Ok(Outcome::fine(shard::names(args, &comparison, of)));
    }
    if let Some(shard) = args.shard {
        return shard::run(args, &comparison, shard);
    }
    let (place, held) = (args.place(), Held::of(args));
    let check = || held.places(&place).iter().try_for_each(|place| place.check(&args.files, &inputs, args.replace));
    let Done { rows: done, journal, mut said } = match done(args, &comparison, &place, &check)? {
        Ok(done) => done,
        Err(findings) => return Ok(Outcome { text: findings, fine: false }),
    };
    let verification = before.as_ref().and_then(|before| before.verify(&comparison, &done));
    let stands = before.as_ref().is_none_or(|before| before.stands(verification.as_ref()));
    let (place, aside) = held.choose(place, stands);
    said += &report(args, &comparison, &done, &place)?;
    journal.map_or(Ok(()), Journal::close)?;
    said += &verification.as_ref().map_or_else(String::new, verified);
    Ok(Outcome { text: said + &aside, fine: !verification.is_some_and(|v| v.refuted) })
}

/// All runs of a comparison, and the journal that is held as long as their results are written; none where they come from others.
struct Done {
    rows: Vec<Row>,
    journal: Option<Journal>,
    said: String,
}

/// Does the runs, or merges those that are done; what keeps them from being whole is for the reader. `check` tells whether results can be
/// written.
fn done(
    args: &Args,
    comparison: &Comparison,
    place: &Place,
    check: &impl Fn() -> Result<(), CliError>,
) -> Result<Result<Done, String>, CliError> {
    if let Some(folder) = &args.merge {
        let was_there = args.folder().exists();
        let merged = merge::merged(args, comparison, folder, check)?;
        if merged.is_err() && !was_there {
            // Nothing was written: not even the folder stays. Where there is something in it, it does.
            let _ = std::fs::remove_dir(args.folder());
        }
        return Ok(merged.map(|merged| Done { rows: merged.rows, journal: None, said: merged.said }));
    }
    check()?;
    let (mut journal, kept) = Journal::open(place, JournalLines::of(comparison, None), !args.no_wait)?;
    place.sweep();
    // Whoever had the name before may have written meanwhile.
    check()?;
    let rows = runs::run_whole(args, comparison, &mut journal, kept)?;
    Ok(Ok(Done { rows, journal: Some(journal), said: String::new() }))
}

/// Writes the files that are asked for, and says what came out in a few lines.
fn report(args: &Args, comparison: &Comparison, done: &[Row], place: &Place) -> Result<String, CliError> {
    let rows = comparison.all_rows(done);
    let samples = Samples::new(comparison, rows.iter().map(Seen::from));
    let analysis = analysis::whole(&samples, &mut Intervals::default());
    let mut said = format!("{}: {}\n", comparison.question.title, analysis.counts.words());
    said += &report::verdicts(comparison, &analysis);
    said += &report::components(comparison, &effects(&samples));
    let (command, document) = (args.command(), |with_rows| comparison_json::write(comparison, done, with_rows));
    let (language, fronts) = (args.language, &args.fronts());
    let (rows, analysis, command, document) = (&rows, &analysis, &command, &document);
    let reports = Reports { comparison, rows, analysis, command, language, fronts, document };
    for (ending, file) in &args.files {
        let path = place.file(ending);
        place.write(&path, &reports.contents(*file))?;
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

/// What the arguments ask, with nothing run.
pub fn asked(args: &Args) -> Result<Comparison, CliError> {
    Ok(question::load(args)?.comparison)
}
