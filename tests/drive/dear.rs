//! Drives over ground that costs more, and past obstacles near which it does.

use std::sync::Arc;

use formicarium::drive::{Did, DriveParams, Driver, End, clairvoyant};
use formicarium::exact::Reference;
use formicarium::map::{Cell, Grid, Movement, Moves, Point, mean_factor, offset, step_length};
use formicarium::params::Values;
use formicarium::path::direction_between;
use formicarium::scenario::{AtEnd, CostRule, DriveSpec, Inflation, Robot, Scenario, ScenarioSpec};

use super::common::drawn;
use super::moving::{Draws, map_at, random, track, with};

/// A random drive with factors, or a robot near which obstacles make cells dearer, or both; none where it has no room at its ends.
fn dear(side: u32, seed: u32) -> Option<Arc<Scenario>> {
    let (plain, mut draws) = (random(side, seed), Draws(u64::from(seed) + 5));
    let kind = draws.below(3);
    let factors = (0..plain.grid.len()).map(|_| draws.one_of(&[1.0, 1.0, 1.5, 4.0])).collect();
    let grid = if kind == 0 { plain.drawn.clone() } else { plain.drawn.clone().with_factors(factors).expect("in range") };
    let inflation = Inflation {
        radius: draws.one_of(&[1.0, 2.0, 3.5]),
        cost_scaling: draws.one_of(&[0.3, 1.0]),
        rule: draws.one_of(&CostRule::ALL),
        multiplier: draws.one_of(&[1.0, 2.0, 9.0]),
    };
    let robot = (kind != 1).then(|| Robot { radius: draws.one_of(&[0.0, 0.4, 1.0]), inflation: Some(inflation) });
    Scenario::new(grid, ScenarioSpec { robot, ..plain.spec.clone() }).ok().map(Arc::new)
}

/// A map as the robot feels it: where it has no room, and the factor of each cell.
fn felt(scenario: &Scenario, map: &Grid) -> (Grid, Vec<f64>) {
    let mut grid = map.clone();
    let costs = scenario.spec.robot.map_or_else(|| vec![0; map.len()], |robot| robot.costs(map, 1.0));
    let own = |cell: usize| map.factors().map_or(1.0, |factors| factors[cell]);
    let inflation = scenario.spec.robot.and_then(|robot| robot.inflation);
    let factor = |cell: usize| match inflation.filter(|_| costs[cell] < 253) {
        Some(inflation) => inflation.factor(costs[cell]).max(own(cell)),
        None => own(cell),
    };
    let factors = (0..map.len()).map(|cell| f64::from(factor(cell))).collect();
    (0..map.len()).filter(|&cell| costs[cell] == 253).for_each(|cell| grid.set_blocked(cell as Cell, true));
    (grid, factors)
}

/// What a step costs by such factors.
fn cost(grid: &Grid, factors: &[f64], from: Point, d: u8) -> f64 {
    let factor = |dx: i32, dy: i32| factors[grid.cell(from).wrapping_add_signed(dy * grid.width() as i32 + dx) as usize];
    step_length(d) * mean_factor(d, factor)
}

/// The least cost to the goal within so many steps: from step to step, to every cell from every other one, without an order or an end.
fn brute_force(scenario: &Scenario, most: u32) -> f64 {
    let cells = scenario.grid.len();
    let mut costs = vec![f64::INFINITY; cells];
    costs[scenario.start as usize] = 0.0;
    for step in 0..most {
        let mut after = costs.clone();
        for cell in (0..cells as Cell).filter(|&c| costs[c as usize].is_finite()) {
            let at = scenario.grid.point(cell);
            let (grid, factors) = felt(scenario, &map_at(scenario, step, at));
            let (x, y) = (i64::from(at.x), i64::from(at.y));
            for d in (0..16).filter(|&d| scenario.spec.movement.allows(&grid, x, y, d)) {
                let (dx, dy) = offset(d);
                let to = cell.wrapping_add_signed(dy * grid.width() as i32 + dx) as usize;
                after[to] = after[to].min(costs[cell as usize] + cost(&grid, &factors, at, d));
            }
        }
        costs = after;
    }
    costs[scenario.goal as usize]
}

#[test]
fn the_cheapest_drive_in_advance_is_that_of_brute_force() {
    let (mut proven, mut dearer) = (0, 0);
    for seed in 0..240 {
        let Some(scenario) = dear(3 + seed % 3, 30_000 + seed) else { continue };
        let best = brute_force(&scenario, 150);
        match clairvoyant(&scenario) {
            Reference::Proven { value } => {
                assert!((value - best).abs() < 1e-9, "seed {seed}: {value}, not {best}");
                proven += 1;
                let still = formicarium::exact::optimum(&scenario);
                dearer += u32::from(still.is_some_and(|still| (value - still).abs() > 1e-9));
            }
            found => assert!(found == Reference::NoPath && best == f64::INFINITY, "seed {seed}: {found:?}, not {best}"),
        }
    }
    assert!(proven > 100 && dearer > 20, "{proven} drives, {dearer} of them of another cost than the path on the map as it was");
}

#[test]
fn every_move_costs_what_the_map_says_when_it_moves() {
    let (mut arrived, mut worse) = (0, 0);
    for seed in 0..300 {
        let Some(scenario) = dear(4 + seed % 9, 40_000 + seed) else { continue };
        let params = DriveParams { iterations: 3, patience: 12, longest: 80, ..DriveParams::default() };
        let has_colonies = scenario.spec.movement.moves != Moves::Sixteen;
        let planner = ["d-star-lite", "astar", if has_colonies { "ant-system" } else { "astar" }][seed as usize % 3];
        let mut robot = Driver::new(&scenario, planner, None, &Values::new(), seed, params).expect("it can drive");
        let drive = robot.run();
        let (mut length, mut sum) = (0.0, 0.0);
        for pair in robot.steps().windows(2) {
            let at = pair[0].at;
            if let Some(d) = direction_between(at, pair[1].at) {
                let (grid, factors) = felt(&scenario, &map_at(&scenario, pair[0].step, at));
                assert!(scenario.spec.movement.allows(&grid, at.x.into(), at.y.into(), d), "seed {seed}: it has no room");
                (length, sum) = (length + step_length(d), sum + cost(&grid, &factors, at, d));
            }
            let told = pair[1].cost.unwrap_or_else(|| panic!("seed {seed}: no cost is told"));
            assert!((told - sum).abs() < 1e-9 && (pair[1].length - length).abs() < 1e-9, "seed {seed}: {told}, not {sum}");
        }
        assert_eq!((drive.cost, drive.length), (robot.last().cost, robot.last().length));
        if drive.end == Some(End::Arrived) {
            let ratio = drive.ratio.unwrap_or_else(|| panic!("seed {seed}: {:?}", drive.clairvoyant));
            assert!(ratio >= 1.0, "seed {seed} is {ratio} of the best");
            (arrived, worse) = (arrived + 1, worse + u32::from(ratio > 1.0));
        }
    }
    assert!(arrived > 100 && worse > 20, "{arrived} arrived, {worse} of them could have been cheaper");
}

#[test]
fn d_star_lite_and_a_star_anew_drive_as_cheaply() {
    for seed in 0..60 {
        let Some(scenario) = dear(5 + seed % 8, 50_000 + seed) else { continue };
        // Of equal paths they may take different ones, after which what they know differs: the first plan and the first cost are the same.
        let planned = ["d-star-lite", "astar"].map(|planner| {
            let mut robot = Driver::new(&scenario, planner, None, &Values::new(), 0, DriveParams::default()).expect("it can");
            robot.step();
            robot.planner().and_then(|planner| planner.best().map(|best| best.length))
        });
        match planned {
            [Some(a), Some(b)] => assert!((a - b).abs() < 1e-9, "seed {seed}: {a} and {b}"),
            [a, b] => assert_eq!(a, b, "seed {seed}"),
        }
    }
}

#[test]
fn plain_ground_tells_no_cost() {
    let corridor = drawn(&["S...G"], Movement::default());
    let mut robot = Driver::new(&corridor, "astar", None, &Values::new(), 0, DriveParams::default()).expect("it can drive");
    let drive = robot.run();
    assert_eq!((drive.cost, drive.ratio), (None, Some(1.0)));
    let json = serde_json::to_string(&drive).expect("JSON") + &serde_json::to_string(robot.steps()).expect("JSON");
    assert!(!json.contains("cost"), "{json}");
}

#[test]
fn it_keeps_away_from_what_moves_and_waits_for_a_cheaper_way() {
    let room = drawn(&[".......", "S.....G", "......."], Movement::default());
    let visitor = track(&[(3, 2)], 0, 4, AtEnd::Leave);
    let moving = with(&room, DriveSpec { tracks: vec![visitor], ..DriveSpec::default() });
    let inflation = Inflation { radius: 2.0, cost_scaling: 0.5, rule: CostRule::Nav2Smac2d, multiplier: 9.0 };
    let spec = ScenarioSpec { robot: Some(Robot { radius: 0.4, inflation: Some(inflation) }), ..moving.spec.clone() };
    let scenario = Arc::new(Scenario::new(moving.drawn.clone(), spec).expect("usable"));
    let mut robot = Driver::new(&scenario, "d-star-lite", None, &Values::new(), 0, DriveParams::default()).expect("it can");
    let drive = robot.run();
    // Whoever knows waits until the visitor has left, and pays the plain length.
    assert_eq!(drive.clairvoyant, Reference::Proven { value: 6.0 });
    assert!(drive.ratio.is_some_and(|ratio| ratio > 1.0), "{drive:?}");
    assert!(robot.steps().iter().any(|step| step.did == Did::Move && step.at.y == 0), "it passes by the far row");
}
