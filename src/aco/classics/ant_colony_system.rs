//! Ant Colony System: Dorigo, Gambardella, "Ant Colony System: a cooperative learning approach to the traveling salesman problem", IEEE
//! Transactions on Evolutionary Computation 1 (1997) 53–66, doi:10.1109/4235.585892; equations and parameters after Dorigo and Stützle,
//! *Ant Colony Optimization* (MIT Press, 2004), section 3.4.1 and box 3.1.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | box 3.1: 1 / (n·C), here 1 / (n·L_open) |
//! | heuristic | as Ant System |
//! | selection | eq. 3.10: pseudo-random proportional rule |
//! | on each move | eq. 3.12: τ ← (1 − ξ)·τ + ξ·τ0 on the step just taken |
//! | update | eq. 3.11: τ ← (1 − ρ)·τ + ρ/L_bs on the steps of the best-so-far path, and there only |
//! | daemon actions | none |
//!
//! Where the publication is silent on paths, we do as in [`super::ant_system`], and take L_open, the length from start to goal on an open
//! map, for the nearest-neighbour tour C, and the steps of that path for n, as a tour of n cities has n steps. All ants move in lock
//! step, one move each in index order, as the paper does; a step back from a dead end changes no trail. The rule has no α; with
//! `alpha` = 1 the weights are the paper's τ·η^β. Its third addition, that the best path so far alone is reinforced (eq. 3.11), cannot be
//! taken out alone: nothing else reinforces.

use std::sync::Arc;

use crate::aco::colony::Colony;
use crate::aco::odds;
use crate::aco::selection::pseudo_random_proportional;
use crate::aco::shared_params::{SelectionParams, SightParams, WalkParams, open_map_length, open_map_steps, settings};
use crate::aco::trails::{Row, Trails};
use crate::aco::variant::{Abreast, Iteration, Settings, Step, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Component, Family, Ground, Layer, Planner, PlannerEntry};
use crate::rng::Stream;
use crate::scenario::Scenario;

params! {
    /// The numbers of its own rules, also by slices.
    pub struct ColonySystemRows {
        /// evaporation rate: the part that leaves in each iteration, on the best path so far only
        rho: f64 = 0.1, "ρ", [0.0..=1.0], "", "Dorigo and Stützle 2004, box 3.1";
        /// probability of taking the best step instead of drawing one
        q0: f64 = 0.9, "q0", [0.0..=1.0], "", "Dorigo and Stützle 2004, box 3.1";
        /// local evaporation: the part of a step's trail that an ant replaces by τ0 as it passes
        xi: f64 = 0.1, "ξ", [0.0..=1.0], "", "Dorigo and Stützle 2004, box 3.1";
    }
}

params! {
    /// Parameters of Ant Colony System.
    pub struct AntColonySystemParams {
        /// ants that build a path in each iteration
        ants: u32 = 10, "m", [1..=1024], "ants", "Dorigo and Stützle 2004, box 3.1";
        ..selection: SelectionParams;
        ..rules: ColonySystemRows;
        ..sight: SightParams;
        ..walk: WalkParams;
    }
}

/// Ant Colony System.
#[derive(Debug, Clone, Copy)]
pub struct AntColonySystem {
    params: AntColonySystemParams,
    /// τ0.
    initial: f64,
}

impl AntColonySystem {
    /// With these parameters.
    pub fn new(params: AntColonySystemParams) -> Self {
        Self { params, initial: 0.0 }
    }
}

impl Variant for AntColonySystem {
    const LOCK_STEP: bool = true;

    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.rules.rho, 1.0, &p.selection, &p.walk)
    }

    fn initial_trail(&self, scenario: &Scenario) -> f64 {
        1.0 / (f64::from(open_map_steps(scenario)) * open_map_length(scenario))
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        self.params.sight.heuristic.of(scenario, i, d, j)
    }

    fn prepare(&mut self, scenario: &Scenario) {
        self.initial = self.initial_trail(scenario);
    }

    fn abreast(&self) -> Abreast {
        Abreast::PseudoProportional(self.params.rules.q0)
    }

    #[inline(always)]
    fn choose(&self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        pseudo_random_proportional(weights, self.params.rules.q0, stream)
    }

    fn odds(&self, weights: &Row) -> Vec<f64> {
        odds::pseudo_random_proportional(weights, self.params.rules.q0)
    }

    fn on_move(&self, trails: &mut Trails, step: Step) {
        trails.blend(step.from, step.direction, self.params.rules.xi, self.initial);
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        let Some(best) = iteration.best_so_far else { return };
        for step in best.path.windows(2) {
            let direction = iteration.scenario.moves.direction(step[0], step[1]);
            trails.blend(step[0], direction, self.params.rules.rho, 1.0 / best.length);
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = AntColonySystem::new(AntColonySystemParams::read(ENTRY.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ENTRY.id, seed, 0)))
}

/// What the paper adds to Ant System, as far as it can be taken out.
pub const COMPONENTS: &[Component] = &[
    Component {
        id: "greedy-choice",
        name: "mostly the best step (q0)",
        adds: "with probability q0 an ant takes the best step (eq. 3.10); without: every step by its probability (eq. 3.2)",
        without: &[("q0", "0")],
    },
    Component {
        id: "local-update",
        name: "local update",
        adds: "an ant wears off the trail of each step it takes (eq. 3.12); without: it changes nothing as it walks",
        without: &[("xi", "0")],
    },
];

/// Ant Colony System in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "ant-colony-system",
    name: "Ant Colony System",
    family: Family::AntColony,
    summary: "Ants mostly take the best step, wear off the trail they walk on, and only the best path so far is reinforced.",
    source: "Dorigo, Gambardella 1997, IEEE Trans. Evolutionary Computation 1, 53–66, doi:10.1109/4235.585892",
    presets: &[],
    components: COMPONENTS,
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: AntColonySystemParams::specs,
    build,
};
