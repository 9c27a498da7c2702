//! Raster layers: the map and one field over it, one pixel a cell. On a terrain the field lies over shaded ground, and what has no data
//! is left clear, for the page to hatch.
//!
//! What has been computed is kept for as long as it holds: the field while the planner has changed nothing of it, the pixels while nothing
//! that they show has changed. They lie in the instance's own memory, from which a canvas takes them without a copy in between.

use wasm_bindgen::{Clamped, JsCast};
use web_sys::{ImageData, OffscreenCanvasRenderingContext2d};
use wide::bytemuck::cast_slice;

use super::Answer;
use super::arguments::{Context, Flag, LayerOrNone, ThemeName, argument, not, word};
use super::colours::{Shown, Theme, opaque};
#[cfg(feature = "whole")]
use super::ground::Ground;
use crate::map::Grid;
use crate::planner::{Layer, Planner, extent};

/// What the browser calls it.
const CONTEXT: &str = "an OffscreenCanvasRenderingContext2D";

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

/// What a run looks like: while it stays the same, so do its map and the layer that it was made for.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Moment {
    /// How often something else was to be looked at: the past, or a map with other walls.
    pub looks: u32,
    /// Changes of the map that have been made.
    pub changes: u32,
    /// Of the layer, where its planner tells it.
    pub version: Option<u64>,
    /// Where it does not: how often the run has advanced.
    pub steps: u32,
}

/// A layer's values over the cells.
#[derive(Debug, Default)]
struct Field {
    values: Vec<f32>,
    /// Of which layer, and when.
    of: Option<(Layer, Moment)>,
    /// Its smallest and its largest value.
    own: Option<[f32; 2]>,
}

/// What pixels show: moment, layer, its ends, style.
type Picture = (Moment, Option<Layer>, Option<[f32; 2]>, Style);

/// The pixels and the field of one run, kept from frame to frame.
#[derive(Debug, Default)]
pub(super) struct Canvas {
    field: Field,
    pixels: Vec<u32>,
    shown: Option<Picture>,
    #[cfg(feature = "whole")]
    ground: Ground,
}

impl Canvas {
    /// Paints map and layer, whose colours go from the lower to the upper of these values, or of the layer's own, which it gives.
    pub(super) fn paint(
        &mut self,
        context: &Context,
        grid: &Grid,
        (planner, moment): (&dyn Planner, Moment),
        layer: Option<Layer>,
        style: Style,
        ends: Option<[f32; 2]>,
    ) -> Answer<Option<[f32; 2]>> {
        let layer = layer.filter(|&kind| self.field.take(planner, grid, kind, moment));
        let own = layer.and(self.field.own);
        let picture = (moment, layer, layer.and(ends.or(own)), style);
        if self.shown != Some(picture) {
            self.fill(grid, layer.map(|kind| Shown::new(kind, style.theme, picture.2)), style);
            self.shown = Some(picture);
        }
        self.put(context, grid)?;
        Ok(own)
    }

    /// Paints the map alone.
    pub(super) fn paint_map(&mut self, context: &Context, grid: &Grid, style: Style) -> Answer<()> {
        self.fill(grid, None, style);
        self.put(context, grid)
    }

    /// The picture is a view of the pixels: made anew each time, as the memory below may have moved when it grew.
    fn put(&self, context: &Context, grid: &Grid) -> Answer<()> {
        let context: &OffscreenCanvasRenderingContext2d = context.dyn_ref().ok_or_else(|| not("context", CONTEXT))?;
        let bytes: &[u8] = cast_slice(&self.pixels);
        let image = ImageData::new_with_u8_clamped_array_and_sh(Clamped(bytes), grid.width(), grid.height());
        let painted = image.and_then(|image| context.put_image_data(&image, 0.0, 0.0));
        painted.map_err(|_| argument("context", "nothing can be painted here"))
    }

    fn fill(&mut self, grid: &Grid, layer: Option<Shown>, style: Style) {
        self.pixels.resize(grid.len(), 0);
        #[cfg(feature = "whole")]
        if let Some(heights) = grid.heights() {
            return self.fill_terrain(grid, heights, style, layer);
        }
        match layer {
            Some(shown) => {
                shown.scale.colour(&self.field.values, grid.blocked(), &shown.pixels(style.theme), &mut self.pixels);
            }
            None => {
                let colours = [style.theme.free(), style.theme.blocked()].map(opaque);
                let cells = self.pixels.iter_mut().zip(grid.blocked());
                cells.for_each(|(pixel, &blocked)| *pixel = colours[usize::from(blocked)]);
            }
        }
    }

    #[cfg(feature = "whole")]
    fn fill_terrain(&mut self, grid: &Grid, heights: &[f32], style: Style, layer: Option<Shown>) {
        self.ground.prepare(heights, grid.width(), style);
        for (c, pixel) in self.pixels.iter_mut().enumerate() {
            let over = || layer.as_ref().and_then(|shown| shown.over_ground(self.field.values[c]));
            let color = if grid.is_blocked(c as u32) {
                self.ground.lit(c, style.theme.blocked())
            } else if let Some((color, cover)) = over() {
                self.ground.under(c, color, cover)
            } else {
                self.ground.color(c)
            };
            *pixel = if heights[c].is_finite() { opaque(color) } else { u32::from_le_bytes([color[0], color[1], color[2], 0]) };
        }
    }
}

impl Field {
    /// Takes a layer's values, if they are not those that it has; false when the planner has no such layer.
    fn take(&mut self, planner: &dyn Planner, grid: &Grid, layer: Layer, moment: Moment) -> bool {
        if self.of == Some((layer, moment)) {
            return true;
        }
        let known = planner.layer(layer, &mut self.values);
        self.of = known.then_some((layer, moment));
        self.own = known.then(|| extent(&self.values, grid)).flatten();
        known
    }
}

/// A layer, or none.
pub(super) fn layer_of(name: &LayerOrNone) -> Answer<Option<Layer>> {
    if **name == *"none" { Ok(None) } else { word(name, "layer").map(Some) }
}
