//! What the inside of each cell looks like.

use super::lattice::Lattice;
use crate::formats::picture::{Picture, luma, over_white};

/// Of a cell's side, what is left out at each end, so that lines and markers of neighbours do not matter.
const CORE: f64 = 0.2;

/// Where its corners begin, and how long they are.
const WIDE: f64 = 0.12;
const CORNER: f64 = 0.15;

/// Largest minus smallest channel of a pixel that has a colour.
pub(super) const COLOURED: u8 = 44;

/// Hues are told apart by tens of degrees.
pub(super) const HUES: usize = 36;

/// The largest channel of a bright colour: dark blue walls and a bright blue path are two colours.
const BRIGHT: u8 = 128;

/// Dark colours by hue, then bright ones.
pub(super) const COLOURS: usize = 2 * HUES;

/// The inside of a cell.
#[derive(Debug, Clone)]
pub(super) struct Look {
    /// Median luma of its core.
    pub luma: u8,
    /// Mean luma of the lightest of its corners: what is drawn across a cell does not fill all four.
    pub corner: u8,
    /// Pixels of the core; 0 beyond the picture.
    pub pixels: u32,
    /// How many of them are dark, those with a colour too.
    pub dark: u32,
    /// How many of them have which colour.
    pub colours: [u16; COLOURS],
}

/// Median luma of the core of each cell of a lattice, row by row.
pub(super) fn medians(picture: &Picture, lattice: &Lattice) -> Vec<u8> {
    let mut lumas = Vec::new();
    let median = |cell| {
        lumas.clear();
        lumas.extend(core(picture, lattice, cell).map(luma));
        lumas.sort_unstable();
        lumas.get(lumas.len() / 2).copied().unwrap_or(255)
    };
    lattice.cells().map(median).collect()
}

/// Looks at the cells of a lattice, whose medians are known; below the threshold is dark.
pub(super) fn looks(picture: &Picture, lattice: &Lattice, medians: &[u8], threshold: u8) -> Vec<Look> {
    let look = |(cell, &luma)| look(picture, lattice, cell, luma, threshold);
    lattice.cells().zip(medians).map(look).collect()
}

fn look(picture: &Picture, lattice: &Lattice, cell: (f64, f64), median: u8, threshold: u8) -> Look {
    let corner = corner(picture, lattice, cell);
    let mut look = Look { luma: median, corner, pixels: 0, dark: 0, colours: [0; COLOURS] };
    for pixel in core(picture, lattice, cell) {
        look.pixels += 1;
        look.dark += u32::from(luma(pixel) < threshold);
        if let Some(colour) = colour(pixel) {
            look.colours[colour] = look.colours[colour].saturating_add(1);
        }
    }
    look
}

/// Mean luma of the lightest corner.
fn corner(picture: &Picture, lattice: &Lattice, (u, v): (f64, f64)) -> u8 {
    let far = 1.0 - WIDE - CORNER;
    let corners = [(WIDE, WIDE), (far, WIDE), (WIDE, far), (far, far)];
    let mean = |(du, dv): (f64, f64)| {
        let part = pixels(picture, lattice, (u + du, v + dv), CORNER);
        let (count, sum) = part.fold((0, 0), |(count, sum), pixel| (count + 1, sum + u32::from(luma(pixel))));
        sum.checked_div(count).unwrap_or(255) as u8
    };
    corners.into_iter().map(mean).max().unwrap_or(255)
}

/// The pixels of a cell, but for a border.
fn core(picture: &Picture, lattice: &Lattice, (u, v): (f64, f64)) -> impl Iterator<Item = [u8; 3]> {
    pixels(picture, lattice, (u + CORE, v + CORE), 1.0 - 2.0 * CORE)
}

/// The pixels of a square, its side in cells; those beyond the picture are left out. At most about 60 000 of them, evenly spread.
fn pixels(picture: &Picture, lattice: &Lattice, (u, v): (f64, f64), side: f64) -> impl Iterator<Item = [u8; 3]> {
    let (left, top) = lattice.at(u, v);
    let (right, bottom) = lattice.at(u + side, v + side);
    let (columns, rows) = (span(left, right, picture.width), span(top, bottom, picture.height));
    let width = picture.width as usize;
    let by = 1 + columns.len().max(rows.len()) / 245;
    let pixel = move |x: usize, y: usize| over_white(picture.pixels[y * width + x]);
    rows.step_by(by).flat_map(move |y| columns.clone().step_by(by).map(move |x| pixel(x, y)))
}

/// The pixels whose middles lie between two places, or the one in between if there is none.
fn span(from: f64, to: f64, sides: u32) -> core::ops::Range<usize> {
    let (mut first, mut end) = (libm::ceil(from - 0.5), libm::floor(to - 0.5) + 1.0);
    if end <= first {
        first = libm::floor((from + to) / 2.0);
        end = first + 1.0;
    }
    let within = |place: f64| place.clamp(0.0, f64::from(sides)) as usize;
    within(first)..within(end)
}

/// The hue of a pixel in tens of degrees from red, 36 more if it is bright; none if it is gray.
fn colour([r, g, b]: [u8; 3]) -> Option<usize> {
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let chroma = i32::from(most - least);
    if most - least < COLOURED {
        return None;
    }
    let part = |a: u8, b: u8| (i32::from(a) - i32::from(b)) * 60 / chroma;
    let degrees = match most {
        _ if most == r => part(g, b),
        _ if most == g => 120 + part(b, r),
        _ => 240 + part(r, g),
    };
    let hue = (degrees + 5).rem_euclid(360) as usize / 10;
    Some(if most < BRIGHT { hue } else { HUES + hue })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hues_of_dark_and_bright() {
        let of = |r, g, b| colour([r, g, b]);
        assert_eq!([of(255, 0, 0), of(0, 255, 0), of(0, 0, 255)], [Some(36), Some(48), Some(60)]);
        assert_eq!([of(255, 0, 10), of(255, 255, 0), of(90, 90, 120)], [Some(36), Some(42), None]);
        assert_eq!([of(20, 30, 90), of(90, 0, 0)], [Some(23), Some(0)]);
    }

    #[test]
    fn spans() {
        assert_eq!(span(1.2, 4.6, 10), 1..5);
        assert_eq!(span(1.6, 1.7, 10), 1..2);
        assert_eq!(span(-5.0, 3.0, 2), 0..2);
        assert!(span(50.0, 60.0, 2).is_empty());
    }
}
