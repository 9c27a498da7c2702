//! Whether a path is one, and how it stands beside the best.

use std::sync::Arc;

use formicarium::catalog::CATALOG;
use formicarium::exact::{self, Reference};
use formicarium::map::{Cell, Movement};
use formicarium::metrics::Metrics;
use formicarium::path::{Flaw, PathKind, audit, audit_slices, points};
use formicarium::planner::{Family, Status};
use formicarium::scenario::Scenario;

use super::common::drawn;
use super::{everywhere, planner, takes};

/// The audit that belongs to the way of moving.
fn audited(scenario: &Scenario, path: &[Cell], kind: PathKind) -> Result<(), Flaw> {
    match &scenario.slices {
        Some(slices) => audit_slices(scenario, &slices.points(path)),
        None => audit(scenario, &points(scenario, path), kind),
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
        audited(scenario, path, objective.path_kind()).unwrap_or_else(|flaw| panic!("{what}: {flaw}"));
        if best.refined.is_some() {
            audited(scenario, &best.path, PathKind::Steps).unwrap_or_else(|flaw| panic!("{what}: {flaw}"));
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
fn start_on_the_goal_is_a_path_of_length_zero() {
    for entry in CATALOG.iter().filter(|e| takes(e, &drawn(&["SG"], Movement::default()))) {
        let mut spec = drawn(&["S.G", "..."], Movement::default()).spec.clone();
        spec.goals[0].at = spec.start;
        let grid = drawn(&["S.G", "..."], Movement::default()).grid.clone();
        let scenario = Arc::new(Scenario::new(grid, spec).expect("usable"));
        let mut planner = planner(entry, &scenario, 1);
        assert_eq!(planner.run(), Status::Optimal, "{}", entry.id);
        assert_eq!(planner.best().map(|b| (b.path.len(), b.length)), Some((1, 0.0)), "{}", entry.id);
    }
}
