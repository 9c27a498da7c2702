//! A path as a list of cells: JSON (`[[0, 0], [1, 1]]` or the output of `plan`), CSV lines `x,y`, or MATLAB pairs; by slices with the level
//! of each place behind it.

use serde::Deserialize;
use serde_json::Value;

use super::table::{self, Sink};
use super::text::decode;
use crate::error::FormatError;
use crate::map::Point;
use crate::path::PathKind;
use crate::planner::Objective;

/// What a path looks like, for error messages.
const EXPECTED: &str = "pairs of whole numbers: [[x, y], …], lines `x,y`, or [x y; x y]; by slices each with its level";

/// Reads a path. The points are as they stand in the file: neither checked against a map nor shifted.
///
/// # Errors
/// [`FormatError`] with the line of the first thing that is no point.
pub fn read_path(bytes: &[u8]) -> Result<Vec<Point>, FormatError> {
    let places = read_places(bytes)?;
    match places.iter().position(|(_, level)| level.is_some()) {
        Some(index) => Err(FormatError::syntax(0, format!("place {index} has a level"), EXPECTED)),
        None => Ok(places.into_iter().map(|(at, _)| at).collect()),
    }
}

/// Reads a path that may be one by slices: each point, and its level where it has a third number or a result has `levels`.
///
/// # Errors
/// [`FormatError`] with the line of the first thing that is no place.
pub fn read_places(bytes: &[u8]) -> Result<Vec<(Point, Option<u32>)>, FormatError> {
    let text = decode(bytes)?;
    if text.trim_start().starts_with('{') {
        return from_result(&text);
    }
    let body = without_header(&text);
    let offset = text[..text.len() - body.len()].matches('\n').count();
    // What is no number is said before what is no place.
    let table = table::read(body)?;
    let rows = if matches!(table.census.columns, 2 | 3) { table.census.rows } else { 0 };
    let mut read = Places { offset, places: Vec::with_capacity(rows), ..Places::default() };
    table.read(&mut read)?;
    Ok(read.places)
}

/// Places on their way in.
#[derive(Default)]
struct Places {
    /// Lines before the table.
    offset: usize,
    places: Vec<(Point, Option<u32>)>,
    /// The first numbers of the row at hand: one more than a place has.
    row: [f64; 4],
    /// How many numbers it has.
    count: usize,
}

impl Sink for Places {
    fn number(&mut self, value: f64) {
        if let Some(place) = self.row.get_mut(self.count) {
            *place = value;
        }
        self.count += 1;
    }

    fn end_row(&mut self, line: usize) -> Result<(), FormatError> {
        let count = std::mem::take(&mut self.count).min(self.row.len());
        self.places.push(place(&self.row[..count], line + self.offset)?);
        Ok(())
    }
}

/// What kind of path a file holds: what a result's objective says; steps for everything else.
pub fn path_kind(bytes: &[u8]) -> PathKind {
    #[derive(Deserialize)]
    struct Result {
        objective: Objective,
    }
    serde_json::from_slice::<Result>(bytes).map_or(PathKind::Steps, |result| result.objective.path_kind())
}

/// Without a first line of column names, e.g. `x,y`.
fn without_header(text: &str) -> &str {
    match text.split_once('\n') {
        Some((head, rest)) if head.contains(char::is_alphabetic) && !head.contains(['[', '=', '%', '#']) => rest,
        _ => text,
    }
}

fn place(values: &[f64], line: usize) -> Result<(Point, Option<u32>), FormatError> {
    let whole = |v: f64| (v.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&v)).then_some(v as u32);
    let point = |x, y| whole(x).zip(whole(y)).map(|(x, y)| Point { x, y });
    match *values {
        [x, y] => point(x, y).map(|at| (at, None)),
        [x, y, level] => point(x, y).zip(whole(level)).map(|(at, level)| (at, Some(level))),
        _ => None,
    }
    .ok_or_else(|| {
        let shown: Vec<_> = values.iter().take(4).map(f64::to_string).collect();
        FormatError::syntax(line, format!("`{}` is no cell", shown.join(" ")), EXPECTED)
    })
}

/// The `path` of a result, with its `levels`.
fn from_result(text: &str) -> Result<Vec<(Point, Option<u32>)>, FormatError> {
    let syntax = |e: serde_json::Error| FormatError::syntax(e.line(), e.to_string(), EXPECTED);
    let mut result: Value = serde_json::from_str(text).map_err(syntax)?;
    let path = result.get_mut("path").map(Value::take);
    let path = path.ok_or_else(|| FormatError::syntax(0, "the JSON object has no `path`", EXPECTED))?;
    let path: Vec<Point> = serde_json::from_value(path).map_err(|e| FormatError::syntax(0, format!("`path`: {e}"), EXPECTED))?;
    let Some(levels) = result.get_mut("levels").map(Value::take) else {
        return Ok(path.into_iter().map(|at| (at, None)).collect());
    };
    let levels: Vec<u32> =
        serde_json::from_value(levels).map_err(|e| FormatError::syntax(0, format!("`levels`: {e}"), EXPECTED))?;
    if levels.len() != path.len() {
        let what = format!("there are {} levels for {} cells", levels.len(), path.len());
        return Err(FormatError::syntax(0, what, "one level for each cell"));
    }
    Ok(path.into_iter().zip(levels.into_iter().map(Some)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_of_one_path() {
        let spellings = [
            "[[0, 0], [1, 1], [2, 1]]",
            "{\"format\": \"formicarium/result@1\", \"path\": [[0,0],[1,1],[2,1]]}",
            "x,y\n0,0\n1,1\n2,1\n",
            "0 0\n1 1\r\n2 1",
            "0;0\n1;1\n2;1\n",
            "path = [0 0; 1 1; 2 1];",
            "route = [0, 0\n1, 1\n2, 1];",
        ];
        for text in spellings {
            let path = read_path(text.as_bytes()).unwrap();
            assert_eq!(path, [Point::new(0, 0), Point::new(1, 1), Point::new(2, 1)], "{text:?}");
        }
    }

    #[test]
    fn levels_are_third_numbers_or_a_list_of_their_own() {
        let spellings =
            ["[[0, 0, 4], [1, 2, 5]]", "0,0,4\n1,2,5\n", "{\"path\": [[0,0],[1,2]], \"levels\": [4, 5]}", "p = [0 0 4; 1 2 5];"];
        for text in spellings {
            let places = read_places(text.as_bytes()).unwrap();
            assert_eq!(places, [(Point::new(0, 0), Some(4)), (Point::new(1, 2), Some(5))], "{text:?}");
            assert!(read_path(text.as_bytes()).is_err(), "{text:?}");
        }
        assert!(read_places(b"{\"path\": [[0,0],[1,2]], \"levels\": [4]}").is_err());
    }

    #[test]
    fn a_result_tells_the_kind_of_its_path() {
        let kind = |text: &str| path_kind(text.as_bytes());
        assert_eq!(kind("{\"objective\": \"polyline-length\", \"path\": [[0,0],[5,1]]}"), PathKind::Polyline);
        for text in ["{\"objective\": \"turn-index\", \"path\": []}", "{\"path\": []}", "[[0, 0]]", "0,0\n"] {
            assert_eq!(kind(text), PathKind::Steps, "{text}");
        }
    }

    #[test]
    fn what_is_no_point_is_refused_with_its_line() {
        for (text, line) in [("0,0\n1,1.5\n", 2), ("x,y\n0,0\n-1,1\n", 3), ("0,0\n0,1,2,3\n", 2), ("{}", 0), ("{", 1)] {
            let Err(FormatError::Syntax { line: got, .. }) = read_path(text.as_bytes()) else { panic!("{text:?}") };
            assert_eq!(got, line, "{text:?}");
        }
    }
}
