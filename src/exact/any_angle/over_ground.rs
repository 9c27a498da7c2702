//! The rules of the search on a terrain: all pairs of cells.

use crate::exact::best_first::{Rules, State, Tree};
use crate::exact::euclidean;
use crate::map::{Cell, Point};
use crate::path::line_of_sight;
use crate::planner::{Objective, Status, held};
use crate::scenario::Scenario;

/// A cell of a terrain that a way may lead to.
#[derive(Clone)]
struct Candidate {
    cell: Cell,
    at: Point,
    to_goal: f64,
}

/// What the search keeps.
#[derive(Clone, Default)]
pub(super) struct OverGround {
    /// The free cells that can be reached at all.
    candidates: Vec<Candidate>,
    /// √(dx² + dy²) for every |dx| < width and |dy| < height, row by row.
    distances: Vec<f64>,
}

impl Rules for OverGround {
    const OBJECTIVE: Objective = Objective::PolylineLength;
    const FOUND: Status = Status::Optimal;

    fn prepare(&mut self, scenario: &Scenario) {
        let reached = scenario.moves.reached_from(scenario.start);
        let cells = (0..scenario.grid.len() as Cell).filter(|&c| reached[c as usize]);
        let candidate = |cell| Candidate { cell, at: scenario.grid.point(cell), to_goal: self.to_goal(scenario, cell) };
        self.candidates = cells.map(candidate).collect();
        self.distances = (0..scenario.grid.len() as Cell).map(|c| euclidean(scenario, 0, c)).collect();
    }

    fn bytes(&self) -> usize {
        held(&self.candidates) + held(&self.distances)
    }

    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64 {
        through_the_air(scenario, cell, scenario.goal, euclidean(scenario, cell, scenario.goal))
    }

    fn expand(&mut self, scenario: &Scenario, cell: State, tree: &mut Tree) {
        let (g, at, width) = (tree.g(cell), scenario.grid.point(cell), scenario.grid.width());
        for next in &self.candidates {
            let offset = next.at.y.abs_diff(at.y) * width + next.at.x.abs_diff(at.x);
            let on_map = self.distances[offset as usize];
            let straight = g + through_the_air(scenario, cell, next.cell, on_map);
            if !tree.improves(next.cell, straight, next.to_goal) {
                continue;
            }
            let next_g = scenario.moves.relief().map_or(straight, |relief| g + relief.segment(cell, next.cell).length);
            if tree.improves(next.cell, next_g, next.to_goal) && line_of_sight(scenario, at, next.at) {
                tree.relax(next.cell, next_g, next.to_goal, cell, next.cell == scenario.goal);
            }
        }
    }
}

/// Length in cells of the straight line between two cells' centres that are so far apart on the map: on a terrain with their heights.
fn through_the_air(scenario: &Scenario, a: Cell, b: Cell, on_map: f64) -> f64 {
    scenario.moves.relief().map_or(on_map, |relief| {
        let z = relief.height(a) - relief.height(b);
        libm::sqrt(on_map * on_map + z * z)
    })
}
