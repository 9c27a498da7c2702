//! Snapshots: what they weigh, which are kept, and what a cell's moves are worth, by hand.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell as Counter;
use std::sync::Arc;

use common::{drawn, random, tours};
use formicarium::catalog::{self, CATALOG};
use formicarium::map::Movement;
use formicarium::params::{Value, Values};
use formicarium::planner::playback::Playback;
use formicarium::planner::{Granularity, Planner, PlannerEntry};
use formicarium::scenario::Scenario;

/// Counts the bytes that this thread holds.
struct Scales;

thread_local! {
    static HELD: Counter<isize> = const { Counter::new(0) };
}

/// What the allocator was asked for and has not been given back.
fn held() -> isize {
    HELD.with(Counter::get)
}

fn add(bytes: isize) {
    let _ = HELD.try_with(|held| held.set(held.get() + bytes));
}

// SAFETY: passes everything on to the system's allocator.
unsafe impl GlobalAlloc for Scales {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        add(layout.size() as isize);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        add(-(layout.size() as isize));
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static SCALES: Scales = Scales;

fn built(entry: &PlannerEntry, scenario: &Arc<Scenario>, numbers: &[(&str, f64)]) -> Box<dyn Planner> {
    let known = |key: &str| (entry.specs)().iter().any(|s| s.key == key);
    let values: Values =
        numbers.iter().filter(|(key, _)| known(key)).map(|&(key, v)| (key.to_string(), Value::Number(v))).collect();
    catalog::build(scenario, entry.id, None, &values, 1).expect("valid parameters")
}

fn planner(id: &str, scenario: &Arc<Scenario>, numbers: &[(&str, f64)]) -> Box<dyn Planner> {
    built(catalog::find(id).expect("in the catalog"), scenario, numbers)
}

#[test]
fn a_snapshot_holds_what_it_says() {
    let movement = Movement::default();
    let mut scenarios = vec![random(40, 0.2, 3, movement)];
    scenarios.extend(tours(movement).into_iter().map(|(_, scenario)| scenario));
    for entry in CATALOG {
        for scenario in scenarios.iter().filter(|s| s.goals.len() <= entry.max_goals as usize) {
            if !entry.grounds.contains(&formicarium::planner::Ground::of(scenario)) {
                continue;
            }
            let mut planner = built(entry, scenario, &[("ants", 12.0), ("iterations", 8.0), ("seed_iterations", 4.0)]);
            for step in 0..12 {
                let before = held();
                let snapshot = planner.snapshot();
                let (weighed, told) = ((held() - before) as f64, snapshot.bytes() as f64);
                // What it does not count: a path of a seed, the map's share in small buffers.
                let slack = 0.02 * weighed + 1024.0;
                assert!((weighed - told).abs() <= slack, "{} at step {step}: {told} told, {weighed} weighed", entry.id);
                drop(snapshot);
                planner.advance(if step % 3 == 0 { Granularity::Move } else { Granularity::Iteration });
            }
        }
    }
}

/// Runs to the end with a playback beside it.
fn played(planner: &mut dyn Planner, budget: u32, by: Granularity) -> Playback {
    let mut playback = Playback::new(planner, budget);
    while !planner.advance(by).is_finished() {
        playback.note(planner, by);
    }
    playback.note(planner, by);
    playback
}

#[test]
fn a_small_budget_keeps_fewer_snapshots_and_never_more_bytes() {
    let scenario = random(24, 0.2, 7, Movement::default());
    let rows = [("iterations", 600.0), ("ants", 200.0)];
    let mut last = u32::MAX;
    for budget in [u32::MAX, 1_200_000, 600_000] {
        let mut colony = planner("ant-system", &scenario, &rows);
        let kept = played(&mut *colony, budget, Granularity::Iteration).summary();
        assert!(kept.bytes <= budget && kept.snapshots < last && kept.snapshots >= 3, "{kept:?}");
        assert_eq!(kept.stride > 1, budget < u32::MAX, "{kept:?}");
        assert!(kept.stride.is_power_of_two() && kept.most_repeated < 600, "{kept:?}");
        last = kept.snapshots;
    }
}

#[test]
fn a_planner_larger_than_the_budget_keeps_its_beginning_alone() {
    let scenario = random(24, 0.2, 7, Movement::default());
    let mut colony = planner("ant-system", &scenario, &[("iterations", 60.0), ("ants", 40.0)]);
    let playback = played(&mut *colony, 20_000, Granularity::Iteration);
    let kept = playback.summary();
    assert_eq!((kept.snapshots, kept.most_repeated), (1, 60));
    let back = playback.back_to(60, None).into_planner();
    assert_eq!(back.digest().hex(), colony.digest().hex());
}

#[test]
fn a_replay_goes_in_slices() {
    let scenario = random(24, 0.2, 7, Movement::default());
    let mut colony = planner("ant-system", &scenario, &[("iterations", 50.0)]);
    let playback = played(&mut *colony, 0, Granularity::Iteration);
    let mut replay = playback.back_to(25, None);
    let slices = (0..).take_while(|_| !replay.go_on(10)).count();
    assert_eq!(slices, 2);
    assert_eq!(replay.into_planner().effort().iterations, 25);
}

/// Start in a corner of 3 × 3 free cells, goal in the opposite one; α = 1, β = 2, η = 1/d(j, goal).
fn corner(scenario: &Arc<Scenario>) -> Box<dyn Planner> {
    let heuristic = ("heuristic".to_string(), Value::Text("goal".into()));
    let numbers = [("ants", 1.0), ("alpha", 1.0), ("beta", 2.0), ("rho", 0.5), ("deposit", 1.0)];
    let values: Values = numbers.iter().map(|&(k, v)| (k.to_string(), Value::Number(v))).chain([heuristic]).collect();
    catalog::build(scenario, "ant-system", None, &values, 1).expect("valid parameters")
}

/// E and S are √5 from the goal, SE √2: η² = 1/5, 1/5, 1/2, whose sum is 9/10. With τ = 1 everywhere p = 2/9, 2/9, 5/9.
#[test]
fn moves_of_ant_system_by_hand() {
    let scenario = drawn(&["S..", "...", "..G"], Movement::default());
    let mut colony = corner(&scenario);
    let (e, s, se) = (1, 3, 4);
    let moves = colony.moves_from(scenario.start);
    assert_eq!(moves.iter().map(|m| m.to).collect::<Vec<_>>(), [e, s, se]);
    for (m, (eta, p)) in moves.iter().zip([(5f64, 2.0 / 9.0), (5.0, 2.0 / 9.0), (2.0, 5.0 / 9.0)]) {
        assert_eq!((m.colony, m.trail), (0, 1.0));
        assert!((m.heuristic - 1.0 / eta.sqrt()).abs() < 1e-12 && (m.probability - p).abs() < 1e-6, "{m:?}");
    }
    assert!(colony.moves_from(scenario.goal).is_empty());

    // One ant has walked: half of every trail has left, and 1/L lies on its first step.
    colony.advance(Granularity::Iteration);
    let best = colony.best().expect("nothing is in its way").clone();
    let tau = |to| 0.5 + if best.path[1] == to { 1.0 / best.length } else { 0.0 };
    let weight = |to, eta2: f64| tau(to) * eta2;
    let sum = weight(e, 0.2) + weight(s, 0.2) + weight(se, 0.5);
    for m in colony.moves_from(scenario.start) {
        let expected = weight(m.to, if m.to == se { 0.5 } else { 0.2 }) / sum;
        assert!((m.trail - tau(m.to)).abs() < 1e-6 && (m.probability - expected).abs() < 1e-6, "{m:?}");
    }
}

/// By [`moves_of_ant_system_by_hand`] SE has 5/9; with q0 = 0.9 and β = 2 it has 0.9 + 0.1·5/9, E and S 0.1·2/9 each.
#[test]
fn the_share_of_exploitation_is_in_the_probability() {
    let scenario = drawn(&["S..", "...", "..G"], Movement::default());
    let heuristic = ("heuristic".to_string(), Value::Text("goal".into()));
    let values: Values =
        [("q0", 0.9), ("beta", 2.0)].iter().map(|&(k, v)| (k.to_string(), Value::Number(v))).chain([heuristic]).collect();
    let colony = catalog::build(&scenario, "ant-colony-system", None, &values, 1).expect("valid parameters");
    let odds: Vec<f64> = colony.moves_from(scenario.start).iter().map(|m| m.probability).collect();
    for (found, expected) in odds.iter().zip([0.2 / 9.0, 0.2 / 9.0, 0.9 + 0.5 / 9.0]) {
        assert!((found - expected).abs() < 1e-6, "{odds:?}");
    }
}

#[test]
fn walls_and_places_beyond_the_map_have_no_moves() {
    let scenario = drawn(&["S#.", "..G"], Movement::default());
    let colony = planner("ant-system", &scenario, &[]);
    for cell in [1, 6, u32::MAX] {
        assert!(colony.moves_from(cell).is_empty(), "{cell}");
    }
}
