//! Samples whose effects are known.

use std::sync::Arc;

use super::*;
use crate::comparison::Comparison;
use crate::comparison::ablation::roles::{AblationRole, roles};
use crate::comparison::question::{Instance, Seeds};
use crate::comparison::row::{Found, Row, Spent, Task};
use crate::map::{Grid, Movement, Point};
use crate::params::Values;
use crate::planner::Status;
use crate::scenario::Scenario;

const SEEDS: Seeds = Seeds { from: 1, count: 20 };

/// An ablation with the entries full, without-ranking and without-best-so-far-deposit, on a corridor.
fn comparison() -> Comparison {
    let grid = Grid::open(6, 1).expect("a usable size");
    let scenario = Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(5, 0)).expect("usable");
    let instance = Instance { id: "a".into(), map: "a.json".into(), note: String::new(), group: None };
    let question =
        crate::comparison::ablation::question("rank-based-ant-system", None, &Values::new(), vec![instance], SEEDS).unwrap();
    Comparison::new(question, vec![Arc::new(scenario)]).unwrap()
}

/// Lengths by entry, for seeds from 1 on; infinite: no path.
fn rows(lengths: [Vec<f64>; 3]) -> Vec<Row> {
    let row = |entry, seed, length: f64| Row {
        task: Task { instance: 0, entry, seed },
        status: Status::BudgetSpent,
        found: length.is_finite().then_some(Found {
            length,
            turns: None,
            turn_index: None,
            weight: None,
            value: length,
            clearance: None,
            driving: None,
        }),
        effort: Spent::default(),
        trace: Vec::new(),
        digest: String::new(),
    };
    let all = lengths.into_iter().enumerate();
    all.flat_map(|(entry, of)| (1..).zip(of).map(move |(seed, length)| row(entry, seed, length))).collect()
}

fn judged(lengths: [Vec<f64>; 3]) -> Ablated {
    effects(&Samples::new(&comparison(), rows(lengths).iter().map(Into::into))).remove(0)
}

fn close(a: Option<f64>, b: f64) {
    assert!(a.is_some_and(|a| (a - b).abs() <= 1e-4 * b), "{a:?} is not {b}");
}

#[test]
fn one_that_matters_and_one_that_does_not() {
    let full: Vec<f64> = (0..20).map(|i| 30.0 + f64::from(i)).collect();
    let longer = full.iter().map(|v| v + 1.0).collect();
    let a = judged([full.clone(), full.clone(), longer]);
    assert_eq!((a.measure, a.statistic, a.full), (RunMeasure::Length, Statistic::Mean, Some(39.5)));
    let [deposit, ranking] = &a.effects[..] else { panic!("two components") };
    assert_eq!((deposit.component.as_str(), ranking.component.as_str()), ("best-so-far-deposit", "ranking"));
    // 20 equal differences: W = 0, z = 105 / √(717.5 − 166.25) = √20, p = 7.7442e-6; times 2 by Holm.
    close(deposit.p, 7.744_2e-6);
    close(deposit.holm, 1.548_84e-5);
    assert_eq!((deposit.finding, deposit.leaning, deposit.without), (Finding::Helps, 1.0, Some(40.5)));
    assert_eq!((deposit.pairs, deposit.finite_pairs, deposit.success), (20, 20, 0.0));
    let means = deposit.means.unwrap();
    assert_eq!((means.value, means.low, means.high), (1.0, 1.0, 1.0));
    // 31 to 50 against 30 to 49: of 400 pairs 19 are equal and 210 larger.
    close(deposit.worse, (210.0 + 9.5) / 400.0);
    assert_eq!((ranking.finding, ranking.p, ranking.holm), (Finding::NotShown, Some(1.0), Some(1.0)));
    assert_eq!((ranking.leaning, ranking.worse), (0.0, Some(0.5)));
}

#[test]
fn a_run_without_a_path_is_worse_than_any() {
    let full = vec![30.0; 20];
    let lost = |n: usize| [vec![f64::INFINITY; n], vec![29.0; 20 - n]].concat();
    // 11 of 20: W⁺ = 165, W⁻ = 45, z = 60 / √(717.5 − 42.5) = 2.3094, p = 0.020921, times 2.
    let a = judged([full.clone(), lost(11), full.clone()]);
    let ranking = &a.effects[0];
    assert_eq!((a.statistic, ranking.component.as_str()), (Statistic::Median, "ranking"));
    close(ranking.holm, 0.041_842);
    close(Some(ranking.leaning), 120.0 / 210.0);
    assert_eq!((ranking.finding, ranking.success, ranking.finite_pairs), (Finding::Helps, -0.55, 9));
    assert_eq!((ranking.without, ranking.medians.unwrap().value), (Some(f64::INFINITY), f64::INFINITY));
    // The nine runs that arrive are shorter; their mean alone would say the opposite.
    assert_eq!(ranking.means.unwrap().value, -1.0);
    // 10 of 20: p = 0.0545.
    assert_eq!(judged([full.clone(), lost(10), full]).effects[0].finding, Finding::NotShown);
}

#[test]
fn without_a_component_that_harms_runs_are_better() {
    let a = judged([vec![30.0; 20], vec![29.0; 20], vec![31.0; 20]]);
    let findings: Vec<Finding> = a.effects.iter().map(|e| e.finding).collect();
    // As large and as clear as each other: in the order of the catalog.
    assert_eq!(findings, [Finding::Harms, Finding::Helps]);
    assert_eq!((a.effects[0].leaning, a.effects[0].worse), (-1.0, Some(0.0)));
}

#[test]
fn the_larger_difference_comes_first() {
    let a = judged([vec![30.0; 20], vec![31.0; 20], vec![34.0; 20]]);
    assert_eq!(a.effects.iter().map(|e| e.component.as_str()).collect::<Vec<_>>(), ["best-so-far-deposit", "ranking"]);
}

#[test]
fn runs_are_paired_by_seed_and_below_twenty_there_is_no_test() {
    let a = judged([vec![30.0; 20], vec![31.0; 19], vec![]]);
    let [ranking, deposit] = &a.effects[..] else { panic!("two components") };
    assert_eq!((ranking.pairs, ranking.p, ranking.finding), (19, None, Finding::TooFew));
    assert_eq!((deposit.pairs, deposit.means, deposit.worse), (0, None, None));
}

#[test]
fn other_questions_are_no_ablations() {
    let mut other = comparison();
    other.question.entries[0].id = "all".into();
    assert_eq!(effects(&Samples::new(&other, [])), []);
    assert_eq!(roles(&other.question), [None, None, None]);
}

#[test]
fn every_entry_has_its_part() {
    let without = |component: &str| Some(AblationRole::Without { component: component.into() });
    let told = roles(&comparison().question);
    assert_eq!(told, [Some(AblationRole::Full), without("ranking"), without("best-so-far-deposit")]);
}

#[test]
fn infinite_numbers_are_null_in_json() {
    let a = judged([vec![30.0; 20], vec![f64::INFINITY; 20], vec![30.0; 20]]);
    let json = serde_json::to_value(&a).unwrap();
    assert_eq!(json["effects"][0]["finding"], "helps");
    assert!(json["effects"][0]["medians"]["value"].is_null() && json["full"] == 30.0);
}
