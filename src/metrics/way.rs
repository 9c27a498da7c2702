//! A way through any places of a plane: a path as a robot was sent it, or a smooth curve. Its places need not be centres of cells.
//!
//! Places are column and row in cells; the centres of cells are whole numbers. A way that follows the side of a cell counts as being in the
//! cell right of it or below it.

use serde::Serialize;

use super::clearance_of;
use crate::map::{Cell, Point};
use crate::scenario::Scenario;

/// A place on the plane: column and row.
pub type Place = [f64; 2];

/// What is nearer is the same place, in cells; a part of a line that is shorter touches a cell and does not come into it.
const TOUCH: f64 = 1e-9;

/// The measures of a way.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct WayMetrics {
    /// Length in cells.
    pub length: f64,
    /// Length in metres.
    pub length_metres: f64,
    /// Σ|Δθ| between its stretches, in radians.
    pub turning: f64,
    /// Smallest distance in cells from the centre of a cell that it comes into to the nearest obstacle's centre; the world beyond the border
    /// is an obstacle.
    pub min_clearance: f64,
    /// Mean of the same distance over the cells that it comes into.
    pub mean_clearance: f64,
    /// Metres / speed in seconds: it turns while it drives.
    pub travel_time: f64,
    /// On weighted ground alone: the integral of the factors along it, in cells.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub cost: Option<f64>,
}

impl WayMetrics {
    /// Measures a way; places beside the map are measured for length and turning alone.
    ///
    /// ```
    /// use formicarium::map::{Grid, Movement, Point};
    /// use formicarium::{metrics::WayMetrics, scenario::Scenario};
    ///
    /// let scenario = Scenario::on(Grid::open(5, 5)?, Movement::default(), Point::new(0, 0), Point::new(4, 4))?;
    /// let measured = WayMetrics::of(&scenario, &[[0.0, 0.5], [3.0, 0.5], [3.0, 4.5]]);
    /// assert_eq!((measured.length, measured.turning), (7.0, std::f64::consts::FRAC_PI_2));
    /// # Ok::<(), formicarium::error::ScenarioError>(())
    /// ```
    pub fn of(scenario: &Scenario, places: &[Place]) -> Self {
        let length = places.windows(2).fold(0.0, |sum, ends| sum + between(ends[0], ends[1]));
        let cells: Vec<Cell> = along(places).filter_map(|(at, _)| cell_of(scenario, at)).collect();
        let (min_clearance, mean_clearance) = clearance_of(scenario.obstacles(), cells.into_iter());
        let length_metres = length * scenario.spec.resolution;
        Self {
            length,
            length_metres,
            turning: turning(places),
            min_clearance,
            mean_clearance,
            travel_time: length_metres / scenario.spec.vehicle.speed,
            cost: cost(scenario, places),
        }
    }
}

/// The cells that a way comes into and that are blocked on the map as the scenario's robot feels it, or lie beside it: each once for each
/// time that it comes in, as column and row.
pub fn entered_blocked<'a>(scenario: &'a Scenario, places: &'a [Place]) -> impl Iterator<Item = (i64, i64)> + 'a {
    let mut before = None;
    let blocked = |&at: &(i64, i64)| !scenario.grid.is_free_at(at.0, at.1);
    along(places).map(|(at, _)| at).filter(blocked).filter(move |&at| before.replace(at) != Some(at))
}

/// The cells that a way comes into, in its order, each with the length of the part that lies in it; the first one even of a single place.
fn along(places: &[Place]) -> impl Iterator<Item = ((i64, i64), f64)> + '_ {
    let first = places.first().map(|&at| (cell_at(at), 0.0));
    let parts = places.windows(2).flat_map(|ends| Line::new(ends[0], ends[1]));
    first.into_iter().chain(parts.filter(|&(_, length)| length > TOUCH))
}

fn cost(scenario: &Scenario, places: &[Place]) -> Option<f64> {
    let weights = scenario.moves.weights()?;
    let parts = along(places).map(|(at, length)| cell_of(scenario, at).map_or(0.0, |cell| length * weights.of(cell)));
    Some(parts.fold(0.0, |sum, part| sum + part))
}

fn cell_of(scenario: &Scenario, (x, y): (i64, i64)) -> Option<Cell> {
    let at = Point::new(u32::try_from(x).ok()?, u32::try_from(y).ok()?);
    scenario.grid.contains(at).then(|| scenario.grid.cell(at))
}

fn turning(places: &[Place]) -> f64 {
    let steps = places.windows(2).map(|ends| [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]]);
    let steps: Vec<Place> = steps.filter(|[dx, dy]| dx.abs().max(dy.abs()) > TOUCH).collect();
    let angle = |[a, b]: [Place; 2]| libm::atan2((a[0] * b[1] - a[1] * b[0]).abs(), a[0] * b[0] + a[1] * b[1]);
    steps.windows(2).fold(0.0, |sum, pair| sum + angle([pair[0], pair[1]]))
}

fn between(from: Place, to: Place) -> f64 {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    libm::sqrt(dx * dx + dy * dy)
}

fn cell_at([x, y]: Place) -> (i64, i64) {
    (libm::floor(x + 0.5) as i64, libm::floor(y + 0.5) as i64)
}

/// The cells that a straight line comes by, each with the length of its part there, which may be 0.
struct Line {
    from: Place,
    by: Place,
    length: f64,
    cell: [i64; 2],
    /// The part of the line that is behind, up to 1.
    now: f64,
    done: bool,
}

impl Line {
    fn new(from: Place, to: Place) -> Self {
        let (x, y) = cell_at(from);
        let by = [to[0] - from[0], to[1] - from[1]];
        let length = between(from, to);
        Self { from, by, length, cell: [x, y], now: 0.0, done: length == 0.0 }
    }

    /// At which part of the line the cell is left along an axis.
    fn leaves(&self, axis: usize) -> f64 {
        let by = self.by[axis];
        if by == 0.0 {
            return f64::INFINITY;
        }
        (self.cell[axis] as f64 + 0.5 * by.signum() - self.from[axis]) / by
    }
}

impl Iterator for Line {
    type Item = ((i64, i64), f64);

    fn next(&mut self) -> Option<Self::Item> {
        if self.done {
            return None;
        }
        let leaves = [self.leaves(0), self.leaves(1)];
        let until = leaves[0].min(leaves[1]).min(1.0);
        let part = ((self.cell[0], self.cell[1]), (until - self.now).max(0.0) * self.length);
        self.done = until >= 1.0;
        self.now = self.now.max(until);
        for ((cell, by), leaves) in self.cell.iter_mut().zip(self.by).zip(leaves) {
            if leaves == until {
                *cell += by.signum() as i64;
            }
        }
        Some(part)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::map::{Grid, Movement};

    fn scenario(factors: Option<Vec<f32>>, blocked: &[Cell]) -> Scenario {
        let mut grid = Grid::open(4, 3).unwrap();
        blocked.iter().for_each(|&cell| grid.set_blocked(cell, true));
        let grid = factors.map_or(grid.clone(), |factors| grid.with_factors(factors).unwrap());
        Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(3, 2)).unwrap()
    }

    fn cells(places: &[Place]) -> Vec<(i64, i64)> {
        along(places).map(|(at, _)| at).collect()
    }

    #[test]
    fn cells_along_a_way_by_hand() {
        assert_eq!(cells(&[[0.2, 0.1]]), [(0, 0)]);
        assert_eq!(cells(&[[0.0, 0.0], [2.0, 0.0]]), [(0, 0), (0, 0), (1, 0), (2, 0)]);
        // Through the corner of four cells, both ways.
        assert_eq!(cells(&[[0.0, 0.0], [1.0, 1.0]]), [(0, 0), (0, 0), (1, 1)]);
        assert_eq!(cells(&[[1.0, 1.0], [0.0, 0.0]]), [(1, 1), (1, 1), (0, 0)]);
        // From a side, away from it.
        assert_eq!(cells(&[[0.5, 0.0], [0.0, 0.0]]), [(1, 0), (0, 0)]);
        assert_eq!(cells(&[[0.25, 0.0], [1.5, 0.5]]), [(0, 0), (0, 0), (1, 0)]);
    }

    #[test]
    fn a_way_between_centres_is_the_path_between_them() {
        let factors: Vec<f32> = (0..12).map(|k| 1.0 + k as f32 / 4.0).collect();
        let scenario = scenario(Some(factors), &[]);
        let (path, places) = ([0, 6, 11], [[0.0, 0.0], [2.0, 1.0], [3.0, 2.0]]);
        let way = WayMetrics::of(&scenario, &places);
        assert!((way.length - scenario.ground_length(&path)).abs() < 1e-12);
        assert!((way.cost.unwrap() - scenario.path_length(&path)).abs() < 1e-12);
        assert!((way.turning - (PI / 4.0 - libm::atan(0.5))).abs() < 1e-12);
    }

    #[test]
    fn places_in_one_cell_are_no_staircase() {
        let scenario = scenario(None, &[]);
        let places: Vec<Place> = (0..=20).map(|k| [0.1 * f64::from(k), 0.05 * f64::from(k)]).collect();
        let way = WayMetrics::of(&scenario, &places);
        assert!((way.length - 5f64.sqrt()).abs() < 1e-12 && way.turning < 1e-6, "{way:?}");
    }

    #[test]
    fn a_blocked_cell_that_is_touched_is_not_entered() {
        let scenario = scenario(None, &[5]);
        let entered = |places: &[Place]| entered_blocked(&scenario, places).collect::<Vec<_>>();
        // Along the upper side of (1, 1), then through its corner; then a hair below.
        assert_eq!(entered(&[[0.0, 0.49], [2.0, 0.49]]), []);
        assert_eq!(entered(&[[0.0, 1.0], [1.0, 0.0]]), []);
        assert_eq!(entered(&[[0.0, 0.51], [0.7, 0.51], [0.9, 0.6], [2.0, 0.6]]), [(1, 1)]);
        assert_eq!(entered(&[[3.0, 2.0], [4.0, 2.0]]), [(4, 2)]);
    }
}
