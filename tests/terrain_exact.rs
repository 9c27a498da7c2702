//! The yardsticks on terrains against brute force that shares no code with them, and on real heights.
#![cfg(not(target_arch = "wasm32"))]

#[path = "common/mod.rs"]
mod common;
#[path = "common/terrains.rs"]
mod terrains;

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use common::{length, movements, solve};
use formicarium::exact::{self, Distance, Estimate, Reference};
use formicarium::map::{Cell, CornerRule, Grid, Measure, Movement, Moves, Point, SliceRules};
use formicarium::path::{PathKind, audit, audit_slices, line_of_sight, points};
use formicarium::planner::{Ground, Objective, Status};
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};
use terrains::{hilly, hilly_slices, rules, sixteen, slices, surface};

/// Equal but for rounding.
fn same(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= 1e-9 * a.abs().max(1.0)
}

/// Bellman and Ford: least cost from one state by relaxing every edge until nothing changes.
fn relax_all(edges: &[(usize, usize, f64)], states: usize, from: usize) -> Vec<f64> {
    let mut cost = vec![f64::INFINITY; states];
    cost[from] = 0.0;
    loop {
        let mut changed = false;
        for &(a, b, d) in edges {
            if cost[a] + d < cost[b] * (1.0 - 1e-14) || (cost[b].is_infinite() && cost[a].is_finite()) {
                (cost[b], changed) = (cost[a] + d, true);
            }
        }
        if !changed {
            return cost;
        }
    }
}

/// The steps of a surface once more, from the rules as they are written down: (from, to, length in cells).
fn steps(s: &Scenario) -> Vec<(usize, usize, f64)> {
    let heights = s.grid.heights();
    let terrain = s.spec.terrain.unwrap_or_default();
    let steepest = match terrain.moves {
        TerrainMoves::Surface { max_slope } if max_slope < 90.0 => max_slope.to_radians().tan(),
        _ => f64::INFINITY,
    };
    let scale = terrain.vertical_unit / s.spec.resolution;
    let index = |x: i64, y: i64| (y * i64::from(s.grid.width()) + x) as usize;
    let z = |x: i64, y: i64| heights.map_or(0.0, |h| f64::from(h[index(x, y)]) * scale);
    let free = |x: i64, y: i64| s.grid.is_free_at(x, y);
    let Movement { moves, corner_rule } = s.spec.movement;
    let mut found = Vec::new();
    for (x, y) in (0..i64::from(s.grid.height())).flat_map(|y| (0..i64::from(s.grid.width())).map(move |x| (x, y))) {
        for (dx, dy) in (-2i64..=2).flat_map(|dy| (-2i64..=2).map(move |dx| (dx, dy))) {
            let to = (x + dx, y + dy);
            if !free(x, y) || !free(to.0, to.1) {
                continue;
            }
            let beside = [free(to.0, y), free(x, to.1)];
            // Run and rise of each straight part.
            let parts: Vec<(f64, f64)> = match (dx.abs().min(dy.abs()), dx.abs().max(dy.abs())) {
                (0, 1) => vec![(1.0, z(to.0, to.1) - z(x, y))],
                (1, 1) if moves != Moves::Four => {
                    let allowed = match corner_rule {
                        CornerRule::Always => true,
                        CornerRule::OneFree => beside[0] || beside[1],
                        CornerRule::BothFree => beside[0] && beside[1],
                    };
                    if !allowed {
                        continue;
                    }
                    vec![(2f64.sqrt(), z(to.0, to.1) - z(x, y))]
                }
                (1, 2) if moves == Moves::Sixteen => {
                    // Halfway it passes between two cells, which it crosses both.
                    let pair =
                        if dx.abs() == 2 { [(x + dx / 2, y), (x + dx / 2, to.1)] } else { [(x, y + dy / 2), (to.0, y + dy / 2)] };
                    if !pair.iter().all(|&(px, py)| free(px, py)) {
                        continue;
                    }
                    let middle = (z(pair[0].0, pair[0].1) + z(pair[1].0, pair[1].1)) / 2.0;
                    let run = 5f64.sqrt() / 2.0;
                    vec![(run, middle - z(x, y)), (run, z(to.0, to.1) - middle)]
                }
                _ => continue,
            };
            if parts.iter().all(|(run, rise)| rise.abs() / run <= steepest) {
                found.push((index(x, y), index(to.0, to.1), parts.iter().map(|(run, rise)| run.hypot(*rise)).sum()));
            }
        }
    }
    found
}

/// Small surfaces and planes of every movement: with walls, limits of slope, missing data, gentle and steep.
fn surfaces() -> Vec<Arc<Scenario>> {
    let mut all = Vec::new();
    for movement in movements().into_iter().chain(sixteen()) {
        for seed in 0..12u32 {
            let (width, height) = (6 + seed % 5, 5 + seed % 7);
            let walls: Vec<u8> = (0..width * height)
                .map(|c| u8::from(c > 0 && c + 1 < width * height && terrains::noise(seed, c, 99) < 0.2))
                .collect();
            let grid = Grid::from_bytes(width, height, &walls).expect("a size");
            let tall = [2.0, 8.0, 40.0, 3000.0][seed as usize % 4];
            let mut heights = terrains::hills(width, height, seed, tall);
            if seed % 3 == 1 {
                let missing = (1..width * height - 1).filter(|&c| terrains::noise(seed, 77, c) < 0.1);
                missing.for_each(|c| heights[c as usize] = f32::NAN);
            }
            let max_slope = if seed % 2 == 0 { 90.0 } else { [60.0, 85.0][seed as usize % 4 / 2] };
            let ends = (Point::new(0, 0), terrains::far_corner(&grid));
            all.push(surface(grid, heights, movement, max_slope, ends));
        }
    }
    all.extend(sixteen().into_iter().flat_map(|m| (0..8).map(move |seed| common::random(9, 0.3, 50 + seed, m))));
    all
}

#[test]
fn astar_and_dijkstra_are_the_shortest_ways_by_brute_force() {
    let (mut found, mut none, mut terrains) = (0, 0, 0);
    for s in surfaces() {
        let shortest = relax_all(&steps(&s), s.grid.len(), s.start as usize)[s.goal as usize];
        for id in ["astar", "dijkstra", "tour-exact"] {
            let planner = solve(&s, id);
            let Some(best) = planner.best() else {
                assert!(shortest.is_infinite() && planner.status() == Status::NoPath, "{id} on {:?}", s.spec);
                continue;
            };
            assert!(same(best.length, shortest), "{id} on {:?}: {} and {shortest}", s.spec, best.length);
            assert_eq!(audit(&s, &points(&s, &best.path), PathKind::Steps), Ok(()), "{id} on {:?}", s.spec);
        }
        *if shortest.is_finite() { &mut found } else { &mut none } += 1;
        terrains += u32::from(Ground::of(&s) != Ground::Plane && s.grid.heights().is_some());
    }
    assert!(found > 60 && none > 5 && terrains > 80, "{found} found, {none} without a path, {terrains} on terrains");
}

#[test]
fn the_estimate_is_consistent_and_admissible() {
    for s in surfaces() {
        let (edges, distance) = (steps(&s), Distance::of(&s));
        let estimate = |c: usize| {
            let p = s.grid.point(c as Cell);
            distance.to_goal(p.x, p.y)
        };
        assert_eq!(estimate(s.goal as usize), 0.0);
        for &(a, b, d) in &edges {
            assert!(estimate(a) <= (d + estimate(b)) * (1.0 + 1e-12), "{:?}: {a} to {b}", s.spec);
        }
        // Every step is as long the other way.
        let to_goal = relax_all(&edges, s.grid.len(), s.goal as usize);
        let free = (0..s.grid.len()).filter(|&c| !s.grid.is_blocked(c as Cell));
        free.for_each(|c| assert!(estimate(c) <= to_goal[c] * (1.0 + 1e-12), "{:?}: cell {c}", s.spec));
    }
}

#[test]
fn steps_of_hundreds_of_cells_by_hand() {
    // Over the pole in the middle: up 300 and down 300. Round it: 4 straight steps, or the two diagonals.
    let pole = |movement| {
        let mut heights = vec![0.0; 9];
        heights[4] = 300.0;
        surface(Grid::open(3, 3).expect("3 × 3"), heights, movement, 90.0, (Point::new(0, 1), Point::new(2, 1)))
    };
    let [four, eight] = [Moves::Four, Moves::Eight].map(|moves| pole(Movement { moves, corner_rule: CornerRule::BothFree }));
    assert_eq!(length(&four, "astar"), 4.0);
    assert!(same(length(&eight, "astar"), 2.0 * 2f64.sqrt()));
    // In a corridor there is no way round: 2·√(1 + 300²).
    let corridor = surface(
        Grid::open(3, 1).expect("3 × 1"),
        vec![0.0, 300.0, 0.0],
        Movement::default(),
        90.0,
        (Point::new(0, 0), Point::new(2, 0)),
    );
    assert!(same(length(&corridor, "astar"), 2.0 * (1.0f64 + 300.0 * 300.0).sqrt()));
}

#[test]
fn any_angle_on_a_surface_is_the_shortest_polyline_over_its_ground() {
    for s in surfaces().into_iter().filter(|s| s.grid.heights().is_some()) {
        let relief = s.moves.relief().expect("a surface").clone();
        let reached = s.moves.reached_from(s.start);
        let cells: Vec<Cell> = (0..s.grid.len() as Cell).filter(|&c| reached[c as usize]).collect();
        let pairs = cells.iter().flat_map(|&a| cells.iter().map(move |&b| (a, b)));
        let seen = pairs.filter(|&(a, b)| a != b && line_of_sight(&s, s.grid.point(a), s.grid.point(b)));
        let edges: Vec<_> = seen.map(|(a, b)| (a as usize, b as usize, relief.segment(a, b).length)).collect();
        let shortest = relax_all(&edges, s.grid.len(), s.start as usize)[s.goal as usize];
        let found = length(&s, "any-angle");
        assert!(same(found, shortest), "{:?}: {found} and {shortest}", s.spec);
        assert!(found <= length(&s, "astar") * (1.0 + 1e-12));
        if found.is_finite() {
            let reference = exact::reference(&s, Objective::PolylineLength);
            assert!(matches!(reference, Reference::Proven { value } if same(value, found)), "{reference:?}");
        }
    }
}

#[test]
fn cliffs_of_a_million_cells_cost_no_memory() {
    let grid = Grid::open(12, 12).expect("a size");
    let heights = (0..144).map(|c| if c / 12 % 2 == 0 { 0.0 } else { 1e6 }).collect();
    let ends = (Point::new(0, 0), Point::new(11, 11));
    let s = surface(grid, heights, Movement::default(), 90.0, ends);
    for id in ["any-angle", "astar"] {
        let mut planner = formicarium::catalog::build(&s, id, None, &Default::default(), 1).expect("knows the ground");
        assert_eq!(planner.run(), Status::Optimal, "{id}");
        assert!(planner.bytes() < 1_000_000, "{id} holds {} bytes", planner.bytes());
        assert!(planner.best().expect("a path").length >= 1e6, "{id}: the goal is so high");
    }
}

#[test]
fn yardsticks_that_do_not_know_the_ground_are_not_asked() {
    let on_hills = hilly(8, 8, 1, 5.0, Movement::default(), 90.0);
    let by_slices = hilly_slices(8, 7, 1, rules(Measure::Cost));
    assert_eq!(exact::reference(&on_hills, Objective::TurnIndex), Reference::Unknown);
    assert_eq!(exact::reference(&on_hills, Objective::SliceCost), Reference::Unknown);
    for objective in [Objective::Length, Objective::PolylineLength, Objective::TourLength, Objective::TurnIndex] {
        assert_eq!(exact::reference(&by_slices, objective), Reference::Unknown, "{objective:?}");
    }
    assert!(matches!(exact::reference(&by_slices, Objective::SliceCost), Reference::Proven { .. }));
    // Too large for a proof: a path of steps is a polyline, too.
    let large = hilly(65, 65, 2, 20.0, Movement::default(), 90.0);
    let reference = exact::reference(&large, Objective::PolylineLength);
    assert!(matches!(reference, Reference::Unproven { value } if same(value, length(&large, "astar"))), "{reference:?}");
}

/// The cheapest way by slices: every way there is, column by column, from the rules as they are written down.
fn cheapest(s: &Scenario, rules: &SliceRules, (x, y, h): (i64, i64, i64)) -> f64 {
    let (goal, heights) = (s.spec.goals[0].at, s.grid.heights().expect("a terrain"));
    let goal_at = (i64::from(goal.x), i64::from(goal.y), i64::from(rules.goal_level));
    if (x, y, h) == goal_at {
        return 0.0;
    }
    if x == goal_at.0 {
        return f64::INFINITY;
    }
    let next_x = x + (goal_at.0 - x).signum();
    let free = |y: i64, h: i64| {
        if next_x == goal_at.0 {
            return (y, h) == (goal_at.1, goal_at.2);
        }
        let inside = (0..i64::from(s.grid.height())).contains(&y) && (1..=i64::from(rules.levels)).contains(&h);
        inside && f64::from(heights[(y * i64::from(s.grid.width()) + next_x) as usize]) < h as f64 * rules.level
    };
    let (aside, climb) = (i64::from(rules.max_aside), i64::from(rules.max_climb));
    let all = (-aside..=aside).flat_map(|dy| (-climb..=climb).map(move |dh| (dy, dh)));
    let costs = all.filter(|&(dy, dh)| free(y + dy, h + dh)).map(|(dy, dh)| {
        let level = if rules.measure == Measure::Cost { (h + dh) as f64 } else { 0.0 };
        ((1 + dy * dy + dh * dh) as f64).sqrt() + level + cheapest(s, rules, (next_x, y + dy, h + dh))
    });
    costs.fold(f64::INFINITY, f64::min)
}

#[test]
fn dynamic_programming_is_the_cheapest_way_by_slices_of_all() {
    let (mut found, mut none) = (0, 0);
    for seed in 0..40u32 {
        let measure = [Measure::Cost, Measure::Length][seed as usize % 2];
        let (aside, climb) = [(1, 1), (2, 1), (1, 2), (0, 2)][seed as usize / 2 % 4];
        let level = if seed % 5 == 4 { 60.0 } else { 120.0 };
        let limits = SliceRules { level, levels: 5, max_aside: aside, max_climb: climb, ..rules(measure) };
        let grid = Grid::open(6, 4).and_then(|g| g.with_heights(terrains::hills(6, 4, seed, 500.0))).expect("6 × 4");
        let ground = |x: u32, y: u32| f64::from(grid.heights().expect("a terrain")[(y * 6 + x) as usize]);
        let lowest = |x, y| (ground(x, y) / level).ceil().max(1.0) as u32;
        let ends = if seed % 3 == 0 { [(5, 2), (0, 1)] } else { [(0, 1), (5, 2)] };
        let [start_level, goal_level] = ends.map(|(x, y)| lowest(x, y));
        if start_level.max(goal_level) > 5 {
            continue;
        }
        let s = slices(grid, SliceRules { start_level, goal_level, ..limits }, ends[0], ends[1]);
        let rules = *s.slices.as_ref().expect("slices").rules();
        let start = (i64::from(ends[0].0), i64::from(ends[0].1), i64::from(start_level));
        let (least, planner) = (cheapest(&s, &rules, start), solve(&s, "slices-exact"));
        match planner.best() {
            Some(best) => {
                assert!(same(best.length, least), "seed {seed}: {} and {least}", best.length);
                let points = s.slices.as_ref().expect("slices").points(&best.path);
                assert_eq!(audit_slices(&s, &points), Ok(()), "seed {seed}");
                found += 1;
            }
            None => {
                assert!(least.is_infinite() && planner.status() == Status::NoPath, "seed {seed}: {least}");
                none += 1;
            }
        }
    }
    assert!(found >= 15 && none >= 3, "{found} found, {none} without a path");
}

/// A file of the data folder; none, said aloud, without the folder.
fn data(name: &str) -> Option<PathBuf> {
    let file = std::env::var_os("FORMICARIUM_DATA").map(|folder| PathBuf::from(folder).join(name));
    if file.is_none() {
        println!("skipped: FORMICARIUM_DATA is not set, so there is no {name}");
    }
    file
}

/// The terrain paper's heights by slices, as its textbook program has them.
fn height_data(measure: Measure, start: (u32, u32, u32), goal: (u32, u32, u32)) -> Option<Arc<Scenario>> {
    let text = std::fs::read_to_string(data("papers/HeightData_21x21.csv")?).expect("readable");
    let heights: Vec<f32> = text.split([',', '\n']).filter(|t| !t.trim().is_empty()).map(|t| t.trim().parse().unwrap()).collect();
    let grid = Grid::open(21, 21).and_then(|g| g.with_heights(heights)).expect("21 × 21");
    let (start_level, goal_level) = (start.2, goal.2);
    let rules = SliceRules { level: 200.0, levels: 19, max_aside: 2, max_climb: 2, start_level, goal_level, measure };
    Some(slices(grid, rules, (start.0, start.1), (goal.0, goal.1)))
}

#[test]
fn the_terrain_papers_map_has_its_known_optima() {
    let (start, goal) = ((0, 9, 4), (20, 7, 5));
    let Some(cost) = height_data(Measure::Cost, start, goal) else { return };
    let one = |s: Option<Arc<Scenario>>| length(&s.expect("the file"), "slices-exact");
    let found = [
        length(&cost, "slices-exact"),
        one(height_data(Measure::Length, start, goal)),
        one(height_data(Measure::Cost, goal, start)),
        one(height_data(Measure::Length, goal, start)),
    ];
    println!("HeightData: cost {:.6}, length {:.6}; backwards {:.6}, {:.6}", found[0], found[1], found[2], found[3]);
    // Backwards the same ways: as long, and the level of the start is charged instead of the goal's.
    let known = [98.130_924, 21.974_691, 98.130_924 - 5.0 + 4.0, 21.974_691];
    found.iter().zip(known).for_each(|(f, k)| assert!((f - k).abs() < 1e-6, "{f} and {k}"));
}

/// An ESRI ASCII grid: six lines of names and numbers, then heights; where there is no data, NaN.
fn esri_ascii(text: &str) -> Grid {
    let lines: Vec<Vec<&str>> = text.lines().map(|l| l.split_whitespace().collect()).collect();
    let number = |name: &str| -> f32 {
        let line = lines.iter().take(6).find(|l| l[0].eq_ignore_ascii_case(name)).expect("in the header");
        line[1].parse().expect("a number")
    };
    let no_data = number("NODATA_value");
    let values = lines.iter().skip(6).flatten().map(|t| t.parse().expect("a number"));
    let heights = values.map(|h: f32| if h == no_data { f32::NAN } else { h }).collect();
    Grid::open(number("ncols") as u32, number("nrows") as u32).and_then(|g| g.with_heights(heights)).expect("a grid")
}

#[test]
fn astar_on_a_real_tile() {
    let Some(file) = data("dem/srtmgl3_144x144.asc") else { return };
    let grid = esri_ascii(&std::fs::read_to_string(file).expect("readable"));
    let corner = terrains::far_corner(&grid);
    // From corner to corner, and to a place that is not on the diagonal.
    for goal in [corner, Point::new(corner.x, corner.y / 2)] {
        let lengths = [Moves::Eight, Moves::Sixteen].map(|moves| astar_on(&grid, moves, goal));
        assert!(lengths[1] <= lengths[0] + 1e-9, "more directions, no longer way: {lengths:?}");
        assert!(goal == corner || lengths[1] < lengths[0] - 1.0, "{lengths:?}");
    }
}

/// Length of A*'s path from the upper left corner, checked.
fn astar_on(grid: &Grid, moves: Moves, goal: Point) -> f64 {
    // Three seconds of arc are 92.6 m from row to row; we call that the size of a cell.
    let terrain = Some(TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Surface { max_slope: 90.0 } });
    let movement = Movement { moves, corner_rule: CornerRule::BothFree };
    let spec = ScenarioSpec { movement, resolution: 92.6, terrain, ..ScenarioSpec::new(grid, Point::new(0, 0), goal) };
    let begun = Instant::now();
    let s = Arc::new(Scenario::new(grid.clone(), spec).expect("usable"));
    let (made, begun) = (begun.elapsed(), Instant::now());
    let planner = solve(&s, "astar");
    let time = begun.elapsed();
    let best = planner.best().expect("a path");
    let (steps, expanded) = (best.path.len() - 1, planner.effort().cell_expansions);
    println!(
        "{moves:?} to {goal:?}: {:.6} cells, {steps} steps, {expanded} expansions, {time:?} and {made:?} for the scenario",
        best.length
    );
    assert_eq!(audit(&s, &points(&s, &best.path), PathKind::Steps), Ok(()));
    assert!(same(best.length, length(&s, "dijkstra")) && same(best.length, s.path_length(&best.path)));
    assert!(Distance::of(&s).to_goal(0, 0) <= best.length);
    assert!(expanded as usize <= s.grid.len(), "a cell more than once: {expanded}");
    best.length
}
