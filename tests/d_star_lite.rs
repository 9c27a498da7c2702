//! D* Lite on maps that change under a robot that moves: after every change its path is as long as that of A* anew.
#![cfg(not(target_arch = "wasm32"))]

mod common;
#[path = "common/terrains.rs"]
mod terrains;

use std::sync::Arc;

use formicarium::catalog;
use formicarium::map::{CornerRule, Grid, Movement, Moves, Point};
use formicarium::params::Values;
use formicarium::path::{PathKind, audit, points};
use formicarium::planner::{Granularity, Planner};
use formicarium::scenario::{Change, Inflation, Robot, Scenario, ScenarioSpec};

/// Numbers below a bound, one after the other.
struct Draws(u64);

impl Draws {
    fn below(&mut self, bound: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as u32) % bound
    }
}

/// Every movement model: 4, 8 and 16 moves, each under every rule that makes a difference.
fn movements() -> Vec<Movement> {
    let of = |moves| CornerRule::ALL.map(|corner_rule| Movement { moves, corner_rule });
    let four = Movement { moves: Moves::Four, corner_rule: CornerRule::BothFree };
    [vec![four], of(Moves::Eight).to_vec(), of(Moves::Sixteen).to_vec()].concat()
}

/// A change of up to six cells, neither the robot's nor the goal.
fn change(draws: &mut Draws, grid: &Grid, robot: Point, goal: Point) -> Change {
    let mut change = Change { at: 0, blocked: Vec::new(), freed: Vec::new() };
    for _ in 0..1 + draws.below(6) {
        let cell = Point::new(draws.below(grid.width()), draws.below(grid.height()));
        let taken = cell == robot || cell == goal || change.cells().any(|p| p == cell);
        let no_data = grid.heights().is_some_and(|h| h[grid.cell(cell) as usize].is_nan());
        match (taken || no_data, grid.is_blocked(grid.cell(cell))) {
            (true, _) => {}
            (false, true) => change.freed.push(cell),
            (false, false) => change.blocked.push(cell),
        }
    }
    change
}

/// The scenario after a change, with the robot elsewhere.
fn after(scenario: &Scenario, change: &Change, robot: Point) -> Arc<Scenario> {
    let mut grid = scenario.drawn.clone();
    change.blocked.iter().for_each(|&p| grid.set_blocked(grid.cell(p), true));
    change.freed.iter().for_each(|&p| grid.set_blocked(grid.cell(p), false));
    let spec = ScenarioSpec { start: robot, ..scenario.spec.clone() };
    Arc::new(Scenario::new(grid, spec).expect("a map that can be driven on"))
}

/// It has found what A* finds, and a path by the rules.
fn assert_shortest(search: &dyn Planner, scenario: &Arc<Scenario>, what: &str) {
    let anew = common::solve(scenario, "astar");
    assert_eq!(search.status(), anew.status(), "{what}");
    let lengths = [search, &*anew].map(|planner| planner.best().map_or(f64::INFINITY, |best| best.length));
    assert!(lengths[0] == lengths[1] || (lengths[0] - lengths[1]).abs() < 1e-9, "{what}: {lengths:?}");
    if let Some(best) = search.best() {
        audit(scenario, &points(scenario, &best.path), PathKind::Steps).expect(what);
    }
}

/// Drives over a map that changes `count` times; the robot goes on by up to four steps in between.
fn drive(mut scenario: Arc<Scenario>, count: u32, draws: &mut Draws, what: &str) {
    let mut search = catalog::build(&scenario, "d-star-lite", None, &Values::new(), 0).expect("usable");
    for k in 0..count {
        let what = format!("{what}, change {k}");
        // Now and then a map changes before the search has ended.
        if draws.below(8) > 0 {
            search.run();
            assert_shortest(&*search, &scenario, &what);
        } else {
            search.advance(Granularity::Iteration);
        }
        let ahead = draws.below(5) as usize;
        let way = search.best().map_or_else(Vec::new, |best| points(&scenario, &best.path));
        let robot = way.get(ahead.min(way.len().saturating_sub(1))).copied().unwrap_or(scenario.spec.start);
        let change = change(draws, &scenario.drawn, robot, scenario.spec.goals[0].at);
        scenario = after(&scenario, &change, robot);
        search.adapt(&change, &scenario);
    }
    search.run();
    assert_shortest(&*search, &scenario, what);
}

#[test]
fn a_thousand_drives_over_changing_maps_are_as_short_as_searches_anew() {
    let movements = movements();
    for seed in 0..1000 {
        let mut draws = Draws(u64::from(seed) + 1);
        let (side, density) = (4 + draws.below(22), [0.0, 0.15, 0.3, 0.4][draws.below(4) as usize]);
        let movement = movements[seed as usize % movements.len()];
        let scenario = common::random(side, density, seed, movement);
        drive(scenario, 12, &mut draws, &format!("{side} × {side} cells by seed {seed}, {movement:?}"));
    }
}

#[test]
fn surfaces_with_steps_of_every_length_are_driven_as_short() {
    for (seed, movement) in (0..60).zip(movements().into_iter().cycle()) {
        let mut draws = Draws(seed + 7000);
        let (width, height) = (5 + draws.below(12), 5 + draws.below(12));
        let steep = [90.0, 40.0][draws.below(2) as usize];
        let scenario = terrains::hilly(width, height, seed as u32, 3.0, movement, steep);
        drive(scenario, 8, &mut draws, &format!("{width} × {height} hills by seed {seed}, up to {steep}°, {movement:?}"));
    }
}

/// The same question on ground with factors, of a robot with costs near obstacles, or both.
fn dear(scenario: &Scenario, draws: &mut Draws) -> Arc<Scenario> {
    let kind = draws.below(3);
    let factors = (0..scenario.grid.len()).map(|_| [1.0, 1.0, 1.25, 3.0][draws.below(4) as usize]).collect();
    let grid = scenario.drawn.clone();
    let grid = if kind == 0 { grid } else { grid.with_factors(factors).expect("in range") };
    let inflation = Inflation { radius: 1.0 + f64::from(draws.below(4)), cost_scaling: 0.5, ..Inflation::NAV2 };
    let robot = (kind != 1).then_some(Robot { radius: 0.4, inflation: Some(inflation) });
    Arc::new(Scenario::new(grid, ScenarioSpec { robot, ..scenario.spec.clone() }).expect("usable"))
}

#[test]
fn costs_that_change_with_obstacles_are_repaired() {
    let movements = movements();
    for seed in 0..200 {
        let mut draws = Draws(u64::from(seed) + 31_000);
        let (side, density) = (5 + draws.below(16), [0.0, 0.1, 0.25][draws.below(3) as usize]);
        let plain = common::random(side, density, seed, movements[seed as usize % movements.len()]);
        let scenario = dear(&plain, &mut draws);
        drive(scenario, 10, &mut draws, &format!("{side} × {side} cells by seed {seed}"));
    }
}

#[test]
fn on_a_large_map_a_long_drive_stays_exact() {
    for (seed, side) in [(1, 90), (2, 120)] {
        let scenario = common::random(side, 0.25, seed, Movement::default());
        drive(scenario, 60, &mut Draws(seed.into()), &format!("{side} × {side}"));
    }
}
