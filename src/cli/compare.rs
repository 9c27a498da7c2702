//! `compare`: a question over many seeds, on all cores; a committed one, or what each component of a planner does.

use std::collections::BTreeSet;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use formicarium::comparison::report::{self, Reports, ResultFile};
use formicarium::comparison::{
    Budget, Comparison, Deviation, Intervals, Row, Samples, Seen, Task, Verification, analysis, document, effects,
};
use formicarium::params::Value;
use indicatif::{ProgressBar, ProgressStyle};

use super::error::CliError;
use super::journal::Journal;
use super::question::{in_question, load};
use super::{Outcome, text};

/// Runs a question: every entry on every map with every seed, and judges its claims
#[derive(clap::Args)]
#[command(after_help = "\
Writes NAME.csv, one row a run, NAME.md, tables and verdicts, NAME.tests.md, rank tests of all pairs, NAME.summary.csv and
NAME.summary.json, one row an entry and map with every statistic, NAME.tex, the same for a paper, and NAME.json, question, maps
and runs in one file, which the page opens and which can be compared again: exit code 1 when other bits come out though engine, question,
maps and parameters are the recorded ones. They depend on the question alone, not on the number of jobs.
Every finished run is kept in NAME.partial at once: a comparison that was broken off goes on where it was when it is started again. The
question's format and the rule of the verdicts: docs/methodology.md.

--ablate asks without a file what each component of a planner does: the full planner beside the same without one, on maps of your own.
`formicarium catalog PLANNER` lists the components.

Examples:
  formicarium compare experiments/ship.toml --out experiments/records
  formicarium compare ship.json --out /tmp/again
  formicarium compare experiments/ship.toml --out /tmp/look --seeds 10 --files markdown,latex
  formicarium compare experiments/ship.toml --out /tmp/fair --budget constructed-paths=2000
  formicarium compare experiments/ship.toml --out /tmp/mine --only ship-20x20 --map ship-20x20=mine.csv
  formicarium compare experiments/ship.toml --results mine.csv --out /tmp/beside-mine
  formicarium compare --ablate ship --map cave.json --map maze.json --seeds 50 --out /tmp/ablation")]
pub struct Args {
    /// The question as TOML (formicarium/question@1), or with its maps and results as JSON (formicarium/comparison@1)
    #[arg(required_unless_present = "ablate")]
    pub question: Option<PathBuf>,
    /// In place of a question: this planner, and the same without each of its components
    #[arg(long, value_name = "PLANNER", conflicts_with = "question", requires = "map")]
    pub ablate: Option<String>,
    /// With --ablate: a named parameter set of the planner
    #[arg(long, value_name = "NAME", requires = "ablate")]
    pub preset: Option<String>,
    /// With --ablate: a parameter, over preset and default; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE", requires = "ablate", value_parser = super::plan::assignment)]
    pub set: Vec<(String, Value)>,
    /// Folder for the files; made if it is missing
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Which files: csv, markdown, tests, tests-csv, summary-csv, summary-json, summary-markdown, latex, json [default: those above]
    #[arg(long, value_name = "KIND,…", value_delimiter = ',', hide_default_value = true, value_parser = result_file,
          default_value = "csv,markdown,tests,summary-csv,summary-json,latex,json")]
    files: Vec<(&'static str, ResultFile)>,
    /// Runs at the same time [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    /// Only the question's first seeds; with --ablate how many [default: 100]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub seeds: Option<u32>,
    /// What a run may spend, in place of the question's budget: iterations, constructed-paths, ant-moves, cell-expansions or moves
    #[arg(long, value_name = "AXIS=AMOUNT", value_parser = super::question::budget)]
    pub budget: Option<Budget>,
    /// Only this instance; may be repeated
    #[arg(long, value_name = "ID")]
    pub only: Vec<String>,
    /// Another map in place of an instance's; with --ablate a map, its ID= may be left out; may be repeated
    #[arg(long, value_name = "ID=FILE", value_parser = super::question::named_map)]
    pub map: Vec<(Option<String>, PathBuf)>,
    /// Results of your own planner, compared and not run: a table or an IOHanalyzer file; ID= says on which map, where the file does not;
    /// may be repeated
    #[arg(long, value_name = "ID=FILE", value_parser = super::question::named_map)]
    pub results: Vec<(Option<String>, PathBuf)>,
}

impl Args {
    /// What the files are called.
    fn name(&self) -> String {
        let stem = |file: &PathBuf| file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        self.ablate.as_ref().map_or_else(|| self.question.as_ref().map_or_else(String::new, stem), |id| format!("ablation-{id}"))
    }

    /// What is asked, as the arguments say it.
    pub fn asked(&self) -> String {
        let file = |file: &PathBuf| file.display().to_string();
        self.ablate.as_ref().map_or_else(|| self.question.as_ref().map_or_else(String::new, file), |id| format!("--ablate {id}"))
    }
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let (comparison, before) = load(args)?;
    let name = args.name();
    let (mut journal, kept) = Journal::open(args.out.join(&name).with_extension("partial"), &comparison)?;
    let done = run_all(args, &comparison, &mut journal, kept)?;
    let rows = comparison.all_rows(&done);
    let analysis = analysis::whole(&Samples::new(&comparison, rows.iter().map(Seen::from)), &mut Intervals::default());
    let mut said = format!("{}: {}\n", comparison.question.title, text::count(rows.len() as u64, "run", "runs"));
    said += &report::verdicts(&comparison, &analysis.judged);
    said += &report::components(&comparison, &effects(&comparison, &rows));
    let (command, document) = (command(args), |with_rows| document::write(&comparison, &done, with_rows));
    let reports = Reports { comparison: &comparison, rows: &rows, analysis: &analysis, command: &command, document: &document };
    for (ending, file) in &args.files {
        let path = args.out.join(&name).with_extension(ending);
        replace(&path, &reports.contents(*file))?;
        said += &format!("wrote {}\n", path.display());
    }
    journal.close()?;
    let verification = before.map(|before| before.verify(&comparison, &done));
    let fine = !verification.as_ref().is_some_and(|v| v.refuted);
    said += &verification.map_or_else(String::new, |v| verified(&v));
    Ok(Outcome { text: said, fine })
}

/// A kind of `--files`, with the ending of its name.
fn result_file(text: &str) -> Result<(&'static str, ResultFile), String> {
    let named = ResultFile::NAMED.iter().find(|(id, ..)| *id == text);
    let all = || ResultFile::NAMED.map(|(id, ..)| id).join(", ");
    named.map(|&(_, ending, file)| (ending, file)).ok_or_else(|| format!("choose from {}", all()))
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

fn jobs(args: &Args) -> usize {
    let cores = || thread::available_parallelism().map_or(1, NonZero::get);
    args.jobs.map_or_else(cores, usize::from)
}

/// Does every run that is not kept from before; rows in the order of the tasks, whoever finishes first.
fn run_all(args: &Args, comparison: &Comparison, journal: &mut Journal, kept: Vec<Row>) -> Result<Vec<Row>, CliError> {
    let all = comparison.tasks();
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
                while take().is_some_and(|&task| sender.send(comparison.run(task, &mut || 0.0)).is_ok()) {}
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
    let mut said = format!("formicarium compare {} --out DIR", args.asked());
    args.preset.iter().for_each(|name| said += &format!(" --preset {name}"));
    args.set.iter().for_each(|(key, value)| said += &format!(" --set {key}={value}"));
    args.seeds.iter().for_each(|n| said += &format!(" --seeds {n}"));
    args.budget.iter().for_each(|b| said += &format!(" --budget {b}"));
    args.only.iter().for_each(|id| said += &format!(" --only {id}"));
    let name = |file: &Path| file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let id = |id: &Option<String>| id.as_ref().map_or_else(String::new, |id| format!("{id}="));
    args.map.iter().for_each(|(of, file)| said += &format!(" --map {}{}", id(of), name(file)));
    args.results.iter().for_each(|(of, file)| said += &format!(" --results {}{}", id(of), name(file)));
    said
}

/// Writes beside the place first, so that a file is the old or the new one, whatever happens.
fn replace(path: &Path, contents: &str) -> Result<(), CliError> {
    let staging = path.with_extension(format!("{}.new", path.extension().unwrap_or_default().to_string_lossy()));
    let folder = path.parent().map_or(Ok(()), std::fs::create_dir_all);
    let written = folder.and_then(|()| std::fs::write(&staging, contents)).and_then(|()| std::fs::rename(&staging, path));
    written.map_err(|error| CliError::File { action: "write", path: path.display().to_string(), error })
}
