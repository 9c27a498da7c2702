//! The colours of a map and of the layers over it.

#[cfg(feature = "whole")]
use wasm_bindgen::prelude::*;

use super::Answer;
#[cfg(feature = "whole")]
use super::arguments::LayerOrNone;
use super::arguments::{ThemeName, not};
#[cfg(feature = "whole")]
use super::paint::layer_of;
use crate::planner::Layer;
use crate::planner::shades::{BARE, BLOCKED, SHADES, Scale};

pub(super) type Rgb = [u8; 3];

/// The page's theme.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Theme {
    Light,
    Dark,
}

impl Theme {
    pub(super) fn of(name: &ThemeName) -> Answer<Self> {
        match name.as_string().as_deref() {
            Some("light") => Ok(Self::Light),
            Some("dark") => Ok(Self::Dark),
            _ => Err(not("theme", "light or dark")),
        }
    }

    pub(super) fn free(self) -> Rgb {
        match self {
            Self::Light => [251, 250, 247],
            Self::Dark => [18, 21, 27],
        }
    }

    pub(super) fn blocked(self) -> Rgb {
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
            Layer::Cost | Layer::Scent | Layer::Merged => Self::Explored,
            Layer::Density => Self::Ground,
            Layer::Priority => Self::Position,
        }
    }

    /// Trails span decades, and the root lifts the weak ones out of the ground; shares and positions spread evenly by themselves.
    fn is_rooted(self) -> bool {
        matches!(self, Self::Trail | Self::Explored)
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

/// A layer on show.
pub(super) struct Shown {
    /// The shade of each value.
    pub scale: Scale,
    #[cfg(feature = "whole")]
    ramp: Ramp,
    table: [Rgb; 256],
}

impl Shown {
    /// Its colours go from the lower to the upper of `ends`; without a finite value there are no ends, and nothing is shown.
    pub fn new(layer: Layer, theme: Theme, ends: Option<[f32; 2]>) -> Self {
        let ramp = Ramp::of(layer);
        Self {
            scale: Scale::new(ends, ramp.is_rooted()),
            #[cfg(feature = "whole")]
            ramp,
            table: color_table(theme, layer),
        }
    }

    /// The opaque pixel of each shade.
    pub fn pixels(&self, theme: Theme) -> [u32; SHADES] {
        let mut pixels = [0; SHADES];
        pixels.iter_mut().zip(&self.table).for_each(|(pixel, &color)| *pixel = opaque(color));
        pixels[BARE] = opaque(theme.free());
        pixels[BLOCKED] = opaque(theme.blocked());
        pixels
    }

    /// The colour of a strength on a terrain, and how much of the ground it hides, 0 to 1; none where the ground is bare.
    #[cfg(feature = "whole")]
    pub fn over_ground(&self, value: f32) -> Option<(Rgb, f32)> {
        let t = self.scale.strength(value);
        (t > 0.0).then(|| (self.table[(t * 255.0) as usize & 255], self.ramp.cover(t)))
    }
}

/// A pixel as a picture has it: red, green, blue, opacity, one byte each.
pub(super) fn opaque([r, g, b]: Rgb) -> u32 {
    u32::from_le_bytes([r, g, b, u8::MAX])
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
            let values: [f32; 256] = std::array::from_fn(|value| value as f32);
            let mut shades = [theme.free(); 256];
            let mut table = [theme.free(); SHADES];
            table[..256].copy_from_slice(&shown.table);
            shown.scale.colour(&values, &[false; 256], &table, &mut shades);
            colors.extend(shades);
        }
        None => colors.extend(theme.ground()),
    }
    Ok(colors.concat())
}

/// As [`map_colors`], of weighted ground: from factor 1 to 10, which all dearer ground has, evenly by factor.
#[cfg(feature = "whole")]
#[wasm_bindgen]
pub fn weight_colors(theme: &ThemeName) -> Answer<Vec<u8>> {
    let theme = Theme::of(theme)?;
    let colors: Vec<Rgb> = [theme.free(), theme.blocked()].into_iter().chain(theme.weights()).collect();
    Ok(colors.concat())
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
