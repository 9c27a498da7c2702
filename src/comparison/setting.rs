//! A question with its maps, ready to run.

use std::sync::{Arc, OnceLock};

use serde::Serialize;

use super::check::QuestionError;
use super::question::{Measure, Question};
use super::row::{Row, Task};
use super::run::{Clock, Timed, build, run};
use crate::digest::Digest;
use crate::exact::{self, Reference};
use crate::map::Moves;
use crate::planner::Objective;
use crate::scenario::Scenario;

/// A question with its maps.
#[derive(Debug)]
pub struct Comparison {
    /// What is asked.
    pub question: Question,
    /// One map for each instance of the question.
    pub maps: Vec<Map>,
    /// The runs of entries whose results come from elsewhere, in the order of the rows.
    pub given: Vec<Row>,
    /// For each entry how far a value may lie from the reference and still be the same, by the digits that it is printed with; 0 for what is
    /// run here.
    printed: Vec<f64>,
}

/// The map of an instance.
#[derive(Debug)]
pub struct Map {
    /// Map, start, goal, movement.
    pub scenario: Arc<Scenario>,
    /// For each entry of the question what counts for it here; none where nothing can be run.
    objectives: Vec<Option<Objective>>,
    /// The best there is, by each objective of an entry: searched for when first asked for, because it can take long.
    references: OnceLock<Vec<Yardstick>>,
}

/// What results are measured by, and the best that there is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Yardstick {
    /// What counts.
    pub objective: Objective,
    /// Its best value, in cells.
    pub reference: Reference,
}

impl Comparison {
    /// Checks the question and that every entry can be run on every map; `scenarios` has one for each instance.
    ///
    /// # Errors
    /// [`QuestionError`] with the field that does not fit.
    pub fn new(question: Question, scenarios: Vec<Arc<Scenario>>) -> Result<Self, QuestionError> {
        question.check()?;
        let map = |scenario| Map::new(scenario, &question);
        let maps = scenarios.into_iter().map(map).collect::<Result<_, _>>()?;
        let printed = vec![0.0; question.entries.len()];
        Ok(Self { question, maps, given: Vec::new(), printed })
    }

    /// Takes in the runs of entries whose results come from elsewhere.
    ///
    /// # Errors
    /// [`QuestionError`] for a run of an entry that has no such results, or of an instance that there is not.
    pub fn with_given(mut self, mut given: Vec<Row>) -> Result<Self, QuestionError> {
        let known = |row: &Row| self.question.entries.get(row.task.entry).is_some_and(|e| e.results.is_some());
        if given.iter().any(|row| row.task.instance >= self.maps.len() || !known(row)) {
            return Err(QuestionError::outside("entry"));
        }
        given.sort_by_key(|row| row.task);
        let half_unit =
            |entry| half_unit(given.iter().filter(|row| row.task.entry == entry).filter_map(|row| Some(row.found?.value)));
        self.printed = (0..self.question.entries.len()).map(half_unit).collect();
        self.given = given;
        Ok(self)
    }

    /// Over the question and its maps: comparisons with equal digests have equal runs, under one version of the engine.
    pub fn digest(&self) -> Digest {
        let json = |value: serde_json::Result<Vec<u8>>| value.unwrap_or_default();
        let mut digest = Digest::default();
        digest.bytes(&json(serde_json::to_vec(&self.question)));
        for Map { scenario, .. } in &self.maps {
            digest.bytes(&json(serde_json::to_vec(&scenario.spec)));
            digest.bytes(&scenario.grid.to_bytes());
            scenario.grid.heights().iter().flat_map(|h| h.iter()).for_each(|&h| digest.f64(f64::from(h)));
        }
        self.given.iter().for_each(|row| digest.bytes(&json(serde_json::to_vec(row))));
        digest
    }

    /// Every run that is to be done, in the order of the rows: by instance, entry, seed.
    pub fn tasks(&self) -> Vec<Task> {
        let runnable = |entry: &usize| self.question.entries[*entry].planner.is_some();
        let seeds = self.question.seeds;
        let of = |instance, entry| seeds.iter().map(move |seed| Task { instance, entry, seed });
        let entries: Vec<usize> = (0..self.question.entries.len()).filter(runnable).collect();
        (0..self.maps.len()).flat_map(|i| entries.iter().flat_map(move |&e| of(i, e))).collect()
    }

    /// Does one run to its end. The clock tells times, which are not part of the row.
    ///
    /// # Errors
    /// [`QuestionError`] for a task that is none of [`Comparison::tasks`].
    pub fn run(&self, task: Task, clock: Clock) -> Result<Timed, QuestionError> {
        let outside = |field| QuestionError::outside(field);
        let entry = self.question.entries.get(task.entry).ok_or_else(|| outside("entry"))?;
        let map = self.maps.get(task.instance).ok_or_else(|| outside("instance"))?;
        let planner = build(&map.scenario, entry, task.seed)?.ok_or_else(|| outside("entry"))?;
        Ok(run(task, &map.scenario, planner, self.question.budget, clock))
    }

    /// The runs that were done and those from elsewhere, in the order of the rows.
    pub fn all_rows(&self, done: &[Row]) -> Vec<Row> {
        let mut rows: Vec<Row> = done.iter().chain(&self.given).cloned().collect();
        rows.sort_by_key(|row| row.task);
        rows
    }

    /// Relative distance of a run's value to the reference, value / reference − 1; none without a path or a reference. Below 0 only where the
    /// reference is not proven, or the run comes from elsewhere. A value from elsewhere that is the reference within the digits it was printed
    /// with has no distance.
    pub fn gap(&self, row: &Row) -> Option<f64> {
        let reference = self.maps.get(row.task.instance)?.reference(row.task.entry).value()?;
        gap(row.found?.value, reference, self.slack(row.task.entry, reference))
    }

    /// How far a value of an entry may lie from another one, in cells, and still be the same: half a unit of the last digit that the entry's
    /// runs are printed with, and what a rounded √2 makes, as in a MovingAI `.scen`. 0 for what is run here.
    pub fn slack(&self, entry: usize, value: f64) -> f64 {
        const ROUNDED_ROOT: f64 = 1e-6;
        match self.printed.get(entry) {
            // Whole numbers are all of a length by straight steps.
            Some(&printed) if printed == 0.5 && self.maps.iter().all(|m| m.scenario.spec.movement.moves == Moves::Four) => 0.0,
            Some(&printed) if printed > 0.0 => printed + ROUNDED_ROOT * value.abs(),
            _ => 0.0,
        }
    }

    /// A length or cost in the digits that all of these entries are known with, before they are ranked: digits that nobody has printed would
    /// break ties. As it is where all of them are run here.
    pub fn in_common_digits(&self, entries: &[usize], measure: Measure, value: f64) -> f64 {
        const MOST: f64 = 1e9;
        let printed = entries.iter().filter_map(|&entry| self.printed.get(entry)).copied().fold(0.0, f64::max);
        if printed == 0.0 || !matches!(measure, Measure::Length | Measure::Cost) {
            return value;
        }
        let scale = libm::round(0.5 / printed).min(MOST);
        libm::round(value * scale) / scale
    }

    /// Whether a run claims a path that cannot be: better than the exact optimum, by more than the digits it was printed with. It was searched
    /// for under other rules (moves, corners, measure), or on another map.
    pub fn impossible(&self, row: &Row) -> bool {
        let reference = self.maps.get(row.task.instance).map(|map| map.reference(row.task.entry));
        let nowhere = reference == Some(Reference::NoPath) && row.found.is_some();
        nowhere || (self.is_proven(row) && self.gap(row).is_some_and(|gap| gap < 0.0))
    }

    /// Whether nothing can be better than what a run is compared with.
    fn is_proven(&self, row: &Row) -> bool {
        self.maps.get(row.task.instance).is_some_and(|map| map.reference(row.task.entry).is_proven())
    }

    /// A measure of a run, as [`Row::value`] tells it, or whether it found the proven optimum.
    pub fn value(&self, row: &Row, measure: Measure) -> Option<f64> {
        match measure {
            Measure::Optimal => Some(f64::from(u8::from(self.is_proven(row) && self.gap(row) == Some(0.0)))),
            other => row.value(other),
        }
    }
}

impl Map {
    fn new(scenario: Arc<Scenario>, question: &Question) -> Result<Self, QuestionError> {
        let by_map = match scenario.by_slices() {
            Some(_) => Objective::SliceCost,
            None if scenario.goals.len() > 1 => Objective::TourLength,
            None => Objective::Length,
        };
        let objective = |entry| match build(&scenario, entry, 0)? {
            Some(planner) => Ok(Some(planner.objective())),
            None => Ok(entry.results.as_ref().map(|_| by_map)),
        };
        let objectives = question.entries.iter().map(objective).collect::<Result<_, _>>()?;
        Ok(Self { scenario, objectives, references: OnceLock::new() })
    }

    /// What paths on it are compared by: by slices their cost, elsewhere their length.
    pub fn measure(&self) -> Measure {
        if self.scenario.by_slices().is_some() { Measure::Cost } else { Measure::Length }
    }

    /// What counts for an entry here.
    pub fn objective(&self, entry: usize) -> Option<Objective> {
        self.objectives.get(entry).copied().flatten()
    }

    /// The best there is, by each objective of an entry, in the order of the entries.
    pub fn yardsticks(&self) -> &[Yardstick] {
        self.references.get_or_init(|| {
            let mut all: Vec<Yardstick> = Vec::new();
            for objective in self.objectives.iter().flatten().copied() {
                if all.iter().all(|y| y.objective != objective) {
                    all.push(Yardstick { objective, reference: exact::reference(&self.scenario, objective) });
                }
            }
            all
        })
    }

    /// What an entry is to achieve here.
    pub fn reference(&self, entry: usize) -> Reference {
        let objective = self.objective(entry);
        let yardstick = self.yardsticks().iter().find(|y| Some(y.objective) == objective);
        yardstick.map_or(Reference::Unknown, |y| y.reference)
    }
}

/// Relative distance to the reference. A difference of a rounding is none.
fn gap(value: f64, best: f64, slack: f64) -> Option<f64> {
    const ROUNDING: f64 = 1e-9;
    if (value - best).abs() <= slack {
        return Some(0.0);
    }
    let gap = if best > 0.0 { value / best - 1.0 } else { 0.0 };
    Some(if gap.abs() < ROUNDING { 0.0 } else { gap })
}

/// Half a unit of the last decimal that any of the values has, because those of one of them may end in zeros; 0 where there is no value.
pub(super) fn half_unit(values: impl Iterator<Item = f64>) -> f64 {
    let decimals = |v: f64| v.to_string().split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let most = values.map(decimals).max();
    most.map_or(0.0, |most| (0..most).fold(0.5, |unit, _| unit / 10.0))
}
