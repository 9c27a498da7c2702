//! Numbers in rows and columns as people keep them: CSV, blanks, semicolons, MATLAB (`G = [0 1; 1 0];`), Python (`[[0, 1], [1, 0]]`), a
//! whole program in any of the usual languages, what MATLAB or pandas print.
//!
//! [`find`] gives every matrix of a text. Subscripts, comments and brackets of anything but numbers are none.

mod around;
mod brackets;
mod clean;
mod head;
mod labels;
mod lists;
mod plain;
mod scan;
mod spelling;
mod table;

use super::text::quote;
use crate::error::{FormatError, Notice};

pub(super) use head::Ends;
use table::Row;
pub(super) use table::Table;

/// Most matrices that are told apart in one text.
const MAX_MATRICES: usize = 1000;

/// One matrix of a text.
pub(super) struct Found {
    /// What it is called in the text, or nothing.
    pub name: String,
    /// Its numbers.
    pub table: Table,
    /// What was left out or taken apart while reading it.
    pub notices: Vec<Notice>,
    /// Start and goal from lines before the rows, as they stand there.
    pub ends: Option<Ends>,
    /// Names that stood above the columns.
    pub names: Vec<String>,
}

/// How a text holds its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// Nothing but numbers, perhaps with labels, sizes or a title.
    Rows,
    /// Brackets of numbers, in a program or alone.
    Brackets,
}

/// Whether a text looks as if it held numbers in rows and columns, from its beginning.
pub(super) fn looks_like(text: &str) -> Option<Shape> {
    let clean = clean::without_comments(text);
    if spelling::of_r(&clean).is_some() || plain::is_displayed(&clean) {
        return Some(Shape::Rows);
    }
    if brackets::begin(&clean) {
        return Some(Shape::Brackets);
    }
    plain::begins(&clean).then_some(Shape::Rows)
}

/// Every matrix of a text, in its order: at least one.
///
/// # Errors
/// [`FormatError`] with the line of the first thing that is no number, or that the text holds none.
pub(super) fn find(text: &str) -> Result<Vec<Found>, FormatError> {
    let clean = clean::without_comments(text);
    if let Some(rows) = spelling::of_r(&clean) {
        let notice = Notice::new("matrix-labels", "line 1 and the first column were read as labels, not as cells");
        let notice = notice.with("line", 1).with("which", "both");
        return Ok(plain::find(&rows)?.into_iter().map(|found| found.with_notice(notice.clone())).collect());
    }
    let between = if plain::is_displayed(&clean) { None } else { brackets::find(&clean)? };
    let found = match between {
        Some(found) => found,
        None => plain::find(&clean)?,
    };
    if found.is_empty() {
        return Err(FormatError::syntax(0, "the file holds no numbers", "rows of 0 and 1"));
    }
    distinct(found)
}

/// The one matrix of a text, or the one that is asked for, from 1.
///
/// # Errors
/// As [`find`]; [`FormatError::Several`] where nothing says which of them is meant; [`FormatError::Field`] for one that is not there.
pub(super) fn read(text: &str, wanted: Option<u32>) -> Result<Found, FormatError> {
    let mut found = find(text)?;
    let count = found.len();
    let at = match wanted {
        None if count > 1 => return Err(FormatError::Several { found: list(&found) }),
        None => 0,
        Some(number) => number as usize - usize::from(number > 0),
    };
    if at >= count || wanted == Some(0) {
        let what = format!("{} is none of the {count} matrices of the file", wanted.unwrap_or_default());
        return Err(FormatError::field("matrix", what, format!("1 to {count}")));
    }
    let mut one = found.swap_remove(at);
    lists::check(&one.table)?;
    if count > 1 {
        let message = format!("matrix {} of {count} was read: {}", at + 1, one.describe());
        let notice = Notice::new("matrix-chosen", message).with("number", at + 1).with("count", count);
        one.notices.insert(0, notice.with("what", one.describe()));
    }
    Ok(one)
}

/// The rows of a text as they stand there: nothing is taken for labels or sizes. Of several brackets the first.
///
/// # Errors
/// As [`find`].
pub(super) fn rows(text: &str) -> Result<Table, FormatError> {
    let clean = clean::without_comments(text);
    match brackets::find(&clean)?.and_then(|found| found.into_iter().next()) {
        Some(found) => Ok(found.table),
        None => {
            let (clean, _) = spelling::plain(&clean)?;
            scan::scan(&clean, 0, scan::plain_layout(&clean))
        }
    }
}

/// Which matrices there are, as a person would list them.
fn list(found: &[Found]) -> String {
    let mut parts: Vec<_> = found.iter().take(8).enumerate().map(|(i, f)| format!("{}: {}", i + 1, f.describe())).collect();
    if found.len() > parts.len() {
        parts.push(format!("{} more", found.len() - parts.len()));
    }
    parts.join("; ")
}

/// Equal matrices count once: programs repeat their map. How often each stands there is told.
///
/// # Errors
/// [`FormatError::TooLarge`] for more than [`MAX_MATRICES`].
fn distinct(found: Vec<Found>) -> Result<Vec<Found>, FormatError> {
    if found.len() > MAX_MATRICES {
        let what = format!("a file with {} matrices", found.len());
        return Err(FormatError::TooLarge { what, max: format!("{MAX_MATRICES} matrices") });
    }
    let mut kept: Vec<(Found, usize)> = Vec::new();
    for one in found {
        match kept.iter_mut().find(|(other, _)| other.table.same_numbers(&one.table)) {
            Some((_, times)) => *times += 1,
            None => kept.push((one, 1)),
        }
    }
    Ok(kept.into_iter().map(|(one, times)| if times > 1 { one.repeated(times) } else { one }).collect())
}

impl Found {
    fn new(name: &str, table: Table) -> Self {
        Self { name: quote(name), table, notices: Vec::new(), ends: None, names: Vec::new() }
    }

    /// Refuses heights below names that say what was measured: they are records.
    ///
    /// # Errors
    /// [`FormatError::Syntax`] with the names.
    pub fn check_heights(&self) -> Result<(), FormatError> {
        if self.names.len() < 2 || lists::only_number(&self.names) {
            return Ok(());
        }
        let names: Vec<String> = self.names.iter().take(4).map(|name| quote(name)).collect();
        let what = format!("the columns are called {}: a table of records, not a grid of heights", names.join(", "));
        let line = self.table.line(0).saturating_sub(1);
        Err(FormatError::syntax(line, what, "heights alone in rows and columns, without names above, or an ESRI ASCII grid"))
    }

    fn with_notice(mut self, notice: Notice) -> Self {
        self.notices.push(notice);
        self
    }

    /// It stands in the file so many times.
    fn repeated(self, times: usize) -> Self {
        let message = format!("the file holds the same numbers {times} times; they were read once");
        self.with_notice(Notice::new("matrix-repeated", message).with("count", times))
    }

    /// Its size, its line and its name.
    pub fn describe(&self) -> String {
        let (rows, line) = (self.table.height(), self.table.line(0));
        let name = if self.name.is_empty() { String::new() } else { format!(" (`{}`)", self.name) };
        format!("{} × {rows} from line {line}{name}", self.table.row(0).len())
    }
}

#[cfg(test)]
mod tests;
