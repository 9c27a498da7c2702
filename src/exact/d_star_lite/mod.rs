//! Koenig, Likhachev, "D* Lite", AAAI-02 (2002), 476–483: the optimized version, figure 4.
//!
//! | figure 4 | here |
//! |---|---|
//! | `CalculateKey` | [`DStarLite::key`] |
//! | `UpdateVertex` | [`DStarLite::update`] |
//! | `Initialize` | [`DStarLite::prepare`] |
//! | `ComputeShortestPath`, its condition and outdated keys | [`DStarLite::next`] |
//! | `ComputeShortestPath`, one pass of its loop | [`DStarLite::expand`] |
//! | `Main`, moving and changed edges | [`Planner::adapt`] |
//!
//! It searches from the goal to the start. When walls change, with them what cells near them cost, or the start moves, it goes on with what
//! it knows: only cells whose distance to the goal has changed, and lies on the way, are expanded again. Every step is as long as the scenario
//! says, in its own direction.
//!
//! What the paper leaves to exact numbers: of cells on one straight way sums and estimates are equal on paper and differ in the last bit
//! here, and a cell that is passed over for it would leave a wrong way standing. So estimates are a millionth smaller ([`SHARE`]): still
//! consistent, and every cell on a way comes strictly before the start. After a change, rhs is worked out anew for all cells around it,
//! in place of the edges one by one (lines 40 to 47): the same values.

mod queue;

use std::sync::Arc;

use super::SEARCH;
use super::astar::Distance;
use super::contours::untouched;
use super::search::Estimate;
use crate::error::ParamError;
#[cfg(feature = "whole")]
use crate::map::Weights;
use crate::map::{Cell, opposite};
use crate::params::{Values, check_keys};
use crate::path::Path;
use crate::planner::{Granularity, Layer, Planner, PlannerEntry, Progress, Record, Solution, Status, held};
#[cfg(feature = "whole")]
use crate::scenario::Change;
use crate::scenario::Scenario;
#[cfg(feature = "whole")]
use crate::{exact::proof, planner::Certificate};

use queue::{Key, Queue};

/// What an estimate is of the distance on an open map.
const SHARE: f64 = 1.0 - 1e-6;

/// A search at work, or at rest until the map changes.
#[derive(Clone)]
struct DStarLite {
    scenario: Arc<Scenario>,
    /// Of the way from the start.
    estimate: Distance,
    /// Cost to the goal by cell, in cells, as it was when the cell was expanded; empty until the first step.
    g: Vec<f64>,
    /// The same by one step and the g behind it.
    rhs: Vec<f64>,
    /// Which cells were expanded since the map changed last.
    expanded: Vec<bool>,
    /// The cells whose g is not their rhs.
    queue: Queue,
    /// By how much keys were smaller before the start moved: Σ of the estimates between its places.
    k_m: f64,
    /// f at which the contour at work ends.
    contour: f64,
    progress: Progress,
}

impl DStarLite {
    fn new(scenario: Arc<Scenario>) -> Self {
        let estimate = Distance::to(&scenario, scenario.start);
        let (g, rhs, expanded) = (Vec::new(), Vec::new(), Vec::new());
        let (queue, progress) = (Queue::default(), Progress::default());
        Self { scenario, estimate, g, rhs, expanded, queue, k_m: 0.0, contour: 0.0, progress }
    }

    /// h: no more than a way from the start to a cell costs.
    fn estimated(&self, cell: Cell) -> f64 {
        let width = self.scenario.grid.width();
        SHARE * self.estimate.to_goal(cell % width, cell / width)
    }

    fn key(&self, cell: Cell) -> Key {
        let least = self.g[cell as usize].min(self.rhs[cell as usize]);
        Key { f: least + self.estimated(cell) + self.k_m, g: least }
    }

    fn prepare(&mut self) {
        let (cells, goal) = (self.scenario.grid.len(), self.scenario.goal);
        self.g = vec![f64::INFINITY; cells];
        self.rhs = vec![f64::INFINITY; cells];
        self.expanded = vec![false; cells];
        self.queue = Queue::new(cells);
        self.k_m = 0.0;
        self.rhs[goal as usize] = 0.0;
        self.update(goal);
        self.begin_contour();
    }

    /// The next contour begins with the cell that is expanded next.
    fn begin_contour(&mut self) {
        let f = self.next().map(|(_, key)| key.f - self.k_m);
        self.contour = f.filter(|f| f.is_finite()).map_or(0.0, |f| libm::floor(f) + 1.0);
    }

    /// Has a cell wait, or no longer, as its g and rhs demand.
    fn update(&mut self, cell: Cell) {
        if self.g[cell as usize] == self.rhs[cell as usize] {
            self.queue.remove(cell);
        } else {
            self.queue.set(cell, self.key(cell));
        }
    }

    /// The cell to expand next, with its key as it is now; none where the way from the start is known.
    fn next(&mut self) -> Option<(Cell, Key)> {
        let start = self.scenario.start;
        loop {
            let (cell, known) = self.queue.top()?;
            let key = self.key(cell);
            if known < key {
                self.queue.set(cell, key);
                continue;
            }
            let goes_on = key < self.key(start) || self.rhs[start as usize] > self.g[start as usize];
            return goes_on.then_some((cell, key));
        }
    }

    fn expand(&mut self, cell: Cell) {
        self.expanded[cell as usize] = true;
        self.progress.effort.cell_expansions += 1;
        let (g, rhs) = (self.g[cell as usize], self.rhs[cell as usize]);
        if g > rhs {
            self.g[cell as usize] = rhs;
            self.queue.remove(cell);
            self.for_each_before(cell, |search, before, length| search.offer(before, length + rhs));
        } else {
            self.g[cell as usize] = f64::INFINITY;
            self.for_each_before(cell, |search, before, length| {
                if search.rhs[before as usize] == length + g {
                    search.look_again(before);
                }
            });
            self.update(cell);
        }
    }

    /// The cells from which a step leads to a cell, and its length. Every step leads back.
    fn for_each_before(&mut self, cell: Cell, then: impl Fn(&mut Self, Cell, f64)) {
        for d in self.scenario.moves.directions(cell) {
            let before = self.scenario.moves.step(cell, d);
            let length = self.scenario.moves.length(before, opposite(d));
            then(self, before, length);
        }
    }

    /// A way from a cell at this cost.
    fn offer(&mut self, cell: Cell, cost: f64) {
        if cell != self.scenario.goal && cost < self.rhs[cell as usize] {
            self.rhs[cell as usize] = cost;
            self.update(cell);
        }
    }

    /// Works rhs out anew.
    fn look_again(&mut self, cell: Cell) {
        if cell != self.scenario.goal {
            self.rhs[cell as usize] = self.onwards(cell).map_or(f64::INFINITY, |(cost, _)| cost);
        }
        self.update(cell);
    }

    /// The cheapest way on from a cell: what it costs to the goal, and the next cell; the first of equals.
    fn onwards(&self, cell: Cell) -> Option<(f64, Cell)> {
        let moves = &self.scenario.moves;
        let ways = moves.directions(cell).map(|d| {
            let next = moves.step(cell, d);
            (moves.length(cell, d) + self.g[next as usize], next)
        });
        ways.reduce(|best, way| if way.0 < best.0 { way } else { best })
    }

    /// Expands a cell; true where the contour ends with it, or the search.
    fn advance_one(&mut self) -> bool {
        if let Some((cell, _)) = self.next() {
            self.expand(cell);
        }
        let next = self.next();
        if next.is_some_and(|(_, key)| key.f - self.k_m < self.contour) {
            return false;
        }
        self.progress.effort.iterations += 1;
        match next {
            Some(_) => self.begin_contour(),
            None => self.finish(),
        }
        let length = self.progress.best.as_ref().map(|best| best.length);
        self.progress.record(Record::of_search(self.progress.effort.iterations, length));
        true
    }

    fn finish(&mut self) {
        if self.rhs[self.scenario.start as usize] == f64::INFINITY {
            self.progress.status = Status::NoPath;
            return;
        }
        let path = self.path();
        let length = self.scenario.path_length(&path);
        self.progress.effort.constructed_paths += 1;
        self.progress.best = Some(Solution { path, length, iteration: self.progress.effort.iterations, refined: None });
        self.progress.status = Status::Optimal;
    }

    fn path(&self) -> Path {
        let mut path = vec![self.scenario.start];
        let mut at = self.scenario.start;
        while at != self.scenario.goal
            && let Some((_, next)) = self.onwards(at)
        {
            debug_assert!(path.len() < self.g.len(), "a shortest path visits no cell twice");
            path.push(next);
            at = next;
        }
        path
    }

    /// Takes another start on a map with other walls, and the cells around these.
    #[cfg(feature = "whole")]
    fn look_around(&mut self, before: &Scenario, change: &Change) {
        let start = self.scenario.start;
        self.k_m += self.estimated(start);
        self.estimate = Distance::to(&self.scenario, start);
        self.expanded.fill(false);
        change.felt(&before.grid, &self.scenario.grid).into_iter().for_each(|cell| self.look_again(cell));
        self.begin_contour();
    }
}

impl Planner for DStarLite {
    /// A contour ends with its last cell, so that the map can change between two moves as between two contours.
    fn advance(&mut self, by: Granularity) -> Status {
        if self.progress.status.is_finished() {
            return self.progress.status;
        }
        if self.g.is_empty() {
            self.prepare();
        }
        while !self.advance_one() && by == Granularity::Iteration {}
        self.progress.status
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn bytes(&self) -> usize {
        let tables = held(&self.g) + held(&self.rhs) + held(&self.expanded) + self.queue.bytes();
        size_of::<Self>() + self.progress.bytes() + tables
    }

    /// Complete at its end alone: after a change the least key of the queue is hardly a bound worth telling.
    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        proof::certificate(&self.progress, || self.best().map(|best| best.length), || None)
    }

    #[cfg(feature = "whole")]
    fn adapts(&self) -> bool {
        true
    }

    #[cfg(feature = "whole")]
    fn adapt(&mut self, change: &Change, to: &Arc<Scenario>) {
        let before = std::mem::replace(&mut self.scenario, Arc::clone(to));
        self.progress.search_on(change);
        // With another smallest factor keys of before may be no lower bounds.
        let least = |scenario: &Scenario| scenario.moves.weights().map_or(1.0, Weights::least);
        if self.g.is_empty() || before.goal != to.goal || least(&before) != least(to) {
            self.estimate = Distance::to(to, to.start);
            self.g.clear();
        } else {
            self.look_around(&before, change);
        }
    }

    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        out.clear();
        match kind {
            Layer::Visits => out.extend(self.expanded.iter().map(|&expanded| f32::from(u8::from(expanded)))),
            Layer::Cost => out.extend(self.rhs.iter().map(|&cost| cost as f32)),
            _ => return false,
        }
        out.resize(self.scenario.grid.len(), untouched(kind));
        true
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, _seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    check_keys(ENTRY.id, &[], values)?;
    Ok(Box::new(DStarLite::new(Arc::clone(scenario))))
}

/// D* Lite in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "d-star-lite",
    name: "D* Lite",
    summary: "Searches from the goal; when walls change or the robot moves, it repairs what it knows. Always the shortest path.",
    source: "Koenig, Likhachev 2002, AAAI-02, 476–483",
    build,
    ..SEARCH
};

#[cfg(test)]
mod tests;
