//! Connecting two cells by opening as few walls as possible: a breadth-first search over 4 moves in which entering a wall
//! costs 1 and entering a free cell 0.

use std::collections::VecDeque;

use crate::map::{Cell, Grid, Point};

/// How many walls must be opened to get from a cell to every other one, and the way back.
pub(super) struct Openings {
    /// Walls on the best way; 0 = connected as it is.
    pub walls: Vec<u32>,
    back: Vec<Cell>,
}

/// Opens the fewest walls that connect both cells under 4 moves; both ends become free.
pub(super) fn connect(grid: &mut Grid, start: Point, goal: Point) {
    let (start, goal) = (grid.cell(start), grid.cell(goal));
    grid.set_blocked(start, false);
    let found = Openings::from(grid, start);
    let mut at = goal;
    while at != start {
        grid.set_blocked(at, false);
        at = found.back[at as usize];
    }
}

impl Openings {
    /// Searches from a cell: each cell is settled once, walls wait at the back of the queue.
    pub(super) fn from(grid: &Grid, start: Cell) -> Self {
        let mut walls = vec![u32::MAX; grid.len()];
        let mut back = vec![start; grid.len()];
        let mut queue = VecDeque::from([start]);
        walls[start as usize] = 0;
        while let Some(at) = queue.pop_front() {
            for next in neighbours(grid, at) {
                let blocked = grid.is_blocked(next);
                let cost = walls[at as usize] + u32::from(blocked);
                if cost < walls[next as usize] {
                    walls[next as usize] = cost;
                    back[next as usize] = at;
                    if blocked { queue.push_back(next) } else { queue.push_front(next) }
                }
            }
        }
        Self { walls, back }
    }
}

/// The cells a step of 4 moves away.
fn neighbours(grid: &Grid, at: Cell) -> impl Iterator<Item = Cell> + use<> {
    let (p, w, h) = (grid.point(at), grid.width(), grid.height());
    let steps = [(p.x > 0, -1), (p.x + 1 < w, 1), (p.y > 0, -(w as i32)), (p.y + 1 < h, w as i32)];
    steps.into_iter().filter(|s| s.0).map(move |s| at.wrapping_add_signed(s.1))
}
