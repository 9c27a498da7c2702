//! Weighted ground: the optimum against brute force, what planners make of it, and a robot's inflation against Nav2's formula.
#![cfg(not(target_arch = "wasm32"))]

use std::path::PathBuf;
use std::sync::Arc;

use formicarium::catalog::{self, CATALOG};
use formicarium::exact::{self, Reference};
use formicarium::formats;
use formicarium::map::{ALL_DIRECTIONS, Cell, Charge, CornerRule, Grid, Movement, Moves, Point, offset};
use formicarium::metrics::Metrics;
use formicarium::params::{Value, Values};
use formicarium::planner::{Ground, Objective};
use formicarium::scenario::{CostRule, Inflation, Robot, Scenario, ScenarioSpec};

/// A small generator of the tests' own, so that nothing of the engine decides what is tested.
struct Draws(u64);

impl Draws {
    fn next(&mut self, below: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % u64::from(below)) as u32
    }
}

const FACTORS: [f32; 6] = [1.0, 1.5, 2.0, 3.25, 8.0, 40.0];

/// A random map of mostly free cells with random factors, start and goal at free cells.
fn random(seed: u64, movement: Movement, least: usize) -> Arc<Scenario> {
    let mut draws = Draws(seed);
    let (width, height) = (6 + draws.next(9), 6 + draws.next(9));
    let cells: Vec<u8> = (0..width * height).map(|_| u8::from(draws.next(100) < 22)).collect();
    let factors: Vec<f32> =
        (0..width * height).map(|_| FACTORS[least + draws.next((FACTORS.len() - least) as u32) as usize]).collect();
    let grid = Grid::from_bytes(width, height, &cells).unwrap().with_factors(factors).unwrap();
    let mut free = || loop {
        let p = Point::new(draws.next(width), draws.next(height));
        if !grid.is_blocked(grid.cell(p)) {
            break p;
        }
    };
    let (start, goal) = (free(), free());
    Arc::new(Scenario::on(grid, movement, start, goal).unwrap())
}

/// Cost of a step by its definition: its length times the mean factor of the cells that it crosses, found by a thousand samples along it.
fn step_cost(scenario: &Scenario, from: Point, (dx, dy): (i32, i32)) -> f64 {
    let length = f64::from(dx * dx + dy * dy).sqrt();
    let factor = |t: f64| {
        let x = (f64::from(from.x) + f64::from(dx) * t + 0.5).floor() as u32;
        let y = (f64::from(from.y) + f64::from(dy) * t + 0.5).floor() as u32;
        f64::from(scenario.drawn.factors().unwrap()[scenario.grid.cell(Point::new(x, y)) as usize])
    };
    // Of a step that crosses two cells the ends' factors are its mean; of one that crosses four the quarters'.
    let at: &[f64] = if dx.abs().max(dy.abs()) == 1 { &[0.0, 1.0] } else { &[0.125, 0.375, 0.625, 0.875] };
    length * at.iter().map(|&t| factor(t)).sum::<f64>() / at.len() as f64
}

/// Dijkstra in its plainest form: the nearest open cell is looked for among all.
fn brute_force(scenario: &Scenario) -> Option<f64> {
    let grid = &scenario.grid;
    let mut cost = vec![f64::INFINITY; grid.len()];
    let mut done = vec![false; grid.len()];
    cost[scenario.start as usize] = 0.0;
    while let Some(at) = (0..grid.len()).filter(|&c| !done[c] && cost[c].is_finite()).min_by(|&a, &b| cost[a].total_cmp(&cost[b]))
    {
        done[at] = true;
        let p = grid.point(at as Cell);
        for d in 0..ALL_DIRECTIONS as u8 {
            if scenario.spec.movement.allows(grid, i64::from(p.x), i64::from(p.y), d) {
                let (dx, dy) = offset(d);
                let next = grid.cell(Point::new(p.x.wrapping_add_signed(dx), p.y.wrapping_add_signed(dy))) as usize;
                cost[next] = cost[next].min(cost[at] + step_cost(scenario, p, (dx, dy)));
            }
        }
    }
    Some(cost[scenario.goal as usize]).filter(|cost| cost.is_finite())
}

fn movements() -> impl Iterator<Item = Movement> {
    let all = [Moves::Four, Moves::Eight, Moves::Sixteen];
    all.into_iter().flat_map(|moves| CornerRule::ALL.map(|corner_rule| Movement { moves, corner_rule }))
}

#[test]
fn the_optimum_is_that_of_brute_force() {
    let mut reached = 0;
    for seed in 0..200 {
        for movement in movements() {
            // On every other map the smallest factor is above 1, so that the lower bound counts it.
            let scenario = random(seed, movement, (seed % 2) as usize * 2);
            let expected = brute_force(&scenario);
            for id in ["astar", "dijkstra"] {
                let mut planner = catalog::build(&scenario, id, None, &Values::new(), 0).unwrap();
                planner.run();
                let found = planner.best().map(|best| best.length);
                assert_eq!(found.is_some(), expected.is_some(), "{id}, map {seed}, {movement:?}");
                if let (Some(found), Some(expected)) = (found, expected) {
                    assert!((found - expected).abs() < 1e-9, "{id}, map {seed}, {movement:?}: {found} {expected}");
                    reached += 1;
                }
            }
            let reference = exact::reference(&scenario, Objective::Length);
            match expected {
                None => assert_eq!(reference, Reference::NoPath),
                Some(expected) => assert!(reference.is_proven() && (reference.value().unwrap() - expected).abs() < 1e-9),
            }
        }
    }
    assert!(reached > 2000, "most maps have a path: {reached}");
}

#[test]
fn no_planner_is_below_the_optimum_and_those_that_cannot_say_so() {
    let (mut planned, mut refused) = (0, 0);
    for seed in 0..6 {
        let scenario = random(1000 + seed, Movement::default(), 0);
        let Some(optimum) = brute_force(&scenario) else { continue };
        for entry in CATALOG {
            let mut values = Values::new();
            for (key, value) in [("iterations", 8.0), ("ants", 12.0)] {
                if (entry.specs)().iter().any(|spec| spec.key == key) {
                    values.insert(key.into(), Value::from(value));
                }
            }
            let built = catalog::build(&scenario, entry.id, None, &values, 3);
            if !entry.grounds.contains(&Ground::Weighted) {
                let message = built.err().expect("it does not know weighted ground").to_string();
                assert!(message.contains(entry.id) && !message.is_empty(), "{message}");
                refused += 1;
                continue;
            }
            let mut planner = built.unwrap_or_else(|e| panic!("{}: {e}", entry.id));
            planner.run();
            let Some(best) = planner.best() else { continue };
            let (path, length) = best.result();
            assert!((length - scenario.path_length(path)).abs() < 1e-9, "{}: its length is the cost", entry.id);
            let metrics = Metrics::of(&scenario, path);
            assert!((metrics.cost.unwrap() - length).abs() < 1e-9 && metrics.length <= length + 1e-9, "{}", entry.id);
            if planner.objective() != Objective::PolylineLength {
                assert!(length >= optimum - 1e-9, "{}: {length} is below {optimum}", entry.id);
            }
            planned += 1;
        }
    }
    assert!(planned > 60 && refused >= 30, "{planned} planned, {refused} refused");
}

#[test]
fn a_polyline_on_weighted_ground_is_never_dearer_than_the_path_of_steps() {
    let mut shorter = 0;
    for seed in 0..60 {
        let scenario = random(2000 + seed, Movement::default(), 0);
        let run = |id: &str| {
            let mut planner = catalog::build(&scenario, id, None, &Values::new(), 0).unwrap();
            planner.run();
            planner.best().map(|best| best.length)
        };
        if let (Some(steps), Some(polyline)) = (run("astar"), run("theta-star")) {
            assert!(polyline <= steps + 1e-9, "map {seed}: {polyline} {steps}");
            shorter += u32::from(polyline < steps - 1e-9);
        }
    }
    assert!(shorter > 10, "{shorter}");
}

#[test]
fn the_dear_way_is_left_for_the_cheap_one() {
    // A straight corridor of factor 10, and a way around of 1.
    let mut factors = vec![1.0f32; 5 * 3];
    factors[5..10].fill(10.0);
    (factors[5], factors[9]) = (1.0, 1.0);
    let grid = Grid::open(5, 3).unwrap().with_factors(factors).unwrap();
    let movement = Movement { moves: Moves::Four, corner_rule: CornerRule::default() };
    let scenario = Arc::new(Scenario::on(grid, movement, Point::new(0, 1), Point::new(4, 1)).unwrap());
    for id in ["astar", "ant-system", "ant-colony-system", "max-min-ant-system", "fire", "ship", "acost"] {
        let mut planner = catalog::build(&scenario, id, None, &Values::new(), 1).unwrap();
        planner.run();
        let best = planner.best().unwrap_or_else(|| panic!("{id} finds a path"));
        assert_eq!(best.result().1, 6.0, "{id} goes around");
    }
}

fn ros(name: &str) -> Option<(Grid, ScenarioSpec)> {
    let folder = PathBuf::from(std::env::var_os("FORMICARIUM_DATA")?).join("rosmap");
    let read = |name: &str| std::fs::read(folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
    let yaml = read(&format!("{name}.yaml"));
    let image = String::from_utf8_lossy(&yaml)
        .lines()
        .find_map(|l| l.strip_prefix("image:").map(|v| v.trim().trim_matches('"').to_owned()));
    let image = image.expect("a picture is named");
    let picture = read(&image);
    let beside = formats::Companion { name: &image, bytes: &picture };
    let map =
        formats::import_with(&yaml, &format!("{name}.yaml"), &formats::ReadOptions::default(), Some(beside)).expect("a map");
    Some((map.grid, map.spec))
}

#[test]
fn inflation_is_nav2s_formula_cell_by_cell() {
    for (name, radius, inflation_radius, scaling) in
        [("turtlebot3_map", 0.22, 0.55, 3.0), ("tb3_sandbox", 0.18, 1.0, 10.0), ("depot", 0.3, 0.7, 2.58)]
    {
        let Some((grid, spec)) = ros(name) else {
            println!("skipped: FORMICARIUM_DATA is not set");
            return;
        };
        let resolution = spec.resolution;
        let inflation = Inflation { radius: inflation_radius, cost_scaling: scaling, ..Inflation::NAV2 };
        let costs = Robot { radius, inflation: Some(inflation) }.costs(&grid, resolution);
        let reach = (inflation_radius / resolution).ceil() as i64;
        // In whole millimetres: in binary numbers 6 · 0.05 m is more than 0.3 m.
        let millimetres = |metres: f64| (metres * 1000.0).round() as i64;
        let (cell, least) = (millimetres(resolution), millimetres(radius));
        let mut seen = [0u32; 4];
        for c in 0..grid.len() as Cell {
            let p = grid.point(c);
            let (x, y) = (i64::from(p.x), i64::from(p.y));
            // The nearest obstacle, looked for in every cell within reach: nothing farther counts.
            let mut squared = i64::MAX;
            for by in (y - reach).max(0)..=(y + reach).min(i64::from(grid.height()) - 1) {
                for bx in (x - reach).max(0)..=(x + reach).min(i64::from(grid.width()) - 1) {
                    if !grid.is_free_at(bx, by) {
                        squared = squared.min((bx - x).pow(2) + (by - y).pow(2));
                    }
                }
            }
            let metres = (squared as f64).sqrt() * resolution;
            let (expected, kind) = if squared == 0 {
                (254, 0)
            } else if squared < i64::MAX && squared * cell * cell <= least * least {
                (253, 1)
            } else if squared <= reach * reach {
                (((253 - 1) as f64 * (-scaling * (metres - radius)).exp()) as u8, 2)
            } else {
                (0, 3)
            };
            assert_eq!(costs[c as usize], expected, "{name} at {p:?}");
            seen[kind] += 1;
        }
        assert!(seen[..3].iter().all(|&n| n > 100), "{name}: {seen:?}");
    }
}

#[test]
fn a_cell_exactly_the_radius_away_is_blocked() {
    for cells in 1..=12u32 {
        for resolution in [0.05, 0.1, 0.02, 0.3] {
            let grid = Grid::from_bytes(cells + 2, 1, &[vec![1], vec![0; cells as usize + 1]].concat()).unwrap();
            // As somebody writes it: 0.15, not 0.15000000000000002.
            let radius: f64 = format!("{:.2}", f64::from(cells) * resolution).parse().unwrap();
            let costs = Robot { radius, inflation: None }.costs(&grid, resolution);
            assert_eq!(costs[cells as usize..], [253, 0], "{cells} cells of {resolution} m");
        }
    }
}

#[test]
fn the_robot_keeps_its_radius_and_pays_for_what_is_near() {
    // A wall with a gap of three cells; the robot of one cell's radius fits through its middle.
    let mut cells = vec![0u8; 15 * 9];
    (0..9).filter(|y| !(3..6).contains(y)).for_each(|y| cells[y * 15 + 7] = 1);
    let grid = Grid::from_bytes(15, 9, &cells).unwrap();
    let robot = |radius, inflation| Some(Robot { radius, inflation });
    let spec = ScenarioSpec { robot: robot(1.0, None), ..ScenarioSpec::new(&grid, Point::new(1, 1), Point::new(13, 7)) };
    let scenario = Arc::new(Scenario::new(grid.clone(), spec.clone()).unwrap());
    assert!(scenario.grid.is_blocked(scenario.grid.cell(Point::new(7, 3))) && !scenario.drawn.is_blocked(3 * 15 + 7));
    let mut planner = catalog::build(&scenario, "astar", None, &Values::new(), 0).unwrap();
    planner.run();
    let path = planner.best().unwrap().path.clone();
    assert!(path.contains(&(4 * 15 + 7)), "through the middle of the gap");
    assert!(Metrics::of(&scenario, &path).min_clearance > 1.0, "to the walls that were drawn");
    let wide = Scenario::new(grid.clone(), ScenarioSpec { robot: robot(2.0, None), ..spec.clone() }).unwrap();
    assert!(!wide.reachable());
    let narrow = Scenario::new(grid.clone(), ScenarioSpec { start: Point::new(6, 1), ..spec.clone() }).unwrap_err();
    assert_eq!(narrow.report().kind, "start-too-narrow");
    // With costs beside walls the way through the gap is dearer than its length.
    let near = Inflation { radius: 3.0, cost_scaling: 0.5, rule: CostRule::Nav2Navfn, ..Inflation::NAV2 };
    let dear = Scenario::new(grid, ScenarioSpec { robot: robot(0.0, Some(near)), ..spec }).unwrap();
    let measured = Metrics::of(&dear, &path);
    assert!(measured.cost.unwrap() > measured.length + 1.0);
    assert_eq!(measured.length, Metrics::of(&scenario, &path).length);
}

#[test]
fn nav2s_own_charge_is_the_cell_that_is_entered() {
    let grid = Grid::open(3, 1).unwrap().with_factors(vec![9.0, 2.0, 4.0]).unwrap();
    let movement = Movement { moves: Moves::Eight, corner_rule: CornerRule::Always };
    let scenario = Arc::new(Scenario::on(grid, movement, Point::new(0, 0), Point::new(2, 0)).unwrap().charging(Charge::Entered));
    let mut planner = catalog::build(&scenario, "astar", None, &Values::new(), 0).unwrap();
    planner.run();
    assert_eq!(planner.best().unwrap().length, 6.0);
    for seed in 0..100 {
        let scenario = Arc::new(Scenario::clone(&random(3000 + seed, movement, 0)).charging(Charge::Entered));
        let run = |id| {
            let mut planner = catalog::build(&scenario, id, None, &Values::new(), 0).unwrap();
            planner.run();
            planner.best().map(|best| best.length)
        };
        let entered = |from: Cell, to: Cell| {
            let (a, b) = (scenario.grid.point(from), scenario.grid.point(to));
            a.distance(b) * f64::from(scenario.grid.factors().unwrap()[to as usize])
        };
        let (Some(found), Some(plain)) = (run("astar"), run("dijkstra")) else { continue };
        assert!((found - plain).abs() < 1e-9, "map {seed}");
        let mut planner = catalog::build(&scenario, "astar", None, &Values::new(), 0).unwrap();
        planner.run();
        let summed: f64 = planner.best().unwrap().path.windows(2).map(|s| entered(s[0], s[1])).sum();
        assert!((found - summed).abs() < 1e-9, "map {seed}: {found} {summed}");
    }
}

#[test]
fn a_weighted_map_and_its_robot_are_themselves_again_after_a_file() {
    let scenario = random(7, Movement::default(), 0);
    let robot = Some(Robot { radius: 0.25, inflation: Some(Inflation::NAV2) });
    let spec = ScenarioSpec { robot, resolution: 0.5, ..scenario.spec.clone() };
    let text = formats::export(&scenario.drawn, &spec, formats::Export::Scenario);
    let spec_alone = formats::read_spec(&text.replace("\"map\"", "\"not\"")).err();
    assert!(spec_alone.is_some(), "unknown fields are refused");
    let read = formats::read_scenario(&text);
    match read {
        Ok((grid, read)) => assert_eq!((grid, read), (scenario.drawn.clone(), spec)),
        // The ends may lie too near to a wall for this robot: that is told by name.
        Err(error) => assert!(error.to_string().contains("does not fit"), "{error}"),
    }
    let plain = ScenarioSpec { robot: None, ..scenario.spec.clone() };
    let text = formats::export(&scenario.drawn, &plain, formats::Export::Scenario);
    assert_eq!(formats::read_scenario(&text).unwrap(), (scenario.drawn.clone(), plain));
    for (from, to, named) in [("1.5", "0.5", "factor"), ("1.5", "null", "factor"), ("1.5", "1e9", "factor")] {
        let broken = text.replacen(from, to, 1);
        assert!(broken != text && formats::read_scenario(&broken).unwrap_err().to_string().contains(named));
    }
}
