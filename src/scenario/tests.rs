//! Other ends on the same map.

use super::*;

fn at(x: u32, y: u32) -> Point {
    Point::new(x, y)
}

fn goal(x: u32, y: u32) -> Vec<Goal> {
    vec![Goal::new(at(x, y), "")]
}

/// 4 × 3 cells with a wall at (1, 0).
fn scenario() -> Scenario {
    let grid = Grid::from_bytes(4, 3, &[0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]).unwrap();
    Scenario::on(grid, Movement::default(), at(0, 0), at(3, 2)).unwrap()
}

#[test]
fn other_ends_are_as_validated_anew() {
    let scenario = scenario();
    let cases = [
        (at(2, 1), goal(0, 2)),
        (at(2, 1), goal(2, 1)),
        (at(1, 0), goal(0, 2)),
        (at(4, 0), goal(0, 2)),
        (at(0, 0), goal(1, 0)),
        (at(0, 0), Vec::new()),
        (at(0, 0), [goal(2, 2), goal(2, 2)].concat()),
        (at(0, 0), vec![Goal { area: -1.0, ..Goal::new(at(2, 2), "") }]),
        (at(0, 0), [goal(2, 2), goal(3, 2)].concat()),
    ];
    for (start, goals) in cases {
        let spec = ScenarioSpec { start, goals: goals.clone(), ..scenario.spec.clone() };
        let anew = Scenario::new(scenario.grid.clone(), spec);
        let parts = |s: Scenario| (s.spec, s.start, s.goal, s.goals, s.moves.bits);
        let shared = scenario.with_ends(start, goals);
        assert_eq!(shared.map(parts).map_err(|e| e.to_string()), anew.map(parts).map_err(|e| e.to_string()));
    }
}

#[test]
fn other_ends_share_the_steps_and_a_changed_map_does_not() {
    let scenario = scenario();
    let other = scenario.with_ends(at(2, 1), goal(0, 2)).unwrap();
    assert!(Arc::ptr_eq(&scenario.moves.bits, &other.moves.bits));
    let mut grid = other.grid.clone();
    grid.set_blocked(5, true);
    assert!(grid.is_blocked(5) && !scenario.grid.is_blocked(5) && !other.grid.is_blocked(5));
}

#[cfg(feature = "whole")]
#[test]
fn changes_spare_other_ends_too() {
    let mut spec = scenario().spec;
    spec.changes = vec![Change { at: 1, blocked: vec![at(2, 2)], freed: vec![] }];
    let scenario = Scenario::new(scenario().grid, spec).unwrap();
    assert!(scenario.with_ends(at(3, 0), goal(0, 2)).is_ok());
    let error = scenario.with_ends(at(2, 2), goal(0, 2)).unwrap_err();
    assert!(error.to_string().contains("changes[0].blocked[0]"), "{error}");
}

#[cfg(feature = "whole")]
#[test]
fn changes_leave_a_robot_its_room() {
    let grid = Grid::open(6, 5).unwrap();
    let mut spec = ScenarioSpec::new(&grid, at(0, 0), at(5, 4));
    spec.robot = Some(Robot { radius: 1.0, inflation: None });
    let walled = |x, y| {
        let changes = vec![Change { at: 0, blocked: vec![at(x, y)], freed: vec![] }];
        Scenario::new(grid.clone(), ScenarioSpec { changes, ..spec.clone() }).map(drop).map_err(|e| e.to_string())
    };
    for beside in [(1, 0), (0, 1), (4, 4), (5, 3)] {
        let error = walled(beside.0, beside.1).unwrap_err();
        assert!(error.contains("changes[0].blocked[0]") && error.contains("room"), "{error}");
    }
    assert_eq!((walled(1, 1), walled(2, 0)), (Ok(()), Ok(())), "no nearer than the radius");
}
