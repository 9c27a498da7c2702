//! IHMACO: Liu, Wu, Xiao, Li, Xu, Guo, Li, "An improved heuristic mechanism ant colony optimization algorithm for solving path planning",
//! Knowledge-Based Systems 271 (2023) 110540, doi:10.1016/j.knosys.2023.110540.
//!
//! Of the publication its abstract was at hand. Rules and numbers are those of a reproduction, aGVsbG93b3JsZA/robot-path-simulation,
//! `rps/aco/ihmaco.py`, not checked against it. That file names another publication (doi:10.1016/j.knosys.2024.111459); its class bears the
//! name of this one, whose abstract lists what it does: a start trail by distances, a judgement of directions, a pseudo-random rule and an
//! evaporation rate that change with time.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | a·(d_ST/(d_Si + d_iT) + d_ST/(d_Sj + d_jT))·τ0, a = 1 where the step leads nearer to the goal, else 0.5 (`uneven_trail`) |
//! | heuristic | 1 / d_jT |
//! | selection | as Ant Colony System of τ^α·η^β·ω·T: ω = (5 − δ)/15, δ eighths of a circle between the step and the way from start to goal (`judgement`); T doubles where the step is straight on (`straight_gain`); q0(k) = 0.1 + 2·(k − 0.45·K)²/K² (`dipping_q0`) |
//! | on each move | nothing |
//! | update | as Ant System with ρ·(1 + 0.2·k/K), and Q over w1·L + w2·turns |
//! | daemon actions | none |
//!
//! Left out: within one iteration the reproduction cuts q0 to a tenth for each ant after more than half of the ants have not bettered the
//! iteration's path. That makes ants depend on those before them; here they walk side by side.
//!
//! The reproduction takes the path of fewer turns among those whose lengths differ by less than 0.1; we the shorter one. An ant without a
//! step left is lost; there its way is cleared and it walks on. Distances in η are at least `goal_distance`. On weighted ground, which is
//! ours, η is taken per factor of the step, and L is the cost.

use std::sync::Arc;

use crate::aco::colony::Colony;
use crate::aco::dead_end::DeadEnd;
use crate::aco::deposit;
use crate::aco::heuristic::{self, AT_GOAL};
use crate::aco::maaco::uneven;
use crate::aco::odds;
use crate::aco::orientation::{eighths, signs};
use crate::aco::selection;
use crate::aco::shared_params::{SelectionParams, WalkParams, settings};
use crate::aco::trails::{Row, Trails};
use crate::aco::variant::{Abreast, Iteration, Settings, Standing, Variant};
use crate::error::ParamError;
use crate::map::{Cell, DIRECTIONS, Direction, OFFSETS, Point};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Component, Family, Ground, Layer, Planner, PlannerEntry};
use crate::rng::Stream;
use crate::scenario::Scenario;

params! {
    /// Parameters of IHMACO.
    pub struct IhmacoParams {
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "reproduction of IHMACO";
        ..selection: SelectionParams { beta = 7.0, "reproduction of IHMACO"; };
        /// evaporation rate: the part of every trail that leaves in the first iterations
        rho: f64 = 0.2, "ρ", [0.0..=1.0], "", "reproduction of IHMACO";
        /// by how much of itself the evaporation rate has grown at the end
        rho_growth: f64 = 0.2, "", [0.0..=10.0], "", "reproduction of IHMACO";
        /// whether trails begin the stronger, the nearer a step is to the straight line from start to goal
        uneven_trail: bool = true, "", [], "", "reproduction of IHMACO";
        /// unit of the trail before the first iteration
        initial_trail: f64 = 1.0, "τ0", [1e-6..=1e6], "", "reproduction of IHMACO";
        /// whether a step is judged by its direction beside that from start to goal
        judgement: bool = true, "ω", [], "", "reproduction of IHMACO";
        /// how many times as much a step straight on weighs
        straight_gain: f64 = 2.0, "T", [1.0..=100.0], "", "reproduction of IHMACO";
        /// whether the probability of the best step dips and grows again; else it is its mean over the run
        dipping_q0: bool = true, "", [], "", "reproduction of IHMACO";
        /// every arrived ant leaves Q / (w1·length + w2·turns) on each step
        deposit: f64 = 2.5, "Q", [0.0..=1e6], "cells", "reproduction of IHMACO";
        /// weight of the length in what a deposit is divided by
        length_share: f64 = 0.5, "w1", [0.01..=100.0], "", "reproduction of IHMACO";
        /// weight of each turn in what a deposit is divided by
        turn_share: f64 = 1.0, "w2", [0.0..=100.0], "cells", "reproduction of IHMACO";
        /// distance that stands for a shorter one in η
        goal_distance: f64 = AT_GOAL, "ε", [1e-3..=1.0], "cells", "reproduction of IHMACO";
        ..walk: WalkParams { dead_end = DeadEnd::Die, "our choice; the reproduction lets it walk on with its way cleared"; };
    }
}

/// The part of τ0 on a step from `i` to `j` before the first iteration, in 0 to 2.
pub fn start_trail(start: Point, i: Point, j: Point, goal: Point) -> f64 {
    let nearer = if i.distance(goal) > j.distance(goal) { 1.0 } else { 0.5 };
    nearer * (uneven(start, i, goal) + uneven(start, j, goal))
}

/// ω of a step in direction `d`: 5/15 along the way from start to goal, 1/15 against it.
pub fn judgement(d: Direction, start: Point, goal: Point) -> f64 {
    (5.0 - f64::from(eighths(OFFSETS[d as usize % DIRECTIONS], signs(start, goal)))) / 15.0
}

/// q0 in iteration `k` (from 1) of `budget`, in 0.1 to 0.705; without the dip its mean over the run.
pub fn greed(p: &IhmacoParams, k: u32, budget: u32) -> f64 {
    if !p.dipping_q0 {
        return 0.1 + 2.0 * (0.55 * 0.55 * 0.55 + 0.45 * 0.45 * 0.45) / 3.0;
    }
    let off = f64::from(k) / f64::from(budget) - 0.45;
    0.1 + 2.0 * off * off
}

/// What the deposit of a path of this length and so many turns is divided by, in cells.
pub fn fitness(p: &IhmacoParams, length: f64, turns: u32) -> f64 {
    p.length_share * length + p.turn_share * f64::from(turns)
}

/// How often a way changes its direction.
fn turns(steps: &[Direction]) -> u32 {
    steps.windows(2).map(|pair| u32::from(pair[0] != pair[1])).sum()
}

/// IHMACO.
#[derive(Debug, Clone, Copy)]
pub struct Ihmaco {
    params: IhmacoParams,
    /// S once the colony is at work: where a robot drives on, its judgements stay those of one run.
    start: Option<Point>,
    q0: f64,
}

impl Ihmaco {
    /// With these parameters.
    pub fn new(params: IhmacoParams) -> Self {
        Self { params, start: None, q0: 0.0 }
    }

    fn start(&self, scenario: &Scenario) -> Point {
        self.start.unwrap_or_else(|| scenario.grid.point(scenario.start))
    }
}

impl Variant for Ihmaco {
    const HEEDS: bool = true;

    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.rho, p.deposit, &p.selection, &p.walk)
    }

    fn initial_trail(&self, _: &Scenario) -> f64 {
        self.params.initial_trail
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        let (to, goal) = (scenario.grid.point(j), scenario.grid.point(scenario.goal));
        heuristic::per_factor(scenario, i, d, j, heuristic::goal_distance(to, goal, self.params.goal_distance))
    }

    fn prepare(&mut self, scenario: &Scenario) {
        self.start = Some(self.start(scenario));
    }

    fn shape_trails(&self, scenario: &Scenario, trails: &mut Trails) {
        if !self.params.uneven_trail {
            return;
        }
        let (start, goal) = (self.start(scenario), scenario.grid.point(scenario.goal));
        for i in 0..scenario.grid.len() as Cell {
            for d in scenario.moves.directions(i) {
                let (from, to) = (scenario.grid.point(i), scenario.grid.point(scenario.moves.step(i, d)));
                trails.blend(i, d, 1.0, self.params.initial_trail * start_trail(start, from, to, goal));
            }
        }
    }

    fn begin_iteration(&mut self, number: u32) {
        self.q0 = greed(&self.params, number, self.params.selection.iterations);
    }

    #[inline(always)]
    fn heed(&self, scenario: &Scenario, weights: &mut Row, ant: Standing) {
        let (p, start, goal) = (&self.params, self.start(scenario), scenario.grid.point(scenario.goal));
        for (d, weight) in (0..).zip(weights.iter_mut()).filter(|(_, weight)| **weight > 0.0) {
            let judged = if p.judgement { judgement(d, start, goal) } else { 1.0 };
            let gain = if ant.last.is_none_or(|last| last == d) { p.straight_gain } else { 1.0 };
            *weight = (f64::from(*weight) * judged * gain) as f32;
        }
    }

    fn abreast(&self) -> Abreast {
        Abreast::Never
    }

    #[inline(always)]
    fn choose(&self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        selection::pseudo_random_proportional(weights, self.q0, stream)
    }

    fn odds(&self, weights: &Row) -> Vec<f64> {
        odds::pseudo_random_proportional(weights, self.q0)
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        let p = &self.params;
        let passed = f64::from(iteration.number) / f64::from(iteration.budget);
        trails.evaporate((p.rho * (1.0 + p.rho_growth * passed)).min(1.0));
        for (ant, length) in iteration.arrived() {
            deposit::along(trails, iteration.scenario, ant, p.deposit / fitness(p, length, turns(ant.steps())));
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = Ihmaco::new(IhmacoParams::read(ENTRY.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ENTRY.id, seed, 0)))
}

/// What the paper adds, as the reproduction has it.
const COMPONENTS: &[Component] = &[
    Component {
        id: "start-trail-by-step",
        name: "start trail by steps",
        adds: "trails begin the stronger, the nearer a step is to the straight line and to the goal; without: they begin alike",
        without: &[("uneven_trail", "false")],
    },
    Component {
        id: "direction-judgement",
        name: "judgement of directions",
        adds: "a step weighs the less, the more it turns from the way from start to goal; without: ω is the same for all",
        without: &[("judgement", "false")],
    },
    Component {
        id: "straight-on",
        name: "straight on",
        adds: "a step straight on weighs twice as much; without: as much as any",
        without: &[("straight_gain", "1")],
    },
    Component {
        id: "dipping-greed",
        name: "q0 that dips",
        adds: "the probability of the best step falls at first and then grows; without: its mean all the time",
        without: &[("dipping_q0", "false")],
    },
    Component {
        id: "growing-rho",
        name: "growing evaporation",
        adds: "the evaporation rate grows by a fifth over the run; without: it stays",
        without: &[("rho_growth", "0")],
    },
    Component {
        id: "turns-in-deposit",
        name: "turns in the deposit",
        adds: "a path with more turns gains less; without: its length alone counts",
        without: &[("turn_share", "0")],
    },
];

/// IHMACO in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "ihmaco",
    name: "Improved heuristic ACO",
    family: Family::AntColony,
    summary: "Steps straight on and along the way from start to goal weigh more, and paths with few turns leave more pheromone.",
    source: "Liu, Wu, Xiao et al. 2023, Knowl.-Based Syst. 271, 110540, doi:10.1016/j.knosys.2023.110540, after a reproduction",
    presets: &[],
    components: COMPONENTS,
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::InitialTrail],
    max_goals: 1,
    grounds: Ground::WEIGHTED_PLANE,
    specs: IhmacoParams::specs,
    build,
};
