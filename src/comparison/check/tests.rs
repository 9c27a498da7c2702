//! Questions that can be asked, and what is refused of others.

use super::*;
use crate::comparison::budget::{Axis, Budget};
use crate::comparison::claim::Direction;
use crate::comparison::question::{Instance, Published, Seeds};
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
    assert_eq!(q.claimed_size(&q.claims[0], &q.instances[0]), Some(0.25));
    assert_eq!(q.claimed_size(&q.claims[0], &q.instances[1]), None);
    let stated = Claim { size: Some(0.1), ..q.claims[0].clone() };
    assert_eq!(q.claimed_size(&stated, &q.instances[1]), Some(0.1));
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
    wrong(|q| q.claims[0].relevant = Some(0.0), "claims.shorter.relevant");
    wrong(|q| q.claims[0].relevant = Some(1.0), "claims.shorter.relevant");
    wrong(|q| q.claims[0].target = Some(0.01), "claims.shorter.target");
    wrong(|q| q.claims[0].axis = Some(Axis::Moves), "claims.shorter.axis");
    let timed = |q: &mut Question| {
        q.claims[0].measure = RunMeasure::RunningTime;
        q.claims[0].target = Some(0.0);
        q.claims[0].axis = Some(Axis::Moves);
    };
    let mut q = question();
    timed(&mut q);
    assert_eq!(q.check(), Ok(()));
    q.claims[0].target = Some(-0.1);
    assert_eq!(q.check().unwrap_err().report().field, "claims.shorter.target");
    timed(&mut q);
    q.claims[0].axis = Some(Axis::Time);
    assert_eq!(q.check().unwrap_err().report().field, "claims.shorter.axis");
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

/// Two maps that stand for one of the publication's, and a third one.
fn grouped() -> Question {
    let mut q = question();
    q.instances.push(Instance { id: "c".into(), ..q.instances[1].clone() });
    q.instances.iter_mut().skip(1).for_each(|i| i.group = Some("one".into()));
    let [own, shared] = [50.0, 60.0].map(|length| Published { length: Some(length), ..Published::default() });
    q.entries[0].published = [("b".into(), own), ("one".into(), shared)].into();
    q.entries[1].published = [("one".into(), Published { length: Some(45.0), ..Published::default() })].into();
    q.facts = vec![Fact { group: Some("one".into()), optimum_at_most: Some(45.0), ..Fact::default() }];
    q
}

#[test]
fn what_is_published_of_a_group_holds_for_its_instances() {
    let q = grouped();
    assert_eq!(q.check(), Ok(()));
    // (50 − 45) / 50 by its own number, (60 − 45) / 60 by the group's; nothing is published for `a`.
    assert_eq!([0, 1, 2].map(|at| q.claimed_size(&q.claims[0], &q.instances[at])), [None, Some(0.1), Some(0.25)]);
    let about = |of: &[&str]| {
        let claim = Claim { instances: of.iter().map(|id| id.to_string()).collect(), ..q.claims[0].clone() };
        q.instances.iter().map(|i| claim.is_about(i)).collect::<Vec<_>>()
    };
    assert_eq!(
        (about(&[]), about(&["one"]), about(&["a", "c"])),
        (vec![true; 3], vec![false, true, true], vec![true, false, true])
    );
}

#[test]
fn groups_and_facts_that_do_not_fit_are_named() {
    let wrong = |change: fn(&mut Question), field: &str| {
        let mut q = grouped();
        change(&mut q);
        assert_eq!(q.check().unwrap_err().report().field, field);
    };
    wrong(|q| q.instances[1].group = Some("a".into()), "instances.b.group");
    wrong(|q| q.instances[1].group = Some("Map 1".into()), "instances.b.group");
    wrong(|q| q.entries[0].published.extend([("two".into(), Published::default())]), "entries.old.published");
    wrong(|q| q.facts[0].group = Some("two".into()), "facts.0.group");
    wrong(|q| q.facts[0].instances = vec!["a".into()], "facts.0.instances");
    wrong(|q| q.facts[0].optimum_of = Some("none".into()), "facts.0.optimum_of");
    wrong(|q| q.facts[0].arrives = vec!["none".into()], "facts.0.arrives");
    wrong(|q| q.facts[0].optimum_at_most = None, "facts.0.optimum_at_most");
    wrong(|q| q.facts[0].optimum_at_most = Some(0.0), "facts.0.optimum_at_most");
    wrong(|q| q.facts[0].in_at_least = Some(0.5), "facts.0.in_at_least");
    wrong(
        |q| {
            q.facts[0].arrives = vec!["old".into()];
            q.facts[0].in_at_least = Some(1.1);
        },
        "facts.0.in_at_least",
    );
}

#[test]
fn groups_and_facts_go_with_their_last_instance() {
    let mut q = grouped();
    q.keep_instances(&["a".into(), "c".into()]).unwrap();
    assert_eq!((q.entries[0].published.len(), q.facts.len(), q.check()), (1, 1, Ok(())));
    q.keep_instances(&["a".into()]).unwrap();
    assert_eq!((q.entries[0].published.len(), q.facts.len(), q.check()), (0, 0, Ok(())));
}

#[test]
fn a_group_is_kept_by_its_id_and_takes_one_more_instance() {
    let mut q = grouped();
    let added = |id: &str, group: &str| Instance {
        id: id.into(),
        map: "mine.json".into(),
        note: String::new(),
        group: Some(group.into()),
    };
    q.add_instance(added("mine", "one")).unwrap();
    assert_eq!(q.check(), Ok(()));
    // What is published of the group, claims and facts are about it as about the others.
    assert_eq!((q.claimed_size(&q.claims[0], &q.instances[3]), q.facts[0].is_about(&q.instances[3])), (Some(0.25), true));
    for (id, group, field) in [("mine", "one", "instances.id"), ("one", "one", "instances.id"), ("new", "two", "instances.group")]
    {
        assert_eq!(q.add_instance(added(id, group)).unwrap_err().report().field, field, "{group}/{id}");
    }
    let refused = q.add_instance(added("new", "a")).unwrap_err();
    assert_eq!(refused.report().hint, "give one of one", "an instance is no group");
    q.keep_instances(&["one".into()]).unwrap();
    assert_eq!(q.instances.iter().map(|i| i.id.as_str()).collect::<Vec<_>>(), ["b", "c", "mine"]);
    let refused = question().add_instance(added("new", "one")).unwrap_err();
    assert!(refused.to_string().contains("the question has no groups"), "{refused}");
}

#[test]
fn questions_of_before_are_written_as_before() {
    let written = serde_json::to_string(&question()).unwrap();
    for new in ["group", "facts", "relevant", "target", "axis"] {
        assert!(!written.contains(new), "{new}: {written}");
    }
    let q = grouped();
    assert_eq!(serde_json::from_str::<Question>(&serde_json::to_string(&q).unwrap()).unwrap(), q);
}

#[test]
fn unknown_fields_are_refused() {
    let error = serde_json::from_value::<Seeds>(json!({ "from": 1, "count": 2, "till": 3 })).unwrap_err();
    assert!(error.to_string().contains("till"));
}
