//! Properties of paths on arbitrary maps: what planners answer, and what the audit lets through.
#![cfg(not(target_arch = "wasm32"))]

use std::sync::Arc;

use formicarium::catalog::{self, CATALOG};
use formicarium::exact;
use formicarium::map::{Cell, CornerRule, Grid, Movement, Moves, Point};
use formicarium::metrics::Metrics;
use formicarium::params::{Value, Values};
use formicarium::path::{PathKind, Refinement, audit, crossed, line_of_sight, points, refine};
use formicarium::planner::{Family, Ground, Planner, Status};
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
        for entry in CATALOG.iter().filter(|e| e.grounds.contains(&Ground::Plane)) {
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
    fn any_angle_paths_keep_their_order(scenario in scenario()) {
        let by = |id| solve(&scenario, id, Family::Exact, 0);
        let lengths = ["any-angle", "theta-star", "astar"].map(|id| by(id).best().map_or(f64::INFINITY, |b| b.length));
        let point = exact::point_robot(&scenario).expect("a small map").unwrap_or(f64::INFINITY);
        let steps = by("astar").best().map(|b| b.path.clone());
        let refined = steps.as_ref().map_or(f64::INFINITY, |path| Metrics::of(&scenario, &refine(&scenario, path, Refinement::Farthest)).length);
        let [any, theta, shortest] = lengths;
        let order = [euclidean(scenario.spec.start, scenario.spec.goals[0].at), point, any, refined, shortest];
        prop_assert!(order.windows(2).all(|pair| pair[0] <= pair[1] + 1e-9), "{:?}", order);
        prop_assert!(any <= theta + 1e-9 && theta <= shortest + 1e-9, "{} {} {}", any, theta, shortest);
    }

    #[test]
    fn the_turn_index_is_least_and_its_path_no_shorter_than_the_shortest(scenario in scenario()) {
        let [least, shortest] = ["turn-aware", "astar"].map(|id| {
            solve(&scenario, id, Family::Exact, 0).best().map(|b| Metrics::of(&scenario, &b.path))
        });
        prop_assert_eq!(least.is_some(), shortest.is_some());
        if let Some((least, shortest)) = least.zip(shortest) {
            prop_assert!(least.turn_index <= shortest.turn_index + 1e-9 && least.length >= shortest.length - 1e-9);
        }
    }

    #[test]
    fn clearance_looks_at_every_crossed_cell(scenario in scenario(), ends in any::<(prop::sample::Index, prop::sample::Index)>()) {
        let free: Vec<Cell> = (0..scenario.grid.len() as Cell).filter(|&c| !scenario.grid.is_blocked(c)).collect();
        let (from, to) = (*ends.0.get(&free), *ends.1.get(&free));
        let (a, b) = (scenario.grid.point(from), scenario.grid.point(to));
        let path = [from, to];
        let cells: Vec<Cell> = crossed(scenario.grid.width(), &path).collect();
        prop_assert_eq!((cells[0], cells[cells.len() - 1]), (from, to));
        // Sampled densely; cells that are touched for less than a sample, or at a corner only, may be missing there.
        for k in 0..=400 {
            let t = f64::from(k) / 400.0;
            let place = |a: u32, b: u32| f64::from(a) + t * (f64::from(b) - f64::from(a)) + 0.5;
            let (x, y) = (place(a.x, b.x), place(a.y, b.y));
            if [x, y].iter().all(|v| (v - v.round()).abs() > 1e-6) {
                prop_assert!(cells.contains(&scenario.grid.cell(Point::new(x as u32, y as u32))));
            }
        }
        prop_assert!(cells.len() as u32 <= a.x.abs_diff(b.x) + a.y.abs_diff(b.y) + 1);
        let back: Vec<Cell> = crossed(scenario.grid.width(), &[to, from]).collect();
        prop_assert!(cells.iter().rev().eq(&back), "there and back");
        prop_assert_eq!(line_of_sight(&scenario, a, b), line_of_sight(&scenario, b, a));
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
