//! One run of a comparison: instance × entry × seed.

use std::sync::Arc;

use crate::catalog;
use crate::metrics::Metrics;
use crate::planner::{Effort, Granularity, Objective, Planner, Solution, Status};
use crate::scenario::Scenario;

use super::check::QuestionError;
use super::question::{Axis, Budget, Entry};
use super::row::{Found, Improvement, Row, Spent, Task};

/// A clock's reading in seconds, from any beginning. Engines have none: who runs a task brings one.
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
    built.map(Some).map_err(|error| QuestionError::planner(entry, error))
}

/// Runs a planner to its end, or to the budget's.
pub(super) fn run(task: Task, scenario: &Scenario, mut planner: Box<dyn Planner>, budget: Option<Budget>, clock: Clock) -> Timed {
    let began = clock();
    let mut log = Log::default();
    let status = loop {
        let status = planner.advance(Granularity::Iteration);
        let spent = budget.map(|b| (amount(planner.effort(), b.axis), b.amount));
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
    let digest = planner.digest().hex();
    let found = log.best.map(|best| found(scenario, &best, log.weight, log.trace.last()));
    Timed { row: Row { task, status, found, effort: planner.effort().into(), trace: log.trace, digest }, seconds: log.seconds }
}

/// What an effort amounts to on an axis; nothing by time.
fn amount(effort: Effort, axis: Axis) -> u64 {
    match axis {
        Axis::Iterations => effort.iterations.into(),
        Axis::ConstructedPaths => effort.constructed_paths,
        Axis::AntMoves => effort.ant_moves,
        Axis::CellExpansions => effort.cell_expansions,
        Axis::Moves => effort.ant_moves + effort.cell_expansions,
        Axis::Time => 0,
    }
}

/// The improvements of a run, and its best path that counts.
#[derive(Default)]
struct Log {
    trace: Vec<Improvement>,
    seconds: Vec<f64>,
    best: Option<Solution>,
    weight: Option<f64>,
}

impl Log {
    fn note(&mut self, scenario: &Scenario, planner: &dyn Planner, elapsed: impl FnOnce() -> f64) {
        let Some(best) = planner.best() else { return };
        if self.best.as_ref().is_some_and(|known| known.iteration == best.iteration) {
            return;
        }
        let (weight, value) = (planner.tour().and_then(|t| t.walked_weight), value(scenario, planner, best));
        // The iteration that found it, which is none where no search was needed.
        let spent = Spent { iterations: Some(best.iteration.into()), ..planner.effort().into() };
        self.trace.push(Improvement { value, spent });
        self.seconds.push(elapsed());
        (self.best, self.weight) = (Some(best.clone()), weight);
    }
}

/// The best path's value by the planner's own objective. Metrics are taken only where it is one of them: they look at every cell.
fn value(scenario: &Scenario, planner: &dyn Planner, best: &Solution) -> f64 {
    let (path, length) = best.result();
    match planner.objective() {
        Objective::TurnIndex => Metrics::of(scenario, path).turn_index,
        Objective::TourWeight => planner.tour().and_then(|t| t.walked_weight).unwrap_or(length),
        Objective::Length | Objective::PolylineLength | Objective::SliceCost | Objective::TourLength => length,
    }
}

fn found(scenario: &Scenario, best: &Solution, weight: Option<f64>, last: Option<&Improvement>) -> Found {
    let m = Metrics::of(scenario, best.result().0);
    let value = last.map_or(m.length, |improvement| improvement.value);
    Found { length: m.length, turns: Some(m.turns), turn_index: Some(m.turn_index), weight, value }
}
