//! The length of the shortest path between two cells of a map that is known: two cells in, a number out.

use std::time::Instant;

use formicarium::exact::Optima;
use formicarium::map::{Cell, Point};
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
    optima: Optima,
    questions: Vec<[Cell; 2]>,
}

impl Exact {
    /// Reads the map, and works out what depends on it alone.
    pub fn new(job: Job) -> Self {
        let scenario = walk::scenario(&job.map);
        let cell = |x, y| scenario.grid.cell(Point::new(x, y));
        let questions = job.lines.iter().map(|&[x, y, to_x, to_y]| [cell(x, y), cell(to_x, to_y)]).collect();
        Self { optima: Optima::new(&scenario), questions }
    }
}

impl Contestant for Exact {
    fn round(&mut self, _: u32) -> Value {
        let start = Instant::now();
        let answer = |&[from, to]: &[Cell; 2]| self.optima.between(from, to).expect("a path");
        let lengths: Vec<f64> = self.questions.iter().map(answer).collect();
        json!({ "seconds": start.elapsed().as_secs_f64(), "lengths": lengths })
    }
}
