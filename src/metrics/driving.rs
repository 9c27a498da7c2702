//! How a path is to drive: how far it turns, how tightly, how smoothly, and what that takes.
//!
//! Straight stretches count as one, so that a path by steps and the polyline through its corners are measured alike. On a terrain angles and
//! curvatures are those of the path as it is seen from above.

use serde::{Deserialize, Serialize};

use crate::map::{Cell, Point};
use crate::path::corners;
use crate::scenario::Scenario;

/// How a path is to drive.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Driving {
    /// Σ|Δθ| over all corners in radians, at least 0; a corner at which the path turns straight back counts π.
    pub turning: f64,
    /// Largest curvature per metre, at least 0, once each corner is rounded by the widest arc that leaves half of both its stretches
    /// straight: max 2·tan(θ/2) / min(a, b) over corners of angle θ between stretches of a and b metres. Absent where the path turns
    /// straight back: no arc does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub largest_curvature: Option<f64>,
    /// Σ(2θ / (a + b))² over all corners, per square metre, at least 0; the smaller, the smoother, and 0 of a straight line. OMPL's
    /// `PathGeometric::smoothness` of the path's corners, but that a corner that turns straight back counts.
    pub smoothness: f64,
    /// What it costs by the vehicle's [`EnergyRule`](crate::scenario::EnergyRule), at least 0.
    pub energy: f64,
}

/// A corner between two stretches.
struct Corner {
    /// Angle in radians, above 0 and up to π.
    angle: f64,
    /// tan(angle / 2); none where it turns straight back.
    half_tangent: Option<f64>,
    /// Lengths of both stretches in cells.
    stretches: [f64; 2],
}

impl Corner {
    fn of([from, at, to]: [Point; 3]) -> Self {
        let (a, b) = (between(from, at), between(at, to));
        let (cross, dot) = ((a.0 * b.1 - a.1 * b.0).abs(), a.0 * b.0 + a.1 * b.1);
        let stretches = [a, b].map(|(x, y)| libm::sqrt(x * x + y * y));
        let half_tangent = (cross > 0.0).then(|| cross / (stretches[0] * stretches[1] + dot));
        Self { angle: libm::atan2(cross, dot), half_tangent, stretches }
    }
}

fn between(from: Point, to: Point) -> (f64, f64) {
    (f64::from(to.x) - f64::from(from.x), f64::from(to.y) - f64::from(from.y))
}

impl Driving {
    /// Of a path of either kind with its metres along the ground and its metres up; none by slices.
    pub(super) fn of(scenario: &Scenario, path: &[Cell], metres: f64, climb: f64) -> Option<Self> {
        if scenario.by_slices().is_some() {
            return None;
        }
        let resolution = scenario.spec.resolution;
        let (mut turning, mut curvature, mut smoothness) = (0.0, Some(0.0f64), 0.0);
        for ends in corners(scenario, path).windows(3) {
            let Corner { angle, half_tangent, stretches: [a, b] } = Corner::of([ends[0], ends[1], ends[2]]);
            turning += angle;
            curvature = curvature.zip(half_tangent).map(|(most, tangent)| most.max(2.0 * tangent / (a.min(b) * resolution)));
            let bend = 2.0 * angle / ((a + b) * resolution);
            smoothness += bend * bend;
        }
        let rule = scenario.spec.vehicle.energy.unwrap_or_default();
        let energy = rule.per_metre * metres + rule.per_radian * turning + rule.per_metre_up * climb;
        Some(Self { turning, largest_curvature: curvature, smoothness, energy })
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

    use super::*;
    use crate::map::{Grid, Movement};
    use crate::metrics::Metrics;
    use crate::scenario::EnergyRule;

    fn driving(resolution: f64, energy: Option<EnergyRule>, path: &[Cell]) -> Driving {
        let grid = Grid::open(5, 5).unwrap();
        let mut s = Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(4, 4)).unwrap();
        (s.spec.resolution, s.spec.vehicle.energy) = (resolution, energy);
        Metrics::of(&s, path).driving.unwrap()
    }

    fn same(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-12
    }

    #[test]
    fn a_straight_line_asks_nothing_but_its_length() {
        let d = driving(0.5, None, &[0, 6, 12, 18, 24]);
        assert_eq!((d.turning, d.largest_curvature, d.smoothness), (0.0, Some(0.0), 0.0));
        assert!(same(d.energy, 2.0 * 2f64.sqrt()));
    }

    #[test]
    fn a_right_angle_by_hand() {
        // Four cells of half a metre east, then two south.
        let d = driving(0.5, None, &[0, 1, 2, 3, 4, 9, 14]);
        assert_eq!(d.turning, FRAC_PI_2);
        // The arc begins half a metre before the corner: its radius is half a metre.
        assert!(same(d.largest_curvature.unwrap(), 2.0));
        assert!(same(d.smoothness, (2.0 * FRAC_PI_2 / 3.0f64).powi(2)));
        assert!(same(d.energy, 3.0 + 0.25 * FRAC_PI_2));
        // Its corners alone are the same path.
        assert_eq!(driving(0.5, None, &[0, 4, 14]), d);
    }

    #[test]
    fn the_energy_is_the_vehicles() {
        let rule = EnergyRule { per_metre: 2.0, per_radian: 8.0, per_metre_up: 100.0 };
        // East, southeast, south: two turns of 45 degrees.
        let d = driving(1.0, Some(rule), &[0, 1, 7, 12]);
        assert!(same(d.turning, FRAC_PI_2) && same(d.energy, 2.0 * (2.0 + 2f64.sqrt()) + 8.0 * FRAC_PI_2));
        assert!(same(d.largest_curvature.unwrap(), 2.0 * libm::tan(FRAC_PI_4 / 2.0)));
    }

    #[test]
    fn no_arc_turns_straight_back() {
        let d = driving(1.0, None, &[0, 1, 2, 1, 0]);
        assert_eq!((d.turning, d.largest_curvature), (PI, None));
        assert!(same(d.smoothness, (PI / 2.0) * (PI / 2.0)));
    }
}
