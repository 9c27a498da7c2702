//! A look ahead changes nothing, and what it shows is what the run does then.
#![cfg(not(target_arch = "wasm32"))]

mod common;
#[path = "common/terrains.rs"]
mod terrains;

use std::sync::Arc;

use formicarium::catalog;
use formicarium::drawn::{Standing, standing, towards};
use formicarium::error::DrawnError;
use formicarium::map::{CornerRule, Measure, Movement, Moves, Point};
use formicarium::metrics::Metrics;
use formicarium::params::{Value, Values};
use formicarium::path::Flaw;
use formicarium::planner::ahead::Ahead;
use formicarium::planner::{Family, Fate, Granularity, Ground, Layer, Objective, Planner, PlannerEntry};
use formicarium::scenario::Scenario;

use common::{drawn, gallery, random, with_goals};

fn planner(id: &str, scenario: &Arc<Scenario>) -> Box<dyn Planner> {
    let few = [("ants", 6.0), ("iterations", 8.0)];
    let entry = catalog::find(id).expect("in the catalog");
    let keys: Vec<_> = (entry.specs)().iter().map(|spec| spec.key).collect();
    let values: Values = few.iter().filter(|(k, _)| keys.contains(k)).map(|&(k, v)| (k.to_string(), Value::Number(v))).collect();
    catalog::build(scenario, id, None, &values, 5).expect("valid parameters")
}

/// Everything that a run could have changed, as far as it shows.
fn standing_of(planner: &dyn Planner) -> (String, u64, Vec<u32>, Vec<f32>) {
    let (mut ants, mut trails) = (Vec::new(), Vec::new());
    planner.ants(&mut ants);
    planner.layer(Layer::Trail, &mut trails);
    (planner.digest().hex(), planner.effort().ant_moves, ants, trails)
}

/// Follows every ant through one iteration of a run: each turn is looked at before the run makes the move, and holds afterwards.
fn follow_an_iteration(what: &str, run: &mut dyn Planner) -> u32 {
    let begun = run.effort().iterations;
    let mut seen = 0;
    let mut ahead = Ahead::of(run);
    while run.effort().iterations == begun && !run.status().is_finished() {
        let before = standing_of(run);
        let turns: Vec<_> = (0..).map_while(|ant| run.turn_of(ant)).collect();
        assert!(standing_of(run) == before, "{what}: looking has changed the run");
        for (ant, turn) in (0..).zip(&turns) {
            assert_eq!(ahead.turn(ant).as_ref(), Some(turn), "{what}: ant {ant} of the copy");
        }
        run.advance(Granularity::Move);
        ahead.go_to(ahead.moves() + 1);
        for (ant, turn) in (0..).zip(turns) {
            let now = run.ant(ant).expect("the ant is there");
            let sum: f64 = turn.odds.iter().map(|m| m.probability).sum();
            let is_open = turn.odds.iter().any(|m| m.weight > 0.0);
            assert!((sum - if is_open { 1.0 } else { 0.0 }).abs() < 1e-9, "{what}: ant {ant}: {sum}");
            match turn.next {
                Some(next) => assert_eq!(now.way.last(), Some(&next), "{what}: ant {ant}"),
                None => assert_eq!(now.way, turn.walked.way, "{what}: ant {ant}"),
            }
            if let (Some(next), true) = (turn.next, is_open) {
                let taken = turn.odds.iter().find(|m| m.to == next).expect("it takes what it weighs");
                assert!(taken.probability > 0.0 && taken.weight > 0.0, "{what}: ant {ant}: {taken:?}");
                assert!(!turn.walked.way.contains(&next), "{what}: ant {ant} goes where it was");
                seen += 1;
            }
        }
    }
    assert!(ahead.is_over(), "{what}");
    assert_eq!(ahead.turn(0).map(|turn| turn.walked), run.ant(0), "{what}: at the end");
    seen
}

fn with_ants() -> impl Iterator<Item = &'static PlannerEntry> {
    catalog::CATALOG.iter().copied().filter(|entry| entry.family == Family::AntColony)
}

fn takes(entry: &PlannerEntry, scenario: &Scenario) -> bool {
    scenario.goals.len() as u32 <= entry.max_goals && entry.grounds.contains(&Ground::of(scenario))
}

fn by_slices() -> Arc<Scenario> {
    terrains::hilly_slices(10, 7, 1, terrains::rules(Measure::Cost))
}

#[test]
fn every_ant_does_what_the_look_ahead_shows() {
    let mut maps = gallery(Movement::default());
    maps.push(("tour", with_goals(&random(12, 0.1, 3, Movement::default()), &[(11, 0), (0, 11), (11, 11)])));
    maps.extend([("slices", by_slices()), ("ridge", terrains::ridge(Measure::Cost))]);
    for entry in with_ants() {
        for (name, scenario) in maps.iter().filter(|(_, s)| takes(entry, s)) {
            let what = format!("{} on {name}", entry.id);
            let mut run = planner(entry.id, scenario);
            // The order of a tour is chosen, and the first stage of a hybrid passed, before ants walk.
            while run.turn_of(0).is_none() && !run.status().is_finished() {
                run.advance(Granularity::Move);
            }
            for _ in 0..2 {
                let seen = follow_an_iteration(&what, &mut *run);
                let sets_out = scenario.moves.all_bits(scenario.start) != 0 && !run.status().is_finished();
                assert!(seen > 0 || !sets_out, "{what}: no ant moved");
            }
        }
    }
}

#[test]
fn a_run_that_was_looked_into_ends_as_one_that_was_not() {
    let maps = [random(16, 0.2, 7, Movement::default()), by_slices()];
    for (entry, scenario) in with_ants().flat_map(|entry| maps.iter().filter(|s| takes(entry, s)).map(move |s| (entry, s))) {
        let (mut looked, mut left) = (planner(entry.id, scenario), planner(entry.id, scenario));
        while !looked.status().is_finished() {
            for ant in [0, 3, 5] {
                let _ = looked.turn_of(ant);
            }
            looked.advance(Granularity::Move);
        }
        left.run();
        assert_eq!(looked.digest().hex(), left.digest().hex(), "{}", entry.id);
    }
}

#[test]
fn planners_without_ants_and_numbers_beyond_the_last_have_no_turn() {
    let scenario = random(12, 0.1, 1, Movement::default());
    for entry in catalog::CATALOG.iter().filter(|e| e.family != Family::AntColony && e.max_goals == 1) {
        if let Ok(run) = catalog::build(&scenario, entry.id, None, &Values::new(), 1) {
            assert!(run.turn_of(0).is_none() && run.ant(0).is_none(), "{}", entry.id);
        }
    }
    let mut run = planner("ant-system", &scenario);
    assert!(run.turn_of(6).is_none() && run.ant(0).is_none() && run.turn_of(5).is_some());
    run.run();
    assert!(run.turn_of(0).is_none(), "it has ended");
    assert!(run.ant(0).is_some(), "the walks of the last iteration are there");
}

/// In a corridor of dead ends an ant that steps back is not said to choose.
#[test]
fn at_a_dead_end_nothing_is_weighed() {
    let scenario = drawn(&["S.#", ".##", "..G"], Movement { moves: Moves::Four, corner_rule: CornerRule::Always });
    let mut run = planner("ant-system", &scenario);
    let mut back = 0;
    for _ in 0..40 {
        for turn in (0..6).filter_map(|ant| run.turn_of(ant)).filter(|turn| turn.walked.fate == Fate::Walking) {
            if turn.odds.iter().all(|m| m.weight == 0.0) {
                let way = &turn.walked.way;
                assert!(turn.next.is_none() || turn.next == way.get(way.len().wrapping_sub(2)).copied(), "{turn:?}");
                back += 1;
            }
        }
        run.advance(Granularity::Move);
    }
    assert!(back > 0, "some ant has tried the dead end");
}

#[test]
fn a_look_ahead_stops_at_the_end_of_its_iteration() {
    let scenario = random(12, 0.1, 1, Movement::default());
    let mut run = planner("ant-colony-system", &scenario);
    run.advance(Granularity::Iteration);
    let mut ahead = Ahead::of(&*run);
    assert!(ahead.ants().is_empty() && !ahead.is_over());
    let made = ahead.go_to(u32::MAX);
    assert!(ahead.is_over() && made > 0 && ahead.go_to(u32::MAX) == made);
    assert_eq!(ahead.ants().len(), 6);
    assert_eq!((ahead.from(), run.effort().iterations), (1, 1));
}

fn points(cells: &[(u32, u32)]) -> Vec<Point> {
    cells.iter().map(|&(x, y)| Point::new(x, y)).collect()
}

/// East, east, then twice south-east: 2 + 2√2, one turn, of √2 cells.
#[test]
fn a_drawn_path_is_measured_as_planners_are() {
    let scenario = drawn(&["S....", ".....", "....G"], Movement::default());
    let path = points(&[(0, 0), (1, 0), (2, 0), (3, 1), (4, 2)]);
    assert_eq!(standing(&scenario, &path), Standing::Complete);
    let cells: Vec<u32> = path.iter().map(|&at| scenario.grid.cell(at)).collect();
    let metrics = Metrics::of(&scenario, &cells);
    let length = 2.0 + 2.0 * 2f64.sqrt();
    assert!((metrics.length - length).abs() < 1e-12 && metrics.turns == 1);
    assert_eq!(Objective::Length.of_steps(&metrics), Some(metrics.length));
    let turn_index = Objective::TurnIndex.of_steps(&metrics).expect("the path decides it");
    assert!((turn_index - (length + 0.2 * 2f64.sqrt())).abs() < 1e-12);
    assert_eq!(Objective::TourWeight.of_steps(&metrics), None);

    // The best path of a search, drawn by hand, has the search's value.
    let mut search = catalog::build(&scenario, "astar", None, &Values::new(), 1).expect("valid");
    search.run();
    let best = search.best().expect("a path exists");
    assert_eq!(Metrics::of(&scenario, &best.path).length, best.length);
}

#[test]
fn a_drawn_path_is_unfinished_or_flawed_until_it_is_complete() {
    let scenario = drawn(&["S.#", "..G"], Movement::default());
    assert_eq!(standing(&scenario, &points(&[(0, 0), (1, 1)])), Standing::Unfinished(Point::new(2, 1)));
    assert_eq!(standing(&scenario, &[]), Standing::Flawed(Flaw::Empty));
    let through = points(&[(0, 0), (1, 0), (2, 0), (2, 1)]);
    assert_eq!(standing(&scenario, &through), Standing::Flawed(Flaw::Collision { index: 2, at: Point::new(2, 0) }));
}

#[test]
fn a_hand_goes_straight_on_by_allowed_steps_alone() {
    let free = drawn(&["S....", ".....", "....G"], Movement::default());
    let way = towards(&free, Point::new(0, 0), Point::new(4, 2)).expect("nothing is in its way");
    let mut path = vec![Point::new(0, 0)];
    path.extend(&way);
    assert_eq!(standing(&free, &path), Standing::Complete);

    let walled = drawn(&["S#.", ".#.", "..G"], Movement { moves: Moves::Eight, corner_rule: CornerRule::BothFree });
    let [start, wall] = [Point::new(0, 0), Point::new(1, 0)];
    assert_eq!(towards(&walled, start, wall), Err(DrawnError::Blocked { x: 1, y: 0 }));
    assert_eq!(towards(&walled, start, Point::new(3, 0)), Err(DrawnError::Outside { x: 3, y: 0 }));
    assert_eq!(towards(&walled, start, Point::new(2, 0)), Err(DrawnError::NoWay { x: 0, y: 0, to_x: 2, to_y: 0 }));
    // The corner of the wall may not be cut: the hand must go around it.
    assert!(towards(&walled, Point::new(0, 1), Point::new(1, 2)).is_ok_and(|way| way.len() == 2));
    assert_eq!(towards(&walled, start, start), Ok(Vec::new()));
}
