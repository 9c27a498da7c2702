//! From pixels to free and blocked cells: gray, threshold, fewer cells than pixels.

use serde::{Deserialize, Serialize};

use super::Picture;
use super::shrink::{at_most, shrink_worst};
use super::threshold::{Histogram, gray};
use crate::error::{FormatError, Notice};
use crate::map::{MAX_SIDE, Window, check_size};

/// How a picture becomes a map. Fields that are left out are as in [`PictureOptions::default`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PictureOptions {
    /// Pixels whose gray (0–255) is below it are dark. 128 unless said otherwise; none: chosen by Otsu's method.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "number | null"))]
    pub threshold: Option<u8>,
    /// Whether light pixels are walls, instead of dark ones.
    pub light_is_blocked: bool,
    /// Only this window, in pixels.
    pub crop: Option<Window>,
    /// Cells of the longer side, at most its pixels. None: one cell a pixel, or 4096 where that would be more.
    pub cells: Option<u32>,
    /// Metres that a pixel is wide and high, above 0.
    pub metres_per_pixel: Option<f64>,
    /// Metres that a cell is wide and high, above 0. With `metres_per_pixel` the number of cells follows from it; alone it only says how
    /// large a cell is.
    pub metres_per_cell: Option<f64>,
}

impl Default for PictureOptions {
    fn default() -> Self {
        Self {
            threshold: Some(128),
            light_is_blocked: false,
            crop: None,
            cells: None,
            metres_per_pixel: None,
            metres_per_cell: None,
        }
    }
}

/// What a picture came to.
#[derive(Debug, Clone, PartialEq)]
pub struct Cells {
    /// Columns, 1–4096.
    pub width: u32,
    /// Rows, 1–4096.
    pub height: u32,
    /// Row by row from the upper left; 1 = blocked, 0 = free.
    pub blocked: Vec<u8>,
    /// The threshold that was used: given, or chosen.
    pub threshold: u8,
    /// Metres per cell, where the options tell.
    pub resolution: Option<f64>,
    /// What was read as what; the picture's own notices first.
    pub notices: Vec<Notice>,
}

/// Free and blocked cells of a picture. A pixel's gray is its luma (ITU-R 601, in whole numbers), transparent ones laid over white. A cell is
/// blocked if any pixel under it is: cell x of w covers the pixels ⌊x·W/w⌋ to ⌈(x+1)·W/w⌉ − 1 of W.
///
/// # Errors
/// [`FormatError::Window`]: the crop does not lie on the picture. [`FormatError::Field`]: the picture has one colour only, or an option is
/// out of its range. [`FormatError::NoFreeCell`].
pub fn to_cells(picture: &Picture, options: &PictureOptions) -> Result<Cells, FormatError> {
    let window = options.crop.unwrap_or(Window { x: 0, y: 0, width: picture.width, height: picture.height });
    window.check((picture.width, picture.height))?;
    let pixels = (window.width, window.height);
    let size = size(pixels, options)?;
    let mut notices = picture.notices.clone();
    let mut layer = gray(picture, window, &mut notices);
    let histogram = Histogram::new(&layer);
    if let Some(unknown) = histogram.unknown_of_ros() {
        let message = format!(
            "its grays 0, 205 and 254 are those of a ROS map: open its .yaml with it; alone, what nobody has seen (gray 205, pixels: {unknown}) is judged by the threshold"
        );
        notices.push(Notice::new("picture-of-ros", message).with("unknown", unknown));
    }
    let threshold = threshold(&histogram, options, &mut notices)?;
    for value in &mut layer {
        *value = u8::from((*value < threshold) != options.light_is_blocked);
    }
    let blocked = shrink_worst(&layer, pixels, size);
    tell(&blocked, threshold, options, &mut notices)?;
    if size != pixels {
        notices.push(shrunk(pixels, size));
    }
    let resolution = resolution(pixels, size, options);
    Ok(Cells { width: size.0, height: size.1, blocked, threshold, resolution, notices })
}

/// Columns and rows of the map.
fn size(pixels: (u32, u32), options: &PictureOptions) -> Result<(u32, u32), FormatError> {
    let pixel = metres("metres_per_pixel", options.metres_per_pixel)?;
    let cell = metres("metres_per_cell", options.metres_per_cell)?;
    let longer = pixels.0.max(pixels.1);
    let sides = match (options.cells, pixel, cell) {
        (Some(_), Some(_), Some(_)) => {
            let what = "the number of cells follows from metres per pixel and per cell";
            return Err(FormatError::field("cells", what, "one of the two"));
        }
        (None, Some(pixel), Some(cell)) => return in_metres(pixels, pixel, cell),
        (cells, ..) => cells.unwrap_or(longer.min(MAX_SIDE)),
    };
    if !(1..=longer.min(MAX_SIDE)).contains(&sides) {
        let what = format!("{sides} cells on {longer} pixels");
        return Err(FormatError::field("cells", what, format!("1 to {}", longer.min(MAX_SIDE))));
    }
    Ok(at_most(pixels, sides))
}

/// Metres that an option gives, if it does.
pub(in crate::formats) fn metres(field: &'static str, value: Option<f64>) -> Result<Option<f64>, FormatError> {
    match value {
        Some(value) if !(value.is_finite() && value > 0.0) => {
            Err(FormatError::field(field, format!("{value} m"), "a length above 0"))
        }
        value => Ok(value),
    }
}

/// As many cells of a size in metres as fit best.
fn in_metres(pixels: (u32, u32), pixel: f64, cell: f64) -> Result<(u32, u32), FormatError> {
    let longer = f64::from(pixels.0.max(pixels.1));
    let fewest = (longer / f64::from(MAX_SIDE)).max(1.0);
    // A breath of room, for what is equal but for rounding.
    if cell < pixel * fewest * (1.0 - 1e-9) {
        let expected = format!("at least {} m: a pixel, and no more than {MAX_SIDE} cells a side", pixel * fewest);
        return Err(FormatError::field("metres_per_cell", format!("{cell} m"), expected));
    }
    let cells = |n: u32| (libm::round(f64::from(n) * pixel / cell) as u32).clamp(1, n.min(MAX_SIDE));
    let size = (cells(pixels.0), cells(pixels.1));
    check_size(size.0.into(), size.1.into())?;
    Ok(size)
}

/// Metres per cell, along the longer side.
fn resolution(pixels: (u32, u32), size: (u32, u32), options: &PictureOptions) -> Option<f64> {
    let longer = |(width, height): (u32, u32)| f64::from(if pixels.0 >= pixels.1 { width } else { height });
    match options.metres_per_pixel {
        Some(pixel) => Some(pixel * longer(pixels) / longer(size)),
        None => options.metres_per_cell,
    }
}

/// The threshold that was asked for, or the one that parts dark from light best.
fn threshold(histogram: &Histogram, options: &PictureOptions, notices: &mut Vec<Notice>) -> Result<u8, FormatError> {
    if let Some(value) = histogram.single() {
        let expected = "walls and free space in different grays; crop it to where the map is";
        return Err(FormatError::field("picture", format!("all of it is of one colour (gray {value})"), expected));
    }
    if let Some(threshold) = options.threshold {
        return Ok(threshold);
    }
    let chosen = histogram.otsu();
    let message = format!("gray {chosen} parts dark from light best (Otsu's method)");
    notices.push(Notice::new("picture-threshold-chosen", message).with("threshold", chosen));
    Ok(chosen)
}

/// Says what was read as what.
fn tell(blocked: &[u8], threshold: u8, options: &PictureOptions, notices: &mut Vec<Notice>) -> Result<(), FormatError> {
    let count = blocked.iter().filter(|&&cell| cell == 1).count();
    if count == blocked.len() {
        return Err(FormatError::NoFreeCell);
    }
    let (kind, which) = match options.light_is_blocked {
        false => ("picture-threshold", format!("pixels darker than {threshold} are walls")),
        true => ("picture-threshold-light", format!("pixels of gray {threshold} and lighter are walls")),
    };
    let message = format!("{which}: {count} of {} cells are blocked", blocked.len());
    notices.push(Notice::new(kind, message).with("threshold", threshold).with("blocked", count).with("cells", blocked.len()));
    Ok(())
}

fn shrunk(pixels: (u32, u32), size: (u32, u32)) -> Notice {
    let message = format!(
        "{} × {} pixels became {} × {} cells: a cell is blocked if any pixel under it is",
        pixels.0, pixels.1, size.0, size.1
    );
    let notice = Notice::new("picture-shrunk", message).with("width", pixels.0).with("height", pixels.1);
    notice.with("columns", size.0).with("rows", size.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(width: u32, grays: &[u8]) -> Picture {
        let pixels = grays.iter().map(|&v| [v, v, v, 255]).collect();
        Picture { width, height: grays.len() as u32 / width, pixels, has_alpha: false, deep: None, notices: Vec::new() }
    }

    fn kinds(cells: &Cells) -> Vec<&str> {
        cells.notices.iter().map(|notice| notice.kind.as_str()).collect()
    }

    #[test]
    fn dark_is_wall_and_one_cell_a_pixel() {
        let picture = picture(3, &[0, 127, 128, 255, 200, 3]);
        let cells = to_cells(&picture, &PictureOptions::default()).unwrap();
        assert_eq!((cells.width, cells.height, cells.threshold), (3, 2, 128));
        assert_eq!(cells.blocked, [1, 1, 0, 0, 0, 1]);
        assert_eq!(cells.notices[0].message, "pixels darker than 128 are walls: 3 of 6 cells are blocked");
        let light = PictureOptions { light_is_blocked: true, ..Default::default() };
        assert_eq!(to_cells(&picture, &light).unwrap().blocked, [0, 0, 1, 1, 1, 0]);
    }

    #[test]
    fn otsu_when_none_is_given() {
        let options = PictureOptions { threshold: None, ..Default::default() };
        let cells = to_cells(&picture(4, &[10, 12, 60, 61]), &options).unwrap();
        assert!((13..=60).contains(&cells.threshold), "{}", cells.threshold);
        assert_eq!(cells.blocked, [1, 1, 0, 0]);
        assert_eq!(kinds(&cells), ["picture-threshold-chosen", "picture-threshold"]);
    }

    #[test]
    fn transparent_is_white() {
        let picture = Picture {
            width: 2,
            height: 1,
            pixels: vec![[0, 0, 0, 0], [0, 0, 0, 255]],
            has_alpha: true,
            deep: None,
            notices: Vec::new(),
        };
        let cells = to_cells(&picture, &PictureOptions::default()).unwrap();
        assert_eq!(cells.blocked, [0, 1]);
        assert_eq!(kinds(&cells)[0], "picture-transparent");
    }

    #[test]
    fn any_blocked_pixel_blocks_its_cell() {
        let mut grays = [255; 36];
        grays[7] = 0;
        let options = PictureOptions { cells: Some(2), metres_per_pixel: Some(0.1), ..Default::default() };
        let cells = to_cells(&picture(6, &grays), &options).unwrap();
        assert_eq!(cells.blocked, [1, 0, 0, 0]);
        assert!((cells.resolution.unwrap() - 0.3).abs() < 1e-12);
        let metres = PictureOptions { metres_per_pixel: Some(0.1), metres_per_cell: Some(0.2), ..Default::default() };
        let cells = to_cells(&picture(6, &grays), &metres).unwrap();
        assert_eq!((cells.width, cells.height, cells.resolution.is_some()), (3, 3, true));
        let alone = PictureOptions { metres_per_cell: Some(0.5), ..Default::default() };
        let cells = to_cells(&picture(6, &grays), &alone).unwrap();
        assert_eq!((cells.width, cells.resolution), (6, Some(0.5)));
    }

    #[test]
    fn long_pictures_fit_a_map() {
        let mut grays = vec![255; 10_000];
        grays[0] = 0;
        let cells = to_cells(&picture(5000, &grays), &PictureOptions::default()).unwrap();
        assert_eq!((cells.width, cells.height), (4096, 2));
        assert_eq!(cells.blocked.iter().filter(|&&cell| cell == 1).count(), 1);
    }

    #[test]
    fn what_cannot_be_a_map_is_refused() {
        let map = picture(2, &[0, 255, 255, 255]);
        let refused = |options: PictureOptions| to_cells(&map, &options).unwrap_err().report().kind;
        assert_eq!(to_cells(&picture(2, &[9; 4]), &PictureOptions::default()).unwrap_err().report().field, "picture");
        assert_eq!(to_cells(&picture(2, &[9, 10]), &PictureOptions::default()), Err(FormatError::NoFreeCell));
        assert_eq!(refused(PictureOptions { cells: Some(3), ..Default::default() }), "bad-field");
        assert_eq!(refused(PictureOptions { cells: Some(0), ..Default::default() }), "bad-field");
        assert_eq!(refused(PictureOptions { metres_per_cell: Some(f64::NAN), ..Default::default() }), "bad-field");
        let small = PictureOptions { metres_per_pixel: Some(1.0), metres_per_cell: Some(0.1), ..Default::default() };
        assert_eq!(refused(small), "bad-field");
        let outside = Window { x: 1, y: 0, width: 2, height: 1 };
        assert_eq!(refused(PictureOptions { crop: Some(outside), ..Default::default() }), "window");
    }

    #[test]
    fn options_as_json() {
        let options: PictureOptions = serde_json::from_str(r#"{"cells": 64}"#).unwrap();
        assert_eq!(options, PictureOptions { cells: Some(64), ..Default::default() });
        let otsu: PictureOptions = serde_json::from_str(r#"{"threshold": null}"#).unwrap();
        assert_eq!(otsu.threshold, None);
        assert!(serde_json::from_str::<PictureOptions>(r#"{"treshold": 3}"#).is_err());
    }
}
