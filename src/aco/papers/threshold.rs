//! ACOST and ACOMSP: Lai Zhi-Ming, Guo Gong-De, "Ant Colony Optimization Based on Self-Adaption Threshold for Path Planning"
//! (基于自适应阈值蚁群算法的路径规划算法), 2014, in Chinese with an English abstract. The copy that we read gives no DOI. ACOMSP is the method
//! that it compares with (its ref. 13: Tang, Zhang, Jiang, Zhang, Journal of Computational Information Systems 8 (2012) 10325–10332), built
//! here from the one sentence and the table row that this paper gives it.
//!
//! | override point | ACOST | ACOMSP | the paper's ACO (`acost --preset aco`) |
//! |---|---|---|---|
//! | initial trail | τ0, step 1 | as ACOST | as ACOST |
//! | heuristic | Eq. 4, Euclidean (Eq. 2) | as ACOST | as ACOST |
//! | selection | Eq. 5 and 6, step 5: [`selection::threshold`] (`rule`) | [`selection::maximal`] of Eq. 5 (`maximal`) | Eq. 5, as Ant System |
//! | on each move | Eq. 7–9: τ + Q1/l | nothing (no Q1 in table 1) | as ACOST |
//! | dead end | the ant stops (step 3, case 1) | as ACOST | as ACOST |
//! | update | Eq. 10–12: evaporate, Q2/L_min on the iteration's shortest path | as ACOST | evaporate (no Q2 in table 1) |
//! | daemon actions | none | none | none |
//!
//! Two places run in two readings (`reading`):
//!
//! - **t.** Step 1 counts from 0, so Eq. 6 gives λ_0 = 0 and every step of the first iteration is drawn uniformly, η or not. *repaired*
//!   counts from 1. (Step 7 would also make T_max + 1 iterations; both readings make T_max, its stated maximum.)
//! - **Eq. 11 and 12.** Eq. 11 sums over all m ants a term that no longer depends on the ant: m·Q2/L_min. *repaired* gives the reward once,
//!   as the text says.
//!
//! A third runs in two readings by a row of its own (`goal_step`):
//!
//! - **At the goal** Eq. 4 divides by 0: η is not defined there, and nothing says that the step is forbidden. *weighed*: the distance counts
//!   as ε (`goal_distance`; 0.01, as in our Ant System). With β = 25 the step onto the goal then has p = 1 up to rounding, and under the
//!   threshold rule it is no candidate while λ < 1: ants beside the goal walk on, unless no other step is left. *enter*, preset
//!   `second-reading`: an ant beside the goal takes the step onto it, whatever the rule, as the fireworks decode (`swarm/decode.rs`).
//!
//! Where the print does not decide and one reading is left:
//!
//! - **ρ** is called 消逝程度, how much vanishes, yet Eq. 10 multiplies by it, so it is what stays. `rho` is the part that leaves, 1 − ρ; at
//!   the paper's 0.5 both are the same.
//! - **D** of Eq. 4 has no value; it cancels in Eq. 5 and is left out. Eq. 5 prints η_j(g_i); we take η of the cell stepped to.
//! - **Eq. 8** adds Q1/l where ⟨g_i, g_j⟩ ∈ tabu_k. Eq. 7 is about the step just taken, from g_i to g_j, for which this is always true.
//! - **Step 8**, where a dead end leads, is not printed under that number: there are two steps 6, so the printed step 7, which ends the
//!   walks of an iteration, is the eighth. The text says 无路可走: the ant's walk ends (`dead_end` = die), the others walk on.
//! - **λ = 1.** Eq. 6 never reaches 1; in 64 bits it rounds to 1 once t² > 37.4·T_max (t = 44 of 50): then the rule is Ant System's.
//!
//! The paper's two improvements are the threshold and the reward of the shortest path; without both, ACOST is the paper's ACO. ACOMSP is
//! told by one: without its rule it is the random proportional one. Its reward cannot be taken out alone, for it is all that its ants leave.
//!
//! Where the paper is silent: τ0 is 1; trails are directed, as its arcs are; all trails evaporate, also when no ant has arrived; ants of an
//! iteration move in turn, one step each; equal largest probabilities are drawn from uniformly; there is no cap on moves.

use std::sync::Arc;

use crate::aco::colony::Colony;
use crate::aco::dead_end::DeadEnd;
use crate::aco::deposit;
use crate::aco::heuristic::{self, AT_GOAL};
use crate::aco::odds;
use crate::aco::selection;
use crate::aco::trails::{Row, Trails};
use crate::aco::variant::{Abreast, Iteration, Settings, Step, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction, Point};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Component, Family, GoalStep, Ground, Layer, PaperReading, Planner, PlannerEntry, Preset, Reading};
use crate::rng::Stream;
use crate::scenario::Scenario;

crate::param_choice! {
    /// How an ant of ACOST selects a step.
    pub enum Rule {
        /// roulette among the steps of at most threshold probability; if there is none, any step
        Threshold = "threshold",
        /// roulette among all steps, as in Ant System
        Proportional = "proportional",
    }
}

params! {
    /// What ACOST and ACOMSP have in common: most of table 1, and what the paper leaves open.
    pub struct CommonParams {
        /// ants that build a path in each iteration
        ants: u32 = 10, "m", [1..=1024], "ants", "table 1";
        /// iterations after which the colony stops
        iterations: u32 = 50, "T_max", [1..=100_000], "iterations", "table 1; also in eq. 6";
        /// weight of the trail τ in the choice of a step
        alpha: f64 = 1.0, "α", [0.0..=10.0], "", "table 1";
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.5, "ρ", [0.0..=1.0], "", "table 1; eq. 10 multiplies by what stays, also 0.5";
        /// the iteration's shortest path gets Q2 / its length on each step
        path_deposit: f64 = 1.0, "Q2", [0.0..=1e6], "cells", "table 1, eq. 12";
        /// how to take what the paper prints against its own text
        reading: Reading = Reading::Repaired, "", [], "", "our choice: eq. 6 from t = 1, eq. 12 once";
        /// what eq. 4 means for the step onto the goal, where it divides by 0
        goal_step: GoalStep = GoalStep::Weighed, "", [], "", "our choice, as in Ant System: eq. 4 divides by 0 at the goal";
        /// distance that stands for 0 where an ant sees the goal itself
        goal_distance: f64 = AT_GOAL, "ε", [1e-3..=1.0], "cells", "our choice, as in Ant System: eq. 4 divides by 0 at the goal",
            when(goal_step: "weighed");
        /// trail on every step before the first iteration
        initial_trail: f64 = 1.0, "τ0", [1e-6..=1e6], "", "our choice: step 1 gives no value";
        /// what an ant does where no neighbour is left
        dead_end: DeadEnd = DeadEnd::Die, "", [], "", "step 3, case 1";
        /// an ant gives up after this many times width + height moves; 0 = never
        move_limit: f64 = 0.0, "", [0.0..=1000.0], "× (width + height)", "our addition; the paper has no cap";
        /// stops after this many iterations without a shorter path; 0 = never
        stagnation: u32 = 0, "", [0..=100_000], "iterations", "our addition";
    }
}

params! {
    /// Parameters of ACOST.
    pub struct AcostParams {
        /// how an ant selects a step
        rule: Rule = Rule::Threshold, "", [], "", "step 5; proportional: the paper's ACO";
        /// weight of the heuristic η in the choice of a step
        beta: f64 = 25.0, "β", [0.0..=50.0], "", "table 1";
        /// after each move an ant leaves Q1 / length walked so far on that step
        move_deposit: f64 = 1.0, "Q1", [0.0..=1e6], "cells", "table 1, eq. 8";
        ..common: CommonParams;
    }
}

params! {
    /// Parameters of ACOMSP.
    pub struct AcomspParams {
        /// whether an ant takes the most probable step; else each by its probability, as in Ant System
        maximal: bool = true, "", [], "", "Lai, Guo 2014, section 1, of its ref. 13";
        /// weight of the heuristic η in the choice of a step
        beta: f64 = 15.0, "β", [0.0..=50.0], "", "table 1";
        ..common: CommonParams;
    }
}

impl CommonParams {
    fn settings(&self, beta: f64) -> Settings {
        Settings {
            ants: self.ants,
            iterations: self.iterations,
            stagnation: self.stagnation,
            alpha: self.alpha,
            beta,
            rho: self.rho,
            deposit: self.path_deposit,
            dead_end: self.dead_end,
            move_limit: self.move_limit,
        }
    }

    /// Eq. 4 of the step from `i` to `j`.
    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        let seen = visibility(scenario.grid.point(j), scenario.grid.point(scenario.goal), self.goal_distance);
        heuristic::per_factor(scenario, i, d, j, seen)
    }
}

/// Eq. 4 with D = 1, over the distance of Eq. 2; `at_goal` stands for 0.
pub fn visibility(j: Point, goal: Point, at_goal: f64) -> f64 {
    heuristic::goal_distance(j, goal, at_goal)
}

/// t of Eq. 6 in iteration `number` (from 1).
pub fn time(reading: Reading, number: u32) -> u32 {
    match reading {
        Reading::Repaired => number,
        Reading::Printed => number - 1,
    }
}

/// Eq. 6: λ_t = 1 − exp(−t²/T_max).
pub fn threshold(t: u32, t_max: u32) -> f64 {
    let t = f64::from(t);
    1.0 - libm::exp(-t * t / f64::from(t_max))
}

/// Eq. 10–12: τ ← (1 − rho)·τ, then Q2/L_min on the iteration's shortest path; *printed* adds this m times.
pub fn reward_shortest(trails: &mut Trails, iteration: &Iteration, p: &CommonParams) {
    trails.evaporate(p.rho);
    let times = match p.reading {
        Reading::Repaired => 1.0,
        Reading::Printed => iteration.ants.len() as f64,
    };
    if let Some((ant, length)) = iteration.iteration_best() {
        deposit::along(trails, iteration.scenario, ant, times * p.path_deposit / length);
    }
}

/// ACOST.
#[derive(Debug, Clone, Copy)]
pub struct Acost {
    params: AcostParams,
    /// λ_t.
    lambda: f64,
}

impl Acost {
    /// With these parameters.
    pub fn new(params: AcostParams) -> Self {
        Self { params, lambda: 0.0 }
    }
}

impl Variant for Acost {
    const LOCK_STEP: bool = true;

    fn settings(&self) -> Settings {
        self.params.common.settings(self.params.beta)
    }

    fn initial_trail(&self, _: &Scenario) -> f64 {
        self.params.common.initial_trail
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        self.params.common.heuristic(scenario, i, d, j)
    }

    fn enters_goal(&self) -> bool {
        self.params.common.goal_step == GoalStep::Enter
    }

    /// Step 4.
    fn begin_iteration(&mut self, number: u32) {
        let p = &self.params.common;
        self.lambda = threshold(time(p.reading, number), p.iterations);
    }

    fn abreast(&self) -> Abreast {
        match self.params.rule {
            Rule::Threshold => Abreast::Never,
            Rule::Proportional => Abreast::Proportional,
        }
    }

    /// Step 5.
    #[inline(always)]
    fn choose(&self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        match self.params.rule {
            Rule::Threshold => selection::threshold(weights, self.lambda, stream),
            Rule::Proportional => selection::random_proportional(weights, stream),
        }
    }

    fn odds(&self, weights: &Row) -> Vec<f64> {
        match self.params.rule {
            Rule::Threshold => odds::threshold(weights, self.lambda),
            Rule::Proportional => odds::random_proportional(weights),
        }
    }

    /// Eq. 7–9.
    fn on_move(&self, trails: &mut Trails, step: Step) {
        trails.deposit(step.from, step.direction, self.params.move_deposit / step.walked);
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        reward_shortest(trails, &iteration, &self.params.common);
    }
}

/// ACOMSP.
#[derive(Debug, Clone, Copy)]
pub struct Acomsp {
    params: AcomspParams,
}

impl Acomsp {
    /// With these parameters.
    pub fn new(params: AcomspParams) -> Self {
        Self { params }
    }
}

impl Variant for Acomsp {
    fn settings(&self) -> Settings {
        self.params.common.settings(self.params.beta)
    }

    fn initial_trail(&self, _: &Scenario) -> f64 {
        self.params.common.initial_trail
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        self.params.common.heuristic(scenario, i, d, j)
    }

    fn enters_goal(&self) -> bool {
        self.params.common.goal_step == GoalStep::Enter
    }

    fn abreast(&self) -> Abreast {
        if self.params.maximal { Abreast::Maximal } else { Abreast::Proportional }
    }

    #[inline(always)]
    fn choose(&self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        if self.params.maximal { selection::maximal(weights, stream) } else { selection::random_proportional(weights, stream) }
    }

    fn odds(&self, weights: &Row) -> Vec<f64> {
        if self.params.maximal { odds::maximal(weights) } else { odds::random_proportional(weights) }
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        reward_shortest(trails, &iteration, &self.params.common);
    }
}

fn build_acost(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = Acost::new(AcostParams::read(ACOST.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ACOST.id, seed, 0)))
}

fn build_acomsp(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = Acomsp::new(AcomspParams::read(ACOMSP.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ACOMSP.id, seed, 0)))
}

const SECOND_READING: Preset = Preset {
    name: "second-reading",
    source: "Lai, Guo 2014, eq. 4",
    meaning: "an ant beside the goal enters it: eq. 4 is undefined there, not a reason to bar the step",
    numbers: &[],
    choices: &[("goal_step", "enter")],
    reading: Some(PaperReading::SecondReading),
};

/// ACOST in the catalog.
pub const ACOST: PlannerEntry = PlannerEntry {
    id: "acost",
    name: "Adaptive-threshold ACO",
    family: Family::AntColony,
    summary: "Early on, steps whose probability exceeds a threshold are barred, so that ants spread; the threshold rises to 1.",
    source: "Lai, Guo 2014, Ant Colony Optimization Based on Self-Adaption Threshold for Path Planning",
    presets: &[
        Preset {
            name: "aco",
            source: "Lai, Guo 2014, table 1: ACO",
            meaning: "the paper's classic ACO: every step by its probability, Q1 after each move, no reward of the shortest path",
            numbers: &[("path_deposit", 0.0)],
            choices: &[("rule", "proportional")],
            reading: None,
        },
        Preset {
            name: "printed",
            source: "Lai, Guo 2014, as printed",
            meaning: "t from 0, so that the first iteration walks uniformly; eq. 11 and 12 reward the shortest path m times",
            numbers: &[],
            choices: &[("reading", "printed")],
            reading: Some(PaperReading::Printed),
        },
        SECOND_READING,
    ],
    components: &[
        Component {
            id: "threshold",
            name: "threshold λ",
            adds: "early on, steps above a probability that rises to 1 are barred (eq. 6, step 5); without: every step by its probability (eq. 5)",
            without: &[("rule", "proportional")],
        },
        Component {
            id: "shortest-path-reward",
            name: "reward of the shortest path",
            adds: "the iteration's shortest path gains Q2/L_min (eq. 10–12); without: ants leave Q1 on their moves alone (eq. 7–9)",
            without: &[("path_deposit", "0")],
        },
    ],
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: AcostParams::specs,
    build: build_acost,
};

/// ACOMSP in the catalog.
pub const ACOMSP: PlannerEntry = PlannerEntry {
    id: "acomsp",
    name: "Maximum-probability ACO",
    family: Family::AntColony,
    summary: "Every ant takes the most probable step; the iteration's shortest path is rewarded. Often every ant ends in the same dead end.",
    source: "Lai, Guo 2014, table 1: ACOMSP, after Tang, Zhang, Jiang, Zhang 2012, J. Comput. Inf. Syst. 8, 10325–10332",
    presets: &[
        Preset {
            name: "printed",
            source: "Lai, Guo 2014, as printed",
            meaning: "eq. 11 and 12 reward the shortest path m times",
            numbers: &[],
            choices: &[("reading", "printed")],
            reading: Some(PaperReading::Printed),
        },
        SECOND_READING,
    ],
    components: &[Component {
        id: "maximal-step",
        name: "most probable step",
        adds: "every ant takes the most probable step (section 1, of its ref. 13); without: every step by its probability (eq. 5)",
        without: &[("maximal", "false")],
    }],
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: AcomspParams::specs,
    build: build_acomsp,
};
