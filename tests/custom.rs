//! Composed of one planner's rules, `custom` is that planner, bit for bit; with one rule replaced it is another.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::sync::Arc;

use formicarium::catalog;
use formicarium::map::Movement;
use formicarium::params::{Value, Values};
use formicarium::scenario::{Goal, Scenario};

fn run(scenario: &Arc<Scenario>, id: &str, preset: Option<&str>, values: &Values, seed: u32) -> String {
    let mut planner = catalog::build(scenario, id, preset, values, seed).expect("valid parameters");
    planner.run();
    planner.digest().hex()
}

/// A map with five goals.
fn several_goals() -> Arc<Scenario> {
    let one = common::random(24, 0.2, 1, Movement::default());
    let mut spec = one.spec.clone();
    let reached = one.moves.reached_from(one.start);
    let far = (0..one.grid.len() as u32).filter(|&c| reached[c as usize] && c % 41 == 3 && c != one.start);
    spec.goals =
        far.take(5).enumerate().map(|(i, c)| Goal { area: 0.5 + i as f64, ..Goal::new(one.grid.point(c), "") }).collect();
    Arc::new(Scenario::new(one.grid.clone(), spec).expect("usable"))
}

/// Few iterations; both in the same words.
fn short() -> Values {
    [("iterations".to_string(), Value::Number(25.0))].into()
}

#[test]
fn a_planners_rules_together_are_that_planner() {
    let scenario = common::random(24, 0.2, 1, Movement::default());
    let entry = catalog::find("custom").expect("in the catalog");
    for preset in entry.presets {
        for seed in 1..=3 {
            let composed = run(&scenario, "custom", Some(preset.name), &short(), seed);
            assert_eq!(composed, run(&scenario, preset.name, None, &short(), seed), "{} seed {seed}", preset.name);
        }
    }
    for id in ["ant-system", "elitist-ant-system", "rank-based-ant-system"] {
        let rho = Value::Number(0.3);
        let mut values = short();
        values.insert("rho".into(), rho);
        let plain = run(&scenario, id, None, &values, 1);
        for rule in ["initial_trail_of", "heuristic_of", "selection_of", "local_update_of", "update_of", "daemon_of"] {
            values.insert(rule.into(), Value::from(id));
        }
        assert_eq!(run(&scenario, "custom", None, &values, 1), plain, "{id}");
    }
}

#[test]
fn the_rules_of_fire_order_several_goals_as_fire_does() {
    let scenario = several_goals();
    assert_eq!(scenario.goals.len(), 5);
    for (key, value) in [("order", "weight"), ("order", "distance"), ("leg_length", "euclidean"), ("legs", "basic")] {
        let mut values = short();
        values.insert(key.into(), Value::from(value));
        let fire = run(&scenario, "fire", None, &values, 1);
        assert_eq!(run(&scenario, "custom", Some("fire"), &values, 1), fire, "{key} = {value}");
    }
}

#[test]
fn a_replaced_rule_changes_the_run() {
    let scenario = common::random(24, 0.2, 1, Movement::default());
    let full = run(&scenario, "custom", Some("ship"), &short(), 1);
    for rule in ["heuristic_of", "update_of"] {
        let mut values = short();
        values.insert(rule.into(), Value::from("ant-system"));
        assert_ne!(run(&scenario, "custom", Some("ship"), &values, 1), full, "{rule}");
    }
}
