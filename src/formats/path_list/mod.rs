//! A path as a list of cells: JSON (`[[0, 0], [1, 1]]` or the output of `plan`), CSV lines whose names say which column is which, MATLAB
//! pairs, tuples and points with names as Python prints them; by slices with the level of each place behind it; what `path_out` writes. A Path
//! message of ROS and a line of GeoJSON are in metres: [`read_world_path`].

mod columns;
mod steps;
mod world;

use std::borrow::Cow;

use serde::Deserialize;
use serde_json::Value;

use super::text::{decode, is_ours};
use super::{numbers, path_out, ros};
use crate::error::{FormatError, Notice};
use crate::map::Point;
use crate::path::PathKind;
use crate::planner::Objective;
use crate::scenario::ScenarioSpec;
use columns::Columns;
pub use steps::read_steps_on;
pub use world::WorldPath;

/// What a path looks like, for error messages.
const EXPECTED: &str = "pairs of whole numbers: [[x, y], …], lines `x,y`, or [x y; x y]; by slices each with its level";

/// Whether a text is a path by its form: pairs in round brackets, points with names, poses of ROS, columns with such names, GeoJSON, or a
/// drawing of a path.
pub(super) fn looks_like(text: &str) -> bool {
    if path_out::looks_like(text) {
        return true;
    }
    if is_ours(text) {
        return false;
    }
    let begin = beginning(text);
    let digit = |rest: &str| rest.trim_start_matches("np.int64(").starts_with(|c: char| c.is_ascii_digit() || c == '-');
    let pairs = begin.find("[(").is_some_and(|at| digit(&begin[at + 2..]));
    pairs
        || has_named_points(&begin)
        || ros::is_path(text)
        || text.lines().next().is_some_and(|line| columns::is_header(line) || columns::in_metres(line).is_some())
}

/// The first letters of a text, without blanks.
fn beginning(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).take(200).collect()
}

/// `[{"x": 0, …`, in JSON or as Python prints it.
fn has_named_points(begin: &str) -> bool {
    let first = begin.split_once("[{").filter(|(before, _)| !before.contains(['[', '{'])).map(|(_, rest)| rest);
    first.is_some_and(|rest| {
        rest.starts_with(['"', '\''])
            && rest.get(1..).is_some_and(|rest| rest.split(['"', '\'']).next().and_then(columns::role).is_some())
    })
}

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
    if let Some((what, expected)) = in_metres(&text) {
        return Err(FormatError::syntax(0, what, expected));
    }
    if let Some(path) = path_out::read_own(&text) {
        return path.map(|path| path.places);
    }
    if text.trim_start().starts_with('{') {
        return from_result(&text);
    }
    if has_named_points(&beginning(&text)) {
        return named_points(&text);
    }
    let (head, rest) = text.split_once('\n').unwrap_or((&text, ""));
    let (columns, body, offset) = match columns::of(head)? {
        Some(columns) => (columns, rest, 1),
        None => (Columns::PLAIN, &*text, 0),
    };
    let table = numbers::rows(&plain_brackets(body))?;
    let rows = table.rows().enumerate();
    rows.map(|(at, row)| {
        place(&row.iter().take(MOST_FIELDS).map(f64::from).collect::<Vec<_>>(), columns, table.line(at) + offset)
    })
    .collect()
}

/// Tuples of Python as lists, numbers of NumPy as numbers: `[(np.int64(0), 1)]` is `[[0, 1]]`.
fn plain_brackets(text: &str) -> Cow<'_, str> {
    if !text.contains("[(") && !text.contains("( (") && !text.contains("((") && !text.contains("[ (") {
        return Cow::Borrowed(text);
    }
    let mut plain = String::with_capacity(text.len());
    // Round brackets that are open: those of a tuple, and those around a number or a whole list.
    let mut open = Vec::new();
    for letter in text.chars() {
        match letter {
            '(' => {
                let word = plain.ends_with(|c: char| c.is_alphanumeric() || c == '_');
                if word {
                    plain.truncate(plain.trim_end_matches(|c: char| c.is_alphanumeric() || matches!(c, '_' | '.')).len());
                } else {
                    plain.push('[');
                }
                open.push(word);
            }
            ')' => plain.extend((open.pop() == Some(false)).then_some(']')),
            letter => plain.push(letter),
        }
    }
    Cow::Owned(plain)
}

/// `[{"x": 0, "y": 1}, …]`.
fn named_points(text: &str) -> Result<Vec<(Point, Option<u32>)>, FormatError> {
    let from = text.find('[').unwrap_or(0);
    let to = text.rfind(']').map_or(text.len(), |at| at + 1);
    // As Python prints it, with single quotation marks.
    let json = text.get(from..to).unwrap_or("").replace('\'', "\"");
    let syntax = |e: serde_json::Error| FormatError::syntax(e.line(), e.to_string(), EXPECTED);
    let points: Vec<serde_json::Map<String, Value>> = serde_json::from_str(&json).map_err(syntax)?;
    let number = |point: &serde_json::Map<String, Value>, wanted: usize| {
        point.iter().find(|(name, _)| columns::role(name) == Some(wanted)).and_then(|(_, value)| value.as_f64())
    };
    let read = |(index, point): (usize, &serde_json::Map<String, Value>)| {
        let missing = || FormatError::syntax(0, format!("point {index} has no x or no y"), EXPECTED);
        let (x, y) = (number(point, 0).ok_or_else(missing)?, number(point, 1).ok_or_else(missing)?);
        let values: Vec<f64> = [x, y].into_iter().chain(number(point, 2)).collect();
        place(&values, Columns::PLAIN, 0)
    };
    points.iter().enumerate().map(read).collect()
}

/// What a text in metres is, and what it needs.
fn in_metres(text: &str) -> Option<(&'static str, &'static str)> {
    if path_out::read_geojson(text).is_some() {
        return Some(("a line of GeoJSON is in the map's coordinate system", "a map that knows its place in the world"));
    }
    let expected = "a map that knows its place in the world: check it against the ROS map";
    if ros::is_path(text) {
        return Some(("a Path message of ROS is in metres", expected));
    }
    let is_metres = path_out::read_curve(text).is_some() || columns::in_metres(text.lines().next().unwrap_or("")).is_some();
    is_metres.then_some(("the path is in metres", expected))
}

/// The places of a Path message of ROS or of a line of GeoJSON in metres; none for any other file.
///
/// # Errors
/// [`FormatError`] with the line, the pose or the position at fault.
pub fn read_world_path(bytes: &[u8]) -> Result<Option<WorldPath>, FormatError> {
    let text = decode(bytes)?;
    if let Some(line) = path_out::read_geojson(&text) {
        return line.map(|(path, _)| Some(path));
    }
    if let Some(curve) = path_out::read_curve(&text) {
        return curve.map(Some);
    }
    if ros::is_path(&text) {
        return ros::read_path(&text).map(Some);
    }
    world::in_columns(&text)
}

/// A path as a map's cells, from any file that holds one.
#[derive(Debug, Clone, PartialEq)]
pub struct PathOnMap {
    /// Its cells, as the file names them or in which its metres lie; by slices each with its level.
    pub places: Vec<(Point, Option<u32>)>,
    /// How they follow each other.
    pub kind: PathKind,
    /// The path in metres, where the file is: by slices [`WorldPath::on`] tells levels once it is known how high they are.
    pub metres: Option<WorldPath>,
    /// Whether the file itself says which number of a place is the column and which the row.
    pub names_columns: bool,
    /// What was assumed.
    pub notices: Vec<Notice>,
}

/// Reads a path of a map: cells as they stand in the file, neither checked against the map nor shifted; of metres the cells in which they lie.
///
/// # Errors
/// As [`read_places`] and [`read_world_path`], and for a place beside the map.
pub fn read_path_on(bytes: &[u8], spec: &ScenarioSpec) -> Result<PathOnMap, FormatError> {
    let metres = read_world_path(bytes)?;
    let places = metres.as_ref().map_or_else(|| read_places(bytes), |path| path.on(spec))?;
    let notices = metres.as_ref().map_or_else(Vec::new, |path| path.notices(spec));
    Ok(PathOnMap { places, kind: path_kind(bytes), metres, names_columns: names_columns(bytes)?, notices })
}

/// Whether a file itself says which number of a place is the column and which the row: by the names of its columns or points, by its format, or
/// by being in metres.
fn names_columns(bytes: &[u8]) -> Result<bool, FormatError> {
    let text = decode(bytes)?;
    if path_out::read_own(&text).is_some() || in_metres(&text).is_some() {
        return Ok(true);
    }
    if text.trim_start().starts_with('{') {
        return Ok(false);
    }
    Ok(has_named_points(&beginning(&text)) || columns::of(text.lines().next().unwrap_or(""))?.is_some())
}

/// What kind of path a file holds: what it says itself, or a result's objective; steps for everything else.
pub fn path_kind(bytes: &[u8]) -> PathKind {
    #[derive(Deserialize)]
    struct Result {
        objective: Objective,
    }
    let text = decode(bytes).unwrap_or_default();
    if let Some(Ok((_, kind))) = path_out::read_geojson(&text) {
        return kind;
    }
    if path_out::read_curve(&text).is_some() {
        return PathKind::Polyline;
    }
    if let Some(Ok(path)) = path_out::read_own(&text) {
        return path.kind;
    }
    serde_json::from_slice::<Result>(bytes).map_or(PathKind::Steps, |result| result.objective.path_kind())
}

/// Fields of a line that are looked at.
const MOST_FIELDS: usize = 64;

fn place(values: &[f64], columns: Columns, line: usize) -> Result<(Point, Option<u32>), FormatError> {
    // Beyond it whole numbers are not told apart, and no map has such cells.
    const LARGEST: f64 = 16_777_216.0;
    let whole = |v: &f64| (v.fract() == 0.0 && (0.0..LARGEST).contains(v)).then_some(*v as u32);
    let wrong = || {
        let shown: Vec<_> = values.iter().take(4).map(f64::to_string).collect();
        FormatError::syntax(line, format!("`{}` is no cell", shown.join(" ")), EXPECTED)
    };
    let fits = columns.width.map_or(matches!(values.len(), 2 | 3), |width| values.len() == width);
    let field = |at: usize| values.get(at).and_then(whole).filter(|_| fits).ok_or_else(wrong);
    let at = Point { x: field(columns.x)?, y: field(columns.y)? };
    let level = columns.level.filter(|&at| at < values.len()).map(field).transpose()?;
    Ok((at, level))
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
            "[(0, 0), (1, 1), (2, 1)]",
            "path = [(0, 0),\n (1, 1), (2, 1)]\n",
            "((0, 0), (1, 1), (2, 1))",
            "deque([(0, 0), (1, 1), (2, 1)])",
            "[(np.int64(0), np.int64(0)), (np.int64(1), np.int64(1)), (np.int64(2), np.int64(1))]",
            "array([[0, 0],\n       [1, 1],\n       [2, 1]])",
            "[[0 0]\n [1 1]\n [2 1]]",
            "[{\"x\": 0, \"y\": 0}, {\"x\": 1, \"y\": 1}, {\"x\": 2, \"y\": 1}]",
            "[{'x': 0, 'y': 0}, {'y': 1, 'x': 1}, {'x': 2, 'y': 1}]",
            "row,col\n0,0\n1,1\n1,2\n",
            "step;Row;Col\n0;0;0\n1;1;1\n2;1;2\n",
            "\"y\"\t\"x\"\n0\t0\n1\t1\n1\t2\n",
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
        for (text, line) in [
            ("0,0\n1,1.5\n", 2),
            ("x,y\n0,0\n-1,1\n", 3),
            ("a,b\n0,0\n", 1),
            ("x,x\n0,0\n", 1),
            ("x,y\n0,0,0\n", 2),
            ("0,0\n0,1,2,3\n", 2),
            ("{}", 0),
            ("{", 1),
        ] {
            let Err(FormatError::Syntax { line: got, .. }) = read_path(text.as_bytes()) else { panic!("{text:?}") };
            assert_eq!(got, line, "{text:?}");
        }
    }
}
