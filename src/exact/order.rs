//! The order of several goals: what the ways between them cost, and the best order by Held, Karp, "A dynamic programming approach to
//! sequencing problems", Journal of the Society for Industrial and Applied Mathematics 10 (1962) 196–210, doi:10.1137/0110015.
//!
//! Nodes of the complete graph: 0 is the start, k is goal k − 1. A tour here is open, from the start by all goals, unless its [`Shape`]
//! says that it returns.

mod ascent;
mod graph;
mod improve;
mod one_tree;
mod search;
mod start;
mod whole;

use std::sync::Arc;

pub use improve::improved;
pub use search::OrderSearch;
pub use start::good_order;
pub use whole::Ways;

use super::astar::Distance;
use super::search::{EVERYWHERE, Search};
use crate::map::Cell;
use crate::path::Path;
use crate::planner::{Planner, Tour, held};
use crate::scenario::Scenario;

/// Most goals that [`held_karp`] orders: 2^16 · 16 states are 8 MB.
pub const MAX_ORDERED: usize = 16;

/// Whether a tour returns to its start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// It ends at its last goal.
    Open,
    /// It returns: the travelling salesman's.
    Closed,
}

/// What each way between two nodes of a complete graph costs; the two directions may differ.
#[derive(Debug, Clone, PartialEq)]
pub struct Costs {
    nodes: usize,
    values: Vec<f64>,
}

impl Costs {
    /// What they hold, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.values)
    }

    /// `cost(i, j)` of every i and j; 0 where i = j.
    pub fn new(nodes: usize, cost: impl Fn(usize, usize) -> f64) -> Self {
        let of = |k: usize| if k / nodes == k % nodes { 0.0 } else { cost(k / nodes, k % nodes) };
        Self { nodes, values: (0..nodes * nodes).map(of).collect() }
    }

    /// Straight-line distances between the cells of start and goals, in cells.
    pub fn euclidean(scenario: &Scenario) -> Self {
        let at = nodes(scenario);
        Self::new(at.len(), |i, j| super::euclidean(scenario, at[i], at[j]))
    }

    /// Lengths of the shortest paths between start and goals under the scenario's rules, in cells; infinite where there is none. One
    /// search over the whole map for each of them but the last.
    pub fn grid(scenario: &Arc<Scenario>) -> Self {
        let rows: Vec<_> = (0..scenario.goals.len()).map(|node| grid_row(scenario, node).0).collect();
        Self::symmetric(&rows)
    }

    /// From the rows of all nodes but the last: row i has the costs between node i and every node. Steps lead back as they lead there.
    pub(crate) fn symmetric(rows: &[Vec<f64>]) -> Self {
        Self::new(rows.len() + 1, |i, j| rows[i.min(j)][i.max(j)])
    }

    /// Comprehensive weights R_ij = d_ij · b_j (fire-fighting paper, Eq. 6), these costs being d_ij.
    #[must_use]
    pub fn weighted(&self, scenario: &Scenario) -> Self {
        Self::new(self.nodes, |i, j| if j == 0 { self.get(i, j) } else { self.get(i, j) * scenario.spec.goals[j - 1].weight() })
    }

    /// Number of nodes: start and goals.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// From node i to node j.
    #[inline]
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.values[i * self.nodes + j]
    }

    /// The cost of each leg of a tour that visits the goals (counted from 0) in this order.
    pub fn legs<'a>(&'a self, order: &'a [u32]) -> impl Iterator<Item = f64> + 'a {
        let from = std::iter::once(0).chain(order.iter().map(|&g| g as usize + 1));
        from.zip(order).map(|(i, &g)| self.get(i, g as usize + 1))
    }

    /// The cost of a tour, summed from its first leg to its last.
    pub fn total(&self, order: &[u32], shape: Shape) -> f64 {
        let last = order.last().map_or(0, |&g| g as usize + 1);
        let back = if shape == Shape::Closed { self.get(last, 0) } else { 0.0 };
        self.legs(order).sum::<f64>() + back
    }
}

/// The cells of the nodes.
pub(crate) fn nodes(scenario: &Scenario) -> Vec<Cell> {
    std::iter::once(scenario.start).chain(scenario.goals.iter().copied()).collect()
}

/// Length in cells of the shortest path from a cell to every cell; infinite where there is none.
pub fn distances_from(scenario: &Arc<Scenario>, cell: Cell) -> Vec<f64> {
    everywhere(scenario, cell).costs().to_vec()
}

/// Lengths of the shortest paths from a node to every node, and the cells that were expanded for them.
pub(crate) fn grid_row(scenario: &Arc<Scenario>, node: usize) -> (Vec<f64>, u64) {
    let at = nodes(scenario);
    let search = everywhere(scenario, at[node]);
    (at.iter().map(|&c| search.costs()[c as usize]).collect(), search.effort().cell_expansions)
}

fn everywhere(scenario: &Arc<Scenario>, cell: Cell) -> Search<Distance> {
    let mut search = Search::between(Arc::clone(scenario), cell, EVERYWHERE, Distance::unknown(scenario));
    search.run();
    search
}

/// The cheapest order of the goals, the first found of equals; `None` for no goal and for more than [`MAX_ORDERED`].
///
/// C(S, k) = min over j in S of C(S without j, j) + c_jk: the cheapest way by all goals of S and then to k, which is not in S.
pub fn held_karp(costs: &Costs, shape: Shape) -> Option<Vec<u32>> {
    let n = costs.nodes() - 1;
    if !(1..=MAX_ORDERED).contains(&n) {
        return None;
    }
    let to: Vec<Row> = (0..=n).map(|node| std::array::from_fn(|k| if k < n { costs.get(node, k + 1) } else { 0.0 })).collect();
    let mut cheapest = vec![to[0]; 1 << n];
    for set in 1..cheapest.len() {
        let mut row = [f64::INFINITY; MAX_ORDERED];
        for j in members(set) {
            let here = cheapest[set & !(1 << j)][j];
            for (least, step) in row.iter_mut().zip(to[j + 1]) {
                let cost = here + step;
                *least = if cost < *least { cost } else { *least };
            }
        }
        cheapest[set] = row;
    }
    Some(trace_back(&cheapest, costs, shape))
}

/// A number for each goal: they are worked out side by side.
type Row = [f64; MAX_ORDERED];

/// The goals of a set, in order.
fn members(set: usize) -> impl Iterator<Item = usize> {
    let rest = std::iter::successors(Some(set), |rest| Some(rest & rest.wrapping_sub(1)));
    rest.take_while(|&rest| rest != 0).map(|rest| rest.trailing_zeros() as usize)
}

/// The cheapest order, from its last goal to its first: of equals the first that leads there as cheaply.
fn trace_back(cheapest: &[Row], costs: &Costs, shape: Shape) -> Vec<u32> {
    let mut set = cheapest.len() - 1;
    let back = |j: usize| if shape == Shape::Closed { costs.get(j + 1, 0) } else { 0.0 };
    let mut order: Vec<u32> = Vec::new();
    while set != 0 {
        let onwards = |j: usize| order.last().map_or_else(|| back(j), |&k| costs.get(j + 1, k as usize + 1));
        let cost = |j: usize| cheapest[set & !(1 << j)][j] + onwards(j);
        let before = members(set).reduce(|best, j| if cost(j) < cost(best) { j } else { best });
        let Some(j) = before else { break };
        order.push(j as u32);
        set &= !(1 << j);
    }
    order.reverse();
    order
}

/// A tour that is chosen but not walked yet; `lengths` are what it was chosen by, before any weight.
pub(crate) fn planned(scenario: &Scenario, lengths: &Costs, order: Vec<u32>) -> Tour {
    let planned: Vec<f64> = lengths.legs(&order).collect();
    let (planned_length, planned_weight) = (planned.iter().sum(), weight(scenario, &order, &planned));
    Tour { order, planned, walked: Vec::new(), planned_length, planned_weight, walked_weight: None }
}

/// Takes in the lengths of the legs as they were walked.
pub(crate) fn walk(scenario: &Scenario, tour: &mut Tour, walked: Vec<f64>) {
    tour.walked_weight = Some(weight(scenario, &tour.order, &walked));
    tour.walked = walked;
}

/// One path from the legs of a tour; each begins where the one before it ends.
pub(crate) fn join<'a>(legs: impl IntoIterator<Item = &'a Path>) -> Path {
    legs.into_iter().fold(Path::new(), |mut path, leg| {
        path.extend(leg.iter().skip(usize::from(!path.is_empty())));
        path
    })
}

/// Σ R of legs of these lengths.
fn weight(scenario: &Scenario, order: &[u32], lengths: &[f64]) -> f64 {
    order.iter().zip(lengths).map(|(&goal, length)| length * scenario.spec.goals[goal as usize].weight()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{Grid, Movement, Point};

    /// Calls `visit` with every order of `n` goals.
    fn orders(n: u32, order: &mut Vec<u32>, visit: &mut impl FnMut(&[u32])) {
        if order.len() == n as usize {
            visit(order);
            return;
        }
        for goal in 0..n {
            if !order.contains(&goal) {
                order.push(goal);
                orders(n, order, visit);
                order.pop();
            }
        }
    }

    #[test]
    fn held_karp_agrees_with_all_orders() {
        for seed in 1..=40u32 {
            let n = 1 + seed % 7;
            let cost = |i: usize, j: usize| f64::from((seed + 7 * i as u32 + 31 * j as u32).wrapping_mul(2_654_435_761) >> 20);
            let costs = Costs::new(n as usize + 1, cost);
            for shape in [Shape::Open, Shape::Closed] {
                let mut best = f64::INFINITY;
                orders(n, &mut Vec::new(), &mut |order| best = best.min(costs.total(order, shape)));
                let order = held_karp(&costs, shape).expect("few goals");
                assert_eq!(costs.total(&order, shape), best, "seed {seed}, {shape:?}");
            }
        }
    }

    /// The same by C(S, k) with k in S, goal by goal, each with the goal before it: the first found of equals.
    fn one_by_one(costs: &Costs, shape: Shape) -> Vec<u32> {
        let n = costs.nodes() - 1;
        let mut cheapest = vec![vec![(f64::INFINITY, 0); n]; 1 << n];
        (0..n).for_each(|k| cheapest[1 << k][k].0 = costs.get(0, k + 1));
        for set in 1..1usize << n {
            for (j, k) in members(set).flat_map(|j| (0..n).map(move |k| (j, k))).filter(|(_, k)| set >> k & 1 == 0) {
                let cost = cheapest[set][j].0 + costs.get(j + 1, k + 1);
                if cost < cheapest[set | 1 << k][k].0 {
                    cheapest[set | 1 << k][k] = (cost, j);
                }
            }
        }
        let mut set = (1 << n) - 1;
        let end = |k: usize| cheapest[set][k].0 + if shape == Shape::Closed { costs.get(k + 1, 0) } else { 0.0 };
        let mut at = (1..n).fold(0, |best, k| if end(k) < end(best) { k } else { best });
        let mut order = vec![at as u32];
        while order.len() < n {
            let before = cheapest[set][at].1;
            set &= !(1 << at);
            at = before;
            order.push(at as u32);
        }
        order.reverse();
        order
    }

    #[test]
    fn of_equally_cheap_orders_the_first_is_chosen() {
        for seed in 1..=60u32 {
            let n = 1 + seed % 10;
            // One of five lengths, so that most orders cost as much as others; sums are rounded.
            let cost = |i: usize, j: usize| {
                f64::from((seed + 7 * i as u32 + 31 * j as u32).wrapping_mul(2_654_435_761) >> 24) % 5.0
                    * std::f64::consts::SQRT_2
            };
            let costs = Costs::new(n as usize + 1, cost);
            for shape in [Shape::Open, Shape::Closed] {
                assert_eq!(held_karp(&costs, shape), Some(one_by_one(&costs, shape)), "seed {seed}, {shape:?}");
            }
        }
    }

    #[test]
    fn too_many_goals_are_not_ordered() {
        assert_eq!(held_karp(&Costs::new(MAX_ORDERED + 2, |_, _| 1.0), Shape::Open), None);
        assert_eq!(held_karp(&Costs::new(1, |_, _| 1.0), Shape::Open), None);
    }

    #[test]
    fn distances_go_around_walls_and_are_infinite_behind_them() {
        let grid = Grid::from_bytes(5, 3, &[0, 1, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0]).expect("a map");
        let s = Arc::new(Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(2, 0)).expect("usable"));
        let from = distances_from(&s, 0);
        // Down two, right two, up two: no corner may be cut.
        assert_eq!([from[0], from[10], from[12], from[2]], [0.0, 2.0, 4.0, 6.0]);
        assert!(from[1].is_infinite() && from[4].is_infinite());
    }
}
