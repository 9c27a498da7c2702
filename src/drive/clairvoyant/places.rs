//! The cells on which the robot may ever stand, and how far each is from the goal at least.

use std::sync::Arc;

use crate::exact::order::distances_from;
use crate::exact::{Distance, Estimate};
use crate::map::{Cell, Grid, Point};
use crate::scenario::{DriveSpec, Scenario, ScenarioSpec};

/// The number of a cell that is no place.
const NONE: u32 = u32::MAX;

/// The cells that hang together with the start where every cell is free that some walls of the drive leave free. On no other cell does any
/// step begin, end or squeeze past a free corner.
pub(super) struct Places {
    pub cells: Vec<Cell>,
    /// By cell.
    numbers: Vec<u32>,
    /// The map of all that is ever free, without what moves.
    widest: Grid,
}

impl Places {
    pub fn of(scenario: &Scenario, moving: &DriveSpec) -> Self {
        let widest = widest(scenario, moving);
        let mut cells = flooded(&widest, scenario.start);
        // Four by four: what lies near each other is reached together.
        let block = |&cell: &Cell| {
            let Point { x, y } = widest.point(cell);
            (y / 4, x / 4, y, x)
        };
        cells.sort_unstable_by_key(block);
        let mut numbers = vec![NONE; widest.len()];
        cells.iter().zip(0..).for_each(|(&cell, number)| numbers[cell as usize] = number);
        Self { cells, numbers, widest }
    }

    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// The number of a cell; none where it is blocked for good, or out of reach.
    pub fn number(&self, cell: Cell) -> Option<usize> {
        Some(self.numbers[cell as usize]).filter(|&number| number != NONE).map(|number| number as usize)
    }

    /// The distance to the goal on an open map, of each place.
    pub fn open_distances(&self, scenario: &Scenario) -> Vec<f64> {
        let distance = Distance::of(scenario);
        let to_goal = |at: Point| distance.to_goal(at.x, at.y);
        self.cells.iter().map(|&cell| to_goal(self.widest.point(cell))).collect()
    }

    /// The cost of the best path to the goal where all is free that ever is, and no obstacle near: no drive costs less.
    pub fn distances(&self, scenario: &Scenario) -> Vec<f64> {
        let spec = ScenarioSpec { robot: None, drive: None, changes: Vec::new(), ..scenario.spec.clone() };
        let widest = Scenario::new(self.widest.clone(), spec).expect("both ends of a usable scenario are free");
        let all = distances_from(&Arc::new(widest), scenario.goal);
        self.cells.iter().map(|&cell| all[cell as usize]).collect()
    }
}

/// The free cells that hang together with one, at their sides or corners.
fn flooded(grid: &Grid, from: Cell) -> Vec<Cell> {
    let (mut seen, mut cells, mut next) = (vec![false; grid.len()], vec![from], 0);
    seen[from as usize] = true;
    while let Some(&cell) = cells.get(next) {
        for near in around(grid, cell).filter(|&near| !grid.is_blocked(near)) {
            if !std::mem::replace(&mut seen[near as usize], true) {
                cells.push(near);
            }
        }
        next += 1;
    }
    cells
}

/// Free where the robot has room between the walls of some step.
fn widest(scenario: &Scenario, moving: &DriveSpec) -> Grid {
    let (mut walls, mut widest) = (scenario.drawn.clone(), scenario.drawn.clone());
    widest.block_all((0..walls.len() as Cell).filter(|&cell| scenario.grid.is_blocked(cell)));
    for change in &moving.changes {
        change.make(&mut walls);
        let felt = scenario.spec.felt(&walls);
        let freed = (0..walls.len() as Cell).filter(|&cell| !felt.is_blocked(cell) && widest.is_blocked(cell));
        for cell in freed.collect::<Vec<_>>() {
            widest.set_blocked(cell, false);
        }
    }
    widest
}

/// A cell and its up to eight neighbours.
fn around(grid: &Grid, cell: Cell) -> impl Iterator<Item = Cell> + use<> {
    let Point { x, y } = grid.point(cell);
    let (width, height) = (grid.width(), grid.height());
    let rows = y.saturating_sub(1)..=(y + 1).min(height - 1);
    rows.flat_map(move |y| (x.saturating_sub(1)..=(x + 1).min(width - 1)).map(move |x| y * width + x))
}
