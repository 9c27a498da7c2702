//! The shortest polyline through centres of free cells, consecutive ones in line of sight: the yardstick of refined and any-angle paths.
//!
//! A* in which every cell is a neighbour of every cell that it sees. No smaller graph would do: bends lie on centres, obstacles' corners
//! do not, so the best bend is where a centre happens to let the next segment pass the corner by a hair, and that may be far from every
//! obstacle (`tests/exact.rs` has such a map). The Euclidean distance to the goal is a consistent estimate, so the length is exact. Sight
//! is tried last, only where it would shorten a way: after a few expansions that is hardly anywhere.
//!
//! On a terrain segments follow the ground, which is no shorter than the straight line through the air: that one is the estimate, and what
//! tells whether a segment is worth following. Bends lie on cells that can be reached by steps, as those of every refined path do; with a
//! limit of slope an oblique segment may be passable where no step is.
//!
//! Pairs of cells grow with the square of the map, hence the limit of [`MOST_CELLS`]; `theta-star` takes any map, with a limit of its work.

use std::sync::Arc;

use super::SEARCH;
use super::best_first::{BestFirst, Rules, State, Tree};
use super::euclidean;
use crate::error::ParamError;
use crate::map::{Cell, Point};
use crate::params::{Values, check_keys};
use crate::path::line_of_sight;
use crate::planner::{Objective, Planner, PlannerEntry, Status, held};
use crate::scenario::Scenario;

/// Largest map in cells, free or not: 64 × 64.
pub const MOST_CELLS: usize = 64 * 64;

/// A free cell that a way may lead to.
#[derive(Clone)]
struct Candidate {
    cell: Cell,
    at: Point,
    to_goal: f64,
}

/// The rules of the search: all cells in sight.
#[derive(Clone, Default)]
struct AnyAngle {
    /// The free cells that can be reached at all.
    candidates: Vec<Candidate>,
    /// √(dx² + dy²) for every |dx| < width and |dy| < height, row by row.
    distances: Vec<f64>,
}

impl Rules for AnyAngle {
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

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    check_keys(ENTRY.id, &[], values)?;
    let (width, height) = (scenario.grid.width(), scenario.grid.height());
    if scenario.grid.len() > MOST_CELLS {
        let planner = ENTRY.id.into();
        return Err(ParamError::MapTooLarge { planner, width, height, most: MOST_CELLS as u32, instead: "theta-star" });
    }
    Ok(Box::new(BestFirst::new(Arc::clone(scenario), AnyAngle::default())))
}

/// The any-angle optimum in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "any-angle",
    name: "Any-angle optimum",
    summary: "A* over all pairs of cells that see each other; always the shortest polyline through cell centres, on maps of up to 64 × 64 cells.",
    source: "ours: A* (Hart, Nilsson, Raphael 1968) on the graph of all cells in line of sight",
    build,
    ..SEARCH
};
