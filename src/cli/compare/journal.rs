//! The journal of a comparison: every finished run, written down at once, so that a comparison that was broken off goes on where it was.
//!
//! First a line that says which comparison it belongs to, then one line of JSON a run, in the order in which they finished. A line counts
//! once its end is there; what a killed process has left of a line is cut off. The journal goes when the results stand.

use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

use formicarium::comparison::{Comparison, Row};

use crate::cli::error::CliError;

/// An open journal.
pub struct Journal {
    path: PathBuf,
    file: File,
}

impl Journal {
    /// Opens the journal beside a comparison's results and gives the runs that it holds. One of another comparison, engine version or
    /// format is begun anew.
    pub fn open(path: PathBuf, comparison: &Comparison) -> Result<(Self, Vec<Row>), CliError> {
        let head = head(comparison);
        let kept = kept(&path)?;
        let (rows, length) = read(&kept, &head);
        let journal = begin(&path, &head, length).map_err(|error| failure(&path, error))?;
        Ok((Self { path, file: journal }, rows))
    }

    /// Writes a run down.
    pub fn note(&mut self, row: &Row) -> Result<(), CliError> {
        let line = row.to_line() + "\n";
        self.file.write_all(line.as_bytes()).map_err(|error| failure(&self.path, error))
    }

    /// Removes it: the results stand.
    pub fn close(self) -> Result<(), CliError> {
        drop(self.file);
        std::fs::remove_file(&self.path).map_err(|error| failure(&self.path, error))
    }
}

fn failure(path: &Path, error: std::io::Error) -> CliError {
    CliError::File { action: "write", path: path.display().to_string(), error }
}

/// What an earlier start has left; nothing where there is no journal.
fn kept(path: &Path) -> Result<Vec<u8>, CliError> {
    match std::fs::read(path) {
        Ok(bytes) => Ok(bytes),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Vec::new()),
        Err(error) => Err(CliError::File { action: "read", path: path.display().to_string(), error }),
    }
}

/// What the first line says.
fn head(comparison: &Comparison) -> String {
    let (version, digest) = (env!("CARGO_PKG_VERSION"), comparison.digest().hex());
    format!(r#"{{"format":"formicarium/journal@1","engine":"{version}","experiment":"{digest}"}}"#) + "\n"
}

/// The runs of a journal with this head, and how many of its bytes are whole lines; nothing of any other.
fn read(bytes: &[u8], head: &str) -> (Vec<Row>, usize) {
    let Some(lines) = bytes.strip_prefix(head.as_bytes()) else { return (Vec::new(), 0) };
    let mut rows = Vec::new();
    let mut length = head.len();
    for line in lines.split_inclusive(|&b| b == b'\n').filter(|line| line.ends_with(b"\n")) {
        let Ok(row) = serde_json::from_slice(line) else { break };
        rows.push(row);
        length += line.len();
    }
    (rows, length)
}

/// The file with its first `length` bytes, ready to be added to; with nothing but the head where that is nothing.
fn begin(path: &Path, head: &str, length: usize) -> std::io::Result<File> {
    path.parent().map_or(Ok(()), std::fs::create_dir_all)?;
    let mut file = OpenOptions::new().create(true).append(true).open(path)?;
    file.set_len(length as u64)?;
    if length == 0 {
        file.write_all(head.as_bytes())?;
    }
    Ok(file)
}
