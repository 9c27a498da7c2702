//! Lai and Guo 2014 (ACOST, ACOMSP).

use std::sync::Arc;

use formicarium::aco::ant::{Ant, Walk};
use formicarium::aco::dead_end::DeadEnd;
use formicarium::aco::selection;
use formicarium::aco::threshold::{
    Acomsp, AcomspParams, Acost, AcostParams, CommonParams, Rule, reward_shortest, threshold, time, visibility,
};
use formicarium::aco::trails::{Row, Trails};
use formicarium::aco::variant::{Iteration, Step, Variant};
use formicarium::aco::visibility::Sight;
use formicarium::aco::weights::WeightTable;
use formicarium::catalog;
use formicarium::map::{CornerRule, Direction, Grid, Movement, Moves, Point};
use formicarium::params::{Value, Values};
use formicarium::planner::{Granularity, Reading};
use formicarium::rng::{Stream, Streams};
use formicarium::scenario::{Change, Scenario, ScenarioSpec};

const SQRT2: f64 = std::f64::consts::SQRT_2;

fn stream() -> Stream {
    Streams::new(1, "test", 0).ant(0, 0)
}

fn open(width: u32, height: u32, goal: Point) -> Arc<Scenario> {
    let grid = Grid::from_bytes(width, height, &vec![0; (width * height) as usize]).expect("a rectangle");
    let movement = Movement { moves: Moves::Eight, corner_rule: CornerRule::OneFree };
    Arc::new(Scenario::on(grid, movement, Point::new(0, 0), goal).expect("usable"))
}

fn direction(s: &Scenario, from: (u32, u32), to: (u32, u32)) -> Direction {
    let cell = |(x, y)| y * s.grid.width() + x;
    s.moves.direction(cell(from), cell(to))
}

/// How often each direction is selected in 40 000 draws.
fn counts(mut select: impl FnMut(&mut Stream) -> Option<Direction>) -> [u32; 8] {
    let (mut stream, mut counts) = (stream(), [0; 8]);
    for _ in 0..40_000 {
        counts[select(&mut stream).expect("a step is left") as usize] += 1;
    }
    counts
}

fn near(count: u32, share: f64) -> bool {
    (f64::from(count) / 40_000.0 - share).abs() < 0.01
}

#[test]
fn eq_2_and_4_the_heuristic_is_one_over_the_euclidean_distance() {
    let goal = Point::new(4, 3);
    assert_eq!(visibility(Point::new(0, 0), goal, 0.01), 0.2, "a 3-4-5 triangle");
    assert_eq!(visibility(Point::new(4, 1), goal, 0.01), 0.5);
    assert!((visibility(Point::new(3, 2), goal, 0.01) - 1.0 / SQRT2).abs() < 1e-15);
    assert_eq!(visibility(goal, goal, 0.01), 100.0, "the print divides by 0");
    let s = open(5, 4, goal);
    assert_eq!(Acost::new(AcostParams::default()).heuristic(&s, 1, 3, 0), 0.2);
    assert_eq!(Acomsp::new(AcomspParams::default()).heuristic(&s, 1, 3, 0), 0.2);
}

#[test]
fn eq_5_probabilities_are_proportional_to_trail_and_heuristic() {
    // τ = 2 and 1, η = 0.5 and 1, α = 1, β = 2: weights 2·0.25 and 1·1, so p = 1/3 and 2/3.
    let goal = Point::new(0, 3);
    let s = open(1, 4, goal);
    let mut trails = Trails::new(4, 1.0);
    let up = direction(&s, (0, 1), (0, 0));
    let down = direction(&s, (0, 1), (0, 2));
    trails.deposit(1, up, 1.0);
    let mut table = WeightTable::new(4, 1.0);
    let sight = Sight { scenario: &s, eta: &|_, d, _| if d == up { 0.5 } else { 1.0 }, beta: 2.0, enters_goal: false };
    assert!(table.learn(&sight, &trails, 1));
    let variant = Acost::new(AcostParams { rule: Rule::Proportional, ..AcostParams::default() });
    let row = *table.row(1);
    let seen = counts(|stream| variant.choose(&row, stream));
    assert!(near(seen[up as usize], 1.0 / 3.0) && near(seen[down as usize], 2.0 / 3.0), "{seen:?}");
}

#[test]
fn eq_6_the_threshold_rises_with_the_square_of_time() {
    assert_eq!(threshold(0, 50), 0.0);
    assert!((threshold(1, 50) - 0.019_801_326_693_244_7).abs() < 1e-15, "1 − exp(−0.02)");
    assert!((threshold(5, 50) - 0.393_469_340_287_366_6).abs() < 1e-15, "1 − exp(−0.5)");
    assert!((threshold(10, 50) - 0.864_664_716_763_387_3).abs() < 1e-15, "1 − exp(−2)");
    assert!(threshold(43, 50) < 1.0 && threshold(44, 50) == 1.0, "where 64 bits round to 1");
    assert_eq!((time(Reading::Repaired, 1), time(Reading::Printed, 1)), (1, 0));
}

/// Probabilities 0.1, 0.3 and 0.6.
const WEIGHTS: Row = [0.0, 1.0, 0.0, 3.0, 6.0, 0.0, 0.0, 0.0];

#[test]
fn step_5_roulette_among_the_steps_up_to_the_threshold() {
    let with = |lambda| counts(|stream| selection::threshold(&WEIGHTS, lambda, stream));
    let (none, one, two, all) = (with(0.05), with(0.2), with(0.5), with(1.0));
    assert!([1, 3, 4].iter().all(|&d| near(none[d], 1.0 / 3.0)), "no candidate: uniform among all, {none:?}");
    assert_eq!(one[1], 40_000, "only 0.1 ≤ 0.2");
    assert!(near(two[1], 0.25) && near(two[3], 0.75) && two[4] == 0, "0.1 and 0.3 of 0.4: {two:?}");
    assert!(near(all[1], 0.1) && near(all[3], 0.3) && near(all[4], 0.6), "as Ant System: {all:?}");
    assert_eq!(selection::threshold(&[0.0; 8], 0.5, &mut stream()), None, "a dead end");
}

#[test]
fn step_4_and_5_the_variant_takes_the_threshold_of_its_time() {
    let common = CommonParams { reading: Reading::Printed, ..CommonParams::default() };
    let mut variant = Acost::new(AcostParams { common, ..AcostParams::default() });
    variant.begin_iteration(1);
    let first = counts(|stream| variant.choose(&WEIGHTS, stream));
    assert!([1, 3, 4].iter().all(|&d| near(first[d], 1.0 / 3.0)), "λ_0 = 0: a uniform walk, {first:?}");
    // λ_4 = 1 − exp(−16/50) = 0.274: only 0.1 is below. λ_5 = 0.393: 0.3, too.
    variant.begin_iteration(5);
    assert_eq!(counts(|stream| variant.choose(&WEIGHTS, stream))[1], 40_000);
    let mut repaired = Acost::new(AcostParams::default());
    repaired.begin_iteration(5);
    assert!(near(counts(|stream| repaired.choose(&WEIGHTS, stream))[3], 0.75));
}

#[test]
fn a_step_that_is_certain_up_to_rounding_is_barred_until_the_threshold_is_one() {
    // Beside the goal with β = 25: the other step is left although it weighs 1e-30.
    let beside_the_goal = [1.0, 1e-30, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let at = |t| selection::threshold(&beside_the_goal, threshold(t, 50), &mut stream());
    assert_eq!((at(1), at(43), at(44)), (Some(1), Some(1), Some(0)));
}

/// Three cells in a row, goal last, and what each planner makes of the two steps from the middle one, back and on: (weight, probability).
fn beside_the_goal(id: &str, values: &[(&str, &str)]) -> Vec<(f64, f64)> {
    let values: Values = values.iter().map(|&(k, v)| (k.to_string(), Value::parse(v))).collect();
    let planner = catalog::build(&open(3, 1, Point::new(2, 0)), id, None, &values, 1).expect("valid");
    planner.moves_from(1).iter().map(|odds| (odds.weight, odds.probability)).collect()
}

#[test]
fn eq_4_at_the_goal_in_both_readings() {
    // β = 2: back η = 1/2, on 1/0.01, so (1/200)² = 0.000025 to 1, p = 0.999975. λ_1 = 1 − exp(−1/50) = 0.0198: on is barred.
    let weighed = beside_the_goal("acost", &[("beta", "2")]);
    assert!((weighed[0].0 - 0.000_025).abs() < 1e-9 && weighed[1].0 == 1.0, "{weighed:?}");
    assert_eq!((weighed[0].1, weighed[1].1), (1.0, 0.0));
    // The paper's ACO weighs them, ACOMSP takes the larger.
    let aco = beside_the_goal("acost", &[("beta", "2"), ("rule", "proportional")]);
    assert!((aco[1].1 - 0.999_975).abs() < 1e-8, "{aco:?}");
    assert_eq!(beside_the_goal("acomsp", &[("beta", "2")])[1].1, 1.0);
    // Entered, the goal is all that there is, whatever the rule, the weight of η or the time.
    let all: [(&str, &[(&str, &str)]); 4] = [
        ("acost", &[("goal_step", "enter")]),
        ("acost", &[("goal_step", "enter"), ("beta", "0")]),
        ("acost", &[("goal_step", "enter"), ("rule", "proportional")]),
        ("acomsp", &[("goal_step", "enter"), ("maximal", "false")]),
    ];
    for (id, values) in all {
        assert_eq!(beside_the_goal(id, values), [(0.0, 0.0), (1.0, 1.0)], "{id} {values:?}");
    }
}

#[test]
fn every_ant_that_comes_beside_the_goal_enters_it() {
    // From (0, 0) every step leads to a cell beside the goal (2, 0), or to (0, 1), from where every step does: three steps at most.
    let s = open(3, 2, Point::new(2, 0));
    for (id, preset) in [("acost", "second-reading"), ("acomsp", "second-reading")] {
        let mut planner = catalog::build(&s, id, Some(preset), &Values::new(), 1).expect("valid");
        planner.advance(Granularity::Iteration);
        let record = planner.history()[0];
        assert_eq!(record.arrived, 10, "{id}");
        assert!(record.iteration_worst.expect("they arrive") <= 1.0 + 1.0 + SQRT2, "{id}");
    }
    // Weighed, the threshold bars that step: some of ACOST's ants end at a dead end.
    let mut weighed = catalog::build(&s, "acost", None, &Values::new(), 1).expect("valid");
    weighed.advance(Granularity::Iteration);
    assert!(weighed.history()[0].arrived < 10);
}

#[test]
fn a_goal_is_entered_where_walls_have_changed_too() {
    // The cell (2, 0) beside the goal (3, 0) is free from iteration 2 on; then it leads onto the goal alone.
    let s = open(4, 2, Point::new(3, 0));
    let mut grid = s.grid.clone();
    grid.set_blocked(2, true);
    let spec = ScenarioSpec { changes: vec![Change { at: 1, blocked: vec![], freed: vec![Point::new(2, 0)] }], ..s.spec.clone() };
    let s = Arc::new(Scenario::new(grid, spec).expect("usable"));
    let mut planner = catalog::build(&s, "acost", Some("second-reading"), &Values::new(), 1).expect("valid");
    for _ in 0..3 {
        planner.advance(Granularity::Iteration);
    }
    let odds: Vec<(u32, f64)> = planner.moves_from(2).iter().map(|m| (m.to, m.probability)).collect();
    assert!(odds.len() > 1 && odds.iter().all(|&(to, p)| p == f64::from(u8::from(to == 3))), "{odds:?}");
    assert!(planner.history()[2].arrived > 0);
}

#[test]
fn acomsp_takes_the_most_probable_step_and_draws_between_equal_ones() {
    let variant = Acomsp::new(AcomspParams::default());
    assert_eq!(counts(|stream| variant.choose(&WEIGHTS, stream))[4], 40_000);
    let tied = counts(|stream| selection::maximal(&[0.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0], stream));
    assert!(near(tied[1], 0.5) && near(tied[3], 0.5), "{tied:?}");
    assert_eq!(selection::maximal(&[0.0; 8], &mut stream()), None);
}

#[test]
fn eq_7_to_9_each_move_leaves_q1_over_the_length_walked() {
    let s = open(4, 2, Point::new(3, 1));
    let variant = Acost::new(AcostParams { move_deposit: 3.0, ..AcostParams::default() });
    let mut trails = Trails::new(8, 1.0);
    // (0,0) → (1,1) → (2,1): l = √2, then 1 + √2, as the ant counts it.
    let (first, second) = (direction(&s, (0, 0), (1, 1)), direction(&s, (1, 1), (2, 1)));
    let walk = Walk { moves: &s.moves, goal: s.goal, dead_end: DeadEnd::Die, max_moves: u32::MAX };
    let mut ant = Ant::new(4, 2, stream());
    ant.begin(4, s.start, stream());
    for direction in [first, second] {
        let from = ant.cell();
        ant.go(&walk, Some(direction));
        variant.on_move(&mut trails, Step { from, direction, walked: ant.walked() });
    }
    assert!((trails.get(0, first) - (1.0 + 3.0 / SQRT2)).abs() < 1e-6, "3.1213");
    assert!((trails.get(5, second) - (1.0 + 3.0 / (1.0 + SQRT2))).abs() < 1e-6, "2.2426");
    assert_eq!(trails.get(5, first), 1.0, "nothing elsewhere");
}

/// Ants on a 3 × 2 map that went straight (length 2), round (1 + √2), and nowhere; then `update`.
fn updated(update: impl Fn(&mut Trails, Iteration)) -> (Trails, Arc<Scenario>) {
    let s = open(3, 2, Point::new(2, 0));
    let walk = Walk { moves: &s.moves, goal: s.goal, dead_end: DeadEnd::Die, max_moves: u32::MAX };
    let way = |steps: &[Direction]| {
        let mut ant = Ant::new(3, 2, stream());
        ant.begin(3, s.start, stream());
        steps.iter().for_each(|&d| ant.go(&walk, Some(d)));
        ant
    };
    let (east, south, north_east) = (direction(&s, (0, 0), (1, 0)), direction(&s, (0, 0), (0, 1)), direction(&s, (1, 1), (2, 0)));
    let mut lost = way(&[south]);
    lost.go(&walk, None);
    let ants = [way(&[east, east]), way(&[south, east, north_east]), lost];
    let mut trails = Trails::new(6, 1.0);
    update(
        &mut trails,
        Iteration { scenario: &s, ants: &ants, number: 1, budget: 50, best_so_far: None, streams: Streams::new(1, "test", 0) },
    );
    (trails, s)
}

#[test]
fn eq_10_to_12_trails_evaporate_and_the_shortest_path_is_rewarded() {
    // L_min = 2, Q2 = 3, 0.8 stays: 0.8 + 3/2 on the shortest path, 0.8 elsewhere; printed: three ants, 0.8 + 3·3/2.
    for (reading, on_path) in [(Reading::Repaired, 2.3), (Reading::Printed, 5.3)] {
        let p = CommonParams { rho: 0.2, path_deposit: 3.0, reading, ..CommonParams::default() };
        let (trails, s) = updated(|trails, iteration| reward_shortest(trails, &iteration, &p));
        let east = direction(&s, (0, 0), (1, 0));
        for cell in [0, 1] {
            assert!((trails.get(cell, east) - on_path).abs() < 1e-6, "{reading:?}: {}", trails.get(cell, east));
        }
        assert!((trails.get(3, east) - 0.8).abs() < 1e-6, "the longer way gets nothing");
    }
}

#[test]
fn eq_10_to_12_both_variants_update_so_and_the_papers_aco_only_evaporates() {
    let defaults = AcostParams::default();
    let acost = |p: AcostParams| updated(|trails, iteration| Acost::new(p).update_trails(trails, iteration));
    let acomsp = updated(|trails, iteration| Acomsp::new(AcomspParams::default()).update_trails(trails, iteration));
    let common = CommonParams { path_deposit: 0.0, ..CommonParams::default() };
    let aco = acost(AcostParams { rule: Rule::Proportional, common, ..defaults });
    // Half stays; 1/2 more on the path.
    for ((trails, s), on_path) in [(acost(defaults), 1.0), (acomsp, 1.0), (aco, 0.5)] {
        let east = direction(&s, (0, 0), (1, 0));
        assert!((trails.get(0, east) - on_path).abs() < 1e-6 && (trails.get(3, east) - 0.5).abs() < 1e-6);
    }
}

#[test]
fn the_iteration_without_arrivals_only_evaporates() {
    let s = open(3, 2, Point::new(2, 0));
    let mut trails = Trails::new(6, 1.0);
    let iteration =
        Iteration { scenario: &s, ants: &[], number: 1, budget: 50, best_so_far: None, streams: Streams::new(1, "test", 0) };
    reward_shortest(&mut trails, &iteration, &CommonParams::default());
    assert!((0..6).all(|c| (0..8).all(|d| trails.get(c, d) == 0.5)));
}

#[test]
fn table_1_is_the_default() {
    let (acost, acomsp) = (AcostParams::default(), AcomspParams::default());
    assert_eq!((acost.beta, acost.move_deposit, acomsp.beta), (25.0, 1.0, 15.0));
    for p in [acost.common, acomsp.common] {
        assert_eq!((p.alpha, p.ants, p.iterations, p.rho, p.path_deposit), (1.0, 10, 50, 0.5, 1.0));
        assert_eq!(p.dead_end, DeadEnd::Die);
    }
}
