//! Best-Worst Ant System: Cordón, Fernández de Viana, Herrera, Moreno, "A new ACO model integrating evolutionary computation concepts: the
//! best-worst ant system", Proc. ANTS 2000, Brussels, 22–29; numbers after Stützle's program ACOTSP, which has this system as well.
//!
//! | override point | source |
//! |---|---|
//! | initial trail | ACOTSP's 1 / (n·C), here 1 / (n·L_open) |
//! | heuristic | as Ant System |
//! | selection | as Ant System |
//! | on each move | nothing |
//! | update | best-worst rule: evaporate, 1/L_bs on the best-so-far path; steps of the iteration's worst that are not on it evaporate again |
//! | daemon actions | trails start again at τ0 where best and worst are nearly alike; otherwise some mutate by ± mut(t) |
//! | mutation | mut(t) = σ·τ_mean·(t − t_r) / (T − t_r), τ_mean over the best-so-far path, t_r = last restart |
//!
//! The publication itself was not at hand: rules and numbers are those of ACOTSP, which names it as their source.
//!
//! Where these are silent on paths, we do as in [`super::ant_system`], and:
//! - take L_open and its number of steps n, on an open map, for the nearest-neighbour tour C and its cities;
//! - a row of the matrix is a cell: with probability P_m one of its allowed steps, each alike, gains or loses mut(t), each alike;
//! - best and worst differ by the share of the worst path's steps that are not on the best; the worst is the longest that arrived, and
//!   where fewer than two ants arrive there is none;
//! - trails stay above 0; the best path so far is kept when trails start again.

use std::sync::Arc;

use rand::Rng;

use crate::aco::ant::Ant;
use crate::aco::colony::Colony;
use crate::aco::deposit;
use crate::aco::shared_params::{SelectionParams, SightParams, WalkParams, open_map_length, open_map_steps, settings};
use crate::aco::trails::Trails;
use crate::aco::variant::{Iteration, Settings, Variant};
use crate::error::ParamError;
use crate::map::{Cell, Direction};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Component, Family, Ground, Layer, Planner, PlannerEntry};
use crate::rng::{Stream, unit_f32};
use crate::scenario::Scenario;

params! {
    /// Parameters of Best-Worst Ant System.
    pub struct BestWorstAntSystemParams {
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "papers' common value; the book takes m = n cities";
        ..selection: SelectionParams;
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.1, "ρ", [0.0..=1.0], "", "Stützle's program ACOTSP";
        /// whether the iteration's worst path evaporates once more where the best path so far does not go
        worst_evaporates: bool = true, "", [], "", "Stützle's program ACOTSP";
        /// probability that one step of a cell gains or loses trail in an iteration
        mutation_probability: f64 = 0.3, "P_m", [0.0..=1.0], "", "Stützle's program ACOTSP";
        /// how much trail a mutation brings at the end of the run, in mean trails of the best path so far
        mutation_strength: f64 = 4.0, "σ", [0.0..=100.0], "", "Stützle's program ACOTSP";
        /// all trails start again where less than this part of the worst path's steps is not on the best; 0 = never
        restart_below: f64 = 0.05, "", [0.0..=1.0], "", "Stützle's program ACOTSP";
        ..sight: SightParams;
        ..walk: WalkParams;
    }
}

/// Best-Worst Ant System.
#[derive(Debug, Clone, Copy)]
pub struct BestWorstAntSystem {
    params: BestWorstAntSystemParams,
    /// t_r, the iteration after which trails started again last; 0 = at the beginning.
    restarted: u32,
}

impl BestWorstAntSystem {
    /// With these parameters.
    pub fn new(params: BestWorstAntSystemParams) -> Self {
        Self { params, restarted: 0 }
    }

    /// mut(t), for a best path whose trail is `mean` on average.
    pub fn mutation(&self, mean: f64, t: u32, budget: u32) -> f64 {
        let (since, all) = (t - self.restarted, budget - self.restarted);
        self.params.mutation_strength * mean * f64::from(since) / f64::from(all)
    }
}

/// The iteration's worst ant, and its steps that are not on the best path so far.
fn apart<'a>(iteration: &Iteration<'a>) -> Option<(&'a Ant, Vec<(Cell, Direction)>)> {
    let (scenario, best) = (iteration.scenario, iteration.best_so_far?);
    let (worst, _) = iteration.iteration_worst().filter(|_| iteration.arrived().nth(1).is_some())?;
    let mut on_best: Vec<_> = best.path.windows(2).map(|s| (s[0], scenario.moves.direction(s[0], s[1]))).collect();
    on_best.sort_unstable();
    let mut at = scenario.start;
    let steps = worst.steps().iter().map(|&d| {
        let from = at;
        at = scenario.moves.step(from, d);
        (from, d)
    });
    Some((worst, steps.filter(|step| on_best.binary_search(step).is_err()).collect()))
}

/// Mean trail of a path's steps.
fn mean_trail(trails: &Trails, scenario: &Scenario, path: &[Cell]) -> f64 {
    let sum: f64 = path.windows(2).map(|s| trails.get(s[0], scenario.moves.direction(s[0], s[1]))).sum();
    sum / f64::from(path.len().saturating_sub(1).max(1) as u32)
}

/// One of a cell's allowed steps gains or loses `amount`, cell by cell with this probability; draws once a cell, and twice where it mutates.
fn mutate(trails: &mut Trails, scenario: &Scenario, probability: f64, amount: f64, stream: &mut Stream) {
    for cell in (0..scenario.grid.len() as Cell).filter(|&c| scenario.moves.bits[c as usize] != 0) {
        if f64::from(unit_f32(stream.next_u32())) >= probability {
            continue;
        }
        let (draw, options) = (stream.next_u32(), scenario.moves.directions(cell).count());
        // The lowest bit decides the sign, the upper 24 the step.
        let chosen = (unit_f32(draw) * options as f32) as usize;
        let Some(direction) = scenario.moves.directions(cell).nth(chosen) else { continue };
        if draw & 1 == 0 {
            trails.deposit(cell, direction, amount);
        } else {
            trails.withdraw(cell, direction, amount, 0.0);
        }
    }
}

impl Variant for BestWorstAntSystem {
    fn settings(&self) -> Settings {
        let p = &self.params;
        settings(p.ants, p.rho, 1.0, &p.selection, &p.walk)
    }

    fn initial_trail(&self, scenario: &Scenario) -> f64 {
        1.0 / (f64::from(open_map_steps(scenario)) * open_map_length(scenario))
    }

    fn heuristic(&self, scenario: &Scenario, i: Cell, d: Direction, j: Cell) -> f64 {
        self.params.sight.heuristic.of(scenario, i, d, j)
    }

    fn update_trails(&mut self, trails: &mut Trails, iteration: Iteration) {
        trails.evaporate(self.params.rho);
        let Some(best) = iteration.best_so_far else { return };
        deposit::along_path(trails, iteration.scenario, &best.path, 1.0 / best.length);
        let worst = apart(&iteration).filter(|_| self.params.worst_evaporates);
        for (cell, direction) in worst.into_iter().flat_map(|(_, steps)| steps) {
            trails.blend(cell, direction, self.params.rho, 0.0);
        }
    }

    fn daemon_actions(&mut self, trails: &mut Trails, iteration: Iteration) {
        let (p, scenario) = (self.params, iteration.scenario);
        let Some(best) = iteration.best_so_far else { return };
        let alike = |(worst, steps): (&Ant, Vec<_>)| (steps.len() as f64) < p.restart_below * worst.steps().len() as f64;
        if apart(&iteration).is_some_and(alike) {
            trails.reset(self.initial_trail(scenario));
            self.restarted = iteration.number;
        } else if p.mutation_probability > 0.0 {
            let amount = self.mutation(mean_trail(trails, scenario, &best.path), iteration.number, iteration.budget);
            mutate(trails, scenario, p.mutation_probability, amount, &mut iteration.streams.daemon(iteration.number));
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let variant = BestWorstAntSystem::new(BestWorstAntSystemParams::read(ENTRY.id, values)?);
    Ok(Box::new(Colony::new(Arc::clone(scenario), variant, ENTRY.id, seed, 0)))
}

/// Best-Worst Ant System in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "best-worst-ant-system",
    name: "Best-Worst Ant System",
    family: Family::AntColony,
    summary: "The best path so far gains pheromone, the iteration's worst loses some, and trails mutate at random, the more the later.",
    source: "Cordón, Fernández de Viana, Herrera, Moreno 2000, Proc. ANTS 2000, 22–29",
    presets: &[],
    components: &[
        Component {
            id: "worst-path-evaporates",
            name: "worst path evaporates",
            adds: "the iteration's worst path evaporates once more where the best does not go; without: as everywhere",
            without: &[("worst_evaporates", "false")],
        },
        Component {
            id: "mutation",
            name: "mutation of trails",
            adds: "trails gain or lose at random, the more the later in the run; without: they do not",
            without: &[("mutation_probability", "0")],
        },
        Component {
            id: "restart-when-alike",
            name: "restart when alike",
            adds: "all trails start again where best and worst path are nearly alike; without: never",
            without: &[("restart_below", "0")],
        },
    ],
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: BestWorstAntSystemParams::specs,
    build,
};
