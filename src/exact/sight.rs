//! All cells that a cell sees on a plane: what [`in_sight`](crate::path::in_sight) says of one segment, worked out for all segments from a
//! cell at once.
//!
//! The plane around a cell is eight octants. In each of them x counts columns from the cell and y rows, and slopes are 0 ≤ y/x < 1; the
//! diagonal is walked by itself. Column by column, what is still open to sight is a list of wedges between two slopes. A blocked cell (x, y)
//! hides the slopes between its lower right corner, (y − ½)/(x + ½), and its upper left one, (y + ½)/(x − ½), from the columns behind it. A
//! ray that passes exactly through a corner of cells has the cells on both of its sides beside it: the corner rule tells whether the slope
//! of a corner belongs to the wedge. All in whole numbers, so it is exact.

use crate::map::{Cell, CornerRule, Grid, Movement, Moves, Point};

/// A slope at the end of a wedge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slope {
    pub(super) rise: i32,
    pub(super) run: i32,
    /// Whether the slope itself does not belong to the wedge.
    pub(super) is_open: bool,
}

impl Slope {
    /// Of two ends at the same slope the open one is narrower.
    fn is_below(self, other: Self) -> bool {
        i64::from(self.rise) * i64::from(other.run) < i64::from(other.rise) * i64::from(self.run)
    }

    /// The higher of two lower ends.
    pub(super) fn or_higher(self, other: Self) -> Self {
        if self.is_below(other) || (!other.is_below(self) && other.is_open) { other } else { self }
    }

    /// The lower of two upper ends.
    pub(super) fn or_lower(self, other: Self) -> Self {
        if other.is_below(self) || (!self.is_below(other) && other.is_open) { other } else { self }
    }

    /// How high it is at `twice_x` half columns, in half rows, as a quotient.
    pub(super) fn at(self, twice_x: i32) -> (i64, i64) {
        (i64::from(self.rise) * i64::from(twice_x), i64::from(self.run))
    }
}

/// What is open to sight between two slopes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wedge {
    pub(super) low: Slope,
    pub(super) high: Slope,
}

impl Wedge {
    pub(super) fn is_empty(self) -> bool {
        let is_point = !self.low.is_below(self.high);
        is_point && (self.high.is_below(self.low) || self.low.is_open || self.high.is_open)
    }

    /// Whether the slope to a place so many half columns and half rows away lies within.
    #[inline]
    pub(super) fn contains(self, (x, y): (i32, i32)) -> bool {
        let ((low, low_run), (high, high_run)) = (self.low.at(x), self.high.at(x));
        let (above, below) = (i64::from(y) * low_run - low, high - i64::from(y) * high_run);
        above >= i64::from(self.low.is_open) && below >= i64::from(self.high.is_open)
    }

    /// The rows whose centres in column x lie within; none where the first is above the last.
    fn centres(self, x: i32) -> (i32, i32) {
        let (low, high) = (self.low.at(x), self.high.at(x));
        let first = if self.low.is_open { low.0.div_euclid(low.1) + 1 } else { -(-low.0).div_euclid(low.1) };
        let last = if self.high.is_open { -(-high.0).div_euclid(high.1) - 1 } else { high.0.div_euclid(high.1) };
        (first as i32, last as i32)
    }

    /// The rows of the cells in column x that it passes, with the one below whose corner a closed end touches.
    fn rows(self, x: i32) -> (i32, i32) {
        let (low, high) = (self.low.at(2 * x - 1), self.high.at(2 * x + 1));
        let first =
            if self.low.is_open { (low.0 + low.1).div_euclid(2 * low.1) } else { -(-(low.0 + low.1)).div_euclid(2 * low.1) - 1 };
        let last = -(high.1 - high.0).div_euclid(2 * high.1);
        (first.max(0) as i32, last as i32)
    }
}

/// Looks around on one map.
#[derive(Debug, Clone)]
pub(super) struct Sight {
    movement: Movement,
    width: i32,
    /// Whether cells are free, row by row within a border of blocked ones.
    free: Vec<bool>,
    /// The wedges of the column at work, and of the next.
    wedges: Vec<Wedge>,
    next: Vec<Wedge>,
}

/// An octant around a cell: where the next column and the next row lead.
#[derive(Clone, Copy)]
struct Octant {
    from: Point,
    column: (i32, i32),
    row: (i32, i32),
}

impl Octant {
    /// The place of (x, y) in a table of lines of this length; `from` has a place of its own there.
    #[inline(always)]
    fn place(self, from: i32, line: i32, x: i32, y: i32) -> i32 {
        from + x * (self.column.0 + self.column.1 * line) + y * (self.row.0 + self.row.1 * line)
    }
}

const STRAIGHT: [(i32, i32); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

impl Sight {
    pub(super) fn new(grid: &Grid, movement: Movement) -> Self {
        let (width, height) = (grid.width() as usize, grid.height());
        let mut free = vec![false; (width + 2) * (height as usize + 2)];
        for (y, row) in (0..height).zip(free.chunks_exact_mut(width + 2).skip(1)) {
            row[1..=width].iter_mut().zip(grid.row(y)).for_each(|(free, blocked)| *free = !blocked);
        }
        Self { movement, width: width as i32, free, wedges: Vec::new(), next: Vec::new() }
    }

    /// What it holds, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.free.capacity() + (self.wedges.capacity() + self.next.capacity()) * size_of::<Wedge>()
    }

    /// Calls `visit` with every cell that a free cell sees, with its distance in cells, and true; itself not, and those on its row and its
    /// column twice. With false it asks about cells that are passed, but whose centres are out of sight. Cells of which the answer is false
    /// block the view as obstacles do. Returns how many cells were looked at.
    pub(super) fn around(&mut self, from: Point, mut visit: impl FnMut(Cell, f64, bool) -> bool) -> u64 {
        let mut looked = 0;
        for (column, row) in STRAIGHT.into_iter().zip(STRAIGHT.into_iter().cycle().skip(1)) {
            let octant = Octant { from, column, row };
            if self.movement.moves == Moves::Four {
                looked += self.along(octant, 0, &mut visit);
                continue;
            }
            looked += self.along(octant, 1, &mut visit);
            looked += self.octant(octant, &mut visit);
            looked += self.octant(Octant { column: row, row: column, ..octant }, &mut visit);
        }
        looked
    }

    #[inline(always)]
    fn is_free(&self, octant: Octant, x: i32, y: i32) -> bool {
        let line = self.width + 2;
        let from = (octant.from.y as i32 + 1) * line + octant.from.x as i32 + 1;
        self.free[octant.place(from, line, x, y) as usize]
    }

    #[inline(always)]
    fn cell(&self, octant: Octant, x: i32, y: i32) -> Cell {
        octant.place(octant.from.y as i32 * self.width + octant.from.x as i32, self.width, x, y) as Cell
    }

    /// Along the columns with so many rows to each: none, or 1 on the diagonal.
    fn along(&self, octant: Octant, rows: i32, visit: &mut impl FnMut(Cell, f64, bool) -> bool) -> u64 {
        let free = |x, y| self.is_free(octant, x, y);
        let beside = |x: i32| rows == 0 || self.movement.corner_rule.allows(free(x - 1, x), free(x, x - 1));
        let mut visit = |x| visit(self.cell(octant, x, x * rows), distance(x, x * rows), true);
        (1..).take_while(|&x| free(x, x * rows) && beside(x) && visit(x)).count() as u64 + 1
    }

    fn octant(&mut self, octant: Octant, visit: &mut impl FnMut(Cell, f64, bool) -> bool) -> u64 {
        let mut looked = 0;
        let all = Wedge { low: Slope { rise: 0, run: 1, is_open: false }, high: Slope { rise: 1, run: 1, is_open: true } };
        self.wedges.clear();
        self.wedges.push(all);
        let mut x = 1;
        while !self.wedges.is_empty() {
            for k in 0..self.wedges.len() {
                looked += self.narrow(octant, x, self.wedges[k], visit);
            }
            std::mem::swap(&mut self.wedges, &mut self.next);
            self.next.clear();
            x += 1;
        }
        looked
    }

    /// Visits what a wedge shows of column x, and keeps what its cells leave of the wedge for the columns behind it.
    fn narrow(&mut self, octant: Octant, x: i32, wedge: Wedge, visit: &mut impl FnMut(Cell, f64, bool) -> bool) -> u64 {
        let rule = self.movement.corner_rule;
        let ((first, last), (first_centre, last_centre)) = (wedge.rows(x), wedge.centres(x));
        let looked = u64::from((last - first + 1).max(0) as u32);
        let (mut y, mut low) = (first, wedge.low);
        let mut is_open = |all: &Self, y| {
            let is_seen = first_centre <= y && y <= last_centre;
            all.is_free(octant, x, y) && visit(all.cell(octant, x, y), distance(x, y), is_seen)
        };
        while y <= last {
            if is_open(self, y) {
                y += 1;
                continue;
            }
            let below = Slope { rise: 2 * y - 1, run: 2 * x + 1, is_open: rule == CornerRule::BothFree };
            self.keep(Wedge { low, high: wedge.high.or_lower(below) });
            let Some(above) = (y + 1..=last).find(|&y| is_open(self, y)) else {
                // Their upper left corner is above the wedge: nothing of it is left there.
                return looked;
            };
            let is_pinched = !rule.allows(false, self.is_free(octant, x - 1, above));
            low = low.or_higher(Slope { rise: 2 * above - 1, run: 2 * x - 1, is_open: is_pinched });
            y = above + 1;
        }
        self.keep(Wedge { low, high: wedge.high });
        looked
    }

    fn keep(&mut self, wedge: Wedge) {
        if !wedge.is_empty() {
            self.next.push(wedge);
        }
    }
}

/// As [`Point::distance`], bit for bit.
#[inline(always)]
fn distance(x: i32, y: i32) -> f64 {
    let (dx, dy) = (f64::from(x), f64::from(y));
    libm::sqrt(dx * dx + dy * dy)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{Generator, generate};
    use crate::path::in_sight;

    /// Compares what each free cell sees with the rule of one segment; how many cells are seen in all.
    fn agrees(grid: &Grid, movement: Movement) -> usize {
        let mut sight = Sight::new(grid, movement);
        let cells = || (0..grid.len() as Cell).map(|c| grid.point(c));
        let mut all = 0;
        for from in cells().filter(|&p| !grid.is_blocked(grid.cell(p))) {
            let mut seen = vec![false; grid.len()];
            let looked = sight.around(from, |cell, away, is_seen| {
                assert_eq!(away.to_bits(), grid.point(cell).distance(from).to_bits());
                seen[cell as usize] |= is_seen;
                true
            });
            for to in cells().filter(|&to| to != from) {
                let expected = in_sight(grid, movement, from, to);
                assert_eq!(seen[grid.cell(to) as usize], expected, "{from:?} to {to:?}, {movement:?}: {grid:?}");
                all += usize::from(expected);
            }
            assert!(!seen[grid.cell(from) as usize] && looked > 0);
        }
        all
    }

    #[test]
    fn it_sees_what_the_segments_see() {
        let mut seen = 0;
        for seed in 0..60 {
            let (width, height) = (1 + seed * 7 % 23, 1 + seed * 5 % 19);
            let density = [0.05, 0.15, 0.3, 0.5][seed as usize % 4];
            let kind = if seed % 5 == 4 { Generator::Cave } else { Generator::Random };
            let grid = generate(kind, width, height, seed, density).expect("a map").grid;
            for corner_rule in CornerRule::ALL {
                for moves in [Moves::Four, Moves::Eight] {
                    seen += agrees(&grid, Movement { moves, corner_rule });
                }
            }
        }
        assert!(seen > 100_000, "{seen} pairs see each other");
    }
}
