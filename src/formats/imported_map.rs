//! A map from a file, and pieces of it.

use super::{Kind, TerrainOptions, ends};
use crate::error::{FormatError, Notice};
use crate::map::{Grid, Point, Window};
use crate::scenario::{Goal, ScenarioSpec, TerrainMoves};

/// A map with everything that can be planned on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// What the file was.
    pub kind: Kind,
    /// The map.
    pub grid: Grid,
    /// The question asked on it; its name is the file's where the format has none.
    pub spec: ScenarioSpec,
    /// What was assumed, chosen or left out.
    pub notices: Vec<Notice>,
    /// Of a ROS map, the cells that nobody has looked at and that count as blocked, as the blocked cells of a grid; none where there are none.
    pub unknown: Option<Grid>,
}

impl Imported {
    /// Whether start or goal had to be chosen because the file names none.
    pub fn ends_were_chosen(&self) -> bool {
        self.notices.iter().any(|n| n.kind == ends::CHOSEN)
    }

    /// Lets the notice about chosen ends tell only of those that are not given elsewhere either.
    pub fn ends_are_given(&mut self, start: bool, goal: bool) {
        let cell = |p: Point| format!("({}, {})", p.x, p.y);
        let left = match (start, goal) {
            (false, false) => return,
            (false, true) => Some(format!("the map names no start: {} is used", cell(self.spec.start))),
            (true, false) => {
                let goal = self.spec.goals.first().map_or(self.spec.start, |g| g.at);
                Some(format!("the map names no goal: {} is used", cell(goal)))
            }
            (true, true) => None,
        };
        if self.ends_were_chosen() {
            self.notices.retain(|n| n.kind != ends::CHOSEN);
            self.notices.extend(left.map(|message| Notice::new(ends::CHOSEN, message)));
        }
    }

    /// A window of the map, and the same ground in another number of cells.
    ///
    /// # Errors
    /// [`FormatError::Window`], or [`crate::error::ScenarioError::MapSize`].
    pub fn piece(mut self, TerrainOptions { crop, size }: TerrainOptions) -> Result<Self, FormatError> {
        let window = crop.unwrap_or(Window { x: 0, y: 0, width: self.grid.width(), height: self.grid.height() });
        self.grid = self.grid.cropped(window)?;
        let (width, height) = size.unwrap_or((window.width, window.height));
        self.grid = self.grid.resampled(width, height)?;
        if let Some(unknown) = self.unknown {
            self.unknown = Some(unknown.cropped(window)?.resampled(width, height)?);
        }
        let scaled = |at: u32, from: u32, of: u32, to: u32| {
            (u64::from(at.checked_sub(from)?) * u64::from(to) / u64::from(of)).try_into().ok()
        };
        let moved = |p: Point| {
            let x = scaled(p.x, window.x, window.width, width)?;
            let y = scaled(p.y, window.y, window.height, height)?;
            Some(Point::new(x, y)).filter(|&p| self.grid.is_free_at(i64::from(p.x), i64::from(p.y)))
        };
        let [of, to] = [f64::from(window.width) * f64::from(window.height), f64::from(width) * f64::from(height)];
        let chosen = self.ends_were_chosen();
        let mut goals = Vec::new();
        for goal in self.spec.goals.drain(..).filter(|_| !chosen) {
            let at = moved(goal.at).filter(|&at| goals.iter().all(|g: &Goal| g.at != at));
            goals.extend(at.map(|at| Goal { at, ..goal }));
        }
        let start = moved(self.spec.start).filter(|_| !chosen);
        let ends = ends::complete(&self.grid, start, goals.first().map(|g| g.at))?;
        if goals.is_empty() {
            goals.push(Goal::new(ends.goal, ""));
        }
        let resolution = self.spec.resolution * libm::sqrt(of / to);
        self.spec.world = self.spec.world.take().and_then(|world| {
            let (left, below) = (window.x, self.spec.height - window.y - window.height);
            // Cells that are no squares afterwards have no place.
            let evenly = u64::from(window.width) * u64::from(height) == u64::from(window.height) * u64::from(width);
            evenly.then(|| world.moved(f64::from(left) * self.spec.resolution, f64::from(below) * self.spec.resolution))
        });
        self.spec = ScenarioSpec { width, height, resolution, start: ends.start, goals, ..self.spec };
        lift_ends(&self.grid, &mut self.spec);
        self.notices.retain(|n| n.kind != ends::CHOSEN);
        self.notices.extend(ends.notice);
        Ok(self)
    }

    /// Swaps free and blocked cells, and unknown ones are free like all that were blocked. Ends that the file names stay free, others are chosen anew.
    ///
    /// # Errors
    /// [`FormatError::NoFreeCell`].
    pub fn invert(mut self) -> Result<Self, FormatError> {
        self.unknown = None;
        let chosen = self.ends_were_chosen();
        let goal = self.spec.goals.first().map_or(self.spec.start, |g| g.at);
        for cell in 0..self.grid.len() as u32 {
            let point = self.grid.point(cell);
            let is_end = !chosen && (point == self.spec.start || point == goal);
            let blocked = !is_end && !self.grid.is_blocked(cell);
            self.grid.set_blocked(cell, blocked);
        }
        if chosen {
            let ends = ends::complete(&self.grid, None, None)?;
            self.spec = ScenarioSpec { start: ends.start, ..self.spec };
            self.spec.goals.iter_mut().for_each(|g| g.at = ends.goal);
            self.notices.retain(|n| n.kind != ends::CHOSEN);
            self.notices.extend(ends.notice);
        }
        Ok(self)
    }
}

/// By slices: raises the levels of start and goal to the ground on which they have come to lie.
fn lift_ends(grid: &Grid, spec: &mut ScenarioSpec) {
    let (Some(heights), Some(terrain)) = (grid.heights(), &mut spec.terrain) else { return };
    let TerrainMoves::Slices(rules) = &mut terrain.moves else { return };
    let (level, unit) = (rules.level, terrain.vertical_unit);
    let lowest = |at: Point| libm::ceil(f64::from(heights[grid.cell(at) as usize]) * unit / level) as u32;
    rules.start_level = rules.start_level.max(lowest(spec.start));
    rules.goal_level = spec.goals.first().map_or(rules.goal_level, |goal| rules.goal_level.max(lowest(goal.at)));
}
