//! A* inside a part of the map that grows: what was expanded stays, and the search goes on where it had to stop.
//!
//! A way that leads out of the part waits at its first cell outside. When the part has grown, the ways that wait at cells of it are open again.
//! At any time some cell on a shortest path is open or waits, reached at its true cost (Hart, Nilsson, Raphael 1968, lemma 1, which holds for
//! every order of expansions): so the least f of those is a lower bound of the shortest length, and once it is not below the best path found, that
//! path is proven, wherever the search has not been.

use std::sync::Arc;

use super::{Contours, Path, Search};
use crate::exact::Distance;
use crate::exact::region::{Part, Region};
use crate::map::Cell;
use crate::metrics::SAME_LENGTH;
use crate::scenario::Scenario;

/// A* from start to goal of a scenario inside a part of its map, at first none of it.
///
/// ```
/// # use std::sync::Arc;
/// use formicarium::exact::Within;
/// use formicarium::map::{Grid, Movement, Point};
/// use formicarium::scenario::Scenario;
///
/// let scenario = Scenario::on(Grid::open(9, 9)?, Movement::default(), Point::new(0, 4), Point::new(8, 4))?;
/// let mut search = Within::new(&Arc::new(scenario));
/// (36..45).for_each(|cell| search.widen(cell, 0));
/// assert!(search.go_on(u64::MAX));
/// assert_eq!((search.best().map(|(_, length)| length), search.lower_bound()), (Some(8.0), 8.0));
/// # Ok::<(), formicarium::error::ScenarioError>(())
/// ```
#[derive(Clone)]
pub struct Within {
    search: Search<Distance, Part>,
}

impl Within {
    /// None of the map is of the part yet.
    pub fn new(scenario: &Arc<Scenario>) -> Self {
        let part = Part::none(scenario.grid.width(), scenario.grid.len());
        let ends = (scenario.start, scenario.goal);
        let mut search = Search::inside(Arc::clone(scenario), part, ends.0, ends.1, Distance::of(scenario));
        search.prepare();
        Self { search }
    }

    /// Takes the square of cells up to `radius` cells away from a cell into the part, diagonally too.
    pub fn widen(&mut self, cell: Cell, radius: u8) {
        self.search.region.widen(cell, radius);
    }

    /// Takes every cell of the map into the part.
    pub fn widen_to_all(&mut self) {
        self.search.region.widen_to_all();
    }

    /// A path of this length, in cells, is known from elsewhere: only shorter ones are looked for.
    pub fn bound_by(&mut self, length: f64) {
        self.search.bound = self.search.bound.min(length);
    }

    /// Searches on until nothing inside the part can lead to a shorter path. False where that would take more than so many expansions.
    pub fn go_on(&mut self, most: u64) -> bool {
        self.search.reopen();
        let end = self.expansions().saturating_add(most);
        let ended = self.search.work_off(end);
        self.search.set_aside();
        ended
    }

    /// The shortest path found, from start to goal, with its length in cells; none while there is none.
    pub fn best(&self) -> Option<(Path, f64)> {
        let search = &self.search;
        search.ways.g(search.goal).is_finite().then(|| {
            let path = search.path();
            let length = search.scenario.path_length(&path);
            (path, length)
        })
    }

    /// No path is shorter, in cells: the least f of what is open, or the best length where nothing can beat it.
    pub fn lower_bound(&self) -> f64 {
        let least = self.search.least_open();
        if least >= self.search.bound - SAME_LENGTH { self.search.bound } else { least }
    }

    /// Whether no path is shorter than the best one known.
    pub fn is_proven(&self) -> bool {
        self.lower_bound() == self.search.bound
    }

    /// Cells expanded so far.
    pub fn expansions(&self) -> u64 {
        self.search.progress.effort.cell_expansions
    }

    /// Whether each cell of the map is of the part, row by row.
    pub fn part(&self) -> &[bool] {
        self.search.region.cells()
    }

    /// What it holds, in bytes, its own size not counted.
    pub fn bytes(&self) -> usize {
        let sorted = self.search.sorted.as_ref().map_or(0, |sorted| sorted.capacity() * size_of::<super::Open>());
        self.search.ways.bytes() + self.search.frontier.bytes() + self.search.region.bytes() + sorted
    }
}

impl Search<Distance, Part> {
    /// Opens the ways that wait at cells that are inside by now; those that cannot lead to a shorter path are dropped.
    fn reopen(&mut self) {
        for (g, cell) in std::mem::take(&mut self.region.waiting) {
            let f = g + self.to_goal(cell);
            let is_hopeful = g <= self.ways.g(cell) && f < self.bound - SAME_LENGTH;
            if is_hopeful && self.region.takes(cell, g) {
                self.file(cell, g, f);
            }
        }
    }

    /// Expands what is open, the least f first; false once `end` cells have been expanded and more are open.
    fn work_off(&mut self, end: u64) -> bool {
        loop {
            if let Some(cell) = self.pop() {
                if self.progress.effort.cell_expansions >= end {
                    self.region.waiting.push((self.ways.g(cell), cell));
                    return false;
                }
                self.expand(cell);
            } else if self.frontier.has_more() {
                self.frontier.next();
                self.sort();
            } else {
                return true;
            }
        }
    }

    /// Has all that is still open wait.
    fn set_aside(&mut self) {
        self.region.waiting.extend(self.frontier.take_all().map(|waiting| (waiting.g, waiting.cell)));
        if let Some(sorted) = &mut self.sorted {
            self.region.waiting.extend(std::mem::take(sorted).into_iter().map(|open| (open.g, open.state)));
        }
    }
}
