//! Straight walls one cell thick, along rows and columns, of different lengths. They touch and cross as they happen to fall.

use super::{Dice, Generated, cells_of, corner_to_corner};
use crate::map::{Grid, Point};

/// Walls that are tried at most, for each cell of the map: more than the greatest density needs.
const TRIALS: usize = 16;

/// The shortest wall, where the map is as long.
const SHORTEST: u32 = 2;

/// Draws walls on an open map until they cover the density; the last one is as long as is missing.
pub(super) fn place(mut grid: Grid, dice: &mut Dice, density: f64) -> Generated {
    let mut missing = cells_of(&grid, density);
    for _ in 0..TRIALS * grid.len() {
        if missing == 0 {
            break;
        }
        missing -= draw(&mut grid, dice, missing);
    }
    corner_to_corner(grid)
}

/// Draws one wall, and tells how many free cells it took, at most `most`.
fn draw(grid: &mut Grid, dice: &mut Dice, most: usize) -> usize {
    let is_row = dice.below(2) == 0;
    let (side, lines) = if is_row { (grid.width(), grid.height()) } else { (grid.height(), grid.width()) };
    let longest = (2 * side / 5).max(SHORTEST);
    let length = (SHORTEST + dice.below(longest - SHORTEST + 1)).min(side);
    let (from, line) = (dice.below(side - length + 1), dice.below(lines));
    let mut taken = 0;
    for along in from..from + length {
        let cell = grid.cell(if is_row { Point::new(along, line) } else { Point::new(line, along) });
        if taken < most && !grid.is_blocked(cell) {
            grid.set_blocked(cell, true);
            taken += 1;
        }
    }
    taken
}
