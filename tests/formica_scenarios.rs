//! Formica on the longer half of MovingAI's scenarios, by its defaults: how often the best path of ten iterations is the shortest, whether what
//! it proves is right, and how many cells it expands beside A*.
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
use formicarium::scenario::Scenario;

use movingai::{MAPS, folder, spread};

/// Iterations after which the best path is looked at.
const ITERATIONS: f64 = 10.0;

/// Equal lengths, whatever rounding leaves of adding.
const SAME: f64 = 1e-6;

/// Runs a planner by these numbers, and by settings as the command line writes them.
fn run(scenario: &Arc<Scenario>, planner: &str, numbers: &[(&str, f64)], set: &[(&str, &str)]) -> Box<dyn Planner> {
    let mut values: Values = numbers.iter().map(|&(key, value)| (key.to_string(), Value::Number(value))).collect();
    values.extend(set.iter().map(|&(key, value)| (key.to_string(), Value::parse(value))));
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
    /// Σ of the same with each free cell on top that is looked at for the scent: once to find the parts, once to join them.
    looked: f64,
    /// Σ of iterations, and of ants' moves over A*'s expansions.
    iterations: f64,
    moves: f64,
}

impl Tally {
    fn take(&mut self, scenario: &Arc<Scenario>, set: &[(&str, &str)]) {
        let astar = run(scenario, "astar", &[], &[]);
        let optimum = astar.best().expect("a path").length;
        let bare = run(scenario, "formica", &[("proof_limit", 0.0), ("iterations", ITERATIONS)], set);
        let is_exact = |length: Option<f64>| u32::from(length.is_some_and(|length| length < optimum + SAME));
        self.at_once += is_exact(bare.history()[0].best_so_far);
        self.exact += is_exact(bare.best().map(|best| best.length));
        let full = run(scenario, "formica", &[], set);
        let (best, certificate) = (full.best().expect("a path").length, full.certificate().expect("a proof"));
        let is_right = |value: f64| (value - optimum).abs() < SAME;
        let is_proven = full.status() == Status::Optimal && certificate.complete;
        self.proven += u32::from(is_proven && is_right(best) && is_right(certificate.lower_bound));
        let expansions = astar.effort().cell_expansions as f64;
        let ratio = full.effort().cell_expansions as f64 / expansions;
        self.ratio += ratio;
        self.worst = self.worst.max(ratio);
        let free = (0..scenario.grid.len() as u32).filter(|&cell| !scenario.grid.is_blocked(cell)).count();
        let smelt = if set.contains(&("scent", "false")) { 0.0 } else { 2.0 * free as f64 };
        self.looked += ratio + smelt / expansions;
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
        self.looked += other.looked;
        self.iterations += other.iterations;
        self.moves += other.moves;
    }

    fn row(&self, name: &str) -> String {
        let mean = |sum: f64| sum / f64::from(self.scenarios);
        let (ratio, looked, iterations, moves) = (mean(self.ratio), mean(self.looked), mean(self.iterations), mean(self.moves));
        let counts = format!("{} | {} | {} | {}", self.scenarios, self.at_once, self.exact, self.proven);
        format!("| {name} | {counts} | {ratio:.2} | {:.2} | {looked:.2} | {iterations:.1} | {moves:.1} |", self.worst)
    }
}

/// So many scenarios of each map, spread evenly over its longer half.
fn measured(folder: &Path, count: usize) -> Tally {
    println!(
        "| map | scenarios | exact after 1 | exact after 10 | proven | expansions / A* | largest | with looks for the scent | iterations | moves / A* |"
    );
    let mut all = Tally::default();
    for name in MAPS {
        let mut tally = Tally::default();
        spread(folder, name, count).for_each(|scenario| tally.take(&scenario, &[]));
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

/// What is taken out, or how many ants walk.
const PARTS: [(&str, &[(&str, &str)]); 8] = [
    ("all of it", &[]),
    ("without scent", &[("scent", "false")]),
    ("without merging", &[("merge", "false")]),
    ("without the adaptive corridor", &[("adaptive_corridor", "false")]),
    ("without restarts", &[("trail_restart", "0")]),
    ("4 ants", &[("ants", "4")]),
    ("8 ants", &[("ants", "8")]),
    ("32 ants", &[("ants", "32")]),
];

#[test]
#[ignore = "minutes: twelve scenarios of each map with each part taken out"]
fn what_each_part_is_worth() {
    let Some(folder) = folder() else { return };
    for (name, set) in PARTS {
        let mut tally = Tally::default();
        MAPS.iter().flat_map(|map| spread(&folder, map, 12)).for_each(|scenario| tally.take(&scenario, set));
        println!("{}", tally.row(name));
        assert_eq!(tally.proven, tally.scenarios, "{name}");
    }
}
