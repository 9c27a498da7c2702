//! How strong a layer is in each cell, in the steps of a scale of colours; four cells at a time.

use wide::{bytemuck::cast, f32x4, i32x4};

/// From the value with the first colour to the one with the last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    low: f32,
    /// 1 / the distance to the upper value; 0 where all values are the same.
    per_unit: f32,
    rooted: bool,
}

/// The shade of a cell that shows the bare map: what is lowest, and what has no value.
pub const BARE: usize = 256;
/// The shade of a blocked cell.
pub const BLOCKED: usize = 257;
/// How many shades there are: 256 of the layer, from its lowest value to its highest, [`BARE`] and [`BLOCKED`].
pub const SHADES: usize = 258;

/// Up to this strength the bare map is shown.
const FAINT: f32 = 0.002;

/// How many cells are looked at together.
const LANES: usize = 4;

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
        let t = (value - self.low) * self.per_unit;
        let t = if t > 1.0 && value.is_finite() { 1.0 } else { t };
        match t {
            f32::INFINITY => f32::NAN,
            _ if self.rooted => t.sqrt(),
            _ => t,
        }
    }

    /// Gives each cell the colour of its shade.
    pub fn colour<C: Copy>(&self, values: &[f32], blocked: &[bool], colours: &[C; SHADES], cells: &mut [C]) {
        let (low, per_unit) = (f32x4::splat(self.low), f32x4::splat(self.per_unit));
        let rooted: f32x4 = cast(i32x4::splat(if self.rooted { -1 } else { 0 }));
        for ((cells, blocked), four) in cells.chunks_mut(LANES).zip(blocked.chunks(LANES)).zip(fours(values)) {
            let even = (four - low) * per_unit;
            let capped = even.fast_min(f32x4::ONE);
            let strength = rooted.bitselect(capped.sqrt(), capped);
            let is_shown: i32x4 = cast(even.simd_gt(f32x4::splat(FAINT)) & four.is_finite());
            let level = (strength * f32x4::splat(255.0)).fast_trunc_int();
            let shades = is_shown.bitselect(level, i32x4::splat(BARE as i32)).to_array();
            for ((cell, &blocked), shade) in cells.iter_mut().zip(blocked).zip(shades) {
                *cell = colours[if blocked { BLOCKED } else { shade as usize }];
            }
        }
    }
}

/// Values four at a time; what the last four lack is NaN.
pub(super) fn fours(values: &[f32]) -> impl Iterator<Item = f32x4> {
    let some = |four: &[f32]| std::array::from_fn(|k| four.get(k).copied().unwrap_or(f32::NAN));
    values.chunks(LANES).map(move |four| f32x4::new(four.first_chunk().copied().unwrap_or_else(|| some(four))))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One cell, as one would write it down.
    fn plainly([low, high]: [f32; 2], rooted: bool, value: f32, blocked: bool) -> usize {
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
        (if rooted { t.sqrt() } else { t } * 255.0).floor() as usize
    }

    #[test]
    fn colours_are_those_of_a_plain_look_at_each_cell() {
        let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MIN, f32::MAX, -0.0, 1e-30, 0.25, 2.0, 7.5];
        let even = (0..1001).map(|k| k as f32 * 0.0017 - 0.2);
        let values: Vec<f32> = odd.into_iter().chain(even).collect();
        let blocked: Vec<bool> = (0..values.len()).map(|k| k % 7 == 3).collect();
        let colours: [usize; SHADES] = std::array::from_fn(|shade| shade);
        for ends in [[0.0, 1.0], [-0.1, 0.3], [0.5, 0.5], [1e-30, 1e30], [f32::MIN, f32::MAX]] {
            for rooted in [false, true] {
                let mut cells = vec![0; values.len()];
                Scale::new(Some(ends), rooted).colour(&values, &blocked, &colours, &mut cells);
                let plain: Vec<usize> = values.iter().zip(&blocked).map(|(&v, &b)| plainly(ends, rooted, v, b)).collect();
                assert_eq!(cells, plain, "{ends:?}, rooted: {rooted}");
            }
        }
    }

    #[test]
    fn without_ends_the_map_is_bare() {
        let colours: [usize; SHADES] = std::array::from_fn(|shade| shade);
        let mut cells = [0; 3];
        Scale::new(None, true).colour(&[0.0, 3.0, f32::NAN], &[false, false, true], &colours, &mut cells);
        assert_eq!(cells, [BARE, BARE, BLOCKED]);
    }

    #[test]
    fn strengths_by_hand() {
        let scale = Scale::new(Some([1.0, 5.0]), true);
        assert_eq!([1.0, 2.0, 5.0, 9.0].map(|value| scale.strength(value)), [0.0, 0.5, 1.0, 1.0]);
        for value in [0.5, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert!(scale.strength(value).is_nan(), "{value}");
        }
    }
}
