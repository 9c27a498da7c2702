//! Liao et al. 2021 (F-RRT*), on trees by hand.

use std::sync::Arc;

use formicarium::catalog;
use formicarium::exact::{Reference, reference};
use formicarium::map::{Cell, CornerRule, Generator, Grid, Movement, Moves, Point, generate};
use formicarium::params::{Value, Values};
use formicarium::path::{PathKind, audit, points};
use formicarium::planner::{Granularity, Layer, Objective, Status};
use formicarium::sampling::f_rrt_star::{FRrtStarParams, create_node, find_reachest, radius};
use formicarium::sampling::tree::Tree;
use formicarium::scenario::Scenario;

use super::close;

/// 6 × 3 cells, a wall in the middle row from (0, 1) to (3, 1), from (0, 0) to (0, 2).
fn bend() -> Scenario {
    let cells: Vec<u8> = [[0; 6], [1, 1, 1, 1, 0, 0], [0; 6]].concat();
    let grid = Grid::from_bytes(6, 3, &cells).expect("a map");
    Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(0, 2)).expect("usable")
}

fn cell(s: &Scenario, x: u32, y: u32) -> Cell {
    s.grid.cell(Point::new(x, y))
}

/// The start, (5, 0) on it, (5, 2) on that.
fn around(s: &Scenario) -> Tree {
    let mut tree = Tree::new(s);
    tree.hang(cell(s, 5, 0), s.start);
    tree.hang(cell(s, 5, 2), cell(s, 5, 0));
    tree
}

#[test]
fn nearest_and_cost_by_hand() {
    let s = bend();
    let tree = around(&s);
    assert!(close(tree.cost(&s, cell(&s, 5, 2)), 7.0) && tree.cost(&s, cell(&s, 1, 2)).is_infinite());
    assert_eq!(tree.way(cell(&s, 5, 2)), [0, 5, 17]);
    // (4, 1) is √2 from both (5, 0) and (5, 2): the one that joined first. A node is not its own nearest.
    assert_eq!(tree.nearest(&s, cell(&s, 4, 1)), Some(5));
    assert_eq!(tree.nearest(&s, cell(&s, 5, 2)), Some(5));
    let mut near = Vec::new();
    tree.near(&s, cell(&s, 5, 1), 1.0, &mut near);
    assert_eq!(near, [5, 17]);
}

#[test]
fn find_reachest_climbs_while_the_sample_is_in_sight() {
    let s = bend();
    let mut tree = around(&s);
    // From (5, 2) to (2, 0): its parent (5, 0) sees it along the row, and the start does.
    assert_eq!(find_reachest(&mut tree, &s, cell(&s, 5, 0), cell(&s, 2, 0)), 0);
    // (0, 2) is hidden from (5, 0) by the wall.
    assert_eq!(find_reachest(&mut tree, &s, cell(&s, 5, 2), cell(&s, 0, 2)), 17);
}

#[test]
fn create_node_by_bisection() {
    let s = bend();
    let mut tree = around(&s);
    // From (5, 2) towards its parent (5, 0): the middle (5, 1) does not see (0, 2), and the bracket is 1 long. From (5, 2) towards (0, 2):
    // (2, 2) and (3, 2) do not see (5, 0), (4, 2) does, and the bracket from (4, 2) to (3, 2) is 1 long.
    assert_eq!(create_node(&mut tree, &s, cell(&s, 5, 2), cell(&s, 0, 2), 1), Some(cell(&s, 4, 2)));
    // A bracket of 3 or less is looked into no further: after (2, 2) it is, and (5, 2) cuts off nothing.
    assert_eq!(create_node(&mut tree, &s, cell(&s, 5, 2), cell(&s, 0, 2), 3), None);
    // The start has no parent.
    assert_eq!(create_node(&mut tree, &s, 0, cell(&s, 2, 0), 1), None);
}

#[test]
fn near_shrinks_as_the_tree_grows_and_is_no_farther_than_a_step() {
    // 100 free cells: γ* = √(3·100/π) = 9.7720502. n = 1: ln 1 = 0. n = 8: √(ln 8 / 8) = 0.5098335, times γ* = 4.9821185.
    let p = FRrtStarParams { near: 1.0, ..FRrtStarParams::default() };
    assert_eq!(radius(&p, 100, 1), 0.0);
    assert!(close(radius(&p, 100, 8), 4.9821185), "{}", radius(&p, 100, 8));
    assert_eq!(radius(&FRrtStarParams { step: 3, ..p }, 100, 8), 3.0);
}

fn built(s: &Arc<Scenario>, values: &[(&str, f64)], seed: u32) -> Box<dyn formicarium::planner::Planner> {
    let values: Values = values.iter().map(|&(key, value)| (key.to_string(), Value::Number(value))).collect();
    catalog::build(s, "f-rrt-star", None, &values, seed).expect("valid")
}

#[test]
fn with_many_samples_it_finds_the_shortest_polyline_around_the_bend() {
    let s = Arc::new(bend());
    // By (4, 0) or (5, 0) and (4, 2): the exact one is the yardstick.
    let Reference::Proven { value: least } = reference(&s, Objective::PolylineLength) else { panic!("a small map") };
    for seed in 1..=5 {
        let mut planner = built(&s, &[], seed);
        assert_eq!(planner.run(), Status::BudgetSpent);
        let best = planner.best().expect("a path");
        assert!((best.length - least).abs() < 1e-9, "seed {seed}: {} instead of {least}", best.length);
        assert_eq!(audit(&s, &points(&s, &best.path), PathKind::Polyline), Ok(()));
        assert_eq!(planner.effort().constructed_paths, 100 * 50);
    }
}

#[test]
fn its_paths_are_legal_under_every_rule_and_get_no_longer() {
    for corner_rule in CornerRule::ALL {
        for moves in [Moves::Four, Moves::Eight] {
            let made = generate(Generator::Random, 24, 20, 3, 0.1).expect("a valid size");
            let s = Arc::new(Scenario::on(made.grid, Movement { moves, corner_rule }, made.start, made.goal).expect("usable"));
            for step in [0.0, 1.0, 5.0] {
                let mut planner = built(&s, &[("step", step), ("iterations", 40.0)], 2);
                let mut last = f64::INFINITY;
                while !planner.advance(Granularity::Iteration).is_finished() {
                    let Some(best) = planner.best() else { continue };
                    assert_eq!(
                        audit(&s, &points(&s, &best.path), PathKind::Polyline),
                        Ok(()),
                        "{corner_rule:?} {moves:?} {step}"
                    );
                    assert!(best.length <= last);
                    last = best.length;
                }
                assert!(moves == Moves::Four || last.is_finite(), "{corner_rule:?} {step}");
            }
        }
    }
}

#[test]
fn the_tree_is_drawn_with_the_way_to_each_of_its_cells() {
    let s = Arc::new(bend());
    let mut planner = built(&s, &[("samples", 1.0), ("goal_bias", 0.0)], 1);
    planner.advance(Granularity::Iteration);
    let mut cost = Vec::new();
    assert!(planner.layer(Layer::Cost, &mut cost));
    assert!(cost[0] == 0.0 && cost.iter().filter(|way| way.is_finite()).count() > 1);
    for (c, &way) in cost.iter().enumerate() {
        // One segment from the start at most: the way is the straight distance.
        let straight = s.grid.point(0).distance(s.grid.point(c as Cell)) as f32;
        assert!(way.is_infinite() || (way - straight).abs() < 1e-6);
    }
}
