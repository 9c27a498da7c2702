//! Properties of paths on arbitrary maps: what planners answer, and what the audit lets through.
#![cfg(not(target_arch = "wasm32"))]

use std::sync::Arc;

use formicarium::catalog::{self, CATALOG};
use formicarium::exact;
use formicarium::map::{CornerRule, Grid, Movement, Moves, Point};
use formicarium::metrics::Metrics;
use formicarium::params::{Value, Values};
use formicarium::path::{PathKind, audit, points};
use formicarium::planner::{Family, Planner, Status};
use formicarium::scenario::Scenario;
use proptest::prelude::*;

fn euclidean(a: Point, b: Point) -> f64 {
    f64::from(a.x.abs_diff(b.x)).hypot(f64::from(a.y.abs_diff(b.y)))
}

fn movement() -> impl Strategy<Value = Movement> {
    prop_oneof![
        Just(Movement { moves: Moves::Four, corner_rule: CornerRule::BothFree }),
        proptest::sample::select(&CornerRule::ALL[..]).prop_map(|corner_rule| Movement { moves: Moves::Eight, corner_rule }),
    ]
}

/// Any map up to 14 × 14, any density, any two cells (freed) as start and goal.
fn scenario() -> impl Strategy<Value = Arc<Scenario>> {
    (1u32..15, 1u32..15, 0u32..60, movement()).prop_flat_map(|(width, height, density, movement)| {
        let cells = width * height;
        let walls = proptest::collection::vec(0u32..100, cells as usize);
        (walls, 0..cells, 0..cells).prop_map(move |(dice, start, goal)| {
            let mut bytes: Vec<u8> = dice.iter().map(|&v| u8::from(v < density)).collect();
            bytes[start as usize] = 0;
            bytes[goal as usize] = 0;
            let grid = Grid::from_bytes(width, height, &bytes).expect("a valid size");
            let (start, goal) = (grid.point(start), grid.point(goal));
            Arc::new(Scenario::on(grid, movement, start, goal).expect("usable"))
        })
    })
}

fn solve(scenario: &Arc<Scenario>, id: &str, family: Family, seed: u32) -> Box<dyn Planner> {
    let few = [("ants".to_string(), Value::Number(6.0)), ("iterations".to_string(), Value::Number(5.0))];
    let values: Values = if family == Family::AntColony { few.into() } else { Values::new() };
    let mut planner = catalog::build(scenario, id, None, &values, seed).expect("valid parameters");
    planner.run();
    planner
}

proptest! {
    #[test]
    fn every_planner_answers_a_valid_path_or_none(scenario in scenario(), seed: u32) {
        let reachable = scenario.moves.connected(scenario.start, scenario.goal);
        let optimum = exact::optimum(&scenario);
        prop_assert_eq!(optimum.is_some(), reachable);
        for entry in CATALOG {
            let planner = solve(&scenario, entry.id, entry.family, seed);
            prop_assert_eq!(planner.status() == Status::NoPath, !reachable, "{}", entry.id);
            let Some(best) = planner.best() else { continue };
            let (path, length) = best.result();
            let metrics = Metrics::of(&scenario, path);
            let (path, kind) = (points(&scenario, path), planner.objective().path_kind());
            prop_assert_eq!(audit(&scenario, &path, kind), Ok(()), "{}", entry.id);
            let least = match kind {
                PathKind::Steps => optimum.unwrap_or(f64::INFINITY),
                PathKind::Polyline => euclidean(path[0], path[path.len() - 1]),
            };
            prop_assert!(length >= least - 1e-9, "{}", entry.id);
            prop_assert_eq!(metrics.length, length);
            prop_assert!(metrics.turn_index >= metrics.length && metrics.turn_index <= 1.2 * metrics.length + 1e-9);
            prop_assert!(metrics.min_clearance >= 1.0 && metrics.min_clearance <= metrics.mean_clearance);
            prop_assert!(metrics.turns < metrics.steps.max(1));
        }
    }

    #[test]
    fn exact_planners_agree_and_a_looser_rule_is_never_longer(scenario in scenario()) {
        let lengths: Vec<Option<f64>> = ["astar", "dijkstra"]
            .map(|id| solve(&scenario, id, Family::Exact, 0).best().map(|b| b.length))
            .into();
        match (lengths[0], lengths[1]) {
            (Some(a), Some(b)) => prop_assert!((a - b).abs() < 1e-9),
            (a, b) => prop_assert_eq!(a, b),
        }
        let under = |corner_rule| {
            let mut spec = scenario.spec.clone();
            spec.movement = Movement { moves: Moves::Eight, corner_rule };
            let scenario = Arc::new(Scenario::new(scenario.grid.clone(), spec).expect("usable"));
            exact::optimum(&scenario).unwrap_or(f64::INFINITY)
        };
        let [always, one, both] = CornerRule::ALL.map(under);
        prop_assert!(always <= one + 1e-9 && one <= both + 1e-9, "{always} {one} {both}");
    }

    #[test]
    fn the_audit_refuses_a_path_with_one_cell_moved_away(scenario in scenario(), which: prop::sample::Index) {
        let planner = solve(&scenario, "astar", Family::Exact, 0);
        if let Some(best) = planner.best() {
            let mut path = points(&scenario, &best.path);
            let i = which.index(path.len());
            path[i] = Point::new(path[i].x + 2, path[i].y);
            prop_assert!(audit(&scenario, &path, PathKind::Steps).is_err());
        }
    }
}
