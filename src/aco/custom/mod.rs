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
//! | update, and what makes a path the best | the planner named by `update_of` |
//! | daemon actions | the planner named by `daemon_of`; refinement: by `refinement_of` |
//!
//! Nothing is written twice: a donor is the planner's own variant, made from the same numbers, and lends one of its hooks. So a planner's
//! rules taken together are that planner, bit for bit: each preset repeats its runs (tested), and what one rule contributes is seen by
//! replacing it (ablation). Random numbers are those of the planner that lends the selection rule, so that two compositions with one
//! selection rule are paired runs.
//!
//! Rows of this file have the meaning and range that all donors share; every other row is a donor's own, and says when it has an effect,
//! unless more than one rule needs it, or the order of several goals.

mod donors;
mod rows;

use std::sync::Arc;

use super::criterion::Judge;
use super::hybrid::Hybrid;
use super::legs::{self, OrderLevel};
use super::papers::fire::FireParams;
use super::shared_params::settings;
use super::trails::{Row, Trails};
use super::variant::{Abreast, Iteration, Settings, Step, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction};
use crate::params::{Values, check_keys};
use crate::path::{Path, Refinement};
use crate::planner::{Family, Ground, Layer, Planner, PlannerEntry};
use crate::rng::Stream;
use crate::scenario::{MAX_GOALS, Scenario};

use donors::{Donors, all, lent, pick};
use rows::{PRESETS, specs};

pub use donors::Donor;
pub use rows::CustomParams;

/// A composed colony. The constants are those of [`Variant`]: how its ants may walk follows from the rules.
#[derive(Debug, Clone)]
pub struct Custom<const LOCK_STEP: bool, const TIMED: bool> {
    rules: CustomParams,
    donors: Donors,
}

impl<const LOCK_STEP: bool, const TIMED: bool> Variant for Custom<LOCK_STEP, TIMED> {
    const LOCK_STEP: bool = LOCK_STEP;
    const TIMED: bool = TIMED;

    fn settings(&self) -> Settings {
        let p = &self.rules;
        settings(p.ants, p.rho, 1.0, &p.selection, &p.walk)
    }

    fn initial_trail(&self, scenario: &Scenario) -> f64 {
        lent!(self, initial_trail_of, initial_trail(scenario))
    }

    fn prepare(&mut self, scenario: &Scenario) {
        all!(self.donors, prepare(scenario));
    }

    fn take_seed(&mut self, found: Option<&(Path, f64)>) {
        all!(self.donors, take_seed(found));
    }

    fn shape_trails(&self, scenario: &Scenario, trails: &mut Trails) {
        lent!(self, initial_trail_of, shape_trails(scenario, trails));
    }

    fn begin_iteration(&mut self, number: u32) {
        all!(self.donors, begin_iteration(number));
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        lent!(self, heuristic_of, heuristic(scenario, i, d, j))
    }

    fn enters_goal(&self) -> bool {
        lent!(self, heuristic_of, enters_goal())
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

    fn abreast(&self) -> Abreast {
        lent!(self, selection_of, abreast())
    }

    #[inline(always)]
    fn choose(&self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        lent!(self, selection_of, choose(weights, stream))
    }

    fn odds(&self, weights: &Row) -> Vec<f64> {
        lent!(self, selection_of, odds(weights))
    }

    fn on_move(&self, trails: &mut Trails, step: Step) {
        lent!(self, local_update_of, on_move(trails, step));
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        lent!(self, update_of, update_trails(trails, iteration));
    }

    fn criterion(&self) -> Judge {
        lent!(self, update_of, criterion())
    }

    fn refinement(&self) -> Refinement {
        lent!(self, refinement_of, refinement())
    }

    fn daemon_actions(&mut self, trails: &mut Trails, iteration: Iteration) {
        lent!(self, daemon_of, daemon_actions(trails, iteration));
    }
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
    Ok(match (rules.local_update_of.updates_on_moves(), rules.heuristic_of.is_timed()) {
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
    if scenario.goals.len() == 1 { rules.initial_trail_of.stage_before(scenario, values, seed) } else { Ok(None) }
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
        let streams = (custom.rules.selection_of.id(), ENTRY.layers);
        match self.first {
            None => legs::planner(self.scenario, self.level, custom, streams, self.seed),
            Some(first) => Box::new(Hybrid::new(Arc::clone(self.scenario), first, custom, streams, self.seed)),
        }
    }
}

/// The composer in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "custom",
    name: "Build your own ant",
    family: Family::AntColony,
    summary: "Every rule of a colony by the name of the planner that it is taken from: compose, or replace one rule to see what it contributes.",
    source: "the planners that lend the rules",
    presets: PRESETS,
    components: &[],
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::InitialTrail, Layer::Density],
    max_goals: MAX_GOALS as u32,
    grounds: Ground::NEIGHBOURS,
    specs,
    build,
};
