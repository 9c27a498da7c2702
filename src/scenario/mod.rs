//! A scenario: a map and the question asked on it. [`ScenarioSpec`] is what people write, [`Scenario`] what planners may rely on.

#[cfg(feature = "whole")]
mod changes;
#[cfg(feature = "whole")]
mod drive;
#[cfg(feature = "whole")]
mod driving;
#[cfg(feature = "whole")]
mod robot;
mod spec;
mod terrain;
#[cfg(feature = "whole")]
mod track;
mod world;

use std::sync::Arc;

use crate::error::{Notice, ScenarioError};
use crate::map::{Cell, Grid, MoveSet, Movement, Point, Slices, length_on_plane};
#[cfg(feature = "whole")]
use crate::map::{Charge, Weights};

#[cfg(feature = "whole")]
pub use changes::{Change, MAX_CHANGES};
#[cfg(feature = "whole")]
pub use drive::{DriveChange, DriveSpec, MAX_DRIVE_CHANGES, MAX_STEP, MAX_TRACKS};
#[cfg(feature = "whole")]
pub use driving::{EnergyRule, SmoothingRule};
#[cfg(feature = "whole")]
pub use robot::{CostRule, FREE_COST, INSCRIBED_COST, Inflation, LETHAL_COST, MAX_MULTIPLIER, NAV2_RADIUS, Robot};
pub use spec::{Goal, ScenarioSpec, Vehicle};
use terrain::slices;
pub use terrain::{TerrainFields, TerrainMoves, TerrainSpec};
#[cfg(feature = "whole")]
pub use track::{AtEnd, MAX_OBSTACLE, MAX_STEPS_PER_CELL, MAX_TRACK_CELLS, Track};
pub use world::World;

/// Largest number of goals of a scenario.
pub const MAX_GOALS: usize = 64;

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
    const POSITIVE: &str = "a positive number, up to 1000000";
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
            quantity(field, value, value > 0.0 && value <= spec::MOST, POSITIVE)?;
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
