//! `tracker check`: every entry is repeated.

use std::fmt::Write as _;
use std::path::Path;

use crate::cli::error::CliError;
use crate::cli::input;
use crate::cli::{Outcome, text};
use crate::comparison::best_known::{check_bound, same};

use super::Where;
use super::entry::Entry;
use super::folder::Tracked;
use super::proof::Proof;

/// Repeats every entry: runs are run again, paths are walked, values compared
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    tracker: Where,
    /// Only these scenarios; may be repeated
    #[arg(long, value_name = "ID")]
    only: Vec<String>,
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let tracker = args.tracker.open()?;
    args.only.iter().try_for_each(|id| tracker.scenario(id).map(drop))?;
    let (mut out, mut count, mut refused) = (String::new(), 0, 0);
    for stray in tracker.strays() {
        refused += 1;
        let _ = writeln!(out, "refused: entries/{stray}: the tracker has no scenario of this id");
    }
    for tracked in tracker.scenarios.iter().filter(|tracked| args.only.is_empty() || args.only.contains(&tracked.id)) {
        for file in tracker.files(&tracked.id)? {
            count += 1;
            if let Err(error) = check(&file, tracked) {
                refused += 1;
                let report = error.report();
                let name = format!("{}/{}", tracked.id, input::file_name(&file));
                let _ = writeln!(out, "refused: {name}: {}: {}\n  hint: {}", report.field, report.message, report.hint);
            }
        }
    }
    let _ = writeln!(out, "{} repeated, {refused} refused", text::count(count, "entry", "entries"));
    Ok(Outcome { text: out, fine: refused == 0 })
}

/// Reads an entry and repeats it.
pub fn check(file: &Path, tracked: &Tracked) -> Result<Entry, CliError> {
    let entry = Entry::read(file)?;
    // What cannot be needs no run.
    check_bound(entry.value, tracked.reference(entry.objective))?;
    let measured = Proof::of(&entry)?.measure(tracked, &entry.planner)?;
    same("objective", &entry.objective, &measured.objective)?;
    same("value", &entry.value, &measured.value)?;
    Ok(entry)
}
