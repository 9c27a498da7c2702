//! Terrains that several test files share: small, seeded by whole numbers, and each with a trap of its own.
#![allow(dead_code, reason = "every test file uses a part of it")]

use std::sync::Arc;

use formicarium::map::{CornerRule, Grid, Measure, Movement, Moves, Point, SliceRules};
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

/// 16 moves under every corner rule.
pub fn sixteen() -> [Movement; 3] {
    CornerRule::ALL.map(|corner_rule| Movement { moves: Moves::Sixteen, corner_rule })
}

/// A number from 0 to 1 for a cell, the same everywhere.
pub fn noise(seed: u32, x: u32, y: u32) -> f32 {
    let mut k = (seed ^ 0x9e37_79b9).wrapping_mul(0x85eb_ca6b) ^ x.wrapping_mul(0xc2b2_ae35) ^ y.wrapping_mul(0x27d4_eb2f);
    k = (k ^ k >> 15).wrapping_mul(0x2c1b_3c6d);
    k = (k ^ k >> 12).wrapping_mul(0x297a_2d39);
    ((k ^ k >> 15) >> 8) as f32 / 16_777_216.0
}

/// Smooth hills and some roughness, `tall` units high.
pub fn hills(width: u32, height: u32, seed: u32, tall: f32) -> Vec<f32> {
    let at = |x: u32, y: u32| {
        let (corner_x, corner_y) = (x / 4, y / 4);
        let (u, v) = ((x % 4) as f32 / 4.0, (y % 4) as f32 / 4.0);
        let corner = |dx, dy| noise(seed, corner_x + dx, corner_y + dy);
        let above = corner(0, 0) * (1.0 - u) + corner(1, 0) * u;
        let below = corner(0, 1) * (1.0 - u) + corner(1, 1) * u;
        tall * (0.9 * (above * (1.0 - v) + below * v) + 0.1 * noise(seed + 1, x, y))
    };
    (0..height).flat_map(|y| (0..width).map(move |x| at(x, y))).collect()
}

/// A scenario with these heights on a map whose walls are given, from corner to corner unless told otherwise.
pub fn surface(grid: Grid, heights: Vec<f32>, movement: Movement, max_slope: f64, ends: (Point, Point)) -> Arc<Scenario> {
    let grid = grid.with_heights(heights).expect("one height a cell");
    let terrain = TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Surface { max_slope } };
    let spec = ScenarioSpec { movement, terrain: Some(terrain), ..ScenarioSpec::new(&grid, ends.0, ends.1) };
    Arc::new(Scenario::new(grid, spec).expect("usable"))
}

/// The lower right corner of a map.
pub fn far_corner(grid: &Grid) -> Point {
    Point::new(grid.width() - 1, grid.height() - 1)
}

/// Hills of this size without walls, from corner to corner.
pub fn hilly(width: u32, height: u32, seed: u32, tall: f32, movement: Movement, max_slope: f64) -> Arc<Scenario> {
    let grid = Grid::open(width, height).expect("a size");
    let ends = (Point::new(0, 0), far_corner(&grid));
    surface(grid, hills(width, height, seed, tall), movement, max_slope, ends)
}

/// The heights of a map in which these cells have no data.
pub fn without(mut heights: Vec<f32>, width: u32, missing: &[(u32, u32)]) -> Vec<f32> {
    missing.iter().for_each(|&(x, y)| heights[(y * width + x) as usize] = f32::NAN);
    heights
}

/// Movement by slices over a map with heights.
pub fn slices(grid: Grid, rules: SliceRules, start: (u32, u32), goal: (u32, u32)) -> Arc<Scenario> {
    let (start, goal) = (Point::new(start.0, start.1), Point::new(goal.0, goal.1));
    let terrain = TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Slices(rules) };
    let spec = ScenarioSpec { terrain: Some(terrain), ..ScenarioSpec::new(&grid, start, goal) };
    Arc::new(Scenario::new(grid, spec).expect("usable"))
}

/// 7 levels of 100 units, two aside and two up or down, both ends on level 5, which nothing of [`hills`] 500 units high reaches.
pub fn rules(measure: Measure) -> SliceRules {
    SliceRules { level: 100.0, levels: 7, max_aside: 2, max_climb: 2, start_level: 5, goal_level: 5, measure }
}

/// Hills by slices: from the left edge to the right edge of the map, in the middle row.
pub fn hilly_slices(width: u32, height: u32, seed: u32, rules: SliceRules) -> Arc<Scenario> {
    let grid = Grid::open(width, height).and_then(|g| g.with_heights(hills(width, height, seed, 500.0))).expect("a size");
    slices(grid, rules, (0, height / 2), (width - 1, height / 2))
}

/// 12 × 5, a ridge across the middle, too high for any level, with a gap in the last row: many ways end at it.
pub fn ridge(measure: Measure) -> Arc<Scenario> {
    let height = |x: u32, y: u32| match (x, y) {
        (6, 4) => 50.0,
        (6, _) => 900.0,
        _ => 0.0,
    };
    let heights = (0..5).flat_map(|y| (0..12).map(move |x| height(x, y))).collect();
    let grid = Grid::open(12, 5).and_then(|g| g.with_heights(heights)).expect("a size");
    slices(grid, SliceRules { max_aside: 1, max_climb: 1, start_level: 1, goal_level: 1, ..rules(measure) }, (0, 2), (11, 2))
}

/// Small terrains with a name, under every movement that goes over them: by steps with and without a limit of slope, without data, by
/// steps of two cells on a plane and on a surface, by slices with both measures.
pub fn terrains(movements: &[Movement]) -> Vec<(String, Arc<Scenario>)> {
    let mut all = Vec::new();
    for &movement in movements.iter().chain(&sixteen()) {
        let grid = |walls: &[u8]| Grid::from_bytes(9, 7, walls).expect("9 × 7");
        let ends = (Point::new(0, 3), Point::new(8, 3));
        let walls: Vec<u8> = (0..63).map(|c| u8::from(c % 9 == 4 && c / 9 != 5)).collect();
        let missing = [(3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (5, 6), (5, 5), (5, 4), (5, 3), (5, 2)];
        // A plateau 20 cells above the plain; only the ramp in the last row is not too steep.
        let ramp = |c: u32| if c / 9 == 6 { (c % 9) as f32 * 0.9 } else { 20.0 * f32::from(u8::from(c % 9 > 4)) };
        let mut add = |name: &str, scenario| all.push((format!("{name} with {movement:?}"), scenario));
        add("walls on hills", surface(grid(&walls), hills(9, 7, 3, 6.0), movement, 90.0, ends));
        add("steep hills", surface(grid(&[0; 63]), hills(9, 7, 4, 900.0), movement, 90.0, ends));
        add(
            "a limit of slope",
            surface(grid(&[0; 63]), (0..63).map(ramp).collect(), movement, 45.0, (Point::new(0, 3), Point::new(8, 6))),
        );
        add("no data", surface(grid(&[0; 63]), without(hills(9, 7, 5, 8.0), 9, &missing), movement, 80.0, ends));
        add("random 24 on hills", hilly(24, 24, 6, 12.0, movement, 60.0));
    }
    for measure in [Measure::Cost, Measure::Length] {
        let mut add = |name: &str, scenario| all.push((format!("{name} by slices, {measure:?}"), scenario));
        add("random 24", hilly_slices(24, 12, 7, rules(measure)));
        add("a ridge with a gap", ridge(measure));
        add("one step", hilly_slices(2, 3, 8, rules(measure)));
        add("two steps", hilly_slices(3, 1, 8, rules(measure)));
        let back = Scenario::clone(&hilly_slices(9, 7, 9, rules(measure)));
        let spec = ScenarioSpec {
            start: back.spec.goals[0].at,
            goals: vec![formicarium::scenario::Goal::new(back.spec.start, "")],
            ..back.spec.clone()
        };
        add("leftwards", Arc::new(Scenario::new(back.grid, spec).expect("usable")));
    }
    all
}
