//! Orders as cycles: a graph without directions whose Hamiltonian cycles, as far as they use what is required and nothing forbidden, are the
//! tours, of equal cost.
//!
//! - **Closed, both directions cost the same**: the nodes themselves.
//! - **Open, both directions cost the same**: vertex 0 is added, from which a way to every node costs nothing and that to node 0, vertex 1, is
//!   required. A cycle then comes from vertex 1 by all goals to some last one k and from there over vertex 0 back: without the two ways at
//!   vertex 0, which cost nothing, it is an open tour from the start. Every open tour makes one such cycle. So least costs are equal, and a bound
//!   for the cycles is one for the tours.
//! - **Directions differ**: each node k is two vertices, 2k where one comes in and 2k + 1 where one leaves, joined by a way that costs nothing
//!   and is required; the way from i to j joins 2i + 1 and 2j, all others are forbidden. Along a cycle each required way is followed by one that
//!   is not, so it runs through all nodes the same way round. Jonker, Volgenant, "Transforming asymmetric into symmetric traveling salesman
//!   problems", Operations Research Letters 2 (1983) 161–163, doi:10.1016/0167-6377(83)90048-2. An open tour returns at no cost.

use super::Shape;
use super::whole::{Ways, Whole};

/// What is decided about an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Edge {
    Free,
    Required,
    Forbidden,
}

/// How vertices stand for nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Nodes,
    Dummy,
    Doubled,
}

/// Costs in units, and what is decided from the first.
#[derive(Debug, Clone)]
pub(super) struct Graph {
    kind: Kind,
    size: usize,
    units: Vec<i64>,
    edges: Vec<Edge>,
}

impl Graph {
    /// Of these costs; with only the edges of `among`, where that is given.
    pub(super) fn new(whole: &Whole, among: Option<&Ways>) -> Self {
        let (kind, size) = match (whole.is_symmetric(), whole.shape()) {
            (true, Shape::Closed) => (Kind::Nodes, whole.nodes()),
            (true, Shape::Open) => (Kind::Dummy, whole.nodes() + 1),
            (false, _) => (Kind::Doubled, 2 * whole.nodes()),
        };
        let mut graph = Self { kind, size, units: vec![0; size * size], edges: vec![Edge::Forbidden; size * size] };
        let is_among = |i: usize, j: usize| among.is_none_or(|among| among.has(i, j));
        for (i, j) in (0..whole.nodes()).flat_map(|i| (0..whole.nodes()).map(move |j| (i, j))).filter(|(i, j)| i != j) {
            if is_among(i, j) {
                let (a, b) = graph.vertices(i, j);
                graph.put(a, b, whole.get(i, j), Edge::Free);
            }
        }
        match kind {
            Kind::Nodes => {}
            Kind::Dummy => graph.put(0, 1, 0, Edge::Required),
            Kind::Doubled => (0..whole.nodes()).for_each(|k| graph.put(2 * k, 2 * k + 1, 0, Edge::Required)),
        }
        graph
    }

    /// The vertices that the way from node i to node j joins.
    fn vertices(&self, i: usize, j: usize) -> (usize, usize) {
        match self.kind {
            Kind::Nodes => (i, j),
            Kind::Dummy if j == 0 => (i + 1, 0),
            Kind::Dummy => (i + 1, j + 1),
            Kind::Doubled => (2 * i + 1, 2 * j),
        }
    }

    fn put(&mut self, a: usize, b: usize, units: i64, edge: Edge) {
        for at in [a * self.size + b, b * self.size + a] {
            (self.units[at], self.edges[at]) = (units, edge);
        }
    }

    /// Number of vertices.
    pub(super) fn size(&self) -> usize {
        self.size
    }

    /// What is decided about every edge, a row for each vertex.
    pub(super) fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Forbids an edge from now on.
    pub(super) fn forbid(&mut self, a: usize, b: usize) {
        self.edges[a * self.size + b] = Edge::Forbidden;
        self.edges[b * self.size + a] = Edge::Forbidden;
    }

    #[inline]
    pub(super) fn get(&self, a: usize, b: usize) -> i64 {
        self.units[a * self.size + b]
    }

    /// The vertices to which an edge leads from each that is not forbidden, in order.
    pub(super) fn neighbours(&self) -> Vec<Vec<u32>> {
        let of = |a: usize| (0..self.size).filter(move |&b| self.edges[a * self.size + b] != Edge::Forbidden);
        (0..self.size).map(|a| of(a).map(|b| b as u32).collect()).collect()
    }

    /// The order of the goals along a cycle of these edges, each vertex on two of them.
    pub(super) fn order(&self, cycle: &[(u32, u32)]) -> Vec<u32> {
        let mut beside = vec![Vec::with_capacity(2); self.size];
        for &(a, b) in cycle {
            beside[a as usize].push(b);
            beside[b as usize].push(a);
        }
        let mut order = Vec::new();
        let (mut before, mut at) = (0, beside[0].iter().copied().min().unwrap_or(0));
        while at != 0 {
            order.extend(self.goal(at));
            let next = beside[at as usize].iter().copied().find(|&next| next != before).unwrap_or(0);
            (before, at) = (at, next);
        }
        order
    }

    /// The order in which the goals are first come by along a spanning tree of all vertices but vertex 0; edges at that do not count.
    pub(super) fn order_along(&self, tree: &[(u32, u32)]) -> Vec<u32> {
        let mut beside = vec![Vec::new(); self.size];
        for &(a, b) in tree.iter().filter(|edge| edge.0 != 0) {
            beside[a as usize].push(b);
            beside[b as usize].push(a);
        }
        let (mut order, mut waiting, mut seen) = (Vec::new(), vec![1], vec![false; self.size]);
        while let Some(at) = waiting.pop() {
            if !std::mem::replace(&mut seen[at as usize], true) {
                order.extend(self.goal(at));
                waiting.extend(beside[at as usize].iter().rev());
            }
        }
        order
    }

    /// The goal for which a vertex stands, told at one of two.
    fn goal(&self, vertex: u32) -> Option<u32> {
        match self.kind {
            Kind::Nodes => Some(vertex - 1),
            Kind::Dummy => vertex.checked_sub(2),
            Kind::Doubled => (vertex > 1 && vertex.is_multiple_of(2)).then(|| vertex / 2 - 1),
        }
    }
}
