//! Fan, Zhang, Liu, Zhu 2026 (rescue robot in a ship's engine room).

use std::sync::Arc;

use formicarium::aco::ant::{Ant, Walk};
use formicarium::aco::ant_system::{AntSystem, AntSystemParams};
use formicarium::aco::dead_end::DeadEnd;
use formicarium::aco::heuristic::Heuristic;
use formicarium::aco::on_demand::OnDemand;
use formicarium::aco::ship::{
    Evaporation, RhoPart, Ship, ShipParams, Update, eta, evaporation, extra_trail, log_eta, omega, path_weights, sight,
};
use formicarium::aco::trails::Trails;
use formicarium::aco::variant::{Iteration, Variant};
use formicarium::aco::weights::Weights;
use formicarium::catalog;
use formicarium::map::{Cell, Direction, Generator, Grid, Movement, Point, generate, length_on_plane, step_length};
use formicarium::metrics::obstacle_density;
use formicarium::params::{Value, Values};
use formicarium::path::{Refinement, refine};
use formicarium::planner::Reading;
use formicarium::planner::{Layer, Objective, Solution};
use formicarium::rng::Streams;
use formicarium::scenario::Scenario;

use super::{E, NE, SE, SQRT2, close};

const S: Direction = 6;

/// 9 × 9 cells, walls at (3, 1) and (4, 1), goal (5, 6): from (2, 2) the goal lies at (+3, +4), 5 cells away.
fn two_walls() -> Scenario {
    let mut grid = Grid::open(9, 9).expect("a usable size");
    for wall in [Point::new(3, 1), Point::new(4, 1)] {
        grid.set_blocked(grid.cell(wall), true);
    }
    Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(5, 6)).expect("usable")
}

/// η of the step from (2, 2) at this ω by Eq. 7, with μ = 10 and γ = 1.
fn eta_at(reading: Reading, omega: f64, d: Direction) -> f64 {
    let s = two_walls();
    let i = s.grid.cell(Point::new(2, 2));
    eta(&ShipParams::default(), omega, &sight(reading, &s, i, d, s.moves.step(i, d)), step_length(d))
}

#[test]
fn eq_2_the_basic_heuristic_as_printed_and_by_the_distance_to_the_goal() {
    let s = two_walls();
    let i = s.grid.cell(Point::new(2, 2));
    let seen = |heuristic: Heuristic, d| heuristic.of(&s, i, d, s.moves.step(i, d));
    // d_ij, the step's length: 1 and √2.
    assert!(close(seen(Heuristic::Step, E), 1.0) && close(seen(Heuristic::Step, SE), 1.0 / SQRT2));
    // The goal lies at (+2, +4) from (3, 2), at (+2, +3) from (3, 3): 1/√20 and 1/√13.
    assert!(close(seen(Heuristic::Goal, E), 0.2236068) && close(seen(Heuristic::Goal, SE), 0.2773501));
}

#[test]
fn eq_3_to_5_the_basic_update_evaporates_and_every_ant_adds() {
    let both = Corridor::walked(&BOTH);
    let mut basic = AntSystem::new(AntSystemParams { rho: 0.8, deposit: 10.0, ..AntSystemParams::default() });
    let mut trails = Trails::new(both.scenario.grid.len(), 10.0);
    let iteration = Iteration {
        scenario: &both.scenario,
        ants: &both.ants,
        number: 1,
        budget: 100,
        best_so_far: None,
        streams: Streams::new(1, "test", 0),
    };
    basic.update_trails(&mut trails, iteration);
    // 0.2·10 + 10/2, 0.2·10 + 10/(2√2), and 0.2·10 where nobody came by.
    all_close([trails.get(1, E), trails.get(4, NE), trails.get(3, E)], [7.0, 5.5355339, 2.0]);
    let preset = catalog::find("ant-system").expect("listed").presets.iter().find(|p| p.name == "ship").expect("the paper's");
    let given = [("ants", 50.0), ("iterations", 100.0), ("beta", 2.0), ("rho", 0.8), ("deposit", 10.0)];
    assert!(given.iter().all(|g| preset.numbers.contains(g)), "section 4; α = 1 is the default");
    assert_eq!(AntSystemParams::default().selection.alpha, 1.0);
}

#[test]
fn eq_6_omega_grows_linearly_from_its_least_to_its_largest() {
    let p = ShipParams::default();
    assert_eq!([0, 50, 100].map(|t| omega(&p, t)), [2.0, 3.0, 4.0], "in both readings");
    let mut falling = ShipParams { omega_min: 3.0, omega_max: 1.0, ..p };
    falling.selection.iterations = 4;
    assert_eq!(omega(&falling, 1), 2.5);
}

#[test]
fn eq_7_repaired_looks_at_the_candidate() {
    let s = two_walls();
    let i = s.grid.cell(Point::new(2, 2));
    // East to (3, 2): goal at (+2, +4) from there, cos θ = 3/5, two of eight cells blocked.
    let east = sight(Reading::Repaired, &s, i, E, s.moves.step(i, E));
    assert!(close(east.pull, 1.0 / 20f64.sqrt()) && close(east.angle, 0.8), "{east:?}");
    assert_eq!((east.distance, east.density), (5.0, 0.25));
    // (10^0.2236068 · 5^0.8)^2 · e^−0.25 = (1.673427 · 3.623898)^2 · 0.778801
    assert!(close(eta_at(Reading::Repaired, 2.0, E), 28.6412509), "{}", eta_at(Reading::Repaired, 2.0, E));
    // South to (2, 3): goal at (+3, +3), cos θ = 4/5, no wall: (10^0.2357023 · 5^0.9)^2
    assert!(close(eta_at(Reading::Repaired, 2.0, S), 53.6476285), "{}", eta_at(Reading::Repaired, 2.0, S));
    // South-east to (3, 3): goal at (+2, +3), cos θ = 7 / (5√2), no wall: (10^0.2773501 · 5^0.9949747)^2 / √2
    assert!(close(eta_at(Reading::Repaired, 2.0, SE), 62.3878766), "{}", eta_at(Reading::Repaired, 2.0, SE));
}

#[test]
fn eq_7_printed_looks_at_the_cell_itself_and_prefers_straight_steps_only() {
    let s = two_walls();
    let i = s.grid.cell(Point::new(2, 2));
    // One wall around (2, 2), to the north-east: cos θ = (3 − 4) / (5√2), h = 0.4292893, α_obs = 1/8, f_a = 1.
    for d in [E, S, SE] {
        let seen = sight(Reading::Printed, &s, i, d, s.moves.step(i, d));
        assert!(close(seen.angle, 0.4292893) && seen.pull == 1.0 && seen.density == 0.125, "{seen:?}");
    }
    // (10 · 5^0.4292893)^2 · e^−0.125, and divided by √2
    assert!(close(eta_at(Reading::Printed, 2.0, E), 351.4260152), "{}", eta_at(Reading::Printed, 2.0, E));
    assert_eq!(eta_at(Reading::Printed, 2.0, E), eta_at(Reading::Printed, 2.0, S));
    assert!(close(eta_at(Reading::Printed, 2.0, SE) * SQRT2, 351.4260152));
}

#[test]
fn eq_7_density_counts_the_border_as_blocked() {
    let s = two_walls();
    assert_eq!(obstacle_density(&s, s.grid.cell(Point::new(0, 0))), 0.625, "5 of 8 lie beyond the corner");
    assert_eq!(obstacle_density(&s, s.grid.cell(Point::new(3, 2))), 0.25);
    assert_eq!(obstacle_density(&s, s.grid.cell(Point::new(5, 6))), 0.0);
}

#[test]
fn eq_1_and_7_probabilities_on_demand_are_those_of_the_formula() {
    let made = generate(Generator::Random, 24, 24, 3, 0.25).expect("a usable size");
    let s = Scenario::on(made.grid, Movement::default(), made.start, made.goal).expect("usable");
    for reading in [Reading::Repaired, Reading::Printed] {
        let p = ShipParams { reading, ..ShipParams::default() };
        let (mut ship, mut trails) = (Ship::new(p), Trails::new(s.grid.len(), 1.0));
        let mut tables = OnDemand::new(s.grid.len(), p.selection.alpha, p.selection.beta);
        for t in [1, 37, 100] {
            trails.evaporate(0.25);
            for c in s.moves.directions(s.start).map(|d| s.moves.step(s.start, d)) {
                s.moves.directions(c).for_each(|d| trails.deposit(c, d, f64::from(d)));
            }
            ship.begin_iteration(t);
            tables.another_time();
            tables.outdate(&mut trails);
            for c in 0..s.grid.len() as Cell {
                let seen = |d| ship.heuristic(&s, c, d, s.moves.step(c, d));
                let weight = |d: Direction| trails.get(c, d) * seen(d).powi(2);
                let sum: f64 = s.moves.directions(c).map(weight).sum();
                let row = *tables.now(&s, &ship, &trails).row(c);
                let got: f64 = row.iter().map(|&w| f64::from(w)).sum();
                for d in s.moves.directions(c) {
                    let (p, expected) = (f64::from(row[d as usize]) / got, weight(d) / sum);
                    assert!((p - expected).abs() <= 1e-4 * expected, "{reading:?}, t = {t}, cell {c}: {p}, {expected}");
                    let (a, b) = ship.log_heuristic(&s, c, d, s.moves.step(c, d));
                    assert!(close(a + b * ship.time(), seen(d).ln()));
                }
                assert!((0..8).all(|d| row[d] == 0.0 || s.moves.bits[c as usize] >> d & 1 == 1), "an infeasible step");
            }
        }
    }
}

#[test]
fn eq_8_the_additional_trail() {
    let p = ShipParams { k_best: 1.5, k_worst: 0.8, ..ShipParams::default() };
    // 1.5 · 10/5 and 0.8 · 10/8
    assert_eq!(extra_trail(&p, 5.0, 8.0), (3.0, 1.0));
}

#[test]
fn eq_10_and_11_weights_of_the_paths() {
    let at = |t| {
        let w = path_weights(t, 100);
        [w.global_best, w.iteration_best, w.iteration_worst]
    };
    assert_eq!(at(0), [0.5, 1.0, 0.0]);
    assert_eq!(at(50), [0.75, 0.75, 0.0]);
    assert_eq!(at(75), [0.875, 0.625, 0.25]);
    assert_eq!(at(100), [1.0, 0.5, 0.5]);
}

/// 3 × 2 free cells, from (0, 0) to (2, 0): an ant east twice (length 2), or one over (1, 1) (length 2√2), or both.
struct Corridor {
    scenario: Arc<Scenario>,
    ants: Vec<Ant>,
}

impl Corridor {
    fn walked(ways: &[[Direction; 2]]) -> Self {
        let grid = Grid::open(3, 2).expect("a usable size");
        let scenario = Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(2, 0)).expect("usable");
        let walk = Walk { moves: &scenario.moves, goal: scenario.goal, dead_end: DeadEnd::Die, max_moves: 9 };
        let ants = ways.iter().map(|way| {
            let stream = || Streams::new(1, "test", 0).ant(0, 0);
            let mut ant = Ant::new(3, 2, stream());
            ant.begin(3, scenario.start, stream());
            way.iter().for_each(|&d| ant.go(&walk, Some(d)));
            ant
        });
        let ants = ants.collect();
        Self { scenario: Arc::new(scenario), ants }
    }

    /// τ of a step of the short way, of one of the long way and of one that nobody took, after the update at t of 100; before it all are
    /// 10, and half evaporates.
    fn updated(&self, reading: Reading, update: Update, t: u32) -> [f64; 3] {
        self.updated_by(ShipParams { reading, update, rho: 0.5, ..ShipParams::default() }, t)
    }

    fn updated_by(&self, params: ShipParams, t: u32) -> [f64; 3] {
        let mut ship = Ship::new(params);
        let mut trails = Trails::new(self.scenario.grid.len(), 10.0);
        let best = Solution { path: vec![0, 1, 2], length: 2.0, iteration: 1, refined: None };
        let iteration = Iteration {
            scenario: &self.scenario,
            ants: &self.ants,
            number: t,
            budget: 100,
            best_so_far: Some(&best),
            streams: Streams::new(1, "test", 0),
        };
        ship.update_trails(&mut trails, iteration);
        [trails.get(1, E), trails.get(4, NE), trails.get(3, E)]
    }
}

const BOTH: [[Direction; 2]; 2] = [[E, E], [SE, NE]];

fn all_close(got: [f64; 3], expected: [f64; 3]) {
    assert!(got.iter().zip(expected).all(|(&a, b)| close(a, b)), "{got:?}, expected {expected:?}");
}

#[test]
fn eq_9_to_11_and_14_repaired() {
    let both = Corridor::walked(&BOTH);
    // Q/L = 5 and 3.5355339. t = 50: 5 + 0.75·5 + 0.75·5 + 5, and 5 − 0·3.5355339 − 3.5355339
    all_close(both.updated(Reading::Repaired, Update::Weighted, 50), [17.5, 1.4644661, 5.0]);
    // t = 75: 5 + (0.875 + 0.625)·5 + 5, and 5 − (0.25 + 1)·3.5355339
    all_close(both.updated(Reading::Repaired, Update::Weighted, 75), [17.5, 0.5805826, 5.0]);
    // t = 100: 5 − (0.5 + 1)·3.5355339 < 0 stops at τ_min
    all_close(both.updated(Reading::Repaired, Update::Weighted, 100), [17.5, 1e-6, 5.0]);
    // Only the long way in this iteration: it is best and worst. 5 + 1·5, and 5 + (0.5 − 0.5 + 1 − 1)·3.5355339
    let long = Corridor::walked(&[[SE, NE]]);
    all_close(long.updated(Reading::Repaired, Update::Weighted, 100), [10.0, 5.0, 5.0]);
    // Nobody arrived: only the global best gains.
    let lost = Corridor::walked(&[[SE, 3]]);
    all_close(lost.updated(Reading::Repaired, Update::Weighted, 100), [10.0, 5.0, 5.0]);
}

#[test]
fn eq_9_to_11_and_14_printed() {
    let both = Corridor::walked(&BOTH);
    // Δω* = 5 − 3.5355339 = 1.4644661 on every step. t = 50: 5 + 7.5 + Δω*, 5 + Δω*, 5 + Δω*
    all_close(both.updated(Reading::Printed, Update::Weighted, 50), [13.9644661, 6.4644661, 6.4644661]);
    // t = 100: the long way loses 0.5·3.5355339
    all_close(both.updated(Reading::Printed, Update::Weighted, 100), [13.9644661, 4.6966991, 6.4644661]);
}

#[test]
fn eq_12_in_both_readings() {
    let both = Corridor::walked(&BOTH);
    // repaired: 5 + 5 + 5, and 5 + 3.5355339 − 3.5355339
    all_close(both.updated(Reading::Repaired, Update::AllAnts, 50), [15.0, 5.0, 5.0]);
    // printed: 5 + 5 + 1.4644661, 5 + 3.5355339 + 1.4644661, 5 + 1.4644661
    all_close(both.updated(Reading::Printed, Update::AllAnts, 50), [11.4644661, 10.0, 6.4644661]);
}

#[test]
fn eq_9_rho_leaves_or_stays() {
    // Nobody arrived and no path is known: 10·(1 − 0.8) or 10·0.8 of every trail.
    let unused = |rho_part| Corridor::walked(&[[SE, 3]]).updated_by(ShipParams { rho_part, ..ShipParams::default() }, 50)[2];
    assert!(close(unused(RhoPart::Leaves), 2.0) && close(unused(RhoPart::Stays), 8.0));
    assert_eq!(ShipParams::default().rho_part, RhoPart::Leaves);
    let preset = catalog::find("ship").expect("listed").presets.iter().find(|p| p.name == "second-reading").expect("offered");
    assert_eq!(preset.values(), [("rho_part".to_string(), Value::from("stays"))].into());
}

#[test]
fn section_4_rho_as_the_initial_factor_shrinks_to_its_least() {
    let p = ShipParams { evaporation: Evaporation::Shrinking, ..ShipParams::default() };
    // 0.8, 0.8·0.95, 0.8·0.95², …, 0.8·0.95^40 = 0.1028097, and 0.8·0.95^41 < 0.1.
    let at = [1, 2, 3, 41, 42, 100].map(|t| evaporation(&p, t, Some((2.0, 3.0))));
    let expected = [0.8, 0.76, 0.722, 0.1028097, 0.1, 0.1];
    assert!(at.iter().zip(expected).all(|(&a, b)| close(a, b)), "{at:?}");
    // Of what stays, 0.2 leaves at first; where less leaves than the least from the beginning, it goes on leaving.
    assert!(close(evaporation(&ShipParams { rho_part: RhoPart::Stays, ..p }, 2, None), 0.19));
    assert_eq!(evaporation(&ShipParams { rho: 0.05, ..p }, 7, None), 0.05);
    // t = 2: 10·(1 − 0.76).
    assert!(close(Corridor::walked(&BOTH).updated_by(p, 2)[2], 2.4));
}

#[test]
fn section_3_2_the_difference_of_best_and_worst_regulates_evaporation() {
    let p = ShipParams { evaporation: Evaporation::ByLengths, ..ShipParams::default() };
    // Best 2, worst 2√2: 0.1 + 0.7·(1 − 0.7071068) = 0.3050252. All equally long, or none arrived: 0.1.
    assert!(close(evaporation(&p, 9, Some((2.0, 2.0 * SQRT2))), 0.3050252));
    assert!(close(evaporation(&p, 9, Some((3.0, 3.0))), 0.1) && close(evaporation(&p, 9, None), 0.1));
    // Two ways: 10·(1 − 0.3050252); one alone: 10·0.9.
    assert!(close(Corridor::walked(&BOTH).updated_by(p, 50)[2], 6.9497475));
    assert!(close(Corridor::walked(&[[E, E]]).updated_by(p, 50)[2], 9.0));
    // The constant rate of every equation looks at neither.
    assert_eq!(evaporation(&ShipParams::default(), 99, Some((2.0, 9.0))), 0.8);
}

#[test]
fn steps_3_and_4_paths_count_by_their_ants() {
    let p = ShipParams { count_ants: true, rho: 0.5, ..ShipParams::default() };
    // Two ants on the short way, which is the best so far as well, one on the long way. t = 50:
    // 5 + 2·(0.75·5 + 0.75·5 + 5), 5 − (0 + 1)·3.5355339, 5.
    let two_short = Corridor::walked(&[[E, E], [SE, NE], [E, E]]);
    all_close(two_short.updated_by(p, 50), [30.0, 1.4644661, 5.0]);
    // Printed, Δω* = 2·5 − 3.5355339 = 6.4644661 on every step: 5 + 2·7.5 + Δω*, 5 + Δω*.
    all_close(two_short.updated_by(ShipParams { reading: Reading::Printed, ..p }, 50), [26.4644661, 11.4644661, 11.4644661]);
    // Two on the long way, Q = 4: 5 + 0.75·2 + 0.75·2 + 2, 5 − 2·1.4142136.
    let two_long = Corridor::walked(&[[SE, NE], [E, E], [SE, NE]]);
    all_close(two_long.updated_by(ShipParams { deposit: 4.0, ..p }, 50), [10.0, 2.1715729, 5.0]);
    // The best so far counts once where nobody walked it: 5 + 1·5.
    all_close(Corridor::walked(&[[SE, 3]]).updated_by(p, 100), [10.0, 5.0, 5.0]);
    // Eq. 12 sums over the ants anyway: 5 + 2·5 + 5, and 5 + 3.5355339 − 3.5355339.
    let all = |count_ants| two_short.updated_by(ShipParams { count_ants, update: Update::AllAnts, ..p }, 50);
    all_close(all(true), [20.0, 5.0, 5.0]);
    assert_eq!(all(true), all(false));
}

#[test]
fn section_3_3_refinement_keeps_the_farthest_node_in_sight() {
    // Fig. 2 and 3: legs that a free straight way can replace are dropped, an obstacle keeps its node.
    let mut grid = Grid::open(6, 4).expect("a usable size");
    for wall in [Point::new(2, 0), Point::new(2, 1)] {
        grid.set_blocked(grid.cell(wall), true);
    }
    let s = Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(5, 0)).expect("usable");
    // The wall hides all after (1,2) from the start, the goal from (1,2), nothing from (3,2).
    let path: Vec<Cell> =
        [(0, 0), (0, 1), (0, 2), (1, 2), (2, 2), (3, 2), (4, 1), (5, 0)].map(|(x, y)| s.grid.cell(Point::new(x, y))).into();
    assert_eq!(Ship::new(ShipParams::default()).refinement(), Refinement::Farthest);
    let refined = refine(&s, &path, Refinement::Farthest);
    let kept: Vec<_> = refined.iter().map(|&c| (s.grid.point(c).x, s.grid.point(c).y)).collect();
    assert_eq!(kept, [(0, 0), (1, 2), (3, 2), (5, 0)]);
    // 2 + 3 + 2√2 before, √5 + 2 + 2√2 after
    let lengths = [&path, &refined].map(|p| length_on_plane(6, p));
    assert!(close(lengths[0], 5.0 + 2.0 * SQRT2) && close(lengths[1], 5f64.sqrt() + 2.0 + 2.0 * SQRT2), "{lengths:?}");
    // From each of these nodes all that follow are in sight up to the last: node by node gives the same.
    assert_eq!(refine(&s, &path, Refinement::Next), refined);
}

#[test]
fn section_3_3_refinement_is_the_last_step_and_changes_no_walk() {
    let made = generate(Generator::Random, 24, 24, 3, 0.25).expect("a usable size");
    let s = Arc::new(Scenario::on(made.grid, Movement::default(), made.start, made.goal).expect("usable"));
    let run = |preset| {
        let mut planner = catalog::build(&s, "ship", preset, &Values::new(), 7).expect("usable");
        planner.run();
        planner
    };
    let (refined, cells) = (run(None), run(Some("cells")));
    assert_eq!(refined.history(), cells.history(), "the search is the same");
    assert_eq!((refined.objective(), cells.objective()), (Objective::PolylineLength, Objective::Length));
    let [a, b] = [&refined, &cells].map(|p| p.best().expect("a path"));
    assert_eq!((&a.path, a.length, a.iteration, &b.refined), (&b.path, b.length, b.iteration, &None));
    assert_eq!(
        a.refined.as_ref().map(|r| &r.path),
        Some(&refine(&s, &b.path, Refinement::Farthest)),
        "step 6: the best path is refined"
    );
    assert!(a.result().1 < a.length);
}

#[test]
fn fig_7_the_density_is_a_layer() {
    let s = Arc::new(two_walls());
    let planner = catalog::build(&s, "ship", None, &Values::new(), 1).expect("usable");
    let mut field = Vec::new();
    assert!(planner.layer(Layer::Density, &mut field));
    let at = |x, y| field[s.grid.cell(Point::new(x, y)) as usize];
    assert_eq!([at(0, 0), at(3, 2), at(5, 6)], [0.625, 0.25, 0.0]);
    let listed = catalog::find("ship").expect("listed").layers;
    assert!(listed.contains(&Layer::Density) && listed.contains(&Layer::Heuristic));
}

#[test]
fn eq_13_the_heuristic_is_bounded() {
    let made = generate(Generator::Random, 32, 32, 5, 0.3).expect("a usable size");
    let s = Scenario::on(made.grid, Movement::default(), made.start, made.goal).expect("usable");
    let farthest = 31.0 * SQRT2;
    for reading in [Reading::Repaired, Reading::Printed] {
        let p = ShipParams { reading, ..ShipParams::default() };
        for c in 0..s.grid.len() as Cell {
            for d in s.moves.directions(c) {
                let seen = sight(reading, &s, c, d, s.moves.step(c, d));
                let (low, high) = ((-1f64).exp() / SQRT2, (10.0 * farthest).powi(4));
                assert!((low..=high).contains(&eta(&p, 4.0, &seen, step_length(d))), "{seen:?}");
                assert!(log_eta(&p, &seen, step_length(d)).1 >= 0.0, "η grows with ω");
            }
        }
    }
}
