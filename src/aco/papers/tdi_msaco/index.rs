//! The terminal distance index, which stands in for pheromone: of each cell the shortest way to the goal that ants have shown.

use crate::map::Cell;
use crate::path::Path;
use crate::planner::held;
use crate::scenario::Scenario;

/// Of a cell from which no ant has come to the goal.
const NOWHERE: Cell = Cell::MAX;

/// The index of every cell, and the cell that one goes to from there.
#[derive(Debug, Clone)]
pub struct Index {
    to_goal: Vec<f64>,
    next: Vec<Cell>,
    goal: Cell,
}

impl Index {
    /// Of a map of so many cells before any ant has arrived: 0 at the goal, `initial` everywhere else, in cells.
    pub fn new(cells: usize, goal: Cell, initial: f64) -> Self {
        let mut to_goal = vec![initial; cells];
        to_goal[goal as usize] = 0.0;
        Self { to_goal, next: vec![NOWHERE; cells], goal }
    }

    /// TDI of a cell, in cells.
    pub fn get(&self, cell: Cell) -> f64 {
        self.to_goal[cell as usize]
    }

    /// The same where an ant has come from there to the goal; infinite elsewhere.
    pub fn known(&self, cell: Cell) -> f64 {
        if cell == self.goal || self.next[cell as usize] != NOWHERE { self.get(cell) } else { f64::INFINITY }
    }

    /// Takes in the way of an ant that has arrived, from its end to its beginning: TDI_i = d_ij + TDI_j where that is less, and from i one
    /// goes to j. Calls `changed` for each cell whose index is another now.
    pub fn learn(&mut self, scenario: &Scenario, way: &[Cell], mut changed: impl FnMut(Cell)) {
        for pair in way.windows(2).rev() {
            let (i, j) = (pair[0], pair[1]);
            let by_j = scenario.grid.point(i).distance(scenario.grid.point(j)) + self.get(j);
            if by_j < self.get(i) {
                self.to_goal[i as usize] = by_j;
                self.next[i as usize] = j;
                changed(i);
            }
        }
    }

    /// The way from a cell to the goal that goes on to the next cell each time; none where it does not begin.
    ///
    /// It ends: an index only ever falls, and that of a cell was above the next one's when it was set.
    pub fn way_from(&self, cell: Cell) -> Option<Path> {
        let mut way = vec![cell];
        let mut at = cell;
        while at != self.goal {
            at = self.next[at as usize];
            if at == NOWHERE {
                return None;
            }
            way.push(at);
        }
        Some(way)
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.to_goal) + held(&self.next)
    }
}
