//! Ant Colony System by slices: Dorigo, Gambardella, "Ant Colony System: a cooperative learning approach to the traveling salesman problem",
//! IEEE Transactions on Evolutionary Computation 1 (1997) 53–66, doi:10.1109/4235.585892; the rules of
//! [`ant_colony_system`](crate::aco::ant_colony_system) on the steps of slices.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | box 3.1: 1 / (n·C), n the steps of every path, C what the straight way would cost (`cost.rs`) |
//! | heuristic | 1 / c_ij, the cost of the step for the distance d_ij; `cost-and-distance` adds the distance that is left |
//! | selection | eq. 3.10: pseudo-random proportional rule |
//! | on each move | eq. 3.12: τ ← (1 − ξ)·τ + ξ·τ0 on the step just taken |
//! | update | eq. 3.11: τ ← (1 − ρ)·τ + ρ/C_bs on the steps of the best path so far, and there only |
//! | daemon actions | none |
//!
//! Equations and parameters after Dorigo and Stützle, *Ant Colony Optimization* (MIT Press, 2004). The rule has no α; with `alpha` = 1 the
//! weights are the paper's. A step back from a dead end changes no trail.

use std::sync::Arc;

use super::colony::{Built, Numbers, Rules, SliceColony};
use super::cost::{SliceHeuristic, straight_cost};
use super::trails::RowTrails;
use crate::aco::ant_colony_system::{COMPONENTS, ColonySystemRows};
use crate::aco::shared_params::{SelectionParams, WalkParams};
use crate::error::ParamError;
use crate::map::{Cell, Slices};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Family, Ground, Layer, Planner, PlannerEntry};
use crate::scenario::Scenario;

params! {
    /// Parameters of Ant Colony System by slices.
    pub struct AcsSlicesParams {
        /// ants that build a path in each iteration
        ants: u32 = 10, "m", [1..=1024], "ants", "Dorigo and Stützle 2004, box 3.1";
        ..selection: SelectionParams;
        ..rules: ColonySystemRows;
        /// what an ant sees of a step
        heuristic: SliceHeuristic = SliceHeuristic::Cost, "η", [], "", "Dorigo and Gambardella 1997: 1/d_ij, here by cost";
        ..walk: WalkParams;
    }
}

/// Ant Colony System by slices.
#[derive(Debug, Clone, Copy)]
pub struct AcsSlices {
    params: AcsSlicesParams,
    /// τ0.
    initial: f64,
}

impl AcsSlices {
    /// With these parameters.
    pub fn new(params: AcsSlicesParams) -> Self {
        Self { params, initial: 0.0 }
    }
}

impl Rules for AcsSlices {
    const ON_PLACES: bool = false;

    fn numbers(&self) -> Numbers {
        let p = &self.params;
        Numbers { ants: p.ants, selection: p.selection, q0: p.rules.q0, walk: p.walk }
    }

    fn prepare(&mut self, slices: &Slices) {
        self.initial = self.initial_trail(slices);
    }

    fn initial_trail(&self, slices: &Slices) -> f64 {
        1.0 / (f64::from(slices.slices()) * straight_cost(slices))
    }

    fn eta(&self, slices: &Slices, from: Cell, to: Cell) -> f64 {
        self.params.heuristic.of(slices, from, to)
    }

    fn on_move(&self, trails: &mut RowTrails, _: &Slices, (from, k, _): (Cell, usize, Cell)) {
        trails.blend(from, k, self.params.rules.xi, self.initial);
    }

    fn update(&mut self, trails: &mut RowTrails, built: Built) {
        let Some(best) = built.best else { return };
        for step in best.path.windows(2) {
            let k = built.slices.step_between(step[0], step[1]);
            trails.blend(step[0], k, self.params.rules.rho, 1.0 / best.length);
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let rules = AcsSlices::new(AcsSlicesParams::read(ENTRY.id, values)?);
    Ok(Box::new(SliceColony::new(scenario, rules, ENTRY.id, seed)?))
}

/// Ant Colony System by slices in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "acs-slices",
    name: "Ant Colony System by slices",
    family: Family::AntColony,
    summary: "Ant Colony System over the steps of slices: ants mostly take the best step by its cost, wear off the trail they walk on, and only the best path so far is reinforced.",
    source: "Dorigo, Gambardella 1997, IEEE Trans. Evolutionary Computation 1, 53–66, doi:10.1109/4235.585892",
    presets: &[],
    components: COMPONENTS,
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: &[Ground::Slices],
    specs: AcsSlicesParams::specs,
    build,
};
