//! A map as a matrix: 0 = free, 1 = blocked, 2 = start, 3 = goal, in every spelling that [`super::table`] reads. A table with many
//! different numbers is none: it holds heights.

use super::table::{Other, Sink, Table};
use crate::error::{FormatError, Notice};
use crate::map::{Grid, Point, check_size};

/// How many different other numbers a map may hold before it is taken for heights.
const MAX_OTHER_NUMBERS: usize = 3;

/// A matrix as read.
pub(super) struct MatrixFile {
    pub grid: Grid,
    pub start: Option<Point>,
    pub goal: Option<Point>,
    pub notices: Vec<Notice>,
}

/// Whether a table holds a map: 0 and 1, one 2, one 3, and no more than three different numbers else.
pub(super) fn is_map(table: &Table) -> bool {
    let marks = Marks::of(table);
    table.census.others.as_ref().is_some_and(|others| others.iter().filter(|o| !marks.has(o.value)).count() <= MAX_OTHER_NUMBERS)
}

/// Reads a matrix; the table holds a map.
///
/// # Errors
/// [`FormatError`] with the line of a ragged row.
pub(super) fn read(table: &Table) -> Result<MatrixFile, FormatError> {
    let (width, height) = table.size()?;
    check_size(width as u64, height as u64)?;
    let marks = Marks::of(table);
    let mut cells = Cells { marks: &marks, cells: Vec::with_capacity(width * height) };
    table.read(&mut cells)?;
    let grid = Grid::from_bytes(width as u32, height as u32, &cells.cells)?;
    Ok(MatrixFile { grid, start: marks.start, goal: marks.goal, notices: notices(table, &marks) })
}

/// The cells of a map on their way in.
struct Cells<'a> {
    marks: &'a Marks,
    /// 0 where it is free.
    cells: Vec<u8>,
}

impl Sink for Cells<'_> {
    fn number(&mut self, value: f64) {
        self.cells.push(u8::from(!(value == 0.0 || self.marks.has(value))));
    }

    fn end_row(&mut self, _line: usize) -> Result<(), FormatError> {
        Ok(())
    }
}

/// The cells that stand for start and goal.
struct Marks {
    start: Option<Point>,
    goal: Option<Point>,
}

impl Marks {
    fn of(table: &Table) -> Self {
        let others = || table.census.others.iter().flatten();
        // The place of a number that occurs exactly once.
        let only = |value: f64| others().find(|o| o.value == value && o.count == 1).map(|o| o.first);
        Self { start: only(2.0), goal: only(3.0) }
    }

    /// Whether a number stands for an end.
    fn has(&self, value: f64) -> bool {
        (value == 2.0 && self.start.is_some()) || (value == 3.0 && self.goal.is_some())
    }
}

fn notices(table: &Table, marks: &Marks) -> Vec<Notice> {
    let mut notices = Vec::new();
    let assumed = "0 was read as free and 1 as blocked; if the file means the opposite, invert the map (`convert --invert`)";
    notices.push(Notice::new("matrix-one-is-blocked", assumed));
    if marks.start.is_some() || marks.goal.is_some() {
        let read = match (marks.start, marks.goal) {
            (Some(_), Some(_)) => "2 was read as the start and 3 as the goal",
            (Some(_), None) => "2 was read as the start",
            _ => "3 was read as the goal",
        };
        notices.push(Notice::new("matrix-ends", read));
    }
    let others: Vec<&Other> = table.census.others.iter().flatten().filter(|o| !marks.has(o.value)).collect();
    if !others.is_empty() {
        let count: usize = others.iter().map(|o| o.count).sum();
        let list = others.iter().map(|o| o.value.to_string()).collect::<Vec<_>>().join(", ");
        let message = format!("{count} cells hold {list}: they were read as blocked");
        notices.push(Notice::new("matrix-other-numbers", message).with("count", count).with("value", list));
    }
    notices.extend(rest_notice(table));
    notices
}

/// That there was text around the numbers.
pub(super) fn rest_notice(table: &Table) -> Option<Notice> {
    let (rows, line) = (table.census.rows, table.census.first_line);
    let message = format!("only the {rows} rows of numbers from line {line} on were read, not the text around them");
    table.has_rest.then(|| Notice::new("matrix-rest-ignored", message).with("count", rows).with("line", line))
}

/// The map as CSV of 0 and 1.
pub(super) fn write(grid: &Grid) -> String {
    let mut text = String::with_capacity(2 * grid.len());
    for (cell, blocked) in grid.to_bytes().into_iter().enumerate() {
        text.push(if blocked == 0 { '0' } else { '1' });
        let row_ends = (cell as u32 + 1).is_multiple_of(grid.width());
        text.push(if row_ends { '\n' } else { ',' });
    }
    text
}
