//! Between ants, which walk by steps, and polylines: an ant's way pulled straight, and the steps along a polyline.

use crate::aco::criterion::way;
use crate::aco::variant::Iteration;
use crate::path::{Path, Refinement, crossed, refine};
use crate::scenario::Scenario;

/// What line of sight makes of the shortest way of an iteration's ants, with its length in cells; none where no ant has arrived.
pub(super) fn straightened(iteration: &Iteration) -> Option<(Path, f64)> {
    let (ant, _) = iteration.iteration_best()?;
    let path = refine(iteration.scenario, &way(iteration.scenario, ant), Refinement::Next);
    let length = iteration.scenario.path_length(&path);
    Some((path, length))
}

/// The cells that a polyline crosses as a path of steps; two of them around a corner are one diagonal step where that is allowed.
pub(super) fn by_steps(scenario: &Scenario, polyline: &[u32]) -> Path {
    let moves = &scenario.moves;
    let mut path = Path::new();
    for cell in crossed(scenario.grid.width(), polyline) {
        if let [.., before, _] = path[..]
            && moves.directions(before).any(|d| moves.step(before, d) == cell)
        {
            path.pop();
        }
        path.push(cell);
    }
    path
}
