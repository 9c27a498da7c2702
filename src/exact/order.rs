//! The order of several goals: what the ways between them cost, and the best order by Held, Karp, "A dynamic programming approach to
//! sequencing problems", Journal of the Society for Industrial and Applied Mathematics 10 (1962) 196–210, doi:10.1137/0110015.
//!
//! Nodes of the complete graph: 0 is the start, k is goal k − 1. A tour here is open, from the start by all goals, unless its [`Shape`]
//! says that it returns.

use std::sync::Arc;

use super::astar::Distance;
use super::search::{EVERYWHERE, Search};
use crate::map::Cell;
use crate::path::Path;
use crate::planner::{Planner, Tour};
use crate::scenario::Scenario;

/// Most goals that [`held_karp`] orders: 2^16 · 16 states are 8 MB and a fraction of a second.
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
/// C(S, j) = min over i in S without j of C(S without j, i) + c_ij: the cheapest way by all goals of S that ends at j.
pub fn held_karp(costs: &Costs, shape: Shape) -> Option<Vec<u32>> {
    let n = costs.nodes() - 1;
    if !(1..=MAX_ORDERED).contains(&n) {
        return None;
    }
    let all = (1usize << n) - 1;
    let mut cheapest = vec![f64::INFINITY; (all + 1) * n];
    let mut before = vec![0u8; (all + 1) * n];
    (0..n).for_each(|j| cheapest[(1 << j) * n + j] = costs.get(0, j + 1));
    for set in 1..=all {
        for j in (0..n).filter(|j| set >> j & 1 == 1) {
            let here = cheapest[set * n + j];
            for k in (0..n).filter(|k| set >> k & 1 == 0) {
                let state = (set | 1 << k) * n + k;
                let cost = here + costs.get(j + 1, k + 1);
                if cost < cheapest[state] {
                    (cheapest[state], before[state]) = (cost, j as u8);
                }
            }
        }
    }
    let back = |j: usize| if shape == Shape::Closed { costs.get(j + 1, 0) } else { 0.0 };
    let end = |j: usize| cheapest[all * n + j] + back(j);
    let last = (1..n).fold(0, |best, j| if end(j) < end(best) { j } else { best });
    Some(trace_back(&before, n, last))
}

/// The order that ends at goal `last`, from the goal before each goal of each set.
fn trace_back(before: &[u8], n: usize, last: usize) -> Vec<u32> {
    let (mut set, mut at) = ((1usize << n) - 1, last);
    let mut order = vec![at as u32];
    while order.len() < n {
        let previous = before[set * n + at] as usize;
        set &= !(1 << at);
        at = previous;
        order.push(at as u32);
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
