//! A map as bits, for jump points: which cells are blocked, and where a straight walk stops.
//!
//! Block-based scanning: Harabor, Grastien, "Improving jump point search", Proceedings of ICAPS 24 (2014) 128–135,
//! doi:10.1609/icaps.v24i1.13633. 64 cells of a line are one number, and the next cell at which something happens is its lowest bit, or its
//! highest. Columns are lines of a transposed copy. Where a walk stops depends on the map alone, so it is worked out once for each of the
//! four directions: a walk reads one line, where the paper reads three.
//!
//! All places here count from the border: (0, 0) is a blocked cell outside the map, (1, 1) its upper left cell.

use crate::map::{CornerRule, Direction, Grid, Point, offset};

/// Bits of a word.
const BITS: usize = u64::BITS as usize;

/// Lines of bits, each of whole words.
#[derive(Debug, Clone)]
struct Lines {
    /// Words of a line.
    words: usize,
    bits: Vec<u64>,
}

impl Lines {
    /// This many lines of this many bits, all set.
    fn set(lines: usize, length: usize) -> Self {
        let words = length.div_ceil(BITS);
        Self { words, bits: vec![u64::MAX; lines * words] }
    }

    fn count(&self) -> usize {
        self.bits.len() / self.words
    }

    fn line(&self, line: usize) -> &[u64] {
        &self.bits[line * self.words..][..self.words]
    }

    #[inline(always)]
    fn get(&self, line: u32, at: u32) -> bool {
        self.bits[line as usize * self.words + at as usize / BITS] >> (at as usize % BITS) & 1 == 1
    }

    /// The first set bit behind a place of a line; there must be one.
    #[inline(always)]
    fn after(&self, line: u32, at: u32) -> u32 {
        let (first, line) = (at as usize + 1, line as usize * self.words);
        let mut word = line + first / BITS;
        let mut bits = self.bits[word] & u64::MAX << (first % BITS);
        while bits == 0 {
            word += 1;
            bits = self.bits[word];
        }
        ((word - line) * BITS) as u32 + bits.trailing_zeros()
    }

    /// The last set bit before a place of a line; there must be one.
    #[inline(always)]
    fn before(&self, line: u32, at: u32) -> u32 {
        let (last, line) = (at as usize - 1, line as usize * self.words);
        let mut word = line + last / BITS;
        let mut bits = self.bits[word] & u64::MAX >> (BITS - 1 - last % BITS);
        while bits == 0 {
            word -= 1;
            bits = self.bits[word];
        }
        ((word - line) * BITS) as u32 + u64::BITS - 1 - bits.leading_zeros()
    }

    /// Rows from columns, or columns from rows, block by block; `length` is how many lines there will be.
    fn transposed(&self, length: usize) -> Self {
        let mut out = Self::set(length, self.count());
        for lines in 0..out.words {
            for word in 0..self.words {
                let row = |k: usize| self.bits.get((lines * BITS + k) * self.words + word).copied().unwrap_or(u64::MAX);
                let block = transposed(std::array::from_fn(row));
                for (k, bits) in block.into_iter().enumerate().take(length.saturating_sub(word * BITS)) {
                    out.bits[(word * BITS + k) * out.words + lines] = bits;
                }
            }
        }
        out
    }
}

/// A block of 64 × 64 bits with rows and columns exchanged: halves, quarters, and so on down to single bits.
fn transposed(mut block: [u64; BITS]) -> [u64; BITS] {
    let (mut half, mut low) = (BITS / 2, u64::from(u32::MAX));
    while half > 0 {
        for k in (0..BITS).filter(|k| k & half == 0) {
            let differ = (block[k] >> half ^ block[k + half]) & low;
            block[k] ^= differ << half;
            block[k + half] ^= differ;
        }
        half /= 2;
        low ^= low << half;
    }
    block
}

/// Which cells are blocked, row by row, within a blocked border.
fn rows_of(grid: &Grid) -> Lines {
    let mut rows = Lines::set(grid.height() as usize + 2, grid.width() as usize + 2);
    for y in 0..grid.height() {
        let line = &mut rows.bits[(y as usize + 1) * rows.words..][..rows.words];
        let word = |cells: &[bool]| cells.iter().rev().fold(0, |bits, &blocked| bits << 1 | u64::from(blocked));
        // Bit 0 of the line is the border; the last cell of each word is the first bit of the next.
        for (i, cells) in grid.row(y).chunks(BITS).enumerate() {
            let free = !word(cells) & u64::MAX >> (BITS - cells.len());
            line[i] &= !(free << 1);
            if free >> (BITS - 1) == 1 {
                line[i + 1] &= !1;
            }
        }
    }
    rows
}

/// Where a walk along a line stops: at blocked cells, and at those from which a step to the side may be part of a shortest path.
///
/// Where no corner is cut, that is a cell just past a corner: beside it is free, and beside the cell before it is not. Where corners are
/// cut, it is a cell just before one: beside it is blocked, and beside the next is not.
fn stops(blocked: &Lines, onwards: bool, cuts: bool) -> Lines {
    let mut out = blocked.clone();
    let moved = |line: &[u64], i: usize, up: bool| {
        let beside = if up { i.checked_sub(1).map(|k| line[k]) } else { line.get(i + 1).copied() }.unwrap_or(u64::MAX);
        if up { line[i] << 1 | beside >> (BITS - 1) } else { line[i] >> 1 | beside << (BITS - 1) }
    };
    let corners = |line: &[u64], i: usize| {
        if cuts { line[i] & !moved(line, i, !onwards) } else { !line[i] & moved(line, i, onwards) }
    };
    for at in 1..blocked.count() - 1 {
        let (above, below) = (blocked.line(at - 1), blocked.line(at + 1));
        for i in 0..blocked.words {
            out.bits[at * blocked.words + i] |= corners(above, i) | corners(below, i);
        }
    }
    out
}

/// The bits of a map under a corner rule, for 8 moves.
#[derive(Debug, Clone)]
pub(super) struct JumpMap {
    rule: CornerRule,
    /// Blocked cells by row.
    rows: Lines,
    /// Stops of walks: along rows onwards and back, along columns onwards and back.
    east: Lines,
    west: Lines,
    south: Lines,
    north: Lines,
}

impl JumpMap {
    /// Of a map as a plane.
    pub(super) fn new(grid: &Grid, rule: CornerRule) -> Self {
        let rows = rows_of(grid);
        let columns = rows.transposed(grid.width() as usize + 2);
        let cuts = rule != CornerRule::BothFree;
        let [east, west] = [true, false].map(|onwards| stops(&rows, onwards, cuts));
        let [south, north] = [true, false].map(|onwards| stops(&columns, onwards, cuts));
        Self { rule, rows, east, west, south, north }
    }

    /// Whether diagonal steps can pass blocked cells.
    #[inline(always)]
    pub(super) fn cuts(&self) -> bool {
        self.rule != CornerRule::BothFree
    }

    /// Whether a cell is blocked, the border included.
    #[inline(always)]
    pub(super) fn is_blocked(&self, at: Point) -> bool {
        self.rows.get(at.y, at.x)
    }

    /// Whether the diagonal step from a free cell is allowed.
    #[inline(always)]
    pub(super) fn allows(&self, from: Point, d: Direction) -> bool {
        let to = beside(from, d);
        let free = |x, y| !self.is_blocked(Point { x, y });
        free(to.x, to.y) && self.rule.allows(free(to.x, from.y), free(from.x, to.y))
    }

    /// The first stop of a walk in a straight direction.
    #[inline(always)]
    pub(super) fn stop(&self, from: Point, d: Direction) -> Point {
        let Point { x, y } = from;
        match offset(d) {
            (0, -1) => Point { x, y: self.north.before(x, y) },
            (0, _) => Point { x, y: self.south.after(x, y) },
            (-1, _) => Point { x: self.west.before(y, x), y },
            _ => Point { x: self.east.after(y, x), y },
        }
    }
}

/// The cell one step away.
#[inline(always)]
pub(super) fn beside(at: Point, d: Direction) -> Point {
    let (dx, dy) = offset(d);
    Point { x: at.x.wrapping_add_signed(dx), y: at.y.wrapping_add_signed(dy) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::Cell;

    fn drawn(width: u32, height: u32, seed: u32) -> Grid {
        let cells: Vec<u8> = (0..width * height).map(|i| u8::from((i + seed).wrapping_mul(2_654_435_761) >> 30 == 0)).collect();
        Grid::from_bytes(width, height, &cells).unwrap()
    }

    /// The first stop, cell by cell as its definition says.
    fn walked(map: &JumpMap, from: Point, d: Direction) -> Point {
        let sides: [Direction; 2] = if offset(d).0 == 0 { [3, 4] } else { [1, 6] };
        let mut at = from;
        loop {
            let before = at;
            at = beside(at, d);
            if map.is_blocked(at) {
                return at;
            }
            let is_corner = sides.iter().any(|&side| {
                let blocked = |p| map.is_blocked(beside(p, side));
                if map.cuts() { blocked(at) && !blocked(beside(at, d)) } else { blocked(before) && !blocked(at) }
            });
            if is_corner {
                return at;
            }
        }
    }

    #[test]
    fn walks_stop_where_the_definition_says() {
        for (width, height) in [(1, 1), (1, 70), (62, 3), (63, 5), (64, 64), (130, 66), (70, 1)] {
            let grid = drawn(width, height, width);
            for rule in CornerRule::ALL {
                let map = JumpMap::new(&grid, rule);
                for cell in (0..grid.len() as Cell).filter(|&c| !grid.is_blocked(c)) {
                    let at = Point::new(cell % width + 1, cell / width + 1);
                    for d in [1, 3, 4, 6] {
                        assert_eq!(map.stop(at, d), walked(&map, at, d), "{width}×{height} {rule:?} {at:?} {d}");
                    }
                }
            }
        }
    }

    #[test]
    fn bits_agree_with_the_grid_in_rows_and_columns() {
        for (width, height) in [(1, 1), (63, 62), (64, 65), (129, 7)] {
            let grid = drawn(width, height, 5);
            let rows = rows_of(&grid);
            let columns = rows.transposed(width as usize + 2);
            for (x, y) in (0..width + 2).flat_map(|x| (0..height + 2).map(move |y| (x, y))) {
                let free = grid.is_free_at(i64::from(x) - 1, i64::from(y) - 1);
                assert_eq!((rows.get(y, x), columns.get(x, y)), (!free, !free), "{width}×{height} ({x}, {y})");
            }
        }
    }
}
