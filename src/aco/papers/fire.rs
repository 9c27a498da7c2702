//! Fire-fighting robot with several fires: 张森, 王奔, 孙梦亚, 刘月锟, 武曲, 刘秀燕 (Zhang, Wang, Sun, Liu, Wu, Liu), 改进的蚁群算法在灭火机器
//! 人多火源路径规划的应用 (Application of improved ant colony algorithm in multi-fire path planning of fire fighting robot), Computer Science
//! and Application 10(5) (2020), doi:10.12677/CSA.2020.105088. A colony chooses the order of the fires, then colonies look for the legs.
//!
//! | override point | source |
//! |---|---|
//! | order of the goals | section 3.2: ants on the complete graph, Eq. 3 with η = 1/R (Eq. 6–8), or 1/d in the basic algorithm |
//! | initial trail | τ0, constant |
//! | heuristic of a leg | text of Eq. 3: 1/d_j, d_j Euclidean from j to the leg's goal |
//! | selection of a step | Eq. 9: pseudo-random proportional; Eq. 3, random proportional, in the basic algorithm |
//! | on each move | as Ant System (nothing) |
//! | update | Eq. 4–5: as Ant System, on both levels; a leg's Q/L is Q/V where V is the criterion (`criterion`) |
//! | daemon actions | none |
//!
//! `reading` decides about ρ: the text calls it the evaporation coefficient, Eq. 4 multiplies what stays by it. *repaired*: ρ = 0.3 leaves;
//! *printed*: 0.3 stays.
//!
//! Step 4 of its section 3.2 names Eq. 3 and 10 for the choice of the next fire. Eq. 10 evaluates paths. All references to equations after
//! Eq. 3 are two too high (Eq. 5 for d, which has no number; Eq. 8 for R, which is Eq. 6; Eq. 12 for V(d, r), which is Eq. 10), so Eq. 3
//! and 8 are meant: the random proportional rule with η = 1/R, while Eq. 9 belongs to section 3.3, the legs. `order_rule=improved` takes
//! Eq. 9 for the order too.
//!
//! Where the paper is silent, we: set Q = 1, τ0 = 1 and r0 = 0.7 (it gives 0.6 to 0.8); give the order level m, K, α, β, ρ and Q of the
//! legs, and its own K as a parameter; take Σ R of a tour for L_k there; deposit on directed edges, for R depends on the direction; let
//! ants at a dead end step back; take d_j at the goal as 0.01.
//!
//! The paper measures the ways between fires by straight lines. Walls may make the best order by lines a bad one to walk, so the default
//! is the length of the shortest path on the map (`leg_length=grid`, ours); presets keep the lines.
//!
//! Eq. 10, V(d, r), evaluates "the whole path" in section 3.4; its conclusion takes it "as the criterion by which paths are good or bad".
//! By default it is measured alone ([`crate::metrics::Metrics::turn_index`]). With `criterion=turn-index` (preset `second-reading`) the best
//! path of a leg is the one of the least V, and an ant leaves Q/V instead of the Q/L of Eq. 5; the way into a leg's first cell is no part of
//! its V, so a turn at a goal counts in none. Whether the deposit goes by the criterion as well the paper leaves open: `deposit_by=length`
//! (preset `printed-deposit`) keeps Eq. 5 as it is printed. V is then no component that could be taken out of the default, though it is the
//! third of the paper's improvements. With one goal there is no order, and nothing to take out of it; then the exact V is the yardstick.
//!
//! `criterion=weighted-sum` is ours: J of [`crate::metrics::WeightedSum`], proven by the turn-aware search on a plane.

use std::sync::Arc;

use crate::aco::criterion::{Criterion, DepositBy, Judge};
use crate::aco::deposit;
use crate::aco::heuristic::{AT_GOAL, goal_distance, per_factor};
use crate::aco::legs::{self, OrderLevel};
use crate::aco::odds;
use crate::aco::selection::{pseudo_random_proportional, random_proportional};
use crate::aco::shared_params::{SelectionParams, WalkParams, settings};
use crate::aco::tour::TourSettings;
use crate::aco::trails::{Row, Trails};
use crate::aco::variant::{Abreast, Iteration, Settings, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction};
use crate::metrics::WeightedSum;
use crate::params::{Params, Values};
use crate::planner::{Component, Family, Ground, Layer, PaperReading, Planner, PlannerEntry, Preset, Reading};
use crate::rng::Stream;
use crate::scenario::{MAX_GOALS, Scenario};
use crate::{param_choice, params};

param_choice! {
    /// What the order of the goals makes small.
    pub enum Order {
        /// Σ R, the length of each leg times the weight b = 1/(s·w·a) of the goal that it leads to: equation 8
        Weight = "weight",
        /// the length of the tour: the basic algorithm
        Distance = "distance",
    }
}

param_choice! {
    /// How an ant selects what comes next.
    pub enum Rule {
        /// equation 9: with probability r0 the best, else as in the basic algorithm
        Improved = "improved",
        /// equation 3: in proportion to τ^α·η^β
        Basic = "basic",
    }
}

param_choice! {
    /// What lies between two goals when their order is chosen.
    pub enum LegLength {
        /// the shortest path on the map
        Grid = "grid",
        /// the straight line, whatever stands in its way: the paper
        Euclidean = "euclidean",
    }
}

params! {
    /// Parameters of the fire-fighting planner.
    pub struct FireParams {
        /// what the order of several goals makes small
        order: Order = Order::Weight, "R", [], "", "eq. 6–8";
        /// how an ant selects the next goal
        order_rule: Rule = Rule::Basic, "", [], "", "section 3.2, step 4: eq. 3, with η of eq. 8";
        /// which length between two goals their order is chosen by
        leg_length: LegLength = LegLength::Grid, "d_ij", [], "", "our choice; the paper: euclidean";
        /// iterations of the colony that chooses the order
        order_iterations: u32 = 100, "K", [1..=10_000], "iterations", "section 4";
        /// how an ant selects the next step of a leg
        legs: Rule = Rule::Improved, "", [], "", "eq. 9";
        /// what makes one path of a leg better than another
        criterion: Criterion = Criterion::Length, "V", [], "", "eq. 5: length; section 5 takes V of eq. 10 as the criterion";
        /// what an ant's deposit on a leg is divided by: the criterion, or the length as eq. 5 has it
        deposit_by: DepositBy = DepositBy::Criterion, "", [], "", "our reading; eq. 5 is printed with the length", when(criterion: "turn-index" | "weighted-sum");
        /// whether ρ of the paper leaves (repaired) or stays (printed)
        reading: Reading = Reading::Repaired, "", [], "", "ours: see the paper card";
        /// ants of each level and leg that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "section 4";
        ..selection: SelectionParams {
            iterations = 100, "section 4";
            alpha = 1.0, "section 4";
            beta = 7.0, "section 4";
        };
        /// ρ of the paper: the part of every trail that leaves in each iteration; as printed, the part that stays
        rho: f64 = 0.3, "ρ", [0.0..=1.0], "", "section 4, eq. 4";
        /// an ant leaves Q / length (by another criterion, Q / its value) of its path or tour on each step of it
        deposit: f64 = 1.0, "Q", [1e-6..=1e6], "cells", "eq. 5; our choice: not given";
        /// by the improved rule, the probability of taking the best step or goal instead of drawing one
        r0: f64 = 0.7, "r0", [0.0..=1.0], "", "eq. 9: 0.6 to 0.8";
        /// trail on every step and edge before the first iteration
        initial_trail: f64 = 1.0, "τ0", [1e-6..=1e6], "", "our choice: not given";
        ..walk: WalkParams;
        ..sum: WeightedSum;
    }
}

impl FireParams {
    /// The part of every trail that leaves, from ρ of Eq. 4 by either reading.
    pub fn evaporation(&self) -> f64 {
        match self.reading {
            Reading::Repaired => self.rho,
            Reading::Printed => 1.0 - self.rho,
        }
    }

    /// Section 3.2: how the order is chosen.
    pub fn order_level(&self) -> OrderLevel {
        let settings = TourSettings {
            ants: self.ants,
            iterations: self.order_iterations,
            alpha: self.selection.alpha,
            beta: self.selection.beta,
            rho: self.evaporation(),
            deposit: self.deposit,
            initial_trail: self.initial_trail,
            exploit: (self.order_rule == Rule::Improved).then_some(self.r0),
        };
        let straight = self.leg_length == LegLength::Euclidean;
        OrderLevel { settings, weighted: self.order == Order::Weight, straight, solving: None }
    }
}

/// The colony of one leg.
#[derive(Debug, Clone, Copy)]
pub struct Fire {
    params: FireParams,
}

impl Fire {
    /// With these parameters.
    pub fn new(params: FireParams) -> Self {
        Self { params }
    }
}

impl Variant for Fire {
    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.evaporation(), p.deposit, &p.selection, &p.walk)
    }

    fn initial_trail(&self, _: &Scenario) -> f64 {
        self.params.initial_trail
    }

    /// η_j = 1/d_j of Eq. 3.
    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        let near = goal_distance(scenario.grid.point(j), scenario.grid.point(scenario.goal), AT_GOAL);
        per_factor(scenario, i, d, j, near)
    }

    fn abreast(&self) -> Abreast {
        match self.params.legs {
            Rule::Improved => Abreast::PseudoProportional(self.params.r0),
            Rule::Basic => Abreast::Proportional,
        }
    }

    /// Eq. 9, or Eq. 3.
    #[inline(always)]
    fn choose(&self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        match self.params.legs {
            Rule::Improved => pseudo_random_proportional(weights, self.params.r0, stream),
            Rule::Basic => random_proportional(weights, stream),
        }
    }

    fn criterion(&self) -> Judge {
        self.params.criterion.by(self.params.sum)
    }

    /// Eq. 4–5, with the criterion's value in the place of L unless `deposit_by` says otherwise.
    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        let p = &self.params;
        let by = if p.deposit_by == DepositBy::Criterion { self.criterion() } else { Judge::Length };
        trails.evaporate(p.evaporation());
        for (ant, _) in iteration.arrived() {
            if let Some(value) = by.of_ant(iteration.scenario, ant) {
                deposit::along(trails, iteration.scenario, ant, p.deposit / value);
            }
        }
    }

    fn odds(&self, weights: &Row) -> Vec<f64> {
        match self.params.legs {
            Rule::Improved => odds::pseudo_random_proportional(weights, self.params.r0),
            Rule::Basic => odds::random_proportional(weights),
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let params = FireParams::read(ENTRY.id, values)?;
    Ok(legs::planner(scenario, params.order_level(), Fire::new(params), (ENTRY.id, ENTRY.layers), seed))
}

const SOURCE: &str = "fire-fighting robot with several fires (Zhang et al. 2020)";

const PRESETS: &[Preset] = &[
    Preset {
        name: "paper",
        source: SOURCE,
        meaning: "its improved algorithm, repaired: the order by straight lines, ρ = 0.3 leaves",
        numbers: &[],
        choices: &[("leg_length", "euclidean")],
        reading: Some(PaperReading::AsRead),
    },
    Preset {
        name: "basic",
        source: SOURCE,
        meaning: "its own baseline: shortest order by straight lines, random proportional rule on both levels",
        numbers: &[],
        choices: &[("order", "distance"), ("leg_length", "euclidean"), ("legs", "basic")],
        reading: None,
    },
    Preset {
        name: "second-reading",
        source: SOURCE,
        meaning: "its improved algorithm with V of eq. 10 as the criterion of a path, as its section 5 says; the order by straight lines",
        numbers: &[],
        choices: &[("leg_length", "euclidean"), ("criterion", "turn-index")],
        reading: Some(PaperReading::SecondReading),
    },
    Preset {
        name: "printed-deposit",
        source: SOURCE,
        meaning: "as second-reading, but an ant leaves Q/L as eq. 5 is printed: V decides which path is the best, and nothing else",
        numbers: &[],
        choices: &[("leg_length", "euclidean"), ("criterion", "turn-index"), ("deposit_by", "length")],
        reading: None,
    },
    Preset {
        name: "printed",
        source: SOURCE,
        meaning: "its improved algorithm as printed: the order by straight lines, ρ = 0.3 stays (eq. 4)",
        numbers: &[],
        choices: &[("leg_length", "euclidean"), ("reading", "printed")],
        reading: Some(PaperReading::Printed),
    },
];

const COMPONENTS: &[Component] = &[
    Component {
        id: "weighted-order",
        name: "order by urgency",
        adds: "the order of the goals weighs each way by the urgency of the goal it leads to (eq. 6–8); without: the shortest order; with one goal there is none",
        without: &[("order", "distance")],
    },
    Component {
        id: "best-step",
        name: "mostly the best step",
        adds: "with probability r0 an ant takes the best step of a leg (eq. 9); without: every step by its probability (eq. 3)",
        without: &[("legs", "basic")],
    },
];

/// The fire-fighting planner in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "fire",
    name: "Multi-fire ACO",
    family: Family::AntColony,
    summary: "Ants choose the order of several goals by distance and urgency, then look for the path of each leg, mostly by the best step (Zhang et al. 2020).",
    source: "Zhang, Wang, Sun, Liu, Wu, Liu 2020, Computer Science and Application 10(5), doi:10.12677/CSA.2020.105088",
    presets: PRESETS,
    components: COMPONENTS,
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: MAX_GOALS as u32,
    grounds: Ground::NEIGHBOURS,
    specs: FireParams::specs,
    build,
};
