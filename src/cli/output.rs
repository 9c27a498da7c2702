//! Writing files: whole, or not at all.
//!
//! A file is written under another name in the same folder and then renamed, so that whoever reads it, and whoever has to live with a full
//! disk, finds the old file or the new one. Renaming puts a file in the place of a symbolic link; it does not follow it.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::Path;

use tempfile::NamedTempFile;

use super::error::CliError;
use super::streams;

/// How the names of files begin that are not whole yet.
pub const UNFINISHED: &str = ".formicarium-";

/// How they end.
pub const UNFINISHED_END: &str = ".tmp";

/// Writes a file, or to standard output where there is no name, or `-`.
pub fn write(path: Option<&Path>, bytes: &[u8]) -> Result<(), CliError> {
    match path {
        Some(path) if path != Path::new("-") => put(path, bytes, UNFINISHED),
        _ => streams::print(bytes),
    }
}

/// Whether a file can be written, as far as that can be told before there is anything to write.
pub fn check(path: Option<&Path>) -> Result<(), CliError> {
    match path {
        Some(path) if path != Path::new("-") => check_file(path, UNFINISHED),
        _ => Ok(()),
    }
}

/// The same of a file that [`put`] is to write with this `unfinished`: what a killed process leaves of the trial begins so too.
pub fn check_file(path: &Path, unfinished: &str) -> Result<(), CliError> {
    try_out(path, unfinished).map_err(|error| failure(path, error))
}

/// Writes a file; until it is whole, its name begins with `unfinished`.
pub fn put(path: &Path, bytes: &[u8], unfinished: &str) -> Result<(), CliError> {
    let written = if is_device(path) { write_to_device(path, bytes) } else { replace(path, bytes, unfinished) };
    written.map_err(|error| failure(path, error))
}

/// A failure to write.
pub fn failure(path: &Path, error: io::Error) -> CliError {
    CliError::File { action: "write", path: path.display().to_string(), error }
}

/// A new file beside another one, with the permissions that any new file has. It goes when it is dropped before it has got its name.
pub fn beside(path: &Path, unfinished: &str) -> io::Result<NamedTempFile> {
    // Opened here, because the library's own files are their owner's alone.
    let open = |path: &Path| OpenOptions::new().read(true).write(true).create_new(true).open(path);
    tempfile::Builder::new().prefix(unfinished).suffix(UNFINISHED_END).make_in(folder(path), open)
}

/// The folder of a file.
pub fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

fn replace(path: &Path, bytes: &[u8], unfinished: &str) -> io::Result<()> {
    let old = existing(path)?;
    let mut file = beside(path, unfinished)?;
    file.as_file_mut().write_all(bytes)?;
    if let Some(old) = old.filter(fs::Metadata::is_file) {
        // Who may read a file does not change because its contents do.
        file.as_file().set_permissions(old.permissions())?;
    }
    file.as_file().sync_all()?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

fn try_out(path: &Path, unfinished: &str) -> io::Result<()> {
    existing(path)?;
    if is_device(path) { Ok(()) } else { beside(path, unfinished).map(drop) }
}

/// What is there already, if it may be replaced.
fn existing(path: &Path) -> io::Result<Option<fs::Metadata>> {
    match fs::symlink_metadata(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
        Ok(found) if found.is_dir() => Err(ErrorKind::IsADirectory.into()),
        Ok(found) if found.is_file() && found.permissions().readonly() => Err(ErrorKind::PermissionDenied.into()),
        Ok(found) => Ok(Some(found)),
    }
}

/// A pipe, a terminal, or a link of the system to one (`/dev/stdout`, `/dev/fd/3`): there is nothing to replace.
fn is_device(path: &Path) -> bool {
    let Ok(found) = fs::symlink_metadata(path) else { return false };
    if !found.is_symlink() {
        return !found.is_file() && !found.is_dir();
    }
    let home = folder(path).canonicalize().unwrap_or_default();
    home == Path::new("/dev") || home.starts_with("/proc")
}

/// Adds to whatever stands behind it: what `>>` has opened keeps what it has.
fn write_to_device(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut device: File = OpenOptions::new().append(true).open(path)?;
    match device.write_all(bytes).and_then(|()| device.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => written,
    }
}
