//! Frozen runs whose walls change: colonies that go on, and planners that begin anew.

use std::sync::Arc;

use formicarium::catalog;
use formicarium::map::{Generator, Movement, Point, generate};
use formicarium::params::{Value, Values};
use formicarium::scenario::{Change, Scenario, ScenarioSpec};

/// A planner, its budget, and the digest.
const FROZEN: &[(&str, &str, &str)] = &[
    ("ant-system", "iterations=60", "bb68e07a83d5336e"),
    ("max-min-ant-system", "iterations=60", "b0af7ef9d39f9dbd"),
    ("ant-colony-system", "iterations=60", "673d01507d29dc39"),
    ("best-worst-ant-system", "iterations=60", "b75a36367f4f27f3"),
    ("ship", "iterations=60", "b3b955291e96ac58"),
    ("custom", "iterations=60", "bb68e07a83d5336e"),
    ("pso-aco", "iterations=30", "b447255d076955db"),
    ("pso", "iterations=20", "10d03b9177aaf9a9"),
    ("astar", "", "b36c64a20ab5b441"),
    ("d-star-lite", "", "2bc13bd386999d59"),
];

/// A cave in which a wall of seven cells appears after iteration 12, where it is free, and goes again after iteration 30.
fn scenario() -> Arc<Scenario> {
    let made = generate(Generator::Cave, 48, 36, 3, 0.0).expect("a valid size");
    let ends = [made.start, made.goal];
    let wall = (15..22).map(|y| Point::new(24, y)).filter(|p| !made.grid.is_blocked(made.grid.cell(*p)) && !ends.contains(p));
    let wall: Vec<Point> = wall.collect();
    assert!(!wall.is_empty(), "the frozen map has free cells there");
    let appears = Change { at: 12, blocked: wall.clone(), freed: Vec::new() };
    let goes = Change { at: 30, blocked: Vec::new(), freed: wall };
    let one = Scenario::on(made.grid, Movement::default(), made.start, made.goal).expect("usable");
    let spec = ScenarioSpec { changes: vec![appears, goes], ..one.spec.clone() };
    Arc::new(Scenario::new(one.grid, spec).expect("usable"))
}

/// What no longer is as it was frozen.
pub fn differences() -> Vec<String> {
    let scenario = scenario();
    let differs = |&(planner, value, frozen): &(&str, &str, &str)| {
        let values: Values = value.split_once('=').map(|(key, v)| (key.to_string(), Value::parse(v))).into_iter().collect();
        let mut run = catalog::build(&scenario, planner, None, &values, 11).expect("valid parameters");
        run.run();
        let digest = run.digest().hex();
        (digest != frozen).then(|| format!("changes ({planner}): {digest}, frozen {frozen}"))
    };
    FROZEN.iter().filter_map(differs).collect()
}
