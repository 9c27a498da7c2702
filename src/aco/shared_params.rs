//! Parameter rows that many colonies share, written once: a planner's `params!` takes them in with `..field: Type;`.

use crate::exact::{Distance, Estimate};
use crate::map::Moves;
use crate::params;
use crate::scenario::Scenario;

use super::dead_end::DeadEnd;
use super::heuristic::Heuristic;
use super::variant::Settings;

params! {
    /// The budget, and the weights of trail and heuristic.
    pub struct SelectionParams {
        /// iterations after which the colony stops
        iterations: u32 = 100, "K", [1..=100_000], "iterations", "papers' common value";
        /// weight of the trail τ in the choice of a step
        alpha: f64 = 1.0, "α", [0.0..=10.0], "", "Dorigo and Stützle 2004, box 3.1";
        /// weight of the heuristic η in the choice of a step
        beta: f64 = 5.0, "β", [0.0..=50.0], "", "Dorigo and Stützle 2004, box 3.1: 2 to 5";
    }
}

params! {
    /// What an ant sees: the publications for tours are silent on it.
    pub struct SightParams {
        /// what an ant sees of a step
        heuristic: Heuristic = Heuristic::Detour, "η", [], "", "our choice; papers: goal or step";
    }
}

params! {
    /// When an ant or the colony gives up: most publications are silent on it.
    pub struct WalkParams {
        /// what an ant does where no neighbour is left
        dead_end: DeadEnd = DeadEnd::Backtrack, "", [], "", "our choice; papers differ or are silent";
        /// an ant gives up after this many times width + height moves; 0 = never
        move_limit: f64 = 4.0, "", [0.0..=1000.0], "× (width + height)", "measured: 0.8 % of ants lost on large maps, same best";
        /// stops after this many iterations without a shorter path; 0 = never
        stagnation: u32 = 0, "", [0..=100_000], "iterations", "our addition";
    }
}

/// The numbers that every colony has, from shared and own rows.
pub fn settings(ants: u32, rho: f64, deposit: f64, selection: &SelectionParams, walk: &WalkParams) -> Settings {
    Settings {
        ants,
        iterations: selection.iterations,
        stagnation: walk.stagnation,
        alpha: selection.alpha,
        beta: selection.beta,
        rho,
        deposit,
        dead_end: walk.dead_end,
        move_limit: walk.move_limit,
    }
}

/// Length in cells of the shortest path from start to goal if nothing were blocked: where publications take the nearest-neighbour
/// tour for a first estimate, which a map does not have.
pub fn open_map_length(scenario: &Scenario) -> f64 {
    let start = scenario.grid.point(scenario.start);
    Distance::of(scenario).to_goal(start.x, start.y)
}

/// Steps of that path.
pub fn open_map_steps(scenario: &Scenario) -> u32 {
    let (start, goal) = (scenario.grid.point(scenario.start), scenario.grid.point(scenario.goal));
    let (dx, dy) = (start.x.abs_diff(goal.x), start.y.abs_diff(goal.y));
    match scenario.spec.movement.moves {
        Moves::Four => dx + dy,
        Moves::Eight => dx.max(dy),
        // A step takes two cells along one axis, or three along both.
        Moves::Sixteen => dx.max(dy).div_ceil(2).max((dx + dy).div_ceil(3)),
    }
}
