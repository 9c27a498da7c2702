//! Scenarios that several test files share: made here, small, and each with a trap of its own.
#![allow(dead_code, reason = "every test file uses a part of it")]

use std::sync::Arc;

use formicarium::map::{CornerRule, Generator, Grid, Movement, Moves, Point, generate};
use formicarium::scenario::Scenario;

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
