//! One run of an experiment: instance × entry × seed.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::catalog;
use crate::digest::Digest;
use crate::exact::{self, Reference};
use crate::metrics::Metrics;
use crate::planner::{Granularity, Objective, Planner, Status};
use crate::scenario::Scenario;

use super::check::QuestionError;
use super::question::{Contender, Measure, Question};

/// A question with its maps, ready to run.
#[derive(Debug)]
pub struct Experiment {
    /// What is asked.
    pub question: Question,
    /// One map for each instance of the question.
    pub maps: Vec<Map>,
}

/// The map of an instance.
#[derive(Debug)]
pub struct Map {
    /// Map, start, goal, movement.
    pub scenario: Arc<Scenario>,
    /// For each entry of the question, what it is to achieve here; none where nothing can be run.
    pub yardsticks: Vec<Option<Yardstick>>,
}

/// What an entry's results are measured by, and the best that there is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Yardstick {
    /// What counts.
    pub objective: Objective,
    /// Its best value, in cells.
    pub reference: Reference,
}

/// One run that is to be done; tasks are in the order of the rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Task {
    /// Which instance of the question.
    pub instance: usize,
    /// Which entry.
    pub entry: usize,
    /// Its seed.
    pub seed: u32,
}

/// One run that is done. A run without a path is a row as well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// What was run.
    pub task: Task,
    /// How it ended.
    pub status: Status,
    /// What it found.
    pub found: Option<Found>,
    /// Moves of all its ants.
    pub ant_moves: u64,
    /// Digest over history and best path, 16 hexadecimal digits.
    pub digest: String,
}

/// The path of a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Found {
    /// Its length in cells.
    pub length: f64,
    /// Its turns.
    pub turns: u32,
    /// V(d, r) in cells.
    pub turn_index: f64,
    /// Σ R in cells, of a tour by several goals.
    pub weight: Option<f64>,
    /// Its value by the planner's own objective, in cells.
    pub value: f64,
    /// The iteration that found it, from 1.
    pub iteration_of_best: u32,
    /// Paths that had been constructed when that iteration ended.
    pub paths_to_best: u64,
    /// Value / reference − 1; none without a reference. Below 0 only where the reference is not proven.
    pub gap: Option<f64>,
}

impl Row {
    /// A measure of the run. Without a path it is infinite, except for shares, which are 0, and for ant moves.
    pub fn value(&self, measure: Measure) -> f64 {
        let of_path = |value: fn(&Found) -> f64| self.found.as_ref().map_or(f64::INFINITY, value);
        let share = |yes: bool| f64::from(u8::from(yes));
        match measure {
            Measure::Length => of_path(|f| f.length),
            Measure::Cost => of_path(|f| f.value),
            Measure::Turns => of_path(|f| f.turns.into()),
            Measure::TurnIndex => of_path(|f| f.turn_index),
            Measure::Weight => of_path(|f| f.weight.unwrap_or(f64::INFINITY)),
            Measure::IterationOfBest => of_path(|f| f.iteration_of_best.into()),
            Measure::PathsToBest => of_path(|f| f.paths_to_best as f64),
            Measure::AntMoves => self.ant_moves as f64,
            Measure::Success => share(self.found.is_some()),
            Measure::Optimal => share(self.found.is_some_and(|f| f.gap == Some(0.0))),
        }
    }
}

impl Experiment {
    /// Checks the question and that every entry can be run on every map; `scenarios` has one for each instance.
    ///
    /// # Errors
    /// [`QuestionError`] with the field that does not fit.
    pub fn new(question: Question, scenarios: Vec<Arc<Scenario>>) -> Result<Self, QuestionError> {
        question.check()?;
        let map = |scenario| Map::new(scenario, &question);
        let maps = scenarios.into_iter().map(map).collect::<Result<_, _>>()?;
        Ok(Self { question, maps })
    }

    /// Over the question and its maps: experiments with equal digests have equal runs, under one version of the engine.
    pub fn digest(&self) -> Digest {
        let json = |value: serde_json::Result<Vec<u8>>| value.unwrap_or_default();
        let mut digest = Digest::default();
        digest.bytes(&json(serde_json::to_vec(&self.question)));
        for Map { scenario, .. } in &self.maps {
            digest.bytes(&json(serde_json::to_vec(&scenario.spec)));
            digest.bytes(&scenario.grid.to_bytes());
            scenario.grid.heights().iter().flat_map(|h| h.iter()).for_each(|&h| digest.f64(f64::from(h)));
        }
        digest
    }

    /// Every run, in the order of the rows: by instance, entry, seed.
    pub fn tasks(&self) -> Vec<Task> {
        let runnable = |entry: &usize| self.question.entries[*entry].planner.is_some();
        let seeds = self.question.seeds;
        let of = |instance, entry| seeds.iter().map(move |seed| Task { instance, entry, seed });
        let entries: Vec<usize> = (0..self.question.entries.len()).filter(runnable).collect();
        (0..self.maps.len()).flat_map(|i| entries.iter().flat_map(move |&e| of(i, e))).collect()
    }

    /// Does one run to its end.
    ///
    /// # Errors
    /// [`QuestionError`] for a task that is none of [`Experiment::tasks`].
    pub fn run(&self, task: Task) -> Result<Row, QuestionError> {
        let outside = |field| QuestionError::outside(field);
        let entry = self.question.entries.get(task.entry).ok_or_else(|| outside("entry"))?;
        let map = self.maps.get(task.instance).ok_or_else(|| outside("instance"))?;
        let mut planner = build(&map.scenario, entry, task.seed)?.ok_or_else(|| outside("entry"))?;
        let paths_to_best = run_to_end(planner.as_mut());
        Ok(row(task, map, planner.as_ref(), paths_to_best))
    }
}

impl Map {
    fn new(scenario: Arc<Scenario>, question: &Question) -> Result<Self, QuestionError> {
        let mut yardsticks: Vec<Option<Yardstick>> = Vec::with_capacity(question.entries.len());
        for entry in &question.entries {
            let objective = build(&scenario, entry, 0)?.map(|planner| planner.objective());
            let known = |objective| yardsticks.iter().flatten().find(|y| y.objective == objective).copied();
            let measure = |objective| Yardstick { objective, reference: exact::reference(&scenario, objective) };
            let yardstick = objective.map(|o| known(o).unwrap_or_else(|| measure(o)));
            yardsticks.push(yardstick);
        }
        Ok(Self { scenario, yardsticks })
    }

    /// What an entry is to achieve here.
    pub fn reference(&self, entry: usize) -> Reference {
        self.yardsticks.get(entry).copied().flatten().map_or(Reference::Unknown, |y| y.reference)
    }
}

/// The planner of an entry; none where nothing can be run.
fn build(scenario: &Arc<Scenario>, entry: &Contender, seed: u32) -> Result<Option<Box<dyn Planner>>, QuestionError> {
    let Some(id) = &entry.planner else { return Ok(None) };
    let built = catalog::build(scenario, id, entry.preset.as_deref(), &entry.set, seed);
    built.map(Some).map_err(|error| QuestionError::planner(entry, error))
}

/// Runs to the end; the constructed paths when the best path was found.
fn run_to_end(planner: &mut dyn Planner) -> u64 {
    let (mut best, mut paths) = (None, 0);
    loop {
        let status = planner.advance(Granularity::Iteration);
        let now = planner.best().map(|b| b.iteration);
        if now != best {
            (best, paths) = (now, planner.effort().constructed_paths);
        }
        if status.is_finished() {
            return paths;
        }
    }
}

fn row(task: Task, map: &Map, planner: &dyn Planner, paths_to_best: u64) -> Row {
    let found = planner.best().map(|best| {
        let m = Metrics::of(&map.scenario, best.result().0);
        let value = planner.value(&m).unwrap_or(m.length);
        Found {
            length: m.length,
            turns: m.turns,
            turn_index: m.turn_index,
            weight: planner.tour().and_then(|t| t.walked_weight),
            value,
            iteration_of_best: best.iteration,
            paths_to_best,
            gap: gap(value, map.reference(task.entry)),
        }
    });
    let (status, ant_moves) = (planner.status(), planner.effort().ant_moves);
    Row { task, status, found, ant_moves, digest: planner.digest().hex() }
}

/// Relative distance to the reference. A difference of a rounding is none.
fn gap(value: f64, reference: Reference) -> Option<f64> {
    const ROUNDING: f64 = 1e-9;
    let gap = reference.value().map(|best| if best > 0.0 { value / best - 1.0 } else { 0.0 });
    gap.map(|g| if g.abs() < ROUNDING { 0.0 } else { g })
}
