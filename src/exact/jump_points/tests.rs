//! Jump points against the A* of the catalog, on maps of every size, density and rule.

use std::sync::Arc;

use super::*;
use crate::exact::{Optima, optima::by_astar};
use crate::map::{Cell, Movement, Moves};
use crate::rng::Streams;
use crate::scenario::Scenario;
use rand::Rng;

/// A whole number below `most`.
fn below(dice: &mut impl Rng, most: u32) -> u32 {
    ((u64::from(dice.next_u32()) * u64::from(most)) >> 32) as u32
}

/// A map of 1 × 1 to 40 × 40 cells with up to 60 % of them blocked, its ends free.
fn drawn(seed: u64, movement: Movement) -> Arc<Scenario> {
    let mut dice = Streams::new(seed, "jump-points", 0).ant(0, 0);
    let (width, height) = (1 + below(&mut dice, 40), 1 + below(&mut dice, 40));
    let percent = below(&mut dice, 61);
    let mut grid = Grid::open(width, height).unwrap();
    for cell in 0..grid.len() as Cell {
        grid.set_blocked(cell, below(&mut dice, 100) < percent);
    }
    let ends = [(); 2].map(|()| below(&mut dice, width * height));
    ends.iter().for_each(|&end| grid.set_blocked(end, false));
    let [start, goal] = ends.map(|end| grid.point(end));
    Arc::new(Scenario::on(grid, movement, start, goal).unwrap())
}

fn bits(length: Option<f64>) -> Option<u64> {
    length.map(f64::to_bits)
}

/// Questions about one map, between any cells, blocked ones too; how many of them have a path.
fn same_as_astar(scenario: &Arc<Scenario>, questions: u32, seed: u64) -> u32 {
    let mut optima = Optima::new(scenario);
    let mut dice = Streams::new(seed, "questions", 0).ant(0, 0);
    let ask = |(start, goal)| {
        let (found, expected) = (optima.between(start, goal), by_astar(scenario, start, goal).0);
        assert_eq!(bits(found), bits(expected), "{found:?} for {expected:?}: {start} to {goal}, {:?}", scenario);
        u32::from(found.is_some())
    };
    let any = |_| [(); 2].map(|()| below(&mut dice, scenario.grid.len() as u32)).into();
    let asked: Vec<(Cell, Cell)> = std::iter::once((scenario.start, scenario.goal)).chain((0..questions).map(any)).collect();
    asked.into_iter().map(ask).sum()
}

#[test]
fn lengths_have_the_bits_of_astar() {
    let mut with_path = 0;
    for seed in 0..400 {
        for corner_rule in CornerRule::ALL {
            with_path += same_as_astar(&drawn(seed, Movement { moves: Moves::Eight, corner_rule }), 12, seed);
        }
        let four = Movement { moves: Moves::Four, corner_rule: CornerRule::BothFree };
        with_path += same_as_astar(&drawn(seed, four), 2, seed);
    }
    assert!(with_path > 4000, "{with_path} questions have a path");
}

#[test]
fn sixteen_moves_and_terrains_are_answered_by_astar() {
    for seed in 0..20 {
        let scenario = drawn(seed, Movement { moves: Moves::Sixteen, corner_rule: CornerRule::BothFree });
        assert!(Optima::new(&scenario).jump_points.is_none());
        same_as_astar(&scenario, 2, seed);
        let heights: Vec<f32> = (0..scenario.grid.len()).map(|k| (k % 7) as f32).collect();
        let grid = scenario.grid.clone().with_heights(heights).unwrap();
        let [start, goal] = [scenario.start, scenario.goal].map(|end| grid.point(end));
        let scenario = Arc::new(Scenario::on(grid, Movement::default(), start, goal).unwrap());
        assert!(Optima::new(&scenario).jump_points.is_none());
        same_as_astar(&scenario, 2, seed);
    }
}

#[test]
fn directions_are_those_of_the_map() {
    for d in 0..DIRECTIONS as Direction {
        assert_eq!(direction(offset(d)), d);
    }
}

#[test]
fn an_open_map_is_answered_without_a_jump_point() {
    let grid = Grid::open(300, 200).unwrap();
    let mut search = JumpPoints::new(&grid, CornerRule::BothFree);
    assert_eq!(search.shortest(Point::new(3, 5), Point::new(280, 150)), Some(counted_length(132, 145)));
    assert_eq!(search.expansions(), 1);
}
