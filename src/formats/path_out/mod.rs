//! A path as a file for other programs, one file a format. What is written here [`super::read_path_on`] reads back to the same cells.

mod csv;
mod geojson;
mod json;
mod nav_msgs;
mod planned;
mod svg;
mod svg_walls;
mod system;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::path_list::WorldPath;
use super::text::is_ours;
use crate::error::{FormatError, Notice};
use crate::map::Point;
use crate::path::PathKind;
use crate::scenario::ScenarioSpec;

pub use planned::PlannedPath;
pub(super) use planned::placed;

/// What the field `format` of a path says.
const FORMAT: &str = "formicarium/path@1";

/// What the kind of a path says that is written as its smooth curve.
const CURVE: &str = "curve";

/// What every version of it begins with.
const ANY_VERSION: &str = "formicarium/path@";

/// A format in which a path can be written. Serialized as [`PathFormat::id`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum PathFormat {
    /// A line a place: cell, level, metres.
    PathCsv,
    /// Cells and metres with what is known of the map: `formicarium/path@1`.
    PathJson,
    /// A Path message of ROS 2, as YAML.
    NavMsgs,
    /// A line for geographic information systems.
    Geojson,
    /// A drawing of the map and the path.
    Svg,
}

/// A path as a file.
#[derive(Debug, Clone, PartialEq)]
pub struct PathFile {
    /// What it holds.
    pub text: String,
    /// What was assumed.
    pub notices: Vec<Notice>,
}

impl PathFormat {
    /// Every format.
    pub const ALL: [Self; 5] = [Self::PathCsv, Self::PathJson, Self::NavMsgs, Self::Geojson, Self::Svg];

    /// Its name on the command line and in scripts.
    pub const fn id(self) -> &'static str {
        match self {
            Self::PathCsv => "path-csv",
            Self::PathJson => "path-json",
            Self::NavMsgs => "nav-msgs",
            Self::Geojson => "geojson",
            Self::Svg => "svg",
        }
    }

    /// How the names of its files end.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::PathCsv => ".path.csv",
            Self::PathJson => ".path.json",
            Self::NavMsgs => ".path.yaml",
            Self::Geojson => ".geojson",
            Self::Svg => ".path.svg",
        }
    }

    /// What a browser calls its files.
    pub const fn media_type(self) -> &'static str {
        match self {
            Self::PathCsv => "text/csv",
            Self::PathJson => "application/json",
            Self::NavMsgs => "application/yaml",
            Self::Geojson => "application/geo+json",
            Self::Svg => "image/svg+xml",
        }
    }

    /// Whether paths on this map can be written so.
    ///
    /// # Errors
    /// [`FormatError::Field`] for GeoJSON of a map without a coordinate system.
    pub fn check(self, spec: &ScenarioSpec) -> Result<(), FormatError> {
        if self == Self::Geojson { geojson::check(spec) } else { Ok(()) }
    }

    /// Writes a path.
    ///
    /// # Errors
    /// As [`PathFormat::check`]; and where the map is so far from zero that its cells are not told apart in metres.
    pub fn write(self, path: &PlannedPath<'_>) -> Result<PathFile, FormatError> {
        let plain = |text| Ok(PathFile { text, notices: Vec::new() });
        let PathFile { text, notices } = match self {
            Self::PathCsv => plain(csv::write(path)),
            Self::PathJson => plain(json::write(path)),
            Self::NavMsgs => nav_msgs::write(path),
            Self::Geojson => geojson::write(path),
            Self::Svg => plain(svg::write(path)),
        }?;
        Ok(PathFile { text, notices: [path.notices(), notices].concat() })
    }
}

/// Places of a path, each with its level by slices, and how they follow each other where the file says so.
pub(super) struct ReadPath {
    pub places: Vec<(Point, Option<u32>)>,
    pub kind: PathKind,
}

/// Reads a path in cells that was written here, as JSON or as a drawing; none for any other text.
///
/// # Errors
/// [`FormatError`]: another version, or what is wrong in which field.
pub(super) fn read_own(text: &str) -> Option<Result<ReadPath, FormatError>> {
    if svg::is_own(text) {
        Some(svg::read(text))
    } else if json::is_own(text) {
        Some(json::read(text))
    } else {
        None
    }
}

/// Reads a curve in metres that was written here as JSON; none for any other text.
///
/// # Errors
/// As [`read_own`].
pub(super) fn read_curve(text: &str) -> Option<Result<WorldPath, FormatError>> {
    if json::is_own(text) { json::read_curve(text) } else { None }
}

/// Reads a line of GeoJSON; none for any other text.
///
/// # Errors
/// [`FormatError`] with what is no line.
pub(super) fn read_geojson(text: &str) -> Option<Result<(WorldPath, PathKind), FormatError>> {
    geojson::is_own(text).then(|| geojson::read(text))
}

/// Whether a text, or the first part of one, is a path in JSON or SVG.
pub(super) fn looks_like(text: &str) -> bool {
    svg::is_own(text) || geojson::is_own(text)
}

/// Refuses other versions.
fn check_version(found: &str) -> Result<(), FormatError> {
    if found == FORMAT { Ok(()) } else { Err(FormatError::Version { found: found.into(), expected: FORMAT }) }
}

/// The kind of a path's joints as files name it.
fn kind_of(word: Option<&str>) -> PathKind {
    if word == Some("polyline") { PathKind::Polyline } else { PathKind::Steps }
}

/// The value of a text that begins as an object of JSON.
fn object(text: &str) -> Result<Value, FormatError> {
    serde_json::from_str(text).map_err(|e| FormatError::syntax(e.line(), format!("broken JSON: {e}"), "an object of JSON"))
}

/// Places with the levels that belong to them.
///
/// # Errors
/// [`FormatError::Field`] where their numbers differ.
fn with_levels(cells: Vec<Point>, levels: Option<Vec<u32>>) -> Result<Vec<(Point, Option<u32>)>, FormatError> {
    let Some(levels) = levels else { return Ok(cells.into_iter().map(|at| (at, None)).collect()) };
    if levels.len() != cells.len() {
        let what = format!("there are {} levels for {} cells", levels.len(), cells.len());
        return Err(FormatError::field("levels", what, "one level for each cell"));
    }
    Ok(cells.into_iter().zip(levels.into_iter().map(Some)).collect())
}
