//! Elitist potential-field ACO in three dimensions (Hans Publishers, article 41567).

mod colony;

use std::sync::Arc;

use formicarium::aco::terrain::field::{Field, Gains, LEAST, along, attraction, distance, first_trail, repulsion};
use formicarium::aco::terrain::params::{BasicParams, EpfParams, Initial};
use formicarium::aco::terrain::sight::{Eyes, Heuristic, Sight, force_factor, force_weight, visibility};
use formicarium::aco::terrain::space::{Directions, Layered, Place, Space, Surface};
use formicarium::aco::terrain::trails::{PlaceTrails, elite_count, elite_weight};
use formicarium::aco::terrain::walk::{Walker, alone, join, select, weigh};
use formicarium::catalog;
use formicarium::map::{CornerRule, Grid, Measure, Movement, Moves, Point, SliceRules, Way};
use formicarium::params::{Value, Values};
use formicarium::path::{PathKind, audit, audit_slices, points};
use formicarium::planner::Reading;
use formicarium::planner::{Layer, Planner};
use formicarium::rng::Streams;
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

const RULES: SliceRules =
    SliceRules { level: 10.0, levels: 6, max_aside: 2, max_climb: 2, start_level: 2, goal_level: 3, measure: Measure::Cost };

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * b.abs().max(1.0)
}

fn on(grid: Grid, moves: Option<TerrainMoves>, steps: Moves, start: (u32, u32), goal: (u32, u32)) -> Arc<Scenario> {
    let mut spec = ScenarioSpec::new(&grid, Point::new(start.0, start.1), Point::new(goal.0, goal.1));
    spec.terrain = moves.map(|moves| TerrainSpec { vertical_unit: 1.0, moves });
    spec.movement = Movement { moves: steps, corner_rule: CornerRule::BothFree };
    Arc::new(Scenario::new(grid, spec).expect("usable"))
}

/// 8 × 7 cells; the ground rises and falls between 0 and 44 m by whole-number arithmetic.
fn hills() -> Grid {
    let height = |c: u32| ((c % 8 * 7 + c / 8 * 5) % 11 * 4) as f32;
    Grid::open(8, 7).expect("a usable size").with_heights((0..56).map(height).collect()).expect("one a cell")
}

/// From (0, 3) at level 2 to (7, 2) at level 3, levels of 10 m.
fn by_slices() -> Arc<Scenario> {
    on(hills(), Some(TerrainMoves::Slices(RULES)), Moves::Eight, (0, 3), (7, 2))
}

fn on_surface(steps: Moves) -> Arc<Scenario> {
    let grid = hills();
    let mut scenario = on(grid, Some(TerrainMoves::Surface { max_slope: 90.0 }), steps, (0, 3), (7, 2)).as_ref().clone();
    scenario.spec.resolution = 10.0;
    Arc::new(Scenario::new(scenario.grid, scenario.spec).expect("usable"))
}

/// One row of open cells, from the first to the last.
fn corridor(cells: u32) -> Arc<Scenario> {
    on(Grid::open(cells, 1).expect("a usable size"), None, Moves::Eight, (0, 0), (cells - 1, 0))
}

fn layered(scenario: &Arc<Scenario>) -> Layered {
    Layered::new(Arc::clone(scenario), Arc::clone(scenario.slices.as_ref().expect("by slices")))
}

fn values(set: &[(&str, &str)]) -> Values {
    set.iter().map(|&(k, v)| (k.to_string(), Value::parse(v))).collect()
}

fn planner(id: &str, scenario: &Arc<Scenario>, set: &[(&str, &str)], seed: u32) -> Box<dyn Planner> {
    catalog::build(scenario, id, None, &values(set), seed).expect("valid parameters")
}

/// One iteration; the trail of every cell.
fn trails_after_one(id: &str, scenario: &Arc<Scenario>, set: &[(&str, &str)]) -> Vec<f64> {
    let mut planner = planner(id, scenario, set, 1);
    planner.advance(formicarium::planner::Granularity::Iteration);
    let mut out = Vec::new();
    assert!(planner.layer(Layer::Trail, &mut out));
    out.into_iter().map(f64::from).collect()
}

#[test]
fn eq_1_weights_are_the_place_s_trail_and_the_step_s_visibility() {
    let streams = Streams::new(1, "test", 0);
    let mut ant = Walker::new(9, streams.ant(0, 0));
    ant.begin(3, streams.ant(1, 0));
    ant.step(4);
    let trails = PlaceTrails::new((0..9).map(|place| 0.5 * f64::from(place)));
    // Steps from 4 to 3, which is tabu, to 5, to 7, to 8, which is infeasible, and to 1.
    let (deltas, seen) = ([-1, 1, 3, 4, -3], [1.0, 0.25, 0.5, 0.0, 1.0]);
    for (alpha, expected) in
        [(1.0, [0.0, 0.25 * 2.5 / 3.5, 0.5, 0.0, 0.5 / 3.5]), (2.0, [0.0, 0.25 * 25.0 / 49.0, 0.5, 0.0, 1.0 / 49.0])]
    {
        let mut weights = [9.0f32; 5];
        weigh(&ant, &seen, &deltas, &trails, alpha, &mut weights);
        assert!(weights.iter().zip(expected).all(|(&w, e)| close(f64::from(w), e)), "{weights:?}");
    }
}

#[test]
fn eq_1_the_selection_threshold_takes_the_first_of_the_best() {
    let fresh = || Streams::new(3, "test", 0).ant(0, 0);
    let (weights, mut stream, mut counts) = ([0.0, 1.0, 0.0, 2.0, 2.0], fresh(), [0u32; 5]);
    assert_eq!(select(&[0.0; 5], 0.8, &mut stream), None);
    assert_eq!(select(&weights, 1.0, &mut stream), Some(3));
    for _ in 0..50_000 {
        counts[select(&weights, 0.8, &mut stream).expect("a step")] += 1;
    }
    // 40,000 to step 3; the rest 1 : 2 : 2.
    for (k, expected) in [(0, 0.0), (1, 2_000.0), (2, 0.0), (3, 44_000.0), (4, 4_000.0)] {
        assert!((f64::from(counts[k]) - expected).abs() <= 3.5 * f64::sqrt(expected), "step {k}: {}", counts[k]);
    }
}

#[test]
fn eq_2_the_distance_in_three_readings() {
    assert_eq!(visibility(Heuristic::Step, 3.0, 5.0), 1.0 / 3.0);
    assert_eq!(visibility(Heuristic::Goal, 3.0, 5.0), 0.2);
    assert_eq!(visibility(Heuristic::Both, 3.0, 5.0), 0.125);
    assert_eq!(visibility(Heuristic::Goal, 3.0, 0.0), 100.0, "at the goal 0.01 stands for 0");
    // By slices, to (1, 5) at level 4 from (0, 3) at level 2: √(1 + 4 + 4) = 3, and √(36 + 9 + 1) to (7, 2) at level 3.
    let s = by_slices();
    let (space, slices) = (layered(&s), s.slices.as_ref().expect("by slices"));
    let to = slices.place(1, 5, 4);
    let k = (0..space.steps()).find(|&k| slices.offset(k) == (2, 2)).expect("a step");
    assert_eq!(space.length(slices.start(), to, k), 3.0);
    assert!(close(distance(space.position(to), space.position(slices.goal())), 46f64.sqrt()));
}

#[test]
fn eq_3_and_4_trails_fade_evaporate_and_grow() {
    let mut trails = PlaceTrails::new([1.0, 1.0, 2.0].into_iter());
    trails.fade(1, 0.1);
    trails.evaporate(0.2);
    trails.deposit(&[0, 1], 0.5);
    trails.fade(1, 0.1);
    assert!([0.8 + 0.5, (0.72 + 0.5) * 0.9, 1.6].iter().zip(0..).all(|(&t, place)| close(trails.get(place), t)));
    for lambda in [0.0, 0.5, 1.0] {
        for _ in 0..3000 {
            trails.evaporate(lambda);
            trails.fade(2, lambda);
            trails.deposit(&[0], 1.0);
        }
        assert!((0..3).all(|place| trails.get(place) > 0.0 && trails.get(place).is_finite()), "{lambda}");
    }
}

#[test]
fn eq_3_as_ant_colony_system_has_it_blends_tau_0_in() {
    // 0.9·1 + 0.1·0.01 = 0.901; ·0.8 = 0.7208; 0.9·0.7208 + 0.001 = 0.64972, and a trail of τ0 stays.
    let mut trails = PlaceTrails::new([1.0, 0.01].into_iter());
    (0..2).for_each(|place| trails.blend(place, 0.1, 0.01));
    assert!(close(trails.get(0), 0.901) && close(trails.get(1), 0.01));
    trails.evaporate(0.2);
    trails.blend(0, 0.1, 0.01);
    assert!(close(trails.get(0), 0.64972), "{}", trails.get(0));
    // Four ants on one step, τ0 = 1: nothing changes locally at first, 0.8 + 4 = 4.8. Then four times 0.9·τ + 0.1: 3.49318, and
    // 0.8·3.49318 + 4 = 6.794544; on the origin, where no ant steps, 0.8·4.8 + 4 = 7.84.
    let mut planner = planner("terrain-aco", &corridor(2), &[("ants", "4"), ("iterations", "3"), ("local_rule", "acs")], 1);
    for expected in [[4.8, 4.8], [7.84, 6.794544]] {
        planner.advance(formicarium::planner::Granularity::Iteration);
        let mut trails = Vec::new();
        assert!(planner.layer(Layer::Trail, &mut trails));
        assert!(trails.iter().zip(expected).all(|(&t, e)| close(f64::from(t), e)), "{trails:?}");
    }
}

#[test]
fn eq_2_a_level_counts_as_many_cells_as_it_is_told() {
    let s = by_slices();
    let (flat, slices) = (layered(&s).seen_as(Directions::All, 0.2), s.slices.as_ref().expect("by slices"));
    let (to, goal) = (slices.place(1, 4, 4), slices.goal());
    let k = (0..flat.steps()).find(|&k| slices.offset(k) == (1, 2)).expect("a step");
    // Two levels are 0.4 cells: √(1 + 1 + 0.16) = √2.16, and one level less √(36 + 4 + 0.04) to the goal.
    assert!(close(flat.length(slices.start(), to, k), 2.16f64.sqrt()));
    assert!(close(distance(flat.seen_at(to), flat.seen_at(goal)), 40.04f64.sqrt()));
    let eyes = Eyes { way: Way::Forward, heuristic: Heuristic::Both, beta: 1.0, force: None };
    let eta =
        eyes.eta(&flat, slices.start(), 1.0, |place| eyes.left(&flat, place)).find(|&(end, _)| end == to).expect("a step").1;
    assert!(close(eta, 1.0 / (2.16f64.sqrt() + 40.04f64.sqrt())));
    // The field does not change, and with one cell a level nothing does.
    let field = |space: &Layered| Field::new(space, Way::Forward, gains(Reading::Repaired)).trail(space, to);
    assert_eq!(field(&flat), field(&layered(&s)));
    // In a field of its own measure (3, 2, 5) is (4, 0, −0.4) from the goal, √16.16 of d0 = √(49 + 1 + 0.04); heights push as ever.
    let low = layered(&s).field_by(0.2);
    let [near, all] = [16.16f64.sqrt(), 50.04f64.sqrt()];
    let push = 2.0 * (1.0 / 1.4 - 0.5) / 1.96 * 0.75;
    let field = Field::new(&low, Way::Forward, gains(Reading::Repaired));
    assert!(close(field.trail(&low, slices.place(3, 2, 5)), 3.0 * all / (all + near) - push));
    let run = |set: &[(&str, &str)]| {
        let mut planner = planner("terrain-epf", &s, set, 3);
        planner.run();
        planner.digest().hex()
    };
    assert_eq!(run(&[("level_height", "1")]), run(&[]));
    assert_ne!(run(&[("level_height", "0.2")]), run(&[]));
    assert_ne!(run(&[("field_level_height", "0.2")]), run(&[]));
}

#[test]
fn section_4_4_with_eight_directions_ants_step_to_neighbours_alone() {
    let s = by_slices();
    let (space, slices) = (layered(&s).seen_as(Directions::Eight, 1.0), s.slices.as_ref().expect("by slices"));
    let rows = |space: &Layered| -> Vec<i64> {
        let ends = (0..space.steps()).filter_map(|k| space.step(slices.place(2, 3, 6), k, Way::Forward));
        let mut rows: Vec<i64> = ends.map(|to| i64::from(slices.at(to).1) - 3).collect();
        rows.dedup();
        rows
    };
    assert_eq!((rows(&space), rows(&layered(&s))), (vec![-1, 0, 1], vec![-2, -1, 0, 1, 2]));
    let surface = Surface::new(on_surface(Moves::Sixteen)).only(Directions::Eight);
    assert_eq!((surface.steps(), Surface::new(on_surface(Moves::Sixteen)).steps()), (8, 16));
    check_steps(&space);
    check_steps(&surface);
    // On a map with eight moves there is nothing to leave out; with 16 moves the path of eight is one of a scenario with eight.
    let path = |scenario: &Arc<Scenario>, directions| {
        let mut planner = planner("terrain-aco", scenario, &[("iterations", "5"), ("directions", directions)], 1);
        planner.run();
        planner.digest().hex()
    };
    assert_eq!(path(&on_surface(Moves::Eight), "eight"), path(&on_surface(Moves::Eight), "all"));
    assert_eq!(path(&on_surface(Moves::Sixteen), "eight"), path(&on_surface(Moves::Eight), "all"));
}

#[test]
fn eq_3_and_4_one_iteration_of_four_ants_on_one_step() {
    // Four ants step onto the goal: 0.9^4 = 0.6561, 0.8 of it stays, and each leaves 1/1 on both places.
    let set = [("ants", "4"), ("iterations", "2")];
    let trails = trails_after_one("terrain-aco", &corridor(2), &set);
    assert!(close(trails[0], 0.8 + 4.0) && close(trails[1], 0.8 * 0.6561 + 4.0), "{trails:?}");
}

fn gains(reading: Reading) -> Gains {
    Gains { reading, attraction: 1.5, repulsion: 2.0, range: 2.0 }
}

#[test]
fn eq_6_the_pull_at_the_start_is_k_in_both_readings() {
    let at = |reading, distance| attraction(&gains(reading), distance, 20.0);
    // k·d/d0: 1.5·4/20; 2k·d0/(d0 + d): 3·20/24, at the goal 2k.
    assert!(close(at(Reading::Printed, 4.0), 0.3) && close(at(Reading::Repaired, 4.0), 2.5));
    assert!(close(at(Reading::Printed, 20.0), 1.5) && close(at(Reading::Repaired, 20.0), 1.5));
    assert!(close(at(Reading::Printed, 0.0), 0.0) && close(at(Reading::Repaired, 0.0), 3.0));
}

#[test]
fn eq_13_heights_push_near_the_ground_and_above_the_start() {
    let at = |reading, clearance, rise| repulsion(&gains(reading), clearance, rise);
    for reading in [Reading::Printed, Reading::Repaired] {
        // θ·(1/ρ − 1/ρ0)/ρ²·rise: 2·0.5·1·0.5, and with ρ = 1.25 2·0.3·0.64·0.5; at ρ0 nothing.
        assert!(close(at(reading, 1.0, 0.5), 0.5) && close(at(reading, 1.25, 0.5), 0.192));
        assert_eq!(at(reading, 2.0, 0.5), 0.0);
    }
    // Beyond ρ0 or below z0 only the printed "or" acts: 2·(1/3 − 1/2)/9·0.5, and 2·0.5·(−0.5).
    assert_eq!([at(Reading::Repaired, 3.0, 0.5), at(Reading::Repaired, 1.0, -0.5)], [0.0, 0.0]);
    assert!(close(at(Reading::Printed, 3.0, 0.5), -1.0 / 54.0) && close(at(Reading::Printed, 1.0, -0.5), -0.5));
    assert_eq!(at(Reading::Printed, 3.0, -0.5), 0.0);
}

#[test]
fn eq_9_and_14_first_trails_are_the_pull_less_the_push_and_stay_positive() {
    assert!(close(first_trail(1.5, 0.5), 1.0) && close(first_trail(0.3, -0.5), 0.8));
    assert_eq!([first_trail(0.3, 0.5), first_trail(0.0, 0.0), first_trail(f64::NAN, 0.0)], [LEAST; 3]);
    let s = by_slices();
    let (space, slices) = (layered(&s), s.slices.as_ref().expect("by slices"));
    let field = Field::new(&space, Way::Forward, gains(Reading::Repaired));
    // (3, 2) at level 6: the ground is (21 + 10) % 11·4 = 36 m, ρ = 6 − 3.6 = 2.4 > ρ0: the pull alone. d0 = √(49 + 1 + 1),
    // d = √(16 + 0 + 9) = 5.
    let d0 = 51f64.sqrt();
    assert!(close(field.trail(&space, slices.place(3, 2, 6)), 3.0 * d0 / (d0 + 5.0)));
    // At level 5, ρ = 1.4, z − z0 = 3 of 4: 2·(1/1.4 − 0.5)/1.96·0.75 = 0.163994; d = √(16 + 4).
    let push = 2.0 * (1.0 / 1.4 - 0.5) / 1.96 * 0.75;
    assert!(close(push, 0.1639942));
    assert!(close(field.trail(&space, slices.place(3, 2, 5)), 3.0 * d0 / (d0 + 20f64.sqrt()) - push));
    // F_tot there: the pull towards (4, 0, −2)/√20, and the push straight down.
    let pull = 3.0 * d0 / (d0 + 20f64.sqrt());
    let expected = [pull * 4.0 / 20f64.sqrt(), 0.0, pull * -2.0 / 20f64.sqrt() - push];
    let force = field.force(&space, slices.place(3, 2, 5));
    assert!(force.iter().zip(expected).all(|(&f, e)| close(f, e)), "{force:?}");
    // Backwards, (0, 3) at level 2 attracts and z0 = 3: at level 5 two of three.
    let back = Field::new(&space, Way::Backward, gains(Reading::Repaired));
    let push = 2.0 * (1.0 / 1.4 - 0.5) / 1.96 * (2.0 / 3.0);
    assert!(close(back.trail(&space, slices.place(3, 2, 5)), 3.0 * d0 / (d0 + 19f64.sqrt()) - push));
}

#[test]
fn eq_14_on_a_surface_the_ground_is_at_hand_everywhere() {
    let s = on_surface(Moves::Sixteen);
    let (space, field) =
        (Surface::new(Arc::clone(&s)), Field::new(&Surface::new(Arc::clone(&s)), Way::Forward, gains(Reading::Repaired)));
    // Start (0, 3): 15 % 11·4 = 16 m = 1.6 cells; goal (7, 2): 59 % 11·4 = 16 m; the highest ground 40 m = 4 cells: 2.4 above the start.
    assert_eq!((space.position(s.start)[2], space.position(s.goal)[2], space.top()), (1.6, 1.6, 4.0));
    // (3, 2) lies at 3.6 cells: push 2·0.5·(2 / 2.4), d = √(16 + 4), d0 = √50.
    let (d, d0) = (20f64.sqrt(), 50f64.sqrt());
    assert!(close(field.trail(&space, 2 * 8 + 3), 3.0 * d0 / (d0 + d) - 2.0 / 2.4));
}

#[test]
fn eq_10_and_11_the_elite_deposits_more_and_more() {
    assert_eq!([0.5, 1.0].map(|part| elite_weight((part * 100.0) as u32, 100)), [0.125, 1.0]);
    assert_eq!(elite_weight(1, 4), 1.0 / 64.0, "`it` counts from 1");
    assert_eq!([20, 25, 40, 50, 60].map(|ants| elite_count(0.05, ants)), [1, 1, 2, 2, 3]);
    assert_eq!([elite_count(0.05, 1), elite_count(0.0, 50), elite_count(1.0, 50)], [1, 0, 50]);
    // Half of four ants at (1/2)³·1/1 each, beside the four deposits of 1/1.
    let off = [
        ("initial", "uniform"),
        ("two_colonies", "false"),
        ("force", "false"),
        ("ants", "4"),
        ("iterations", "2"),
        ("elite", "0.5"),
    ];
    let trails = trails_after_one("terrain-epf", &corridor(2), &off);
    assert!(close(trails[0], 0.8 + 4.0 + 0.25) && close(trails[1], 0.8 * 0.6561 + 4.0 + 0.25), "{trails:?}");
}

#[test]
fn eq_11_the_elite_are_the_shortest() {
    // By four moves a path of length L has L + 1 places. Two ants, the last iteration, nothing evaporates: of 1/L1 and 1/L2 on every place
    // of their paths the shorter one's is left twice.
    let s = on(Grid::open(5, 4).expect("a usable size"), None, Moves::Four, (0, 0), (4, 3));
    let set = [
        ("initial", "uniform"),
        ("two_colonies", "false"),
        ("force", "false"),
        ("ants", "2"),
        ("iterations", "1"),
        ("elite", "0.5"),
        ("rho", "0"),
        ("local_rho", "0"),
        ("beta", "0"),
        ("q0", "0"),
    ];
    let mut unequal = 0;
    for seed in 1..=10 {
        let mut planner = planner("terrain-epf", &s, &set, seed);
        planner.run();
        let record = planner.history()[0];
        let (Some(one), Some(two)) = (record.iteration_best, record.iteration_worst) else { panic!("{record:?}") };
        let mut trails = Vec::new();
        assert!(record.arrived == 2 && planner.layer(Layer::Trail, &mut trails));
        let left: f64 = trails.into_iter().map(|t| f64::from(t) - 1.0).sum();
        let expected = 2.0 * (one + 1.0) / one + (two + 1.0) / two;
        assert!((left - expected).abs() < 1e-4, "seed {seed}: {one} and {two}: {left}, {expected}");
        unequal += u32::from(one < two);
    }
    assert!(unequal >= 5, "{unequal}");
}

#[test]
fn second_eq_12_the_force_weighs_the_exponent_less_and_less() {
    assert_eq!([1, 50, 100].map(|it| force_weight(Reading::Repaired, it, 100)), [0.99f64 * 0.99 * 0.99, 0.125, 0.0]);
    assert_eq!([1, 50, 100].map(|it| force_weight(Reading::Printed, it, 100)), [1.0; 3], "the factor cancels in eq. 1");
    // 2^(0.125·4) = √2; the force along a step at right angles to it is none.
    assert!(close(force_factor(2.0, 0.125, 4.0), std::f64::consts::SQRT_2) && force_factor(2.0, 0.0, 4.0) == 1.0);
    assert!(close(along([3.0, 0.0, -1.5], [1.0, 1.0, 1.0], [2.0, 3.0, 3.0]), 0.0));
    assert!(close(along([3.0, 0.0, -1.5], [1.0, 1.0, 1.0], [2.0, 3.0, -1.0]), 2.0));
}

#[test]
fn second_eq_12_eta_of_two_steps_by_hand() {
    let s = by_slices();
    let (space, slices) = (layered(&s), s.slices.as_ref().expect("by slices"));
    let field = Field::new(&space, Way::Forward, gains(Reading::Repaired));
    let eyes = Eyes { way: Way::Forward, heuristic: Heuristic::Goal, beta: 3.0, force: Some((field, 2.5)) };
    let etas: Vec<(Place, f64)> = eyes.eta(&space, slices.place(3, 2, 5), 0.125, |place| eyes.left(&space, place)).collect();
    let eta = |level| etas.iter().find(|(to, _)| *to == slices.place(4, 2, level)).expect("a step").1;
    // At (3, 2, 5) the pull is 3·√51 / (√51 + √20) = 1.844764 along (4, 0, −2)/√20, and the push 0.1639942 down. Down along (1, 0, −1)/√2
    // both help: (6/√20·1.844764 + 0.1639942)/√2 = 1.866058; 2.5^(0.125·1.866058) = 1.238290, and √10 are left to the goal.
    assert!((eta(4) - 0.391582).abs() < 1e-5, "{}", eta(4));
    // Up along (1, 0, 1)/√2: (2/√20·1.844764 − 0.1639942)/√2 = 0.467404; 2.5^(0.125·0.467404) = 1.054994, and √18 are left.
    assert!((eta(6) - 0.248664).abs() < 1e-5, "{}", eta(6));
}

#[test]
fn eq_1_and_12_rows_are_the_powers_of_the_formula() {
    let s = by_slices();
    let (space, slices) = (layered(&s), s.slices.as_ref().expect("by slices"));
    for (reading, heuristic, way) in
        [(Reading::Repaired, Heuristic::Goal, Way::Forward), (Reading::Printed, Heuristic::Step, Way::Backward)]
    {
        let field = Field::new(&space, way, gains(reading));
        let eyes = Eyes { way, heuristic, beta: 3.0, force: Some((field, 2.5)) };
        let mut sight = Sight::new(&space, eyes);
        for it in [1, 60, 99] {
            let weight = force_weight(reading, it, 100);
            sight.begin(it, weight);
            for from in [slices.place(3, 2, 5), slices.place(4, 5, 4), space.origin(way)] {
                let etas: Vec<(Place, f64)> = eyes.eta(&space, from, weight, |place| eyes.left(&space, place)).collect();
                assert!(!etas.is_empty());
                let powers: f64 = etas.iter().map(|(_, eta)| eta.powi(3)).sum();
                let row = sight.row(&space, from).to_vec();
                let whole: f64 = row.iter().map(|&w| f64::from(w)).sum();
                let ends = (0..space.steps()).filter_map(|k| space.step(from, k, way).map(|to| (k, to)));
                for ((k, to), (end, eta)) in ends.zip(etas) {
                    assert_eq!(to, end);
                    let (got, expected) = (f64::from(row[k]) / whole, eta.powi(3) / powers);
                    assert!((got - expected).abs() <= 1e-4 * expected, "{reading:?} {it}: {got}, {expected}");
                }
            }
        }
    }
}

#[test]
fn places_and_steps_agree_with_their_numbers_both_ways() {
    let mirrored = on(hills(), Some(TerrainMoves::Slices(SliceRules { start_level: 3, ..RULES })), Moves::Eight, (7, 2), (1, 3));
    let slices = [by_slices(), mirrored].map(|s| layered(&s));
    let surfaces = [on_surface(Moves::Four), on_surface(Moves::Eight), on_surface(Moves::Sixteen), corridor(5)].map(Surface::new);
    slices.iter().for_each(check_steps);
    surfaces.iter().for_each(check_steps);
}

fn check_steps<S: Space>(space: &S) {
    let mut count = 0;
    for (way, back) in [(Way::Forward, Way::Backward), (Way::Backward, Way::Forward)] {
        assert_ne!(space.origin(way), space.target(way));
        for from in 0..space.places() as Place {
            for (k, to) in (0..space.steps()).filter_map(|k| Some((k, space.step(from, k, way)?))) {
                count += 1;
                assert_eq!(from.wrapping_add_signed(space.delta(k, way)), to);
                assert!(space.length(from, to, k) >= 1.0);
                // What leads there leads back.
                assert!((0..space.steps()).any(|b| space.step(to, b, back) == Some(from)), "{from} → {to}");
            }
        }
    }
    assert!(count > 0);
}

#[test]
fn clearance_is_the_height_above_the_ground_at_least_one() {
    let s = by_slices();
    let (space, slices) = (layered(&s), s.slices.as_ref().expect("by slices"));
    // (3, 2): 36 m, levels of 10 m. At level 4 0.4 counts as 1.
    assert!([(4, 1.0), (5, 1.4), (6, 2.4)].iter().all(|&(h, rho)| close(space.clearance(slices.place(3, 2, h)), rho)));
    assert_eq!(Surface::new(on_surface(Moves::Eight)).clearance(5), 1.0);
}
