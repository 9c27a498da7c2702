//! What every planner of the catalog must keep, whatever its paper says. A new planner is covered by its line in the catalog.

#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::sync::Arc;

use common::{drawn, gallery, movements, tours, with_goals};
use formicarium::catalog::{self, CATALOG};
use formicarium::error::ParamError;
use formicarium::exact::{self, Reference};
use formicarium::map::Movement;
use formicarium::metrics::Metrics;
use formicarium::params::{ParamKind, ParamSpec, Value, Values};
use formicarium::path::{PathKind, audit, points};
use formicarium::planner::{Entry, Family, Granularity, Layer, Planner, Status};
use formicarium::scenario::Scenario;

/// A budget that keeps the tests short, where the planner has one.
fn short(entry: &Entry) -> Values {
    let has = |key: &str| (entry.specs)().iter().any(|s| s.key == key);
    let mut values = Values::new();
    for (key, value) in [("iterations", 12.0), ("seed_iterations", 6.0), ("ants", 10.0)] {
        if has(key) {
            values.insert(key.into(), Value::Number(value));
        }
    }
    values
}

fn planner(entry: &Entry, scenario: &Arc<Scenario>, seed: u32) -> Box<dyn Planner> {
    catalog::build(scenario, entry.id, None, &short(entry), seed).expect("valid parameters")
}

/// Calls `check` for every planner on every scenario that it takes, under every movement.
fn everywhere(check: impl Fn(&Entry, &str, &Arc<Scenario>)) {
    for entry in CATALOG {
        for movement in movements() {
            let takes = |scenario: &Scenario| scenario.goals.len() <= entry.max_goals as usize;
            for (name, scenario) in gallery(movement).into_iter().chain(tours(movement)).filter(|(_, s)| takes(s)) {
                check(entry, &format!("{} on {name} with {movement:?}", entry.id), &scenario);
            }
        }
    }
}

#[test]
fn paths_are_valid_and_never_shorter_than_the_optimum() {
    everywhere(|entry, what, scenario| {
        let mut planner = planner(entry, scenario, 3);
        let status = planner.run();
        let Some(best) = planner.best() else {
            assert!(!scenario.reachable() || entry.family != Family::Exact, "{what}: no path found");
            return;
        };
        let objective = planner.objective();
        let (path, length) = best.result();
        audit(scenario, &points(scenario, path), objective.path_kind()).unwrap_or_else(|flaw| panic!("{what}: {flaw}"));
        if best.refined.is_some() {
            audit(scenario, &points(scenario, &best.path), PathKind::Steps).unwrap_or_else(|flaw| panic!("{what}: {flaw}"));
            assert!(length <= best.length + 1e-9, "{what}: refined from {} to {length}", best.length);
        }
        let value = planner.value(&Metrics::of(scenario, path)).unwrap_or_else(|| panic!("{what}: a path without a value"));
        match exact::reference(scenario, objective) {
            Reference::Proven { value: optimum } => {
                assert!(value >= optimum - 1e-9, "{what}: {value} < {optimum}");
                if entry.family == Family::Exact {
                    assert_eq!(status, Status::Optimal, "{what}");
                    assert!((value - optimum).abs() < 1e-9, "{what}: {value} != {optimum}");
                }
            }
            Reference::NoPath => panic!("{what}: a path where none exists"),
            Reference::Unproven { .. } | Reference::Unknown => assert_ne!(entry.family, Family::Exact, "{what}"),
        }
    });
}

#[test]
fn same_seed_same_digest_and_another_seed_another() {
    everywhere(|entry, what, scenario| {
        let digest = |seed| {
            let mut planner = planner(entry, scenario, seed);
            planner.run();
            (planner.digest().hex(), planner.effort())
        };
        assert_eq!(digest(5), digest(5), "{what}");
        // The effort tells two runs apart in which no ant arrives. ACOMSP draws only between equal probabilities.
        if entry.family == Family::AntColony && entry.id != "acomsp" && what.contains("random 24") {
            assert_ne!(digest(5), digest(6), "{what}: the seed has no effect");
        }
    });
}

#[test]
fn stepping_by_moves_by_iterations_or_by_both_agrees() {
    everywhere(|entry, what, scenario| {
        let mut by_iteration = planner(entry, scenario, 4);
        by_iteration.run();
        let mut by_move = planner(entry, scenario, 4);
        while !by_move.advance(Granularity::Move).is_finished() {}
        let mut mixed = planner(entry, scenario, 4);
        for step in 0u32.. {
            let by = if step % 7 == 6 { Granularity::Iteration } else { Granularity::Move };
            if mixed.advance(by).is_finished() {
                break;
            }
        }
        for other in [by_move, mixed] {
            assert_eq!(by_iteration.digest().hex(), other.digest().hex(), "{what}");
            assert_eq!(by_iteration.effort(), other.effort(), "{what}");
            assert_eq!(by_iteration.status(), other.status(), "{what}");
        }
    });
}

#[test]
fn an_unreachable_goal_is_an_answer() {
    for entry in CATALOG {
        for movement in movements() {
            let walled = drawn(&["S.#..", "..#..", "###..", "....G"], movement);
            let mut planner = planner(entry, &walled, 1);
            assert_eq!(planner.run(), Status::NoPath, "{}", entry.id);
            assert!(planner.best().is_none());
        }
    }
}

#[test]
fn one_unreachable_goal_of_several_is_an_answer() {
    for entry in CATALOG.iter().filter(|e| e.max_goals > 1) {
        for movement in movements() {
            let walled = with_goals(&drawn(&["S.#..", "..#..", "###..", "....G"], movement), &[(1, 1), (4, 3)]);
            let mut planner = planner(entry, &walled, 1);
            assert_eq!(planner.run(), Status::NoPath, "{}", entry.id);
            assert!(planner.best().is_none());
        }
    }
}

#[test]
fn more_goals_than_a_planner_takes_are_refused_by_name() {
    let open = drawn(&["S.......", "........", "........", ".......G"], Movement::default());
    for entry in CATALOG {
        let most = entry.max_goals as usize;
        if most >= formicarium::scenario::MAX_GOALS {
            continue;
        }
        let cells: Vec<_> = (1..=most as u32 + 1).map(|c| (c % 8, c / 8)).collect();
        let error = catalog::build(&with_goals(&open, &cells), entry.id, None, &short(entry), 1).err();
        assert!(
            matches!(&error, Some(ParamError::TooManyGoals { planner, most, got, .. })
                if planner == entry.id && *most == entry.max_goals && *got == cells.len()),
            "{}: {error:?}",
            entry.id
        );
        assert!(catalog::build(&with_goals(&open, &cells[1..]), entry.id, None, &short(entry), 1).is_ok(), "{}", entry.id);
    }
}

#[test]
fn tours_visit_every_goal_once_and_tell_what_each_leg_costs() {
    everywhere(|entry, what, scenario| {
        let mut planner = planner(entry, scenario, 3);
        planner.run();
        let (Some(tour), true) = (planner.tour(), scenario.goals.len() > 1) else {
            assert!(scenario.goals.len() == 1 && planner.tour().is_none(), "{what}");
            return;
        };
        let best = planner.best().unwrap_or_else(|| panic!("{what}: no path"));
        let mut order = tour.order.clone();
        order.sort_unstable();
        assert_eq!(order, (0..scenario.goals.len() as u32).collect::<Vec<_>>(), "{what}");
        let weigh = |legs: &[f64]| -> f64 {
            tour.order.iter().zip(legs).map(|(&g, l)| l * scenario.spec.goals[g as usize].weight()).sum()
        };
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{what}: {a}, {b}");
        close(tour.planned_length, tour.planned.iter().sum());
        close(tour.planned_weight, weigh(&tour.planned));
        close(best.length, tour.walked.iter().sum());
        close(tour.walked_weight.expect("walked"), weigh(&tour.walked));
        // The path comes by the goals in this order.
        let mut rest = best.path.as_slice();
        for &goal in &tour.order {
            let at = rest.iter().position(|&c| c == scenario.goals[goal as usize]);
            rest = &rest[at.unwrap_or_else(|| panic!("{what}: goal {goal}"))..];
        }
    });
}

#[test]
fn start_on_the_goal_is_a_path_of_length_zero() {
    for entry in CATALOG {
        let mut spec = drawn(&["S.G", "..."], Movement::default()).spec.clone();
        spec.goals[0].at = spec.start;
        let grid = drawn(&["S.G", "..."], Movement::default()).grid.clone();
        let scenario = Arc::new(Scenario::new(grid, spec).expect("usable"));
        let mut planner = planner(entry, &scenario, 1);
        assert_eq!(planner.run(), Status::Optimal, "{}", entry.id);
        assert_eq!(planner.best().map(|b| (b.path.len(), b.length)), Some((1, 0.0)), "{}", entry.id);
    }
}

#[test]
fn a_step_after_the_end_is_inert() {
    everywhere(|entry, what, scenario| {
        let mut planner = planner(entry, scenario, 2);
        let status = planner.run();
        let (digest, effort) = (planner.digest().hex(), planner.effort());
        for by in [Granularity::Move, Granularity::Iteration] {
            assert_eq!(planner.advance(by), status, "{what}");
        }
        assert_eq!((planner.digest().hex(), planner.effort()), (digest, effort), "{what}");
    });
}

#[test]
fn layers_have_one_usable_value_a_cell() {
    everywhere(|entry, what, scenario| {
        let mut planner = planner(entry, scenario, 2);
        let mut field = Vec::new();
        for step in 0..40 {
            for kind in [Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::Cost] {
                assert_eq!(planner.layer(kind, &mut field), entry.layers.contains(&kind), "{what}: {kind:?}");
                if entry.layers.contains(&kind) {
                    assert_eq!(field.len(), scenario.grid.len(), "{what}: {kind:?}");
                    assert!(field.iter().all(|v| !v.is_nan() && *v >= 0.0), "{what}: {kind:?}");
                    assert!(kind == Layer::Cost || field.iter().all(|v| v.is_finite()), "{what}: {kind:?}");
                }
            }
            planner.advance(if step % 2 == 0 { Granularity::Move } else { Granularity::Iteration });
        }
        planner.layer(Layer::Trail, &mut field);
        if entry.layers.contains(&Layer::Trail) && scenario.start != scenario.goal {
            assert!(field.iter().all(|&v| v > 0.0), "{what}: a trail has vanished");
        }
    });
}

#[test]
fn history_and_effort_are_consistent() {
    everywhere(|entry, what, scenario| {
        let mut planner = planner(entry, scenario, 8);
        planner.run();
        let (history, effort) = (planner.history(), planner.effort());
        let mut best = f64::INFINITY;
        for (i, r) in history.iter().enumerate() {
            assert_eq!(r.iteration as usize, i + 1, "{what}");
            if let (Some(low), Some(mean), Some(high)) = (r.iteration_best, r.iteration_mean, r.iteration_worst) {
                assert!(low <= mean + 1e-9 && mean <= high + 1e-9, "{what}: {r:?}");
                best = best.min(low);
            }
            if scenario.goals.len() == 1 {
                assert_eq!(r.best_so_far, best.is_finite().then_some(best), "{what}");
            } else {
                // The legs' best may be of different iterations, and an iteration's best leaves out where a leg has none.
                let before = history[..i].iter().filter_map(|r| r.best_so_far).fold(best, f64::min);
                assert!(!best.is_finite() || r.best_so_far.is_some(), "{what}");
                assert!(r.best_so_far.is_none_or(|b| b <= before + 1e-9), "{what}: {r:?}");
            }
        }
        assert_eq!(effort.iterations as usize, history.len(), "{what}");
        if entry.family == Family::Exact {
            let searches = 2 * scenario.goals.len() as u64 - 1;
            assert!(effort.cell_expansions <= 4 * searches * scenario.grid.len() as u64, "{what}: {effort:?}");
        }
    });
}

/// The values at both ends of a parameter's range, and those just outside.
fn ends(spec: &ParamSpec) -> (Vec<Value>, Vec<Value>) {
    match &spec.kind {
        ParamKind::Integer { min, max } | ParamKind::Real { min, max } => (
            vec![Value::Number(*min), Value::Number(*max)],
            vec![
                Value::Number(min - 1.0),
                Value::Number(max + 1.0),
                Value::Number(f64::NAN),
                Value::Text("x".into()),
                Value::Flag(true),
            ],
        ),
        ParamKind::Flag => (vec![Value::Flag(true), Value::Flag(false)], vec![Value::Number(1.0)]),
        ParamKind::Choice { options } => {
            (options.iter().map(|o| Value::from(o.id)).collect(), vec![Value::Text("no such option".into()), Value::Number(0.0)])
        }
    }
}

#[test]
fn range_ends_run_and_what_is_outside_is_refused_by_name() {
    let one = common::random(12, 0.2, 1, Movement::default());
    let two = with_goals(&one, &[(one.spec.goals[0].at.x, one.spec.goals[0].at.y), (one.spec.start.x, one.spec.start.y)]);
    for entry in CATALOG {
        let scenario = if entry.max_goals > 1 { &two } else { &one };
        for spec in (entry.specs)() {
            let (inside, outside) = ends(&spec);
            for value in inside {
                let mut values = short(entry);
                values.insert(spec.key.into(), value.clone());
                let built = catalog::build(scenario, entry.id, None, &values, 1);
                let mut planner = built.unwrap_or_else(|e| panic!("{} {} = {value}: {e}", entry.id, spec.key));
                for _ in 0..8 {
                    planner.advance(Granularity::Iteration);
                }
                let mut trail = Vec::new();
                if planner.layer(Layer::Trail, &mut trail) {
                    assert!(trail.iter().all(|t| *t > 0.0 && t.is_finite()), "{} {} = {value}", entry.id, spec.key);
                }
            }
            for value in outside {
                let values: Values = [(spec.key.to_string(), value.clone())].into();
                let error = catalog::build(scenario, entry.id, None, &values, 1).err();
                let report = error.unwrap_or_else(|| panic!("{} {} = {value} was accepted", entry.id, spec.key)).report();
                assert_eq!(report.field, spec.key);
                assert!(report.message.contains(spec.meaning) && !report.hint.is_empty(), "{report:?}");
            }
        }
    }
}

#[test]
fn unknown_names_are_refused_with_what_is_known() {
    let scenario = common::random(8, 0.1, 1, Movement::default());
    let build = |id: &str, preset: Option<&str>, values: &Values| catalog::build(&scenario, id, preset, values, 1).err();
    assert!(
        matches!(build("ants", None, &Values::new()), Some(ParamError::UnknownPlanner { known, .. }) if known.contains("astar"))
    );
    for entry in CATALOG {
        let values: Values = [("no_such_key".to_string(), Value::Number(1.0))].into();
        assert!(matches!(build(entry.id, None, &values), Some(ParamError::UnknownKey { .. })), "{}", entry.id);
        assert!(matches!(build(entry.id, Some("no such preset"), &Values::new()), Some(ParamError::UnknownPreset { .. })));
    }
}

#[test]
fn what_would_run_out_of_memory_is_refused() {
    let grid = formicarium::map::Grid::open(4096, 4096).expect("the largest map");
    let ends = (formicarium::map::Point::new(0, 0), formicarium::map::Point::new(9, 9));
    let scenario = Arc::new(Scenario::on(grid, Movement::default(), ends.0, ends.1).expect("usable"));
    let with = |ants: f64| catalog::build(&scenario, "ant-system", None, &[("ants".to_string(), Value::Number(ants))].into(), 1);
    assert!(with(50.0).is_ok());
    let report = with(1024.0).err().expect("too many ants").report();
    assert_eq!((report.kind.as_str(), report.field.as_str()), ("memory", "ants"));
    // With several goals every leg has a colony of its own: one fits, three do not.
    assert!(catalog::build(&scenario, "fire", None, &Values::new(), 1).is_ok());
    let several = with_goals(&scenario, &[(9, 9), (4000, 9), (9, 4000)]);
    let report = catalog::build(&several, "fire", None, &Values::new(), 1).err().expect("three colonies").report();
    assert_eq!((report.kind.as_str(), report.field.as_str()), ("memory", "ants"));
}

#[test]
fn the_catalog_is_complete_and_its_presets_run() {
    let scenario = common::random(16, 0.2, 1, Movement::default());
    for (i, entry) in CATALOG.iter().enumerate() {
        assert!(CATALOG[..i].iter().all(|e| e.id != entry.id), "{} twice", entry.id);
        assert!(!entry.source.is_empty() && !entry.summary.is_empty() && !entry.layers.is_empty(), "{}", entry.id);
        for spec in (entry.specs)() {
            assert!(!spec.meaning.is_empty() && !spec.source.is_empty(), "{} {}", entry.id, spec.key);
            let keys: Vec<_> = (entry.specs)().iter().map(|s| s.key).collect();
            assert!(spec.applies_when.is_none_or(|w| keys.contains(&w.key)), "{} {}", entry.id, spec.key);
        }
        for preset in entry.presets {
            let mut planner = catalog::build(&scenario, entry.id, Some(preset.name), &short(entry), 1)
                .unwrap_or_else(|e| panic!("{} --preset {}: {e}", entry.id, preset.name));
            planner.advance(Granularity::Iteration);
        }
    }
}

#[test]
fn large_beta_on_a_large_map_does_not_underflow() {
    let scenario = common::random(512, 0.2, 1, Movement::default());
    for heuristic in ["goal", "detour", "step"] {
        let values: Values = [
            ("beta".to_string(), Value::Number(25.0)),
            ("ants".to_string(), Value::Number(8.0)),
            ("heuristic".to_string(), Value::Text(heuristic.into())),
        ]
        .into();
        let mut planner = catalog::build(&scenario, "ant-system", None, &values, 1).expect("valid parameters");
        planner.advance(Granularity::Iteration);
        let moves = planner.effort().ant_moves;
        assert!(moves > 8 * 100, "{heuristic}: ants hardly moved ({moves})");
        if heuristic == "detour" {
            assert!(planner.best().is_some(), "no ant arrived with the default heuristic");
        }
    }
}
