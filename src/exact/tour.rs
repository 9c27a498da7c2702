//! The exact tour by several goals: lengths of the shortest paths between all of them, the best order by Held and Karp (see
//! [`super::order`]), and a shortest path for each leg by A*.
//!
//! Beyond [`order::MAX_ORDERED`] goals the order is looked for by branch and bound ([`OrderSearch`]), as far as it may: then the tour is the best, or a
//! good one with a bound.
//!
//! A tour of straight lines is not offered here: its order would be proven for lines that walls may cut, and not for what is walked.

use std::sync::Arc;

use super::SEARCH;
use super::astar::Distance;
use super::order::{self, Costs, OrderSearch, Shape, good_order, held_karp, nodes};
#[cfg(feature = "whole")]
use super::proof::{self, surely};
use super::search::{EVERYWHERE, Search};
use crate::error::ParamError;
use crate::map::Cell;
use crate::params::{Params, Values};
use crate::path::Path;
#[cfg(feature = "whole")]
use crate::planner::Certificate;
use crate::planner::{Effort, Granularity, Layer, Objective, Planner, PlannerEntry, Progress, Record, Solution, Status, nested};
use crate::scenario::{MAX_GOALS, Scenario};
use crate::{param_choice, params};

param_choice! {
    /// What the order of the goals makes smallest.
    pub enum Smallest {
        /// Σ R, the length of each leg times the weight b = 1/(s·w·a) of the goal that it leads to
        Weight = "weight",
        /// the length of the whole tour
        Length = "length",
    }
}

params! {
    /// Parameters of the exact tour.
    pub struct TourParams {
        /// what is made smallest, where there are several goals
        objective: Smallest = Smallest::Weight, "", [], "", "fire-fighting paper, eq. 6–7";
        /// 1-trees after which the search for the best order of more than 16 goals ends
        order_limit: u32 = 50_000, "", [1..=1_000_000], "1-trees", "our choice";
    }
}

/// The exact tour at work: first a search from each node but the last to all others, then a search for each leg.
#[derive(Clone)]
struct ExactTour {
    scenario: Arc<Scenario>,
    objective: Objective,
    /// Most 1-trees of the search for the order.
    limit: u64,
    /// That search, where there are many goals.
    ordering: Option<Box<OrderSearch>>,
    /// Distances between the nodes, a row for each search that has ended.
    rows: Vec<Vec<f64>>,
    /// The legs that are found.
    legs: Vec<Path>,
    search: Search<Distance>,
    progress: Progress,
}

impl ExactTour {
    fn new(scenario: Arc<Scenario>, objective: Objective, limit: u64) -> Self {
        let search = Search::between(Arc::clone(&scenario), scenario.start, EVERYWHERE, Distance::unknown(&scenario));
        let (rows, legs, progress) = (Vec::new(), Vec::new(), Progress::default());
        Self { scenario, objective, limit, ordering: None, rows, legs, search, progress }
    }

    /// Goes on to the next search, to the walk, or to the end.
    fn end_search(&mut self) {
        if self.progress.tour.is_none() {
            let costs = self.search.costs();
            self.rows.push(nodes(&self.scenario).iter().map(|&c| costs[c as usize]).collect());
        } else if let Some(leg) = self.search.best() {
            self.legs.push(leg.path.clone());
        }
        if self.rows[0].iter().any(|d| d.is_infinite()) {
            self.progress.status = Status::NoPath;
        } else if self.rows.len() < self.scenario.goals.len() {
            self.look_for(nodes(&self.scenario)[self.rows.len()], EVERYWHERE);
        } else if self.progress.tour.is_none() {
            self.choose_order();
        } else {
            self.walk();
        }
    }

    /// The best order at once, or the search for it.
    fn choose_order(&mut self) {
        let lengths = Costs::symmetric(&self.rows);
        let weighted = (self.objective == Objective::TourWeight).then(|| lengths.weighted(&self.scenario));
        let costs = weighted.as_ref().unwrap_or(&lengths);
        if let Some(order) = held_karp(costs, Shape::Open) {
            return self.walk_in(order);
        }
        let good = good_order(costs, Shape::Open);
        self.ordering = OrderSearch::new(costs, Shape::Open, &good).map(Box::new);
        if self.ordering.is_none() {
            self.walk_in(good);
        }
    }

    /// One step of the search for the order, or all of them; then to the legs.
    fn order(&mut self, by: Granularity) {
        let Some(search) = &mut self.ordering else { return };
        match by {
            Granularity::Move => search.step(self.limit),
            Granularity::Iteration => _ = search.go_on(self.limit),
        }
        if search.is_done() || search.trees() >= self.limit {
            let order = search.order().to_vec();
            self.walk_in(order);
        }
    }

    fn walk_in(&mut self, order: Vec<u32>) {
        let lengths = Costs::symmetric(&self.rows);
        self.progress.tour = Some(order::planned(&self.scenario, &lengths, order));
        self.walk();
    }

    fn look_for(&mut self, from: Cell, to: Cell) {
        let scenario = &self.scenario;
        let bound = if to == EVERYWHERE { Distance::unknown(scenario) } else { Distance::to(scenario, to) };
        self.search = Search::between(Arc::clone(&self.scenario), from, to, bound);
    }

    /// Begins the next leg, or ends.
    fn walk(&mut self) {
        let scenario = &self.scenario;
        let Some(tour) = &self.progress.tour else { return };
        let goal = |leg: usize| tour.order.get(leg).map(|&g| scenario.goals[g as usize]);
        let from = self.legs.len().checked_sub(1).and_then(goal).unwrap_or(scenario.start);
        match goal(self.legs.len()) {
            Some(to) => self.look_for(from, to),
            None => self.finish(),
        }
    }

    fn finish(&mut self) {
        let walked = self.legs.iter().map(|leg| self.scenario.path_length(leg)).collect();
        if let Some(tour) = &mut self.progress.tour {
            order::walk(&self.scenario, tour, walked);
        }
        let path = order::join(&self.legs);
        let length = self.scenario.path_length(&path);
        let iteration = self.progress.effort.iterations;
        self.progress.effort.constructed_paths = 1;
        self.progress.best = Some(Solution { path, length, iteration, refined: None });
        let is_proven = self.ordering.as_ref().is_none_or(|search| search.is_proven());
        self.progress.status = if is_proven { Status::Optimal } else { Status::BudgetSpent };
    }

    /// Adds contours to the history.
    fn record(&mut self, iterations: std::ops::RangeInclusive<u32>) {
        for iteration in iterations {
            let length = self.progress.best.as_ref().filter(|b| b.iteration == iteration).map(|b| b.length);
            self.progress.record(Record::of_search(iteration, length));
        }
    }
}

impl Planner for ExactTour {
    /// A move expands one cell or is one step of the search for the order, an iteration is one contour of the search at work or all of that.
    fn advance(&mut self, by: Granularity) -> Status {
        if self.progress.status.is_finished() {
            return self.progress.status;
        }
        if self.ordering.is_some() && self.progress.tour.is_none() {
            self.order(by);
            return self.progress.status;
        }
        let before = self.search.effort();
        let ended = self.search.advance(by).is_finished();
        let now = self.search.effort();
        let effort = &mut self.progress.effort;
        let first = effort.iterations + 1;
        *effort = Effort {
            iterations: effort.iterations + now.iterations - before.iterations,
            cell_expansions: effort.cell_expansions + now.cell_expansions - before.cell_expansions,
            ..*effort
        };
        let last = effort.iterations;
        if ended {
            self.end_search();
        }
        self.record(first..=last);
        self.progress.status
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn bytes(&self) -> usize {
        let search = self.search.bytes() - size_of::<Search<Distance>>();
        let ordering = self.ordering.as_ref().map_or(0, |search| size_of::<OrderSearch>() + search.bytes());
        size_of::<Self>() + self.progress.bytes() + nested(&self.rows) + nested(&self.legs) + search + ordering
    }

    fn objective(&self) -> Objective {
        self.objective
    }

    /// What the search for the order has proven; without one the best order is known before its legs are walked: what that promises.
    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        let (tour, is_weight) = (self.progress.tour.as_ref(), self.objective == Objective::TourWeight);
        let walked = || if is_weight { tour?.walked_weight } else { self.best().map(|best| best.length) };
        let promised = || tour.map(|tour| surely(if is_weight { tour.planned_weight } else { tour.planned_length }));
        let bound = || self.ordering.as_ref().map_or_else(promised, |search| Some(search.lower_bound()));
        proof::certificate(&self.progress, walked, bound)
    }

    /// Of the search at work; once finished, of the last leg's.
    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        self.search.layer(kind, out)
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let params = TourParams::read(ENTRY.id, values)?;
    let scenario = Arc::clone(scenario);
    if scenario.goals.len() == 1 {
        let distance = Distance::of(&scenario);
        return Ok(Box::new(Search::new(scenario, distance)));
    }
    let objective = match params.objective {
        Smallest::Weight => Objective::TourWeight,
        Smallest::Length => Objective::TourLength,
    };
    Ok(Box::new(ExactTour::new(scenario, objective, params.order_limit.into())))
}

/// The exact tour in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "tour-exact",
    name: "Exact tour",
    summary: "The proven best order of up to 16 goals, by weight or by length, with a shortest path for each leg; of more goals a good order and a bound.",
    source: "Held, Karp 1962, J. SIAM 10, 196–210, doi:10.1137/0110015, and 1971, Math. Program. 1, 6–25, doi:10.1007/BF01584070; legs by A*",
    max_goals: MAX_GOALS as u32,
    specs: TourParams::specs,
    build,
    ..SEARCH
};
