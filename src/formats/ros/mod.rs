//! Files of ROS: the description of a map (`map.yaml`) with its picture, OccupancyGrid and Path messages; and instances of multi-agent path
//! finding, which are YAML as well.

use super::text::lines;

/// Keys at the beginning of lines that are not indented; of an object of JSON, its names.
fn has_keys(text: &str, wanted: &[&str]) -> bool {
    if text.trim_start().starts_with('{') {
        return wanted.iter().all(|key| text.contains(&format!("\"{key}\"")));
    }
    let is_key = |line: &str, key: &str| line.strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with(':'));
    wanted.iter().all(|key| lines(text).take(4096).any(|(_, line)| is_key(line, key)))
}

/// Whether a text is the description of a map: `image`, `resolution` and `origin`.
pub(super) fn is_map_description(text: &str) -> bool {
    has_keys(text, &["image", "resolution"]) || has_keys(text, &["image", "origin"])
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
