//! The obstacles of a plane as a point finds them, and the corners at which its shortest way may bend: see `point_robot.rs` for the rule.

use crate::map::{Cell, CornerRule, Grid, Movement, Moves, Point};

/// A place in half cells: corners have even coordinates, centres odd ones.
pub(super) type Place = (i32, i32);

/// The centre of a cell.
pub(super) fn centre(p: Point) -> Place {
    (2 * p.x as i32 + 1, 2 * p.y as i32 + 1)
}

/// Straight distance in cells.
#[inline]
pub(super) fn distance(a: Place, b: Place) -> f64 {
    let (dx, dy) = (f64::from(a.0 - b.0), f64::from(a.1 - b.1));
    0.5 * libm::sqrt(dx * dx + dy * dy)
}

/// Between which slopes a way may go on in one of the eight octants, y/x in its own columns and rows: 0 ≤ y/x ≤ 1, each as (rise, run).
pub(super) type Slopes = ((i32, i32), (i32, i32));

/// The whole octant.
pub(super) const ALL_SLOPES: Slopes = ((0, 1), (1, 1));

/// Where a way that bends or goes straight on at a corner leads: a quadrant by the signs of x and y, and the slopes in its two octants, with
/// columns along x first, along y second.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Cone {
    pub(super) quadrant: (i32, i32),
    pub(super) slopes: [Option<Slopes>; 2],
}

impl Cone {
    /// A whole quadrant.
    pub(super) fn quadrant(quadrant: (i32, i32)) -> Self {
        Self { quadrant, slopes: [Some(ALL_SLOPES); 2] }
    }

    /// From a direction within a quadrant to the quadrant's x axis or to its y axis.
    fn beside(quadrant: (i32, i32), (dx, dy): (i32, i32), to_x: bool) -> Self {
        let (dx, dy) = (dx.abs(), dy.abs());
        let slopes = if to_x {
            Self::towards(dy, dx)
        } else {
            let [y, x] = Self::towards(dx, dy);
            [x, y]
        };
        Self { quadrant, slopes }
    }

    /// From a direction to the axis `along`: the slopes of the octant at that axis, then of the other one.
    fn towards(across: i32, along: i32) -> [Option<Slopes>; 2] {
        if across <= along {
            [Some(((0, 1), (across, along))), None]
        } else {
            [Some(ALL_SLOPES), Some(((along, across), (1, 1)))]
        }
    }
}

/// The blocked cells around a corner, a bit for each: upper left, upper right, lower left, lower right. None where no way bends.
type Blocked = u8;

const UPPER_LEFT: Blocked = 1;
const UPPER_RIGHT: Blocked = 2;
const LOWER_LEFT: Blocked = 4;
const LOWER_RIGHT: Blocked = 8;

/// Where a point may go.
#[derive(Debug, Clone)]
pub(super) struct Obstacles {
    width: i32,
    /// Whether the point squeezes between two obstacles that touch at a corner.
    squeezes: bool,
    /// Whether cells are free, row by row within a border of blocked ones.
    free: Vec<bool>,
    /// What is blocked around each corner at which a way may bend, 0 where none does; row by row, one more than cells in each.
    bends: Vec<Blocked>,
}

impl Obstacles {
    /// In time and memory of the map's cells: two bytes each.
    pub(super) fn of(grid: &Grid, movement: Movement) -> Self {
        let (width, height) = (grid.width() as usize, grid.height() as usize);
        let squeezes = movement.moves != Moves::Four && movement.corner_rule == CornerRule::Always;
        let mut free = vec![false; (width + 2) * (height + 2)];
        for (y, row) in free.chunks_exact_mut(width + 2).skip(1).take(height).enumerate() {
            row[1..=width].iter_mut().zip(grid.row(y as u32)).for_each(|(free, blocked)| *free = !blocked);
        }
        let mut all = Self { width: width as i32, squeezes, free, bends: Vec::new() };
        all.bends =
            (0..=height as i32).flat_map(|y| (0..=width as i32).map(move |x| (x, y))).map(|(x, y)| all.blocked(x, y)).collect();
        all
    }

    pub(super) fn squeezes(&self) -> bool {
        self.squeezes
    }

    /// Whether a cell is free; of the map, or beside it.
    #[inline(always)]
    pub(super) fn is_free(&self, x: i32, y: i32) -> bool {
        self.free[((y + 1) * (self.width + 2) + x + 1) as usize]
    }

    #[inline(always)]
    pub(super) fn cell(&self, x: i32, y: i32) -> Cell {
        (y * self.width + x) as Cell
    }

    /// The number of a corner, row by row.
    #[inline(always)]
    pub(super) fn corner(&self, (x, y): Place) -> usize {
        (y / 2 * (self.width + 1) + x / 2) as usize
    }

    /// Where the corner of a number is.
    pub(super) fn place(&self, corner: usize) -> Place {
        let line = self.width + 1;
        (2 * (corner as i32 % line), 2 * (corner as i32 / line))
    }

    pub(super) fn corners(&self) -> usize {
        self.bends.len()
    }

    /// What is blocked around the upper left corner of the cell (x, y), where a shortest way may bend: one cell, or two that touch.
    fn blocked(&self, x: i32, y: i32) -> Blocked {
        let around = [(x - 1, y - 1), (x, y - 1), (x - 1, y), (x, y)];
        let bit = |(k, &(x, y)): (usize, &(i32, i32))| if self.is_free(x, y) { 0 } else { 1 << k };
        let blocked: Blocked = around.iter().enumerate().map(bit).sum();
        let touching = blocked == UPPER_LEFT | LOWER_RIGHT || blocked == UPPER_RIGHT | LOWER_LEFT;
        if blocked.count_ones() == 1 || (self.squeezes && touching) { blocked } else { 0 }
    }

    /// Where a shortest way can go on that has come to a corner in this direction: round the obstacle, not away from it. Such a way leads out
    /// through the quadrant opposite to the one it came by, both beside the obstacle. None where no shortest way goes on at all.
    #[inline]
    pub(super) fn beyond(&self, corner: usize, (dx, dy): (i32, i32)) -> Option<Cone> {
        let blocked = self.bends[corner];
        if blocked == 0 {
            return None;
        }
        // Obstacles at the upper left and the lower right leave the other two quadrants, in which x and y have opposite signs.
        let sign = if blocked & (UPPER_LEFT | LOWER_RIGHT) != 0 { -1 } else { 1 };
        let quadrant = match (dx.signum(), dy.signum()) {
            (0, y) => (sign * y, y),
            (x, 0) => (x, sign * x),
            (x, y) if x * y == sign => (x, y),
            _ => return None,
        };
        if blocked.count_ones() == 2 {
            return Some(Cone::quadrant(quadrant));
        }
        let obstacle = (
            if blocked & (UPPER_LEFT | LOWER_LEFT) != 0 { -1 } else { 1 },
            if blocked & (UPPER_LEFT | UPPER_RIGHT) != 0 { -1 } else { 1 },
        );
        Some(Cone::beside(quadrant, (dx, dy), quadrant.0 == obstacle.0))
    }
}
