//! A tree of cells in line of sight, rooted at the start. A cell is at most one node, so a tree is never larger than its map.
//!
//! The length of the way to a node is added up when it is asked for: a node that is hung elsewhere takes all that hang on it along.

use crate::map::{Cell, Point};
use crate::path::{Path, crossed, line_of_sight};
use crate::planner::held;
use crate::scenario::Scenario;

/// Of a cell that is no node.
const NO_NODE: Cell = Cell::MAX;

/// The tree of one planner.
#[derive(Debug, Clone)]
pub struct Tree {
    /// The cell that each cell hangs on; the root hangs on itself.
    parent: Vec<Cell>,
    /// The nodes in the order in which they joined.
    nodes: Vec<Cell>,
    root: Cell,
    /// Cells along which sight was tried.
    looked_along: u64,
}

impl Tree {
    /// The scenario's start alone.
    pub fn new(scenario: &Scenario) -> Self {
        let mut parent = vec![NO_NODE; scenario.grid.len()];
        parent[scenario.start as usize] = scenario.start;
        Self { parent, nodes: vec![scenario.start], root: scenario.start, looked_along: 0 }
    }

    /// The nodes in the order in which they joined.
    pub fn nodes(&self) -> &[Cell] {
        &self.nodes
    }

    /// Whether a cell is a node.
    pub fn holds(&self, cell: Cell) -> bool {
        self.parent[cell as usize] != NO_NODE
    }

    /// What a node hangs on; none for the root, and for a cell that is no node.
    pub fn parent(&self, cell: Cell) -> Option<Cell> {
        let parent = self.parent[cell as usize];
        (parent != NO_NODE && cell != self.root).then_some(parent)
    }

    /// Hangs a cell on a node; a cell that is none joins.
    pub fn hang(&mut self, cell: Cell, on: Cell) {
        if !self.holds(cell) {
            self.nodes.push(cell);
        }
        self.parent[cell as usize] = on;
    }

    /// Length of the way to a node, in cells; infinite for a cell that is none.
    pub fn cost(&self, scenario: &Scenario, node: Cell) -> f64 {
        if !self.holds(node) {
            return f64::INFINITY;
        }
        let (mut at, mut sum) = (node, 0.0);
        while let Some(parent) = self.parent(at) {
            sum += distance(scenario, parent, at);
            at = parent;
        }
        sum
    }

    /// The way from the root to a node.
    pub fn way(&self, node: Cell) -> Path {
        let mut way = vec![node];
        let mut at = node;
        while let Some(parent) = self.parent(at) {
            way.push(parent);
            at = parent;
        }
        way.reverse();
        way
    }

    /// Whether two cells see each other, counted.
    pub fn sees(&mut self, scenario: &Scenario, a: Cell, b: Cell) -> bool {
        let (from, to) = (scenario.grid.point(a), scenario.grid.point(b));
        self.looked_along += u64::from(from.x.abs_diff(to.x).max(from.y.abs_diff(to.y)));
        line_of_sight(scenario, from, to)
    }

    /// Cells along which sight was tried so far.
    pub fn looked_along(&self) -> u64 {
        self.looked_along
    }

    /// The node nearest to a cell, other than the cell itself; of equal ones the one that joined first.
    pub fn nearest(&self, scenario: &Scenario, to: Cell) -> Option<Cell> {
        let at = scenario.grid.point(to);
        let others = self.nodes.iter().copied().filter(|&node| node != to);
        others.min_by_key(|&node| squared(at, scenario.grid.point(node)))
    }

    /// Writes the nodes within a radius of a cell, other than the cell itself, in the order in which they joined.
    pub fn near(&self, scenario: &Scenario, to: Cell, radius: f64, out: &mut Vec<Cell>) {
        let (at, limit) = (scenario.grid.point(to), radius * radius);
        let is_near = |node: &Cell| *node != to && squared(at, scenario.grid.point(*node)) as f64 <= limit;
        out.clear();
        out.extend(self.nodes.iter().copied().filter(is_near));
    }

    /// Calls `mark` for every cell that a segment of the tree crosses, with the length of the way to it.
    pub fn draw(&self, scenario: &Scenario, mut mark: impl FnMut(Cell, f64)) {
        mark(self.root, 0.0);
        for &node in &self.nodes {
            let Some(parent) = self.parent(node) else { continue };
            let before = self.cost(scenario, parent);
            let segment = [parent, node];
            crossed(scenario.grid.width(), &segment).skip(1).for_each(|c| mark(c, before + distance(scenario, parent, c)));
        }
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.parent) + held(&self.nodes)
    }
}

/// Straight distance between two cells' centres, in cells.
pub fn distance(scenario: &Scenario, a: Cell, b: Cell) -> f64 {
    scenario.grid.point(a).distance(scenario.grid.point(b))
}

/// The same as a whole number, squared.
pub fn squared(a: Point, b: Point) -> u64 {
    let (dx, dy) = (u64::from(a.x.abs_diff(b.x)), u64::from(a.y.abs_diff(b.y)));
    dx * dx + dy * dy
}
