//! `nav_msgs/OccupancyGrid` as `ros2 topic echo` prints it (YAML), or as JSON: rows from the south, −1 for unknown, 0 to 100 for occupancy,
//! or for the costs of a costmap.

use super::costs::of_published;
use super::states::{States, of_percent, tell_of_values_between};
use super::yaml::{self, Value, required};
use crate::error::{FormatError, Notice};
use crate::scenario::World;

/// Occupancies above it are blocked, below the other free, as map_saver writes them.
const THRESHOLDS: (f64, f64) = (0.25, 0.65);

/// A message as read.
pub(in crate::formats) struct Message {
    pub states: States,
    pub resolution: f64,
    pub world: World,
    pub notices: Vec<Notice>,
}

/// Reads a message; `as_costs`: of a costmap.
///
/// # Errors
/// [`FormatError`] with the line of broken YAML, or the field at fault; also for a message that was cut short while printing.
pub(in crate::formats) fn read(text: &str, as_costs: bool) -> Result<Message, FormatError> {
    let message = yaml::read(text)?;
    let side = |field: &'static str| {
        let value = required(&message, &["info", field], field, "a number of cells")?;
        let whole = value.fract() == 0.0 && (1.0..=1e6).contains(&value);
        if whole {
            Ok(value as u32)
        } else {
            Err(FormatError::field(field, value.to_string(), "a whole number of cells, above 0"))
        }
    };
    let (width, height) = (side("width")?, side("height")?);
    let resolution = required(&message, &["info", "resolution"], "resolution", "metres per cell")?;
    if resolution <= 0.0 {
        return Err(FormatError::field("resolution", resolution.to_string(), "metres per cell, above 0"));
    }
    let data = match message.get(&["data"]) {
        Some(data @ (Value::Numbers(_) | Value::Many(_))) => data.many(),
        Some(Value::List(_)) => {
            let hint = "the whole message: ros2 topic echo --once --full-length /map";
            return Err(FormatError::field("data", "the list was cut short while printing", hint));
        }
        _ => return Err(FormatError::field("data", "no list", "one number for each cell")),
    };
    let count = u64::from(width) * u64::from(height);
    if data.len() as u64 != count {
        return Err(FormatError::field(
            "data",
            format!("{} numbers for {width} × {height} cells", data.len()),
            "one for each cell",
        ));
    }
    if let Some(wrong) = data.iter().find(|&&v| !(v == -1.0 || (0.0..=100.0).contains(&v) && v.fract() == 0.0)) {
        return Err(FormatError::field("data", format!("{wrong}"), "−1, or 0 to 100"));
    }
    let from_south = data.chunks(width as usize).rev().flatten();
    let state = |value: f64| if as_costs { of_published(value) } else { of_percent(value, THRESHOLDS.0, THRESHOLDS.1) };
    let cells = from_south.map(|&value| state(f64::from(value))).collect();
    let more = yaml::holds_more(text)
        .then(|| Notice::new("ros-first-message", "the file holds more than one message: the first was read"));
    let between = data.iter().filter(|&&value| !as_costs && (1.0..=99.0).contains(&value)).count();
    let notices = more.into_iter().chain(tell_of_values_between(between)).collect();
    Ok(Message { states: States { width, height, cells }, resolution, world: world(&message)?, notices })
}

/// z and w of a turn about the vertical.
fn upright([x, y, z, w]: [f64; 4]) -> Result<(f64, f64), FormatError> {
    /// What is rounded on its way through text is nearer.
    const SLACK: f64 = 1e-3;
    let refused = |what: String, expected: &str| Err(FormatError::field("orientation", what, expected));
    let length = libm::sqrt(x * x + y * y + z * z + w * w);
    if (length - 1.0).abs() > SLACK {
        return refused(format!("a quaternion of length {length:.4}"), "length 1; without a turn x, y, z are 0 and w is 1");
    }
    if x.abs() > SLACK || y.abs() > SLACK {
        return refused(format!("the map is tilted (x {x}, y {y})"), "a turn about the vertical alone: x and y are 0");
    }
    Ok((z, w))
}

/// Position and heading of the origin.
fn world(message: &Value) -> Result<World, FormatError> {
    let number = |path: &[&str], field| required(message, path, field, "a number");
    let (x, y) = (number(&["info", "origin", "position", "x"], "x")?, number(&["info", "origin", "position", "y"], "y")?);
    let turn = |axis: &'static str| number(&["info", "origin", "orientation", axis], axis);
    let (z, w) = match message.get(&["info", "origin", "orientation"]) {
        Some(given) => {
            let tilt = |axis: &'static str| given.get(&[axis]).map_or(Ok(0.0), |_| turn(axis));
            upright([tilt("x")?, tilt("y")?, turn("z")?, turn("w")?])?
        }
        None => (0.0, 1.0),
    };
    let frame = message.get(&["header", "frame_id"]).and_then(Value::text).unwrap_or("").to_owned();
    Ok(World { x, y, yaw: 2.0 * libm::atan2(z, w), frame })
}
