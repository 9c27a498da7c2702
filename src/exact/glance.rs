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
        let half = octant.half;
        let (near, far) = (2 * x - half, 2 * x - half + 2);
        corners(map, octant, near, wedge, seen);
        let (first, last) = rows(wedge, near, far, half);
        self.looked += u64::from((last - first + 1).max(0) as u32);
        let is_free = |x, y| {
            let (x, y) = octant.cell(x, y);
            map.is_free(x, y)
        };
        let mut is_open = |y, low| {
            let (to, (cell_x, cell_y)) = ((near + 1, 2 * y + 1 - half), octant.cell(x, y));
            let is_seen = Wedge { low, ..wedge }.contains(to);
            map.is_free(cell_x, cell_y) && seen.cell(map.cell(cell_x, cell_y), octant.place(to.0, to.1), is_seen)
        };
        let (mut y, mut low) = (first, wedge.low);
        while y <= last {
            if is_open(y, low) {
                y += 1;
                continue;
            }
            // Along the axis from a corner the way would run between this cell and one that another octant knows.
            let below = Slope { rise: 2 * y - half, run: far, is_open: 2 * y == half };
            self.keep(Wedge { low, high: wedge.high.or_lower(below) });
            loop {
                y += 1;
                if y > last {
                    return;
                }
                let is_pinched = !map.squeezes() && !is_free(x - 1, y);
                let above = low.or_higher(Slope { rise: 2 * y - half, run: near, is_open: is_pinched });
                if is_open(y, above) {
                    low = above;
                    break;
                }
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

/// The rows of the cells that a wedge passes between two lines, with the one below whose corner a closed end touches; the first row also
/// where it only touches the axis.
fn rows(wedge: Wedge, near: i32, far: i32, half: i32) -> (i32, i32) {
    let half = i64::from(half);
    let ((low, low_run), (high, high_run)) = (wedge.low.at(near), wedge.high.at(far));
    let first = if wedge.low.is_open {
        (low + half * low_run).div_euclid(2 * low_run)
    } else {
        ceil(low + half * low_run, 2 * low_run) - 1
    };
    let last = ceil(high + half * high_run, 2 * high_run) - 1;
    (first.max(0) as i32, last.max(0) as i32)
}

fn ceil(a: i64, b: i64) -> i64 {
    -(-a).div_euclid(b)
}

/// Tells the corners that a wedge shows on the line before a column.
fn corners(map: &Obstacles, octant: Octant, near: i32, wedge: Wedge, seen: &mut impl Seen) {
    let half = i64::from(octant.half);
    let ((low, low_run), (high, high_run)) = (wedge.low.at(near), wedge.high.at(near));
    let (low, high) = (low + half * low_run, high + half * high_run);
    let first = if wedge.low.is_open { low.div_euclid(2 * low_run) + 1 } else { ceil(low, 2 * low_run) };
    let last = if wedge.high.is_open { ceil(high, 2 * high_run) - 1 } else { high.div_euclid(2 * high_run) };
    for row in first..=last {
        let at = octant.place(near, 2 * row as i32 - octant.half);
        let corner = map.corner(at);
        if map.beyond(corner, (at.0 - octant.from.0, at.1 - octant.from.1)).is_some() {
            seen.corner(corner, at);
        }
    }
}
