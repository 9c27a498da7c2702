//! The lines of one direction: how far apart, where, how much they lean.

use super::period::Wave;
use super::plane::{Bands, peaks};

/// How often lines are moved to the peaks near them.
const ROUNDS: usize = 6;

/// Most that lines may lean: pixels a pixel.
const STEEPEST: f64 = 0.03;

/// Line i lies at `start + i · apart + slope · y` in row y, in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lines {
    pub start: f64,
    pub apart: f64,
    pub slope: f64,
}

/// Lines of about a frequency that go through the peaks of a profile best.
pub(super) fn lines(bands: &Bands, frequency: f64) -> Lines {
    let slope = slope(bands, frequency);
    let profile = peaks(&bands.upright(slope));
    let start = Wave::of(&profile, frequency).crest(frequency);
    let mut lines = Lines { start, apart: 1.0 / frequency, slope };
    for _ in 0..ROUNDS {
        lines = refined(&profile, lines);
    }
    lines
}

/// How much lines lean, from where the crests of each band lie.
fn slope(bands: &Bands, frequency: f64) -> f64 {
    let upright = Wave::of(&bands.upright(0.0), frequency);
    let mut points = Vec::new();
    for (profile, &middle) in bands.profiles.iter().zip(&bands.middles) {
        let all: f64 = profile.iter().sum();
        let wave = Wave::of(profile, frequency);
        // Against the whole: a band's crests lie less than half a cell from it.
        let (re, im) = (wave.re * upright.re + wave.im * upright.im, wave.im * upright.re - wave.re * upright.im);
        let offset = Wave { re, im }.crest(frequency);
        if all > 0.0 {
            let clear = wave.strength() / all;
            points.push((middle, offset, wave.strength() * clear * clear));
        }
    }
    straight(&points).map_or(0.0, |(_, slope)| slope.clamp(-STEEPEST, STEEPEST))
}

/// Lines through the middles of the peaks near those of `lines`. Peaks count the less the farther they are, down to nothing half a cell away:
/// a thick line has two, and a border between them and the next would pull the line to one side.
fn refined(profile: &[f64], lines: Lines) -> Lines {
    let mut points = Vec::new();
    let reach = lines.apart / 2.0;
    let first = libm::ceil(-lines.start / lines.apart) as i64;
    let last = libm::floor((profile.len() as f64 - lines.start) / lines.apart) as i64;
    for line in first..=last {
        let centre = lines.start + line as f64 * lines.apart;
        let (from, to) = (libm::ceil((centre - reach).max(0.0)) as usize, libm::floor((centre + reach).max(0.0)) as usize);
        let (mut mass, mut moment) = (0.0, 0.0);
        for (x, &value) in profile.iter().enumerate().take(to + 1).skip(from) {
            let away = (x as f64 - centre) / reach;
            let weight = value * (1.0 - away * away) * (1.0 - away * away);
            mass += weight;
            moment += weight * x as f64;
        }
        if mass > 0.0 {
            points.push((line as f64, moment / mass, mass));
        }
    }
    straight(&points).map_or(lines, |(start, apart)| Lines { start, apart, ..lines })
}

/// The straight line through weighted points (x, y, weight) with the least squares: its height at 0 and its slope.
fn straight(points: &[(f64, f64, f64)]) -> Option<(f64, f64)> {
    let sum = |of: &dyn Fn(f64, f64) -> f64| points.iter().map(|&(x, y, weight)| weight * of(x, y)).sum::<f64>();
    let weight = sum(&|_, _| 1.0);
    let (x, y) = (sum(&|x, _| x) / weight, sum(&|_, y| y) / weight);
    let (xx, xy) = (sum(&|a, _| (a - x) * (a - x)), sum(&|a, b| (a - x) * (b - y)));
    let slope = xy / xx;
    (points.len() >= 2 && slope.is_finite()).then_some((y - slope * x, slope))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_lines() {
        let points = [(0.0, 1.0, 1.0), (1.0, 3.0, 2.0), (2.0, 5.0, 0.5)];
        let (start, slope) = straight(&points).unwrap();
        assert!((start - 1.0).abs() < 1e-12 && (slope - 2.0).abs() < 1e-12);
        assert_eq!(straight(&points[..1]), None);
        assert_eq!(straight(&[(1.0, 2.0, 1.0), (1.0, 3.0, 1.0)]), None);
    }
}
