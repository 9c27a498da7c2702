//! The best order by branch and bound over 1-trees (Held and Karp 1971; Volgenant and Jonker 1982, both cited in [`super::ascent`]), with a lower
//! bound at any time.
//!
//! Where the least 1-tree of a part of the orders is no tour, some vertex is on more than two of its edges. Two of these, e and f, divide the
//! part: orders with both, with e and not f, without e. The part of the least bound is divided first, so that bound holds for all orders.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::ascent::{Found, Rounds, ascend, too_dear};
use super::graph::{Edge, Graph};
use super::improve::improve;
use super::one_tree::{Among, OneTree};
use super::whole::{Ways, Whole};
use super::{Costs, Shape, held_karp};

/// The first bound, of all orders.
const ROOT: Rounds = Rounds { most: 1500, lambda: 2.0, patience: 20 };
/// The bound of a part, which begins with the multipliers of the larger part.
const PART: Rounds = Rounds { most: 20, lambda: 0.5, patience: 3 };
/// Of so many parts one gives an order to be improved, where there are no more nodes than this: many more cost as much as many 1-trees.
const TRIED: u32 = 8;
const NODES_TRIED: usize = 256;
/// Fewer nodes have no 1-trees, or hardly any; [`held_karp`] orders them.
const FEWEST: usize = 4;

/// A search for the best order. What it costs is counted in 1-trees.
///
/// ```
/// use formicarium::exact::order::{Costs, OrderSearch, Shape};
///
/// let along = Costs::new(20, |i, j| i.abs_diff(j) as f64);
/// let mut search = OrderSearch::new(&along, Shape::Open, &(0..19).rev().collect::<Vec<_>>()).expect("costs are finite");
/// search.go_on(10_000);
/// assert!(search.is_proven());
/// assert_eq!((search.order(), search.lower_bound()), (&(0..19).collect::<Vec<_>>()[..], 19.0));
/// ```
#[derive(Debug, Clone)]
pub struct OrderSearch {
    whole: Whole,
    cost: f64,
    best: Vec<u32>,
    units: i64,
    graph: Graph,
    neighbours: Vec<Vec<u32>>,
    /// The 1-tree of the first bound, and its multipliers.
    first: Option<(OneTree, Vec<i64>)>,
    /// What is left to divide; none before the first step.
    open: Option<BinaryHeap<Part>>,
    trees: u64,
    parts: u32,
    costs: Costs,
}

/// A part of the orders: those with and without certain edges.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Part {
    /// The largest comes first: that of the least bound, of equals the youngest, which is the nearest to a tour.
    bound: Reverse<i64>,
    number: u32,
    decided: Vec<(u32, u32, bool)>,
    multipliers: Vec<i64>,
    /// Two edges at the vertex that divides it; the second only where none at that vertex is required.
    divided_by: Vec<(u32, u32)>,
}

impl OrderSearch {
    /// Of orders of all goals (counted from 0) cheaper than `known`, which is improved by small changes first. None where a cost is
    /// negative or not finite, and without goals.
    pub fn new(costs: &Costs, shape: Shape, known: &[u32]) -> Option<Self> {
        Self::among(costs, shape, known, None)
    }

    /// The same among these ways alone: the orders that can be put together from parts of those that have gone them. What it proves is proven
    /// for these orders.
    pub fn merging(costs: &Costs, shape: Shape, known: &[u32], ways: &Ways) -> Option<Self> {
        Self::among(costs, shape, known, Some(ways))
    }

    fn among(costs: &Costs, shape: Shape, known: &[u32], among: Option<&Ways>) -> Option<Self> {
        if costs.nodes() < 2 || known.len() + 1 != costs.nodes() {
            return None;
        }
        let mut best = known.to_vec();
        let whole = scaled(costs, shape, &mut best)?;
        let is_small = whole.nodes() < FEWEST;
        if let Some(order) = held_karp(costs, shape).filter(|_| is_small) {
            best = order;
        }
        let graph = Graph::new(&whole, among);
        Some(Self {
            cost: costs.total(&best, shape),
            units: whole.total(&best),
            best,
            neighbours: graph.neighbours(),
            graph,
            first: None,
            open: is_small.then(BinaryHeap::new),
            trees: 0,
            parts: 0,
            costs: costs.clone(),
            whole,
        })
    }

    /// The best order so far: goals counted from 0.
    pub fn order(&self) -> &[u32] {
        &self.best
    }

    /// What it costs.
    pub fn cost(&self) -> f64 {
        self.cost
    }

    /// 1-trees that were found so far.
    pub fn trees(&self) -> u64 {
        self.trees
    }

    /// Whether no order is cheaper than the best, by more than [`crate::metrics::SAME_LENGTH`], or that part of it where it is above 1.
    pub fn is_proven(&self) -> bool {
        self.is_done() && self.whole.is_fine(self.cost)
    }

    /// Whether nothing is left to search.
    pub fn is_done(&self) -> bool {
        self.open.as_ref().is_some_and(|open| open.peek().is_none_or(|part| part.bound.0 > self.most_units()))
    }

    /// No order costs less: what rounding takes from a sum is allowed for. Once it is proven, the cost of the best order.
    pub fn lower_bound(&self) -> f64 {
        if self.is_proven() {
            return self.cost;
        }
        // What was left out costs at least so many units.
        let reached = self.units - self.whole.grain() + 1;
        let least = self.open.as_ref().map_or(0, |open| open.peek().map_or(reached, |part| part.bound.0.min(reached)));
        self.whole.told(least).min(self.cost)
    }

    /// Searches until the best order is proven, or so many 1-trees were found in all, those of the part at work on top; whether it is proven.
    pub fn go_on(&mut self, most: u64) -> bool {
        while !self.is_done() && self.trees < most {
            self.step(most);
        }
        self.is_proven()
    }

    /// The bound of all orders at first, by no more than `most` 1-trees; then divides one part, by 63 more at most.
    pub fn step(&mut self, most: u64) {
        let Some(open) = &mut self.open else { return self.begin(most) };
        let Some(part) = open.pop() else { return };
        for decided in divide(&part) {
            self.bound(decided, part.multipliers.clone(), part.bound.0, PART);
        }
    }

    /// What it holds, in bytes, its own size not counted.
    pub fn bytes(&self) -> usize {
        let (size, parts) = (self.graph.size(), self.open.as_ref().map_or(0, BinaryHeap::len));
        size * size * 18 + parts * (size_of::<Part>() + 12 * size)
    }

    /// What a better order costs at most.
    fn most_units(&self) -> i64 {
        self.units - self.whole.grain()
    }

    fn begin(&mut self, most: u64) {
        self.open = Some(BinaryHeap::new());
        self.bound(Vec::new(), vec![0; self.graph.size()], 0, Rounds { most: ROOT.most.min(most), ..ROOT });
    }

    /// Bounds a part of a part of this bound, and keeps it where it may have a better order.
    fn bound(&mut self, decided: Vec<(u32, u32, bool)>, mut multipliers: Vec<i64>, least: i64, rounds: Rounds) {
        let Some((decision, required)) = self.decide(&decided) else { return };
        let (graph, neighbours, most) = (&self.graph, &self.neighbours, self.most_units());
        let with = |multipliers| Among { graph, neighbours, edges: &decision, required, multipliers };
        let find = |multipliers: &[i64], tree: &mut OneTree| {
            tree.find(&Among { graph, neighbours, edges: &decision, required, multipliers })
        };
        let mut tree = OneTree::default();
        match ascend(find, (&mut multipliers, &mut tree, &mut self.trees), most, rounds) {
            Found::Nothing => {}
            Found::Cycle(cycle) => self.take(self.graph.order(&cycle)),
            Found::Bound(bound) => {
                let divided_by = dividing(&tree, &with(&multipliers));
                let bound = Reverse(self.whole.least_order(bound).max(least));
                self.parts += 1;
                self.keep(Part { bound, number: self.parts, decided, multipliers, divided_by }, tree);
            }
        }
    }

    /// Keeps a part, whose 1-tree this is, to be divided.
    fn keep(&mut self, part: Part, tree: OneTree) {
        if part.number % TRIED == 1 && self.whole.nodes() <= NODES_TRIED {
            self.try_along(&tree);
        }
        if part.decided.is_empty() {
            self.first = Some((tree, part.multipliers.clone()));
            self.forbid_too_dear();
        }
        self.open.get_or_insert_default().push(part);
    }

    /// Takes in an order where it is the cheapest so far.
    fn take(&mut self, order: Vec<u32>) {
        let units = self.whole.total(&order);
        if units <= self.most_units() {
            self.cost = self.costs.total(&order, self.whole.shape());
            (self.best, self.units) = (order, units);
            self.forbid_too_dear();
        }
    }

    /// Forbids the edges with which no order is cheap enough, by the 1-tree of the first bound.
    fn forbid_too_dear(&mut self) {
        let Some((tree, multipliers)) = &self.first else { return };
        let (graph, neighbours) = (&self.graph, &self.neighbours);
        let among = Among { graph, neighbours, edges: graph.edges(), required: 0, multipliers };
        let never = too_dear(tree, &among, self.most_units());
        never.into_iter().for_each(|(a, b)| self.graph.forbid(a as usize, b as usize));
        self.neighbours = self.graph.neighbours();
    }

    /// Improves an order along a 1-tree: whoever comes off its edges goes on at the next vertex that it leads to.
    fn try_along(&mut self, tree: &OneTree) {
        let mut order = self.graph.order_along(&tree.edges);
        improve(&self.whole, &mut order);
        self.take(order);
    }

    /// Every edge after these decisions (required or not) and what follows from them, and how many are required: every vertex is on two. None
    /// where no cycle is left.
    fn decide(&self, decided: &[(u32, u32, bool)]) -> Option<(Vec<Edge>, usize)> {
        let size = self.graph.size();
        let mut left = self.graph.edges().to_vec();
        for &(a, b, is_required) in decided {
            put(&mut left, size, (a, b), if is_required { Edge::Required } else { Edge::Forbidden });
        }
        let mut waiting: Vec<u32> = (0..size as u32).collect();
        while let Some(a) = waiting.pop() {
            let beside = &self.neighbours[a as usize];
            let is = |b: u32, edge: Edge| left[a as usize * size + b as usize] == edge;
            let required = beside.iter().filter(|&&b| is(b, Edge::Required)).count();
            let free: Vec<u32> = beside.iter().copied().filter(|&b| is(b, Edge::Free)).collect();
            if required > 2 || required + free.len() < 2 {
                return None;
            }
            if required == 2 || required + free.len() == 2 {
                let edge = if required == 2 { Edge::Forbidden } else { Edge::Required };
                free.iter().for_each(|&b| put(&mut left, size, (a, b), edge));
                waiting.extend(free);
            }
        }
        let required = left.iter().filter(|&&edge| edge == Edge::Required).count() / 2;
        Some((left, required))
    }
}

/// Costs in units that are as fine as a good order allows: `best`, which is improved with them, and again with finer ones where it has become far
/// better.
fn scaled(costs: &Costs, shape: Shape, best: &mut [u32]) -> Option<Whole> {
    loop {
        let known = costs.total(best, shape);
        let whole = Whole::below(costs, shape, known)?;
        improve(&whole, best);
        if 4.0 * costs.total(best, shape) >= known {
            return Some(whole);
        }
    }
}

fn put(edges: &mut [Edge], size: usize, (a, b): (u32, u32), edge: Edge) {
    edges[a as usize * size + b as usize] = edge;
    edges[b as usize * size + a as usize] = edge;
}

/// The two least edges that are free, at the vertex with the most edges of a 1-tree that is no cycle; one where another is required there.
fn dividing(tree: &OneTree, among: &Among) -> Vec<(u32, u32)> {
    let most = tree.degrees.iter().copied().max().unwrap_or(0);
    let vertex = tree.degrees.iter().position(|&degree| degree == most).unwrap_or(0) as u32;
    let at = || tree.edges.iter().copied().filter(|&(a, b)| a == vertex || b == vertex);
    let required = at().filter(|&(a, b)| among.edge(a, b) == Edge::Required).count();
    let mut free: Vec<(i64, (u32, u32))> =
        at().filter(|&(a, b)| among.edge(a, b) == Edge::Free).map(|(a, b)| (among.cost(a, b), (a, b))).collect();
    free.sort_unstable();
    free.truncate(2 - required.min(1));
    free.into_iter().map(|(_, edge)| edge).collect()
}

/// The decisions of the parts of a part.
fn divide(part: &Part) -> Vec<Vec<(u32, u32, bool)>> {
    let with = |more: &[((u32, u32), bool)]| {
        part.decided.iter().copied().chain(more.iter().map(|&((a, b), is_required)| (a, b, is_required))).collect()
    };
    match *part.divided_by.as_slice() {
        [e, f] => vec![with(&[(e, true), (f, true)]), with(&[(e, true), (f, false)]), with(&[(e, false)])],
        [e] => vec![with(&[(e, true)]), with(&[(e, false)])],
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests;
