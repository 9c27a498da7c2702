//! What ants leave behind: formulas of Δτ, shared by all variants.

use super::ant::Ant;
use super::trails::Trails;
use crate::map::Cell;
use crate::scenario::Scenario;

/// Adds the same amount on every step of a walk that began at the scenario's start.
pub fn along(trails: &mut Trails, scenario: &Scenario, ant: &Ant, amount: f64) {
    trails.deposit_along(&scenario.moves, scenario.start, ant.steps(), amount);
}

/// Adds the same amount on every step of a path of neighbouring cells.
pub fn along_path(trails: &mut Trails, scenario: &Scenario, path: &[Cell], amount: f64) {
    for step in path.windows(2) {
        trails.deposit(step[0], scenario.moves.direction(step[0], step[1]), amount);
    }
}

/// Ant-cycle deposit (Ant System): every arrived ant leaves Q/L on each of its steps.
pub fn ant_cycle(trails: &mut Trails, scenario: &Scenario, ants: &[Ant], q: f64) {
    for ant in ants {
        if let Some(length) = ant.length() {
            along(trails, scenario, ant, q / length);
        }
    }
}
