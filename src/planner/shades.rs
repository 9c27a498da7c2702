//! How strong a layer is in each cell, in the steps of a scale of colours.

/// From the value with the first colour to the one with the last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    low: f32,
    /// 1 / the distance to the upper value; 0 where all values are the same.
    per_unit: f32,
    rooted: bool,
}

/// The shade of a cell that shows the bare map: what is lowest, and what has no value.
pub const BARE: u16 = 256;
/// The shade of a blocked cell.
pub const BLOCKED: u16 = 257;
/// How many shades there are: 256 of the layer, from its lowest value to its highest, [`BARE`] and [`BLOCKED`].
pub const SHADES: usize = 258;

/// Up to this strength the bare map is shown.
const FAINT: f32 = 0.002;

impl Scale {
    /// Between two values, the smaller one first; without them nothing is shown. `rooted`: by the root of the distance, which lifts weak
    /// values out of the ground.
    pub fn new(ends: Option<[f32; 2]>, rooted: bool) -> Self {
        let [low, high] = ends.unwrap_or_default();
        let per_unit = if high > low { 1.0 / (high - low) } else { 0.0 };
        Self { low, per_unit, rooted }
    }

    /// Where a value lies between the ends, from 0 to 1; not above 0, or NaN, where nothing is to be shown.
    pub fn strength(&self, value: f32) -> f32 {
        let t = self.even(value);
        if self.rooted { t.sqrt() } else { t }
    }

    /// The shade of each cell of a row, or of any part of the map.
    pub fn shade(&self, values: &[f32], blocked: &[bool], shades: &mut [u16]) {
        // Two loops without a branch, which compilers turn into lanes.
        if self.rooted {
            self.shade_by(values, blocked, shades, f32::sqrt);
        } else {
            self.shade_by(values, blocked, shades, |t| t);
        }
    }

    #[inline(always)]
    fn shade_by(&self, values: &[f32], blocked: &[bool], shades: &mut [u16], scaled: impl Fn(f32) -> f32) {
        for ((shade, &value), &blocked) in shades.iter_mut().zip(values).zip(blocked) {
            let t = self.even(value);
            let shown = if t > FAINT { (scaled(t) * 255.0) as i32 as u16 } else { BARE };
            *shade = if blocked { BLOCKED } else { shown };
        }
    }

    #[inline(always)]
    fn even(&self, value: f32) -> f32 {
        let t = (value - self.low) * self.per_unit;
        let t = if t > 1.0 { 1.0 } else { t };
        if value.is_finite() { t } else { -1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One cell, as one would write it down.
    fn plainly([low, high]: [f32; 2], rooted: bool, value: f32, blocked: bool) -> u16 {
        if blocked {
            return BLOCKED;
        }
        if !value.is_finite() || high <= low {
            return BARE;
        }
        let t = (value - low) * (1.0 / (high - low));
        if t.is_nan() || t <= 0.002 {
            return BARE;
        }
        let t = t.min(1.0);
        (if rooted { t.sqrt() } else { t } * 255.0).floor() as u16
    }

    #[test]
    fn shades_are_those_of_a_plain_look_at_each_cell() {
        let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MIN, f32::MAX, -0.0, 1e-30, 0.25, 2.0, 7.5];
        let even = (0..1000).map(|k| k as f32 * 0.0017 - 0.2);
        let values: Vec<f32> = odd.into_iter().chain(even).collect();
        let blocked: Vec<bool> = (0..values.len()).map(|k| k % 7 == 3).collect();
        for ends in [[0.0, 1.0], [-0.1, 0.3], [0.5, 0.5], [1e-30, 1e30], [f32::MIN, f32::MAX]] {
            for rooted in [false, true] {
                let mut shades = vec![0; values.len()];
                Scale::new(Some(ends), rooted).shade(&values, &blocked, &mut shades);
                let plain: Vec<u16> = values.iter().zip(&blocked).map(|(&v, &b)| plainly(ends, rooted, v, b)).collect();
                assert_eq!(shades, plain, "{ends:?}, rooted: {rooted}");
            }
        }
    }

    #[test]
    fn without_ends_the_map_is_bare() {
        let mut shades = [0; 3];
        Scale::new(None, true).shade(&[0.0, 3.0, f32::NAN], &[false, false, true], &mut shades);
        assert_eq!(shades, [BARE, BARE, BLOCKED]);
    }
}
