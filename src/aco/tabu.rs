//! The tabu list of an ant: one bit a cell, laid out so that a cell's eight neighbours come with one load.
//!
//! A byte holds a column of a *band*: six rows, and the row above and the one below them once more. Three bytes side by side, shifted by the
//! cell's row in its band, have all neighbours at fixed bits; a cell at the edge of a band is written twice.

use crate::map::{Cell, DIRECTIONS, Direction, OFFSETS};
use crate::planner::held;

/// Rows of a band.
const ROWS: i32 = 6;

/// Where one is on a tabu list: the byte left of the cell's own, and in the lowest three bits the row in its band.
pub(super) type Place = u32;

/// Which of a cell's neighbours have been visited, each at its bit of [`SEEN`].
pub(super) type Seen = u32;

/// The bit of each direction in [`Seen`]: 8 for each column from the left, 1 for each row from above.
pub(super) const SEEN: [Seen; DIRECTIONS] = {
    let mut bits = [0; DIRECTIONS];
    let mut d = 0;
    while d < DIRECTIONS {
        let (dx, dy) = OFFSETS[d];
        bits[d] = 1 << (8 * (dx + 1) + dy + 1);
        d += 1;
    }
    bits
};

/// The bit of the cell itself.
const CENTRE: Seen = 1 << 9;

/// The visited cells of one ant.
#[derive(Debug, Clone)]
pub(super) struct Tabu {
    bits: Vec<u8>,
    /// Bytes of a band: the columns, and one more on either side.
    stride: u32,
    /// What to add to a place, by its row and the direction of a step.
    moved: [[i32; DIRECTIONS]; 8],
    /// Where a cell of each row is written once more: bytes away from the one left of it, and the bit.
    again: [(i32, u8); 8],
}

impl Tabu {
    /// An empty list for a map of this size.
    pub fn new(width: u32, height: u32) -> Self {
        let stride = width + 2;
        // A band above and one below the map's; a load is of four bytes, the first of them left of the cell.
        let bands = u64::from(height).div_ceil(ROWS as u64) + 2;
        let bytes = u64::from(stride) * bands + 4;
        let mut again = [(1, 0); 8];
        again[0] = (1 - stride as i32, 1 << (ROWS + 1));
        again[ROWS as usize - 1] = (1 + stride as i32, 1);
        let moved = std::array::from_fn(|row| OFFSETS.map(|(dx, dy)| moved(stride as i32, row as i32, dx, dy)));
        Self { bits: vec![0; bytes as usize], stride, moved, again }
    }

    /// The place of a cell of a map of this width.
    pub fn place(&self, width: u32, c: Cell) -> Place {
        let (x, y) = (c % width, c / width);
        let band = y / ROWS as u32 + 1;
        ((band * self.stride + x) << 3) | (y % ROWS as u32)
    }

    /// One step on.
    #[inline(always)]
    pub fn step(&self, place: Place, d: Direction) -> Place {
        place.wrapping_add_signed(self.moved[(place & 7) as usize][d as usize & 7])
    }

    /// Marks a cell, and tells which neighbours are marked.
    #[inline(always)]
    pub fn insert(&mut self, place: Place) -> Seen {
        let (byte, row) = ((place >> 3) as usize, place & 7);
        let Some(near) = self.bits.get_mut(byte..byte + 4).and_then(<[u8]>::first_chunk_mut) else { return 0 };
        let marked = u32::from_le_bytes(*near);
        *near = (marked | CENTRE << row).to_le_bytes();
        let (away, bit) = self.again[row as usize];
        self.bits[byte.wrapping_add_signed(away as isize)] |= bit;
        marked >> row
    }

    /// Which neighbours are marked.
    #[inline(always)]
    pub fn around(&self, place: Place) -> Seen {
        let byte = (place >> 3) as usize;
        let near = self.bits.get(byte..byte + 4).and_then(<[u8]>::first_chunk);
        near.map_or(0, |near| u32::from_le_bytes(*near)) >> (place & 7)
    }

    /// Takes back the marks of these places alone.
    pub fn remove(&mut self, place: Place) {
        let byte = (place >> 3) as usize;
        self.bits[byte + 1] = 0;
        let (away, _) = self.again[(place & 7) as usize];
        self.bits[byte.wrapping_add_signed(away as isize)] = 0;
    }

    /// Whether so many marks are taken back sooner by emptying all of it.
    pub fn is_small_beside(&self, marks: usize) -> bool {
        self.bits.len() < 16 * marks
    }

    /// Takes back all marks.
    pub fn clear(&mut self) {
        self.bits.fill(0);
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.bits)
    }
}

/// What a step from a row of a band adds to a place.
fn moved(stride: i32, row: i32, dx: i32, dy: i32) -> i32 {
    let to = row + dy;
    let band = if to < 0 { -1 } else { i32::from(to >= ROWS) };
    8 * (band * stride + dx) + dy - ROWS * band
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a list of cells, on maps of every height in a band.
    #[test]
    fn the_neighbours_that_were_marked_are_seen() {
        for (width, height) in [(1, 1), (2, 13), (13, 2), (7, 6), (5, 7), (4, 12), (9, 19)] {
            let mut tabu = Tabu::new(width, height);
            let mut marked = vec![false; (width * height) as usize];
            for k in 0..3 * width * height {
                let c = (k * 7 + k / 3) % (width * height);
                tabu.insert(tabu.place(width, c));
                marked[c as usize] = true;
                for at in 0..width * height {
                    let seen = tabu.around(tabu.place(width, at));
                    for (d, (dx, dy)) in OFFSETS.into_iter().enumerate() {
                        let (x, y) = ((at % width) as i32 + dx, (at / width) as i32 + dy);
                        let inside = x >= 0 && y >= 0 && x < width as i32 && y < height as i32;
                        let expected = inside && marked[(y * width as i32 + x) as usize];
                        assert_eq!(seen & SEEN[d] != 0, expected, "{width} × {height}: {at}, direction {d}");
                        if inside {
                            let to = tabu.place(width, (y * width as i32 + x) as Cell);
                            assert_eq!(tabu.step(tabu.place(width, at), d as Direction), to);
                        }
                    }
                }
            }
            marked.iter().zip(0..).filter(|(m, _)| **m).for_each(|(_, c)| tabu.remove(tabu.place(width, c)));
            assert!(tabu.bits.iter().all(|&b| b == 0));
        }
    }
}
