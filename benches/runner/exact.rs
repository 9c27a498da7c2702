//! The length of the shortest path: from the cells and two ends to a number, everything included.

use std::sync::Arc;
use std::time::Instant;

use formicarium::exact::optimum;
use formicarium::map::{Grid, Point};
use formicarium::scenario::{Scenario, ScenarioSpec};
use serde::Deserialize;
use serde_json::{Value, json};

use super::{Contestant, walk};

/// These questions on one map: (x, y) of the start, (x, y) of the goal.
#[derive(Deserialize)]
pub struct Job {
    map: String,
    lines: Vec<[u32; 4]>,
}

/// The questions of a job, ready to be asked.
pub struct Exact {
    grid: Grid,
    questions: Vec<ScenarioSpec>,
}

impl Exact {
    /// Reads the map.
    pub fn new(job: Job) -> Self {
        let read = walk::scenario(&job.map);
        let question = |[x, y, to_x, to_y]: [u32; 4]| {
            let spec = ScenarioSpec::new(&read.grid, Point::new(x, y), Point::new(to_x, to_y));
            ScenarioSpec { movement: read.spec.movement, ..spec }
        };
        Self { grid: read.grid.clone(), questions: job.lines.into_iter().map(question).collect() }
    }
}

impl Contestant for Exact {
    fn round(&mut self, _: u32) -> Value {
        let start = Instant::now();
        let answer = |spec: &ScenarioSpec| {
            let scenario = Scenario::new(self.grid.clone(), spec.clone()).expect("usable ends");
            optimum(&Arc::new(scenario)).expect("a path")
        };
        let lengths: Vec<f64> = self.questions.iter().map(answer).collect();
        json!({ "seconds": start.elapsed().as_secs_f64(), "lengths": lengths })
    }
}
