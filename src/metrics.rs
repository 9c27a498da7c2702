//! What is measured on a path: length, turns, V(d, r), clearance, travel time.

use std::f64::consts::SQRT_2;

use serde::Serialize;

use crate::map::{Cell, Grid};
use crate::scenario::Scenario;

/// Weight of a turning step in V(d, r): equation (10) of the fire-fighting paper.
pub const TURN_WEIGHT: f64 = 1.2;

/// The metrics of one path.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Metrics {
    /// Length in cells: straight steps + √2 · diagonal steps.
    pub length: f64,
    /// Length in metres.
    pub length_metres: f64,
    /// Number of steps.
    pub steps: u32,
    /// Number of steps whose direction differs from the step before.
    pub turns: u32,
    /// V(d, r) = Σ dᵢ·rᵢ in cells, rᵢ = 1.2 if step i turns, else 1.
    pub turn_index: f64,
    /// Smallest distance in cells from a cell's centre of the path to the nearest obstacle's centre; the world beyond the border is an obstacle.
    pub min_clearance: f64,
    /// Mean of the same distance over the path's cells.
    pub mean_clearance: f64,
    /// Seconds: metres / speed + turns · seconds per turn.
    pub travel_time: f64,
}

/// Length in cells. Straight and diagonal steps are counted and √2 multiplied once, so that equal paths have equal bits in any order.
pub fn length(straight: u32, diagonal: u32) -> f64 {
    f64::from(straight) + f64::from(diagonal) * SQRT_2
}

/// Length in cells of a path of neighbouring cells on a map of this width.
pub fn path_length(width: u32, path: &[Cell]) -> f64 {
    let steps = path.len().saturating_sub(1) as u32;
    let straight = path.windows(2).filter(|s| is_straight(width, s[0], s[1])).count() as u32;
    length(straight, steps - straight)
}

fn is_straight(width: u32, a: Cell, b: Cell) -> bool {
    let gap = a.abs_diff(b);
    // A map one cell wide has no horizontal neighbours, so a gap of 1 is a vertical step there: straight all the same.
    gap == 1 || gap == width
}

impl Metrics {
    /// Measures a valid path.
    pub fn of(scenario: &Scenario, path: &[Cell]) -> Self {
        let width = scenario.grid.width();
        let length = path_length(width, path);
        let mut turns = 0u32;
        let mut turning = (0u32, 0u32);
        for s in path.windows(3) {
            if s[1].wrapping_sub(s[0]) != s[2].wrapping_sub(s[1]) {
                turns += 1;
                if is_straight(width, s[1], s[2]) { turning.0 += 1 } else { turning.1 += 1 }
            }
        }
        let (min_clearance, mean_clearance) = clearance(&scenario.grid, path);
        let metres = length * scenario.spec.resolution;
        let vehicle = scenario.spec.vehicle;
        Self {
            length,
            length_metres: metres,
            steps: path.len().saturating_sub(1) as u32,
            turns,
            turn_index: length + (TURN_WEIGHT - 1.0) * self::length(turning.0, turning.1),
            min_clearance,
            mean_clearance,
            travel_time: metres / vehicle.speed + f64::from(turns) * vehicle.seconds_per_turn,
        }
    }
}

/// Smallest and mean clearance of a path's cells.
fn clearance(grid: &Grid, path: &[Cell]) -> (f64, f64) {
    let field = squared_distances(grid);
    let (mut min, mut sum) = (f64::INFINITY, 0.0);
    for &c in path {
        let d = libm::sqrt(f64::from(field[c as usize]));
        min = min.min(d);
        sum += d;
    }
    if path.is_empty() { (0.0, 0.0) } else { (min, sum / path.len() as f64) }
}

/// Squared Euclidean distance of every cell to the nearest blocked cell or to the ring of cells just outside the map, exact
/// (rows, then columns, as every separable distance transform).
fn squared_distances(grid: &Grid) -> Vec<u32> {
    let (w, h) = (grid.width() as usize, grid.height() as usize);
    let mut field = vec![0u32; w * h];
    for y in 0..h {
        let row = &mut field[y * w..(y + 1) * w];
        let mut gap = 0;
        for (x, cell) in row.iter_mut().enumerate() {
            gap = if grid.is_blocked((y * w + x) as Cell) { 0 } else { gap + 1 };
            *cell = gap;
        }
        gap = 0;
        for (x, cell) in row.iter_mut().enumerate().rev() {
            gap = if grid.is_blocked((y * w + x) as Cell) { 0 } else { gap + 1 };
            *cell = gap.min(*cell);
        }
    }
    let mut column = vec![0u32; h];
    for x in 0..w {
        for (y, g) in column.iter_mut().enumerate() {
            *g = field[y * w + x];
        }
        for y in 0..h {
            field[y * w + x] = nearest_in_column(&column, y);
        }
    }
    field
}

/// min over y' of (y − y')² + column[y']², the rows −1 and h counting as blocked; looks outwards until no farther row can be nearer.
fn nearest_in_column(column: &[u32], y: usize) -> u32 {
    let border = (y + 1).min(column.len() - y) as u32;
    let mut best = border.min(column[y]).pow(2);
    let mut gap = 1u32;
    while gap * gap < best {
        let g = gap as usize;
        let above = y.checked_sub(g).map_or(0, |i| column[i]);
        let below = column.get(y + g).copied().unwrap_or(0);
        best = best.min(gap * gap + above.min(below).pow(2));
        gap += 1;
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{Movement, Point};

    fn scenario(rows: &[&str]) -> Scenario {
        let cells: Vec<u8> = rows.iter().flat_map(|r| r.bytes().map(|b| u8::from(b == b'#'))).collect();
        let grid = Grid::from_bytes(rows[0].len() as u32, rows.len() as u32, &cells).unwrap();
        let end = Point::new(grid.width() - 1, grid.height() - 1);
        Scenario::on(grid, Movement::default(), Point::new(0, 0), end).unwrap()
    }

    #[test]
    fn measures_by_hand() {
        let mut s = scenario(&["....", "....", "...."]);
        s.spec.resolution = 0.5;
        s.spec.vehicle = crate::scenario::Vehicle { speed: 0.25, seconds_per_turn: 2.0 };
        // E, E, SE, S: turns at the SE and at the S step.
        let path = [0, 1, 2, 7, 11];
        let m = Metrics::of(&s, &path);
        assert_eq!(m.steps, 4);
        assert_eq!(m.turns, 2);
        assert_eq!(m.length, 3.0 + SQRT_2);
        assert!((m.turn_index - (1.0 + 1.0 + 1.2 * SQRT_2 + 1.2)).abs() < 1e-12);
        assert_eq!(m.length_metres, 0.5 * m.length);
        assert_eq!(m.travel_time, 2.0 * m.length + 4.0);
        assert_eq!(m.min_clearance, 1.0);
    }

    #[test]
    fn clearance_agrees_with_brute_force() {
        let s = scenario(&["......#", ".......", "..#....", ".......", ".......", "#......", "......."]);
        let field = squared_distances(&s.grid);
        for y in 0..7i64 {
            for x in 0..7i64 {
                let mut best = i64::MAX;
                for by in -1..8 {
                    for bx in -1..8 {
                        if !s.grid.is_free_at(bx, by) {
                            best = best.min((x - bx).pow(2) + (y - by).pow(2));
                        }
                    }
                }
                assert_eq!(i64::from(field[(y * 7 + x) as usize]), best, "at ({x}, {y})");
            }
        }
    }
}
