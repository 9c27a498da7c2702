//! The journal of a comparison: every finished run, written down at once, so that a comparison that was broken off goes on where it was.
//!
//! Whoever has the journal has the name: the file is locked as long as runs are added and results are written, and a second process waits.
//! The system takes the lock back when a process dies. The journal goes when the results stand. What is in its way but no journal of this
//! comparison is never emptied: another comparison's is set aside, anything else is refused.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::place::Place;
use crate::cli::error::CliError;
use crate::cli::output::{beside, failure};
use crate::cli::streams::say;
use crate::cli::text;
use crate::comparison::Row;
use crate::formats::journal::{Found, JournalLines};

/// As much of a file as tells whether it is a journal.
const BEGINNING: u64 = 1 << 20;

/// An open, locked journal.
pub struct Journal {
    path: PathBuf,
    file: File,
    lines: JournalLines,
}

impl Journal {
    /// Opens the journal beside a comparison's results and gives the runs that it holds. While another process has it, waits, or fails.
    pub fn open(place: &Place, lines: JournalLines, wait: bool) -> Result<(Self, Vec<Row>), CliError> {
        let path = place.file("partial");
        loop {
            let mut file = taken(place, &path, &lines, wait)?;
            let bytes = contents(&path, &mut file, &lines)?;
            match lines.read(&bytes) {
                Found::Ours { rows, damaged, whole } => {
                    tell_of_damage(&path, damaged);
                    let file = match whole {
                        0 => anew(place, &path, &lines, &rows)?,
                        _ => cut(file, whole as u64).map_err(|error| failure(&path, error))?,
                    };
                    return Ok((Self { path, file, lines }, rows));
                }
                Found::Other => set_aside(&path, "of another comparison or version")?,
                Found::Unchecked => set_aside(&path, "of an older version, whose lines cannot be checked")?,
            }
        }
    }

    /// Writes a run down.
    pub fn note(&mut self, row: &Row) -> Result<(), CliError> {
        self.file.write_all(self.lines.line(row).as_bytes()).map_err(|error| failure(&self.path, error))
    }

    /// Gives it the name of a whole one, whose bytes have reached the disk.
    pub fn finish(self, name: &Path) -> Result<(), CliError> {
        if !is_at(&self.file, &self.path) {
            let message = format!("{} was removed or replaced while runs were added to it", self.path.display());
            return Err(CliError::usage(message, "start the shard again: what is left of its runs is not done twice"));
        }
        self.file.sync_all().and_then(|()| fs::rename(&self.path, name)).map_err(|error| failure(name, error))
    }

    /// Removes it, and then lets others have the name: the results stand. What somebody has put in its place is theirs.
    pub fn close(self) -> Result<(), CliError> {
        if !is_at(&self.file, &self.path) {
            return Ok(());
        }
        fs::remove_file(&self.path).map_err(|error| failure(&self.path, error))
    }
}

/// The locked file under the journal's name; a new one where there is none.
fn taken(place: &Place, path: &Path, lines: &JournalLines, wait: bool) -> Result<File, CliError> {
    let failed = |error| failure(path, error);
    loop {
        match fs::symlink_metadata(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => match begun(place, path, &lines.head()).map_err(failed)? {
                Some(file) => return Ok(file),
                None => continue,
            },
            Err(error) => return Err(failed(error)),
            Ok(found) if !found.is_file() => return Err(refused(path)),
            Ok(_) => {}
        }
        let file = match OpenOptions::new().read(true).write(true).open(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => continue,
            opened => opened.map_err(failed)?,
        };
        lock(&file, path, wait)?;
        // Whoever had it may have removed or replaced it meanwhile.
        if is_at(&file, path) {
            return Ok(file);
        }
    }
}

/// A new journal, locked before it gets its name; none where somebody else was faster.
fn begun(place: &Place, path: &Path, text: &str) -> std::io::Result<Option<File>> {
    let mut new = beside(path, &place.unfinished())?;
    tried(new.as_file().try_lock())?;
    new.as_file_mut().write_all(text.as_bytes())?;
    match new.persist_noclobber(path) {
        Ok(file) => Ok(Some(file)),
        Err(error) if error.error.kind() == ErrorKind::AlreadyExists || path.exists() => Ok(None),
        Err(error) => Err(error.error),
    }
}

/// The journal with these runs alone, in the place of what is there.
fn anew(place: &Place, path: &Path, lines: &JournalLines, rows: &[Row]) -> Result<File, CliError> {
    let write = || {
        let mut new = beside(path, &place.unfinished())?;
        tried(new.as_file().try_lock())?;
        let text = lines.head() + &rows.iter().map(|row| lines.line(row)).collect::<String>();
        new.as_file_mut().write_all(text.as_bytes())?;
        new.as_file().sync_all()?;
        new.persist(path).map_err(|error| error.error)
    };
    write().map_err(|error| failure(path, error))
}

/// The file with its first bytes alone, ready to be added to.
fn cut(mut file: File, length: u64) -> std::io::Result<File> {
    file.set_len(length)?;
    file.seek(SeekFrom::Start(length))?;
    Ok(file)
}

/// What a journal holds; what is none is refused after its beginning.
fn contents(path: &Path, file: &mut File, lines: &JournalLines) -> Result<Vec<u8>, CliError> {
    let unread = |error| CliError::File { action: "read", path: path.display().to_string(), error };
    let mut bytes = Vec::new();
    file.seek(SeekFrom::Start(0)).map_err(unread)?;
    file.take(BEGINNING).read_to_end(&mut bytes).map_err(unread)?;
    if !lines.is_journal(&bytes) {
        return Err(refused(path));
    }
    file.read_to_end(&mut bytes).map_err(unread)?;
    Ok(bytes)
}

/// Refuses a file that is in a journal's way and is none.
pub fn refused(path: &Path) -> CliError {
    let message = format!("{} is no journal of this program: it is left as it is", path.display());
    CliError::usage(message, "the runs would be kept under this name: move the file away, or choose another folder with --out")
}

fn tell_of_damage(path: &Path, damaged: usize) {
    if damaged > 0 {
        let lines = text::count(damaged as u64, "damaged line", "damaged lines");
        say(format!("note: {}: {lines} dropped; those runs are done again", path.display()));
    }
}

/// Gives a journal the first name that is free.
pub fn set_aside(path: &Path, what: &str) -> Result<(), CliError> {
    let numbered = |n: u32| {
        let mut name = path.as_os_str().to_owned();
        name.push(format!(".{n}"));
        PathBuf::from(name)
    };
    let is_free = |path: &PathBuf| fs::symlink_metadata(path).is_err_and(|error| error.kind() == ErrorKind::NotFound);
    let Some(aside) = (1..=u32::MAX).map(numbered).find(is_free) else { return Err(refused(path)) };
    fs::rename(path, &aside).map_err(|error| failure(path, error))?;
    say(format!("note: {} is a journal {what}: it is kept as {}", path.display(), aside.display()));
    Ok(())
}

/// Locks the journal; where another process has it, waits for that.
fn lock(file: &File, path: &Path, wait: bool) -> Result<(), CliError> {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) if !wait => {
            let message = format!("another process is comparing under this name: {} is its journal", path.display());
            Err(CliError::usage(message, "leave out --no-wait to wait for it, or choose another folder with --out"))
        }
        Err(TryLockError::WouldBlock) => {
            say(format!("note: another process is comparing under this name ({}): waiting for it", path.display()));
            file.lock().map_err(|error| failure(path, error))
        }
        locked => tried(locked).map_err(|error| failure(path, error)),
    }
}

/// A file system without locks is used without them.
fn tried(locked: Result<(), TryLockError>) -> std::io::Result<()> {
    match locked {
        Err(TryLockError::Error(error)) if error.kind() != ErrorKind::Unsupported => Err(error),
        Err(TryLockError::WouldBlock) => Err(ErrorKind::WouldBlock.into()),
        _ => Ok(()),
    }
}

/// Whether an open file is the one with this name.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let same = |a: fs::Metadata, b: fs::Metadata| (a.dev(), a.ino()) == (b.dev(), b.ino());
    file.metadata().ok().zip(fs::symlink_metadata(path).ok()).is_some_and(|(open, named)| same(open, named))
}

/// Whether there is a file with this name at all: elsewhere than on Unix nothing tells more.
#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    path.exists()
}
