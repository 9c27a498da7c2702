//! Nash, Daniel, Koenig, Felner, "Theta*: Any-angle path planning on grids", AAAI 2007, 1177–1183; Daniel, Nash, Koenig, Felner, Journal
//! of Artificial Intelligence Research 39 (2010) 533–579.
//!
//! A* by steps whose parents need not be neighbours: a cell that the parent of its neighbour sees hangs on that parent (path 2), else on
//! the neighbour (path 1). Sight is [`line_of_sight`], under the scenario's corner rule. Short polylines, but no proof: a parent is only
//! sought where the search by steps comes by.
//!
//! Unlike the print we open a cell again when a shorter way to it turns up, so the result is never longer than the path of A*.

use std::sync::Arc;

use super::SEARCH;
use super::best_first::{BestFirst, Rules, State, Tree};
use super::euclidean;
use crate::error::ParamError;
use crate::map::Cell;
use crate::params::{Values, check_keys};
use crate::path::line_of_sight;
use crate::planner::{Family, Ground, Objective, Planner, PlannerEntry, Status};
use crate::scenario::Scenario;

/// The rules of Theta*.
#[derive(Clone)]
struct ThetaStar;

impl Rules for ThetaStar {
    const OBJECTIVE: Objective = Objective::PolylineLength;
    const FOUND: Status = Status::Complete;

    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64 {
        euclidean(scenario, cell, scenario.goal)
    }

    fn expand(&mut self, scenario: &Scenario, cell: State, tree: &mut Tree) {
        let parent = tree.parent(cell);
        let at = |c: Cell| scenario.grid.point(c);
        for d in scenario.moves.directions(cell) {
            let next = scenario.moves.step(cell, d);
            let to_goal = self.to_goal(scenario, next);
            // By the triangle inequality the way from the parent is the shorter one: where that improves nothing, sight is no matter.
            let straight = tree.g(parent) + euclidean(scenario, parent, next);
            if !tree.improves(next, straight, to_goal) {
                continue;
            }
            let (g, via) = if line_of_sight(scenario, at(parent), at(next)) {
                (straight, parent)
            } else {
                (tree.g(cell) + euclidean(scenario, cell, next), cell)
            };
            tree.relax(next, g, to_goal, via, next == scenario.goal);
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    check_keys(ENTRY.id, &[], values)?;
    Ok(Box::new(BestFirst::new(Arc::clone(scenario), ThetaStar)))
}

/// Theta* in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "theta-star",
    name: "Theta*",
    family: Family::Search,
    summary: "A* whose segments may have any angle: a cell hangs on its grandparent where that one sees it. Short polylines, without a proof.",
    source: "Nash, Daniel, Koenig, Felner 2007, AAAI-07, 1177–1183; Daniel, Nash, Koenig, Felner 2010, JAIR 39, 533–579, doi:10.1613/jair.2994",
    grounds: Ground::PLANE,
    build,
    ..SEARCH
};
