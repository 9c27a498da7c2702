//! Where a map lies in the world: metres of a robot's map, instead of cells.

use serde::{Deserialize, Serialize};

use super::ScenarioSpec;
use crate::error::ScenarioError;
use crate::map::Point;

/// Longest name of a coordinate system, in letters.
const LONGEST_FRAME: usize = 80;

/// Farthest origin, in metres: beyond it an f64 no longer tells millimetres.
const FARTHEST: f64 = 1e9;

/// The place of a map in the world. Rows run from the top; the lower left corner of the lower left cell lies at (x, y), and the map is turned
/// by `yaw` about it, as ROS's map_server has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct World {
    /// x of the lower left corner, in metres.
    pub x: f64,
    /// y of the lower left corner, in metres.
    pub y: f64,
    /// Anticlockwise turn about that corner, in radians.
    #[serde(default)]
    pub yaw: f64,
    /// Name of the coordinate system, e.g. `map`; may be empty.
    #[serde(default)]
    pub frame: String,
}

impl World {
    /// The axes of a map that is not turned, from the lower left corner.
    pub fn at(x: f64, y: f64) -> Self {
        Self { x, y, yaw: 0.0, frame: String::new() }
    }

    /// The place of what lies so many metres to the right of the corner and above it, along the map's own axes.
    pub fn moved(self, right: f64, up: f64) -> Self {
        let (sin, cos) = (libm::sin(self.yaw), libm::cos(self.yaw));
        let (x, y) = (self.x + cos * right - sin * up, self.y + sin * right + cos * up);
        Self { x, y, ..self }
    }

    /// # Errors
    /// [`ScenarioError::Quantity`] for what is no place, or a frame's name of more than 80 letters.
    pub(super) fn check(&self) -> Result<(), ScenarioError> {
        for (field, value) in [("world.x", self.x), ("world.y", self.y)] {
            super::quantity(field, value, value.abs() <= FARTHEST, "metres, at most 1e9 from zero")?;
        }
        super::quantity("world.yaw", self.yaw, self.yaw.abs() <= 1e3, "radians, at most 1000 from zero")?;
        super::quantity(
            "world.frame",
            self.frame.len() as f64,
            self.frame.chars().count() <= LONGEST_FRAME,
            "a name of at most 80 letters",
        )
    }
}

impl ScenarioSpec {
    /// Metres a cell, of a map that has a scale: on a terrain, whose heights are metres, where its place in the world is known, or where a
    /// cell is not one metre, which is what a map says that knows none.
    pub fn scale(&self) -> Option<f64> {
        (self.terrain.is_some() || self.world.is_some() || self.resolution != 1.0).then_some(self.resolution)
    }

    /// The middle of a cell in the world, in metres; none for a map whose place is not known.
    pub fn to_world(&self, at: Point) -> Option<[f64; 2]> {
        self.place_to_world([f64::from(at.x), f64::from(at.y)])
    }

    /// A place, as column and row in cells, in the world, in metres; none for a map whose place is not known.
    pub fn place_to_world(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let world = self.world.as_ref()?;
        let east = (x + 0.5) * self.resolution;
        let north = (f64::from(self.height) - y - 0.5) * self.resolution;
        let World { x, y, .. } = world.clone().moved(east, north);
        Some([x, y])
    }

    /// A place of the world as column and row in cells, the middles of cells being whole numbers; none where the map's place is not known.
    pub fn to_place(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let world = self.world.as_ref()?;
        let (sin, cos) = (libm::sin(world.yaw), libm::cos(world.yaw));
        let (dx, dy) = (x - world.x, y - world.y);
        let column = (cos * dx + sin * dy) / self.resolution;
        let row = (cos * dy - sin * dx) / self.resolution;
        Some([column - 0.5, f64::from(self.height) - row - 0.5])
    }

    /// The cell that holds a place of the world; none beside the map, or where the map's place is not known.
    pub fn to_cell(&self, [x, y]: [f64; 2]) -> Option<Point> {
        let world = self.world.as_ref()?;
        let (sin, cos) = (libm::sin(world.yaw), libm::cos(world.yaw));
        let (dx, dy) = (x - world.x, y - world.y);
        let column = libm::floor((cos * dx + sin * dy) / self.resolution);
        let row = f64::from(self.height) - 1.0 - libm::floor((cos * dy - sin * dx) / self.resolution);
        let within = (0.0..f64::from(self.width)).contains(&column) && (0.0..f64::from(self.height)).contains(&row);
        within.then(|| Point::new(column as u32, row as u32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::Grid;

    #[test]
    fn cells_go_to_the_world_and_back() {
        let grid = Grid::open(4, 3).unwrap();
        let mut spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(3, 2));
        assert_eq!((spec.to_world(Point::new(0, 0)), spec.to_cell([0.0, 0.0])), (None, None));
        spec.resolution = 0.5;
        spec.world = Some(World::at(-1.0, 2.0));
        assert_eq!(spec.to_world(Point::new(0, 2)), Some([-0.75, 2.25]));
        assert_eq!(spec.to_world(Point::new(3, 0)), Some([0.75, 3.25]));
        for yaw in [0.0, 1.0, -2.5] {
            spec.world = Some(World { yaw, ..World::at(-1.0, 2.0) });
            for (x, y) in [(0, 0), (3, 0), (1, 2), (3, 2)] {
                let at = Point::new(x, y);
                assert_eq!(spec.to_cell(spec.to_world(at).unwrap()), Some(at));
            }
        }
        assert_eq!(spec.to_cell([100.0, 0.0]), None);
        spec.world = Some(World { yaw: 0.0, ..World::at(-1.0, 2.0) });
        assert_eq!(spec.to_place([-1.0, 3.5]), Some([-0.5, -0.5]), "the upper left corner");
        assert_eq!(spec.to_place([-0.75, 2.25]), Some([0.0, 2.0]));
    }
}
