//! A map as a matrix: 0 = free, 1 = blocked, 2 = start, 3 = goal, in every spelling that [`super::table`] reads.

use super::table::{self, Row, Table};
use crate::error::{FormatError, Notice};
use crate::map::{Grid, Point, check_size};

/// How many different other numbers a map may hold before it is taken for something else, such as heights.
const MAX_OTHER_NUMBERS: usize = 3;

/// A matrix as read.
pub(super) struct MatrixFile {
    pub grid: Grid,
    pub start: Option<Point>,
    pub goal: Option<Point>,
    pub notices: Vec<Notice>,
}

/// Reads a matrix.
///
/// # Errors
/// [`FormatError`] with the line of a ragged row or of the first thing that is no cell.
pub(super) fn read(text: &str) -> Result<MatrixFile, FormatError> {
    let table = table::read(text)?;
    let (width, height) = shape(&table.rows)?;
    let marks = Marks { start: only(&table.rows, 2.0), goal: only(&table.rows, 3.0) };
    let mut others = Others::default();
    let mut cells = Vec::with_capacity(width as usize * height as usize);
    for (y, row) in table.rows.iter().enumerate() {
        for (x, &value) in row.values.iter().enumerate() {
            let at = Point::new(x as u32, y as u32);
            let free = value == 0.0 || marks.start == Some(at) || marks.goal == Some(at);
            if !free && value != 1.0 {
                others.add(value, row.line)?;
            }
            cells.push(u8::from(!free));
        }
    }
    let notices = notices(&table, &marks, &others);
    Ok(MatrixFile { grid: Grid::from_bytes(width, height, &cells)?, start: marks.start, goal: marks.goal, notices })
}

/// Width and height, if all rows are equally long.
fn shape(rows: &[Row]) -> Result<(u32, u32), FormatError> {
    let width = rows.first().map_or(0, |r| r.values.len());
    if let Some((index, row)) = rows.iter().enumerate().find(|(_, r)| r.values.len() != width) {
        let what = format!("row {} has {} numbers where the first row has {width}", index + 1, row.values.len());
        return Err(FormatError::syntax(row.line, what, "equally long rows"));
    }
    check_size(width as u64, rows.len() as u64)?;
    Ok((width as u32, rows.len() as u32))
}

/// The cells that stand for start and goal.
struct Marks {
    start: Option<Point>,
    goal: Option<Point>,
}

/// The place of a number that occurs exactly once.
fn only(rows: &[Row], value: f64) -> Option<Point> {
    let mut places = rows.iter().enumerate().flat_map(|(y, row)| {
        row.values.iter().enumerate().filter(move |&(_, &v)| v == value).map(move |(x, _)| Point::new(x as u32, y as u32))
    });
    let first = places.next()?;
    places.next().is_none().then_some(first)
}

/// Numbers that are none of 0, 1, start and goal.
#[derive(Default)]
struct Others {
    values: Vec<f64>,
    count: usize,
}

impl Others {
    fn add(&mut self, value: f64, line: usize) -> Result<(), FormatError> {
        self.count += 1;
        if !self.values.contains(&value) {
            self.values.push(value);
        }
        if self.values.len() <= MAX_OTHER_NUMBERS {
            return Ok(());
        }
        let what = format!("{} and other numbers make this a table of values, not a map", self.list());
        Err(FormatError::syntax(line, what, "0 (free), 1 (blocked), one 2 (start) and one 3 (goal)"))
    }

    fn list(&self) -> String {
        self.values.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
    }
}

fn notices(table: &Table, marks: &Marks, others: &Others) -> Vec<Notice> {
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
    if others.count > 0 {
        let message = format!("{} cells hold {}: they were read as blocked", others.count, others.list());
        notices.push(Notice::new("matrix-other-numbers", message).with("count", others.count).with("value", others.list()));
    }
    if table.has_rest {
        let (rows, line) = (table.rows.len(), table.rows[0].line);
        let message = format!("only the {rows} rows of numbers from line {line} on were read, not the text around them");
        notices.push(Notice::new("matrix-rest-ignored", message).with("count", rows).with("line", line));
    }
    notices
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
