//! The search against Held and Karp's dynamic programming, on complete graphs of every kind.

use super::super::{Costs, Shape, Ways, held_karp};
use super::OrderSearch;
use crate::rng::Streams;
use rand::Rng;

const SHAPES: [Shape; 2] = [Shape::Open, Shape::Closed];

/// A graph of 2 to 12 nodes: points of the plane, some of them equal; lengths that many share; whole numbers, some 0; costs of two directions.
fn drawn(seed: u32) -> Costs {
    let mut stream = Streams::new(seed.into(), "orders", 0).ant(1, 1);
    let mut below = |n: u32| stream.next_u32() % n;
    let nodes = 2 + below(11) as usize;
    let at: Vec<(f64, f64)> = (0..nodes).map(|_| (f64::from(below(40)), f64::from(below(7)))).collect();
    let numbers: Vec<u32> = (0..nodes * nodes).map(|_| below(1000)).collect();
    let number = |i: usize, j: usize| f64::from(numbers[i * nodes + j]);
    Costs::new(nodes, |i, j| {
        let ((x, y), (other_x, other_y)) = (at[i], at[j]);
        let (a, b) = (i.min(j), i.max(j));
        match seed % 5 {
            0 => libm::hypot(x - other_x, y - other_y),
            1 => (x - other_x).abs() + std::f64::consts::SQRT_2 * (y - other_y).abs(),
            2 => (number(a, b) - 300.0).max(0.0),
            3 => number(i, j) / 7.0,
            _ => libm::hypot(x - other_x, y - other_y) / (1.0 + number(0, j)),
        }
    })
}

/// The goals in the order of their numbers.
fn plain(costs: &Costs) -> Vec<u32> {
    (0..costs.nodes() as u32 - 1).collect()
}

#[test]
fn bounds_are_below_the_best_order_and_orders_are_the_best() {
    let (mut proven_at_once, mut all) = (0, 0);
    for (seed, shape) in (0..400).flat_map(|seed| SHAPES.map(|shape| (seed, shape))) {
        let costs = drawn(seed);
        let least = costs.total(&held_karp(&costs, shape).expect("few goals"), shape);
        let mut search = OrderSearch::new(&costs, shape, &plain(&costs)).expect("finite costs");
        assert!(search.lower_bound() <= least && least <= search.cost() + 1e-9, "seed {seed}, {shape:?}");
        let mut bound = 0.0;
        while !search.is_proven() {
            search.step(u64::MAX);
            assert!(search.is_proven() || search.lower_bound() <= least, "seed {seed}, {shape:?}: {}", search.lower_bound());
            assert!(search.lower_bound() >= bound, "seed {seed}, {shape:?}");
            bound = search.lower_bound();
            all += 1;
        }
        proven_at_once += u32::from(search.parts <= 1);
        assert!((search.cost() - least).abs() < 1e-9, "seed {seed}, {shape:?}: {} {least}", search.cost());
        assert_eq!(search.cost(), costs.total(search.order(), shape));
        assert_eq!(search.lower_bound(), search.cost());
        let mut goals = search.order().to_vec();
        goals.sort_unstable();
        assert_eq!(goals, plain(&costs), "seed {seed}, {shape:?}");
    }
    println!("{proven_at_once} of 800 by the first bound, {all} steps");
}

#[test]
fn whole_costs_are_proven_exactly() {
    for seed in (0..60).map(|k| 5 * k + 2) {
        let costs = drawn(seed);
        for shape in SHAPES {
            let least = costs.total(&held_karp(&costs, shape).expect("few goals"), shape);
            let mut search = OrderSearch::new(&costs, shape, &plain(&costs)).expect("finite costs");
            search.go_on(1);
            assert!(search.lower_bound() <= least && search.lower_bound().fract() == 0.0);
            assert!(search.go_on(u64::MAX));
            assert_eq!(search.cost(), least, "seed {seed}, {shape:?}");
        }
    }
}

#[test]
fn a_merged_order_is_the_best_of_the_ways_that_were_gone() {
    // On a line, two orders that go each half well: together they go all of it well.
    let costs = Costs::new(9, |i, j| i.abs_diff(j) as f64);
    let halves = [vec![0, 1, 2, 3, 7, 4, 6, 5], vec![3, 0, 2, 1, 4, 5, 6, 7], vec![7, 6, 5, 4, 3, 2, 1, 0]];
    let mut search = OrderSearch::merging(&costs, Shape::Open, &halves[0], &ways(&costs, &halves)).expect("finite costs");
    assert!(search.go_on(u64::MAX));
    assert_eq!((search.cost(), search.order()), (8.0, &plain(&costs)[..]));
    for (seed, shape) in (0..60).flat_map(|seed| SHAPES.map(|shape| (seed, shape))) {
        let costs = drawn(seed);
        let orders: Vec<Vec<u32>> = [1, 5, 7].map(|by| turned(&costs, by)).into();
        let mut merged = OrderSearch::merging(&costs, shape, &orders[0], &ways(&costs, &orders)).expect("finite costs");
        assert!(merged.go_on(u64::MAX));
        let best = orders.iter().map(|order| costs.total(order, shape)).fold(f64::INFINITY, f64::min);
        assert!(merged.cost() <= best + 1e-9, "seed {seed}, {shape:?}");
    }
}

fn ways(costs: &Costs, orders: &[Vec<u32>]) -> Ways {
    let mut ways = Ways::none(costs.nodes());
    orders.iter().for_each(|order| ways.take(order));
    ways
}

/// The goals begun at another one.
fn turned(costs: &Costs, by: usize) -> Vec<u32> {
    let mut order = plain(costs);
    let by = by % order.len();
    order.rotate_left(by);
    order
}

#[test]
fn what_has_no_bound_is_not_searched() {
    let behind_walls = Costs::new(5, |i, j| if i + j == 5 { f64::INFINITY } else { 1.0 });
    assert!(OrderSearch::new(&behind_walls, Shape::Open, &[0, 1, 2, 3]).is_none());
    let open = Costs::new(5, |_, _| 1.0);
    assert!(OrderSearch::new(&open, Shape::Open, &[0, 1]).is_none(), "an order of all goals");
    assert!(OrderSearch::new(&Costs::new(1, |_, _| 1.0), Shape::Open, &[]).is_none());
}
