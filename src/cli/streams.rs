//! Standard output and the error stream.

use std::fmt::Display;
use std::io::{self, ErrorKind, Write};

use super::error::CliError;

/// Prints a result. A reader that has seen enough (`| head`) is no error; a full disk is.
pub fn print(bytes: &[u8]) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    heeded(out.write_all(bytes).and_then(|()| out.flush()))
}

/// What is left of a failure to print.
pub fn heeded(printed: io::Result<()>) -> Result<(), CliError> {
    match printed {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(CliError::File { action: "write", path: "standard output".into(), error })
        }
        _ => Ok(()),
    }
}

/// Says something on the error stream. Nobody can be told where that fails, and `eprintln!` would panic.
pub fn say(line: impl Display) {
    let _ = writeln!(io::stderr().lock(), "{}", harmless(&line.to_string()));
}

/// A text without signs that would command a terminal: names in files may hold any.
pub fn harmless(text: &str) -> String {
    let is_meant = |c: char| !c.is_control() || matches!(c, '\n' | '\t');
    text.chars().map(|c| if is_meant(c) { c } else { '\u{fffd}' }).collect()
}
