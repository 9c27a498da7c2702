//! Components: what a publication adds, each of which can be taken out alone.

use std::collections::BTreeMap;
use std::sync::Arc;

use formicarium::catalog::{self, CATALOG};
use formicarium::map::{Measure, Movement};
use formicarium::params::{Value, Values};
use formicarium::planner::{Component, PlannerEntry};
use formicarium::scenario::Scenario;

use super::common::{drawn, random, rooms, tours};
use super::{takes, terrains};

fn with_components() -> impl Iterator<Item = (&'static PlannerEntry, &'static Component)> {
    CATALOG.iter().flat_map(|entry| entry.components.iter().map(move |component| (*entry, component)))
}

/// Maps on which something happens: walls, dead ends, several goals, hills.
fn maps() -> Vec<Arc<Scenario>> {
    let movement = Movement::default();
    let traps = drawn(&["S.......", ".#.#.#.#", ".#.#.#.#", "........", "#.#.#.#.", ".......G"], movement);
    let slices = terrains::hilly_slices(10, 7, 1, terrains::rules(Measure::Cost));
    // Where the best path is soon found, colonies by slices stand still long enough.
    let small = terrains::hilly_slices(5, 4, 1, terrains::rules(Measure::Cost));
    let several = tours(movement).into_iter().map(|(_, scenario)| scenario);
    // Rooms: on small maps a search that merges ants' ways proves the first iteration's best. Last, for they are large.
    let rooms = [(48, 1), (64, 2)].map(|(side, seed)| rooms(side, seed, movement));
    [random(24, 0.25, 3, movement), traps, slices, small].into_iter().chain(several).chain(rooms).collect()
}

fn digest(scenario: &Arc<Scenario>, entry: &PlannerEntry, values: Values) -> String {
    let mut all: Values = [("ants", 30.0), ("iterations", 300.0), ("seed_iterations", 20.0)]
        .into_iter()
        .filter(|(key, _)| (entry.specs)().iter().any(|s| s.key == *key))
        .map(|(key, value)| (key.to_string(), Value::Number(value)))
        .collect();
    all.extend(values);
    let mut planner = catalog::build(scenario, entry.id, None, &all, 1).expect("valid parameters");
    planner.run();
    planner.digest().hex()
}

#[test]
fn every_component_changes_a_run_when_it_is_taken_out() {
    let maps = maps();
    for (entry, component) in with_components() {
        let changed = maps
            .iter()
            .filter(|s| takes(entry, s))
            .any(|scenario| digest(scenario, entry, Values::new()) != digest(scenario, entry, component.values()));
        assert!(changed, "{} without {}", entry.id, component.id);
    }
}

#[test]
fn what_turns_a_component_off_fits_and_is_not_the_default() {
    for (entry, component) in with_components() {
        let (specs, values) = ((entry.specs)(), component.values());
        assert!(!values.is_empty() && values.len() == component.without.len(), "{} {}", entry.id, component.id);
        for (key, value) in values {
            let spec = specs.iter().find(|s| s.key == key).unwrap_or_else(|| panic!("{}: no row {key}", entry.id));
            spec.check(&value).unwrap_or_else(|e| panic!("{} without {}: {e}", entry.id, component.id));
            assert_ne!(spec.default, value, "{} without {}", entry.id, component.id);
        }
    }
}

#[test]
fn ids_are_plain_and_name_one_thing_each() {
    let mut told = BTreeMap::new();
    for entry in CATALOG {
        for (i, c) in entry.components.iter().enumerate() {
            let plain = c.id.bytes().all(|b| b.is_ascii_lowercase() || b == b'-');
            assert!(plain && !c.id.is_empty() && !c.name.is_empty(), "{} {}", entry.id, c.id);
            assert!(c.adds.contains("without: "), "{} {}: it says what is left", entry.id, c.id);
            assert!(entry.components[..i].iter().all(|other| other.id != c.id && other.name != c.name), "{} {}", entry.id, c.id);
            assert_eq!(*told.entry(c.id).or_insert((c.name, c.adds)), (c.name, c.adds), "{} means two things", c.id);
        }
    }
}

#[test]
fn every_papers_own_planner_has_components() {
    let own =
        ["fire", "ship", "terrain-epf", "acost", "acomsp", "ifwa", "fwa-aco", "pso-aco", "iaaco", "maaco", "ihmaco", "tdi-msaco"];
    let classics = ["elitist-ant-system", "rank-based-ant-system", "max-min-ant-system", "ant-colony-system"];
    for id in own.iter().chain(&classics) {
        assert!(!catalog::find(id).expect("in the catalog").components.is_empty(), "{id}");
    }
}
