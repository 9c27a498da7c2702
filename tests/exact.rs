//! The searches behind the yardsticks: any-angle, Theta*, turn-aware and the point robot, against brute force on small maps.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::sync::Arc;

use common::{drawn, length, movements, random, solve, swamp};
use formicarium::catalog;
use formicarium::error::ParamError;
use formicarium::exact::{self, Reference, point_robot, weighted_reference};
use formicarium::map::{Cell, CornerRule, Direction, Grid, Movement, Moves, Point, step_length};
use formicarium::metrics::{Metrics, TURN_WEIGHT, WeightedSum};
use formicarium::params::{Value, Values};
use formicarium::path::{PathKind, Refinement, audit, line_of_sight, points, refine};
use formicarium::planner::{Objective, Status};
use formicarium::scenario::Scenario;

const SQRT2: f64 = std::f64::consts::SQRT_2;

/// Small maps of several densities and shapes under every movement.
fn small(count: u32) -> impl Iterator<Item = Arc<Scenario>> {
    let densities = [0.1, 0.25, 0.4];
    (0..count).flat_map(move |seed| {
        let (side, density) = (5 + seed % 8, densities[seed as usize % 3]);
        movements().into_iter().map(move |movement| random(side, density, 100 + seed, movement))
    })
}

/// Least cost from state 0 to each state by relaxing every edge until nothing changes: no heap, no heuristic, no order.
fn relax_all(edges: &[(usize, usize, f64)], states: usize, from: &[usize]) -> Vec<f64> {
    let mut cost = vec![f64::INFINITY; states];
    from.iter().for_each(|&s| cost[s] = 0.0);
    loop {
        let mut changed = false;
        for &(a, b, d) in edges {
            if cost[a] + d < cost[b] - 1e-12 {
                (cost[b], changed) = (cost[a] + d, true);
            }
        }
        if !changed {
            return cost;
        }
    }
}

fn distance(a: Point, b: Point) -> f64 {
    (f64::from(a.x) - f64::from(b.x)).hypot(f64::from(a.y) - f64::from(b.y))
}

/// The shortest polyline over all pairs of free cells in sight.
fn shortest_polyline(s: &Scenario) -> f64 {
    let cells: Vec<Cell> = (0..s.grid.len() as Cell).filter(|&c| !s.grid.is_blocked(c)).collect();
    let pairs = cells.iter().flat_map(|&a| cells.iter().map(move |&b| (s.grid.point(a), s.grid.point(b))));
    let seen = pairs.filter(|&(a, b)| a != b && line_of_sight(s, a, b));
    let edges: Vec<_> = seen.map(|(a, b)| (s.grid.cell(a) as usize, s.grid.cell(b) as usize, distance(a, b))).collect();
    relax_all(&edges, s.grid.len(), &[s.start as usize])[s.goal as usize]
}

/// The least V(d, r): states are cell · 8 + direction of the step that led there; the first step costs its length.
fn least_turn_index(s: &Scenario) -> f64 {
    let cells = 0..s.grid.len() as Cell;
    let steps = cells.flat_map(|c| s.moves.directions(c).map(move |d| (c, d, s.moves.step(c, d))));
    let mut edges = Vec::new();
    for (c, d, next) in steps {
        let to = next as usize * 8 + usize::from(d);
        for came in 0..8 as Direction {
            let rate = if came == d { 1.0 } else { TURN_WEIGHT };
            edges.push((c as usize * 8 + usize::from(came), to, rate * step_length(d)));
        }
        if c == s.start {
            edges.push((s.grid.len() * 8, to, step_length(d)));
        }
    }
    let cost = relax_all(&edges, s.grid.len() * 8 + 1, &[s.grid.len() * 8]);
    let least = (0..8).map(|d| cost[s.goal as usize * 8 + d]).fold(f64::INFINITY, f64::min);
    if s.start == s.goal { 0.0 } else { least }
}

fn same(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() < 1e-9
}

#[test]
fn any_angle_is_the_shortest_polyline() {
    for s in small(60) {
        let planner = solve(&s, "any-angle");
        let found = planner.best().map_or(f64::INFINITY, |b| b.length);
        assert!(same(found, shortest_polyline(&s)), "{:?} {:?}: {found}, {}", s.spec, s.grid, shortest_polyline(&s));
        if let Some(best) = planner.best() {
            assert_eq!(audit(&s, &points(&s, &best.path), PathKind::Polyline), Ok(()));
            assert_eq!(planner.status(), Status::Optimal);
        }
    }
}

#[test]
fn the_best_bend_can_lie_far_from_every_obstacle() {
    // From (0,1) to (10,0) past the wall at (5,0): no cell near the wall's corners is the best place to bend.
    let s = drawn(&[".....#....G", "S..........", "..........."], Movement::default());
    let bends: Vec<f64> =
        (0..11).map(|x| distance(Point::new(0, 1), Point::new(x, 1)) + distance(Point::new(x, 1), Point::new(10, 0))).collect();
    let seen: Vec<usize> =
        (0..11).filter(|&x| line_of_sight(&s, Point::new(x, 1), Point::new(10, 0))).map(|x| x as usize).collect();
    assert_eq!(seen, [2, 3, 4, 5, 6, 7, 8, 9, 10]);
    assert!(same(length(&s, "any-angle"), bends[2]) && bends[2] < bends[4] - 0.01, "{bends:?}");
}

#[test]
fn turn_aware_has_the_least_turn_index() {
    for s in small(60) {
        let planner = solve(&s, "turn-aware");
        let found = planner.best().map_or(f64::INFINITY, |b| Metrics::of(&s, &b.path).turn_index);
        assert!(same(found, least_turn_index(&s)), "{:?}: {found}, {}", s.spec, least_turn_index(&s));
    }
}

#[test]
fn a_longer_path_with_fewer_turns_wins() {
    // By hand: straight along the bottom is 8 steps and 2 turns, V = 8 + 0.2·2; every shorter way by diagonals turns more often.
    let s = drawn(&["S.#.#.#.G", ".........", "........."], Movement { moves: Moves::Four, corner_rule: CornerRule::BothFree });
    let best = solve(&s, "turn-aware");
    let metrics = best.best().map(|b| Metrics::of(&s, &b.path)).expect("a path");
    assert_eq!((metrics.length, metrics.turns), (10.0, 2));
    assert!(same(metrics.turn_index, 10.4), "1 down, 8 along, 1 up, two of them turning");
}

#[test]
fn theta_star_lies_between_the_shortest_polyline_and_the_shortest_path() {
    let mut better = 0;
    for s in small(60) {
        let [any, theta, steps] = ["any-angle", "theta-star", "astar"].map(|id| length(&s, id));
        assert!(any <= theta + 1e-9 && theta <= steps + 1e-9, "{:?}: {any} {theta} {steps}", s.spec);
        better += u32::from(theta < steps - 1e-9);
    }
    assert!(better > 50, "its segments have any angle: {better}");
}

#[test]
fn theta_star_by_hand() {
    // By steps the way is (0,0), (1,1), (2,2), (3,2), …; the start sees (3,2), which hangs on it, but not (4,2) behind the wall's foot.
    let s = drawn(&["S..#...", "...#...", "......G"], Movement::default());
    let planner = solve(&s, "theta-star");
    assert_eq!(planner.status(), Status::Complete);
    let best = planner.best().expect("a path");
    assert!(same(best.length, 13f64.sqrt() + 3.0), "{:?}", points(&s, &best.path));
    assert_eq!(points(&s, &best.path), [(0, 0), (3, 2), (6, 2)].map(|(x, y)| Point::new(x, y)));
}

#[test]
fn the_point_robot_bounds_every_polyline() {
    let (mut below, mut all) = (0, 0);
    let sixteen = CornerRule::ALL.map(|corner_rule| Movement { moves: Moves::Sixteen, corner_rule });
    let far = (0..60).flat_map(|seed| sixteen.map(|movement| random(5 + seed % 8, 0.4, seed, movement)));
    for s in small(200).chain(far) {
        let point = point_robot(&s).expect("a small map").unwrap_or(f64::INFINITY);
        let any = length(&s, "any-angle");
        assert!(point <= any + 1e-9, "{:?} {:?}: {point} > {any}", s.spec, s.grid);
        assert_eq!(point.is_finite(), any.is_finite(), "{:?}", s.spec);
        let ends = distance(s.spec.start, s.spec.goals[0].at);
        assert!(point >= ends - 1e-9);
        below += u32::from(any < f64::INFINITY && point < any - 1e-9);
        all += 1;
    }
    assert!(below > all / 10, "{below} of {all}: a polyline through centres keeps off the corners");
}

/// The point robot's way by brute force: all corners and both ends, sight by sampling the way densely.
fn sampled_point_robot(s: &Scenario) -> f64 {
    let (w, h) = (s.grid.width() as i32, s.grid.height() as i32);
    let end = |p: Point| (f64::from(p.x) + 0.5, f64::from(p.y) + 0.5);
    let mut places = vec![end(s.spec.start), end(s.spec.goals[0].at)];
    places.extend((0..=h).flat_map(|y| (0..=w).map(move |x| (f64::from(x), f64::from(y)))));
    let free = |x: f64, y: f64| s.grid.is_free_at(x.floor() as i64, y.floor() as i64);
    // A place is inside the obstacles when all four cells a hair away from it are blocked.
    let open =
        |x: f64, y: f64| [(-1e-7, -1e-7), (1e-7, -1e-7), (-1e-7, 1e-7), (1e-7, 1e-7)].iter().any(|o| free(x + o.0, y + o.1));
    let sees = |a: (f64, f64), b: (f64, f64)| {
        (0..=997).all(|k| {
            let t = f64::from(k) / 997.0;
            open(a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1))
        })
    };
    let mut edges = Vec::new();
    for (i, &a) in places.iter().enumerate() {
        for (j, &b) in places.iter().enumerate() {
            if i != j && sees(a, b) {
                edges.push((i, j, (a.0 - b.0).hypot(a.1 - b.1)));
            }
        }
    }
    relax_all(&edges, places.len(), &[0])[1]
}

#[test]
fn the_point_robot_agrees_with_dense_sampling() {
    // Sampling cannot tell a squeeze from a passage, so the rule is `always`, which squeezes.
    let rule = Movement { moves: Moves::Eight, corner_rule: CornerRule::Always };
    for seed in 0..25 {
        let s = random(4 + seed % 3, 0.35, 40 + seed, rule);
        let found = point_robot(&s).expect("a small map").unwrap_or(f64::INFINITY);
        let sampled = sampled_point_robot(&s);
        assert!(found == sampled || (found - sampled).abs() < 1e-6, "{:?}: {found}, {sampled}", s.grid);
    }
}

#[test]
fn the_point_robot_by_hand() {
    let bound =
        |rows: &[&str], rule| point_robot(&drawn(rows, Movement { moves: Moves::Eight, corner_rule: rule })).expect("small");
    // Over the upper corners of one block: (0.5, 1.5) → (1, 1) → (2, 1) → (2.5, 1.5).
    let block = ["...", "S#G", "..."];
    assert!(bound(&block, CornerRule::BothFree).is_some_and(|l| same(l, 1.0 + SQRT2)));
    // Through the corner at which two blocks touch, or not.
    let pinch = ["S#", "#G"];
    assert!(bound(&pinch, CornerRule::Always).is_some_and(|l| same(l, SQRT2)));
    for rule in [CornerRule::OneFree, CornerRule::BothFree] {
        assert_eq!(bound(&pinch, rule), None, "{rule:?}");
        // Round the outside of the blocks, along their edges: no way through their shared edge, none beyond the border.
        assert_eq!(bound(&["S#.", "##.", "..G"], rule), None, "{rule:?}");
    }
    assert!(bound(&["S.", "#G"], CornerRule::OneFree).is_some_and(|l| same(l, SQRT2)), "one corner may be touched");
    assert!(bound(&["S", "."].map(|_| "SG")[..1], CornerRule::Always).is_some_and(|l| same(l, 1.0)));
}

#[test]
fn polylines_have_a_proven_yardstick_on_large_planes() {
    let rule = Movement::default();
    for s in [64, 65, 256].map(|side| random(side, 0.3, 2, rule)) {
        let Reference::Proven { value } = exact::reference(&s, Objective::PolylineLength) else { panic!("proven") };
        let steps = solve(&s, "astar").best().map(|b| b.path.clone()).expect("a path");
        let refined = Metrics::of(&s, &refine(&s, &steps, Refinement::Farthest)).length;
        let point = point_robot(&s).expect("within its limit").expect("a way");
        assert!(point < value && value < refined && refined < Metrics::of(&s, &steps).length, "{point} {value} {refined}");
    }
    let swamp = swamp(rule);
    assert!(
        matches!(exact::reference(&swamp, Objective::PolylineLength), Reference::Unproven { value } if same(value, length(&swamp, "theta-star")))
    );

    let grid = Grid::open(1025, 1024).expect("a map");
    let huge = Arc::new(Scenario::on(grid, rule, Point::new(0, 0), Point::new(9, 2)).expect("usable"));
    assert_eq!(exact::reference(&huge, Objective::PolylineLength), Reference::Unknown);
    let refused = catalog::build(&huge, "any-angle", None, &Values::new(), 1).err().expect("too large");
    assert!(matches!(&refused, ParamError::MapTooLarge { most: 1_048_576, width: 1025, .. }));
    let report = refused.report();
    assert_eq!((report.kind.as_str(), report.field.as_str()), ("map-too-large", "map"));
    assert!(report.message.contains("1048576") && report.hint.contains("theta-star"), "{report:?}");
    assert!(matches!(exact::reference(&huge, Objective::TurnIndex), Reference::Proven { .. }));
    assert!(point_robot(&huge).is_err_and(|e| (e.cells, e.most) == (1025 * 1024, 1 << 20)));
}

#[test]
fn the_shortest_polyline_is_proven_on_large_planes() {
    for (seed, density) in [(1, 0.1), (2, 0.3)] {
        let s = random(256, density, seed, Movement::default());
        let planner = solve(&s, "any-angle");
        let best = planner.best().expect("a path");
        assert_eq!(planner.status(), Status::Optimal);
        assert_eq!(audit(&s, &points(&s, &best.path), PathKind::Polyline), Ok(()));
        assert_eq!(refine(&s, &best.path, Refinement::Farthest), best.path, "none of its bends can be left out");
        assert!(best.length <= length(&s, "theta-star") + 1e-9 && best.length >= distance(s.spec.start, s.spec.goals[0].at));
    }
}

#[test]
fn the_turn_index_has_a_proven_yardstick_not_above_the_shortest_paths() {
    for s in small(30) {
        let astar = solve(&s, "astar");
        match exact::reference(&s, Objective::TurnIndex) {
            Reference::Proven { value } => {
                let best = astar.best().expect("a path");
                let metrics = Metrics::of(&s, &best.path);
                assert!(metrics.length <= value + 1e-9 && value <= metrics.turn_index + 1e-9);
            }
            reference => assert_eq!((reference, astar.best()), (Reference::NoPath, None)),
        }
    }
}

/// The least weighted sum: states are cell · 8 + direction of the step that led there, every edge's cost is a difference of sums of two or three
/// cells, measured as any path is.
fn least_sum(s: &Scenario, sum: &WeightedSum) -> f64 {
    let mut edges = Vec::new();
    let cells = s.grid.len();
    for c in 0..cells as Cell {
        for d in s.moves.directions(c) {
            let next = s.moves.step(c, d);
            let (to, step) = (next as usize * 8 + usize::from(d), sum.of(s, &[c, next]));
            if c == s.start {
                edges.push((cells * 8, to, step));
            }
            for came in 0..8 as Direction {
                // The cell before, where a step in this direction leads to c.
                let before = (0..cells as Cell).find(|&b| s.moves.directions(b).any(|e| e == came && s.moves.step(b, e) == c));
                if let Some(before) = before {
                    let both = sum.of(s, &[before, c, next]);
                    edges.push((c as usize * 8 + usize::from(came), to, both - sum.of(s, &[before, c])));
                }
            }
        }
    }
    let cost = relax_all(&edges, cells * 8 + 1, &[cells * 8]);
    if s.start == s.goal { 0.0 } else { (0..8).map(|d| cost[s.goal as usize * 8 + d]).fold(f64::INFINITY, f64::min) }
}

#[test]
fn the_weighted_search_has_the_least_sum_of_every_kind() {
    let none = WeightedSum { turn_weight: 0.0, clearance_weight: 0.0, ..WeightedSum::default() };
    let sums = [
        none,
        WeightedSum::default(),
        WeightedSum { turn_weight: 3.5, ..none },
        WeightedSum { clearance_weight: 8.0, clearance_wanted: 2.5, ..none },
        WeightedSum { energy_weight: 8.0, length_weight: 0.001, ..none },
        WeightedSum { energy_weight: 0.5, turn_weight: 0.3, clearance_weight: 2.0, ..WeightedSum::default() },
    ];
    for (index, s) in small(12).enumerate() {
        let sum = sums[index % sums.len()];
        let least = least_sum(&s, &sum);
        match weighted_reference(&s, sum) {
            Reference::Proven { value } => assert!(same(value, least), "{:?} {sum:?}: {value}, {least}", s.spec),
            Reference::NoPath => assert_eq!(least, f64::INFINITY),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn the_planner_of_the_weighted_search_tells_its_sum_and_what_it_comes_to() {
    let s = drawn(&["S.#.#.#.G", ".........", "........."], Movement { moves: Moves::Four, corner_rule: CornerRule::BothFree });
    let set = |pairs: &[(&str, Value)]| -> Values { pairs.iter().map(|(k, v)| ((*k).to_string(), v.clone())).collect() };
    let values = set(&[("criterion", "weighted-sum".into()), ("turn_weight", 5.0.into()), ("clearance_weight", 0.0.into())]);
    let mut planner = catalog::build(&s, "turn-aware", None, &values, 1).expect("usable");
    assert_eq!((planner.objective(), planner.run()), (Objective::Weighted, Status::Optimal));
    let best = planner.best().expect("a path").path.clone();
    // 10 steps and two turns, as by the turn index.
    let value = planner.value(&Metrics::of(&s, &best)).expect("a value");
    assert!(same(value, 20.0), "{value}");
    let sum = planner.weighed().expect("a weighted sum").sum;
    assert_eq!((sum.turn_weight, exact::reference(&s, Objective::Weighted)), (5.0, Reference::Unknown));
    let of_v = catalog::build(&s, "turn-aware", None, &Values::new(), 1).expect("usable");
    assert_eq!((of_v.objective(), of_v.weighed()), (Objective::TurnIndex, None));
}

#[test]
fn closeness_keeps_away_from_walls() {
    // Straight along the wall, or a row below it.
    let s = drawn(&["#########", "S.......G", ".........", ".........", "#########"], Movement::default());
    let sum = WeightedSum { clearance_weight: 5.0, clearance_wanted: 2.0, turn_weight: 0.0, ..WeightedSum::default() };
    let along: Vec<Cell> = (9..18).collect();
    let Reference::Proven { value } = weighted_reference(&s, sum) else { panic!("a plane") };
    assert!(value < sum.of(&s, &along) - 1.0, "{value}");
}
