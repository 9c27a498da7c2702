//! From a picture to the lattice of its figure.

use super::extent::{Extent, Sides, between};
use super::fit::{self, Lines};
use super::lattice::{Lattice, MOST_CELLS};
use super::period::{self, Spectrum};
use super::plane::{Bands, Plane, peaks};
use crate::error::FormatError;

/// Longest side of a picture in which figures are looked for.
const MOST_PIXELS: usize = 8192;

/// Share of the lines inside a figure on which at least one side is drawn.
const USED: f64 = 0.7;

/// A line so many cells from the picture's edge lies there.
const EDGE: f64 = 0.25;

/// A lattice moved by half a cell meets less than this share of the sides that it meets where it is.
const MISSED: f64 = 0.35;

/// The lattice of a figure.
pub(super) fn lattice(plane: &Plane) -> Result<Lattice, FormatError> {
    if plane.width.max(plane.height) > MOST_PIXELS {
        let what = format!("a figure in {} × {} pixels", plane.width, plane.height);
        return Err(FormatError::TooLarge { what, max: format!("{MOST_PIXELS} pixels a side") });
    }
    let turned = plane.transposed();
    let (across, down) = (plane.bands(0, plane.height), turned.bands(0, plane.width));
    let spectra = spectrum(&across).zip(spectrum(&down));
    let (x, y) = spectra.ok_or_else(none)?;
    let candidates = frequencies(&x, &y);
    let fitted = candidates.into_iter().filter_map(|(fx, fy)| {
        let endless = endless(plane, fit::lines(&across, fx), fit::lines(&down, fy))?;
        settled(plane, &turned, endless)
    });
    // The one that most sides are drawn on; of equal ones the first.
    let best = fitted.reduce(|best, next| if next.1 > best.1 { next } else { best });
    best.map(|(lattice, _)| lattice).ok_or_else(none)
}

fn none() -> FormatError {
    let expected = "cells of one size, at least 4 × 4 of 5 pixels; give its lattice (--lattice on the command line), or read it as a picture by its --threshold";
    FormatError::field("figure", "no lattice of cells is found in the picture", expected)
}

fn spectrum(bands: &Bands) -> Option<Spectrum> {
    Spectrum::new(&peaks(&bands.upright(0.0)))
}

/// Frequencies across and down, the likeliest first: each direction's own, and where they differ by more than a tenth either's for both.
fn frequencies(x: &Spectrum, y: &Spectrum) -> Vec<(f64, f64)> {
    let (fx, fy) = (x.fundamental(), y.fundamental());
    let mut all = vec![(fx, fy)];
    if (fx / fy - 1.0).abs() > 0.1 {
        all.extend(y.beside(fx).map(|(f, _)| (fx, f)));
        all.extend(x.beside(fy).map(|(f, _)| (f, fy)));
    }
    all
}

/// The lattice over the whole picture.
fn endless(plane: &Plane, upright: Lines, level: Lines) -> Option<Lattice> {
    let whole = |lines: Lines, sides: usize| {
        if !(lines.apart >= 0.8 * period::LEAST && lines.start.is_finite()) {
            return None;
        }
        let before = libm::floor(lines.start / lines.apart) + 1.0;
        let start = lines.start - before * lines.apart;
        let count = libm::ceil((sides as f64 - start) / lines.apart) + 1.0;
        (count <= MOST_PIXELS as f64).then_some((Lines { start, ..lines }, count as u32))
    };
    let (upright, columns) = whole(upright, plane.width)?;
    let (level, rows) = whole(level, plane.height)?;
    Some(Lattice::crossing(upright, level, columns, rows))
}

/// The part of a lattice that is the figure, fitted anew to what lies within, and how many sides are drawn in it. None if it is none.
fn settled(plane: &Plane, turned: &Plane, endless: Lattice) -> Option<(Lattice, usize)> {
    let (rough, _) = figure(plane, turned, endless)?;
    let fine = refitted(plane, turned, &rough)?;
    let (lattice, sides) = figure(plane, turned, fine)?;
    let strays = between(plane, turned, &lattice);
    (strays as f64 <= MISSED * sides as f64).then_some((lattice, sides))
}

/// The figure's part of a lattice.
fn figure(plane: &Plane, turned: &Plane, lattice: Lattice) -> Option<(Lattice, usize)> {
    let sides = Sides::new(plane, turned, &lattice);
    let extent = sides.extent()?;
    let at_edge = |line: usize, is_level: bool| {
        let (x, y) = (lattice.x0 + line as f64 * lattice.dx, lattice.y0 + line as f64 * lattice.dy);
        let near = |place: f64, side: usize, cell: f64| place.abs().min((place - side as f64).abs()) <= EDGE * cell;
        if is_level { near(y, plane.height, lattice.dy) } else { near(x, plane.width, lattice.dx) }
    };
    let extent = sides.to_the_edge(extent, at_edge);
    let Extent { columns, rows } = extent;
    let (wide, high) = ((columns.1 - columns.0) as u32, (rows.1 - rows.0) as u32);
    let enough = period::FEWEST as u32..=MOST_CELLS;
    let used = sides.lines(extent).iter().all(|&(used, all)| used as f64 >= USED * all as f64);
    if !(used && enough.contains(&wide) && enough.contains(&high)) {
        return None;
    }
    Some((lattice.part((columns.0 as u32, rows.0 as u32), wide, high), sides.count(extent)))
}

/// The same lattice fitted to the figure alone, with a margin of one cell around.
fn refitted(plane: &Plane, turned: &Plane, rough: &Lattice) -> Option<Lattice> {
    let (right, bottom) = rough.at(f64::from(rough.columns), f64::from(rough.rows));
    let within = |from: f64, to: f64, sides: usize| {
        let (from, to) = (from.max(0.0) as usize, libm::ceil(to.max(0.0)) as usize);
        (from < sides && from < to).then_some((from, to.min(sides)))
    };
    let (left, right) = within(rough.x0, right, plane.width)?;
    let (top, bottom) = within(rough.y0, bottom, plane.height)?;
    let mut across = plane.bands(top, bottom);
    let mut down = turned.bands(left, right);
    across.keep(left as f64 - 0.5 * rough.dx, right as f64 + 0.5 * rough.dx);
    down.keep(top as f64 - 0.5 * rough.dy, bottom as f64 + 0.5 * rough.dy);
    let fine = endless(plane, fit::lines(&across, 1.0 / rough.dx), fit::lines(&down, 1.0 / rough.dy))?;
    Some(fine)
}
