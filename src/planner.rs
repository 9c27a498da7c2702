//! The one interface of every planner: advance by a move or an iteration, and tell what stands.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::digest::Digest;
use crate::error::ParamError;
use crate::map::Cell;
use crate::params::{ParamSpec, Value, Values};
use crate::path::Path;
use crate::scenario::Scenario;

/// How far one call of [`Planner::advance`] goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Granularity {
    /// One move of every living ant; one cell expansion of a search.
    Move,
    /// One iteration of a colony; one contour (whole number of f) of a search.
    Iteration,
}

/// Whether and how a planner has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Status {
    /// There is more to do.
    Running,
    /// The best path is proven optimal under the scenario's rules.
    Optimal,
    /// No improvement for as long as the planner was told to wait.
    Stagnated,
    /// The budget of iterations is spent.
    BudgetSpent,
    /// No path exists. An answer, not an error.
    NoPath,
}

impl Status {
    /// Whether nothing is left to do.
    pub fn is_finished(self) -> bool {
        self != Self::Running
    }
}

/// The fair-budget axes: what has been spent so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Effort {
    /// Finished iterations.
    pub iterations: u32,
    /// Walks that were begun and ended: at the goal, at a dead end, or at the cap on moves.
    pub constructed_paths: u64,
    /// Moves of ants: steps, steps back, and the move in which an ant finds itself lost at a dead end.
    pub ant_moves: u64,
    /// Cells taken from the open list of a search.
    pub cell_expansions: u64,
}

/// One finished iteration. Lengths in cells; `None` where no ant has arrived.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Record {
    /// From 1.
    pub iteration: u32,
    /// Shortest length of all iterations so far.
    pub best_so_far: Option<f64>,
    /// Shortest length of this iteration.
    pub iteration_best: Option<f64>,
    /// Mean length of this iteration's arrived ants.
    pub iteration_mean: Option<f64>,
    /// Longest length of this iteration's arrived ants.
    pub iteration_worst: Option<f64>,
    /// Ants that arrived.
    pub arrived: u32,
}

/// The best path so far.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Cells from start to goal.
    pub path: Path,
    /// Its length in cells.
    pub length: f64,
    /// The iteration (from 1) that found it; 0 where none was needed, because the start is the goal.
    pub iteration: u32,
}

/// A field over the map that can be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Layer {
    /// The strongest trail that leaves a cell.
    Trail,
    /// Colonies: how many ants of the current iteration have the cell on their way. Searches: 1 where a cell was expanded.
    Visits,
    /// Mean heuristic value η of the steps that lead into a cell.
    Heuristic,
    /// A search's cost from the start, in cells; infinite where none is known.
    Cost,
}

/// Where a planner stands; every planner keeps one.
#[derive(Debug, Clone)]
pub struct Progress {
    /// Whether and how it has ended.
    pub status: Status,
    /// The best path of the finished iterations.
    pub best: Option<Solution>,
    /// What has been spent.
    pub effort: Effort,
    history: Vec<Record>,
    /// Over the history, kept up to date so that a long one is not hashed again for every question.
    digest: Digest,
}

impl Default for Progress {
    fn default() -> Self {
        let (best, effort, history, digest) = (None, Effort::default(), Vec::new(), Digest::default());
        Self { status: Status::Running, best, effort, history, digest }
    }
}

impl Progress {
    /// Adds a finished iteration to the history.
    pub fn record(&mut self, r: Record) {
        self.digest.u32(r.iteration);
        for v in [r.best_so_far, r.iteration_best, r.iteration_mean, r.iteration_worst] {
            self.digest.f64(v.unwrap_or(f64::NAN));
        }
        self.digest.u32(r.arrived);
        self.history.push(r);
    }

    /// Digest over the history, the best path, and its length.
    fn digest(&self) -> Digest {
        let mut digest = self.digest;
        if let Some(best) = &self.best {
            digest.u32(best.path.len() as u32);
            best.path.iter().for_each(|&c| digest.u32(c));
            digest.f64(best.length);
        }
        digest
    }
}

/// A planner at work on one scenario.
pub trait Planner: Send {
    /// Goes one step further; inert once finished.
    fn advance(&mut self, by: Granularity) -> Status;
    /// Where it stands.
    fn progress(&self) -> &Progress;
    /// The budget of iterations; `None` for a search, which ends by itself.
    fn budget(&self) -> Option<u32>;
    /// Number of ants per iteration; 0 for a search.
    fn colony_size(&self) -> u32;
    /// Writes a layer (one value a cell, row by row); false when the planner has no such layer.
    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool;
    /// Writes the cell of every living ant of the current iteration.
    fn ants(&self, out: &mut Vec<Cell>);

    /// Whether and how it has ended.
    fn status(&self) -> Status {
        self.progress().status
    }

    /// The best path of the finished iterations.
    fn best(&self) -> Option<&Solution> {
        self.progress().best.as_ref()
    }

    /// One record per finished iteration.
    fn history(&self) -> &[Record] {
        &self.progress().history
    }

    /// What has been spent.
    fn effort(&self) -> Effort {
        self.progress().effort
    }

    /// Digest over the history, the best path, and its length.
    fn digest(&self) -> Digest {
        self.progress().digest()
    }

    /// Advances by iterations until finished.
    fn run(&mut self) -> Status {
        loop {
            let status = self.advance(Granularity::Iteration);
            if status.is_finished() {
                return status;
            }
        }
    }
}

/// What kind of planner an entry of the catalog is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Family {
    /// Ant colonies.
    AntColony,
    /// Searches with a proof.
    Exact,
}

/// A named parameter set, e.g. a paper's.
#[derive(Debug, Clone, Copy)]
pub struct Preset {
    /// Its name on the command line and in links.
    pub name: &'static str,
    /// The publication.
    pub source: &'static str,
    /// What it stands for, and what was converted.
    pub meaning: &'static str,
    /// Numbers by key; what is absent keeps the default.
    pub numbers: &'static [(&'static str, f64)],
    /// Ids of choices by key; what is absent keeps the default.
    pub choices: &'static [(&'static str, &'static str)],
}

impl Preset {
    /// Its values by key.
    pub fn values(&self) -> Values {
        let numbers = self.numbers.iter().map(|&(k, v)| (k.to_string(), Value::from(v)));
        numbers.chain(self.choices.iter().map(|&(k, v)| (k.to_string(), Value::from(v)))).collect()
    }
}

/// A planner in the catalog: its file's only export that others need.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// Stable id in links, files and records.
    pub id: &'static str,
    /// Name for people.
    pub name: &'static str,
    /// Kind of planner.
    pub family: Family,
    /// One sentence.
    pub summary: &'static str,
    /// The publication.
    pub source: &'static str,
    /// Named parameter sets.
    pub presets: &'static [Preset],
    /// The layers it can draw.
    pub layers: &'static [Layer],
    /// The rows of its parameters.
    pub specs: fn() -> Vec<ParamSpec>,
    /// Makes one, after checking the values.
    pub build: Build,
}

/// Makes a planner for a scenario from values and a seed.
pub type Build = fn(&Arc<Scenario>, &Values, u32) -> Result<Box<dyn Planner>, ParamError>;
