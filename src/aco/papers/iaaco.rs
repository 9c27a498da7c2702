//! IAACO: Miao, Chen, Yan et al., "Path planning optimization of indoor mobile robot based on adaptive ant colony algorithm", Computers &
//! Industrial Engineering 156 (2021) 107230, doi:10.1016/j.cie.2021.107230.
//!
//! The publication itself was not at hand: rules and numbers are those of a reproduction, aGVsbG93b3JsZA/robot-path-simulation,
//! `rps/aco/iaaco.py`, not checked against it.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | τ = Q |
//! | heuristic | η^β·μ^λ, η = 1 / (σ1·d_ij + σ2·d_jG), μ the angle guidance (`reading`) |
//! | selection | as Ant Colony System, q0(t) = δ0·exp(−(t/T)²/2) |
//! | on each move | nothing |
//! | update | every arrived path blends Q/L in by ρ = κ·L_SG/L_ib, then the iteration's best and worst path (`extreme_paths`) |
//! | daemon actions | none |
//!
//! `reading` decides where, as the reproduction quotes it, the print contradicts itself: μ = 1/cos φ = |y_j − y_G| / d_jG. *printed* is its
//! last form, at least `goal_distance`; *repaired* the reproduction's d_jG over the larger of the differences, 1/cos of the angle to the
//! nearer axis.
//!
//! Left out, because it changes nothing there:
//!
//! - **ε(t)** = exp(−2·(t/T)²), a factor of every η, cancels in the choice of a step.
//! - **ξ**, the exclusion of obstacles, is of the cell that is left, so it cancels, too; with R_s = 0.5 it is 1 on every free cell.
//! - **J**, the path's index of length, safety and energy: the reproduction counts 1·L + 0·S + 0·E.
//!
//! Trails are directed; an ant without a step left is lost; of equal best or worst paths the first counts. On weighted ground, which is ours,
//! η is taken per factor of the step, and L is the cost.

use std::sync::Arc;

use crate::aco::ant::Ant;
use crate::aco::colony::Colony;
use crate::aco::dead_end::DeadEnd;
use crate::aco::heuristic::{self, AT_GOAL};
use crate::aco::odds;
use crate::aco::selection;
use crate::aco::shared_params::{SelectionParams, WalkParams, settings};
use crate::aco::trails::{Row, Trails};
use crate::aco::variant::{Abreast, Iteration, Settings, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction, Point, step_length};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Component, Family, Ground, Layer, PaperReading, Planner, PlannerEntry, Preset, Reading};
use crate::rng::Stream;
use crate::scenario::Scenario;

params! {
    /// Parameters of IAACO.
    pub struct IaacoParams {
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "reproduction of IAACO";
        ..selection: SelectionParams { beta = 7.0, "reproduction of IAACO"; };
        /// weight of the angle guidance μ in the choice of a step
        angle_weight: f64 = 7.0, "λ", [0.0..=50.0], "", "reproduction of IAACO";
        /// how to take what the paper prints against its own text
        reading: Reading = Reading::Repaired, "", [], "", "reproduction of IAACO: 1/cos φ";
        /// weight of the step's own length in η
        near_weight: f64 = 0.1, "σ1", [0.0..=1.0], "", "reproduction of IAACO";
        /// weight of the goal's distance in η
        far_weight: f64 = 0.9, "σ2", [0.01..=1.0], "", "reproduction of IAACO";
        /// probability of the best step at the beginning
        q0: f64 = 0.15, "δ0", [0.0..=1.0], "", "reproduction of IAACO";
        /// evaporation rate of an iteration whose best path is a straight line
        rho_gain: f64 = 0.9, "κ", [0.0..=1.0], "", "reproduction of IAACO";
        /// every arrived ant blends Q / its length in on each step
        deposit: f64 = 2.5, "Q", [0.0..=1e6], "cells", "reproduction of IAACO";
        /// trail on every step before the first iteration
        initial_trail: f64 = 2.5, "τ0", [1e-6..=1e6], "", "reproduction of IAACO: Q";
        /// whether the iteration's best path gains once more and its worst loses
        extreme_paths: bool = true, "", [], "", "reproduction of IAACO";
        /// trail below which the worst path weakens no step
        trail_min: f64 = 0.1, "τ_min", [0.0..=1e6], "", "reproduction of IAACO";
        /// distance that stands for a shorter one
        goal_distance: f64 = AT_GOAL, "ε", [1e-3..=1.0], "cells", "reproduction of IAACO";
        ..walk: WalkParams { dead_end = DeadEnd::Die, "reproduction of IAACO"; };
    }
}

/// η of a step of this length to `j`: 1 / (σ1·d_ij + σ2·d_jG), in 1/cells.
pub fn visibility(p: &IaacoParams, step: f64, j: Point, goal: Point) -> f64 {
    1.0 / (p.near_weight * step + p.far_weight * j.distance(goal).max(p.goal_distance))
}

/// μ of a cell: 1 at the goal; *repaired* in 1 to √2, *printed* in ε to 1.
pub fn guidance(p: &IaacoParams, j: Point, goal: Point) -> f64 {
    let (dx, dy) = (f64::from(j.x.abs_diff(goal.x)), f64::from(j.y.abs_diff(goal.y)));
    let distance = j.distance(goal);
    match p.reading {
        _ if distance == 0.0 => 1.0,
        Reading::Repaired => distance / dx.max(dy),
        Reading::Printed => (dy / distance).max(p.goal_distance),
    }
}

/// q0 in iteration `t` (from 1) of `budget`.
pub fn greed(p: &IaacoParams, t: u32, budget: u32) -> f64 {
    let passed = f64::from(t) / f64::from(budget);
    p.q0 * libm::exp(-0.5 * passed * passed)
}

/// ρ of an iteration whose best path has this length, `straight` cells being the straight line.
pub fn evaporation(p: &IaacoParams, straight: f64, best: f64) -> f64 {
    (p.rho_gain * straight / best).min(1.0)
}

/// τ ← f(τ) on every step of an ant's way.
fn along(trails: &mut Trails, scenario: &Scenario, ant: &Ant, change: impl Fn(f64) -> f64) {
    let mut at = scenario.start;
    for &d in ant.steps() {
        let changed = change(trails.get(at, d));
        trails.blend(at, d, 1.0, changed);
        at = scenario.moves.step(at, d);
    }
}

/// IAACO.
#[derive(Debug, Clone, Copy)]
pub struct Iaaco {
    params: IaacoParams,
    q0: f64,
}

impl Iaaco {
    /// With these parameters.
    pub fn new(params: IaacoParams) -> Self {
        Self { params, q0: params.q0 }
    }
}

impl Variant for Iaaco {
    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.rho_gain, p.deposit, &p.selection, &p.walk)
    }

    fn initial_trail(&self, _: &Scenario) -> f64 {
        self.params.initial_trail
    }

    /// η·μ^(λ/β), so that its β-th power is η^β·μ^λ; with β = 0 ants see nothing.
    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        let p = &self.params;
        let (to, goal) = (scenario.grid.point(j), scenario.grid.point(scenario.goal));
        let share = if p.selection.beta > 0.0 { p.angle_weight / p.selection.beta } else { 0.0 };
        let seen = visibility(p, step_length(d), to, goal) * libm::pow(guidance(p, to, goal), share);
        heuristic::per_factor(scenario, i, d, j, seen)
    }

    fn begin_iteration(&mut self, number: u32) {
        self.q0 = greed(&self.params, number, self.params.selection.iterations);
    }

    fn abreast(&self) -> Abreast {
        Abreast::PseudoProportional(self.q0)
    }

    #[inline(always)]
    fn choose(&self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        selection::pseudo_random_proportional(weights, self.q0, stream)
    }

    fn odds(&self, weights: &Row) -> Vec<f64> {
        odds::pseudo_random_proportional(weights, self.q0)
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        let (p, scenario) = (&self.params, iteration.scenario);
        let ends = iteration.iteration_best().zip(iteration.iteration_worst());
        let Some(((best, shortest), (worst, longest))) = ends else { return };
        let straight = scenario.grid.point(scenario.start).distance(scenario.grid.point(scenario.goal));
        let rho = evaporation(p, straight, shortest);
        for (ant, length) in iteration.arrived() {
            along(trails, scenario, ant, |t| (1.0 - rho) * t + rho * p.deposit / length);
        }
        if p.extreme_paths {
            let gain = p.deposit / shortest * (shortest + longest) / 2.0;
            along(trails, scenario, best, |t| (1.0 - rho) * t + rho * gain);
            along(trails, scenario, worst, |t| ((1.0 - rho) * t - rho * p.deposit / longest).max(p.trail_min));
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = Iaaco::new(IaacoParams::read(ENTRY.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ENTRY.id, seed, 0)))
}

const PRESETS: &[Preset] = &[Preset {
    name: "printed",
    source: "Miao, Chen, Yan et al. 2021, as its reproduction quotes it",
    meaning: "μ = |y_j − y_G| / d_jG, as the last form of its formula says",
    numbers: &[],
    choices: &[("reading", "printed")],
    reading: Some(PaperReading::Printed),
}];

/// What the paper adds, as the reproduction has it.
const COMPONENTS: &[Component] = &[
    Component {
        id: "angle-guidance",
        name: "angle guidance μ",
        adds: "a step is weighed by μ^λ, an angle between its cell and the goal; without: λ = 0",
        without: &[("angle_weight", "0")],
    },
    Component {
        id: "falling-greed",
        name: "best step now and then",
        adds: "with a probability that falls with time an ant takes the best step; without: each by its probability",
        without: &[("q0", "0")],
    },
    Component {
        id: "best-and-worst",
        name: "best and worst path",
        adds: "the iteration's best path gains once more and its worst loses; without: every arrived path alike",
        without: &[("extreme_paths", "false")],
    },
];

/// IAACO in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "iaaco",
    name: "Indoor adaptive ACO",
    family: Family::AntColony,
    summary: "Ants are led by distance and by an angle to the goal; how much a path's trail is renewed follows how straight the best one is.",
    source: "Miao, Chen, Yan et al. 2021, Comput. Ind. Eng. 156, 107230, doi:10.1016/j.cie.2021.107230, after a reproduction",
    presets: PRESETS,
    components: COMPONENTS,
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::WEIGHTED_PLANE,
    specs: IaacoParams::specs,
    build,
};
