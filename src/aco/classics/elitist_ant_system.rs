//! Elitist Ant System: Dorigo, Maniezzo, Colorni, "Ant System: optimization by a colony of cooperating agents", IEEE Transactions on
//! Systems, Man, and Cybernetics B 26 (1996) 29–41, doi:10.1109/3477.484436; equations and parameters after Dorigo and
//! Stützle, *Ant Colony Optimization* (MIT Press, 2004), section 3.3.2 and box 3.1.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | box 3.1: (e + m) / (ρ·C), here (e + m)·Q / (ρ·L_open) |
//! | heuristic | as Ant System |
//! | selection | as Ant System |
//! | on each move | nothing |
//! | update | eq. 3.6–3.7: as Ant System, then e·Q/L_bs on each step of the best-so-far path |
//! | daemon actions | none |
//!
//! Where the publication is silent on paths, we do as in [`super::ant_system`], and take L_open, the length from start to goal on an open
//! map, for the nearest-neighbour tour C. The book sets e and m to the number of cities n; a path has no n to know beforehand, so e = m.

use std::sync::Arc;

use crate::aco::colony::Colony;
use crate::aco::deposit;
use crate::aco::shared_params::{SelectionParams, SightParams, WalkParams, open_map_length, settings};
use crate::aco::trails::Trails;
use crate::aco::variant::{Iteration, Settings, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Component, Family, Ground, Layer, Planner, PlannerEntry};
use crate::scenario::Scenario;

params! {
    /// Parameters of Elitist Ant System.
    pub struct ElitistAntSystemParams {
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "papers' common value; the book takes m = n cities";
        ..selection: SelectionParams;
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.5, "ρ", [0.001..=1.0], "", "Dorigo and Stützle 2004, box 3.1";
        /// an arrived ant leaves Q / length on each of its steps
        deposit: f64 = 1.0, "Q", [1e-6..=1e6], "cells", "Dorigo and Stützle 2004, eq. 3.5: 1 / length";
        /// weight of the best path so far: it is deposited this many times in each iteration
        elitists: f64 = 50.0, "e", [0.0..=1000.0], "ants", "Dorigo and Stützle 2004, box 3.1: e = n = m";
        ..sight: SightParams;
        ..walk: WalkParams;
    }
}

/// Elitist Ant System.
#[derive(Debug, Clone, Copy)]
pub struct ElitistAntSystem {
    params: ElitistAntSystemParams,
}

impl ElitistAntSystem {
    /// With these parameters.
    pub fn new(params: ElitistAntSystemParams) -> Self {
        Self { params }
    }
}

impl Variant for ElitistAntSystem {
    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.rho, p.deposit, &p.selection, &p.walk)
    }

    fn initial_trail(&self, scenario: &Scenario) -> f64 {
        let p = &self.params;
        (p.elitists + f64::from(p.ants)) * p.deposit / (p.rho * open_map_length(scenario))
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        self.params.sight.heuristic.of(scenario, i, d, j)
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        let p = &self.params;
        trails.evaporate(p.rho);
        deposit::ant_cycle(trails, iteration.scenario, iteration.ants, p.deposit);
        if let Some(best) = iteration.best_so_far {
            deposit::along_path(trails, iteration.scenario, &best.path, p.elitists * p.deposit / best.length);
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = ElitistAntSystem::new(ElitistAntSystemParams::read(ENTRY.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ENTRY.id, seed, 0)))
}

/// Elitist Ant System in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "elitist-ant-system",
    name: "Elitist Ant System",
    family: Family::AntColony,
    summary: "Ant System in which the best path so far gets extra pheromone in every iteration, as if elitist ants walked it again.",
    source: "Dorigo, Maniezzo, Colorni 1996, IEEE Trans. SMC-B 26, 29–41, doi:10.1109/3477.484436",
    presets: &[],
    components: &[Component {
        id: "elitists",
        name: "elitist ants",
        adds: "the best path so far is deposited e times more in each iteration (eq. 3.6–3.7); without: e = 0, Ant System",
        without: &[("elitists", "0")],
    }],
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: ElitistAntSystemParams::specs,
    build,
};
