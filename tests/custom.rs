//! Composed of one planner's rules, `custom` is that planner, bit for bit; with one rule replaced it is another.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::sync::Arc;

use formicarium::catalog;
use formicarium::map::Movement;
use formicarium::params::{ParamKind, ParamSpec, Value, Values};
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
}

/// Every planner that lends rules, with the values of its own rows: also those that no preset repeats.
#[test]
fn every_donors_rules_together_are_that_donor() {
    let scenario = common::random(24, 0.2, 1, Movement::default());
    let rows = (catalog::find("custom").expect("in the catalog").specs)();
    let rules: Vec<&ParamSpec> = rows.iter().filter(|row| row.key.ends_with("_of")).collect();
    let ParamKind::Choice { options } = &rules[0].kind else { panic!("a rule is lent by one of the donors") };
    for donor in options {
        let own = catalog::values(donor.id, None, &short()).expect("valid parameters");
        let plain = run(&scenario, donor.id, None, &own, 1);
        let mut composed = own;
        composed.extend(rules.iter().map(|rule| (rule.key.to_string(), Value::from(donor.id))));
        assert_eq!(run(&scenario, "custom", None, &composed, 1), plain, "{}", donor.id);
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

/// Within its budget MAX–MIN Ant System restarts only if it is told to: so does the composition, by the rule it borrows.
#[test]
fn a_borrowed_daemon_restarts_as_its_planner_does() {
    let scenario = common::random(24, 0.2, 1, Movement::default());
    let mut values = short();
    values.insert("restart_after".into(), Value::Number(3.0));
    let restarted = run(&scenario, "max-min-ant-system", None, &values, 1);
    assert_ne!(run(&scenario, "max-min-ant-system", None, &short(), 1), restarted, "the restarts have an effect");
    assert_eq!(run(&scenario, "custom", Some("max-min-ant-system"), &values, 1), restarted);
    values.insert("daemon_of".into(), Value::from("ant-system"));
    assert_eq!(
        run(&scenario, "custom", Some("max-min-ant-system"), &values, 1),
        run(&scenario, "max-min-ant-system", None, &short(), 1)
    );
}

/// A row that says when it has an effect has none otherwise; one that two rules need does not say it.
#[test]
fn a_row_without_effect_is_said_to_have_none() {
    let scenario = common::random(24, 0.2, 1, Movement::default());
    let specs = (catalog::find("custom").expect("in the catalog").specs)();
    let says = |key: &str| specs.iter().find(|s| s.key == key).expect("a row").applies_when.is_some();
    let borrowed =
        [("elitists", 5.0, "elitist-ant-system"), ("ranks", 3.0, "rank-based-ant-system"), ("deposit", 9.0, "fwa-aco")];
    for (key, value, donor) in borrowed {
        let mut values = short();
        // An update that does not need the row.
        values.extend([("update_of", "acost"), ("initial_trail_of", donor)].map(|(k, v)| (k.to_string(), Value::from(v))));
        let before = run(&scenario, "custom", None, &values, 1);
        values.insert(key.into(), Value::Number(value));
        assert_ne!(run(&scenario, "custom", None, &values, 1), before, "{key} shapes the initial trail of {donor}");
        assert!(!says(key), "{key}");
    }
    assert!(says("q0") && says("xi") && says("goal_pull") && says("restart_after"));
}
