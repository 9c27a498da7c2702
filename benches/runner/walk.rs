//! Colonies on a map: the engine's, and the naive walk of `benches/reference`.

use std::sync::Arc;
use std::time::{Duration, Instant};

use formicarium::aco::heuristic::Heuristic;
use formicarium::catalog;
use formicarium::formats;
use formicarium::params::Values;
use formicarium::planner::{Granularity, Planner};
use formicarium::scenario::Scenario;
use serde::Deserialize;
use serde_json::{Value, json};

use super::Contestant;
use super::reference::Naive;

/// One iteration of a colony, and so many more; `who` is `engine` or `naive`.
#[derive(Deserialize)]
pub struct Job {
    who: String,
    map: String,
    planner: String,
    params: Values,
    iterations: u32,
}

/// The scenario in a file.
pub fn scenario(map: &str) -> Arc<Scenario> {
    let text = std::fs::read_to_string(map).expect("a map");
    let (grid, spec) = formats::read_scenario(&text).expect("a scenario");
    Arc::new(Scenario::new(grid, spec).expect("a valid scenario"))
}

/// A contestant as the job wants it.
pub fn contestant(job: Job) -> Box<dyn Contestant> {
    let scenario = scenario(&job.map);
    match job.who.as_str() {
        "engine" => Box::new(Engine { job, scenario }),
        "naive" => Box::new(NaiveWalk { job, scenario }),
        other => panic!("no walk of {other} here"),
    }
}

struct Engine {
    job: Job,
    scenario: Arc<Scenario>,
}

impl Contestant for Engine {
    fn round(&mut self, seed: u32) -> Value {
        let start = Instant::now();
        let mut planner = build(&self.scenario, &self.job.planner, &self.job.params, seed);
        run(&mut *planner, 1);
        let (first, before, start) = (start.elapsed(), planner.effort().ant_moves, Instant::now());
        run(&mut *planner, self.job.iterations);
        let mut told = answer(first, start.elapsed(), planner.effort().ant_moves - before, &planner.digest().hex());
        told["bytes"] = planner.bytes().into();
        told
    }
}

/// What it took to begin: the planner with its tables and the first iteration; then what the others took, and their moves.
fn answer(first: Duration, others: Duration, moves: u64, digest: &str) -> Value {
    json!({ "first": first.as_secs_f64(), "seconds": others.as_secs_f64(), "moves": moves, "digest": digest })
}

fn build(scenario: &Arc<Scenario>, planner: &str, params: &Values, seed: u32) -> Box<dyn Planner> {
    catalog::build(scenario, planner, None, params, seed).expect("valid parameters")
}

fn run(planner: &mut dyn Planner, iterations: u32) {
    for _ in 0..iterations {
        planner.advance(Granularity::Iteration);
    }
}

/// Ant System with its defaults: the one colony that is written naively.
struct NaiveWalk {
    job: Job,
    scenario: Arc<Scenario>,
}

impl Contestant for NaiveWalk {
    fn round(&mut self, seed: u32) -> Value {
        let start = Instant::now();
        let mut naive = Naive::new(Arc::clone(&self.scenario), 50, 5.0, 0.5, Heuristic::Detour, seed);
        naive.iterate();
        let (first, before, start) = (start.elapsed(), naive.moves, Instant::now());
        (0..self.job.iterations).for_each(|_| naive.iterate());
        answer(first, start.elapsed(), naive.moves - before, &naive.digest())
    }
}

/// How many moves a colony's ants make in these iterations.
pub fn moves(map: &str, planner: &str, iterations: u32) -> u64 {
    let mut planner = build(&scenario(map), planner, &Values::new(), 1);
    run(&mut *planner, iterations);
    planner.effort().ant_moves
}
