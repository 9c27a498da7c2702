//! What a repair costs, and what it leaves alone.

use super::*;
use crate::exact::optimum;
use crate::map::{Generator, Grid, Movement, Point, generate};
use crate::planner::Snapshot;

fn search(scenario: &Arc<Scenario>) -> DStarLite {
    let mut search = DStarLite::new(Arc::clone(scenario));
    assert_eq!(search.run(), Status::Optimal);
    search
}

#[test]
fn a_repair_expands_what_has_changed() {
    let made = generate(Generator::Random, 80, 80, 5, 0.3).expect("a map");
    let scenario = Arc::new(Scenario::on(made.grid, Movement::default(), made.start, made.goal).expect("usable"));
    let mut search = search(&scenario);
    let path = search.path();
    let anew = search.effort().cell_expansions;

    // The robot goes 3 steps, and the cell after the next is blocked.
    let mut grid = scenario.grid.clone();
    grid.set_blocked(path[5], true);
    let change = Change { at: 0, blocked: vec![grid.point(path[5])], freed: Vec::new() };
    let to = Arc::new(Scenario::on(grid, Movement::default(), scenario.grid.point(path[3]), made.goal).expect("usable"));
    search.adapt(&change, &to);
    assert_eq!(search.run(), Status::Optimal);
    let spent = search.effort().cell_expansions - anew;
    assert!(spent > 0 && 10 * spent < anew, "{spent} expansions to repair what took {anew}");
    let (found, best) = (search.best().expect("a path").length, optimum(&to).expect("a path"));
    assert!((found - best).abs() < 1e-9, "{found}, not {best}");

    // Nobody asks what lies behind the goal of a robot that is there.
    let freed = Change { at: 0, blocked: Vec::new(), freed: vec![to.grid.point(path[5])] };
    let there = Arc::new(scenario.with_ends(made.goal, scenario.spec.goals.clone()).expect("usable"));
    search.adapt(&freed, &there);
    search.run();
    assert_eq!(search.best().map(|best| (best.path.clone(), best.length)), Some((vec![there.goal], 0.0)));
}

#[test]
fn another_goal_begins_anew() {
    let open = Grid::open(9, 9).expect("a map");
    let to = |start, goal| Arc::new(Scenario::on(open.clone(), Movement::default(), start, goal).expect("usable"));
    let mut search = search(&to(Point::new(0, 0), Point::new(8, 8)));
    search.adapt(&Change { at: 0, blocked: Vec::new(), freed: Vec::new() }, &to(Point::new(3, 0), Point::new(8, 0)));
    let mut copy = search.snapshot();
    assert_eq!((search.run(), search.best().map(|best| best.length)), (Status::Optimal, Some(5.0)));
    copy.run();
    assert_eq!(copy.digest().hex(), search.digest().hex());
}
