//! Ant System: Dorigo, Maniezzo, Colorni, "Ant System: optimization by a colony of cooperating agents", IEEE Transactions on Systems,
//! Man, and Cybernetics B 26 (1996) 29–41, doi:10.1109/3477.484436; parameters after Dorigo and Stützle, *Ant Colony Optimization*
//! (MIT Press, 2004), box 3.1.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | τ0, constant (the book's m/C^nn needs a tour; on a map there is none) |
//! | heuristic | `detour` (ours), `goal` or `step` (the papers' basic ACO) |
//! | selection | random proportional rule, eq. 3.2 of the book |
//! | on each move | nothing (ant-cycle: trails change when the iteration ends) |
//! | update | eq. 3.3–3.5: evaporate, then Q/L on each step of every arrived ant |
//! | daemon actions | none |
//!
//! Ant System was published for tours. Where it is silent on paths: trails are directed (start → goal); a cell is visited once per walk; a
//! dead end lets the ant step back or die (`dead_end`); an ant gives up after `move_limit` × (width + height) moves. The default η is
//! `detour`, because 1/distance is flat far from the goal and ants get lost on large maps with it; the presets keep what the papers print.
//!
//! Presets are the basic ACO of five papers. Evaporation is converted: `rho` is always the part that leaves.

use std::sync::Arc;

use crate::aco::colony::Colony;
use crate::aco::shared_params::{SelectionParams, SightParams, WalkParams, settings};
use crate::aco::variant::{Settings, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Family, Ground, Layer, Planner, PlannerEntry, Preset};
use crate::scenario::Scenario;

params! {
    /// Parameters of Ant System.
    pub struct AntSystemParams {
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "papers' common value; the book takes m = n cities";
        ..selection: SelectionParams;
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.5, "ρ", [0.0..=1.0], "", "Dorigo and Stützle 2004, box 3.1";
        /// an arrived ant leaves Q / length on each of its steps
        deposit: f64 = 1.0, "Q", [1e-6..=1e6], "cells", "Dorigo and Stützle 2004, eq. 3.5: 1 / length";
        /// trail on every step before the first iteration
        initial_trail: f64 = 1.0, "τ0", [1e-6..=1e6], "", "our choice: no tour to derive it from";
        ..sight: SightParams;
        ..walk: WalkParams;
    }
}

/// Ant System.
#[derive(Debug, Clone, Copy)]
pub struct AntSystem {
    params: AntSystemParams,
}

impl AntSystem {
    /// With these parameters.
    pub fn new(params: AntSystemParams) -> Self {
        Self { params }
    }
}

impl Variant for AntSystem {
    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.rho, p.deposit, &p.selection, &p.walk)
    }

    fn initial_trail(&self, _: &Scenario) -> f64 {
        self.params.initial_trail
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        self.params.sight.heuristic.of(scenario, i, d, j)
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = AntSystem::new(AntSystemParams::read(ENTRY.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ENTRY.id, seed, 0)))
}

const PRESETS: &[Preset] = &[
    Preset {
        name: "fire",
        source: "multi-fire path planning for a fire-fighting robot",
        meaning: "basic ACO, repaired: its ρ = 0.3 evaporates (0.7 stays), as its text says; Q is not given, 1",
        numbers: &[("ants", 50.0), ("iterations", 100.0), ("beta", 7.0), ("rho", 0.3)],
        choices: &[("heuristic", "goal")],
        reading: None,
    },
    Preset {
        name: "fire-printed",
        source: "multi-fire path planning for a fire-fighting robot",
        meaning: "basic ACO, as printed in its eq. 4: ρ = 0.3 multiplies what stays, so 0.7 leaves",
        numbers: &[("ants", 50.0), ("iterations", 100.0), ("beta", 7.0), ("rho", 0.7)],
        choices: &[("heuristic", "goal")],
        reading: None,
    },
    Preset {
        name: "ship",
        source: "rescue robot in a ship's engine room (Fan et al. 2026)",
        meaning: "basic ACO, eq. 1–5, repaired: η = 1/distance to the goal (printed is the step's length: choose step)",
        numbers: &[("ants", 50.0), ("iterations", 100.0), ("beta", 2.0), ("rho", 0.8), ("deposit", 10.0)],
        choices: &[("heuristic", "goal")],
        reading: None,
    },
    Preset {
        name: "terrain",
        source: "elitist potential-field ACO in three dimensions",
        meaning: "basic ACO, eq. 1–4, on a plane: η = 1/step length, global evaporation 0.2",
        numbers: &[("ants", 50.0), ("iterations", 100.0), ("beta", 7.0), ("rho", 0.2)],
        choices: &[("heuristic", "step")],
        reading: None,
    },
    Preset {
        name: "threshold",
        source: "adaptive-threshold ACO (Lai, Guo 2014)",
        meaning: "its parameters with Ant System's deposit at the end of the iteration (the paper also deposits after every move); half the trail stays",
        numbers: &[("ants", 10.0), ("iterations", 50.0), ("beta", 25.0), ("rho", 0.5)],
        choices: &[("heuristic", "goal"), ("dead_end", "die")],
        reading: None,
    },
    Preset {
        name: "fireworks",
        source: "fireworks and ant-colony hybrid (Zhou, Mu, Zhang 2019)",
        meaning: "basic ACO, eq. 11–12: its ρ = 0.5 is what stays, so 0.5 leaves; backtracking at dead ends",
        numbers: &[("ants", 50.0), ("iterations", 50.0), ("beta", 3.0), ("rho", 0.5), ("deposit", 5.0)],
        choices: &[("heuristic", "goal")],
        reading: None,
    },
];

/// Ant System in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "ant-system",
    name: "Ant System",
    family: Family::AntColony,
    summary: "The first ant-colony algorithm: every ant that arrives leaves pheromone, more on shorter paths, and trails evaporate.",
    source: "Dorigo, Maniezzo, Colorni 1996, IEEE Trans. SMC-B 26, 29–41, doi:10.1109/3477.484436",
    presets: PRESETS,
    components: &[],
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: AntSystemParams::specs,
    build,
};
