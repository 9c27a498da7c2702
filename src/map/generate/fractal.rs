//! Ground like eroded hills: fractional Brownian motion, a sum of value noise in octaves. Each octave is a lattice of random heights,
//! interpolated smoothly; its lattice is twice as fine as the one before and its heights are lower, the more so the smoother the ground.

use super::terrain::Field;
use super::{Dice, RESOLUTION};

/// Difference of height over the longer side of the map.
const RELIEF: f64 = 0.12;

/// Exponent by which the heights of an octave fall at roughness 0: amplitude · 2^−(1.4 − roughness). At 0.5 that is H = 0.9: nearly as steep
/// in the small as in the large, as eroded ground is.
const SMOOTHEST: f64 = 1.4;

/// One axis of a lattice, as the cells of the map lie in it: the line before each, and the weight of the line behind it.
struct Axis(Vec<(usize, f64)>);

impl Axis {
    /// `shift` moves the lattice, so that its lines do not all meet in the map's corner.
    fn new(cells: u32, wavelength: f64, shift: f64) -> Self {
        let place = |i: u32| {
            let at = f64::from(i) / wavelength + shift;
            let line = libm::floor(at);
            (line as usize, smooth(at - line))
        };
        Self((0..cells).map(place).collect())
    }

    /// Number of lines that the cells touch.
    fn lines(&self) -> usize {
        self.0.last().map_or(0, |&(line, _)| line + 2)
    }
}

/// Perlin's 6t⁵ − 15t⁴ + 10t³: flat at both ends.
fn smooth(t: f64) -> f64 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// Heights in metres, from 0 upwards.
pub(super) fn ground(width: u32, height: u32, dice: &mut Dice, roughness: f64) -> Field {
    let mut field = Field::flat(width, height);
    let gain = libm::exp2(roughness - SMOOTHEST);
    let longer = f64::from(width.max(height));
    let (mut wavelength, mut amplitude) = ((longer / 2.0).max(2.0), 1.0);
    loop {
        octave(&mut field, wavelength, amplitude, dice);
        wavelength /= 2.0;
        amplitude *= gain;
        if wavelength < 2.0 {
            break;
        }
    }
    field.stretched(RELIEF * longer * RESOLUTION)
}

/// Adds one octave.
fn octave(field: &mut Field, wavelength: f64, amplitude: f64, dice: &mut Dice) {
    let (columns, rows) = (Axis::new(field.width, wavelength, dice.share()), Axis::new(field.height, wavelength, dice.share()));
    let lines = columns.lines();
    let lattice: Vec<f64> = (0..lines * rows.lines()).map(|_| amplitude * dice.share()).collect();
    let mut between = vec![0.0; lines];
    for (row, &(line, down)) in field.heights.chunks_exact_mut(field.width as usize).zip(&rows.0) {
        let (above, below) = (&lattice[line * lines..][..lines], &lattice[(line + 1) * lines..][..lines]);
        for (k, height) in between.iter_mut().enumerate() {
            *height = above[k] + (below[k] - above[k]) * down;
        }
        for (height, &(line, across)) in row.iter_mut().zip(&columns.0) {
            *height += between[line] + (between[line + 1] - between[line]) * across;
        }
    }
}
