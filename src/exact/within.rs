//! A* inside a part of the map that grows: what was expanded stays, and the search goes on where it had to stop.
//!
//! A way that leads out of the part waits at its first cell outside. When the part has grown, the ways that wait at cells of it are open again.
//! At any time some cell on a shortest path is open or waits, reached at its true cost (Hart, Nilsson, Raphael 1968, lemma 1, which holds for
//! every order of expansions): so the least f of those is a lower bound of the shortest length, and once it is not below the best path found, that
//! path is proven, wherever the search has not been. The same holds of the turn index and the weighted sum, over states of a cell and the
//! direction of the step that led there: `directed/growing.rs`.

use std::sync::Arc;

use super::Distance;
use super::directed::{Directed, SumCosts, TurnCosts};
use super::growing::Growing;
use super::region::Part;
use super::search::Search;
use crate::map::Cell;
use crate::metrics::WeightedSum;
use crate::path::Path;
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
pub struct Within {
    search: Box<dyn Growing>,
}

impl Clone for Within {
    fn clone(&self) -> Self {
        Self { search: self.search.boxed() }
    }
}

impl Within {
    /// For the shortest path. None of the map is of the part yet.
    pub fn new(scenario: &Arc<Scenario>) -> Self {
        let ends = (scenario.start, scenario.goal);
        let part = Part::none(scenario.grid.width(), scenario.grid.len());
        let search = Search::inside(Arc::clone(scenario), part, ends.0, ends.1, Distance::of(scenario));
        Self { search: Box::new(search.prepared()) }
    }

    /// For the path with the smallest turn index V(d, r).
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use formicarium::exact::Within;
    /// # use formicarium::map::{Grid, Movement, Point};
    /// # use formicarium::scenario::Scenario;
    /// let scenario = Scenario::on(Grid::open(9, 9)?, Movement::default(), Point::new(0, 0), Point::new(5, 4))?;
    /// let mut search = Within::by_turn_index(&Arc::new(scenario));
    /// search.widen_to_all();
    /// assert!(search.go_on(u64::MAX) && search.is_proven());
    /// // Four diagonal steps, and one along a row that turns.
    /// assert!(search.best().is_some_and(|(_, v)| (v - (4.0 * 2f64.sqrt() + 1.2)).abs() < 1e-9));
    /// # Ok::<(), formicarium::error::ScenarioError>(())
    /// ```
    pub fn by_turn_index(scenario: &Arc<Scenario>) -> Self {
        Self { search: Box::new(Directed::new(scenario, TurnCosts::new(scenario))) }
    }

    /// For the path with the smallest weighted sum J.
    pub fn by_sum(scenario: &Arc<Scenario>, sum: WeightedSum) -> Self {
        let mut costs = SumCosts::new(scenario, sum);
        costs.prepare(scenario);
        Self { search: Box::new(Directed::new(scenario, costs)) }
    }

    /// Takes the square of cells up to `radius` cells away from a cell into the part, diagonally too.
    pub fn widen(&mut self, cell: Cell, radius: u8) {
        self.search.part_mut().widen(cell, radius);
    }

    /// Takes every cell of the map into the part.
    pub fn widen_to_all(&mut self) {
        self.search.part_mut().widen_to_all();
    }

    /// A path of this cost, in cells, is known from elsewhere: only better ones are looked for.
    pub fn bound_by(&mut self, cost: f64) {
        self.search.bound_by(self.search.bound().min(cost));
    }

    /// Searches on until nothing inside the part can lead to a better path. False where that would take more than so many expansions.
    pub fn go_on(&mut self, most: u64) -> bool {
        self.search.go_on(most)
    }

    /// The best path found, from start to goal, with its cost in cells: its length, V or J; none while there is none.
    pub fn best(&self) -> Option<(Path, f64)> {
        self.search.best()
    }

    /// No path costs less, in cells: the least f of what is open, or the best cost where nothing can beat it.
    pub fn lower_bound(&self) -> f64 {
        self.search.lower_bound()
    }

    /// Whether no path costs less than the best one known.
    pub fn is_proven(&self) -> bool {
        self.lower_bound() == self.search.bound()
    }

    /// Cells, or states of cells, expanded so far.
    pub fn expansions(&self) -> u64 {
        self.search.expansions()
    }

    /// Whether each cell of the map is of the part, row by row.
    pub fn part(&self) -> &[bool] {
        self.search.part().cells()
    }

    /// What it holds, in bytes, its own size not counted.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.search) + self.search.bytes()
    }
}
