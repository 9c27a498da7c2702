//! Scenarios that several test files share: made here, small, and each with a trap of its own.
#![allow(dead_code, reason = "every test file uses a part of it")]

use std::sync::Arc;

use formicarium::catalog;
use formicarium::map::{CornerRule, Generator, Grid, Movement, Moves, Point, generate};
use formicarium::params::Values;
use formicarium::planner::Planner;
use formicarium::scenario::{Goal, Scenario, ScenarioSpec};

/// A scenario from rows of `.` free, `#` blocked, `S` start, `G` goal.
pub fn drawn(rows: &[&str], movement: Movement) -> Arc<Scenario> {
    let find = |what: u8| {
        let (y, row) = rows.iter().enumerate().find(|(_, r)| r.bytes().any(|b| b == what)).expect("marked");
        Point::new(row.bytes().position(|b| b == what).expect("marked") as u32, y as u32)
    };
    let cells: Vec<u8> = rows.iter().flat_map(|r| r.bytes().map(|b| u8::from(b == b'#'))).collect();
    let grid = Grid::from_bytes(rows[0].len() as u32, rows.len() as u32, &cells).expect("a rectangle");
    Arc::new(Scenario::on(grid, movement, find(b'S'), find(b'G')).expect("usable"))
}

/// Weighted ground: a swamp of several factors between start and goal, with a wall in it.
pub fn swamp(movement: Movement) -> Arc<Scenario> {
    let plain = drawn(&["........", "S.......", "...##...", "...#...G", "........"], movement);
    let factor = |c: u32| if (2..6).contains(&(c % 8)) { 1.5 + (c * 7 % 5) as f32 } else { 1.0 };
    let grid = plain.grid.clone().with_factors((0..40).map(factor).collect()).expect("factors of every cell");
    Arc::new(Scenario::new(grid, plain.spec.clone()).expect("usable"))
}

/// Every movement model.
pub fn movements() -> Vec<Movement> {
    let eight = CornerRule::ALL.map(|corner_rule| Movement { moves: Moves::Eight, corner_rule });
    [Movement { moves: Moves::Four, corner_rule: CornerRule::BothFree }].into_iter().chain(eight).collect()
}

/// A seeded random map of one size under one movement.
pub fn random(side: u32, density: f64, seed: u32, movement: Movement) -> Arc<Scenario> {
    let made = generate(Generator::Random, side, side, seed, density).expect("a valid size");
    Arc::new(Scenario::on(made.grid, movement, made.start, made.goal).expect("usable"))
}

/// Rooms with doors on a square map, made by seed.
pub fn rooms(side: u32, seed: u32, movement: Movement) -> Arc<Scenario> {
    let made = generate(Generator::Rooms, side, side, seed, 0.2).expect("a valid size");
    Arc::new(Scenario::on(made.grid, movement, made.start, made.goal).expect("usable"))
}

/// Small scenarios with a name: open, a wall with a gap, a trap that ants walk into, a corridor, one column, a diagonal squeeze.
pub fn gallery(movement: Movement) -> Vec<(&'static str, Arc<Scenario>)> {
    let maps: &[(&str, &[&str])] = &[
        ("open", &["S.....", "......", "......", ".....G"]),
        ("gap", &["S..#...", "...#...", ".......", "...#...", "...#..G"]),
        ("trap", &["........", ".#####..", ".....#..", "S....#.G", ".....#..", ".#####..", "........"]),
        ("corridor", &["S#...", ".#.#.", ".#.#.", "...#G"]),
        ("column", &["S", ".", ".", "G"]),
        ("row", &["S...G"]),
        ("same cell wide goal", &["SG"]),
        ("dead ends", &["S.......", ".#.#.#.#", ".#.#.#.#", "........", "#.#.#.#.", ".......G"]),
    ];
    let mut all: Vec<_> = maps.iter().map(|&(name, rows)| (name, drawn(rows, movement))).collect();
    all.push(("random 24", random(24, 0.25, 7, movement)));
    all
}

/// The same scenario with these goals; each weighs something else.
pub fn with_goals(scenario: &Scenario, goals: &[(u32, u32)]) -> Arc<Scenario> {
    let weigh = |(k, &(x, y)): (usize, &(u32, u32))| {
        let area = 0.4 + 0.3 * k as f64;
        Goal { area, ..Goal::new(Point::new(x, y), "") }
    };
    let spec = ScenarioSpec { goals: goals.iter().enumerate().map(weigh).collect(), ..scenario.spec.clone() };
    Arc::new(Scenario::new(scenario.grid.clone(), spec).expect("usable"))
}

/// Small scenarios with several goals: in a row, around a wall, with a goal on the start, on a random map.
pub fn tours(movement: Movement) -> Vec<(&'static str, Arc<Scenario>)> {
    let wall = drawn(&["........", "S.####..", "....G#..", ".####...", "........"], movement);
    let random = random(24, 0.25, 7, movement);
    let reached = random.moves.reached_from(random.start);
    let free: Vec<(u32, u32)> =
        (0..).zip(reached).filter(|r| r.1).map(|(c, _)| random.grid.point(c)).map(|p| (p.x, p.y)).collect();
    let spread: Vec<_> = (1..=5).map(|k| free[k * (free.len() - 1) / 5]).collect();
    vec![
        ("two goals in a row", with_goals(&drawn(&["..S...G"], movement), &[(6, 0), (0, 0)])),
        ("three goals around a wall", with_goals(&wall, &[(4, 2), (7, 0), (6, 4)])),
        ("a goal on the start", with_goals(&wall, &[(7, 4), (0, 1), (4, 2)])),
        ("five goals on random 24", with_goals(&random, &spread)),
    ]
}

/// A planner with its defaults and seed 1, run to its end.
pub fn solve(scenario: &Arc<Scenario>, id: &str) -> Box<dyn Planner> {
    let mut planner = catalog::build(scenario, id, None, &Values::new(), 1).expect("usable");
    planner.run();
    planner
}

/// The length of its path; infinite where there is none.
pub fn length(scenario: &Arc<Scenario>, id: &str) -> f64 {
    solve(scenario, id).best().map_or(f64::INFINITY, |b| b.length)
}
