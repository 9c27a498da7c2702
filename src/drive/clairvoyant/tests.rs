//! How long the map takes to repeat itself, and what is too much to search. Values against brute force: `tests/drive`.

use super::*;
use crate::map::{Movement, Point};
use crate::scenario::{AtEnd, DriveChange, ScenarioSpec, Track};

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
    let of = |settled, period| Some(Time { settled, period });
    assert_eq!(time(Vec::new(), &[]), of(0, 1));
    assert_eq!(time(Vec::new(), &[3, 8]), of(8, 1));
    assert_eq!(time(vec![track(4, 10, 2, AtEnd::Stay)], &[3]), of(18, 1));
    // To and fro over four cells are six.
    let (there, round) = (track(4, 0, 2, AtEnd::BackAndForth), track(2, 5, 4, AtEnd::Loop));
    assert_eq!(time(vec![there.clone(), round], &[]), of(13, 24));
    let primes = [997, 991, 983].map(|steps| track(2, 0, steps, AtEnd::Loop)).to_vec();
    assert_eq!(time(primes, &[]), None, "two thousand million steps");
    let (time, steps) = (Time { settled: 13, period: 24 }, [0, 12, 35, 36]);
    assert_eq!(steps.map(|step| time.after(step)), [1, 13, 36, 13]);
}

#[test]
fn what_is_too_much_is_unknown() {
    let drive = |side: u32, at_step: u32| {
        let grid = Grid::open(side, side).expect("a map");
        let changes = vec![DriveChange { at_step, blocked: vec![Point::new(1, 1)], freed: Vec::new() }];
        let plain = Scenario::on(grid.clone(), Movement::default(), Point::new(0, 0), Point::new(side - 1, 0)).expect("usable");
        let spec = ScenarioSpec { drive: Some(DriveSpec { changes, ..DriveSpec::default() }), ..plain.spec };
        clairvoyant(&Scenario::new(grid, spec).expect("usable"))
    };
    assert_eq!(drive(20, 40), Reference::Proven { value: 19.0 });
    assert_eq!(drive(64, 1024), Reference::Unknown);
    assert_eq!(drive(64, 1023), Reference::Proven { value: 63.0 }, "4096 cells times 1024 steps");
}
