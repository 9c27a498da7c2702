//! The planner of a robot: asked from wherever it stands, on the map as the robot knows it.

use std::sync::Arc;

use super::params::DriveParams;
use super::result::Stuck;
use super::surroundings::differences;
use crate::catalog;
use crate::error::{Error, ScenarioError};
use crate::map::{Grid, Point};
use crate::params::{ParamKind, Value, Values};
use crate::path::Path;
use crate::planner::{Effort, Granularity, Planner, PlannerEntry, Status};
use crate::scenario::{Change, Scenario, ScenarioSpec};

/// The row of a planner that says after how many iterations it stops.
const ITERATIONS: &str = "iterations";

/// A planner, and what it is made of.
#[derive(Clone)]
pub(super) struct Pilot {
    entry: &'static PlannerEntry,
    preset: Option<String>,
    values: Values,
    seed: u32,
    /// Of each planning; none for a planner that ends by itself.
    iterations: Option<u32>,
    /// Whether it goes on with what it has learnt.
    keeps: bool,
    /// With the map that it has planned on last.
    planner: Option<(Box<dyn Planner>, Grid)>,
    /// Spent by all plannings.
    effort: Effort,
    plans: u32,
}

impl Pilot {
    /// # Errors
    /// What [`catalog::build`] says of planner and values; [`ScenarioError::Drive`] for a planner of polylines.
    pub(super) fn new(
        scenario: &Scenario,
        planner: &str,
        preset: Option<&str>,
        values: &Values,
        seed: u32,
        params: &DriveParams,
    ) -> Result<Self, Error> {
        let entry = catalog::find(planner)?;
        let most = (entry.specs)().into_iter().find(|spec| spec.key == ITERATIONS).and_then(|spec| match spec.kind {
            ParamKind::Integer { max, .. } => Some(max),
            _ => None,
        });
        let mut values = values.clone();
        if most.is_some() {
            values.insert(ITERATIONS.into(), Value::from(f64::from(params.iterations)));
        }
        let asked = asked(scenario, &scenario.drawn, scenario.spec.start)?;
        let trial = catalog::build(&asked, planner, preset, &values, seed)?;
        if !trial.goes_by_steps() {
            let (field, value) = ("planner".into(), planner.to_owned());
            return Err(ScenarioError::Drive { field, value, allowed: "a planner whose paths go from cell to cell" }.into());
        }
        let keeps = params.keep && trial.adapts();
        if let Some(most) = most.filter(|_| keeps) {
            values.insert(ITERATIONS.into(), Value::from(most));
        }
        let (preset, iterations) = (preset.map(str::to_owned), most.map(|_| params.iterations));
        Ok(Self { entry, preset, values, seed, iterations, keeps, planner: None, effort: Effort::default(), plans: 0 })
    }

    /// What all plannings have spent.
    pub(super) fn effort(&self) -> Effort {
        self.effort
    }

    /// How often it was asked.
    pub(super) fn plans(&self) -> u32 {
        self.plans
    }

    /// The planner as its last planning has left it.
    pub(super) fn planner(&self) -> Option<&dyn Planner> {
        self.planner.as_ref().map(|(planner, _)| &**planner)
    }

    /// A path from a cell to the goal on a map that is known.
    ///
    /// # Errors
    /// Why there is none.
    pub(super) fn plan(&mut self, scenario: &Scenario, known: &Grid, at: Point) -> Result<Path, Stuck> {
        self.plans += 1;
        let to = asked(scenario, known, at).map_err(|error| match error {
            ScenarioError::TooNarrow { role: "start", .. } => Stuck::NoRoom,
            _ => Stuck::GoalTaken,
        })?;
        let (mut planner, before) = self.made_ready(&to);
        for _ in 0..self.iterations.unwrap_or(u32::MAX) {
            if planner.advance(Granularity::Iteration).is_finished() {
                break;
            }
        }
        self.effort = self.effort.plus(planner.effort().since(before));
        let found = planner.best().map(|best| best.path.clone());
        let none = if planner.status() == Status::NoPath { Stuck::NoPath } else { Stuck::NotFound };
        self.planner = Some((planner, known.clone()));
        found.ok_or(none)
    }

    /// The planner on another map from another start, and what it has spent by then.
    fn made_ready(&mut self, to: &Arc<Scenario>) -> (Box<dyn Planner>, Effort) {
        if let Some((mut planner, before)) = self.planner.take().filter(|(p, _)| self.keeps && p.status() != Status::BudgetSpent)
        {
            let (blocked, freed) = differences(&before, &to.drawn);
            planner.adapt(&Change { at: 0, blocked, freed }, to);
            let effort = planner.effort();
            return (planner, effort);
        }
        let made = catalog::build(to, self.entry.id, self.preset.as_deref(), &self.values, self.seed);
        (made.expect("the same values suit a map of the same size"), Effort::default())
    }
}

/// The question from a cell on another map, where nothing moves.
fn asked(scenario: &Scenario, map: &Grid, start: Point) -> Result<Arc<Scenario>, ScenarioError> {
    let spec = ScenarioSpec { start, changes: Vec::new(), drive: None, ..scenario.spec.clone() };
    Scenario::new(map.clone(), spec).map(Arc::new)
}
