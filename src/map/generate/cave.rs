//! A cave by a cellular automaton: random rock, then a few rounds in which every cell follows the majority of the nine around it.

use super::openings::{Openings, connect};
use super::{Chance, Dice, Generated};
use crate::map::{Grid, Point};

/// Share of rock in the beginning.
const ROCK: f64 = 0.45;

/// Rounds of smoothing.
const ROUNDS: u32 = 5;

/// Rock among the nine cells from which on a cell becomes rock.
const MAJORITY: u8 = 5;

/// Smallest side at which the world beyond the map counts as rock, so that the cave closes.
const CLOSED_SIDE: u32 = 12;

/// Grows a cave on an open map: automaton, ends in roomy places, the fewest openings between them, pockets filled.
pub(super) fn grow(mut grid: Grid, dice: &mut Dice) -> Generated {
    let rock = Chance::of(ROCK);
    let mut cells: Vec<u8> = (0..grid.len()).map(|_| u8::from(dice.happens(rock))).collect();
    for _ in 0..ROUNDS {
        cells = smooth(&cells, grid.width() as usize, grid.height() as usize);
    }
    for (cell, &rock) in cells.iter().enumerate() {
        grid.set_blocked(cell as u32, rock != 0);
    }
    let (start, goal) = ends(&grid);
    connect(&mut grid, start, goal);
    fill_pockets(&mut grid, start);
    Generated::plane(grid, start, goal)
}

/// One round; sums over rows first, then over columns.
fn smooth(cells: &[u8], w: usize, h: usize) -> Vec<u8> {
    let beyond = u8::from(w.min(h) >= CLOSED_SIDE as usize);
    let mut sums = vec![3 * beyond; w * (h + 2)];
    for y in 0..h {
        let row = &cells[y * w..(y + 1) * w];
        for x in 0..w {
            let left = if x == 0 { beyond } else { row[x - 1] };
            sums[(y + 1) * w + x] = left + row[x] + row.get(x + 1).copied().unwrap_or(beyond);
        }
    }
    (0..w * h).map(|i| u8::from(sums[i] + sums[i + w] + sums[i + 2 * w] >= MAJORITY)).collect()
}

/// The roomiest cells near both corners: with all eight around free, else free, else the corner itself.
fn ends(grid: &Grid) -> (Point, Point) {
    let (w, h) = (grid.width(), grid.height());
    let roomy = |p: Point| {
        let (x, y) = (i64::from(p.x), i64::from(p.y));
        (-1..=1).all(|dy| (-1..=1).all(|dx| grid.is_free_at(x + dx, y + dy)))
    };
    let free = |p: Point| !grid.is_blocked(grid.cell(p));
    let nearest = |corner: Point, fits: &dyn Fn(Point) -> bool| {
        let far = |p: &Point| u64::from(p.x.abs_diff(corner.x)) + u64::from(p.y.abs_diff(corner.y));
        (0..grid.len() as u32).map(|c| grid.point(c)).filter(|&p| fits(p)).min_by_key(far)
    };
    let end = |corner| nearest(corner, &roomy).or_else(|| nearest(corner, &free)).unwrap_or(corner);
    (end(Point::new(0, 0)), end(Point::new(w - 1, h - 1)))
}

/// Turns every free cell that cannot be reached from the start into rock.
fn fill_pockets(grid: &mut Grid, start: Point) {
    let found = Openings::from(grid, grid.cell(start));
    for (cell, &walls) in found.walls.iter().enumerate() {
        if walls > 0 {
            grid.set_blocked(cell as u32, true);
        }
    }
}
