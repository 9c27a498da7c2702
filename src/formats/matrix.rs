//! A map as a matrix: 0 = free, 1 = blocked, 2 = start, 3 = goal, in every spelling that [`super::numbers`] reads. A table with many
//! different numbers is none: it holds heights.

use super::numbers::{Ends, Found, Table};
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
    let mut others = Others::default();
    table.numbers().filter(|&v| v != 0.0 && v != 1.0 && !marks.has(v)).all(|v| others.add(v))
}

/// Reads a matrix; the table holds a map.
///
/// # Errors
/// [`FormatError`] with the line of a ragged row.
pub(super) fn read(found: Found) -> Result<MatrixFile, FormatError> {
    let table = &found.table;
    let (width, height) = table.size()?;
    check_size(width as u64, height as u64)?;
    let marks = Marks::of(table);
    let mut others = Others::default();
    let mut cells = Vec::with_capacity(width * height);
    for value in table.numbers() {
        let free = value == 0.0 || marks.has(value);
        if !free && value != 1.0 {
            others.add(value);
        }
        cells.push(u8::from(!free));
    }
    let mut notices = notices(table, &marks, &others);
    let grid = Grid::from_bytes(width as u32, height as u32, &cells)?;
    let (mut start, mut goal) = (marks.start, marks.goal);
    if let (Some(ends), None, None) = (found.ends, start, goal) {
        let (places, notice) = stated_ends(&grid, ends);
        (start, goal) = (places.map(|p| p[0]), places.map(|p| p[1]));
        notices.push(notice);
    }
    notices.splice(0..0, found.notices);
    Ok(MatrixFile { grid, start, goal, notices })
}

/// Start and goal from the lines above a matrix: as column and row, or as row and column, where only one of the two lies on free cells.
fn stated_ends(grid: &Grid, ends: Ends) -> (Option<[Point; 2]>, Notice) {
    let [start, goal] = [ends.start, ends.goal];
    let pairs = format!("{} {} and {} {}", start[0], start[1], goal[0], goal[1]);
    let is_free = |places: &[Point; 2]| places.iter().all(|p| grid.is_free_at(p.x.into(), p.y.into()));
    let columns = Some([start, goal].map(|[x, y]| Point::new(x, y))).filter(is_free);
    let rows = Some([start, goal].map(|[y, x]| Point::new(x, y))).filter(is_free);
    let (places, order) = match (columns, rows) {
        (Some(a), Some(b)) if a != b => (None, "unsure"),
        (Some(places), _) => (Some(places), "columns"),
        (None, Some(places)) => (Some(places), "rows"),
        (None, None) => (None, "nowhere"),
    };
    let message = match order {
        "columns" => format!("the start and the goal {pairs} were read as column and row"),
        "rows" => format!("the start and the goal {pairs} were read as row and column: the other way round they are not free"),
        "unsure" => format!("{pairs} may be columns and rows, or rows and columns: start and goal were not taken from them"),
        _ => format!("{pairs} are no free cells: start and goal were not taken from them"),
    };
    (places, Notice::new("matrix-stated-ends", message).with("pairs", pairs).with("order", order))
}

/// The cells that stand for start and goal.
struct Marks {
    start: Option<Point>,
    goal: Option<Point>,
}

impl Marks {
    fn of(table: &Table) -> Self {
        Self { start: only(table, 2.0), goal: only(table, 3.0) }
    }

    /// Whether a number stands for an end.
    fn has(&self, value: f32) -> bool {
        (value == 2.0 && self.start.is_some()) || (value == 3.0 && self.goal.is_some())
    }
}

/// The place of a number that occurs exactly once.
fn only(table: &Table, value: f32) -> Option<Point> {
    let mut places = table.rows().enumerate().flat_map(|(y, row)| {
        row.iter().enumerate().filter(move |&(_, v)| v == value).map(move |(x, _)| Point::new(x as u32, y as u32))
    });
    let first = places.next()?;
    places.next().is_none().then_some(first)
}

/// Numbers that are none of 0, 1, start and goal.
#[derive(Default)]
struct Others {
    values: Vec<f32>,
    count: usize,
}

impl Others {
    /// Counts a number; false when there are too many different ones.
    fn add(&mut self, value: f32) -> bool {
        self.count += 1;
        if !self.values.contains(&value) {
            self.values.push(value);
        }
        self.values.len() <= MAX_OTHER_NUMBERS
    }

    fn list(&self) -> String {
        self.values.iter().map(f32::to_string).collect::<Vec<_>>().join(", ")
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
    notices.extend(rest_notice(table));
    notices
}

/// That there was text around the numbers.
pub(super) fn rest_notice(table: &Table) -> Option<Notice> {
    let (rows, line) = (table.height(), table.line(0));
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
