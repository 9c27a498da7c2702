//! Hill shading: how much light falls on each cell of a terrain from the north-west, 45° above the horizon.
//!
//! Slopes are those of Horn (1981): weighted differences over the eight neighbours. They are stretched until the mean slope of the map is
//! [`MEAN_SLOPE`], so that flat ground shows its form and rough ground keeps some.

/// Mean rise over run of the ground as it is lit.
const MEAN_SLOPE: f64 = 0.55;

/// Most stretching: what is flatter looks flat.
const MOST_STRETCH: f64 = 40.0;

/// Light on level ground, of 255.
pub const LEVEL_LIGHT: u8 = 180;

/// What a terrain looks like from above.
#[derive(Debug, Clone, PartialEq)]
pub struct Shading {
    /// Each cell's height between the lowest, 0, and the highest, 255; 0 where there is no data.
    pub heights: Vec<u8>,
    /// Light on each cell, 0 to 255; [`LEVEL_LIGHT`] on level ground and where there is no data.
    pub light: Vec<u8>,
}

impl Shading {
    /// Of heights row by row; `scale` is cells per unit of the heights.
    pub fn of(heights: &[f32], width: u32, scale: f64) -> Self {
        let slopes = slopes(heights, width as usize, scale);
        let known = || slopes.iter().filter(|s| !s[0].is_nan());
        let mean = known().map(|[x, y]| libm::sqrt(x * x + y * y)).sum::<f64>() / known().count().max(1) as f64;
        let stretch = if mean > 0.0 { (MEAN_SLOPE / mean).min(MOST_STRETCH) } else { 1.0 };
        Self { heights: ranks(heights), light: slopes.iter().map(|&[x, y]| light(x * stretch, y * stretch)).collect() }
    }
}

fn ranks(heights: &[f32]) -> Vec<u8> {
    let finite = heights.iter().filter(|h| h.is_finite());
    let (low, high) = finite.fold((f32::INFINITY, f32::NEG_INFINITY), |(l, h), &v| (l.min(v), h.max(v)));
    let per_unit = if high > low { 255.0 / (high - low) } else { 0.0 };
    // What is not a number becomes 0.
    heights.iter().map(|&h| ((h - low) * per_unit) as u8).collect()
}

/// Rise over run along x and y at each cell; NaN where there is no data. A neighbour without data stands as high as the cell itself.
fn slopes(heights: &[f32], width: usize, scale: f64) -> Vec<[f64; 2]> {
    let rows = heights.len() / width.max(1);
    let slope = |c: usize| {
        let (x, y, here) = (c % width, c / width, heights[c]);
        let at = |dx: isize, dy: isize| {
            let (nx, ny) = (x.saturating_add_signed(dx).min(width - 1), y.saturating_add_signed(dy).min(rows - 1));
            let h = heights[ny * width + nx];
            f64::from(if h.is_finite() { h } else { here })
        };
        let side = |dx| at(dx, -1) + 2.0 * at(dx, 0) + at(dx, 1);
        let end = |dy| at(-1, dy) + 2.0 * at(0, dy) + at(1, dy);
        // On the border a neighbour is the cell itself, one cell away instead of two.
        let span = |at: usize, size: usize| if at == 0 || at + 1 == size { 4.0 } else { 8.0 };
        [(side(1) - side(-1)) * scale / span(x, width), (end(1) - end(-1)) * scale / span(y, rows)]
    };
    (0..heights.len()).map(slope).collect()
}

/// The cosine between the ground's normal and the light.
fn light(x: f64, y: f64) -> u8 {
    let flat = std::f64::consts::FRAC_1_SQRT_2;
    let cosine = (0.5 * x + 0.5 * y + flat) / libm::sqrt(1.0 + x * x + y * y);
    if cosine.is_nan() { LEVEL_LIGHT } else { (cosine.clamp(0.0, 1.0) * 255.0 + 0.5) as u8 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn level_ground_and_holes_are_lit_alike() {
        let flat = Shading::of(&[5.0, 5.0, f32::NAN, 5.0], 2, 1.0);
        assert_eq!((flat.light, flat.heights), (vec![LEVEL_LIGHT; 4], vec![0; 4]));
    }

    #[test]
    fn what_faces_the_light_is_bright() {
        // A ridge that runs north and south: its western side rises to the east.
        let heights: Vec<f32> = (0..15).map(|c| [0.0, 1.0, 2.0, 1.0, 0.0][c % 5]).collect();
        let Shading { light, heights } = Shading::of(&heights, 5, 1.0);
        assert_eq!(heights[5..10], [0, 127, 255, 127, 0]);
        assert!(light[6] > LEVEL_LIGHT && light[8] < LEVEL_LIGHT && light[7] == LEVEL_LIGHT, "{light:?}");
        // Slope 1 but for the ridge, 4 of 5 columns: mean 0.8, stretched to 0.55: 0.6875. (0.34375 + 0.70711) / √(1 + 0.6875²) = 0.86580.
        assert_eq!(light[6], (0.865_80f64 * 255.0).round() as u8);
    }

    #[test]
    fn the_stretch_knows_the_true_slope_and_has_an_end() {
        let ramp = |rise: f32| (0..9).map(|c| (c % 3) as f32 * rise).collect::<Vec<_>>();
        let lit = |rise, scale| Shading::of(&ramp(rise), 3, scale).light[4];
        assert_eq!(lit(1.0, 1.0), lit(0.05, 1.0));
        assert_eq!(lit(1.0, 1.0), lit(1.0, 0.1));
        let nearly_level = lit(1.0, 1e-6);
        assert_eq!(nearly_level, LEVEL_LIGHT);
        // 40 · 0.001 = 0.04 instead of 0.55: (0.02 + 0.70711) / √1.0016 = 0.72653.
        assert_eq!(lit(1.0, 0.001), (0.726_53f64 * 255.0).round() as u8);
    }
}
