//! Order problems: looked at, and ordered by ants step by step.

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::{Bytes, Flag, Number, ParamValues};
use super::{Answer, object, throw};
use crate::aco::order_run::{self, ORDER_COLONY, OrderParams};
use crate::comparison::gap::relative_gap;
use crate::error::FormatError;
use crate::exact::order::{OrderSearch, Shape};
use crate::exact::order_problem::{LISTED_SOURCE, OrderProblem};
use crate::formats::tsplib;
use crate::params::{ParamSpec, Params};

/// A tour and its cost.
#[derive(Serialize, Tsify)]
pub struct PlacesInOrder {
    /// What it costs.
    pub cost: f64,
    /// The places from 0, beginning with the first.
    pub order: Vec<u32>,
}

/// What an instance of TSPLIB holds, and what is known of its best tour.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct OrderFacts {
    /// Its name; may be empty.
    pub name: String,
    /// What its file says of it; may be empty.
    pub comment: String,
    /// How many places there are.
    pub places: u32,
    /// How its file gives costs, e.g. `EUC_2D`.
    pub weight_type: String,
    /// Where to draw each place, x to the right and y upwards; null where nothing tells.
    #[tsify(type = "[number, number][] | null")]
    pub at: Option<Vec<[f64; 2]>>,
    /// The proven best tour; null for more places than can be proven.
    pub exact: Option<PlacesInOrder>,
    /// Most places that can be proven.
    pub most_proven: u32,
    /// The best closed tour's length, where it is listed.
    pub listed_optimum: Option<f64>,
    /// Where it is listed.
    pub listed_source: String,
    /// The tour that came with the instance.
    pub tour: Option<PlacesInOrder>,
    /// The parameters of the order colony.
    pub params: Vec<ParamSpec>,
}

/// Where a run of the order colony stands.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct OrderSummary {
    /// Iterations done.
    pub iteration: u32,
    /// Iterations that it may do.
    pub budget: u32,
    /// The best tour so far; null before the first iteration.
    pub best: Option<PlacesInOrder>,
    /// The iteration that found it.
    pub iteration_of_best: Option<u32>,
    /// Its distance to the proven or listed optimum, as a part of that; null where neither is known.
    pub gap: Option<f64>,
    /// Every improvement: iteration from 1, and cost.
    #[tsify(type = "[number, number][]")]
    pub improvements: Vec<(u32, f64)>,
    /// 16 hexadecimal digits over the best tour and all improvements.
    pub digest: String,
}

/// What a search has found and proven where dynamic programming does not reach.
#[derive(Serialize, Tsify)]
pub struct OrderBound {
    /// No tour costs less.
    pub lower_bound: f64,
    /// The best tour that it knows.
    pub best: PlacesInOrder,
    /// Whether no tour is better than that one.
    pub complete: bool,
    /// 1-trees that it took.
    pub trees: u32,
    /// Whether it is at its end: it is proven, or has found as many 1-trees as it may.
    pub finished: bool,
}

/// An order as places from 0.
fn placed(cost: f64, order: &[u32]) -> PlacesInOrder {
    PlacesInOrder { cost, order: std::iter::once(0).chain(order.iter().map(|place| place + 1)).collect() }
}

fn problem(bytes: &Bytes, open: &Flag) -> Answer<OrderProblem> {
    let mut problem = tsplib::read_instance(&bytes.read("bytes")?).map_err(throw)?;
    problem.shape = if open.read("open")? { Shape::Open } else { Shape::Closed };
    Ok(problem)
}

/// Looks at an instance of TSPLIB, and at a tour of it; tours return to their first place unless they are `open`.
#[wasm_bindgen]
pub fn read_order(bytes: &Bytes, open: &Flag, tour: Option<Bytes>) -> Answer<Ts<OrderFacts>> {
    let problem = problem(bytes, open)?;
    let given = tour.map(|bytes| bytes.read("tour")).transpose()?;
    let read = |bytes: Vec<u8>| -> Result<PlacesInOrder, FormatError> {
        let order = tsplib::read_tour(&bytes, &problem)?;
        Ok(placed(problem.cost(&order), &order))
    };
    let tour = given.map(read).transpose().map_err(throw)?;
    Ok(object(&OrderFacts {
        places: problem.len() as u32,
        exact: problem.prove().map(|proven| placed(proven.cost, &proven.order)),
        most_proven: crate::exact::order::MAX_ORDERED as u32 + 1,
        listed_optimum: problem.listed_optimum(),
        listed_source: LISTED_SOURCE.into(),
        tour,
        params: OrderParams::specs(),
        name: problem.name,
        comment: problem.comment,
        weight_type: problem.weight_type,
        at: problem.places,
    }))
}

/// The order colony at work on an instance.
#[wasm_bindgen]
pub struct OrderRun {
    run: order_run::OrderRun,
    problem: OrderProblem,
    optimum: Option<f64>,
    /// From the best tour of these iterations on.
    search: Option<OrderSearch>,
}

#[wasm_bindgen]
impl OrderRun {
    /// Makes a run; nothing is computed before the first `advance`. Parameters are those of `OrderFacts`.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &Bytes, open: &Flag, params: &ParamValues, seed: &Number) -> Answer<OrderRun> {
        let problem = problem(bytes, open)?;
        let params = OrderParams::read(ORDER_COLONY, &params.read("params")?).map_err(throw)?;
        let optimum = problem.prove().map(|proven| proven.cost).or(problem.listed_optimum());
        let run = order_run::OrderRun::new(&problem, &params, seed.whole("seed")?);
        Ok(OrderRun { run, problem, optimum, search: None })
    }

    /// Up to `count` iterations; false once the budget is spent.
    pub fn advance(&mut self, count: &Number) -> Answer<bool> {
        for _ in 0..count.whole("count")? {
            if self.run.is_finished() {
                break;
            }
            self.run.advance();
            self.search = None;
        }
        Ok(!self.run.is_finished())
    }

    /// Where the run stands.
    pub fn summary(&self) -> Ts<OrderSummary> {
        let best = self.run.best();
        object(&OrderSummary {
            iteration: self.run.iteration(),
            budget: self.run.budget(),
            iteration_of_best: best.map(|best| best.iteration),
            gap: best.zip(self.optimum).map(|(best, optimum)| relative_gap(best.cost, optimum)),
            best: best.map(|best| placed(best.cost, &best.order)),
            improvements: self.run.improvements().to_vec(),
            digest: self.run.digest().hex(),
        })
    }

    /// One step of a search for a better tour and for a proof, from the best tour so far on: what the command line tells when it is at its end.
    /// Null before the first iteration, and where `OrderFacts.exact` is known.
    pub fn search(&mut self) -> Option<Ts<OrderBound>> {
        let most = self.problem.usual_trees();
        if self.search.is_none() {
            self.search = self.problem.search(&self.run.best()?.order);
        }
        let search = self.search.as_mut()?;
        let is_at_end = |search: &OrderSearch| search.is_done() || search.trees() >= most;
        if !is_at_end(search) {
            search.step(most);
        }
        Some(object(&OrderBound {
            lower_bound: search.lower_bound(),
            best: placed(search.cost(), search.order()),
            complete: search.is_proven(),
            trees: u32::try_from(search.trees()).unwrap_or(u32::MAX),
            finished: is_at_end(search),
        }))
    }

    /// The strongest trails, three numbers each: from and to (places from 0), and the share of the largest.
    pub fn trails(&self) -> Vec<f64> {
        self.run.strong_trails().into_iter().flat_map(|(from, to, share)| [f64::from(from), f64::from(to), share]).collect()
    }
}
