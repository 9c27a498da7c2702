//! The colony by slices: ants go from column to column, from the start to the goal.
//!
//! All ants move in lock step, one move each in index order. Without steps back an ant enters a column exactly after the ants before it have
//! entered it, so that what they do to trails as they go is what ants do that walk one after the other.

use std::ops::Range;
use std::sync::Arc;

use super::tables::Tables;
use super::trails::RowTrails;
use crate::aco::colony::take_solved;
use crate::aco::shared_params::{SelectionParams, WalkParams};
use crate::aco::terrain::walk::Walker;
use crate::aco::variant::Solved;
use crate::error::ParamError;
use crate::map::{Cell, Slices};
#[cfg(feature = "whole")]
use crate::planner::Certificate;
use crate::planner::{
    Fate, Granularity, Iterations, Layer, MoveOdds, Objective, Planner, Progress, Solution, Status, Tally, Turn, Walked, advance,
};
use crate::rng::{Stream, Streams};
use crate::scenario::Scenario;

/// Numbers that every colony by slices has.
#[derive(Debug, Clone, Copy)]
pub struct Numbers {
    /// Ants in an iteration.
    pub ants: u32,
    /// Budget, α and β.
    pub selection: SelectionParams,
    /// Probability of taking the best step.
    pub q0: f64,
    /// When ants and colony give up.
    pub walk: WalkParams,
}

/// A complete iteration, as the update of trails sees it.
#[derive(Clone, Copy)]
pub struct Built<'a> {
    /// From 1.
    pub number: u32,
    /// Where it was.
    pub slices: &'a Slices,
    /// The cheapest path so far, of this iteration too.
    pub best: Option<&'a Solution>,
    /// The cheapest path of the iteration, with its cost; the first of equals.
    pub iteration_best: Option<(&'a [Cell], f64)>,
    /// All ants of the iteration.
    pub ants: &'a [Walker],
}

/// What a publication decides.
pub trait Rules: Clone + Send {
    /// Whether a trail lies on a place, whatever step leads there; else on a step.
    const ON_PLACES: bool;

    /// The numbers.
    fn numbers(&self) -> Numbers;

    /// Learns what it needs to know of the scenario, before the first iteration.
    fn prepare(&mut self, _slices: &Slices) {}

    /// τ before the first iteration.
    fn initial_trail(&self, slices: &Slices) -> f64;

    /// η of a feasible step between two places, above 0.
    fn eta(&self, slices: &Slices, from: Cell, to: Cell) -> f64;

    /// After a step: where it began, its number, and where it led.
    fn on_move(&self, _trails: &mut RowTrails, _slices: &Slices, _step: (Cell, usize, Cell)) {}

    /// At the end of an iteration, before trails are updated: what a search adds to it. Paths are places, lengths costs.
    fn solve(&mut self, _built: Built) -> Option<Solved> {
        None
    }

    /// Writes a layer of its own, by cell; false when there is no such layer.
    fn show(&self, _slices: &Slices, _kind: Layer, _out: &mut [f32]) -> bool {
        false
    }

    /// What is proven of the best path.
    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        None
    }

    /// What it needs for each place at most beside the colony's tables, in bytes.
    fn bytes_of_place(&self) -> u64 {
        0
    }

    /// What it holds, in bytes, its own size not counted.
    fn bytes(&self) -> usize {
        0
    }

    /// At the end of an iteration.
    fn update(&mut self, trails: &mut RowTrails, built: Built);
}

/// A colony at work on one scenario.
#[derive(Clone)]
pub struct SliceColony<R> {
    pub(super) slices: Arc<Slices>,
    scenario: Arc<Scenario>,
    pub(super) rules: R,
    pub(super) numbers: Numbers,
    streams: Streams,
    max_moves: u32,
    pub(super) tables: Option<Tables>,
    /// An iteration has begun and not ended.
    constructing: bool,
    progress: Progress,
}

impl<R: Rules> SliceColony<R> {
    /// A colony of the planner with this id.
    ///
    /// # Errors
    /// [`ParamError::Memory`] where its tables could grow too large.
    ///
    /// # Panics
    /// Unless the scenario moves by slices.
    pub fn new(scenario: &Arc<Scenario>, mut rules: R, planner: &str, seed: u32) -> Result<Self, ParamError> {
        let slices = Arc::clone(scenario.slices.as_ref().expect("a scenario by slices"));
        let (numbers, places) = (rules.numbers(), slices.places() as u64);
        // Sight, and trails as wide at most, with their rows; a tabu list for each ant.
        let tables = places * (8 + 8 * slices.directions() as u64 + rules.bytes_of_place());
        ParamError::check_memory("ants", numbers.ants, tables + u64::from(numbers.ants) * (places / 8 + 4096))?;
        rules.prepare(&slices);
        let (width, height) = (scenario.grid.width(), scenario.grid.height());
        let limit = numbers.walk.move_limit;
        Ok(Self {
            slices,
            scenario: Arc::clone(scenario),
            rules,
            numbers,
            streams: Streams::new(u64::from(seed), planner, 0),
            max_moves: if limit == 0.0 { u32::MAX } else { (limit * f64::from(width + height)) as u32 },
            tables: None,
            constructing: false,
            progress: Progress::default(),
        })
    }

    /// A stream from which nothing is drawn.
    pub(super) fn stream(&self) -> Stream {
        self.streams.ant(0, 0)
    }

    /// One move of the walking ones among these ants, in index order; true when none of them is left.
    #[inline(always)]
    pub(super) fn move_ants(&mut self, which: Range<usize>) -> bool {
        let Some(tables) = &mut self.tables else { return true };
        let mut done = true;
        for k in which {
            if !tables.ants[k].is_walking() {
                continue;
            }
            tables.move_one(&self.rules, &self.numbers, &self.slices, k);
            let ant = &mut tables.ants[k];
            if ant.is_walking() && ant.moves() >= self.max_moves {
                ant.stop();
            }
            done &= !ant.is_walking();
        }
        done
    }
}

impl<R: Rules> Iterations for SliceColony<R> {
    fn parts(&mut self) -> (&mut Progress, &Scenario) {
        (&mut self.progress, &self.scenario)
    }

    fn is_prepared(&self) -> bool {
        self.tables.is_some()
    }

    fn prepare(&mut self) {
        self.tables = Some(Tables::new(&self.rules, &self.slices, self.numbers.ants, self.streams));
    }

    fn begin_iteration(&mut self) {
        if self.constructing {
            return;
        }
        let (number, start) = (self.progress.effort.iterations + 1, self.slices.start());
        let Some(Tables { ants, .. }) = &mut self.tables else { return };
        (0..).zip(ants).for_each(|(k, ant)| ant.begin(start, self.streams.ant(number, k)));
        self.constructing = true;
    }

    /// One move of every walking ant, in index order; true when none is left.
    fn move_all(&mut self) -> bool {
        self.move_ants(0..self.numbers.ants as usize)
    }

    fn end_iteration(&mut self) {
        let Some(Tables { ants, trails, .. }) = &mut self.tables else { return };
        self.constructing = false;
        let progress = &mut self.progress;
        progress.effort.iterations += 1;
        progress.effort.constructed_paths += ants.len() as u64;
        progress.effort.ant_moves += ants.iter().map(|a| u64::from(a.moves())).sum::<u64>();
        let number = progress.effort.iterations;
        let arrived = || ants.iter().filter_map(Walker::path);
        let iteration_best = arrived().reduce(|best, next| if next.1 < best.1 { next } else { best });
        if let Some((path, length)) = iteration_best
            && progress.best.as_ref().is_none_or(|b| length < b.length)
        {
            progress.best = Some(Solution { path: path.to_vec(), length, iteration: number, refined: None });
        }
        let tally: Tally = arrived().map(|(_, cost)| cost).collect();
        let built = Built { number, slices: &self.slices, best: None, iteration_best, ants };
        let solved = self.rules.solve(Built { best: progress.best.as_ref(), ..built });
        let ended = solved.as_ref().and_then(|solved| solved.status);
        let found = solved.and_then(|solved| take_solved(progress, solved));
        let record = tally.record(number, progress.best.as_ref());
        progress.record(found.map_or(record, |cost| record.with_found(cost)));
        self.rules.update(trails, Built { best: progress.best.as_ref(), ..built });
        let status = progress.after_iteration(self.numbers.selection.iterations, self.numbers.walk.stagnation);
        progress.status = ended.unwrap_or(status);
    }
}

impl<R: Rules + 'static> Planner for SliceColony<R> {
    fn advance(&mut self, by: Granularity) -> Status {
        advance(self, by)
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn budget(&self) -> Option<u32> {
        Some(self.numbers.selection.iterations)
    }

    fn colony_size(&self) -> u32 {
        self.numbers.ants
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.progress.bytes() + self.rules.bytes() + self.tables.as_ref().map_or(0, Tables::bytes)
    }

    fn moves_from(&self, place: Cell) -> Vec<MoveOdds> {
        self.odds_at(place)
    }

    fn ant(&self, number: u32) -> Option<Walked> {
        self.tables.as_ref()?.ants.get(number as usize).map(Walker::walked)
    }

    fn turn_of(&self, number: u32) -> Option<Turn> {
        (number < self.numbers.ants).then(|| self.clone().take_turn(number as usize))?
    }

    fn objective(&self) -> Objective {
        Objective::SliceCost
    }

    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        self.rules.certificate()
    }

    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        self.show(kind, out)
    }

    /// η of a step is the rules' and the map's alone; trails may change with every move.
    fn layer_version(&self, kind: Layer) -> Option<u64> {
        (kind == Layer::Heuristic).then_some(0)
    }

    fn ants(&self, out: &mut Vec<Cell>) {
        out.clear();
        if let (Some(tables), true) = (&self.tables, self.constructing) {
            out.extend(tables.ants.iter().filter(|a| a.fate() != Fate::Lost).map(Walker::place));
        }
    }
}
