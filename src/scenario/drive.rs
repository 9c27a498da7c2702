//! What moves while a robot drives: walls that change at its steps, obstacles on tracks, and how far it sees.

use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use super::changes::unfit_for_change;
use super::{ScenarioSpec, Track};
use crate::error::ScenarioError;
use crate::map::{Grid, Point};

/// Most changes of walls of a drive.
pub const MAX_DRIVE_CHANGES: usize = 1000;
/// Most obstacles that move.
pub const MAX_TRACKS: usize = 100;
/// The last step at which anything can begin.
pub const MAX_STEP: u32 = 1_000_000;

/// What moves while a robot drives. Its steps are counted by its moves and waits: 0 is before the first.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct DriveSpec {
    /// Walls that change, in the order of their steps.
    #[serde(default)]
    pub changes: Vec<DriveChange>,
    /// Obstacles that move.
    #[serde(default)]
    pub tracks: Vec<Track>,
    /// From how far the robot sees that a cell is not as it knows, in cells between centres; what its next step can touch it always sees.
    /// None: it knows at once, wherever it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub sight: Option<f64>,
}

/// Walls that change at a step of the robot. The cell on which it stands is blocked once it has left.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct DriveChange {
    /// After so many moves and waits, up to [`MAX_STEP`].
    pub at_step: u32,
    /// Cells without a wall that get one.
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number][]"))]
    pub blocked: Vec<Point>,
    /// Cells with a wall that lose it.
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number][]"))]
    pub freed: Vec<Point>,
}

impl DriveChange {
    /// Makes it on a map; its cells are known to be such as it says.
    pub fn make(&self, grid: &mut Grid) {
        self.blocked.iter().for_each(|&p| grid.set_blocked(grid.cell(p), true));
        self.freed.iter().for_each(|&p| grid.set_blocked(grid.cell(p), false));
    }

    fn check(&self, grid: &Grid, index: usize) -> Result<(), ScenarioError> {
        if self.blocked.is_empty() && self.freed.is_empty() {
            return Err(wrong(&format!("changes[{index}]"), "no cells".into(), "a change of one cell or more"));
        }
        for (field, cells, block) in [("blocked", &self.blocked, true), ("freed", &self.freed, false)] {
            let mut seen = BTreeSet::new();
            for (i, &cell) in cells.iter().enumerate() {
                let twice = (!seen.insert(cell)).then_some("a cell that the change does not name twice");
                if let Some(allowed) = unfit_for_change(grid, cell, block).or(twice) {
                    return Err(wrong(&format!("changes[{index}].{field}[{i}]"), said(cell), allowed));
                }
            }
        }
        Ok(())
    }
}

impl DriveSpec {
    /// Whether all of it can be on a map, one change after the other, and no goal is blocked for good.
    ///
    /// # Errors
    /// [`ScenarioError::Drive`] names the field, the value and what is allowed.
    pub fn check(&self, grid: &Grid, spec: &ScenarioSpec) -> Result<(), ScenarioError> {
        let (changes, tracks) = (self.changes.len(), self.tracks.len());
        if changes > MAX_DRIVE_CHANGES {
            return Err(wrong("changes", changes.to_string(), "a list of at most 1000"));
        }
        if tracks > MAX_TRACKS {
            return Err(wrong("tracks", tracks.to_string(), "a list of at most 100"));
        }
        if let Some(sight) = self.sight.filter(|s| !(s.is_finite() && *s >= 0.0)) {
            return Err(wrong("sight", sight.to_string(), "0 or a positive number of cells"));
        }
        self.check_changes(grid, spec)?;
        self.tracks.iter().enumerate().try_for_each(|(index, track)| track.check(grid, spec, index))
    }

    fn check_changes(&self, grid: &Grid, spec: &ScenarioSpec) -> Result<(), ScenarioError> {
        let (mut map, mut before) = (grid.clone(), 0);
        for (index, change) in self.changes.iter().enumerate() {
            let step = format!("changes[{index}].at_step");
            check_number(&step, change.at_step, before..=MAX_STEP, "no step before that of the change before it, up to 1000000")?;
            before = change.at_step;
            change.check(&map, index)?;
            change.make(&mut map);
        }
        let walled = |at: Point| map.contains(at) && map.is_blocked(map.cell(at)) && !grid.is_blocked(grid.cell(at));
        match spec.goals.iter().find(|goal| walled(goal.at)) {
            Some(goal) => Err(wrong("changes", said(goal.at), "changes that leave every goal free in the end")),
            None => Ok(()),
        }
    }
}

/// # Errors
/// [`ScenarioError::Drive`] where a number of a drive is not within its range.
pub(super) fn check_number(
    field: &str,
    value: u32,
    within: RangeInclusive<u32>,
    allowed: &'static str,
) -> Result<(), ScenarioError> {
    if within.contains(&value) { Ok(()) } else { Err(wrong(field, value.to_string(), allowed)) }
}

/// A cell, as errors say it.
pub(super) fn said(cell: Point) -> String {
    format!("({}, {})", cell.x, cell.y)
}

/// A field of a drive that cannot be used.
pub(super) fn wrong(field: &str, value: String, allowed: &'static str) -> ScenarioError {
    ScenarioError::Drive { field: format!("drive.{field}"), value, allowed }
}
