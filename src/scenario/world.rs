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
    pub fn to_place(&self, at: [f64; 2]) -> Option<[f64; 2]> {
        let [right, above] = self.beyond_corner(at)?;
        Some([right - 0.5, f64::from(self.height) - above - 0.5])
    }

    /// How many cells right of the lower left corner and above it a place of the world lies, along the map's own axes.
    fn beyond_corner(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let world = self.world.as_ref()?;
        let (sin, cos) = (libm::sin(world.yaw), libm::cos(world.yaw));
        let (dx, dy) = (x - world.x, y - world.y);
        Some([(cos * dx + sin * dy) / self.resolution, (cos * dy - sin * dx) / self.resolution])
    }

    /// The cell that holds a place of the world; none beside the map, or where the map's place is not known. A place on the edge of two cells, or
    /// so near to it that decimal numbers cannot tell, belongs to the one to the right, or above.
    pub fn to_cell(&self, at: [f64; 2]) -> Option<Point> {
        let [right, above] = self.beyond_corner(at)?;
        let (column, above) = (number_of(right, self.width)?, number_of(above, self.height)?);
        Some(Point::new(column, self.height - 1 - above))
    }
}

/// In which of `count` cells in a row a place lies that is so many cells from their beginning; none beside them. In binary (-0.5 + 2.8) / 0.05 is
/// less than 46.
fn number_of(cells: f64, count: u32) -> Option<u32> {
    /// Cells from an edge within which a place lies on it.
    const ON_EDGE: f64 = 1e-6;
    let beyond = libm::floor(cells + ON_EDGE);
    // Beyond the last edge there is no cell.
    let number = if beyond < f64::from(count) { beyond } else { libm::floor(cells) };
    (0.0..f64::from(count)).contains(&number).then_some(number as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::Grid;

    #[test]
    fn on_an_edge_the_cell_beyond_counts_as_in_decimal_numbers() {
        let grid = Grid::open(120, 100).unwrap();
        let mut spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(3, 2));
        (spec.resolution, spec.world) = (0.05, Some(World::at(-2.8, -2.8)));
        assert_eq!(spec.to_cell([-0.5, -0.5]), Some(Point::new(46, 53)));
        // Each edge of a cell by its decimal number, whatever its neighbours' bits are.
        for k in 0..120 {
            let x = format!("{:.2}", -2.8 + 0.05 * f64::from(k)).parse().unwrap();
            assert_eq!(spec.to_cell([x, -2.8]), Some(Point::new(k, 99)), "{x}");
        }
        assert_eq!(spec.to_cell([-0.500_01, -0.5]).map(|p| p.x), Some(45), "a hundredth of a millimetre is no rounding");
        // The map's own border: nothing lies beyond the last edge, and a rounding does not throw a place off the first one.
        let inside = 1e-9;
        assert_eq!(spec.to_cell([3.2 - inside, 2.2 - inside]), Some(Point::new(119, 0)));
        assert_eq!(spec.to_cell([3.2 + inside, 0.0]), None);
        assert_eq!(spec.to_cell([-2.8 - inside, -2.8]), Some(Point::new(0, 99)));
    }

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
