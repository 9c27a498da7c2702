//! Raster layers: the map and one field over it, one pixel a cell. On a terrain the field lies over shaded ground, and what has no data
//! is left clear, for the page to hatch.

use wasm_bindgen::{Clamped, JsCast};
use web_sys::{ImageData, OffscreenCanvasRenderingContext2d};

use super::Answer;
use super::arguments::{Context, Flag, ThemeName, argument, not};
#[cfg(feature = "whole")]
use super::ground::Ground;
use crate::map::Grid;
use crate::planner::{Layer, Planner};

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
    /// Paints map and layer.
    pub(super) fn paint(
        &mut self,
        context: &Context,
        grid: &Grid,
        planner: &dyn Planner,
        layer: Option<Layer>,
        style: Style,
    ) -> Answer<()> {
        let layer = layer.filter(|&kind| planner.layer(kind, &mut self.field));
        self.put(context, grid, layer, style)
    }

    /// Paints the map alone.
    pub(super) fn paint_map(&mut self, context: &Context, grid: &Grid, style: Style) -> Answer<()> {
        self.put(context, grid, None, style)
    }

    fn put(&mut self, context: &Context, grid: &Grid, layer: Option<Layer>, style: Style) -> Answer<()> {
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

    fn fill(&mut self, grid: &Grid, theme: Theme, layer: Option<Layer>) {
        let table = layer.map(|kind| (Ramp::of(kind), color_table(theme, kind)));
        let (low, per_unit) = range(&self.field, grid);
        for (c, pixel) in self.rgba.chunks_exact_mut(4).enumerate() {
            let color = if grid.is_blocked(c as u32) {
                theme.blocked()
            } else if let Some((ramp, table)) = &table {
                let t = (self.field[c] - low) * per_unit;
                shade(table, theme, *ramp, t)
            } else {
                theme.free()
            };
            pixel[..3].copy_from_slice(&color);
        }
    }

    #[cfg(feature = "whole")]
    fn fill_terrain(&mut self, grid: &Grid, heights: &[f32], style: Style, layer: Option<Layer>) {
        let theme = style.theme;
        let table = layer.map(|kind| (Ramp::of(kind), color_table(theme, kind)));
        let (low, per_unit) = range(&self.field, grid);
        self.ground.prepare(heights, grid.width(), style);
        for (c, pixel) in self.rgba.chunks_exact_mut(4).enumerate() {
            let ground = self.ground.color(c);
            let color = if grid.is_blocked(c as u32) {
                self.ground.lit(c, theme.blocked())
            } else if let Some((ramp, table)) = &table {
                let t = ramp.scaled((self.field[c] - low) * per_unit);
                if t.is_finite() && t > 0.0 {
                    self.ground.under(c, table[(t * 255.0) as usize & 255], ramp.cover(t))
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

/// Smallest value over the free cells, and 1 / (largest − smallest); infinite values do not count.
fn range(field: &[f32], grid: &Grid) -> (f32, f32) {
    let (mut low, mut high) = (f32::INFINITY, f32::NEG_INFINITY);
    for (c, &v) in field.iter().enumerate() {
        if v.is_finite() && !grid.is_blocked(c as u32) {
            low = low.min(v);
            high = high.max(v);
        }
    }
    (low, if high > low { 1.0 / (high - low) } else { 0.0 })
}

/// Colour of a value between the lowest, 0, and the highest, 1. What is lowest shows the bare map, and so does what has no value.
fn shade(table: &[Rgb; 256], theme: Theme, ramp: Ramp, t: f32) -> Rgb {
    if !t.is_finite() || t <= 0.002 {
        return theme.free();
    }
    table[(ramp.scaled(t) * 255.0) as usize & 255]
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
