//! The fast walk against the naive one (pow per neighbour): equal digests, so every step of every ant was the same.

#![cfg(not(target_arch = "wasm32"))]

mod common;
#[path = "../benches/reference/mod.rs"]
mod reference;

use common::{movements, random};
use formicarium::aco::heuristic::Heuristic;
use formicarium::catalog;
use formicarium::params::{Value, Values};
use formicarium::planner::Granularity;

fn compare(side: u32, seed: u32, iterations: u32, id: &str, heuristic: Heuristic, beta: f64) {
    for movement in movements() {
        let scenario = random(side, 0.2, seed, movement);
        let mut naive = reference::Naive::new(scenario.clone(), 50, beta, 0.5, heuristic, seed);
        let values: Values =
            [("heuristic".to_string(), Value::Text(id.into())), ("beta".to_string(), Value::Number(beta))].into();
        let mut engine = catalog::build(&scenario, "ant-system", None, &values, seed).expect("valid parameters");
        for _ in 0..iterations {
            naive.iterate();
            engine.advance(Granularity::Iteration);
        }
        assert_eq!(engine.effort().ant_moves, naive.moves, "{side} {id} {movement:?}");
        assert_eq!(engine.digest().hex(), naive.digest(), "{side} {id} {movement:?}");
    }
}

#[test]
fn detour_on_100_by_100() {
    compare(100, 1, 6, "detour", Heuristic::Detour, 5.0);
}

#[test]
fn goal_distance_on_small_maps_for_many_iterations() {
    for seed in 0..4 {
        compare(20, seed, 40, "goal", Heuristic::Goal, 7.0);
    }
}

#[test]
fn step_length_with_a_fractional_exponent() {
    compare(30, 2, 20, "step", Heuristic::Step, 2.5);
}
