//! Smoothed curves: free to the last part, within their bound where there is room, the same on every machine.
#![cfg(not(target_arch = "wasm32"))]

use std::sync::Arc;

use formicarium::catalog;
use formicarium::digest::Digest;
use formicarium::map::{Cell, CornerRule, Generator, Grid, Measure, Movement, Moves, Point, SliceRules, generate};
use formicarium::params::Values;
use formicarium::scenario::{Goal, Scenario, ScenarioSpec, SmoothingRule, TerrainMoves, TerrainSpec};
use formicarium::smoothing::{Smoothed, smooth};

/// No bound.
const ANY: SmoothingRule = SmoothingRule { max_curvature: 0.0 };

/// How close together the naive check looks, in cells.
const LOOK: f64 = 1.0 / 128.0;

fn planned(scenario: &Arc<Scenario>, planner: &str) -> Option<Vec<Cell>> {
    let mut planner = catalog::build(scenario, planner, None, &Values::new(), 1).expect("a planner");
    planner.run();
    planner.best().map(|best| best.result().0.to_vec())
}

fn cell(at: [f64; 2]) -> [i64; 2] {
    at.map(|v| (v + 0.5).floor() as i64)
}

/// Whether one may go straight from a point in one cell to a point in another diagonally beside it: by the free cell that lies between, or,
/// exactly through the corner, by the rule.
fn passes(scenario: &Scenario, mut from: ([f64; 2], [i64; 2]), mut to: ([f64; 2], [i64; 2])) -> bool {
    let free = |[x, y]: [i64; 2]| scenario.grid.is_free_at(x, y);
    for _ in 0..30 {
        let middle = [0, 1].map(|i| 0.5 * (from.0[i] + to.0[i]));
        match cell(middle) {
            here if here == from.1 => from.0 = middle,
            here if here == to.1 => to.0 = middle,
            // What comes into a blocked cell is seen elsewhere; a hair's breadth of it is rounding.
            between if free(between) => return true,
            _ => break,
        }
    }
    scenario.spec.movement.corner_rule.allows(free([to.1[0], from.1[1]]), free([from.1[0], to.1[1]]))
}

/// Looks at one point after the other: each lies in a free cell, and where the next one lies diagonally across a corner the rule allows it.
fn naive_flaw(scenario: &Scenario, points: &[[f64; 2]]) -> Option<String> {
    let free = |x: i64, y: i64| scenario.grid.is_free_at(x, y);
    let mut before = (points[0], cell(points[0]));
    for ends in points.windows(2) {
        let away = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
        let parts = (away[0].hypot(away[1]) / LOOK).ceil().max(1.0);
        for k in 0..=parts as u32 {
            let at = [0, 1].map(|i| ends[0][i] + away[i] * f64::from(k) / parts);
            let here = cell(at);
            // What lies on a side of the cell belongs to both.
            let deep = |v: f64, c: i64| (v - c as f64).abs() < 0.5 - 1e-6;
            if !free(here[0], here[1]) && deep(at[0], here[0]) && deep(at[1], here[1]) {
                return Some(format!("{at:?} is blocked"));
            }
            let aside = here[0] != before.1[0] && here[1] != before.1[1];
            if aside && !passes(scenario, before, (at, here)) {
                return Some(format!("{before:?} to {here:?} cuts a corner"));
            }
            if free(here[0], here[1]) {
                before = (at, here);
            }
        }
    }
    None
}

/// The distance from a point to the nearest blocked cell's square, as far as it is below 1.
fn clearance(grid: &Grid, [x, y]: [f64; 2]) -> f64 {
    let (column, row) = ((x + 0.5).floor() as i64, (y + 0.5).floor() as i64);
    let mut least = 1.0f64;
    for by in row - 2..=row + 2 {
        for bx in column - 2..=column + 2 {
            if !grid.is_free_at(bx, by) {
                let beyond = |v: f64, b: i64| ((v - b as f64).abs() - 0.5).max(0.0);
                least = least.min(beyond(x, bx).hypot(beyond(y, by)));
            }
        }
    }
    least
}

#[test]
fn no_curve_touches_a_wall_on_200_maps() {
    let (mut curves, mut bends) = (0, 0);
    for seed in 0..200 {
        let (width, height) = (8 + seed * 7 % 23, 8 + seed * 5 % 19);
        let density = [0.1, 0.2, 0.3, 0.4][seed as usize % 4];
        let kind = [Generator::Random, Generator::Cave, Generator::Rooms][seed as usize % 3];
        let Ok(made) = generate(kind, width, height, seed, density) else { continue };
        for corner_rule in CornerRule::ALL {
            for (moves, planner) in [(Moves::Eight, "astar"), (Moves::Four, "astar"), (Moves::Eight, "theta-star")] {
                let spec = ScenarioSpec { movement: Movement { moves, corner_rule }, ..made.spec("") };
                let scenario = Arc::new(Scenario::new(made.grid.clone(), spec).expect("usable"));
                let Some(path) = planned(&scenario, planner) else { continue };
                for bound in [0.0, 0.5] {
                    let curve = smooth(&scenario, &path, SmoothingRule { max_curvature: bound }).expect("a curve");
                    assert!(curve.is_curve, "on a plane there always is one");
                    let flaw = naive_flaw(&scenario, &curve.points);
                    assert_eq!(flaw, None, "seed {seed}, {corner_rule:?}, {moves:?}, {planner}, bound {bound}");
                    let ends = [path[0], path[path.len() - 1]].map(|c| scenario.grid.point(c)).map(|p| [p.x, p.y].map(f64::from));
                    assert_eq!((curve.points[0], curve.points[curve.points.len() - 1]), (ends[0], ends[1]));
                    if corner_rule == CornerRule::BothFree {
                        let near = curve.points.iter().map(|&at| clearance(&scenario.grid, at)).fold(1.0, f64::min);
                        assert!(near > 0.0, "seed {seed}: it touches a wall");
                    }
                    curves += 1;
                    bends += usize::from(curve.points.len() > 2);
                }
            }
        }
    }
    assert!(curves > 1500 && bends > 1200, "{curves} curves, {bends} of them bent");
}

/// An open map of a metre a cell, with a path through these cells.
fn open(side: u32, through: &[(u32, u32)]) -> (Scenario, Vec<Cell>) {
    let at = |&(x, y): &(u32, u32)| Point::new(x, y);
    let grid = Grid::open(side, side).expect("a map");
    let path = through.iter().map(|p| grid.cell(at(p))).collect();
    let ends = (at(&through[0]), at(&through[through.len() - 1]));
    (Scenario::on(grid, Movement::default(), ends.0, ends.1).expect("usable"), path)
}

/// Σ of the distances between one point and the next.
fn length(points: &[[f64; 2]]) -> f64 {
    points.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).sum()
}

#[test]
fn a_straight_path_stays_as_it_is() {
    let (scenario, path) = open(9, &[(0, 0), (1, 1), (2, 2), (3, 3)]);
    let curve = smooth(&scenario, &path, ANY).expect("a curve");
    assert_eq!(curve.points, [[0.0, 0.0], [3.0, 3.0]]);
    assert_eq!((curve.largest_curvature, curve.meets_bound, curve.is_curve, curve.saved), (Some(0.0), true, true, 0.0));
    let (scenario, path) = open(9, &[(4, 4)]);
    let curve = smooth(&scenario, &path, ANY).expect("a curve");
    assert_eq!((curve.points.len(), curve.length.to_bits(), curve.largest_curvature), (1, 0, Some(0.0)));
}

#[test]
fn bounds_are_met_where_there_is_room() {
    let corner: &[(u32, u32)] = &[(2, 2), (27, 2), (27, 27)];
    let stairs: Vec<(u32, u32)> = (0u32..28).map(|k| (k.div_ceil(2) + 1, k / 2 + 1)).collect();
    let around: &[(u32, u32)] = &[(2, 15), (15, 2), (28, 15), (15, 28)];
    for (name, through) in [("a corner", corner), ("stairs", &stairs), ("almost around", around)] {
        let (mut scenario, path) = open(30, through);
        for (resolution, radius) in [(1.0, 1.0), (1.0, 4.0), (0.05, 0.2)] {
            scenario.spec.resolution = resolution;
            let curve = smooth(&scenario, &path, SmoothingRule { max_curvature: 1.0 / radius }).expect("a curve");
            let most = curve.largest_curvature.expect("a radius");
            assert!(curve.meets_bound && most <= (1.0 + 1e-9) / radius, "{name}, {radius} m: {most}");
            assert!(curve.saved > 0.0 && (length(&curve.points) - curve.length).abs() < 1e-9, "{name}");
        }
    }
}

#[test]
fn a_bound_that_cannot_be_met_is_told() {
    // A corridor a cell wide around a corner: no turn is wider than it.
    let rows = ["......", "#####.", "#####.", "#####.", "#####.", "#####."];
    let cells: Vec<u8> = rows.iter().flat_map(|r| r.bytes().map(|b| u8::from(b == b'#'))).collect();
    let grid = Grid::from_bytes(6, 6, &cells).expect("a map");
    let scenario = Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(5, 5)).expect("usable");
    let path: Vec<Cell> = (0..6).chain((1..6).map(|y| y * 6 + 5)).collect();
    let curve = smooth(&scenario, &path, SmoothingRule { max_curvature: 0.1 }).expect("a curve");
    assert!(!curve.meets_bound && curve.is_curve && curve.largest_curvature > Some(0.1));
    assert_eq!(naive_flaw(&scenario, &curve.points), None);
}

#[test]
fn the_curvature_told_is_that_of_the_points() {
    let (scenario, path) = open(30, &[(2, 2), (20, 2), (25, 20), (4, 27)]);
    let curve = smooth(&scenario, &path, SmoothingRule { max_curvature: 0.5 }).expect("a curve");
    // Of the circle through three points in a row, by Menger: 4 · area / the product of the sides.
    let menger = |p: &[[f64; 2]]| {
        let side = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
        let area = ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0])).abs() / 2.0;
        4.0 * area / (side(p[0], p[1]) * side(p[1], p[2]) * side(p[0], p[2]))
    };
    let seen = curve.points.windows(3).map(menger).fold(0.0, f64::max);
    let told = curve.largest_curvature.expect("a radius");
    assert!(seen <= told * 1.01 && seen >= told * 0.97, "{seen} of {told}");
}

#[test]
fn a_path_that_turns_straight_back_has_no_radius() {
    let (scenario, path) = open(9, &[(0, 0), (6, 0), (2, 0)]);
    let curve = smooth(&scenario, &path, SmoothingRule { max_curvature: 0.0 }).expect("a curve");
    assert_eq!((curve.largest_curvature, curve.meets_bound), (None, true));
}

#[test]
fn a_tour_comes_through_the_cell_of_every_goal() {
    let (scenario, path) = open(20, &[(0, 0), (0, 15), (15, 15), (15, 3), (5, 3)]);
    let goals = [(0, 15), (8, 15), (15, 3), (5, 3)].map(|(x, y)| Goal::new(Point::new(x, y), ""));
    let scenario = scenario.with_ends(Point::new(0, 0), goals.to_vec()).expect("usable");
    let path: Vec<Cell> = [path[0], path[1], scenario.grid.cell(Point::new(8, 15)), path[2], path[3], path[4]].into();
    for bound in [0.0, 0.3] {
        let curve = smooth(&scenario, &path, SmoothingRule { max_curvature: bound }).expect("a curve");
        for goal in &scenario.spec.goals {
            assert!(curve.points.iter().any(|&at| cell(at) == [goal.at.x, goal.at.y].map(i64::from)), "{:?}", goal.at);
        }
        assert!(curve.points.iter().all(|&at| cell(at) != [15, 15]) || bound == 0.0, "a corner that is no goal may be left out");
    }
}

/// A cone of 20 cells by 20, `steep` high a cell away from its top.
fn cone(steep: f32, max_slope: f64) -> Option<(Scenario, Vec<Cell>)> {
    let away = |i: u32| ((i % 20) as f32 - 9.5).hypot((i / 20) as f32 - 9.5);
    let heights = (0..400).map(|i| 100.0 - steep * away(i)).collect();
    let grid = Grid::open(20, 20).expect("a map").with_heights(heights).expect("heights");
    let terrain = Some(TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Surface { max_slope } });
    let spec = ScenarioSpec { terrain, ..ScenarioSpec::new(&grid, Point::new(1, 9), Point::new(18, 10)) };
    let scenario = Arc::new(Scenario::new(grid, spec).expect("usable"));
    let path = planned(&scenario, "astar")?;
    Some((Scenario::clone(&scenario), path))
}

#[test]
fn on_a_surface_the_curve_is_as_long_as_its_ground_and_not_too_steep() {
    let (scenario, path) = cone(0.5, 90.0).expect("a path over the top");
    let curve = smooth(&scenario, &path, SmoothingRule { max_curvature: 0.5 }).expect("a curve");
    assert!(curve.length > length(&curve.points) * 1.05, "{} on the ground", curve.length);
    assert!((scenario.path_length(&path) - curve.length - curve.saved).abs() < 0.1);
    // At most 15 degrees on ground of 27: it must go around.
    let (scenario, path) = cone(0.5, 15.0).expect("a path around the top");
    let curve = smooth(&scenario, &path, SmoothingRule { max_curvature: 0.3 }).expect("a curve");
    let height = |[x, y]: [f64; 2]| {
        let at = |x: f64, y: f64| 100.0 - 0.5 * (x - 9.5).hypot(y - 9.5);
        let (l, u, r, d) = (x.floor(), y.floor(), x - x.floor(), y - y.floor());
        (1.0 - d) * ((1.0 - r) * at(l, u) + r * at(l + 1.0, u)) + d * ((1.0 - r) * at(l, u + 1.0) + r * at(l + 1.0, u + 1.0))
    };
    assert!(curve.is_curve && curve.points.len() > 20);
    for p in curve.points.windows(2) {
        let slope = (height(p[1]) - height(p[0])).abs() / (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]);
        assert!(slope.atan().to_degrees() < 15.0 + 0.01, "{slope} at {p:?}");
    }
}

#[test]
fn where_no_curve_is_free_the_path_itself_is_told() {
    // A slope that rises as steeply as is allowed to the east and to the south, and so more steeply in between.
    let heights: Vec<f32> = (0..25u32).map(|i| (i % 5 + i / 5) as f32).collect();
    let grid = Grid::open(5, 5).expect("a map").with_heights(heights).expect("heights");
    let terrain = Some(TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Surface { max_slope: 45.01 } });
    let spec = ScenarioSpec { terrain, ..ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(3, 3)) };
    let scenario = Scenario::new(grid, spec).expect("usable");
    let path = [0, 1, 2, 3, 8, 13, 18];
    let curve = smooth(&scenario, &path, ANY).expect("an answer");
    assert_eq!((curve.points, curve.saved), (vec![[0.0, 0.0], [3.0, 0.0], [3.0, 3.0]], 0.0));
    assert_eq!((curve.is_curve, curve.largest_curvature, curve.meets_bound), (false, None, true));
    let bound = smooth(&scenario, &path, SmoothingRule { max_curvature: 9.0 }).expect("an answer");
    assert!(!bound.meets_bound, "a corner meets no bound");
}

#[test]
fn by_slices_and_without_a_rule_there_is_none() {
    let (scenario, path) = open(9, &[(0, 0), (4, 0), (4, 4)]);
    assert_eq!((Smoothed::of(&scenario, &path), smooth(&scenario, &[], ANY)), (None, None));
    let grid = Grid::open(6, 6).expect("a map").with_heights(vec![0.0; 36]).expect("heights");
    let rules =
        SliceRules { level: 1.0, levels: 5, max_aside: 2, max_climb: 2, start_level: 1, goal_level: 1, measure: Measure::Cost };
    let terrain = Some(TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Slices(rules) });
    let mut spec = ScenarioSpec { terrain, ..ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(5, 3)) };
    spec.vehicle.smoothing = Some(ANY);
    let scenario = Arc::new(Scenario::new(grid, spec).expect("usable"));
    let path = planned(&scenario, "slices-exact").expect("a path");
    assert_eq!(Smoothed::of(&scenario, &path), None);
}

/// What came out when these were written: other bits on any machine are a fault, another number here is a change of results.
#[test]
fn the_same_points_on_every_machine() {
    let mut digest = Digest::default();
    for (seed, planner) in [(1, "astar"), (2, "theta-star"), (3, "dijkstra")] {
        let made = generate(Generator::Random, 30, 30, seed, 0.2).expect("a map");
        let scenario = Arc::new(Scenario::new(made.grid.clone(), made.spec("")).expect("usable"));
        let path = planned(&scenario, planner).expect("a path");
        for bound in [0.0, 1.0] {
            let curve = smooth(&scenario, &path, SmoothingRule { max_curvature: bound }).expect("a curve");
            curve.points.iter().flatten().for_each(|&v| digest.f64(v));
            [curve.length, curve.saved, curve.largest_curvature.expect("a radius")].into_iter().for_each(|v| digest.f64(v));
        }
    }
    assert_eq!(digest.hex(), "b1ee9958a85369f4");
}
