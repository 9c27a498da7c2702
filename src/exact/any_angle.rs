//! The shortest polyline through centres of free cells, consecutive ones in line of sight: the yardstick of refined and any-angle paths.
//!
//! A* in which every cell is a neighbour of every cell that it sees. No smaller graph would do: bends lie on centres, obstacles' corners
//! do not, so the best bend is where a centre happens to let the next segment pass the corner by a hair, and that may be far from every
//! obstacle (`tests/exact.rs` has such a map). The Euclidean distance to the goal is a consistent estimate, so the length is exact. On a
//! plane `exact/sight.rs` tells all cells that a cell sees, in little more time than it takes to list them. The work still grows with how much
//! is seen from how many cells: hence the limit of [`MOST_CELLS`], and the search ends when it has looked at [`MOST_LOOKED_AT`] of them, as a
//! run whose budget is spent, with the best way to the goal that it then knows, if any. `theta-star` takes any map.
//!
//! On a terrain segments follow the ground, which is no shorter than the straight line through the air: that one is the estimate, and what
//! tells whether a segment is worth following. Bends lie on cells that can be reached by steps, as those of every refined path do; with a
//! limit of slope an oblique segment may be passable where no step is. There sight is tried pair by pair, last and only where it would
//! shorten a way, on terrains of up to [`MOST_CELLS_OF_TERRAIN`].

use std::sync::Arc;

use super::SEARCH;
use super::best_first::{BestFirst, Rules, State, Tree};
use super::euclidean;
use super::sight::Sight;
use crate::error::ParamError;
use crate::map::{Cell, Point};
use crate::params::{Values, check_keys};
use crate::path::line_of_sight;
use crate::planner::{Ground, Objective, Planner, PlannerEntry, Status, held};
use crate::scenario::Scenario;

/// Largest plane in cells, free or not: 1024 × 1024, for which the search holds up to a quarter of a gigabyte.
pub const MOST_CELLS: usize = 1 << 20;

/// Largest terrain in cells, free or not: 64 × 64.
pub const MOST_CELLS_OF_TERRAIN: usize = 64 * 64;

/// Cells at which a search on a plane looks at most: some seconds.
const MOST_LOOKED_AT: u64 = 1 << 30;

/// The rules of the search on a plane: all cells in sight.
#[derive(Clone)]
struct InSight {
    sight: Sight,
    /// Cells to which a way is found to be shorter; empty between two expansions.
    shorter: Vec<Cell>,
    /// Cells that it may still look at.
    left: u64,
}

impl InSight {
    fn new(scenario: &Scenario, left: u64) -> Self {
        Self { sight: Sight::new(&scenario.grid, scenario.spec.movement), shorter: Vec::new(), left }
    }
}

impl Rules for InSight {
    const OBJECTIVE: Objective = Objective::PolylineLength;
    const FOUND: Status = Status::Optimal;

    fn bytes(&self) -> usize {
        self.sight.bytes() + held(&self.shorter)
    }

    fn is_spent(&self) -> bool {
        self.left == 0
    }

    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64 {
        euclidean(scenario, cell, scenario.goal)
    }

    fn expand(&mut self, scenario: &Scenario, cell: State, tree: &mut Tree) {
        let g = tree.g(cell);
        let mut shorter = std::mem::take(&mut self.shorter);
        let looked = self.sight.around(scenario.grid.point(cell), |next, away| {
            if tree.is_cheaper(next, g + away) {
                shorter.push(next);
            }
        });
        self.left = self.left.saturating_sub(looked);
        // The goal first: once the way to it is known, no other cell in sight can be on a better one, and none of them needs to wait.
        shorter.sort_unstable_by_key(|&next| (next != scenario.goal, next));
        for next in shorter.drain(..) {
            let next_g = g + euclidean(scenario, cell, next);
            tree.relax(next, next_g, self.to_goal(scenario, next), cell, next == scenario.goal);
        }
        self.shorter = shorter;
    }
}

/// A cell of a terrain that a way may lead to.
#[derive(Clone)]
struct Candidate {
    cell: Cell,
    at: Point,
    to_goal: f64,
}

/// The rules of the search on a terrain: all pairs of cells.
#[derive(Clone, Default)]
struct OverGround {
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

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    check_keys(ENTRY.id, &[], values)?;
    let on_plane = scenario.moves.relief().is_none();
    let (most, instead) = if on_plane { (MOST_CELLS, "theta-star") } else { (MOST_CELLS_OF_TERRAIN, "astar") };
    if scenario.grid.len() > most {
        let (width, height) = (scenario.grid.width(), scenario.grid.height());
        return Err(ParamError::MapTooLarge { planner: ENTRY.id.into(), width, height, most: most as u32, instead });
    }
    let scenario = Arc::clone(scenario);
    if on_plane {
        let rules = InSight::new(&scenario, MOST_LOOKED_AT);
        Ok(Box::new(BestFirst::new(scenario, rules)))
    } else {
        Ok(Box::new(BestFirst::new(scenario, OverGround::default())))
    }
}

/// The any-angle optimum in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "any-angle",
    name: "Any-angle optimum",
    summary: "A* over all pairs of cells that see each other; always the shortest polyline through cell centres, on planes of up to 1024 × 1024 cells within a limit of work, on terrains of up to 64 × 64.",
    source: "ours: A* (Hart, Nilsson, Raphael 1968) on the graph of all cells in line of sight",
    grounds: Ground::LENGTHS,
    build,
    ..SEARCH
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{CornerRule, Generator, Movement, Moves, generate};

    fn made(kind: Generator, side: u32, seed: u32, movement: Movement) -> Arc<Scenario> {
        let made = generate(kind, side, side, seed, 0.25).expect("a map");
        Arc::new(Scenario::on(made.grid, movement, made.start, made.goal).expect("usable"))
    }

    fn run(scenario: &Arc<Scenario>, rules: impl Rules + 'static) -> Box<dyn Planner> {
        let mut search = Box::new(BestFirst::new(Arc::clone(scenario), rules));
        search.run();
        search
    }

    #[test]
    fn all_that_is_seen_at_once_is_all_pairs_in_sight() {
        let kinds = [Generator::Random, Generator::Cave, Generator::Rooms, Generator::Maze];
        for (seed, corner_rule) in (0..24).zip(CornerRule::ALL.into_iter().cycle()) {
            let moves = if seed % 8 == 7 { Moves::Four } else { Moves::Eight };
            let scenario = made(kinds[seed as usize % 4], 20 + seed, seed, Movement { moves, corner_rule });
            let (found, expected) =
                (run(&scenario, InSight::new(&scenario, MOST_LOOKED_AT)), run(&scenario, OverGround::default()));
            assert_eq!(found.status(), Status::Optimal, "{:?}", scenario.spec);
            assert_eq!(found.effort(), expected.effort(), "{:?}", scenario.spec);
            assert_eq!(found.digest().hex(), expected.digest().hex(), "{:?}", scenario.spec);
        }
    }

    #[test]
    fn it_ends_at_the_limit_of_its_work() {
        let scenario = made(Generator::Rooms, 50, 3, Movement::default());
        let whole = run(&scenario, InSight::new(&scenario, MOST_LOOKED_AT));
        let stopped = run(&scenario, InSight::new(&scenario, 20_000));
        assert_eq!((whole.status(), stopped.status()), (Status::Optimal, Status::BudgetSpent));
        assert!(stopped.effort().cell_expansions < whole.effort().cell_expansions);
        assert!(stopped.best().is_none_or(|best| best.length >= whole.best().expect("a path").length));
    }
}
