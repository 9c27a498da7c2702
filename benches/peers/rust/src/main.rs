//! Exact searches of the crates `pathfinding` and `grid_pathfinding`, as a runner of `cargo xtask bench` (benches/runner has the protocol).

mod map;
mod searches;

use std::io::{BufRead, Write, stdin, stdout};

use serde_json::{Value, json};

use map::Map;
use searches::{Astar, JumpPoints, Search};

/// One search, its questions, and what it took to get ready for the map.
struct Contestant {
    search: Box<dyn Search>,
    lines: Vec<[i32; 4]>,
}

impl Contestant {
    fn new(job: &Value) -> Self {
        let map = Map::read(job["map"].as_str().expect("a map"));
        let search: Box<dyn Search> = match job["who"].as_str() {
            Some("pathfinding") => Box::new(Astar::new(map)),
            Some("grid_pathfinding") => Box::new(JumpPoints::new(&map)),
            other => panic!("no search of {other:?} here"),
        };
        let lines = serde_json::from_value(job["lines"].clone()).expect("four numbers a question");
        Self { search, lines }
    }

    fn round(&mut self) -> Value {
        let start = std::time::Instant::now();
        let lengths: Vec<f64> = self.lines.iter().map(|&line| self.search.length(line)).collect();
        json!({ "seconds": start.elapsed().as_secs_f64(), "lengths": lengths })
    }
}

fn main() {
    let mut contestants = Vec::new();
    for line in stdin().lock().lines() {
        let request: Value = serde_json::from_str(&line.expect("a line")).expect("a request");
        let answer = if let Some(job) = request.get("prepare") {
            contestants.push(Contestant::new(job));
            json!(contestants.len() - 1)
        } else {
            let number = request["round"].as_u64().expect("a number");
            contestants[number as usize].round()
        };
        println!("{answer}");
        stdout().flush().expect("somebody reads");
    }
}
