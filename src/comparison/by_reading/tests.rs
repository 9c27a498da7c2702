//! Claims of one, two and no reading, and readings that the entries are not run by.

use super::*;
use crate::comparison::question::FORMAT;
use serde_json::{Value, json};

fn claim(id: &str, says: &str, measure: &str, reading: Option<&str>) -> Value {
    let mut claim =
        json!({ "id": id, "says": says, "improved": "new", "baseline": "old", "measure": measure, "direction": "less" });
    if let Some(reading) = reading {
        claim["reading"] = json!(reading);
    }
    claim
}

fn claims(all: &[Value]) -> Vec<Claim> {
    all.iter().map(|claim| serde_json::from_value(claim.clone()).unwrap()).collect()
}

#[test]
fn claims_that_say_the_same_are_one_row() {
    let claims = claims(&[
        claim("second", "shorter", "length", Some("second-reading")),
        claim("any", "shorter", "length", None),
        claim("turns", "shorter", "turns", Some("as-read")),
        claim("as-read", "shorter", "length", Some("as-read")),
        claim("again", "shorter", "length", Some("as-read")),
        claim("other", "sooner", "length", Some("second-reading")),
    ]);
    let table = ByReading::of(&claims);
    assert_eq!(table.readings, [PaperReading::AsRead, PaperReading::SecondReading], "only those that occur, in their order");
    let rows: Vec<_> = table.rows.iter().map(|row| row.claims.clone()).collect();
    assert_eq!(rows, [vec![Some(3), Some(0)], vec![Some(2), None], vec![Some(4), None], vec![None, Some(5)]]);
    assert_eq!(table.rows[0].first(), 3);
}

#[test]
fn running_times_to_other_targets_say_something_else() {
    let mut all = [claim("a", "sooner", "running-time", Some("printed")), claim("b", "sooner", "running-time", Some("as-read"))];
    assert_eq!(ByReading::of(&claims(&all)).rows.len(), 1);
    // The target that is meant without one is another way to say the same.
    all[1]["target"] = json!(Claim::TARGET);
    assert_eq!(ByReading::of(&claims(&all)).rows.len(), 1);
    all[1]["target"] = json!(0.05);
    assert_eq!(ByReading::of(&claims(&all)).rows.len(), 2);
}

#[test]
fn claims_without_a_reading_make_no_table() {
    assert_eq!(ByReading::of(&claims(&[claim("a", "shorter", "length", None)])), ByReading::default());
    // And are written as ever.
    let old = claims(&[claim("a", "shorter", "length", None)]);
    assert!(serde_json::to_value(&old[0]).unwrap().get("reading").is_none());
}

#[test]
fn entries_are_run_by_the_reading_that_is_claimed() {
    let refused = |preset: Value, set: Value, reading: &str| {
        let mut new = json!({ "id": "new", "label": "", "role": "improved", "planner": "ship", "set": set });
        new["preset"] = preset;
        let question: Question = serde_json::from_value(json!({
            "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 3 },
            "instances": [{ "id": "a", "map": "a.json" }],
            "entries": [{ "id": "old", "label": "", "role": "baseline", "planner": "ant-system", "preset": "ship" }, new],
            "claims": [claim("c", "shorter", "length", Some(reading))]
        }))
        .unwrap();
        question.check().err().map(|error| error.report())
    };
    assert_eq!(refused(json!("printed"), json!({}), "printed"), None);
    assert_eq!(refused(Value::Null, json!({}), "as-read"), None);
    let report = refused(json!("printed"), json!({}), "second-reading").unwrap();
    assert_eq!(report.field, "claims.c.reading");
    assert!(report.hint.contains("printed, by which"), "{}", report.hint);
    assert!(refused(Value::Null, json!({}), "printed").is_some(), "the defaults are a reading as well");
    // A preset that is no reading, and own values: nobody can tell.
    assert_eq!(refused(json!("cells"), json!({}), "second-reading"), None);
    assert_eq!(refused(Value::Null, json!({ "rho_part": "stays" }), "second-reading"), None);
}
