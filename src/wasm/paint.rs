//! Raster layers: the map and one field over it, one pixel a cell. On a terrain the field lies over shaded ground, on weighted ground over
//! its tints. What has no data is left clear, and where the robot does not fit half clear, for the page to hatch.
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

/// The map that is painted.
#[derive(Clone, Copy)]
pub(super) struct Underfoot<'a> {
    /// The one on which one moves.
    pub grid: &'a Grid,
    /// The one that was drawn, where the robot is no point: what is free on it alone is too narrow.
    #[cfg(feature = "whole")]
    pub drawn: Option<&'a Grid>,
}

/// Of cells in which the robot does not fit: the page's hatching shows through.
#[cfg(feature = "whole")]
const NARROW_OPACITY: u8 = 150;

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
        map: Underfoot,
        (planner, moment): (&dyn Planner, Moment),
        layer: Option<Layer>,
        style: Style,
        ends: Option<[f32; 2]>,
    ) -> Answer<Option<[f32; 2]>> {
        let layer = layer.filter(|&kind| self.field.take(planner, map.grid, kind, moment));
        let own = layer.and(self.field.own);
        let picture = (moment, layer, layer.and(ends.or(own)), style);
        if self.shown != Some(picture) {
            self.fill(map, layer.map(|kind| Shown::new(kind, style.theme, picture.2)), style);
            self.shown = Some(picture);
        }
        self.put(context, map.grid)?;
        Ok(own)
    }

    /// Paints the map alone.
    pub(super) fn paint_map(&mut self, context: &Context, map: Underfoot, style: Style) -> Answer<()> {
        self.fill(map, None, style);
        self.put(context, map.grid)
    }

    /// The picture is a view of the pixels: made anew each time, as the memory below may have moved when it grew.
    fn put(&self, context: &Context, grid: &Grid) -> Answer<()> {
        let context: &OffscreenCanvasRenderingContext2d = context.dyn_ref().ok_or_else(|| not("context", CONTEXT))?;
        let bytes: &[u8] = cast_slice(&self.pixels);
        let image = ImageData::new_with_u8_clamped_array_and_sh(Clamped(bytes), grid.width(), grid.height());
        let painted = image.and_then(|image| context.put_image_data(&image, 0.0, 0.0));
        painted.map_err(|_| argument("context", "nothing can be painted here"))
    }

    fn fill(&mut self, map: Underfoot, layer: Option<Shown>, style: Style) {
        let grid = map.grid;
        self.pixels.resize(grid.len(), 0);
        #[cfg(feature = "whole")]
        if self.ground.prepare(map, style) {
            return self.fill_ground(map, style, layer);
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

    /// Of what is no plain plane.
    #[cfg(feature = "whole")]
    fn fill_ground(&mut self, Underfoot { grid, drawn }: Underfoot, style: Style, layer: Option<Shown>) {
        let is_known = |c: usize| grid.heights().is_none_or(|heights| heights[c].is_finite());
        let is_narrow = |c: usize| drawn.is_some_and(|drawn| !drawn.is_blocked(c as u32));
        for (c, pixel) in self.pixels.iter_mut().enumerate() {
            let over = || layer.as_ref().and_then(|shown| shown.over_ground(self.field.values[c]));
            let mut opacity = if is_known(c) { u8::MAX } else { 0 };
            let [r, g, b] = if !grid.is_blocked(c as u32) {
                over().map_or_else(|| self.ground.color(c), |(color, cover)| self.ground.under(c, style.theme, color, cover))
            } else if is_narrow(c) {
                opacity = if style.shaded { opacity.min(NARROW_OPACITY) } else { opacity };
                self.ground.lit(c, style.theme, style.theme.narrow())
            } else {
                self.ground.lit(c, style.theme, style.theme.blocked())
            };
            *pixel = u32::from_le_bytes([r, g, b, opacity]);
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
