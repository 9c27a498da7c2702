//! Fireworks and ants: 周森鹏, 穆平安, 张仁杰 (Zhou Senpeng, Mu Ping'an, Zhang Renjie), 基于烟花混合蚁群的移动机器人路径规划研究 (Path planning of
//! mobile robot based on hybrid FWA and ACO), Packaging Engineering (包装工程), June 2019, in Chinese with an English abstract. The copy that we
//! read gives no DOI.
//!
//! The improved fireworks search roughly; then a colony starts from trails that are stronger along the path they found.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | Eq. 10: τ0 + Δτ along the seeder's best path, [`Variant::shape_trails`] |
//! | heuristic | 1 / (distance to the goal), "as in the traditional algorithm" |
//! | selection | "as in the traditional algorithm": as Ant System |
//! | on each move | nothing |
//! | dead end | the ant steps back (step 2) |
//! | update | Eq. 11 and 12: as Ant System, or by the best path alone (`depositors`) |
//! | daemon actions | Eq. 10 where ants come first, [`Variant::daemon_actions`] |
//!
//! | equation | where |
//! |---|---|
//! | 1 | `swarm/decode.rs` |
//! | 2–9 | `swarm/explosion.rs`, put to work in `swarm/fireworks.rs` |
//! | 10–12 | here |
//!
//! `pso-aco` has a particle swarm in place of the fireworks: the hybrid that the paper says it compares with, without a formula or a number
//! (`swarm/particle_swarm.rs`).
//!
//! Where the print contradicts itself: Eq. 11 multiplies by ρ, the residual coefficient (残留系数), while section 2 calls the same 0.9 the
//! evaporation factor (挥发因子). `rho` is what leaves: 0.1 by the equation; preset `evaporating` has 0.9.
//!
//! Where it allows more than one reading, each is a row:
//!
//! - **Who leaves trail** (`depositors`). Eq. 12 sums over all m ants (*all-ants*). Step 3 updates "by the best path that the ants computed"
//!   (根据蚂蚁计算出的最佳路径): Q/L on it once, and on no other. The best of the iteration (*iteration-best*), or, as the step before takes
//!   "the global minimum as the best value" (求取全局最小值作为最优值), of all iterations so far (*best-so-far*); of ants, not of fireworks.
//! - **τ of Eq. 10** (`ants_first`). The words above it have the ants come first (首先利用蚁群算法得到环境的初始信息素分布); by step 1
//!   Δτ is added to the colony's first matrix (初始信息素矩阵), and only then ants stand ready. 0 is step 1; otherwise this share of
//!   the colony's iterations, rounded, runs without Δτ, and then it is added to their trails. The fireworks do not see the ants, so it does not matter whose turn comes
//!   first; budgets count the same.
//! - **x_min of Eq. 6** (`range_min`), **L at the goal** (`decode_goal`): `swarm/decode.rs`.
//!
//! Preset `second-reading` takes the best path of the iteration, and an x_min above 0. The paper gives x_min no value: 0.8 is one choice of
//! ours, and the card shows what others change.
//!
//! Each of its additions can be taken out alone, but for the rough search itself: without it there is no Δτ, and with it and without Δτ
//! (`seed_ants` = 0) the budget is the same, which is what is compared.
//!
//! Where the paper is silent: how much Δτ of Eq. 10 is. We take what `seed_ants` ants leave on the path by Eq. 12, n·Q/L, by default as many
//! as the colony has. τ0 is 1. Trails are directed. The colony's iterations are numbered after those of the seeder, and the best path is the
//! best of both, so that budgets and histories count everything that was spent. The first stage draws the numbers of `ifwa`: it is that
//! planner's run with the same seed.

use std::sync::Arc;

use crate::aco::dead_end::DeadEnd;
use crate::aco::deposit;
use crate::aco::heuristic::Heuristic;
use crate::aco::hybrid::Hybrid;
use crate::aco::shared_params::{SelectionParams, SightParams, WalkParams, settings};
use crate::aco::trails::Trails;
use crate::aco::variant::{Iteration, Settings, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction};
use crate::params;
use crate::params::{Params, Values};
use crate::path::Path;
use crate::planner::{Component, Family, Ground, Layer, PaperReading, Planner, PlannerEntry, Preset};
use crate::scenario::Scenario;
use crate::swarm::decode::DecodeRows;
use crate::swarm::fireworks::{self, AnnealingRows, COOLED_RADIUS, FireworkRows, WEIGHTED_MUTATION};
use crate::swarm::particle_swarm::ParticleRows;
use crate::swarm::pso;

crate::param_choice! {
    /// Which ants leave trail at the end of an iteration.
    pub enum Depositors {
        /// eq. 12: every arrived ant, as in Ant System
        AllAnts = "all-ants",
        /// step 3: the ant with the iteration's shortest path alone
        IterationBest = "iteration-best",
        /// steps 2 and 3: the shortest path of all iterations so far alone
        BestSoFar = "best-so-far",
    }
}

params! {
    /// The ant colony that comes second.
    pub struct ColonyRows {
        /// ants that build a path in each iteration of the second stage
        ants: u32 = 50, "m", [1..=1024], "ants", "Zhou, Mu, Zhang 2019, section 2.2";
        ..selection: SelectionParams {
            iterations = 50, "Zhou, Mu, Zhang 2019, section 2.2: of the second stage";
            alpha = 2.0, "Zhou, Mu, Zhang 2019, section 2.2";
            beta = 8.0, "Zhou, Mu, Zhang 2019, section 2.2";
        };
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.1, "ρ", [0.0..=1.0], "", "Zhou, Mu, Zhang 2019, section 2.2: 0.9, by eq. 11 what stays";
        /// an arrived ant leaves Q / length on each of its steps
        deposit: f64 = 1.0, "Q", [1e-6..=1e6], "cells", "Zhou, Mu, Zhang 2019, section 2.2";
        /// the first stage's path gets what this many ants would leave on it
        seed_ants: f64 = 50.0, "", [0.0..=1e6], "ants", "our choice: eq. 10 does not say how much; as many as the colony has";
        /// which ants leave trail at the end of an iteration
        depositors: Depositors = Depositors::AllAnts, "", [], "", "Zhou, Mu, Zhang 2019, eq. 12; its step 3: by the best path";
        /// share of the colony's iterations before the first stage's path is added to its trails
        ants_first: f64 = 0.0, "", [0.0..=0.9], "× iterations", "Zhou, Mu, Zhang 2019, step 1; above eq. 10: after ants";
        /// trail on every step before the seed
        initial_trail: f64 = 1.0, "τ0", [1e-6..=1e6], "", "our choice: not given";
        ..sight: SightParams { heuristic = Heuristic::Goal, "our reading: as in the traditional algorithm"; };
        ..walk: WalkParams { dead_end = DeadEnd::Backtrack, "Zhou, Mu, Zhang 2019, section 1.3.2, step 2"; };
    }
}

params! {
    /// Parameters of the hybrid of fireworks and ants.
    pub struct FwaAcoParams {
        /// iterations of the fireworks, the first stage
        seed_iterations: u32 = 50, "G_max", [1..=100_000], "iterations", "Zhou, Mu, Zhang 2019, section 2.1";
        ..colony: ColonyRows;
        ..fireworks: FireworkRows;
        ..annealing: AnnealingRows;
        ..decoding: DecodeRows;
    }
}

params! {
    /// Parameters of the hybrid of particles and ants.
    pub struct PsoAcoParams {
        /// iterations of the particle swarm, the first stage
        seed_iterations: u32 = 50, "", [1..=100_000], "iterations", "our choice: as many as the fireworks have";
        ..colony: ColonyRows;
        ..particles: ParticleRows;
        ..decoding: DecodeRows;
    }
}

/// The colony of the second stage.
#[derive(Debug, Clone)]
pub struct Seeded {
    rows: ColonyRows,
    /// The seeder's best path and its length in cells, if it found one.
    seed: Option<(Path, f64)>,
}

impl Seeded {
    /// With these parameters and this seed path of allowed steps.
    pub fn new(rows: ColonyRows, seed: Option<(Path, f64)>) -> Self {
        Self { rows, seed }
    }

    /// The second stage of `fwa-aco`, not seeded yet.
    pub fn by_fireworks(params: FwaAcoParams) -> Self {
        Self::new(params.colony, None)
    }

    /// The second stage of `pso-aco`, not seeded yet.
    pub fn by_particles(params: PsoAcoParams) -> Self {
        Self::new(params.colony, None)
    }

    /// Eq. 10: τ^s = τ + Δτ.
    fn add_seed(&self, scenario: &Scenario, trails: &mut Trails) {
        if let Some((path, length)) = &self.seed {
            deposit::along_path(trails, scenario, path, seed_trail(&self.rows, *length));
        }
    }
}

/// Eq. 10: Δτ on each step of a path of this length, what `seed_ants` ants leave there by Eq. 12.
pub fn seed_trail(rows: &ColonyRows, length: f64) -> f64 {
    rows.seed_ants * rows.deposit / length
}

/// How many of the colony's iterations come before Eq. 10; at least one comes after it.
pub fn prior_iterations(rows: &ColonyRows) -> u32 {
    let all = rows.selection.iterations;
    (libm::round(rows.ants_first * f64::from(all)) as u32).min(all - 1)
}

impl Variant for Seeded {
    fn settings(&self) -> Settings {
        let r = &self.rows;
        settings(r.ants, r.rho, r.deposit, &r.selection, &r.walk)
    }

    fn initial_trail(&self, _: &Scenario) -> f64 {
        self.rows.initial_trail
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        self.rows.sight.heuristic.of(scenario, i, d, j)
    }

    fn take_seed(&mut self, found: Option<&(Path, f64)>) {
        self.seed = found.cloned();
    }

    fn shape_trails(&self, scenario: &Scenario, trails: &mut Trails) {
        if prior_iterations(&self.rows) == 0 {
            self.add_seed(scenario, trails);
        }
    }

    /// Eq. 11 and 12.
    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        let (rows, scenario) = (&self.rows, iteration.scenario);
        trails.evaporate(rows.rho);
        match rows.depositors {
            Depositors::AllAnts => deposit::ant_cycle(trails, scenario, iteration.ants, rows.deposit),
            Depositors::IterationBest => {
                if let Some((ant, length)) = iteration.iteration_best() {
                    deposit::along(trails, scenario, ant, rows.deposit / length);
                }
            }
            Depositors::BestSoFar => {
                if let Some(best) = iteration.best_so_far {
                    deposit::along_path(trails, scenario, &best.path, rows.deposit / best.length);
                }
            }
        }
    }

    fn daemon_actions(&mut self, trails: &mut Trails, iteration: Iteration) {
        if iteration.number == prior_iterations(&self.rows) {
            self.add_seed(iteration.scenario, trails);
        }
    }
}

/// The first stage of `fwa-aco`: a run of `ifwa`.
///
/// # Errors
/// [`ParamError::Memory`] where the positions would not fit.
pub fn fireworks_first(scenario: &Arc<Scenario>, p: &FwaAcoParams, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let rows = (p.fireworks, p.annealing, p.decoding);
    Ok(Box::new(fireworks::improved(scenario, rows, p.seed_iterations, 0, seed)?))
}

/// The first stage of `pso-aco`: a run of `pso`.
///
/// # Errors
/// [`ParamError::Memory`] where the positions would not fit.
pub fn particles_first(scenario: &Arc<Scenario>, p: &PsoAcoParams, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let swarm = pso::over_cells(scenario, (p.particles, p.decoding), p.seed_iterations, 0, seed)?;
    Ok(Box::new(swarm))
}

/// The first stage, and then the colony.
fn hybrid(
    scenario: &Arc<Scenario>,
    first: Box<dyn Planner>,
    second: Seeded,
    planner: &'static str,
    seed: u32,
) -> Box<dyn Planner> {
    Box::new(Hybrid::new(Arc::clone(scenario), first, second, (planner, LAYERS), seed))
}

fn build_fwa_aco(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let p = FwaAcoParams::read(FWA_ACO.id, values)?;
    Ok(hybrid(scenario, fireworks_first(scenario, &p, seed)?, Seeded::by_fireworks(p), FWA_ACO.id, seed))
}

fn build_pso_aco(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let p = PsoAcoParams::read(PSO_ACO.id, values)?;
    Ok(hybrid(scenario, particles_first(scenario, &p, seed)?, Seeded::by_particles(p), PSO_ACO.id, seed))
}

const LAYERS: &[Layer] = &[Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::InitialTrail, Layer::SeedPath, Layer::Priority];

const EVAPORATING: Preset = Preset {
    name: "evaporating",
    source: "Zhou, Mu, Zhang 2019, section 2.2",
    meaning: "0.9 is what leaves, as its section 2.2 calls it, against its eq. 11",
    numbers: &[("rho", 0.9)],
    choices: &[],
    reading: None,
};

const SECOND_READING: Preset = Preset {
    name: "second-reading",
    source: "Zhou, Mu, Zhang 2019, eq. 6 and step 3",
    meaning: "an x_min above 0 (eq. 6; the paper gives no value, 0.8 is ours), and the iteration's best path alone leaves trail (step 3)",
    numbers: &[("range_min", 0.8)],
    choices: &[("depositors", "iteration-best")],
    reading: Some(PaperReading::SecondReading),
};

const SEED_TRAIL: Component = Component {
    id: "seed-trail",
    name: "trail of the first stage",
    adds: "the first stage's best path gets a head start of trail (eq. 10); without: the same first stage, and τ0 everywhere",
    without: &[("seed_ants", "0")],
};

const STEPPING_BACK: Component = Component {
    id: "stepping-back",
    name: "stepping back",
    adds: "ants at a dead end step back (section 1.3.2, step 2); without: they die",
    without: &[("dead_end", "die")],
};

/// The hybrid of fireworks and ants in the catalog.
pub const FWA_ACO: PlannerEntry = PlannerEntry {
    id: "fwa-aco",
    name: "Fireworks, then ants",
    family: Family::AntColony,
    summary: "Improved fireworks search first; their best path gets a head start of pheromone, and ants go on from there.",
    source: "Zhou, Mu, Zhang 2019 (基于烟花混合蚁群的移动机器人路径规划研究)",
    presets: &[
        EVAPORATING,
        Preset {
            name: "unseeded",
            source: "ours: what the seed is worth",
            meaning: "the same budget and the same colony, but the path of the fireworks leaves no trail",
            numbers: &[("seed_ants", 0.0)],
            choices: &[],
            reading: None,
        },
        fireworks::PRINTED,
        SECOND_READING,
    ],
    components: &[SEED_TRAIL, COOLED_RADIUS, WEIGHTED_MUTATION, STEPPING_BACK],
    layers: LAYERS,
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: FwaAcoParams::specs,
    build: build_fwa_aco,
};

/// The hybrid of particles and ants in the catalog.
pub const PSO_ACO: PlannerEntry = PlannerEntry {
    id: "pso-aco",
    name: "Particles, then ants",
    family: Family::AntColony,
    summary: "A particle swarm over cell priorities searches first; its best path gets a head start of pheromone, and ants go on from there.",
    source: "named in Zhou, Mu, Zhang 2019 as what it compares with; particle swarm as Shi and Eberhart 1999",
    presets: &[EVAPORATING, SECOND_READING],
    components: &[SEED_TRAIL],
    layers: LAYERS,
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: PsoAcoParams::specs,
    build: build_pso_aco,
};
