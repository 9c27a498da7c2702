//! The one skeleton of every colony: construct solutions, update trails, daemon actions.

#[cfg(feature = "whole")]
mod adapt;
mod moves;
mod tables;
mod view;

use std::num::NonZero;
use std::ops::Range;
use std::sync::Arc;

use wide::bytemuck::cast;

use crate::map::Cell;
use crate::metrics::SAME_LENGTH;
use crate::path::{PathKind, Refinement, refine};
#[cfg(feature = "whole")]
use crate::planner::Certificate;
use crate::planner::{
    Fate, Granularity, Iterations, Layer, MoveOdds, Objective, Planner, Progress, Record, Refined, Solution, Status, Tally, Turn,
    Walked, Weighed, advance,
};
use crate::rng::Streams;
#[cfg(feature = "whole")]
use crate::scenario::Change;
use crate::scenario::Scenario;

use super::ant::{Ant, Walk};
use super::criterion::{Judge, way};
use super::lane_rules::{Maximal, Proportional, PseudoProportional};
use super::lanes;
use super::selection::left;
use super::threads;
use super::trails::{Row, Trails};
use super::variant::{Abreast, Iteration, Settings, Solved, Standing, Step, Variant};
use super::visibility::{Eta, Sight};
use super::weights::{self, Weights};

use tables::{Kind, Tables};

/// A colony at work on one scenario.
#[derive(Clone)]
pub struct Colony<V> {
    scenario: Arc<Scenario>,
    variant: V,
    settings: Settings,
    streams: Streams,
    max_moves: u32,
    tables: Option<Tables>,
    /// An iteration has begun and not ended.
    constructing: bool,
    progress: Progress,
    /// On which ants walk.
    threads: NonZero<usize>,
    /// The last iteration in which η was another one than before.
    seen_since: u32,
}

impl<V: Variant + 'static> Colony<V> {
    /// Whether its ants can walk on several threads.
    pub(super) const ON_THREADS: bool = cfg!(not(target_arch = "wasm32")) && !V::LOCK_STEP && !V::TIMED;

    /// A colony of the planner with this id; `run` tells repeated runs of one comparison apart.
    pub fn new(scenario: Arc<Scenario>, variant: V, planner: &str, seed: u32, run: u32) -> Self {
        let settings = variant.settings();
        let (width, height) = (scenario.grid.width(), scenario.grid.height());
        let cap = settings.move_limit * f64::from(width + height);
        Self {
            scenario,
            variant,
            settings,
            streams: Streams::new(u64::from(seed), planner, run),
            max_moves: if settings.move_limit == 0.0 { u32::MAX } else { cap as u32 },
            tables: None,
            constructing: false,
            progress: Progress::default(),
            threads: NonZero::<usize>::MIN,
            seen_since: 0,
        }
    }

    /// Leaves it to somebody else to stop a colony that stagnates.
    pub(super) fn never_stagnates(mut self) -> Self {
        self.settings.stagnation = 0;
        self
    }

    /// The trails before the first iteration.
    fn initial_trails(&self) -> Trails {
        let mut trails = Trails::new(self.scenario.grid.len(), self.variant.initial_trail(&self.scenario));
        self.variant.shape_trails(&self.scenario, &mut trails);
        trails
    }

    /// One move of the walking ones among these ants, in index order; true when none of them is left.
    #[inline(always)]
    fn move_ants(&mut self, which: Range<usize>) -> bool {
        let Some(Tables { trails, weights, on_demand, ants }) = &mut self.tables else { return true };
        let walk = walk_rules(&self.scenario, &self.settings, self.max_moves);
        let eta = |i, d, j| self.variant.heuristic(&self.scenario, i, d, j);
        let sight = sight(&self.scenario, &self.variant, self.settings.beta, &eta);
        let choose = |weights: &Row, ant: &mut Ant| self.variant.step_of(&self.scenario, weights, ant);
        let mut done = true;
        for ant in ants[which].iter_mut().filter(|a| a.fate() == Fate::Walking) {
            let from = ant.cell();
            let step = if V::TIMED {
                lanes::move_one(&mut on_demand.now(&self.scenario, &self.variant, trails), &walk, ant, choose)
            } else if V::LOCK_STEP {
                let weights = weights.weigh_now(&sight, trails, from);
                let step = choose(&cast(left(&weights, ant.look_around())), ant);
                ant.go(&walk, step);
                step
            } else {
                lanes::move_one(&mut weights::Now { table: weights, trails, sight }, &walk, ant, choose)
            };
            if let Some(direction) = step
                && V::LOCK_STEP
            {
                self.variant.on_move(trails, Step { from, direction, walked: ant.walked() });
                if V::TIMED {
                    on_demand.outdate(trails);
                }
            }
            done &= ant.fate() != Fate::Walking;
        }
        done
    }
}

impl<V: Variant + 'static> Iterations for Colony<V> {
    fn parts(&mut self) -> (&mut Progress, &Scenario) {
        (&mut self.progress, self.variant.asked().unwrap_or(&self.scenario))
    }

    fn is_prepared(&self) -> bool {
        self.tables.is_some()
    }

    fn prepare(&mut self) {
        self.variant.prepare(&self.scenario);
        let trails = self.initial_trails();
        self.tables = Some(Tables::new(&self.scenario, &self.settings, trails, Kind::of::<V>(), self.streams));
    }

    fn begin_iteration(&mut self) {
        let Some(tables) = self.tables.as_mut().filter(|_| !self.constructing) else { return };
        let number = self.progress.effort.iterations + 1;
        self.variant.begin_iteration(number);
        let is_seen_anew = self.variant.heuristic_changes(number);
        if is_seen_anew {
            self.seen_since = number;
        }
        tables.take_in(Kind::of::<V>(), is_seen_anew);
        tables.place_ants(&self.scenario, self.streams, number);
        self.constructing = true;
    }

    /// One move of every walking ant, in index order; true when none is left.
    fn move_all(&mut self) -> bool {
        self.move_ants(0..self.settings.ants as usize)
    }

    /// Lets every ant walk to its end. Same walks as by [`Iterations::move_all`], in whatever order is fastest.
    fn move_to_the_end(&mut self) {
        if V::LOCK_STEP {
            while !self.move_all() {}
            return;
        }
        let Some(Tables { trails, weights, on_demand, ants }) = &mut self.tables else { return };
        let walk = walk_rules(&self.scenario, &self.settings, self.max_moves);
        if V::TIMED {
            let mut weights = on_demand.now(&self.scenario, &self.variant, trails);
            walk_to_the_end(&self.scenario, &self.variant, &mut weights, &walk, ants);
        } else {
            let eta = |i, d, j| self.variant.heuristic(&self.scenario, i, d, j);
            let sight = sight(&self.scenario, &self.variant, self.settings.beta, &eta);
            if Self::ON_THREADS && self.threads.get() > 1 {
                let (scenario, variant, known) = (&*self.scenario, &self.variant, &*weights);
                threads::each_part(ants, self.threads, |part| walk_to_the_end(scenario, variant, &mut &*known, &walk, part));
            }
            let mut weights = weights::Now { table: weights, trails, sight };
            walk_to_the_end(&self.scenario, &self.variant, &mut weights, &walk, ants);
        }
    }

    fn end_iteration(&mut self) {
        let Some(Tables { trails, ants, .. }) = &mut self.tables else { return };
        self.constructing = false;
        self.progress.effort.iterations += 1;
        self.progress.effort.constructed_paths += u64::from(self.settings.ants);
        self.progress.effort.ant_moves += ants.iter().map(|a| u64::from(a.moves())).sum::<u64>();
        let number = self.progress.effort.iterations;
        let (scenario, budget) = (&*self.scenario, self.settings.iterations);
        let iteration = Iteration { scenario, ants, number, budget, best_so_far: None, streams: self.streams };
        let criterion = self.variant.criterion();
        if let Some((ant, length)) = leader(&iteration, criterion)
            && self.progress.best.as_ref().is_none_or(|b| better(scenario, criterion, (ant, length), b))
        {
            let path = way(scenario, ant);
            let refined = refined(scenario, &path, self.variant.refinement());
            self.progress.best = Some(Solution { path, length, iteration: number, refined });
        }
        let solved = self.variant.solve(Iteration { best_so_far: self.progress.best.as_ref(), ..iteration });
        let ended = solved.as_ref().and_then(|solved| solved.status);
        let found = solved.and_then(|solved| take_solved(&mut self.progress, solved));
        let record = record(&Iteration { best_so_far: self.progress.best.as_ref(), ..iteration });
        self.progress.record(found.map_or(record, |length| record.with_found(length)));
        let iteration = Iteration { best_so_far: self.progress.best.as_ref(), ..iteration };
        self.variant.update_trails(trails, iteration);
        self.variant.daemon_actions(trails, iteration);
        let status = self.progress.after_iteration(budget, self.settings.stagnation);
        self.progress.status = ended.unwrap_or(status);
    }
}

/// Takes in what a search has added to the iteration that has just been counted; the length of a path that it has found.
#[inline(never)]
pub(super) fn take_solved(progress: &mut Progress, solved: Solved) -> Option<f64> {
    progress.effort.cell_expansions += solved.expansions;
    let (path, length) = solved.found?;
    progress.best = Some(Solution { path, length, iteration: progress.effort.iterations, refined: None });
    Some(length)
}

/// The rules of every walk, borrowed.
fn walk_rules<'a>(scenario: &'a Scenario, settings: &Settings, max_moves: u32) -> Walk<'a> {
    Walk { moves: &scenario.moves, goal: scenario.goal, dead_end: settings.dead_end, max_moves }
}

/// What ants of a variant see by this η, its own.
fn sight<'a, V: Variant>(scenario: &'a Scenario, variant: &V, beta: f64, eta: &'a Eta<'a>) -> Sight<'a> {
    Sight { scenario, eta, beta, enters_goal: variant.enters_goal() }
}

/// Every ant's walk, side by side.
fn walk_to_the_end<V: Variant, W: Weights>(scenario: &Scenario, variant: &V, weights: &mut W, walk: &Walk, ants: &mut [Ant]) {
    let whole = cfg!(feature = "whole");
    match variant.abreast() {
        _ if V::HEEDS => lanes::walk_all_by(weights, walk, ants, |weights, ant| variant.step_of(scenario, weights, ant)),
        Abreast::Proportional => lanes::walk_all(weights, walk, ants, Proportional),
        Abreast::PseudoProportional(q0) if !V::TIMED && whole => {
            lanes::walk_all(weights, walk, ants, PseudoProportional::new(q0))
        }
        Abreast::Maximal if !V::TIMED && whole => lanes::walk_all(weights, walk, ants, Maximal),
        _ => lanes::walk_all_by(weights, walk, ants, |weights, ant| variant.choose(weights, &mut ant.stream)),
    }
}

/// The arrived ant with the best way and its length; the first of equals.
#[inline(always)]
pub(super) fn leader<'a>(iteration: &Iteration<'a>, criterion: Judge) -> Option<(&'a Ant, f64)> {
    if criterion == Judge::Length {
        return iteration.iteration_best();
    }
    let judged = iteration.arrived().filter_map(|a| Some((a, criterion.of_ant(iteration.scenario, a.0)?)));
    judged.reduce(|best, next| if next.1 < best.1 { next } else { best }).map(|(arrived, _)| arrived)
}

/// Whether an arrived ant's way, of this length, is better than the best so far.
#[inline(always)]
fn better(scenario: &Scenario, criterion: Judge, (ant, length): (&Ant, f64), best: &Solution) -> bool {
    match criterion {
        Judge::Length => length < best.length,
        // Equal ones may differ by what rounding leaves of adding.
        Judge::TurnIndex | Judge::Weighted(_) => {
            let found = criterion.of_ant(scenario, ant).unwrap_or(f64::INFINITY);
            found < criterion.of_solution(scenario, best) - SAME_LENGTH
        }
    }
}

/// How far an ant has come.
fn walked(scenario: &Scenario, ant: &Ant) -> Walked {
    Walked { way: way(scenario, ant), fate: ant.fate() }
}

/// The iteration's record.
#[inline(never)]
fn record(iteration: &Iteration) -> Record {
    let tally: Tally = iteration.arrived().map(|(_, length)| length).collect();
    tally.record(iteration.number, iteration.best_so_far)
}

impl<V: Variant + 'static> Planner for Colony<V> {
    fn advance(&mut self, by: Granularity) -> Status {
        advance(self, by)
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.variant.bytes() + self.progress.bytes() + self.tables.as_ref().map_or(0, Tables::bytes)
    }

    fn moves_from(&self, cell: Cell) -> Vec<MoveOdds> {
        if cell as usize >= self.scenario.grid.len() || cell == self.scenario.goal {
            return Vec::new();
        }
        let variant = self.variant_now();
        match &self.tables {
            Some(tables) => self.odds_at(&variant, &tables.trails, Standing::at(cell), 0),
            None => self.odds_at(&variant, &self.initial_trails(), Standing::at(cell), 0),
        }
    }

    fn ant(&self, number: u32) -> Option<Walked> {
        let ants = self.tables.as_ref().filter(|_| cfg!(feature = "whole")).map(|tables| &tables.ants)?;
        ants.get(number as usize).map(|ant| walked(&self.scenario, ant))
    }

    fn turn_of(&self, number: u32) -> Option<Turn> {
        (cfg!(feature = "whole") && number < self.settings.ants).then(|| self.clone().take_turn(number as usize))?
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn budget(&self) -> Option<u32> {
        Some(self.settings.iterations)
    }

    fn colony_size(&self) -> u32 {
        self.settings.ants
    }

    #[cfg(feature = "whole")]
    fn adapts(&self) -> bool {
        V::ADAPTS
    }

    #[cfg(feature = "whole")]
    fn adapt(&mut self, change: &Change, to: &Arc<Scenario>) {
        self.go_on(change, to);
    }

    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        self.variant.certificate()
    }

    fn walk_on(&mut self, threads: NonZero<usize>) -> bool {
        self.threads = threads;
        Self::ON_THREADS
    }

    fn objective(&self) -> Objective {
        objective(&self.variant)
    }

    #[cfg(feature = "whole")]
    fn goes_by_steps(&self) -> bool {
        self.variant.path_kind() == PathKind::Steps
    }

    fn weighed(&self) -> Option<Weighed> {
        weighed(&self.variant, &self.scenario, self.best())
    }

    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        self.show(kind, out)
    }

    fn layer_version(&self, kind: Layer) -> Option<u64> {
        self.version_of(kind)
    }

    fn ants(&self, out: &mut Vec<Cell>) {
        out.clear();
        if let (Some(tables), true) = (&self.tables, self.constructing) {
            out.extend(tables.ants.iter().filter(|a| a.fate() != Fate::Lost).map(Ant::cell));
        }
    }
}

/// The best path after refinement, if there is any.
#[inline(never)]
fn refined(scenario: &Scenario, path: &[Cell], how: Refinement) -> Option<Refined> {
    let refined = || {
        let path = refine(scenario, path, how);
        Refined { length: scenario.path_length(&path), path }
    };
    (how != Refinement::None).then(refined)
}

/// What the result of a colony of this variant is measured by: a refined path by its length, whatever it was chosen by.
pub(super) fn objective<V: Variant>(variant: &V) -> Objective {
    if variant.path_kind() == PathKind::Polyline {
        return Objective::PolylineLength;
    }
    match (variant.refinement(), variant.criterion()) {
        (Refinement::None, Judge::Length) => Objective::Length,
        (Refinement::None, Judge::TurnIndex) => Objective::TurnIndex,
        (Refinement::None, Judge::Weighted(_)) => Objective::Weighted,
        _ => Objective::PolylineLength,
    }
}

/// What a result of a colony of this variant comes to where the weighted sum is its objective.
pub(super) fn weighed<V: Variant>(variant: &V, scenario: &Scenario, best: Option<&Solution>) -> Option<Weighed> {
    let is_one = objective(variant) == Objective::Weighted;
    is_one.then(|| variant.criterion().weighed(scenario, best)).flatten()
}
