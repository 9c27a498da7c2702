//! The ways of moving that planners know, or do not.

use serde::Serialize;

use crate::map::Moves;
use crate::scenario::Scenario;

/// A way of moving, as far as planners differ in what they know.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Ground {
    /// 4 or 8 moves on a plane.
    Plane,
    /// 4 or 8 moves on the surface of a terrain.
    Surface,
    /// 16 moves, on a plane or on a surface.
    Sixteen,
    /// By slices over a terrain.
    Slices,
}

impl Ground {
    /// Of planners that only know the plane.
    pub const PLANE: &'static [Self] = &[Self::Plane];
    /// Of planners that go from cell to neighbouring cell.
    pub const NEIGHBOURS: &'static [Self] = &[Self::Plane, Self::Surface];
    /// Of planners that go from cell to cell by any allowed step.
    pub const STEPS: &'static [Self] = &[Self::Plane, Self::Surface, Self::Sixteen];
    /// Of planners that know every way of moving.
    pub const ALL: &'static [Self] = &[Self::Plane, Self::Surface, Self::Sixteen, Self::Slices];

    /// How one moves in a scenario.
    pub fn of(scenario: &Scenario) -> Self {
        match (scenario.by_slices(), scenario.spec.movement.moves, scenario.moves.relief()) {
            (Some(_), ..) => Self::Slices,
            (None, Moves::Sixteen, _) => Self::Sixteen,
            (None, _, Some(_)) => Self::Surface,
            (None, _, None) => Self::Plane,
        }
    }

    /// Its stable name, and as a phrase after "plans".
    pub const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Plane => ("plane", "on a plane"),
            Self::Surface => ("surface", "on the surface of a terrain"),
            Self::Sixteen => ("sixteen", "with 16 moves"),
            Self::Slices => ("slices", "by slices"),
        }
    }
}
