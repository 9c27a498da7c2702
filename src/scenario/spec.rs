//! A scenario as people write it: the question without its cells.

#[cfg(feature = "whole")]
use std::sync::Arc;

use serde::{Deserialize, Serialize};

#[cfg(feature = "whole")]
use super::changes::{self, Change};
#[cfg(feature = "whole")]
use super::drive::DriveSpec;
#[cfg(feature = "whole")]
use super::driving::{EnergyRule, SmoothingRule, check_driving};
#[cfg(feature = "whole")]
use super::robot::{self, Robot};
#[cfg(feature = "whole")]
use super::terrain::{TerrainMoves, rise_over_run};
use super::terrain::{TerrainSpec, check_terrain};
use super::{World, quantity};
use crate::error::ScenarioError;
#[cfg(feature = "whole")]
use crate::map::{Charge, Relief, Weights};
use crate::map::{Generated, Grid, MoveSet, Movement, Point};

/// A place to reach. Area, strength and danger say how urgent it is, for planners that choose the order of several goals.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Goal {
    /// Its cell.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number]"))]
    pub at: Point,
    /// Its name in tables; may be empty.
    pub name: String,
    /// s, how large it is (a fire's area), above 0.
    pub area: f64,
    /// w, how strong it is, above 0.
    pub strength: f64,
    /// a, how dangerous it is, above 0.
    pub danger: f64,
}

impl Goal {
    /// A goal like any other: area, strength and danger are 1.
    pub fn new(at: Point, name: impl Into<String>) -> Self {
        Self { at, name: name.into(), area: 1.0, strength: 1.0, danger: 1.0 }
    }

    /// b = 1 / (s·w·a): how much of a way to this goal counts in the comprehensive weight (fire-fighting paper, Eq. 7).
    pub fn weight(&self) -> f64 {
        1.0 / (self.area * self.strength * self.danger)
    }
}

/// Who drives along a path: what turns it into seconds, into energy, and into a curve.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Vehicle {
    /// Speed on straight stretches, metres per second, above 0.
    pub speed: f64,
    /// Seconds lost at each turn, at least 0.
    pub seconds_per_turn: f64,
    /// What driving costs; where it is absent, [`EnergyRule::default`]. No search depends on it. The opening build knows none.
    #[cfg(feature = "whole")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub energy: Option<EnergyRule>,
    /// Results carry a smoothed curve as well where it is present. No search depends on it. The opening build knows none.
    #[cfg(feature = "whole")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub smoothing: Option<SmoothingRule>,
}

impl Vehicle {
    /// Seconds for so many metres with so many turns.
    pub fn travel_time(self, metres: f64, turns: u32) -> f64 {
        metres / self.speed + f64::from(turns) * self.seconds_per_turn
    }
}

impl Default for Vehicle {
    fn default() -> Self {
        Self {
            speed: 1.0,
            seconds_per_turn: 0.0,
            #[cfg(feature = "whole")]
            energy: None,
            #[cfg(feature = "whole")]
            smoothing: None,
        }
    }
}

/// Largest quantity of a scenario, in its unit: what is larger is a slip.
pub(super) const MOST: f64 = 1e6;

/// Longest name of a map or a goal, in letters.
const LONGEST_NAME: usize = 1000;

/// A scenario without its cells, as files and the page hold it.
///
/// ```
/// use formicarium::map::{Grid, Point};
/// use formicarium::scenario::{Goal, ScenarioSpec};
///
/// let grid = Grid::open(30, 20)?;
/// let mut spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(29, 19));
/// spec.resolution = 0.5; // metres a cell
/// spec.goals.push(Goal::new(Point::new(15, 3), "on the way"));
/// assert_eq!((spec.width, spec.goals.len()), (30, 2));
/// # Ok::<(), formicarium::error::ScenarioError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ScenarioSpec {
    /// Its name in tables; may be empty.
    pub name: String,
    /// Width in cells.
    pub width: u32,
    /// Height in cells.
    pub height: u32,
    /// Metres per cell, above 0.
    pub resolution: f64,
    /// Moves and corner rule.
    pub movement: Movement,
    /// Where ants and searches start.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number]"))]
    pub start: Point,
    /// Where they are to arrive: all of them, in an order that the planner chooses. 1 to [`super::MAX_GOALS`].
    pub goals: Vec<Goal>,
    /// For arrival time, energy and smoothing.
    pub vehicle: Vehicle,
    /// On a map with heights; none on a plane. The opening build knows no terrains and is spared reading them.
    #[cfg_attr(feature = "whole", serde(default, skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(not(feature = "whole"), serde(skip))]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "TerrainFields", optional))]
    pub terrain: Option<TerrainSpec>,
    /// Where the map lies in the world; none where that is not known. No result depends on it.
    #[cfg_attr(feature = "whole", serde(default, skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(not(feature = "whole"), serde(skip))]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub world: Option<World>,
    /// The robot that moves; none where it is a point. The opening build knows none.
    #[cfg(feature = "whole")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub robot: Option<Robot>,
    /// How walls change while planners are at work, in the order of their iterations; empty where they stay. The opening build knows none.
    #[cfg(feature = "whole")]
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub changes: Vec<Change>,
    /// What moves while a robot drives over the map; none where nothing does. Planners alone see the map before its first step.
    #[cfg(feature = "whole")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub drive: Option<DriveSpec>,
}

impl Generated {
    /// The question that comes with the map.
    pub fn spec(&self, name: impl Into<String>) -> ScenarioSpec {
        let spec = ScenarioSpec::new(&self.grid, self.start, self.goal);
        ScenarioSpec { name: name.into(), resolution: self.resolution, ..spec }
    }
}

impl ScenarioSpec {
    /// A scenario with one goal, 8 moves, corner rule `both-free`, one metre a cell; with heights, a terrain with the defaults of
    /// [`TerrainSpec`].
    pub fn new(grid: &Grid, start: Point, goal: Point) -> Self {
        Self {
            name: String::new(),
            width: grid.width(),
            height: grid.height(),
            resolution: 1.0,
            movement: Movement::default(),
            start,
            goals: vec![Goal::new(goal, "")],
            vehicle: Vehicle::default(),
            terrain: grid.heights().map(|_| TerrainSpec::default()),
            world: None,
            #[cfg(feature = "whole")]
            robot: None,
            #[cfg(feature = "whole")]
            changes: Vec::new(),
            #[cfg(feature = "whole")]
            drive: None,
        }
    }

    /// Checks all but start and goals: sizes, quantities, the terrain, the changes of the walls, the drive.
    ///
    /// # Errors
    /// [`ScenarioError`] names the field, the value and what is allowed.
    pub fn check(&self, grid: &Grid) -> Result<(), ScenarioError> {
        if (self.width, self.height) != (grid.width(), grid.height()) {
            return Err(ScenarioError::CellCount { width: self.width, height: self.height, got: grid.len() });
        }
        let within = |value: f64| value > 0.0 && value <= MOST;
        quantity("resolution", self.resolution, within(self.resolution), "a positive number of metres, up to 1000000")?;
        let Vehicle { speed, seconds_per_turn, .. } = self.vehicle;
        quantity("speed", speed, within(speed), "a positive number of metres per second, up to 1000000")?;
        let turns = (0.0..=MOST).contains(&seconds_per_turn);
        quantity("seconds_per_turn", seconds_per_turn, turns, "0 or a positive number of seconds, up to 1000000")?;
        let names = std::iter::once(&self.name).chain(self.goals.iter().map(|goal| &goal.name));
        let longest = names.map(|name| name.chars().count()).max().unwrap_or(0);
        quantity("name", longest as f64, longest <= LONGEST_NAME, "one of at most 1000 letters")?;
        #[cfg(feature = "whole")]
        check_driving(&self.vehicle)?;
        self.world.as_ref().map_or(Ok(()), World::check)?;
        check_terrain(grid, self)?;
        #[cfg(feature = "whole")]
        robot::check(grid, self)?;
        #[cfg(feature = "whole")]
        self.check_what_moves(grid)?;
        Ok(())
    }

    /// Checks the changes of the walls, and the drive.
    #[cfg(feature = "whole")]
    pub(super) fn check_what_moves(&self, grid: &Grid) -> Result<(), ScenarioError> {
        changes::check_changes(grid, self)?;
        self.drive.as_ref().map_or(Ok(()), |drive| drive.check(grid, self))
    }

    /// The allowed steps on a map, and what they cost. The opening build knows planes alone.
    pub(super) fn steps(&self, grid: &Grid) -> MoveSet {
        let moves = MoveSet::new(grid, self.movement);
        #[cfg(feature = "whole")]
        if let Some(relief) = self.relief(grid) {
            return moves.over(relief);
        }
        #[cfg(feature = "whole")]
        if let Some(factors) = grid.factors() {
            return moves.weighing(Weights::new(Arc::clone(factors), grid, Charge::default()));
        }
        moves
    }

    /// Whether the robot touches an obstacle so far away, by the squared distance in cells: a point only one in its own cell.
    #[cfg(feature = "whole")]
    pub(crate) fn touches(&self, squared: u32) -> bool {
        self.robot.map_or(squared == 0, |robot| robot.touches(squared, self.resolution))
    }

    /// How far away, in cells, an obstacle is felt by the robot; none for a point.
    #[cfg(feature = "whole")]
    pub(crate) fn reach(&self) -> Option<u32> {
        self.robot.map(|robot| robot.reach(self.resolution))
    }

    /// A drawn map as the robot of a checked spec feels it: blocked where it does not fit, dearer where an obstacle is near.
    pub(crate) fn felt(&self, drawn: &Grid) -> Grid {
        #[cfg(feature = "whole")]
        if let Some(robot) = &self.robot {
            return robot.feels(drawn, self.resolution);
        }
        drawn.clone()
    }

    /// The ground of a terrain in lengths of cells; none on a plane.
    #[cfg(feature = "whole")]
    fn relief(&self, grid: &Grid) -> Option<Relief> {
        let terrain = self.terrain?;
        let steepest = match terrain.moves {
            TerrainMoves::Surface { max_slope } if max_slope < 90.0 => rise_over_run(max_slope),
            _ => f64::INFINITY,
        };
        Some(Relief::new(Arc::clone(grid.heights()?), self.width, terrain.vertical_unit / self.resolution, steepest))
    }
}
