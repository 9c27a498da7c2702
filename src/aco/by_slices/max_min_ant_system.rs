//! MAX–MIN Ant System by slices: Stützle, Hoos, "MAX–MIN Ant System", Future Generation Computer Systems 16 (2000) 889–914,
//! doi:10.1016/S0167-739X(00)00043-1; the rules of [`max_min_ant_system`](crate::aco::max_min_ant_system) on the steps of slices.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | box 3.1: the upper limit, 1 / (ρ·C), C what the straight way would cost (`cost.rs`) |
//! | heuristic | 1 / c_ij, the cost of the step for the distance d_ij; `cost-and-distance` adds the distance that is left |
//! | selection | as Ant System |
//! | on each move | nothing |
//! | update | eq. 3.9: evaporate, 1/C on the iteration-best or the best-so-far path; then τ_min ≤ τ ≤ τ_max |
//! | limits (`limits`) | τ_max = 1/(ρ·C_bs), τ_min = τ_max·(1 − ⁿ√p)/((avg − 1)·ⁿ√p), p = p_best, anew with each new best |
//! | daemon actions | after `restart_after` iterations without a cheaper path all trails start again at τ_max |
//!
//! n is the number of steps of every path, the slices between the ends; avg is the mean number of feasible steps of the places that have any,
//! at least 2. All else as in the colony from cell to cell.

use std::sync::Arc;

use super::colony::{Built, Numbers, Rules, SliceColony};
use super::cost::{SliceHeuristic, mean_options, straight_cost};
use super::trails::RowTrails;
use crate::aco::max_min_ant_system::{COMPONENTS, Limits, MaxMinRows};
use crate::aco::shared_params::{SelectionParams, WalkParams};
use crate::error::ParamError;
use crate::map::{Cell, Slices};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Family, Ground, Layer, Planner, PlannerEntry};
use crate::scenario::Scenario;

params! {
    /// Parameters of MAX–MIN Ant System by slices.
    pub struct MmasSlicesParams {
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "papers' common value; the book takes m = n cities";
        ..selection: SelectionParams;
        ..rules: MaxMinRows;
        /// what an ant sees of a step
        heuristic: SliceHeuristic = SliceHeuristic::Cost, "η", [], "", "Stützle and Hoos 2000: 1/d_ij, here by cost";
        ..walk: WalkParams;
    }
}

/// MAX–MIN Ant System by slices.
#[derive(Debug, Clone, Copy)]
pub struct MmasSlices {
    params: MmasSlicesParams,
    /// avg.
    options: f64,
    /// None until an ant has arrived.
    limits: Option<Limits>,
    /// The iteration of the last restart; 0 = none.
    restarted: u32,
}

impl MmasSlices {
    /// With these parameters.
    pub fn new(params: MmasSlicesParams) -> Self {
        Self { params, options: 2.0, limits: None, restarted: 0 }
    }

    fn deposit(trails: &mut RowTrails, slices: &Slices, path: &[Cell], cost: f64) {
        for step in path.windows(2) {
            trails.deposit(step[0], slices.step_between(step[0], step[1]), 1.0 / cost);
        }
    }
}

impl Rules for MmasSlices {
    const ON_PLACES: bool = false;

    fn numbers(&self) -> Numbers {
        let p = &self.params;
        Numbers { ants: p.ants, selection: p.selection, q0: 0.0, walk: p.walk }
    }

    fn prepare(&mut self, slices: &Slices) {
        self.options = mean_options(slices);
    }

    fn initial_trail(&self, slices: &Slices) -> f64 {
        1.0 / (self.params.rules.rho * straight_cost(slices))
    }

    fn eta(&self, slices: &Slices, from: Cell, to: Cell) -> f64 {
        self.params.heuristic.of(slices, from, to)
    }

    fn update(&mut self, trails: &mut RowTrails, built: Built) {
        let rules = &self.params.rules;
        trails.evaporate(rules.rho);
        let Some(best) = built.best else { return };
        if rules.turn_of_best(built.number) {
            Self::deposit(trails, built.slices, &best.path, best.length);
        } else if let Some((path, cost)) = built.iteration_best {
            Self::deposit(trails, built.slices, path, cost);
        }
        let limits = match self.limits {
            Some(limits) if best.iteration != built.number => limits,
            _ => Limits::new(rules.rho, rules.p_best, best.length, best.path.len() as u32 - 1, self.options),
        };
        self.limits = Some(limits);
        if rules.limits {
            trails.limit(limits.min, limits.max);
        }
        if rules.restarts(built.number - best.iteration.max(self.restarted)) {
            trails.reset(limits.max);
            self.restarted = built.number;
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let rules = MmasSlices::new(MmasSlicesParams::read(ENTRY.id, values)?);
    Ok(Box::new(SliceColony::new(scenario, rules, ENTRY.id, seed)?))
}

/// MAX–MIN Ant System by slices in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "mmas-slices",
    name: "MAX–MIN Ant System by slices",
    family: Family::AntColony,
    summary: "MAX–MIN Ant System over the steps of slices: only the best path of an iteration deposits, and trails stay between two limits.",
    source: "Stützle, Hoos 2000, Future Generation Computer Systems 16, 889–914, doi:10.1016/S0167-739X(00)00043-1",
    presets: &[],
    components: COMPONENTS,
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: &[Ground::Slices],
    specs: MmasSlicesParams::specs,
    build,
};
