//! A robot that drives, step by step.

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::{Bytes, Heights, Number, ParamValues, Text};
use super::{Answer, object, scenario, throw};
use crate::drive::{DRIVE, Drive, DriveParams, DriveStep, Driver, End};
use crate::map::Point;
use crate::params::{ParamSpec, Params};
use crate::scenario::ScenarioSpec;

/// A robot as it stands, beside what its last step has told.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct DriveState {
    /// Its last step; the first is at the start.
    pub last: DriveStep,
    /// How the drive has ended; null while it goes on.
    pub end: Option<End>,
    /// The rest of its path, from its cell to the goal; empty without one.
    #[tsify(type = "[number, number][]")]
    pub path: Vec<Point>,
    /// The centre and the size of each obstacle on the map, null for one that is not there.
    pub obstacles: Vec<Option<Obstacle>>,
    /// Cells that the robot takes for blocked, and that are free now.
    #[tsify(type = "[number, number][]")]
    pub believed_blocked: Vec<Point>,
    /// Cells that the robot takes for free, and that are blocked now.
    #[tsify(type = "[number, number][]")]
    pub believed_free: Vec<Point>,
}

/// An obstacle on the map.
#[derive(Serialize, Tsify)]
pub struct Obstacle {
    /// Its centre.
    #[tsify(type = "[number, number]")]
    pub at: Point,
    /// Cells a side.
    pub size: u32,
}

/// A robot that drives in a scenario whose `drive` says what moves. A worker makes one, calls `step` at its pace, and draws by what each
/// step tells: the cells that it has blocked and freed, and the robot's cell. `summary` searches, once, for the best drive in advance, which may
/// take seconds: it is for the end.
#[wasm_bindgen]
pub struct DriveRun {
    driver: Driver,
}

#[wasm_bindgen]
impl DriveRun {
    /// Makes a robot at the start; nothing is planned before the first `step`. `values` are the planner's, `driving` those of
    /// `drive_params`.
    #[wasm_bindgen(constructor)]
    #[allow(clippy::too_many_arguments, reason = "a map crosses as its parts")]
    pub fn new(
        spec: Ts<ScenarioSpec>,
        cells: &Bytes,
        heights: Option<Heights>,
        factors: Option<Heights>,
        planner: &Text,
        values: &ParamValues,
        seed: &Number,
        driving: &ParamValues,
    ) -> Answer<DriveRun> {
        let scenario = scenario(&spec, cells, [heights.as_ref(), factors.as_ref()])?;
        let (planner, seed) = (planner.read("planner")?, seed.whole("seed")?);
        let params = DriveParams::read(DRIVE, &driving.read("driving")?).map_err(throw)?;
        let driver = Driver::new(&scenario, &planner, None, &values.read("values")?, seed, params).map_err(throw)?;
        Ok(DriveRun { driver })
    }

    /// Up to `count` steps further: what was done in each; fewer, or none, once the drive has ended.
    pub fn step(&mut self, count: &Number) -> Answer<Vec<Ts<DriveStep>>> {
        let mut steps = Vec::new();
        for _ in 0..count.whole("count")? {
            let Some(step) = self.driver.step() else { break };
            steps.push(object(step));
        }
        Ok(steps)
    }

    /// Where it stands.
    pub fn state(&self) -> Ts<DriveState> {
        let driver = &self.driver;
        let (believed_blocked, believed_free) = driver.mistaken();
        let path = driver.path().iter().map(|&cell| driver.map().point(cell)).collect();
        let obstacle = |(at, size): (Option<Point>, u32)| at.map(|at| Obstacle { at, size });
        object(&DriveState {
            last: driver.last().clone(),
            end: driver.end(),
            path,
            obstacles: driver.obstacles().map(obstacle).collect(),
            believed_blocked,
            believed_free,
        })
    }

    /// What the drive comes to so far, compared with the best in advance.
    pub fn summary(&self) -> Ts<Drive> {
        object(&self.driver.drive())
    }
}

/// How a robot drives, as rows for controls: the `driving` of a `DriveRun`.
#[wasm_bindgen]
pub fn drive_params() -> Vec<Ts<ParamSpec>> {
    DriveParams::specs().iter().map(object).collect()
}
