//! Costs of a costmap of Nav2, as it publishes them, and what they make of a cell.

use serde::{Deserialize, Serialize};

use super::states::{FREE, OCCUPIED, UNKNOWN};
use crate::error::FormatError;
use crate::scenario::{CostRule, Inflation, MAX_MULTIPLIER};

/// How the values of a costmap become factors of cells.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Costs {
    /// What a cost makes of a step.
    #[serde(default)]
    pub rule: CostRule,
    /// m of [`CostRule::Nav2Smac2d`], 0 to [`MAX_MULTIPLIER`].
    #[serde(default = "usual_multiplier")]
    pub multiplier: f64,
}

fn usual_multiplier() -> f64 {
    Inflation::NAV2.multiplier
}

impl Costs {
    /// A rule with Nav2's own multiplier.
    pub fn by(rule: CostRule) -> Self {
        Self { rule, multiplier: usual_multiplier() }
    }

    /// # Errors
    /// [`FormatError::Field`] for a multiplier that is none.
    pub(super) fn check(self) -> Result<(), FormatError> {
        if (0.0..=MAX_MULTIPLIER).contains(&self.multiplier) {
            return Ok(());
        }
        Err(FormatError::field("multiplier", self.multiplier.to_string(), format!("a number from 0 to {MAX_MULTIPLIER}")))
    }

    /// The factor of a cell in this state; 1 where it holds no cost.
    pub(super) fn factor(self, state: u8) -> f32 {
        let Self { rule, multiplier } = self;
        if state < UNKNOWN { Inflation { rule, multiplier, ..Inflation::NAV2 }.factor(state) } else { 1.0 }
    }
}

/// The state of a published value: 1 to 98 stand for the costs 1 to 252, 99 for inscribed and 100 for lethal, both of which are occupied.
///
/// `Costmap2DPublisher` of nav2_costmap_2d publishes a cost c of 1 to 252 as 1 + ⌊97·(c − 1) / 251⌋; of the two or three costs that a value
/// may have been, this is the smallest.
pub(super) fn of_published(value: f64) -> u8 {
    match value {
        v if !(0.0..=100.0).contains(&v) => UNKNOWN,
        v if v >= 99.0 => OCCUPIED,
        v if v < 1.0 => FREE,
        v => {
            let above = 251 * (v as u32 - 1);
            (1 + above.div_ceil(97)) as u8
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_published_value_is_its_own_cost_again() {
        let publish = |cost: u32| 1 + 97 * (cost - 1) / 251;
        for value in 1..=98 {
            let cost = u32::from(of_published(f64::from(value)));
            assert_eq!(publish(cost), value);
            assert!(cost == 1 || publish(cost - 1) < value, "{cost} is the smallest of {value}");
        }
        assert_eq!([0.0, 1.0, 98.0, 99.0, 100.0, 101.0, -1.0].map(of_published), [0, 1, 252, 254, 254, 253, 253]);
    }
}
