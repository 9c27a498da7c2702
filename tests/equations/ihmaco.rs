//! Liu, Wu, Xiao et al. 2023 (IHMACO), as a reproduction has it.

use std::sync::Arc;

use formicarium::aco::ant::{Ant, Walk};
use formicarium::aco::dead_end::DeadEnd;
use formicarium::aco::ihmaco::{Ihmaco, IhmacoParams, fitness, greed, judgement, start_trail};
use formicarium::aco::trails::Trails;
use formicarium::aco::variant::{Iteration, Standing, Variant};
use formicarium::map::{Grid, Movement, Point};
use formicarium::rng::Streams;
use formicarium::scenario::Scenario;

use super::{E, NE, SE, close};

const W: u8 = 3;

/// From (0, 0) to (8, 6): d_ST = 10.
fn ten() -> Arc<Scenario> {
    let grid = Grid::open(12, 12).expect("a rectangle");
    Arc::new(Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(8, 6)).expect("usable"))
}

#[test]
fn trails_begin_by_both_cells_of_a_step_and_whether_it_leads_nearer() {
    let (start, goal) = (Point::new(0, 0), Point::new(8, 6));
    let (corner, below) = (Point::new(8, 0), Point::new(8, 1));
    let (of_corner, of_below) = (10.0 / 14.0, 10.0 / (5.0 + 65f64.sqrt()));
    assert!(close(start_trail(start, corner, below, goal), of_corner + of_below));
    assert!(close(start_trail(start, below, corner, goal), 0.5 * (of_corner + of_below)), "away from the goal");
    let s = ten();
    let shaped = |uneven_trail| {
        let mut trails = Trails::new(s.grid.len(), 1.0);
        Ihmaco::new(IhmacoParams { uneven_trail, ..IhmacoParams::default() }).shape_trails(&s, &mut trails);
        trails.get(s.grid.cell(corner), 6)
    };
    assert!(close(shaped(true), of_corner + of_below));
    assert_eq!(shaped(false), 1.0);
}

#[test]
fn directions_are_judged_beside_that_from_start_to_goal() {
    let (start, goal) = (Point::new(0, 0), Point::new(8, 6));
    let judged = [SE, E, NE, 1, 0].map(|d| judgement(d, start, goal));
    assert_eq!(judged, [5.0 / 15.0, 4.0 / 15.0, 3.0 / 15.0, 2.0 / 15.0, 1.0 / 15.0]);
}

#[test]
fn a_step_straight_on_weighs_twice() {
    let s = ten();
    let at = s.grid.cell(Point::new(4, 3));
    let heeded = |params, last| {
        let mut row = [0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0];
        Ihmaco::new(params).heed(&s, &mut row, Standing { last, ..Standing::at(at) });
        row
    };
    let plain = IhmacoParams { judgement: false, ..IhmacoParams::default() };
    let of = |row: [f32; 8]| [row[usize::from(W)], row[E as usize], row[SE as usize]];
    assert_eq!(of(heeded(plain, Some(E))), [1.0, 2.0, 1.0]);
    assert_eq!(of(heeded(plain, None)), [2.0, 2.0, 2.0], "the first step turns nowhere");
    let row = of(heeded(IhmacoParams::default(), Some(E)));
    for (weight, expected) in row.into_iter().zip([2.0 / 15.0, 8.0 / 15.0, 5.0 / 15.0]) {
        assert!(close(f64::from(weight), expected), "{row:?}");
    }
}

#[test]
fn q0_dips_and_grows_again() {
    let p = IhmacoParams::default();
    assert!(close(greed(&p, 45, 100), 0.1));
    assert!(close(greed(&p, 100, 100), 0.705));
    assert!(close(greed(&p, 20, 100), 0.1 + 2.0 * 0.0625));
    let constant = greed(&IhmacoParams { dipping_q0: false, ..p }, 7, 100);
    let mean = (0..10_000).map(|k| greed(&p, k, 10_000)).sum::<f64>() / 10_000.0;
    assert!((constant - mean).abs() < 1e-4, "{constant} {mean}");
}

#[test]
fn turns_count_against_a_deposit_and_evaporation_grows() {
    let p = IhmacoParams::default();
    assert_eq!(fitness(&p, 10.0, 3), 8.0);
    let grid = Grid::open(3, 2).expect("a rectangle");
    let s = Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(2, 0)).expect("usable");
    let streams = Streams::new(1, "ihmaco", 0);
    let walk = Walk { moves: &s.moves, goal: s.goal, dead_end: DeadEnd::Die, max_moves: u32::MAX };
    let mut ant = Ant::new(3, 2, streams.ant(1, 0));
    ant.begin(3, s.start, streams.ant(1, 0));
    [SE, NE].into_iter().for_each(|d| ant.go(&walk, Some(d)));
    let ants = [ant];
    let updated = |number| {
        let mut trails = Trails::new(6, 1.0);
        let iteration = Iteration { scenario: &s, ants: &ants, number, budget: 10, best_so_far: None, streams };
        Ihmaco::new(p).update_trails(&mut trails, iteration);
        (trails.get(0, SE), trails.get(0, E))
    };
    let (walked, other) = updated(5);
    assert!(close(other, 1.0 - 0.22), "0.2·1.1: {other}");
    let gain = 2.5 / (0.5 * 2.0 * std::f64::consts::SQRT_2 + 1.0);
    assert!(close(walked, 0.78 + gain), "one turn: {walked}");
    assert!(close(updated(10).1, 1.0 - 0.24));
}

#[test]
fn the_heuristic_is_the_goals_distance() {
    let s = ten();
    let j = s.grid.cell(Point::new(5, 2));
    assert_eq!(Ihmaco::new(IhmacoParams::default()).heuristic(&s, j - 1, E, j), 0.2, "a 3-4-5 triangle");
    assert_eq!(Ihmaco::new(IhmacoParams::default()).heuristic(&s, s.goal - 1, E, s.goal), 100.0);
}
