//! What a run tells: digests, stepping, layers, history.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::num::NonZero;

use formicarium::catalog;
use formicarium::map::Movement;
use formicarium::params::{Value, Values};
use formicarium::planner::{Family, Granularity, Layer};

use super::common::random;
use super::{everywhere, planner};

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
        if matches!(entry.family, Family::AntColony | Family::Swarm | Family::Sampling)
            && entry.id != "acomsp"
            && what.contains("random 24")
        {
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
            let places = scenario.slices.as_ref().map_or(4 * scenario.grid.len(), |slices| slices.places());
            assert!(effort.cell_expansions <= searches * places as u64, "{what}: {effort:?}");
        }
    });
}

#[test]
fn large_beta_on_a_large_map_does_not_underflow() {
    let scenario = random(512, 0.2, 1, Movement::default());
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

#[test]
fn threads_change_no_run() {
    let shared = RefCell::new(BTreeSet::new());
    everywhere(|entry, what, scenario| {
        let mut alone = planner(entry, scenario, 4);
        alone.run();
        for threads in [2, 3, 64] {
            let mut run = planner(entry, scenario, 4);
            if run.walk_on(NonZero::new(threads).expect("some")) {
                shared.borrow_mut().insert(entry.id);
            }
            // In the middle of an iteration too.
            run.advance(Granularity::Move);
            run.run();
            assert_eq!(run.digest().hex(), alone.digest().hex(), "{what} on {threads} threads");
            assert_eq!((run.effort(), run.history()), (alone.effort(), alone.history()), "{what}");
        }
    });
    let shared = shared.into_inner();
    let expected = ["acomsp", "ant-system", "best-worst-ant-system", "custom", "elitist-ant-system", "fire", "fwa-aco"];
    assert!(expected.iter().all(|id| shared.contains(id)), "{shared:?}");
    assert!(!shared.contains("ant-colony-system") && !shared.contains("astar"), "{shared:?}");
}
