//! Colonies by slices: the textbook's program, and the classics with the cost of slices for the length of a tour.

use std::sync::Arc;

use formicarium::aco::by_slices::cost::{SliceHeuristic, mean_options, straight_cost};
use formicarium::aco::by_slices::textbook::visibility;
use formicarium::catalog;
use formicarium::exact::SliceEstimate;
use formicarium::map::{Grid, Measure, Point, SliceRules, Slices};
use formicarium::params::{Value, Values};
use formicarium::path::audit_slices;
use formicarium::planner::{Granularity, Layer, Planner, Reading};
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

use super::close;

const IDS: [&str; 3] = ["terrain-textbook", "acs-slices", "mmas-slices"];

fn rules(levels: u32, reach: u32, start_level: u32, goal_level: u32) -> SliceRules {
    SliceRules { level: 10.0, levels, max_aside: reach, max_climb: reach, start_level, goal_level, measure: Measure::Cost }
}

/// Flat ground by slices.
fn flat(size: (u32, u32), rules: SliceRules, start: (u32, u32), goal: (u32, u32)) -> Arc<Scenario> {
    let heights = vec![0.0; (size.0 * size.1) as usize];
    let grid = Grid::open(size.0, size.1).and_then(|grid| grid.with_heights(heights)).expect("one a cell");
    let mut spec = ScenarioSpec::new(&grid, Point::new(start.0, start.1), Point::new(goal.0, goal.1));
    spec.terrain = Some(TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Slices(rules) });
    Arc::new(Scenario::new(grid, spec).expect("usable"))
}

/// Four columns with one place each: three steps of √1 + level 1, so every path costs 6.
fn corridor() -> Arc<Scenario> {
    flat((4, 1), rules(1, 0, 1, 1), (0, 0), (3, 0))
}

fn slices(scenario: &Scenario) -> &Slices {
    scenario.slices.as_ref().expect("by slices")
}

fn planner(id: &str, scenario: &Arc<Scenario>, set: &[(&str, &str)], seed: u32) -> Box<dyn Planner> {
    let values: Values = set.iter().map(|&(k, v)| (k.to_string(), Value::parse(v))).collect();
    catalog::build(scenario, id, None, &values, seed).expect("valid parameters")
}

/// The trail of every cell after so many iterations in the corridor.
fn trails(id: &str, set: &[(&str, &str)], iterations: u32) -> Vec<f64> {
    let mut planner = planner(id, &corridor(), set, 1);
    for _ in 0..iterations {
        planner.advance(Granularity::Iteration);
    }
    let mut out = Vec::new();
    assert!(planner.layer(Layer::Trail, &mut out));
    out.into_iter().map(f64::from).collect()
}

#[test]
fn formica_by_hand() {
    // Level 1 all the way: 3 steps of 1 and 3 levels are left; a step that is straight on is no detour.
    let scenario = corridor();
    let (slices, estimate) = (slices(&scenario), SliceEstimate::new(slices(&scenario)));
    let places = [0, 1, 2, 3].map(|x| slices.place(x, 0, 1));
    assert_eq!(places.map(|place| estimate.of(slices, place)), [6.0, 4.0, 2.0, 0.0]);
    let odds = planner("formica-slices", &scenario, &[], 1).moves_from(places[0]);
    assert_eq!((odds.len(), odds[0].heuristic, odds[0].trail), (1, 1.0, 0.5));
    // 0.5·0.9 + 0.1, and the same again; the third iteration without a cheaper path has begun anew at the second.
    let set = [("proof_limit", "0"), ("merge", "false")];
    let trail = |iterations| trails("formica-slices", &set, iterations)[0];
    assert!(close(trail(1), 0.55) && close(trail(2), 0.595) && close(trail(3), 0.5));
}

#[test]
fn a_detour_by_slices_by_hand() {
    // Two steps to go, levels 1 to 3, one row: up at first and down again costs √2 + 2, then √2 + 1; the straight line has 2 + 2 to go.
    let scenario = flat((3, 1), rules(3, 1, 1, 1), (0, 0), (2, 0));
    let (slices, estimate) = (slices(&scenario), SliceEstimate::new(slices(&scenario)));
    let (start, up) = (slices.place(0, 0, 1), slices.place(1, 0, 2));
    let detour = 2f64.sqrt() + 2.0 + (2f64.sqrt() + 1.0) - 4.0;
    let odds = planner("formica-slices", &scenario, &[("kappa", "0.7")], 1).moves_from(start);
    let of_up = odds.iter().find(|odds| odds.to == up).expect("a step up");
    assert!(close(of_up.heuristic, (-0.7 * detour).exp()), "{}", of_up.heuristic);
    // From level 3 on the middle slice the goal is out of reach.
    assert_eq!(estimate.of(slices, slices.place(1, 0, 3)), f64::INFINITY);
}

#[test]
fn textbook_visibility_by_hand() {
    // From row 3, level 2 to row 5, level 4, six columns before the goal in row 2, level 3; a level is 0.2 cells. M = 30/5;
    // d = √(1 + 4 + 0.16), r = √(36 + 9 + 0.04): 6·50/(2.271563 + 6.711185) = 33.39735. By the row before the step r = √(36 + 1 + 0.04).
    let at = |reading| visibility(reading, 0.2, (3.0, 2.0), (5.0, 4.0), 6.0, (2.0, 3.0));
    assert!((at(Reading::Repaired) - 33.39735).abs() < 1e-4, "{}", at(Reading::Repaired));
    assert!((at(Reading::Printed) - 35.89541).abs() < 1e-4, "{}", at(Reading::Printed));
}

#[test]
fn textbook_updates_by_hand() {
    // Two ants take 0.1 each from the place that they enter: 0.81; then 0.8·0.81 + 0.2·100/6 on the places between the ends.
    let repaired = trails("terrain-textbook", &[("ants", "2")], 1);
    assert!(repaired[1..3].iter().all(|&t| close(t, 0.8 * 0.81 + 20.0 / 6.0)), "{repaired:?}");
    // As it runs: stepping into column 1 halves column 2, so that two ants leave 1 and 0.25.
    let printed = trails("terrain-textbook", &[("ants", "2"), ("reading", "printed"), ("local_rho", "0.5")], 1);
    assert!(close(printed[1], 0.8 + 20.0 / 6.0) && close(printed[2], 0.2 + 20.0 / 6.0), "{printed:?}");
    assert!(close(printed[0], 1.0) && close(repaired[0], 1.0), "the ends are left out");
}

#[test]
fn the_straight_way_stands_for_the_nearest_neighbour_tour() {
    // From (0, 3) at level 2 to (7, 2) at level 3: √(49 + 1 + 1), and the levels 2 + i/7 of i = 1 … 7: 14 + 28/7.
    let s = flat((8, 7), rules(6, 2, 2, 3), (0, 3), (7, 2));
    assert!(close(straight_cost(slices(&s)), 51f64.sqrt() + 18.0));
    assert!(close(straight_cost(slices(&corridor())), 6.0));
    let by_length = flat((8, 7), SliceRules { measure: Measure::Length, ..rules(6, 2, 2, 3) }, (0, 3), (7, 2));
    assert!(close(straight_cost(slices(&by_length)), 51f64.sqrt()));
    // A step aside and up from the start: √3 to level 3; six columns, no row and no level are left.
    let (all, to) = (slices(&s), slices(&s).place(1, 2, 3));
    assert!(close(SliceHeuristic::Cost.of(all, all.start(), to), 1.0 / (3f64.sqrt() + 3.0)));
    assert!(close(SliceHeuristic::CostAndDistance.of(all, all.start(), to), 1.0 / (3f64.sqrt() + 3.0 + 6.0)));
}

#[test]
fn options_are_counted_where_there_are_any() {
    assert!(close(mean_options(slices(&corridor())), 1.0));
    // 3 columns, 2 rows, 2 levels, any step of 1: the start has 4, each of the 4 places between leads to the goal alone: 8 steps, 5 places.
    assert!(close(mean_options(slices(&flat((3, 2), rules(2, 1, 1, 1), (0, 0), (2, 0)))), 8.0 / 5.0));
}

#[test]
fn ant_colony_system_by_slices_updates_by_hand() {
    // τ0 = 1/(3·6) = 1/18, which a passing ant leaves as it is; then 0.9/18 + 0.1/6 = 0.0666667 on the best path.
    let one = trails("acs-slices", &[("ants", "1")], 1);
    assert!(one[..3].iter().all(|&t| close(t, 1.0 / 15.0)) && close(one[3], 1.0 / 18.0), "{one:?}");
    // The next ant leaves 0.9/15 + 0.1/18 = 0.0655556, the update 0.9 of it and 0.1/6.
    let two = trails("acs-slices", &[("ants", "1")], 2);
    assert!(two[..3].iter().all(|&t| close(t, 0.9 * (0.06 + 0.1 / 18.0) + 0.1 / 6.0)), "{two:?}");
}

#[test]
fn max_min_ant_system_by_slices_keeps_its_limits() {
    // ρ = 0.5: τ_max = 1/(0.5·6) = 1/3, where the best path stays: 1/6 + 1/6. Elsewhere trails halve, down to
    // τ_min = 1/3·(1 − ³√0.9)/³√0.9 = 0.0119148.
    let set = [("ants", "1"), ("rho", "0.5"), ("p_best", "0.9")];
    for (iterations, rest) in [(1, 1.0 / 6.0), (4, 1.0 / 48.0), (6, 0.011_914_8)] {
        let t = trails("mmas-slices", &set, iterations);
        assert!(t[..3].iter().all(|&t| close(t, 1.0 / 3.0)), "{t:?}");
        assert!((t[3] - rest).abs() < 1e-6, "{iterations}: {t:?}");
    }
    let unlimited = trails("mmas-slices", &[&set[..], &[("limits", "false")]].concat(), 6);
    assert!(close(unlimited[3], 1.0 / 192.0), "{unlimited:?}");
    // After two iterations without a cheaper path all is τ_max again.
    let restarted = trails("mmas-slices", &[&set[..], &[("restart_after", "2")]].concat(), 3);
    assert!(restarted.iter().all(|&t| close(t, 1.0 / 3.0)), "{restarted:?}");
}

#[test]
fn their_paths_are_paths_by_slices_and_cost_what_they_say() {
    // To the right and to the left, on ground that is in the way.
    let height = |c: u32| ((c % 8 * 7 + c / 8 * 5) % 11 * 4) as f32;
    for (start, goal) in [((0, 3), (7, 2)), ((7, 2), (0, 3))] {
        let grid = Grid::open(8, 7).and_then(|g| g.with_heights((0..56).map(height).collect())).expect("one a cell");
        let mut spec = ScenarioSpec::new(&grid, Point::new(start.0, start.1), Point::new(goal.0, goal.1));
        let moves = TerrainMoves::Slices(rules(6, 2, 2, 2));
        spec.terrain = Some(TerrainSpec { vertical_unit: 1.0, moves });
        let s = Arc::new(Scenario::new(grid, spec).expect("usable"));
        for id in IDS {
            let mut planner = planner(id, &s, &[("iterations", "40")], 5);
            planner.run();
            let best = planner.best().unwrap_or_else(|| panic!("{id} found no path"));
            audit_slices(&s, &slices(&s).points(&best.path)).expect("a path");
            assert_eq!(best.length, slices(&s).value(&best.path), "{id}");
        }
    }
}

#[test]
fn the_presets_of_the_textbook_make_other_runs() {
    let s = flat((8, 7), rules(6, 2, 2, 3), (0, 3), (7, 2));
    let run = |preset| {
        let mut planner = catalog::build(&s, "terrain-textbook", preset, &Values::new(), 1).expect("valid parameters");
        planner.run();
        planner.digest().hex()
    };
    let runs = [None, Some("printed"), Some("terrain")].map(run);
    assert!(runs[0] != runs[1] && runs[0] != runs[2] && runs[1] != runs[2], "{runs:?}");
}
