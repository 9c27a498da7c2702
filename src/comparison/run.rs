//! One run of a comparison: instance × entry × seed.

use std::sync::Arc;

use super::budget::Budget;
use super::question::Entry;
use super::row::{Clearance, Found, Improvement, Row, Spent, Task};
use crate::catalog;
use crate::error::QuestionError;
use crate::metrics::Metrics;
use crate::planner::{Granularity, Planner, Status};
use crate::scenario::Scenario;

/// A clock's reading in seconds, from any beginning. The engine has none: the caller brings one.
pub type Clock<'a> = &'a mut dyn FnMut() -> f64;

/// A run that is done, and what no two machines agree on: when.
#[derive(Debug, Clone, PartialEq)]
pub struct Timed {
    /// The run.
    pub row: Row,
    /// Seconds from its beginning to the end of the iteration of each improvement, and to its end: one number more than improvements.
    pub seconds: Vec<f64>,
}

/// The planner of an entry; none where nothing can be run.
pub(super) fn build(scenario: &Arc<Scenario>, entry: &Entry, seed: u32) -> Result<Option<Box<dyn Planner>>, QuestionError> {
    let Some(id) = &entry.planner else { return Ok(None) };
    let built = catalog::build(scenario, id, entry.preset.as_deref(), &entry.set, seed);
    built.map(Some).map_err(|error| QuestionError::planner(&entry.id, error))
}

/// Where a planner runs, for how long, and what is noted of it.
#[derive(Clone, Copy)]
pub(super) struct Asked<'a> {
    pub scenario: &'a Scenario,
    pub budget: Option<Budget>,
    /// Whether rows tell how a path is to drive.
    pub drives: bool,
}

/// Runs a planner to its end, or to the budget's.
pub(super) fn run(task: Task, asked: Asked, mut planner: Box<dyn Planner>, clock: Clock) -> Timed {
    let Asked { scenario, budget, drives } = asked;
    let began = clock();
    let mut log = Log { drives, ..Log::default() };
    let status = loop {
        let status = planner.advance(Granularity::Iteration);
        let spent = budget.and_then(|b| Some((Spent::from(planner.effort()).count(b.axis)?, b.amount)));
        let is_over = spent.is_some_and(|(spent, most)| spent > most);
        if !is_over {
            log.note(scenario, planner.as_ref(), || clock() - began);
        }
        if is_over || (!status.is_finished() && spent.is_some_and(|(spent, most)| spent == most)) {
            break Status::BudgetSpent;
        }
        if status.is_finished() {
            break status;
        }
    };
    log.seconds.push(clock() - began);
    let (digest, effort) = (planner.digest().hex(), planner.effort().into());
    Timed { row: Row { task, status, found: log.found, effort, trace: log.trace, digest }, seconds: log.seconds }
}

/// The improvements of a run, and its best path that counts.
#[derive(Default)]
struct Log {
    trace: Vec<Improvement>,
    seconds: Vec<f64>,
    found: Option<Found>,
    /// The iteration that found it.
    iteration: Option<u32>,
    /// Whether it tells how a path is to drive.
    drives: bool,
}

impl Log {
    fn note(&mut self, scenario: &Scenario, planner: &dyn Planner, elapsed: impl FnOnce() -> f64) {
        let Some(best) = planner.best() else { return };
        if self.iteration == Some(best.iteration) {
            return;
        }
        let (path, length) = best.result();
        let metrics = Metrics::of(scenario, path);
        let value = planner.value(&metrics).unwrap_or(length);
        // The iteration that found it, which is none where no search was needed.
        let spent = Spent { iterations: Some(best.iteration.into()), ..planner.effort().into() };
        self.trace.push(Improvement { value, spent });
        self.seconds.push(elapsed());
        self.iteration = Some(best.iteration);
        self.found = Some(Found {
            length: metrics.length,
            turns: Some(metrics.turns),
            turn_index: Some(metrics.turn_index),
            weight: planner.tour().and_then(|t| t.walked_weight),
            value,
            driving: metrics.driving.filter(|_| self.drives),
            clearance: Some(Clearance { least: metrics.min_clearance, mean: metrics.mean_clearance }),
        });
    }
}
