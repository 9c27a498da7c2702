//! Open maps, whose optimum is known by hand.

use std::sync::Arc;

use super::*;
use crate::comparison::analysis::{Analysis, whole};
use crate::comparison::row::{Found, Row, Spent, Task};
use crate::comparison::verdict::{Verdict, WhyNot};
use crate::comparison::{Comparison, Intervals, Question, Seen};
use crate::map::{Grid, Movement, Point};
use crate::planner::Status;
use crate::scenario::Scenario;
use serde_json::{Value, json};

/// A corridor of 11 cells, optimum 10, and an open map of 5 × 3, by steps 2 + 2√2, as a polyline √20.
fn comparison(facts: Value) -> Comparison {
    let entry = |id: &str, planner: &str| json!({ "id": id, "label": id, "role": "other", "planner": planner });
    let question: Question = serde_json::from_value(json!({
        "format": "formicarium/question@1", "title": "t", "asks": "?", "seeds": { "from": 1, "count": 30 },
        "instances": [{ "id": "long", "map": "m.json", "group": "one" }, { "id": "open", "map": "m.json", "group": "two" }],
        "entries": [entry("ants", "ant-system"), entry("line", "theta-star")],
        "claims": [{ "id": "c", "says": "", "improved": "line", "baseline": "ants", "measure": "length", "direction": "less" }],
        "facts": facts
    }))
    .unwrap();
    let maps = [(11, 1), (5, 3)].map(|(width, height)| {
        let (grid, goal) = (Grid::open(width, height).unwrap(), Point::new(width - 1, height - 1));
        Arc::new(Scenario::on(grid, Movement::default(), Point::new(0, 0), goal).unwrap())
    });
    Comparison::new(question, maps.into()).unwrap()
}

/// `arriving` of `runs` runs of the ants find a path, on every map.
fn rows(arriving: u32, runs: u32) -> Vec<Row> {
    let one = |instance: usize, seed: u32| Row {
        task: Task { instance, entry: 0, seed },
        status: Status::BudgetSpent,
        found: (seed <= arriving).then_some(Found {
            length: 20.0,
            turns: Some(1),
            turn_index: None,
            weight: None,
            value: 20.0,
            clearance: None,
            driving: None,
        }),
        effort: Spent::default(),
        trace: Vec::new(),
        digest: String::new(),
    };
    (0..2).flat_map(|instance| (1..=runs).map(move |seed| one(instance, seed))).collect()
}

fn analysed(comparison: &Comparison, rows: &[Row]) -> Analysis {
    whole(&Samples::new(comparison, rows.iter().map(Seen::from)), &mut Intervals::default())
}

fn told(facts: Value, arriving: u32, runs: u32) -> Vec<(String, Unfit)> {
    let comparison = comparison(facts);
    analysed(&comparison, &rows(arriving, runs)).unfit.into_iter().map(|map| (map.instance, map.why)).collect()
}

#[test]
fn the_optimum_of_a_map_may_not_be_above_what_is_published() {
    let of = |group: &str, most: f64| told(json!([{ "group": group, "optimum_at_most": most }]), 0, 0);
    assert_eq!((of("one", 10.0), of("one", 12.5)), (vec![], vec![]));
    assert_eq!(of("one", 9.9), [("long".into(), Unfit::Optimum)]);
    // 2 + 2√2 = 4.828: printed as 4.83 or as 4.8 it can be.
    assert_eq!((of("two", 4.83), of("two", 4.8)), (vec![], vec![]));
    assert_eq!(of("two", 4.82), [("open".into(), Unfit::Optimum)]);
    // √20 = 4.472 of a polyline.
    let line = |most: f64| told(json!([{ "group": "two", "optimum_at_most": most, "optimum_of": "line" }]), 0, 0);
    assert_eq!((line(4.5), line(4.4)), (vec![], vec![("open".into(), Unfit::Optimum)]));
}

#[test]
fn who_arrives_there_must_arrive_here() {
    let of = |share: Value, arriving| {
        told(json!([{ "instances": ["long"], "arrives": ["ants"], "in_at_least": share }]), arriving, 30)
    };
    // Half of 30 unless said otherwise.
    assert_eq!((of(Value::Null, 15), of(json!(0.8), 24)), (vec![], vec![]));
    assert_eq!(
        (of(Value::Null, 14), of(json!(0.8), 23)),
        (vec![("long".into(), Unfit::Arrives)], vec![("long".into(), Unfit::Arrives)])
    );
    // Of fewer runs than a verdict needs nothing is said; a fact about no map in particular is about all.
    let all = |runs| told(json!([{ "arrives": ["ants"] }]), 0, runs);
    assert_eq!((all(29).len(), all(30).len()), (0, 2));
}

#[test]
fn who_does_not_arrive_spoils_his_own_claims_alone() {
    let verdicts = |facts: Value| {
        let mut comparison = comparison(facts);
        let mut ours = comparison.question.claims[0].clone();
        (ours.id, ours.improved) = ("ours".into(), "ants".into());
        comparison.question.claims.push(ours);
        let told = analysed(&comparison, &rows(10, 30));
        told.judged.iter().map(|c| c.verdict == Verdict::CannotTell(WhyNot::Contradicted)).collect::<Vec<_>>()
    };
    // Of both maps the first claim is of line against ants, the second of ants against ants.
    assert_eq!(verdicts(json!([{ "arrives": ["ants"] }])), [true, true, true, true]);
    assert_eq!(verdicts(json!([{ "group": "two", "arrives": ["line", "ants"] }])), [false, true, false, true]);
    assert_eq!(verdicts(json!([{ "arrives": ["line"] }])), [false, false, false, false]);
}

#[test]
fn of_a_map_that_cannot_stand_for_it_nothing_can_be_told() {
    let comparison = comparison(json!([{ "group": "one", "optimum_at_most": 9.0, "says": "table 1" }]));
    let analysis = analysed(&comparison, &rows(30, 30));
    let verdicts: Vec<Verdict> = analysis.judged.iter().map(|c| c.verdict).collect();
    assert_eq!(verdicts, [Verdict::CannotTell(WhyNot::Contradicted), Verdict::CannotTell(WhyNot::NotRun)]);
    let UnfitMap { says, entry, found, demanded, .. } = &analysis.unfit[0];
    assert_eq!((says.as_str(), entry, *found, *demanded), ("table 1", &None, Some(10.0), 9.0));
    // Without intervals there is the same list, and no verdict.
    let rows = rows(30, 30);
    let quick = crate::comparison::analyse(
        &Samples::new(&comparison, rows.iter().map(Seen::from)),
        crate::comparison::Axis::ConstructedPaths,
        None,
    );
    assert_eq!((quick.unfit, quick.over_maps.len()), (analysis.unfit, 0));
}
