//! GeoJSON (RFC 7946): a Feature whose geometry is a LineString, for maps whose frame is a coordinate system.
//!
//! The RFC knows WGS 84 in degrees alone. A map is in metres, so its system is another one: coordinates are written as they are, east before
//! north whatever the system's own order, with the member `crs` of GeoJSON 2008, by which GDAL and QGIS know them.

use serde::Deserialize;
use serde_json::{Value, json};

use super::system::{self, WGS_84};
use super::{PathFile, PlannedPath, is_ours, kind_of, object};
use crate::error::{FormatError, Notice};
use crate::formats::path_list::WorldPath;
use crate::formats::text::quote;
use crate::path::PathKind;
use crate::scenario::ScenarioSpec;

/// What a map must have to be written so.
const PLACE: &str =
    "a map with `world` in its scenario, whose `frame` is a code such as EPSG:25832; path-json and nav-msgs need none";

/// What is read.
const LINE: &str = "a Feature, or a collection of one, whose geometry is a LineString of [x, y] or [x, y, z]";

/// Whether the map's frame is a coordinate system.
///
/// # Errors
/// [`FormatError::Field`].
pub(super) fn check(spec: &ScenarioSpec) -> Result<(), FormatError> {
    code_of(spec).map(drop)
}

fn code_of(spec: &ScenarioSpec) -> Result<u32, FormatError> {
    let world = spec.world.as_ref();
    let world = world.ok_or_else(|| FormatError::field("world", "the map's place in the world is not known", PLACE))?;
    let unknown = || match world.frame.as_str() {
        "" => FormatError::field("world.frame", "the map names no coordinate system", PLACE),
        frame => FormatError::field("world.frame", format!("`{}` is no coordinate system with a code", quote(frame)), PLACE),
    };
    let code = system::code(&world.frame).ok_or_else(unknown)?;
    if system::is_in_degrees(code) {
        let what = format!("EPSG:{code} is in degrees, and the map's place and cells are in metres");
        return Err(FormatError::field("world.frame", what, "the code of the projected system in which the map's place is said"));
    }
    Ok(code)
}

/// Writes a path; of a single place its position stands twice, since a LineString has two.
///
/// # Errors
/// As [`check`] and [`PlannedPath::check_metres`].
pub(super) fn write(path: &PlannedPath<'_>) -> Result<PathFile, FormatError> {
    let code = code_of(path.spec)?;
    path.check_metres()?;
    let mut positions: Vec<String> = path.metres.iter().map(|at| json!(at).to_string()).collect();
    if let [only] = &positions[..] {
        positions.push(only.clone());
    }
    let crs = json!({ "type": "name", "properties": { "name": system::urn(code) } });
    let properties = json!({
        "name": path.spec.name, "kind": path.kind, "length": path.length, "length_metres": path.length_metres,
        "resolution": path.spec.resolution,
    });
    let line = positions.join(",\n    ");
    let text = format!(
        "{{\n  \"type\": \"Feature\",\n  \"crs\": {crs},\n  \"properties\": {properties},\n  \"geometry\": {{\"type\": \"LineString\", \"coordinates\": [\n    {line}\n  ]}}\n}}\n"
    );
    Ok(PathFile { text, notices: vec![other_system(code)] })
}

/// That readers which know the RFC alone would take the coordinates for degrees.
fn other_system(code: u32) -> Notice {
    let message = format!(
        "the coordinates are of EPSG:{code}, named by the member `crs` of GeoJSON 2008: RFC 7946 knows degrees of WGS 84 alone, and a reader that leaves `crs` out would misplace the line"
    );
    Notice::new("geojson-crs", message).with("code", code)
}

/// Whether a text is GeoJSON that may hold a line; of JSON that is broken or cut short, by the words in it.
pub(super) fn is_own(text: &str) -> bool {
    #[derive(Deserialize)]
    struct Head {
        r#type: Option<String>,
    }
    if !text.trim_start().starts_with('{') {
        return false;
    }
    match serde_json::from_str::<Head>(text) {
        Ok(head) => matches!(head.r#type.as_deref(), Some("Feature" | "FeatureCollection" | "LineString")),
        Err(_) => !is_ours(text) && ["\"LineString\"", "\"coordinates\""].iter().all(|word| text.contains(word)),
    }
}

/// Reads the line. Its frame is `EPSG:` and the code of `crs`, without one WGS 84.
///
/// # Errors
/// [`FormatError`] with what is no line.
pub(super) fn read(text: &str) -> Result<(WorldPath, PathKind), FormatError> {
    let all = object(text)?;
    let feature = match all["features"].as_array().map(Vec::as_slice) {
        Some([only]) => only,
        Some(several) => return Err(no_line(format!("the collection has {} features", several.len()))),
        None => &all,
    };
    let geometry = if feature["geometry"].is_object() { &feature["geometry"] } else { feature };
    if geometry["type"] != "LineString" {
        return Err(no_line(format!("the geometry is `{}`", quote(geometry["type"].as_str().unwrap_or("missing")))));
    }
    let positions = geometry["coordinates"].as_array().ok_or_else(|| no_line("there are no coordinates"))?;
    let position = |(index, at): (usize, &Value)| place(at).ok_or_else(|| no_line(format!("position {index} is no [x, y]")));
    let places = positions.iter().enumerate().map(position).collect::<Result<_, _>>()?;
    let kind = kind_of(feature["properties"]["kind"].as_str());
    let crs = [&all["crs"], &feature["crs"]].into_iter().find(|crs| !crs.is_null()).unwrap_or(&Value::Null);
    Ok((WorldPath { places, frame: frame(crs)? }, kind))
}

fn no_line(what: impl Into<String>) -> FormatError {
    FormatError::field("geometry", what, LINE)
}

fn place(position: &Value) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> = position.as_array()?.iter().map(Value::as_f64).collect();
    match numbers?[..] {
        [x, y] => Some([x, y, 0.0]),
        [x, y, z, ..] => Some([x, y, z]),
        _ => None,
    }
}

fn frame(crs: &Value) -> Result<String, FormatError> {
    let code = match crs {
        Value::Null => Some(WGS_84),
        crs => crs["properties"]["name"].as_str().and_then(system::code),
    };
    let code = code.ok_or_else(|| FormatError::field("crs", "it names no code", "a name such as urn:ogc:def:crs:EPSG::25832"))?;
    Ok(format!("EPSG:{code}"))
}
