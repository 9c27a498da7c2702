//! Raster layers: the map and one field over it, one pixel a cell.

use wasm_bindgen::{Clamped, JsValue};
use web_sys::{ImageData, OffscreenCanvasRenderingContext2d};

use crate::map::Grid;
use crate::planner::{Layer, Planner};

type Rgb = [u8; 3];

/// The page's theme.
#[derive(Debug, Clone, Copy)]
pub(super) enum Theme {
    Light,
    Dark,
}

impl Theme {
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

    /// Stops from "next to nothing" to "strongest". Lightness runs one way, so that the order survives colour blindness and grey print;
    /// warm for what ants leave and see, cool for what a search explores.
    fn stops(self, layer: Layer) -> [Rgb; 4] {
        let explored = matches!(layer, Layer::Cost);
        match (self, explored) {
            (Self::Light, false) => [[254, 240, 196], [253, 190, 90], [233, 100, 44], [150, 26, 70]],
            (Self::Dark, false) => [[52, 26, 84], [140, 41, 129], [236, 88, 96], [254, 226, 150]],
            (Self::Light, true) => [[56, 124, 186], [116, 170, 216], [176, 208, 236], [222, 236, 248]],
            (Self::Dark, true) => [[126, 196, 240], [58, 134, 192], [28, 84, 134], [20, 48, 78]],
        }
    }
}

/// The pixel buffer and the field of one run, kept from frame to frame.
#[derive(Debug, Default)]
pub(super) struct Canvas {
    field: Vec<f32>,
    rgba: Vec<u8>,
}

impl Canvas {
    /// Paints map and layer.
    pub(super) fn paint(
        &mut self,
        context: &OffscreenCanvasRenderingContext2d,
        grid: &Grid,
        planner: &dyn Planner,
        layer: Option<Layer>,
        theme: Theme,
    ) -> Result<(), JsValue> {
        let layer = layer.filter(|&kind| planner.layer(kind, &mut self.field));
        self.rgba.resize(grid.len() * 4, u8::MAX);
        self.fill(grid, theme, layer);
        let image = ImageData::new_with_u8_clamped_array_and_sh(Clamped(&self.rgba), grid.width(), grid.height())?;
        context.put_image_data(&image, 0.0, 0.0)
    }

    fn fill(&mut self, grid: &Grid, theme: Theme, layer: Option<Layer>) {
        let table = layer.map(|kind| color_table(theme, kind));
        let (low, per_unit) = range(&self.field, grid);
        for (c, pixel) in self.rgba.chunks_exact_mut(4).enumerate() {
            let color = if grid.is_blocked(c as u32) {
                theme.blocked()
            } else if let Some(table) = &table {
                shade(table, theme, self.field[c], low, per_unit)
            } else {
                theme.free()
            };
            pixel[..3].copy_from_slice(&color);
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

/// Colour of a value. The square root lifts weak trails out of the ground; what is lowest shows the bare map.
fn shade(table: &[Rgb; 256], theme: Theme, value: f32, low: f32, per_unit: f32) -> Rgb {
    let t = (value - low) * per_unit;
    if !value.is_finite() || t.is_nan() || t <= 0.002 {
        return theme.free();
    }
    table[(t.sqrt() * 255.0) as usize & 255]
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
