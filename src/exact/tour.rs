//! The exact tour by several goals: lengths of the shortest paths between all of them, the best order by Held and Karp (see
//! [`super::order`]), and a shortest path for each leg by A*.
//!
//! A tour of straight lines is not offered here: its order would be proven for lines that walls may cut, and not for what is walked.

use std::sync::Arc;

use super::SEARCH;
use super::astar::Distance;
use super::order::{self, Costs, MAX_ORDERED, Shape, held_karp, nodes};
use super::search::{EVERYWHERE, Search};
use crate::error::ParamError;
use crate::map::Cell;
use crate::params::{Params, Values};
use crate::path::Path;
use crate::planner::{Effort, Granularity, Layer, Objective, Planner, PlannerEntry, Progress, Record, Solution, Status, nested};
use crate::scenario::Scenario;
#[cfg(feature = "whole")]
use crate::{
    exact::proof::{self, surely},
    planner::Certificate,
};
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
    }
}

/// The exact tour at work: first a search from each node but the last to all others, then a search for each leg.
#[derive(Clone)]
struct ExactTour {
    scenario: Arc<Scenario>,
    objective: Objective,
    /// Distances between the nodes, a row for each search that has ended.
    rows: Vec<Vec<f64>>,
    /// The legs that are found.
    legs: Vec<Path>,
    search: Search<Distance>,
    progress: Progress,
}

impl ExactTour {
    fn new(scenario: Arc<Scenario>, objective: Objective) -> Self {
        let search = Search::between(Arc::clone(&scenario), scenario.start, EVERYWHERE, Distance::unknown(&scenario));
        let (rows, legs, progress) = (Vec::new(), Vec::new(), Progress::default());
        Self { scenario, objective, rows, legs, search, progress }
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
        } else {
            self.walk();
        }
    }

    fn look_for(&mut self, from: Cell, to: Cell) {
        let scenario = &self.scenario;
        let bound = if to == EVERYWHERE { Distance::unknown(scenario) } else { Distance::to(scenario, to) };
        self.search = Search::between(Arc::clone(&self.scenario), from, to, bound);
    }

    /// Begins the next leg, or ends.
    fn walk(&mut self) {
        let scenario = &self.scenario;
        let tour = self.progress.tour.get_or_insert_with(|| {
            let lengths = Costs::symmetric(&self.rows);
            let weighted = (self.objective == Objective::TourWeight).then(|| lengths.weighted(scenario));
            let order = held_karp(weighted.as_ref().unwrap_or(&lengths), Shape::Open).unwrap_or_default();
            order::planned(scenario, &lengths, order)
        });
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
        self.progress.status = Status::Optimal;
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
    /// A move expands one cell, an iteration is one contour of the search at work.
    fn advance(&mut self, by: Granularity) -> Status {
        if self.progress.status.is_finished() {
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
        size_of::<Self>() + self.progress.bytes() + nested(&self.rows) + nested(&self.legs) + search
    }

    fn objective(&self) -> Objective {
        self.objective
    }

    /// The best order is proven before its legs are walked: no tour comes to less than it promises.
    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        let tour = self.progress.tour.as_ref()?;
        let is_weight = self.objective == Objective::TourWeight;
        let walked = || if is_weight { tour.walked_weight } else { self.best().map(|best| best.length) };
        let promised = if is_weight { tour.planned_weight } else { tour.planned_length };
        proof::certificate(&self.progress, walked, || Some(surely(promised)))
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
    Ok(Box::new(ExactTour::new(scenario, objective)))
}

/// The exact tour in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "tour-exact",
    name: "Exact tour",
    summary: "The proven best order of up to 16 goals, by weight or by length, with a shortest path for each leg.",
    source: "Held, Karp 1962, J. SIAM 10, 196–210, doi:10.1137/0110015; legs by A*",
    max_goals: MAX_ORDERED as u32,
    specs: TourParams::specs,
    build,
    ..SEARCH
};
