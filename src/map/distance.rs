//! How far every cell is from the nearest blocked one: the exact Euclidean distance transform.
//!
//! A. Meijster, J. B. T. M. Roerdink, W. H. Hesselink, "A general algorithm for computing distance transforms in linear time",
//! Mathematical Morphology and its Applications to Image and Signal Processing (2000) 331–340. Whole numbers throughout.

use super::grid::Grid;

/// Squared distance in cells, centre to centre, of every cell to the nearest blocked one, row by row; 0 of a blocked cell. `u32::MAX` on a map
/// without obstacles. The world beyond the border is none.
///
/// ```
/// use formicarium::map::{Grid, squared_distances};
///
/// let grid = Grid::from_bytes(3, 2, &[1, 0, 0, 0, 0, 0])?;
/// assert_eq!(squared_distances(&grid), [0, 1, 4, 1, 2, 5]);
/// # Ok::<(), formicarium::error::ScenarioError>(())
/// ```
pub fn squared_distances(grid: &Grid) -> Vec<u32> {
    let width = grid.width() as usize;
    let gaps = gaps_in_columns(grid);
    let mut squared = vec![u32::MAX; grid.len()];
    let mut hull = Vec::with_capacity(width);
    for (gaps, out) in gaps.chunks_exact(width).zip(squared.chunks_exact_mut(width)) {
        lower_hull(gaps, &mut hull);
        read_hull(gaps, &hull, out);
    }
    squared
}

/// No blocked cell in a column.
const NONE: u32 = u32::MAX;

/// Distance of every cell to the nearest blocked one of its column.
fn gaps_in_columns(grid: &Grid) -> Vec<u32> {
    let width = grid.width() as usize;
    let mut gaps: Vec<u32> = grid.blocked().iter().map(|&blocked| if blocked { 0 } else { NONE }).collect();
    let rows = grid.height() as usize;
    for (y, from) in (1..rows).map(|y| (y, y - 1)).chain((1..rows).rev().map(|y| (y - 1, y))) {
        for x in 0..width {
            let beyond = gaps[from * width + x].saturating_add(1);
            let here = &mut gaps[y * width + x];
            *here = beyond.min(*here);
        }
    }
    gaps
}

/// A column whose parabola is the lowest of a row from `begins` on.
#[derive(Clone, Copy)]
struct Lowest {
    column: i64,
    begins: i64,
}

/// The parabolas (x − column)² + gap² that are lowest somewhere in a row, from the left.
fn lower_hull(gaps: &[u32], hull: &mut Vec<Lowest>) {
    hull.clear();
    let squared = |column: i64| i64::from(gaps[column as usize]).pow(2);
    let value = |x: i64, column: i64| (x - column).pow(2) + squared(column);
    for column in (0..gaps.len() as i64).filter(|&x| gaps[x as usize] != NONE) {
        while hull.last().is_some_and(|last| value(last.begins, last.column) > value(last.begins, column)) {
            hull.pop();
        }
        let Some(last) = hull.last() else {
            hull.push(Lowest { column, begins: 0 });
            continue;
        };
        // The last place where the one before is not higher.
        let until =
            (column.pow(2) - last.column.pow(2) + squared(column) - squared(last.column)).div_euclid(2 * (column - last.column));
        if until + 1 < gaps.len() as i64 {
            hull.push(Lowest { column, begins: until + 1 });
        }
    }
}

fn read_hull(gaps: &[u32], hull: &[Lowest], out: &mut [u32]) {
    let mut next = 0;
    for (x, out) in out.iter_mut().enumerate().filter(|_| !hull.is_empty()) {
        while hull.get(next + 1).is_some_and(|later| later.begins <= x as i64) {
            next += 1;
        }
        let column = hull[next].column;
        *out = ((x as i64 - column).pow(2) + i64::from(gaps[column as usize]).pow(2)) as u32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::Cell;

    #[test]
    fn agrees_with_brute_force() {
        for (width, height, one_in) in
            [(1u32, 1u32, 2u32), (1, 9, 3), (9, 1, 3), (13, 8, 2), (17, 23, 9), (31, 12, 40), (6, 6, 1_000_000)]
        {
            let bit = |i: u32| u8::from(i.wrapping_mul(2_654_435_761).wrapping_add(width) % one_in == 0);
            let cells: Vec<u8> = (0..width * height).map(bit).collect();
            let grid = Grid::from_bytes(width, height, &cells).unwrap();
            let found = squared_distances(&grid);
            for c in 0..grid.len() as Cell {
                let p = grid.point(c);
                let away = |b: Cell| grid.point(b).x.abs_diff(p.x).pow(2) + grid.point(b).y.abs_diff(p.y).pow(2);
                let best = (0..grid.len() as Cell).filter(|&b| grid.is_blocked(b)).map(away).min().unwrap_or(u32::MAX);
                assert_eq!(found[c as usize], best, "{width} × {height} at {p:?}");
            }
        }
    }
}
