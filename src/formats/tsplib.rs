//! Instances of TSPLIB: places without a map.

use super::text::lines;

/// Whether a text begins with the keys of an instance.
pub(super) fn looks_like(text: &str) -> bool {
    let key = |line: &str| line.split([':', ' ']).next().unwrap_or("").trim().to_owned();
    let keys: Vec<String> = lines(text).take(40).map(|(_, line)| key(line)).collect();
    let has = |wanted: &str| keys.iter().any(|key| key == wanted);
    has("DIMENSION") && (has("EDGE_WEIGHT_TYPE") || has("NODE_COORD_SECTION") || has("TYPE"))
}
