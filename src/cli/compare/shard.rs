//! `--shard`: one part of a comparison's runs, kept in a journal.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use super::args::Args;
use super::journal::{self, Journal};
use super::{recheck, runs};
use crate::cli::error::CliError;
use crate::cli::output::failure;
use crate::cli::streams::say;
use crate::cli::{Outcome, text};
use crate::comparison::{Comparison, Row, Shard, Task};
use crate::formats::journal::{Found, JournalLines};

/// Does a shard's runs that are not done yet. Its journal gets its name when all are.
pub fn run(args: &Args, comparison: &Comparison, shard: Shard) -> Result<Outcome, CliError> {
    let lines = JournalLines::of(comparison, Some(shard));
    let asked = asked(args, comparison, shard, &lines);
    if asked.is_empty() {
        say(format!("note: there are fewer runs than shards: {} of {}", comparison.task_count(), shard.of()));
    }
    let place = args.place_of(shard, lines.digest());
    let whole = place.file("journal");
    fs::create_dir_all(args.folder()).map_err(|error| failure(args.folder(), error))?;
    let Some(earlier) = earlier(&whole, &lines, &asked)? else { return Ok(already(shard, &whole)) };
    let (mut journal, kept) = Journal::open(&place, lines, !args.no_wait)?;
    place.sweep();
    let lines = JournalLines::of(comparison, Some(shard));
    // Whoever had the journal before may have finished it meanwhile.
    if kept.is_empty() && self::earlier(&whole, &lines, &asked)?.is_none() {
        journal.close()?;
        return Ok(already(shard, &whole));
    }
    let mut done: BTreeSet<Task> = kept.iter().map(|row| row.task).collect();
    for row in earlier.into_iter().filter(|row| !done.contains(&row.task)).collect::<Vec<_>>() {
        journal.note(&row)?;
        done.insert(row.task);
    }
    let tasks: Vec<Task> = asked.iter().copied().filter(|task| !done.contains(task)).collect();
    runs::run_all(args, comparison, &tasks, done.len(), |row| journal.note(&row))?;
    journal.finish(&whole)?;
    let runs = text::count(asked.len() as u64, "run", "runs");
    let before = if done.is_empty() { String::new() } else { format!(", {} from before", done.len()) };
    Ok(Outcome::fine(format!("shard {shard}: {runs}{before}\nwrote {}\n", whole.display())))
}

/// What the journals of so many shards are called, one a line.
pub fn names(args: &Args, comparison: &Comparison, of: u32) -> String {
    let digest = comparison.digest().hex();
    let shards = (1..=of).filter_map(|index| Shard::new(index, of).ok());
    let name = |shard| args.place_of(shard, &digest).file("journal").file_name().map(|name| name.to_string_lossy().into_owned());
    shards.filter_map(name).map(|name| name + "\n").collect()
}

/// The runs of a shard, and with `--recheck` some of the next one's.
fn asked(args: &Args, comparison: &Comparison, shard: Shard, lines: &JournalLines) -> BTreeSet<Task> {
    let others = match args.recheck {
        Some(share) if shard.of() > 1 => recheck::spread(&comparison.dealt(shard.next()), share),
        _ => Vec::new(),
    };
    comparison.dealt(shard).into_iter().chain(others).map(|place| lines.tasks()[place]).collect()
}

fn already(shard: Shard, whole: &Path) -> Outcome {
    Outcome::fine(format!("shard {shard} is whole already: {}\n", whole.display()))
}

/// The runs of a journal that has its name and yet not all that is asked, or lines that do not hold: a disk may have damaged it, or more is
/// asked than before. None where it is whole.
fn earlier(path: &Path, lines: &JournalLines, asked: &BTreeSet<Task>) -> Result<Option<Vec<Row>>, CliError> {
    let Some(bytes) = contents(path)? else { return Ok(Some(Vec::new())) };
    if !lines.is_journal(&bytes) {
        return Err(journal::refused(path));
    }
    let Found::Ours { rows, whole, .. } = lines.read(&bytes) else {
        journal::set_aside(path, "of another version")?;
        return Ok(Some(Vec::new()));
    };
    let has: BTreeSet<Task> = rows.iter().map(|row| row.task).collect();
    if whole == bytes.len() && asked.is_subset(&has) {
        return Ok(None);
    }
    say(format!("note: {} does not have all that is asked, or does not hold: it is gone on with", path.display()));
    Ok(Some(rows))
}

/// What a file holds; none where there is no file.
fn contents(path: &Path) -> Result<Option<Vec<u8>>, CliError> {
    if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        return Err(journal::refused(path));
    }
    match fs::read(path) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
        read => read.map(Some).map_err(|error| CliError::File { action: "read", path: path.display().to_string(), error }),
    }
}
