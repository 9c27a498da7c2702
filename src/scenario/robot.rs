//! The robot that moves: how much room it needs, and how dear the cells near obstacles are to it.
//!
//! Costs follow Nav2: `InflationLayer::computeCost` of nav2_costmap_2d gives a cell at distance d from the nearest obstacle, centre to centre,
//! 253 up to the inscribed radius r and ⌊252·exp(−s·(d − r))⌋ beyond it, s being the cost scaling factor, out to the inflation radius, in
//! whole cells rounded up. A cell of 253 or more cannot be entered. What the map's file has left unknown and the reader has blocked counts
//! as an obstacle, as with Nav2's `inflate_around_unknown`; the world beyond the border does not, as with Nav2.
//!
//! Where this is not Nav2 to the letter (docs/methodology.md says it to users):
//! - r is what a user gives as the radius. Nav2 makes a padded polygon of 16 corners of its `robot_radius`, whose inscribed circle is a
//!   little larger or smaller: 0.2255 m of 0.22 m with its `footprint_padding` of 0.01 m.
//! - Cells up to r are blocked even where the inflation radius is smaller, or 0.
//! - d is exact. Nav2 spreads from cell to cell, which misses the nearest obstacle now and then.

use serde::{Deserialize, Serialize};

use super::{ScenarioSpec, free_cell, quantity};
use crate::error::ScenarioError;
use crate::map::{Cell, Grid, squared_distances};

/// Cost of a cell that is far from everything: `FREE_SPACE` of Nav2.
pub const FREE_COST: u8 = 0;
/// Cost of a cell in which the robot certainly touches an obstacle: `INSCRIBED_INFLATED_OBSTACLE` of Nav2.
pub const INSCRIBED_COST: u8 = 253;
/// Cost of an obstacle: `LETHAL_OBSTACLE` of Nav2.
pub const LETHAL_COST: u8 = 254;

/// Nav2's radius of a robot that nobody has described, in metres: `robot_radius` of nav2_costmap_2d.
pub const NAV2_RADIUS: f64 = 0.1;
/// By what part a distance may exceed the radius and be the same: three cells of 0.05 m are 0.15 m, though not in binary numbers.
const SAME: f64 = 1e-9;

/// Largest m of [`CostRule::Nav2Smac2d`].
pub const MAX_MULTIPLIER: f64 = 500.0;

/// A round robot.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Robot {
    /// Metres, at least 0: a cell whose centre is no farther from an obstacle's is blocked for the robot.
    pub radius: f64,
    /// What cells beyond that cost; nothing more than their length where it is absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub inflation: Option<Inflation>,
}

/// How cells near obstacles become dearer.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Inflation {
    /// Inflation radius in metres, at least 0.
    pub radius: f64,
    /// Cost scaling factor in 1 / metre, above 0: the larger, the faster costs fall off.
    pub cost_scaling: f64,
    /// What a cost makes of a step.
    #[serde(default)]
    pub rule: CostRule,
    /// m of [`CostRule::Nav2Smac2d`], 0 to [`MAX_MULTIPLIER`]: its `cost_travel_multiplier`. NavFn has none.
    #[serde(default = "multiplier_of_nav2")]
    pub multiplier: f64,
}

/// How a cell's cost of 0 to 252 becomes a factor of its length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum CostRule {
    /// SmacPlanner2D of Nav2: 1 + m·cost / 252 (`Node2D::getTraversalCost`, nav2_smac_planner).
    #[default]
    #[serde(rename = "nav2-smac-2d")]
    Nav2Smac2d,
    /// NavFn of Nav2: ⌊50 + 0.8·cost⌋ / 50 (`COST_NEUTRAL`, `COST_FACTOR` of nav2_navfn_planner).
    #[serde(rename = "nav2-navfn")]
    Nav2Navfn,
}

impl CostRule {
    /// All rules.
    pub const ALL: [Self; 2] = [Self::Nav2Smac2d, Self::Nav2Navfn];

    /// Its stable name.
    pub const fn id(self) -> &'static str {
        match self {
            Self::Nav2Smac2d => "nav2-smac-2d",
            Self::Nav2Navfn => "nav2-navfn",
        }
    }
}

fn multiplier_of_nav2() -> f64 {
    Inflation::NAV2.multiplier
}

impl Inflation {
    /// Nav2's defaults: 0.55 m and 10 / m (`InflationLayer`), SmacPlanner2D with m = 2; newer versions of that have m = 1.
    pub const NAV2: Self = Self { radius: 0.55, cost_scaling: 10.0, rule: CostRule::Nav2Smac2d, multiplier: 2.0 };

    /// Factor of a cell of this cost, 0 to 252; at least 1.
    pub fn factor(self, cost: u8) -> f32 {
        let cost = f64::from(cost);
        match self.rule {
            CostRule::Nav2Smac2d => (1.0 + self.multiplier * cost / 252.0) as f32,
            CostRule::Nav2Navfn => (libm::floor(50.0 + 0.8 * cost) / 50.0) as f32,
        }
    }
}

impl Robot {
    /// Nav2's cost of every cell of a map with cells of this many metres, row by row.
    ///
    /// ```
    /// use formicarium::map::Grid;
    /// use formicarium::scenario::{Inflation, Robot};
    ///
    /// let grid = Grid::from_bytes(5, 1, &[1, 0, 0, 0, 0])?;
    /// let robot = Robot { radius: 0.1, inflation: Some(Inflation { radius: 0.3, ..Inflation::NAV2 }) };
    /// // 252·exp(−10·(0.2 − 0.1)) = 92.7, 252·exp(−10·(0.3 − 0.1)) = 34.1; 0.4 m is beyond.
    /// assert_eq!(robot.costs(&grid, 0.1), [254, 253, 92, 34, 0]);
    /// # Ok::<(), formicarium::error::ScenarioError>(())
    /// ```
    pub fn costs(&self, grid: &Grid, resolution: f64) -> Vec<u8> {
        let farthest = self.inflation.map_or(0.0, |inflation| libm::ceil(inflation.radius / resolution));
        let cost = |squared: u32| {
            let cells = libm::sqrt(f64::from(squared));
            let distance = cells * resolution;
            match self.inflation {
                _ if squared == 0 => LETHAL_COST,
                _ if self.touches(squared, resolution) => INSCRIBED_COST,
                Some(inflation) if cells <= farthest => {
                    (252.0 * libm::exp(-inflation.cost_scaling * (distance - self.radius))) as u8
                }
                _ => FREE_COST,
            }
        };
        squared_distances(grid).into_iter().map(|squared| if squared == u32::MAX { FREE_COST } else { cost(squared) }).collect()
    }

    /// Whether it touches an obstacle whose centre is so far from its own, by the squared distance in cells of so many metres.
    pub fn touches(&self, squared: u32, resolution: f64) -> bool {
        squared == 0 || libm::sqrt(f64::from(squared)) * resolution <= self.radius * (1.0 + SAME)
    }

    /// How many cells of so many metres an obstacle lies away at most that blocks a cell or makes it dearer.
    pub(super) fn reach(&self, resolution: f64) -> u32 {
        let farthest = self.inflation.map_or(self.radius, |inflation| inflation.radius.max(self.radius));
        libm::ceil(farthest / resolution) as u32
    }

    /// A drawn map as the robot feels it: blocked where it does not fit; of a cell's own factor and that of inflation the larger one counts,
    /// as layers of a costmap are put together.
    pub(super) fn feels(&self, drawn: &Grid, resolution: f64) -> Grid {
        let costs = self.costs(drawn, resolution);
        let mut grid = drawn.clone();
        let narrow = costs.iter().enumerate().filter(|(_, cost)| **cost == INSCRIBED_COST);
        grid.block_all(narrow.map(|(cell, _)| cell as Cell));
        let Some(inflation) = self.inflation else { return grid };
        let own = |cell: usize| drawn.factors().map_or(1.0, |factors| factors[cell]);
        let dear = |(cell, &cost): (usize, &u8)| {
            if cost < INSCRIBED_COST { inflation.factor(cost).max(own(cell)) } else { own(cell) }
        };
        grid.with_factors(costs.iter().enumerate().map(dear).collect()).expect("a checked rule gives factors in range")
    }
}

/// Whether what is said of the robot can be used.
pub(super) fn check(grid: &Grid, spec: &ScenarioSpec) -> Result<(), ScenarioError> {
    /// Metres: more than any map has.
    const FARTHEST: f64 = 1e6;
    let inflation = spec.robot.and_then(|robot| robot.inflation);
    if grid.heights().is_some() && (grid.factors().is_some() || inflation.is_some()) {
        return Err(ScenarioError::WeightedTerrain);
    }
    let Some(robot) = spec.robot else { return Ok(()) };
    let length = |field, value: f64| quantity(field, value, (0.0..=FARTHEST).contains(&value), "0 to 1000000 metres");
    length("robot.radius", robot.radius)?;
    let Some(Inflation { radius, cost_scaling, multiplier, .. }) = inflation else { return Ok(()) };
    length("robot.inflation.radius", radius)?;
    let scaling = cost_scaling > 0.0 && cost_scaling <= 1e3;
    quantity("robot.inflation.cost_scaling", cost_scaling, scaling, "above 0 and up to 1000 per metre")?;
    quantity("robot.inflation.multiplier", multiplier, (0.0..=MAX_MULTIPLIER).contains(&multiplier), "0 to 500")
}

/// Whether the robot has room at its ends, which are free on the drawn map.
pub(super) fn check_room(felt: &Grid, spec: &ScenarioSpec) -> Result<(), ScenarioError> {
    let Some(Robot { radius, .. }) = spec.robot else { return Ok(()) };
    let ends = spec.goals.iter().map(|goal| ("goal", goal.at));
    for (role, at) in std::iter::once(("start", spec.start)).chain(ends) {
        free_cell(felt, role, at).map_err(|_| ScenarioError::TooNarrow { role, x: at.x, y: at.y, radius })?;
    }
    Ok(())
}
