//! The blocked cells of a map as few rectangles.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::map::Grid;

/// Columns from..to, of which the rectangle goes on.
type Run = (u32, u32);

/// The commands of an SVG path: a rectangle for each run of blocked cells that goes on for some rows unchanged, in cells.
pub(super) fn commands(grid: &Grid) -> String {
    let mut out = String::new();
    // By its columns the first row of each rectangle that has not ended.
    let mut open: BTreeMap<Run, u32> = BTreeMap::new();
    for y in 0..=grid.height() {
        let here = if y < grid.height() { runs(grid, y) } else { Vec::new() };
        let mut kept = BTreeMap::new();
        for run in here {
            kept.insert(run, open.remove(&run).unwrap_or(y));
        }
        for ((from, to), top) in open {
            let (width, height) = (to - from, y - top);
            let _ = write!(out, "M{from} {top}h{width}v{height}h-{width}z");
        }
        open = kept;
    }
    out
}

/// The runs of blocked cells in a row.
fn runs(grid: &Grid, y: u32) -> Vec<Run> {
    let blocked = |x: u32| grid.is_blocked(y * grid.width() + x);
    let mut runs: Vec<Run> = Vec::new();
    for x in (0..grid.width()).filter(|&x| blocked(x)) {
        match runs.last_mut() {
            Some((_, to)) if *to == x => *to += 1,
            _ => runs.push((x, x + 1)),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_that_are_alike_are_one_rectangle() {
        let grid = Grid::from_bytes(4, 3, &[1, 1, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1]).unwrap();
        assert_eq!(commands(&grid), "M3 0h1v1h-1zM0 0h2v2h-2zM3 2h1v1h-1z");
        assert_eq!(commands(&Grid::open(3, 3).unwrap()), "");
    }
}
