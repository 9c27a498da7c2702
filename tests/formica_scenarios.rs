//! Formica on the longer half of MovingAI's scenarios, by its defaults: how often the best path of ten iterations is the shortest, whether what
//! it proves is right, and how many cells it expands beside A*. The files are those of the data folder that the environment variable
//! FORMICARIUM_DATA names; they may not be redistributed, so without the variable this is skipped, aloud.
//!
//! `cargo test --release --test formica_scenarios -- --ignored --nocapture` measures a hundred scenarios of each map and prints the table.
#![cfg(not(target_arch = "wasm32"))]

#[path = "common/movingai.rs"]
mod movingai;

use std::path::Path;
use std::sync::Arc;

use formicarium::catalog;
use formicarium::params::{Value, Values};
use formicarium::planner::{Planner, Status};
use formicarium::scenario::{Goal, Scenario};
use movingai::{folder, load};

/// Random cells, rooms, mazes, games, a city, a warehouse.
const MAPS: [&str; 13] = [
    "random-32-32-20-random-1",
    "room-64-64-16-random-1",
    "maze-128-128-10-random-1",
    "32room_000.map",
    "maze512-8-0.map",
    "random512-25-0.map",
    "den312d.map",
    "lak303d.map",
    "brc202d.map",
    "arena.map",
    "arena2.map",
    "Berlin_0_256.map",
    "warehouse-10-20-10-2-1-random-1",
];

/// Iterations after which the best path is looked at.
const ITERATIONS: f64 = 10.0;

/// Equal lengths, whatever rounding leaves of adding.
const SAME: f64 = 1e-6;

fn run(scenario: &Arc<Scenario>, planner: &str, values: &[(&str, f64)]) -> Box<dyn Planner> {
    let values: Values = values.iter().map(|&(key, value)| (key.to_string(), Value::Number(value))).collect();
    let mut planner = catalog::build(scenario, planner, None, &values, 1).expect("valid parameters");
    planner.run();
    planner
}

/// What scenarios come to.
#[derive(Default)]
struct Tally {
    scenarios: u32,
    /// The best path is the shortest after one iteration, and after [`ITERATIONS`]; without a proof, which would find it.
    at_once: u32,
    exact: u32,
    /// The proof is complete, and it and the best path are right.
    proven: u32,
    /// Σ of expansions over those of A*: of parts for the scent, of cells for merging and proof.
    ratio: f64,
    worst: f64,
    /// Σ of iterations, and of ants' moves over A*'s expansions.
    iterations: f64,
    moves: f64,
}

impl Tally {
    fn take(&mut self, scenario: &Arc<Scenario>) {
        let astar = run(scenario, "astar", &[]);
        let optimum = astar.best().expect("a path").length;
        let bare = run(scenario, "formica", &[("proof_limit", 0.0), ("iterations", ITERATIONS)]);
        let is_exact = |length: Option<f64>| u32::from(length.is_some_and(|length| length < optimum + SAME));
        self.at_once += is_exact(bare.history()[0].best_so_far);
        self.exact += is_exact(bare.best().map(|best| best.length));
        let full = run(scenario, "formica", &[]);
        let (best, certificate) = (full.best().expect("a path").length, full.certificate().expect("a proof"));
        let is_right = |value: f64| (value - optimum).abs() < SAME;
        let is_proven = full.status() == Status::Optimal && certificate.complete;
        self.proven += u32::from(is_proven && is_right(best) && is_right(certificate.lower_bound));
        let expansions = astar.effort().cell_expansions as f64;
        let ratio = full.effort().cell_expansions as f64 / expansions;
        self.ratio += ratio;
        self.worst = self.worst.max(ratio);
        self.iterations += f64::from(full.effort().iterations);
        self.moves += full.effort().ant_moves as f64 / expansions;
        self.scenarios += 1;
    }

    fn add(&mut self, other: &Self) {
        self.scenarios += other.scenarios;
        self.at_once += other.at_once;
        self.exact += other.exact;
        self.proven += other.proven;
        self.ratio += other.ratio;
        self.worst = self.worst.max(other.worst);
        self.iterations += other.iterations;
        self.moves += other.moves;
    }

    fn row(&self, name: &str) -> String {
        let mean = |sum: f64| sum / f64::from(self.scenarios);
        let (ratio, iterations, moves) = (mean(self.ratio), mean(self.iterations), mean(self.moves));
        let counts = format!("{} | {} | {} | {}", self.scenarios, self.at_once, self.exact, self.proven);
        format!("| {name} | {counts} | {ratio:.2} | {:.2} | {iterations:.1} | {moves:.1} |", self.worst)
    }
}

/// So many scenarios of each map, spread evenly over its longer half.
fn measured(folder: &Path, count: usize) -> Tally {
    println!(
        "| map | scenarios | exact after 1 | exact after 10 | proven | expansions / A* | largest | iterations | moves / A* |"
    );
    let mut all = Tally::default();
    for name in MAPS {
        let (lines, map) = load(&folder.join(format!("{name}.scen")));
        let count = count.min(lines.len());
        let mut tally = Tally::default();
        for line in (0..count).map(|k| &lines[k * lines.len() / count]) {
            tally.take(&Arc::new(map.with_ends(line.start, vec![Goal::new(line.goal, "")]).expect("usable")));
        }
        println!("{}", tally.row(name));
        all.add(&tally);
    }
    println!("{}", all.row("all"));
    all
}

fn holds(all: &Tally) {
    assert_eq!(all.proven, all.scenarios, "a proof is not complete, or not right");
    assert!(f64::from(all.exact) >= 0.99 * f64::from(all.scenarios), "{} of {} exact", all.exact, all.scenarios);
    assert!(all.ratio / f64::from(all.scenarios) <= 4.0, "{} times the expansions of A*", all.ratio / f64::from(all.scenarios));
}

#[test]
fn a_sample_is_exact_proven_and_cheap() {
    let Some(folder) = folder() else { return };
    holds(&measured(&folder, 6));
}

#[test]
#[ignore = "minutes: a hundred scenarios of each map"]
fn a_hundred_of_each_map_are_exact_proven_and_cheap() {
    let Some(folder) = folder() else { return };
    holds(&measured(&folder, 100));
}
