//! The rule of docs/methodology.md, case by case.

use std::sync::Arc;

use super::*;
use crate::comparison::Comparison;
use crate::comparison::question::{FORMAT, Question};
use crate::comparison::row::Task;
use crate::map::{Grid, Point};
use crate::scenario::{Scenario, ScenarioSpec};
use serde_json::json;

const CLAIM: &str = r#"{ "id": "c", "says": "", "improved": "a", "baseline": "b", "measure": "length", "direction": "less" }"#;

fn judged(claimed: Option<f64>, improved: f64, baseline: f64, low: f64, high: f64) -> JudgedClaim {
    JudgedClaim {
        claim: 0,
        instance: 0,
        claimed,
        pairs: 100,
        finite_pairs: 100,
        baseline_optimal: Some(0.2),
        statistic: Statistic::Median,
        baseline: Some(baseline),
        improved: Some(improved),
        medians: Some(Difference { value: improved - baseline, low, high }),
        means: None,
        better: None,
        verdict: Verdict::Not,
    }
}

#[test]
fn the_rule() {
    let claim: Claim = serde_json::from_str(CLAIM).unwrap();
    let judge = |c: JudgedClaim| verdict(&claim, &c);
    // Claimed: 10 % shorter. 40 → 38 is 5 %: half of it, and the interval lies below 0.
    assert_eq!(judge(judged(Some(0.1), 38.0, 40.0, -2.5, -1.5)), Verdict::Reproduced);
    assert_eq!(judge(judged(Some(0.1), 38.5, 40.0, -2.0, -1.0)), Verdict::Partly);
    assert_eq!(judge(judged(Some(0.1), 38.0, 40.0, -4.0, 0.0)), Verdict::Not);
    assert_eq!(judge(judged(Some(0.1), 42.0, 40.0, 1.0, 3.0)), Verdict::Opposite);
    assert_eq!(judge(judged(None, 39.9, 40.0, -0.2, -0.05)), Verdict::Reproduced);
}

#[test]
fn runs_without_a_path_decide_too() {
    let claim: Claim = serde_json::from_str(CLAIM).unwrap();
    let judge = |c: JudgedClaim| verdict(&claim, &c);
    let cannot = |c: JudgedClaim| matches!(judge(c), Verdict::CannotTell(_));
    // An improved entry that mostly finds nothing is no improvement; a baseline that does is none to compare with.
    let inf = f64::INFINITY;
    assert_eq!(judge(judged(Some(0.1), inf, 40.0, inf, inf)), Verdict::Opposite);
    assert!(cannot(judged(Some(0.1), 40.0, inf, -inf, -inf)));
    assert!(cannot(JudgedClaim { pairs: 29, ..judged(None, 39.0, 40.0, -2.0, -0.5) }));
    let unpaired = JudgedClaim { medians: None, pairs: 0, ..judged(None, 39.0, 40.0, 0.0, 0.0) };
    assert_eq!(judge(unpaired.clone()), Verdict::CannotTell(WhyNot::NoCommonSeed));
    assert_eq!(judge(JudgedClaim { improved: None, ..unpaired }), Verdict::CannotTell(WhyNot::NotRun));
}

#[test]
fn an_optimal_baseline_leaves_no_room() {
    let claim: Claim = serde_json::from_str(CLAIM).unwrap();
    let full = |improved, low, high| JudgedClaim { baseline_optimal: Some(0.97), ..judged(None, improved, 40.0, low, high) };
    assert!(matches!(verdict(&claim, &full(40.0, -0.1, 0.0)), Verdict::CannotTell(_)));
    assert_eq!(verdict(&claim, &full(41.0, 0.5, 1.5)), Verdict::Opposite);
    let turns = Claim { measure: RunMeasure::Turns, ..claim };
    assert_eq!(verdict(&turns, &full(40.0, -0.1, 0.0)), Verdict::Not);
}

/// Steps, a polyline and V on an open map without a straight way.
fn comparison(width: u32, height: u32) -> Comparison {
    let entry = |planner| json!({ "id": planner, "label": planner, "role": "other", "planner": planner });
    let planners = ["astar", "theta-star", "turn-aware"];
    let question: Question = serde_json::from_value(json!({
        "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 2 },
        "instances": [{ "id": "open", "map": "open.json" }],
        "entries": planners.map(entry)
    }))
    .unwrap();
    let grid = Grid::open(width, height).unwrap();
    let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(width - 1, height - 1));
    Comparison::new(question, vec![Arc::new(Scenario::new(grid, spec).unwrap())]).unwrap()
}

#[test]
fn an_optimum_of_another_kind_leaves_room() {
    let map = &comparison(6, 5).maps[0];
    let is_bound = |improved, baseline| is_bound(map, RunMeasure::Length, [Some(improved), Some(baseline)]);
    // A polyline may be shorter than the shortest path of steps; not the other way round. The least V says nothing of lengths.
    assert_eq!([is_bound(0, 0), is_bound(1, 0), is_bound(0, 1), is_bound(0, 2)], [true, false, true, false]);
    assert!(
        !super::is_bound(map, RunMeasure::Turns, [Some(0), Some(0)])
            && !super::is_bound(map, RunMeasure::Length, [None, Some(0)])
    );
}

#[test]
fn what_is_not_proven_is_no_optimum() {
    // Above 64 × 64 cells the yardstick of polylines is a Theta* run.
    for (width, proven) in [(64, true), (65, false)] {
        let comparison = comparison(width, 64);
        let row = comparison.run(Task { instance: 0, entry: 1, seed: 1 }, &mut || 0.0).unwrap().row;
        assert_eq!(comparison.gap(&row), Some(0.0));
        assert_eq!(comparison.value(&row, RunMeasure::Optimal), Some(f64::from(u8::from(proven))));
    }
}

#[test]
fn a_run_without_a_path_is_never_the_better_one() {
    let inf = f64::INFINITY;
    let of = |direction| [inf, 3.0].map(|v| worst_if_missing(direction, v));
    assert_eq!((of(Direction::Less), of(Direction::More)), ([inf, 3.0], [-inf, 3.0]));
    let claim: Claim = serde_json::from_str(CLAIM).unwrap();
    let means = Claim { statistic: Some(Statistic::Mean), ..claim };
    assert_eq!((means.statistic(true), means.statistic(false)), (Statistic::Mean, Statistic::Median));
}

#[test]
fn more_is_the_other_direction() {
    let less: Claim = serde_json::from_str(CLAIM).unwrap();
    let more = Claim { direction: Direction::More, ..less };
    assert_eq!(verdict(&more, &judged(Some(0.1), 42.0, 40.0, 1.0, 3.0)), Verdict::Reproduced);
    assert_eq!(verdict(&more, &judged(Some(0.1), 38.0, 40.0, -2.5, -1.5)), Verdict::Opposite);
    assert_eq!(better(Direction::Less, &[1.0, 1.0], &[2.0, 1.0]), Some(0.75));
    assert_eq!(better(Direction::More, &[1.0, 1.0], &[2.0, 1.0]), Some(0.25));
}
