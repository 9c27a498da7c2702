//! What makes a scenario a terrain, and what of it can be used.

use serde::{Deserialize, Serialize};

use super::{ScenarioSpec, quantity};
use crate::error::ScenarioError;
use crate::map::{Cell, Grid, MAX_LEVELS, MAX_REACH, MAX_SIDE, SliceRules, Slices};

/// How one moves on a terrain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TerrainMoves {
    /// From cell to cell on the ground, by the scenario's movement.
    Surface {
        /// Steepest ground in degrees, above 0; 90 = no limit.
        max_slope: f64,
    },
    /// From column to column, above the ground.
    Slices(SliceRules),
}

/// What makes a map with heights a terrain. Serialized as [`TerrainFields`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(from = "TerrainFields", into = "TerrainFields")]
pub struct TerrainSpec {
    /// Metres per unit of the heights, above 0.
    pub vertical_unit: f64,
    /// How one moves.
    pub moves: TerrainMoves,
}

impl Default for TerrainSpec {
    /// Heights in metres, on the surface, without a limit of slope.
    fn default() -> Self {
        Self { vertical_unit: 1.0, moves: TerrainMoves::Surface { max_slope: 90.0 } }
    }
}

/// A [`TerrainSpec`] as files and the page hold it: one moves by slices where `slices` is given, on the surface otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct TerrainFields {
    /// Metres per unit of the heights, above 0.
    pub vertical_unit: f64,
    /// On the surface: steepest ground in degrees, above 0; 90 = no limit, and what is meant where it is absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_slope: Option<f64>,
    /// By slices: the rules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slices: Option<SliceRules>,
}

impl From<TerrainFields> for TerrainSpec {
    fn from(TerrainFields { vertical_unit, max_slope, slices }: TerrainFields) -> Self {
        let surface = TerrainMoves::Surface { max_slope: max_slope.unwrap_or(90.0) };
        Self { vertical_unit, moves: slices.map_or(surface, TerrainMoves::Slices) }
    }
}

impl From<TerrainSpec> for TerrainFields {
    fn from(TerrainSpec { vertical_unit, moves }: TerrainSpec) -> Self {
        match moves {
            TerrainMoves::Surface { max_slope } => Self { vertical_unit, max_slope: Some(max_slope), slices: None },
            TerrainMoves::Slices(rules) => Self { vertical_unit, max_slope: None, slices: Some(rules) },
        }
    }
}

/// The largest rise over run whose angle is not above this one, in degrees: what metrics call that steep is that steep.
#[cfg(feature = "whole")]
pub(super) fn rise_over_run(degrees: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1e6);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if libm::atan(middle).to_degrees() <= degrees { low = middle } else { high = middle }
    }
    low
}

/// Whether heights and terrain come together, and what the terrain says can be used.
pub(super) fn check_terrain(grid: &Grid, spec: &ScenarioSpec) -> Result<(), ScenarioError> {
    /// More cells up than any map has sideways: the unit must be wrong.
    const MOST: f64 = 1e6;
    if !cfg!(feature = "whole") {
        return Ok(());
    }
    let (terrain, heights) = match (&spec.terrain, grid.heights()) {
        (Some(terrain), Some(heights)) => (terrain, heights),
        (None, None) => return Ok(()),
        (Some(_), None) => return Err(ScenarioError::Heights { missing: true }),
        (None, Some(_)) => return Err(ScenarioError::Heights { missing: false }),
    };
    let unit = terrain.vertical_unit;
    quantity("vertical_unit", unit, unit > 0.0, "a positive number of metres")?;
    let tallest = heights.iter().fold(0f32, |most, h| if h.abs() > most { h.abs() } else { most });
    let cells = f64::from(tallest) * unit / spec.resolution;
    quantity(
        "height in cells",
        cells,
        cells <= MOST,
        "at most 1,000,000 cells high; check the vertical unit and the resolution",
    )?;
    match terrain.moves {
        TerrainMoves::Surface { max_slope } => {
            quantity("max_slope", max_slope, max_slope > 0.0 && max_slope <= 90.0, "above 0 and up to 90 degrees")
        }
        TerrainMoves::Slices(rules) => check_slices(&rules),
    }
}

fn check_slices(rules: &SliceRules) -> Result<(), ScenarioError> {
    let whole = |field, value: u32, range: std::ops::RangeInclusive<u32>, allowed| {
        quantity(field, f64::from(value), range.contains(&value), allowed)
    };
    quantity("level", rules.level, rules.level > 0.0, "a positive number of metres")?;
    whole("levels", rules.levels, 1..=MAX_LEVELS, "1 to 255")?;
    whole("max_aside", rules.max_aside, 0..=MAX_REACH, "0 to 5 cells")?;
    whole("max_climb", rules.max_climb, 0..=MAX_REACH, "0 to 5 levels")?;
    whole("start_level", rules.start_level, 1..=rules.levels, "between 1 and the number of levels")?;
    whole("goal_level", rules.goal_level, 1..=rules.levels, "between 1 and the number of levels")
}

/// The places of movement by slices, if that is how one moves.
pub(super) fn slices(grid: &Grid, spec: &ScenarioSpec, start: Cell, goals: &[Cell]) -> Result<Option<Slices>, ScenarioError> {
    let Some(TerrainSpec { vertical_unit, moves: TerrainMoves::Slices(rules) }) = spec.terrain else { return Ok(None) };
    let heights = grid.heights().ok_or(ScenarioError::Heights { missing: true })?;
    if grid.len() as u64 * (u64::from(rules.levels) + 1) > u64::from(u32::MAX) {
        let (width, height) = (u64::from(spec.width), u64::from(spec.height));
        return Err(ScenarioError::MapSize { width, height, most: MAX_SIDE });
    }
    let slices = Slices::new(grid, rules, vertical_unit, start, goals[0]);
    let ground = |c: Cell| f64::from(heights[c as usize]) * vertical_unit;
    let above = slices.ends_above_ground(ground(start), ground(goals[0]));
    let ends = [("start", above[0], start, rules.start_level), ("goal", above[1], goals[0], rules.goal_level)];
    match ends.into_iter().find(|end| !end.1) {
        Some((role, _, cell, level)) => {
            let lowest = libm::ceil(ground(cell) / rules.level);
            Err(ScenarioError::BelowGround { role, level, lowest: lowest as u32 })
        }
        None => Ok(Some(slices)),
    }
}
