//! The any-angle search inside a part of the map that grows: bends lie in the part, lines of sight lead over the whole map, and what was
//! expanded stays.
//!
//! An expanded cell tells all cells that it sees, inside the part or not; whose turn it is outside waits until the part has grown. So at any time
//! some bend of a shortest polyline is open or waits, reached at its true length, as in `search/within.rs`: the least f of those is a lower bound,
//! never below that of a point among the obstacles, which is the start's own f.

use std::sync::Arc;

use super::MOST_LOOKED_AT;
use super::in_sight::InSight;
use crate::exact::best_first::{Rules, Tree};
use crate::exact::region::{Part, Region};
use crate::map::Cell;
use crate::metrics::SAME_LENGTH;
use crate::path::Path;
use crate::scenario::Scenario;

/// The search for the shortest polyline from start to goal of a scenario on a plane, inside a part of its map, at first none of it.
///
/// ```
/// # use std::sync::Arc;
/// use formicarium::exact::PolylinesWithin;
/// use formicarium::map::{Grid, Movement, Point};
/// use formicarium::scenario::Scenario;
///
/// let scenario = Scenario::on(Grid::open(9, 9)?, Movement::default(), Point::new(0, 0), Point::new(3, 4))?;
/// let mut search = PolylinesWithin::new(&Arc::new(scenario));
/// search.widen(0, 0);
/// assert!(search.go_on(u64::MAX));
/// assert_eq!((search.best(), search.lower_bound()), (Some((vec![0, 39], 5.0)), 5.0));
/// # Ok::<(), formicarium::error::ScenarioError>(())
/// ```
#[derive(Clone)]
pub struct PolylinesWithin {
    scenario: Arc<Scenario>,
    rules: InSight,
    tree: Tree,
    region: Part,
    /// The least f of what is open or waits.
    least: f64,
    expansions: u64,
}

impl PolylinesWithin {
    /// None of the map is of the part yet. Finds out what is left to go for a point from every cell.
    pub fn new(scenario: &Arc<Scenario>) -> Self {
        let rules = InSight::led_alone(scenario, MOST_LOOKED_AT);
        let (cells, start) = (scenario.grid.len(), scenario.start);
        let least = rules.to_goal(scenario, start);
        let mut tree = Tree::along(scenario, cells, least);
        tree.begin(start, least, start == scenario.goal);
        let region = Part::none(scenario.grid.width(), cells);
        Self { scenario: Arc::clone(scenario), rules, tree, region, least, expansions: 0 }
    }

    /// Takes the square of cells up to `radius` cells away from a cell into the part, diagonally too.
    pub fn widen(&mut self, cell: Cell, radius: u8) {
        self.region.widen(cell, radius);
    }

    /// Takes every cell of the map into the part.
    pub fn widen_to_all(&mut self) {
        self.region.widen_to_all();
    }

    /// A polyline of this length, in cells, is known from elsewhere: only shorter ones are looked for.
    pub fn bound_by(&mut self, length: f64) {
        self.tree.bound_by(self.tree.bound().min(length));
    }

    /// Searches on until nothing that bends inside the part can be shorter. False where that would take more than so many expansions, or where
    /// the search has looked at as many cells as it may.
    pub fn go_on(&mut self, most: u64) -> bool {
        self.reopen();
        let ended = self.work_off(self.expansions.saturating_add(most));
        let open = self.tree.least().map_or(f64::INFINITY, |(_, f)| f);
        let waiting = self.region.waiting.iter().filter(|&&(g, cell)| g <= self.tree.g(cell));
        let f = |&(g, cell): &(f64, Cell)| g + self.rules.to_goal(&self.scenario, cell);
        // Rounding may put f a hair below that of the start.
        self.least = waiting.map(f).fold(open, f64::min).max(self.least);
        ended
    }

    /// The shortest polyline found, from start to goal, with its length in cells; none while there is none.
    pub fn best(&self) -> Option<(Path, f64)> {
        self.tree.has_arrived().then(|| {
            let path = self.tree.way();
            let length = self.scenario.path_length(&path);
            (path, length)
        })
    }

    /// No polyline is shorter, in cells: the least f of what is open, or the best length where nothing can beat it.
    pub fn lower_bound(&self) -> f64 {
        // Each segment, a cell long at least, may be counted too long by the tolerance.
        if self.is_proven() { self.tree.bound() } else { self.least * (1.0 - SAME_LENGTH) }
    }

    /// Whether no polyline is shorter than the best one known.
    pub fn is_proven(&self) -> bool {
        !self.tree.is_below_bound(self.least)
    }

    /// Cells expanded so far.
    pub fn expansions(&self) -> u64 {
        self.expansions
    }

    /// Whether each cell of the map is of the part, row by row.
    pub fn part(&self) -> &[bool] {
        self.region.cells()
    }

    /// What it holds, in bytes, its own size not counted, nor what its copies share.
    pub fn bytes(&self) -> usize {
        self.rules.bytes() + self.tree.bytes() + self.region.bytes()
    }

    /// Opens what waits at cells that are inside by now; what cannot lead to a shorter polyline is dropped.
    fn reopen(&mut self) {
        for (g, state) in std::mem::take(&mut self.region.waiting) {
            let f = g + self.rules.to_goal(&self.scenario, state);
            let is_hopeful = g <= self.tree.g(state) && self.tree.is_below_bound(f);
            if is_hopeful && self.region.takes(state, g) {
                self.tree.file(state, g, f);
            }
        }
    }

    /// Expands what is open inside the part, the least f first; false where the search may not go on and more is open.
    fn work_off(&mut self, end: u64) -> bool {
        while let Some((cell, _)) = self.tree.least() {
            if self.region.takes(cell, self.tree.g(cell)) {
                if self.expansions >= end || self.rules.is_spent() {
                    return false;
                }
                self.expansions += 1;
                self.tree.take_least();
                self.rules.expand(&self.scenario, cell, &mut self.tree);
            } else {
                self.tree.take_least();
            }
        }
        true
    }
}
