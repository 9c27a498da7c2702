//! A perfect maze by depth-first search with backtracking: long winding corridors, one cell wide.
//!
//! Rooms sit at even places of a lattice, walls at odd ones. A lattice has an odd number of lines; where the map's side is even,
//! one line of walls in the middle (the seam) is drawn two cells thick, so that the maze fills the map and stays perfect.

use super::{Dice, Generated, frame};
use crate::map::{Grid, Point};

/// One axis of the lattice.
#[derive(Clone, Copy)]
struct Axis {
    /// Number of rooms.
    rooms: u32,
    /// First cell inside the frame.
    first: u32,
    /// The lattice line that is two cells thick; `u32::MAX` if none.
    seam: u32,
}

impl Axis {
    fn new(side: u32, frame: u32) -> Self {
        let inner = side - 2 * frame;
        let even = inner.is_multiple_of(2);
        let rooms = if even { inner / 2 } else { inner.div_ceil(2) };
        Self { rooms, first: frame, seam: if even { (rooms - 1) | 1 } else { u32::MAX } }
    }

    /// The cell at which a lattice line begins.
    fn cell(self, line: u32) -> u32 {
        self.first + line + u32::from(line > self.seam)
    }

    /// The cells of a lattice line.
    fn cells(self, line: u32) -> std::ops::Range<u32> {
        self.cell(line)..self.cell(line + 1)
    }
}

/// The maze under construction.
struct Carver {
    grid: Grid,
    x: Axis,
    y: Axis,
    visited: Vec<bool>,
}

/// Carves a maze into a map without free cells.
pub(super) fn carve(grid: Grid, dice: &mut Dice) -> Generated {
    let frame = frame(&grid);
    let (x, y) = (Axis::new(grid.width(), frame), Axis::new(grid.height(), frame));
    let mut carver = Carver { grid, x, y, visited: vec![false; x.rooms as usize * y.rooms as usize] };
    let mut trail = vec![(0, 0)];
    carver.enter((0, 0));
    while let Some(&room) = trail.last() {
        let Some(next) = carver.unvisited(room, dice) else {
            trail.pop();
            continue;
        };
        carver.open(room.0 + next.0, room.1 + next.1);
        carver.enter(next);
        trail.push(next);
    }
    let goal = Point::new(x.cell(2 * (x.rooms - 1)), y.cell(2 * (y.rooms - 1)));
    Generated::plane(carver.grid, Point::new(x.first, y.first), goal)
}

impl Carver {
    fn enter(&mut self, (i, j): (u32, u32)) {
        self.visited[(j * self.x.rooms + i) as usize] = true;
        self.open(2 * i, 2 * j);
    }

    /// Frees the cells of one place of the lattice.
    fn open(&mut self, line_x: u32, line_y: u32) {
        for y in self.y.cells(line_y) {
            for x in self.x.cells(line_x) {
                self.grid.set_blocked(self.grid.cell(Point::new(x, y)), false);
            }
        }
    }

    /// A random neighbouring room that has not been visited.
    fn unvisited(&self, (i, j): (u32, u32), dice: &mut Dice) -> Option<(u32, u32)> {
        let around = [(i.wrapping_sub(1), j), (i + 1, j), (i, j.wrapping_sub(1)), (i, j + 1)];
        let fresh =
            |&&(i, j): &&(u32, u32)| i < self.x.rooms && j < self.y.rooms && !self.visited[(j * self.x.rooms + i) as usize];
        let count = around.iter().filter(fresh).count() as u32;
        if count == 0 { None } else { around.iter().filter(fresh).nth(dice.below(count) as usize).copied() }
    }
}
