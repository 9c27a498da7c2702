//! Properties of steps over arbitrary ground, and what ants that walk there measure.
#![cfg(not(target_arch = "wasm32"))]

use std::sync::Arc;

use formicarium::aco::ant::{Ant, Walk};
use formicarium::aco::dead_end::DeadEnd;
use formicarium::map::{ALL_DIRECTIONS, CornerRule, DIRECTIONS, Grid, Movement, Moves, Point, offset, opposite};
use formicarium::metrics::Metrics;
use formicarium::planner::Fate;
use formicarium::rng::{Streams, unit_f32};
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};
use proptest::prelude::*;
use rand::Rng;

/// Any surface up to 12 × 12: walls, cells without data, gentle or steep, any limit of slope, any movement.
fn surface() -> impl Strategy<Value = Arc<Scenario>> {
    let movement = prop_oneof![Just(Moves::Four), Just(Moves::Eight), Just(Moves::Sixteen)].prop_flat_map(|moves| {
        proptest::sample::select(&CornerRule::ALL[..]).prop_map(move |corner_rule| Movement { moves, corner_rule })
    });
    let slope = prop_oneof![Just(90.0), 20.0..89.0];
    (2u32..13, 2u32..13, movement, slope, 0.1f32..300.0).prop_flat_map(|(width, height, movement, max_slope, tall)| {
        let heights = proptest::collection::vec((0f32..1.0, 0u32..100), (width * height) as usize);
        heights.prop_map(move |cells| {
            let last = cells.len() - 1;
            let end = |c: usize| c == 0 || c == last;
            let walls: Vec<u8> = cells.iter().enumerate().map(|(c, v)| u8::from(v.1 < 20 && !end(c))).collect();
            let no_data = |(c, v): (usize, &(f32, u32))| if v.1 >= 95 && !end(c) { f32::NAN } else { v.0 * tall };
            let heights = cells.iter().enumerate().map(no_data).collect();
            let grid = Grid::from_bytes(width, height, &walls).and_then(|g| g.with_heights(heights)).expect("a size");
            let terrain = Some(TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Surface { max_slope } });
            let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(width - 1, height - 1));
            Arc::new(Scenario::new(grid, ScenarioSpec { movement, terrain, ..spec }).expect("usable"))
        })
    })
}

/// A walk at random: any step to a cell that it has not visited.
fn wander(s: &Scenario, dead_end: DeadEnd, seed: u32, mut check: impl FnMut(&Ant, &[u32])) -> Ant {
    let walk = Walk { moves: &s.moves, goal: s.goal, dead_end, max_moves: 4000 };
    let streams = Streams::new(u64::from(seed), "test", 0);
    let mut ant = Ant::new(s.grid.width(), s.grid.height(), streams.ant(0, 0));
    ant.begin(s.grid.width(), s.start, streams.ant(0, 0));
    while ant.fate() == Fate::Walking {
        let visited = ant.visited();
        let open: Vec<u8> = s.moves.directions(ant.cell()).filter(|&d| visited >> d & 1 == 0).collect();
        let draw = unit_f32(ant.stream.next_u32());
        let step = open.get((draw * open.len() as f32) as usize).copied();
        ant.go(&walk, step);
        let mut way = vec![s.start];
        ant.steps().iter().for_each(|&d| way.push(s.moves.step(way[way.len() - 1], d)));
        check(&ant, &way);
    }
    ant
}

proptest! {
    #[test]
    fn steps_are_as_long_and_as_steep_both_ways(s in surface()) {
        let relief = s.moves.relief().expect("a surface");
        for a in 0..s.grid.len() as u32 {
            for d in s.moves.directions(a) {
                let b = s.moves.step(a, d);
                prop_assert!(s.moves.directions(b).any(|back| back == opposite(d)), "{a} to {b}, but not back");
                let (there, back) = (s.moves.length(a, d), s.moves.length(b, opposite(d)));
                prop_assert!((there - back).abs() <= 1e-12 * there, "{there} and {back}");
                let (up, down) = (relief.step(a, b, d), relief.step(b, a, opposite(d)));
                prop_assert!((up.climb - down.descent).abs() <= 1e-9 && (up.descent - down.climb).abs() <= 1e-9);
                prop_assert!((up.steepness - down.steepness).abs() <= 1e-9 * up.steepness.max(1.0));
                // At least the straight line between its ends, and a step is the segment between its cells.
                let (dx, dy) = offset(d);
                let rise = relief.height(b) - relief.height(a);
                prop_assert!(there >= (f64::from(dx * dx + dy * dy) + rise * rise).sqrt() * (1.0 - 1e-12));
                prop_assert_eq!(there, relief.segment(a, b).length);
                prop_assert!((up.climb - up.descent - rise).abs() <= 1e-9 * rise.abs().max(1.0));
            }
        }
    }

    #[test]
    fn steps_lead_over_free_cells_that_are_not_too_steep(s in surface()) {
        let relief = s.moves.relief().expect("a surface");
        let steepest = match s.spec.terrain.expect("a terrain").moves {
            TerrainMoves::Surface { max_slope } if max_slope < 90.0 => max_slope.to_radians().tan(),
            _ => f64::INFINITY,
        };
        let free = |x: i32, y: i32| s.grid.is_free_at(i64::from(x), i64::from(y));
        for a in 0..s.grid.len() as u32 {
            let p = s.grid.point(a);
            let (x, y) = (p.x as i32, p.y as i32);
            for d in 0..ALL_DIRECTIONS as u8 {
                let (dx, dy) = offset(d);
                let on_map = s.spec.movement.allows(&s.grid, i64::from(x), i64::from(y), d) && !s.grid.is_blocked(a);
                let allowed = s.moves.all_bits(a) >> d & 1 == 1;
                let gentle = || relief.step(a, s.moves.step(a, d), d).steepness <= steepest * (1.0 + 1e-12);
                prop_assert_eq!(allowed, on_map && gentle(), "{:?} direction {}", p, d);
                if allowed && d as usize >= DIRECTIONS {
                    prop_assert!(s.spec.movement.moves == Moves::Sixteen);
                    // Every cell whose inside the straight way comes through, at a thousand places.
                    for k in 0..=1000 {
                        let t = f64::from(k) / 1000.0;
                        let at = (f64::from(x) + t * f64::from(dx), f64::from(y) + t * f64::from(dy));
                        prop_assert!(free((at.0 + 0.5).floor() as i32, (at.1 + 0.5).floor() as i32), "{:?} direction {}", p, d);
                    }
                }
            }
        }
    }

    #[test]
    fn what_an_ant_has_walked_is_the_length_of_its_path(s in surface(), seed: u32, die: bool) {
        prop_assume!(s.spec.movement.moves != Moves::Sixteen);
        let dead_end = if die { DeadEnd::Die } else { DeadEnd::Backtrack };
        let mut worst = 0.0f64;
        let ant = wander(&s, dead_end, seed, |ant, way| {
            let length = s.path_length(way);
            worst = worst.max((ant.walked() - length).abs() / length.max(1.0));
        });
        prop_assert!(worst < 1e-9, "off by {worst} on the way");
        let mut way = vec![s.start];
        ant.steps().iter().for_each(|&d| way.push(s.moves.step(way[way.len() - 1], d)));
        // Once arrived, bit for bit.
        prop_assert_eq!(ant.length(), (ant.fate() == Fate::Arrived).then(|| s.path_length(&way)));
        prop_assert_eq!(ant.fate() == Fate::Arrived, way.last() == Some(&s.goal));
    }

    #[test]
    fn what_a_path_climbs_and_descends_is_the_difference_of_its_ends(s in surface(), seed: u32) {
        prop_assume!(s.spec.movement.moves != Moves::Sixteen);
        let ant = wander(&s, DeadEnd::Backtrack, seed, |_, _| ());
        let mut way = vec![s.start];
        ant.steps().iter().for_each(|&d| way.push(s.moves.step(way[way.len() - 1], d)));
        let metrics = Metrics::of(&s, &way);
        let (terrain, heights) = (metrics.terrain.expect("a terrain"), s.altitudes(&way));
        let rise = heights[heights.len() - 1] - heights[0];
        prop_assert!((terrain.climb - terrain.descent - rise).abs() <= 1e-9 * terrain.climb.max(1.0));
        prop_assert!(metrics.length >= way.len() as f64 - 1.0 && terrain.level_cost.is_none());
        if let TerrainMoves::Surface { max_slope } = s.spec.terrain.expect("a terrain").moves {
            prop_assert!(terrain.steepest <= max_slope + 1e-9);
        }
    }
}
