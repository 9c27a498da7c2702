//! What the vehicle says of driving: what it costs, and how tight its curves may be.

use serde::{Deserialize, Serialize};

use super::spec::MOST;
use super::{Vehicle, quantity};
use crate::error::ScenarioError;

/// What driving costs: `per_metre` · metres + `per_radian` · radians turned + `per_metre_up` · metres climbed. In joules, if the three
/// numbers are; with the defaults in metres of level ground that cost as much. Each at least 0.
///
/// The defaults are ours. A metre counts 1. A radian counts ¼: so far the wheels of a robot roll that turns on the spot, half a metre apart.
/// A metre up counts 10: m·g·h beside a rolling resistance of 0.1·m·g, that of wheels on loose ground.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EnergyRule {
    /// Of a metre along the path, on a terrain along its ground.
    pub per_metre: f64,
    /// Of a turn by a radian.
    pub per_radian: f64,
    /// Of a metre up, added to what its length costs. Nothing comes back on the way down.
    pub per_metre_up: f64,
}

impl Default for EnergyRule {
    fn default() -> Self {
        Self { per_metre: 1.0, per_radian: 0.25, per_metre_up: 10.0 }
    }
}

/// That results carry a smoothed curve, and how tight it may be.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SmoothingRule {
    /// Largest curvature per metre: 1 / the smallest radius of a turn in metres. 0 = no bound.
    pub max_curvature: f64,
}

/// Largest part of an energy: in joules a metre up of a hundred tonnes is a million.
const MOST_ENERGY: f64 = 1e9;

/// # Errors
/// [`ScenarioError::Quantity`] for a number that is negative, too large or not finite.
pub(super) fn check_driving(vehicle: &Vehicle) -> Result<(), ScenarioError> {
    if let Some(rule) = vehicle.energy {
        let energy = |field, value: f64| {
            quantity(field, value, (0.0..=MOST_ENERGY).contains(&value), "0 or a positive number, up to 1000000000")
        };
        energy("vehicle.energy.per_metre", rule.per_metre)?;
        energy("vehicle.energy.per_radian", rule.per_radian)?;
        energy("vehicle.energy.per_metre_up", rule.per_metre_up)?;
    }
    vehicle.smoothing.map_or(Ok(()), |rule| {
        let allowed = "0 for no bound, or a positive number per metre, up to 1000000";
        quantity("vehicle.smoothing.max_curvature", rule.max_curvature, (0.0..=MOST).contains(&rule.max_curvature), allowed)
    })
}
