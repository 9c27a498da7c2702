//! Rows and columns of labels, as pandas, R and spreadsheets write them around a matrix: names, or 0 … n − 1, or 1 … n.

use super::scan::hole;
use super::{Row, Table};
use crate::error::{FormatError, Notice};

/// Fewest numbers of a row that are taken for labels: 0 1 2 may be a free cell, a wall and a start.
const FEWEST: usize = 4;

/// Whether the fields of a line are names of columns: no number among them, or numbers that count behind a name or nothing.
pub(super) fn is_names(fields: &[&str]) -> bool {
    let bare = |field: &str| field.trim().trim_matches(['"', '\'']).trim().to_owned();
    let fields: Vec<String> = fields.iter().map(|field| bare(field)).collect();
    let is_number = |field: &String| field.parse::<f64>().is_ok_and(f64::is_finite);
    let Some((first, rest)) = fields.split_first() else { return false };
    let named = fields.iter().filter(|field| !field.is_empty());
    if named.clone().next().is_some() && named.clone().all(|f| !is_number(f) && f.starts_with(char::is_alphabetic)) {
        return true;
    }
    !is_number(first) && rest.len() > 1 && counts(rest.iter().filter_map(|f| f.parse().ok()), rest.len())
}

/// Whether numbers count up from 0 or 1, `count` of them.
fn counts(numbers: impl Iterator<Item = f64>, count: usize) -> bool {
    let mut seen = 0;
    let mut first = 0.0;
    for (at, number) in numbers.enumerate() {
        first = if at == 0 { number } else { first };
        if number != first + at as f64 {
            return false;
        }
        seen += 1;
    }
    seen == count && (first == 0.0 || first == 1.0)
}

fn row_counts(row: Row<'_>) -> bool {
    counts(row.iter().map(f64::from), row.len())
}

/// What was left out around a table.
pub(super) struct Labels {
    /// The line of names above the rows, where it has been left out already.
    pub above: Option<usize>,
    /// Whether what stands above the first column is no label of one, so that this has to be a column of labels.
    pub has_corner: bool,
    /// Whether rows began with a name that has been left out already.
    pub before: bool,
}

/// Leaves out a row and a column of labels.
///
/// # Errors
/// [`FormatError::Syntax`] where a first row 0 1 2 may be labels or cells.
pub(super) fn without(table: Table, labels: &Labels) -> Result<(Table, Option<Notice>), FormatError> {
    let above = labels.above.is_none() && first_row_counts(&table)?;
    let first = usize::from(above);
    let named = above || labels.above.is_some();
    // A column of labels stands beside a row of them with the same number of fields, or beside nothing where it counts far enough.
    let column = !labels.before && column_counts(&table, first, named);
    if let Some(line) = labels.above.filter(|_| labels.has_corner && !column && !labels.before) {
        return Err(hole(line, 1));
    }
    if !above && !column && labels.above.is_none() && !labels.before {
        return Ok((table, None));
    }
    let line = labels.above.unwrap_or_else(|| table.line(0));
    let message = match (named, column || labels.before) {
        (true, true) => format!("line {line} and the first column were read as labels, not as cells"),
        (true, false) => format!("line {line} was read as labels of the columns, not as cells"),
        _ => "the first column was read as labels of the rows, not as cells".into(),
    };
    let which = match (named, column || labels.before) {
        (true, true) => "both",
        (true, false) => "row",
        _ => "column",
    };
    let notice = Notice::new("matrix-labels", message).with("line", line).with("which", which);
    Ok((table.without(first, column), Some(notice)))
}

/// Whether the first row counts the columns, and the rows below do not go on as it does.
fn first_row_counts(table: &Table) -> Result<bool, FormatError> {
    let (first, second) = (table.row(0), table.row(1));
    let goes_on = second.len() == first.len() && (1..second.len()).all(|at| second.at(at) - second.at(at - 1) == 1.0);
    if table.height() < 3 || goes_on || second.len() < first.len() || !row_counts(first) {
        return Ok(false);
    }
    match first.len() {
        3 if first.at(0) == 0.0 && table.height() == 4 && table.numbers().filter(|&n| n >= 2.0).count() == 1 => {
            let expected = "a line without labels; or names such as a,b,c above the columns";
            Err(FormatError::syntax(
                table.line(0),
                "0 1 2 may be labels of the columns, or a free cell, a wall and the start",
                expected,
            ))
        }
        length => Ok(length >= FEWEST),
    }
}

/// Whether the first column counts the rows from row `first` on.
fn column_counts(table: &Table, first: usize, named: bool) -> bool {
    let height = table.height().saturating_sub(first);
    let rows = || (first..table.height()).map(|row| table.row(row));
    if height < 2 || (!named && height < FEWEST) || rows().any(|row| row.len() < 2) {
        return false;
    }
    let second_too = counts(rows().map(|row| f64::from(row.at(1))), height);
    counts(rows().map(|row| f64::from(row.at(0))), height) && !second_too
}
