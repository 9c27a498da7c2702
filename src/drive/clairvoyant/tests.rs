//! How long the map takes to repeat itself, and what is too much to search. Values against brute force: `tests/drive`.

use super::*;
use crate::map::{Grid, Movement, Point};
use crate::scenario::{AtEnd, DriveChange, Robot, ScenarioSpec, Track};

fn track(cells: u32, from_step: u32, steps_per_cell: u32, at_end: AtEnd) -> Track {
    let cells = (0..cells).map(|x| Point::new(x, 0)).collect();
    Track { cells, size: 1, from_step, steps_per_cell, at_end }
}

#[test]
fn the_span_of_a_drive_by_hand() {
    let time = |tracks: Vec<Track>, walls: &[u32]| {
        let change = |&at_step: &u32| DriveChange { at_step, blocked: vec![Point::new(1, 1)], freed: Vec::new() };
        Time::of(&DriveSpec { changes: walls.iter().map(change).collect(), tracks, sight: None })
    };
    let of = |settled, period| Ok(Time { settled, period });
    assert_eq!(time(Vec::new(), &[]), of(0, 1));
    assert_eq!(time(Vec::new(), &[3, 8]), of(8, 1));
    assert_eq!(time(vec![track(4, 10, 2, AtEnd::Stay)], &[3]), of(18, 1));
    // To and fro over four cells are six.
    let (there, round) = (track(4, 0, 2, AtEnd::BackAndForth), track(2, 5, 4, AtEnd::Loop));
    assert_eq!(time(vec![there.clone(), round], &[]), of(13, 24));
    let primes = [997, 991, 983].map(|steps| track(2, 0, steps, AtEnd::Loop)).to_vec();
    let most = MOST_STATES as u32;
    assert_eq!(time(primes, &[]), Err(TooMuch::Period { most }), "two thousand million steps");
    let (time, steps) = (Time { settled: 13, period: 24 }, [0, 12, 35, 36]);
    assert_eq!(steps.map(|step| time.after(step)), [1, 13, 36, 13]);
}

/// A step, cells that get a wall then, and cells that lose theirs.
type Walls<'a> = (u32, &'a [(u32, u32)], &'a [(u32, u32)]);

/// From corner to corner of a row of an open map on which cells get walls, and others lose theirs, at these steps.
fn walled(side: u32, changes: &[Walls]) -> Scenario {
    let grid = Grid::open(side, side).expect("a map");
    let points = |cells: &[(u32, u32)]| cells.iter().map(|&(x, y)| Point::new(x, y)).collect();
    let change = |&(at_step, blocked, freed): &Walls| DriveChange { at_step, blocked: points(blocked), freed: points(freed) };
    let changes = changes.iter().map(change).collect();
    let plain = Scenario::on(grid.clone(), Movement::default(), Point::new(0, 0), Point::new(side - 1, 0)).expect("usable");
    let spec = ScenarioSpec { drive: Some(DriveSpec { changes, ..DriveSpec::default() }), ..plain.spec };
    Scenario::new(grid, spec).expect("usable")
}

#[test]
fn what_is_too_much_is_unknown() {
    let (gate, proven) = ([(5, 0), (5, 1)], |value| Reference::Proven { value });
    let shut = |side, until| walled(side, &[(0, &gate, &[]), (until, &[], &gate)]);
    assert_eq!(clairvoyant(&shut(20, 40)), proven(19.0));
    assert_eq!(clairvoyant(&shut(64, 1023)), proven(63.0), "4096 cells times 1024 steps");
    assert_eq!(clairvoyant(&shut(64, 5000)), proven(63.0), "it is worth while to wait, and few states are searched for it");
    assert!(matches!(best_in_advance(&shut(64, 9000)), Err(TooMuch::Kept { cells: 4096, .. })));
    assert_eq!(clairvoyant(&shut(64, 9000)), Reference::Unknown);
}

#[test]
fn every_limit_is_told_by_name() {
    // A wall that shuts before anybody can be there: that no wait helps is known once every step is searched.
    let wall: Vec<(u32, u32)> = (0..19).map(|y| (16, y)).collect();
    let late = walled(20, &[(3, &wall, &[]), (120, &[(1, 16)], &[])]);
    let found = best_in_advance(&late);
    assert!(matches!(found, Ok(Some(value)) if value > 40.0), "{found:?}");
    let limited = |limits| best_within(&late, limits);
    assert!(matches!(limited(Limits { states: 9_000, ..MOST }), Err(TooMuch::States { cells: 400, most: 9_000, .. })));
    assert_eq!(limited(Limits { kept: 399, ..MOST }), Err(TooMuch::Kept { cells: 400, steps: 2, most: 399 }));
    assert_eq!(limited(Limits { felt: 399, ..MOST }), found, "a point needs no room");
    // Few states are kept, by the best path where all is free that ever is: what it searches is as exact.
    let few = best_within(&late, Limits { states: 48_399, ..MOST });
    assert_eq!(few.map(|best| best.map(|b| (b * 1e9).round())), found.map(|best| best.map(|b| (b * 1e9).round())));
    let robot = Some(Robot { radius: 0.5, inflation: None });
    let round = Scenario::new(late.drawn.clone(), ScenarioSpec { robot, ..late.spec.clone() }).expect("it has room");
    let felt = best_within(&round, Limits { felt: 399, ..MOST });
    assert_eq!(felt, Err(TooMuch::Felt { cells: 400, steps: 2, most: 399 }));
}

#[test]
fn cells_out_of_reach_do_not_count() {
    // A corridor of 300 cells in a map of 90,000: all of them times the steps would be too many.
    let cells: Vec<u8> = (0..90_000).map(|cell| u8::from(cell >= 300)).collect();
    let grid = Grid::from_bytes(300, 300, &cells).expect("a map");
    let plain = Scenario::on(grid.clone(), Movement::default(), Point::new(0, 0), Point::new(299, 0)).expect("usable");
    let tracks = vec![track(1, 0, 900, AtEnd::Leave)];
    let tracks = tracks.into_iter().map(|one| Track { cells: vec![Point::new(200, 0)], ..one }).collect();
    let spec = ScenarioSpec { drive: Some(DriveSpec { tracks, ..DriveSpec::default() }), ..plain.spec };
    let corridor = Scenario::new(grid, spec).expect("usable");
    assert_eq!(clairvoyant(&corridor), Reference::Proven { value: 299.0 });
}
