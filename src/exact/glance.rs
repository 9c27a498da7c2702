//! What a point sees from a place on a plane, within a cone: centres of cells, and corners at which its shortest way may go on.
//!
//! As `sight.rs`, octant by octant, column by column, with wedges between two slopes, but from centres and from corners of cells, and with the
//! point robot's rule: outlines may be touched. In half cells, so all in whole numbers and exact.

use super::obstacles::{Cone, Obstacles, Place, Slopes};
use super::sight::{Slope, Wedge};
use crate::map::Cell;

/// What is told of what is seen.
pub(super) trait Seen {
    /// A free cell: its centre is in sight, or only a part of it. Whether what is behind it is of interest; else it blocks the view.
    fn cell(&mut self, cell: Cell, at: Place, is_seen: bool) -> bool;
    /// A corner at which a shortest way from the place can go on, by its number.
    fn corner(&mut self, corner: usize, at: Place);
}

/// Looks around, and keeps its lists from one look to the next.
#[derive(Debug, Default)]
pub(super) struct Glance {
    wedges: Vec<Wedge>,
    next: Vec<Wedge>,
    /// Cells looked at so far.
    pub(super) looked: u64,
}

/// An octant around a place: where the next column and the next row lead.
#[derive(Clone, Copy)]
struct Octant {
    from: Place,
    /// 1 around a centre, whose own column begins half a cell before it; 0 around a corner.
    half: i32,
    column: (i32, i32),
    row: (i32, i32),
    /// The cell in column 0 and row 0.
    first: (i32, i32),
}

impl Octant {
    fn new(from: Place, (sx, sy): (i32, i32), columns_along_x: bool) -> Self {
        let half = from.0 & 1;
        // Of a corner's four cells the one in the quadrant; a centre's own.
        let cell = |at: i32, sign: i32| if half == 0 && sign < 0 { at / 2 - 1 } else { at / 2 };
        let (column, row) = if columns_along_x { ((sx, 0), (0, sy)) } else { ((0, sy), (sx, 0)) };
        Self { from, half, column, row, first: (cell(from.0, sx), cell(from.1, sy)) }
    }

    #[inline(always)]
    fn cell(self, x: i32, y: i32) -> (i32, i32) {
        (self.first.0 + x * self.column.0 + y * self.row.0, self.first.1 + x * self.column.1 + y * self.row.1)
    }

    /// The place so many half columns and half rows away.
    #[inline(always)]
    fn place(self, x: i32, y: i32) -> Place {
        (self.from.0 + x * self.column.0 + y * self.row.0, self.from.1 + x * self.column.1 + y * self.row.1)
    }
}

impl Glance {
    /// Looks into a cone.
    pub(super) fn look(&mut self, map: &Obstacles, from: Place, cone: Cone, seen: &mut impl Seen) {
        for (slopes, columns_along_x) in cone.slopes.into_iter().zip([true, false]) {
            if let Some(slopes) = slopes {
                self.octant(map, Octant::new(from, cone.quadrant, columns_along_x), slopes, seen);
            }
        }
    }

    fn octant(&mut self, map: &Obstacles, octant: Octant, (low, high): Slopes, seen: &mut impl Seen) {
        let (x, y) = octant.first;
        if !map.is_free(x, y) {
            return;
        }
        // Of the cells around a corner the first has its centre on the diagonal.
        if octant.half == 0 && !seen.cell(map.cell(x, y), octant.place(1, 1), high.0 == high.1) {
            return;
        }
        let closed = |(rise, run)| Slope { rise, run, is_open: false };
        self.wedges.clear();
        self.wedges.push(Wedge { low: closed(low), high: closed(high) });
        let mut x = 1;
        while !self.wedges.is_empty() {
            for k in 0..self.wedges.len() {
                self.narrow(map, octant, x, self.wedges[k], seen);
            }
            std::mem::swap(&mut self.wedges, &mut self.next);
            self.next.clear();
            x += 1;
        }
    }

    /// Tells what a wedge shows of column x and of the corners before it, and keeps what its cells leave of the wedge.
    fn narrow(&mut self, map: &Obstacles, octant: Octant, x: i32, wedge: Wedge, seen: &mut impl Seen) {
        let column = Column { map, octant, x, near: 2 * x - octant.half };
        column.corners(wedge, seen);
        let (first, last) = column.rows(wedge);
        self.looked += u64::from((last - first + 1).max(0) as u32);
        let (mut y, mut low) = (first, wedge.low);
        while y <= last {
            if !column.is_open(y, Wedge { low, ..wedge }, seen) {
                self.keep(Wedge { low, high: wedge.high.or_lower(column.below(y)) });
                let is_open = |&y: &i32| column.is_open(y, Wedge { low: low.or_higher(column.above(y)), ..wedge }, seen);
                let Some(next) = (y + 1..=last).find(is_open) else { return };
                (y, low) = (next, low.or_higher(column.above(next)));
            }
            y += 1;
        }
        self.keep(Wedge { low, high: wedge.high });
    }

    fn keep(&mut self, wedge: Wedge) {
        if !wedge.is_empty() {
            self.next.push(wedge);
        }
    }
}

/// A column of an octant.
#[derive(Clone, Copy)]
struct Column<'a> {
    map: &'a Obstacles,
    octant: Octant,
    x: i32,
    /// Half columns to the line before it.
    near: i32,
}

impl Column<'_> {
    fn is_free(self, x: i32, y: i32) -> bool {
        let (x, y) = self.octant.cell(x, y);
        self.map.is_free(x, y)
    }

    /// Whether the cell of a row is free and leads on, after what a wedge shows of it is told.
    fn is_open(self, y: i32, wedge: Wedge, seen: &mut impl Seen) -> bool {
        let (x, half_rows) = (self.near + 1, 2 * y + 1 - self.octant.half);
        let (cell_x, cell_y) = self.octant.cell(self.x, y);
        let mut tell =
            || seen.cell(self.map.cell(cell_x, cell_y), self.octant.place(x, half_rows), wedge.contains((x, half_rows)));
        self.map.is_free(cell_x, cell_y) && tell()
    }

    /// Where the view below the blocked cell of a row ends. Along the axis from a corner, the way would run between this cell and one that
    /// another octant knows.
    fn below(self, y: i32) -> Slope {
        Slope { rise: 2 * y - self.octant.half, run: self.near + 2, is_open: 2 * y == self.octant.half }
    }

    /// Where the view above the blocked cells below a row begins.
    fn above(self, y: i32) -> Slope {
        let is_pinched = !self.map.squeezes() && !self.is_free(self.x - 1, y);
        Slope { rise: 2 * y - self.octant.half, run: self.near, is_open: is_pinched }
    }

    /// The rows of the cells that a wedge passes, with the one below whose corner a closed end touches; the first row also where it only
    /// touches the axis.
    fn rows(self, wedge: Wedge) -> (i32, i32) {
        let half = i64::from(self.octant.half);
        let ((low, low_run), (high, high_run)) = (wedge.low.at(self.near), wedge.high.at(self.near + 2));
        let low = low + half * low_run;
        let first = if wedge.low.is_open { low.div_euclid(2 * low_run) } else { ceil(low, 2 * low_run) - 1 };
        let last = ceil(high + half * high_run, 2 * high_run) - 1;
        (first.max(0) as i32, last.max(0) as i32)
    }

    /// Tells the corners that a wedge shows on the line before it.
    fn corners(self, wedge: Wedge, seen: &mut impl Seen) {
        let (half, from) = (i64::from(self.octant.half), self.octant.from);
        let ((low, low_run), (high, high_run)) = (wedge.low.at(self.near), wedge.high.at(self.near));
        let (low, high) = (low + half * low_run, high + half * high_run);
        let first = if wedge.low.is_open { low.div_euclid(2 * low_run) + 1 } else { ceil(low, 2 * low_run) };
        let last = if wedge.high.is_open { ceil(high, 2 * high_run) - 1 } else { high.div_euclid(2 * high_run) };
        for row in first..=last {
            let at = self.octant.place(self.near, 2 * row as i32 - self.octant.half);
            let corner = self.map.corner(at);
            if self.map.beyond(corner, (at.0 - from.0, at.1 - from.1)).is_some() {
                seen.corner(corner, at);
            }
        }
    }
}

fn ceil(a: i64, b: i64) -> i64 {
    -(-a).div_euclid(b)
}
