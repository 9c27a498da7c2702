//! The order of several goals by ants on a complete graph: a small Ant System for tours, with the random proportional or the
//! pseudo-random proportional rule. Which costs its edges have decides what the order makes small.
//!
//! Dorigo, Maniezzo, Colorni 1996 for the travelling salesman; here tours are open unless told otherwise. Trails and costs are directed:
//! the weighted cost of an edge depends on the goal that it leads to.

use rand::Rng;

use super::weights::power;
use crate::exact::order::{Costs, Shape};
use crate::planner::held;
use crate::rng::{Stream, Streams, unit_f32};

/// Costs below this count as this: two nodes may share a cell, and η = 1 / cost.
const NEAREST: f64 = 1e-9;
/// No trail evaporates below this.
const TRAIL_FLOOR: f64 = 1e-30;
/// Smallest weight of a node that is left: it can always be chosen when nothing else is.
const WEIGHT_FLOOR: f64 = 1e-300;

/// Numbers of an order colony.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TourSettings {
    /// m, tours per iteration.
    pub ants: u32,
    /// K, iterations.
    pub iterations: u32,
    /// α, weight of the trail.
    pub alpha: f64,
    /// β, weight of the heuristic.
    pub beta: f64,
    /// ρ, the part of the trail that leaves in each iteration.
    pub rho: f64,
    /// Q of the deposit Q/L.
    pub deposit: f64,
    /// τ of every edge before the first iteration.
    pub initial_trail: f64,
    /// Probability of taking the best edge instead of drawing one; none for the random proportional rule.
    pub exploit: Option<f64>,
}

/// A tour and what it costs.
#[derive(Debug, Clone, PartialEq)]
pub struct Ordered {
    /// The goals from 0, in visiting order.
    pub order: Vec<u32>,
    /// Σ of its edges.
    pub cost: f64,
    /// The iteration (from 1) that found it.
    pub iteration: u32,
}

/// An order colony at work.
#[derive(Debug, Clone)]
pub struct OrderColony {
    costs: Costs,
    shape: Shape,
    settings: TourSettings,
    streams: Streams,
    /// τ by edge, from · nodes + to.
    trails: Vec<f64>,
    iterations: u32,
    best: Option<Ordered>,
}

/// η of an edge: 1 / cost (fire-fighting paper, Eq. 8, over Eq. 6; with lengths for costs, its basic heuristic).
pub fn heuristic(cost: f64) -> f64 {
    1.0 / cost.max(NEAREST)
}

impl OrderColony {
    /// A colony on a complete graph of at least two nodes; node 0 is the start.
    pub fn new(costs: Costs, shape: Shape, settings: TourSettings, streams: Streams) -> Self {
        let trails = vec![settings.initial_trail; costs.nodes() * costs.nodes()];
        Self { costs, shape, settings, streams, trails, iterations: 0, best: None }
    }

    /// One iteration: every ant builds a tour, then trails are updated.
    pub fn advance(&mut self) {
        let tours = self.construct();
        self.learn(tours);
    }

    /// The first half of an iteration: every ant builds a tour.
    pub(super) fn construct(&mut self) -> Vec<Ordered> {
        self.iterations += 1;
        let weights = self.weights();
        let build = |ant| self.build(&weights, &mut self.streams.ant(self.iterations, ant));
        (0..self.settings.ants).map(build).collect()
    }

    /// The other half: trails follow these tours, and the cheapest is kept.
    pub(super) fn learn(&mut self, tours: Vec<Ordered>) {
        self.update_trails(&tours);
        for tour in tours {
            if self.best.as_ref().is_none_or(|best| tour.cost < best.cost) {
                self.best = Some(tour);
            }
        }
    }

    /// The cheapest tour so far; the first found of equals.
    pub fn best(&self) -> Option<&Ordered> {
        self.best.as_ref()
    }

    /// Iterations done.
    pub fn iterations(&self) -> u32 {
        self.iterations
    }

    /// Whether the budget of iterations is spent.
    pub fn is_finished(&self) -> bool {
        self.iterations >= self.settings.iterations
    }

    /// What it holds beside its costs, in bytes; of both as many as there are pairs of nodes.
    pub fn bytes(&self) -> usize {
        3 * held(&self.trails) + self.best.as_ref().map_or(0, |best| held(&best.order))
    }

    /// τ of the edge from node i to node j.
    pub fn trail(&self, i: usize, j: usize) -> f64 {
        self.trails[i * self.costs.nodes() + j]
    }

    /// τ^α·η^β of every edge, both divided by the largest of the node's edges first, as on the grid.
    fn weights(&self) -> Vec<f64> {
        let n = self.costs.nodes();
        let mut weights = vec![0.0; n * n];
        for i in 0..n {
            let others = || (0..n).filter(move |&j| j != i);
            let tau = others().fold(TRAIL_FLOOR, |m, j| m.max(self.trail(i, j)));
            let eta = others().fold(0.0, |m: f64, j| m.max(heuristic(self.costs.get(i, j))));
            for j in others() {
                let strength = power(self.trail(i, j) / tau, self.settings.alpha);
                let sight = power(heuristic(self.costs.get(i, j)) / eta, self.settings.beta);
                weights[i * n + j] = (strength * sight).max(WEIGHT_FLOOR);
            }
        }
        weights
    }

    /// One ant's tour from the start by all goals.
    fn build(&self, weights: &[f64], stream: &mut Stream) -> Ordered {
        let n = self.costs.nodes();
        let mut left: Vec<usize> = (1..n).collect();
        let mut order = Vec::with_capacity(left.len());
        let mut at = 0;
        while !left.is_empty() {
            let row: Vec<f64> = left.iter().map(|&j| weights[at * n + j]).collect();
            at = left.remove(choose(&row, self.settings.exploit, stream));
            order.push(at as u32 - 1);
        }
        Ordered { cost: self.costs.total(&order, self.shape), order, iteration: self.iterations }
    }

    /// τ ← (1 − ρ)·τ + Σ Q/L over all ants, on the edges of their tours.
    fn update_trails(&mut self, tours: &[Ordered]) {
        let (n, s) = (self.costs.nodes(), &self.settings);
        self.trails.iter_mut().for_each(|t| *t = (*t * (1.0 - s.rho)).max(TRAIL_FLOOR));
        for tour in tours {
            let back = (self.shape == Shape::Closed).then_some(0);
            let mut at = 0;
            for to in tour.order.iter().map(|&g| g as usize + 1).chain(back) {
                self.trails[at * n + to] += s.deposit / tour.cost.max(NEAREST);
                at = to;
            }
        }
    }
}

/// Which of the candidates is next, all of positive weight: with probability `exploit` the first of the largest, else one in proportion
/// to its weight (Eq. 9 and 3). Draws r first, and for the random proportional rule a second number, as on the grid.
pub fn choose(weights: &[f64], exploit: Option<f64>, stream: &mut Stream) -> usize {
    let unit = |stream: &mut Stream| f64::from(unit_f32(stream.next_u32()));
    if exploit.is_some_and(|r0| unit(stream) <= r0) {
        return (1..weights.len()).fold(0, |best, j| if weights[j] > weights[best] { j } else { best });
    }
    let threshold = unit(stream) * weights.iter().sum::<f64>();
    let mut sum = 0.0;
    let above = weights.iter().position(|w| {
        sum += w;
        sum > threshold
    });
    // u < 1, but the sum may round down to the threshold.
    above.unwrap_or(weights.len() - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SETTINGS: TourSettings = TourSettings {
        ants: 10,
        iterations: 20,
        alpha: 1.0,
        beta: 2.0,
        rho: 0.3,
        deposit: 1.0,
        initial_trail: 1.0,
        exploit: Some(0.7),
    };

    fn colony(costs: Costs, settings: TourSettings) -> OrderColony {
        OrderColony::new(costs, Shape::Open, settings, Streams::new(1, "test", 0))
    }

    #[test]
    fn every_tour_visits_every_goal_once() {
        let mut colony = colony(Costs::new(8, |i, j| i.abs_diff(j) as f64), SETTINGS);
        while !colony.is_finished() {
            colony.advance();
            let mut order = colony.best().expect("ants build tours").order.clone();
            order.sort_unstable();
            assert_eq!(order, (0..7).collect::<Vec<_>>());
        }
        // On a line from 0 to 7 the best is to walk along it.
        let best = colony.best().expect("ants build tours");
        assert_eq!((best.order.clone(), best.cost), ((0..7).collect(), 7.0));
    }

    #[test]
    fn extremes_leave_trails_and_weights_usable() {
        for (cost, rho, beta, alpha) in
            [(0.0, 1.0, 50.0, 10.0), (1e12, 1.0, 50.0, 10.0), (1e-12, 0.0, 0.0, 0.0), (5000.0, 0.5, 50.0, 1.0)]
        {
            let costs = Costs::new(5, |i, j| if i + j == 3 { 1.0 } else { cost });
            let mut colony = colony(costs, TourSettings { rho, beta, alpha, exploit: None, ..SETTINGS });
            for _ in 0..300 {
                colony.advance();
            }
            assert!(colony.weights().iter().all(|w| w.is_finite()), "{cost} {rho}");
            assert!(colony.trails.iter().all(|t| t.is_finite() && *t > 0.0), "{cost} {rho}");
        }
    }
}
