//! What planners say to have proven: never more than is true, at every move, and all of it at the end of an exact search.

use std::sync::Arc;

use formicarium::catalog::{self, CATALOG};
use formicarium::metrics::Metrics;
use formicarium::params::{Value, Values};
use formicarium::planner::{Certificate, Family, Granularity, Planner, PlannerEntry, Status};
use formicarium::scenario::Scenario;

use super::common::{movements, random, rooms};
use super::{everywhere, scenarios, short, takes};

/// What an exact planner can be asked to make small: its default first.
fn criteria(entry: &PlannerEntry) -> Vec<Values> {
    let other = |key: &str, value: &str| Values::from([(key.to_string(), Value::Text(value.into()))]);
    match entry.id {
        "turn-aware" => vec![short(entry), other("criterion", "weighted-sum")],
        "tour-exact" => vec![short(entry), other("objective", "length")],
        _ => vec![short(entry)],
    }
}

/// What is told before each move and after the last one.
fn told(planner: &mut dyn Planner) -> Vec<Option<Certificate>> {
    let mut told = vec![planner.certificate()];
    while !planner.advance(Granularity::Move).is_finished() {
        told.push(planner.certificate());
    }
    told.push(planner.certificate());
    told
}

/// Runs an exact planner move by move: no bound is above the result, none is below an earlier one, and the last one is the result. How many
/// bounds there were before the end.
fn hold(entry: &PlannerEntry, name: &str, scenario: &Arc<Scenario>, values: &Values) -> usize {
    let mut planner = catalog::build(scenario, entry.id, None, values, 1).expect("usable");
    let told = told(planner.as_mut());
    let (last, before) = told.split_last().expect("two at least");
    assert_eq!(told[0], None, "{name}: nothing is proven before the first step");
    let Some(best) = planner.best() else {
        assert_eq!((last, planner.status()), (&None, Status::NoPath), "{name}");
        return 0;
    };
    let value = planner.value(&Metrics::of(scenario, best.result().0)).expect("of a path");
    let last = last.unwrap_or_else(|| panic!("{name}: {value} is not proven"));
    assert_eq!((last.lower_bound, last.expansions, last.complete), (value, planner.effort().cell_expansions, true), "{name}");
    let bounds: Vec<Certificate> = before.iter().flatten().copied().collect();
    for pair in bounds.windows(2) {
        assert!(pair[1].lower_bound >= pair[0].lower_bound - 1e-9 && pair[1].expansions >= pair[0].expansions, "{name}");
    }
    assert!(bounds.iter().all(|b| !b.complete && (0.0..=value).contains(&b.lower_bound)), "{name}: {value} {bounds:?}");
    bounds.len()
}

#[test]
fn an_exact_search_bounds_its_result_at_every_move_and_proves_it_at_the_end() {
    let of_movement = |movement| (0..6).flat_map(move |seed| [random(9, 0.3, seed, movement), rooms(14, seed, movement)]);
    let made = movements().into_iter().flat_map(of_movement).map(|s| (format!("{:?}", s.spec.movement), s));
    let all: Vec<_> = scenarios().into_iter().chain(made).collect();
    for entry in CATALOG.iter().filter(|entry| entry.family == Family::Exact) {
        let mut bounds = 0;
        for (name, scenario) in all.iter().filter(|(_, s)| takes(entry, s)) {
            let name = format!("{} on {name}", entry.id);
            bounds += criteria(entry).iter().map(|values| hold(entry, &name, scenario, values)).sum::<usize>();
        }
        assert_eq!(bounds > 50, entry.id != "d-star-lite", "{}: {bounds} bounds before the end", entry.id);
    }
}

#[test]
fn who_proves_nothing_says_nothing() {
    everywhere(|entry, name, scenario| {
        if entry.family == Family::Exact || entry.id.starts_with("formica") {
            return;
        }
        let mut planner = super::planner(entry, scenario, 1);
        planner.advance(Granularity::Iteration);
        assert_eq!(planner.certificate(), None, "{name} at work");
        if entry.family == Family::Search {
            planner.run();
            let is_trivial = planner.status() == Status::Optimal;
            assert!(is_trivial || planner.certificate().is_none(), "{name} at its end");
        }
    });
}
