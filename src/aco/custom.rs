//! Build your own ant: every rule of a colony by the name of the planner that it is taken from.
//!
//! | override point | taken from |
//! |---|---|
//! | order of several goals | `fire`: `order`, `order_rule`, `leg_length` |
//! | initial trail | the planner named by `initial_trail_of` |
//! | heuristic | the planner named by `heuristic_of` |
//! | selection | the planner named by `selection_of` |
//! | on each move | the planner named by `local_update_of` |
//! | dead end | `dead_end` |
//! | update | the planner named by `update_of` |
//! | daemon actions | the planner named by `daemon_of`; refinement: by `refinement_of` |
//!
//! Nothing is written twice: a donor is the planner's own variant, made from the same numbers, and lends one of its hooks. So a planner's
//! rules taken together are that planner, bit for bit: each preset repeats its runs (tested), and what one rule contributes is seen by
//! replacing it (ablation). Random numbers are those of the planner that lends the selection rule, so that two compositions with one
//! selection rule are paired runs.
//!
//! Rows of this file have the meaning and range that all donors share; every other row is a donor's own, and says when it has an effect,
//! unless more than one rule needs it, or the order of several goals.

use std::sync::Arc;

use super::classics::ant_colony_system::{AntColonySystem, AntColonySystemParams};
use super::classics::ant_system::{AntSystem, AntSystemParams};
use super::classics::elitist_ant_system::{ElitistAntSystem, ElitistAntSystemParams};
use super::classics::max_min_ant_system::{MaxMinAntSystem, MaxMinAntSystemParams};
use super::classics::rank_based_ant_system::{RankBasedAntSystem, RankBasedAntSystemParams};
use super::hybrid::Hybrid;
use super::legs::{self, OrderLevel};
use super::papers::Reading;
use super::papers::fire::{Fire, FireParams};
use super::papers::fireworks::{self, ColonyRows, FwaAcoParams, PsoAcoParams, Seeded};
use super::papers::ship::{Ship, ShipParams};
use super::papers::threshold::{Acomsp, AcomspParams, Acost, AcostParams};
use super::shared_params::{ChoiceParams, WalkParams, settings};
use super::trails::{Row, Trails};
use super::variant::{Iteration, Settings, Step, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction};
use crate::params::{AppliesWhen, Choice, ParamSpec, Params, Value, Values, check_keys};
use crate::planner::{Entry, Family, Layer, Planner, Preset};
use crate::rng::Stream;
use crate::scenario::{MAX_GOALS, Scenario};
use crate::{choice, params};

choice! {
    /// The planner that lends a rule.
    pub enum Donor {
        /// Ant System
        AntSystem = "ant-system",
        /// Elitist Ant System
        Elitist = "elitist-ant-system",
        /// rank-based Ant System
        RankBased = "rank-based-ant-system",
        /// MAX–MIN Ant System
        MaxMin = "max-min-ant-system",
        /// Ant Colony System
        AntColonySystem = "ant-colony-system",
        /// multi-fire ACO (Zhang et al. 2020)
        Fire = "fire",
        /// engine-room ACO (Fan et al. 2026)
        Ship = "ship",
        /// ACOST (Lai and Guo 2014)
        Acost = "acost",
        /// ACOMSP (as given by Lai and Guo 2014)
        Acomsp = "acomsp",
        /// fireworks, then ants (Zhou, Mu, Zhang 2019)
        FwaAco = "fwa-aco",
        /// particles, then ants (named by Zhou, Mu, Zhang 2019)
        PsoAco = "pso-aco",
    }
}

params! {
    /// The rules by name, and the numbers that all donors share.
    pub struct CustomParams {
        /// the trails before the first iteration are those of this planner; a hybrid's first stage needs a single goal
        initial_trail_of: Donor = Donor::AntSystem, "", [], "", "composition";
        /// what an ant sees of a step is as in this planner
        heuristic_of: Donor = Donor::AntSystem, "", [], "", "composition";
        /// an ant selects a step as in this planner; its random numbers are those of this planner
        selection_of: Donor = Donor::AntSystem, "", [], "", "composition";
        /// what happens to the trail of each step that an ant takes is as in this planner
        local_update_of: Donor = Donor::AntSystem, "", [], "", "composition; Ant System: nothing";
        /// trails change at the end of an iteration as in this planner
        update_of: Donor = Donor::AntSystem, "", [], "", "composition";
        /// what no single ant could do is as in this planner; MAX–MIN restarts need its update, whose limits they use
        daemon_of: Donor = Donor::AntSystem, "", [], "", "composition; Ant System: nothing";
        /// the best path is refined, or not, as in this planner
        refinement_of: Donor = Donor::AntSystem, "", [], "", "composition; Ant System: not refined";
        /// how the lent rules take the places where their papers contradict themselves
        reading: Reading = Reading::Repaired, "", [], "", "the planners that lend the rules";
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "papers' common value";
        ..choice: ChoiceParams;
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.5, "ρ", [0.001..=1.0], "", "Dorigo and Stützle 2004, box 3.1";
        ..walk: WalkParams;
    }
}

/// One variant of each planner, made from the same numbers.
#[derive(Debug, Clone)]
struct Donors {
    ant_system: AntSystem,
    elitist: ElitistAntSystem,
    rank_based: RankBasedAntSystem,
    max_min: MaxMinAntSystem,
    ant_colony_system: AntColonySystem,
    fire: Fire,
    ship: Ship,
    acost: Acost,
    acomsp: Acomsp,
    seeded: Seeded,
}

/// Reads a donor's parameters; keys of others are not its business.
fn pick<P: Params>(values: &Values) -> Result<P, ParamError> {
    P::pick(values, P::default())
}

impl Donors {
    fn pick(values: &Values) -> Result<Self, ParamError> {
        Ok(Self {
            ant_system: AntSystem::new(pick::<AntSystemParams>(values)?),
            elitist: ElitistAntSystem::new(pick::<ElitistAntSystemParams>(values)?),
            rank_based: RankBasedAntSystem::new(pick::<RankBasedAntSystemParams>(values)?),
            max_min: MaxMinAntSystem::new(pick::<MaxMinAntSystemParams>(values)?),
            ant_colony_system: AntColonySystem::new(pick::<AntColonySystemParams>(values)?),
            fire: Fire::new(pick::<FireParams>(values)?),
            ship: Ship::new(pick::<ShipParams>(values)?),
            acost: Acost::new(pick::<AcostParams>(values)?),
            acomsp: Acomsp::new(pick::<AcomspParams>(values)?),
            seeded: Seeded::new(pick::<ColonyRows>(values)?, None),
        })
    }

    /// The rows of all donors, in the order of [`Donor`].
    fn specs() -> Vec<ParamSpec> {
        [
            AntSystemParams::specs(),
            ElitistAntSystemParams::specs(),
            RankBasedAntSystemParams::specs(),
            MaxMinAntSystemParams::specs(),
            AntColonySystemParams::specs(),
            FireParams::specs(),
            ShipParams::specs(),
            AcostParams::specs(),
            AcomspParams::specs(),
            FwaAcoParams::specs(),
            PsoAcoParams::specs(),
        ]
        .concat()
    }
}

/// Calls a hook of the donor that a rule names.
macro_rules! lent {
    ($custom:ident, $rule:ident, $hook:ident($($arg:expr),*)) => {
        match $custom.rules.$rule {
            Donor::AntSystem => $custom.donors.ant_system.$hook($($arg),*),
            Donor::Elitist => $custom.donors.elitist.$hook($($arg),*),
            Donor::RankBased => $custom.donors.rank_based.$hook($($arg),*),
            Donor::MaxMin => $custom.donors.max_min.$hook($($arg),*),
            Donor::AntColonySystem => $custom.donors.ant_colony_system.$hook($($arg),*),
            Donor::Fire => $custom.donors.fire.$hook($($arg),*),
            Donor::Ship => $custom.donors.ship.$hook($($arg),*),
            Donor::Acost => $custom.donors.acost.$hook($($arg),*),
            Donor::Acomsp => $custom.donors.acomsp.$hook($($arg),*),
            Donor::FwaAco | Donor::PsoAco => $custom.donors.seeded.$hook($($arg),*),
        }
    };
}

/// Calls a hook of every donor.
macro_rules! all {
    ($custom:ident, $hook:ident($($arg:expr),*)) => {{
        let donors = &mut $custom.donors;
        donors.ant_system.$hook($($arg),*);
        donors.elitist.$hook($($arg),*);
        donors.rank_based.$hook($($arg),*);
        donors.max_min.$hook($($arg),*);
        donors.ant_colony_system.$hook($($arg),*);
        donors.fire.$hook($($arg),*);
        donors.ship.$hook($($arg),*);
        donors.acost.$hook($($arg),*);
        donors.acomsp.$hook($($arg),*);
        donors.seeded.$hook($($arg),*);
    }};
}

impl Donor {
    /// Its planner's id.
    pub fn id(self) -> &'static str {
        Self::OPTIONS.iter().find(|o| o.0 == self).map_or("", |o| o.1)
    }

    /// Whether its η changes with time as ln η = a + b·w(t).
    fn is_timed(self) -> bool {
        self == Self::Ship
    }

    /// Whether its selection is the random proportional rule.
    fn is_proportional(self) -> bool {
        !matches!(self, Self::AntColonySystem | Self::Fire | Self::Acost | Self::Acomsp)
    }

    /// Whether its ants change trails while they walk.
    fn updates_on_moves(self) -> bool {
        matches!(self, Self::AntColonySystem | Self::Acost)
    }
}

/// A composed colony. `IN_STEP`: ants move in lock step, because trails change on moves or the selection rule is not the random
/// proportional one; `TIMED`: as [`Variant::TIMED`].
#[derive(Debug, Clone)]
pub struct Custom<const IN_STEP: bool, const TIMED: bool> {
    rules: CustomParams,
    donors: Donors,
}

impl<const IN_STEP: bool, const TIMED: bool> Variant for Custom<IN_STEP, TIMED> {
    const LOCK_STEP: bool = IN_STEP;
    const RANDOM_PROPORTIONAL: bool = !IN_STEP;
    const TIMED: bool = TIMED;

    fn settings(&self) -> Settings {
        let p = &self.rules;
        settings(p.ants, p.rho, 1.0, &p.choice, &p.walk)
    }

    fn initial_trail(&self, scenario: &Scenario) -> f64 {
        lent!(self, initial_trail_of, initial_trail(scenario))
    }

    fn prepare(&mut self, scenario: &Scenario) {
        all!(self, prepare(scenario));
    }

    fn shape_trails(&self, scenario: &Scenario, trails: &mut Trails) {
        lent!(self, initial_trail_of, shape_trails(scenario, trails));
    }

    fn begin_iteration(&mut self, number: u32) {
        all!(self, begin_iteration(number));
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        lent!(self, heuristic_of, heuristic(scenario, i, d, j))
    }

    fn heuristic_changes(&self, iteration: u32) -> bool {
        lent!(self, heuristic_of, heuristic_changes(iteration))
    }

    fn log_heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> (f64, f64) {
        lent!(self, heuristic_of, log_heuristic(scenario, i, d, j))
    }

    fn time(&self) -> f64 {
        lent!(self, heuristic_of, time())
    }

    #[inline(always)]
    fn choose(&self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        lent!(self, selection_of, choose(weights, stream))
    }

    fn on_move(&self, trails: &mut Trails, step: Step) {
        lent!(self, local_update_of, on_move(trails, step));
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        lent!(self, update_of, update_trails(trails, iteration));
    }

    fn refines(&self) -> bool {
        lent!(self, refinement_of, refines())
    }

    fn daemon_actions(&mut self, trails: &mut Trails, iteration: Iteration) {
        lent!(self, daemon_of, daemon_actions(trails, iteration));
    }
}

/// When a donor's own row has an effect: the rule that must be one of these planners'. None where more than one rule can need it
/// (`elitists` and `ranks`: update and initial trail; `deposit`: the seed's trail, too), or the order of several goals (`initial_trail`, `r0`).
fn applies(key: &str) -> Option<(&'static str, &'static [Donor])> {
    const GOAL: &[Donor] = &[Donor::Acost, Donor::Acomsp];
    const CLASSICS_AND_HYBRIDS: &[Donor] = &[
        Donor::AntSystem,
        Donor::Elitist,
        Donor::RankBased,
        Donor::MaxMin,
        Donor::AntColonySystem,
        Donor::FwaAco,
        Donor::PsoAco,
    ];
    const SEEDED: &[Donor] = &[Donor::FwaAco, Donor::PsoAco];
    Some(match key {
        "heuristic" => ("heuristic_of", CLASSICS_AND_HYBRIDS),
        "goal_pull" | "omega_min" | "omega_max" | "obstacle_push" => ("heuristic_of", &[Donor::Ship]),
        "goal_distance" => ("heuristic_of", GOAL),
        "q0" => ("selection_of", &[Donor::AntColonySystem]),
        "seed_iterations" | "seed_ants" | "range" | "decode_limit" => ("initial_trail_of", SEEDED),
        "fireworks" | "sparks" | "fewest" | "most" | "radius" | "gaussian_sparks" | "radius_end" | "mutation_start"
        | "mutation_end" => ("initial_trail_of", &[Donor::FwaAco]),
        "particles" | "inertia_start" | "inertia_end" | "cognitive" | "social" | "speed_limit" => {
            ("initial_trail_of", &[Donor::PsoAco])
        }
        "legs" => ("selection_of", &[Donor::Fire]),
        "rule" => ("selection_of", &[Donor::Acost]),
        "xi" => ("local_update_of", &[Donor::AntColonySystem]),
        "move_deposit" => ("local_update_of", &[Donor::Acost]),
        "p_best" | "best_every" => ("update_of", &[Donor::MaxMin]),
        "update" | "k_best" | "k_worst" | "trail_min" => ("update_of", &[Donor::Ship]),
        "path_deposit" => ("update_of", GOAL),
        "refine" => ("refinement_of", &[Donor::Ship]),
        "restart_after" => ("daemon_of", &[Donor::MaxMin]),
        _ => return None,
    })
}

/// The rows of this file, then every donor's own.
fn specs() -> Vec<ParamSpec> {
    let mut rows = CustomParams::specs();
    for row in Donors::specs() {
        if rows.iter().all(|r| r.key != row.key) {
            rows.push(row);
        }
    }
    for row in &mut rows {
        if let Some((key, donors)) = applies(row.key) {
            row.applies_when = Some(AppliesWhen { key, values: donors.iter().map(|d| Value::from(d.id())).collect() });
        }
    }
    rows
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let rows = specs();
    check_keys(ENTRY.id, &rows, values)?;
    // Also the rows of donors that lend nothing here.
    rows.iter().filter_map(|r| Some((r, values.get(r.key)?))).try_for_each(|(row, value)| row.check(value))?;
    // Every donor works with the numbers of this composition, not with its own defaults.
    let mut all: Values = rows.iter().map(|r| (r.key.to_string(), r.default.clone())).collect();
    all.extend(values.clone());
    let (rules, donors) = (pick::<CustomParams>(&all)?, Donors::pick(&all)?);
    let parts = Parts {
        scenario,
        level: pick::<FireParams>(&all)?.order_level(),
        first: first_stage(scenario, rules, &all, seed)?,
        seed,
    };
    let in_step = !rules.selection_of.is_proportional() || rules.local_update_of.updates_on_moves();
    Ok(match (in_step, rules.heuristic_of.is_timed()) {
        (false, false) => parts.planner(Custom::<false, false> { rules, donors }),
        (false, true) => parts.planner(Custom::<false, true> { rules, donors }),
        (true, false) => parts.planner(Custom::<true, false> { rules, donors }),
        (true, true) => parts.planner(Custom::<true, true> { rules, donors }),
    })
}

/// The planner whose path shapes the initial trail, where the donor has one; legs between several goals begin without.
fn first_stage(
    scenario: &Arc<Scenario>,
    rules: CustomParams,
    values: &Values,
    seed: u32,
) -> Result<Option<Box<dyn Planner>>, ParamError> {
    Ok(match rules.initial_trail_of {
        Donor::FwaAco if scenario.goals.len() == 1 => Some(fireworks::fireworks_first(scenario, &pick(values)?, seed)?),
        Donor::PsoAco if scenario.goals.len() == 1 => Some(fireworks::particles_first(scenario, &pick(values)?, seed)?),
        _ => None,
    })
}

/// What a composition is built around.
struct Parts<'a> {
    scenario: &'a Arc<Scenario>,
    level: OrderLevel,
    first: Option<Box<dyn Planner>>,
    seed: u32,
}

impl Parts<'_> {
    fn planner<const S: bool, const T: bool>(self, custom: Custom<S, T>) -> Box<dyn Planner> {
        let (rules, streams) = (custom.rules, custom.rules.selection_of.id());
        let Some(first) = self.first else {
            return legs::planner(self.scenario, self.level, custom, (streams, ENTRY.layers), self.seed);
        };
        let second = move |found| {
            let seeded = custom.donors.seeded.with_seed(found);
            Custom::<S, T> { rules, donors: Donors { seeded, ..custom.donors.clone() } }
        };
        Box::new(Hybrid::new(Arc::clone(self.scenario), first, Box::new(second), (streams, ENTRY.layers), self.seed))
    }
}

/// All rules from one planner.
macro_rules! all_rules {
    ($id:literal $(, $key:literal = $value:literal)*) => {
        &[
            ("initial_trail_of", $id),
            ("heuristic_of", $id),
            ("selection_of", $id),
            ("local_update_of", $id),
            ("update_of", $id),
            ("daemon_of", $id),
            ("refinement_of", $id),
            $(($key, $value)),*
        ]
    };
}

const PRESETS: &[Preset] = &[
    Preset {
        name: "max-min-ant-system",
        source: "Stützle, Hoos 2000",
        meaning: "all rules of MAX–MIN Ant System: the same runs",
        numbers: &[("rho", 0.02)],
        choices: all_rules!("max-min-ant-system"),
    },
    Preset {
        name: "ant-colony-system",
        source: "Dorigo, Gambardella 1997",
        meaning: "all rules of Ant Colony System: the same runs",
        numbers: &[("ants", 10.0), ("rho", 0.1)],
        choices: all_rules!("ant-colony-system"),
    },
    Preset {
        name: "fire",
        source: "Zhang et al. 2020",
        meaning: "all rules of the multi-fire ACO: the same runs",
        numbers: &[("beta", 7.0), ("rho", 0.3)],
        choices: all_rules!("fire"),
    },
    Preset {
        name: "ship",
        source: "Fan et al. 2026",
        meaning: "all rules of the engine-room ACO: the same runs",
        numbers: &[("beta", 2.0), ("rho", 0.8), ("deposit", 10.0)],
        choices: all_rules!("ship"),
    },
    Preset {
        name: "acost",
        source: "Lai, Guo 2014",
        meaning: "all rules of ACOST: the same runs",
        numbers: &[("ants", 10.0), ("iterations", 50.0), ("beta", 25.0), ("move_limit", 0.0)],
        choices: all_rules!("acost", "dead_end" = "die"),
    },
    Preset {
        name: "acomsp",
        source: "Lai, Guo 2014",
        meaning: "all rules of ACOMSP: the same runs",
        numbers: &[("ants", 10.0), ("iterations", 50.0), ("beta", 15.0), ("move_limit", 0.0)],
        choices: all_rules!("acomsp", "dead_end" = "die"),
    },
    Preset {
        name: "fwa-aco",
        source: "Zhou, Mu, Zhang 2019",
        meaning: "all rules of the fireworks hybrid: the same runs",
        numbers: &[("iterations", 50.0), ("alpha", 2.0), ("beta", 8.0), ("rho", 0.1)],
        choices: all_rules!("fwa-aco", "heuristic" = "goal"),
    },
    Preset {
        name: "pso-aco",
        source: "named by Zhou, Mu, Zhang 2019",
        meaning: "all rules of the particle hybrid: the same runs",
        numbers: &[("iterations", 50.0), ("alpha", 2.0), ("beta", 8.0), ("rho", 0.1)],
        choices: all_rules!("pso-aco", "heuristic" = "goal"),
    },
];

/// The composer in the catalog.
pub const ENTRY: Entry = Entry {
    id: "custom",
    name: "Build your own ant",
    family: Family::AntColony,
    summary: "Every rule of a colony by the name of the planner that it is taken from: compose, or replace one rule to see what it contributes.",
    source: "the planners that lend the rules",
    presets: PRESETS,
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::InitialTrail, Layer::Density],
    max_goals: MAX_GOALS as u32,
    specs,
    build,
};
