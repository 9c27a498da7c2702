//! Results of runs that were made elsewhere: what somebody's own planner has found, to be compared with what is run here.
//!
//! [`import_results`] reads tables with a header (`table`) and the data files of IOHanalyzer (`ioh`). Nothing here knows which maps the
//! runs belong to: [`crate::comparison::imported`] joins them to a question. docs/formats.md lists the columns.

mod columns;
mod ioh;
mod run;
mod table;
mod template;

use super::text::{self, quote};
use crate::comparison::MAX_COUNT;
use crate::comparison::imported::{ImportedResults, ImportedStep};
use crate::comparison::names::stem;
use crate::error::{FormatError, Notice};
use crate::planner::Status;

pub use template::results_table;

/// Most lines of a file.
pub const MAX_ROWS: usize = 1_000_000;

/// Most entries of a file.
pub const MAX_ENTRIES: usize = 100;

/// Most maps of a file.
pub const MAX_INSTANCES: usize = 1000;

/// Longest line in bytes: a text of 64 MiB on one line would have millions of columns.
const LONGEST_LINE: usize = 1 << 20;

/// Longest name of an entry or an instance, in letters; the rest is cut off.
const LONGEST_NAME: usize = 80;

/// What reads as "no path was found" where a length is expected, in small letters.
const MISSING: [&str; 12] = ["", "-", "–", "inf", "+inf", "infinity", "∞", "nan", "na", "n/a", "none", "null"];

/// Reads the results of runs: a table with one line a run or one line an improvement, or a data file of IOHanalyzer.
///
/// # Errors
/// [`FormatError`] with the line, the column and the value at fault, for more than a million lines or a hundred entries, and for what is no
/// text of at most 64 MiB.
pub fn import_results(bytes: &[u8], name: &str) -> Result<ImportedResults, FormatError> {
    let text = text::decode(bytes)?;
    let text = text.trim_end_matches('\u{1a}');
    // A lone CR ends lines as well; the readers below know LF and CRLF.
    let unified = if text.contains('\n') { None } else { Some(text.replace('\r', "\n")) };
    let text = unified.as_deref().unwrap_or(text);
    if let Some((line, _)) = text::lines(text).find(|(_, line)| line.len() > LONGEST_LINE) {
        let expected = "a line of column names, then one line a run";
        return Err(FormatError::syntax(line, format!("the line has more than {LONGEST_LINE} bytes"), expected));
    }
    let mut results = if ioh::looks_like(text) { ioh::read(text, name)? } else { table::read(text, name)? };
    if results.entries.iter().flat_map(|entry| &entry.runs).all(|run| run.steps.is_empty()) {
        results.notices.push(Notice::new("results-no-path", "no run of the file has a path: their lengths are left open"));
    }
    Ok(results)
}

/// Whether a text begins as such a file does: with a line of column names, one of them a length or a value.
pub(super) fn looks_like(text: &str) -> bool {
    ioh::looks_like(text) || columns::looks_like(text)
}

/// A name as it may stand in a table: on one line, not endless; the file's where there is none.
fn label(text: &str, file: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    let short: String = words.join(" ").chars().filter(|c| !c.is_control()).take(LONGEST_NAME).collect();
    match short.as_str() {
        "" if stem(file).trim().is_empty() => "results".into(),
        "" => stem(file).trim().chars().take(LONGEST_NAME).collect(),
        _ => short,
    }
}

/// A name made of a to z, 0 to 9 and `-` alone.
fn plain(label: &str) -> String {
    let mut id = String::new();
    for letter in label.chars().map(|c| c.to_ascii_lowercase()) {
        match letter {
            'a'..='z' | '0'..='9' => id.push(letter),
            _ if !id.is_empty() && !id.ends_with('-') => id.push('-'),
            _ => {}
        }
    }
    let id = id.trim_end_matches('-');
    if id.is_empty() { "results".into() } else { id.into() }
}

/// How a run ended that does not say so.
fn ended(steps: &[ImportedStep]) -> Status {
    if steps.is_empty() { Status::BudgetSpent } else { Status::Complete }
}

/// A number of at least 0, or none for what means that there is no path.
fn measured(text: &str) -> Result<Option<f64>, &'static str> {
    const ALLOWED: &str = "a number of at least 0 with a decimal point, or nothing, inf or nan for a run without a path";
    match text.parse() {
        Ok(value) if f64::is_finite(value) && value >= 0.0 => Ok(Some(value)),
        _ if MISSING.contains(&text.to_lowercase().as_str()) => Ok(None),
        _ => Err(ALLOWED),
    }
}

/// A whole number up to [`MAX_COUNT`], or none where nothing stands; `100.0` and `1e3` are whole as well.
fn counted(text: &str) -> Result<Option<u64>, &'static str> {
    const TOO_LARGE: &str = "a whole number of at most 9007199254740992, which is 2^53: larger ones are not told apart";
    // Digits alone are read as they are: as a float 2⁵³ + 1 would be 2⁵³.
    if let Ok(count) = text.parse::<u64>() {
        return if count <= MAX_COUNT { Ok(Some(count)) } else { Err(TOO_LARGE) };
    }
    match measured(text) {
        Ok(Some(v)) if v >= MAX_COUNT as f64 => Err(TOO_LARGE),
        Ok(Some(v)) if v.fract() == 0.0 => Ok(Some(v as u64)),
        Ok(None) => Ok(None),
        _ => Err("a whole number of at least 0, or nothing where it is not known"),
    }
}

/// A field that cannot be used.
fn cell(line: usize, column: &str, value: &str, expected: &str) -> FormatError {
    FormatError::Cell { line, column: quote(column), value: quote(value), expected: expected.into() }
}

/// More lines than are read.
fn too_many_rows(line: usize) -> FormatError {
    FormatError::syntax(line, format!("the file has more than {MAX_ROWS} lines"), format!("at most {MAX_ROWS} lines"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_plain() {
        for (label, id) in [("My ACO (v2)", "my-aco-v2"), ("蚁群算法", "results"), ("--", "results"), ("A_b", "a-b")] {
            assert_eq!(plain(label), id);
        }
        assert_eq!(
            (label("  a\n b ", "f.csv"), label("", "d/f.csv"), label("", "")),
            ("a b".into(), "f".into(), "results".into())
        );
        assert_eq!(label(&"x".repeat(200), "").len(), LONGEST_NAME);
    }

    #[test]
    fn numbers_as_programs_print_them() {
        for (text, value) in
            [("34.5", Some(34.5)), ("+2.95000e+02", Some(295.0)), ("NaN", None), ("Inf", None), ("", None), ("0", Some(0.0))]
        {
            assert_eq!(measured(text), Ok(value), "{text}");
        }
        for text in ["-1", "-inf", "abc", "1,5", "1e999", "0x10"] {
            assert!(measured(text).is_err(), "{text}");
        }
        assert_eq!((counted("1e3"), counted("7.0"), counted("")), (Ok(Some(1000)), Ok(Some(7)), Ok(None)));
        assert!(counted("7.5").is_err());
        assert_eq!((counted("+9007199254740992"), counted("9007199254740991.0")), (Ok(Some(MAX_COUNT)), Ok(Some(MAX_COUNT - 1))));
        for text in ["9007199254740993", "9007199254740993.0", "1e17", "18446744073709551616"] {
            assert!(counted(text).unwrap_err().contains(&MAX_COUNT.to_string()), "{text}");
        }
    }
}
