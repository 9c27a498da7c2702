//! A scenario: a map and the question asked on it. [`ScenarioSpec`] is what people write, [`Scenario`] what planners may rely on.

#[cfg(feature = "whole")]
mod changes;
#[cfg(feature = "whole")]
mod drive;
#[cfg(feature = "whole")]
mod driving;
#[cfg(feature = "whole")]
mod robot;
mod terrain;
#[cfg(feature = "whole")]
mod track;
mod world;

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::error::{Notice, ScenarioError};
use crate::map::{Cell, Generated, Grid, MoveSet, Movement, Point, Slices, length_on_plane};
#[cfg(feature = "whole")]
use crate::map::{Charge, Relief, Weights};

#[cfg(feature = "whole")]
pub use changes::{Change, MAX_CHANGES};
#[cfg(feature = "whole")]
pub use drive::{DriveChange, DriveSpec, MAX_DRIVE_CHANGES, MAX_STEP, MAX_TRACKS};
#[cfg(feature = "whole")]
pub use driving::{EnergyRule, SmoothingRule};
#[cfg(feature = "whole")]
pub use robot::{CostRule, FREE_COST, INSCRIBED_COST, Inflation, LETHAL_COST, MAX_MULTIPLIER, NAV2_RADIUS, Robot};
#[cfg(feature = "whole")]
use terrain::rise_over_run;
pub use terrain::{TerrainFields, TerrainMoves, TerrainSpec};
use terrain::{check_terrain, slices};
#[cfg(feature = "whole")]
pub use track::{AtEnd, MAX_OBSTACLE, MAX_STEPS_PER_CELL, MAX_TRACK_CELLS, Track};
pub use world::World;

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
    /// Where they are to arrive: all of them, in an order that the planner chooses. 1 to [`MAX_GOALS`].
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
        quantity("resolution", self.resolution, self.resolution > 0.0, "a positive number of metres")?;
        quantity("speed", self.vehicle.speed, self.vehicle.speed > 0.0, "a positive number of metres per second")?;
        let turn = self.vehicle.seconds_per_turn;
        quantity("seconds_per_turn", turn, turn >= 0.0, "0 or a positive number of seconds")?;
        #[cfg(feature = "whole")]
        driving::check_driving(&self.vehicle)?;
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
    fn check_what_moves(&self, grid: &Grid) -> Result<(), ScenarioError> {
        changes::check_changes(grid, self)?;
        self.drive.as_ref().map_or(Ok(()), |drive| drive.check(grid, self))
    }

    /// The allowed steps on a map, and what they cost. The opening build knows planes alone.
    fn steps(&self, grid: &Grid) -> MoveSet {
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

/// A validated scenario: start and goal are different or equal free cells of the map, all quantities are usable.
#[derive(Debug, Clone)]
pub struct Scenario {
    /// The map on which one moves: where the robot is no point, the cells in which it does not fit count as blocked.
    pub grid: Grid,
    /// The map as it was drawn or read: what obstacles there are. In the opening build, which knows no robots, that is the other one.
    #[cfg(feature = "whole")]
    pub drawn: Grid,
    /// What it was made from.
    pub spec: ScenarioSpec,
    /// The allowed steps of every cell. By slices only the ground below.
    pub moves: MoveSet,
    /// The places and steps of movement by slices; none where one moves from cell to cell.
    pub slices: Option<Arc<Slices>>,
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
    /// ```
    /// use formicarium::map::{Grid, Point};
    /// use formicarium::scenario::{Scenario, ScenarioSpec};
    ///
    /// let grid = Grid::from_bytes(3, 1, &[0, 1, 0])?;
    /// let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(2, 0));
    /// assert!(!Scenario::new(grid.clone(), spec)?.reachable(), "no path is an answer, not an error");
    ///
    /// let on_a_wall = ScenarioSpec::new(&grid, Point::new(1, 0), Point::new(2, 0));
    /// assert!(Scenario::new(grid, on_a_wall).is_err());
    /// # Ok::<(), formicarium::error::ScenarioError>(())
    /// ```
    ///
    /// # Errors
    /// [`ScenarioError`] names the field, the value and what is allowed.
    pub fn new(grid: Grid, spec: ScenarioSpec) -> Result<Self, ScenarioError> {
        spec.check(&grid)?;
        Self::asked(grid, spec, |spec, drawn| {
            let felt = spec.felt(drawn);
            let moves = spec.steps(&felt);
            (felt, moves)
        })
    }

    /// The same map, rules and changes with another start and other goals. What depends on the map alone is shared with this scenario, so
    /// it costs next to nothing, but by slices, whose places depend on their ends, and with changes or a drive, which must spare them.
    ///
    /// ```
    /// use formicarium::map::{Grid, Movement, Point};
    /// use formicarium::scenario::{Goal, Scenario};
    ///
    /// let scenario = Scenario::on(Grid::from_bytes(3, 1, &[0, 0, 1])?, Movement::default(), Point::new(0, 0), Point::new(1, 0))?;
    /// let back = scenario.with_ends(Point::new(1, 0), vec![Goal::new(Point::new(0, 0), "home")])?;
    /// assert_eq!((back.start, back.goal), (1, 0));
    /// assert!(scenario.with_ends(Point::new(2, 0), scenario.spec.goals.clone()).is_err(), "its start is blocked");
    /// # Ok::<(), formicarium::error::ScenarioError>(())
    /// ```
    ///
    /// # Errors
    /// What [`Scenario::new`] says of ends and changes.
    pub fn with_ends(&self, start: Point, goals: Vec<Goal>) -> Result<Self, ScenarioError> {
        let spec = ScenarioSpec { start, goals, ..self.spec.clone() };
        #[cfg(feature = "whole")]
        spec.check_what_moves(&self.drawn)?;
        Self::asked(self.obstacles().clone(), spec, |_, _| (self.grid.clone(), self.moves.clone()))
    }

    /// What obstacles there are: the map as it was drawn.
    #[inline(always)]
    pub fn obstacles(&self) -> &Grid {
        #[cfg(feature = "whole")]
        return &self.drawn;
        #[cfg(not(feature = "whole"))]
        &self.grid
    }

    /// Validates the ends of a scenario that is otherwise usable; `felt` makes the map on which one moves of the drawn one, and its steps.
    fn asked(
        drawn: Grid,
        spec: ScenarioSpec,
        felt: impl FnOnce(&ScenarioSpec, &Grid) -> (Grid, MoveSet),
    ) -> Result<Self, ScenarioError> {
        let start = free_cell(&drawn, "start", spec.start)?;
        let goals = goal_cells(&drawn, &spec.goals)?;
        let (grid, moves) = felt(&spec, &drawn);
        #[cfg(feature = "whole")]
        robot::check_room(&grid, &spec)?;
        let slices = if cfg!(feature = "whole") { slices(&grid, &spec, start, &goals)?.map(Arc::new) } else { None };
        Ok(Self {
            grid,
            #[cfg(feature = "whole")]
            drawn,
            spec,
            moves,
            slices,
            start,
            goal: goals[0],
            goals,
        })
    }

    /// For measuring paths that need not be valid, from cell to cell between any two cells of the map.
    pub fn unvalidated(drawn: Grid, spec: ScenarioSpec, start: Cell, goal: Cell) -> Self {
        let grid = spec.felt(&drawn);
        let moves = spec.steps(&grid);
        Self {
            grid,
            #[cfg(feature = "whole")]
            drawn,
            spec,
            moves,
            slices: None,
            start,
            goal,
            goals: vec![goal],
        }
    }

    /// The same map with another start and one goal: a leg of a tour. Both must be free cells.
    #[must_use]
    pub fn leg(&self, start: Cell, goal: Cell) -> Self {
        let goals = vec![Goal::new(self.grid.point(goal), "")];
        let spec = ScenarioSpec { start: self.grid.point(start), goals, ..self.spec.clone() };
        let slices = self.slices.clone();
        Self {
            grid: self.grid.clone(),
            #[cfg(feature = "whole")]
            drawn: self.drawn.clone(),
            spec,
            moves: self.moves.clone(),
            slices,
            start,
            goal,
            goals: vec![goal],
        }
    }

    /// The places and steps of movement by slices, if that is how one moves; never in the opening build, which is spared their code.
    #[inline(always)]
    pub fn by_slices(&self) -> Option<&Slices> {
        if cfg!(feature = "whole") { self.slices.as_deref() } else { None }
    }

    /// What planners make small, in cells: the length of a path of allowed steps or of segments in line of sight, on weighted ground what
    /// it costs.
    pub fn path_length(&self, path: &[Cell]) -> f64 {
        match self.moves.weights() {
            Some(weights) => path.windows(2).map(|s| weights.segment(s[0], s[1])).sum(),
            None => self.ground_length(path),
        }
    }

    /// Length in cells of a path of allowed steps or of segments in line of sight; along the ground of a terrain. By slices
    /// Σ √(1 + Δy² + Δh²), cells and levels counting 1 each.
    pub fn ground_length(&self, path: &[Cell]) -> f64 {
        let sum = |length: &dyn Fn(Cell, Cell) -> f64| path.windows(2).map(|s| length(s[0], s[1])).sum();
        match (self.by_slices(), self.moves.relief()) {
            (Some(slices), _) => sum(&|a, b| slices.length(a, b)),
            (None, Some(relief)) => sum(&|a, b| relief.segment(a, b).length),
            (None, None) => length_on_plane(self.grid.width(), path),
        }
    }

    /// The same scenario with its weighted ground charged by another rule; on any other ground the same.
    #[cfg(feature = "whole")]
    #[must_use]
    pub fn charging(self, charge: Charge) -> Self {
        let factors = self.grid.factors().filter(|_| self.moves.weights().is_some());
        let moves = match factors {
            Some(factors) => self.moves.clone().weighing(Weights::new(Arc::clone(factors), &self.grid, charge)),
            None => self.moves.clone(),
        };
        Self { moves, ..self }
    }

    /// The cells of a path, whatever its places are.
    pub fn cells_of(&self, path: &[Cell]) -> Vec<Cell> {
        let area = self.grid.len() as Cell;
        path.iter().map(|place| place % area).collect()
    }

    /// Altitudes of a path's places in metres, on the ground or by slices at their levels; empty on a plane.
    pub fn altitudes(&self, path: &[Cell]) -> Vec<f64> {
        let Some(heights) = self.grid.heights() else { return Vec::new() };
        let unit = self.spec.terrain.map_or(1.0, |t| t.vertical_unit);
        match self.by_slices() {
            Some(slices) => path.iter().map(|&p| f64::from(slices.at(p).2) * slices.rules().level).collect(),
            None => path.iter().map(|&c| f64::from(heights[c as usize]) * unit).collect(),
        }
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

    /// Whether the first goal can be reached from the start.
    pub fn connected(&self) -> bool {
        self.by_slices().map_or_else(|| self.moves.connected(self.start, self.goal), |slices| slices.reachable())
    }

    /// Whether every goal can be reached from the start.
    pub fn reachable(&self) -> bool {
        if let Some(slices) = self.by_slices() {
            return slices.reachable();
        }
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
        return Err(ScenarioError::GoalCount { got: goals.len(), most: MAX_GOALS });
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

#[cfg(test)]
mod tests;
