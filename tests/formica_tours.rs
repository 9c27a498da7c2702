//! Formica by many goals: what it finds and proves beside the planners that order goals without a proof.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::sync::Arc;

use common::{movements, random, swamp, with_goals};
use formicarium::catalog;
use formicarium::map::{CornerRule, Generator, Movement, Moves, generate};
use formicarium::params::{Value, Values};
use formicarium::planner::{Objective, Planner, Status};
use formicarium::scenario::{Goal, Scenario, ScenarioSpec};

/// A generated map with so many goals on cells that can be reached, spread as if drawn.
fn many(map: (Generator, u32, u32, u32, f64), count: u32) -> Arc<Scenario> {
    let (generator, width, height, seed, density) = map;
    let made = generate(generator, width, height, seed, density).expect("a map");
    let spec = made.spec("many");
    let scenario = Arc::new(Scenario::new(made.grid, spec).expect("usable"));
    let reached = scenario.moves.reached_from(scenario.start);
    let free: Vec<u32> =
        (0..).zip(reached).filter(|(cell, reached)| *reached && *cell != scenario.start).map(|(c, _)| c).collect();
    let mut at: Vec<u32> = Vec::new();
    for k in 1u32.. {
        let cell = free[k.wrapping_mul(2_654_435_761) as usize % free.len()];
        if at.len() == count as usize {
            break;
        } else if !at.contains(&cell) {
            at.push(cell);
        }
    }
    let points = at.iter().map(|&cell| scenario.grid.point(cell));
    with_goals(&scenario, &points.map(|p| (p.x, p.y)).collect::<Vec<_>>())
}

/// The same with goals of different weights.
fn weighted(scenario: &Scenario) -> Arc<Scenario> {
    let weigh = |(k, goal): (usize, &Goal)| Goal { area: 0.5 + 0.25 * (k % 7) as f64, ..goal.clone() };
    let goals = scenario.spec.goals.iter().enumerate().map(weigh).collect();
    let spec = ScenarioSpec { goals, ..scenario.spec.clone() };
    Arc::new(Scenario::new(scenario.grid.clone(), spec).expect("usable"))
}

fn run(scenario: &Arc<Scenario>, id: &str, set: &[(&str, &str)]) -> Box<dyn Planner> {
    let values: Values = set.iter().map(|&(key, text)| (key.to_string(), Value::parse(text))).collect();
    let mut planner = catalog::build(scenario, id, None, &values, 1).expect("usable");
    planner.run();
    planner
}

/// What its result comes to, the bound that it has proven, and how it ended.
fn told(planner: &dyn Planner) -> (f64, Option<f64>, Status) {
    let value = match planner.objective() {
        Objective::TourWeight => planner.tour().and_then(|tour| tour.walked_weight),
        _ => planner.best().map(|best| best.length),
    };
    (value.expect("a path"), planner.certificate().map(|certificate| certificate.lower_bound), planner.status())
}

const ROOMS: (Generator, u32, u32, u32, f64) = (Generator::Rooms, 64, 48, 7, 0.0);
const CAVE: (Generator, u32, u32, u32, f64) = (Generator::Cave, 96, 72, 3, 0.0);
const RANDOM: (Generator, u32, u32, u32, f64) = (Generator::Random, 80, 80, 5, 0.2);

#[test]
fn twenty_and_forty_goals_are_bounded_and_never_worse_than_by_ants_alone() {
    for (name, map, goals) in [("rooms", ROOMS, 20), ("cave", CAVE, 40), ("random", RANDOM, 40)] {
        let plain = many(map, goals);
        for (scenario, order, fires) in [(&plain, "length", "distance"), (&weighted(&plain), "weight", "weight")] {
            let (value, bound, status) = told(&*run(scenario, "formica", &[("order", order)]));
            let (exact, exact_bound, exact_status) = told(&*run(scenario, "tour-exact", &[("objective", order)]));
            let ants = run(scenario, "fire", &[("order", fires), ("iterations", "30")]);
            let (fire, none, _) = told(&*ants);
            let its_order =
                ants.tour().map_or(0.0, |tour| if order == "weight" { tour.planned_weight } else { tour.planned_length });
            let (bound, exact_bound) = (bound.expect("proven"), exact_bound.expect("proven"));
            println!(
                "{name}, {goals} goals, {order}: formica {value:.4}, bound {bound:.4}, {status:?}; tour-exact {exact:.4}, \
                 bound {exact_bound:.4}, {exact_status:?}; fire {fire:.4}, its order by shortest legs {its_order:.4}"
            );
            let optimum_is_between = bound <= exact + 1e-9 && exact_bound <= value + 1e-9;
            assert!(optimum_is_between && bound <= value && exact_bound <= exact, "{name}, {order}");
            assert!(value <= its_order + 1e-9 && bound <= fire && exact_bound <= its_order + 1e-9, "{name}, {order}");
            assert_eq!(status == Status::Optimal, bound == value, "{name}, {order}");
            assert!(bound > 0.95 * value, "{name}, {order}");
            assert_eq!(none, None);
        }
    }
}

#[test]
fn few_goals_are_proven_as_by_dynamic_programming() {
    for seed in 1..=6 {
        let scenario = weighted(&many((Generator::Random, 30, 24, seed, 0.2), 2 + 2 * seed));
        for order in ["length", "weight"] {
            let (value, bound, status) = told(&*run(&scenario, "formica", &[("order", order)]));
            let (exact, proven, _) = told(&*run(&scenario, "tour-exact", &[("objective", order)]));
            assert_eq!((status, bound, proven), (Status::Optimal, Some(value), Some(exact)), "seed {seed}, {order}");
            assert!((value - exact).abs() < 1e-9, "seed {seed}, {order}: {value}, {exact}");
        }
    }
}

/// Hills with four goals on their diagonals.
fn hills(movement: Movement) -> Arc<Scenario> {
    let made = generate(Generator::Hills, 24, 24, 5, 0.5).expect("hills");
    let spec = ScenarioSpec { movement, ..made.spec("hills") };
    let scenario = Scenario::new(made.grid, spec).expect("usable");
    with_goals(&scenario, &[(4, 4), (19, 4), (4, 19), (18, 18)])
}

#[test]
fn every_ground_is_proven_by_several_goals() {
    let sixteen = Movement { moves: Moves::Sixteen, corner_rule: CornerRule::BothFree };
    for movement in movements().into_iter().chain([sixteen]) {
        let plane = random(24, 0.0, 7, movement);
        let scenarios = [
            ("a plane", with_goals(&plane, &[(20, 3), (2, 20), (11, 11), (23, 23), (0, 9)])),
            ("a swamp", with_goals(&swamp(movement), &[(7, 3), (0, 4), (5, 0), (4, 4)])),
            ("hills", hills(movement)),
        ];
        for (name, scenario) in scenarios {
            let (value, bound, status) = told(&*run(&scenario, "formica", &[]));
            let (exact, _, _) = told(&*run(&scenario, "tour-exact", &[]));
            assert_eq!((status, bound), (Status::Optimal, Some(value)), "{name}, {movement:?}");
            assert!((value - exact).abs() < 1e-9, "{name}, {movement:?}: {value}, {exact}");
        }
    }
}

#[test]
fn a_search_that_is_stopped_tells_an_interval() {
    let scenario = many(CAVE, 40);
    for (id, key) in [("formica", "order"), ("tour-exact", "objective")] {
        let planner = run(&scenario, id, &[(key, "length"), ("order_limit", "3")]);
        let (value, bound, status) = told(&*planner);
        assert_eq!(status, Status::BudgetSpent, "{id}");
        let certificate = planner.certificate().expect("a bound");
        assert!(!certificate.complete && certificate.expansions > 0 && bound.is_some_and(|bound| bound < value), "{id}");
    }
}

#[test]
fn without_a_proof_or_a_search_nothing_is_told() {
    let scenario = many(ROOMS, 6);
    for set in [("proof_limit", "0"), ("order_limit", "0")] {
        let planner = run(&scenario, "formica", &[set]);
        assert!(planner.certificate().is_none() && planner.best().is_some(), "{set:?}");
        assert_eq!(planner.status(), Status::BudgetSpent, "{set:?}");
    }
}

#[test]
fn legs_count_what_they_expand() {
    let scenario = many(ROOMS, 6);
    let planner = run(&scenario, "formica", &[]);
    let exact = run(&scenario, "tour-exact", &[]);
    let effort = planner.effort();
    assert!(effort.ant_moves > 0 && effort.cell_expansions > exact.effort().cell_expansions / 2, "{effort:?}");
    assert_eq!(planner.certificate().map(|certificate| certificate.expansions), Some(effort.cell_expansions));
    assert_eq!(planner.history().last().and_then(|last| last.best_so_far), planner.best().map(|best| best.length));
}

#[test]
fn a_goal_at_the_start_that_weighs_much_hides_no_better_order() {
    for (seed, few) in [(1, 5), (2, 6), (3, 7), (4, 17)] {
        let plain = many((Generator::Random, 20, 16, seed, 0.1), few);
        let mut spec = plain.spec.clone();
        let start = spec.start;
        // b = 1e13.
        spec.goals.push(Goal { area: 1e-6, strength: 1e-6, danger: 0.1, ..Goal::new(start, "here") });
        let here = Arc::new(Scenario::new(plain.grid.clone(), spec).expect("usable"));
        let of = |scenario: &Arc<Scenario>, planner: &str| told(&*run(scenario, planner, &[])).0;
        let least = of(&plain, "tour-exact");
        for planner in ["formica", "tour-exact"] {
            assert!((of(&here, planner) - least).abs() < 1e-9 * least, "seed {seed}, {planner}: {}, {least}", of(&here, planner));
        }
    }
}
