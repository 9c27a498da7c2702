//! What the classics take from a tour's distances, by slices: the cost of a step for d_ij, the cost of the straight way for the
//! nearest-neighbour tour, and how many steps there are to choose from.

use crate::map::{Cell, Measure, Slices, Way};
use crate::param_choice;

param_choice! {
    /// What an ant sees of a step.
    pub enum SliceHeuristic {
        /// η = 1 / c_ij: what the step costs, its level included, as 1/d_ij of a tour
        Cost = "cost",
        /// η = 1 / (c_ij + d(j, goal)): the cost of the step and the straight distance that is left
        CostAndDistance = "cost-and-distance",
    }
}

impl SliceHeuristic {
    /// η of a feasible step, above 0.
    pub fn of(self, slices: &Slices, from: Cell, to: Cell) -> f64 {
        let cost = slices.cost(from, to);
        match self {
            Self::Cost => 1.0 / cost,
            Self::CostAndDistance => 1.0 / (cost + straight(slices, to, slices.goal())),
        }
    }
}

/// Straight distance between two places, cells and levels counting 1 each.
pub fn straight(slices: &Slices, a: Cell, b: Cell) -> f64 {
    let ((ax, ay, ah), (bx, by, bh)) = (slices.at(a), slices.at(b));
    let [x, y, h] = [ax.abs_diff(bx), ay.abs_diff(by), ah.abs_diff(bh)].map(f64::from);
    libm::sqrt(x * x + y * y + h * h)
}

/// What the straight way from start to goal would cost if nothing were in it: C for the nearest-neighbour tour. Its length; where levels are
/// charged, also the level at the end of each of its steps, h0 + (h1 − h0)·i/n, which add up to n·h0 + (h1 − h0)·(n + 1)/2.
pub fn straight_cost(slices: &Slices) -> f64 {
    let (start, goal) = (slices.start(), slices.goal());
    let (n, from, to) = (f64::from(slices.slices()), f64::from(slices.at(start).2), f64::from(slices.at(goal).2));
    let levels = if slices.rules().measure == Measure::Cost { n * from + (to - from) * (n + 1.0) / 2.0 } else { 0.0 };
    straight(slices, start, goal) + levels
}

/// Mean number of feasible steps of the places that have any.
pub fn mean_options(slices: &Slices) -> f64 {
    let (mut places, mut steps) = (0u64, 0u64);
    for place in (0..slices.places() as Cell).filter(|&p| slices.is_free(p)) {
        let options = (0..slices.directions()).filter(|&k| slices.step(place, k, Way::Forward).is_some()).count() as u64;
        places += u64::from(options > 0);
        steps += options;
    }
    steps as f64 / places.max(1) as f64
}
