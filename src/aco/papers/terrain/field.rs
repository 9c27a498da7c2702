//! The artificial potential field: the pull of the goal, the push of the heights, and the first trails that they make.
//!
//! Forces are free of the map's size: distances count in parts of the distance from start to goal, heights above the start in parts of
//! the highest place's. So k is the pull at the start, and θ·(1 − 1/ρ0) the push on the highest place near the ground.

use super::space::{Place, Space};
use crate::map::Way;
use crate::planner::Reading;

/// Smallest coefficient of a first trail, in parts of τ0: where the push outweighs the pull, Eq. 14 is not positive.
pub const LEAST: f64 = 0.01;

/// Numbers of a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gains {
    /// How Eq. 6 and 13 are read.
    pub reading: Reading,
    /// k.
    pub attraction: f64,
    /// θ.
    pub repulsion: f64,
    /// ρ0 in cells or levels.
    pub range: f64,
}

/// Eq. 6, |F_att| at a distance from the goal; `whole` is the distance from start to goal. Printed: k·d/d0, the farther the stronger.
/// Repaired, "the nearer, the stronger": 2k·d0/(d0 + d), from k at the start to 2k at the goal.
pub fn attraction(gains: &Gains, distance: f64, whole: f64) -> f64 {
    match gains.reading {
        Reading::Printed => gains.attraction * distance / whole,
        Reading::Repaired => 2.0 * gains.attraction * whole / (whole + distance),
    }
}

/// Eq. 13, F'_rep = θ·(1/ρ − 1/ρ0)·(1/ρ²)·(z − z0). Repaired where ρ ≤ ρ0 and z > z0, printed where either holds; 0 elsewhere.
pub fn repulsion(gains: &Gains, clearance: f64, rise: f64) -> f64 {
    let (near, high) = (clearance <= gains.range, rise > 0.0);
    let acts = match gains.reading {
        Reading::Printed => near || high,
        Reading::Repaired => near && high,
    };
    let size = gains.repulsion * (1.0 / clearance - 1.0 / gains.range) / (clearance * clearance) * rise;
    if acts { size } else { 0.0 }
}

/// Eq. 14 over τ0, kept positive: F'_tot is the pull less the push (Eq. 9).
pub fn first_trail(attraction: f64, repulsion: f64) -> f64 {
    (attraction - repulsion).max(LEAST)
}

/// The field that the ants of one way feel: the end that they go to attracts, heights above the end that they come from repel.
#[derive(Debug, Clone, Copy)]
pub struct Field {
    gains: Gains,
    target: [f64; 3],
    /// z0.
    base: f64,
    /// Height of the highest place above z0, at least 1.
    span: f64,
    /// Distance from start to goal.
    whole: f64,
}

impl Field {
    /// Of the ants that go this way.
    pub fn new(space: &impl Space, way: Way, gains: Gains) -> Self {
        let (origin, target) = (space.position(space.origin(way)), space.position(space.target(way)));
        let base = space.height(space.origin(way));
        let span = (space.top() - base).max(1.0);
        Self { gains, target, base, span, whole: distance(origin, target).max(1.0) }
    }

    /// |F_att| and F'_rep at a place.
    fn sizes(&self, space: &impl Space, place: Place) -> (f64, f64) {
        let at = space.position(place);
        let rise = (space.height(place) - self.base) / self.span;
        let pull = attraction(&self.gains, distance(at, self.target), self.whole);
        (pull, repulsion(&self.gains, space.clearance(place), rise))
    }

    /// The coefficient of τ0 at a place (Eq. 14), at least [`LEAST`], also where there is no data.
    pub fn trail(&self, space: &impl Space, place: Place) -> f64 {
        let (pull, push) = self.sizes(space, place);
        first_trail(pull, push)
    }

    /// F_tot as a vector: the pull towards the goal, the push straight down, away from the heights.
    pub fn force(&self, space: &impl Space, place: Place) -> [f64; 3] {
        let (pull, push) = self.sizes(space, place);
        let [x, y, z] = direction(space.position(place), self.target);
        [pull * x, pull * y, pull * z - push]
    }
}

/// F_tot·cos φ of the step between two positions: the force along it.
pub fn along(force: [f64; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
    let step = direction(from, to);
    force[0] * step[0] + force[1] * step[1] + force[2] * step[2]
}

/// Straight distance between two positions.
pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [x, y, z] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    libm::sqrt(x * x + y * y + z * z)
}

/// The unit vector from one position to another; none between equal ones.
fn direction(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let length = distance(a, b);
    if length > 0.0 { [(b[0] - a[0]) / length, (b[1] - a[1]) / length, (b[2] - a[2]) / length] } else { [0.0; 3] }
}
