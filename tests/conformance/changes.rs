//! Walls that change while a planner is at work: what every planner keeps, whether it adapts or begins anew.

use std::sync::Arc;

use formicarium::catalog;
use formicarium::digest::Digest;
use formicarium::map::{Cell, Movement, Point};
use formicarium::path::{PathKind, audit, audit_slices, points};
use formicarium::planner::playback::Playback;
use formicarium::planner::{Granularity, Layer, Planner, PlannerEntry, Status};
use formicarium::scenario::{Change, Scenario, ScenarioSpec};

use super::{common, everywhere, planner, short};

/// A planner that takes changes; the map has none yet.
fn changing(entry: &PlannerEntry, scenario: &Arc<Scenario>, seed: u32) -> Box<dyn Planner> {
    catalog::build_changing(scenario, entry.id, None, &short(entry), seed).expect("valid parameters")
}

/// Goes on by so many iterations.
fn iterate(planner: &mut dyn Planner, count: u32) {
    for _ in 0..count {
        planner.advance(Granularity::Iteration);
    }
}

/// What a run comes to.
fn end(planner: &dyn Planner) -> (String, String, Status) {
    (planner.digest().hex(), format!("{:?}", planner.history()), planner.status())
}

/// Takes a change of a run that is under way.
fn schedule(planner: &mut dyn Planner, blocked: Vec<Point>, freed: Vec<Point>) -> Change {
    let changing = planner.changing_mut().expect("it takes changes");
    let change = Change { at: changing.next_end(), blocked, freed };
    changing.schedule(change.clone()).expect("cells that can be changed");
    change
}

/// The map that a run is on.
fn map(planner: &dyn Planner) -> &Scenario {
    planner.changing().expect("it takes changes").scenario()
}

/// Cells that can be blocked: of the best path, or else any free ones.
fn blockable(planner: &dyn Planner) -> Vec<Point> {
    let scenario = map(planner);
    let spec = &scenario.spec;
    let path = planner.best().map_or_else(Vec::new, |best| scenario.cells_of(&best.path));
    let mut cells: Vec<Point> = path.into_iter().chain(0..scenario.grid.len() as Cell).map(|c| scenario.grid.point(c)).collect();
    cells
        .retain(|&p| !scenario.grid.is_blocked(scenario.grid.cell(p)) && p != spec.start && spec.goals.iter().all(|g| g.at != p));
    cells.truncate(1);
    cells
}

/// No path crosses a wall of its map.
fn assert_legal(planner: &dyn Planner, what: &str) {
    let (Some(best), scenario) = (planner.best(), map(planner)) else { return };
    if let Some(slices) = scenario.by_slices() {
        let places: Vec<_> = best.path.iter().map(|&p| slices.at(p)).map(|(x, y, level)| (Point::new(x, y), level)).collect();
        audit_slices(scenario, &places).expect(what);
        return;
    }
    let of_steps = best.refined.is_some() || planner.objective().path_kind() == PathKind::Steps;
    let kind = if of_steps { PathKind::Steps } else { PathKind::Polyline };
    audit(scenario, &points(scenario, &best.path), kind).expect(what);
    if let Some(refined) = &best.refined {
        audit(scenario, &points(scenario, &refined.path), PathKind::Polyline).expect(what);
    }
}

#[test]
fn without_changes_a_run_is_as_ever() {
    everywhere(|entry, what, scenario| {
        for by in [Granularity::Iteration, Granularity::Move] {
            let (mut plain, mut other) = (planner(entry, scenario, 5), changing(entry, scenario, 5));
            while !plain.advance(by).is_finished() {
                assert_eq!(other.advance(by), plain.status(), "{what}");
                assert_eq!((other.ant(0), other.turn_of(0)), (plain.ant(0), plain.turn_of(0)), "{what}");
            }
            other.advance(by);
            assert_eq!((end(&*other), other.effort()), (end(&*plain), plain.effort()), "{what}");
        }
    });
}

/// Runs to the end; blocks a cell after 3 iterations, and after 5 frees it and blocks another one. By moves both happen within an iteration.
fn changed_by(planner: &mut dyn Planner, by: Granularity, what: &str) -> Vec<Change> {
    let mut changes: Vec<Change> = Vec::new();
    for at in [3, 5] {
        while planner.effort().iterations < at && !planner.advance(by).is_finished() {}
        if by == Granularity::Move {
            planner.advance(by);
        }
        let freed = changes.first().map_or_else(Vec::new, |change| change.blocked.clone());
        let waits = planner.changing().is_some_and(|c| c.to_come() > 0);
        let blocked = if waits { Vec::new() } else { blockable(planner) };
        if !(blocked.is_empty() && freed.is_empty()) {
            changes.push(schedule(planner, blocked, freed));
        }
        assert_legal(planner, what);
    }
    while !planner.advance(by).is_finished() {
        assert_legal(planner, what);
    }
    assert_legal(planner, what);
    changes
}

#[test]
fn a_run_with_changes_is_repeated_from_their_list_at_any_pace() {
    everywhere(|entry, what, scenario| {
        for live in [Granularity::Iteration, Granularity::Move] {
            let mut run = changing(entry, scenario, 4);
            let changes = changed_by(&mut *run, live, what);
            let spec = ScenarioSpec { changes: changes.clone(), ..scenario.spec.clone() };
            let listed = Arc::new(Scenario::new(scenario.grid.clone(), spec).expect("changes that were made"));
            for by in [Granularity::Iteration, Granularity::Move] {
                let mut again = changing(entry, &listed, 4);
                while !again.advance(by).is_finished() {
                    assert_legal(&*again, what);
                }
                assert_eq!(end(&*again), end(&*run), "{what}: {changes:?} made by {live:?}, repeated by {by:?}");
                assert_eq!(map(&*again).grid, map(&*run).grid, "{what}");
            }
        }
    });
}

#[test]
fn a_snapshot_goes_on_through_changes_and_looking_back_shows_the_map_of_then() {
    everywhere(|entry, what, scenario| {
        for (budget, by) in [(0, Granularity::Iteration), (u32::MAX, Granularity::Iteration), (u32::MAX, Granularity::Move)] {
            let mut run = changing(entry, scenario, 6);
            let mut playback = Playback::new(&*run, budget);
            let mut stood = Vec::new();
            let mut left = 3;
            loop {
                let (iteration, finished) = (run.effort().iterations, run.status().is_finished());
                if left > 0 && (iteration >= 2 || finished) {
                    left -= 1;
                    let blocked = blockable(&*run);
                    if !blocked.is_empty() && run.changing().is_some_and(|c| c.to_come() == 0) {
                        let change = schedule(&mut *run, blocked, Vec::new());
                        playback.change(&*run, &change);
                    }
                } else if finished {
                    break;
                }
                run.advance(by);
                playback.note(&*run, by);
                if by == Granularity::Iteration {
                    stood.push(run.snapshot());
                }
            }
            let ended = end(&*run);
            for mut kept in stood {
                let looked = playback.back_to(kept.effort().iterations, None).into_planner();
                if kept.changing().map(|c| c.made()) == looked.changing().map(|c| c.made()) {
                    assert_eq!(kept.digest().hex(), looked.digest().hex(), "{what}");
                    assert_eq!(map(&*kept).grid, map(&*looked).grid, "{what}");
                }
                kept.run();
                assert!(kept.status().is_finished(), "{what}");
            }
            let looked = playback.back_to(u32::MAX, None).into_planner();
            assert_eq!((end(&*looked).0, end(&*looked).1), (ended.0, ended.1), "{what} by {by:?}");
        }
    });
}

/// A colony on a map of 12 × 12 after five iterations.
fn colony(id: &str) -> Box<dyn Planner> {
    let scenario = common::random(12, 0.15, 3, Movement::default());
    let entry = catalog::find(id).expect("in the catalog");
    let mut colony = changing(entry, &scenario, 2);
    iterate(&mut *colony, 5);
    colony
}

/// τ of every step that is allowed, by cell and next cell.
fn trails(planner: &dyn Planner) -> Vec<(Cell, Cell, f64)> {
    let cells = 0..map(planner).grid.len() as Cell;
    cells.flat_map(|c| planner.moves_from(c).into_iter().map(move |m| (c, m.to, m.trail))).collect()
}

#[test]
fn trails_of_steps_that_stay_are_kept_and_evaporate() {
    let mut colony = colony("ant-system");
    let before = trails(&*colony);
    let blocked = blockable(&*colony);
    schedule(&mut *colony, blocked.clone(), Vec::new());
    let after = trails(&*colony);
    assert!(after.len() < before.len(), "a cell less has fewer steps");
    assert!(after.iter().all(|step| before.contains(step)), "τ is kept to the bit");
    assert!(colony.best().is_none(), "the best path went through the wall");

    colony.advance(Granularity::Iteration);
    let mut visits = Vec::new();
    colony.layer(Layer::Visits, &mut visits);
    let untouched = trails(&*colony).into_iter().filter(|(from, ..)| visits[*from as usize] == 0.0);
    let mut steps = 0;
    for ((from, to, now), (_, _, then)) in
        untouched.map(|step| (step, after.iter().find(|s| (s.0, s.1) == (step.0, step.1)))).filter_map(|(a, b)| Some((a, *b?)))
    {
        assert!((now - 0.5 * then).abs() <= 1e-6 * then, "ρ = 0.5 from {from} to {to}: {then} to {now}");
        steps += 1;
    }
    assert!(steps > 20, "only {steps} steps that no ant took");
}

#[test]
fn the_best_of_the_new_map_begins_with_its_first_iteration() {
    let mut colony = colony("max-min-ant-system");
    let length = colony.best().expect("found").length;
    let blocked = blockable(&*colony);
    schedule(&mut *colony, blocked.clone(), Vec::new());
    colony.advance(Granularity::Iteration);
    let last = colony.history().last().expect("six iterations");
    assert_eq!((last.iteration, last.best_so_far), (6, last.iteration_best));
    // Once it is free again the best path is still allowed and stays: the old one is forgotten.
    let kept = colony.best().map(|best| best.length);
    schedule(&mut *colony, Vec::new(), blocked);
    assert_eq!(colony.best().map(|best| best.length), kept);
    assert!(length > 0.0);
}

#[test]
fn a_goal_that_is_walled_off_ends_a_colony_and_an_opening_lets_it_go_on() {
    let scenario = common::drawn(&["S....", ".....", "....G"], Movement::default());
    let mut colony = changing(catalog::find("ant-system").expect("in the catalog"), &scenario, 1);
    iterate(&mut *colony, 3);
    let wall: Vec<Point> = (0..3).map(|y| Point::new(2, y)).collect();
    schedule(&mut *colony, wall.clone(), Vec::new());
    assert_eq!((colony.status(), colony.best()), (Status::NoPath, None));
    assert_eq!(colony.advance(Granularity::Iteration), Status::NoPath);
    schedule(&mut *colony, Vec::new(), wall);
    assert_eq!(colony.status(), Status::Running);
    assert_eq!(colony.run(), Status::BudgetSpent);
    assert!(colony.best().is_some());
}

#[test]
fn the_order_of_a_changes_cells_is_none_of_the_digests_business() {
    let digest = |order: [u32; 2]| -> Digest {
        let mut colony = colony("ant-system");
        let free = (0..12).map(|x| Point::new(x, 6)).filter(|&p| !map(&*colony).grid.is_blocked(map(&*colony).grid.cell(p)));
        let free: Vec<Point> = free.collect();
        schedule(&mut *colony, order.map(|i| free[i as usize]).to_vec(), Vec::new());
        colony.digest()
    };
    assert_eq!(digest([2, 4]).hex(), digest([4, 2]).hex());
    assert_ne!(digest([2, 4]).hex(), digest([2, 3]).hex());
}

#[test]
fn a_wall_may_come_and_go_within_one_iteration() {
    for entry in ["ant-system", "astar"].map(|id| catalog::find(id).expect("a planner")) {
        let scenario = common::drawn(&["S......", ".......", "......G"], Movement::default());
        let mut run = changing(entry, &scenario, 5);
        let mut playback = Playback::new(&*run, 1 << 20);
        let mut list = Vec::new();
        for _ in 0..3 {
            run.advance(Granularity::Move);
            playback.note(&*run, Granularity::Move);
        }
        let wall = vec![Point::new(3, 1)];
        for (blocked, freed) in [(wall.clone(), vec![]), (vec![], wall.clone()), (wall, vec![])] {
            let change = schedule(&mut *run, blocked, freed);
            playback.change(&*run, &change);
            list.push(change);
        }
        let coming = run.changing().expect("it takes changes").coming();
        assert!(coming.is_blocked(coming.cell(Point::new(3, 1))), "{}", entry.id);
        iterate(&mut *run, 8);
        let mut spec = scenario.spec.clone();
        spec.changes = list;
        let listed = Arc::new(Scenario::new(scenario.grid.clone(), spec).expect("changes that can be made"));
        let mut again = changing(entry, &listed, 5);
        while again.effort().iterations < run.effort().iterations && !again.status().is_finished() {
            again.advance(Granularity::Iteration);
        }
        assert_eq!(end(&*again), end(&*run), "{}", entry.id);
    }
}

#[test]
fn what_cannot_be_changed_is_refused_by_name() {
    let scenario = common::drawn(&["S.#.", "...G"], Movement::default());
    let refused = |changes: Vec<Change>| {
        let spec = ScenarioSpec { changes, ..scenario.spec.clone() };
        Scenario::new(scenario.grid.clone(), spec).expect_err("not possible").report()
    };
    let change = |at, blocked: &[(u32, u32)], freed: &[(u32, u32)]| {
        let points = |cells: &[(u32, u32)]| cells.iter().map(|&(x, y)| Point::new(x, y)).collect();
        Change { at, blocked: points(blocked), freed: points(freed) }
    };
    for (changes, field) in [
        (vec![change(1, &[], &[])], "changes[0]"),
        (vec![change(1, &[(0, 0)], &[])], "changes[0].blocked[0]"),
        (vec![change(1, &[(1, 0), (3, 1)], &[])], "changes[0].blocked[1]"),
        (vec![change(1, &[(2, 0)], &[])], "changes[0].blocked[0]"),
        (vec![change(1, &[(4, 0)], &[])], "changes[0].blocked[0]"),
        (vec![change(1, &[], &[(1, 0)])], "changes[0].freed[0]"),
        (vec![change(1, &[(1, 0), (1, 0)], &[])], "changes[0].blocked[1]"),
        (vec![change(1, &[], &[(2, 0)]), change(2, &[], &[(2, 0)])], "changes[1].freed[0]"),
        (vec![change(5, &[(1, 0)], &[]), change(4, &[], &[(1, 0)])], "changes[1].at"),
    ] {
        let report = refused(changes.clone());
        assert_eq!((report.kind.as_str(), report.field.as_str()), ("change", field), "{changes:?}: {}", report.message);
    }
    let mut colony = changing(catalog::find("ant-system").expect("in the catalog"), &scenario, 1);
    iterate(&mut *colony, 3);
    let late = colony.changing_mut().expect("it takes changes").schedule(change(2, &[(1, 0)], &[]));
    assert_eq!(late.expect_err("the iteration is past").report().field, "changes[0].at");
}

/// What ants see of each step from a cell.
fn seen(planner: &dyn Planner, cell: Cell) -> Vec<(Cell, u64)> {
    planner.moves_from(cell).into_iter().map(|m| (m.to, m.heuristic.to_bits())).collect()
}

#[test]
fn a_wall_is_felt_two_cells_away_and_no_farther() {
    everywhere(|entry, what, scenario| {
        let mut run = changing(entry, scenario, 1);
        iterate(&mut *run, 2);
        let blocked = blockable(&*run);
        if !run.adapts() || blocked.is_empty() {
            return;
        }
        let cells = 0..map(&*run).grid.len() as Cell;
        let before: Vec<_> = cells.clone().map(|c| seen(&*run, c)).collect();
        schedule(&mut *run, blocked.clone(), Vec::new());
        for cell in cells.filter(|&c| seen(&*run, c) != before[c as usize]) {
            let (at, wall) = (map(&*run).grid.point(cell), blocked[0]);
            assert!(at.x.abs_diff(wall.x).max(at.y.abs_diff(wall.y)) <= 2, "{what}: {wall:?} is felt at {at:?}");
        }
    });
}
