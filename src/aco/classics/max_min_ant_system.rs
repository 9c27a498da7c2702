//! MAX–MIN Ant System: Stützle, Hoos, "MAX–MIN Ant System", Future Generation Computer Systems 16 (2000) 889–914,
//! doi:10.1016/S0167-739X(00)00043-1; equations and parameters after Dorigo and Stützle, *Ant Colony Optimization* (MIT Press, 2004),
//! section 3.3.4 and box 3.1.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | box 3.1: the upper limit, 1 / (ρ·C), here 1 / (ρ·L_open) |
//! | heuristic | as Ant System |
//! | selection | as Ant System |
//! | on each move | nothing |
//! | update | eq. 3.9: evaporate, 1/L on the iteration-best or the best-so-far path; then τ_min ≤ τ ≤ τ_max |
//! | limits (`limits`) | τ_max = 1/(ρ·L_bs), τ_min = τ_max·(1 − ⁿ√p)/((avg − 1)·ⁿ√p), p = p_best, anew with each new best |
//! | daemon actions | after `restart_after` iterations without a shorter path all trails start again at τ_max |
//!
//! Where the publication is silent on paths, we do as in [`super::ant_system`], and:
//! - take L_open, the length from start to goal on an open map, for the nearest-neighbour tour C; limits hold from the first path on;
//! - n, the number of choices that must all be right, is the number of steps of the best-so-far path;
//! - avg, the mean number of options of a choice, is the mean number of allowed moves of the map's cells that have any, at least 2;
//! - τ_min is at most τ_max, as the paper says; with few steps the formula exceeds it;
//! - an iteration in which no ant arrives only evaporates, unless it is the turn of the best-so-far path;
//! - that one ant alone deposits cannot be taken out alone: τ_max is where one deposit an iteration leads to;
//! - the best-so-far path has its turn every `best_every` iterations from first to last (the paper's schedule is for runs of thousands
//!   of iterations with local search), and a restart looks only at improvement, not at the branching factor.

use std::sync::Arc;

use crate::aco::colony::Colony;
use crate::aco::deposit;
use crate::aco::shared_params::{SelectionParams, SightParams, WalkParams, open_map_length, settings};
use crate::aco::trails::Trails;
use crate::aco::variant::{Iteration, Settings, Variant};
use crate::aco::weights::power;
use crate::error::ParamError;
use crate::map::{Cell, Direction};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Component, Family, Ground, Layer, Planner, PlannerEntry, Solution};
use crate::scenario::Scenario;

params! {
    /// The numbers of its own rules, also by slices.
    pub struct MaxMinRows {
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.02, "ρ", [0.001..=1.0], "", "Dorigo and Stützle 2004, box 3.1";
        /// whether trails stay between the limits
        limits: bool = true, "τ_min, τ_max", [], "", "Stützle and Hoos 2000; Dorigo and Stützle 2004, section 3.3.4";
        /// probability of repeating the best path once trails have converged; it sets the lower limit of trails
        p_best: f64 = 0.05, "p_best", [0.0001..=0.9999], "", "Stützle and Hoos 2000; Dorigo and Stützle 2004, box 3.1";
        /// the best path so far deposits in every iteration that is a multiple of this, the iteration's best in all others; 0 = never
        best_every: u32 = 25, "u_gb", [0..=100_000], "iterations", "Stützle's program ACOTSP, without local search";
        /// all trails start again at the upper limit after this many iterations without a shorter path; 0 = never
        restart_after: u32 = 250, "", [0..=100_000], "iterations", "Stützle's program ACOTSP";
    }
}

impl MaxMinRows {
    /// Whether this iteration is the turn of the best-so-far path.
    pub fn turn_of_best(&self, number: u32) -> bool {
        self.best_every > 0 && number.is_multiple_of(self.best_every)
    }

    /// Whether all trails start again after so many iterations without a shorter path.
    pub fn restarts(&self, since: u32) -> bool {
        self.restart_after > 0 && since >= self.restart_after
    }
}

params! {
    /// Parameters of MAX–MIN Ant System.
    pub struct MaxMinAntSystemParams {
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "papers' common value; the book takes m = n cities";
        ..selection: SelectionParams;
        ..rules: MaxMinRows;
        ..sight: SightParams;
        ..walk: WalkParams;
    }
}

/// τ_min and τ_max.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The lower limit.
    pub min: f64,
    /// The upper limit.
    pub max: f64,
}

impl Limits {
    /// The limits for a best path of this length and number of steps, with `options` moves to choose from on average.
    pub fn new(rho: f64, p_best: f64, length: f64, steps: u32, options: f64) -> Self {
        let max = 1.0 / (rho * length);
        let root = power(p_best, 1.0 / f64::from(steps));
        let min = max * (1.0 - root) / ((options.max(2.0) - 1.0) * root);
        Self { min: min.min(max), max }
    }
}

/// MAX–MIN Ant System.
#[derive(Debug, Clone, Copy)]
pub struct MaxMinAntSystem {
    params: MaxMinAntSystemParams,
    /// avg.
    options: f64,
    /// None until an ant has arrived.
    limits: Option<Limits>,
    /// The iteration of the last restart; 0 = none.
    restarted: u32,
}

impl MaxMinAntSystem {
    /// With these parameters.
    pub fn new(params: MaxMinAntSystemParams) -> Self {
        Self { params, options: 2.0, limits: None, restarted: 0 }
    }

    fn limits_of(&self, best: &Solution) -> Limits {
        let p = &self.params.rules;
        Limits::new(p.rho, p.p_best, best.length, best.path.len() as u32 - 1, self.options)
    }
}

/// Mean number of allowed moves of the cells that have any.
fn mean_options(scenario: &Scenario) -> f64 {
    let (mut cells, mut moves) = (0u32, 0u32);
    for bits in scenario.moves.bits.iter().filter(|&&b| b != 0) {
        cells += 1;
        moves += bits.count_ones();
    }
    f64::from(moves) / f64::from(cells.max(1))
}

impl Variant for MaxMinAntSystem {
    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.rules.rho, 1.0, &p.selection, &p.walk)
    }

    fn initial_trail(&self, scenario: &Scenario) -> f64 {
        1.0 / (self.params.rules.rho * open_map_length(scenario))
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        self.params.sight.heuristic.of(scenario, i, d, j)
    }

    fn prepare(&mut self, scenario: &Scenario) {
        self.options = mean_options(scenario);
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        trails.evaporate(self.params.rules.rho);
        let Some(best) = iteration.best_so_far else { return };
        if self.params.rules.turn_of_best(iteration.number) {
            deposit::along_path(trails, iteration.scenario, &best.path, 1.0 / best.length);
        } else if let Some((ant, length)) = iteration.iteration_best() {
            deposit::along(trails, iteration.scenario, ant, 1.0 / length);
        }
        if self.limits.is_none() || best.iteration == iteration.number {
            self.limits = Some(self.limits_of(best));
        }
        if let Some(Limits { min, max }) = self.limits.filter(|_| self.params.rules.limits) {
            trails.limit(min, max);
        }
    }

    fn daemon_actions(&mut self, trails: &mut Trails, iteration: Iteration) {
        let (Some(best), Some(limits)) = (iteration.best_so_far, self.limits) else { return };
        let since = iteration.number - best.iteration.max(self.restarted);
        if self.params.rules.restarts(since) {
            trails.reset(limits.max);
            self.restarted = iteration.number;
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = MaxMinAntSystem::new(MaxMinAntSystemParams::read(ENTRY.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ENTRY.id, seed, 0)))
}

/// What the paper adds to Ant System, as far as it can be taken out.
pub const COMPONENTS: &[Component] = &[
    Component {
        id: "limits",
        name: "limits of trails",
        adds: "trails stay between τ_min and τ_max (section 3.3.4); without: they have no limits",
        without: &[("limits", "false")],
    },
    Component {
        id: "turns-of-the-best",
        name: "turns of the best so far",
        adds: "now and then the best path so far deposits in place of the iteration's best (eq. 3.9); without: the iteration's best alone",
        without: &[("best_every", "0")],
    },
    Component {
        id: "restart",
        name: "restart",
        adds: "all trails start again after many iterations without a shorter path (section 3.3.4); without: never; it needs a budget above `restart_after`",
        without: &[("restart_after", "0")],
    },
];

/// MAX–MIN Ant System in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "max-min-ant-system",
    name: "MAX–MIN Ant System",
    family: Family::AntColony,
    summary: "Only the best path of an iteration deposits, and trails stay between two limits, so that no way is ever given up.",
    source: "Stützle, Hoos 2000, Future Generation Computer Systems 16, 889–914, doi:10.1016/S0167-739X(00)00043-1",
    presets: &[],
    components: COMPONENTS,
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: MaxMinAntSystemParams::specs,
    build,
};
