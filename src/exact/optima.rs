//! The shortest lengths on one map, for who has many questions about it.

use std::sync::Arc;

use super::astar::Distance;
use super::jump_points::JumpPoints;
use super::search::Search;
use crate::map::{Cell, Moves};
use crate::planner::Planner;
use crate::scenario::Scenario;

/// Lengths of shortest paths of steps from cell to cell on a scenario's map, under its rules: between any two cells, without the paths.
///
/// By jump points with 8 moves on plain ground; elsewhere by A*, which finds the same. What depends on the map alone is worked out once.
///
/// ```
/// # use std::sync::Arc;
/// use formicarium::exact::Optima;
/// use formicarium::map::{Grid, Movement, Point};
/// use formicarium::scenario::Scenario;
///
/// let scenario = Scenario::on(Grid::open(4, 2)?, Movement::default(), Point::new(0, 0), Point::new(3, 0))?;
/// let mut optima = Optima::new(&Arc::new(scenario));
/// assert_eq!(optima.between(0, 3), Some(3.0));
/// assert_eq!(optima.between(0, 7), Some(2.0 + 2f64.sqrt()));
/// # Ok::<(), formicarium::error::ScenarioError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Optima {
    scenario: Arc<Scenario>,
    /// None where A* answers.
    pub(super) jump_points: Option<JumpPoints>,
    /// Cells that A* has expanded.
    expansions: u64,
}

impl Optima {
    /// On the scenario's map; its ends do not matter.
    pub fn new(scenario: &Arc<Scenario>) -> Self {
        let movement = scenario.spec.movement;
        let jumps = movement.moves == Moves::Eight && scenario.moves.is_plain() && scenario.by_slices().is_none();
        let jump_points = jumps.then(|| JumpPoints::new(&scenario.grid, movement.corner_rule));
        Self { scenario: Arc::clone(scenario), jump_points, expansions: 0 }
    }

    /// Length in cells of the shortest path between two cells of the map, with the bits of [`Scenario::path_length`]; `None` when there is
    /// none.
    pub fn between(&mut self, start: Cell, goal: Cell) -> Option<f64> {
        let grid = &self.scenario.grid;
        match &mut self.jump_points {
            Some(jump_points) => jump_points.shortest(grid.point(start), grid.point(goal)),
            None => {
                let (length, expansions) = by_astar(&self.scenario, start, goal);
                self.expansions += expansions;
                length
            }
        }
    }

    /// What was expanded for all answers so far: jump points, or cells where A* answers.
    pub fn expansions(&self) -> u64 {
        self.expansions + self.jump_points.as_ref().map_or(0, JumpPoints::expansions)
    }
}

/// Length of the shortest path, and the cells that A* expands for it.
pub(super) fn by_astar(scenario: &Arc<Scenario>, start: Cell, goal: Cell) -> (Option<f64>, u64) {
    let mut search = Search::between(Arc::clone(scenario), start, goal, Distance::to(scenario, goal));
    search.run();
    (search.best().map(|best| scenario.path_length(&best.path)), search.effort().cell_expansions)
}
