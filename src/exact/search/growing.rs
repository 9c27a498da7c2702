//! The search by steps inside a part of the map that grows.

use super::{Contours, Open, Path, Search};
use crate::exact::Distance;
use crate::exact::growing::{Growing, Node};
use crate::exact::region::Part;
use crate::map::Cell;

impl Search<Distance, Part> {
    /// With its tables, and its start open.
    pub(in crate::exact) fn prepared(mut self) -> Self {
        self.prepare();
        self
    }
}

/// A node is a cell.
impl Growing for Search<Distance, Part> {
    fn part(&self) -> &Part {
        &self.region
    }

    fn part_mut(&mut self) -> &mut Part {
        &mut self.region
    }

    #[inline(always)]
    fn cell(&self, node: Node) -> Cell {
        node
    }

    #[inline(always)]
    fn bound(&self) -> f64 {
        self.bound
    }

    fn bound_by(&mut self, cost: f64) {
        self.bound = cost;
    }

    #[inline(always)]
    fn to_goal(&self, cell: Cell) -> f64 {
        Search::to_goal(self, cell)
    }

    #[inline(always)]
    fn is_current(&self, node: Node, g: f64) -> bool {
        g <= self.ways.g(node)
    }

    #[inline(always)]
    fn file(&mut self, node: Node, g: f64, f: f64) {
        Search::file(self, node, g, f);
    }

    #[inline(always)]
    fn take_next(&mut self) -> Option<(f64, Node)> {
        loop {
            if let Some(cell) = self.pop() {
                return Some((self.ways.g(cell), cell));
            }
            if !self.frontier.has_more() {
                return None;
            }
            self.frontier.next();
            self.sort();
        }
    }

    #[inline(always)]
    fn expand(&mut self, node: Node) {
        Search::expand(self, node);
    }

    fn set_aside(&mut self) {
        self.region.waiting.extend(self.frontier.take_all().map(|waiting| (waiting.g, waiting.cell)));
        if let Some(sorted) = &mut self.sorted {
            self.region.waiting.extend(std::mem::take(sorted).into_iter().map(|open| (open.g, open.state)));
        }
    }

    fn expansions(&self) -> u64 {
        self.progress.effort.cell_expansions
    }

    fn best(&self) -> Option<(Path, f64)> {
        self.ways.g(self.goal).is_finite().then(|| {
            let path = self.path();
            let length = self.scenario.path_length(&path);
            (path, length)
        })
    }

    fn bytes(&self) -> usize {
        let sorted = self.sorted.as_ref().map_or(0, |sorted| sorted.capacity() * size_of::<Open>());
        self.ways.bytes() + self.frontier.bytes() + self.region.bytes() + sorted
    }

    fn boxed(&self) -> Box<dyn Growing> {
        Box::new(self.clone())
    }
}
