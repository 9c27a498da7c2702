//! Files of ROS: the description of a map (`map.yaml`) with its picture, OccupancyGrid and Path messages; and instances of multi-agent path
//! finding, which are YAML as well.

mod costs;
mod map_server;
mod mapf;
mod occupancy_grid;
mod states;
mod write;
mod yaml;

use std::borrow::Cow;

use super::imported_map::Imported;
use super::kind::Kind;
use super::options::ReadOptions;
use super::path_list::WorldPath;
use super::picture;
use super::text::{self, lines};
use crate::error::{Error, FormatError, Notice};

pub use costs::Costs;
use map_server::Description;
pub use states::Unknown;
pub use write::{RosMap, write};

/// Keys at the beginning of lines that are not indented; of an object of JSON, its names.
fn has_keys(text: &str, wanted: &[&str]) -> bool {
    if text.trim_start().starts_with('{') {
        return wanted.iter().all(|key| text.contains(&format!("\"{key}\"")));
    }
    let is_key = |line: &str, key: &str| line.strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with(':'));
    wanted.iter().all(|key| lines(text).take(4096).any(|(_, line)| is_key(line, key)))
}

/// A description with blanks for tabs behind its colons: YAML has both, the parser only blanks.
fn without_tabs(text: &str) -> Cow<'_, str> {
    if text.contains(":\t") { Cow::Owned(text.replace(":\t", ": ")) } else { Cow::Borrowed(text) }
}

/// Whether a text is the description of a map: `image`, `resolution` and `origin`.
pub(super) fn is_map_description(text: &str) -> bool {
    /// A description is a few lines.
    const LONGEST: usize = 1 << 14;
    if has_keys(text, &["image", "resolution"]) || has_keys(text, &["image", "origin"]) {
        return true;
    }
    // With keys between quotation marks, or in braces.
    let may_be = text.len() <= LONGEST && text.contains("image") && (text.contains("resolution") || text.contains("origin"));
    let has = |document: &yaml::Value, key: &str| document.get(&[key]).is_some();
    may_be
        && yaml::read(&without_tabs(text)).is_ok_and(|all| has(&all, "image") && (has(&all, "resolution") || has(&all, "origin")))
}

/// Whether a text is an OccupancyGrid message.
pub(super) fn is_occupancy_grid(text: &str) -> bool {
    has_keys(text, &["info", "data"])
}

/// Whether a text is a Path message.
pub(super) fn is_path(text: &str) -> bool {
    has_keys(text, &["poses"])
}

/// Whether a text is an instance of multi-agent path finding.
pub(super) fn is_mapf(text: &str) -> bool {
    has_keys(text, &["map", "agents"]) || has_keys(text, &["map", "robots"])
}

/// The name of the picture that a description names, perhaps with folders.
///
/// # Errors
/// [`FormatError`]: the description cannot be used.
pub fn image_of(yaml: &[u8]) -> Result<String, Error> {
    Ok(Description::read(&text::decode(yaml)?)?.image)
}

/// Reads a description with its picture.
///
/// # Errors
/// [`FormatError`]: either cannot be read.
pub(super) fn read_map(yaml: &[u8], image: &[u8], name: &str, options: &ReadOptions) -> Result<Imported, Error> {
    let description = Description::read(&text::decode(yaml)?)?;
    let (states, notices) = description.states(&picture::decode(image)?, options.costs.is_some());
    let placed = Placed { kind: Kind::RosMap, states, resolution: description.resolution, world: description.world, notices };
    Ok(placed.import(name, options)?)
}

/// Reads an OccupancyGrid message.
///
/// # Errors
/// [`FormatError`] with the line or the field at fault.
pub(super) fn read_message(text: &str, name: &str, options: &ReadOptions) -> Result<Imported, FormatError> {
    let occupancy_grid::Message { states, resolution, world, notices } = occupancy_grid::read(text, options.costs.is_some())?;
    Placed { kind: Kind::OccupancyGrid, states, resolution, world, notices }.import(name, options)
}

/// Reads a Path message.
///
/// # Errors
/// [`FormatError`] with the line of broken YAML, or the number of the pose at fault, from 0; also for several messages in one file.
pub(super) fn read_path(text: &str) -> Result<WorldPath, FormatError> {
    let message = yaml::read(text)?;
    if yaml::holds_more(text) {
        let hint = "one message: ros2 topic echo --once --full-length /plan";
        return Err(FormatError::field("poses", "the file holds more than one message", hint));
    }
    let poses = message.get(&["poses"]).and_then(yaml::Value::list);
    let poses =
        poses.ok_or_else(|| FormatError::field("poses", "no list of poses", "what ros2 topic echo --full-length prints"))?;
    let read = |(index, pose): (usize, &yaml::Value)| {
        let number = |axis: &str| {
            let stamped = pose.get(&["pose", "position", axis]).or_else(|| pose.get(&["position", axis]));
            stamped.and_then(yaml::Value::number)
        };
        let missing = || FormatError::field("poses", format!("pose {index} has no position"), "position: {x, y}");
        Ok([number("x").ok_or_else(missing)?, number("y").ok_or_else(missing)?, number("z").unwrap_or(0.0)])
    };
    let places = poses.iter().enumerate().map(read).collect::<Result<_, FormatError>>()?;
    let frame = message.get(&["header", "frame_id"]).and_then(yaml::Value::text).unwrap_or("").to_owned();
    Ok(WorldPath { places, frame })
}

/// Reads an instance of multi-agent path finding.
///
/// # Errors
/// [`FormatError`] with the line or the field at fault.
pub(super) fn read_mapf(text: &str, name: &str) -> Result<Imported, FormatError> {
    let mapf::Instance { grid, start, goal, notices } = mapf::read(text)?;
    super::complete(Kind::Mapf, name, grid, start, goal, notices)
}

/// Cells with their place in the world.
struct Placed {
    kind: Kind,
    states: states::States,
    resolution: f64,
    world: crate::scenario::World,
    notices: Vec<Notice>,
}

impl Placed {
    fn import(self, name: &str, options: &ReadOptions) -> Result<Imported, FormatError> {
        let rows = self.states.height;
        let (states, grown, shrunk) = self.states.shrunk(options.cells)?;
        let (grid, counted) = states.grid(options.unknown, options.costs)?;
        let unknown = states.unknown(options.unknown)?;
        let mut notices = self.notices;
        notices.extend(counted);
        notices.extend(shrunk);
        let mut imported = super::complete(self.kind, name, grid, None, None, notices)?;
        let resolution = self.resolution * f64::from(grown);
        // Fewer cells may reach a little beyond the lower edge: the upper one stays where it is.
        let below = f64::from(states.height * grown - rows) * self.resolution;
        imported.spec.resolution = resolution;
        imported.spec.world = Some(self.world.moved(0.0, -below));
        imported.unknown = unknown;
        Ok(imported)
    }
}
