//! From the bytes of a picture to its pixels, by the `image` crate; Netpbm by [`super::pnm`].

use std::io::Cursor;

use image::codecs::{bmp::BmpDecoder, jpeg::JpegDecoder, png::PngDecoder, webp::WebPDecoder};
use image::metadata::Orientation;
use image::{ColorType, ImageDecoder, ImageError, ImageResult, Limits};

use super::pnm;
use crate::error::{FormatError, Notice};
use crate::formats::terrain::MAX_CELLS;

/// Most pixels of a picture that is read: as many as cells of a raster of heights (67 million).
pub const MAX_PIXELS: u64 = MAX_CELLS;

/// Most bytes that a decoder may set aside: the largest picture with 16 bits in each of four channels, and half as much to work with.
const MAX_BYTES: u64 = MAX_PIXELS * 12;

/// No PNG holds more pixels in a byte: 1032 bytes of eight, by deflate.
const MOST_OF_PNG: u64 = 1032 * 8;

/// No JPEG does: a block of 8 × 8 takes at least one bit.
const MOST_OF_JPEG: u64 = 8 * 64;

/// A picture: 8 bits for each of red, green, blue and alpha.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Columns, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// Red, green, blue, alpha of each pixel (0–255, alpha not multiplied in), row by row from the upper left: `width · height` of them.
    pub pixels: Vec<[u8; 4]>,
    /// Whether the file has a channel of alpha, even where all of it is opaque.
    pub has_alpha: bool,
    /// The grays with 16 bits (0–65535) of a picture that has nothing but gray, and finer than or other than 0 to 255; as many as pixels.
    pub deep: Option<Vec<u16>>,
    /// What was left out.
    pub notices: Vec<Notice>,
}

/// The formats that are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Png,
    Jpeg,
    Bmp,
    Webp,
    Netpbm,
}

/// Whether the bytes begin as a picture does that [`decode`] reads.
pub fn looks_like(bytes: &[u8]) -> bool {
    format(bytes).is_some()
}

fn format(bytes: &[u8]) -> Option<Format> {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => Some(Format::Png),
        [0xff, 0xd8, 0xff, ..] => Some(Format::Jpeg),
        // Reserved fields are 0, so that no text is taken for a bitmap.
        [b'B', b'M', _, _, _, _, 0, 0, 0, 0, ..] => Some(Format::Bmp),
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => Some(Format::Webp),
        _ => pnm::looks_like(bytes).then_some(Format::Netpbm),
    }
}

/// Reads a picture. Gray and palettes become red, green and blue. Of 16 bits the high byte is kept (of Netpbm the value is scaled exactly);
/// grays keep all of them beside it, in [`Picture::deep`].
/// Of an animation or several pictures in a row the first is read, with the notice `picture-first-only`. How a camera was held (EXIF) is not
/// followed: notice `picture-turned`. Colour profiles and gamma are not applied.
///
/// # Errors
/// [`FormatError::NotAMap`]: no picture of a known format. [`FormatError::TooLarge`]: it claims more than [`MAX_PIXELS`], before memory is
/// set aside for them. [`FormatError::Field`]: it is broken, or holds fewer bytes than its size takes.
pub fn decode(bytes: &[u8]) -> Result<Picture, FormatError> {
    match format(bytes) {
        Some(Format::Png) => png(bytes),
        Some(Format::Jpeg) => jpeg(bytes),
        Some(Format::Bmp) => bmp(bytes),
        Some(Format::Webp) => webp(bytes),
        Some(Format::Netpbm) => pnm::read(bytes),
        None => Err(FormatError::NotAMap { found: "no picture of a known format (PNG, JPEG, BMP, WebP, PBM, PGM, PPM)" }),
    }
}

fn png(bytes: &[u8]) -> Result<Picture, FormatError> {
    let decoder = PngDecoder::with_limits(Cursor::new(bytes), limits()).map_err(|e| broken("PNG", e))?;
    let is_moving = decoder.is_apng().unwrap_or(false);
    from(Box::new(decoder), Source { name: "PNG", is_moving, most: Some(MOST_OF_PNG * bytes.len() as u64) })
}

fn jpeg(bytes: &[u8]) -> Result<Picture, FormatError> {
    let decoder = JpegDecoder::new(Cursor::new(bytes)).map_err(|e| broken("JPEG", e))?;
    from(Box::new(decoder), Source { name: "JPEG", is_moving: false, most: Some(MOST_OF_JPEG * bytes.len() as u64) })
}

fn bmp(bytes: &[u8]) -> Result<Picture, FormatError> {
    let decoder = BmpDecoder::new(Cursor::new(bytes)).map_err(|e| broken("BMP", e))?;
    from(Box::new(decoder), Source { name: "BMP", is_moving: false, most: None })
}

fn webp(bytes: &[u8]) -> Result<Picture, FormatError> {
    let decoder = WebPDecoder::new(Cursor::new(bytes)).map_err(|e| broken("WebP", e))?;
    let is_moving = decoder.has_animation();
    from(Box::new(decoder), Source { name: "WebP", is_moving, most: None })
}

/// What a decoder does not tell by itself.
struct Source {
    /// Of the format.
    name: &'static str,
    /// Whether there is more than one frame.
    is_moving: bool,
    /// Most pixels that a file of its length can hold.
    most: Option<u64>,
}

fn limits() -> Limits {
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(MAX_BYTES);
    limits
}

/// The sides of a picture, if there may be so many pixels.
///
/// # Errors
/// [`FormatError::Field`] for none, [`FormatError::TooLarge`].
pub(super) fn check_claim(width: u64, height: u64) -> Result<(u32, u32), FormatError> {
    if width == 0 || height == 0 {
        return Err(FormatError::field("size", format!("{width} × {height} pixels"), "at least one pixel"));
    }
    let pixels = width.checked_mul(height).filter(|&pixels| pixels <= MAX_PIXELS);
    match (u32::try_from(width), u32::try_from(height), pixels) {
        (Ok(w), Ok(h), Some(_)) => Ok((w, h)),
        _ => {
            let max = format!("{} million pixels", MAX_PIXELS / 1_000_000);
            Err(FormatError::TooLarge { what: format!("a picture of {width} × {height} pixels"), max })
        }
    }
}

fn broken(name: &'static str, error: ImageError) -> FormatError {
    match error {
        ImageError::Limits(_) => {
            let max = format!("{} MiB of memory", MAX_BYTES >> 20);
            FormatError::TooLarge { what: format!("the {name}"), max }
        }
        ImageError::IoError(_) => FormatError::field(name, "the file ends too soon", "the whole file"),
        other => FormatError::field(name, other.to_string(), format!("a {name} as its specification describes it")),
    }
}

fn from(mut decoder: Box<dyn ImageDecoder + '_>, source: Source) -> Result<Picture, FormatError> {
    let (width, height) = decoder.dimensions();
    let (width, height) = check_claim(u64::from(width), u64::from(height))?;
    if source.most.is_some_and(|most| u64::from(width) * u64::from(height) > most) {
        let what = format!("{width} × {height} pixels are more than a file of this length can hold");
        return Err(FormatError::field(source.name, what, "the whole file"));
    }
    let notices = notices(&mut decoder, &source);
    let color = decoder.color_type();
    let raw = raw(decoder).map_err(|e| broken(source.name, e))?;
    let deep = (color == ColorType::L16).then(|| raw.as_chunks().0.iter().map(|&v| u16::from_ne_bytes(v)).collect());
    Ok(Picture { width, height, pixels: rgba(&raw, color), has_alpha: color.has_alpha(), deep, notices })
}

fn raw(mut decoder: Box<dyn ImageDecoder + '_>) -> ImageResult<Vec<u8>> {
    decoder.set_limits(limits())?;
    let mut raw = vec![0; decoder.total_bytes() as usize];
    decoder.read_image(&mut raw)?;
    Ok(raw)
}

fn notices(decoder: &mut Box<dyn ImageDecoder + '_>, source: &Source) -> Vec<Notice> {
    let mut notices = Vec::new();
    if source.is_moving {
        notices.push(first_only());
    }
    if source.name == "JPEG" && decoder.orientation().is_ok_and(|held| held != Orientation::NoTransforms) {
        let message = "the file says that the camera was held turned: this is not followed, pixels are read as they lie";
        notices.push(Notice::new("picture-turned", message));
    }
    notices
}

/// That there is more in the file.
pub(super) fn first_only() -> Notice {
    Notice::new("picture-first-only", "the file holds more than one picture: the first was read")
}

/// Pixels of any layout as red, green, blue, alpha.
fn rgba(raw: &[u8], color: ColorType) -> Vec<[u8; 4]> {
    match color {
        ColorType::L8 => raw.iter().map(|&v| [v, v, v, 255]).collect(),
        ColorType::La8 => each(raw, |&[v, a]: &[u8; 2]| [v, v, v, a]),
        ColorType::Rgb8 => each(raw, |&[r, g, b]: &[u8; 3]| [r, g, b, 255]),
        ColorType::Rgba8 => each(raw, |pixel: &[u8; 4]| *pixel),
        ColorType::L16 => each(raw, |v: &[u8; 2]| [high(v), high(v), high(v), 255]),
        ColorType::La16 => each(raw, |[v @ .., a, b]: &[u8; 4]| [high(v), high(v), high(v), high(&[*a, *b])]),
        ColorType::Rgb16 => each(raw, |p: &[u8; 6]| [high(&p[..2]), high(&p[2..4]), high(&p[4..]), 255]),
        _ => each(raw, |p: &[u8; 8]| [high(&p[..2]), high(&p[2..4]), high(&p[4..6]), high(&p[6..])]),
    }
}

fn each<const N: usize>(raw: &[u8], pixel: impl Fn(&[u8; N]) -> [u8; 4]) -> Vec<[u8; 4]> {
    raw.as_chunks().0.iter().map(pixel).collect()
}

/// The high byte of a value of 16 bits as the machine stores it.
fn high(value: &[u8]) -> u8 {
    value[if cfg!(target_endian = "little") { 1 } else { 0 }]
}

#[cfg(test)]
mod tests {
    use image::codecs::{jpeg::JpegEncoder, png::PngEncoder};
    use image::{ExtendedColorType, ImageEncoder};

    use super::*;

    fn packed(raw: &[u8], (width, height): (u32, u32), color: ExtendedColorType) -> Vec<u8> {
        let mut bytes = Vec::new();
        PngEncoder::new(&mut bytes).write_image(raw, width, height, color).unwrap();
        bytes
    }

    #[test]
    fn gray_colour_alpha_and_sixteen_bits() {
        let gray = decode(&packed(&[0, 7, 255, 128], (2, 2), ExtendedColorType::L8)).unwrap();
        assert_eq!((gray.width, gray.height), (2, 2));
        assert_eq!(gray.pixels, [[0, 0, 0, 255], [7, 7, 7, 255], [255, 255, 255, 255], [128, 128, 128, 255]]);
        let clear = decode(&packed(&[1, 2, 3, 4], (1, 1), ExtendedColorType::Rgba8)).unwrap();
        assert_eq!(clear.pixels, [[1, 2, 3, 4]]);
        let values: Vec<u8> = [0x12ff_u16, 0xfe80, 0x0100, 0x8000].iter().flat_map(|v| v.to_ne_bytes()).collect();
        let deep = decode(&packed(&values, (1, 1), ExtendedColorType::Rgba16)).unwrap();
        assert_eq!(deep.pixels, [[0x12, 0xfe, 0x01, 0x80]]);
        let values: Vec<u8> = [0x12ff_u16, 0xfe80].iter().flat_map(|v| v.to_ne_bytes()).collect();
        assert_eq!(decode(&packed(&values, (1, 1), ExtendedColorType::La16)).unwrap().pixels, [[0x12, 0x12, 0x12, 0xfe]]);
    }

    #[test]
    fn jpeg_comes_near() {
        let mut bytes = Vec::new();
        JpegEncoder::new_with_quality(&mut bytes, 90).write_image(&[200; 16 * 16], 16, 16, ExtendedColorType::L8).unwrap();
        let picture = decode(&bytes).unwrap();
        assert!(picture.pixels.iter().all(|p| p[0].abs_diff(200) <= 2 && p[0] == p[2] && p[3] == 255));
    }

    #[test]
    fn sizes_are_checked_first() {
        assert!(matches!(check_claim(8193, 8193), Err(FormatError::TooLarge { .. })));
        assert!(matches!(check_claim(1 << 40, 1 << 40), Err(FormatError::TooLarge { .. })));
        assert!(matches!(check_claim(0, 3), Err(FormatError::Field { .. })));
        assert_eq!(check_claim(8192, 8192).unwrap(), (8192, 8192));
        // A header that claims 8000 × 8000 pixels, and a few bytes behind it.
        let mut claims = packed(&[0; 4], (2, 2), ExtendedColorType::L8);
        claims[16..24].copy_from_slice(&[0, 0, 0x1f, 0x40, 0, 0, 0x1f, 0x40]);
        assert!(decode(&claims).is_err());
    }

    #[test]
    fn broken_files_are_refused() {
        assert!(matches!(decode(b"hello"), Err(FormatError::NotAMap { .. })));
        let whole = packed(&[9; 64], (8, 8), ExtendedColorType::L8);
        for end in 0..whole.len() - 16 {
            assert!(decode(&whole[..end]).is_err(), "{end} bytes");
        }
    }
}
