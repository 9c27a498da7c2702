//! Formica with polylines on the longer half of MovingAI's scenarios: how far its best one is above the shortest after so many iterations,
//! whether what it proves is right, and how many cells it expands beside `any-angle`.
//!
//! `cargo test --release --test formica_polylines -- --ignored --nocapture` measures ten scenarios of each map and prints the table.
#![cfg(not(target_arch = "wasm32"))]

#[path = "common/movingai.rs"]
mod movingai;

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use formicarium::catalog;
use formicarium::params::{Value, Values};
use formicarium::planner::{Effort, Planner, Status};
use formicarium::scenario::Scenario;

use movingai::{MAPS, folder, spread};

/// Iterations after which the best polyline is looked at, without a proof, which would find the shortest one.
const AFTER: [usize; 3] = [1, 3, 10];

/// Equal lengths, whatever rounding leaves of adding.
const SAME: f64 = 1e-6;

/// A planner that has run, and how long that took.
fn run(scenario: &Arc<Scenario>, planner: &str, values: &[(&str, f64)]) -> (Box<dyn Planner>, Duration) {
    let mut all: Values = values.iter().map(|&(key, value)| (key.to_string(), Value::Number(value))).collect();
    if planner == "formica" {
        all.insert("paths".into(), Value::from("polylines"));
    }
    let mut planner = catalog::build(scenario, planner, None, &all, 1).expect("valid parameters");
    let begun = Instant::now();
    planner.run();
    (planner, begun.elapsed())
}

/// What scenarios come to.
#[derive(Default)]
struct Tally {
    scenarios: u32,
    /// Σ of what the best polyline is longer than the shortest, as a part of that, and the largest, after each of [`AFTER`].
    above: [f64; 3],
    most_above: [f64; 3],
    /// The best polyline is the shortest after the last of [`AFTER`].
    exact: u32,
    /// The proof is complete, and it and the best polyline are right.
    proven: u32,
    /// What it says of the shortest polyline is wrong, or its result is longer than that of `theta-star`.
    wrong: u32,
    worse: u32,
    /// Σ of expansions, its own and those of `any-angle`, the largest quotient of the two, and Σ of ants' moves.
    expansions: u64,
    any_angle_expansions: u64,
    most_expansions: f64,
    moves: u64,
    iterations: u32,
    /// How long both took in all.
    took: Duration,
    any_angle_took: Duration,
}

impl Tally {
    fn take(&mut self, scenario: &Arc<Scenario>) {
        let (exact, any_angle_took) = run(scenario, "any-angle", &[]);
        assert_eq!(exact.status(), Status::Optimal, "{:?}", scenario.spec);
        let optimum = exact.best().expect("a polyline").length;
        self.look_at(scenario, optimum);
        let (full, took) = run(scenario, "formica", &[]);
        let (best, certificate) = (full.best().expect("a polyline").length, full.certificate().expect("a proof"));
        let is_right = |value: f64| (value - optimum).abs() < SAME;
        let is_proven = full.status() == Status::Optimal && certificate.complete;
        self.proven += u32::from(is_proven && is_right(best) && is_right(certificate.lower_bound));
        self.wrong += u32::from(certificate.lower_bound > optimum + SAME || best < optimum - SAME || is_proven != is_right(best));
        let theta_star = run(scenario, "theta-star", &[]).0.best().expect("a polyline").length;
        self.worse += u32::from(best > theta_star + SAME);
        self.count(full.effort(), exact.effort());
        (self.took, self.any_angle_took) = (self.took + took, self.any_angle_took + any_angle_took);
        self.scenarios += 1;
    }

    fn count(&mut self, effort: Effort, any_angle: Effort) {
        self.expansions += effort.cell_expansions;
        self.any_angle_expansions += any_angle.cell_expansions;
        self.most_expansions = self.most_expansions.max(effort.cell_expansions as f64 / any_angle.cell_expansions as f64);
        self.moves += effort.ant_moves;
        self.iterations += effort.iterations;
    }

    /// How far above the shortest polyline the best one is while iterations go by.
    fn look_at(&mut self, scenario: &Arc<Scenario>, optimum: f64) {
        let (bare, _) = run(scenario, "formica", &[("proof_limit", 0.0), ("iterations", AFTER[2] as f64)]);
        for (k, after) in AFTER.into_iter().enumerate() {
            let above = bare.history()[after - 1].best_so_far.expect("a polyline") / optimum - 1.0;
            assert!(above > -SAME, "shorter than the shortest: {:?}", scenario.spec);
            self.above[k] += above;
            self.most_above[k] = self.most_above[k].max(above);
        }
        self.exact += u32::from(bare.best().is_some_and(|best| best.length < optimum + SAME));
    }

    fn add(&mut self, other: &Self) {
        self.scenarios += other.scenarios;
        for k in 0..AFTER.len() {
            self.above[k] += other.above[k];
            self.most_above[k] = self.most_above[k].max(other.most_above[k]);
        }
        self.exact += other.exact;
        self.proven += other.proven;
        self.wrong += other.wrong;
        self.worse += other.worse;
        self.expansions += other.expansions;
        self.any_angle_expansions += other.any_angle_expansions;
        self.most_expansions = self.most_expansions.max(other.most_expansions);
        self.moves += other.moves;
        self.iterations += other.iterations;
        self.took += other.took;
        self.any_angle_took += other.any_angle_took;
    }

    fn row(&self, name: &str) -> String {
        let mean = |sum: f64| sum / f64::from(self.scenarios);
        let above = |k: usize| format!("{:.3} % ({:.2} %)", 100.0 * mean(self.above[k]), 100.0 * self.most_above[k]);
        let found = format!("{} | {} | {} | {} | {}", self.scenarios, above(0), above(1), above(2), self.exact);
        let of_its = |count: u64| count as f64 / self.any_angle_expansions as f64;
        let (expansions, most, moves) = (of_its(self.expansions), self.most_expansions, of_its(self.moves));
        let times = self.took.as_secs_f64() / self.any_angle_took.as_secs_f64();
        let proof = format!("{} | {expansions:.2} | {most:.2} | {:.1}", self.proven, mean(f64::from(self.iterations)));
        format!("| {name} | {found} | {proof} | {moves:.1} | {times:.1} |")
    }
}

/// So many scenarios of each of these maps.
fn measured(folder: &Path, maps: &[&str], count: usize) -> Tally {
    let above = "above after 1: mean (largest) | after 3 | after 10";
    let cost = "expansions / any-angle | largest | iterations | moves / its expansions | time / its time";
    println!("| map | scenarios | {above} | exact after 10 | proven | {cost} |");
    let mut all = Tally::default();
    for name in maps {
        let mut tally = Tally::default();
        spread(folder, name, count).for_each(|scenario| tally.take(&scenario));
        println!("{}", tally.row(name));
        all.add(&tally);
    }
    println!("{}", all.row("all"));
    all
}

fn holds(all: &Tally) {
    assert_eq!(all.wrong, 0, "what is proven is wrong");
    assert_eq!(all.worse, 0, "longer than theta-star");
    assert!(f64::from(all.proven) >= 0.95 * f64::from(all.scenarios), "{} of {} proven", all.proven, all.scenarios);
}

#[test]
fn a_sample_is_proven_right() {
    let Some(folder) = folder() else { return };
    holds(&measured(&folder, &[MAPS[0], MAPS[1], MAPS[2], MAPS[6], MAPS[9], MAPS[12]], 2));
}

#[test]
#[ignore = "minutes: ten scenarios of each map"]
fn ten_of_each_map_are_proven_right() {
    let Some(folder) = folder() else { return };
    let all = measured(&folder, &MAPS, 10);
    holds(&all);
    assert!(all.scenarios >= 60, "{}", all.scenarios);
}
