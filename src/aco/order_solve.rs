//! Orders by ants, put together by a search: Construct, Merge, Solve & Adapt (Blum, Pinacho, López-Ibáñez, Lozano 2016, cited in
//! [`super::formica`]) on the edges of tours, and a proof.
//!
//! Each ant's tour is improved by 2-opt and Or-opt beside the colony, whose trails follow the tours as its ants built them: so it finds at least
//! what the colony finds alone. When all have walked, a search looks for the best order among the ways of the improved tours, then among all
//! ([`OrderSearch`]). What it may cost is counted in 1-trees.

use super::tour::OrderColony;
use crate::exact::order::{Costs, OrderSearch, Shape, Ways, improved};
use crate::planner::held;

/// The part of the 1-trees that merging may cost.
const FOR_MERGING: u64 = 4;

/// What is made of the ants' tours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solving {
    /// Whether tours are improved and merged.
    pub merge: bool,
    /// Whether the best order is to be proven.
    pub prove: bool,
    /// Most 1-trees of all searches.
    pub limit: u64,
}

impl Solving {
    /// Nothing: the colony's best stands.
    pub const NONE: Self = Self { merge: false, prove: false, limit: 0 };
}

/// What is proven of an order: no order's cost is below the bound; complete where it is that of the best.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrderProof {
    /// In the unit of the costs.
    pub lower_bound: f64,
    /// Whether no order is cheaper.
    pub complete: bool,
}

/// An order colony, and the searches after it.
#[derive(Debug, Clone)]
pub struct OrderSolver {
    costs: Costs,
    shape: Shape,
    solving: Solving,
    colony: OrderColony,
    /// Those of all improved tours.
    ways: Ways,
    best: Option<(Vec<u32>, f64)>,
    merging: Option<OrderSearch>,
    proof: Option<OrderSearch>,
    trees: u64,
}

impl OrderSolver {
    /// Begins with the ants of `colony`, which has these costs and this shape.
    pub fn new(costs: Costs, shape: Shape, solving: Solving, colony: OrderColony) -> Self {
        let (ways, best) = (Ways::none(costs.nodes()), None);
        Self { costs, shape, solving, colony, ways, best, merging: None, proof: None, trees: 0 }
    }

    /// One iteration of the ants; after the last one step of a search.
    pub fn advance(&mut self) {
        if !self.colony.is_finished() {
            self.walk();
        } else if self.is_merging() {
            self.merge();
        } else {
            self.prove();
        }
    }

    /// Whether nothing is left to do.
    pub fn is_finished(&self) -> bool {
        self.colony.is_finished() && !self.is_merging() && !self.is_proving()
    }

    /// The cheapest order so far, of goals counted from 0, and what it costs.
    pub fn best(&self) -> Option<(&[u32], f64)> {
        self.best.as_ref().map(|(order, cost)| (&order[..], *cost))
    }

    /// What is proven, once it has ended with a proof.
    pub fn proof(&self) -> Option<OrderProof> {
        let proof = self.proof.as_ref()?;
        Some(OrderProof { lower_bound: proof.lower_bound(), complete: proof.is_proven() })
    }

    /// 1-trees that were found so far.
    pub fn trees(&self) -> u64 {
        self.trees
    }

    /// What it holds, in bytes, its own size not counted.
    pub fn bytes(&self) -> usize {
        let searches = [&self.merging, &self.proof].into_iter().flatten();
        self.costs.bytes()
            + self.colony.bytes()
            + self.ways.bytes()
            + self.best.as_ref().map_or(0, |best| held(&best.0))
            + searches.map(OrderSearch::bytes).sum::<usize>()
    }

    fn is_merging(&self) -> bool {
        let most = self.solving.limit / FOR_MERGING;
        let has_ended = |search: &OrderSearch| search.is_done() || search.trees() >= most;
        self.solving.merge && most > 0 && !self.merging.as_ref().is_some_and(has_ended)
    }

    fn is_proving(&self) -> bool {
        let has_ended = |proof: &OrderSearch| proof.is_done() || self.trees >= self.solving.limit;
        self.solving.prove && self.solving.limit > 0 && !self.proof.as_ref().is_some_and(has_ended)
    }

    fn walk(&mut self) {
        let tours = self.colony.construct();
        for tour in &tours {
            let mut order = tour.order.clone();
            if self.solving.merge {
                order = improved(&self.costs, self.shape, &order);
                self.ways.take(&order);
            }
            self.take(order);
        }
        self.colony.learn(tours);
    }

    /// Takes in an order where it is the cheapest so far.
    fn take(&mut self, order: Vec<u32>) {
        let cost = self.costs.total(&order, self.shape);
        if self.best.as_ref().is_none_or(|best| cost < best.1) {
            self.best = Some((order, cost));
        }
    }

    fn merge(&mut self) {
        let Some((best, _)) = &self.best else { return };
        if self.merging.is_none() {
            self.merging = OrderSearch::merging(&self.costs, self.shape, best, &self.ways);
        }
        let Some(search) = &mut self.merging else { return self.give_up() };
        let before = search.trees();
        search.step(self.solving.limit / FOR_MERGING);
        self.trees += search.trees() - before;
        let order = search.order().to_vec();
        self.take(order);
    }

    fn prove(&mut self) {
        let Some((best, _)) = &self.best else { return };
        if self.proof.is_none() {
            self.proof = OrderSearch::new(&self.costs, self.shape, best);
        }
        let Some(search) = &mut self.proof else { return self.give_up() };
        let before = search.trees();
        search.step(before + self.solving.limit - self.trees.min(self.solving.limit));
        self.trees += search.trees() - before;
        let order = search.order().to_vec();
        self.take(order);
    }

    /// Costs that no search takes: the ants' order stands.
    fn give_up(&mut self) {
        self.solving = Solving::NONE;
    }
}
