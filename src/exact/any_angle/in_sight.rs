//! The rules of the search on a plane: all cells in sight behind which there can be a better way.
//!
//! From a cell at the end of a way of length g, f(p) = g + |cp| + h(p) never falls along a ray, because h is consistent. Where a ray to a cell of
//! use crosses another cell, a point could go aside to that cell's centre and back within it, √2 at most. So a cell whose f exceeds the best
//! known length by more than that is on the way to no cell of use, and blocks the view as an obstacle does.

use std::sync::Arc;

use crate::exact::best_first::{Known, Rules, State, Tree};
use crate::exact::euclidean;
use crate::exact::geodesic::ASIDE;
use crate::exact::sight::Sight;
use crate::map::Cell;
use crate::planner::{Objective, Status, held};
use crate::scenario::Scenario;

use super::lead::Lead;

/// Largest map in cells that the straight line leads through: 64 × 64. There it takes no longer than to find out what is left to go.
pub(super) const MOST_CELLS_UNLED: usize = 64 * 64;

/// What the search keeps.
#[derive(Clone)]
pub(super) struct InSight {
    sight: Sight,
    /// Cells to which a way is found to be shorter; empty between two expansions.
    shorter: Vec<Cell>,
    /// Cells that it may still look at.
    left: u64,
    /// Whether what is left to go for a point is still to be found out; what leads it is that, else the straight line.
    is_led: bool,
    /// That, once it is known.
    lead: Option<Lead>,
}

impl InSight {
    /// A search that looks at no more than `left` cells.
    pub(super) fn new(scenario: &Scenario, left: u64) -> Self {
        let sight = Sight::new(&scenario.grid, scenario.spec.movement);
        Self { sight, shorter: Vec::new(), left, is_led: scenario.grid.len() > MOST_CELLS_UNLED, lead: None }
    }

    /// The same, led on a map of any size, without a way to begin with.
    pub(super) fn led_alone(scenario: &Arc<Scenario>, left: u64) -> Self {
        let lead = Lead::alone(scenario);
        let left = left.saturating_sub(lead.looked);
        Self { is_led: false, lead: Some(lead), ..Self::new(scenario, left) }
    }

    /// The same, led on any map or on none.
    #[cfg(test)]
    pub(super) fn led(mut self, is_led: bool) -> Self {
        self.is_led = is_led;
        self
    }
}

impl Rules for InSight {
    const OBJECTIVE: Objective = Objective::PolylineLength;
    const FOUND: Status = Status::Optimal;

    fn prepare(&mut self, scenario: &Scenario) {
        if !self.is_led {
            return;
        }
        let lead = Lead::of(scenario, self.left);
        self.left = self.left.saturating_sub(lead.looked);
        self.lead = Some(lead);
    }

    fn known(&self) -> Option<&Known> {
        self.lead.as_ref().and_then(|lead| lead.known.as_ref())
    }

    fn bytes(&self) -> usize {
        self.sight.bytes() + held(&self.shorter)
    }

    fn is_spent(&self) -> bool {
        self.left == 0
    }

    fn to_goal(&self, scenario: &Scenario, cell: Cell) -> f64 {
        self.lead.as_ref().map_or_else(|| euclidean(scenario, cell, scenario.goal), |lead| lead.rest[cell as usize])
    }

    fn expand(&mut self, scenario: &Scenario, cell: State, tree: &mut Tree) {
        let g = tree.g(cell);
        let mut shorter = std::mem::take(&mut self.shorter);
        let rest = self.lead.as_ref().map(|lead| &*lead.rest);
        let looked = self.sight.around(scenario.grid.point(cell), |next, away, is_seen| {
            let f = rest.map_or(0.0, |rest| g + away + rest[next as usize]);
            if is_seen && tree.is_cheaper(next, g + away) && tree.is_below_bound(f) {
                shorter.push(next);
            }
            tree.is_below_bound(f - ASIDE)
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
