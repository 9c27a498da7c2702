//! MAACO: Wu, Huang, Cui et al., "Modified adaptive ant colony optimization algorithm and its application for solving path planning of mobile
//! robot", Expert Systems with Applications 215 (2023) 119410, doi:10.1016/j.eswa.2022.119410.
//!
//! The publication itself was not at hand: rules and numbers are those of two reproductions, not checked against it. **A** is
//! aGVsbG93b3JsZA/robot-path-simulation, `rps/aco/maaco.py`; **B** is dvnam1605/MAACO-path-planing, `MAACO.py`. The defaults are A, the preset
//! `second-reading` is B where B differs.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | A, B: τ0·d_ST / (d_Si + d_iT), of the cell that is left (A) or entered (B) (`initial`) |
//! | heuristic | B, and A but for d_Sj: 1 / (g·d_Sj + h·d_jT + a·c), h from `weight_max` far from the goal down to `weight_min` at it, g = 1 − h, c = 1 where the step turns |
//! | which steps | A: of those left the three nearest to the direction of the goal; B: none against the direction from start to goal (`orientation`) |
//! | selection | A, B: as Ant Colony System, with a q0 that falls and then grows with time (`late_greed`) |
//! | on each move | nothing |
//! | update | A, B: as Ant System; then limits (`trail_limits`) |
//! | daemon actions | none |
//!
//! Distances are Euclidean, at least `goal_distance`, as in A. Where the reproductions differ, contradict themselves or are silent:
//!
//! - **d_Sj** is the straight distance from the start, as the same symbol in the initial trail of both; so is B. A takes the way walked so
//!   far and the step, an earlier version of A the step alone (`start_distance`).
//! - **exp in h.** A prints exp(−k·d_jT)/d_ST, which is all but 0 off the goal; B and an earlier version of A exp(−k·d_jT/d_ST), as here.
//! - **k** "is not given in the original paper" (A): 1 there, 0.9 in B.
//! - **Best path.** A takes the path of fewer turns among those whose lengths differ by less than 0.1; we the shorter one, as B.
//! - **Dead end.** An ant that has no step left is lost, as in B; A clears its way and lets it walk on, so that its trail begins there.
//! - **B's trails are on cells**, ours on steps; B counts no step past a corner, which is the scenario's affair.
//! - **Weighted ground** is ours: η is taken per factor of the step.

use std::sync::Arc;

use crate::aco::colony::Colony;
use crate::aco::dead_end::DeadEnd;
use crate::aco::deposit;
use crate::aco::heuristic::{self, AT_GOAL};
use crate::aco::odds;
use crate::aco::orientation::{nearest_three, onward};
use crate::aco::selection;
use crate::aco::shared_params::{SelectionParams, WalkParams, settings};
use crate::aco::trails::{Row, Trails};
use crate::aco::variant::{Abreast, Iteration, Settings, Standing, Variant};
use crate::aco::weights::power;
use crate::error::ParamError;
use crate::map::{Cell, Direction, Point};
use crate::params::{Params, Values};
use crate::planner::{Component, Family, Ground, Layer, PaperReading, Planner, PlannerEntry, Preset};
use crate::rng::Stream;
use crate::scenario::Scenario;
use crate::{param_choice, params};

param_choice! {
    /// The trails before the first iteration of MAACO.
    pub enum InitialTrail {
        /// τ0·d_ST / (d_Si + d_iT) of the cell i that a step leaves
        Left = "cell-left",
        /// the same of the cell that a step enters
        Entered = "cell-entered",
        /// τ0 everywhere
        Uniform = "uniform",
    }
}

param_choice! {
    /// What d_Sj of η is in MAACO: how far the start is from the cell that a step enters.
    pub enum StartDistance {
        /// the straight distance
        Straight = "straight-line",
        /// the way walked so far and the step
        Walked = "walked",
        /// the step alone
        Step = "step-length",
    }
}

param_choice! {
    /// Which of the steps that are left an ant of MAACO considers.
    pub enum Orientation {
        /// the three whose directions are nearest to that of the goal; of equal ones the first in the order of directions
        NearestThree = "nearest-three",
        /// those that do not lead against the direction from start to goal; if there is none, not against that from the ant to the goal; if there is none, all
        StartToGoal = "start-to-goal",
        /// all of them
        Any = "any",
    }
}

param_choice! {
    /// How q0 of MAACO goes in the last 30 % of the iterations.
    pub enum LateGreed {
        /// from q0/2 up by k/K
        Jumps = "jumps",
        /// from where it has fallen to, up to the mean of that and q0
        Grows = "grows",
        /// it stays at q0 all the time
        Never = "constant",
    }
}

param_choice! {
    /// Between which limits MAACO keeps trails.
    pub enum Limits {
        /// 200·(1/(2·(1 − ρ)) + 1) / L_bs and a 500th of that
        Elite = "elite",
        /// 1 / ((1 − ρ)·L_bs), and that over twice the longer side of the map
        MaxMin = "max-min",
        /// none
        None = "unlimited",
    }
}

params! {
    /// Parameters of MAACO.
    pub struct MaacoParams {
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "reproductions A and B of MAACO";
        ..selection: SelectionParams { beta = 7.0, "reproductions A and B of MAACO"; };
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.2, "ρ", [0.0..=0.99], "", "reproduction A of MAACO; B: 0.1";
        /// every arrived ant leaves Q / its length on each step
        deposit: f64 = 2.5, "Q", [0.0..=1e6], "cells", "reproductions A and B of MAACO";
        /// the trails before the first iteration
        initial: InitialTrail = InitialTrail::Left, "", [], "", "reproduction A of MAACO; B: of the cell entered";
        /// largest trail before the first iteration
        initial_trail: f64 = 1.0, "τ0", [1e-6..=1e6], "", "reproduction A of MAACO; B: 0.1";
        /// which of the steps that are left an ant considers
        orientation: Orientation = Orientation::NearestThree, "", [], "", "reproduction A of MAACO; B: start to goal";
        /// weight of the goal's distance in η far from the goal
        weight_max: f64 = 0.9, "w_max", [0.0..=1.0], "", "reproductions A and B of MAACO";
        /// weight of the goal's distance in η at the goal
        weight_min: f64 = 0.2, "w_min", [0.0..=1.0], "", "reproductions A and B of MAACO";
        /// how fast the weight falls on the way to the goal
        weight_decay: f64 = 1.0, "k", [0.0..=100.0], "", "reproduction A of MAACO, where the paper gives none; B: 0.9";
        /// how far the start is from a cell, in η
        start_distance: StartDistance = StartDistance::Straight, "d_Sj", [], "", "reproduction B of MAACO; A: walked, earlier the step";
        /// what a turn adds to the distances in η
        turn_cost: f64 = 1.0, "a", [0.0..=1e3], "cells", "reproductions A and B of MAACO";
        /// probability of the best step at the beginning
        q0: f64 = 0.5, "q0", [0.0..=1.0], "", "reproductions A and B of MAACO";
        /// how that probability goes at the end
        late_greed: LateGreed = LateGreed::Jumps, "", [], "", "reproduction A of MAACO; B: grows";
        /// between which limits trails are kept
        trail_limits: Limits = Limits::Elite, "", [], "", "reproduction A of MAACO; B: max-min";
        /// distance that stands for a shorter one in η
        goal_distance: f64 = AT_GOAL, "ε", [1e-3..=1.0], "cells", "reproduction A of MAACO";
        ..walk: WalkParams { dead_end = DeadEnd::Die, "reproduction B of MAACO"; };
    }
}

/// Weight h of the goal's distance in η where that distance is `to_goal`: w_max − (w_max − w_min)·exp(−k·d_jT/d_ST), in 0 to 1.
pub fn goal_weight(p: &MaacoParams, to_goal: f64, whole: f64) -> f64 {
    p.weight_max - (p.weight_max - p.weight_min) * libm::exp(-p.weight_decay * to_goal / whole)
}

/// g·d_Sj + h·d_jT in cells, what η of a straight step is one over; `from_start` is d_Sj, and points are cells.
pub fn seen_distance(p: &MaacoParams, start: Point, from_start: f64, j: Point, goal: Point) -> f64 {
    let between = |a: Point, b: Point| a.distance(b).max(p.goal_distance);
    let to_goal = between(j, goal);
    let h = goal_weight(p, to_goal, between(start, goal));
    (1.0 - h) * from_start.max(p.goal_distance) + h * to_goal
}

/// τ0·d_ST / (d_Si + d_iT) as a part of τ0, in 0 to 1.
pub fn uneven(start: Point, i: Point, goal: Point) -> f64 {
    let whole = start.distance(goal);
    if whole > 0.0 { whole / (start.distance(i) + i.distance(goal)) } else { 1.0 }
}

/// q0 in iteration `k` (from 1) of `budget`: it falls by (K − k)/K up to 0.7·K, then grows.
pub fn greed(p: &MaacoParams, k: u32, budget: u32) -> f64 {
    let (k, all) = (f64::from(k), f64::from(budget));
    let turn = 0.7 * all;
    match p.late_greed {
        LateGreed::Never => p.q0,
        _ if k < turn => (all - k) / all * p.q0,
        LateGreed::Jumps => (k - turn) / all * p.q0 + p.q0 / 2.0,
        LateGreed::Grows => {
            let fallen = (all - turn) / all;
            (fallen + (k - turn) / (all - turn) * (1.0 - fallen) / 2.0) * p.q0
        }
    }
}

/// Smallest and largest trail where the best path so far has this length, on a map whose longer side is `side`; none where none is kept.
pub fn limits(p: &MaacoParams, length: f64, side: u32) -> Option<(f64, f64)> {
    match p.trail_limits {
        Limits::Elite => {
            let max = 200.0 * (1.0 / (2.0 * (1.0 - p.rho)) + 1.0) / length;
            Some((max / 500.0, max))
        }
        Limits::MaxMin => {
            let max = 1.0 / ((1.0 - p.rho) * length);
            Some((max / (2.0 * f64::from(side)), max))
        }
        Limits::None => None,
    }
}

/// MAACO.
#[derive(Debug, Clone, Copy)]
pub struct Maaco {
    params: MaacoParams,
    /// S once the colony is at work: where a robot drives on, η and its trails stay those of one run.
    start: Option<Point>,
    q0: f64,
}

impl Maaco {
    /// With these parameters.
    pub fn new(params: MaacoParams) -> Self {
        Self { params, start: None, q0: params.q0 }
    }

    fn start(&self, scenario: &Scenario) -> Point {
        self.start.unwrap_or_else(|| scenario.grid.point(scenario.start))
    }

    /// g·d_Sj + h·d_jT for the step from `i` to `j`, without what an ant has walked before.
    fn distance(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        let start = self.start(scenario);
        let from_start = match self.params.start_distance {
            StartDistance::Straight => start.distance(scenario.grid.point(j)),
            StartDistance::Walked | StartDistance::Step => scenario.moves.length(i, d),
        };
        seen_distance(&self.params, start, from_start, scenario.grid.point(j), scenario.grid.point(scenario.goal))
    }

    /// Has a step weigh (D / (D + a·c + g·L))^β as much, D its distance without the turn c and without the way L that the ant has walked,
    /// where that counts.
    fn see_longer(&self, scenario: &Scenario, weights: &mut Row, ant: Standing) {
        let p = &self.params;
        let goal = scenario.grid.point(scenario.goal);
        let whole = self.start(scenario).distance(goal).max(p.goal_distance);
        for (d, weight) in (0..).zip(weights.iter_mut()).filter(|(_, weight)| **weight > 0.0) {
            let j = scenario.moves.step(ant.at, d);
            let mut more = if ant.last.is_some_and(|last| last != d) { p.turn_cost } else { 0.0 };
            if p.start_distance == StartDistance::Walked {
                let to_goal = scenario.grid.point(j).distance(goal).max(p.goal_distance);
                more += (1.0 - goal_weight(p, to_goal, whole)) * ant.walked;
            }
            if more > 0.0 {
                let seen = self.distance(scenario, ant.at, d, j);
                let share = power(seen / (seen + more), p.selection.beta);
                *weight = (f64::from(*weight) * share).max(f64::from(f32::MIN_POSITIVE)) as f32;
            }
        }
    }
}

impl Variant for Maaco {
    const HEEDS: bool = true;

    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.rho, p.deposit, &p.selection, &p.walk)
    }

    fn initial_trail(&self, _: &Scenario) -> f64 {
        self.params.initial_trail
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        heuristic::per_factor(scenario, i, d, j, 1.0 / self.distance(scenario, i, d, j))
    }

    fn prepare(&mut self, scenario: &Scenario) {
        self.start = Some(self.start(scenario));
    }

    fn shape_trails(&self, scenario: &Scenario, trails: &mut Trails) {
        let p = &self.params;
        if p.initial == InitialTrail::Uniform {
            return;
        }
        let (start, goal) = (self.start(scenario), scenario.grid.point(scenario.goal));
        for i in 0..scenario.grid.len() as Cell {
            for d in scenario.moves.directions(i) {
                let of = if p.initial == InitialTrail::Left { i } else { scenario.moves.step(i, d) };
                trails.blend(i, d, 1.0, p.initial_trail * uneven(start, scenario.grid.point(of), goal));
            }
        }
    }

    fn begin_iteration(&mut self, number: u32) {
        self.q0 = greed(&self.params, number, self.params.selection.iterations);
    }

    #[inline(always)]
    fn heed(&self, scenario: &Scenario, weights: &mut Row, ant: Standing) {
        let (here, goal) = (scenario.grid.point(ant.at), scenario.grid.point(scenario.goal));
        match self.params.orientation {
            Orientation::NearestThree => nearest_three(weights, here, goal),
            Orientation::StartToGoal => onward(weights, here, self.start(scenario), goal),
            Orientation::Any => {}
        }
        self.see_longer(scenario, weights, ant);
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
        trails.evaporate(self.params.rho);
        deposit::ant_cycle(trails, iteration.scenario, iteration.ants, self.params.deposit);
        let side = iteration.scenario.grid.width().max(iteration.scenario.grid.height());
        let kept = iteration.best_so_far.and_then(|best| limits(&self.params, best.length, side));
        if let Some((min, max)) = kept {
            trails.limit(min, max);
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = Maaco::new(MaacoParams::read(ENTRY.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ENTRY.id, seed, 0)))
}

const PRESETS: &[Preset] = &[Preset {
    name: "second-reading",
    source: "reproduction B of MAACO",
    meaning: "the other reproduction's rules and numbers: start trails of the cell entered, steps by the way from start to goal, q0 that grows evenly, MAX–MIN limits",
    numbers: &[("rho", 0.1), ("initial_trail", 0.1), ("weight_decay", 0.9)],
    choices: &[
        ("initial", "cell-entered"),
        ("orientation", "start-to-goal"),
        ("late_greed", "grows"),
        ("trail_limits", "max-min"),
    ],
    reading: Some(PaperReading::SecondReading),
}];

/// What the paper adds, as the reproductions have it.
const COMPONENTS: &[Component] = &[
    Component {
        id: "uneven-start-trail",
        name: "uneven start trail",
        adds: "trails begin the stronger, the nearer a cell is to the straight line from start to goal; without: they begin alike",
        without: &[("initial", "uniform")],
    },
    Component {
        id: "orientation",
        name: "orientation",
        adds: "an ant considers the three steps nearest to the direction of the goal; without: all that are left",
        without: &[("orientation", "any")],
    },
    Component {
        id: "turn-cost",
        name: "turns in η",
        adds: "a step that turns is seen as a longer way; without: a = 0",
        without: &[("turn_cost", "0")],
    },
    Component {
        id: "adaptive-greed",
        name: "adaptive q0",
        adds: "the probability of the best step falls over 70 % of the iterations and then grows; without: it stays at q0",
        without: &[("late_greed", "constant")],
    },
    Component {
        id: "trail-limits",
        name: "limits of trails",
        adds: "trails stay between limits that follow the best path; without: none",
        without: &[("trail_limits", "unlimited")],
    },
];

/// MAACO in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "maaco",
    name: "Modified adaptive ACO",
    family: Family::AntColony,
    summary: "Ants look towards the goal, see turns as longer ways, and follow a trail that begins stronger around the straight line.",
    source: "Wu, Huang, Cui et al. 2023, Expert Syst. Appl. 215, 119410, doi:10.1016/j.eswa.2022.119410, after two reproductions",
    presets: PRESETS,
    components: COMPONENTS,
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::InitialTrail],
    max_goals: 1,
    grounds: Ground::WEIGHTED_PLANE,
    specs: MaacoParams::specs,
    build,
};
