//! Planners without one of their components: what is left by hand, and where all are out, the rule that the publication starts from.

use std::sync::Arc;

use formicarium::aco::ant::{Ant, Walk};
use formicarium::aco::ant_colony_system::{AntColonySystem, AntColonySystemParams, ColonySystemRows};
use formicarium::aco::dead_end::DeadEnd;
use formicarium::aco::elitist_ant_system::{ElitistAntSystem, ElitistAntSystemParams};
use formicarium::aco::fireworks::{ColonyRows, seed_trail};
use formicarium::aco::max_min_ant_system::{MaxMinAntSystem, MaxMinAntSystemParams, MaxMinRows};
use formicarium::aco::rank_based_ant_system::{RankBasedAntSystem, RankBasedAntSystemParams};
use formicarium::aco::ship::{MEAN_WEIGHTS, Ship, ShipParams, Update, eta, omega, path_weights, seen};
use formicarium::aco::threshold::{Acomsp, AcomspParams};
use formicarium::aco::trails::{Row, Trails};
use formicarium::aco::variant::{Iteration, Step, Variant};
use formicarium::catalog;
use formicarium::map::{Direction, Grid, Movement, Point};
use formicarium::params::{Value, Values};
use formicarium::planner::{Granularity, Layer, Solution};
use formicarium::rng::{Stream, Streams};
use formicarium::scenario::Scenario;
use formicarium::swarm::explosion::{cooled_radius, inertia, mutation_factor};

use super::{E, NE, SE, SQRT2, close};

fn all_close(got: [f64; 3], expected: [f64; 3]) {
    assert!(got.iter().zip(expected).all(|(&a, b)| close(a, b)), "{got:?}, expected {expected:?}");
}

fn open(width: u32, height: u32, start: (u32, u32), goal: (u32, u32)) -> Arc<Scenario> {
    let grid = Grid::open(width, height).expect("a usable size");
    let ends = (Point::new(start.0, start.1), Point::new(goal.0, goal.1));
    Arc::new(Scenario::on(grid, Movement::default(), ends.0, ends.1).expect("usable"))
}

fn stream() -> Stream {
    Streams::new(1, "test", 0).ant(0, 0)
}

/// τ of a step of the short way (length 2), of one of the long way (2√2) and of one that nobody took, after a variant's update at t of
/// 100 in which one ant walked each way; before it all are `initial`. The short way is the best so far.
fn updated<V: Variant>(mut variant: V, initial: f64, t: u32) -> [f64; 3] {
    let scenario = open(3, 2, (0, 0), (2, 0));
    let walk = Walk { moves: &scenario.moves, goal: scenario.goal, dead_end: DeadEnd::Die, max_moves: 9 };
    let ants = [[E, E], [SE, NE]].map(|way| {
        let mut ant = Ant::new(3, 2, stream());
        ant.begin(3, scenario.start, stream());
        way.iter().for_each(|&d| ant.go(&walk, Some(d)));
        ant
    });
    let best = Solution { path: vec![0, 1, 2], length: 2.0, iteration: 1, refined: None };
    let mut trails = Trails::new(scenario.grid.len(), initial);
    variant.prepare(&scenario);
    variant.update_trails(
        &mut trails,
        Iteration {
            scenario: &scenario,
            ants: &ants,
            number: t,
            budget: 100,
            best_so_far: Some(&best),
            streams: Streams::new(1, "test", 0),
        },
    );
    [trails.get(1, E), trails.get(4, NE), trails.get(3, E)]
}

/// How often each direction is selected, as a share of 40 000 draws.
fn shares(mut select: impl FnMut(&mut Stream) -> Option<Direction>) -> [f64; 8] {
    let (mut stream, mut shares) = (stream(), [0.0; 8]);
    (0..40_000).for_each(|_| shares[select(&mut stream).expect("a step is left") as usize] += 1.0 / 40_000.0);
    shares
}

/// Probabilities 0.1, 0.3 and 0.6.
const WEIGHTS: Row = [0.0, 1.0, 0.0, 3.0, 6.0, 0.0, 0.0, 0.0];

fn are_proportional(shares: [f64; 8]) -> bool {
    [(1, 0.1), (3, 0.3), (4, 0.6)].iter().all(|&(d, p)| (shares[d] - p).abs() < 0.01)
}

mod ship {
    use super::*;

    fn updated(p: ShipParams, t: u32) -> [f64; 3] {
        super::updated(Ship::new(ShipParams { rho: 0.5, ..p }), 10.0, t)
    }

    /// η of the step in direction `d` from (2, 2), with the goal at (+3, +4), 5 cells away, and walls at (3, 1) and (4, 1).
    fn eta_of(p: &ShipParams, omega: f64, d: Direction) -> f64 {
        let mut grid = Grid::open(9, 9).expect("a usable size");
        [(3, 1), (4, 1)].iter().for_each(|&(x, y)| grid.set_blocked(grid.cell(Point::new(x, y)), true));
        let s = Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(5, 6)).expect("usable");
        let i = s.grid.cell(Point::new(2, 2));
        eta(p, omega, &seen(p, &s, i, d, s.moves.step(i, d)), s.moves.length(i, d))
    }

    #[test]
    fn eq_7_without_one_factor() {
        let p = ShipParams::default();
        // East, ω = 2: (10^0.2236068 · 5^0.8)^2 · e^−0.25 = 28.6412509 with everything.
        assert!(close(eta_of(&p, 2.0, E), 28.6412509));
        // 10^0.4472136 · e^−0.25 = 2.800358 · 0.778801
        assert!(close(eta_of(&ShipParams { direction: false, ..p }, 2.0, E), 2.1809212));
        // 5^1.6 · e^−0.25 = 13.132639 · 0.778801
        assert!(close(eta_of(&ShipParams { goal_pull: 1.0, ..p }, 2.0, E), 10.2277096));
        // (1.673427 · 3.623898)^2
        assert!(close(eta_of(&ShipParams { obstacle_push: 0.0, ..p }, 2.0, E), 36.7760941));
    }

    #[test]
    fn eq_7_without_all_three_is_eq_2_the_basic_heuristic() {
        let p = ShipParams { direction: false, goal_pull: 1.0, obstacle_push: 0.0, ..ShipParams::default() };
        for w in [2.0, 3.0, 4.0] {
            assert_eq!((eta_of(&p, w, E), eta_of(&p, w, SE)), (1.0, 1.0 / SQRT2));
        }
    }

    #[test]
    fn eq_6_without_growth_is_the_mean() {
        let p = ShipParams { growing_pull: false, ..ShipParams::default() };
        assert_eq!([0, 1, 100].map(|t| omega(&p, t)), [3.0; 3]);
        assert_eq!(omega(&ShipParams { omega_min: 1.0, omega_max: 4.0, ..p }, 7), 2.5);
    }

    #[test]
    fn eq_10_and_11_without_their_shift_are_the_means_over_the_run() {
        // The mean over a fine run: 0.75, 0.75 and ∫ (s − ½) ds from ½ to 1 = 1/8.
        let run = |of: fn(u32) -> f64| (1..=10_000).map(of).sum::<f64>() / 10_000.0;
        assert!((run(|t| path_weights(t, 10_000).global_best) - MEAN_WEIGHTS.global_best).abs() < 1e-3);
        assert!((run(|t| path_weights(t, 10_000).iteration_best) - MEAN_WEIGHTS.iteration_best).abs() < 1e-3);
        assert!((run(|t| path_weights(t, 10_000).iteration_worst) - MEAN_WEIGHTS.iteration_worst).abs() < 1e-3);
        let p = ShipParams { shifting_weights: false, ..ShipParams::default() };
        // Q/L = 5 and 3.5355339, whenever: 5 + (0.75 + 0.75)·5 + 5, and 5 − (0.125 + 1)·3.5355339
        for t in [1, 50, 100] {
            all_close(updated(p, t), [17.5, 1.0225243, 5.0]);
        }
    }

    #[test]
    fn eq_8_to_11_without_the_worst_path_it_only_evaporates() {
        let p = ShipParams { weaken_worst: false, ..ShipParams::default() };
        for t in [50, 75, 100] {
            all_close(updated(p, t), [17.5, 5.0, 5.0]);
        }
        // Nor does Δω* as printed lose anything: 5 + 7.5 + 5 on the short way, 5 + 5 everywhere else.
        let printed = ShipParams { reading: formicarium::planner::Reading::Printed, ..p };
        all_close(updated(printed, 100), [17.5, 10.0, 10.0]);
    }

    #[test]
    fn eq_9_to_11_without_the_additional_trail() {
        let p = ShipParams { k_best: 0.0, k_worst: 0.0, ..ShipParams::default() };
        // t = 75: 5 + (0.875 + 0.625)·5, and 5 − 0.25·3.5355339
        all_close(updated(p, 75), [12.5, 4.1161165, 5.0]);
    }

    #[test]
    fn eq_12_without_the_additional_trail_is_the_update_of_ant_system() {
        let p = ShipParams { update: Update::AllAnts, k_best: 0.0, k_worst: 0.0, ..ShipParams::default() };
        // Eq. 3–5: 5 + 10/2, 5 + 10/(2√2), 5
        all_close(updated(p, 75), [10.0, 8.5355339, 5.0]);
    }
}

mod terrain {
    use super::*;

    /// Three cells in a row, goal last: η of the step onto the goal is 1/0.01 · e^(w·F), where F = 2·k·d0/(d0 + d) = 2·2/(2 + 1).
    fn eta_of_the_goal(values: &[(&str, &str)], iterations: usize) -> f64 {
        let values: Values = values.iter().map(|&(k, v)| (k.to_string(), Value::parse(v))).collect();
        let mut planner = catalog::build(&open(3, 1, (0, 0), (2, 0)), "terrain-epf", None, &values, 1).expect("valid");
        for _ in 0..iterations {
            planner.advance(Granularity::Iteration);
        }
        let mut field = Vec::new();
        assert!(planner.layer(Layer::Heuristic, &mut field));
        f64::from(field[2])
    }

    #[test]
    fn the_second_eq_12_without_fading_has_its_full_weight_all_the_time() {
        // In iteration 1 of 100: 100 · e^(0.99³ · 4/3), and in iteration 51 e^(0.49³ · 4/3).
        assert!((eta_of_the_goal(&[], 0) - 364.6369).abs() < 1e-2);
        assert!((eta_of_the_goal(&[], 50) - 116.9838).abs() < 1e-2);
        // 100 · e^(4/3)
        for iterations in [0, 50] {
            assert!((eta_of_the_goal(&[("force_fades", "false")], iterations) - 379.3668).abs() < 1e-2);
        }
    }

    #[test]
    fn the_second_eq_12_without_a_force_is_eq_2() {
        assert!((eta_of_the_goal(&[("force", "false")], 0) - 100.0).abs() < 1e-3);
    }
}

#[test]
fn acomsp_without_the_maximal_step_is_the_random_proportional_rule() {
    let variant = Acomsp::new(AcomspParams { maximal: false, ..AcomspParams::default() });
    assert!(are_proportional(shares(|stream| variant.choose(&WEIGHTS, stream))));
}

#[test]
fn fireworks_without_eq_9_have_the_radius_and_the_mutation_of_eq_3_and_5() {
    for g in [1, 25, 50] {
        assert_eq!((cooled_radius(3.0, 1.0, g, 50), inertia(1.0, 1.0, g, 50)), (3.0, 1.0));
    }
    assert_eq!(mutation_factor(2.25, 1.0), 2.25);
}

#[test]
fn a_hybrid_without_eq_10_adds_nothing_to_the_first_trails() {
    assert_eq!(seed_trail(&ColonyRows { seed_ants: 0.0, ..ColonyRows::default() }, 4.0), 0.0);
}

mod classics {
    use super::*;

    /// Eq. 3.6 with e = 0: 0.5·1 + 1/2, 0.5·1 + 1/(2√2), 0.5·1, as Ant System.
    #[test]
    fn elitist_ant_system_without_elitists_is_ant_system() {
        let p = ElitistAntSystemParams { elitists: 0.0, rho: 0.5, ..Default::default() };
        all_close(updated(ElitistAntSystem::new(p), 1.0, 1), [1.0, 0.8535534, 0.5]);
    }

    #[test]
    fn eq_3_8_without_ranks_or_without_the_best_so_far() {
        let after = |ranking, best_so_far| {
            let p = RankBasedAntSystemParams { ranks: 3, rho: 0.5, ranking, best_so_far, ..Default::default() };
            updated(RankBasedAntSystem::new(p), 3.0, 1)
        };
        // With both: 1.5 + 2/2 + 3/2, and 1.5 + 1/(2√2).
        all_close(after(true, true), [4.0, 1.8535534, 1.5]);
        // 1.5 + 1/2 + 3/2; 1.5 + 2/2; and as Ant System 1.5 + 1/2.
        all_close(after(false, true), [3.5, 1.8535534, 1.5]);
        all_close(after(true, false), [2.5, 1.8535534, 1.5]);
        all_close(after(false, false), [2.0, 1.8535534, 1.5]);
    }

    /// ρ = 0.5: τ_max = 1/(0.5·2) = 1, but 0.5·4 + 1/2 = 2.5 on the iteration's best path and 2 elsewhere stay as they are.
    #[test]
    fn max_min_ant_system_without_limits_lets_trails_grow_and_fall() {
        let after = |limits| {
            let p = MaxMinAntSystemParams { rules: MaxMinRows { rho: 0.5, limits, ..Default::default() }, ..Default::default() };
            updated(MaxMinAntSystem::new(p), 4.0, 1)
        };
        all_close(after(true), [1.0, 1.0, 1.0]);
        all_close(after(false), [2.5, 2.0, 2.0]);
    }

    #[test]
    fn ant_colony_system_without_q0_and_without_the_local_update() {
        let without = AntColonySystem::new(AntColonySystemParams {
            rules: ColonySystemRows { q0: 0.0, xi: 0.0, ..Default::default() },
            ..Default::default()
        });
        assert!(are_proportional(shares(|stream| without.choose(&WEIGHTS, stream))));
        let mut trails = Trails::new(6, 0.75);
        without.on_move(&mut trails, Step { from: 0, direction: E, walked: 1.0 });
        assert_eq!(trails.get(0, E), 0.75);
    }
}
