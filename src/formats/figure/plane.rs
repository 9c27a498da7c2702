//! The luma of a picture, and how it changes across columns.

use crate::formats::picture::{Picture, luma, over_white};

/// Luma below this difference is noise, above the other it says no more.
const LEAST: u8 = 10;
const MOST: u8 = 48;

/// Bands of rows whose profiles are told apart, for skew.
const BANDS: usize = 24;

/// Luma of each pixel, row by row.
pub(super) struct Plane {
    pub width: usize,
    pub height: usize,
    pub luma: Vec<u8>,
}

/// How much luma changes at each border between columns.
pub(super) struct Bands {
    /// The middle of each band, in pixels from above.
    pub middles: Vec<f64>,
    /// For each band the change at border x (between the columns x − 1 and x), summed up over its rows.
    pub profiles: Vec<Vec<f64>>,
}

impl Plane {
    pub(super) fn new(picture: &Picture) -> Self {
        let luma = picture.pixels.iter().map(|&pixel| luma(over_white(pixel))).collect();
        Self { width: picture.width as usize, height: picture.height as usize, luma }
    }

    /// Columns as rows.
    pub(super) fn transposed(&self) -> Self {
        let column = |x: usize| self.luma.iter().skip(x).step_by(self.width).copied();
        let mut luma = Vec::with_capacity(self.luma.len());
        (0..self.width).for_each(|x| luma.extend(column(x)));
        Self { width: self.height, height: self.width, luma }
    }

    /// Luma right of border x minus luma left of it; 0 outside.
    pub(super) fn step(&self, x: isize, y: isize) -> i16 {
        if x < 1 || y < 0 || x as usize >= self.width || y as usize >= self.height {
            return 0;
        }
        let at = y as usize * self.width + x as usize;
        i16::from(self.luma[at]) - i16::from(self.luma[at - 1])
    }

    /// Profiles of the rows `from` to `to`, of which there is at least one.
    pub(super) fn bands(&self, from: usize, to: usize) -> Bands {
        let mut bands = Bands { middles: Vec::new(), profiles: Vec::new() };
        let count = BANDS.min(to - from);
        for band in 0..count {
            let (first, end) = (from + band * (to - from) / count, from + (band + 1) * (to - from) / count);
            let mut sums = vec![0_u32; self.width];
            for row in self.luma[first * self.width..end * self.width].chunks_exact(self.width) {
                for (sum, pair) in sums[1..].iter_mut().zip(row.windows(2)) {
                    let change = pair[0].abs_diff(pair[1]);
                    *sum += if change < LEAST { 0 } else { u32::from(change.min(MOST)) };
                }
            }
            bands.middles.push((first + end) as f64 / 2.0);
            bands.profiles.push(sums.into_iter().map(f64::from).collect());
        }
        bands
    }
}

impl Bands {
    /// Forgets what lies outside of two places.
    pub(super) fn keep(&mut self, from: f64, to: f64) {
        let outside = |x: usize| (x as f64) < from || x as f64 > to;
        for profile in &mut self.profiles {
            profile.iter_mut().enumerate().filter(|(x, _)| outside(*x)).for_each(|(_, change)| *change = 0.0);
        }
    }

    /// All bands as one profile, each moved so that lines which lean by `slope` pixels a row stand upright at row 0.
    pub(super) fn upright(&self, slope: f64) -> Vec<f64> {
        let mut sums = vec![0.0; self.profiles.first().map_or(0, Vec::len)];
        for (profile, middle) in self.profiles.iter().zip(&self.middles) {
            let shift = slope * middle;
            let whole = libm::floor(shift);
            let part = shift - whole;
            for (x, &change) in profile.iter().enumerate().filter(|(_, change)| **change > 0.0) {
                let at = x as isize - whole as isize;
                for (at, share) in [(at, 1.0 - part), (at - 1, part)] {
                    if let Some(sum) = usize::try_from(at).ok().and_then(|at| sums.get_mut(at)) {
                        *sum += change * share;
                    }
                }
            }
        }
        sums
    }
}

/// A profile above its median, its peaks made more alike by the root, so that a frame does not outweigh all lines.
pub(super) fn peaks(profile: &[f64]) -> Vec<f64> {
    let mut sorted = profile.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let median = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
    profile.iter().map(|&change| libm::sqrt((change - median).max(0.0))).collect()
}
