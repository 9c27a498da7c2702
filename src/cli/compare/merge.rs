//! `--merge`: the runs of many journals as if one process had done them all, or what keeps them from it.

mod gathered;
mod tell;

use std::fs::{self, File};
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

use super::args::Args;
use super::recheck;
use crate::cli::error::CliError;
use crate::comparison::{Comparison, Row};
use crate::formats::journal::{JournalFault, JournalLines};

pub use gathered::Gathered;

/// The endings of journals' names: whole, or still being written.
const ENDINGS: [&str; 2] = ["journal", "partial"];

/// Longer lines are no runs: what has no ends of lines must not fill the memory.
const LONGEST_LINE: u64 = 64 << 20;

/// All runs of a comparison.
pub struct Merged {
    /// In the order of the tasks.
    pub rows: Vec<Row>,
    /// What is worth saying about the journals.
    pub said: String,
}

/// Reads the journals of a folder. Where they do not make a whole comparison, or some do not hold: everything that is wrong, for the reader.
/// `check` tells whether results can be written, before anything is done again.
pub fn merged(
    args: &Args,
    comparison: &Comparison,
    folder: &Path,
    check: &impl Fn() -> Result<(), CliError>,
) -> Result<Result<Merged, String>, CliError> {
    let mut gathered = Gathered::new(JournalLines::of(comparison, None));
    for path in journals(folder)? {
        read(&path, &mut gathered)?;
    }
    if gathered.is_empty() {
        return Err(nothing(folder));
    }
    if let Some(findings) = tell::findings(args, comparison, &gathered, folder) {
        return Ok(Err(findings));
    }
    check()?;
    let mut said = tell::summary(&gathered);
    if let Some(share) = args.recheck {
        match recheck::recheck(args, comparison, share, &gathered)? {
            Ok(same) => said += &same,
            Err(findings) => return Ok(Err(said + &findings)),
        }
    }
    Ok(Ok(Merged { rows: gathered.into_rows(), said }))
}

/// That there is no journal, and where there are some.
fn nothing(folder: &Path) -> CliError {
    let inside = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let nearby = inside.filter(|path| path.is_dir()).find(|path| journals(path).is_ok_and(|found| !found.is_empty()));
    let hint = match nearby {
        Some(nearby) => format!("there are some in {}", nearby.display()),
        None => format!("`formicarium compare … --shard 1/N --out {}` writes the first one", folder.display()),
    };
    CliError::usage(format!("{}: there is no journal", folder.display()), hint)
}

/// The journals in a folder, by their names.
fn journals(folder: &Path) -> Result<Vec<PathBuf>, CliError> {
    let unread = |error| CliError::File { action: "read", path: folder.display().to_string(), error };
    if folder.is_file() {
        let message = format!("{} is a file", folder.display());
        return Err(CliError::usage(message, "name the folder that the journals are in"));
    }
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(unread)? {
        let path = entry.map_err(unread)?.path();
        let is_journal = path.extension().and_then(|ending| ending.to_str()).is_some_and(|ending| ENDINGS.contains(&ending));
        if is_journal && path.is_file() {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}

fn read(path: &Path, gathered: &mut Gathered) -> Result<(), CliError> {
    let unread = |error| CliError::File { action: "read", path: path.display().to_string(), error };
    let mut file = BufReader::with_capacity(1 << 20, File::open(path).map_err(unread)?);
    let (mut line, mut number) = (Vec::new(), 0);
    gathered.begin(path);
    while next_line(&mut file, &mut line).map_err(unread)? {
        number += 1;
        let ends = line.ends_with(b"\n");
        match number {
            1 => gathered.head(&line),
            _ => gathered.line(number, &line),
        }
        if gathered.is_foreign() || (!ends && line.len() as u64 == LONGEST_LINE) {
            break;
        }
    }
    if number == 0 {
        gathered.fault(0, JournalFault::NoJournal);
    }
    Ok(())
}

fn next_line(file: &mut BufReader<File>, line: &mut Vec<u8>) -> std::io::Result<bool> {
    line.clear();
    file.by_ref().take(LONGEST_LINE).read_until(b'\n', line).map(|read| read > 0)
}
