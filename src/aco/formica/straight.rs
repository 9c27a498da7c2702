//! Between ants, which walk by steps, and polylines: an ant's way pulled straight, and the steps along a polyline.

use crate::aco::criterion::way;
use crate::aco::variant::Iteration;
use crate::map::Cell;
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
pub(super) fn by_steps(scenario: &Scenario, polyline: &[Cell]) -> Path {
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::catalog;
    use crate::map::{CornerRule, Generator, Grid, Movement, Moves, Point, generate};
    use crate::params::Values;
    use crate::path::{PathKind, audit, points};

    #[test]
    fn the_steps_along_a_segment_by_hand() {
        let steps = |width: u32, rows: &[u8]| {
            let grid = Grid::from_bytes(width, 2, rows).expect("a map");
            let goal = Point::new(width - 1, 1);
            let s = Scenario::on(grid, Movement::default(), Point::new(0, 0), goal).expect("usable");
            by_steps(&s, &[s.start, s.goal])
        };
        // It crosses (1, 0) and (2, 1), from the one to the other through their common corner.
        assert_eq!(steps(4, &[0; 8]), [0, 1, 6, 7]);
        // It crosses (1, 0) and (1, 1): from (0, 0) a diagonal step leads to (1, 1), unless a corner would be cut.
        assert_eq!(steps(3, &[0, 0, 1, 0, 0, 0]), [0, 4, 5]);
        assert_eq!(steps(3, &[0, 0, 1, 1, 0, 0]), [0, 1, 4, 5]);
    }

    #[test]
    fn the_steps_along_polylines_are_allowed_and_lead_to_their_ends() {
        let mut bent = 0;
        for (seed, corner_rule) in (0..90).zip(CornerRule::ALL.into_iter().cycle()) {
            let made = generate(Generator::Random, 24, 17, seed, 0.3).expect("a map");
            let moves = if seed % 5 == 4 { Moves::Four } else { Moves::Eight };
            let scenario =
                Arc::new(Scenario::on(made.grid, Movement { moves, corner_rule }, made.start, made.goal).expect("usable"));
            let mut search = catalog::build(&scenario, "any-angle", None, &Values::new(), 1).expect("a plane");
            search.run();
            let Some(best) = search.best() else { continue };
            let steps = by_steps(&scenario, &best.path);
            assert_eq!(audit(&scenario, &points(&scenario, &steps), PathKind::Steps), Ok(()), "{:?}", scenario.spec);
            bent += u32::from(best.path.len() > 2);
        }
        assert!(bent > 50, "{bent} with bends");
    }
}
