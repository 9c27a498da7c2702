//! Formica by slices: ants find where cheap paths may lie, a search puts their ways together, and the cheapest is proven; the rules of
//! [`formica`](crate::aco::formica) on the steps of slices.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | 0.5, as in the hyper-cube framework: Blum, Dorigo 2004 |
//! | heuristic | η = exp(−κ·detour), the detour by [`SliceEstimate`], ours; the least number where the goal is out of reach |
//! | selection | as Ant System |
//! | on each move | nothing |
//! | solve | merge and solve, after Construct, Merge, Solve & Adapt: Blum, Pinacho, López-Ibáñez, Lozano 2016; [`SlicesWithin`] |
//! | update | τ ← (1 − ρ)·τ, + ρ on the cheapest path, limits: hyper-cube framework; trails start again where nothing cheaper is found |
//! | end | a proof: the search over all places, bounded by the best cost, on what merging has expanded; ours |
//!
//! [`slices-exact`](crate::exact::slices) expands every place that can be reached; the proof leaves out those from which no path can be cheaper.

use std::sync::Arc;

use super::colony::{Built, Numbers, Rules, SliceColony};
use super::trails::RowTrails;
use crate::aco::formica::{LIMITS, MERGE, PROOF, TRAIL, detour};
use crate::aco::shared_params::{SelectionParams, WalkParams};
use crate::aco::variant::Solved;
use crate::error::ParamError;
use crate::exact::{SliceEstimate, SlicesWithin};
use crate::map::{Cell, Slices};
use crate::metrics::SAME_LENGTH;
use crate::params;
use crate::params::{Params, Values};
use crate::path::Path;
#[cfg(feature = "whole")]
use crate::planner::Certificate;
use crate::planner::{Family, Ground, Layer, Planner, PlannerEntry, Status};
use crate::scenario::Scenario;

params! {
    /// Parameters of Formica by slices.
    pub struct FormicaSlicesParams {
        /// ants that build a path in each iteration
        ants: u32 = 16, "m", [1..=1024], "ants", "as from cell to cell: docs/papers/formica.md";
        ..selection: SelectionParams;
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.1, "ρ", [0.0..=1.0], "", "Blum and Dorigo 2004";
        /// how strongly ants avoid detours: η = exp(−κ · detour)
        kappa: f64 = 0.4, "κ", [0.0..=20.0], "per cell", "as from cell to cell: docs/papers/formica.md";
        /// whether a search puts the ways of each iteration's ants together
        merge: bool = true, "", [], "", "Blum et al. 2016";
        /// how far around the ants' places the search looks, in rows and levels
        widening: u32 = 1, "", [0..=64], "cells or levels", "our choice";
        /// how far around the best path the search looks, in rows and levels
        corridor: u32 = 2, "", [0..=128], "cells or levels", "our choice";
        /// trails start again after so many iterations without a cheaper path; 0 = never
        trail_restart: u32 = 2, "", [0..=100_000], "iterations", "as from cell to cell: docs/papers/formica.md";
        /// ants stop after so many iterations without a cheaper path, and the proof begins; 0 = only at the end of the budget
        proof_after: u32 = 3, "", [0..=100_000], "iterations", "as from cell to cell: docs/papers/formica.md";
        /// most expansions of the proof; 0 = no proof
        proof_limit: f64 = 4.0, "", [0.0..=1000.0], "× places", "our addition";
        ..walk: WalkParams;
    }
}

/// The rules of Formica by slices, and what they have learnt of one scenario.
#[derive(Clone)]
pub struct FormicaSlices {
    params: FormicaSlicesParams,
    slices: Arc<Slices>,
    estimate: SliceEstimate,
    /// None before the first iteration has ended.
    learnt: Option<Learnt>,
}

/// What is known after iterations.
#[derive(Clone)]
struct Learnt {
    search: SlicesWithin,
    /// How far around the best path it looks.
    corridor: u8,
    /// Cost of the best path, and the iteration that found it.
    best: f64,
    since: u32,
    /// Expansions that were told already.
    told: u64,
}

impl Learnt {
    fn new(params: &FormicaSlicesParams, slices: &Arc<Slices>) -> Self {
        Self { search: SlicesWithin::new(slices), corridor: params.corridor as u8, best: f64::INFINITY, since: 0, told: 0 }
    }

    /// Merges the ways of an iteration's ants and searches among them.
    fn merge(&mut self, built: &Built, widening: u8) {
        for &place in built.ants.iter().flat_map(|ant| ant.list()) {
            self.search.widen(place, widening);
        }
        if let Some(best) = built.best {
            best.path.iter().for_each(|&place| self.search.widen(place, self.corridor));
        }
        self.search.go_on(u64::MAX);
    }

    /// Takes note of the best cost after an iteration.
    fn note(&mut self, cost: f64, number: u32) {
        if cost < self.best - SAME_LENGTH {
            (self.best, self.since) = (cost, number);
        }
    }

    /// The path of the search, if it is cheaper than what is known.
    fn cheaper(&self, known: f64) -> Option<(Path, f64)> {
        self.search.best().filter(|(_, cost)| *cost < known - SAME_LENGTH)
    }
}

impl FormicaSlices {
    /// On a scenario by slices.
    pub fn new(params: FormicaSlicesParams, slices: Arc<Slices>) -> Self {
        Self { params, estimate: SliceEstimate::new(&slices), slices, learnt: None }
    }

    /// Proves what stands after an iteration, if it is time; takes in a cheaper path with its cost. How the colony has ended by that.
    fn prove(&mut self, number: u32, found: &mut Option<(Path, f64)>) -> Option<Status> {
        let is_last = self.is_last(number, self.learnt.as_ref()?.since);
        let most = self.params.proof_limit * self.slices.places() as f64;
        let learnt = self.learnt.as_mut()?;
        learnt.search.bound_by(learnt.best);
        if most <= 0.0 {
            return None;
        }
        if is_last && !learnt.search.is_proven() {
            learnt.search.widen_to_all();
            learnt.search.go_on(most as u64);
            if let Some(better) = learnt.cheaper(learnt.best) {
                (learnt.best, learnt.since) = (better.1, number);
                *found = Some(better);
            }
        }
        ending(&learnt.search, (is_last, number >= self.params.selection.iterations), learnt.best)
    }

    /// Whether the iteration is the last one that ants walk: the budget is spent, or nothing cheaper was found for long enough.
    fn is_last(&self, number: u32, since: u32) -> bool {
        let p = &self.params;
        let waits = |most: u32| most > 0 && number - since >= most;
        number >= p.selection.iterations || waits(p.proof_after) || waits(p.walk.stagnation)
    }
}

/// How the colony ends by its proof, if it does: whether this is the last iteration, and whether the budget is spent.
fn ending(search: &SlicesWithin, (is_last, is_spent): (bool, bool), best: f64) -> Option<Status> {
    match (search.is_proven(), is_last) {
        (true, _) if best.is_finite() => Some(Status::Optimal),
        (true, _) => Some(Status::NoPath),
        // Without any path the ants go on; merging has all places by then.
        (false, true) if best.is_finite() || is_spent => Some(Status::BudgetSpent),
        (false, _) => None,
    }
}

impl Rules for FormicaSlices {
    const ON_PLACES: bool = false;

    fn numbers(&self) -> Numbers {
        let p = &self.params;
        Numbers { ants: p.ants, selection: p.selection, q0: 0.0, walk: p.walk }
    }

    fn initial_trail(&self, _: &Slices) -> f64 {
        TRAIL
    }

    fn eta(&self, slices: &Slices, from: Cell, to: Cell) -> f64 {
        let (here, there) = (self.estimate.of(slices, from), self.estimate.of(slices, to));
        // Infinite here, it is infinite there.
        let longer = if there.is_finite() { slices.cost(from, to) + there - here } else { f64::INFINITY };
        detour(self.params.kappa, longer).max(f64::MIN_POSITIVE)
    }

    fn solve(&mut self, built: Built) -> Option<Solved> {
        let learnt = self.learnt.get_or_insert_with(|| Learnt::new(&self.params, &self.slices));
        let known = built.best.map_or(f64::INFINITY, |best| best.length);
        if self.params.merge {
            learnt.merge(&built, self.params.widening as u8);
        }
        let mut found = learnt.cheaper(known);
        learnt.note(found.as_ref().map_or(known, |(_, cost)| *cost), built.number);
        let status = self.prove(built.number, &mut found);
        let learnt = self.learnt.as_mut()?;
        let all = learnt.search.expansions();
        Some(Solved { found, expansions: all - std::mem::replace(&mut learnt.told, all), status })
    }

    fn update(&mut self, trails: &mut RowTrails, built: Built) {
        trails.evaporate(self.params.rho);
        for step in built.best.iter().flat_map(|best| best.path.windows(2)) {
            trails.deposit(step[0], built.slices.step_between(step[0], step[1]), self.params.rho);
        }
        trails.limit(LIMITS.0, LIMITS.1);
        let waited = built.number - self.learnt.as_ref().map_or(0, |learnt| learnt.since);
        let after = self.params.trail_restart;
        if after > 0 && waited > 0 && waited.is_multiple_of(after) {
            trails.reset(TRAIL);
        }
    }

    fn show(&self, slices: &Slices, kind: Layer, out: &mut [f32]) -> bool {
        let part = self.learnt.iter().flat_map(|learnt| learnt.search.part());
        (0..).zip(part).filter(|(_, inside)| **inside).for_each(|(place, _)| out[slices.cell(place) as usize] = 1.0);
        kind == Layer::Merged
    }

    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        let learnt = self.learnt.as_ref().filter(|learnt| self.params.proof_limit > 0.0 && learnt.best.is_finite())?;
        let complete = learnt.search.is_proven();
        let lower_bound = if complete { learnt.best } else { learnt.search.lower_bound() * (1.0 - SAME_LENGTH) };
        Some(Certificate { lower_bound, expansions: learnt.search.expansions(), complete })
    }

    fn bytes_of_place(&self) -> u64 {
        SlicesWithin::BYTES
    }

    fn bytes(&self) -> usize {
        self.learnt.as_ref().map_or(0, |learnt| learnt.search.bytes())
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    // The catalog lets nothing else through.
    let slices = scenario.slices.as_ref().expect("a scenario by slices");
    let rules = FormicaSlices::new(FormicaSlicesParams::read(ENTRY.id, values)?, Arc::clone(slices));
    Ok(Box::new(SliceColony::new(scenario, rules, ENTRY.id, seed)?))
}

/// Formica by slices in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "formica-slices",
    name: "Formica by slices",
    family: Family::AntColony,
    summary: "Ants go from slice to slice, an exact search puts their ways together, and the cheapest path is proven.",
    source: crate::aco::formica::ENTRY.source,
    presets: &[],
    components: &[MERGE, PROOF],
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::Merged],
    max_goals: 1,
    grounds: &[Ground::Slices],
    specs: FormicaSlicesParams::specs,
    build,
};
