//! A scenario: a map and the question asked on it. [`ScenarioSpec`] is what people write, [`Scenario`] what planners may rely on.

use serde::{Deserialize, Serialize};

use crate::error::{Notice, ScenarioError};
use crate::map::{Cell, Grid, MoveSet, Movement, Point};

/// Largest number of goals of a scenario.
pub const MAX_GOALS: usize = 64;

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
    /// Where they are to arrive: all of them, in an order that the planner chooses. 1 to [`MAX_GOALS`].
    pub goals: Vec<Goal>,
    /// For the arrival time.
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
            goals: vec![Goal::new(goal, "")],
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
    /// Goal cell; the first of several.
    pub goal: Cell,
    /// All goal cells, in the scenario's order; never two the same.
    pub goals: Vec<Cell>,
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
        let goals = goal_cells(&grid, &spec.goals)?;
        let moves = MoveSet::new(&grid, spec.movement);
        Ok(Self { grid, spec, moves, start, goal: goals[0], goals })
    }

    /// The same map with another start and one goal: a leg of a tour. Both must be free cells.
    #[must_use]
    pub fn leg(&self, start: Cell, goal: Cell) -> Self {
        let goals = vec![Goal::new(self.grid.point(goal), "")];
        let spec = ScenarioSpec { start: self.grid.point(start), goals, ..self.spec.clone() };
        Self { grid: self.grid.clone(), spec, moves: self.moves.clone(), start, goal, goals: vec![goal] }
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
        if self.goals == [self.start] {
            notices.push(Notice::new("start-is-goal", "start and goal are the same cell: the path has length 0"));
        } else if !self.reachable() {
            notices.push(Notice::new("unreachable", "no path leads from start to goal under this movement"));
        }
        notices
    }

    /// Whether every goal can be reached from the start.
    pub fn reachable(&self) -> bool {
        let reached = self.moves.reached_from(self.start);
        self.goals.iter().all(|&g| reached[g as usize])
    }
}

fn quantity(field: &'static str, value: f64, ok: bool, allowed: &'static str) -> Result<(), ScenarioError> {
    if ok && value.is_finite() { Ok(()) } else { Err(ScenarioError::Quantity { field, value: value.to_string(), allowed }) }
}

/// The cells of the goals.
fn goal_cells(grid: &Grid, goals: &[Goal]) -> Result<Vec<Cell>, ScenarioError> {
    const POSITIVE: &str = "a positive number";
    if !(1..=MAX_GOALS).contains(&goals.len()) {
        return Err(ScenarioError::GoalCount { got: goals.len() });
    }
    let mut cells = Vec::with_capacity(goals.len());
    for goal in goals {
        let cell = free_cell(grid, "goal", goal.at)?;
        if cells.contains(&cell) {
            return Err(ScenarioError::GoalTwice { x: goal.at.x, y: goal.at.y });
        }
        cells.push(cell);
        for (field, value) in [("area", goal.area), ("strength", goal.strength), ("danger", goal.danger)] {
            quantity(field, value, value > 0.0, POSITIVE)?;
        }
        quantity("weight of a goal", goal.weight(), goal.weight() > 0.0, "a positive number: 1 / (area · strength · danger)")?;
    }
    Ok(cells)
}

fn free_cell(grid: &Grid, role: &'static str, p: Point) -> Result<Cell, ScenarioError> {
    if !grid.contains(p) {
        let (width, height) = (grid.width(), grid.height());
        return Err(ScenarioError::OutsideMap { role, x: i64::from(p.x), y: i64::from(p.y), width, height });
    }
    let cell = grid.cell(p);
    if grid.is_blocked(cell) { Err(ScenarioError::Blocked { role, x: p.x, y: p.y }) } else { Ok(cell) }
}
