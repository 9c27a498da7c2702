//! What every planner of the catalog must keep, whatever its paper says. A new planner is covered by its line in the catalog, on every
//! ground that it claims.
#![cfg(not(target_arch = "wasm32"))]

mod certificates;
mod changes;
#[path = "../common/mod.rs"]
mod common;
mod components;
mod grounds;
mod layers;
mod parameters;
mod paths;
mod polylines;
mod runs;
mod snapshots;
#[path = "../common/terrains.rs"]
mod terrains;
mod tours;

use std::sync::Arc;

use common::{gallery, movements};
use formicarium::catalog::{self, CATALOG};
use formicarium::params::{Value, Values};
use formicarium::planner::{Ground, Planner, PlannerEntry};
use formicarium::scenario::Scenario;

/// A budget that keeps the tests short, where the planner has one.
fn short(entry: &PlannerEntry) -> Values {
    let has = |key: &str| (entry.specs)().iter().any(|s| s.key == key);
    let mut values = Values::new();
    for (key, value) in [("iterations", 12.0), ("seed_iterations", 6.0), ("ants", 10.0), ("particles", 10.0)] {
        if has(key) {
            values.insert(key.into(), Value::Number(value));
        }
    }
    values
}

fn planner(entry: &PlannerEntry, scenario: &Arc<Scenario>, seed: u32) -> Box<dyn Planner> {
    catalog::build(scenario, entry.id, None, &short(entry), seed).expect("valid parameters")
}

/// Whether a planner plans there at all.
fn takes(entry: &PlannerEntry, scenario: &Scenario) -> bool {
    scenario.goals.len() <= entry.max_goals as usize && Ground::all_of(scenario).all(|ground| entry.grounds.contains(&ground))
}

/// Every scenario: planes and tours under every movement, weighted ground, and every terrain.
fn scenarios() -> Vec<(String, Arc<Scenario>)> {
    let on_planes = movements().into_iter().flat_map(|movement| {
        let all = gallery(movement).into_iter().chain(common::tours(movement));
        all.map(move |(name, scenario)| (format!("{name} with {movement:?}"), scenario))
    });
    let weighted = movements()
        .into_iter()
        .chain(terrains::sixteen())
        .map(|movement| (format!("a swamp with {movement:?}"), common::swamp(movement)));
    on_planes.chain(weighted).chain(terrains::terrains(&movements())).collect()
}

/// Calls `check` for every planner on every scenario that it takes, under every movement.
fn everywhere(check: impl Fn(&PlannerEntry, &str, &Arc<Scenario>)) {
    let all = scenarios();
    for entry in CATALOG {
        for (name, scenario) in all.iter().filter(|(_, s)| takes(entry, s)) {
            check(entry, &format!("{} on {name}", entry.id), scenario);
        }
    }
}
