//! `compare`: a question over many seeds, on all cores.

use std::collections::BTreeSet;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use formicarium::experiment::{Deviation, Experiment, Row, Task, Verification, document, judge, report};
use indicatif::{ProgressBar, ProgressStyle};

use super::error::CliError;
use super::journal::Journal;
use super::question::{in_question, load};
use super::{Outcome, text};

/// Runs a question: every entry on every map with every seed, and judges its claims
#[derive(clap::Args)]
#[command(after_help = "\
Writes NAME.csv, one row a run, NAME.md, tables and verdicts, NAME.tests.md, rank tests of all pairs, and NAME.json, question, maps
and runs in one file, which the page opens and which can be compared again. They depend on the question alone, not on the number of jobs.
Every finished run is kept in NAME.partial at once: a comparison that was broken off goes on where it was when it is started again. The
question's format and the rule of the verdicts: docs/methodology.md.

Examples:
  formicarium compare experiments/ship.toml --out experiments/records
  formicarium compare ship.json --out /tmp/again
  formicarium compare experiments/ship.toml --out /tmp/look --seeds 10
  formicarium compare experiments/ship.toml --out /tmp/mine --only ship-20x20 --map ship-20x20=mine.csv")]
pub struct Args {
    /// The question as TOML (formicarium/question@1), or with its maps and results as JSON (formicarium/result@1)
    pub question: PathBuf,
    /// Folder for the files; made if it is missing
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Runs at the same time [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    /// Only the question's first seeds
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub seeds: Option<u32>,
    /// Only this instance; may be repeated
    #[arg(long, value_name = "ID")]
    pub only: Vec<String>,
    /// Another map in place of an instance's; may be repeated
    #[arg(long, value_name = "ID=FILE", value_parser = super::question::stand_in)]
    pub map: Vec<(String, PathBuf)>,
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let (experiment, recorded) = load(args)?;
    let name = args.question.file_stem().unwrap_or_default();
    let (mut journal, kept) = Journal::open(args.out.join(name).with_extension("partial"), &experiment)?;
    let done = run_all(args, &experiment, &mut journal, kept)?;
    let rows = experiment.all_rows(&done);
    let comparisons = judge(&experiment, &rows);
    let page = report::markdown(&experiment, &rows, &comparisons, &command(args));
    let mut said = format!("{}: {}\n", experiment.question.title, text::count(rows.len() as u64, "run", "runs"));
    said += &report::verdicts(&experiment, &comparisons);
    let tests = report::tests(&experiment, &rows);
    let whole = document::write(&experiment, &done, true);
    for (ending, contents) in [("csv", report::csv(&experiment, &rows)), ("md", page), ("tests.md", tests), ("json", whole)] {
        let path = args.out.join(name).with_extension(ending);
        replace(&path, &contents)?;
        said += &format!("wrote {}\n", path.display());
    }
    journal.close()?;
    said += &recorded.map_or_else(String::new, |then| verified(&document::verify(&experiment, &then, &done)));
    Ok(Outcome::fine(said))
}

/// What became of the results that the file had.
fn verified(verification: &Verification) -> String {
    let Verification { same, open, deviations } = verification;
    let mut said = format!("recorded results: {same} of {} the same, bit for bit\n", same + open + bits(deviations));
    for deviation in deviations {
        said += &format!("  {deviation}\n");
    }
    said
}

fn bits(deviations: &[Deviation]) -> u32 {
    deviations.iter().filter(|d| matches!(d, Deviation::Bits { .. })).count() as u32
}

fn jobs(args: &Args) -> usize {
    let cores = || thread::available_parallelism().map_or(1, NonZero::get);
    args.jobs.map_or_else(cores, usize::from)
}

/// Does every run that is not kept from before; rows in the order of the tasks, whoever finishes first.
fn run_all(args: &Args, experiment: &Experiment, journal: &mut Journal, kept: Vec<Row>) -> Result<Vec<Row>, CliError> {
    let all = experiment.tasks();
    let mut rows: Vec<Option<Row>> = vec![None; all.len()];
    let mut place = |row: Row| {
        if let Ok(place) = all.binary_search(&row.task) {
            rows[place] = Some(row);
        }
    };
    let done: BTreeSet<Task> = kept.iter().map(|row| row.task).collect();
    kept.into_iter().for_each(&mut place);
    let tasks: Vec<Task> = all.iter().copied().filter(|task| !done.contains(task)).collect();
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..jobs(args).min(tasks.len()) {
            let (sender, next, tasks) = (sender.clone(), &next, &tasks);
            scope.spawn(move || {
                let take = || tasks.get(next.fetch_add(1, Ordering::Relaxed));
                // A closed channel: an error has ended the whole.
                while take().is_some_and(|&task| sender.send(experiment.run(task, &mut || 0.0)).is_ok()) {}
            });
        }
        drop(sender);
        let (bar, mut without_path) = (bar(done.len(), all.len()), 0);
        for row in receiver {
            let row = row.map_err(|e| in_question(args, e))?.row;
            journal.note(&row)?;
            without_path += usize::from(row.found.is_none());
            bar.set_message(beside(done.len(), without_path));
            bar.inc(1);
            place(row);
        }
        bar.finish_and_clear();
        Ok::<_, CliError>(())
    })?;
    Ok(rows.into_iter().flatten().collect())
}

/// A bar on the error stream, where somebody looks at it; it starts with the runs that are kept from before.
fn bar(kept: usize, of: usize) -> ProgressBar {
    const LOOK: &str = "{bar:32} {pos} of {len} runs{msg}, {eta} left";
    let bar = ProgressBar::new(of as u64)
        .with_style(ProgressStyle::with_template(LOOK).unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.set_position(kept as u64);
    // The time left follows from the runs of this start alone.
    bar.reset_eta();
    bar
}

/// What is worth saying beside the counter.
fn beside(kept: usize, without_path: usize) -> String {
    let kept = if kept > 0 { format!(", {kept} from before") } else { String::new() };
    if without_path > 0 { format!("{kept}, {without_path} without a path") } else { kept }
}

/// The arguments that the results depend on; other maps by their names alone, because their folders are this machine's.
fn command(args: &Args) -> String {
    let mut said = format!("formicarium compare {} --out DIR", args.question.display());
    args.seeds.iter().for_each(|n| said += &format!(" --seeds {n}"));
    args.only.iter().for_each(|id| said += &format!(" --only {id}"));
    let name = |file: &Path| file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    args.map.iter().for_each(|(id, file)| said += &format!(" --map {id}={}", name(file)));
    said
}

/// Writes beside the place first, so that a file is the old or the new one, whatever happens.
fn replace(path: &Path, contents: &str) -> Result<(), CliError> {
    let staging = path.with_extension(format!("{}.new", path.extension().unwrap_or_default().to_string_lossy()));
    let folder = path.parent().map_or(Ok(()), std::fs::create_dir_all);
    let written = folder.and_then(|()| std::fs::write(&staging, contents)).and_then(|()| std::fs::rename(&staging, path));
    written.map_err(|error| CliError::File { action: "write", path: path.display().to_string(), error })
}
