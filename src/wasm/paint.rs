//! Raster layers: the map and one field over it, one pixel a cell. On a terrain the field lies over shaded ground, and what has no data
//! is left clear, for the page to hatch.

#[cfg(feature = "whole")]
use wasm_bindgen::prelude::*;
use wasm_bindgen::{Clamped, JsCast};
use web_sys::{ImageData, OffscreenCanvasRenderingContext2d};

use super::Answer;
use super::arguments::{Context, Flag, LayerOrNone, ThemeName, argument, not, word};
#[cfg(feature = "whole")]
use super::ground::Ground;
use crate::map::Grid;
use crate::planner::{Layer, Planner, extent};

/// What the browser calls it.
const CONTEXT: &str = "an OffscreenCanvasRenderingContext2D";

pub(super) type Rgb = [u8; 3];

/// The page's theme.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Theme {
    Light,
    Dark,
}

impl Theme {
    fn of(name: &ThemeName) -> Answer<Self> {
        match name.as_string().as_deref() {
            Some("light") => Ok(Self::Light),
            Some("dark") => Ok(Self::Dark),
            _ => Err(not("theme", "light or dark")),
        }
    }

    fn free(self) -> Rgb {
        match self {
            Self::Light => [251, 250, 247],
            Self::Dark => [18, 21, 27],
        }
    }

    fn blocked(self) -> Rgb {
        match self {
            Self::Light => [61, 68, 81],
            Self::Dark => [75, 84, 100],
        }
    }

    /// Stops from "next to nothing" to "strongest". Lightness runs one way, so that the order survives colour blindness and grey print.
    fn stops(self, layer: Layer) -> [Rgb; 4] {
        match (self, Ramp::of(layer)) {
            (Self::Light, Ramp::Trail) => [[254, 240, 196], [253, 190, 90], [233, 100, 44], [150, 26, 70]],
            (Self::Dark, Ramp::Trail) => [[52, 26, 84], [140, 41, 129], [236, 88, 96], [254, 226, 150]],
            (Self::Light, Ramp::Explored) => [[56, 124, 186], [116, 170, 216], [176, 208, 236], [222, 236, 248]],
            (Self::Dark, Ramp::Explored) => [[126, 196, 240], [58, 134, 192], [28, 84, 134], [20, 48, 78]],
            (Self::Light, Ramp::Ground) => [[238, 236, 246], [206, 204, 230], [164, 160, 208], [116, 108, 176]],
            (Self::Dark, Ramp::Ground) => [[30, 30, 46], [48, 46, 80], [76, 72, 126], [124, 116, 186]],
            (Self::Light, Ramp::Position) => [[236, 245, 226], [180, 218, 160], [86, 166, 112], [14, 94, 84]],
            (Self::Dark, Ramp::Position) => [[18, 44, 42], [24, 92, 78], [86, 166, 104], [214, 238, 160]],
        }
    }
}

/// What kind of thing a layer shows.
#[derive(Debug, Clone, Copy)]
enum Ramp {
    /// Warm: what ants leave and see.
    Trail,
    /// Cool: what a search explores.
    Explored,
    /// Near the colour of walls: a property of the map.
    Ground,
    /// Green: the numbers that a swarm moves.
    Position,
}

impl Ramp {
    fn of(layer: Layer) -> Self {
        match layer {
            Layer::Trail | Layer::Visits | Layer::Heuristic | Layer::InitialTrail | Layer::SeedPath => Self::Trail,
            Layer::Cost => Self::Explored,
            Layer::Density => Self::Ground,
            Layer::Priority => Self::Position,
        }
    }

    /// Trails span decades, and the root lifts the weak ones out of the ground; shares and positions spread evenly by themselves.
    fn scaled(self, t: f32) -> f32 {
        match self {
            Self::Trail | Self::Explored => t.sqrt(),
            Self::Ground | Self::Position => t,
        }
    }

    /// How much of a terrain's ground the colour hides where the layer is `t` strong, 0 to 1: weak trails let it show through.
    #[cfg(feature = "whole")]
    fn cover(self, t: f32) -> f32 {
        match self {
            Self::Trail => (1.35 * t).min(0.95),
            Self::Explored => 0.8,
            Self::Ground | Self::Position => 0.7,
        }
    }
}

/// How a map is painted: in which colours, and on a terrain with how much relief.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Style {
    pub theme: Theme,
    /// Cells per unit of the heights.
    pub scale: f64,
    /// Without it the ground has its colours but no light and shade: who draws it in three dimensions lights it himself.
    pub shaded: bool,
}

impl Style {
    pub(super) fn of(theme: &ThemeName, scale: f64, shaded: &Flag) -> Answer<Self> {
        Ok(Self { theme: Theme::of(theme)?, scale, shaded: shaded.read("shaded")? })
    }
}

/// The pixel buffer and the field of one run, kept from frame to frame.
#[derive(Debug, Default)]
pub(super) struct Canvas {
    field: Vec<f32>,
    rgba: Vec<u8>,
    #[cfg(feature = "whole")]
    ground: Ground,
}

impl Canvas {
    /// Paints map and layer, whose colours go from the lower to the upper of these values, or of the layer's own, which it gives.
    pub(super) fn paint(
        &mut self,
        context: &Context,
        grid: &Grid,
        planner: &dyn Planner,
        layer: Option<Layer>,
        style: Style,
        ends: Option<[f32; 2]>,
    ) -> Answer<Option<[f32; 2]>> {
        let layer = layer.filter(|&kind| planner.layer(kind, &mut self.field));
        let own = layer.and_then(|_| extent(&self.field, grid));
        self.put(context, grid, layer.map(|kind| Shown::new(kind, style.theme, ends.or(own))), style)?;
        Ok(own)
    }

    /// Paints the map alone.
    pub(super) fn paint_map(&mut self, context: &Context, grid: &Grid, style: Style) -> Answer<()> {
        self.put(context, grid, None, style)
    }

    fn put(&mut self, context: &Context, grid: &Grid, layer: Option<Shown>, style: Style) -> Answer<()> {
        let context: &OffscreenCanvasRenderingContext2d = context.dyn_ref().ok_or_else(|| not("context", CONTEXT))?;
        self.rgba.resize(grid.len() * 4, u8::MAX);
        #[cfg(feature = "whole")]
        match grid.heights() {
            Some(heights) => self.fill_terrain(grid, heights, style, layer),
            None => self.fill(grid, style.theme, layer),
        }
        #[cfg(not(feature = "whole"))]
        self.fill(grid, style.theme, layer);
        let image = ImageData::new_with_u8_clamped_array_and_sh(Clamped(&self.rgba), grid.width(), grid.height());
        let painted = image.and_then(|image| context.put_image_data(&image, 0.0, 0.0));
        painted.map_err(|_| argument("context", "nothing can be painted here"))
    }

    fn fill(&mut self, grid: &Grid, theme: Theme, layer: Option<Shown>) {
        for (c, pixel) in self.rgba.chunks_exact_mut(4).enumerate() {
            let color = if grid.is_blocked(c as u32) {
                theme.blocked()
            } else if let Some(shown) = &layer {
                shown.over(theme.free(), shown.strength(self.field[c]))
            } else {
                theme.free()
            };
            pixel[..3].copy_from_slice(&color);
        }
    }

    #[cfg(feature = "whole")]
    fn fill_terrain(&mut self, grid: &Grid, heights: &[f32], style: Style, layer: Option<Shown>) {
        self.ground.prepare(heights, grid.width(), style);
        for (c, pixel) in self.rgba.chunks_exact_mut(4).enumerate() {
            let ground = self.ground.color(c);
            let color = if grid.is_blocked(c as u32) {
                self.ground.lit(c, style.theme.blocked())
            } else if let Some(shown) = &layer {
                let t = shown.ramp.scaled(shown.strength(self.field[c]));
                if t.is_finite() && t > 0.0 {
                    self.ground.under(c, shown.table[(t * 255.0) as usize & 255], shown.ramp.cover(t))
                } else {
                    ground
                }
            } else {
                ground
            };
            pixel[..3].copy_from_slice(&color);
            pixel[3] = if heights[c].is_finite() { u8::MAX } else { 0 };
        }
    }
}

/// A layer on show.
struct Shown {
    ramp: Ramp,
    table: [Rgb; 256],
    /// The value with the first colour, and 1 / its distance to the one with the last; 0 where all values are the same.
    low: f32,
    per_unit: f32,
}

impl Shown {
    /// Without a finite value there are no ends, and nothing is shown.
    fn new(layer: Layer, theme: Theme, ends: Option<[f32; 2]>) -> Self {
        let [low, high] = ends.unwrap_or_default();
        let per_unit = if high > low { 1.0 / (high - low) } else { 0.0 };
        Self { ramp: Ramp::of(layer), table: color_table(theme, layer), low, per_unit }
    }

    /// Where a value lies between the ends, 0 to 1; below the lower one negative, and not finite where there is no value.
    fn strength(&self, value: f32) -> f32 {
        let t = (value - self.low) * self.per_unit;
        if t > 1.0 && value.is_finite() { 1.0 } else { t }
    }

    /// Colour of a strength. What is lowest shows the bare map, and so does what has no value.
    fn over(&self, free: Rgb, t: f32) -> Rgb {
        if !t.is_finite() || t <= 0.002 {
            return free;
        }
        self.table[(self.ramp.scaled(t) * 255.0) as usize & 255]
    }
}

/// Three bytes each: the colour of a free cell, that of a blocked one, and 256 of a layer from its lowest value to its highest, evenly; of
/// no layer those of a terrain from its lowest ground to its highest.
#[cfg(feature = "whole")]
#[wasm_bindgen]
pub fn map_colors(layer: &LayerOrNone, theme: &ThemeName) -> Answer<Vec<u8>> {
    let theme = Theme::of(theme)?;
    let mut colors = vec![theme.free(), theme.blocked()];
    match layer_of(layer)? {
        Some(layer) => {
            let shown = Shown::new(layer, theme, Some([0.0, 255.0]));
            colors.extend((0..=255u8).map(|value| shown.over(theme.free(), shown.strength(f32::from(value)))));
        }
        None => colors.extend(theme.ground()),
    }
    Ok(colors.concat())
}

/// A layer, or none.
pub(super) fn layer_of(name: &LayerOrNone) -> Answer<Option<Layer>> {
    if **name == *"none" { Ok(None) } else { word(name, "layer").map(Some) }
}

fn color_table(theme: Theme, layer: Layer) -> [Rgb; 256] {
    let stops = theme.stops(layer);
    std::array::from_fn(|i| {
        let t = i as f32 / 255.0 * (stops.len() - 1) as f32;
        let k = (t as usize).min(stops.len() - 2);
        let part = t - k as f32;
        std::array::from_fn(|ch| {
            let (a, b) = (f32::from(stops[k][ch]), f32::from(stops[k + 1][ch]));
            (a + (b - a) * part) as u8
        })
    })
}
