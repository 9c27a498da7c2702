//! ESRI ASCII grid: a header of keys and numbers in any order and case, then `nrows` times `ncols` heights, over any number of lines.
//!
//! Lines that begin with `#` are comments. The corner or centre of the lower left cell only tells whether cells are in degrees.

use std::fmt::Write;

use super::super::Kind;
use super::super::text::{lines, quote};
use super::{Raster, check_claim, ground};
use crate::error::{FormatError, Notice};
use crate::map::Grid;

/// The keys that a header may have.
const KEYS: [&str; 10] =
    ["ncols", "nrows", "xllcorner", "yllcorner", "xllcenter", "yllcenter", "cellsize", "dx", "dy", "nodata_value"];

/// Stands for no data where the header does not say what does, as Esri's own programs have it.
const NO_DATA: f64 = -9999.0;

/// Cells below this are degrees, if the corner can be one.
const LARGEST_DEGREE: f64 = 0.1;

/// What the header says, in the order of [`KEYS`].
#[derive(Default)]
struct Header([Option<f64>; 10]);

/// Words that programs write where there is no height, in small letters: of C, of SQL and R, of old Windows.
fn is_no_number(word: &str) -> bool {
    let small = word.trim_start_matches(['+', '-']).to_ascii_lowercase();
    matches!(small.as_str(), "nan" | "null" | "na" | "n/a" | "none" | "*" | "inf" | "infinity")
        || ["1.#", "nan("].iter().any(|begin| small.starts_with(begin))
}

/// Whether the text begins with a key of the header.
pub(in crate::formats) fn looks_like(text: &str) -> bool {
    words(text).next().is_some_and(|(_, word)| key(word).is_some())
}

/// Each word with its line.
fn words(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let lines = lines(text).filter(|(_, line)| !line.trim_start().starts_with('#'));
    lines.flat_map(|(number, line)| line.split_ascii_whitespace().map(move |word| (number, word)))
}

fn key(word: &str) -> Option<usize> {
    let word = if word.eq_ignore_ascii_case("nodata") { "nodata_value" } else { word };
    KEYS.iter().position(|key| key.eq_ignore_ascii_case(word))
}

/// Reads a grid.
///
/// # Errors
/// [`FormatError`] with the line of the first thing that is wrong.
pub(in crate::formats) fn read(text: &str) -> Result<Raster, FormatError> {
    let mut words = words(text).peekable();
    let mut header = Header::default();
    let mut last = 0;
    while let Some(&(line, word)) = words.peek().filter(|(_, word)| number(word).is_none() && !is_no_number(word)) {
        words.next();
        last = header.set(line, word, words.next())?;
        // Cells that are not square are told otherwise; a second number would be taken for a height.
        let beside = words.peek().filter(|&&(line, next)| key(word) == key("cellsize") && line == last && number(next).is_some());
        if let Some((line, next)) = beside {
            let what = format!("`{}` stands behind the number of `cellsize`", quote(next));
            return Err(FormatError::syntax(*line, what, "one number, or `dx N` and `dy N`; heights on lines of their own"));
        }
    }
    let (width, height) = header.size()?;
    // A claim costs nothing: no more is set aside than the text can hold.
    let mut heights = Vec::with_capacity((width as usize * height as usize).min(text.len() / 2 + 1));
    let mut without = 0usize;
    for (line, word) in words {
        without += usize::from(is_no_number(word));
        if heights.len() == width as usize * height as usize {
            return Err(FormatError::syntax(line, format!("`{}` follows the last height", quote(word)), count(width, height)));
        }
        heights.push(header.height(word).ok_or_else(|| no_number(line, word))?);
        last = line;
    }
    if heights.len() < width as usize * height as usize {
        let what = format!("the grid ends after {} heights, in row {}", heights.len(), heights.len() / width as usize + 1);
        return Err(FormatError::syntax(last, what, count(width, height)));
    }
    let (cell, mut notices) = header.cell(height)?;
    if without > 0 {
        let message = format!("{without} cells hold a word such as nan or null in place of a height: they have no data");
        notices.push(Notice::new("terrain-words", message).with("count", without));
    }
    Ok(Raster { kind: Kind::EsriAscii, width, height, heights, cell, unit: 1.0, notices })
}

/// Whether a word is a number but for a comma in place of its point.
fn has_decimal_comma(word: &str) -> bool {
    word.matches(',').count() == 1 && number(&word.replace(',', ".")).is_some()
}

fn no_number(line: usize, word: &str) -> FormatError {
    if has_decimal_comma(word) {
        let what = format!("`{}` has a decimal comma", quote(word));
        return FormatError::syntax(line, what, "a decimal point: replace every , by .");
    }
    FormatError::syntax(line, format!("`{}` is no number", quote(word)), "a number")
}

fn count(width: u32, height: u32) -> String {
    format!("ncols · nrows = {width} · {height} numbers")
}

/// A number.
fn number(word: &str) -> Option<f64> {
    let first = word.as_bytes().first()?;
    let is_number = first.is_ascii_digit() || b"+-.".contains(first);
    if is_number { word.parse().ok() } else { None }
}

impl Header {
    /// Takes a key and the word behind it, and tells the line of the latter.
    fn set(&mut self, line: usize, word: &str, value: Option<(usize, &str)>) -> Result<usize, FormatError> {
        let unknown = || FormatError::syntax(line, format!("`{}` is no key of the header", quote(word)), KEYS.join(", "));
        let at = key(word).ok_or_else(|| if has_decimal_comma(word) { no_number(line, word) } else { unknown() })?;
        let missing = || FormatError::syntax(line, format!("nothing follows `{}`", KEYS[at]), "a number");
        let (line, value) = value.ok_or_else(missing)?;
        let wordy = is_no_number(value) && KEYS[at] == "nodata_value";
        let value = if wordy { Some(f64::NAN) } else { number(value) }.ok_or_else(|| no_number(line, value))?;
        match self.0[at].replace(value) {
            Some(_) => Err(FormatError::syntax(line, format!("`{}` stands twice", KEYS[at]), "each key once")),
            None => Ok(line),
        }
    }

    fn get(&self, key: &str) -> Option<f64> {
        KEYS.iter().position(|k| *k == key).and_then(|at| self.0[at])
    }

    fn size(&self) -> Result<(u32, u32), FormatError> {
        let side = |key: &'static str| match self.get(key) {
            None => Err(FormatError::field(key, "missing in the header", format!("a line `{key} N`"))),
            Some(n) if n >= 1.0 && n.fract() == 0.0 => Ok(n as u64),
            Some(n) => Err(FormatError::field(key, format!("{n}"), "a whole number, at least 1")),
        };
        check_claim(side("ncols")?, side("nrows")?)
    }

    /// A height; NaN for no data; none for what is no number.
    fn height(&self, word: &str) -> Option<f32> {
        if is_no_number(word) {
            return Some(f32::NAN);
        }
        let value = number(word)?;
        let no_data = self.get("nodata_value").unwrap_or(NO_DATA);
        // Printed with fewer digits than the header, or with more.
        if value == no_data || value as f32 == no_data as f32 {
            return Some(f32::NAN);
        }
        // What is beyond all ground is told by the caller.
        Some(value as f32)
    }

    /// Metres per cell.
    fn cell(&self, rows: u32) -> Result<([f64; 2], Vec<Notice>), FormatError> {
        let size = self.get("cellsize");
        if size.is_some() && (self.get("dx").is_some() || self.get("dy").is_some()) {
            return Err(FormatError::field("cellsize", "stands beside dx or dy", "cellsize alone, or dx and dy"));
        }
        let (Some(dx), Some(dy)) = (self.get("dx").or(size), self.get("dy").or(size)) else {
            return Err(FormatError::field("cellsize", "missing in the header", "a line `cellsize N`, or `dx N` and `dy N`"));
        };
        let cell = ground::check_cell("cellsize", [dx, dy])?;
        let x = self.get("xllcorner").or(self.get("xllcenter"));
        let y = self.get("yllcorner").or(self.get("yllcenter"));
        let (Some(x), Some(y)) = (x, y) else { return Ok((cell, Vec::new())) };
        let in_degrees = dx < LARGEST_DEGREE && dy < LARGEST_DEGREE && x.abs() <= 180.0 && y.abs() <= 90.0;
        if !in_degrees {
            return Ok((cell, Vec::new()));
        }
        let (cell, notice) = ground::cell(cell, y + dy * f64::from(rows) / 2.0)?;
        Ok((cell, vec![notice]))
    }
}

/// A terrain as a grid, in metres; the lower left corner lies at (0, 0). A plane has height 0 where it is free and no data where it is not.
pub(in crate::formats) fn write(grid: &Grid, heights: &[f32], resolution: f64) -> String {
    let no_data = no_data(heights);
    // A cell of centimetres at (0, 0) would be taken for degrees.
    let corner = if resolution < LARGEST_DEGREE { 1000 } else { 0 };
    let mut text = format!("ncols {}\nnrows {}\nxllcorner {corner}\nyllcorner {corner}\n", grid.width(), grid.height());
    let _ = write!(text, "cellsize {resolution}\nNODATA_value {no_data}\n");
    text.push_str(&super::height_table::rows(heights, grid.width(), " ", no_data));
    text
}

/// −9999, or what is below every height.
pub(super) fn no_data(heights: &[f32]) -> f32 {
    let mut no_data = NO_DATA as f32;
    while heights.contains(&no_data) {
        no_data = no_data * 10.0 - 9.0;
    }
    no_data
}
