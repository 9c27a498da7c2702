//! Wu, Huang, Cui et al. 2023 (MAACO), as two reproductions have it.

use std::sync::Arc;

use formicarium::aco::ant::{Ant, Walk};
use formicarium::aco::dead_end::DeadEnd;
use formicarium::aco::maaco::{
    InitialTrail, LateGreed, Limits, Maaco, MaacoParams, Orientation, StartDistance, goal_weight, greed, limits, seen_distance,
    uneven,
};
use formicarium::aco::orientation::{eighths, nearest_three, onward, signs};
use formicarium::aco::trails::Trails;
use formicarium::aco::variant::{Iteration, Standing, Variant};
use formicarium::catalog;
use formicarium::map::{Direction, Grid, Movement, OFFSETS, Point};
use formicarium::params::{Params, Value, Values};
use formicarium::planner::{Granularity, Solution};
use formicarium::rng::Streams;
use formicarium::scenario::Scenario;

use super::{E, SE, close};

const S: Direction = 6;
const W: Direction = 3;

fn open(width: u32, height: u32, start: Point, goal: Point) -> Arc<Scenario> {
    let grid = Grid::open(width, height).expect("a rectangle");
    Arc::new(Scenario::on(grid, Movement::default(), start, goal).expect("usable"))
}

/// From (0, 0) to (8, 6): d_ST = 10.
fn ten() -> Arc<Scenario> {
    open(12, 12, Point::new(0, 0), Point::new(8, 6))
}

#[test]
fn the_weight_of_the_goal_falls_from_w_max_to_w_min() {
    let p = MaacoParams::default();
    assert!(close(goal_weight(&p, 0.0, 10.0), 0.2), "at the goal exp(0) = 1");
    assert!(close(goal_weight(&p, 10.0, 10.0), 0.9 - 0.7 / std::f64::consts::E), "d_jT = d_ST");
    assert!(close(goal_weight(&p, 1e6, 10.0), 0.9));
}

#[test]
fn the_heuristic_sees_start_and_goal_by_that_weight() {
    let (p, start, goal) = (MaacoParams::default(), Point::new(0, 0), Point::new(8, 6));
    let h = 0.9 - 0.7 * (-0.5f64).exp();
    // (4, 3) lies halfway: both distances are 5.
    assert!(close(goal_weight(&p, 5.0, 10.0), h));
    assert!(close(seen_distance(&p, start, 5.0, Point::new(4, 3), goal), 5.0));
    // At the goal: 0.8·10, and ε for its own distance.
    let at_goal = goal_weight(&p, 0.01, 10.0);
    assert!(close(seen_distance(&p, start, 10.0, goal, goal), (1.0 - at_goal) * 10.0 + at_goal * 0.01));
    let (s, variant) = (ten(), Maaco::new(p));
    let j = s.grid.cell(Point::new(4, 3));
    assert!(close(variant.heuristic(&s, j - 1, E, j), 0.2));
}

#[test]
fn a_turn_adds_a_to_the_distance() {
    let s = ten();
    let at = s.grid.cell(Point::new(4, 3));
    let params = MaacoParams { orientation: Orientation::Any, ..MaacoParams::default() };
    let mut weights = [0.0; 8];
    (weights[E as usize], weights[SE as usize]) = (1.0, 0.5);
    let heeded = |last| {
        let mut row = weights;
        Maaco::new(params).heed(&s, &mut row, Standing { last, ..Standing::at(at) });
        row
    };
    assert_eq!(heeded(None), weights, "the first step turns nowhere");
    let far = seen_distance(&params, Point::new(0, 0), 34f64.sqrt(), Point::new(5, 3), Point::new(8, 6));
    let row = heeded(Some(SE));
    assert_eq!(row[SE as usize], 0.5, "straight on");
    assert!(close(f64::from(row[E as usize]), (far / (far + 1.0)).powi(7)), "β = 7: (D / (D + a))^β, {row:?}");
}

#[test]
fn the_way_walked_may_stand_for_the_distance_from_the_start() {
    let s = ten();
    let at = s.grid.cell(Point::new(4, 3));
    let row = |start_distance, walked| {
        let params = MaacoParams { orientation: Orientation::Any, turn_cost: 0.0, start_distance, ..MaacoParams::default() };
        let variant = Maaco::new(params);
        let eta = |d, j| variant.heuristic(&s, at, d, j);
        // η^β of both steps, then what the ant's way makes of them.
        let mut row = [0.0; 8];
        row[E as usize] = eta(E, at + 1).powi(7) as f32;
        row[SE as usize] = eta(SE, at + 13).powi(7) as f32;
        variant.heed(&s, &mut row, Standing { walked, ..Standing::at(at) });
        f64::from(row[E as usize] / row[SE as usize])
    };
    let distance =
        |j: Point, from_start| seen_distance(&MaacoParams::default(), Point::new(0, 0), from_start, j, Point::new(8, 6));
    let (east, diagonal) = (Point::new(5, 3), Point::new(5, 4));
    let ratio = |length| (distance(diagonal, length + 2f64.sqrt()) / distance(east, length + 1.0)).powi(7);
    assert!((row(StartDistance::Walked, 6.0) - ratio(6.0)).abs() < 1e-5);
    assert!((row(StartDistance::Step, 6.0) - ratio(0.0)).abs() < 1e-5);
    assert!((ratio(6.0) - ratio(0.0)).abs() > 1e-2, "the way counts");
}

#[test]
fn trails_begin_by_how_near_a_cell_is_to_the_straight_line() {
    let (start, goal) = (Point::new(0, 0), Point::new(8, 6));
    assert_eq!(uneven(start, Point::new(4, 3), goal), 1.0, "on the line");
    assert!(close(uneven(start, Point::new(8, 0), goal), 10.0 / 14.0), "8 and 6");
    assert_eq!(uneven(start, start, start), 1.0);
    let s = ten();
    let corner = s.grid.cell(Point::new(8, 0));
    let shaped = |initial| {
        let mut trails = Trails::new(s.grid.len(), 2.0);
        Maaco::new(MaacoParams { initial, initial_trail: 2.0, ..MaacoParams::default() }).shape_trails(&s, &mut trails);
        trails.get(corner, S)
    };
    assert!(close(shaped(InitialTrail::Left), 20.0 / 14.0));
    assert!(close(shaped(InitialTrail::Entered), 20.0 / (5.0 + 65f64.sqrt())), "of (8, 1)");
    assert_eq!(shaped(InitialTrail::Uniform), 2.0);
}

#[test]
fn q0_falls_to_the_seventh_tenth_and_then_grows() {
    let p = MaacoParams::default();
    assert!(close(greed(&p, 1, 100), 0.495));
    assert!(close(greed(&p, 69, 100), 0.155));
    assert!(close(greed(&p, 70, 100), 0.25), "it jumps to q0/2");
    assert!(close(greed(&p, 100, 100), 0.4));
    let grows = MaacoParams { late_greed: LateGreed::Grows, ..p };
    assert!(close(greed(&grows, 70, 100), 0.15));
    assert!(close(greed(&grows, 100, 100), 0.325));
    assert_eq!(greed(&MaacoParams { late_greed: LateGreed::Never, ..p }, 50, 100), 0.5);
    let mut variant = Maaco::new(p);
    variant.begin_iteration(1);
    let odds = variant.odds(&[0.0, 3.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
    assert!(close(odds[1], 0.495 + 0.505 * 0.75), "{odds:?}");
}

#[test]
fn limits_follow_the_best_path() {
    let p = MaacoParams::default();
    let (min, max) = limits(&p, 20.0, 50).expect("limits");
    assert!(close(max, 16.25) && close(min, 0.0325), "200·(1/1.6 + 1)/20: {min} {max}");
    let (min, max) = limits(&MaacoParams { trail_limits: Limits::MaxMin, ..p }, 20.0, 50).expect("limits");
    assert!(close(max, 0.0625) && close(min, 0.000_625), "1/(0.8·20), over 100");
    assert_eq!(limits(&MaacoParams { trail_limits: Limits::None, ..p }, 20.0, 50), None);
}

#[test]
fn the_update_evaporates_deposits_and_limits() {
    let s = open(4, 1, Point::new(0, 0), Point::new(3, 0));
    let walk = Walk { moves: &s.moves, goal: s.goal, dead_end: DeadEnd::Die, max_moves: u32::MAX };
    let streams = Streams::new(1, "maaco", 0);
    let mut ant = Ant::new(4, 1, streams.ant(1, 0));
    ant.begin(4, s.start, streams.ant(1, 0));
    (0..3).for_each(|_| ant.go(&walk, Some(E)));
    let best = Solution { path: vec![0, 1, 2, 3], length: 3.0, iteration: 1, refined: None };
    let ants = [ant];
    let iteration = Iteration { scenario: &s, ants: &ants, number: 1, budget: 10, best_so_far: Some(&best), streams };
    let updated = |trail_limits, deposit| {
        let mut trails = Trails::new(4, 1.0);
        Maaco::new(MaacoParams { trail_limits, deposit, ..MaacoParams::default() }).update_trails(&mut trails, iteration);
        (trails.get(0, E), trails.get(1, W))
    };
    let (walked, other) = updated(Limits::None, 2.5);
    assert!(close(walked, 0.8 + 2.5 / 3.0) && close(other, 0.8), "{walked} {other}");
    let (walked, other) = updated(Limits::MaxMin, 2.5);
    assert!(close(walked, 1.0 / 2.4) && close(other, 1.0 / 2.4), "both above 1/(0.8·3): {walked} {other}");
    let (walked, _) = updated(Limits::Elite, 1e3);
    assert!(close(walked, 325.0 / 3.0), "{walked}");
}

#[test]
fn angles_are_counted_in_eighths() {
    assert_eq!(OFFSETS.map(|o| eighths(o, (1, 0))), [3, 2, 1, 4, 0, 3, 2, 1]);
    assert_eq!(OFFSETS.map(|o| eighths(o, (1, 1))), [4, 3, 2, 3, 1, 2, 1, 0]);
    assert_eq!(signs(Point::new(3, 3), Point::new(9, 3)), (1, 0));
    assert_eq!(signs(Point::new(3, 3), Point::new(0, 4)), (-1, 1));
}

#[test]
fn an_ant_looks_along_the_three_nearest_steps() {
    let (here, goal) = (Point::new(5, 5), Point::new(9, 5));
    let mut all = [1.0; 8];
    nearest_three(&mut all, here, goal);
    assert_eq!(all, [0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0], "NE, E, SE");
    let mut without_east = [1.0, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0, 1.0];
    nearest_three(&mut without_east, here, goal);
    assert_eq!(without_east, [0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0], "N before S, which are as near");
    let mut back = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    nearest_three(&mut back, here, goal);
    assert_eq!(back[W as usize], 1.0, "the only one is left");
}

#[test]
fn the_other_reading_goes_from_start_to_goal() {
    let (start, goal) = (Point::new(0, 0), Point::new(9, 9));
    let mut all = [1.0; 8];
    onward(&mut all, Point::new(5, 5), start, goal);
    assert_eq!(all, [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0], "E, S, SE");
    // In the goal's row past its column: none leads on, but west leads to the goal.
    let mut row = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    onward(&mut row, Point::new(10, 9), start, goal);
    assert_eq!(row[W as usize], 1.0);
    let mut away = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    onward(&mut away, Point::new(5, 5), start, goal);
    assert_eq!(away[1], 1.0, "where none leads on, all stay");
}

#[test]
fn ants_of_a_colony_walk_by_it() {
    let s = ten();
    let values: Values = [("iterations".to_string(), Value::Number(5.0))].into();
    for preset in [None, Some("second-reading")] {
        let mut planner = catalog::build(&s, "maaco", preset, &values, 1).expect("valid");
        // The odds of the next step are what the ant that is shown steps by.
        planner.advance(Granularity::Move);
        planner.advance(Granularity::Move);
        let turn = planner.turn_of(0).expect("it walks");
        assert!(turn.odds.iter().filter(|o| o.probability > 0.0).count() <= 3);
        assert!(turn.odds.iter().any(|o| Some(o.to) == turn.next && o.probability > 0.0));
        planner.run();
        assert!(planner.best().is_some());
    }
    assert!(MaacoParams::read("maaco", &[("rho".to_string(), Value::Number(1.0))].into()).is_err(), "1 − ρ is divided by");
}
