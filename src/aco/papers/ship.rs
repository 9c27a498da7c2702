//! Rescue robot in a ship's engine room: 范学兴, 张彬, 刘世翔, 朱文斌 (Fan, Zhang, Liu, Zhu), 基于改进蚁群算法的船舶机舱救援机器人路径规划
//! (Path planning for ship engine room rescue robot based on improved ant colony algorithm), Journal of Dalian Maritime University 52(1)
//! (2026) 87–98, doi:10.16411/j.cnki.issn1006-7736.2026.01.009.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | as Ant System |
//! | heuristic | Eq. 6–7: pull of the goal, direction (`direction`), obstacle density, with a weight ω(t) that grows (`growing_pull`) |
//! | selection | Eq. 1: as Ant System |
//! | on each move | as Ant System (nothing) |
//! | update | Eq. 9–11 (`shifting_weights`, `weaken_worst`) and 14 with Eq. 8; or Eq. 12 with Eq. 8 (`update`); what evaporates: `rho_part`, `evaporation` |
//! | daemon actions | section 3.3: the best path is refined by line of sight (`refinement`); ants and trails know nothing of it |
//!
//! `reading` decides where the printed formula does not do what its text says:
//!
//! | Eq. | `printed` | `repaired` |
//! |---|---|---|
//! | 7, f_a | a constant, 1 | 1 / max(d(j, E), 1): "the nearer, the stronger" |
//! | 7, θ in h | at i, between the directions to the goal and to the obstacles around i | at i, between the directions to the goal and to j |
//! | 7, α_obs | blocked share of the cells around i | blocked share of the cells around j |
//! | 8, Δω\* | one number, added to every step of the map | its gain on the iteration's best path, its loss on the worst |
//!
//! Printed, all of Eq. 7 but 1/d_ij depends on i alone and cancels in Eq. 1: η then only prefers straight steps.
//!
//! Where the paper is silent, we: start from τ0 = 1; let α(t) grow from 0.5 to 1, β(t) fall from 1 to 0.5, γ(t) rise from 0 to 0.5 in the
//! second half of the iterations, all linearly (Eq. 10–11 give no formula); set μ = 10, γ = 1, ω from 2 to 4, both k = 1 (no value is
//! given); weaken no step below `trail_min` (its proof needs positive trails); take what lies beyond the border for an obstacle; take
//! d(i, E) as at least 1; let ants at a dead end step back. Its section 4 calls Q = 10 the initial trail, Eq. 5 and 10 the intensity of a
//! deposit: we use it as the equations do. Its steps 3 and 4 count the ants on each path: Eq. 12 sums over them anyway, and `count_ants` has
//! Eq. 8, 10 and 11 take each path's Q/L as often as ants of the iteration walked it. Its step 4 updates by Eq. 12, its convergence proof by
//! Eq. 14, the default here. Its step 6 refines once, after the last iteration; we refine each new best path, which shows the same path in
//! the end: the shortest one is chosen by its length before refinement. Section 3.3 can be read in two ways: from each kept node to the
//! farthest later one in sight, as its introduction says of ref. 22, the default; or node by node up to the first one out of sight
//! (`refinement`).
//!
//! Section 4 has ρ = 0.8 as the *initial* evaporation factor, section 3.2 a *dynamic non-linear* evaporation rate that takes the difference
//! between best and worst path as its regulator, and no equation has either: ρ is a constant in all of them, the default. `evaporation`
//! offers both in words of ours ([`evaporation`]). Which part of a trail ρ is the papers of this kind do not agree on: Eq. 3 and 9 have it
//! leave, papers that print ρ·τ have it stay (`rho_part`, preset `second-reading`).
//!
//! Everything that the paper adds can be taken out alone ([`COMPONENTS`]), but for that evaporation rate, which is not in the default. What
//! adapts to time (Eq. 6, 10 and 11) is replaced by its mean over the run, so that the adaptation is taken out and not the strength, which is
//! ours. With all of μ^f_a, d^h and exp(−γ·α_obs) out, η is 1/d_ij (Eq. 2); with Eq. 12 and without Δω\*, the update is Ant System's.

use std::sync::Arc;

use crate::aco::ant::Ant;
use crate::aco::colony::Colony;
use crate::aco::deposit;
use crate::aco::shared_params::{SelectionParams, WalkParams, settings};
use crate::aco::trails::Trails;
use crate::aco::variant::{Iteration, Settings, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction, OFFSETS, Point};
use crate::metrics::{obstacle_density, obstacles_around};
use crate::params::{Params, Values};
use crate::path::Refinement;
use crate::planner::{Component, Family, Ground, Layer, PaperReading, Planner, PlannerEntry, Preset, Reading};
use crate::scenario::Scenario;
use crate::{param_choice, params};

param_choice! {
    /// Which of the paper's two trail updates.
    pub enum Update {
        /// equations 9–11 and 14: weighted deposits on global-best and iteration-best path, a withdrawal on the iteration-worst
        Weighted = "weighted",
        /// equation 12, which the paper's step 4 names: every arrived ant deposits, as in Ant System
        AllAnts = "all-ants",
    }
}

param_choice! {
    /// Which part of every trail ρ is.
    pub enum RhoPart {
        /// ρ leaves in each iteration: equations 3 and 9
        Leaves = "leaves",
        /// ρ stays, 1 − ρ leaves: as in papers that print ρ·τ
        Stays = "stays",
    }
}

param_choice! {
    /// How the part that leaves changes with time.
    pub enum Evaporation {
        /// it does not: every equation
        Constant = "constant",
        /// the "initial" factor of section 4: from iteration to iteration it shrinks, down to its least
        Shrinking = "shrinking",
        /// the "dynamic non-linear" rate of section 3.2: the larger, the more the iteration's worst path is longer than its best
        ByLengths = "by-lengths",
    }
}

params! {
    /// Parameters of the engine-room planner.
    pub struct ShipParams {
        /// how the paper's formulas are read where they do not do what its text says
        reading: Reading = Reading::Repaired, "", [], "", "ours: see the paper card";
        /// which of the paper's two trail updates
        update: Update = Update::Weighted, "", [], "", "Fan et al. 2026, eq. 14; its step 4 names eq. 12";
        /// ants that build a path in each iteration
        ants: u32 = 50, "M", [1..=1024], "ants", "Fan et al. 2026, section 4";
        ..selection: SelectionParams {
            iterations = 100, "Fan et al. 2026, section 4";
            alpha = 1.0, "Fan et al. 2026, section 4";
            beta = 2.0, "Fan et al. 2026, section 4";
        };
        /// ρ of the paper: the part of every trail that leaves in each iteration, or that stays
        rho: f64 = 0.8, "ρ", [0.0..=1.0], "", "Fan et al. 2026, section 4";
        /// whether ρ leaves or stays
        rho_part: RhoPart = RhoPart::Leaves, "", [], "", "Fan et al. 2026, eq. 3 and 9; sibling papers have it stay";
        /// how the part of every trail that leaves changes with time
        evaporation: Evaporation = Evaporation::Constant, "ρ(t)", [], "", "Fan et al. 2026, sections 3.2 and 4, in words alone";
        /// factor by which the part that leaves shrinks in each iteration
        rho_shrink: f64 = 0.95, "λ", [0.5..=1.0], "", "our choice: not given", when(evaporation: "shrinking");
        /// least part that leaves, unless less leaves from the beginning
        rho_min: f64 = 0.1, "ρ_min", [0.0..=1.0], "", "our choice: not given", when(evaporation: "shrinking" | "by-lengths");
        /// intensity of every deposit: Q / length
        deposit: f64 = 10.0, "Q", [1e-6..=1e6], "cells", "Fan et al. 2026, section 4, where it is called the initial trail";
        /// whether d(i, E)^h pulls in the direction of the goal; else η has no such factor
        direction: bool = true, "h", [], "", "Fan et al. 2026, eq. 7";
        /// strength of the goal's pull
        goal_pull: f64 = 10.0, "μ", [1.0..=100.0], "", "our choice: not given";
        /// whether the weight of the goal's pull goes from its first to its last value; else it is their mean all the time
        growing_pull: bool = true, "ω(t)", [], "", "Fan et al. 2026, eq. 6";
        /// weight of the goal's pull at the beginning
        omega_min: f64 = 2.0, "ω_min", [0.0..=6.0], "", "our choice: not given";
        /// weight of the goal's pull at the end
        omega_max: f64 = 4.0, "ω_max", [0.0..=6.0], "", "our choice: not given";
        /// how strongly obstacles around a cell repel
        obstacle_push: f64 = 1.0, "γ", [0.0..=50.0], "", "our choice: not given";
        /// whether the weights of global-best, iteration-best and iteration-worst path shift with time; else they are their means over the run
        shifting_weights: bool = true, "α(t), β(t), γ(t)", [], "", "Fan et al. 2026, eq. 10–11", when(update: "weighted");
        /// whether the iteration's worst path loses trail, by Δτ⁻ and by the second term of the additional trail
        weaken_worst: bool = true, "Δτ⁻", [], "", "Fan et al. 2026, eq. 8, 9 and 11";
        /// whether each path's Q / length counts as often as ants of the iteration walked that path
        count_ants: bool = false, "", [], "", "Fan et al. 2026, steps 3 and 4", when(update: "weighted");
        /// weight of the iteration's best path in the additional trail
        k_best: f64 = 1.0, "k_best", [0.0..=100.0], "", "our choice: not given";
        /// weight of the iteration's worst path in the additional trail
        k_worst: f64 = 1.0, "k_worst", [0.0..=100.0], "", "our choice: not given";
        /// trail on every step before the first iteration
        initial_trail: f64 = 1.0, "τ0", [1e-6..=1e6], "", "our choice: not given";
        /// the worst path is not weakened below this trail
        trail_min: f64 = 1e-6, "τ_min", [1e-30..=1.0], "", "our choice: the paper's proof needs positive trails";
        ..walk: WalkParams;
        /// which node of the best path follows a kept one: those between are dropped, so that segments may have any angle
        refinement: Refinement = Refinement::Farthest, "", [], "", "Fan et al. 2026, section 3.3; next: its words taken one by one";
    }
}

/// Eq. 6: ω(t) = ω_min + (ω_max − ω_min)·t/T; without it, the mean of both.
pub fn omega(p: &ShipParams, t: u32) -> f64 {
    let part = if p.growing_pull { f64::from(t) / f64::from(p.selection.iterations) } else { 0.5 };
    p.omega_min + (p.omega_max - p.omega_min) * part
}

/// The four quantities of Eq. 7 that ω(t) and the parameters act on, for the step from i to j.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// d(i, E), at least 1.
    pub distance: f64,
    /// f_a, the exponent of μ.
    pub pull: f64,
    /// h = ½(1 + cos θ), the exponent of d(i, E).
    pub angle: f64,
    /// α_obs, from 0 to 1.
    pub density: f64,
}

/// What an ant at `i` sees of the step in direction `d` to `j` (Eq. 7).
pub fn seen(p: &ShipParams, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> Sight {
    let all = sight(p.reading, scenario, i, d, j);
    // d^0 = 1: no factor.
    Sight { angle: if p.direction { all.angle } else { 0.0 }, ..all }
}

/// All that Eq. 7 has to say of the step in direction `d` from `i` to `j`.
pub fn sight(reading: Reading, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> Sight {
    let (at, next, goal) = (scenario.grid.point(i), scenario.grid.point(j), scenario.grid.point(scenario.goal));
    let to_goal = vector(at, goal);
    let (step_x, step_y) = OFFSETS[d as usize];
    let (pull, beside, around) = match reading {
        Reading::Printed => (1.0, obstacle_direction(scenario, i), i),
        Reading::Repaired => (1.0 / norm(vector(next, goal)).max(1.0), (f64::from(step_x), f64::from(step_y)), j),
    };
    Sight {
        distance: norm(to_goal).max(1.0),
        pull,
        angle: 0.5 * (1.0 + cosine(to_goal, beside)),
        density: obstacle_density(scenario, around),
    }
}

/// Eq. 7: η_ij(t) = (μ^f_a · d(i,E)^h)^ω(t) / d_ij · exp(−γ·α_obs).
pub fn eta(p: &ShipParams, omega: f64, sight: &Sight, step: f64) -> f64 {
    let attraction = libm::pow(p.goal_pull, sight.pull) * libm::pow(sight.distance, sight.angle);
    libm::pow(attraction, omega) / step * libm::exp(-p.obstacle_push * sight.density)
}

/// Eq. 7 as ln η = a + b·ω(t): what stays in time, and what ω(t) multiplies.
pub fn log_eta(p: &ShipParams, sight: &Sight, step: f64) -> (f64, f64) {
    let fixed = -libm::log(step) - p.obstacle_push * sight.density;
    (fixed, sight.pull * libm::log(p.goal_pull) + sight.angle * libm::log(sight.distance))
}

/// Sum of the directions to the blocked cells around a cell; (0, 0) where there is none.
fn obstacle_direction(scenario: &Scenario, at: Cell) -> (f64, f64) {
    obstacles_around(scenario, at).fold((0.0, 0.0), |sum, (dx, dy)| {
        let length = norm((f64::from(dx), f64::from(dy)));
        (sum.0 + f64::from(dx) / length, sum.1 + f64::from(dy) / length)
    })
}

fn vector(from: Point, to: Point) -> (f64, f64) {
    (f64::from(to.x) - f64::from(from.x), f64::from(to.y) - f64::from(from.y))
}

fn norm((x, y): (f64, f64)) -> f64 {
    libm::sqrt(x * x + y * y)
}

/// cos θ between two directions; 1, no deviation, where one of them is none.
fn cosine(a: (f64, f64), b: (f64, f64)) -> f64 {
    let lengths = norm(a) * norm(b);
    // Vectors that cancel to a rounding error have no direction.
    if lengths < 1e-9 { 1.0 } else { ((a.0 * b.0 + a.1 * b.1) / lengths).clamp(-1.0, 1.0) }
}

/// α(t), β(t), γ(t) of Eq. 10–11.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathWeights {
    /// α(t), of the global-best path: grows from 0.5 to 1.
    pub global_best: f64,
    /// β(t), of the iteration-best path: falls from 1 to 0.5.
    pub iteration_best: f64,
    /// γ(t), of the iteration-worst path: 0, in the second half growing to 0.5.
    pub iteration_worst: f64,
}

/// Eq. 10–11: the adaptive weights at iteration t of T.
pub fn path_weights(t: u32, budget: u32) -> PathWeights {
    let s = f64::from(t) / f64::from(budget);
    PathWeights { global_best: 0.5 + 0.5 * s, iteration_best: 1.0 - 0.5 * s, iteration_worst: (s - 0.5).max(0.0) }
}

/// The means of [`path_weights`] over the run.
pub const MEAN_WEIGHTS: PathWeights = PathWeights { global_best: 0.75, iteration_best: 0.75, iteration_worst: 0.125 };

impl ShipParams {
    /// The part of every trail that leaves, before it changes with time.
    pub fn leaving(&self) -> f64 {
        match self.rho_part {
            RhoPart::Leaves => self.rho,
            RhoPart::Stays => 1.0 - self.rho,
        }
    }
}

/// The part of every trail that leaves in iteration t, from 1. With r, the part by ρ, and m the smaller of r and ρ_min it is r; or
/// max(r·λ^(t − 1), m), as ρ is made to shrink in adaptive colonies for tours; or m + (r − m)·(1 − L_best / L_worst) by the iteration's own
/// paths, and m where no ant arrived. Both formulas are ours: the paper has words alone.
pub fn evaporation(p: &ShipParams, t: u32, lengths: Option<(f64, f64)>) -> f64 {
    let r = p.leaving();
    let least = p.rho_min.min(r);
    match p.evaporation {
        Evaporation::Constant => r,
        Evaporation::Shrinking => (r * libm::pow(p.rho_shrink, f64::from(t.saturating_sub(1)))).max(least),
        Evaporation::ByLengths => least + (r - least) * lengths.map_or(0.0, |(best, worst)| 1.0 - best / worst),
    }
}

/// How many ants of an iteration walked these steps; at least 1, for a path that an earlier one has found.
pub fn ants_on(ants: &[Ant], steps: &[Direction]) -> f64 {
    let count = ants.iter().filter(|ant| ant.length().is_some() && ant.steps() == steps).count();
    count.max(1) as f64
}

/// The two terms of Eq. 8, Δω* = k_best·Q/L_best − k_worst·Q/L_worst; the worst path's is 0 where it is not weakened.
pub fn extra_trail(p: &ShipParams, best: f64, worst: f64) -> (f64, f64) {
    let loss = if p.weaken_worst { p.k_worst * p.deposit / worst } else { 0.0 };
    (p.k_best * p.deposit / best, loss)
}

/// The planner of the paper.
#[derive(Debug, Clone, Copy)]
pub struct Ship {
    params: ShipParams,
    /// ω(t) of the iteration at work.
    omega: f64,
}

impl Ship {
    /// With these parameters.
    pub fn new(params: ShipParams) -> Self {
        Self { params, omega: omega(&params, 0) }
    }

    /// How often the Q / length of a path with these steps counts.
    fn times(&self, iteration: &Iteration, steps: &[Direction]) -> f64 {
        let counts = self.params.count_ants && self.params.update == Update::Weighted;
        if counts { ants_on(iteration.ants, steps) } else { 1.0 }
    }

    /// Eq. 9–11 without what evaporates: +Δτ⁺ on the best paths; what Δτ⁻ takes from the worst is returned.
    fn weighted(&self, trails: &mut Trails, iteration: &Iteration) -> f64 {
        let (q, shifting, scenario) = (self.params.deposit, self.params.shifting_weights, iteration.scenario);
        let weights = if shifting { path_weights(iteration.number, iteration.budget) } else { MEAN_WEIGHTS };
        if let Some(best) = iteration.best_so_far {
            let times = self.times(iteration, &steps_of(scenario, &best.path));
            deposit::along_path(trails, scenario, &best.path, times * weights.global_best * q / best.length);
        }
        if let Some((ant, length)) = iteration.iteration_best() {
            let times = self.times(iteration, ant.steps());
            deposit::along(trails, scenario, ant, times * weights.iteration_best * q / length);
        }
        let worst = iteration.iteration_worst().filter(|_| self.params.weaken_worst);
        worst.map_or(0.0, |(ant, length)| self.times(iteration, ant.steps()) * weights.iteration_worst * q / length)
    }
}

/// The steps of a path of neighbouring cells.
fn steps_of(scenario: &Scenario, path: &[Cell]) -> Vec<Direction> {
    path.windows(2).map(|step| scenario.moves.direction(step[0], step[1])).collect()
}

/// Takes the same amount from each step of a walk, not below `floor`.
fn withdraw_along(trails: &mut Trails, scenario: &Scenario, ant: &Ant, amount: f64, floor: f64) {
    let mut at = scenario.start;
    for &d in ant.steps() {
        trails.withdraw(at, d, amount, floor);
        at = scenario.moves.step(at, d);
    }
}

impl Variant for Ship {
    const TIMED: bool = true;

    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.leaving(), p.deposit, &p.selection, &p.walk)
    }

    fn initial_trail(&self, _: &Scenario) -> f64 {
        self.params.initial_trail
    }

    fn begin_iteration(&mut self, number: u32) {
        self.omega = omega(&self.params, number);
    }

    fn heuristic_changes(&self, _: u32) -> bool {
        true
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        eta(&self.params, self.omega, &seen(&self.params, scenario, i, d, j), scenario.moves.length(i, d))
    }

    fn log_heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> (f64, f64) {
        log_eta(&self.params, &seen(&self.params, scenario, i, d, j), scenario.moves.length(i, d))
    }

    fn time(&self) -> f64 {
        self.omega
    }

    /// Section 3.3.
    fn refinement(&self) -> Refinement {
        self.params.refinement
    }

    /// Eq. 14, or Eq. 12. What is taken from the worst path is taken last, so that the floor holds for the sum.
    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        let p = &self.params;
        let ends = iteration.iteration_best().zip(iteration.iteration_worst());
        trails.evaporate(evaporation(p, iteration.number, ends.map(|((_, best), (_, worst))| (best, worst))));
        let mut taken = match p.update {
            Update::Weighted => self.weighted(trails, &iteration),
            Update::AllAnts => {
                deposit::ant_cycle(trails, iteration.scenario, iteration.ants, p.deposit);
                0.0
            }
        };
        let Some(((best, shortest), (worst, longest))) = ends else { return };
        let (gain, loss) = extra_trail(p, shortest, longest);
        let (gain, loss) = (gain * self.times(&iteration, best.steps()), loss * self.times(&iteration, worst.steps()));
        match p.reading {
            Reading::Printed => trails.shift(gain - loss),
            Reading::Repaired => {
                deposit::along(trails, iteration.scenario, best, gain);
                taken += loss;
            }
        }
        if taken > 0.0 {
            withdraw_along(trails, iteration.scenario, worst, taken, p.trail_min);
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = Ship::new(ShipParams::read(ENTRY.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ENTRY.id, seed, 0)))
}

const PRESETS: &[Preset] = &[
    Preset {
        name: "printed",
        source: "rescue robot in a ship's engine room (Fan et al. 2026)",
        meaning: "everything literally: eq. 7 and 8 as printed, eq. 12 for the update, as its step 4 says, and section 3.3 node by node",
        numbers: &[],
        choices: &[("reading", "printed"), ("update", "all-ants"), ("refinement", "next")],
        reading: Some(PaperReading::Printed),
    },
    Preset {
        name: "second-reading",
        source: "rescue robot in a ship's engine room (Fan et al. 2026)",
        meaning: "its ρ = 0.8 as the part of every trail that stays, as papers of its kind print it; all else as we read it",
        numbers: &[],
        choices: &[("rho_part", "stays")],
        reading: Some(PaperReading::SecondReading),
    },
    Preset {
        name: "cells",
        source: "rescue robot in a ship's engine room (Fan et al. 2026), without its section 3.3",
        meaning: "the search alone: the best path stays cell by cell, to be compared with planners that do not refine",
        numbers: &[],
        choices: &[("refinement", "none")],
        reading: None,
    },
];

/// What the paper adds, in the order of its equations.
pub const COMPONENTS: &[Component] = &[
    Component {
        id: "growing-pull",
        name: "growing pull ω(t)",
        adds: "the weight of goal and direction grows with the iterations (eq. 6); without: its mean all the time",
        without: &[("growing_pull", "false")],
    },
    Component {
        id: "goal-pull",
        name: "pull of the goal",
        adds: "η grows by μ^f_a near the goal (eq. 7); without: no such factor, μ = 1",
        without: &[("goal_pull", "1")],
    },
    Component {
        id: "direction",
        name: "direction",
        adds: "η grows by d(i, E)^h, the more the straighter a step leads to the goal (eq. 7); without: no such factor",
        without: &[("direction", "false")],
    },
    Component {
        id: "obstacle-density",
        name: "obstacle density",
        adds: "η falls by exp(−γ·α_obs) where many cells around are blocked (eq. 7); without: γ = 0",
        without: &[("obstacle_push", "0")],
    },
    Component {
        id: "extra-trail",
        name: "additional trail Δω*",
        adds: "the iteration's best path gains and its worst loses once more (eq. 8); without: both k = 0",
        without: &[("k_best", "0"), ("k_worst", "0")],
    },
    Component {
        id: "weighted-paths",
        name: "best and worst paths alone",
        adds: "only global-best, iteration-best and iteration-worst path change trails (eq. 9–11 and 14); without: every arrived ant deposits, as in Ant System (eq. 12)",
        without: &[("update", "all-ants")],
    },
    Component {
        id: "shifting-weights",
        name: "shifting weights",
        adds: "the weights of these paths shift with the iterations (eq. 10–11); without: their means all the time",
        without: &[("shifting_weights", "false")],
    },
    Component {
        id: "weakened-worst",
        name: "weakened worst path",
        adds: "the iteration's worst path loses trail (eq. 8, 9 and 11); without: it loses none",
        without: &[("weaken_worst", "false")],
    },
    Component {
        id: "refinement",
        name: "refinement",
        adds: "the best path is straightened by line of sight at the end (section 3.3); without: it stays cell by cell",
        without: &[("refinement", "none")],
    },
];

/// The engine-room planner in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "ship",
    name: "Engine-room ACO",
    family: Family::AntColony,
    summary: "Ants see goal, direction and obstacles around a cell; best paths gain pheromone and the worst loses some; the best path is refined by line of sight (Fan et al. 2026).",
    source: "Fan, Zhang, Liu, Zhu 2026, J. Dalian Maritime Univ. 52(1), 87–98, doi:10.16411/j.cnki.issn1006-7736.2026.01.009",
    presets: PRESETS,
    components: COMPONENTS,
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::Density],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: ShipParams::specs,
    build,
};
