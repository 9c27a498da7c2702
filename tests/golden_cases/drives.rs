//! Frozen drives: two obstacles go to and fro, and the robot sees six cells far.

use std::sync::Arc;

use formicarium::drive::{DriveParams, Driver};
use formicarium::map::{Generator, Movement, Point, generate};
use formicarium::params::Values;
use formicarium::scenario::{AtEnd, DriveSpec, Scenario, ScenarioSpec, Track};

/// A planner and the digest.
const FROZEN: &[(&str, &str)] = &[
    ("d-star-lite", "81c344347bf28bb5"),
    ("astar", "b9a45c3bd99fc40f"),
    ("ant-system", "89d3d2d484bc8427"),
    ("max-min-ant-system", "f7411b0344c730f2"),
];

fn track(cells: impl Iterator<Item = (u32, u32)>, size: u32, steps_per_cell: u32) -> Track {
    let cells = cells.map(|(x, y)| Point::new(x, y)).collect();
    Track { cells, size, from_step: 0, steps_per_cell, at_end: AtEnd::BackAndForth }
}

fn scenario() -> Arc<Scenario> {
    let made = generate(Generator::Random, 24, 24, 7, 0.2).expect("a valid size");
    let tracks = vec![track((4..20).map(|x| (x, 12)), 2, 1), track((3..21).map(|y| (12, y)), 1, 2)];
    let drive = DriveSpec { changes: Vec::new(), tracks, sight: Some(6.0) };
    let one = Scenario::on(made.grid, Movement::default(), made.start, made.goal).expect("usable");
    let spec = ScenarioSpec { drive: Some(drive), ..one.spec.clone() };
    Arc::new(Scenario::new(one.grid, spec).expect("usable"))
}

/// What no longer is as it was frozen.
pub fn differences() -> Vec<String> {
    let scenario = scenario();
    let differs = |&(planner, frozen): &(&str, &str)| {
        let params = DriveParams { iterations: 10, ..DriveParams::default() };
        let mut robot = Driver::new(&scenario, planner, None, &Values::new(), 11, params).expect("it can drive");
        let digest = robot.run().digest;
        (digest != frozen).then(|| format!("drive ({planner}): {digest}, frozen {frozen}"))
    };
    FROZEN.iter().filter_map(differs).collect()
}
