//! A weighted sum of length, turns, closeness to obstacles and energy: one number for what a path costs.
//!
//! J = w_L·L + w_T·T + w_C·C + w_E·E, of a path of steps:
//!
//! | term | what it is | unit |
//! |---|---|---|
//! | L | its length, as [`crate::metrics::Metrics::length`], on weighted ground its cost | cells |
//! | T | its turns, as [`crate::metrics::Metrics::turns`] | turns |
//! | C | Σ over its steps of their length on the plane × the mean of c at their two ends; c = max(0, 1 − d/D), d from a cell's centre to the nearest obstacle's, D the distance that is wanted | cells |
//! | E | what driving takes by the vehicle's rule of energy, over the metres of a cell: e₁·length + e₂·Σ\|Δθ\|/metres a cell + e₃·climb; e₁ = 1, e₂ = ¼ and e₃ = 10 unless the map says otherwise | cells |
//!
//! C is the way spent too near to obstacles, each cell of it by how much: an obstacle cost along the arc length, as CHOMP has it (Ratliff,
//! Zucker, Bagnell, Srinivasa 2009), with a linear c. A mean over the path would not do: it is no sum over steps, and a detour in the open
//! would make it better. E counts work against rolling resistance and against gravity (Rowe and Ross 1990), as
//! `Driving::energy` does. Δθ is the angle between two steps; the climb is in cells, 0 on a plane. All terms but that of the climb are sums over (cell, direction), so that a search proves J
//! on a plane.

use serde::Serialize;

use super::turns;
use crate::map::{Cell, Grid, displacement};
use crate::params;
use crate::scenario::Scenario;

params! {
    /// The weights of the sum, and what its terms need to know.
    #[derive(Serialize)]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub struct WeightedSum {
        /// in the weighted sum, weight of the path's length
        length_weight: f64 = 1.0, "w_L", [0.001..=100.0], "", "our addition", when(criterion: "weighted-sum");
        /// in the weighted sum, what a turn costs
        turn_weight: f64 = 1.0, "w_T", [0.0..=100.0], "cells", "our addition", when(criterion: "weighted-sum");
        /// in the weighted sum, what a cell of way costs right beside an obstacle, before it is divided by how much is missing
        clearance_weight: f64 = 1.0, "w_C", [0.0..=100.0], "", "our addition", when(criterion: "weighted-sum");
        /// in the weighted sum, weight of the energy
        energy_weight: f64 = 0.0, "w_E", [0.0..=100.0], "", "our addition", when(criterion: "weighted-sum");
        /// distance to obstacles from which on a cell costs nothing more
        clearance_wanted: f64 = 3.0, "D", [1.0..=16.0], "cells", "our addition", when(criterion: "weighted-sum");
    }
}

/// What the terms come to.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Terms {
    /// L in cells.
    pub length: f64,
    /// T.
    pub turns: u32,
    /// C in cells; 0 where it has no weight.
    pub closeness: f64,
    /// E in cells.
    pub energy: f64,
}

impl WeightedSum {
    /// J of a valid path of steps, in cells; above 0 for every path that moves.
    ///
    /// ```
    /// use formicarium::map::{Grid, Movement, Point};
    /// use formicarium::{metrics::WeightedSum, scenario::Scenario};
    ///
    /// let scenario = Scenario::on(Grid::open(3, 3)?, Movement::default(), Point::new(0, 0), Point::new(2, 2))?;
    /// let sum = WeightedSum { turn_weight: 0.5, clearance_weight: 0.0, ..WeightedSum::default() };
    /// // East, east, south, south: 4 cells and one turn.
    /// assert_eq!(sum.of(&scenario, &[0, 1, 2, 5, 8]), 4.5);
    /// # Ok::<(), formicarium::error::ScenarioError>(())
    /// ```
    pub fn of(&self, scenario: &Scenario, path: &[Cell]) -> f64 {
        let Terms { length, turns, closeness, energy } = self.terms(scenario, path);
        self.length_weight * length
            + self.turn_weight * f64::from(turns)
            + self.clearance_weight * closeness
            + self.energy_weight * energy
    }

    /// The terms of a valid path of steps, without their weights.
    pub fn terms(&self, scenario: &Scenario, path: &[Cell]) -> Terms {
        let length = scenario.path_length(path);
        let (turns, radians) = turning(scenario.grid.width(), path);
        let closeness = if self.clearance_weight > 0.0 { self.closeness(&scenario.grid, path) } else { 0.0 };
        let [way, radian, up] = energy_rates(scenario);
        let energy = way * scenario.ground_length(path) + radian * radians + up * climb(scenario, path);
        Terms { length, turns, closeness, energy }
    }

    /// C.
    fn closeness(&self, grid: &Grid, path: &[Cell]) -> f64 {
        let near: Vec<f64> = path.iter().map(|&cell| self.shortfall(grid, cell)).collect();
        let step = |k: usize| {
            let (dx, dy) = displacement(grid.width(), path[k - 1], path[k]);
            libm::sqrt(f64::from(dx * dx + dy * dy)) * 0.5 * (near[k - 1] + near[k])
        };
        (1..path.len()).map(step).sum()
    }

    /// c of a free cell: how much of the wanted distance is missing, 0 to 1. The world beyond the border is an obstacle.
    pub fn shortfall(&self, grid: &Grid, cell: Cell) -> f64 {
        let wanted = self.clearance_wanted;
        let (reach, at) = (libm::ceil(wanted) as i64, grid.point(cell));
        let (x, y) = (i64::from(at.x), i64::from(at.y));
        let mut nearest = reach * reach;
        for dy in -reach..=reach {
            for dx in -reach..=reach {
                let squared = dx * dx + dy * dy;
                if squared < nearest && !grid.is_free_at(x + dx, y + dy) {
                    nearest = squared;
                }
            }
        }
        (1.0 - libm::sqrt(nearest as f64) / wanted).max(0.0)
    }
}

/// What a cell of way, a radian of turning and a cell up take by the vehicle's rule, in units of E. No planner of the opening build asks.
pub fn energy_rates(scenario: &Scenario) -> [f64; 3] {
    #[cfg(feature = "whole")]
    {
        let rule = scenario.spec.vehicle.energy.unwrap_or_default();
        [rule.per_metre, rule.per_radian / scenario.spec.resolution, rule.per_metre_up]
    }
    #[cfg(not(feature = "whole"))]
    {
        let _ = scenario;
        [1.0, 0.0, 0.0]
    }
}

/// Angle between two steps in radians, 0 to π.
pub fn angle(a: (i32, i32), b: (i32, i32)) -> f64 {
    let (cross, dot) = (a.0 * b.1 - a.1 * b.0, a.0 * b.0 + a.1 * b.1);
    libm::atan2(f64::from(cross.abs()), f64::from(dot))
}

/// Number of turns, and the angles turned by in radians.
fn turning(width: u32, path: &[Cell]) -> (u32, f64) {
    let (mut count, mut radians) = (0u32, 0.0);
    for three in path.windows(3) {
        let (before, after) = (displacement(width, three[0], three[1]), displacement(width, three[1], three[2]));
        if turns(before, after) {
            count += 1;
            radians += angle(before, after);
        }
    }
    (count, radians)
}

/// Cells upwards; 0 on a plane.
fn climb(scenario: &Scenario, path: &[Cell]) -> f64 {
    let Some(relief) = scenario.moves.relief() else { return 0.0 };
    path.windows(2).map(|step| relief.segment(step[0], step[1]).climb).sum()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, SQRT_2};

    use super::*;
    use crate::map::{Movement, Point};
    use crate::metrics::Metrics;

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-12
    }

    /// 7 × 7, free but for the middle.
    fn scenario() -> Scenario {
        let mut grid = Grid::open(7, 7).unwrap();
        grid.set_blocked(24, true);
        Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(6, 6)).unwrap()
    }

    #[test]
    fn a_shortfall_by_hand() {
        let (s, sum) = (scenario(), WeightedSum { clearance_wanted: 3.0, ..WeightedSum::default() });
        let c = |x: u32, y: u32| sum.shortfall(&s.grid, s.grid.cell(Point::new(x, y)));
        // Beside the border d = 1; at (1, 1) d = 2; beside the middle d = 1, diagonally √2.
        assert!(near(c(0, 0), 2.0 / 3.0) && near(c(1, 1), 1.0 / 3.0) && near(c(3, 2), 2.0 / 3.0));
        assert!(near(c(2, 2), 1.0 - SQRT_2 / 3.0));
        let easy = WeightedSum { clearance_wanted: 1.0, ..sum };
        assert_eq!(easy.shortfall(&s.grid, 0), 0.0, "one cell is what every free cell has");
    }

    #[test]
    fn the_terms_by_hand() {
        let s = scenario();
        let sum = WeightedSum { energy_weight: 0.25, turn_weight: 2.0, clearance_weight: 3.0, ..WeightedSum::default() };
        // (0,0) E (1,0) SE (2,1) S (2,2): c = 2/3, 2/3, 1/3, 1 − √2/3.
        let path = [0, 1, 9, 16];
        let t = sum.terms(&s, &path);
        let c = [2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0, 1.0 - SQRT_2 / 3.0];
        let closeness = (c[0] + c[1]) / 2.0 + SQRT_2 * (c[1] + c[2]) / 2.0 + (c[2] + c[3]) / 2.0;
        assert!(near(t.length, 2.0 + SQRT_2) && t.turns == 2 && near(t.closeness, closeness));
        assert!(near(t.energy, t.length + 0.25 * FRAC_PI_2));
        assert!(
            near(t.energy, Metrics::of(&s, &path).driving.unwrap().energy),
            "as a path's energy is told, a cell being a metre"
        );
        assert!(near(sum.of(&s, &path), t.length + 4.0 + 3.0 * closeness + 0.25 * t.energy));
        let m = Metrics::of(&s, &path);
        assert_eq!((t.length, t.turns), (m.length, m.turns));
    }

    #[test]
    fn angles_have_no_side() {
        assert!(near(angle((1, 0), (1, 1)), FRAC_PI_4) && near(angle((1, 0), (0, -1)), FRAC_PI_2));
        assert!(near(angle((1, 0), (-1, 0)), PI) && angle((1, 1), (1, 1)) == 0.0);
    }

    #[test]
    fn length_alone_is_the_length() {
        let (s, path) = (scenario(), [0, 8, 16, 17]);
        let sum = WeightedSum { turn_weight: 0.0, clearance_weight: 0.0, ..WeightedSum::default() };
        assert_eq!(sum.of(&s, &path), s.path_length(&path));
    }
}
