//! Where ants of the terrain paper walk: places, and the numbered steps between them, on a surface or by slices.
//!
//! A step adds the same to a place's number wherever it is taken; so a walk needs no more than which steps are feasible.

use std::sync::Arc;

use crate::map::{ALL_DIRECTIONS, Cell, DIRECTIONS, Direction, Moves, Slices, Way};
use crate::param_choice;
use crate::planner::Objective;
use crate::scenario::Scenario;

/// A place: a cell, or `cell + area · level`.
pub type Place = Cell;

param_choice! {
    /// Which of the scenario's steps ants take: section 4.4 has 16 directions in place of 8.
    pub enum Directions {
        /// every step that the scenario allows: with 16 moves 16 directions, by slices as far aside as its rules go
        All = "all",
        /// steps to neighbours alone, of the paper's figure 1(a): at most the 8 around a cell, by slices one row aside at most
        Eight = "eight",
    }
}

/// The places of a scenario and the steps between them. Lengths and positions in cells; by slices a level counts as one.
pub trait Space: Clone + Send {
    /// What a path is measured by.
    const OBJECTIVE: Objective;

    /// Places are numbered below this.
    fn places(&self) -> usize;
    /// Cells of the map; the cell of a place is the remainder.
    fn area(&self) -> usize;
    /// Where paths begin and where they end.
    fn ends(&self) -> [Place; 2];
    /// Steps are numbered below this.
    fn steps(&self) -> usize;
    /// Where a step leads; none where it is not allowed, nor from a place that is not free.
    fn step(&self, from: Place, k: usize, way: Way) -> Option<Place>;
    /// What a step adds to a place's number.
    fn delta(&self, k: usize, way: Way) -> i32;
    /// L_ij of a feasible step, as η counts it.
    fn length(&self, from: Place, to: Place, k: usize) -> f64;
    /// What a path from start to goal is worth, by the scenario's measure.
    fn value(&self, path: &[Place]) -> f64;
    /// x, y, z, as the field counts them: by slices a level may be more or less than one cell.
    fn position(&self, place: Place) -> [f64; 3];
    /// z as it is: by slices the level.
    fn height(&self, place: Place) -> f64;
    /// The same as the distances of η count it: by slices a level may be more or less than one cell.
    fn seen_at(&self, place: Place) -> [f64; 3] {
        self.position(place)
    }
    /// ρ, the distance to the ground, at least 1, which is the distance between two places.
    fn clearance(&self, place: Place) -> f64;
    /// Height of the highest place.
    fn top(&self) -> f64;

    /// Where ants that go this way set out.
    fn origin(&self, way: Way) -> Place {
        self.ends()[usize::from(way == Way::Backward)]
    }

    /// Where ants that go this way are to arrive.
    fn target(&self, way: Way) -> Place {
        self.ends()[usize::from(way == Way::Forward)]
    }
}

/// From cell to cell: on a plane, where all heights are 0, or on the ground of a terrain. Steps lead back as they led there.
#[derive(Clone)]
pub struct Surface {
    scenario: Arc<Scenario>,
    top: f64,
    directions: Directions,
}

impl Surface {
    /// Of a scenario that does not move by slices, with all of its steps.
    pub fn new(scenario: Arc<Scenario>) -> Self {
        let height = |c| scenario.moves.relief().map_or(0.0, |relief| relief.height(c));
        let free = (0..scenario.grid.len() as Cell).filter(|&c| !scenario.grid.is_blocked(c));
        let top = free.map(height).fold(f64::NEG_INFINITY, f64::max);
        Self { scenario, top, directions: Directions::All }
    }

    /// The same with these steps alone.
    pub fn only(self, directions: Directions) -> Self {
        Self { directions, ..self }
    }
}

impl Space for Surface {
    const OBJECTIVE: Objective = Objective::Length;

    fn places(&self) -> usize {
        self.area()
    }

    fn area(&self) -> usize {
        self.scenario.grid.len()
    }

    fn ends(&self) -> [Place; 2] {
        [self.scenario.start, self.scenario.goal]
    }

    fn steps(&self) -> usize {
        let sixteen = self.scenario.spec.movement.moves == Moves::Sixteen && self.directions == Directions::All;
        if sixteen { ALL_DIRECTIONS } else { DIRECTIONS }
    }

    fn step(&self, from: Place, k: usize, _: Way) -> Option<Place> {
        let moves = &self.scenario.moves;
        (moves.all_bits(from) >> k & 1 == 1).then(|| moves.step(from, k as Direction))
    }

    fn delta(&self, k: usize, _: Way) -> i32 {
        self.scenario.moves.delta[k]
    }

    fn length(&self, from: Place, _: Place, k: usize) -> f64 {
        self.scenario.moves.length(from, k as Direction)
    }

    fn value(&self, path: &[Place]) -> f64 {
        self.scenario.path_length(path)
    }

    fn position(&self, place: Place) -> [f64; 3] {
        let p = self.scenario.grid.point(place);
        [f64::from(p.x), f64::from(p.y), self.height(place)]
    }

    fn height(&self, place: Place) -> f64 {
        self.scenario.moves.relief().map_or(0.0, |relief| relief.height(place))
    }

    /// On the ground there is nothing between it and the ant.
    fn clearance(&self, _: Place) -> f64 {
        1.0
    }

    fn top(&self) -> f64 {
        self.top
    }
}

/// From column to column above the ground.
#[derive(Clone)]
pub struct Layered {
    scenario: Arc<Scenario>,
    slices: Arc<Slices>,
    /// Levels per unit of the heights.
    scale: f64,
    /// Cells that a level counts as in the distances of η.
    level_height: f64,
    /// The same in the field.
    field_level_height: f64,
    directions: Directions,
    /// +1 where the goal lies to the right of the start, −1 to the left.
    onward: i32,
}

impl Layered {
    /// Of a scenario that moves by these slices, with all of its steps; a level counts as one cell.
    pub fn new(scenario: Arc<Scenario>, slices: Arc<Slices>) -> Self {
        let unit = scenario.spec.terrain.map_or(1.0, |terrain| terrain.vertical_unit);
        let onward = if slices.at(slices.goal()).0 > slices.at(slices.start()).0 { 1 } else { -1 };
        let scale = unit / slices.rules().level;
        Self { scenario, slices, scale, level_height: 1.0, field_level_height: 1.0, directions: Directions::All, onward }
    }

    /// The same with these steps alone, and with levels that the distances of η count as so many cells.
    pub fn seen_as(self, directions: Directions, level_height: f64) -> Self {
        Self { directions, level_height, ..self }
    }

    /// The same with levels that the distances and directions of the field count as so many cells.
    pub fn field_by(self, field_level_height: f64) -> Self {
        Self { field_level_height, ..self }
    }
}

impl Space for Layered {
    const OBJECTIVE: Objective = Objective::SliceCost;

    fn places(&self) -> usize {
        self.slices.places()
    }

    fn area(&self) -> usize {
        self.slices.area() as usize
    }

    fn ends(&self) -> [Place; 2] {
        [self.slices.start(), self.slices.goal()]
    }

    fn steps(&self) -> usize {
        self.slices.directions()
    }

    fn step(&self, from: Place, k: usize, way: Way) -> Option<Place> {
        let taken = self.directions == Directions::All || self.slices.offset(k).0.abs() <= 1;
        (taken && self.slices.is_free(from)).then(|| self.slices.step(from, k, way))?
    }

    fn delta(&self, k: usize, way: Way) -> i32 {
        let (dy, dh) = self.slices.offset(k);
        let aside = dy * self.scenario.grid.width() as i32 + dh * self.slices.area() as i32;
        aside + if way == Way::Forward { self.onward } else { -self.onward }
    }

    fn length(&self, from: Place, to: Place, _: usize) -> f64 {
        let ((_, y, h), (_, to_y, to_h)) = (self.slices.at(from), self.slices.at(to));
        let (dy, dh) = (f64::from(y.abs_diff(to_y)), f64::from(h.abs_diff(to_h)) * self.level_height);
        libm::sqrt(1.0 + dy * dy + dh * dh)
    }

    fn value(&self, path: &[Place]) -> f64 {
        self.slices.value(path)
    }

    fn position(&self, place: Place) -> [f64; 3] {
        let (x, y, level) = self.slices.at(place);
        [f64::from(x), f64::from(y), f64::from(level) * self.field_level_height]
    }

    fn height(&self, place: Place) -> f64 {
        f64::from(self.slices.at(place).2)
    }

    fn seen_at(&self, place: Place) -> [f64; 3] {
        let (x, y, level) = self.slices.at(place);
        [f64::from(x), f64::from(y), f64::from(level) * self.level_height]
    }

    fn clearance(&self, place: Place) -> f64 {
        let ground = self.scenario.grid.heights().map_or(0.0, |h| f64::from(h[self.slices.cell(place) as usize]));
        let above = f64::from(self.slices.at(place).2) - ground * self.scale;
        // Also where there is no data, which is NaN.
        if above > 1.0 { above } else { 1.0 }
    }

    fn top(&self) -> f64 {
        f64::from(self.slices.rules().levels)
    }
}
