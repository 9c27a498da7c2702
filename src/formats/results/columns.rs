//! The columns of a table of results: which of them says what, under which names.

use super::quote;
use crate::error::FormatError;
use crate::formats::text::lines;

/// What a column says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Column {
    Entry,
    Instance,
    Seed,
    Length,
    Value,
    Turns,
    TurnIndex,
    Weight,
    IterationOfBest,
    Iterations,
    PathsToBest,
    Evaluations,
    AntMoves,
    CellExpansions,
    Status,
}

use Column::*;

/// Every column with its names, the preferred one first. Where a file has two of the names, the later one says nothing.
const NAMES: [(Column, &[&str]); 15] = [
    (Entry, &["entry", "algorithm", "planner", "method"]),
    (Instance, &["instance", "map", "problem"]),
    (Seed, &["seed", "run", "run_id"]),
    (Length, &["length", "path_length"]),
    (Value, &["value", "cost"]),
    (Turns, &["turns"]),
    (TurnIndex, &["turn_index"]),
    (Weight, &["weight"]),
    (IterationOfBest, &["iteration_of_best"]),
    (Iterations, &["iterations", "iteration"]),
    (PathsToBest, &["paths_to_best"]),
    (Evaluations, &["evaluations", "evaluation", "constructed_paths", "function_evaluations"]),
    (AntMoves, &["ant_moves"]),
    (CellExpansions, &["cell_expansions"]),
    (Status, &["status"]),
];

/// The preferred name of a column.
pub(super) fn name(column: Column) -> &'static str {
    NAMES[column as usize].1[0]
}

/// Columns that our own tables have besides; they follow from the others.
const OURS: [&str; 5] = ["objective", "reference", "proven", "gap", "digest"];

/// Where the columns of a table stand.
#[derive(Debug, Default)]
pub(super) struct Columns {
    /// By column: its place in a line, and its name in the header.
    places: [Option<(usize, String)>; NAMES.len()],
    /// Number of fields of the header.
    pub width: usize,
    /// Names of columns that say nothing here.
    pub unknown: Vec<String>,
}

impl Columns {
    /// Finds the columns in the fields of a header.
    ///
    /// # Errors
    /// [`FormatError`] where a name stands twice, or no column holds results.
    pub fn of(header: &[&str], line: usize) -> Result<Self, FormatError> {
        let names: Vec<String> = header.iter().map(|name| normal(name)).collect();
        for (at, name) in names.iter().enumerate().filter(|(_, name)| role(name).is_some()) {
            if names[..at].contains(name) {
                return Err(FormatError::syntax(line, format!("the column `{name}` stands twice"), "each column once"));
            }
        }
        let place = |&(_, known): &(Column, &[&str])| {
            let at = known.iter().find_map(|known| names.iter().position(|name| name == known))?;
            Some((at, header[at].trim().to_owned()))
        };
        let places = NAMES.each_ref().map(place);
        let says_nothing = |at: usize| !places.iter().flatten().any(|(place, _)| *place == at);
        let is_ours = |name: &str| name.is_empty() || OURS.contains(&name);
        let unknown = (0..names.len()).filter(|&at| says_nothing(at) && !is_ours(&names[at])).map(|at| quote(header[at]));
        let columns = Self { width: header.len(), unknown: unknown.collect(), places };
        if columns.has(Length) || columns.has(Value) {
            return Ok(columns);
        }
        let what = format!("no column holds results: the columns are {}", quote(&names.join(", ")));
        let expected = "a line of names first, one of them `length` (or `value`); between commas, semicolons or tabs";
        Err(FormatError::syntax(line, what, expected))
    }

    /// Whether the table has a column.
    pub fn has(&self, column: Column) -> bool {
        self.places[column as usize].is_some()
    }

    /// Whether the table has a column from which the effort of a line can be told.
    pub fn tell_effort(&self) -> bool {
        [IterationOfBest, Iterations, PathsToBest, Evaluations, AntMoves, CellExpansions].into_iter().any(|c| self.has(c))
    }

    /// Its place in a line and its name in the header.
    pub fn place(&self, column: Column) -> Option<(usize, &str)> {
        self.places[column as usize].as_ref().map(|(at, name)| (*at, name.as_str()))
    }
}

/// Small letters, `_` between words.
fn normal(name: &str) -> String {
    name.trim().to_lowercase().replace([' ', '-'], "_")
}

/// What a column of this name says.
fn role(name: &str) -> Option<Column> {
    NAMES.iter().find(|(_, known)| known.contains(&name)).map(|(column, _)| *column)
}

/// What stands between the fields: a tab or a semicolon where the header has one, else a comma.
pub(super) fn separator(header: &str) -> u8 {
    [b'\t', b';'].into_iter().find(|&b| header.bytes().any(|h| h == b)).unwrap_or(b',')
}

/// The first line that is neither blank nor a comment.
pub(super) fn header(text: &str) -> Option<&str> {
    lines(text).map(|(_, line)| line).find(|line| !line.trim().is_empty() && !line.starts_with('#'))
}

/// Whether a text begins with the names of such columns, one of them `length` or `value`. Maps never do: their first line holds numbers, or
/// words without a separator; and a program that holds a matrix has a `=` or a `%` in its first line.
pub(super) fn looks_like(text: &str) -> bool {
    let Some(header) = header(text).filter(|line| line.len() < 4096 && !line.starts_with('%')) else { return false };
    let names: Vec<String> = header.split(char::from(separator(header))).map(|name| normal(name.trim_matches('"'))).collect();
    let is_name = |name: &String| !name.contains(['=', '{']) && name.parse::<f64>().is_err();
    let holds_results = |name: &String| matches!(role(name), Some(Length | Value));
    names.iter().all(is_name) && names.iter().any(holds_results)
}
