//! Comparisons: a question is run, measured and judged the same way everywhere.
//!
//! A [`Question`] asks what a publication claims: which entries (planner, preset, values), on which instances (maps), over which seeds.
//! A [`Comparison`] is a question with its maps. Each of its [`Task`]s is one run and gives one [`Row`], whether or not a path was found; the
//! row tells every improvement on the way. [`imported`] joins runs from elsewhere. [`analysis`] makes the numbers, [`judge`] gives a verdict
//! on each claim by the rule of docs/methodology.md, [`ablation`] tells what each component of a planner does, [`pareto`] what runs trade off,
//! and [`report`] prints.
//! [`best_known`] judges claims to have a better value than any before.
//!
//! No clock, no threads, no files: the caller decides where the tasks run, so that the browser can do it too.

pub mod ablation;
pub mod analysis;
pub mod best_known;
mod budget;
mod by_reading;
mod check;
mod claim;
mod contrast;
mod course;
mod facts;
pub mod gap;
pub mod imported;
pub mod inference;
mod intervals;
mod json;
pub mod judge;
mod maps;
mod measure;
pub mod names;
mod order;
mod over_maps;
pub mod pareto;
mod printed_digits;
pub mod question;
pub mod report;
mod row;
mod run;
mod running_time;
mod samples;
mod shard;
mod signs;
pub mod statistics;
mod verdict;
mod verify;

use std::borrow::Cow;
use std::sync::Arc;

use crate::digest::Digest;
use crate::error::QuestionError;
use crate::scenario::Scenario;

pub use ablation::{Ablated, AblationRole, Effect, Finding, effects};
pub use analysis::{Analysis, analyse};
pub use budget::{Axis, Budget};
pub use by_reading::{ByReading, ReadingRow};
pub use claim::{Claim, Direction, Statistic};
pub use contrast::EffectSize;
pub use facts::{Fact, Unfit, UnfitMap};
pub use intervals::Intervals;
pub(crate) use json::json;
pub use judge::JudgedClaim;
pub use maps::{Map, Yardstick};
pub use measure::RunMeasure;
pub use over_maps::{OverMaps, OverallVerdict, VerdictCounts};
pub use pareto::{EntryFront, FrontPoint, FrontQuestion, MapFronts, fronts};
pub use question::{Entry, Instance, Published, Question, Role, Seeds};
pub use row::{Clearance, Found, Improvement, MAX_COUNT, Row, Spent, Task};
pub use run::{Clock, Timed};
pub use samples::{Samples, Seen};
pub use shard::{MAX_SHARDS, Shard};
pub use verdict::{Verdict, WhyNot};
pub use verify::{Deviation, Record, Recorded, Runs, Verification};

/// A question with its maps, ready to run.
#[derive(Debug)]
pub struct Comparison {
    /// What is asked.
    pub question: Question,
    /// One map for each instance of the question.
    pub maps: Vec<Map>,
    /// The runs of entries whose results come from elsewhere, in the order of the rows.
    pub imported: Vec<Row>,
    /// For each entry half a unit of the last digit that its values are printed with, in cells; 0 for what is run here.
    half_units: Vec<f64>,
}

impl Comparison {
    /// Checks the question, and that every entry can be run on every map. `scenarios` has one for each instance, in their order.
    ///
    /// # Errors
    /// [`QuestionError`] with the field that does not fit.
    pub fn new(question: Question, scenarios: Vec<Arc<Scenario>>) -> Result<Self, QuestionError> {
        question.check()?;
        #[cfg(feature = "whole")]
        check_walls(&question, &scenarios)?;
        let map = |scenario| Map::new(scenario, &question);
        let maps = scenarios.into_iter().map(map).collect::<Result<_, _>>()?;
        let half_units = vec![0.0; question.entries.len()];
        Ok(Self { question, maps, imported: Vec::new(), half_units })
    }

    /// Takes in the runs of entries whose results come from elsewhere, in place of those it had.
    ///
    /// # Errors
    /// [`QuestionError`] for a run of an entry that has no such results, or of an instance that does not exist.
    pub fn with_imported(mut self, mut imported: Vec<Row>) -> Result<Self, QuestionError> {
        let is_asked = |row: &Row| self.question.entries.get(row.task.entry).is_some_and(|e| e.results.is_some());
        if imported.iter().any(|row| row.task.instance >= self.maps.len() || !is_asked(row)) {
            return Err(QuestionError::outside("entry"));
        }
        imported.sort_by_key(|row| row.task);
        self.half_units = printed_digits::half_units(self.question.entries.len(), &imported);
        self.imported = imported;
        Ok(self)
    }

    /// Over the question, its maps and the imported runs: comparisons with equal digests have equal runs, under one version of the engine.
    pub fn digest(&self) -> Digest {
        let mut digest = Digest::default();
        digest.bytes(json(&self.question).as_bytes());
        for Map { scenario, .. } in &self.maps {
            digest.bytes(json(&scenario.spec).as_bytes());
            digest.bytes(&scenario.drawn.to_bytes());
            let numbers = scenario.drawn.heights().into_iter().chain(scenario.drawn.factors()).flat_map(|n| n.iter());
            numbers.for_each(|&number| digest.f64(f64::from(number)));
        }
        self.imported.iter().for_each(|row| digest.bytes(json(row).as_bytes()));
        digest
    }

    /// Does one run to its end. The clock tells times, which are not part of the row.
    ///
    /// # Errors
    /// [`QuestionError`] for a task that is none of [`Comparison::tasks`].
    pub fn run(&self, task: Task, clock: Clock) -> Result<Timed, QuestionError> {
        let outside = |field| QuestionError::outside(field);
        let entry = self.question.entries.get(task.entry).ok_or_else(|| outside("entry"))?;
        let map = self.maps.get(task.instance).ok_or_else(|| outside("instance"))?;
        let planner = run::build(&map.scenario, entry, task.seed)?.ok_or_else(|| outside("entry"))?;
        let asked = run::Asked { scenario: &map.scenario, budget: self.question.budget, drives: self.drives(map) };
        Ok(run::run(task, asked, planner, clock))
    }

    /// Whether rows on a map tell how a path is to drive: where a claim is about it, or the map's vehicle has a rule of energy or smoothing. All
    /// others stay as they were before such measures were taken.
    fn drives(&self, map: &Map) -> bool {
        let vehicle = &map.scenario.spec.vehicle;
        let is_claimed = self.question.claims.iter().any(|claim| claim.measure.is_of_driving());
        is_claimed || vehicle.energy.is_some() || vehicle.smoothing.is_some()
    }

    /// The runs that were done and the imported ones, in the order of the rows. `done` is in that order.
    pub fn all_rows<'a>(&self, done: &'a [Row]) -> Cow<'a, [Row]> {
        if self.imported.is_empty() {
            return done.into();
        }
        let mut rows: Vec<Row> = done.iter().chain(&self.imported).cloned().collect();
        rows.sort_by_key(|row| row.task);
        rows.into()
    }
}

/// Refuses maps whose walls change: all entries of a comparison are measured on one map.
#[cfg(feature = "whole")]
fn check_walls(question: &Question, scenarios: &[Arc<Scenario>]) -> Result<(), QuestionError> {
    let moving = question.instances.iter().zip(scenarios).find(|(_, scenario)| !scenario.spec.changes.is_empty());
    let Some((instance, scenario)) = moving else { return Ok(()) };
    let found = format!("a map with {} changes of its walls", scenario.spec.changes.len());
    Err(QuestionError::field(
        format!("instances.{}.map", instance.id),
        found,
        "a map whose walls stay: `plan` runs the other kind",
    ))
}
