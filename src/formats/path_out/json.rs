//! `formicarium/path@1`: a path with what is known of its map, one field a line.

use serde::Deserialize;
use serde_json::{Value, json};

use super::{ANY_VERSION, CURVE, FORMAT, PlannedPath, ReadPath, check_version, is_ours, kind_of, object, with_levels};
use crate::error::FormatError;
use crate::formats::path_list::WorldPath;
use crate::map::Point;

/// What a path needs to be read.
const EXPECTED: &str = "`cells`: [[x, y], …], and by slices `levels`: [level, …]";

pub(super) fn write(path: &PlannedPath<'_>) -> String {
    let spec = path.spec;
    let fields = [
        ("format", json!(FORMAT)),
        ("name", json!(spec.name)),
        ("width", json!(spec.width)),
        ("height", json!(spec.height)),
        ("resolution", json!(spec.resolution)),
        ("kind", json!(path.kind)),
        ("frame", json!(spec.world.as_ref().map(|world| &world.frame))),
        ("length", json!(path.length)),
        ("length_metres", json!(path.length_metres)),
        match &path.curve {
            Some(curve) => ("curve", json!(curve.points)),
            None => ("cells", json!(path.cells)),
        },
    ];
    let levels = path.levels.as_ref().map(|levels| ("levels", json!(levels)));
    let fields = fields.into_iter().chain(levels).chain([("metres", json!(path.metres))]);
    let lines: Vec<String> = fields.map(|(key, value)| format!("  \"{key}\": {value}")).collect();
    format!("{{\n{}\n}}\n", lines.join(",\n"))
}

/// Whether a text is a path of this program in any version; broken JSON tells it too, so that the error is about the line.
pub(super) fn is_own(text: &str) -> bool {
    is_ours(text)
        && match crate::formats::format_of(text) {
            Some(format) => format.starts_with(ANY_VERSION),
            None => text.contains(&format!("\"{ANY_VERSION}")),
        }
}

/// Reads the cells.
///
/// # Errors
/// [`FormatError`]: broken JSON, another version, or a field that cannot be used.
pub(super) fn read(text: &str) -> Result<ReadPath, FormatError> {
    let mut path = object(text)?;
    check_version(path["format"].as_str().unwrap_or_default())?;
    let cells: Vec<Point> = list("cells", path["cells"].take())?;
    let levels = path.get_mut("levels").map(Value::take).map(|levels| list("levels", levels)).transpose()?;
    Ok(ReadPath { places: with_levels(cells, levels)?, kind: kind_of(path["kind"].as_str()) })
}

/// Reads the metres of a curve; none for any other path.
///
/// # Errors
/// As [`read`].
pub(super) fn read_curve(text: &str) -> Option<Result<WorldPath, FormatError>> {
    let mut path = object(text).ok().filter(|path| path["kind"] == CURVE)?;
    let mut read = || {
        check_version(path["format"].as_str().unwrap_or_default())?;
        let places: Vec<Vec<f64>> = list("metres", path["metres"].take())?;
        let place = |at: &Vec<f64>| match at[..] {
            [x, y] => Ok([x, y, 0.0]),
            [x, y, z] => Ok([x, y, z]),
            _ => Err(FormatError::field("metres", "a place without x and y", "[x, y] or [x, y, z] in metres")),
        };
        let places = places.iter().map(place).collect::<Result<_, _>>()?;
        Ok(WorldPath { places, frame: path["frame"].as_str().unwrap_or_default().into() })
    };
    Some(read())
}

fn list<T: for<'a> Deserialize<'a>>(field: &'static str, value: Value) -> Result<Vec<T>, FormatError> {
    serde_json::from_value(value).map_err(|e| FormatError::field(field, e.to_string(), EXPECTED))
}
