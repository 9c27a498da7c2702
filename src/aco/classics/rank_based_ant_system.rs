//! Rank-based Ant System: Bullnheimer, Hartl, Strauss, "A new rank based version of the Ant System: a computational study", Central
//! European Journal for Operations Research and Economics 7 (1999) 25–38; equation and parameters after Dorigo and Stützle, *Ant Colony
//! Optimization* (MIT Press, 2004), section 3.3.3 and box 3.1.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | box 3.1: 0.5·w·(w − 1) / (ρ·C), here 0.5·w·(w − 1)·Q / (ρ·L_open) |
//! | heuristic | as Ant System |
//! | selection | as Ant System |
//! | on each move | nothing |
//! | update | eq. 3.8: evaporate; the ant of rank r < w leaves (w − r)·Q/L_r (`ranking`), the best-so-far path gets w·Q/L_bs (`best_so_far`) |
//! | daemon actions | none |
//!
//! Where the publication is silent on paths, we do as in [`super::ant_system`], and take L_open, the length from start to goal on an open
//! map, for the nearest-neighbour tour C. Only arrived ants are ranked; of equal lengths the lower index ranks first.

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
    /// Parameters of rank-based Ant System.
    pub struct RankBasedAntSystemParams {
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "papers' common value; the book takes m = n cities";
        ..selection: SelectionParams;
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.1, "ρ", [0.001..=1.0], "", "Dorigo and Stützle 2004, box 3.1";
        /// an ant's deposit is Q / length, times a weight by its rank
        deposit: f64 = 1.0, "Q", [1e-6..=1e6], "cells", "Dorigo and Stützle 2004, eq. 3.8: 1 / length";
        /// weight of the best path so far; the ant of rank r weighs w − r, so w − 1 ants deposit
        ranks: u32 = 6, "w", [2..=100], "ants", "Dorigo and Stützle 2004, box 3.1";
        /// whether deposits weigh by rank; else every arrived ant leaves Q / length, as in Ant System
        ranking: bool = true, "w − r", [], "", "Dorigo and Stützle 2004, eq. 3.8";
        /// whether the best path so far is deposited as well
        best_so_far: bool = true, "L_bs", [], "", "Dorigo and Stützle 2004, eq. 3.8";
        ..sight: SightParams;
        ..walk: WalkParams;
    }
}

/// Rank-based Ant System.
#[derive(Debug, Clone, Copy)]
pub struct RankBasedAntSystem {
    params: RankBasedAntSystemParams,
}

impl RankBasedAntSystem {
    /// With these parameters.
    pub fn new(params: RankBasedAntSystemParams) -> Self {
        Self { params }
    }
}

/// The first sum of Eq. 3.8.
fn by_rank(p: &RankBasedAntSystemParams, trails: &mut Trails, iteration: &Iteration) {
    let mut ranked: Vec<_> = iteration.arrived().collect();
    ranked.sort_by(|a, b| a.1.total_cmp(&b.1));
    for (weight, (ant, length)) in (1..p.ranks).rev().zip(ranked) {
        deposit::along(trails, iteration.scenario, ant, f64::from(weight) * p.deposit / length);
    }
}

impl Variant for RankBasedAntSystem {
    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.rho, p.deposit, &p.selection, &p.walk)
    }

    fn initial_trail(&self, scenario: &Scenario) -> f64 {
        let p = &self.params;
        let weights = 0.5 * f64::from(p.ranks * (p.ranks - 1));
        weights * p.deposit / (p.rho * open_map_length(scenario))
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        self.params.sight.heuristic.of(scenario, i, d, j)
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        let p = &self.params;
        trails.evaporate(p.rho);
        if p.ranking {
            by_rank(p, trails, &iteration);
        } else {
            deposit::ant_cycle(trails, iteration.scenario, iteration.ants, p.deposit);
        }
        if let Some(best) = iteration.best_so_far.filter(|_| p.best_so_far) {
            deposit::along_path(trails, iteration.scenario, &best.path, f64::from(p.ranks) * p.deposit / best.length);
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = RankBasedAntSystem::new(RankBasedAntSystemParams::read(ENTRY.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ENTRY.id, seed, 0)))
}

/// Rank-based Ant System in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "rank-based-ant-system",
    name: "Rank-based Ant System",
    family: Family::AntColony,
    summary: "Only the best few ants of an iteration deposit, the better the more, and the best path so far most of all.",
    source: "Bullnheimer, Hartl, Strauss 1999, Central European J. Operations Research and Economics 7, 25–38",
    presets: &[],
    components: &[
        Component {
            id: "ranking",
            name: "deposits by rank",
            adds: "only the best w − 1 ants of an iteration deposit, the better the more (eq. 3.8); without: every arrived ant leaves Q/L (eq. 3.5)",
            without: &[("ranking", "false")],
        },
        Component {
            id: "best-so-far-deposit",
            name: "deposit of the best so far",
            adds: "the best path so far is deposited w times in each iteration (eq. 3.8); without: ants of the iteration alone deposit",
            without: &[("best_so_far", "false")],
        },
    ],
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: RankBasedAntSystemParams::specs,
    build,
};
