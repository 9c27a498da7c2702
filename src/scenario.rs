//! A scenario: a map and the question asked on it. [`ScenarioSpec`] is what people write, [`Scenario`] what planners may rely on.

use serde::{Deserialize, Serialize};

use crate::error::{Notice, ScenarioError};
use crate::map::{Cell, Grid, MoveSet, Movement, Point};

/// A place to reach.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Goal {
    /// Its cell.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number]"))]
    pub at: Point,
    /// Its name in tables; may be empty.
    pub name: String,
}

/// What turns a path into seconds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Vehicle {
    /// Speed on straight stretches, metres per second, above 0.
    pub speed: f64,
    /// Seconds lost at each turn, at least 0.
    pub seconds_per_turn: f64,
}

impl Default for Vehicle {
    fn default() -> Self {
        Self { speed: 1.0, seconds_per_turn: 0.0 }
    }
}

/// A scenario without its cells, as files and the page hold it.
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
    /// Where they are to arrive. The planners of today take exactly one.
    pub goals: Vec<Goal>,
    /// For the travel time.
    pub vehicle: Vehicle,
}

impl ScenarioSpec {
    /// A scenario with one goal, 8 moves, corner rule `both-free`, one metre a cell.
    pub fn new(grid: &Grid, start: Point, goal: Point) -> Self {
        Self {
            name: String::new(),
            width: grid.width(),
            height: grid.height(),
            resolution: 1.0,
            movement: Movement::default(),
            start,
            goals: vec![Goal { at: goal, name: String::new() }],
            vehicle: Vehicle::default(),
        }
    }
}

/// A validated scenario: start and goal are different or equal free cells of the map, all quantities are usable.
#[derive(Debug, Clone)]
pub struct Scenario {
    /// The map.
    pub grid: Grid,
    /// What it was made from.
    pub spec: ScenarioSpec,
    /// The allowed steps of every cell.
    pub moves: MoveSet,
    /// Start cell.
    pub start: Cell,
    /// Goal cell.
    pub goal: Cell,
}

impl Scenario {
    /// Validates a scenario.
    ///
    /// # Errors
    /// [`ScenarioError`] names the field, the value and what is allowed.
    pub fn new(grid: Grid, spec: ScenarioSpec) -> Result<Self, ScenarioError> {
        if (spec.width, spec.height) != (grid.width(), grid.height()) {
            return Err(ScenarioError::CellCount { width: spec.width, height: spec.height, got: grid.len() });
        }
        quantity("resolution", spec.resolution, spec.resolution > 0.0, "a positive number of metres")?;
        quantity("speed", spec.vehicle.speed, spec.vehicle.speed > 0.0, "a positive number of metres per second")?;
        let turn = spec.vehicle.seconds_per_turn;
        quantity("seconds_per_turn", turn, turn >= 0.0, "0 or a positive number of seconds")?;
        let start = free_cell(&grid, "start", spec.start)?;
        let [goal] = spec.goals.as_slice() else {
            return Err(ScenarioError::GoalCount { got: spec.goals.len() });
        };
        let goal = free_cell(&grid, "goal", goal.at)?;
        let moves = MoveSet::new(&grid, spec.movement);
        Ok(Self { grid, spec, moves, start, goal })
    }

    /// From one goal on a grid, with the defaults of [`ScenarioSpec::new`] and the given movement.
    ///
    /// # Errors
    /// As [`Scenario::new`].
    pub fn on(grid: Grid, movement: Movement, start: Point, goal: Point) -> Result<Self, ScenarioError> {
        let spec = ScenarioSpec { movement, ..ScenarioSpec::new(&grid, start, goal) };
        Self::new(grid, spec)
    }

    /// What is worth saying about a usable scenario: an unreachable goal, a start that is the goal.
    pub fn notices(&self) -> Vec<Notice> {
        let mut notices = Vec::new();
        if self.start == self.goal {
            notices.push(Notice::new("start-is-goal", "start and goal are the same cell: the path has length 0"));
        } else if !self.moves.connected(self.start, self.goal) {
            notices.push(Notice::new("unreachable", "no path leads from start to goal under this movement"));
        }
        notices
    }
}

fn quantity(field: &'static str, value: f64, ok: bool, allowed: &'static str) -> Result<(), ScenarioError> {
    if ok && value.is_finite() { Ok(()) } else { Err(ScenarioError::Quantity { field, value: value.to_string(), allowed }) }
}

fn free_cell(grid: &Grid, role: &'static str, p: Point) -> Result<Cell, ScenarioError> {
    if !grid.contains(p) {
        let (width, height) = (grid.width(), grid.height());
        return Err(ScenarioError::OutsideMap { role, x: i64::from(p.x), y: i64::from(p.y), width, height });
    }
    let cell = grid.cell(p);
    if grid.is_blocked(cell) { Err(ScenarioError::Blocked { role, x: p.x, y: p.y }) } else { Ok(cell) }
}
