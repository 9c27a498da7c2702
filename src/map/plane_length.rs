//! Lengths on a plane, counted before they are multiplied, so that equal paths have equal bits.

use std::f64::consts::SQRT_2;

use super::grid::Cell;

/// Length in cells. Straight and diagonal steps are counted and √2 multiplied once, so that equal paths have equal bits in any order.
pub fn counted_length(straight: u32, diagonal: u32) -> f64 {
    f64::from(straight) + f64::from(diagonal) * SQRT_2
}

/// Length in cells of a path on a map of this width: of allowed steps or of straight segments between cells. Rows, columns and exact
/// diagonals are counted, so that a path of steps and the same path with its straight stretches merged have equal bits.
pub fn length_on_plane(width: u32, path: &[Cell]) -> f64 {
    let mut sum = PlaneLength::default();
    path.windows(2).for_each(|s| sum.add(displacement(width, s[0], s[1])));
    sum.length()
}

/// Straight and diagonal cells walked, and the length of everything else.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct PlaneLength {
    straight: u32,
    diagonal: u32,
    oblique: f64,
}

impl PlaneLength {
    pub(crate) fn add(&mut self, (dx, dy): (i32, i32)) {
        let (nx, ny) = (dx.unsigned_abs(), dy.unsigned_abs());
        match (nx.min(ny), nx.max(ny)) {
            (0, n) => self.straight += n,
            (n, m) if n == m => self.diagonal += n,
            (n, m) => self.oblique += libm::sqrt(f64::from(n * n + m * m)),
        }
    }

    pub(crate) fn length(&self) -> f64 {
        counted_length(self.straight, self.diagonal) + self.oblique
    }
}

/// (dx, dy) of a step or segment. By rows and columns: on a map two cells wide a diagonal step changes the index by 1, as a horizontal
/// one does.
pub(crate) fn displacement(width: u32, a: Cell, b: Cell) -> (i32, i32) {
    ((b % width) as i32 - (a % width) as i32, (b / width) as i32 - (a / width) as i32)
}
