//! Zhou, Mu, Zhang 2019 (fireworks and ants).

use std::sync::Arc;

use formicarium::aco::ant::{Ant, Walk};
use formicarium::aco::dead_end::DeadEnd;
use formicarium::aco::fireworks::{ColonyRows, Depositors, Seeded, prior_iterations, seed_trail};
use formicarium::aco::shared_params::SelectionParams;
use formicarium::aco::trails::Trails;
use formicarium::aco::variant::{Iteration, Variant};
use formicarium::catalog;
use formicarium::map::{CornerRule, Direction, Generator, Grid, Movement, Moves, Point, generate};
use formicarium::params::{Value, Values};
use formicarium::planner::{GoalStep, Reading};
use formicarium::planner::{Granularity, Layer, Planner, Solution};
use formicarium::rng::Streams;
use formicarium::scenario::Scenario;
use formicarium::swarm::decode::{DecodeRows, Decoder, Limits, nearness};
use formicarium::swarm::explosion::{
    allotment, confined, cooled_radius, crowding, displacement, explosions, gaussian, inertia, mutation_factor, roulette,
    rounded_sparks,
};
use formicarium::swarm::fireworks::{AnnealingRows, FireworkRows, Fireworks};
use formicarium::swarm::particle_swarm::{moved, velocity};
use formicarium::swarm::population::{Population, distance};
use formicarium::swarm::search::Method;
use rand::Rng;

use super::{E, NE, SE, SQRT2, close};

/// A scenario from the upper left to the lower right cell.
fn drawn(rows: &[&str], moves: Moves) -> Scenario {
    let cells: Vec<u8> = rows.iter().flat_map(|r| r.bytes().map(|b| u8::from(b == b'#'))).collect();
    let grid = Grid::from_bytes(rows[0].len() as u32, rows.len() as u32, &cells).expect("a map");
    let end = Point::new(grid.width() - 1, grid.height() - 1);
    Scenario::on(grid, Movement { moves, corner_rule: CornerRule::BothFree }, Point::new(0, 0), end).expect("usable")
}

/// The same to another goal.
fn drawn_to(rows: &[&str], goal: Point) -> Scenario {
    let drawn = drawn(rows, Moves::Eight);
    Scenario::on(drawn.grid, drawn.spec.movement, Point::new(0, 0), goal).expect("usable")
}

fn population(positions: &[&[f32]]) -> Population {
    let mut all = Population::new(positions[0].len());
    for (i, p) in positions.iter().enumerate() {
        all.push_random(Limits::up_to(1.0), &mut Streams::new(1, "test", 0).ant(0, 0));
        all.position_mut(i).copy_from_slice(p);
    }
    all
}

#[test]
fn eq_1_the_next_cell_has_the_largest_priority_times_nearness() {
    assert_eq!(nearness(Point::new(0, 0), Point::new(4, 3)), 0.2, "a 3-4-5 triangle");
    let s = drawn(&["...", "...", "..."], Moves::Eight);
    // From (0, 0): 0.9/√5 = 0.402 east, 0.5/√5 = 0.224 south, 0.5/√2 = 0.354 south-east, so P = 0.411, 0.228, 0.361.
    // From (1, 0): (2, 0) 1/2 = 0.5, (2, 1) 0.4/1, (1, 1) 0.354, (0, 1) 0.224. From (2, 0): (2, 1) 0.4. From (2, 1): the goal.
    let position = [0.0, 0.9, 1.0, 0.5, 0.5, 0.4, 0.0, 0.0, 0.0];
    let mut decoder = Decoder::new(&s, 0.0, GoalStep::Enter);
    assert_eq!(decoder.decode(&s, &position), Some(4.0));
    assert_eq!((decoder.path(), decoder.moves()), (&[0, 1, 2, 5, 8][..], 4));
    // Twice every priority: the same path, as P does not change.
    assert_eq!(decoder.decode(&s, &position.map(|a| 2.0 * a)), Some(4.0));
    assert_eq!(decoder.path(), [0, 1, 2, 5, 8]);
    // Only (1, 1) counts: √2 + √2.
    assert_eq!(decoder.decode(&s, &[0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]), Some(2.0 * SQRT2));
}

#[test]
fn eq_1_dead_ends_are_walked_back() {
    // One number for each of the seven free cells: (0,0) (1,0) (2,0) (0,1) (0,2) (1,2) (2,2). East first, into the dead end.
    let s = drawn(&["...", ".##", "..."], Moves::Four);
    let position = [0.0, 1.0, 1.0, 0.5, 0.5, 0.5, 0.5];
    let mut decoder = Decoder::new(&s, 0.0, GoalStep::Enter);
    assert_eq!((decoder.dimensions(), decoder.decode(&s, &position)), (7, Some(4.0)));
    // 2 steps in, 2 back, 4 to the goal; what was taken back is no part of the path.
    assert_eq!((decoder.path(), decoder.moves()), (&[0, 3, 6, 7, 8][..], 8));
    // 1 × (3 + 3) moves are too few.
    assert_eq!(Decoder::new(&s, 1.0, GoalStep::Enter).decode(&s, &position), None);
}

#[test]
fn eq_2_sparks_of_an_explosion() {
    // m = 6, lengths 10, 20, 30: Y_max − f = 20, 10, 0, Σ = 30.
    assert!(
        close(allotment(6.0, 20.0, 30.0), 4.0) && close(allotment(6.0, 10.0, 30.0), 2.0) && allotment(6.0, 0.0, 30.0) < 1e-15
    );
    let six = FireworkRows { sparks: 6.0, ..FireworkRows::default() };
    // a·m = 1.8 and b·m = 3.
    let sparks = |rows: &FireworkRows, lengths: &[f64]| explosions(rows, 3.0, lengths).iter().map(|e| e.0).collect::<Vec<_>>();
    assert_eq!(sparks(&six, &[10.0, 20.0, 30.0]), [3, 2, 2]);
    // The paper's own m = 5: 1.5 and 2.5 round to 2 and 3, whatever the lengths.
    let paper = FireworkRows::default();
    assert_eq!([0.0, 1.4, 1.6, 2.4, 2.6, 99.0].map(|s| rounded_sparks(s, &paper)), [2, 2, 2, 2, 3, 3]);
    // All lengths equal: (0 + ε) / (0 + ε) gives everybody all m.
    assert_eq!(allotment(5.0, 0.0, 0.0), 5.0);
    assert_eq!(sparks(&paper, &[7.0; 4]), [3; 4]);
}

#[test]
fn eq_3_radius_of_an_explosion() {
    let radii: Vec<f64> = explosions(&FireworkRows::default(), 3.0, &[10.0, 20.0, 30.0]).iter().map(|e| e.1).collect();
    // f − Y_min = 0, 10, 20, Σ = 30: the best firework hardly explodes at all.
    assert!(radii[0] < 1e-15 && close(radii[1], 1.0) && close(radii[2], 2.0), "{radii:?}");
}

#[test]
fn eq_4_displacement_in_both_readings() {
    assert_eq!([0.0, 0.25, 1.0].map(|u| displacement(Reading::Printed, 2.0, u)), [0.0, 0.5, 2.0]);
    assert_eq!([0.0, 0.25, 1.0].map(|u| displacement(Reading::Repaired, 2.0, u)), [-2.0, -1.0, 2.0]);
}

#[test]
fn eq_5_mutation_is_by_a_gaussian_of_mean_and_variance_1() {
    // √(−2·ln e⁻²) = 2.
    let first = (-2f64).exp();
    assert!(close(gaussian(first, 0.0), 3.0) && close(gaussian(first, 0.5), -1.0) && close(gaussian(first, 0.25), 1.0));
    let mut stream = Streams::new(3, "test", 0).ant(0, 0);
    let mut draw = || (f64::from(stream.next_u32()) + 1.0) / 4_294_967_296.0;
    let drawn: Vec<f64> = (0..100_000).map(|_| gaussian(draw(), draw())).collect();
    let mean = drawn.iter().sum::<f64>() / 1e5;
    let variance = drawn.iter().map(|g| (g - mean) * (g - mean)).sum::<f64>() / 1e5;
    assert!((mean - 1.0).abs() < 0.02 && (variance - 1.0).abs() < 0.02, "{mean}, {variance}");
}

#[test]
fn eq_6_out_of_range_is_mapped_back() {
    assert!(close(confined(1.3, 0.0, 1.0), 0.3) && close(confined(-0.4, 0.0, 1.0), 0.4));
    assert_eq!([0.0, 0.5, 1.0].map(|x| confined(x, 0.0, 1.0)), [0.0, 0.5, 1.0]);
    // 2 + 7.5 % 3
    assert_eq!(confined(-7.5, 2.0, 5.0), 3.5);
}

#[test]
fn eq_6_has_a_lower_limit_too() {
    // x_min = 0.8·2.5, x_max = 2.5; 2 + 1.3 % 0.5 = 2.3, 2 + 3.1 % 0.5 = 2.1.
    let rows = DecodeRows { range: 2.5, range_min: 0.8, ..DecodeRows::default() };
    let limits = rows.limits();
    assert_eq!((limits.min, limits.max, limits.span()), (2.0, 2.5, 0.5));
    assert!(close(confined(1.3, limits.min, limits.max), 2.3) && close(confined(3.1, limits.min, limits.max), 2.1));
    assert_eq!(DecodeRows::default().limits(), Limits::up_to(1.0));
    // So do the positions of all that is proposed: fireworks at first, then their sparks.
    let mut method = Fireworks::new(FireworkRows::default(), AnnealingRows::default(), rows, 10, 0);
    let (mut all, streams) = (Population::new(40), Streams::new(1, "test", 0));
    assert!(method.propose(&mut all, 1, streams));
    (0..all.len()).for_each(|i| all.note(10.0 + i as f64));
    assert!(method.propose(&mut all, 1, streams));
    let positions: Vec<f32> = (0..all.len()).flat_map(|i| all.position(i).to_vec()).collect();
    assert!(positions.len() > 40 * 40 && positions.iter().all(|x| (2.0..=2.5).contains(x)));
    assert!(positions.iter().any(|x| *x < 2.1) && positions.iter().any(|x| *x > 2.4), "all of the range");
}

#[test]
fn eq_6_limits_decide_how_far_a_path_leaves_the_greedy_one() {
    // Three cells to the goal in the row, 1/3 or 1/2 or 1 near; off it from (0, 0) east 1/2 = 0.5, south-east 1/√5 = 0.447.
    let s = drawn_to(&["....", "...."], Point::new(3, 0));
    let path = |position: &[f32]| {
        let mut decoder = Decoder::new(&s, 0.0, GoalStep::Enter);
        decoder.decode(&s, position);
        decoder.path().to_vec()
    };
    // 0.8·0.5 = 0.4 east, 1·0.447 south-east: priorities of at least 0.8 may turn the step, because 0.5 / 0.447 = 1.118 < 1 / 0.8.
    assert_eq!(path(&[1.0, 0.8, 1.0, 1.0, 0.8, 1.0, 0.8, 0.8])[1], 5);
    // 0.9·0.5 = 0.45: those of at least 0.9 may not.
    assert_eq!(path(&[1.0, 0.9, 1.0, 1.0, 0.9, 1.0, 0.9, 0.9])[1], 1);
}

#[test]
fn eq_1_at_the_goal_in_both_readings() {
    // From (1, 0), beside the goal (2, 0): the goal's priority is 0.005, so weighed 0.005/0.01 = 0.5; (2, 1) below the goal has 1/1.
    let s = drawn_to(&["...", "..."], Point::new(2, 0));
    assert!(close(nearness(Point::new(2, 0), Point::new(2, 0)), 100.0));
    let path = |goal_step, at_goal| {
        let mut decoder = Decoder::new(&s, 0.0, goal_step);
        decoder.decode(&s, &[0.0, 1.0, at_goal, 0.0, 0.0, 1.0]);
        decoder.path().to_vec()
    };
    assert_eq!(path(GoalStep::Enter, 0.005), [0, 1, 2], "a goal that is allowed is taken");
    // Then from (2, 1) 0.5 again, against 0 of the cells that are left.
    assert_eq!(path(GoalStep::Weighed, 0.005), [0, 1, 5, 2]);
    // 0.02/0.01 = 2 > 1.
    assert_eq!(path(GoalStep::Weighed, 0.02), [0, 1, 2]);
    assert_eq!(DecodeRows::default().decode_goal, GoalStep::Enter);
}

#[test]
fn eq_7_crowding_sums_the_distances() {
    // 3-4-5 triangles: ‖01‖ = 5, ‖12‖ = 5, ‖02‖ = 8.
    assert_eq!(crowding(&population(&[&[0.0, 0.0], &[3.0, 4.0], &[0.0, 8.0]])), [13.0, 10.0, 13.0]);
    // Nine and more dimensions are summed eight at a time: √(11 · 0.25).
    assert!(close(distance(&[0.5; 11], &[1.0; 11]), 2.75f64.sqrt()));
}

#[test]
fn eq_8_survivors_are_drawn_by_their_share() {
    // ΣR = 8: 1/8, 3/8, 4/8.
    assert_eq!([0.0, 0.12, 0.13, 0.49, 0.5, 0.999].map(|u| roulette(&[1.0, 3.0, 4.0], u)), [0, 0, 1, 1, 2, 2]);
    assert_eq!([0.0, 0.3, 0.99].map(|u| roulette(&[0.0; 4], u)), [0, 1, 3], "all alike: uniform");
}

#[test]
fn eq_9_radius_and_mutation_cool_down() {
    // 3 · 0.01^½ and 3 · 0.01.
    assert!(close(cooled_radius(3.0, 0.01, 25, 50), 0.3) && close(cooled_radius(3.0, 0.01, 50, 50), 0.03));
    assert_eq!(cooled_radius(3.0, 1.0, 25, 50), 3.0);
    assert!(close(inertia(0.9, 0.4, 25, 50), 0.65) && close(inertia(0.9, 0.4, 50, 50), 0.4));
    assert_eq!((mutation_factor(3.0, 0.5), mutation_factor(3.0, 1.0), mutation_factor(-1.0, 0.0)), (2.0, 3.0, 1.0));
}

#[test]
fn an_iteration_of_fireworks_keeps_the_best() {
    let rows = FireworkRows { fireworks: 3, gaussian_sparks: 4, ..FireworkRows::default() };
    let mut method = Fireworks::new(rows, AnnealingRows::default(), DecodeRows::default(), 10, 0);
    let (mut all, streams) = (Population::new(6), Streams::new(1, "test", 0));
    assert!(method.propose(&mut all, 1, streams));
    assert_eq!(all.len(), 3);
    [10.0, 20.0, 30.0].into_iter().for_each(|cost| all.note(cost));
    assert!(method.propose(&mut all, 1, streams));
    // S = 3.33, 1.67, 0 of m = 5, so 3, 2, 2; and 4 Gaussian sparks.
    assert_eq!(all.len(), 3 + 7 + 4);
    assert!((3..6).all(|i| distance(all.position(i), all.position(0)) < 1e-6), "sparks of the best have no radius");
    assert!((0..14).all(|i| all.position(i).iter().all(|x| (0.0..=1.0).contains(x))));
    (3..14).for_each(|i| all.note(if i == 11 { 5.0 } else { 40.0 }));
    let best = all.position(11).to_vec();
    assert!(!method.propose(&mut all, 1, streams), "the iteration is complete");
    assert_eq!((all.len(), all.costs()[0], all.position(0)), (3, 5.0, &best[..]));
    assert_eq!(all.next(), None, "survivors are not decoded again");
}

#[test]
fn particles_by_hand() {
    // 0.5·0.5 + 1·(2 − 1) + 0.5·(3 − 1)
    assert_eq!(velocity(0.5, 1.0, [2.0, 3.0], 0.5, [1.0, 0.5], 10.0), 2.25);
    assert_eq!(velocity(0.5, 1.0, [2.0, 3.0], 0.5, [1.0, 0.5], 2.0), 2.0);
    let stops = |limits| [(0.5, 0.25), (0.9, 0.3), (0.1, -0.3)].map(|(x, v)| moved(x, v, limits));
    assert_eq!(stops(Limits::up_to(1.0)), [(0.75, 0.25), (1.0, 0.0), (0.0, 0.0)]);
    assert_eq!(stops(Limits { min: 0.25, max: 0.75 }), [(0.75, 0.25), (0.75, 0.0), (0.25, 0.0)]);
}

/// 3 × 2 free cells, from (0, 0) to (2, 0).
fn corridor() -> Scenario {
    Scenario::on(Grid::open(3, 2).expect("a usable size"), Movement::default(), Point::new(0, 0), Point::new(2, 0))
        .expect("usable")
}

#[test]
fn eq_10_the_seed_path_starts_with_more_trail() {
    let (s, rows) = (corridor(), ColonyRows::default());
    assert_eq!(
        (rows.selection.alpha, rows.selection.beta, rows.rho, rows.deposit, rows.ants, rows.selection.iterations),
        (2.0, 8.0, 0.1, 1.0, 50, 50)
    );
    // Over (1, 1), length 2√2; 50 ants · 1 / 2.828427.
    let length = 2.0 * SQRT2;
    assert!(close(seed_trail(&rows, length), 17.6776695));
    let seeded = Seeded::new(rows, Some((vec![0, 4, 2], length)));
    let mut trails = Trails::new(s.grid.len(), seeded.initial_trail(&s));
    seeded.shape_trails(&s, &mut trails);
    assert!(close(trails.get(0, SE), 18.6776695) && close(trails.get(4, NE), 18.6776695));
    assert_eq!((trails.get(0, E), trails.get(1, E)), (1.0, 1.0));
    let mut unseeded = Trails::new(s.grid.len(), 1.0);
    Seeded::new(rows, None).shape_trails(&s, &mut unseeded);
    assert_eq!(unseeded.get(0, SE), 1.0);
}

/// τ of the second step of the straight way (length 2), of that of the long one (2√2) and of one that nobody took, after the colony's
/// update: two ants went straight, one the long way, and the best of all iterations went the long way; before it all are 10.
fn updated(rows: ColonyRows) -> [f64; 3] {
    let s = corridor();
    let walk = Walk { moves: &s.moves, goal: s.goal, dead_end: DeadEnd::Backtrack, max_moves: 9 };
    let walked = |way: [Direction; 2]| {
        let stream = || Streams::new(1, "test", 0).ant(0, 0);
        let mut ant = Ant::new(3, 2, stream());
        ant.begin(3, s.start, stream());
        way.iter().for_each(|&d| ant.go(&walk, Some(d)));
        ant
    };
    let ants = [walked([E, E]), walked([SE, NE]), walked([E, E])];
    let mut trails = Trails::new(s.grid.len(), 10.0);
    let best = Solution { path: vec![0, 4, 2], length: 2.0 * SQRT2, iteration: 1, refined: None };
    let iteration = Iteration {
        scenario: &s,
        ants: &ants,
        number: 2,
        budget: 50,
        best_so_far: Some(&best),
        streams: Streams::new(1, "test", 0),
    };
    Seeded::new(rows, None).update_trails(&mut trails, iteration);
    [trails.get(1, E), trails.get(4, NE), trails.get(3, E)]
}

fn all_close(got: [f64; 3], expected: [f64; 3]) {
    assert!(got.iter().zip(expected).all(|(&a, b)| close(a, b)), "{got:?}, expected {expected:?}");
}

#[test]
fn eq_11_and_12_nine_tenths_stay_and_every_ant_adds() {
    // 0.9·10 + ½ + ½, 0.9·10 + 1/(2√2), 0.9·10
    all_close(updated(ColonyRows::default()), [10.0, 9.3535534, 9.0]);
    assert_eq!(ColonyRows::default().depositors, Depositors::AllAnts);
}

#[test]
fn step_3_the_best_path_alone_adds() {
    let by = |depositors| updated(ColonyRows { depositors, deposit: 4.0, ..ColonyRows::default() });
    // 9 + 4/2 on the iteration's shortest, once, although two ants took it; or 9 + 4/(2√2) on the shortest so far, whatever this iteration.
    all_close(by(Depositors::IterationBest), [11.0, 9.0, 9.0]);
    all_close(by(Depositors::BestSoFar), [9.0, 10.4142136, 9.0]);
    all_close(by(Depositors::AllAnts), [13.0, 10.4142136, 9.0]);
}

#[test]
fn eq_10_may_come_after_iterations_of_ants() {
    let s = corridor();
    let length = 2.0 * SQRT2;
    // 0.04 · 50 = 2; of few iterations one is left for what comes after.
    let rows = ColonyRows { ants_first: 0.04, ..ColonyRows::default() };
    let of = |ants_first, iterations| {
        let selection = SelectionParams { iterations, ..rows.selection };
        prior_iterations(&ColonyRows { ants_first, selection, ..rows })
    };
    assert_eq!([of(0.0, 50), of(0.04, 50), of(0.9, 50), of(0.5, 5), of(0.9, 3), of(0.9, 1)], [0, 2, 45, 3, 2, 0]);
    let mut seeded = Seeded::new(rows, Some((vec![0, 4, 2], length)));
    let mut trails = Trails::new(s.grid.len(), 1.0);
    seeded.shape_trails(&s, &mut trails);
    assert_eq!(trails.get(0, SE), 1.0, "not before the ants");
    // No ant arrives: 0.9, then 0.81 and 50 / (2√2) = 17.6776695, then 0.9 of both.
    for (number, expected) in [(1, 0.9), (2, 18.4876695), (3, 16.6389026)] {
        let iteration =
            Iteration { scenario: &s, ants: &[], number, budget: 50, best_so_far: None, streams: Streams::new(1, "test", 0) };
        seeded.update_trails(&mut trails, iteration);
        seeded.daemon_actions(&mut trails, iteration);
        assert!(close(trails.get(0, SE), expected), "{number}: {}", trails.get(0, SE));
    }
    assert!(close(trails.get(0, E), 0.729));
}

pub fn map(seed: u32) -> Arc<Scenario> {
    let made = generate(Generator::Random, 20, 20, seed, 0.2).expect("a usable size");
    Arc::new(Scenario::on(made.grid, Movement::default(), made.start, made.goal).expect("usable"))
}

fn planner(scenario: &Arc<Scenario>, id: &str, values: &[(&str, f64)], seed: u32) -> Box<dyn Planner> {
    let values: Values = values.iter().map(|&(k, v)| (k.to_string(), Value::Number(v))).collect();
    catalog::build(scenario, id, None, &values, seed).expect("valid parameters")
}

/// 50 iterations: the first stage of a hybrid, all of a swarm.
fn first_stage(planner: &mut dyn Planner) {
    for _ in 0..50 {
        planner.advance(Granularity::Iteration);
    }
}

#[test]
fn a_hybrid_counts_both_stages() {
    let s = map(2);
    let mut alone = planner(&s, "ifwa", &[], 7);
    alone.run();
    let found = alone.best().expect("a path").clone();
    let mut both = planner(&s, "fwa-aco", &[], 7);
    first_stage(&mut *both);
    assert_eq!((both.history(), both.best(), both.effort()), (alone.history(), Some(&found), alone.effort()), "the run of ifwa");
    let (mut trail, mut seed) = (Vec::new(), Vec::new());
    assert!(both.layer(Layer::InitialTrail, &mut trail) && both.layer(Layer::SeedPath, &mut seed));
    let peak = 1.0 + 50.0 / found.length;
    for c in 0..s.grid.len() {
        let on_path = found.path.contains(&(c as u32));
        assert_eq!(seed[c], f32::from(u8::from(on_path)));
        let expected = if on_path && c as u32 != s.goal { peak } else { 1.0 };
        assert!(close(f64::from(trail[c]), expected), "cell {c}: {}", trail[c]);
    }
    both.run();
    assert_eq!((both.history().len(), both.budget(), both.effort().iterations), (100, Some(100), 100));
    assert_eq!(both.effort().constructed_paths, alone.effort().constructed_paths + 50 * 50);
    assert!(both.history()[50..].iter().all(|r| r.best_so_far <= Some(found.length)), "the best of both stages");
    let mut unseeded = planner(&s, "fwa-aco", &[("seed_ants", 0.0)], 7);
    unseeded.run();
    assert_ne!(unseeded.digest().hex(), both.digest().hex(), "the seed has an effect");
}

#[test]
fn both_stages_draw_the_layers_of_the_catalog() {
    const ALL: [Layer; 8] = [
        Layer::Trail,
        Layer::Visits,
        Layer::Heuristic,
        Layer::Cost,
        Layer::Density,
        Layer::InitialTrail,
        Layer::SeedPath,
        Layer::Priority,
    ];
    let (s, mut field) = (map(3), Vec::new());
    for id in ["fwa", "ifwa", "fwa-aco", "pso-aco"] {
        let mut p = planner(&s, id, &[], 1);
        for _ in 0..60 {
            for kind in ALL {
                assert_eq!(p.layer(kind, &mut field), catalog::find(id).expect("known").layers.contains(&kind), "{id}, {kind:?}");
                assert!(field.len() == s.grid.len() && field.iter().all(|v| *v >= 0.0 && v.is_finite()), "{id}, {kind:?}");
            }
            p.advance(Granularity::Iteration);
        }
        assert!(p.layer(Layer::Priority, &mut field) && field.iter().any(|v| *v > 0.0), "{id}");
    }
}

#[test]
fn a_hybrid_stops_when_its_second_stage_stagnates() {
    let s = map(2);
    let mut p = planner(&s, "pso-aco", &[("stagnation", 5.0), ("iterations", 1000.0), ("seed_iterations", 3.0)], 1);
    assert_eq!(p.run(), formicarium::planner::Status::Stagnated);
    let best = p.best().expect("a path").iteration.max(3);
    assert_eq!(p.effort().iterations, best + 5);
}

#[test]
fn swarms_improve_on_their_first_iteration() {
    for id in ["fwa", "ifwa", "pso-aco"] {
        for seed in 1..=5 {
            let mut p = planner(&map(seed), id, &[], seed);
            first_stage(&mut *p);
            let lengths = p.history().iter().map(|r| r.best_so_far.expect("every decoding arrives"));
            let lengths: Vec<f64> = lengths.collect();
            assert!(lengths[49] < lengths[0], "{id}, seed {seed}: {} and {}", lengths[0], lengths[49]);
        }
    }
}

#[test]
fn the_papers_ant_colony_is_a_preset_of_ant_system() {
    let entry = catalog::find("ant-system").expect("in the catalog");
    let preset = entry.presets.iter().find(|p| p.name == "fireworks").expect("the preset");
    // 50 iterations, 50 ants, α = 1, β = 3, ρ = 0.5 (what stays is what leaves), Q = 5.
    let of = |key: &str| match preset.values().get(key) {
        Some(v) => v.clone(),
        None => (entry.specs)().iter().find(|s| s.key == key).expect("a row").default.clone(),
    };
    let numbers = ["iterations", "ants", "alpha", "beta", "rho", "deposit"].map(of);
    assert_eq!(numbers, [50.0, 50.0, 1.0, 3.0, 0.5, 5.0].map(Value::Number));
    assert_eq!((of("heuristic"), of("dead_end")), (Value::from("goal"), Value::from("backtrack")));
}
