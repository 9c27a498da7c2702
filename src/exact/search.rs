//! Best-first search over a bucket queue: Dijkstra and A* are this file with different estimates.
//!
//! Buckets are half a cell of f wide (on a steep terrain more, so that they stay few) and worked off last in, first out, which costs O(1)
//! per cell where a heap costs O(log n). Order within a bucket is loose, so a cell can be expanded again when a shorter way to it turns up;
//! the search ends only when no open cell can beat the goal's cost, which keeps the result exact for any consistent estimate.
//!
//! On a terrain hardly two ways are equally long, and loose order would expand cells dozens of times over: there the bucket at work is a
//! heap, and each cell is expanded once.

use std::collections::BinaryHeap;
use std::sync::Arc;

use super::best_first::Open;
use super::contours::{self, Contours};
use crate::map::{Cell, Direction, offset, opposite};
use crate::metrics::SAME_LENGTH;
use crate::path::Path;
use crate::planner::{Granularity, Layer, Planner, Progress, Record, Solution, Status, held, nested};
use crate::scenario::Scenario;

/// A lower bound of the remaining cost that never drops by more than a step costs.
pub trait Estimate: Clone + Send {
    /// For the cell in column x and row y, in cells.
    fn to_goal(&self, x: u32, y: u32) -> f64;
}

/// Buckets per contour, which is a cell of f wide unless steps are far longer.
const BUCKETS_PER_CONTOUR: f64 = 2.0;
/// Parent of the start.
const NO_PARENT: u8 = u8::MAX;
/// The goal of a search that is to reach every cell.
pub(super) const EVERYWHERE: Cell = Cell::MAX;

/// A search at work.
#[derive(Clone)]
pub(super) struct Search<E> {
    scenario: Arc<Scenario>,
    start: Cell,
    goal: Cell,
    estimate: E,
    /// Cost from the start by cell; empty until the first step.
    g: Vec<f64>,
    /// Direction of the step that led here.
    parent: Vec<u8>,
    expanded: Vec<bool>,
    buckets: Vec<Vec<Open>>,
    /// The bucket worked on.
    bucket: usize,
    /// On a terrain what that bucket holds, the least f first.
    sorted: Option<BinaryHeap<Open>>,
    /// f below which bucket 0 begins.
    base: f64,
    /// Cells of f to a contour: 1 but on a terrain with steps of hundreds of cells.
    contour: f64,
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
        Self {
            scenario,
            start,
            goal,
            estimate,
            g: Vec::new(),
            parent: Vec::new(),
            expanded: Vec::new(),
            buckets: Vec::new(),
            bucket: 0,
            sorted: None,
            base: 0.0,
            contour: 1.0,
            bound: f64::INFINITY,
            progress: Progress::default(),
        }
    }

    /// Cost from the start by cell, in cells; exact everywhere once a search [`EVERYWHERE`] has ended, infinite where it cannot go.
    pub(super) fn costs(&self) -> &[f64] {
        &self.g
    }

    /// The bucket at work as a heap; the opening build knows no terrains and is spared its code.
    #[inline(always)]
    fn sorted(&mut self) -> Option<&mut BinaryHeap<Open>> {
        if cfg!(feature = "whole") { self.sorted.as_mut() } else { None }
    }

    /// Takes note of a way to a cell when it is the shortest so far and can still lead to a shorter path.
    #[inline(always)]
    fn relax(&mut self, cell: Cell, g: f64, f: f64, parent: u8) {
        if g >= self.g[cell as usize] - SAME_LENGTH || f >= self.bound - SAME_LENGTH {
            return;
        }
        self.g[cell as usize] = g;
        self.parent[cell as usize] = parent;
        if cell == self.goal {
            self.bound = g;
            return;
        }
        // Rounding may put f a hair below the bucket at work: never file behind it.
        let bucket = (((f - self.base) * (BUCKETS_PER_CONTOUR / self.contour)) as usize).max(self.bucket);
        let open = Open { state: cell, g, f };
        if bucket == self.bucket
            && let Some(sorted) = self.sorted()
        {
            sorted.push(open);
            return;
        }
        if bucket >= self.buckets.len() {
            self.buckets.resize_with(bucket + 1, Vec::new);
        }
        self.buckets[bucket].push(open);
    }

    /// The next open cell of the bucket at work that is neither outdated nor hopeless.
    fn pop(&mut self) -> Option<Cell> {
        loop {
            let open = match self.sorted() {
                Some(sorted) => sorted.pop()?,
                None => self.buckets.get_mut(self.bucket)?.pop()?,
            };
            if open.g <= self.g[open.state as usize] && open.f < self.bound - SAME_LENGTH {
                return Some(open.state);
            }
        }
    }

    fn expand(&mut self, cell: Cell) {
        let width = self.scenario.grid.width();
        let (x, y) = (cell % width, cell / width);
        let g = self.g[cell as usize];
        self.expanded[cell as usize] = true;
        self.progress.effort.cell_expansions += 1;
        let mut bits = self.scenario.moves.all_bits(cell);
        while bits != 0 {
            let d = bits.trailing_zeros() as Direction;
            bits &= bits - 1;
            let (dx, dy) = offset(d);
            let next = self.scenario.moves.step(cell, d);
            let next_g = g + self.scenario.moves.length(cell, d);
            let h = self.estimate.to_goal(x.wrapping_add_signed(dx), y.wrapping_add_signed(dy));
            self.relax(next, next_g, next_g + h, d);
        }
    }

    fn close_contour(&mut self, exhausted: bool) {
        self.progress.effort.iterations += 1;
        let floor = self.base + self.bucket as f64 * (self.contour / BUCKETS_PER_CONTOUR);
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
        while self.parent[at as usize] != NO_PARENT {
            at = self.scenario.moves.step(at, opposite(self.parent[at as usize]));
            path.push(at);
        }
        path.reverse();
        path
    }
}

/// Width of a contour in cells of f: no step is longer than 16 of them. Every step leads back, so half of the directions are looked at.
fn contour(scenario: &Scenario) -> f64 {
    const ONWARDS: u16 = 0xf0f0;
    let moves = &scenario.moves;
    let cells = if moves.relief().is_none() { 0 } else { scenario.grid.len() as Cell };
    let onwards = |c: Cell| moves.directions(c).filter(|d| ONWARDS >> d & 1 == 1);
    let longest = |c: Cell| onwards(c).map(move |d| moves.length(c, d));
    (0..cells).flat_map(longest).fold(1.0, |most: f64, length| most.max(libm::ceil(length / 16.0)))
}

impl<E: Estimate> Contours for Search<E> {
    fn status(&self) -> Status {
        self.progress.status
    }

    fn is_prepared(&self) -> bool {
        !self.g.is_empty()
    }

    fn prepare(&mut self) {
        let cells = self.scenario.grid.len();
        self.g = vec![f64::INFINITY; cells];
        self.parent = vec![NO_PARENT; cells];
        self.expanded = vec![false; cells];
        let start = self.start;
        let p = self.scenario.grid.point(start);
        self.contour = contour(&self.scenario);
        self.sorted = self.scenario.moves.relief().map(|_| BinaryHeap::new());
        self.base = libm::floor(self.estimate.to_goal(p.x, p.y));
        self.relax(start, 0.0, self.estimate.to_goal(p.x, p.y), NO_PARENT);
    }

    fn advance_one(&mut self) -> bool {
        loop {
            if let Some(cell) = self.pop() {
                self.expand(cell);
                return true;
            }
            let more = self.bucket + 1 < self.buckets.len();
            let ends_contour = (self.bucket + 1) as f64 % BUCKETS_PER_CONTOUR == 0.0;
            if more {
                // Given back: on a large map the emptied buckets would hold more than all tables together.
                self.buckets[self.bucket] = Vec::new();
                self.bucket += 1;
                if self.sorted().is_some() {
                    self.sorted = Some(std::mem::take(&mut self.buckets[self.bucket]).into());
                }
            }
            if !more || ends_contour {
                self.close_contour(!more);
                return false;
            }
        }
    }
}

impl<E: Estimate + 'static> Planner for Search<E> {
    fn advance(&mut self, by: Granularity) -> Status {
        contours::advance(self, by)
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn bytes(&self) -> usize {
        let sorted = self.sorted.as_ref().map_or(0, |sorted| sorted.capacity() * size_of::<Open>());
        let tables = held(&self.g) + held(&self.parent) + held(&self.expanded) + nested(&self.buckets);
        size_of::<Self>() + self.progress.bytes() + tables + sorted
    }

    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        out.clear();
        match kind {
            Layer::Visits => out.extend(self.expanded.iter().map(|&e| f32::from(u8::from(e)))),
            Layer::Cost => out.extend(self.g.iter().map(|&g| g as f32)),
            _ => return false,
        }
        out.resize(self.scenario.grid.len(), contours::untouched(kind));
        true
    }
}
