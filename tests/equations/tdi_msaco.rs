//! Li, Wang, Cai, Ma, Tan 2022 (TDI-MSACO), as two reproductions have it.

use std::sync::Arc;

use formicarium::aco::dead_end::DeadEnd;
use formicarium::aco::tdi_msaco::index::Index;
use formicarium::aco::tdi_msaco::walker::Walker;
use formicarium::aco::tdi_msaco::window::Window;
use formicarium::aco::tdi_msaco::{TdiMsacoParams, initial_index, weight};
use formicarium::catalog;
use formicarium::exact::{Reference, reference};
use formicarium::map::{Cell, CornerRule, Generator, Grid, Movement, Moves, Point, generate};
use formicarium::params::{Value, Values};
use formicarium::path::{PathKind, audit, points};
use formicarium::planner::{Fate, Granularity, Layer, Objective, Planner};
use formicarium::rng::Streams;
use formicarium::scenario::Scenario;

use super::{SQRT2, close};

fn scenario(rows: &[&str], movement: Movement, start: (u32, u32), goal: (u32, u32)) -> Scenario {
    let cells: Vec<u8> = rows.concat().bytes().map(|b| u8::from(b == b'#')).collect();
    let grid = Grid::from_bytes(rows[0].len() as u32, rows.len() as u32, &cells).expect("a map");
    let at = |(x, y)| Point::new(x, y);
    Scenario::on(grid, movement, at(start), at(goal)).expect("usable")
}

fn open(width: u32, height: u32, goal: (u32, u32)) -> Scenario {
    let grid = Grid::open(width, height).expect("a rectangle");
    Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(goal.0, goal.1)).expect("usable")
}

fn seen(s: &Scenario, reach: u32, from: (u32, u32)) -> Vec<(u32, u32)> {
    let from = s.grid.cell(Point::new(from.0, from.1));
    let mut window = Window::new(reach, s.grid.len());
    let bits = window.look(s, from);
    assert_eq!([(); 2].map(|()| window.seen_from(s, from)), [bits; 2], "looked up or not");
    let cells = window.cells(s.grid.width(), from, bits).map(|c| s.grid.point(c));
    cells.map(|p| (p.x, p.y)).collect()
}

#[test]
fn an_ant_may_go_to_any_cell_in_sight_within_its_reach() {
    let s = open(9, 9, (8, 8));
    assert_eq!([1, 2, 3].map(|reach| seen(&s, reach, (4, 4)).len()), [8, 24, 48]);
    assert_eq!(seen(&s, 1, (4, 4)), [(3, 3), (4, 3), (5, 3), (3, 4), (5, 4), (3, 5), (4, 5), (5, 5)], "row by row");
    assert_eq!(seen(&s, 3, (0, 0)).len(), 15, "nothing lies beyond the border");
    // A wall hides what is behind it, and its corners are not cut.
    let walled = scenario(&[".....", "..#..", "....."], Movement::default(), (0, 0), (4, 2));
    assert_eq!(seen(&walled, 1, (1, 1)), [(0, 0), (1, 0), (0, 1), (0, 2), (1, 2)]);
    assert!(!seen(&walled, 3, (1, 1)).contains(&(3, 1)) && seen(&walled, 3, (1, 0)).contains(&(4, 0)));
    let four = scenario(&["....", "...."], Movement { moves: Moves::Four, ..Movement::default() }, (0, 0), (3, 1));
    assert_eq!(seen(&four, 3, (0, 0)), [(1, 0), (2, 0), (3, 0), (0, 1)]);
}

#[test]
fn a_cell_weighs_by_its_distance_and_by_its_index() {
    let s = open(9, 9, (8, 8));
    let (p, j) = (TdiMsacoParams::default(), s.grid.cell(Point::new(8, 4)));
    // 4^−1.5 + 16^−0.8 = 0.125 + 2^−3.2.
    assert!(close(weight(&p, &s, j, 16.0), 0.125 + 0.108_818_82));
    let second = TdiMsacoParams { distance_power: 1.0, index_power: 7.0, ..p };
    assert!(close(weight(&second, &s, j, 16.0), 0.25 + 1.0 / 268_435_456.0));
    // Without the index: 16^0 = 1.
    assert!(close(weight(&TdiMsacoParams { index_power: 0.0, ..p }, &s, j, 16.0), 1.125));
    // At the goal ε = 0.01 stands for 0: 0.01^−1.5 + 0.01^−0.8.
    assert!(close(weight(&p, &s, s.goal, 0.0), 1000.0 + 39.810_717));
}

#[test]
fn the_index_begins_at_ten_diagonals() {
    assert!(close(initial_index(&TdiMsacoParams::default(), &open(4, 5, (3, 4))), 50.0), "a 3-4-5 triangle");
}

#[test]
fn the_index_is_the_shortest_way_that_ants_have_shown() {
    let s = open(5, 2, (4, 0));
    let mut index = Index::new(10, s.goal, 60.0);
    assert_eq!((index.get(4), index.get(0), index.known(0), index.known(4)), (0.0, 60.0, f64::INFINITY, 0.0));
    let learn = |index: &mut Index, way: &[Cell]| {
        let mut changed = Vec::new();
        index.learn(&s, way, |cell| changed.push(cell));
        changed
    };
    // By (1, 1) and (3, 1): √2 + 2 + √2.
    assert_eq!(learn(&mut index, &[0, 6, 8, 4]), [8, 6, 0], "from its end");
    assert!(close(index.get(8), SQRT2) && close(index.get(6), 2.0 + SQRT2) && close(index.get(0), 2.0 + 2.0 * SQRT2));
    assert_eq!(index.way_from(0), Some(vec![0, 6, 8, 4]));
    // A way that is no better changes nothing.
    assert_eq!(learn(&mut index, &[0, 5, 6, 8, 4]), [5]);
    // (1, 1) is 3.1622777 from the goal: what was set by it stays, but one goes the shorter way.
    assert_eq!(learn(&mut index, &[6, 4]), [6]);
    assert!(close(index.get(6), 10f64.sqrt()) && close(index.get(0), 2.0 + 2.0 * SQRT2));
    assert_eq!(index.way_from(0), Some(vec![0, 6, 4]));
    assert_eq!((index.way_from(9), index.known(9)), (None, f64::INFINITY), "nobody came from there");
}

#[test]
fn a_cell_is_drawn_by_its_share_of_the_weights() {
    let streams = Streams::new(1, "tdi-msaco", 0);
    let mut ant = Walker::new(9, 0, streams.ant(1, 0));
    assert_eq!(ant.draw(&[]), None);
    let options = [(1, 0.5), (5, 2.0), (7, 1.5)];
    let mut drawn = [0; 9];
    for _ in 0..40_000 {
        drawn[ant.draw(&options).expect("one of them") as usize] += 1;
    }
    for (cell, expected) in [(1, 5_000), (5, 20_000), (7, 15_000)] {
        assert!(i32::abs(drawn[cell] - expected) < 450, "{drawn:?}");
    }
}

#[test]
fn an_ant_arrives_steps_back_or_is_lost() {
    let streams = Streams::new(1, "tdi-msaco", 0);
    let walked = |moves: &[Option<Cell>], dead_end, most| {
        let mut ant = Walker::new(9, 0, streams.ant(1, 0));
        moves.iter().for_each(|&to| ant.go(to, 8, dead_end, most));
        (ant.way().to_vec(), ant.fate(), ant.moves(), ant.has_been_at(4))
    };
    assert_eq!(walked(&[Some(4), Some(8)], DeadEnd::Die, 9), (vec![0, 4, 8], Fate::Arrived, 2, true));
    assert_eq!(walked(&[Some(4), None], DeadEnd::Die, 9), (vec![0, 4], Fate::Lost, 2, true));
    assert_eq!(walked(&[Some(4), None], DeadEnd::Backtrack, 9), (vec![0], Fate::Walking, 2, true));
    assert_eq!(walked(&[None], DeadEnd::Backtrack, 9), (vec![0], Fate::Lost, 1, false), "no way back from the start");
    assert_eq!(walked(&[Some(4), Some(5)], DeadEnd::Die, 2), (vec![0, 4, 5], Fate::Lost, 2, true));
}

fn built(s: &Arc<Scenario>, values: &[(&str, Value)], seed: u32) -> Box<dyn Planner> {
    let values: Values = values.iter().map(|(key, value)| ((*key).to_string(), value.clone())).collect();
    catalog::build(s, "tdi-msaco", None, &values, seed).expect("valid")
}

fn scattered(corner_rule: CornerRule, moves: Moves) -> Arc<Scenario> {
    let made = generate(Generator::Random, 20, 16, 5, 0.15).expect("a valid size");
    Arc::new(Scenario::on(made.grid, Movement { moves, corner_rule }, made.start, made.goal).expect("usable"))
}

#[test]
fn its_paths_are_legal_within_its_reach_and_get_no_longer() {
    for corner_rule in CornerRule::ALL {
        for moves in [Moves::Four, Moves::Eight] {
            let s = scattered(corner_rule, moves);
            let mut longest = [0; 4];
            for reach in 1..=3 {
                let mut planner = built(&s, &[("reach", Value::from(f64::from(reach))), ("iterations", Value::from(40.0))], 2);
                let mut last = f64::INFINITY;
                while !planner.advance(Granularity::Iteration).is_finished() {
                    let Some(best) = planner.best() else { continue };
                    let path = points(&s, &best.path);
                    assert_eq!(audit(&s, &path, PathKind::Polyline), Ok(()), "{corner_rule:?} {moves:?} {reach}");
                    assert!(best.length <= last);
                    last = best.length;
                    let spans = path.windows(2).map(|p| p[0].x.abs_diff(p[1].x).max(p[0].y.abs_diff(p[1].y)));
                    longest[reach as usize] = spans.max().unwrap_or(0);
                }
                assert!(last.is_finite(), "{corner_rule:?} {moves:?} {reach}");
            }
            assert_eq!(longest, [0, 1, 2, 3], "{corner_rule:?} {moves:?}");
        }
    }
}

#[test]
fn the_index_leads_it_to_the_shortest_polyline_around_a_bend() {
    let s = Arc::new(scenario(&["......", "####..", "......"], Movement::default(), (0, 0), (0, 2)));
    let Reference::Proven { value: least } = reference(&s, Objective::PolylineLength) else { panic!("a small map") };
    for seed in 1..=5 {
        let mut planner = built(&s, &[], seed);
        planner.run();
        let best = planner.best().expect("a path");
        assert!((best.length - least).abs() < 1e-9, "seed {seed}: {} instead of {least}", best.length);
        let mut index = Vec::new();
        assert!(planner.layer(Layer::Scent, &mut index));
        assert_eq!(index[s.goal as usize], 0.0);
        assert!(f64::from(index[s.start as usize]) >= least - 1e-5 && index[7].is_infinite(), "a wall has none: {index:?}");
    }
}

/// Length in cells of the shortest polyline whose segments an ant could go, each in one move: Dijkstra over them.
fn shortest_within(s: &Scenario, reach: u32) -> f64 {
    let window = Window::new(reach, 0);
    let mut to = vec![f64::INFINITY; s.grid.len()];
    to[s.start as usize] = 0.0;
    let mut open: Vec<Cell> = (0..s.grid.len() as Cell).filter(|&c| !s.grid.is_blocked(c)).collect();
    while let Some(k) = (0..open.len()).min_by(|&a, &b| to[open[a] as usize].total_cmp(&to[open[b] as usize])) {
        let at = open.swap_remove(k);
        for next in window.cells(s.grid.width(), at, window.look(s, at)) {
            let by = to[at as usize] + s.grid.point(at).distance(s.grid.point(next));
            to[next as usize] = to[next as usize].min(by);
        }
    }
    to[s.goal as usize]
}

#[test]
fn its_index_comes_to_the_shortest_way_by_segments_within_its_reach() {
    let s = scattered(CornerRule::BothFree, Moves::Eight);
    for (reach, seed) in [(2, 1), (2, 2), (3, 1), (3, 2)] {
        let least = shortest_within(&s, reach);
        let mut planner = built(&s, &[("reach", Value::from(f64::from(reach))), ("iterations", Value::from(300.0))], seed);
        planner.run();
        let best = planner.best().expect("a path").length;
        assert!((best - least).abs() < 1e-9, "reach {reach}, seed {seed}: {best} instead of {least}");
    }
    assert!(shortest_within(&s, 3) < shortest_within(&s, 2) && shortest_within(&s, 2) < shortest_within(&s, 1));
}

#[test]
fn an_ant_returns_only_where_it_is_let() {
    let s = scattered(CornerRule::BothFree, Moves::Eight);
    let returns = |tabu: bool| {
        let mut planner =
            built(&s, &[("tabu", tabu.into()), ("move_limit", Value::from(0.0)), ("iterations", Value::from(3.0))], 1);
        planner.run();
        let ways = (0..10).map(|k| planner.ant(k).expect("ten ants").way);
        ways.map(|mut way| {
            let stood = way.len();
            assert!(tabu || stood <= s.grid.len() + 1, "as many moves as there are cells");
            way.sort_unstable();
            way.dedup();
            stood - way.len()
        })
        .sum::<usize>()
    };
    assert_eq!(returns(true), 0);
    assert!(returns(false) > 0);
}
