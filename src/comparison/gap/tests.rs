//! What a run tells of itself on a map whose numbers are known by hand.

use std::sync::Arc;

use serde_json::json;

use super::*;
use crate::comparison::Question;
use crate::comparison::question::Published;
use crate::comparison::row::{Found, Spent, Task};
use crate::map::{Generator, Movement, Point, SliceRules, generate};
use crate::planner::Status;
use crate::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec, Vehicle};

/// Half a metre a cell, a quarter of a metre a second, three seconds a turn.
fn comparison(by_slices: bool) -> Comparison {
    let question: Question = serde_json::from_value(json!({
        "format": "formicarium/question@1", "title": "t", "asks": "?", "seeds": { "from": 1, "count": 1 },
        "instances": [{ "id": "map", "map": "m.json" }],
        "entries": [{ "id": "ants", "label": "ants", "role": "other", "planner": if by_slices { "slices-exact" } else { "ant-system" } }],
    }))
    .unwrap();
    let made = generate(Generator::Hills, 6, 6, 1, 0.5).unwrap();
    let (start, goal) = (Point::new(0, 0), Point::new(5, 5));
    let mut terrain = TerrainSpec::default();
    if by_slices {
        terrain.moves = TerrainMoves::Slices(SliceRules::fitting_map(&made.grid, 1.0, start, goal, None));
    }
    let vehicle = Vehicle { speed: 0.25, seconds_per_turn: 3.0, ..Vehicle::default() };
    let own = made.spec("m");
    let spec = ScenarioSpec { resolution: 0.5, vehicle, terrain: Some(terrain), movement: Movement::default(), ..own };
    Comparison::new(question, vec![Arc::new(Scenario::new(made.grid, spec).unwrap())]).unwrap()
}

fn row(path: Option<(f64, Option<u32>)>) -> Row {
    let found = path.map(|(length, turns)| Found {
        length,
        turns,
        turn_index: None,
        weight: None,
        value: length,
        driving: None,
        clearance: None,
    });
    let task = Task { instance: 0, entry: 0, seed: 1 };
    Row { task, status: Status::BudgetSpent, found, effort: Spent::default(), trace: Vec::new(), digest: String::new() }
}

#[test]
fn a_run_arrives_after_its_metres_and_its_turns() {
    let time = |by_slices, path| comparison(by_slices).value(&row(path), RunMeasure::ArrivalTime);
    // 7 cells are 3.5 m and 14 s, 2 turns 6 s.
    assert_eq!(time(false, Some((7.0, Some(2)))), Some(20.0));
    assert_eq!(time(false, Some((7.0, None))), None, "a run from elsewhere that tells no turns");
    assert_eq!(time(false, None), Some(f64::INFINITY));
    assert_eq!(time(true, Some((7.0, Some(2)))), None, "by slices the levels' metres are not told");
    let beside = Row { task: Task { instance: 1, ..row(None).task }, ..row(None) };
    assert_eq!(comparison(false).value(&beside, RunMeasure::ArrivalTime), None);
}

#[test]
fn every_run_arrives_when_its_path_does() {
    let comparison = comparison(false);
    let run = comparison.run(Task { instance: 0, entry: 0, seed: 1 }, &mut || 0.0).unwrap().row;
    let found = run.found.unwrap();
    let by_hand = found.length * 0.5 / 0.25 + 3.0 * f64::from(found.turns.unwrap());
    assert_eq!(comparison.value(&run, RunMeasure::ArrivalTime), Some(by_hand));
    assert!(!run.to_line().contains("arrival"), "no row of before gains a field");
}

#[test]
fn a_published_arrival_time_is_told_only_where_there_is_one() {
    assert!(!serde_json::to_string(&Published::default()).unwrap().contains("arrival_time"));
    let published: Published = serde_json::from_value(json!({ "arrival_time": 464.0 })).unwrap();
    assert_eq!(RunMeasure::ArrivalTime.published(&published), Some(464.0));
    assert!((RunMeasure::ArrivalTime.relevant() - RunMeasure::Length.relevant()).abs() < 1e-12);
}
