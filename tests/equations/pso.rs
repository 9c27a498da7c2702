//! The particle swarm over places of movement by slices: velocities, clamps and repair by hand. Over cell priorities: `fireworks.rs`.

use std::sync::Arc;

use formicarium::catalog;
use formicarium::map::{Grid, Measure, Movement, Point, SliceRules, Slices};
use formicarium::params::{Value, Values};
use formicarium::planner::{Granularity, Layer, Objective, Planner};
use formicarium::rng::Streams;
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};
use formicarium::swarm::decode::Limits;
use formicarium::swarm::explosion::inertia;
use formicarium::swarm::particle_swarm::{ParticleRows, ParticleSwarm, moved, velocity};
use formicarium::swarm::population::Population;
use formicarium::swarm::search::{Decode, Method};
use formicarium::swarm::slices::{SliceDecoder, clamped, nearest_free, window};

/// By slices over these rows of heights, levels of 10, from the left edge to the right edge in row 0, both ends at level 1.
fn by_slices(rows: &[&[f32]], rules: SliceRules) -> Arc<Scenario> {
    let (width, height) = (rows[0].len() as u32, rows.len() as u32);
    let grid = Grid::open(width, height).and_then(|g| g.with_heights(rows.concat())).expect("a rectangle");
    let terrain = Some(TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Slices(rules) });
    let spec = ScenarioSpec { terrain, ..ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(width - 1, 0)) };
    Arc::new(Scenario::new(grid, spec).expect("usable"))
}

fn rules() -> SliceRules {
    SliceRules { level: 10.0, levels: 4, max_aside: 1, max_climb: 1, start_level: 1, goal_level: 1, measure: Measure::Cost }
}

fn planner(scenario: &Arc<Scenario>, preset: Option<&str>, values: &[(&str, f64)], seed: u32) -> Box<dyn Planner> {
    let values: Values = values.iter().map(|&(k, v)| (k.to_string(), Value::Number(v))).collect();
    catalog::build(scenario, "pso", preset, &values, seed).expect("valid parameters")
}

/// Places as (column, row, level).
fn at(slices: &Slices, path: &[u32]) -> Vec<(u32, u32, u32)> {
    path.iter().map(|&p| slices.at(p)).collect()
}

#[test]
fn velocity_and_position_by_hand() {
    // w = 0.65 halfway from 0.9 to 0.4; v = 2, x = 5, p = 7, g = 4; c1·r1 = 2·0.25, c2·r2 = 2·0.75:
    // 0.65·2 + 0.5·(7 − 5) + 1.5·(4 − 5) = 1.3 + 1 − 1.5 = 0.8.
    let w = inertia(0.9, 0.4, 50, 100);
    let v = velocity(2.0, 5.0, [7.0, 4.0], w, [2.0 * 0.25, 2.0 * 0.75], 20.0);
    assert!((w - 0.65).abs() < 1e-12 && (v - 0.8).abs() < 1e-12);
    assert_eq!(moved(5.0, 0.5, Limits::up_to(20.0)), (5.5, 0.5));
    // v_max = 1 × 3 rows, and the border at row 3.
    assert_eq!(velocity(2.0, 5.0, [30.0, 40.0], 0.9, [2.0, 2.0], 3.0), 3.0);
    let rows = Limits::up_to(3.0);
    assert_eq!((moved(1.0, 3.0, rows), moved(1.0, -3.0, rows)), ((3.0, 0.0), (0.0, 0.0)));
}

#[test]
fn the_constriction_factor_by_hand() {
    // φ = 4.1: χ = 2 / |2 − 4.1 − √(4.1² − 16.4)| = 2 / (2.1 + √0.41) = 2 / 2.7403124 = 0.7298438; 2.05·χ = 1.4961798.
    let phi: f64 = 4.1;
    let chi = 2.0 / (2.0 - phi - (phi * phi - 4.0 * phi).sqrt()).abs();
    let entry = catalog::find("pso").expect("in the catalog");
    let values = entry.presets.iter().find(|p| p.name == "constriction").expect("the preset").values();
    let number = |key: &str| match values.get(key) {
        Some(Value::Number(v)) => *v,
        other => panic!("{key}: {other:?}"),
    };
    assert!((chi - 0.729_843_788).abs() < 1e-9);
    for (key, expected) in [("inertia_start", chi), ("inertia_end", chi), ("cognitive", 2.05 * chi), ("social", 2.05 * chi)] {
        assert!((number(key) - expected).abs() < 1e-5, "{key}");
    }
}

#[test]
fn limits_by_hand() {
    // From row 9 by steps of at most 2, the goal in row 7 with 18 steps left: 7 to 11 of 0 to 20.
    assert_eq!(window(9, 7, 2, 18, 0..=20), 7..=11);
    // One step left: 5 to 9 from the goal, 7 to 11 from here.
    assert_eq!(window(9, 7, 2, 1, 0..=20), 7..=9);
    // None left: the goal itself. At the border; without any movement aside.
    assert_eq!(window(9, 7, 2, 0, 0..=20), 7..=7);
    assert_eq!((window(1, 7, 2, 18, 0..=20), window(20, 7, 2, 18, 0..=20), window(3, 3, 0, 5, 0..=20)), (0..=3, 18..=20, 3..=3));
    assert_eq!([2.0, 8.4, 30.0].map(|x| clamped(x, &(7..=11))), [7.0, 8.4, 11.0]);
}

#[test]
fn the_nearest_free_place_by_hand() {
    // Column 1: level 1 lies above 5 but not above 10, level 2 above 15, nothing above 45.
    let s = by_slices(&[&[0.0, 45.0, 0.0], &[0.0, 15.0, 0.0], &[0.0, 5.0, 0.0]], rules());
    let slices = s.slices.as_ref().expect("slices");
    let nearest = |place, rows, levels| nearest_free(slices, 1, place, &rows, &levels).map(|p| slices.at(p));
    assert_eq!(nearest((1, 3), 0..=2, 1..=4), Some((1, 1, 3)), "it is free");
    assert_eq!(nearest((1, 1), 0..=2, 1..=4), Some((1, 1, 2)), "the level above");
    assert_eq!(nearest((1, 1), 0..=2, 1..=1), Some((1, 2, 1)), "not within the limits: the next row");
    assert_eq!(nearest((0, 1), 0..=2, 1..=4), Some((1, 1, 2)), "nothing in row 0");
    assert_eq!((nearest((0, 1), 0..=0, 1..=4), nearest((0, 1), 0..=1, 1..=1)), (None, None));
    // Of two rows equally near, the lower number.
    let ridge = by_slices(&[&[0.0, 5.0, 0.0], &[0.0, 45.0, 0.0], &[0.0, 5.0, 0.0]], rules());
    let slices = ridge.slices.as_ref().expect("slices");
    assert_eq!(nearest_free(slices, 1, (1, 2), &(0..=2), &(1..=4)).map(|p| slices.at(p)), Some((1, 0, 2)));
}

#[test]
fn a_position_is_clamped_rounded_and_repaired_column_by_column() {
    // Five columns, three rows; in column 2 row 1 is high ground.
    let s = by_slices(&[&[0.0; 5], &[0.0, 0.0, 25.0, 0.0, 0.0], &[0.0; 5]], rules());
    let slices = s.slices.as_ref().expect("slices");
    let mut decoder = SliceDecoder::of(Arc::clone(slices));
    assert_eq!((decoder.dimensions(), SliceDecoder::ranges(slices, &s)), (6, [2.0, 3.0]));
    // Rows and levels from 0. Column 1: (1.4, 2.2) is clamped to row 1, level 1 (the second): (1, 1, 2). Column 2: row 0.6 is 1, level 0 is
    // the first, inside ground of 25, which leaves levels 3 and 4; 3 is in reach of 2 and of the goal in two steps. Column 3: row 2 is too
    // far from the goal, so 1; from level 3 down to 2.
    let mut position = [1.4, 2.2, 0.6, 0.0, 2.0, 0.1];
    let cost = decoder.decode(&s, &mut position).expect("a path");
    assert_eq!(at(slices, decoder.path()), [(0, 0, 1), (1, 1, 2), (2, 1, 3), (3, 1, 2), (4, 0, 1)]);
    assert_eq!((position, decoder.moves()), ([1.0, 1.0, 1.0, 2.0, 1.0, 1.0], 4));
    // √3 + 2, √2 + 3, √2 + 2, √3 + 1.
    assert!((cost - (2.0 * 3f64.sqrt() + 2.0 * 2f64.sqrt() + 8.0)).abs() < 1e-12);
    // What is clamped is not rounded: the particle keeps its place between two rows.
    let mut between = [0.3, 0.4, 0.2, 0.0, 0.49, 0.9];
    decoder.decode(&s, &mut between).expect("a path");
    assert_eq!(between, [0.3, 0.4, 0.2, 0.0, 0.49, 0.9]);
    assert_eq!(at(slices, decoder.path()), [(0, 0, 1), (1, 0, 1), (2, 0, 1), (3, 0, 2), (4, 0, 1)]);
    // On the map: its level at each column's row.
    let mut field = vec![0.0; 15];
    decoder.draw(&s, &between, &mut field);
    assert_eq!(field, [0.0, 1.0, 1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn a_particle_that_no_free_place_is_in_reach_of_is_lost() {
    // Column 2 is free in row 2 alone: from row 0 of column 1 it is out of reach.
    let s = by_slices(&[&[0.0, 0.0, 90.0, 0.0, 0.0], &[0.0, 0.0, 90.0, 0.0, 0.0], &[0.0; 5]], rules());
    let slices = s.slices.as_ref().expect("slices");
    let mut decoder = SliceDecoder::of(Arc::clone(slices));
    assert_eq!(decoder.decode(&s, &mut [0.0; 6]), None);
    assert_eq!((at(slices, decoder.path()), decoder.moves(), decoder.lost()), (vec![(0, 0, 1), (1, 0, 1)], 1, f64::INFINITY));
    assert!(decoder.decode(&s, &mut [1.0, 0.0, 2.0, 0.0, 1.0, 0.0]).is_some());
    // Counted as a constructed path that has not arrived; the others go on.
    let mut p = planner(&s, None, &[("particles", 20.0), ("iterations", 30.0)], 3);
    p.advance(Granularity::Iteration);
    let first = p.history()[0];
    assert_eq!(p.effort().constructed_paths, 20);
    assert!((1..20).contains(&first.arrived), "{first:?}");
    p.run();
    let last = p.history()[29];
    assert!(last.arrived > first.arrived, "they are drawn to where there is a way: {first:?}, {last:?}");
}

#[test]
fn an_iteration_of_particles_by_hand() {
    // One particle over two ranges: at rest first, then w·0 + c1·r1·(p − x) + c2·r2·(g − x) = 0, because it is its own best.
    let rows = ParticleRows { particles: 1, ..ParticleRows::default() };
    let mut method = ParticleSwarm::within([2.0, 30.0].map(Limits::up_to), rows, 10, 0);
    let (mut all, streams) = (Population::new(4), Streams::new(1, "test", 0));
    assert!(method.propose(&mut all, 1, streams));
    let begun = all.position(0).to_vec();
    assert!(begun.iter().zip([2.0, 30.0, 2.0, 30.0]).all(|(x, range)| (0.0..=range).contains(x)) && begun[1].max(begun[3]) > 2.0);
    // What decoding puts right is what it remembers.
    all.position_mut(0).copy_from_slice(&[1.0, 2.0, 2.0, 29.0]);
    all.note(7.0);
    assert!(!method.propose(&mut all, 1, streams));
    assert!(method.propose(&mut all, 2, streams));
    assert_eq!(all.position(0), [1.0, 2.0, 2.0, 29.0]);
    // A worse position is not remembered: it is drawn back, each dimension by c1·r1 + c2·r2 of the way, 0 to 4.
    all.position_mut(0).copy_from_slice(&[1.5, 2.0, 2.0, 20.0]);
    all.note(f64::INFINITY);
    assert!(!method.propose(&mut all, 2, streams));
    assert!(method.propose(&mut all, 3, streams));
    let drawn = all.position(0);
    assert!(drawn[0] <= 1.5 && drawn[1] == 2.0 && drawn[2] == 2.0 && drawn[3] >= 20.0, "{drawn:?}");
}

#[test]
fn by_slices_and_from_cell_to_cell_it_improves_on_its_first_iteration() {
    let wave = |c: u32| if c == 14 { 0.0 } else { ((c % 15 * 7 + c / 15 * 5) % 11) as f32 * 3.0 };
    let wavy: Vec<f32> = (0..15 * 9u32).map(wave).collect();
    let rows: Vec<&[f32]> = wavy.chunks(15).collect();
    for measure in [Measure::Cost, Measure::Length] {
        let s = by_slices(&rows, SliceRules { max_aside: 2, max_climb: 2, measure, ..rules() });
        for seed in 1..=5 {
            let mut p = planner(&s, Some("terrain"), &[], seed);
            p.run();
            let best: Vec<f64> = p.history().iter().filter_map(|r| r.best_so_far).collect();
            assert!(best[best.len() - 1] < best[0] && p.objective() == Objective::SliceCost, "seed {seed}: {best:?}");
            assert_eq!((p.effort().iterations, p.effort().constructed_paths), (100, 5000));
        }
    }
}

#[test]
fn the_first_stage_of_pso_aco_is_its_run() {
    let s = super::fireworks::map(4);
    let mut alone = planner(&s, None, &[], 9);
    alone.run();
    let mut both = catalog::build(&s, "pso-aco", None, &Values::new(), 9).expect("usable");
    for _ in 0..50 {
        both.advance(Granularity::Iteration);
    }
    assert_eq!((both.history(), both.best(), both.effort()), (alone.history(), alone.best(), alone.effort()));
}

#[test]
fn one_step_by_slices_needs_no_number() {
    let s = by_slices(&[&[0.0, 0.0], &[0.0, 0.0]], rules());
    let mut p = planner(&s, None, &[("iterations", 2.0)], 1);
    p.run();
    assert_eq!(p.best().map(|b| b.length), Some(1.0 + 1.0));
    let mut field = Vec::new();
    assert!(p.layer(Layer::Priority, &mut field) && field == [0.0; 4]);
}

#[test]
fn cells_may_have_16_moves_and_heights() {
    let heights: Vec<f32> = (0..100u32).map(|c| (c * 37 % 23) as f32 * 0.1).collect();
    let grid = Grid::open(10, 10).and_then(|g| g.with_heights(heights)).expect("10 × 10");
    let movement = Movement { moves: formicarium::map::Moves::Sixteen, ..Movement::default() };
    let s = Arc::new(Scenario::on(grid, movement, Point::new(0, 0), Point::new(9, 5)).expect("usable"));
    let far = (1..=20).any(|seed| {
        let mut p = planner(&s, None, &[], seed);
        p.run();
        let path = &p.best().expect("a path").path;
        path.windows(2).any(|step| s.moves.direction(step[0], step[1]) >= 8)
    });
    assert!(far, "some best path has a step of two cells");
}
