//! Ground that is no plain plane as the page shows it: of a terrain colours by height, light and shade, contour lines; of weighted ground
//! tints by what it costs.

use std::sync::Arc;

use wasm_bindgen::prelude::*;

use super::Answer;
use super::arguments::{Heights, Number};
use super::colours::{Rgb, Theme};
use super::paint::{Style, Underfoot};
use crate::map::{self, LEVEL_LIGHT, Shading};

impl Theme {
    /// From the lowest ground to the highest; quiet, so that layers and paths read over it. Lightness runs one way.
    fn tints(self) -> [Rgb; 3] {
        match self {
            Self::Light => [[196, 211, 199], [228, 222, 200], [250, 247, 241]],
            Self::Dark => [[22, 34, 36], [48, 50, 46], [86, 80, 72]],
        }
    }

    /// 256 tints from the lowest ground to the highest.
    pub(super) fn ground(self) -> impl Iterator<Item = Rgb> {
        (0..=255).map(move |height| tint(&self.tints(), height))
    }

    /// From plain ground to the dearest that is told apart. Cool, as trails are warm; lightness runs one way.
    fn weight_tints(self) -> [Rgb; 3] {
        match self {
            Self::Light => [self.free(), [168, 201, 199], [66, 122, 126]],
            Self::Dark => [self.free(), [31, 70, 76], [74, 142, 140]],
        }
    }

    /// The tint of a cell of this factor: by its logarithm, as a factor counts against others by how often, not by how much.
    fn weighed(self, factor: f32) -> Rgb {
        let share = libm::log10(f64::from(factor)) / libm::log10(DEAREST);
        tint(&self.weight_tints(), (share.clamp(0.0, 1.0) * 255.0) as i32)
    }

    /// 256 tints from factor 1 to [`DEAREST`], evenly by factor.
    pub(super) fn weights(self) -> impl Iterator<Item = Rgb> {
        (0..=255).map(move |k| self.weighed((1.0 + (DEAREST - 1.0) * f64::from(k) / 255.0) as f32))
    }

    /// Where the robot does not fit: neither ground nor wall.
    pub(super) fn narrow(self) -> Rgb {
        match self {
            Self::Light => [170, 172, 181],
            Self::Dark => [50, 56, 68],
        }
    }

    /// What the ground turns to in the shade and in the light.
    fn shade(self) -> [Rgb; 2] {
        match self {
            Self::Light => [[58, 66, 88], [255, 255, 252]],
            Self::Dark => [[4, 6, 12], [168, 174, 176]],
        }
    }
}

/// The factor from which on all ground has the same tint.
const DEAREST: f64 = 10.0;

/// Colours and light of a map's cells, made once for a map and a theme.
#[derive(Debug, Default)]
pub(super) struct Ground {
    shading: Option<Shading>,
    /// Of which style and factors the colours are.
    made: Option<(Style, Option<Arc<[f32]>>)>,
    colors: Vec<Rgb>,
    /// For each strength of light the part that shade or light has in a colour, of 256; above 0 light, below 0 shade.
    mixes: Vec<i32>,
}

impl Ground {
    /// Makes colours of this style, if they are not there already; false for a plain plane, which needs none. A canvas belongs to one map,
    /// whose heights stay.
    pub fn prepare(&mut self, Underfoot { grid, drawn }: Underfoot, style: Style) -> bool {
        let (heights, factors) = (grid.heights(), grid.factors());
        if heights.is_none() && factors.is_none() && drawn.is_none() {
            return false;
        }
        let is_made = |(made, of): &(Style, Option<Arc<[f32]>>)| *made == style && same(of.as_ref(), factors);
        if !self.made.as_ref().is_some_and(is_made) {
            match heights {
                Some(heights) => self.shade(heights, grid.width(), style),
                None => self.weigh(factors.map_or(&[], |factors| factors), grid.len(), style.theme),
            }
            self.made = Some((style, factors.cloned()));
        }
        true
    }

    fn shade(&mut self, heights: &[f32], width: u32, style: Style) {
        let shading = self.shading.take().unwrap_or_else(|| Shading::of(heights, width, style.scale));
        self.mixes = (0..=255).map(|light| if style.shaded { mix_of(light) } else { 0 }).collect();
        let tints: Vec<Rgb> = style.theme.ground().collect();
        self.colors = shading.heights.iter().map(|&height| tints[height as usize]).collect();
        self.shading = Some(shading);
        for c in 0..self.colors.len() {
            self.colors[c] = self.lit(c, style.theme, self.colors[c]);
        }
    }

    /// Without factors all ground is plain.
    fn weigh(&mut self, factors: &[f32], cells: usize, theme: Theme) {
        self.colors.clear();
        self.colors.extend(factors.iter().map(|&factor| theme.weighed(factor)));
        self.colors.resize(cells, theme.free());
    }

    /// The ground's colour.
    pub fn color(&self, c: usize) -> Rgb {
        self.colors[c]
    }

    /// A colour in the light that falls on a cell; as it is where there are no heights.
    pub fn lit(&self, c: usize, theme: Theme, color: Rgb) -> Rgb {
        let Some(shading) = &self.shading else { return color };
        let [dark, bright] = theme.shade();
        let mix = self.mixes[shading.light[c] as usize];
        blend(color, if mix < 0 { dark } else { bright }, mix.abs())
    }

    /// The ground under a layer's colour that hides this part of it. The colour takes part in light and shade.
    pub fn under(&self, c: usize, theme: Theme, color: Rgb, cover: f32) -> Rgb {
        blend(self.colors[c], self.lit(c, theme, color), (cover * 256.0) as i32)
    }
}

fn same(a: Option<&Arc<[f32]>>, b: Option<&Arc<[f32]>>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        _ => a.is_none() && b.is_none(),
    }
}

/// Shade takes up to six tenths, light up to four.
fn mix_of(light: i32) -> i32 {
    let level = i32::from(LEVEL_LIGHT);
    if light < level { (light - level) * 154 / level } else { (light - level) * 102 / (255 - level) }
}

fn tint([low, middle, high]: &[Rgb; 3], height: i32) -> Rgb {
    if height < 128 { blend(*low, *middle, height * 2) } else { blend(*middle, *high, (height - 128) * 2) }
}

/// `part` of 256 of the second colour.
fn blend(a: Rgb, b: Rgb, part: i32) -> Rgb {
    std::array::from_fn(|k| {
        let (a, b) = (i32::from(a[k]), i32::from(b[k]));
        (a + (b - a) * part / 256) as u8
    })
}

/// The contour lines of a terrain, as one list of points.
#[wasm_bindgen]
pub struct ContourLines {
    contours: map::Contours,
}

#[wasm_bindgen]
impl ContourLines {
    /// Of heights row by row, `unit` metres each; NaN where there is no data.
    #[wasm_bindgen(constructor)]
    pub fn new(width: &Number, heights: &Heights, unit: &Number) -> Answer<ContourLines> {
        let (width, heights) = (width.whole("width")?, heights.read("heights")?);
        Ok(ContourLines { contours: map::Contours::of(&heights, width, unit.real("unit")?) })
    }

    /// Metres between one line and the next; 0 on level ground.
    pub fn interval(&self) -> f64 {
        self.contours.interval
    }

    /// x0, y0, x1, y1, … of all lines in cells from the upper left corner of the map.
    pub fn points(&self) -> Vec<f32> {
        self.contours.lines.iter().flat_map(|line| line.points.as_flattened()).copied().collect()
    }

    /// For each line the number of points up to its end.
    pub fn ends(&self) -> Vec<u32> {
        let ends = self.contours.lines.iter().scan(0, |end, line| {
            *end += line.points.len() as u32;
            Some(*end)
        });
        ends.collect()
    }

    /// For each line its height in intervals; every fifth is a main line.
    pub fn levels(&self) -> Vec<i32> {
        self.contours.lines.iter().map(|line| line.level).collect()
    }
}
