//! A map for map_server: `map.yaml` and `map.pgm`.

use crate::formats::picture::write_pgm;
use crate::map::{Cell, Grid};
use crate::scenario::ScenarioSpec;

/// Grays of free, unknown and occupied cells, as map_saver writes them.
const FREE: u8 = 254;
const UNKNOWN: u8 = 205;
const OCCUPIED: u8 = 0;

/// The two files of a map.
pub struct RosMap {
    /// `map.yaml`.
    pub yaml: String,
    /// The picture that it names.
    pub pgm: Vec<u8>,
}

/// Writes cells and place of a map; blocked cells that are blocked in `unknown`, a grid of the same size, as unknown ones. `image` is the name
/// of the picture beside the description. Read again, it has the same cells and the same origin: a map without one lies at (0, 0).
pub fn write(grid: &Grid, unknown: Option<&Grid>, spec: &ScenarioSpec, image: &str) -> RosMap {
    let gray = |cell: Cell| match grid.is_blocked(cell) {
        false => FREE,
        true if unknown.is_some_and(|unknown| unknown.is_blocked(cell)) => UNKNOWN,
        true => OCCUPIED,
    };
    let gray: Vec<u8> = (0..grid.len() as Cell).map(gray).collect();
    let (x, y, yaw) = spec.world.as_ref().map_or((0.0, 0.0, 0.0), |world| (world.x, world.y, world.yaw));
    // A name in quotes: JSON's are YAML's.
    let image = serde_json::Value::from(image);
    let yaml = format!(
        "image: {image}\nmode: trinary\nresolution: {}\norigin: [{x:?}, {y:?}, {yaw:?}]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n",
        spec.resolution
    );
    RosMap { yaml, pgm: write_pgm(grid.width(), grid.height(), &gray) }
}
