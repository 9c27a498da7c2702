//! The classics' equations, numbered as in Dorigo and Stützle, *Ant Colony Optimization* (MIT Press, 2004).
//!
//! `bend()` has one way only, 4 steps long: every ant takes it, so that trails are exact numbers. On an open map it would be 2 long.

use std::sync::Arc;

use formicarium::aco::ant::{Ant, Walk};
use formicarium::aco::dead_end::DeadEnd;
use formicarium::aco::trails::Trails;
use formicarium::aco::variant::{Iteration, Variant};
use formicarium::catalog;
use formicarium::map::{CornerRule, Direction, Grid, Movement, Moves, Point};
use formicarium::params::{Value, Values};
use formicarium::planner::{Granularity, Layer, Planner, Solution};
use formicarium::rng::Streams;
use formicarium::scenario::Scenario;

use super::{E, NE, SE};

const N: Direction = 1;
const S: Direction = 6;

fn scenario(rows: &[&str], moves: Moves, start: Point, goal: Point) -> Arc<Scenario> {
    let cells: Vec<u8> = rows.iter().flat_map(|r| r.bytes().map(|b| u8::from(b == b'#'))).collect();
    let grid = Grid::from_bytes(rows[0].len() as u32, rows.len() as u32, &cells).expect("a rectangle");
    let movement = Movement { moves, corner_rule: CornerRule::BothFree };
    Arc::new(Scenario::on(grid, movement, start, goal).expect("usable"))
}

/// L = 4, L_open = 2; the goal's trails are never deposited on.
fn bend() -> Arc<Scenario> {
    scenario(&[".#.", "..."], Moves::Four, Point::new(0, 0), Point::new(2, 0))
}

/// Cell 0 to cell 2, with room for several ways.
fn room() -> Arc<Scenario> {
    scenario(&["...", "..."], Moves::Eight, Point::new(0, 0), Point::new(2, 0))
}

fn build(scenario: &Arc<Scenario>, id: &str, numbers: &[(&str, f64)]) -> Box<dyn Planner> {
    let values: Values = numbers.iter().map(|&(k, v)| (k.to_string(), Value::Number(v))).collect();
    catalog::build(scenario, id, None, &values, 1).expect("valid parameters")
}

/// Strongest trails of start and goal before the first and after each of so many iterations; the start's is on the way of all ants.
fn trails(scenario: &Arc<Scenario>, id: &str, numbers: &[(&str, f64)], iterations: u32) -> Vec<(f32, f32)> {
    let mut planner = build(scenario, id, numbers);
    let mut field = Vec::new();
    let mut after = |_| {
        planner.advance(Granularity::Iteration);
        assert!(planner.layer(Layer::Trail, &mut field));
        (field[scenario.start as usize], field[scenario.goal as usize])
    };
    (0..iterations).map(&mut after).collect()
}

fn assert_near(found: &[(f32, f32)], expected: &[(f32, f32)]) {
    let near = |a: f32, b: f32| (a - b).abs() <= 1e-6 * b;
    assert_eq!(found.len(), expected.len());
    assert!(found.iter().zip(expected).all(|(f, e)| near(f.0, e.0) && near(f.1, e.1)), "{found:?} is not {expected:?}");
}

/// An ant that has walked these steps.
fn walked(scenario: &Scenario, steps: &[Direction]) -> Ant {
    let stream = Streams::new(1, "test", 0).ant(1, 0);
    let (width, height) = (scenario.grid.width(), scenario.grid.height());
    let walk = Walk { moves: &scenario.moves, goal: scenario.goal, dead_end: DeadEnd::Die, max_moves: u32::MAX };
    let mut ant = Ant::new(width, height, stream.clone());
    ant.begin(width, scenario.start, stream);
    steps.iter().for_each(|&d| ant.go(&walk, Some(d)));
    ant
}

/// A variant's update of trails that are `initial` everywhere.
fn updated<V: Variant>(variant: &mut V, initial: f64, iteration: Iteration) -> Trails {
    let scenario = iteration.scenario;
    let mut trails = Trails::new(scenario.grid.len(), initial);
    variant.prepare(scenario);
    variant.update_trails(&mut trails, iteration);
    trails
}

fn near(trails: &Trails, c: u32, d: Direction, expected: f64) {
    let found = trails.get(c, d);
    assert!((found - expected).abs() <= 1e-6 * expected, "cell {c}, direction {d}: {found} is not {expected}");
}

mod ant_system {
    use super::*;

    /// Eq. 3.3–3.5: 0.5·1 + 4·1/4 = 1.5, then 0.5·1.5 + 1 = 1.75; elsewhere 0.5 and 0.25.
    #[test]
    fn eq_3_3_to_3_5_trails_evaporate_and_every_ant_deposits() {
        let numbers = [("ants", 4.0), ("rho", 0.5)];
        assert_near(&trails(&bend(), "ant-system", &numbers, 2), &[(1.5, 0.5), (1.75, 0.25)]);
    }

    /// ρ = 0.2 leaves, Q = 3, τ0 = 2: 0.8·2 + 2·3/4 = 3.1, then 0.8·3.1 + 1.5 = 3.98; elsewhere 1.6 and 1.28.
    #[test]
    fn rho_is_what_leaves_and_a_deposit_is_q_over_the_length() {
        let numbers = [("ants", 2.0), ("rho", 0.2), ("deposit", 3.0), ("initial_trail", 2.0)];
        assert_near(&trails(&bend(), "ant-system", &numbers, 2), &[(3.1, 1.6), (3.98, 1.28)]);
    }
}

mod elitist_ant_system {
    use super::*;

    /// τ0 = (e + m)·Q/(ρ·L_open) = (3 + 4)/(0.5·2) = 7. Eq. 3.6–3.7: 0.5·7 + 4·1/4 + 3·1/4 = 5.25, then 0.5·5.25 + 1.75 = 4.375.
    #[test]
    fn eq_3_6_the_best_so_far_is_deposited_e_times() {
        let numbers = [("ants", 4.0), ("elitists", 3.0), ("rho", 0.5)];
        assert_near(&trails(&bend(), "elitist-ant-system", &numbers, 2), &[(5.25, 3.5), (4.375, 1.75)]);
    }

    /// Q = 2 doubles everything.
    #[test]
    fn deposits_and_the_initial_trail_are_in_units_of_q() {
        let numbers = [("ants", 4.0), ("elitists", 3.0), ("rho", 0.5), ("deposit", 2.0)];
        assert_near(&trails(&bend(), "elitist-ant-system", &numbers, 2), &[(10.5, 7.0), (8.75, 3.5)]);
    }
}

mod rank_based_ant_system {
    use super::*;
    use formicarium::aco::rank_based_ant_system::{RankBasedAntSystem, RankBasedAntSystemParams};

    /// τ0 = 0.5·3·2/(0.5·2) = 3. Eq. 3.8 with one ant, of rank 1: 0.5·3 + (3 − 1)/4 + 3/4 = 2.75, then 0.5·2.75 + 1.25 = 2.625.
    #[test]
    fn eq_3_8_with_fewer_ants_than_ranks() {
        let numbers = [("ants", 1.0), ("ranks", 3.0), ("rho", 0.5)];
        assert_near(&trails(&bend(), "rank-based-ant-system", &numbers, 2), &[(2.75, 1.5), (2.625, 0.75)]);
    }

    /// Lengths 4, 2√2, 2, in that order: the last ranks first and is the best so far, the first ranks third and leaves nothing.
    #[test]
    fn eq_3_8_by_rank() {
        let room = room();
        let ants = [&[S, E, E, N][..], &[SE, NE], &[E, E]].map(|steps| walked(&room, steps));
        let best = Solution { path: vec![0, 1, 2], length: 2.0, iteration: 1, refined: None };
        let params = RankBasedAntSystemParams { ranks: 3, rho: 0.5, ..Default::default() };
        let iteration = Iteration {
            scenario: &room,
            ants: &ants,
            number: 1,
            budget: 9,
            best_so_far: Some(&best),
            streams: Streams::new(1, "test", 0),
        };
        let trails = updated(&mut RankBasedAntSystem::new(params), 3.0, iteration);
        for (c, d) in [(0, E), (1, E)] {
            near(&trails, c, d, 1.5 + 2.0 / 2.0 + 3.0 / 2.0);
        }
        for (c, d) in [(0, SE), (4, NE)] {
            near(&trails, c, d, 1.5 + 1.0 / (2.0 * std::f64::consts::SQRT_2));
        }
        for (c, d) in [(0, S), (3, E), (4, E), (5, N)] {
            near(&trails, c, d, 1.5);
        }
    }
}

mod max_min_ant_system {
    use super::*;
    use formicarium::aco::max_min_ant_system::{Limits, MaxMinAntSystem, MaxMinAntSystemParams, MaxMinRows};

    /// τ_max = 1/(0.02·10) = 5. p = 0.5^10: ¹⁰√p = 0.5, τ_min = 5·0.5/((6 − 1)·0.5) = 1.
    #[test]
    fn limits_by_hand() {
        let limits = Limits::new(0.02, 0.5f64.powi(10), 10.0, 10, 6.0);
        assert!((limits.max - 5.0).abs() < 1e-12 && (limits.min - 1.0).abs() < 1e-12, "{limits:?}");
        let one_step = Limits::new(0.02, 0.05, 10.0, 1, 6.0);
        assert_eq!(one_step.min, one_step.max, "0.95/(5·0.05) = 3.8 times the upper limit is cut to it");
    }

    /// τ0 = 1/(0.5·2) = 1; τ_max = 1/(0.5·4) = 0.5; avg = 8/5, so 2; p = 0.8⁴: τ_min = 0.5·0.2/(1·0.8) = 0.125.
    /// On the way 0.5·1 + 1/4 is cut to 0.5, which 0.5·0.5 + 1/4 keeps; elsewhere 0.5, 0.25, 0.125, and 0.0625 is raised to 0.125.
    #[test]
    fn eq_3_9_between_the_limits() {
        let numbers = [("ants", 4.0), ("rho", 0.5), ("p_best", 0.4096)];
        let expected = [(0.5, 0.5), (0.5, 0.25), (0.5, 0.125), (0.5, 0.125)];
        assert_near(&trails(&bend(), "max-min-ant-system", &numbers, 4), &expected);
    }

    /// As above; the path of iteration 1 is never improved, so all trails are τ_max again after iterations 3 and 5.
    #[test]
    fn a_restart_puts_all_trails_to_the_upper_limit() {
        let numbers = [("ants", 4.0), ("rho", 0.5), ("p_best", 0.4096), ("restart_after", 2.0)];
        let expected = [(0.5, 0.5), (0.5, 0.25), (0.5, 0.5), (0.5, 0.25), (0.5, 0.5)];
        assert_near(&trails(&bend(), "max-min-ant-system", &numbers, 5), &expected);
    }

    /// Ways of length 2 (best so far) and 2√2 (the iteration's best): 0.75 + 1/2 or 0.75 + 1/(2√2), below τ_max = 1/(0.25·2) = 2.
    #[test]
    fn eq_3_9_the_best_so_far_has_its_turn() {
        let room = room();
        let ants = [walked(&room, &[SE, NE])];
        let best = Solution { path: vec![0, 1, 2], length: 2.0, iteration: 1, refined: None };
        let params = MaxMinAntSystemParams {
            rules: MaxMinRows { rho: 0.25, p_best: 0.9, best_every: 3, ..Default::default() },
            ..Default::default()
        };
        for number in 2..=6 {
            let iteration = Iteration {
                scenario: &room,
                ants: &ants,
                number,
                budget: 9,
                best_so_far: Some(&best),
                streams: Streams::new(1, "test", 0),
            };
            let trails = updated(&mut MaxMinAntSystem::new(params), 1.0, iteration);
            let turn = number % 3 == 0;
            near(&trails, 0, E, if turn { 1.25 } else { 0.75 });
            near(&trails, 0, SE, if turn { 0.75 } else { 0.75 + 1.0 / (2.0 * std::f64::consts::SQRT_2) });
        }
    }
}

mod ant_colony_system {
    use super::*;

    fn corridor() -> Arc<Scenario> {
        scenario(&["..."], Moves::Eight, Point::new(0, 0), Point::new(2, 0))
    }

    /// τ0 = 1/(n·L_open) = 1/(2·2) = 0.25. Iteration 1: 0.9·0.25 + 0.1·0.25 = 0.25 for each of two ants (eq. 3.12), then
    /// 0.8·0.25 + 0.2/2 = 0.3 (eq. 3.11). Iteration 2: 0.9·0.3 + 0.025 = 0.295, 0.9·0.295 + 0.025 = 0.2905, 0.8·0.2905 + 0.1 = 0.3324.
    #[test]
    fn eq_3_11_and_3_12_on_the_best_path_only() {
        let numbers = [("ants", 2.0), ("rho", 0.2), ("xi", 0.1)];
        assert_near(&trails(&corridor(), "ant-colony-system", &numbers, 2), &[(0.3, 0.25), (0.3324, 0.25)]);
    }

    /// The local update comes with each move: after the first move of the second iteration the start's step has been passed twice.
    #[test]
    fn eq_3_12_on_each_move() {
        let mut planner = build(&corridor(), "ant-colony-system", &[("ants", 2.0), ("rho", 0.2), ("xi", 0.1)]);
        planner.advance(Granularity::Iteration);
        planner.advance(Granularity::Move);
        let mut field = Vec::new();
        planner.layer(Layer::Trail, &mut field);
        assert_near(&[(field[0], field[1])], &[(0.2905, 0.3)]);
    }

    /// Eq. 3.10 with q0 = 1 and no local update: all ants of an iteration take the same way, the first best step each time.
    #[test]
    fn eq_3_10_with_q0_of_one_is_greedy() {
        let mut planner = build(&room(), "ant-colony-system", &[("q0", 1.0), ("xi", 0.0), ("iterations", 3.0)]);
        planner.run();
        assert!(planner.history().iter().all(|r| r.iteration_best == Some(2.0) && r.iteration_worst == Some(2.0)));
    }
}

mod best_worst_ant_system {
    use super::*;
    use formicarium::aco::best_worst_ant_system::{BestWorstAntSystem, BestWorstAntSystemParams};

    /// τ0 = 1/(n·L_open) = 1/(2·2) = 0.25. 0.5·0.25 + 1/4 = 0.375, then 0.5·0.375 + 1/4 = 0.4375; the worst is the best, and loses nothing.
    #[test]
    fn the_best_so_far_alone_deposits() {
        let numbers = [("ants", 4.0), ("rho", 0.5), ("mutation_probability", 0.0), ("restart_below", 0.0)];
        assert_near(&trails(&bend(), "best-worst-ant-system", &numbers, 2), &[(0.375, 0.125), (0.4375, 0.0625)]);
    }

    /// Every ant takes the only way: best and worst are alike, and after each iteration all trails are τ0 again.
    #[test]
    fn trails_start_again_where_best_and_worst_are_alike() {
        let numbers = [("ants", 4.0), ("rho", 0.5)];
        assert_near(&trails(&bend(), "best-worst-ant-system", &numbers, 2), &[(0.25, 0.25), (0.25, 0.25)]);
        // A single ant that arrives is no worst one; without mutation trails go on as above.
        let numbers = [("ants", 1.0), ("rho", 0.5), ("mutation_probability", 0.0)];
        assert_near(&trails(&bend(), "best-worst-ant-system", &numbers, 2), &[(0.375, 0.125), (0.4375, 0.0625)]);
    }

    /// The worst way, 2 + √2 long, shares its first step with the best, 2 long.
    fn two_ways(room: &Scenario) -> ([Ant; 2], Solution) {
        let best = Solution { path: vec![0, 1, 2], length: 2.0, iteration: 1, refined: None };
        ([&[E, E][..], &[E, SE, N]].map(|steps| walked(room, steps)), best)
    }

    /// τ = 4, ρ = 0.5: 2 + 1/2 on the best; 4·0.5·0.5 where only the worst goes; 2 elsewhere.
    #[test]
    fn the_worst_evaporates_again_where_the_best_does_not_go() {
        let room = room();
        let (ants, best) = two_ways(&room);
        let streams = Streams::new(1, "test", 0);
        let iteration = Iteration { scenario: &room, ants: &ants, number: 1, budget: 9, best_so_far: Some(&best), streams };
        for (worst_evaporates, expected) in [(true, 1.0), (false, 2.0)] {
            let params = BestWorstAntSystemParams { rho: 0.5, worst_evaporates, ..Default::default() };
            let trails = updated(&mut BestWorstAntSystem::new(params), 4.0, iteration);
            [(0, E), (1, E)].iter().for_each(|&(c, d)| near(&trails, c, d, 2.5));
            [(1, SE), (5, N)].iter().for_each(|&(c, d)| near(&trails, c, d, expected));
            near(&trails, 0, SE, 2.0);
        }
    }

    /// mut(t) = σ·τ_mean·(t − t_r)/(T − t_r): 4·0.5·25/100 = 0.5; after a restart in iteration 20 4·0.5·(25 − 20)/80 = 0.125.
    #[test]
    fn mutations_grow_from_the_last_restart_to_the_end() {
        let mut variant = BestWorstAntSystem::new(BestWorstAntSystemParams::default());
        assert_eq!([25, 100].map(|t| variant.mutation(0.5, t, 100)), [0.5, 2.0]);
        let room = room();
        let ants = [&[E, E][..], &[E, E]].map(|steps| walked(&room, steps));
        let (_, best) = two_ways(&room);
        let streams = Streams::new(1, "test", 0);
        let iteration = Iteration { scenario: &room, ants: &ants, number: 20, budget: 100, best_so_far: Some(&best), streams };
        let mut trails = Trails::new(room.grid.len(), 4.0);
        variant.daemon_actions(&mut trails, iteration);
        near(&trails, 0, E, 0.25);
        assert_eq!(variant.mutation(0.5, 25, 100), 0.125);
    }

    /// With P_m = 1 each cell has one step that gains or loses σ·τ_mean·t/T = 0.5·4·1/4; which one depends on the iteration alone.
    #[test]
    fn one_step_of_a_cell_mutates() {
        let room = room();
        let (ants, best) = two_ways(&room);
        let params = BestWorstAntSystemParams { mutation_probability: 1.0, mutation_strength: 0.5, ..Default::default() };
        let mutated = |number: u32, budget: u32| {
            let streams = Streams::new(1, "test", 0);
            let iteration = Iteration { scenario: &room, ants: &ants, number, budget, best_so_far: Some(&best), streams };
            let mut trails = Trails::new(room.grid.len(), 4.0);
            BestWorstAntSystem::new(params).daemon_actions(&mut trails, iteration);
            (0..6)
                .flat_map(|c| room.moves.directions(c).map(move |d| (c, d)))
                .map(|(c, d)| (c, trails.get(c, d)))
                .collect::<Vec<_>>()
        };
        let found = mutated(1, 4);
        for cell in 0..6 {
            let of_cell: Vec<f64> = found.iter().filter(|(c, t)| *c == cell && *t != 4.0).map(|(_, t)| *t).collect();
            assert!(of_cell == [4.5] || of_cell == [3.5], "cell {cell}: {of_cell:?}");
        }
        assert_eq!(mutated(1, 4), found);
        assert_ne!(mutated(2, 8), found, "the same amount in another iteration");
    }
}
