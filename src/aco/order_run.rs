//! The order colony on an order problem: its parameters, its runs step by step, and what several seeds reach.
//!
//! Ant System for tours (Dorigo and Stützle 2004, section 3.3 and box 3.1), without local search: see [`super::tour`].

use super::tour::{OrderColony, Ordered, TourSettings};
use crate::digest::Digest;
use crate::exact::order_problem::OrderProblem;
use crate::params::{ParamType, Values};
use crate::rng::Streams;
use crate::{param_choice, params};

param_choice! {
    /// How an ant selects the next place.
    pub enum OrderRule {
        /// in proportion to τ^α·η^β
        RandomProportional = "random-proportional",
        /// with probability q0 the best place, else in proportion to τ^α·η^β
        PseudoRandomProportional = "pseudo-random-proportional",
    }
}

params! {
    /// Parameters of the order colony.
    pub struct OrderParams {
        /// how an ant selects the next place
        rule: OrderRule = OrderRule::RandomProportional, "", [], "", "Dorigo and Stützle 2004, eq. 3.2 and 3.10";
        /// ants that build a tour in each iteration
        ants: u32 = 25, "m", [1..=1024], "ants", "our choice; box 3.1: as many as places";
        /// iterations after which the colony stops
        iterations: u32 = 200, "K", [1..=100_000], "iterations", "our choice";
        /// weight of the trail τ in the choice of a place
        alpha: f64 = 1.0, "α", [0.0..=10.0], "", "Dorigo and Stützle 2004, box 3.1";
        /// weight of the heuristic η = 1/cost in the choice of a place
        beta: f64 = 5.0, "β", [0.0..=50.0], "", "Dorigo and Stützle 2004, box 3.1: 2 to 5";
        /// the part of every trail that leaves in each iteration
        rho: f64 = 0.5, "ρ", [0.0..=1.0], "", "Dorigo and Stützle 2004, box 3.1";
        /// by the pseudo-random proportional rule, the probability of taking the best place instead of drawing one
        q0: f64 = 0.7, "q0", [0.0..=1.0], "", "our choice", when(rule: "pseudo-random-proportional");
    }
}

/// The id that names the colony in errors and, with its rule, its random streams.
pub const ORDER_COLONY: &str = "order-colony";

impl OrderParams {
    /// All values by key.
    pub fn values(&self) -> Values {
        let numbers = [
            ("ants", self.ants.value()),
            ("iterations", self.iterations.value()),
            ("alpha", self.alpha.value()),
            ("beta", self.beta.value()),
            ("rho", self.rho.value()),
            ("q0", self.q0.value()),
            ("rule", self.rule.value()),
        ];
        numbers.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
    }

    fn settings(&self) -> TourSettings {
        TourSettings {
            ants: self.ants,
            iterations: self.iterations,
            alpha: self.alpha,
            beta: self.beta,
            rho: self.rho,
            deposit: 1.0,
            initial_trail: 1.0,
            exploit: (self.rule == OrderRule::PseudoRandomProportional).then_some(self.q0),
        }
    }

    fn streams(&self, seed: u32) -> Streams {
        let name = match self.rule {
            OrderRule::RandomProportional => "order-random-proportional",
            OrderRule::PseudoRandomProportional => "order-pseudo-random-proportional",
        };
        Streams::new(seed.into(), name, 0)
    }
}

/// One run of the order colony.
#[derive(Debug, Clone)]
pub struct OrderRun {
    colony: OrderColony,
    budget: u32,
    places: usize,
    /// Every improvement: (iteration from 1, cost).
    improvements: Vec<(u32, f64)>,
}

impl OrderRun {
    /// A run that has not begun; a problem has at least two places.
    pub fn new(problem: &OrderProblem, params: &OrderParams, seed: u32) -> Self {
        let colony = OrderColony::new(problem.costs.clone(), problem.shape, params.settings(), params.streams(seed));
        Self { colony, budget: params.iterations, places: problem.len(), improvements: Vec::new() }
    }

    /// One iteration; none after the last.
    pub fn advance(&mut self) {
        if self.is_finished() {
            return;
        }
        self.colony.advance();
        let reached = self.improvements.last().map_or(f64::INFINITY, |&(_, cost)| cost);
        if let Some(best) = self.colony.best().filter(|best| best.cost < reached) {
            self.improvements.push((best.iteration, best.cost));
        }
    }

    /// To the end of the budget.
    pub fn run(&mut self) {
        while !self.is_finished() {
            self.advance();
        }
    }

    /// Whether the budget of iterations is spent.
    pub fn is_finished(&self) -> bool {
        self.colony.is_finished()
    }

    /// Iterations done.
    pub fn iteration(&self) -> u32 {
        self.colony.iterations()
    }

    /// Iterations that it may do.
    pub fn budget(&self) -> u32 {
        self.budget
    }

    /// The cheapest tour so far; none before the first iteration.
    pub fn best(&self) -> Option<&Ordered> {
        self.colony.best()
    }

    /// Every improvement: (iteration from 1, cost).
    pub fn improvements(&self) -> &[(u32, f64)] {
        &self.improvements
    }

    /// The strongest trails: (from, to, share of the largest), of every place those five to others that are at least a twentieth of the
    /// largest of all; of equals the first.
    pub fn strong_trails(&self) -> Vec<(u32, u32, f64)> {
        const MOST: usize = 5;
        const LEAST: f64 = 0.05;
        let n = self.places;
        let ways = |i: usize| (0..n).filter(move |&j| j != i);
        let largest = (0..n).flat_map(|i| ways(i).map(move |j| self.colony.trail(i, j))).fold(0.0, f64::max);
        let of = |i: usize| {
            let mut shares: Vec<(u32, u32, f64)> =
                ways(i).map(|j| (i as u32, j as u32, self.colony.trail(i, j) / largest)).filter(|way| way.2 >= LEAST).collect();
            shares.sort_by(|a, b| b.2.total_cmp(&a.2));
            shares.truncate(MOST);
            shares
        };
        (0..n).flat_map(of).collect()
    }

    /// Over the iterations, the best tour and every improvement: equal digests mean equal runs.
    pub fn digest(&self) -> Digest {
        let mut digest = Digest::default();
        digest.u32(self.iteration());
        if let Some(best) = self.best() {
            best.order.iter().for_each(|&place| digest.u32(place));
            digest.f64(best.cost);
        }
        for &(iteration, cost) in &self.improvements {
            digest.u32(iteration);
            digest.f64(cost);
        }
        digest
    }
}
