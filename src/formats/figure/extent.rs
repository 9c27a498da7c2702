//! Which cells of an endless lattice are the figure: where its sides are drawn.

use super::lattice::Lattice;
use super::plane::Plane;

/// A side is drawn where luma changes by at least this much across it, along three quarters of it.
const DRAWN: i16 = 8;

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
        Self { columns, rows, upright: drawn(plane, lattice, 0.0), level: drawn(turned, &lattice.transposed(), 0.0) }
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
        let union = |a: Extent, b: Extent| Extent {
            columns: (a.columns.0.min(b.columns.0), a.columns.1.max(b.columns.1)),
            rows: (a.rows.0.min(b.rows.0), a.rows.1.max(b.rows.1)),
        };
        let closed = || parts.iter().filter(|part| part.sides >= part.corners).map(|part| part.extent).reduce(union);
        self.framed(largest.extent).or_else(closed)
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

    /// Corners that drawn sides join.
    fn parts(&self) -> Vec<Part> {
        let wide = self.columns + 1;
        let mut roots: Vec<usize> = (0..wide * (self.rows + 1)).collect();
        let mut sides = Vec::new();
        for v in 0..=self.rows {
            for u in 0..=self.columns {
                let corner = v * wide + u;
                if v < self.rows && self.upright[v * wide + u] {
                    sides.push((corner, corner + wide));
                }
                if u < self.columns && self.level[u * (self.rows + 1) + v] {
                    sides.push((corner, corner + 1));
                }
            }
        }
        for &(a, b) in &sides {
            let (a, b) = (root(&mut roots, a), root(&mut roots, b));
            roots[a.max(b)] = a.min(b);
        }
        self.gathered(&mut roots, &sides)
    }

    fn gathered(&self, roots: &mut [usize], sides: &[(usize, usize)]) -> Vec<Part> {
        let wide = self.columns + 1;
        let mut parts: Vec<Option<Part>> = vec![None; roots.len()];
        for corner in 0..roots.len() {
            let (u, v) = (corner % wide, corner / wide);
            let root = root(roots, corner);
            let new = Part { sides: 0, corners: 0, extent: Extent { columns: (u, u), rows: (v, v) } };
            let part = parts[root].get_or_insert(new);
            part.corners += 1;
            let Extent { columns, rows } = &mut part.extent;
            (*columns, *rows) = ((columns.0.min(u), columns.1.max(u)), (rows.0.min(v), rows.1.max(v)));
        }
        for &(corner, _) in sides {
            if let Some(part) = &mut parts[root(roots, corner)] {
                part.sides += 1;
            }
        }
        parts.into_iter().flatten().filter(|part| part.sides > 0).collect()
    }
}

/// How many of the sides would be drawn, if the lattice were moved by half a cell: few, unless it is none.
pub(super) fn between(plane: &Plane, turned: &Plane, lattice: &Lattice) -> usize {
    let count = |plane, lattice: &Lattice| drawn(plane, lattice, 0.5).iter().filter(|&&drawn| drawn).count();
    count(plane, lattice) + count(turned, &lattice.transposed())
}

#[derive(Debug, Clone, Copy)]
struct Part {
    sides: usize,
    corners: usize,
    extent: Extent,
}

fn root(roots: &mut [usize], mut corner: usize) -> usize {
    while roots[corner] != corner {
        roots[corner] = roots[roots[corner]];
        corner = roots[corner];
    }
    corner
}

/// Whether the left side of each cell is drawn, row by row, and the right side of the last; `moved` cells to the right.
fn drawn(plane: &Plane, lattice: &Lattice, moved: f64) -> Vec<bool> {
    let cells = (0..lattice.rows).flat_map(|v| (0..=lattice.columns).map(move |u| (f64::from(u) + moved, f64::from(v))));
    let mut steps = Vec::new();
    cells.map(|(u, v)| is_drawn(plane, lattice, (u, v), &mut steps)).collect()
}

fn is_drawn(plane: &Plane, lattice: &Lattice, (u, v): (f64, f64), steps: &mut Vec<i16>) -> bool {
    let ((x, top), (_, bottom)) = (lattice.at(u, v + 0.15), lattice.at(u, v + 0.85));
    let (top, bottom) = (libm::ceil(top - 0.5) as isize, libm::floor(bottom - 0.5) as isize);
    let lean = lattice.shear_x / lattice.dy;
    let reach = (0.17 * lattice.dx).max(1.0);
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
