//! A scenario as JSON: `"format": "formicarium/scenario@1"`, the fields of [`ScenarioSpec`], and the map as rows of `.` and `@`,
//! on a terrain with `"terrain"` and `map.heights`, rows of numbers, `null` where there is no data; on weighted ground with `map.factors`,
//! rows of numbers; with `"robot"` where it is no point, with `"changes"` where walls change, `"drive"` where a robot drives.
//!
//! Nothing is guessed: other versions, unknown fields and unusable values are refused by name. docs/schema has the schema.

use std::sync::Arc;

use serde::Serialize;
use serde_json::{Map, Value, json};

use super::movingai;
use super::text::quote;
use crate::error::FormatError;
use crate::map::{CornerRule, Grid, Movement, check_size};
use crate::scenario::{EnergyRule, Scenario, ScenarioSpec, SmoothingRule, Vehicle};

/// What `format` must say.
pub(super) const FORMAT: &str = "formicarium/scenario@1";

type Object = Map<String, Value>;

/// Reads a scenario and validates it.
///
/// # Errors
/// [`FormatError`] with the line of broken JSON, or the name of the field at fault.
pub(super) fn read(text: &str) -> Result<(Grid, ScenarioSpec), FormatError> {
    let mut object = parse(text)?;
    check_format(&object)?;
    object.remove("format");
    let map = object.remove("map").ok_or_else(|| field_error("`map` is missing", r#"{"rows": ["..@.", …]}"#))?;
    let spec = read_spec(object)?;
    let grid = read_map(&map, &spec)?;
    // Validation takes both and gives them back.
    let scenario = Scenario::new(grid, spec)?;
    Ok((scenario.drawn, scenario.spec))
}

/// Reads the fields of a scenario that comes without its map; nothing is validated against one.
///
/// # Errors
/// As [`read`].
pub(super) fn read_spec_alone(text: &str) -> Result<ScenarioSpec, FormatError> {
    read_spec(parse(text)?)
}

/// What `format` says, if the text is a JSON object that has one.
pub(super) fn format_of(text: &str) -> Option<String> {
    #[derive(serde::Deserialize)]
    struct Head {
        format: String,
    }
    serde_json::from_str::<Head>(text).ok().map(|h| h.format)
}

fn parse(text: &str) -> Result<Object, FormatError> {
    let syntax = |e: serde_json::Error| FormatError::syntax(e.line(), format!("broken JSON: {e}"), "a JSON object");
    match serde_json::from_str(text).map_err(syntax)? {
        Value::Object(object) => Ok(object),
        _ => Err(field_error("the JSON is not an object", format!(r#"an object with "format": "{FORMAT}""#))),
    }
}

fn check_format(object: &Object) -> Result<(), FormatError> {
    match object.get("format") {
        Some(Value::String(format)) if format == FORMAT => Ok(()),
        Some(Value::String(format)) => Err(FormatError::Version { found: quote(format), expected: FORMAT }),
        Some(other) => Err(FormatError::Version { found: quote(&other.to_string()), expected: FORMAT }),
        None => Err(FormatError::Version { found: "missing".into(), expected: FORMAT }),
    }
}

fn field_error(what: impl Into<String>, expected: impl Into<String>) -> FormatError {
    FormatError::syntax(0, what, expected)
}

/// Fills in what the format lets people leave out.
fn complete(object: &mut Object) {
    fn fill(object: &mut Object, key: &str, value: Value) {
        object.entry(key).or_insert(value);
    }
    fill(object, "name", json!(""));
    fill(object, "resolution", json!(1.0));
    fill(object, "movement", json_value(&Movement::default()));
    fill(object, "vehicle", json_value(&Vehicle::default()));
    if object.get("changes").and_then(Value::as_array).is_some_and(Vec::is_empty) {
        object.remove("changes");
    }
    for change in object.get_mut("changes").and_then(Value::as_array_mut).into_iter().flatten().filter_map(Value::as_object_mut) {
        ["blocked", "freed"].into_iter().for_each(|key| fill(change, key, json!([])));
    }
    if let Some(Value::Object(vehicle)) = object.get_mut("vehicle") {
        let Vehicle { speed, seconds_per_turn, .. } = Vehicle::default();
        fill(vehicle, "speed", json!(speed));
        fill(vehicle, "seconds_per_turn", json!(seconds_per_turn));
        let rules = [("energy", json_value(&EnergyRule::default())), ("smoothing", json_value(&SmoothingRule::default()))];
        for (rule, default) in rules {
            let (Some(Value::Object(rule)), Value::Object(default)) = (vehicle.get_mut(rule), default) else { continue };
            default.into_iter().for_each(|(key, value)| fill(rule, &key, value));
        }
    }
    if let Some(Value::Object(movement)) = object.get_mut("movement") {
        fill(movement, "corner_rule", json_value(&CornerRule::default()));
    }
    if let Some(Value::Array(goals)) = object.get_mut("goals") {
        for goal in goals.iter_mut().filter_map(Value::as_object_mut) {
            fill(goal, "name", json!(""));
            ["area", "strength", "danger"].into_iter().for_each(|key| fill(goal, key, json!(1.0)));
        }
    }
}

/// Reads the fields of a scenario but for its format and map.
pub(super) fn read_spec(mut object: Object) -> Result<ScenarioSpec, FormatError> {
    complete(&mut object);
    let read = Value::Object(object);
    let spec: ScenarioSpec =
        serde_json::from_value(read.clone()).map_err(|e| field_error(e.to_string(), "the fields of docs/formats.md"))?;
    // Written out again, a scenario shows every field there is: what the file has beyond them is unknown.
    refused_field(&read, &json_value(&spec), "").map_or(Ok(spec), Err)
}

/// What is wrong with the first field of `read`, at a path, that `known` lacks, or that stands as a list where names are asked for.
fn refused_field(read: &Value, known: &Value, path: &str) -> Option<FormatError> {
    match (read, known) {
        (Value::Object(read), Value::Object(known)) => read.iter().find_map(|(key, value)| {
            let at = if path.is_empty() { quote(key) } else { format!("{path}.{}", quote(key)) };
            match known.get(key) {
                Some(k) => refused_field(value, k, &at),
                None if value.is_null() => {
                    Some(field_error(format!("`{at}` is null"), "a field that is left out where there is none"))
                }
                None => {
                    let names = known.keys().cloned().collect::<Vec<_>>().join(", ");
                    Some(field_error(format!("there is no field `{at}`"), format!("only {names} here")))
                }
            }
        }),
        (Value::Array(read), Value::Array(known)) => read.iter().zip(known).find_map(|(value, k)| refused_field(value, k, path)),
        (Value::Array(_), Value::Object(known)) => {
            let names = known.keys().cloned().collect::<Vec<_>>().join(", ");
            Some(field_error(format!("`{path}` is a list"), format!("an object with the names {names}")))
        }
        _ => None,
    }
}

/// Reads `map`: rows of letters, on a terrain rows of heights.
pub(super) fn read_map(map: &Value, spec: &ScenarioSpec) -> Result<Grid, FormatError> {
    const EXPECTED: &str = r#"{"rows": ["..@.", …]} with `.` for free and `@` for blocked"#;
    const FIELDS: [&str; 3] = ["rows", "heights", "factors"];
    if let Some(key) = map.as_object().and_then(|m| m.keys().find(|key| !FIELDS.contains(&key.as_str()))) {
        return Err(field_error(format!("there is no field `map.{}`", quote(key)), EXPECTED));
    }
    check_size(u64::from(spec.width), u64::from(spec.height))?;
    let rows = map.get("rows").and_then(Value::as_array).ok_or_else(|| field_error("`map.rows` is no list", EXPECTED))?;
    if rows.len() != spec.height as usize {
        let what = format!("`map.rows` has {} rows where `height` is {}", rows.len(), spec.height);
        return Err(field_error(what, EXPECTED));
    }
    let mut cells = Vec::with_capacity(spec.width as usize * spec.height as usize);
    for (y, row) in rows.iter().enumerate() {
        let row = row.as_str().ok_or_else(|| field_error(format!("row {y} of the map is no text"), EXPECTED))?;
        if row.chars().count() != spec.width as usize {
            let what = format!("row {y} of the map has {} cells where `width` is {}", row.chars().count(), spec.width);
            return Err(field_error(what, EXPECTED));
        }
        for (x, letter) in row.chars().enumerate() {
            cells.push(match letter {
                '.' => 0,
                '@' => 1,
                _ => return Err(field_error(format!("`{letter}` at ({x}, {y}) is no cell"), EXPECTED)),
            });
        }
    }
    let grid = Grid::from_bytes(spec.width, spec.height, &cells)?;
    let grid = match map.get("heights") {
        Some(heights) => grid.with_heights(read_numbers(heights, spec, HEIGHTS)?)?,
        None => grid,
    };
    match map.get("factors") {
        Some(factors) => Ok(grid.with_factors(read_numbers(factors, spec, FACTORS)?)?),
        None => Ok(grid),
    }
}

/// A field of `map` with one number for each cell.
#[derive(Clone, Copy)]
struct Numbers {
    field: &'static str,
    one: &'static str,
    /// Whether `null` stands for a cell without one.
    null: bool,
    expected: &'static str,
}

const HEIGHTS: Numbers = Numbers {
    field: "heights",
    one: "height",
    null: true,
    expected: r#""heights": [[12.5, 13, null, …], …], one number for each cell, `null` for no data"#,
};

const FACTORS: Numbers = Numbers {
    field: "factors",
    one: "factor",
    null: false,
    expected: r#""factors": [[1, 2.5, 1, …], …], one number for each cell, 1 to 1000"#,
};

fn read_numbers(numbers: &Value, spec: &ScenarioSpec, of: Numbers) -> Result<Vec<f32>, FormatError> {
    let Numbers { field, one, null, expected } = of;
    let rows = numbers.as_array().ok_or_else(|| field_error(format!("`map.{field}` is no list"), expected))?;
    if rows.len() != spec.height as usize {
        return Err(field_error(format!("`map.{field}` has {} rows where `height` is {}", rows.len(), spec.height), expected));
    }
    let mut values = Vec::with_capacity(spec.width as usize * spec.height as usize);
    for (y, row) in rows.iter().enumerate() {
        let row = row
            .as_array()
            .filter(|row| row.len() == spec.width as usize)
            .ok_or_else(|| field_error(format!("row {y} of the {field} is no list of {} numbers", spec.width), expected))?;
        for (x, value) in row.iter().enumerate() {
            values.push(match value {
                Value::Null if null => f32::NAN,
                Value::Number(n) => {
                    let height = n.as_f64().map_or(f32::NAN, |v| v as f32);
                    let wrong = || field_error(format!("{n} at ({x}, {y}) is no {one}"), expected);
                    Some(height).filter(|h| h.is_finite()).ok_or_else(wrong)?
                }
                other => return Err(field_error(format!("{} at ({x}, {y}) is no {one}", quote(&other.to_string())), expected)),
            });
        }
    }
    Ok(values)
}

/// The scenario as a file: one line for each field and for each row of the map.
pub(super) fn write(grid: &Grid, spec: &ScenarioSpec) -> String {
    // Taken apart, so that a new field cannot be forgotten.
    let ScenarioSpec {
        name,
        width,
        height,
        resolution,
        movement,
        start,
        goals,
        vehicle,
        terrain,
        world,
        #[cfg(feature = "whole")]
        robot,
        #[cfg(feature = "whole")]
        changes,
        #[cfg(feature = "whole")]
        drive,
    } = spec;
    let fields = [
        ("format", text(&FORMAT)),
        ("name", text(name)),
        ("width", text(width)),
        ("height", text(height)),
        ("resolution", text(resolution)),
        ("movement", text(movement)),
        ("start", text(start)),
        ("goals", text(goals)),
        ("vehicle", text(vehicle)),
    ];
    let terrain = terrain.iter().map(|terrain| ("terrain", text(terrain)));
    let world = world.iter().map(|world| ("world", text(world)));
    let fields = fields.into_iter().chain(terrain).chain(world);
    #[cfg(feature = "whole")]
    let fields = fields.chain(robot.iter().map(|robot| ("robot", text(robot))));
    #[cfg(feature = "whole")]
    let fields = fields.chain((!changes.is_empty()).then(|| ("changes", text(changes))));
    #[cfg(feature = "whole")]
    let fields = fields.chain(drive.iter().map(|drive| ("drive", text(drive))));
    let fields: String = fields.map(|(key, value)| format!("  \"{key}\": {value},\n")).collect();
    let rows: Vec<String> = movingai::rows(grid).map(|row| format!("    \"{row}\"")).collect();
    format!(
        "{{\n{fields}  \"map\": {{\"rows\": [\n{}\n  ]{}}}\n}}\n",
        rows.join(",\n"),
        write_numbers("heights", grid.heights(), grid) + &write_numbers("factors", grid.factors(), grid)
    )
}

/// Heights or factors as a field behind the rows, one line for each row of the map; nothing where there are none.
fn write_numbers(field: &str, numbers: Option<&Arc<[f32]>>, grid: &Grid) -> String {
    let Some(numbers) = numbers else { return String::new() };
    // Shortest digits that give back the same f32; what is not finite becomes null.
    let row = |row: &[f32]| format!("    {}", text(&row));
    let rows: Vec<String> = numbers.chunks(grid.width() as usize).map(row).collect();
    format!(", \"{field}\": [\n{}\n  ]", rows.join(",\n"))
}

/// Why writing cannot fail.
const PLAIN: &str = "a scenario is numbers, texts and lists, which can always be written as JSON";

fn json_value(value: &impl Serialize) -> Value {
    serde_json::to_value(value).expect(PLAIN)
}

fn text(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect(PLAIN)
}
