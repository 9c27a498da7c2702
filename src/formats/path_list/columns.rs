//! Which column of a path says what: by its name, or by its place.

use crate::error::FormatError;
use crate::formats::text::quote;

/// Names of the column that counts columns, of the one that counts rows, and of levels and metres, in small letters.
const NAMES: [&[&str]; 3] = [
    &["x", "col", "cols", "column", "columns", "c", "j", "px", "列"],
    &["y", "row", "rows", "r", "i", "py", "行"],
    &["level", "z", "height_level", "层"],
];

/// Names of the columns of metres.
const METRES: [&str; 3] = ["x_m", "y_m", "z_m"];

/// Where column, row and level of a place stand in a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Columns {
    pub x: usize,
    pub y: usize,
    pub level: Option<usize>,
    /// How many fields a line has, where names say it.
    pub width: Option<usize>,
}

impl Columns {
    /// x and y, perhaps with a level behind them.
    pub const PLAIN: Self = Self { x: 0, y: 1, level: Some(2), width: None };
}

/// The fields of a line of names; none where a number stands among them.
fn names(line: &str) -> Option<Vec<String>> {
    /// No line of names is longer, in bytes.
    const LONGEST: usize = 4096;
    if line.len() > LONGEST {
        return None;
    }
    let bare = |name: &&str| name.trim_matches(['"', '\'', '%', '#']).trim().to_lowercase();
    let fields: Vec<String> = fields(line).iter().map(bare).collect();
    let is_name =
        |name: &String| name.is_empty() || name.starts_with(char::is_alphabetic) && !name.contains(['=', '[', '(', ':']);
    let named = fields.len() > 1 && fields.iter().all(is_name) && fields.iter().any(|name| !name.is_empty());
    named.then_some(fields)
}

/// Where x, y and z in metres stand in a line, and how many fields it has, where the names of a line say so and none names a column of cells.
pub(super) fn in_metres(line: &str) -> Option<([Option<usize>; 3], usize)> {
    let names = names(line).filter(|_| !is_header(line))?;
    let places = METRES.map(|known| names.iter().position(|name| name == known));
    (places[0].is_some() && places[1].is_some()).then_some((places, names.len()))
}

/// The fields of a line, which its first separator parts, or blanks where it has none.
pub(super) fn fields(line: &str) -> Vec<&str> {
    match [',', ';', '\t'].into_iter().find(|&c| line.contains(c)) {
        Some(separator) => line.split(separator).map(str::trim).collect(),
        None => line.split_whitespace().collect(),
    }
}

/// Whether a line names a column of columns and one of rows.
pub(super) fn is_header(line: &str) -> bool {
    names(line).is_some_and(|names| NAMES[..2].iter().all(|known| names.iter().any(|name| known.contains(&name.as_str()))))
}

/// What the names of a line say; none for a line that holds none.
///
/// # Errors
/// [`FormatError::Syntax`] where they do not say which column is which.
pub(super) fn of(line: &str) -> Result<Option<Columns>, FormatError> {
    let Some(names) = names(line) else { return Ok(None) };
    let place = |known: &[&str]| {
        let mut at = names.iter().enumerate().filter(|(_, name)| known.contains(&name.as_str())).map(|(at, _)| at);
        at.next().filter(|_| at.next().is_none())
    };
    let [x, y, level] = NAMES.map(place);
    match (x, y) {
        (Some(x), Some(y)) => Ok(Some(Columns { x, y, level, width: Some(names.len()) })),
        _ => {
            let what = format!("the columns `{}` do not say which is which", quote(&names.join(", ")));
            Err(FormatError::syntax(1, what, "x and y, or row and col, once each"))
        }
    }
}

/// Which of the names of a point's fields counts columns, rows and levels: 0, 1, 2.
pub(super) fn role(name: &str) -> Option<usize> {
    NAMES.iter().position(|known| known.contains(&name.to_lowercase().as_str()))
}
