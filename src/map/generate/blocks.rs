//! Machinery: rectangular blocks of different sizes that stand apart, with an aisle of one cell or more around each.
//!
//! Blocks are placed one after the other wherever there is room, until they cover the density. About a third of the map can be covered so;
//! of a greater density as many blocks stand as the trials find room for.

use super::{Dice, Generated, cells_of, corner_to_corner};
use crate::map::{Grid, Point};

/// Places that are tried, for each cell of the map.
const TRIALS: usize = 4;

/// The longest side of a block: so many go on the shorter side of the map.
const SHARE_OF_SIDE: u32 = 5;

/// No side is longer than this, however large the map.
const LONGEST_SIDE: u32 = 8;

/// A block, as its first column and row and the size.
struct Block {
    x: u32,
    y: u32,
    width: u32,
    height: u32,
}

/// Places blocks on an open map.
pub(super) fn place(mut grid: Grid, dice: &mut Dice, density: f64) -> Generated {
    let longest = (grid.width().min(grid.height()) / SHARE_OF_SIDE).clamp(1, LONGEST_SIDE);
    let mut missing = cells_of(&grid, density);
    for _ in 0..TRIALS * grid.len() {
        if missing == 0 {
            break;
        }
        let block = Block::anywhere(&grid, longest, dice);
        if block.cells() <= missing && block.has_room(&grid) {
            block.build(&mut grid);
            missing -= block.cells();
        }
    }
    corner_to_corner(grid)
}

impl Block {
    fn anywhere(grid: &Grid, longest: u32, dice: &mut Dice) -> Self {
        let (width, height) = (1 + dice.below(longest), 1 + dice.below(longest));
        let (x, y) = (dice.below(grid.width() - width + 1), dice.below(grid.height() - height + 1));
        Self { x, y, width, height }
    }

    fn cells(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Whether it touches no other block, not even by a corner, and leaves start and goal free.
    fn has_room(&self, grid: &Grid) -> bool {
        let (right, below) = (self.x + self.width, self.y + self.height);
        let is_on_an_end = (self.x, self.y) == (0, 0) || (right, below) == (grid.width(), grid.height());
        let columns = self.x.saturating_sub(1)..(right + 1).min(grid.width());
        let mut rows = self.y.saturating_sub(1)..(below + 1).min(grid.height());
        !is_on_an_end && rows.all(|y| columns.clone().all(|x| !grid.is_blocked(grid.cell(Point::new(x, y)))))
    }

    fn build(&self, grid: &mut Grid) {
        for y in self.y..self.y + self.height {
            for x in self.x..self.x + self.width {
                grid.set_blocked(grid.cell(Point::new(x, y)), true);
            }
        }
    }
}
