//! The runs of a comparison, on all cores.

use std::collections::BTreeSet;
use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use crate::comparison::{Comparison, Row, Task};
use indicatif::{ProgressBar, ProgressStyle};

use super::args::Args;
use super::journal::Journal;
use crate::cli::error::CliError;

fn jobs(args: &Args) -> usize {
    let cores = || thread::available_parallelism().map_or(1, NonZero::get);
    args.jobs.map_or_else(cores, usize::from)
}

/// Does every run that is not kept from before. The rows are in the order of the tasks, not in that in which they finish.
pub fn run_whole(args: &Args, comparison: &Comparison, journal: &mut Journal, kept: Vec<Row>) -> Result<Vec<Row>, CliError> {
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
    run_all(args, comparison, &tasks, done.len(), |row| {
        journal.note(&row)?;
        place(row);
        Ok(())
    })?;
    Ok(rows.into_iter().flatten().collect())
}

/// Does these runs and hands over each when it ends; `kept`: how many are there from before.
pub fn run_all(
    args: &Args,
    comparison: &Comparison,
    tasks: &[Task],
    kept: usize,
    mut done: impl FnMut(Row) -> Result<(), CliError>,
) -> Result<(), CliError> {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..jobs(args).min(tasks.len()) {
            let (sender, next) = (sender.clone(), &next);
            scope.spawn(move || {
                let take = || tasks.get(next.fetch_add(1, Ordering::Relaxed));
                // A closed channel: an error has ended the whole.
                while take().is_some_and(|&task| sender.send(comparison.run(task, &mut || 0.0)).is_ok()) {}
            });
        }
        drop(sender);
        let (bar, mut without_path) = (bar(kept, kept + tasks.len()), 0);
        for row in receiver {
            let row = row.map_err(|e| args.wrong(e))?.row;
            without_path += usize::from(row.found.is_none());
            done(row)?;
            bar.set_message(beside(kept, without_path));
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(())
    })
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
