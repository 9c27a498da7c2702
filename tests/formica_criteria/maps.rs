//! Benchmark maps of 128 to 512 cells a side: how often the best path of ten iterations is the best there is, whether what is proven is right,
//! and how many states are expanded beside those of the turn-aware search.
//!
//! `cargo test --release --test formica_criteria -- --ignored --nocapture` measures twelve scenarios of each map and prints the tables.

use std::path::Path;

use formicarium::params::Value;
use formicarium::planner::{Planner, Status};

use super::movingai::{MAPS, folder, spread};
use super::{Arc, By, Scenario, WeightedSum, catalog, same, solved, value};

/// Maps of less than 64 cells a side, or hardly more: they are not measured.
const SMALL: [&str; 3] = ["random-32-32-20-random-1", "room-64-64-16-random-1", "arena.map"];

/// Iterations after which the best path is looked at.
const ITERATIONS: f64 = 10.0;

/// What scenarios come to.
#[derive(Default)]
struct Tally {
    scenarios: u32,
    /// The best path after one iteration, and after [`ITERATIONS`], is the best there is; without a proof, which would find it.
    at_once: u32,
    exact: u32,
    /// The certificate is right: complete and the optimum, or a lower bound of it.
    right: u32,
    /// It is complete.
    proven: u32,
    /// Σ of expansions over those of the turn-aware search, and the largest.
    ratio: f64,
    worst: f64,
    iterations: f64,
}

impl Tally {
    fn take(&mut self, s: &Arc<Scenario>, by: By, merge: bool) {
        let exact = solved(s, "turn-aware", by, &[]);
        let optimum = value(s, &*exact);
        let is_best = |iterations| {
            u32::from(same(value(s, &*with(s, by, merge, &[("proof_limit", 0.0), ("iterations", iterations)])), optimum))
        };
        self.at_once += is_best(1.0);
        self.exact += is_best(ITERATIONS);
        let full = with(s, by, merge, &[]);
        let (best, certificate) = (value(s, &*full), full.certificate().expect("a proof"));
        let complete = full.status() == Status::Optimal && certificate.complete;
        let is_right = if complete {
            same(best, optimum) && same(certificate.lower_bound, optimum)
        } else {
            certificate.lower_bound <= optimum
        };
        self.right += u32::from(is_right && best > optimum - 1e-7);
        self.proven += u32::from(complete);
        let ratio = full.effort().cell_expansions as f64 / exact.effort().cell_expansions as f64;
        (self.ratio, self.worst) = (self.ratio + ratio, self.worst.max(ratio));
        self.iterations += f64::from(full.effort().iterations);
        self.scenarios += 1;
    }

    fn add(&mut self, other: &Self) {
        self.scenarios += other.scenarios;
        self.at_once += other.at_once;
        self.exact += other.exact;
        self.right += other.right;
        self.proven += other.proven;
        self.ratio += other.ratio;
        self.worst = self.worst.max(other.worst);
        self.iterations += other.iterations;
    }

    fn row(&self, name: &str) -> String {
        let mean = |sum: f64| sum / f64::from(self.scenarios);
        let counts = format!("{} | {} | {} | {} | {}", self.scenarios, self.at_once, self.exact, self.right, self.proven);
        format!("| {name} | {counts} | {:.2} | {:.2} | {:.1} |", mean(self.ratio), self.worst, mean(self.iterations))
    }
}

/// Formica's run, with merging or without.
fn with(s: &Arc<Scenario>, by: By, merge: bool, set: &[(&str, f64)]) -> Box<dyn Planner> {
    let mut values = by.values();
    values.insert("merge".into(), merge.into());
    values.extend(set.iter().map(|&(key, value)| (key.to_string(), Value::Number(value))));
    let mut planner = catalog::build(s, "formica", None, &values, 1).expect("valid parameters");
    planner.run();
    planner
}

/// So many scenarios of each map, spread evenly over its longer half.
fn measured(folder: &Path, count: usize, by: By, merge: bool) -> Tally {
    println!("{by:?}, merging: {merge}");
    println!(
        "| map | scenarios | exact after 1 | exact after 10 | right | proven | expansions / turn-aware | largest | iterations |"
    );
    let mut all = Tally::default();
    for name in MAPS.into_iter().filter(|name| !SMALL.contains(name)) {
        let mut tally = Tally::default();
        spread(folder, name, count).for_each(|s| tally.take(&s, by, merge));
        println!("{}", tally.row(name));
        all.add(&tally);
    }
    println!("{}", all.row("all"));
    all
}

/// No certificate is wrong, and all are complete.
fn holds(all: &Tally) {
    assert_eq!((all.right, all.proven), (all.scenarios, all.scenarios), "a certificate is not right, or not complete");
}

/// The same, and merging finds the best path itself, nearly always.
fn finds(all: &Tally) {
    holds(all);
    assert!(f64::from(all.exact) >= 0.95 * f64::from(all.scenarios), "{} of {} exact", all.exact, all.scenarios);
}

#[test]
fn a_sample_is_found_and_proven() {
    let Some(folder) = folder() else { return };
    finds(&measured(&folder, 1, By::TurnIndex, true));
}

#[test]
#[ignore = "minutes: twelve scenarios of each map, three times"]
fn twelve_of_each_map_by_both_criteria() {
    let Some(folder) = folder() else { return };
    finds(&measured(&folder, 12, By::TurnIndex, true));
    holds(&measured(&folder, 12, By::TurnIndex, false));
    finds(&measured(&folder, 12, By::Sum(WeightedSum::default()), true));
}
