//! Formica, our own colony: scent, merging and its certificate on maps by hand.

use std::sync::Arc;

use formicarium::aco::formica::detour;
use formicarium::aco::formica::merge::{Corridor, Merge};
use formicarium::aco::formica::scent::Scent;
use formicarium::catalog;
use formicarium::exact::Within;
use formicarium::map::{Cell, Generator, Grid, Movement, Moves, Point, generate};
use formicarium::metrics::WeightedSum;
use formicarium::params::{Value, Values};
use formicarium::planner::{Effort, Granularity, Layer, Planner, Status};
use formicarium::scenario::{Scenario, ScenarioSpec};

use super::{SQRT2, close};

fn built(scenario: &Arc<Scenario>, set: &[(&str, f64)]) -> Box<dyn Planner> {
    let values: Values = set.iter().map(|&(key, value)| (key.to_string(), Value::Number(value))).collect();
    catalog::build(scenario, "formica", None, &values, 1).expect("valid parameters")
}

/// 24 × 8 cells in three blocks, from (0, 4) to (20, 4), blocked where `wall` says.
fn three_blocks(wall: impl Fn(u32, u32) -> bool) -> Scenario {
    let cells: Vec<u8> = (0..24 * 8).map(|c| u8::from(wall(c % 24, c / 24))).collect();
    let grid = Grid::from_bytes(24, 8, &cells).expect("a map");
    Scenario::on(grid, Movement::default(), Point::new(0, 4), Point::new(20, 4)).expect("usable")
}

fn cell(s: &Scenario, x: u32, y: u32) -> Cell {
    s.grid.cell(Point::new(x, y))
}

#[test]
fn scent_by_hand() {
    let s = three_blocks(|_, _| false);
    let scent = Scent::new(&s);
    // Centres are (4, 4) and (12, 4), that of the goal's part is the goal: D = 16, 8, 0.
    assert_eq!(scent.expanded(), 3);
    assert_eq!([(20, 4), (16, 4), (12, 4), (0, 4)].map(|(x, y)| scent.of(cell(&s, x, y))), [0.0, 4.0, 8.0, 20.0]);
    // From (4, 0) to (12, 4) are 4 diagonal and 4 straight steps.
    assert!(close(scent.of(cell(&s, 4, 0)), 8.0 + 4.0 + 4.0 * SQRT2));
}

#[test]
fn a_block_that_a_wall_divides_has_two_parts() {
    // From (3, 0) down to (3, 7) a wall, and one from (4, 6) to (23, 6) that leaves a dead end below it.
    let s = three_blocks(|x, y| x == 3 || (x > 3 && y == 6));
    let scent = Scent::new(&s);
    let (left, below, right) = (cell(&s, 0, 4), cell(&s, 8, 7), cell(&s, 8, 4));
    assert!(scent.of(left).is_infinite() && scent.of(below).is_infinite(), "no way leads there");
    assert!(scent.of(right).is_finite() && scent.expanded() == 3);
}

#[test]
fn scent_knows_the_way_around_a_wall() {
    // 24 × 16 cells, to (20, 4); column 15 is blocked above row 8, so that one goes below.
    let cells: Vec<u8> = (0..24 * 16).map(|c| u8::from(c % 24 == 15 && c / 24 < 8)).collect();
    let grid = Grid::from_bytes(24, 16, &cells).expect("a map");
    let s = Scenario::on(grid, Movement::default(), Point::new(0, 4), Point::new(20, 4)).expect("usable");
    // From (14, 4) to the centre (12, 12), to (20, 12), to the goal.
    assert!(close(Scent::new(&s).of(cell(&s, 14, 4)), 6.0 + 2.0 * SQRT2 + 8.0 + 8.0));
}

#[test]
fn scent_counts_factors() {
    let spec = |grid: &Grid| ScenarioSpec::new(grid, Point::new(0, 4), Point::new(20, 4));
    let grid = Grid::open(24, 8).expect("a map").with_factors((0..24 * 8).map(|c| if c % 24 < 8 { 3.0 } else { 1.0 }).collect());
    let grid = grid.expect("factors of every cell");
    let s = Scenario::new(grid.clone(), spec(&grid)).expect("usable");
    let scent = Scent::new(&s);
    // From the centre (4, 4) of factor 3 to the centre (12, 4) of factor 1: 8 · 2; from there to the goal 8.
    assert_eq!(scent.of(cell(&s, 4, 4)), 24.0);
}

#[test]
fn eta_by_detour() {
    assert_eq!(detour(0.4, 0.0), 1.0);
    assert!(close(detour(0.4, 2.0), 0.449_328_964));
    assert_eq!(detour(0.4, -1.0), 1.0, "a scent is no bound");
}

#[test]
fn the_part_grows_by_squares() {
    let s = Arc::new(three_blocks(|_, _| false));
    let inside = |search: &Within| search.part().iter().filter(|&&inside| inside).count();
    let mut search = Within::new(&s);
    assert_eq!(inside(&search), 0);
    search.widen(cell(&s, 0, 0), 2);
    assert_eq!(inside(&search), 9, "at the corner");
    search.widen(cell(&s, 0, 0), 1);
    assert_eq!(inside(&search), 9);
    search.widen(cell(&s, 10, 4), 1);
    search.widen(cell(&s, 23, 7), 0);
    assert_eq!(inside(&search), 9 + 9 + 1);
    search.widen_to_all();
    assert_eq!(inside(&search), 24 * 8);
}

/// From (0, 4) to (20, 4) past a wall in column 10 with a gap at (10, 0), eight rows higher a detour, and another at (10, 3).
fn two_gaps() -> Arc<Scenario> {
    Arc::new(three_blocks(|x, y| x == 10 && y != 0 && y != 3))
}

/// The rows from 0 to 1, and the columns of both ends, as the part of the map.
fn upper_way(s: &Scenario, search: &mut Within) {
    (0..24).flat_map(|x| [(x, 0), (x, 1)]).for_each(|(x, y)| search.widen(cell(s, x, y), 0));
    (0..8).flat_map(|y| [(0, y), (20, y)]).for_each(|(x, y)| search.widen(cell(s, x, y), 0));
}

#[test]
fn a_search_inside_a_part_goes_on_where_it_had_to_stop() {
    let s = two_gaps();
    let mut search = Within::new(&s);
    assert_eq!((search.best(), search.lower_bound()), (None, 20.0), "the start waits");
    upper_way(&s, &mut search);
    assert!(search.go_on(u64::MAX));
    let (path, long) = search.best().expect("the upper gap");
    assert!(path.contains(&cell(&s, 10, 0)) && close(long, s.path_length(&path)));
    let (bound, expanded) = (search.lower_bound(), search.expansions());
    // Four steps up in column 0, at most one of each end is a diagonal one.
    assert!(bound < long && !search.is_proven(), "{bound} {long}");
    assert!(search.go_on(u64::MAX) && search.expansions() == expanded, "nothing is open inside");
    search.widen_to_all();
    assert!(search.go_on(u64::MAX));
    let (path, short) = search.best().expect("the lower gap");
    assert!(path.contains(&cell(&s, 10, 3)) && search.is_proven());
    // No corner may be cut: one diagonal step up and one down, before and after the gap.
    assert!(close(short, 18.0 + 2.0 * SQRT2), "{short}");
    assert!(bound <= short && search.lower_bound() == short);
}

#[test]
fn a_search_that_is_stopped_tells_what_it_has_proven() {
    let s = two_gaps();
    let mut search = Within::new(&s);
    search.widen_to_all();
    let mut bounds = vec![search.lower_bound()];
    while !search.go_on(3) {
        bounds.push(search.lower_bound());
    }
    let optimum = 18.0 + 2.0 * SQRT2;
    assert!(bounds.len() > 5 && bounds[0] == 20.0, "{bounds:?}");
    assert!(bounds.iter().all(|&bound| bound <= optimum + 1e-9), "{bounds:?}");
    assert!(close(search.lower_bound(), optimum) && search.is_proven());
}

#[test]
fn a_search_that_is_bounded_looks_for_shorter_paths_alone() {
    let s = two_gaps();
    let optimum = 18.0 + 2.0 * SQRT2;
    let expanded = |known: f64| {
        let mut search = Within::new(&s);
        search.bound_by(known);
        search.widen_to_all();
        assert!(search.go_on(u64::MAX) && search.is_proven());
        (search.best().map(|(_, length)| length), search.lower_bound(), search.expansions())
    };
    let (none, bound, few) = expanded(optimum);
    assert_eq!((none, bound), (None, optimum));
    let (found, proven, many) = expanded(100.0);
    assert!(found.is_some_and(|length| close(length, optimum)) && close(proven, optimum));
    assert!(few <= many, "{few} {many}");
}

#[test]
fn the_corridor_widens_until_something_is_found() {
    let mut corridor = Corridor { narrow: 3, wide: 20, radius: 3 };
    let radii: Vec<u8> = [false, false, false, false, true, false]
        .map(|is_shorter| {
            corridor.learn(is_shorter);
            corridor.radius
        })
        .into();
    assert_eq!(radii, [6, 12, 20, 20, 3, 6]);
    let mut point = Corridor { narrow: 0, wide: 2, radius: 0 };
    point.learn(false);
    assert_eq!(point.radius, 1);
}

#[test]
fn a_merge_follows_the_corridor_and_counts_once() {
    let s = two_gaps();
    let mut merge = Merge::new(&s, Corridor { narrow: 1, wide: 1, radius: 1 });
    let mut upper: Vec<Cell> = (0..=4).rev().map(|y| cell(&s, 0, y)).collect();
    upper.extend((1..=20).map(|x| cell(&s, x, 0)));
    upper.extend((1..=4).map(|y| cell(&s, 20, y)));
    merge.follow(&upper);
    let (_, length) = merge.solve().expect("a path in the corridor");
    // Two corners are rounded by a diagonal step each, two steps at each end are saved by that and by a corridor of 1.
    assert!(length < s.path_length(&upper) && length > 18.0 + 2.0 * SQRT2, "{length}");
    assert!(merge.take_expansions() > 0 && merge.take_expansions() == 0);
    let certificate = merge.certificate(length);
    assert!(!certificate.complete && certificate.lower_bound < length, "{certificate:?}");
    let better = merge.prove(length, u64::MAX).expect("a path").1;
    let certificate = merge.certificate(better);
    assert!(certificate.complete && certificate.lower_bound == better, "{certificate:?}");
    assert_eq!(certificate.expansions, merge.take_expansions() + merge_before(&s, &upper));
}

/// 9 × 3 cells by 4 moves: down, along and up is the only way past the walls of the first row that does not turn all the time.
fn teeth() -> Arc<Scenario> {
    let cells: Vec<u8> = (0..27).map(|c| u8::from(c < 9 && c % 2 == 0 && c != 0 && c != 8)).collect();
    let grid = Grid::from_bytes(9, 3, &cells).expect("a map");
    let movement = Movement { moves: Moves::Four, ..Movement::default() };
    Arc::new(Scenario::on(grid, movement, Point::new(0, 0), Point::new(8, 0)).expect("usable"))
}

#[test]
fn a_search_over_states_proves_the_turn_index_where_it_has_not_been() {
    let s = teeth();
    let mut search = Within::by_turn_index(&s);
    assert_eq!((search.best(), search.lower_bound()), (None, 8.0), "the start waits");
    (0..18).for_each(|cell| search.widen(cell, 0));
    assert!(search.go_on(u64::MAX));
    let (path, v) = search.best().expect("along the second row");
    // 10 steps, two of which turn; the third row is two steps more.
    assert!(path.len() == 11 && close(v, 10.4), "{v}");
    assert!(search.is_proven() && !search.part()[18]);
}

#[test]
fn a_search_over_states_proves_the_weighted_sum() {
    let s = teeth();
    let sum = WeightedSum { turn_weight: 5.0, clearance_weight: 0.0, energy_weight: 2.0, ..WeightedSum::default() };
    let mut search = Within::by_sum(&s, sum);
    // 8 cells, and their energy.
    assert_eq!(search.lower_bound(), 8.0 + 2.0 * 8.0);
    search.widen_to_all();
    assert!(search.go_on(u64::MAX) && search.is_proven());
    let energy = 10.0 + 0.25 * std::f64::consts::PI;
    assert!(search.best().is_some_and(|(_, j)| close(j, 10.0 + 5.0 * 2.0 + 2.0 * energy)));
}

#[test]
fn steps_of_two_cells_turn_as_others_do() {
    let grid = Grid::open(7, 3).expect("a map");
    let movement = Movement { moves: Moves::Sixteen, ..Movement::default() };
    let s = Arc::new(Scenario::on(grid, movement, Point::new(0, 0), Point::new(5, 2)).expect("usable"));
    let mut search = Within::by_turn_index(&s);
    search.widen_to_all();
    search.go_on(u64::MAX);
    // One straight, which is shorter than a step of two cells, so it is the one that turns.
    assert!(search.best().is_some_and(|(_, v)| close(v, 2.0 * 5f64.sqrt() + 1.2)));
}

/// Expansions of the merge alone.
fn merge_before(s: &Arc<Scenario>, path: &[Cell]) -> u64 {
    let mut merge = Merge::new(s, Corridor { narrow: 1, wide: 1, radius: 1 });
    merge.follow(path);
    merge.solve();
    merge.take_expansions()
}

/// A map of rooms with every number of moves, on which the shortest path is not straight.
fn rooms(side: u32, moves: Moves) -> Arc<Scenario> {
    let made = generate(Generator::Rooms, side, side, 3, 0.0).expect("a valid size");
    let movement = Movement { moves, ..Movement::default() };
    Arc::new(Scenario::on(made.grid, movement, made.start, made.goal).expect("usable"))
}

fn optimum(scenario: &Arc<Scenario>) -> f64 {
    formicarium::exact::optimum(scenario).expect("a path")
}

#[test]
fn the_best_path_is_proven_with_every_number_of_moves() {
    for moves in [Moves::Four, Moves::Eight, Moves::Sixteen] {
        let scenario = rooms(40, moves);
        let mut ants = built(&scenario, &[]);
        assert_eq!(ants.run(), Status::Optimal, "{moves:?}");
        let (best, certificate) = (ants.best().expect("a path").length, ants.certificate().expect("a proof"));
        assert!(close(best, optimum(&scenario)), "{moves:?}: {best}");
        assert!(certificate.complete && certificate.lower_bound == best, "{moves:?}: {certificate:?}");
        assert!(certificate.expansions > 0 && certificate.expansions < ants.effort().cell_expansions, "scent counts, too");
    }
}

#[test]
fn the_cheapest_path_is_proven_on_weighted_ground() {
    for moves in [Moves::Four, Moves::Eight, Moves::Sixteen] {
        let plain = rooms(40, moves);
        let factors = (0..1600u32).map(|c| if c.wrapping_mul(2_654_435_761) >> 30 == 0 { 4.0 } else { 1.25 }).collect();
        let grid = plain.grid.clone().with_factors(factors).expect("factors of every cell");
        let scenario = Arc::new(Scenario::new(grid, plain.spec.clone()).expect("usable"));
        let mut ants = built(&scenario, &[]);
        assert_eq!(ants.run(), Status::Optimal, "{moves:?}");
        assert!(close(ants.best().expect("a path").length, optimum(&scenario)), "{moves:?}");
    }
}

#[test]
fn a_proof_that_is_cut_off_tells_how_far_it_has_come() {
    let scenario = rooms(64, Moves::Eight);
    // Nothing is merged, and a proof of four cells proves next to nothing.
    let mut ants = built(&scenario, &[("proof_limit", 0.001), ("iterations", 2.0), ("widening", 0.0), ("corridor", 0.0)]);
    let status = ants.run();
    let (best, certificate) = (ants.best().expect("a path").length, ants.certificate().expect("as far as it goes"));
    assert_eq!(status, Status::BudgetSpent);
    assert!(!certificate.complete && certificate.lower_bound < best, "{certificate:?} {best}");
    assert!(certificate.lower_bound <= optimum(&scenario) + 1e-9);
    let mut none = built(&scenario, &[("proof_limit", 0.0), ("iterations", 2.0)]);
    assert_eq!((none.run(), none.certificate()), (Status::BudgetSpent, None));
}

#[test]
fn without_merging_the_proof_finds_the_shortest_path() {
    let scenario = rooms(48, Moves::Eight);
    let values: Values = [("merge".to_string(), Value::from(false)), ("iterations".to_string(), Value::from(2.0))].into();
    let mut ants = catalog::build(&scenario, "formica", None, &values, 1).expect("valid parameters");
    ants.advance(Granularity::Iteration);
    assert!(ants.best().expect("an ant arrives").length > optimum(&scenario) + 1e-6, "ants alone do not find it here");
    assert_eq!(ants.run(), Status::Optimal);
    let best = ants.best().expect("a path");
    assert!(close(best.length, optimum(&scenario)) && best.iteration == 2);
    assert_eq!(ants.history()[1].iteration_best, Some(best.length));
}

#[test]
fn layers_show_scent_and_what_was_merged() {
    let scenario = rooms(40, Moves::Eight);
    let mut ants = built(&scenario, &[]);
    let (mut before, mut scent, mut merged) = (Vec::new(), Vec::new(), Vec::new());
    assert!(ants.layer(Layer::Scent, &mut before) && ants.layer(Layer::Merged, &mut merged));
    assert!(merged.iter().all(|&v| v == 0.0));
    ants.advance(Granularity::Iteration);
    assert!(ants.layer(Layer::Scent, &mut scent) && ants.layer(Layer::Merged, &mut merged));
    assert_eq!(scent, before);
    assert_eq!(scent[scenario.goal as usize], 0.0);
    assert!(merged[scenario.start as usize] == 1.0 && merged[scenario.goal as usize] == 1.0);
}

#[test]
fn where_nothing_leads_there_is_no_path_and_nothing_to_prove() {
    let scenario = Arc::new(three_blocks(|x, _| x == 9));
    let mut ants = built(&scenario, &[]);
    assert_eq!((ants.run(), ants.certificate()), (Status::NoPath, None));
    assert_eq!(ants.effort(), Effort::default());
}
