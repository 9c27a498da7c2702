//! The one interface of every planner: advance by a move or an iteration, and tell what stands.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::digest::Digest;
use crate::error::ParamError;
use crate::map::{Cell, Moves};
use crate::metrics::Metrics;
use crate::params::{ParamSpec, Value, Values};
use crate::path::{Path, PathKind};
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
    /// The search has ended, without a proof that nothing is better.
    Complete,
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
    /// Moves of ants: steps, steps back, and the move in which an ant finds itself lost at a dead end. Of swarms, the steps and steps back
    /// by which positions are decoded into paths.
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

impl Record {
    /// Of a search, which has one path or none; length in cells.
    pub fn of_search(iteration: u32, length: Option<f64>) -> Self {
        Self {
            iteration,
            best_so_far: length,
            iteration_best: length,
            iteration_mean: length,
            iteration_worst: length,
            arrived: u32::from(length.is_some()),
        }
    }
}

/// The best path so far.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Cells from start to goal, as the planner found them; a polyline where [`Planner::objective`] says so; by slices its places.
    pub path: Path,
    /// Its length in cells; by slices its cost by the scenario's measure.
    pub length: f64,
    /// The iteration (from 1) that found it; 0 where none was needed, because the start is the goal.
    pub iteration: u32,
    /// The same path after line-of-sight refinement, where that is part of the planner.
    pub refined: Option<Refined>,
}

/// What line-of-sight refinement makes of a path of steps.
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    /// A polyline from start to goal.
    pub path: Path,
    /// Its length in cells.
    pub length: f64,
}

impl Solution {
    /// The planner's result: the refined path where there is one. Cells, kind and length in cells.
    pub fn result(&self) -> (&Path, f64) {
        self.refined.as_ref().map_or((&self.path, self.length), |r| (&r.path, r.length))
    }
}

/// What a planner's result is measured by, and over which paths: it tells which exact planner is its yardstick.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Objective {
    /// Length of a path of steps to the goal.
    #[default]
    Length,
    /// Length of a polyline to the goal, its segments in line of sight.
    PolylineLength,
    /// By slices: Σ √(1 + Δy² + Δh²) + |h|, or Σ √(1 + Δy² + Δh²), as the scenario says.
    SliceCost,
    /// V(d, r) of a path of steps to the goal.
    TurnIndex,
    /// Length of a path of steps by all goals.
    TourLength,
    /// Σ R of a path of steps by all goals: the length of each leg times the weight of the goal that it leads to.
    TourWeight,
}

impl Objective {
    /// What it is, in words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Length => "length by steps",
            Self::PolylineLength => "length of a polyline",
            Self::SliceCost => "cost by slices",
            Self::TurnIndex => "turn index V",
            Self::TourLength => "length by all goals",
            Self::TourWeight => "weight R by all goals",
        }
    }

    /// The kind of the paths that it compares.
    pub fn path_kind(self) -> PathKind {
        if self == Self::PolylineLength { PathKind::Polyline } else { PathKind::Steps }
    }
}

/// In which order several goals are visited, and what each leg costs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Tour {
    /// The goals' indices in the scenario, in visiting order.
    pub order: Vec<u32>,
    /// Length of each leg in cells, by which the order was chosen.
    pub planned: Vec<f64>,
    /// Length of each leg in cells as walked on the best path; empty while there is none.
    pub walked: Vec<f64>,
    /// Σ of the planned lengths.
    pub planned_length: f64,
    /// Σ R of the planned lengths.
    pub planned_weight: f64,
    /// Σ R of the walked lengths; none while there is no path.
    pub walked_weight: Option<f64>,
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
    /// Share of blocked cells among the eight around a cell; beyond the border is blocked.
    Density,
    /// The strongest trail that leaves a cell before the first iteration.
    InitialTrail,
    /// The path that seeded the trails, 1 on its cells; of a hybrid's first stage.
    SeedPath,
    /// The numbers by which a decoded path is chosen, one a cell: a firework's or a particle's position.
    Priority,
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
    /// The order of the goals, of planners that choose one.
    pub tour: Option<Tour>,
    history: Vec<Record>,
    /// Over the history, kept up to date so that a long one is not hashed again for every question.
    digest: Digest,
}

impl Default for Progress {
    fn default() -> Self {
        let (effort, history, digest) = (Effort::default(), Vec::new(), Digest::default());
        Self { status: Status::Running, best: None, effort, tour: None, history, digest }
    }
}

impl Progress {
    /// Answers what needs no search for a path to one goal: a start that is the goal, and a goal that nobody can reach.
    pub fn settle(&mut self, scenario: &Scenario) {
        let (start, goal) = scenario.by_slices().map_or((scenario.start, scenario.goal), |s| (s.start(), s.goal()));
        if start == goal {
            self.best = Some(Solution { path: vec![start], length: 0.0, iteration: 0, refined: None });
            self.status = Status::Optimal;
        } else if !scenario.connected() {
            self.status = Status::NoPath;
        }
    }

    /// Adds a finished iteration to the history.
    pub fn record(&mut self, r: Record) {
        self.digest.u32(r.iteration);
        for v in [r.best_so_far, r.iteration_best, r.iteration_mean, r.iteration_worst] {
            self.digest.f64(v.unwrap_or(f64::NAN));
        }
        self.digest.u32(r.arrived);
        self.history.push(r);
    }

    /// Digest over the history, the best path and its length, the refined path and its length, and the order of the goals.
    fn digest(&self) -> Digest {
        let mut digest = self.digest;
        let paths = self
            .best
            .iter()
            .flat_map(|b| std::iter::once((&b.path, b.length)).chain(b.refined.as_ref().map(|r| (&r.path, r.length))));
        for (path, length) in paths {
            digest.u32(path.len() as u32);
            path.iter().for_each(|&c| digest.u32(c));
            digest.f64(length);
        }
        self.tour.iter().flat_map(|t| &t.order).for_each(|&goal| digest.u32(goal));
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
    fn budget(&self) -> Option<u32> {
        None
    }
    /// Number of ants per iteration; 0 for a search.
    fn colony_size(&self) -> u32 {
        0
    }
    /// Writes a layer (one value a cell, row by row); false when the planner has no such layer.
    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool;
    /// Writes the cell of every living ant of the current iteration.
    fn ants(&self, out: &mut Vec<Cell>) {
        out.clear();
    }

    /// What its result is measured by.
    fn objective(&self) -> Objective {
        Objective::Length
    }

    /// Its result's value by its own objective, in cells, given the metrics of that result; none while there is none.
    fn value(&self, metrics: &Metrics) -> Option<f64> {
        match self.objective() {
            Objective::Length | Objective::PolylineLength | Objective::SliceCost | Objective::TourLength => {
                self.best().map(|b| b.result().1)
            }
            Objective::TurnIndex => Some(metrics.turn_index),
            Objective::TourWeight => self.tour().and_then(|t| t.walked_weight),
        }
    }

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

    /// The order of the goals, of planners that choose one.
    fn tour(&self) -> Option<&Tour> {
        self.progress().tour.as_ref()
    }

    /// Digest over the history, the best path, its refinement, and the order of the goals.
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
    /// Ant colonies, also as a part of hybrids.
    AntColony,
    /// Particle swarms and fireworks.
    Swarm,
    /// Searches without a proof.
    Search,
    /// Searches with a proof.
    Exact,
}

/// A way of moving, as far as planners differ in what they know.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Ground {
    /// 4 or 8 moves on a plane.
    Plane,
    /// 4 or 8 moves on the surface of a terrain.
    Surface,
    /// 16 moves, on a plane or on a surface.
    Sixteen,
    /// By slices over a terrain.
    Slices,
}

impl Ground {
    /// Of planners that only know the plane.
    pub const PLANE: &'static [Self] = &[Self::Plane];
    /// Of planners that go from cell to neighbouring cell.
    pub const NEIGHBOURS: &'static [Self] = &[Self::Plane, Self::Surface];
    /// Of planners that go from cell to cell by any allowed step.
    pub const STEPS: &'static [Self] = &[Self::Plane, Self::Surface, Self::Sixteen];
    /// Of planners that know every way of moving.
    pub const ALL: &'static [Self] = &[Self::Plane, Self::Surface, Self::Sixteen, Self::Slices];

    /// How one moves in a scenario.
    pub fn of(scenario: &Scenario) -> Self {
        match (scenario.by_slices(), scenario.spec.movement.moves, scenario.moves.relief()) {
            (Some(_), ..) => Self::Slices,
            (None, Moves::Sixteen, _) => Self::Sixteen,
            (None, _, Some(_)) => Self::Surface,
            (None, _, None) => Self::Plane,
        }
    }

    /// Its stable name, and as a phrase after "plans".
    pub const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Plane => ("plane", "on a plane"),
            Self::Surface => ("surface", "on the surface of a terrain"),
            Self::Sixteen => ("sixteen", "with 16 moves"),
            Self::Slices => ("slices", "by slices"),
        }
    }
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
    /// Ids of choices, `true` or `false` of flags, by key; what is absent keeps the default.
    pub choices: &'static [(&'static str, &'static str)],
}

impl Preset {
    /// Its values by key.
    pub fn values(&self) -> Values {
        let numbers = self.numbers.iter().map(|&(k, v)| (k.to_string(), Value::from(v)));
        let choice = |v: &str| v.parse::<bool>().map_or_else(|_| Value::from(v), Value::from);
        numbers.chain(self.choices.iter().map(|&(k, v)| (k.to_string(), choice(v)))).collect()
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
    /// Most goals that it can visit: 1 for a planner from one place to another.
    pub max_goals: u32,
    /// The ways of moving that it knows.
    pub grounds: &'static [Ground],
    /// The rows of its parameters.
    pub specs: fn() -> Vec<ParamSpec>,
    /// Makes one, after checking the values.
    pub build: Build,
}

/// Makes a planner for a scenario from values and a seed.
pub type Build = fn(&Arc<Scenario>, &Values, u32) -> Result<Box<dyn Planner>, ParamError>;
