//! Questions that can be asked, and what is refused of others.

use super::*;
use crate::comparison::budget::{Axis, Budget};
use crate::comparison::claim::Direction;
use crate::comparison::question::{Instance, Seeds};
use serde_json::json;

fn question() -> Question {
    serde_json::from_value(json!({
        "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 3 },
        "instances": [{ "id": "a", "map": "a.json" }, { "id": "b", "map": "b.json" }],
        "entries": [
            { "id": "old", "label": "old", "role": "baseline", "planner": "ant-system",
              "published": { "a": { "length": 40.0, "turns": 20 }, "b": { "length": 50.0 } } },
            { "id": "new", "label": "new", "role": "improved", "planner": "ship", "published": { "a": { "length": 30.0 } } },
            { "id": "ref", "label": "ref", "role": "other", "missing": "formulas not published" }
        ],
        "claims": [{ "id": "shorter", "says": "shorter", "improved": "new", "baseline": "old", "measure": "length", "direction": "less" }]
    }))
    .unwrap()
}

#[test]
fn a_claims_size_follows_from_the_published_numbers() {
    let q = question();
    assert_eq!(q.check(), Ok(()));
    // (40 − 30) / 40.
    assert_eq!(q.claimed_size(&q.claims[0], "a"), Some(0.25));
    assert_eq!(q.claimed_size(&q.claims[0], "b"), None);
    let stated = Claim { size: Some(0.1), ..q.claims[0].clone() };
    assert_eq!(q.claimed_size(&stated, "b"), Some(0.1));
}

#[test]
fn what_does_not_fit_is_named() {
    let wrong = |change: fn(&mut Question), field: &str| {
        let mut q = question();
        change(&mut q);
        let report = q.check().unwrap_err().report();
        assert_eq!(report.field, field, "{}", report.message);
        assert!(!report.hint.is_empty());
    };
    wrong(|q| q.format = "formicarium/question@2".into(), "format");
    wrong(|q| q.seeds.count = 0, "seeds.count");
    wrong(|q| q.seeds.from = u32::MAX, "seeds.from");
    // Each of them may be asked for; all of them together are too many.
    wrong(
        |q| {
            q.seeds.count = 100_000;
            let map = q.instances[0].clone();
            q.instances.extend((0..20).map(|i| Instance { id: format!("more-{i}"), ..map.clone() }));
        },
        "seeds.count",
    );
    wrong(|q| q.budget = Some(Budget { axis: Axis::Time, amount: 3 }), "budget.axis");
    wrong(|q| q.budget = Some(Budget { axis: Axis::Moves, amount: 0 }), "budget.amount");
    wrong(|q| q.budget = Some(Budget { axis: Axis::Moves, amount: (1 << 53) + 1 }), "budget.amount");
    wrong(|q| q.entries[0].published.get_mut("a").unwrap().iterations = Some(1e16), "entries.old.published.a");
    wrong(|q| q.entries[0].results = Some("mine.csv".into()), "entries.old.planner");
    wrong(|q| q.instances.clear(), "instances");
    wrong(|q| q.instances[0].id = "A map".into(), "instances.id");
    wrong(|q| q.entries[1].id = "old".into(), "entries.id");
    wrong(|q| q.entries[0].planner = Some("bee".into()), "entries.old.planner");
    wrong(|q| q.entries[0].planner = None, "entries.old.planner");
    wrong(|q| q.entries[2].planner = Some("ship".into()), "entries.ref.planner");
    wrong(|q| q.claims[0].baseline = "older".into(), "claims.shorter.baseline");
    wrong(|q| q.claims[0].instances = vec!["c".into()], "claims.shorter.instances");
    wrong(|q| q.claims[0].direction = Direction::More, "claims.shorter.size");
    wrong(|q| q.claims[0].size = Some(f64::NAN), "claims.shorter.size");
}

#[test]
fn instances_can_be_left_out() {
    let mut q = question();
    q.claims.push(Claim { id: "on-a".into(), instances: vec!["a".into()], ..q.claims[0].clone() });
    q.keep_instances(&["b".into()]).unwrap();
    assert_eq!((q.instances.len(), q.claims.len(), q.entries[0].published.len()), (1, 1, 1));
    assert_eq!(q.check(), Ok(()));
    assert!(q.keep_instances(&["a".into()]).is_err());
    assert!(q.instance_mut("a").is_err());
    assert_eq!(q.instance_mut("b").unwrap().map, "b.json");
}

#[test]
fn unknown_fields_are_refused() {
    let error = serde_json::from_value::<Seeds>(json!({ "from": 1, "count": 2, "till": 3 })).unwrap_err();
    assert!(error.to_string().contains("till"));
}
