//! Which cells of an endless lattice are the figure: where its sides are drawn.

use std::collections::BTreeMap;

use super::lattice::Lattice;
use super::plane::Plane;

/// A side is drawn where luma changes by at least this much across it, along three quarters of it.
const DRAWN: i16 = 8;

/// The edges of a thick line lie within so many cells of its middle.
const REACH: f64 = 0.17;

/// A frame is whole where so much of each of its sides is drawn.
const WHOLE: f64 = 0.6;

/// Most of what hangs together that may lie beside the frame.
const PEELED: f64 = 0.4;

/// The sides of the cells of a lattice.
pub(super) struct Sides {
    columns: usize,
    rows: usize,
    /// Left sides: `rows` rows of `columns + 1`.
    upright: Vec<bool>,
    /// Upper sides: `columns` columns of `rows + 1`.
    level: Vec<bool>,
}

/// Columns and rows from the first to the one behind the last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Extent {
    pub columns: (usize, usize),
    pub rows: (usize, usize),
}

impl Extent {
    /// What holds both.
    fn with(self, other: Self) -> Self {
        let both = |a: (usize, usize), b: (usize, usize)| (a.0.min(b.0), a.1.max(b.1));
        Self { columns: both(self.columns, other.columns), rows: both(self.rows, other.rows) }
    }

    /// Without its first or last column, first or last row (0 to 3).
    fn without(mut self, side: usize) -> Self {
        match side {
            0 => self.columns.0 += 1,
            1 => self.columns.1 -= 1,
            2 => self.rows.0 += 1,
            _ => self.rows.1 -= 1,
        }
        self
    }
}

impl Sides {
    /// Looks at every side; `turned` is the transposed plane.
    pub(super) fn new(plane: &Plane, turned: &Plane, lattice: &Lattice) -> Self {
        let (columns, rows) = (lattice.columns as usize, lattice.rows as usize);
        Self {
            columns,
            rows,
            upright: drawn(plane, lattice, (0.0, REACH)),
            level: drawn(turned, &lattice.transposed(), (0.0, REACH)),
        }
    }

    /// How many sides are drawn.
    pub(super) fn count(&self, e: Extent) -> usize {
        let upright = (e.columns.0..=e.columns.1).map(|u| self.on_column(u, e.rows)).sum::<usize>();
        upright + (e.rows.0..=e.rows.1).map(|v| self.on_row(v, e.columns)).sum::<usize>()
    }

    fn on_column(&self, u: usize, rows: (usize, usize)) -> usize {
        (rows.0..rows.1).filter(|v| self.upright[v * (self.columns + 1) + u]).count()
    }

    fn on_row(&self, v: usize, columns: (usize, usize)) -> usize {
        (columns.0..columns.1).filter(|u| self.level[u * (self.rows + 1) + v]).count()
    }

    /// Lines inside with at least one drawn side, and all lines inside.
    pub(super) fn lines(&self, e: Extent) -> [(usize, usize); 2] {
        let inside = |(from, to): (usize, usize)| (from + 1)..to;
        let columns = inside(e.columns).filter(|&u| self.on_column(u, e.rows) > 0).count();
        let rows = inside(e.rows).filter(|&v| self.on_row(v, e.columns) > 0).count();
        [(columns, inside(e.columns).count()), (rows, inside(e.rows).count())]
    }

    /// The figure: what hangs together, down to its frame; without a frame all that closes around cells.
    pub(super) fn extent(&self) -> Option<Extent> {
        let parts = self.parts();
        let largest = parts.iter().max_by_key(|part| part.sides)?;
        let closed = || parts.iter().filter(|part| part.is_closed).map(|part| part.extent).reduce(Extent::with);
        self.framed(largest.extent).or_else(closed)
    }

    /// With the columns and rows that reach a picture's edge, where there is no side to be drawn: `at_edge` says which of a lattice's lines,
    /// across and down, lie there.
    pub(super) fn to_the_edge(&self, mut e: Extent, at_edge: impl Fn(usize, bool) -> bool) -> Extent {
        let level = |u: usize, e: Extent| (e.rows.0..=e.rows.1).filter(|v| self.level[u * (self.rows + 1) + v]).count();
        let upright =
            |v: usize, e: Extent| (e.columns.0..=e.columns.1).filter(|u| self.upright[v * (self.columns + 1) + u]).count();
        let some = |drawn: usize, (from, to): (usize, usize)| 10 * drawn > to - from;
        if e.columns.0 > 0 && at_edge(e.columns.0 - 1, false) && some(level(e.columns.0 - 1, e), e.rows) {
            e.columns.0 -= 1;
        }
        if e.columns.1 < self.columns && at_edge(e.columns.1 + 1, false) && some(level(e.columns.1, e), e.rows) {
            e.columns.1 += 1;
        }
        if e.rows.0 > 0 && at_edge(e.rows.0 - 1, true) && some(upright(e.rows.0 - 1, e), e.columns) {
            e.rows.0 -= 1;
        }
        if e.rows.1 < self.rows && at_edge(e.rows.1 + 1, true) && some(upright(e.rows.1, e), e.columns) {
            e.rows.1 += 1;
        }
        e
    }

    /// The frame in it: ticks and numbers beside it are peeled off, line by line where least is drawn.
    fn framed(&self, whole: Extent) -> Option<Extent> {
        let mut e = whole;
        loop {
            let (wide, high) = (e.columns.1 - e.columns.0, e.rows.1 - e.rows.0);
            let lost = 1.0 - (wide * high) as f64 / ((whole.columns.1 - whole.columns.0) * (whole.rows.1 - whole.rows.0)) as f64;
            if wide == 0 || high == 0 || lost > PEELED {
                return None;
            }
            let (w, h) = (wide as f64, high as f64);
            let shares = [
                self.on_column(e.columns.0, e.rows) as f64 / h,
                self.on_column(e.columns.1, e.rows) as f64 / h,
                self.on_row(e.rows.0, e.columns) as f64 / w,
                self.on_row(e.rows.1, e.columns) as f64 / w,
            ];
            match (0..4).min_by(|&a, &b| shares[a].total_cmp(&shares[b])) {
                Some(side) if shares[side] < WHOLE => e = e.without(side),
                _ => return Some(e),
            }
        }
    }

    /// What drawn sides join, in the order of their first corners.
    fn parts(&self) -> Vec<Part> {
        let wide = self.columns + 1;
        let mut roots: Vec<u32> = (0..(wide * (self.rows + 1)) as u32).collect();
        let mut closed = Vec::new();
        let sides = self.joined();
        for &(a, b) in &sides {
            let (a, b) = (root(&mut roots, a), root(&mut roots, b));
            roots[a.max(b) as usize] = a.min(b);
            if a == b {
                closed.push(a);
            }
        }
        let mut parts: BTreeMap<u32, Part> = BTreeMap::new();
        for &(a, b) in &sides {
            let part = parts.entry(root(&mut roots, a)).or_insert_with(|| Part::at(a as usize, wide));
            part.sides += 1;
            part.extent = part.extent.with(Part::at(b as usize, wide).extent).with(Part::at(a as usize, wide).extent);
        }
        for corner in closed {
            parts.entry(root(&mut roots, corner)).and_modify(|part| part.is_closed = true);
        }
        parts.into_values().collect()
    }

    /// The numbers of the corners at both ends of each drawn side.
    fn joined(&self) -> Vec<(u32, u32)> {
        let wide = self.columns + 1;
        let mut sides = Vec::new();
        for v in 0..=self.rows {
            for u in 0..=self.columns {
                let corner = v * wide + u;
                if v < self.rows && self.upright[corner] {
                    sides.push((corner as u32, (corner + wide) as u32));
                }
                if u < self.columns && self.level[u * (self.rows + 1) + v] {
                    sides.push((corner as u32, corner as u32 + 1));
                }
            }
        }
        sides
    }
}

/// How many of the sides would be drawn, if the lattice were moved by half a cell: few, unless it is none.
pub(super) fn between(plane: &Plane, turned: &Plane, lattice: &Lattice) -> usize {
    let count = |plane, lattice: &Lattice| drawn(plane, lattice, (0.5, 0.0)).iter().filter(|&&drawn| drawn).count();
    count(plane, lattice) + count(turned, &lattice.transposed())
}

/// Sides that hang together.
#[derive(Debug, Clone, Copy)]
struct Part {
    sides: usize,
    /// Whether they close around something.
    is_closed: bool,
    extent: Extent,
}

impl Part {
    fn at(corner: usize, wide: usize) -> Self {
        let (u, v) = (corner % wide, corner / wide);
        Self { sides: 0, is_closed: false, extent: Extent { columns: (u, u), rows: (v, v) } }
    }
}

fn root(roots: &mut [u32], mut corner: u32) -> u32 {
    while roots[corner as usize] != corner {
        roots[corner as usize] = roots[roots[corner as usize] as usize];
        corner = roots[corner as usize];
    }
    corner
}

/// Whether the left side of each cell is drawn, row by row, and the right side of the last; `moved` cells to the right, and within so many
/// cells of there.
fn drawn(plane: &Plane, lattice: &Lattice, (moved, reach): (f64, f64)) -> Vec<bool> {
    let cells = (0..lattice.rows).flat_map(|v| (0..=lattice.columns).map(move |u| (f64::from(u) + moved, f64::from(v))));
    let mut steps = Vec::new();
    let reach = (reach * lattice.dx).max(0.5);
    cells.map(|(u, v)| is_drawn(plane, lattice, (u, v), reach, &mut steps)).collect()
}

fn is_drawn(plane: &Plane, lattice: &Lattice, (u, v): (f64, f64), reach: f64, steps: &mut Vec<i16>) -> bool {
    let ((x, top), (_, bottom)) = (lattice.at(u, v + 0.15), lattice.at(u, v + 0.85));
    let (top, bottom) = (libm::ceil(top - 0.5) as isize, libm::floor(bottom - 0.5) as isize);
    let lean = lattice.shear_x / lattice.dy;
    let (from, to) = (libm::ceil(-reach - 0.5) as isize, libm::floor(reach + 0.5) as isize);
    (from..=to).any(|offset| {
        steps.clear();
        steps.extend((top..=bottom).map(|y| {
            let at = libm::round(x + lean * (y - top) as f64) as isize;
            plane.step(at + offset, y)
        }));
        steps.sort_unstable();
        let quarter = steps.len() / 4;
        !steps.is_empty() && (steps[quarter] >= DRAWN || steps[steps.len() - 1 - quarter] <= -DRAWN)
    })
}
