//! Hart, Nilsson, Raphael, "A formal basis for the heuristic determination of minimum cost paths", IEEE Transactions on Systems Science
//! and Cybernetics 4 (1968) 100–107.
//!
//! Estimate: Manhattan distance with 4 moves, octile distance with 8, its like with 16. Each is consistent under every corner rule, because a
//! stricter rule only removes steps; so the length is exact. On a terrain √(d² + z²), z being the difference in height: a step is at least
//! as long as the straight line between its ends, and √(d² + z²) is a norm because d is one. On weighted ground the distance times the
//! smallest factor of a free cell.

use std::f64::consts::SQRT_2;
use std::sync::Arc;

use super::SEARCH;
use super::search::{Estimate, Search};
use crate::error::ParamError;
#[cfg(feature = "whole")]
use crate::map::Relief;
use crate::map::{Cell, DIRECTIONS, Moves, Point, step_length};
use crate::params::{Values, check_keys};
use crate::planner::{Planner, PlannerEntry};
use crate::scenario::Scenario;

/// What a lower bound must know of ground that is not plain; the opening build knows no other.
#[cfg(feature = "whole")]
#[derive(Debug, Clone)]
enum Uneven {
    /// A terrain: its ground, the map's width, and the height of the goal; all lengths in cells.
    Relief(Relief, u32, f64),
    /// Weighted ground: the smallest factor of the map.
    Least(f64),
}

#[cfg(feature = "whole")]
impl Uneven {
    /// Of a scenario's ground; none where it is plain.
    fn of(scenario: &Scenario, goal: Cell) -> Option<Self> {
        let relief = scenario.moves.relief().map(|r| Self::Relief(r.clone(), scenario.grid.width(), r.height(goal)));
        relief.or_else(|| scenario.moves.weights().map(|weights| Self::Least(weights.least())))
    }
}

/// Length of the shortest path on an open map: Σ of both axes, less what each diagonal step saves, and each step of two cells by one. On a
/// terrain it is a lower bound; on weighted ground it counts the smallest factor of the map, so that it is one.
#[derive(Debug, Clone)]
pub struct Distance {
    /// Whether nothing is known of the goal: 0 everywhere. A search by it is the same code as by the others.
    unknown: bool,
    goal: Point,
    saved_by_diagonal: f64,
    saved_by_far: f64,
    /// What the ground adds; none on plain ground.
    #[cfg(feature = "whole")]
    uneven: Option<Uneven>,
}

impl Distance {
    /// To the scenario's goal, with its number of moves.
    pub fn of(scenario: &Scenario) -> Self {
        Self::to(scenario, scenario.goal)
    }

    /// Dijkstra's: it knows nothing of the goal.
    pub fn unknown(scenario: &Scenario) -> Self {
        Self { unknown: true, ..Self::of(scenario) }
    }

    /// To any cell of the scenario's map.
    pub fn to(scenario: &Scenario, goal: Cell) -> Self {
        // Between a row and a diagonal, 16 moves replace a straight and a diagonal step by one of √5.
        let (saved_by_diagonal, saved_by_far) = match scenario.spec.movement.moves {
            Moves::Four => (0.0, 0.0),
            Moves::Eight => (2.0 - SQRT_2, 0.0),
            Moves::Sixteen => (2.0 - SQRT_2, 1.0 + SQRT_2 - step_length(DIRECTIONS as u8)),
        };
        Self {
            unknown: false,
            goal: scenario.grid.point(goal),
            saved_by_diagonal,
            saved_by_far,
            #[cfg(feature = "whole")]
            uneven: Uneven::of(scenario, goal),
        }
    }

    /// Length in cells of the shortest path between any two cells of an open plane that are so many columns and rows apart.
    #[inline(always)]
    pub fn on_open_map(&self, dx: u32, dy: u32) -> f64 {
        let mut plane = f64::from(dx + dy) - self.saved_by_diagonal * f64::from(dx.min(dy));
        if self.saved_by_far > 0.0 {
            plane -= self.saved_by_far * f64::from(dx.min(dy).min(dx.abs_diff(dy)));
        }
        plane
    }
}

impl Estimate for Distance {
    #[inline(always)]
    fn to_goal(&self, x: u32, y: u32) -> f64 {
        if self.unknown {
            return 0.0;
        }
        let (dx, dy) = (x.abs_diff(self.goal.x), y.abs_diff(self.goal.y));
        let plane = self.on_open_map(dx, dy);
        #[cfg(feature = "whole")]
        match &self.uneven {
            None => {}
            Some(Uneven::Least(factor)) => return plane * factor,
            Some(Uneven::Relief(relief, width, height)) => {
                let z = relief.height(y * width + x) - height;
                return libm::sqrt(plane * plane + z * z);
            }
        }
        plane
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    check_keys(ENTRY.id, &[], values)?;
    Ok(Box::new(Search::new(Arc::clone(scenario), Distance::of(scenario))))
}

/// A* in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "astar",
    name: "A*",
    summary: "Explores by cost so far plus a lower bound of what remains; always the shortest path, usually with fewer cells.",
    source: "Hart, Nilsson, Raphael 1968, IEEE Trans. Systems Science and Cybernetics 4, 100–107, doi:10.1109/TSSC.1968.300136",
    build,
    ..SEARCH
};
