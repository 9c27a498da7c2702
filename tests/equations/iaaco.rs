//! Miao, Chen, Yan et al. 2021 (IAACO), as a reproduction has it.

use formicarium::aco::ant::{Ant, Walk};
use formicarium::aco::dead_end::DeadEnd;
use formicarium::aco::iaaco::{Iaaco, IaacoParams, evaporation, greed, guidance, visibility};
use formicarium::aco::trails::Trails;
use formicarium::aco::variant::{Abreast, Iteration, Variant};
use formicarium::catalog;
use formicarium::map::{Direction, Grid, Movement, Point};
use formicarium::params::Values;
use formicarium::planner::Reading;
use formicarium::rng::Streams;
use formicarium::scenario::Scenario;

use super::{E, NE, SE, SQRT2, close};

/// Three by two, from the upper left corner to the upper right one.
fn small() -> Scenario {
    let grid = Grid::open(3, 2).expect("a rectangle");
    Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(2, 0)).expect("usable")
}

/// An ant that has walked these steps.
fn walked(s: &Scenario, steps: &[Direction]) -> Ant {
    let streams = Streams::new(1, "iaaco", 0);
    let walk = Walk { moves: &s.moves, goal: s.goal, dead_end: DeadEnd::Die, max_moves: u32::MAX };
    let mut ant = Ant::new(3, 2, streams.ant(1, 0));
    ant.begin(3, s.start, streams.ant(1, 0));
    steps.iter().for_each(|&d| ant.go(&walk, Some(d)));
    ant
}

#[test]
fn the_heuristic_weighs_the_step_and_the_goal() {
    let p = IaacoParams::default();
    let goal = Point::new(5, 0);
    assert!(close(visibility(&p, 1.0, Point::new(1, 3), goal), 1.0 / (0.1 + 4.5)), "d_jG = 5");
    assert!(close(visibility(&p, SQRT2, Point::new(4, 0), goal), 1.0 / (0.141_421_356 + 0.9)));
    assert!(close(visibility(&p, 1.0, goal, goal), 1.0 / 0.109), "ε stands for 0");
}

#[test]
fn the_angle_guidance_in_both_readings() {
    let (repaired, goal) = (IaacoParams::default(), Point::new(8, 6));
    let printed = IaacoParams { reading: Reading::Printed, ..repaired };
    let origin = Point::new(0, 0);
    assert_eq!((guidance(&repaired, origin, goal), guidance(&printed, origin, goal)), (1.25, 0.6));
    let (diagonal, in_row) = (Point::new(5, 3), Point::new(2, 6));
    assert!(close(guidance(&repaired, diagonal, goal), SQRT2));
    assert_eq!((guidance(&repaired, in_row, goal), guidance(&printed, in_row, goal)), (1.0, 0.01), "ε, not 0");
    assert_eq!((guidance(&repaired, goal, goal), guidance(&printed, goal, goal)), (1.0, 1.0));
}

#[test]
fn its_weight_is_raised_beside_that_of_the_heuristic() {
    let s = small();
    let heuristic = |angle_weight| {
        let p = IaacoParams { angle_weight, ..IaacoParams::default() };
        Iaaco::new(p).heuristic(&s, 3, E, 4)
    };
    // From (0, 1) to (1, 1), diagonally below the goal: d = μ = √2.
    let seen = 1.0 / (0.1 + 0.9 * SQRT2);
    assert!(close(heuristic(0.0), seen));
    assert!(close(heuristic(7.0), seen * SQRT2), "λ = β");
    assert!(close(heuristic(14.0), seen * 2.0), "λ = 2β");
    let mut blind = IaacoParams::default();
    blind.selection.beta = 0.0;
    assert!(close(Iaaco::new(blind).heuristic(&s, 3, E, 4), seen), "β = 0 raises all to 1 anyway");
}

#[test]
fn q0_falls_with_time() {
    let p = IaacoParams::default();
    assert!(close(greed(&p, 100, 100), 0.15 * (-0.5f64).exp()));
    assert!(close(greed(&p, 50, 100), 0.15 * (-0.125f64).exp()));
    let mut variant = Iaaco::new(p);
    variant.begin_iteration(100);
    assert_eq!(variant.abreast(), Abreast::PseudoProportional(greed(&p, 100, 100)));
}

#[test]
fn the_evaporation_follows_the_best_path() {
    let p = IaacoParams::default();
    assert_eq!(evaporation(&p, 20.0, 20.0), 0.9);
    assert_eq!(evaporation(&p, 20.0, 40.0), 0.45);
}

#[test]
fn every_path_blends_in_then_the_best_and_the_worst() {
    let s = small();
    // Straight: 2. Around below: √2 + √2, by the middle of the second row.
    let ants = [walked(&s, &[E, E]), walked(&s, &[SE, NE])];
    let iteration =
        Iteration { scenario: &s, ants: &ants, number: 1, budget: 10, best_so_far: None, streams: Streams::new(1, "iaaco", 0) };
    let after = |extreme_paths| {
        let mut trails = Trails::new(6, 2.5);
        Iaaco::new(IaacoParams { extreme_paths, ..IaacoParams::default() }).update_trails(&mut trails, iteration);
        (trails.get(0, E), trails.get(0, SE), trails.get(3, E))
    };
    // ρ = 0.9·2/2: a tenth stays.
    let (best, worst) = (0.25 + 0.9 * 1.25, 0.25 + 0.9 * 2.5 / (2.0 * SQRT2));
    let (straight, around, elsewhere) = after(false);
    assert!(close(straight, best) && close(around, worst), "{straight} {around}");
    assert_eq!(elsewhere, 2.5, "what no ant has walked on does not evaporate");
    let (straight, around, _) = after(true);
    let gain = 1.25 * (2.0 + 2.0 * SQRT2) / 2.0;
    assert!(close(straight, 0.1 * best + 0.9 * gain), "{straight}");
    assert!(close(around, 0.1), "not below τ_min: {around}");
}

#[test]
fn the_printed_reading_is_another_run() {
    let grid = Grid::open(12, 9).expect("a rectangle");
    let s = std::sync::Arc::new(Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(11, 4)).expect("usable"));
    let digest = |preset| {
        let mut planner = catalog::build(&s, "iaaco", preset, &Values::new(), 1).expect("valid");
        planner.run();
        assert!(planner.best().is_some());
        planner.digest().hex()
    };
    assert_ne!(digest(None), digest(Some("printed")));
}
