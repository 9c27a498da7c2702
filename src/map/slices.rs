//! Movement by slices: the model of the textbook 3-D colony. Each step leads from one column of the terrain to the next, a few cells
//! aside and a few levels up or down; a place is a cell at a level, free where the level lies above the ground.
//!
//! Places are numbered `cell + area · level`, so that a path stays a list of numbers and its cells are the remainders.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::grid::{Cell, Grid, Point};

/// Most levels.
pub const MAX_LEVELS: u32 = 255;
/// Largest limit aside and upwards.
pub const MAX_REACH: u32 = 5;

/// What a path by slices is measured by. Serialized as `cost`, `length`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Measure {
    /// Σ √(1 + Δy² + Δh²) + |h|: the textbook program's, which charges every place for its level.
    #[default]
    Cost,
    /// Σ √(1 + Δy² + Δh²): length alone.
    Length,
}

/// The rules of movement by slices, as files and the page hold them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SliceRules {
    /// Metres per level, above 0.
    pub level: f64,
    /// Highest level, 1 to [`MAX_LEVELS`]; the lowest is 1.
    pub levels: u32,
    /// |Δy|: most cells aside in a step, 0 to [`MAX_REACH`].
    pub max_aside: u32,
    /// |Δh|: most levels up or down in a step, 0 to [`MAX_REACH`].
    pub max_climb: u32,
    /// Level of the start, on the ground or above it.
    pub start_level: u32,
    /// Level of the goal, on the ground or above it.
    pub goal_level: u32,
    /// What paths are measured by.
    pub measure: Measure,
}

impl SliceRules {
    /// The textbook's limits for a terrain: 20 levels of a tenth of `top`, 2 aside and 2 up or down, measured by cost.
    ///
    /// `top` is the highest ground, `start_ground` and `goal_ground` the ground at the ends, all in metres: heights times the vertical unit.
    /// Start and goal are at the lowest level above their ground, from 1 to 20. Where no ground lies above 0, a level is 1 m.
    pub fn fitting(top: f64, start_ground: f64, goal_ground: f64) -> Self {
        let level = if top > 0.0 { top / 10.0 } else { 1.0 };
        let above = |ground: f64| (libm::floor(ground / level) as i64 + 1).clamp(1, 20) as u32;
        let (start_level, goal_level) = (above(start_ground), above(goal_ground));
        Self { level, levels: 20, max_aside: 2, max_climb: 2, start_level, goal_level, measure: Measure::Cost }
    }

    /// [`SliceRules::fitting`] over a map whose heights are `unit` metres each; with levels of `level` metres, where they are given. What has
    /// no height, or lies outside, counts as 0.
    pub fn fitting_map(grid: &Grid, unit: f64, start: Point, goal: Point, level: Option<f64>) -> Self {
        let metres = |h: f32| if h.is_nan() { 0.0 } else { f64::from(h) * unit };
        let heights = grid.heights().map_or(&[][..], |heights| heights);
        let ground = |at| {
            let height = grid.contains(at).then(|| heights.get(grid.cell(at) as usize)).flatten();
            height.map_or(0.0, |&h| metres(h))
        };
        let top = heights.iter().map(|&h| metres(h)).fold(0.0, f64::max);
        // The rules have ten levels up to the top.
        Self::fitting(level.map_or(top, |level| 10.0 * level), ground(start), ground(goal))
    }
}

/// Which way along the slices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// From the start to the goal.
    Forward,
    /// From the goal to the start.
    Backward,
}

/// The places of a scenario by slices, and the steps between them.
#[derive(Debug, Clone)]
pub struct Slices {
    width: u32,
    height: u32,
    rules: SliceRules,
    /// By cell: the lowest level above the ground, 1 at least; none where nothing is free.
    floor: Arc<[u32]>,
    start: Cell,
    goal: Cell,
    /// (Δy, Δh) of each step, in order.
    steps: Vec<(i32, i32)>,
}

impl Slices {
    /// Over a terrain whose heights are `unit` metres each. Start and goal are cells of the map; whether their levels lie above the ground
    /// is for the scenario to check, by [`Slices::ends_above_ground`].
    pub fn new(grid: &Grid, rules: SliceRules, unit: f64, start: Cell, goal: Cell) -> Self {
        let area = grid.len() as Cell;
        let floor = (0..area).map(|c| floor_level(grid, &rules, unit, c)).collect();
        let reach = |limit: u32| -(limit as i32)..=limit as i32;
        let steps = reach(rules.max_aside).flat_map(|dy| reach(rules.max_climb).map(move |dh| (dy, dh))).collect();
        Self {
            width: grid.width(),
            height: grid.height(),
            rules,
            floor,
            start: start + area * rules.start_level,
            goal: goal + area * rules.goal_level,
            steps,
        }
    }

    /// The rules.
    pub fn rules(&self) -> &SliceRules {
        &self.rules
    }

    /// Number of cells of the map.
    pub fn area(&self) -> u32 {
        self.width * self.height
    }

    /// Rows of the map.
    pub fn rows(&self) -> u32 {
        self.height
    }

    /// Places are numbered below this.
    pub fn places(&self) -> usize {
        self.area() as usize * (self.rules.levels as usize + 1)
    }

    /// The place where paths begin.
    pub fn start(&self) -> Cell {
        self.start
    }

    /// The place where paths end.
    pub fn goal(&self) -> Cell {
        self.goal
    }

    /// The cell of a place.
    pub fn cell(&self, place: Cell) -> Cell {
        place % self.area()
    }

    /// Column, row and level of a place.
    #[inline]
    pub fn at(&self, place: Cell) -> (u32, u32, u32) {
        let cell = place % self.area();
        (cell % self.width, cell / self.width, place / self.area())
    }

    /// The place at a column, row and level of the map.
    #[inline]
    pub fn place(&self, x: u32, y: u32, level: u32) -> Cell {
        level * self.area() + y * self.width + x
    }

    /// How many slices lie between start and goal: the number of steps of every path.
    pub fn slices(&self) -> u32 {
        self.at(self.start).0.abs_diff(self.at(self.goal).0)
    }

    /// Whether an ant may be at a place: above the ground, and on the slices of the ends only at the ends.
    #[inline]
    pub fn is_free(&self, place: Cell) -> bool {
        if place == self.start || place == self.goal {
            return true;
        }
        let (x, _, level) = self.at(place);
        let (first, last) = (self.at(self.start).0, self.at(self.goal).0);
        x > first.min(last) && x < first.max(last) && level <= self.rules.levels && level >= self.floor[self.cell(place) as usize]
    }

    /// Number of steps that a place may have: `0..directions()` numbers them.
    pub fn directions(&self) -> usize {
        self.steps.len()
    }

    /// (Δy, Δh) of a step.
    pub fn offset(&self, k: usize) -> (i32, i32) {
        self.steps[k]
    }

    /// Where step `k` leads; none where it would leave the map, or into the ground.
    #[inline]
    pub fn step(&self, from: Cell, k: usize, way: Way) -> Option<Cell> {
        let (x, y, level) = self.at(from);
        let (dy, dh) = self.steps[k];
        let (here, there) = match way {
            Way::Forward => (self.start, self.goal),
            Way::Backward => (self.goal, self.start),
        };
        let (first, last) = (self.at(here).0, self.at(there).0);
        if x == last {
            return None;
        }
        let x = if last > first { x + 1 } else { x - 1 };
        let (y, level) = (y.checked_add_signed(dy)?, level.checked_add_signed(dh)?);
        if y >= self.height || level > self.rules.levels {
            return None;
        }
        let to = self.place(x, y, level);
        self.is_free(to).then_some(to)
    }

    /// The number of the step between two places; they are a step apart.
    pub fn step_between(&self, from: Cell, to: Cell) -> usize {
        let ((_, y, h), (_, to_y, to_h)) = (self.at(from), self.at(to));
        let rank = |from: u32, to: u32, reach: u32| (to + reach - from) as usize;
        let across = 2 * self.rules.max_climb as usize + 1;
        rank(y, to_y, self.rules.max_aside) * across + rank(h, to_h, self.rules.max_climb)
    }

    /// √(1 + Δy² + Δh²) of a step between two places, cells and levels counting 1 each.
    #[inline]
    pub fn length(&self, from: Cell, to: Cell) -> f64 {
        let ((_, y, h), (_, to_y, to_h)) = (self.at(from), self.at(to));
        let (dy, dh) = (f64::from(y.abs_diff(to_y)), f64::from(h.abs_diff(to_h)));
        libm::sqrt(1.0 + dy * dy + dh * dh)
    }

    /// What the step costs by the scenario's measure, forwards.
    #[inline]
    pub fn cost(&self, from: Cell, to: Cell) -> f64 {
        let level = f64::from(to / self.area());
        self.length(from, to) + if self.rules.measure == Measure::Cost { level } else { 0.0 }
    }

    /// Σ of the costs of a path from start to goal.
    pub fn value(&self, path: &[Cell]) -> f64 {
        path.windows(2).map(|s| self.cost(s[0], s[1])).sum()
    }

    /// Whether the levels of start and goal lie on the ground or above it, given its heights in metres there.
    pub fn ends_above_ground(&self, start_ground: f64, goal_ground: f64) -> [bool; 2] {
        let above = |place: Cell, ground: f64| ground <= f64::from(place / self.area()) * self.rules.level;
        [above(self.start, start_ground), above(self.goal, goal_ground)]
    }

    /// By place: whether the end of the way can be reached from it.
    pub fn leads_to_end(&self, way: Way) -> Vec<bool> {
        let (end, back) = match way {
            Way::Forward => (self.goal, Way::Backward),
            Way::Backward => (self.start, Way::Forward),
        };
        let mut reached = vec![false; self.places()];
        let mut open = vec![end];
        reached[end as usize] = true;
        while let Some(place) = open.pop() {
            for next in (0..self.directions()).filter_map(|k| self.step(place, k, back)) {
                if !std::mem::replace(&mut reached[next as usize], true) {
                    open.push(next);
                }
            }
        }
        reached
    }

    /// Whether a path leads from start to goal.
    pub fn reachable(&self) -> bool {
        self.leads_to_end(Way::Forward)[self.start as usize]
    }

    /// Column, row and level of a path's places.
    pub fn points(&self, path: &[Cell]) -> Vec<(Point, u32)> {
        path.iter().map(|&p| self.at(p)).map(|(x, y, level)| (Point::new(x, y), level)).collect()
    }
}

/// The lowest level of a cell whose altitude is above the ground (strictly), 1 at least; beyond all levels where the cell is blocked.
fn floor_level(grid: &Grid, rules: &SliceRules, unit: f64, c: Cell) -> u32 {
    let ground = grid.heights().map_or(0.0, |h| f64::from(h[c as usize]) * unit);
    let above = |level: &u32| ground < f64::from(*level) * rules.level;
    if grid.is_blocked(c) { u32::MAX } else { (1..=rules.levels).find(above).unwrap_or(u32::MAX) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rules() -> SliceRules {
        SliceRules { level: 10.0, levels: 3, max_aside: 1, max_climb: 1, start_level: 1, goal_level: 2, measure: Measure::Cost }
    }

    /// 3 × 2; the middle column is 10 m above, 25 m below.
    fn slices() -> Slices {
        let grid = Grid::open(3, 2).unwrap().with_heights(vec![0.0, 10.0, 20.0, 0.0, 25.0, 0.0]).unwrap();
        Slices::new(&grid, rules(), 1.0, 0, 2)
    }

    #[test]
    fn rules_that_fit_have_ten_levels_up_to_the_top_and_ends_above_the_ground() {
        const NO: f32 = f32::NAN;
        let heights = vec![10.0, 20.0, 30.0, 40.0, 15.0, 25.0, 35.0, 45.0, NO, 30.0, NO, 100.0];
        let grid = Grid::open(4, 3).unwrap().with_heights(heights).unwrap();
        let fit = |unit, start, level| SliceRules::fitting_map(&grid, unit, start, Point::new(3, 2), level);
        // Levels of 10 m: the start on 10 m → floor(1) + 1 = 2, the goal on 100 m → 11.
        let rules = fit(1.0, Point::new(0, 0), None);
        let ends = (rules.start_level, rules.goal_level);
        assert_eq!((rules.level, rules.levels, rules.max_aside, rules.max_climb, ends), (10.0, 20, 2, 2, (2, 11)));
        assert_eq!(rules.measure, Measure::Cost);
        assert_eq!(fit(0.5, Point::new(0, 0), None).level, 5.0);
        // No height counts as 0, and so does what lies outside.
        assert_eq!([Point::new(0, 2), Point::new(9, 9)].map(|start| fit(1.0, start, None).start_level), [1, 1]);
        let given = fit(1.0, Point::new(0, 0), Some(4.0));
        assert_eq!((given.level, given.start_level, given.goal_level), (4.0, 3, 20));
        let flat = Grid::open(2, 2).unwrap().with_heights(vec![0.0; 4]).unwrap();
        let rules = SliceRules::fitting_map(&flat, 1.0, Point::new(0, 0), Point::new(1, 1), None);
        assert_eq!((rules.level, rules.start_level, rules.goal_level), (1.0, 1, 1));
    }

    #[test]
    fn places_are_free_strictly_above_the_ground() {
        let s = slices();
        assert_eq!(s.at(s.start()), (0, 0, 1));
        assert_eq!(s.at(s.goal()), (2, 0, 2));
        // Level 1 of the middle column lies at 10 m: on the ground above, in it below.
        assert_eq!([1, 2, 3].map(|h| s.is_free(s.place(1, 0, h))), [false, true, true]);
        assert_eq!([1, 2, 3].map(|h| s.is_free(s.place(1, 1, h))), [false, false, true]);
        // The goal lies on the ground and is free; nothing else of its slice is.
        assert_eq!([1, 2, 3].map(|h| s.is_free(s.place(2, 0, h))), [false, true, false]);
    }

    #[test]
    fn steps_and_costs_by_hand() {
        let s = slices();
        let next: Vec<Cell> = (0..s.directions()).filter_map(|k| s.step(s.start(), k, Way::Forward)).collect();
        assert_eq!(next, [s.place(1, 0, 2)]);
        let back: Vec<Cell> = (0..s.directions()).filter_map(|k| s.step(s.goal(), k, Way::Backward)).collect();
        assert_eq!(back, [s.place(1, 0, 2), s.place(1, 0, 3), s.place(1, 1, 3)]);
        for k in 0..s.directions() {
            assert!(s.step(s.start(), k, Way::Forward).is_none_or(|to| s.step_between(s.start(), to) == k));
        }
        let path = [s.start(), next[0], s.goal()];
        assert_eq!(s.value(&path), (2f64.sqrt() + 2.0) + (1.0 + 2.0));
        assert!(s.reachable());
        assert_eq!(s.slices(), 2);
    }
}
