//! What Formica keeps by default, it keeps with polylines: stepping, snapshots, paths, history.

use std::sync::Arc;

use formicarium::catalog;
use formicarium::params::Value;
use formicarium::path::{PathKind, audit, points};
use formicarium::planner::{Granularity, Ground, Planner};
use formicarium::scenario::Scenario;

use super::{scenarios, short};

/// With a proof it ends soon on small maps, without one after its last iteration.
const WITH_AND_WITHOUT_PROOF: [f64; 2] = [4.0, 0.0];

fn polylines(scenario: &Arc<Scenario>, proof_limit: f64) -> Box<dyn Planner> {
    let entry = catalog::find("formica").expect("listed");
    let mut values = short(entry);
    values.insert("paths".into(), Value::from("polylines"));
    values.insert("proof_limit".into(), Value::from(proof_limit));
    catalog::build(scenario, entry.id, None, &values, 4).expect("valid parameters")
}

/// Calls `check` on every plane with one goal, for each of [`WITH_AND_WITHOUT_PROOF`].
fn on_planes(check: impl Fn(&str, &dyn Fn() -> Box<dyn Planner>, &Scenario)) {
    let all = scenarios();
    let planes = all.iter().filter(|(_, s)| s.goals.len() == 1 && Ground::all_of(s).eq([Ground::Plane]));
    let mut count = 0;
    for (name, scenario) in planes {
        WITH_AND_WITHOUT_PROOF.iter().for_each(|&most| check(name, &|| polylines(scenario, most), scenario));
        count += 1;
    }
    assert!(count > 20, "{count} planes");
}

#[test]
fn stepping_by_moves_or_by_iterations_agrees_and_so_do_snapshots() {
    on_planes(|what, made, _| {
        let mut by_iteration = made();
        by_iteration.run();
        let mut by_move = made();
        while !by_move.advance(Granularity::Move).is_finished() {}
        let mut original = made();
        original.advance(Granularity::Iteration);
        (0..5).for_each(|_| {
            original.advance(Granularity::Move);
        });
        let mut snapshot = original.snapshot();
        snapshot.run();
        original.run();
        for other in [by_move, original, snapshot] {
            assert_eq!(by_iteration.digest().hex(), other.digest().hex(), "{what}");
            assert_eq!(by_iteration.history(), other.history(), "{what}");
            assert_eq!((by_iteration.effort(), by_iteration.status()), (other.effort(), other.status()), "{what}");
            assert_eq!(by_iteration.certificate(), other.certificate(), "{what}");
        }
    });
}

#[test]
fn polylines_are_valid_and_the_history_tells_of_the_best() {
    on_planes(|what, made, scenario| {
        let mut planner = made();
        planner.run();
        let Some(best) = planner.best() else { return };
        audit(scenario, &points(scenario, &best.path), PathKind::Polyline).unwrap_or_else(|flaw| panic!("{what}: {flaw}"));
        assert!((scenario.path_length(&best.path) - best.length).abs() < 1e-9, "{what}");
        let mut least = f64::INFINITY;
        for record in planner.history() {
            least = record.iteration_best.map_or(least, |length| least.min(length));
            assert_eq!(record.best_so_far, least.is_finite().then_some(least), "{what}: {record:?}");
        }
        assert!(planner.bytes() > 0);
    });
}
