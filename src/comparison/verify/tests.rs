//! Documents that are verified, edited, broken off.

use std::sync::Arc;

use serde_json::json;

use super::recorded::digest;
use super::*;
use crate::comparison::question::FORMAT;
use crate::formats::comparison_json;
use crate::map::{Grid, Point};
use crate::scenario::{Scenario, ScenarioSpec};

fn comparison() -> Comparison {
    let question: Question = serde_json::from_value(json!({
        "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 3, "count": 4 },
        "instances": [{ "id": "open", "map": "open.json" }],
        "entries": [
            { "id": "ants", "label": "ants", "role": "other", "planner": "ant-system", "set": { "iterations": 3, "ants": 4 } },
            { "id": "exact", "label": "exact", "role": "other", "planner": "astar" }
        ]
    }))
    .unwrap();
    let grid = Grid::from_bytes(6, 5, &[0; 30]).unwrap();
    let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(5, 4));
    Comparison::new(question, vec![Arc::new(Scenario::new(grid, spec).unwrap())]).unwrap()
}

fn run_all(comparison: &Comparison) -> Vec<Row> {
    comparison.tasks().into_iter().map(|task| comparison.run(task, &mut || 0.0).unwrap().row).collect()
}

/// Writes a document after some runs, opens it, and compares.
fn verified(then: &[Row], with_rows: bool, now: &[Row]) -> Verification {
    let opened = comparison_json::open(&comparison_json::write(&comparison(), then, with_rows)).unwrap();
    opened.record().verify(&opened.comparison, &opened.rows, now)
}

#[test]
fn runs_are_verified_as_far_as_they_are_done_again() {
    let rows = run_all(&comparison());
    let told = |same, open, runs| Verification { same, open, runs, of: 8, ..Verification::default() };
    for with_rows in [true, false] {
        assert_eq!(verified(&rows, with_rows, &rows), told(2, 0, 8));
        assert_eq!(verified(&rows, with_rows, &[]), told(0, 2, 0));
    }
    // The last seed of A* is not done: rows can be compared without it, a digest over all of them cannot.
    assert_eq!(verified(&rows, true, &rows[..7]), told(1, 1, 7));
    assert_eq!(verified(&rows, false, &rows[..7]), told(1, 1, 4));
    assert_eq!(verified(&[], true, &rows), Verification::default());
}

#[test]
fn a_comparison_that_was_broken_off_is_verified_by_the_runs_it_had() {
    let e = comparison();
    let rows = run_all(&e);
    // Seeds 3 and 4 of the ants, and seed 6, which no run before it leads to.
    let some = [rows[0].clone(), rows[1].clone(), rows[3].clone()];
    let recorded = Recorded::of(&e, &some);
    assert_eq!(recorded.runs[0][0].as_ref().map(|runs| runs.count), Some(2));
    assert_eq!(recorded.runs[0][1], None);
    for (with_rows, runs) in [(false, 2), (true, 3)] {
        let told = verified(&some, with_rows, &rows);
        assert_eq!((told.same, told.open, told.runs, told.of, told.refuted), (1, 0, runs, runs, false));
    }
}

#[test]
fn the_first_seed_that_differs_is_named() {
    let rows = run_all(&comparison());
    let mut others = rows.clone();
    for place in [2, 3] {
        others[place].digest = "0000000000000000".into();
    }
    let told = verified(&others, true, &rows);
    assert_eq!((told.same, told.open, told.runs, told.of, told.refuted), (1, 0, 6, 8, true));
    let [recorded, now] = [&others[2], &rows[2]].map(digest);
    let (instance, entry) = ("open".to_owned(), "ants".to_owned());
    let bits = Deviation::Bits { instance, entry, seed: Some(5), differing: Some(2), recorded, now };
    assert_eq!(told.deviations, [bits]);
    // In a link only that they differ.
    let told = verified(&others, false, &rows);
    assert_eq!((told.same, told.runs, told.refuted), (1, 4, true));
    assert!(matches!(told.deviations[..], [Deviation::Bits { seed: None, differing: None, .. }]));
}

#[test]
fn every_difference_is_told_with_what_may_be_its_cause() {
    let e = comparison();
    let rows = run_all(&e);
    let mut then = Recorded::of(&e, &rows);
    then.engine = "0.0.1".into();
    then.parameters[0].as_mut().unwrap().insert("ants".into(), crate::params::Value::from(7.0));
    then.runs[0][0].as_mut().unwrap().digest = "00".into();
    let told = Record::new(&e, Some(then)).verify(&e, &[], &rows);
    let lines: Vec<String> = told.deviations.iter().map(ToString::to_string).collect();
    assert_eq!(lines.len(), 3, "{lines:?}");
    assert_eq!(lines[0], format!("engine: recorded with version 0.0.1, this is {}", env!("CARGO_PKG_VERSION")));
    assert_eq!(lines[1], "parameter ants.ants: recorded with 7.0, now 4.0");
    assert!(lines[2].starts_with("runs of ants on open: digest 00 was recorded, now "));
    assert!(!told.refuted, "another version may give other bits");
}

#[test]
fn rows_that_were_changed_in_the_file_are_told_from_runs_that_differ() {
    let e = comparison();
    let rows = run_all(&e);
    let text = comparison_json::write(&e, &rows, true);
    let changed = text.replacen(&rows[5].digest, "0123456789abcdef", 1);
    let opened = comparison_json::open(&changed).unwrap();
    let told = opened.record().verify(&e, &opened.rows, &rows);
    let edited = Deviation::Edited { instance: "open".into(), entry: "exact".into() };
    // The digest in the file is still that of the runs that come out.
    assert_eq!((told.deviations, told.same, told.refuted), (vec![edited], 2, true));
}

#[test]
fn runs_of_several_engines_are_said_to_be() {
    let mut other = Recorded::of(&comparison(), &[]);
    let mine = |other: &Recorded| Recorded::of(&comparison(), &[]).with_runs_of(other).engine;
    let now = env!("CARGO_PKG_VERSION");
    assert_eq!(mine(&other), now);
    other.engine = "0.0.1".into();
    assert_eq!(mine(&other), format!("0.0.1 and {now}"));
    other.engine = mine(&other);
    assert_eq!(mine(&other), format!("0.0.1 and {now}"));
}

#[test]
fn rows_that_tell_no_clearance_are_those_that_do() {
    let rows = run_all(&comparison());
    let mut before = rows.clone();
    before.iter_mut().flat_map(|row| &mut row.found).for_each(|found| found.clearance = None);
    for with_rows in [true, false] {
        assert_eq!(
            (verified(&before, with_rows, &rows).same, verified(&rows, with_rows, &before).runs),
            (2, if with_rows { 0 } else { 8 })
        );
    }
    // What is told is compared.
    let mut other = rows.clone();
    other[0].found.as_mut().and_then(|found| found.clearance.as_mut()).expect("told").mean += 1.0;
    assert!(verified(&other, true, &rows).refuted);
}
