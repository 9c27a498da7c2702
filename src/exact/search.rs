//! Best-first search over a bucket queue: Dijkstra and A* are this file with different estimates.
//!
//! Buckets are half a cell of f wide (on a steep terrain more, so that they stay few) and worked off last in, first out, which costs O(1)
//! per cell where a heap costs O(log n). Order within a bucket is loose, so a cell can be expanded again when a shorter way to it turns up;
//! the search ends only when no open cell can beat the goal's cost, which keeps the result exact for any consistent estimate.
//!
//! On a plane all neighbours of a cell are looked at at once, and only those to which the way is cheaper one by one: they are one or two of
//! eight.
//!
//! On a terrain and on weighted ground hardly two ways cost the same, and loose order would expand cells dozens of times over: there the
//! bucket at work is a heap, and each cell is expanded once.

use std::collections::BinaryHeap;
use std::sync::Arc;

use super::best_first::Open;
use super::contours::{self, Contours};
use super::frontier::Frontier;
use super::region::{Region, WholeMap};
use super::ways::{NO_PARENT, Ways};
use crate::map::{ALL_DIRECTIONS, Cell, DIRECTIONS, Direction, offset, opposite, step_length};
use crate::metrics::SAME_LENGTH;
use crate::path::Path;
use crate::planner::{Granularity, Layer, Planner, Progress, Record, Solution, Status};
use crate::scenario::Scenario;
#[cfg(feature = "whole")]
use crate::{
    exact::proof::{self, surely},
    planner::Certificate,
};

/// A lower bound of the remaining cost that never drops by more than a step costs.
pub trait Estimate: Clone + Send {
    /// For the cell in column x and row y, in cells.
    fn to_goal(&self, x: u32, y: u32) -> f64;
}

/// Buckets per contour, which is a cell of f wide unless steps are far longer.
const BUCKETS_PER_CONTOUR: usize = 2;
/// Length of a step on the plane by direction.
const LENGTHS: [f64; ALL_DIRECTIONS] = {
    let mut lengths = [0.0; ALL_DIRECTIONS];
    let mut d = 0;
    while d < ALL_DIRECTIONS {
        lengths[d] = step_length(d as Direction);
        d += 1;
    }
    lengths
};
/// The goal of a search that is to reach every cell.
pub(super) const EVERYWHERE: Cell = Cell::MAX;

/// A cell that waits to be expanded.
#[derive(Clone, Copy)]
struct Waiting {
    /// Cost from the start when it was seen; a cheaper way may have turned up since.
    g: f64,
    cell: Cell,
}

/// A search at work, on the whole map or on a region of it.
#[derive(Clone)]
pub(super) struct Search<E, R = WholeMap> {
    scenario: Arc<Scenario>,
    /// Which cells it may enter.
    region: R,
    start: Cell,
    goal: Cell,
    estimate: E,
    /// Empty until the first step.
    ways: Ways,
    frontier: Frontier<Waiting>,
    /// On a terrain and on weighted ground what the bucket at work holds, the least f first.
    sorted: Option<BinaryHeap<Open>>,
    /// f below which bucket 0 begins.
    base: f64,
    /// Cells of f to a contour: 1 but where steps cost far more than on plain ground.
    contour: f64,
    /// [`BUCKETS_PER_CONTOUR`] over that.
    buckets_per_cell: f64,
    /// Cost of the best way to the goal so far.
    bound: f64,
    progress: Progress,
}

impl<E: Estimate> Search<E> {
    pub(super) fn new(scenario: Arc<Scenario>, estimate: E) -> Self {
        let (start, goal) = (scenario.start, scenario.goal);
        Self::between(scenario, start, goal, estimate)
    }

    /// From one cell of the map to another, or [`EVERYWHERE`].
    pub(super) fn between(scenario: Arc<Scenario>, start: Cell, goal: Cell, estimate: E) -> Self {
        Self::inside(scenario, WholeMap, start, goal, estimate)
    }
}

impl<E: Estimate, R: Region> Search<E, R> {
    /// The same inside a region, in which start and goal lie.
    pub(super) fn inside(scenario: Arc<Scenario>, region: R, start: Cell, goal: Cell, estimate: E) -> Self {
        Self {
            scenario,
            region,
            start,
            goal,
            estimate,
            ways: Ways::default(),
            frontier: Frontier::default(),
            sorted: None,
            base: 0.0,
            contour: 1.0,
            buckets_per_cell: BUCKETS_PER_CONTOUR as f64,
            bound: f64::INFINITY,
            progress: Progress::default(),
        }
    }

    /// Cost from the start by cell, in cells; exact everywhere once a search [`EVERYWHERE`] has ended, infinite where it cannot go.
    pub(super) fn costs(&self) -> &[f64] {
        self.ways.costs()
    }

    /// The bucket at work as a heap; the opening build knows no terrains and is spared its code.
    #[inline(always)]
    fn sorted(&mut self) -> Option<&mut BinaryHeap<Open>> {
        if cfg!(feature = "whole") { self.sorted.as_mut() } else { None }
    }

    /// The smallest f of what is open or waits outside the region; infinite where nothing does.
    #[cfg(feature = "whole")]
    fn least_open(&self) -> f64 {
        let sorted = self.sorted.iter().flatten().map(|open| (open.g, open.state));
        let filed = self.frontier.waiting().map(|waiting| (waiting.g, waiting.cell));
        let open = sorted.chain(filed).chain(self.region.waiting().iter().copied());
        let current = open.filter(|&(g, cell)| g <= self.ways.g(cell));
        current.map(|(g, cell)| g + self.to_goal(cell)).fold(f64::INFINITY, f64::min)
    }

    /// Least cost from a cell to the goal.
    #[inline(always)]
    fn to_goal(&self, cell: Cell) -> f64 {
        let width = self.scenario.grid.width();
        self.estimate.to_goal(cell % width, cell / width)
    }

    /// Takes note of a cheaper way to a cell, if it can still lead to a shorter path.
    #[inline(always)]
    fn open(&mut self, cell: Cell, g: f64, f: f64, parent: Direction) {
        if f >= self.bound - SAME_LENGTH {
            return;
        }
        self.ways.note(cell, g, parent);
        if cell == self.goal {
            self.bound = g;
            return;
        }
        if self.region.takes(cell, g) {
            self.file(cell, g, f);
        }
    }

    /// Has a cell wait for its turn.
    #[inline(always)]
    fn file(&mut self, cell: Cell, g: f64, f: f64) {
        let bucket = ((f - self.base) * self.buckets_per_cell) as u32 as usize;
        // Rounding may put f a hair below the bucket at work.
        if bucket <= self.frontier.at_work()
            && let Some(sorted) = self.sorted()
        {
            sorted.push(Open { state: cell, g, f });
            return;
        }
        self.frontier.file(bucket, Waiting { g, cell });
    }

    /// The next open cell of the bucket at work that is neither outdated nor hopeless.
    #[inline(always)]
    fn pop(&mut self) -> Option<Cell> {
        loop {
            let Waiting { g, cell } = match self.sorted() {
                Some(sorted) => sorted.pop().map(|open| Waiting { g: open.g, cell: open.state })?,
                None => self.frontier.pop()?,
            };
            if g <= self.ways.g(cell) && (self.bound == f64::INFINITY || g + self.to_goal(cell) < self.bound - SAME_LENGTH) {
                return Some(cell);
            }
        }
    }

    #[inline(always)]
    fn expand(&mut self, cell: Cell) {
        let g = self.ways.g(cell);
        self.ways.note_expansion(cell);
        self.progress.effort.cell_expansions += 1;
        // The opening build must stay small.
        if !self.scenario.moves.is_plain() || !cfg!(feature = "whole") {
            self.expand_one_by_one(cell, g);
            return;
        }
        let allowed = self.scenario.moves.all_bits(cell);
        let width = self.scenario.grid.width();
        let (x, y) = (cell % width, cell / width);
        let mut cheaper = allowed & self.cheaper(cell, g, allowed);
        while cheaper != 0 {
            let d = cheaper.trailing_zeros() as Direction;
            cheaper &= cheaper - 1;
            let (dx, dy) = offset(d);
            let next_g = g + LENGTHS[usize::from(d)];
            let h = self.estimate.to_goal(x.wrapping_add_signed(dx), y.wrapping_add_signed(dy));
            self.open(self.scenario.moves.step(cell, d), next_g, next_g + h, d);
        }
    }

    /// In which directions a step from a cell of cost g leads to another more cheaply than before, on the plane, as bits.
    #[inline(always)]
    fn cheaper(&self, cell: Cell, g: f64, allowed: u16) -> u16 {
        let (near, far) = self.scenario.moves.delta.split_at(DIRECTIONS);
        let near = self.ways.cheaper(cell, near, std::array::from_fn(|d| g + LENGTHS[d]));
        let far =
            if allowed >> DIRECTIONS == 0 { 0 } else { self.ways.cheaper(cell, far, [g + LENGTHS[DIRECTIONS]; DIRECTIONS]) };
        u16::from(near) | u16::from(far) << DIRECTIONS
    }

    /// The same step by step, whatever the ground.
    #[inline(never)]
    fn expand_one_by_one(&mut self, cell: Cell, g: f64) {
        for d in self.scenario.moves.directions(cell) {
            let next = self.scenario.moves.step(cell, d);
            let next_g = g + self.scenario.moves.length(cell, d);
            if self.ways.is_cheaper(next, next_g) {
                self.open(next, next_g, next_g + self.to_goal(next), d);
            }
        }
    }

    /// Where there is a heap, takes the bucket at work into it.
    fn sort(&mut self) {
        if self.sorted().is_some() {
            let waiting: Vec<Waiting> = self.frontier.take().collect();
            let open = waiting.iter().map(|&Waiting { g, cell }| Open { state: cell, g, f: g + self.to_goal(cell) });
            self.sorted = Some(open.collect());
        }
    }

    fn close_contour(&mut self, exhausted: bool) {
        self.progress.effort.iterations += 1;
        let floor = self.base + self.frontier.at_work() as f64 * (self.contour / BUCKETS_PER_CONTOUR as f64);
        if exhausted || floor >= self.bound - SAME_LENGTH {
            self.finish();
        }
        let length = self.progress.best.as_ref().map(|b| b.length);
        self.progress.record(Record::of_search(self.progress.effort.iterations, length));
    }

    fn finish(&mut self) {
        if !self.bound.is_finite() {
            self.progress.status = Status::NoPath;
            return;
        }
        let path = self.path();
        let length = self.scenario.path_length(&path);
        self.progress.effort.constructed_paths = 1;
        self.progress.best = Some(Solution { path, length, iteration: self.progress.effort.iterations, refined: None });
        self.progress.status = Status::Optimal;
    }

    fn path(&self) -> Path {
        let mut path = vec![self.goal];
        let mut at = self.goal;
        while self.ways.parent(at) != NO_PARENT {
            at = self.scenario.moves.step(at, opposite(self.ways.parent(at)));
            path.push(at);
        }
        path.reverse();
        path
    }
}

/// Width of a contour in cells of f: no step is longer than 16 of them. Every step leads back, so half of the directions are looked at.
pub(super) fn contour(scenario: &Scenario) -> f64 {
    const ONWARDS: u16 = 0xf0f0;
    let moves = &scenario.moves;
    if let Some(weights) = moves.weights() {
        return libm::ceil(weights.most() * step_length(DIRECTIONS as Direction) / 16.0);
    }
    let cells = if moves.relief().is_none() { 0 } else { scenario.grid.len() as Cell };
    let onwards = |c: Cell| moves.directions(c).filter(|d| ONWARDS >> d & 1 == 1);
    let longest = |c: Cell| onwards(c).map(move |d| moves.length(c, d));
    (0..cells).flat_map(longest).fold(1.0, |most: f64, length| most.max(libm::ceil(length / 16.0)))
}

impl<E: Estimate, R: Region> Contours for Search<E, R> {
    fn status(&self) -> Status {
        self.progress.status
    }

    fn is_prepared(&self) -> bool {
        !self.ways.costs().is_empty()
    }

    fn prepare(&mut self) {
        self.ways = Ways::new(self.scenario.grid.width(), self.scenario.grid.len());
        self.contour = contour(&self.scenario);
        self.buckets_per_cell = BUCKETS_PER_CONTOUR as f64 / self.contour;
        self.sorted = (!self.scenario.moves.is_plain()).then(BinaryHeap::new);
        let to_goal = self.to_goal(self.start);
        self.base = libm::floor(to_goal);
        self.open(self.start, 0.0, to_goal, NO_PARENT);
    }

    fn advance_one(&mut self) -> bool {
        loop {
            if let Some(cell) = self.pop() {
                self.expand(cell);
                return true;
            }
            let more = self.frontier.has_more();
            let ends_contour = (self.frontier.at_work() + 1).is_multiple_of(BUCKETS_PER_CONTOUR);
            if more {
                self.frontier.next();
                self.sort();
            }
            if !more || ends_contour {
                self.close_contour(!more);
                return false;
            }
        }
    }
}

impl<E: Estimate + 'static, R: Region + 'static> Planner for Search<E, R> {
    fn advance(&mut self, by: Granularity) -> Status {
        contours::advance(self, by)
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        self.is_prepared().then_some(())?;
        proof::certificate(
            &self.progress,
            || self.best().map(|best| best.length),
            || Some(surely(self.least_open().min(self.bound))),
        )
    }

    fn bytes(&self) -> usize {
        let sorted = self.sorted.as_ref().map_or(0, |sorted| sorted.capacity() * size_of::<Open>());
        size_of::<Self>() + self.progress.bytes() + self.ways.bytes() + self.frontier.bytes() + sorted
    }

    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        out.clear();
        match kind {
            Layer::Visits => out.extend(self.ways.expanded().iter().map(|&e| f32::from(u8::from(e)))),
            Layer::Cost => out.extend(self.ways.costs().iter().map(|&g| g as f32)),
            _ => return false,
        }
        out.resize(self.scenario.grid.len(), contours::untouched(kind));
        true
    }
}

mod growing;
#[cfg(test)]
mod tests;
