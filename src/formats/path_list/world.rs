//! Paths in metres of the world, and the cells in which their places lie.

use crate::error::{FormatError, Notice};
use crate::formats::path_out::placed;
use crate::map::Point;
use crate::scenario::{ScenarioSpec, TerrainMoves, TerrainSpec};

/// A path in metres: a Path message of ROS, or a line of GeoJSON.
#[derive(Debug, Clone, PartialEq)]
pub struct WorldPath {
    /// x, y and z of its places; z is 0 where the file has none.
    pub places: Vec<[f64; 3]>,
    /// In which frame they are; empty where the file does not say.
    pub frame: String,
}

impl WorldPath {
    /// The cells in which its places lie, one for each run of places in the same cell; by slices with the level nearest to z.
    ///
    /// # Errors
    /// [`FormatError::Field`] with the number of the place that lies beside the map.
    pub fn on(&self, spec: &ScenarioSpec) -> Result<Vec<(Point, Option<u32>)>, FormatError> {
        let expected = "places on the map: check against the one that the path was planned on";
        let (placed, level) = (placed(spec), metres_of_level(spec));
        let mut places = Vec::with_capacity(self.places.len());
        for (index, &[x, y, z]) in self.places.iter().enumerate() {
            let beside = || FormatError::field("poses", format!("pose {index} ({x}, {y}) lies beside the map"), expected);
            let at = placed.to_cell([x, y]).ok_or_else(beside)?;
            // Far above or below what there is the cast stops at an end: the audit says so.
            places.push((at, level.map(|level| libm::round(z / level) as u32)));
        }
        places.dedup();
        Ok(places)
    }

    /// What is worth saying of the path and a map: no place, or another frame; the description of a ROS map names none, and map_server
    /// publishes it as `map`.
    pub fn notices(&self, spec: &ScenarioSpec) -> Vec<Notice> {
        let Some(world) = &spec.world else {
            let message = "the map's place in the world is not known: the path's metres count from its lower left corner";
            return vec![Notice::new("path-map-unplaced", message)];
        };
        let (path, map) = (&self.frame, &world.frame);
        let differ = |map: &str| !path.is_empty() && !path.trim_start_matches('/').eq_ignore_ascii_case(map);
        if map.is_empty() {
            let message =
                || format!("the path is in the frame {path}, and the map names none: their metres were taken for the same");
            return differ("map").then(|| Notice::new("path-frame-unnamed", message()).with("path", path)).into_iter().collect();
        }
        let message = || format!("the path is in the frame {path}, the map in {map}: their metres were taken for the same");
        differ(map).then(|| Notice::new("path-frame", message()).with("path", path).with("map", map)).into_iter().collect()
    }
}

/// Metres of a level, by slices.
fn metres_of_level(spec: &ScenarioSpec) -> Option<f64> {
    match spec.terrain {
        Some(TerrainSpec { moves: TerrainMoves::Slices(rules), .. }) => Some(rules.level),
        _ => None,
    }
}
