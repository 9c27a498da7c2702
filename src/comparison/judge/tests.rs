//! The rule of docs/methodology.md, case by case.

use std::sync::Arc;

use super::*;
use crate::comparison::question::{FORMAT, Instance, Question};
use crate::comparison::row::{Found, Improvement, Row, Spent, Task};
use crate::comparison::{Comparison, Seen};
use crate::map::{Grid, Point};
use crate::planner::Status;
use crate::scenario::{Scenario, ScenarioSpec};
use serde_json::json;

const CLAIM: &str = r#"{ "id": "c", "says": "", "improved": "a", "baseline": "b", "measure": "length", "direction": "less" }"#;

/// 40 → `improved`, with the 95 % interval of the effect; the 90 % one is a fifth narrower on each side.
fn judged(claimed: Option<f64>, improved: f64, low: f64, high: f64) -> JudgedClaim {
    let value = (40.0 - improved) / 40.0;
    let inner = |end: f64| value + 0.8 * (end - value);
    JudgedClaim {
        claim: 0,
        instance: 0,
        claimed,
        relevant: 0.01,
        paired: true,
        runs: [100, 100],
        finite: [100, 100],
        baseline_optimal: Some(0.2),
        statistic: Statistic::Median,
        baseline: Some(40.0),
        improved: Some(improved),
        medians: None,
        means: None,
        effect: Some(EffectSize { value, low, high, inner_low: inner(low), inner_high: inner(high) }),
        better: None,
        p: None,
        verdict: Verdict::Not,
    }
}

fn claim() -> Claim {
    serde_json::from_str(CLAIM).unwrap()
}

#[test]
fn the_rule() {
    let judge = |c: JudgedClaim| verdict(&claim(), &c);
    // Claimed: 10 % shorter. 40 → 37 is 7.5 %.
    assert_eq!(judge(judged(Some(0.1), 37.0, 0.06, 0.09)), Verdict::Reproduced);
    assert_eq!(judge(judged(Some(0.1), 38.0, 0.04, 0.06)), Verdict::Direction);
    assert_eq!(judge(judged(Some(0.1), 38.5, 0.03, 0.045)), Verdict::Partly);
    assert_eq!(judge(judged(Some(0.1), 38.0, 0.0, 0.1)), Verdict::Not);
    assert_eq!(judge(judged(Some(0.1), 42.0, -0.07, -0.03)), Verdict::Opposite);
    assert_eq!(judge(judged(None, 39.9, 0.001, 0.005)), Verdict::Equivalent);
}

#[test]
fn where_there_is_too_little_nothing_is_said() {
    let judge = |c: JudgedClaim| verdict(&claim(), &c);
    let cannot = Verdict::CannotTell;
    assert_eq!(judge(JudgedClaim { runs: [29, 100], ..judged(None, 37.0, 0.06, 0.09) }), cannot(WhyNot::TooFewRuns));
    // Means count finite runs alone.
    let mean = JudgedClaim { finite: [100, 29], statistic: Statistic::Mean, ..judged(None, 37.0, 0.06, 0.09) };
    assert_eq!(judge(mean), cannot(WhyNot::TooFewRuns));
    let none = JudgedClaim { runs: [0, 0], effect: None, ..judged(None, 39.0, 0.0, 0.0) };
    assert_eq!(judge(none.clone()), cannot(WhyNot::NoCommonSeed));
    let lost = JudgedClaim { baseline: Some(f64::INFINITY), effect: None, ..judged(None, 39.0, 0.0, 0.0) };
    assert_eq!(judge(lost), cannot(WhyNot::NoBaseline));
    // An improved entry that mostly finds nothing is no improvement.
    let inf = f64::INFINITY;
    assert_eq!(judge(judged(Some(0.1), inf, -inf, -inf)), Verdict::Opposite);
}

#[test]
fn an_optimal_baseline_leaves_no_room() {
    let full = |improved, low, high| JudgedClaim { baseline_optimal: Some(0.97), ..judged(None, improved, low, high) };
    assert_eq!(verdict(&claim(), &full(40.0, 0.0, 0.002)), Verdict::CannotTell(WhyNot::NoRoom));
    assert_eq!(verdict(&claim(), &full(40.1, -0.03, 0.02)), Verdict::CannotTell(WhyNot::NoRoom));
    // Nor may a map count only where it speaks against the claim.
    assert_eq!(verdict(&claim(), &full(41.0, -0.04, -0.01)), Verdict::CannotTell(WhyNot::NoRoom));
    let longer = Claim { direction: Direction::More, ..claim() };
    assert_eq!(verdict(&longer, &full(39.0, 0.01, 0.04)), Verdict::Reproduced);
    let turns = Claim { measure: RunMeasure::Turns, ..claim() };
    assert_eq!(verdict(&turns, &full(40.0, 0.0, 0.002)), Verdict::Equivalent);
}

/// Steps, a polyline and V on an open map without a straight way.
fn open_question() -> Question {
    let entry = |planner| json!({ "id": planner, "label": planner, "role": "other", "planner": planner });
    let planners = ["astar", "theta-star", "turn-aware"];
    serde_json::from_value(json!({
        "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 2 },
        "instances": [{ "id": "open", "map": "open.json" }],
        "entries": planners.map(entry)
    }))
    .unwrap()
}

fn open_comparison(width: u32, height: u32) -> Comparison {
    comparison_on(Grid::open(width, height).unwrap())
}

fn comparison_on(grid: Grid) -> Comparison {
    let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(grid.width() - 1, grid.height() - 1));
    Comparison::new(open_question(), vec![Arc::new(Scenario::new(grid, spec).unwrap())]).unwrap()
}

#[test]
fn an_optimum_of_another_kind_leaves_room() {
    let map = &open_comparison(6, 5).maps[0];
    let is_bound = |improved, baseline| is_bound(map, RunMeasure::Length, [improved, baseline]);
    // A polyline may be shorter than the shortest path of steps; not the other way round. The least V says nothing of lengths.
    assert_eq!([is_bound(0, 0), is_bound(1, 0), is_bound(0, 1), is_bound(0, 2)], [true, false, true, false]);
    assert!(!super::is_bound(map, RunMeasure::Turns, [0, 0]));
}

#[test]
fn what_is_not_proven_is_no_optimum() {
    // On weighted ground the yardstick of polylines is a Theta* run.
    let factors = (0..63).map(|cell| if cell == 8 { 2.0 } else { 1.0 }).collect();
    let weighted = Grid::open(9, 7).unwrap().with_factors(factors).unwrap();
    for (comparison, proven) in [(open_comparison(65, 64), true), (comparison_on(weighted), false)] {
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
    assert_eq!(better(Direction::Less, &[1.0, 1.0], &[2.0, 1.0]), Some(0.75));
    assert_eq!(better(Direction::More, &[1.0, 1.0], &[2.0, 1.0]), Some(0.25));
}

/// Three entries on an open map: one planner twice, and another one.
fn three(claim: serde_json::Value) -> Comparison {
    let entry = |id: &str, planner: &str, ants: u32| json!({ "id": id, "label": id, "role": "other", "planner": planner, "set": { "ants": ants } });
    let question: Question = serde_json::from_value(json!({
        "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 40 },
        "instances": [{ "id": "open", "map": "open.json" }],
        "entries": [entry("a", "ant-system", 3), entry("b", "ant-system", 4), entry("c", "max-min-ant-system", 3)],
        "claims": [claim]
    }))
    .unwrap();
    let grid = Grid::open(11, 1).unwrap();
    let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(10, 0));
    Comparison::new(question, vec![Arc::new(Scenario::new(grid, spec).unwrap())]).unwrap()
}

/// A run that finds a path of this length after so many constructed paths, and ends after 100; an infinite one finds none.
fn row(entry: usize, seed: u32, length: f64, paths: u64) -> Row {
    let spent = |n: u64| Spent { iterations: Some(n), constructed_paths: Some(n), ant_moves: Some(n), cell_expansions: Some(0) };
    let found = length.is_finite();
    Row {
        task: Task { instance: 0, entry, seed },
        status: Status::BudgetSpent,
        found: found.then_some(Found {
            length,
            turns: Some(2),
            turn_index: None,
            weight: None,
            value: length,
            clearance: None,
            driving: None,
        }),
        effort: spent(100),
        trace: if found { vec![Improvement { value: length, spent: spent(paths) }] } else { Vec::new() },
        digest: String::new(),
    }
}

fn judged_of(comparison: &Comparison, rows: &[Row]) -> JudgedClaim {
    let samples = Samples::new(comparison, rows.iter().map(Seen::from));
    judge(&samples, &mut Intervals::default(), &[]).remove(0)
}

fn between(improved: &str, baseline: &str, measure: &str) -> serde_json::Value {
    json!({ "id": "c", "says": "", "improved": improved, "baseline": baseline, "measure": measure, "direction": "less" })
}

#[test]
fn a_map_that_is_asked_twice_counts_once() {
    let verdicts = |goal: u32| {
        let mut question = three(between("a", "b", "length")).question;
        question.instances.push(Instance { id: "again".into(), ..question.instances[0].clone() });
        let scenario = |goal| {
            let grid = Grid::open(11, 1).unwrap();
            let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(goal, 0));
            Arc::new(Scenario::new(grid, spec).unwrap())
        };
        let comparison = Comparison::new(question, vec![scenario(10), scenario(goal)]).unwrap();
        let of = |instance, entry: usize, seed| {
            let mut row = row(entry, seed, if entry == 0 { 19.0 } else { 20.0 }, 10);
            row.task.instance = instance;
            row
        };
        let rows: Vec<Row> = (0..2).flat_map(|i| (0..2).flat_map(move |e| (1..=40).map(move |seed| of(i, e, seed)))).collect();
        let samples = Samples::new(&comparison, rows.iter().map(Seen::from));
        judge(&samples, &mut Intervals::default(), &[]).iter().map(|c| c.verdict).collect::<Vec<_>>()
    };
    assert_eq!(verdicts(9), [Verdict::Reproduced, Verdict::Reproduced]);
    assert_eq!(verdicts(10), [Verdict::Reproduced, Verdict::CannotTell(WhyNot::SameMap)]);
}

#[test]
fn where_many_runs_end_in_a_first_stage_nothing_is_told() {
    let verdict = |in_first_stage: u32| {
        let mut comparison = three(between("a", "c", "iteration-of-best"));
        comparison.question.entries[0].first_stage = Some(50);
        let best = |seed| if seed <= in_first_stage { 50 } else { 60 };
        let ours = (1..=40).map(|seed| row(0, seed, 20.0, best(seed)));
        let rows: Vec<Row> = ours.chain((1..=40).map(|seed| row(2, seed, 20.0, 90))).collect();
        judged_of(&comparison, &rows).verdict
    };
    assert_eq!([verdict(2), verdict(3)], [Verdict::Reproduced, Verdict::CannotTell(WhyNot::FirstStage)]);
}

#[test]
fn settings_of_one_planner_are_pairs_and_planners_are_not() {
    // Each run of the improved entry is 5 % shorter than the other one of its seed, and lengths differ much more from seed to seed.
    let rows: Vec<Row> = (0..3)
        .flat_map(|entry| {
            let share = if entry == 0 { 0.95 } else { 1.0 };
            (1..=40).map(move |seed| row(entry, seed, share * (20.0 + 2.0 * f64::from(seed * 7 % 40)), 10))
        })
        .collect();
    let paired = judged_of(&three(between("a", "b", "length")), &rows);
    assert!(paired.paired && paired.verdict == Verdict::Reproduced, "{paired:?}");
    let independent = judged_of(&three(between("a", "c", "length")), &rows);
    assert!(!independent.paired && independent.verdict == Verdict::Not, "{independent:?}");
    let [values, again] = [&paired, &independent].map(|c| c.effect.unwrap().value);
    assert!((values - 0.05).abs() < 1e-9 && values == again);
    assert!(paired.p.unwrap() < 1e-6 && independent.p.unwrap() > 0.3);
    // Without a common seed there is no pair; independent samples need none.
    let apart: Vec<Row> = rows.iter().filter(|row| (row.task.entry == 0) == (row.task.seed <= 20)).cloned().collect();
    assert_eq!(judged_of(&three(between("a", "b", "length")), &apart).verdict, Verdict::CannotTell(WhyNot::NoCommonSeed));
    let few = judged_of(&three(between("a", "c", "length")), &apart);
    assert_eq!((few.verdict, few.runs), (Verdict::CannotTell(WhyNot::TooFewRuns), [20, 20]));
    let alone: Vec<Row> = rows.iter().filter(|row| row.task.entry == 0).cloned().collect();
    let alone = judged_of(&three(between("a", "c", "length")), &alone);
    assert_eq!((alone.verdict, alone.baseline), (Verdict::CannotTell(WhyNot::NotRun), None));
    assert!(alone.improved.is_some());
}

#[test]
fn shares_differ_by_points() {
    let of = |entry: usize, arriving: u32| {
        (1..=40).map(move |seed| row(entry, seed, if seed <= arriving { 12.0 } else { f64::INFINITY }, 10))
    };
    let rows: Vec<Row> = of(0, 36).chain(of(2, 20)).collect();
    let claim = json!({ "id": "c", "says": "", "improved": "a", "baseline": "c", "measure": "success", "direction": "more", "size": 0.5 });
    let comparison = three(claim);
    let judged = judged_of(&comparison, &rows);
    // 90 % against 50 %: 40 points. Half as much again as 50 % is 25 points.
    assert_eq!((judged.effect.unwrap().value, judged.claimed, judged.relevant), (0.4, Some(0.25), 0.05));
    assert_eq!(judged.verdict, Verdict::Reproduced);
    assert_eq!(judged_of(&comparison, &of(0, 36).collect::<Vec<_>>()).claimed, None);
}

#[test]
fn running_times_are_judged_by_what_all_runs_spend() {
    // The optimum is 10. `a` reaches it after 20 paths in 30 of 40 runs, the others spend 100: (600 + 1000) / 30. `c` after 50 in 20 of 40:
    // (1000 + 2000) / 20.
    let of = |entry: usize, hits: u32, paths: u64| {
        (1..=40).map(move |seed| row(entry, seed, if seed <= hits { 10.0 } else { 11.0 }, paths))
    };
    let time = between("a", "c", "running-time");
    let comparison = three(time.clone());
    let rows: Vec<Row> = of(0, 30, 20).chain(of(2, 20, 50)).collect();
    let judged = judged_of(&comparison, &rows);
    let near = |a: Option<f64>, b: f64| assert!((a.unwrap() - b).abs() < 1e-9, "{a:?}");
    near(judged.improved, 1600.0 / 30.0);
    near(judged.baseline, 150.0);
    near(judged.effect.map(|e| e.value), 1.0 - 1600.0 / 30.0 / 150.0);
    assert_eq!((judged.verdict, judged.paired, judged.p), (Verdict::Reproduced, false, None));
    // A target at 10 % is 11, which every run reaches: 20 paths against 50.
    let easy = judged_of(
        &three(
            json!({ "target": 0.1, "axis": "ant-moves", "id": "c", "says": "", "improved": "a", "baseline": "c", "measure": "running-time", "direction": "less" }),
        ),
        &rows,
    );
    assert_eq!((easy.improved, easy.baseline), (Some(20.0), Some(50.0)));
    // Where one never reaches it, the other one decides, unless it may be chance.
    let verdict =
        |hits: [u32; 2]| judged_of(&comparison, &of(0, hits[0], 20).chain(of(2, hits[1], 50)).collect::<Vec<_>>()).verdict;
    assert_eq!([[30, 0], [0, 30]].map(verdict), [Verdict::Reproduced, Verdict::Opposite]);
    assert_eq!([[3, 0], [0, 3]].map(verdict), [Verdict::Not, Verdict::Not]);
    assert_eq!(verdict([0, 0]), Verdict::CannotTell(WhyNot::NeitherReaches));
    // A run that found a path and does not tell when.
    let mut untold = rows.clone();
    untold[0].trace.clear();
    assert_eq!(judged_of(&comparison, &untold).verdict, Verdict::CannotTell(WhyNot::NoEffort));
    let few: Vec<Row> = rows.iter().filter(|row| row.task.seed < 30).cloned().collect();
    assert_eq!(judged_of(&comparison, &few).verdict, Verdict::CannotTell(WhyNot::TooFewRuns));
    // Turns are made small by nobody's V: entries that search for different things have no target in common.
    let other = Question {
        claims: vec![serde_json::from_value(between("astar", "turn-aware", "running-time")).unwrap()],
        ..open_question()
    };
    let other = Comparison::new(other, vec![Arc::clone(&open_comparison(6, 5).maps[0].scenario)]).unwrap();
    let rows: Vec<Row> = [0, 2].into_iter().flat_map(|entry| (1..=40).map(move |seed| row(entry, seed, 10.0, 20))).collect();
    assert_eq!(judged_of(&other, &rows).verdict, Verdict::CannotTell(WhyNot::OtherObjective));
}
