//! The least 1-tree of a graph whose vertices have multipliers, by Prim's algorithm.
//!
//! A 1-tree is a spanning tree of all vertices but vertex 0, and two edges at that. Every Hamiltonian cycle is one. With multipliers π an edge
//! costs c_ab + π_a + π_b: a cycle then costs Σ 2π more than before, whatever the cycle, so the least 1-tree less Σ 2π bounds all cycles.

use super::graph::{Edge, Graph};

/// By how much a required edge comes before all others: more than costs and multipliers can differ.
const FIRST: i64 = 1 << 58;
/// Larger than what any edge costs.
const NEVER: i64 = i64::MAX;

/// A least 1-tree, and room to find the next one.
#[derive(Debug, Clone, Default)]
pub(super) struct OneTree {
    /// Its edges, the two at vertex 0 last, the dearer of those last of all.
    pub(super) edges: Vec<(u32, u32)>,
    /// How many of them there are at each vertex.
    pub(super) degrees: Vec<i32>,
    /// What they cost with multipliers, less Σ 2π.
    pub(super) bound: i64,
    key: Vec<i64>,
    from: Vec<u32>,
    left: Vec<u32>,
}

/// What a 1-tree is made of: the graph, which edges are left, and the multipliers.
#[derive(Clone, Copy)]
pub(super) struct Among<'a> {
    pub(super) graph: &'a Graph,
    pub(super) neighbours: &'a [Vec<u32>],
    pub(super) edges: &'a [Edge],
    /// How many of them are required.
    pub(super) required: usize,
    pub(super) multipliers: &'a [i64],
}

impl Among<'_> {
    pub(super) fn edge(&self, a: u32, b: u32) -> Edge {
        self.edges[a as usize * self.graph.size() + b as usize]
    }

    /// What an edge costs with multipliers.
    #[inline]
    pub(super) fn cost(&self, a: u32, b: u32) -> i64 {
        let (a, b) = (a as usize, b as usize);
        self.graph.get(a, b) + self.multipliers[a] + self.multipliers[b]
    }

    /// The same for a comparison: a required edge comes first, a forbidden one never.
    #[inline]
    fn key(&self, a: u32, b: u32) -> i64 {
        match self.edge(a, b) {
            Edge::Free => self.cost(a, b),
            Edge::Required => self.cost(a, b) - FIRST,
            Edge::Forbidden => NEVER,
        }
    }
}

impl OneTree {
    /// Finds the least 1-tree with all edges that are required and none that is forbidden; false where there is none.
    pub(super) fn find(&mut self, among: &Among) -> bool {
        let size = among.graph.size();
        self.edges.clear();
        self.degrees.clear();
        self.degrees.resize(size, 0);
        self.bound = -2 * among.multipliers.iter().sum::<i64>();
        self.span(among) && self.close(among) && self.has_all_required(among)
    }

    /// The spanning tree.
    fn span(&mut self, among: &Among) -> bool {
        let size = among.graph.size();
        self.key.clear();
        self.key.resize(size, NEVER);
        self.from.resize(size, 0);
        self.left.clear();
        self.left.extend(2..size as u32);
        let mut at = 1;
        while !self.left.is_empty() {
            self.reach_from(at, among);
            let nearest = (0..self.left.len()).reduce(|best, k| if self.key_of(k) < self.key_of(best) { k } else { best });
            let Some(nearest) = nearest.filter(|&k| self.key_of(k) != NEVER) else { return false };
            at = self.left.swap_remove(nearest);
            self.take(self.from[at as usize], at, among);
        }
        true
    }

    fn key_of(&self, place: usize) -> i64 {
        self.key[self.left[place] as usize]
    }

    /// Takes note of the edges at a vertex that has come into the tree.
    fn reach_from(&mut self, at: u32, among: &Among) {
        self.key[at as usize] = i64::MIN;
        for &to in among.neighbours[at as usize].iter().filter(|&&to| to != 0) {
            let key = among.key(at, to);
            if key < self.key[to as usize] {
                (self.key[to as usize], self.from[to as usize]) = (key, at);
            }
        }
    }

    /// The two least edges at vertex 0.
    fn close(&mut self, among: &Among) -> bool {
        let (mut first, mut second) = ((NEVER, 0), (NEVER, 0));
        for &to in &among.neighbours[0] {
            let found = (among.key(0, to), to);
            if found.0 < first.0 {
                (first, second) = (found, first);
            } else if found.0 < second.0 {
                second = found;
            }
        }
        if second.0 == NEVER {
            return false;
        }
        self.take(0, first.1, among);
        self.take(0, second.1, among);
        true
    }

    fn take(&mut self, a: u32, b: u32, among: &Among) {
        self.edges.push((a, b));
        self.degrees[a as usize] += 1;
        self.degrees[b as usize] += 1;
        self.bound += among.cost(a, b);
    }

    /// Whether no required edge is left out, as where they make a circle.
    fn has_all_required(&self, among: &Among) -> bool {
        let has = self.edges.iter().filter(|&&(a, b)| among.edge(a, b) == Edge::Required).count();
        has == among.required
    }

    /// Whether it is a cycle.
    pub(super) fn is_cycle(&self) -> bool {
        self.degrees.iter().all(|&degree| degree == 2)
    }
}
