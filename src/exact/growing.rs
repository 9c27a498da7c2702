//! What a best-first search must offer to be held up at the border of a part of the map, and to go on when that has grown.

use super::region::Part;
use crate::map::Cell;
use crate::metrics::SAME_LENGTH;
use crate::path::Path;

/// What is expanded: a cell, or a state of one.
pub(super) type Node = u32;

/// A best-first search inside a part of the map; what it finds outside waits there ([`Part::waiting`]).
pub(super) trait Growing: Send + Sync {
    /// Where it may go, and what waits.
    fn part(&self) -> &Part;
    /// The same, to let it grow.
    fn part_mut(&mut self) -> &mut Part;
    /// The cell of a node.
    fn cell(&self, node: Node) -> Cell;
    /// The least cost of a path known so far, in cells; infinite while none is.
    fn bound(&self) -> f64;
    /// Sets that.
    fn bound_by(&mut self, cost: f64);
    /// A lower bound of the cost from a cell to the goal.
    fn to_goal(&self, cell: Cell) -> f64;
    /// Whether a way of this cost to a node is the one known, and worth following.
    fn is_current(&self, node: Node, g: f64) -> bool;
    /// Has a node wait for its turn; g is its cost, f that and the estimate.
    fn file(&mut self, node: Node, g: f64, f: f64);
    /// Takes out the open node of the least f, or nearly so, with its cost.
    fn take_next(&mut self) -> Option<(f64, Node)>;
    /// Expands a node: files what follows it inside the part, and has the rest wait.
    fn expand(&mut self, node: Node);
    /// Has all that is still open wait.
    fn set_aside(&mut self);
    /// Nodes expanded so far.
    fn expansions(&self) -> u64;
    /// The best path found, with its cost as it is measured.
    fn best(&self) -> Option<(Path, f64)>;
    /// What it holds, in bytes.
    fn bytes(&self) -> usize;
    /// A copy.
    fn boxed(&self) -> Box<dyn Growing>;

    /// Opens what waits at cells that are inside by now; what cannot lead to a better path is dropped.
    fn reopen(&mut self) {
        for (g, node) in std::mem::take(&mut self.part_mut().waiting) {
            let cell = self.cell(node);
            let f = g + self.to_goal(cell);
            if !self.is_current(node, g) || f >= self.bound() - SAME_LENGTH {
                continue;
            }
            if self.part().has(cell) {
                self.file(node, g, f);
            } else {
                self.part_mut().waiting.push((g, node));
            }
        }
    }

    /// Searches on until nothing inside the part can lead to a better path; false where that would take more than so many expansions.
    fn go_on(&mut self, most: u64) -> bool {
        let end = self.expansions().saturating_add(most);
        self.reopen();
        let ended = loop {
            let Some((g, node)) = self.take_next() else { break true };
            if self.expansions() >= end {
                self.part_mut().waiting.push((g, node));
                break false;
            }
            self.expand(node);
        };
        self.set_aside();
        ended
    }

    /// The least f of what is open or waits, or the bound where nothing can beat it.
    fn lower_bound(&self) -> f64 {
        let open = self.part().waiting.iter().filter(|&&(g, node)| self.is_current(node, g));
        let least = open.map(|&(g, node)| g + self.to_goal(self.cell(node))).fold(f64::INFINITY, f64::min);
        if least >= self.bound() - SAME_LENGTH { self.bound() } else { least }
    }
}
