//! GeoTIFF by the `tiff` crate: strips and tiles, plain, LZW, deflate or PackBits, integers and floats of 8 to 64 bits, BigTIFF. The first
//! band of the first image is read; size and place of its cells come from the tags of GeoTIFF, the value for no data from GDAL's.

use std::io::Cursor;

use tiff::decoder::ifd::Value;
use tiff::decoder::{ChunkType, Decoder, DecodingResult, Limits};
use tiff::encoder::{Compression, DeflateLevel, TiffEncoder, colortype::Gray32Float};
use tiff::tags::Tag;
use tiff::{ColorType, TiffError, TiffResult};

use super::super::Kind;
use super::{Raster, check_claim, esri_ascii, geotiff_tags, ground, whole_tiles};
use crate::error::{FormatError, Notice};
use crate::map::Grid;

/// No compression of TIFF makes more than this many cells of a byte (deflate's limit is 1032 bytes).
const MOST_CELLS_PER_BYTE: u64 = 1100;

/// Most bytes of a strip or tile, and of what is read for one.
const MAX_CHUNK: usize = 128 << 20;

/// Cells below this are degrees, if nothing says what they are and the corner can be one.
const LARGEST_DEGREE: f64 = 0.1;

/// GTModelTypeGeoKey, and what it says of coordinates in degrees and of those from the middle of the Earth.
const MODEL: u16 = 1024;
const GEOGRAPHIC: u16 = 2;
const GEOCENTRIC: u16 = 3;

/// ProjLinearUnitsGeoKey: the unit of projected coordinates.
const LINEAR_UNITS: u16 = 3076;

/// VerticalUnitsGeoKey, and VerticalGeoKey: the coordinate system of heights.
const VERTICAL_UNITS: u16 = 4099;
const VERTICAL_SYSTEM: u16 = 4096;

/// GDAL's metadata, as XML.
const GDAL_METADATA: Tag = Tag::Unknown(42112);

/// How tag Compression says LZW.
const LZW: u16 = 5;

type Tiff<'a> = Decoder<Cursor<&'a [u8]>>;

/// Whether the bytes begin like a TIFF or a BigTIFF.
pub(in crate::formats) fn looks_like(bytes: &[u8]) -> bool {
    [&b"II*\0"[..], b"MM\0*", b"II+\0", b"MM\0+"].iter().any(|magic| bytes.starts_with(magic))
}

/// Reads the first band.
///
/// # Errors
/// [`FormatError`]: the file is broken, claims more than it can hold, or is a picture.
pub(in crate::formats) fn read(bytes: &[u8]) -> Result<Raster, FormatError> {
    let mut tiff = open(bytes)?;
    let (width, height) = tiff.dimensions().map_err(broken)?;
    let (width, height) = check_claim(u64::from(width), u64::from(height))?;
    if u64::from(width) * u64::from(height) > bytes.len() as u64 * MOST_CELLS_PER_BYTE {
        let what = format!("{width} × {height} cells in a file of {} bytes", bytes.len());
        return Err(FormatError::field("ImageWidth", what, "no more cells than the file can hold"));
    }
    let bands = bands(&mut tiff)?;
    check_chunk(&mut tiff)?;
    check_orientation(&mut tiff)?;
    let (Cells { cell, is_south_up }, mut notices) = cells(&mut tiff, (width, height))?;
    let no_data = no_data(&mut tiff)?;
    let values = values(&mut tiff)?;
    notices.extend(values.notices());
    let range = range(&mut tiff)?;
    notices.extend(no_data.and_then(|no_data| geotiff_tags::unused(no_data, range)));
    let whole = whole(&mut tiff, bytes, (width, height))?;
    if let Some(file) = &whole {
        tiff = open(file)?;
    }
    let mut heights = heights(&mut tiff, (width, height), bands, no_data)?;
    if !values.is_plain() {
        heights.iter_mut().for_each(|height| *height = (f64::from(*height) * values.scale + values.offset) as f32);
    }
    if is_south_up {
        turn_over(&mut heights, width as usize);
        notices.push(Notice::new("terrain-south-up", "the file's rows run northwards: they were turned over, north is above"));
    }
    Ok(Raster { kind: Kind::Geotiff, width, height, heights, cell, unit: values.unit, notices })
}

/// Rows from below to above.
fn turn_over(heights: &mut [f32], width: usize) {
    let rows = heights.len() / width.max(1);
    let (above, below) = heights.split_at_mut(rows / 2 * width);
    above.chunks_exact_mut(width).zip(below.chunks_exact_mut(width).rev()).for_each(|(a, b)| a.swap_with_slice(b));
}

/// Pixels that lie otherwise than row by row from the upper left would be placed wrongly.
fn check_orientation(tiff: &mut Tiff) -> Result<(), FormatError> {
    match tiff.find_tag_unsigned::<u16>(Tag::Orientation).map_err(broken)? {
        None | Some(1) => Ok(()),
        Some(other) => Err(FormatError::field("Orientation", other.to_string(), "1: rows from above, columns from the left")),
    }
}

/// The decoder sets memory aside for a whole strip or tile, whatever the file holds of it.
fn check_chunk(tiff: &mut Tiff) -> Result<(), FormatError> {
    const MOST_CELLS: u64 = MAX_CHUNK as u64 / 8;
    let (width, height) = tiff.chunk_dimensions();
    if width == 0 || height == 0 || u64::from(width) * u64::from(height) > MOST_CELLS {
        let max = format!("{MOST_CELLS} cells");
        return Err(FormatError::TooLarge { what: format!("a strip or tile of {width} × {height} cells"), max });
    }
    Ok(())
}

fn open(bytes: &[u8]) -> Result<Tiff<'_>, FormatError> {
    let mut limits = Limits::default();
    limits.decoding_buffer_size = MAX_CHUNK;
    limits.intermediate_buffer_size = MAX_CHUNK;
    Ok(Decoder::new(Cursor::new(bytes)).map_err(broken)?.with_limits(limits))
}

/// The file with an image that ends together with its tiles, where they are packed by LZW and it does not.
fn whole(tiff: &mut Tiff, bytes: &[u8], (width, height): (u32, u32)) -> Result<Option<Vec<u8>>, FormatError> {
    let is_tiled = tiff.get_chunk_type() == ChunkType::Tile;
    if !is_tiled || tiff.find_tag_unsigned::<u16>(Tag::Compression).map_err(broken)? != Some(LZW) {
        return Ok(None);
    }
    let (tile_width, tile_height) = tiff.chunk_dimensions();
    let up = |side: u32, tile: u32| side.checked_next_multiple_of(tile);
    let (Some(wide), Some(high)) = (up(width, tile_width), up(height, tile_height)) else { return Ok(None) };
    if (wide, high) == (width, height) {
        return Ok(None);
    }
    Ok(tiff.ifd_pointer().and_then(|directory| whole_tiles::with_sides(bytes, directory.0, [wide, high])))
}

fn broken(error: TiffError) -> FormatError {
    match error {
        TiffError::LimitsExceeded | TiffError::IntSizeError => FormatError::TooLarge {
            what: "a strip, a tile or a list in the file".into(),
            max: format!("{} MiB", MAX_CHUNK >> 20),
        },
        TiffError::UnsupportedError(what) => {
            FormatError::field("TIFF", what.to_string(), "numbers of 8 to 64 bits, plain or by LZW or deflate")
        }
        TiffError::IoError(_) => FormatError::field("TIFF", "the file ends too soon, or its data is damaged", "the whole file"),
        other => FormatError::field("TIFF", other.to_string(), "a TIFF as its specification describes it"),
    }
}

/// How many numbers a cell has in a strip or tile.
fn bands(tiff: &mut Tiff) -> Result<usize, FormatError> {
    const PHOTOMETRIC: &str = "PhotometricInterpretation";
    let separate = tiff.find_tag_unsigned::<u16>(Tag::PlanarConfiguration).map_err(broken)? == Some(2);
    if tiff.find_tag_unsigned::<u16>(Tag::PhotometricInterpretation).map_err(broken)? == Some(0) {
        return Err(FormatError::field(PHOTOMETRIC, "white is zero: a picture", "black is zero, as heights have it"));
    }
    let (bits, bands) = match tiff.colortype().map_err(broken)? {
        ColorType::Gray(bits) => (bits, 1),
        ColorType::GrayA(bits) => (bits, 2),
        ColorType::Multiband { bit_depth, num_samples } => (bit_depth, usize::from(num_samples)),
        other => return Err(FormatError::field(PHOTOMETRIC, format!("{other:?} is a picture"), "heights, one number a cell")),
    };
    if !matches!(bits, 8 | 16 | 32 | 64) {
        return Err(FormatError::field("BitsPerSample", format!("{bits} bits"), "8, 16, 32 or 64 bits"));
    }
    Ok(if separate { 1 } else { bands })
}

/// The numbers of a tag of floats; none where it is missing.
fn numbers(tiff: &mut Tiff, tag: Tag) -> Result<Option<Vec<f64>>, FormatError> {
    tiff.find_tag(tag).and_then(|value| value.map(Value::into_f64_vec).transpose()).map_err(broken)
}

/// The value of a short key of GeoTIFF: (key, 0, 1, value) in the directory of keys.
fn geo_key(keys: &[u16], key: u16) -> Option<u16> {
    keys.chunks_exact(4).skip(1).find(|entry| entry[0] == key && entry[1] == 0).map(|entry| entry[3])
}

/// Metres per cell, and whether rows run northwards.
struct Cells {
    cell: [f64; 2],
    is_south_up: bool,
}

/// The cells, and what was assumed.
fn cells(tiff: &mut Tiff, size: (u32, u32)) -> Result<(Cells, Vec<Notice>), FormatError> {
    let Some(Placed { cell, middle: [x, y], is_south_up }) = placed(tiff, size)? else {
        let message = "the file does not say how large its cells are: 1 m is assumed; set the resolution";
        let cells = Cells { cell: [1.0; 2], is_south_up: false };
        return Ok((cells, vec![Notice::new("terrain-cell-size", message)]));
    };
    let cell = ground::check_cell("ModelPixelScale", cell)?;
    let keys = tiff.find_tag_unsigned_vec::<u16>(Tag::GeoKeyDirectoryTag).map_err(broken)?.unwrap_or_default();
    let in_degrees = match geo_key(&keys, MODEL) {
        Some(GEOCENTRIC) => {
            return Err(FormatError::field("GTModelType", "geocentric coordinates", "projected or geographic ones: gdalwarp"));
        }
        Some(model) => model == GEOGRAPHIC,
        None => cell[0] < LARGEST_DEGREE && cell[1] < LARGEST_DEGREE && x.abs() <= 180.0 && y.abs() <= 90.0,
    };
    if in_degrees {
        let (cell, notice) = ground::cell(cell, y)?;
        return Ok((Cells { cell, is_south_up }, vec![notice]));
    }
    let metres = match geo_key(&keys, LINEAR_UNITS) {
        None | Some(0 | 9001) => 1.0,
        Some(9002) => geotiff_tags::FOOT,
        Some(9003) => geotiff_tags::SURVEY_FOOT,
        Some(other) => {
            let what = if other == 32767 { "a unit of its own".to_owned() } else { format!("the unit {other}") };
            return Err(FormatError::field("ProjLinearUnits", what, "metres (9001) or feet (9002, 9003)"));
        }
    };
    Ok((Cells { cell: cell.map(|c| c * metres), is_south_up }, Vec::new()))
}

/// Size of the cells and place of the raster's middle, in units of the coordinates.
struct Placed {
    cell: [f64; 2],
    middle: [f64; 2],
    is_south_up: bool,
}

/// None where the file does not say.
fn placed(tiff: &mut Tiff, (width, height): (u32, u32)) -> Result<Option<Placed>, FormatError> {
    let (column, row) = (f64::from(width) / 2.0, f64::from(height) / 2.0);
    if let Some(scale) = numbers(tiff, Tag::ModelPixelScaleTag)? {
        let &[x, y, ..] = scale.as_slice() else {
            return Err(FormatError::field("ModelPixelScale", format!("{} numbers", scale.len()), "3 numbers"));
        };
        // GDAL takes a negative size for its amount as well: rows run southwards all the same.
        let (x, y) = (x.abs(), y.abs());
        let tie = numbers(tiff, Tag::ModelTiepointTag)?.unwrap_or_default();
        let middle = match tie.as_slice() {
            &[i, j, _, at_x, at_y, ..] => [at_x + (column - i) * x, at_y - (row - j) * y],
            // Not on Earth, so that nothing is taken for degrees.
            _ => [f64::INFINITY; 2],
        };
        return Ok(Some(Placed { cell: [x, y], middle, is_south_up: false }));
    }
    let Some(m) = numbers(tiff, Tag::ModelTransformationTag)? else { return Ok(None) };
    if m.len() != 16 {
        return Err(FormatError::field("ModelTransformation", format!("{} numbers", m.len()), "16 numbers"));
    }
    // Columns of the matrix: what a step along a row and along a column is, however the raster is turned.
    let length = |a: f64, b: f64| libm::sqrt(a * a + b * b);
    let middle = [m[0] * column + m[1] * row + m[3], m[4] * column + m[5] * row + m[7]];
    let cell = [length(m[0], m[4]), length(m[1], m[5])];
    Ok(Some(Placed { cell, middle, is_south_up: m[0] > 0.0 && m[5] > 0.0 }))
}

/// What heights are made of, from GDAL's metadata and the keys of the vertical coordinates.
fn values(tiff: &mut Tiff) -> Result<geotiff_tags::Values, FormatError> {
    let metadata = match tiff.find_tag(GDAL_METADATA).map_err(broken)? {
        Some(value) => value.into_string().map_err(broken)?,
        None => String::new(),
    };
    let keys = tiff.find_tag_unsigned_vec::<u16>(Tag::GeoKeyDirectoryTag).map_err(broken)?.unwrap_or_default();
    geotiff_tags::Values::of(&metadata, geo_key(&keys, VERTICAL_UNITS), geo_key(&keys, VERTICAL_SYSTEM))
}

/// The least and the largest number of files that hold whole numbers of up to 32 bits.
fn range(tiff: &mut Tiff) -> Result<Option<(f64, f64)>, FormatError> {
    let bits = tiff.find_tag_unsigned_vec::<u16>(Tag::BitsPerSample).map_err(broken)?;
    let bits = bits.and_then(|bits| bits.first().copied()).unwrap_or(1);
    let form = tiff.find_tag_unsigned_vec::<u16>(Tag::SampleFormat).map_err(broken)?;
    let two = |power: u16| libm::pow(2.0, f64::from(power));
    Ok(match form.and_then(|form| form.first().copied()).unwrap_or(1) {
        1 if bits <= 32 => Some((0.0, two(bits) - 1.0)),
        2 if (1..=32).contains(&bits) => Some((-two(bits - 1), two(bits - 1) - 1.0)),
        _ => None,
    })
}

/// The value that stands for no data, from GDAL's tag.
fn no_data(tiff: &mut Tiff) -> Result<Option<f64>, FormatError> {
    let Some(value) = tiff.find_tag(Tag::GdalNodata).map_err(broken)? else { return Ok(None) };
    let text = value.into_string().map_err(broken)?;
    let text = text.trim_matches(|c: char| c.is_whitespace() || c == '\0');
    let wrong = || FormatError::field("GDAL_NODATA", format!("`{}` is no number", super::super::text::quote(text)), "a number");
    text.parse().map(Some).map_err(|_| wrong())
}

/// All heights, strip by strip or tile by tile.
fn heights(tiff: &mut Tiff, (width, height): (u32, u32), bands: usize, no_data: Option<f64>) -> Result<Vec<f32>, FormatError> {
    let (chunk_width, chunk_height) = tiff.chunk_dimensions();
    let (across, down) = (width.div_ceil(chunk_width), height.div_ceil(chunk_height));
    let lengths = lengths(tiff).map_err(broken)?;
    // What GDAL leaves out has no data, or is 0.
    let left_out = if no_data.is_some() { f32::NAN } else { 0.0 };
    let mut heights = vec![left_out; width as usize * height as usize];
    for index in 0..across * down {
        if lengths.get(index as usize) == Some(&0) {
            continue;
        }
        let (column, row) = (index % across * chunk_width, index / across * chunk_height);
        let place = Place {
            corner: row as usize * width as usize + column as usize,
            width: width as usize,
            columns: tiff.chunk_data_dimensions(index).0 as usize,
            taken: chunk_width.min(width - column) as usize,
            bands,
        };
        place.fill(&mut heights, tiff.read_chunk(index).map_err(broken)?, no_data);
    }
    Ok(heights)
}

/// Bytes of each strip or tile in the file.
fn lengths(tiff: &mut Tiff) -> TiffResult<Vec<u64>> {
    let strips = tiff.find_tag_unsigned_vec(Tag::StripByteCounts)?;
    let tiles = tiff.find_tag_unsigned_vec(Tag::TileByteCounts)?;
    Ok(strips.or(tiles).unwrap_or_default())
}

/// Where a strip or tile lies among the heights.
struct Place {
    /// Index of its upper left cell.
    corner: usize,
    /// Columns of the image.
    width: usize,
    /// Cells of its rows, and how many of them belong to the image.
    columns: usize,
    taken: usize,
    /// Numbers of a cell.
    bands: usize,
}

impl Place {
    /// Puts the first number of each cell where it belongs; nothing is made on the way, since a strip may be the whole image.
    fn fill(&self, heights: &mut [f32], chunk: DecodingResult, no_data: Option<f64>) {
        let height = |value: f64| {
            let missing = value.is_nan() || no_data.is_some_and(|no| value == no || value as f32 == no as f32);
            if missing { f32::NAN } else { value as f32 }
        };
        match chunk {
            DecodingResult::U8(v) => self.each(heights, &v, |v| height(v.into())),
            DecodingResult::U16(v) => self.each(heights, &v, |v| height(v.into())),
            DecodingResult::U32(v) => self.each(heights, &v, |v| height(v.into())),
            DecodingResult::U64(v) => self.each(heights, &v, |v| height(v as f64)),
            DecodingResult::I8(v) => self.each(heights, &v, |v| height(v.into())),
            DecodingResult::I16(v) => self.each(heights, &v, |v| height(v.into())),
            DecodingResult::I32(v) => self.each(heights, &v, |v| height(v.into())),
            DecodingResult::I64(v) => self.each(heights, &v, |v| height(v as f64)),
            DecodingResult::F16(v) => self.each(heights, &v, |v| height(v.to_f64())),
            DecodingResult::F32(v) => self.each(heights, &v, |v| height(v.into())),
            DecodingResult::F64(v) => self.each(heights, &v, height),
        }
    }

    fn each<T: Copy>(&self, heights: &mut [f32], numbers: &[T], height: impl Fn(T) -> f32) {
        let bands = self.bands.max(1);
        for (y, row) in numbers.chunks_exact(self.columns.max(1) * bands).enumerate() {
            let from = self.corner + y * self.width;
            // The rest of a tile lies below the image.
            let Some(cells) = heights.get_mut(from..from + self.taken) else { break };
            for (cell, &number) in cells.iter_mut().zip(row.iter().step_by(bands)) {
                *cell = height(number);
            }
        }
    }
}

/// A terrain as a GeoTIFF of f32 in metres, deflated; projected, with its upper left corner at (0, 0).
///
/// # Errors
/// [`FormatError::Field`] with what the encoder says.
pub(in crate::formats) fn write(grid: &Grid, heights: &[f32], resolution: f64) -> Result<Vec<u8>, FormatError> {
    encode(grid, heights, resolution).map_err(|e| FormatError::field("TIFF", e.to_string(), "a smaller map"))
}

fn encode(grid: &Grid, heights: &[f32], resolution: f64) -> TiffResult<Vec<u8>> {
    /// Version and number of keys, then: projected; cells are areas; a coordinate system of its own; metres.
    const KEYS: [u16; 20] = [1, 1, 0, 4, MODEL, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 32767, LINEAR_UNITS, 0, 1, 9001];
    let no_data = esri_ascii::no_data(heights);
    let filled: Vec<f32> = heights.iter().map(|&h| if h.is_nan() { no_data } else { h }).collect();
    let mut file = Cursor::new(Vec::new());
    let mut tiff = TiffEncoder::new(&mut file)?.with_compression(Compression::Deflate(DeflateLevel::Balanced));
    let mut image = tiff.new_image::<Gray32Float>(grid.width(), grid.height())?;
    let tags = image.encoder();
    tags.write_tag(Tag::ModelPixelScaleTag, &[resolution, resolution, 0.0][..])?;
    tags.write_tag(Tag::ModelTiepointTag, &[0.0f64; 6][..])?;
    tags.write_tag(Tag::GeoKeyDirectoryTag, &KEYS[..])?;
    tags.write_tag(Tag::GdalNodata, no_data.to_string().as_str())?;
    image.write_data(&filled)?;
    Ok(file.into_inner())
}
