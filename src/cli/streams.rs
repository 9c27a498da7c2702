//! Standard output and the error stream.

use std::cell::RefCell;
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

thread_local! {
    /// What is said while somebody listens; none while nobody does.
    static HEARD: RefCell<Option<Vec<String>>> = const { RefCell::new(None) };
}

/// Says something: to whoever listens on this thread, else on the error stream. Nobody can be told where that fails, and `eprintln!` would
/// panic.
pub fn say(line: impl Display) {
    let line = harmless(&line.to_string());
    let unheard = HEARD.with_borrow_mut(|heard| match heard {
        Some(heard) => {
            heard.push(line);
            None
        }
        None => Some(line),
    });
    if let Some(line) = unheard {
        let _ = writeln!(io::stderr().lock(), "{line}");
    }
}

/// Does something, and gives what it said on this thread instead of saying it.
pub fn heard<T>(work: impl FnOnce() -> T) -> (T, Vec<String>) {
    let before = HEARD.replace(Some(Vec::new()));
    let done = work();
    (done, HEARD.replace(before).unwrap_or_default())
}

/// A text without signs that would command a terminal: names in files may hold any.
pub fn harmless(text: &str) -> String {
    let is_meant = |c: char| !c.is_control() || matches!(c, '\n' | '\t');
    text.chars().map(|c| if is_meant(c) { c } else { '\u{fffd}' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_listens_hears_what_is_said_meanwhile() {
        let (inner, outer) = heard(|| {
            say("note: one");
            heard(|| say("note: two\u{1b}")).1
        });
        assert_eq!((inner, outer), (vec!["note: two\u{fffd}".to_owned()], vec!["note: one".to_owned()]));
    }
}
