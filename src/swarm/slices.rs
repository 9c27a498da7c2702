//! From rows and levels to a path by slices.
//!
//! A position has two numbers for each column between the ends, a row and a level, both counted from 0. Column by column from the start they
//! are clamped to what can be reached from the place before and leads on to the goal by the limits of the steps, and rounded to a place.
//! Where that lies in the ground, the nearest free level of the same row within these limits is taken, else of the nearest row; of two
//! equally near ones the lower number. Where none is free the path ends there: the particle is lost.
//!
//! The position becomes what was clamped, or the place that was taken instead: what a particle remembers is the path that it had. Its
//! velocity stays, because the limits are no border: they move with the path.

use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::map::{Cell, Slices};
use crate::planner::held;
use crate::scenario::Scenario;

use super::search::{Decode, Settings};

/// Rows, or levels, of one column.
pub type Window = RangeInclusive<i64>;

/// What can be reached in one step of at most `reach` from `here`, and leads to `goal` in `left` more of them, within `all`.
pub fn window(here: u32, goal: u32, reach: u32, left: u32, all: Window) -> Window {
    let (here, goal, reach) = (i64::from(here), i64::from(goal), i64::from(reach));
    let rest = reach * i64::from(left);
    (here - reach).max(goal - rest).max(*all.start())..=(here + reach).min(goal + rest).min(*all.end())
}

/// A number clamped to a window.
pub fn clamped(x: f32, window: &Window) -> f32 {
    x.clamp(*window.start() as f32, *window.end() as f32)
}

/// The numbers of a window by their distance from one of them, of two the lower first.
fn outwards(from: i64, window: &Window) -> impl Iterator<Item = i64> + use<> {
    let (first, last) = (*window.start(), *window.end());
    let both = move |d: i64| [from - d, from + d].into_iter().take(if d == 0 { 1 } else { 2 });
    (0..=last - first).flat_map(both).filter(move |k| (first..=last).contains(k))
}

/// The free place of column `x` nearest to a row and level: the nearest level of that row, else of the nearest row; none in these windows.
pub fn nearest_free(slices: &Slices, x: u32, (row, level): (i64, i64), rows: &Window, levels: &Window) -> Option<Cell> {
    let place = |y: i64, h: i64| Some(slices.place(x, y as u32, h as u32)).filter(|&p| slices.is_free(p));
    outwards(row, rows).find_map(|y| outwards(level, levels).find_map(|h| place(y, h)))
}

/// Decodes positions on one scenario by slices, again and again, without allocating.
#[derive(Debug, Clone)]
pub struct SliceDecoder {
    slices: Arc<Slices>,
    /// Columns between the ends.
    columns: usize,
    path: Vec<Cell>,
}

impl SliceDecoder {
    /// For these slices.
    pub fn of(slices: Arc<Slices>) -> Self {
        let columns = slices.slices().saturating_sub(1) as usize;
        Self { slices, columns, path: Vec::with_capacity(columns + 2) }
    }

    /// Largest row and largest level, both counted from 0: the ranges of a position.
    pub fn ranges(slices: &Slices, scenario: &Scenario) -> [f64; 2] {
        [scenario.grid.height() - 1, slices.rules().levels - 1].map(f64::from)
    }

    /// Column `k` between the ends, from 0.
    fn x(&self, k: usize) -> u32 {
        let (from, to) = (self.slices.at(self.slices.start()).0, self.slices.at(self.slices.goal()).0);
        if to > from { from + 1 + k as u32 } else { from - 1 - k as u32 }
    }

    /// The place after `from` for this row and level of column `k`, which become what they may be.
    fn place(&self, scenario: &Scenario, from: Cell, k: usize, at: &mut [f32]) -> Option<Cell> {
        let (slices, rules) = (&*self.slices, self.slices.rules());
        let ((_, y, h), (_, goal_y, goal_h)) = (slices.at(from), slices.at(slices.goal()));
        let left = (self.columns - k) as u32;
        let rows = window(y, goal_y, rules.max_aside, left, 0..=i64::from(scenario.grid.height()) - 1);
        let levels = window(h, goal_h, rules.max_climb, left, 1..=i64::from(rules.levels));
        (at[0], at[1]) = (clamped(at[0], &rows), clamped(at[1], &(levels.start() - 1..=levels.end() - 1)));
        let wanted = (libm::roundf(at[0]) as i64, libm::roundf(at[1]) as i64 + 1);
        let place = nearest_free(slices, self.x(k), wanted, &rows, &levels)?;
        let (_, row, level) = slices.at(place);
        if (i64::from(row), i64::from(level)) != wanted {
            (at[0], at[1]) = (row as f32, (level - 1) as f32);
        }
        Some(place)
    }
}

impl Decode for SliceDecoder {
    fn new(scenario: &Scenario, _: &Settings) -> Self {
        // The planner is built for scenarios by slices alone.
        Self::of(Arc::clone(scenario.slices.as_ref().expect("a scenario by slices")))
    }

    /// Two for each column between the ends; two without use where there is none.
    fn dimensions(&self) -> usize {
        2 * self.columns.max(1)
    }

    fn decode(&mut self, scenario: &Scenario, position: &mut [f32]) -> Option<f64> {
        self.path.clear();
        let mut here = self.slices.start();
        self.path.push(here);
        for (k, at) in position.chunks_exact_mut(2).take(self.columns).enumerate() {
            here = self.place(scenario, here, k, at)?;
            self.path.push(here);
        }
        self.path.push(self.slices.goal());
        Some(self.slices.value(&self.path))
    }

    fn lost(&self) -> f64 {
        f64::INFINITY
    }

    fn path(&self) -> &[Cell] {
        &self.path
    }

    fn moves(&self) -> u32 {
        self.path.len() as u32 - 1
    }

    fn bytes(&self) -> usize {
        held(&self.path)
    }

    /// The level at each column's row.
    fn draw(&self, scenario: &Scenario, position: &[f32], out: &mut [f32]) {
        for (k, at) in position.chunks_exact(2).take(self.columns).enumerate() {
            let row = libm::roundf(at[0]) as u32;
            out[(row * scenario.grid.width() + self.x(k)) as usize] = libm::roundf(at[1]) + 1.0;
        }
    }
}
