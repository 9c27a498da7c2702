//! Nash, Daniel, Koenig, Felner, "Theta*: Any-angle path planning on grids", AAAI 2007, 1177–1183; Daniel, Nash, Koenig, Felner, Journal
//! of Artificial Intelligence Research 39 (2010) 533–579.
//!
//! A* by steps whose parents need not be neighbours: a cell that the parent of its neighbour sees hangs on that parent (path 2), else on
//! the neighbour (path 1). Sight is [`line_of_sight`], under the scenario's corner rule. Short polylines, but no proof: a parent is only
//! sought where the search by steps comes by.
//!
//! Each step of the search may look as far as the map is wide: in corridors of a map of 4096 × 4096 cells it would look at 10¹¹ of them. So it
//! ends when it has looked along [`MOST_LOOKED_AT`] cells, as a run whose budget is spent, with the best way to the goal that it then knows, if any.
//!
//! On weighted ground a segment costs the integral of the factors along it, and the straight way may be the dearer one: then path 1 stays.
//!
//! Unlike the print we open a cell again when a shorter way to it turns up, so the result is never longer than the path of A*.

use std::sync::Arc;

use super::SEARCH;
use super::best_first::{BestFirst, Known, Rules, State, Tree};
use super::euclidean;
use crate::error::ParamError;
use crate::map::{Cell, Weights};
use crate::params::{Values, check_keys};
use crate::path::line_of_sight;
use crate::planner::{Family, Ground, Objective, Planner, PlannerEntry, Status};
use crate::scenario::Scenario;

/// Cells along which a search looks at most, counted by the longer side of every segment whose sight is tried: a quarter of a minute.
const MOST_LOOKED_AT: u64 = 1 << 33;

/// The rules of Theta*.
#[derive(Clone)]
struct ThetaStar {
    /// Cells that it may still look along.
    left: u64,
    /// A lower bound of what is left to go from each cell, where there is a better one than the straight line.
    rest: Option<Arc<[f64]>>,
}

impl Rules for ThetaStar {
    const OBJECTIVE: Objective = Objective::PolylineLength;
    const FOUND: Status = Status::Complete;

    fn is_spent(&self) -> bool {
        self.left == 0
    }

    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64 {
        if let Some(rest) = &self.rest {
            return rest[cell as usize];
        }
        euclidean(scenario, cell, scenario.goal) * scenario.moves.weights().map_or(1.0, Weights::least)
    }

    fn expand(&mut self, scenario: &Scenario, cell: State, tree: &mut Tree) {
        let parent = tree.parent(cell);
        let at = |c: Cell| scenario.grid.point(c);
        for d in scenario.moves.directions(cell) {
            let next = scenario.moves.step(cell, d);
            let to_goal = self.to_goal(scenario, next);
            if let Some(weights) = scenario.moves.weights() {
                tree.relax(next, tree.g(cell) + scenario.moves.length(cell, d), to_goal, cell, next == scenario.goal);
                self.hang_on_parent(scenario, weights, (parent, next), to_goal, tree);
                continue;
            }
            // By the triangle inequality the way from the parent is the shorter one: where that improves nothing, sight is no matter.
            let straight = tree.g(parent) + euclidean(scenario, parent, next);
            if !tree.improves(next, straight, to_goal) {
                continue;
            }
            let (from, to) = (at(parent), at(next));
            self.left = self.left.saturating_sub(from.x.abs_diff(to.x).max(from.y.abs_diff(to.y)).into());
            let (g, via) = if line_of_sight(scenario, from, to) {
                (straight, parent)
            } else {
                (tree.g(cell) + euclidean(scenario, cell, next), cell)
            };
            tree.relax(next, g, to_goal, via, next == scenario.goal);
        }
    }
}

impl ThetaStar {
    /// Path 2 on weighted ground, where the straight way from the parent may be the dearer one: only where it is not, and is in sight.
    fn hang_on_parent(
        &mut self,
        scenario: &Scenario,
        weights: &Weights,
        (parent, next): (Cell, Cell),
        to_goal: f64,
        tree: &mut Tree,
    ) {
        let (from, to) = (scenario.grid.point(parent), scenario.grid.point(next));
        let cells = u64::from(from.x.abs_diff(to.x).max(from.y.abs_diff(to.y)));
        self.left = self.left.saturating_sub(cells);
        let straight = tree.g(parent) + weights.segment(parent, next);
        if tree.improves(next, straight, to_goal) && line_of_sight(scenario, from, to) {
            tree.relax(next, straight, to_goal, parent, next == scenario.goal);
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    check_keys(ENTRY.id, &[], values)?;
    Ok(Box::new(BestFirst::new(Arc::clone(scenario), ThetaStar { left: MOST_LOOKED_AT, rest: None })))
}

/// The way that it finds on a plane when it is led by a lower bound of what is left to go from each cell, none where there is none within
/// about so many cells along which it may look; and along how many it has.
pub(super) fn led(scenario: &Arc<Scenario>, rest: Arc<[f64]>, most: u64) -> (Option<Known>, u64) {
    let mut search = BestFirst::new(Arc::clone(scenario), ThetaStar { left: most.min(MOST_LOOKED_AT), rest: Some(rest) });
    search.run();
    let expansions = search.effort().cell_expansions;
    let known = search.best().map(|best| Known { path: best.path.clone(), length: best.length, expansions });
    (known, most.saturating_sub(search.rules().left))
}

/// Theta* in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "theta-star",
    name: "Theta*",
    family: Family::Search,
    summary: "A* whose segments may have any angle: a cell hangs on its grandparent where that one sees it. Short polylines, without a proof.",
    source: "Nash, Daniel, Koenig, Felner 2007, AAAI-07, 1177–1183; Daniel, Nash, Koenig, Felner 2010, JAIR 39, 533–579, doi:10.1613/jair.2994",
    grounds: Ground::WEIGHTED_PLANE,
    build,
    ..SEARCH
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{Grid, Movement, Point};
    use crate::planner::Snapshot;

    /// Walls in every other row, open at one end and the other in turn.
    fn serpentine(side: u32) -> Arc<Scenario> {
        let gap = |y: u32| if y % 4 == 1 { side - 1 } else { 0 };
        let cell = |i: u32| u8::from((i / side) % 2 == 1 && i % side != gap(i / side));
        let grid = Grid::from_bytes(side, side, &(0..side * side).map(cell).collect::<Vec<u8>>()).unwrap();
        Arc::new(Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(0, side - 1)).unwrap())
    }

    #[test]
    fn it_ends_at_the_limit_of_its_work() {
        let scenario = serpentine(41);
        let run = |left| {
            let mut search = BestFirst::new(Arc::clone(&scenario), ThetaStar { left, rest: None });
            (search.run(), search)
        };
        let (status, whole) = run(MOST_LOOKED_AT);
        assert_eq!((status, whole.best().is_some()), (Status::Complete, true));
        let (status, stopped) = run(500);
        assert_eq!((status, stopped.best().is_some()), (Status::BudgetSpent, false));
        assert!(stopped.effort().cell_expansions < whole.effort().cell_expansions);
        // What is spent stays spent, and the record says that there is no path yet.
        let mut again = stopped.snapshot();
        assert_eq!(again.run(), Status::BudgetSpent);
        assert_eq!(again.history().last().unwrap().best_so_far, None);
    }
}
