//! What holds for every drive, whoever plans: nothing collides, nobody is better than who knows everything, and it can be repeated.

use std::sync::Arc;

use formicarium::catalog;
use formicarium::drive::{Did, DriveParams, DriveStep, Driver, End, Replan};
use formicarium::map::Grid;
use formicarium::params::{Value, Values};
use formicarium::path::direction_between;
use formicarium::planner::Ground;
use formicarium::scenario::Scenario;

use super::moving::{Draws, map_at, random};

/// Planners that are cheap enough to drive often; the colonies with few ants.
const PLANNERS: [&str; 6] = ["astar", "d-star-lite", "d-star-lite", "ant-system", "ship", "pso"];

fn driver(scenario: &Arc<Scenario>, seed: u32) -> Driver {
    let mut draws = Draws(u64::from(seed) + 77);
    let able = |id: &str| catalog::find(id).is_ok_and(|entry| entry.grounds.contains(&Ground::of(scenario)));
    let planner = Some(draws.one_of(&PLANNERS)).filter(|id| able(id)).unwrap_or("d-star-lite");
    let specs = catalog::find(planner).expect("in the catalog").specs;
    let few = ["ants", "particles"].into_iter().filter(|key| specs().iter().any(|spec| spec.key == *key));
    let values: Values = few.map(|key| (key.to_owned(), Value::from(5.0))).collect();
    let params = DriveParams {
        iterations: 3,
        keep: draws.below(3) > 0,
        replan: draws.one_of(&[Replan::Changed, Replan::Blocked]),
        hold: draws.below(4),
        patience: 12,
        longest: 80,
    };
    Driver::new(scenario, planner, None, &values, seed, params).expect("it can drive")
}

/// The map after a step, from what the steps say of it.
fn change(map: &mut Grid, step: &DriveStep) {
    for (cells, blocked) in [(&step.blocked, true), (&step.freed, false)] {
        for &cell in cells {
            assert_ne!(map.is_blocked(map.cell(cell)), blocked, "{cell:?} changes to what it was");
            map.set_blocked(map.cell(cell), blocked);
        }
    }
}

/// Repeats a drive from its steps; the map is worked out anew.
fn assert_legal(scenario: &Scenario, steps: &[DriveStep], what: &str) {
    let mut map = scenario.grid.clone();
    let mut before: Option<&DriveStep> = None;
    for (k, step) in steps.iter().enumerate() {
        assert_eq!((step.step as usize, step.did == Did::Start), (k, k == 0), "{what}");
        if let Some(before) = before {
            let moved = direction_between(before.at, step.at);
            assert_eq!(moved.is_some(), step.did == Did::Move, "{what}: from {:?} to {:?}", before.at, step.at);
            let (x, y) = (i64::from(before.at.x), i64::from(before.at.y));
            assert!(moved.is_none_or(|d| scenario.spec.movement.allows(&map, x, y, d)), "{what}: step {k} collides");
        }
        change(&mut map, step);
        assert!(!map.is_blocked(map.cell(step.at)), "{what}: something stands on the robot after step {k}");
        assert_eq!(map, map_at(scenario, step.step, step.at), "{what}: the map after step {k}");
        before = Some(step);
    }
}

#[test]
fn no_drive_collides_or_beats_who_knows_everything() {
    let (mut arrived, mut waited, mut replanned, mut worse) = (0, 0, 0, 0);
    for seed in 0..600 {
        let scenario = random(4 + seed % 9, 500 + seed);
        let mut robot = driver(&scenario, seed);
        let drive = robot.run();
        let what = format!("drive {seed}");
        assert_legal(&scenario, robot.steps(), &what);
        assert_eq!(drive.moves + drive.waits + 1, robot.steps().len() as u32, "{what}");
        if drive.end == Some(End::Arrived) {
            assert_eq!(robot.at(), scenario.spec.goals[0].at, "{what}");
            let ratio = drive.ratio.unwrap_or_else(|| panic!("{what}: {:?}", drive.clairvoyant));
            assert!(ratio >= 1.0, "{what} is {ratio} of the best");
            (arrived, worse) = (arrived + 1, worse + u32::from(ratio > 1.0));
        }
        (waited, replanned) = (waited + drive.waits, replanned + drive.replans);
        assert_eq!(driver(&scenario, seed).run(), drive, "{what} once more");
    }
    assert!(arrived > 400 && worse > 50 && waited > 200 && replanned > 500, "{arrived}, {worse}, {waited}, {replanned}");
}

#[test]
fn where_nothing_moves_an_exact_planner_drives_the_shortest_path() {
    for seed in 0..20 {
        let scenario = super::common::random(30, 0.25, seed, Default::default());
        for planner in ["astar", "dijkstra", "d-star-lite"] {
            let mut robot =
                Driver::new(&scenario, planner, None, &Values::new(), 1, DriveParams::default()).expect("it can drive");
            let drive = robot.run();
            assert_eq!((drive.ratio, drive.waits, drive.replans), (Some(1.0), 0, 0), "{planner}");
            assert!((drive.length - super::common::length(&scenario, "astar")).abs() < 1e-9);
        }
    }
}
