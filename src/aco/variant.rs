//! What a publication may change: the override points of a colony, whose defaults are Ant System.

use std::sync::Arc;

use crate::map::{Cell, Direction};
use crate::path::{Path, PathKind, Refinement};
#[cfg(feature = "whole")]
use crate::planner::Certificate;
use crate::planner::{Layer, Solution, Status};
use crate::rng::{Stream, Streams};
use crate::scenario::Scenario;

use super::ant::Ant;
use super::criterion::Judge;
use super::dead_end::DeadEnd;
use super::deposit;
use super::odds;
use super::selection::random_proportional;
use super::trails::{Row, Trails};

/// Numbers that every colony has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// m, ants per iteration.
    pub ants: u32,
    /// Budget of iterations.
    pub iterations: u32,
    /// Iterations without improvement after which the colony stops; 0 = never.
    pub stagnation: u32,
    /// α, weight of the trail.
    pub alpha: f64,
    /// β, weight of the heuristic.
    pub beta: f64,
    /// ρ, the part of the trail that leaves in each iteration.
    pub rho: f64,
    /// Q of the deposit Q/L.
    pub deposit: f64,
    /// At a dead end.
    pub dead_end: DeadEnd,
    /// Cap on an ant's moves, in multiples of width + height; 0 = none.
    pub move_limit: f64,
}

/// What stands at the end of an iteration.
#[derive(Debug, Clone, Copy)]
pub struct Iteration<'a> {
    /// The scenario.
    pub scenario: &'a Scenario,
    /// All ants, in index order; lost ones have no length.
    pub ants: &'a [Ant],
    /// t, from 1.
    pub number: u32,
    /// T, the budget.
    pub budget: u32,
    /// The best path of all iterations, this one included.
    pub best_so_far: Option<&'a Solution>,
    /// Where random numbers come from that are no ant's: [`Streams::daemon`].
    pub streams: Streams,
}

impl<'a> Iteration<'a> {
    /// The arrived ant with the shortest way; the first of equals.
    pub fn iteration_best(&self) -> Option<(&'a Ant, f64)> {
        self.arrived().reduce(|best, next| if next.1 < best.1 { next } else { best })
    }

    /// The arrived ant with the longest way; the first of equals.
    pub fn iteration_worst(&self) -> Option<(&'a Ant, f64)> {
        self.arrived().reduce(|worst, next| if next.1 > worst.1 { next } else { worst })
    }

    /// The arrived ants with their lengths, in index order.
    pub fn arrived(&self) -> impl Iterator<Item = (&'a Ant, f64)> + use<'a> {
        self.ants.iter().filter_map(|ant| ant.length().map(|length| (ant, length)))
    }
}

/// One step of an ant, for a local update.
#[derive(Debug, Clone, Copy)]
pub struct Step {
    /// From this cell …
    pub from: Cell,
    /// … in this direction.
    pub direction: Direction,
    /// Length of the ant's way in cells, this step included.
    pub walked: f64,
}

/// Where an ant stands and how it came there, for [`Variant::heed`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Standing {
    /// The cell.
    pub at: Cell,
    /// The step that led there; none at the start.
    pub last: Option<Direction>,
    /// Length of its way in cells, on weighted ground its cost.
    pub walked: f64,
}

impl Standing {
    /// Of this ant.
    pub fn of(ant: &Ant) -> Self {
        Self { at: ant.cell(), last: ant.steps().last().copied(), walked: ant.walked() }
    }

    /// At this cell, come from nowhere.
    pub fn at(at: Cell) -> Self {
        Self { at, last: None, walked: 0.0 }
    }
}

/// The rules of selection that four ants can follow at once, in SIMD lanes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Abreast {
    /// The random proportional rule.
    Proportional,
    /// The pseudo-random proportional rule, with this q0.
    PseudoProportional(f64),
    /// The step of the largest weight.
    Maximal,
    /// None of these: each ant by itself.
    Never,
}

/// What a search adds to an iteration of ants; see [`Variant::solve`].
#[derive(Debug, Clone, PartialEq)]
pub struct Solved {
    /// A path from start to goal that is better than the best so far by the criterion, with its length in cells.
    pub found: Option<(Path, f64)>,
    /// Cells that were expanded since the iteration before.
    pub expansions: u64,
    /// How the colony has ended by that, if it has.
    pub status: Option<Status>,
}

/// A variant of the colony. Every default is Ant System.
pub trait Variant: Clone + Send + Sync {
    /// Whether ants change trails while they walk, each on the step that it has just taken: then all of them move in lock step, one move
    /// each in index order. Otherwise each ant's walk depends on its own stream alone, and ants may walk in any order, four at a time.
    const LOCK_STEP: bool = false;

    /// Whether ln η(t) = a + b·w(t), given by [`Variant::log_heuristic`] and [`Variant::time`]. Then an η that changes in every
    /// iteration is computed only where ants come by.
    const TIMED: bool = false;

    /// Whether the colony goes on with what it has learnt when walls have changed; otherwise it begins anew.
    const ADAPTS: bool = true;

    /// Whether an ant weighs its steps by its own way as well: [`Variant::heed`]. Then it walks by itself, not in SIMD lanes.
    const HEEDS: bool = false;

    /// The common numbers.
    fn settings(&self) -> Settings;

    /// τ of every step before the first iteration.
    fn initial_trail(&self, scenario: &Scenario) -> f64;

    /// η of the step from `i` in direction `d` to `j`; positive and finite.
    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64;

    /// Before the first iteration.
    fn prepare(&mut self, _scenario: &Scenario) {}

    /// The scenario whose paths are asked for, where ants walk on another one.
    fn asked(&self) -> Option<&Scenario> {
        None
    }

    /// The same rules for another scenario, a leg of a tour, and the scenario on which its ants walk.
    fn of_leg(&self, leg: &Arc<Scenario>) -> (Arc<Scenario>, Self) {
        (Arc::clone(leg), self.clone())
    }

    /// Takes in the best path of the stage before, with its length in cells, if that has found one; only hybrids have such a stage
    /// ([`super::hybrid`]).
    fn take_seed(&mut self, _found: Option<&(Path, f64)>) {}

    /// What the trails are before the first iteration beyond [`Variant::initial_trail`], e.g. more along a path that is known already.
    fn shape_trails(&self, _scenario: &Scenario, _trails: &mut Trails) {}

    /// Before the ants of iteration `number` (from 1) start: what depends on the time.
    fn begin_iteration(&mut self, _number: u32) {}

    /// Whether an ant beside the goal takes the step onto it without a choice, where it is allowed; not with [`Variant::TIMED`].
    fn enters_goal(&self) -> bool {
        false
    }

    /// Whether η differs from the iteration before (iterations count from 1).
    fn heuristic_changes(&self, iteration: u32) -> bool {
        iteration == 1
    }

    /// (a, b) of ln η(t) = a + b·w(t), the same η as by [`Variant::heuristic`]; only with [`Variant::TIMED`].
    fn log_heuristic(&self, _scenario: &Scenario, _i: Cell, _d: Direction, _j: Cell) -> (f64, f64) {
        (0.0, 0.0)
    }

    /// w(t) of the iteration at work; only with [`Variant::TIMED`].
    fn time(&self) -> f64 {
        0.0
    }

    /// The rule of [`Variant::choose`], where ants can choose by it side by side.
    #[inline(always)]
    fn abreast(&self) -> Abreast {
        Abreast::Proportional
    }

    /// Has the weights of the steps that are left follow the ant's own way. Where a step is left, it leaves one; only with
    /// [`Variant::HEEDS`].
    #[inline(always)]
    fn heed(&self, _scenario: &Scenario, _weights: &mut Row, _ant: Standing) {}

    /// The step of an ant, given the weights of those that are left to it: by [`Variant::choose`], after [`Variant::heed`].
    #[inline(always)]
    fn step_of(&self, scenario: &Scenario, weights: &Row, ant: &mut Ant) -> Option<Direction> {
        if !Self::HEEDS {
            return self.choose(weights, &mut ant.stream);
        }
        let mut heeded = *weights;
        self.heed(scenario, &mut heeded, Standing::of(ant));
        self.choose(&heeded, &mut ant.stream)
    }

    /// Selects a step; visited and infeasible ones weigh 0. `None` = dead end.
    #[inline(always)]
    fn choose(&self, weights: &Row, stream: &mut Stream) -> Option<Direction> {
        random_proportional(weights, stream)
    }

    /// With which probability [`Variant::choose`] selects each step.
    fn odds(&self, weights: &Row) -> Vec<f64> {
        odds::random_proportional(weights)
    }

    /// After a step of an ant (only with [`Variant::LOCK_STEP`]): may change the trail of this step, and no other.
    fn on_move(&self, _trails: &mut Trails, _step: Step) {}

    /// After the ants of an iteration, before trails change: what a search makes of their ways.
    fn solve(&mut self, _iteration: Iteration) -> Option<Solved> {
        None
    }

    /// At the end of an iteration: evaporate, then every arrived ant deposits Q/L.
    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        let settings = self.settings();
        trails.evaporate(settings.rho);
        deposit::ant_cycle(trails, iteration.scenario, iteration.ants, settings.deposit);
    }

    /// What makes one finished path better than another.
    fn criterion(&self) -> Judge {
        Judge::Length
    }

    /// What the best path is, unless it is refined: a polyline where [`Variant::solve`] finds polylines, of which an ant's way is one too.
    fn path_kind(&self) -> PathKind {
        PathKind::Steps
    }

    /// How the best path is refined by line of sight; a refined path is measured as a polyline.
    fn refinement(&self) -> Refinement {
        Refinement::None
    }

    /// What no single ant could do: reinitialise…
    fn daemon_actions(&mut self, _trails: &mut Trails, _iteration: Iteration) {}

    /// Writes a layer of its own (one value a cell, row by row; `out` holds zeros); false where it has no such layer.
    fn show(&self, _scenario: &Scenario, _kind: Layer, _out: &mut [f32]) -> bool {
        false
    }

    /// What it has proven of the best path.
    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        None
    }

    /// What it holds in bytes, its own size not counted.
    fn bytes(&self) -> usize {
        0
    }
}
