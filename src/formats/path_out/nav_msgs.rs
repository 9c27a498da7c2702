//! `nav_msgs/msg/Path` of ROS 2, as `ros2 topic echo` prints one and `ros2 topic pub` takes it.

use std::fmt::Write;

use super::{PathFile, PlannedPath};
use crate::error::{FormatError, Notice};

/// The frame of a map that names none, as map_server publishes it.
const USUAL_FRAME: &str = "map";

/// Writes a pose a place: on a terrain at its altitude, elsewhere at z = 0, looking to the next place, the last one as the one before it.
///
/// A map whose place is not known lies at (0, 0), where the ROS map that is written of it lies too, so that both fit each other; a notice
/// says so.
///
/// # Errors
/// See [`PlannedPath::check_metres`].
pub(super) fn write(path: &PlannedPath<'_>) -> Result<PathFile, FormatError> {
    path.check_metres()?;
    let frame = path.spec.world.as_ref().map_or("", |world| &world.frame);
    // A name in quotes: JSON's are YAML's.
    let frame = serde_json::Value::from(if frame.is_empty() { USUAL_FRAME } else { frame });
    let mut text = format!("header:\n  stamp:\n    sec: 0\n    nanosec: 0\n  frame_id: {frame}\nposes:\n");
    for (at, [z, w]) in path.metres.iter().zip(headings(&path.metres)) {
        let _ = write!(text, "- header:\n    stamp:\n      sec: 0\n      nanosec: 0\n    frame_id: {frame}\n  pose:\n");
        let place = ["x", "y", "z"].into_iter().enumerate().map(|(axis, name)| (name, at.get(axis).copied().unwrap_or(0.0)));
        numbers(&mut text, "position", place);
        numbers(&mut text, "orientation", [("x", 0.0), ("y", 0.0), ("z", z), ("w", w)].into_iter());
    }
    Ok(PathFile { text, notices: unplaced(path).into_iter().collect() })
}

fn numbers(text: &mut String, key: &str, values: impl Iterator<Item = (&'static str, f64)>) {
    let _ = writeln!(text, "    {key}:");
    for (name, value) in values {
        let _ = writeln!(text, "      {name}: {}", real(value));
    }
}

/// A number that every reader of YAML takes for a real one: with a point, without an exponent.
fn real(value: f64) -> String {
    let text = value.to_string();
    if text.contains('.') { text } else { text + ".0" }
}

/// z and w of the quaternion that turns about the vertical towards the next place; x and y are 0. East for a path of one place.
fn headings(metres: &[Vec<f64>]) -> Vec<[f64; 2]> {
    let turned = |step: &[Vec<f64>]| {
        let yaw = libm::atan2(step[1][1] - step[0][1], step[1][0] - step[0][0]);
        [libm::sin(yaw / 2.0), libm::cos(yaw / 2.0)]
    };
    let mut all: Vec<[f64; 2]> = metres.windows(2).map(turned).collect();
    all.push(all.last().copied().unwrap_or([0.0, 1.0]));
    all
}

/// That the map has no place.
fn unplaced(path: &PlannedPath<'_>) -> Option<Notice> {
    let message =
        "the map's place in the world is not known: its lower left corner is (0, 0), as in the ROS map that `convert` writes";
    path.spec.world.is_none().then(|| Notice::new("path-unplaced", message))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poses_look_along_the_way() {
        let half = libm::sqrt(0.5);
        let near = |found: [f64; 2], wanted: [f64; 2]| (0..2).all(|i| (found[i] - wanted[i]).abs() < 1e-12);
        let found = headings(&[vec![0.0, 0.0], vec![1.0, 0.0], vec![1.0, 2.0], vec![0.0, 2.0]]);
        for (found, wanted) in found.iter().zip([[0.0, 1.0], [half, half], [1.0, 0.0], [1.0, 0.0]]) {
            assert!(near(*found, wanted), "{found:?} {wanted:?}");
        }
        assert_eq!(headings(&[vec![3.0, 4.0]]), [[0.0, 1.0]]);
    }

    #[test]
    fn numbers_have_a_point_and_no_exponent() {
        assert_eq!([0.0, -2.0, 1e9, 1e-7].map(real), ["0.0", "-2.0", "1000000000.0", "0.0000001"]);
    }
}
