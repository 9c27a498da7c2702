//! Start and goal for maps that name none.

use crate::error::{FormatError, Notice};
use crate::map::{Cell, Grid, Point};

/// Kind of the notice that ends were chosen.
pub(super) const CHOSEN: &str = "ends-chosen";

/// Start and goal, and whether they had to be chosen.
pub(super) struct Ends {
    pub start: Point,
    pub goal: Point,
    pub notice: Option<Notice>,
}

/// Completes start and goal: the cells nearest the upper-left and the lower-right corner (rows and columns added up) of the
/// region in which the given end lies, or of the largest region. Cells of one region reach each other under every movement.
///
/// # Errors
/// [`FormatError::NoFreeCell`].
pub(super) fn complete(grid: &Grid, start: Option<Point>, goal: Option<Point>) -> Result<Ends, FormatError> {
    if let (Some(start), Some(goal)) = (start, goal) {
        return Ok(Ends { start, goal, notice: None });
    }
    let region = region(grid, start.or(goal)).ok_or(FormatError::NoFreeCell)?;
    let near = |p: &Point| p.x + p.y;
    let points = || region.iter().map(|&c| grid.point(c));
    let (first, last) = (points().min_by_key(near), points().max_by_key(near));
    let (Some(first), Some(last)) = (first, last) else { return Err(FormatError::NoFreeCell) };
    let (chosen_start, chosen_goal) = (start.unwrap_or(first), goal.unwrap_or(last));
    let notice = notice(chosen_start, chosen_goal, start.is_some(), goal.is_some());
    Ok(Ends { start: chosen_start, goal: chosen_goal, notice: Some(notice) })
}

fn notice(start: Point, goal: Point, has_start: bool, has_goal: bool) -> Notice {
    let missing = match (has_start, has_goal) {
        (false, false) => "start and goal",
        (false, true) => "start",
        _ => "goal",
    };
    let ends = format!("start ({}, {}) and goal ({}, {})", start.x, start.y, goal.x, goal.y);
    Notice::new(CHOSEN, format!("no {missing} is read from the file: {ends} are used"))
        .with("start", format!("{},{}", start.x, start.y))
        .with("goal", format!("{},{}", goal.x, goal.y))
}

/// The cells connected with `seed` by 4 moves, in map order; without a seed, the largest such region (the first of several).
fn region(grid: &Grid, seed: Option<Point>) -> Option<Vec<Cell>> {
    let mut seen = vec![false; grid.len()];
    let mut largest: Option<Vec<Cell>> = None;
    let seeds = seed.map_or(0..grid.len() as Cell, |p| grid.cell(p)..grid.cell(p) + 1);
    for cell in seeds {
        if seen[cell as usize] || grid.is_blocked(cell) {
            continue;
        }
        let cells = flood(grid, cell, &mut seen);
        if largest.as_ref().is_none_or(|l| cells.len() > l.len()) {
            largest = Some(cells);
        }
    }
    largest.map(|mut cells| {
        cells.sort_unstable();
        cells
    })
}

fn flood(grid: &Grid, seed: Cell, seen: &mut [bool]) -> Vec<Cell> {
    let mut found = vec![seed];
    seen[seed as usize] = true;
    let mut next = 0;
    while next < found.len() {
        let p = grid.point(found[next]);
        next += 1;
        for (dx, dy) in [(0, -1), (-1, 0), (1, 0), (0, 1)] {
            let (x, y) = (i64::from(p.x) + dx, i64::from(p.y) + dy);
            if grid.is_free_at(x, y) {
                let cell = grid.cell(Point::new(x as u32, y as u32));
                if !std::mem::replace(&mut seen[cell as usize], true) {
                    found.push(cell);
                }
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(rows: &[&str]) -> Grid {
        let cells: Vec<u8> = rows.iter().flat_map(|r| r.bytes().map(|b| u8::from(b == b'@'))).collect();
        Grid::from_bytes(rows[0].len() as u32, rows.len() as u32, &cells).unwrap()
    }

    #[test]
    fn the_largest_region_counts_not_the_corner() {
        let ends = complete(&grid(&[".@...", "@....", "....@", "...@."]), None, None).unwrap();
        assert_eq!((ends.start, ends.goal), (Point::new(2, 0), Point::new(2, 3)));
        assert_eq!(ends.notice.unwrap().args["start"], "2,0");
    }

    #[test]
    fn a_given_end_decides_the_region() {
        let map = grid(&["..@....", "..@....", "..@...."]);
        let ends = complete(&map, Some(Point::new(1, 1)), None).unwrap();
        assert_eq!((ends.start, ends.goal), (Point::new(1, 1), Point::new(1, 2)));
    }

    #[test]
    fn a_rock_has_no_ends() {
        assert_eq!(complete(&grid(&["@@"]), None, None).err(), Some(FormatError::NoFreeCell));
        let ends = complete(&grid(&["@."]), None, None).unwrap();
        assert_eq!((ends.start, ends.goal), (Point::new(1, 0), Point::new(1, 0)));
    }
}
