//! Formica, a colony of our own: ants find where good paths may lie, an exact search puts their ways together and proves the best.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | 0.5, as in the hyper-cube framework: Blum, Dorigo 2004 |
//! | heuristic | η = exp(−κ·detour), the detour by scent: `scent.rs`, ours |
//! | selection | random proportional, as Ant System |
//! | on each move | nothing |
//! | solve | merge and solve, after Construct, Merge, Solve & Adapt: Blum, Pinacho, López-Ibáñez, Lozano 2016; `merge.rs` |
//! | update | τ ← (1 − ρ)·τ, + ρ on the path that the search has found, limits: hyper-cube framework |
//! | daemon actions | trails start again where nothing shorter is found, as MAX–MIN Ant System |
//! | end | a proof: A* over the whole map, bounded by the best length, on what merging has expanded; ours |
//! | several goals | their order by ants, merged and proven by 1-trees: `../order_solve.rs`; then the same for each leg |
//!
//! - Blum, Pinacho, López-Ibáñez, Lozano, "Construct, Merge, Solve & Adapt: a new general algorithm for combinatorial optimization", Computers
//!   and Operations Research 68 (2016) 75–88, doi:10.1016/j.cor.2015.10.014. There components that the solver does not use grow old and leave;
//!   here none leaves, because what was searched costs nothing any more.
//! - Blum, Dorigo, "The hyper-cube framework for ant colony optimization", IEEE Transactions on Systems, Man, and Cybernetics B 34 (2004)
//!   1161–1172, doi:10.1109/TSMCB.2003.821450.
//!
//! By `criterion` it is the turn index V or the weighted sum J that ants are judged by, and that is searched for and proven, over states of a cell
//! and a direction. The scent stays the length's: η is a hint, no bound.
//!
//! With 16 moves ants walk by 8 of them and the search by all: a step of two cells deposits on the two steps that it stands for.
//!
//! With `paths = polylines` the search is that of `any-angle`, and a polyline deposits on the steps along it: `straight.rs`.

mod inside;
mod learnt;
pub mod merge;
mod params;
pub mod scent;
mod straight;

use std::sync::Arc;

use crate::aco::colony::leader;
#[cfg(feature = "whole")]
use crate::aco::criterion::Criterion;
use crate::aco::criterion::{Judge, way};
use crate::aco::legs;
use crate::aco::shared_params::settings;
use crate::aco::trails::Trails;
use crate::aco::variant::{Iteration, Settings, Solved, Variant};
use crate::error::ParamError;
use crate::exact::Estimate;
#[cfg(feature = "whole")]
use crate::exact::any_angle::MOST_CELLS;
use crate::map::{Cell, Direction, MoveSet, Moves};
use crate::metrics::SAME_LENGTH;
#[cfg(feature = "whole")]
use crate::params::ParamChoice;
use crate::params::{Params, Values};
use crate::path::{Path, PathKind};
#[cfg(feature = "whole")]
use crate::planner::Certificate;
use crate::planner::{Component, Family, Ground, Layer, Planner, PlannerEntry, Status, held};
use crate::scenario::{MAX_GOALS, Scenario};

use learnt::Learnt;
pub use params::{FormicaParams, Paths};
use scent::Scent;

/// Trails before the first iteration and after a restart, and their limits.
pub(super) const TRAIL: f64 = 0.5;
pub(super) const LIMITS: (f64, f64) = (0.001, 0.999);

/// The colony's rules, and what they have learnt of one scenario.
#[derive(Clone)]
pub struct Formica {
    params: FormicaParams,
    /// With all its steps; ants walk on one with steps to neighbours alone.
    scenario: Arc<Scenario>,
    /// None before the first iteration.
    learnt: Option<Learnt>,
}

impl Formica {
    /// On this scenario.
    pub fn new(params: FormicaParams, scenario: Arc<Scenario>) -> Self {
        Self { params, scenario, learnt: None }
    }

    /// Proves what stands after an iteration, if it is time; takes in a better path with its value. How the colony has ended by that.
    fn prove(&mut self, iteration: &Iteration, found: &mut Option<(Path, f64)>) -> Option<Status> {
        let is_last = self.is_last(iteration);
        let most = self.params.proof_limit * f64::from(self.scenario.grid.len() as u32);
        let learnt = self.learnt.as_mut().filter(|_| most > 0.0)?;
        if !learnt.merge.is_proven() && is_last {
            let better = learnt.merge.prove(learnt.best, most as u64).filter(|(_, value)| *value < learnt.best - SAME_LENGTH);
            if let Some((_, value)) = better {
                (learnt.best, learnt.since) = (value, iteration.number);
                *found = better;
            }
        }
        match (learnt.merge.is_proven(), is_last) {
            (true, _) => Some(Status::Optimal),
            // Without any path the ants go on; merging has the whole map by then.
            (false, true) if learnt.best.is_finite() || iteration.number >= iteration.budget => Some(Status::BudgetSpent),
            (false, _) => None,
        }
    }

    /// Whether the iteration is the last one that ants walk: the budget is spent, or nothing shorter was found for long enough.
    fn is_last(&self, iteration: &Iteration) -> bool {
        let since = self.learnt.as_ref().map_or(0, |learnt| learnt.since);
        let (p, waited) = (&self.params, iteration.number - since);
        let waits = |most: u32| most > 0 && waited >= most;
        iteration.number >= iteration.budget || waits(p.proof_after) || waits(p.walk.stagnation)
    }
}

impl Variant for Formica {
    const ADAPTS: bool = false;

    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.rho, 1.0, &p.selection, &p.walk)
    }

    fn initial_trail(&self, _scenario: &Scenario) -> f64 {
        TRAIL
    }

    fn asked(&self) -> Option<&Scenario> {
        Some(&self.scenario)
    }

    fn of_leg(&self, leg: &Arc<Scenario>) -> (Arc<Scenario>, Self) {
        (walked_on(leg), Self::new(self.params, Arc::clone(leg)))
    }

    fn prepare(&mut self, scenario: &Scenario) {
        self.learnt = Some(Learnt::new(&self.params, scenario, &self.scenario));
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        let Some(learnt) = &self.learnt else { return 1.0 };
        let straight = |c: Cell| learnt.open_map.to_goal(c % scenario.grid.width(), c / scenario.grid.width());
        let to_goal = |c| if self.params.scent { learnt.scent.of(c) } else { straight(c) };
        detour(self.params.kappa, scenario.moves.length(i, d) + to_goal(j) - to_goal(i))
    }

    fn criterion(&self) -> Judge {
        self.params.judge()
    }

    fn solve(&mut self, iteration: Iteration) -> Option<Solved> {
        let learnt = self.learnt.as_mut()?;
        let mut found = if self.params.merge {
            learnt.merge(&iteration, self.params.widening as u8)
        } else {
            learnt.path = leader(&iteration, learnt.criterion).map(|(ant, _)| way(iteration.scenario, ant)).unwrap_or_default();
            learnt.straighten(&iteration)
        };
        let value = found.as_ref().map(|f| f.1).or_else(|| learnt.value(&iteration));
        learnt.note(value.unwrap_or(f64::INFINITY), iteration.number);
        let status = self.prove(&iteration, &mut found);
        let expansions = self.learnt.as_mut().map_or(0, Learnt::take_expansions);
        let found = found.map(|(path, _)| {
            let length = self.scenario.path_length(&path);
            (path, length)
        });
        Some(Solved { found, expansions, status })
    }

    fn path_kind(&self) -> PathKind {
        match self.params.paths {
            Paths::Steps => PathKind::Steps,
            Paths::Polylines => PathKind::Polyline,
        }
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        trails.evaporate(self.params.rho);
        let path = self.learnt.iter().flat_map(|learnt| learnt.path.windows(2));
        for (from, direction) in path.flat_map(|step| steps(&iteration.scenario.moves, step[0], step[1])) {
            trails.deposit(from, direction, self.params.rho);
        }
        trails.limit(LIMITS.0, LIMITS.1);
    }

    fn daemon_actions(&mut self, trails: &mut Trails, iteration: Iteration) {
        let waited = iteration.number - self.learnt.as_ref().map_or(0, |learnt| learnt.since);
        let after = self.params.trail_restart;
        if after > 0 && waited > 0 && waited.is_multiple_of(after) {
            trails.reset(TRAIL);
        }
    }

    fn show(&self, scenario: &Scenario, kind: Layer, out: &mut [f32]) -> bool {
        match (kind, &self.learnt) {
            (Layer::Scent, Some(learnt)) => learnt.scent.show(out),
            (Layer::Scent, None) => Scent::new(scenario).show(out),
            (Layer::Merged, Some(learnt)) => {
                out.iter_mut().zip(learnt.merge.part()).for_each(|(v, &inside)| *v = f32::from(u8::from(inside)));
            }
            (Layer::Merged, None) => {}
            _ => return false,
        }
        true
    }

    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        let learnt = self.learnt.as_ref().filter(|learnt| self.params.proof_limit > 0.0 && learnt.best.is_finite())?;
        Some(learnt.merge.certificate(learnt.best))
    }

    fn bytes(&self) -> usize {
        self.learnt.as_ref().map_or(0, |learnt| learnt.scent.bytes() + learnt.merge.bytes() + held(&learnt.path))
    }
}

/// η of a step with this detour in cells, which rounding, or a scent that is no bound, may put below 0.
pub fn detour(kappa: f64, detour: f64) -> f64 {
    libm::exp(-kappa * detour.max(0.0))
}

/// The steps to neighbours that a step of a path stands for: itself or, where it takes two cells at once, the first two that lead there.
fn steps(moves: &MoveSet, from: Cell, to: Cell) -> Vec<(Cell, Direction)> {
    let straight = |from: Cell, to: Cell| moves.directions(from).find(|&d| moves.step(from, d) == to);
    if let Some(direction) = straight(from, to) {
        return vec![(from, direction)];
    }
    let by = |first: Direction| {
        let via = moves.step(from, first);
        straight(via, to).map(|second| vec![(from, first), (via, second)])
    };
    moves.directions(from).find_map(by).unwrap_or_default()
}

/// The scenario with steps to neighbours alone, on which ants walk.
fn walked_on(scenario: &Arc<Scenario>) -> Arc<Scenario> {
    if scenario.spec.movement.moves != Moves::Sixteen {
        return Arc::clone(scenario);
    }
    let mut near = Scenario { moves: scenario.moves.to_neighbours(), ..(**scenario).clone() };
    near.spec.movement.moves = Moves::Eight;
    Arc::new(near)
}

/// Refuses what the search for polylines does not know: any ground but a plane, several goals, another criterion than length, and what is
/// larger than `any-angle` takes.
#[cfg(feature = "whole")]
fn takes_polylines(scenario: &Scenario, criterion: Judge) -> Result<(), ParamError> {
    let ground = Ground::all_of(scenario).find(|&ground| ground != Ground::Plane).map(Ground::words);
    let goals = (scenario.goals.len() > 1).then_some(("several-goals", "to several goals"));
    let by = (criterion != Judge::Length).then_some(("criterion", "by another criterion than length"));
    if let Some((id, words)) = ground.or(goals).or(by) {
        let (key, value, instead) = ("paths", "polylines", "steps");
        return Err(ParamError::ValueOnGround { key, value, ground: words, id, instead });
    }
    let (width, height) = (scenario.grid.width(), scenario.grid.height());
    if scenario.grid.len() > MOST_CELLS {
        let most = MOST_CELLS as u32;
        return Err(ParamError::MapTooLarge { planner: ENTRY.id.into(), width, height, most, instead: "theta-star" });
    }
    Ok(())
}

/// A criterion as people write it, unless it is the length.
#[cfg(feature = "whole")]
fn other_than_length(criterion: Criterion) -> Option<&'static str> {
    Criterion::OPTIONS.iter().find(|option| option.0 == criterion && criterion != Criterion::Length).map(|option| option.1)
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let params = FormicaParams::read(ENTRY.id, values)?;
    #[cfg(feature = "whole")]
    if let Some(value) = other_than_length(params.criterion).filter(|_| scenario.goals.len() > 1) {
        // What is proven of an order is proven of lengths.
        let (key, instead) = ("criterion", "length");
        return Err(ParamError::ValueOnGround { key, value, ground: "to several goals", id: "several-goals", instead });
    }
    #[cfg(feature = "whole")]
    if params.paths == Paths::Polylines {
        takes_polylines(scenario, params.judge())?;
    }
    let variant = Formica::new(params, Arc::clone(scenario));
    Ok(legs::planner(scenario, params.order_level(), variant, (ENTRY.id, ENTRY.layers), seed))
}

/// Merging, as a part of every planner that has it.
pub(super) const MERGE: Component = Component {
    id: "merge-and-solve",
    name: "merge and solve",
    adds: "a search puts the ways of the ants together; without: the best way of ants takes the deposit",
    without: &[("merge", "false")],
};

/// The proof, as a part of every planner that has it.
pub(super) const PROOF: Component = Component {
    id: "proof",
    name: "proof",
    adds: "a search wherever something better may be proves the best path, or finds a better one; without: the best path is what was found",
    without: &[("proof_limit", "0")],
};

/// Formica in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "formica",
    name: "Formica",
    family: Family::AntColony,
    summary: "Ants smell the way around walls, an exact search puts their ways together, and the best path is proven.",
    source: "our own; merging after Blum, Pinacho, López-Ibáñez, Lozano 2016, Comput. Oper. Res. 68, 75–88, doi:10.1016/j.cor.2015.10.014",
    presets: &[],
    components: &[
        Component {
            id: "scent",
            name: "scent",
            adds: "ants smell how far the goal is around walls; without: they know how far it is on an open map",
            without: &[("scent", "false")],
        },
        MERGE,
        Component {
            id: "adaptive-corridor",
            name: "adaptive corridor",
            adds: "the search looks farther around the best path while nothing shorter is found; without: always as far",
            without: &[("adaptive_corridor", "false")],
        },
        Component {
            id: "restarts",
            name: "restarts of trails",
            adds: "trails start again where nothing shorter is found; without: never",
            without: &[("trail_restart", "0")],
        },
        PROOF,
    ],
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::Scent, Layer::Merged],
    max_goals: MAX_GOALS as u32,
    grounds: Ground::STEPS,
    specs: FormicaParams::specs,
    build,
};
