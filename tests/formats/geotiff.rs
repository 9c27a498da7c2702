//! GeoTIFF: every layout and type that is read, the tags that place it, and files that were made to harm.

use std::io::Cursor;

use formicarium::formats::{Imported, Kind, import, sniff};
use tiff::encoder::colortype::{Gray8, Gray32Float, Gray64Float, GrayI16};
use tiff::encoder::{Compression, DeflateLevel, Predictor, TiffEncoder, colortype::ColorType};
use tiff::tags::Tag;

use super::notices;

/// A field of a directory.
enum Field {
    Ascii(&'static str),
    Short(Vec<u16>),
    Long(Vec<u32>),
    Double(Vec<f64>),
}

impl Field {
    /// Type, count and bytes.
    fn parts(&self, big: bool) -> (u16, u32, Vec<u8>) {
        macro_rules! bytes {
            ($values:expr) => {
                $values.iter().flat_map(|v| if big { v.to_be_bytes().to_vec() } else { v.to_le_bytes().to_vec() }).collect()
            };
        }
        match self {
            Self::Ascii(text) => (2, text.len() as u32 + 1, [text.as_bytes(), b"\0"].concat()),
            Self::Short(v) => (3, v.len() as u32, bytes!(v)),
            Self::Long(v) => (4, v.len() as u32, bytes!(v)),
            Self::Double(v) => (12, v.len() as u32, bytes!(v)),
        }
    }
}

fn short(value: u16) -> Field {
    Field::Short(vec![value])
}

/// A TIFF by hand: the strips or tiles behind the header, then the directory, then what does not fit into it.
fn by_hand(big: bool, mut fields: Vec<(u16, Field)>, chunks: &[Vec<u8>], tiled: bool) -> Vec<u8> {
    let number = |bytes: u32, length: usize| {
        let le = bytes.to_le_bytes()[..length].to_vec();
        if big { le.into_iter().rev().collect() } else { le }
    };
    let mut file = if big { b"MM\0*".to_vec() } else { b"II*\0".to_vec() };
    let data: usize = chunks.iter().map(Vec::len).sum();
    file.extend(number(8 + data as u32, 4));
    let mut offsets = Vec::new();
    for chunk in chunks {
        offsets.push(file.len() as u32);
        file.extend(chunk);
    }
    let (at, lengths) = if tiled { (324, 325) } else { (273, 279) };
    fields.push((at, Field::Long(offsets)));
    fields.push((lengths, Field::Long(chunks.iter().map(|c| c.len() as u32).collect())));
    fields.sort_by_key(|field| field.0);
    let behind = file.len() + 2 + 12 * fields.len() + 4;
    let mut rest: Vec<u8> = Vec::new();
    file.extend(number(fields.len() as u32, 2));
    for (tag, field) in &fields {
        let (kind, count, mut bytes) = field.parts(big);
        file.extend(number(u32::from(*tag), 2));
        file.extend(number(u32::from(kind), 2));
        file.extend(number(count, 4));
        if bytes.len() <= 4 {
            bytes.resize(4, 0);
            file.extend(bytes);
        } else {
            file.extend(number((behind + rest.len()) as u32, 4));
            rest.extend(bytes);
        }
    }
    file.extend(number(0, 4));
    file.extend(rest);
    file
}

/// Fields of an image of 16-bit integers in black and white.
fn integers(width: u16, height: u16) -> Vec<(u16, Field)> {
    let fields = [(256, width), (257, height), (258, 16), (259, 1), (262, 1), (277, 1), (339, 2)];
    fields.into_iter().map(|(tag, value)| (tag, short(value))).collect()
}

fn i16s(values: impl IntoIterator<Item = i16>, big: bool) -> Vec<u8> {
    values.into_iter().flat_map(|v| if big { v.to_be_bytes() } else { v.to_le_bytes() }).collect()
}

/// 2 × 2 integers in one strip, with more fields.
fn placed(more: Vec<(u16, Field)>) -> Vec<u8> {
    let mut fields = integers(2, 2);
    fields.extend(more);
    by_hand(false, fields, &[i16s([1, 2, 3, 4], false)], false)
}

fn read(bytes: &[u8]) -> Imported {
    import(bytes, "dem.tif").unwrap()
}

fn heights(map: &Imported) -> Vec<f32> {
    map.grid.heights().unwrap().to_vec()
}

fn refused(bytes: &[u8]) -> String {
    let report = import(bytes, "dem.tif").unwrap_err().report();
    format!("{} {}", report.kind, report.message)
}

/// 5 × 3 numbers: 0, 7, 14, ….
fn encoded<C: ColorType>(compression: Compression, predictor: Predictor, number: impl Fn(i32) -> C::Inner) -> Vec<u8>
where
    [C::Inner]: tiff::encoder::TiffValue,
{
    let numbers: Vec<C::Inner> = (0..15).map(|i| number(7 * i)).collect();
    let mut file = Cursor::new(Vec::new());
    let mut tiff = TiffEncoder::new(&mut file).unwrap().with_compression(compression).with_predictor(predictor);
    let mut image = tiff.new_image::<C>(5, 3).unwrap();
    image.rows_per_strip(2).unwrap();
    image.write_data(&numbers).unwrap();
    file.into_inner()
}

#[test]
fn every_compression_and_type_gives_the_same_heights() {
    let wanted: Vec<f32> = (0..15u8).map(|i| 7.0 * f32::from(i)).collect();
    let packings =
        [Compression::Uncompressed, Compression::Lzw, Compression::Deflate(DeflateLevel::default()), Compression::Packbits];
    for packing in packings {
        let files = [
            encoded::<Gray8>(packing, Predictor::None, |v| v as u8),
            encoded::<GrayI16>(packing, Predictor::None, |v| v as i16),
            encoded::<GrayI16>(packing, Predictor::Horizontal, |v| v as i16),
            encoded::<Gray32Float>(packing, Predictor::None, |v| v as f32),
            encoded::<Gray64Float>(packing, Predictor::None, f64::from),
        ];
        for (which, file) in files.iter().enumerate() {
            assert_eq!(sniff(file, "a.png"), Kind::Geotiff);
            let map = read(file);
            assert_eq!((map.grid.width(), map.grid.height(), heights(&map)), (5, 3, wanted.clone()), "file {which}");
        }
    }
}

#[test]
fn a_bigtiff_is_read() {
    let mut file = Cursor::new(Vec::new());
    let mut tiff = TiffEncoder::new_big(&mut file).unwrap();
    let mut image = tiff.new_image::<GrayI16>(3, 1).unwrap();
    image.encoder().write_tag(Tag::ModelPixelScaleTag, &[25.0, 25.0, 0.0][..]).unwrap();
    image.write_data(&[5, -6, 7]).unwrap();
    let map = read(&file.into_inner());
    assert_eq!((heights(&map), map.spec.resolution), (vec![5.0, -6.0, 7.0], 25.0));
}

#[test]
fn tiles_are_put_together_in_both_byte_orders() {
    // 20 × 18 in tiles of 16 × 16: four of them, three reaching beyond the image; the lower left one is left out.
    let height = |x: i16, y: i16| if x < 20 && y < 18 { 100 * y + x } else { -1 };
    for big in [false, true] {
        let tile = |tx: i16, ty: i16| {
            i16s((0..16).flat_map(|y| (0..16).map(move |x| (x, y))).map(|(x, y)| height(16 * tx + x, 16 * ty + y)), big)
        };
        let mut fields = integers(20, 18);
        fields.extend([(322, short(16)), (323, short(16)), (42113, Field::Ascii("-32768"))]);
        let map = read(&by_hand(big, fields, &[tile(0, 0), tile(1, 0), Vec::new(), tile(1, 1)], true));
        let found = heights(&map);
        for (i, found) in found.iter().enumerate() {
            let (x, y) = (i as i16 % 20, i as i16 / 20);
            let missing = y >= 16 && x < 16;
            assert!(if missing { found.is_nan() } else { *found == f32::from(height(x, y)) }, "({x}, {y}): {found}");
        }
        assert!(notices(&map).contains(&"terrain-no-data"));
    }
}

/// 17 × 16 bytes in tiles of 16 × 16, as GDAL 3.10 packs x mod 7 + y² mod 5; the second tile has one column of the image.
fn packed_by_gdal(big: bool) -> Vec<u8> {
    let tiles = [
        "800000202018100a06814120d0800c0e0b0703c3a17110144c10090545a31068d46621178f44a212203452130f8642a0f029 \
         245251148ecc40b3292c820d2d9c00a4f0b9dcae1b2a92ce668079b4ce3f1ba3c86812e89c0e7b299440a020",
        "800080103824160c03834260a0685436190d84c2221068144e0b128b40e1f190046e33188cc5639208b47a4b1c81c9227228 \
         cc04",
    ];
    let bytes = |tile: &str| {
        let digits: Vec<char> = tile.chars().filter(|c| !c.is_whitespace()).collect();
        digits.chunks(2).map(|d| u8::from_str_radix(&d.iter().collect::<String>(), 16).unwrap()).collect::<Vec<_>>()
    };
    let fields = [(256, 17), (257, 16), (258, 8), (259, 5), (262, 1), (277, 1), (322, 16), (323, 16), (339, 1)];
    let fields = fields.into_iter().map(|(tag, value)| (tag, short(value))).collect();
    by_hand(big, fields, &tiles.map(bytes), true)
}

#[test]
fn lzw_ends_well_in_tiles_that_reach_beyond_the_image() {
    for big in [false, true] {
        let map = read(&packed_by_gdal(big));
        assert_eq!((map.grid.width(), map.grid.height()), (17, 16));
        for (i, found) in heights(&map).into_iter().enumerate() {
            let (x, y) = (i % 17, i / 17);
            assert_eq!(found, (x % 7 + y * y % 5) as f32, "({x}, {y})");
        }
    }
}

#[test]
fn of_several_bands_the_first_is_read() {
    let bands = |planar: u16| {
        let mut fields = integers(2, 1);
        fields.retain(|f| f.0 != 277 && f.0 != 258 && f.0 != 339);
        fields.extend([
            (277, short(2)),
            (258, Field::Short(vec![16, 16])),
            (339, Field::Short(vec![2, 2])),
            (284, short(planar)),
        ]);
        fields.extend([(338, short(0)), (278, short(1))]);
        fields
    };
    let mixed = by_hand(false, bands(1), &[i16s([1, 90, 2, 91], false)], false);
    let apart = by_hand(false, bands(2), &[i16s([1, 2], false), i16s([90, 91], false)], false);
    for file in [mixed, apart] {
        assert_eq!(heights(&read(&file)), [1.0, 2.0]);
    }
}

#[test]
fn tags_tell_how_large_cells_are() {
    let scale = |x: f64, y: f64| (33550, Field::Double(vec![x, y, 0.0]));
    let tie = |x: f64, y: f64| (33922, Field::Double(vec![0.0, 0.0, 0.0, x, y, 0.0]));
    let keys = |keys: &[[u16; 2]]| {
        let entries = keys.iter().flat_map(|&[key, value]| [key, 0, 1, value]);
        (34735, Field::Short([1, 1, 0, keys.len() as u16].into_iter().chain(entries).collect()))
    };
    let resolution = |more| read(&placed(more)).spec.resolution;
    assert_eq!(resolution(vec![scale(30.0, 30.0), tie(500_000.0, 4e6)]), 30.0);
    assert_eq!(resolution(vec![scale(20.0, 45.0)]), 30.0);
    // Projected, in feet and in metres; the corner could be degrees.
    assert_eq!(resolution(vec![scale(0.05, 0.05), tie(0.0, 0.0), keys(&[[1024, 1], [3076, 9002]])]), 0.05 * 0.3048);
    assert_eq!(resolution(vec![scale(0.05, 0.05), tie(0.0, 0.0), keys(&[[1024, 1]])]), 0.05);
    // Geographic: the middle of two rows of 0.5° below 60.5° lies at 60°; 55,660 m high and half of it wide, √(55660 · 27830) = 39357.56.
    let found = read(&placed(vec![scale(0.5, 0.5), tie(7.0, 60.5), keys(&[[1024, 2]])]));
    assert!((found.spec.resolution - 39_357.56).abs() < 0.01, "{}", found.spec.resolution);
    assert_eq!(notices(&found)[0], "terrain-geographic");
    // The same without keys: 0.05° cells.
    let guessed = resolution(vec![scale(0.05, 0.05), tie(7.0, 60.05)]);
    assert!((guessed - 3_935.76).abs() < 0.01, "{guessed}");
    // Turned by 90° and by 36.87°: steps along rows and columns as vectors.
    let matrix = |a: [f64; 4]| {
        (34264, Field::Double(vec![a[0], a[1], 0.0, 5e5, a[2], a[3], 0.0, 4e6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]))
    };
    assert_eq!(resolution(vec![matrix([0.0, 30.0, 30.0, 0.0])]), 30.0);
    assert_eq!(resolution(vec![matrix([8.0, 6.0, 6.0, -8.0])]), 10.0);
    let unknown = read(&placed(Vec::new()));
    assert_eq!((unknown.spec.resolution, notices(&unknown)[0]), (1.0, "terrain-cell-size"));
}

#[test]
fn the_value_for_no_data_is_gdals() {
    for text in ["2", " 2.0 ", "2e0"] {
        let found = heights(&read(&placed(vec![(42113, Field::Ascii(text))])));
        assert!(found[1].is_nan() && found[0] == 1.0, "{text}: {found:?}");
    }
    assert!(heights(&read(&placed(vec![(42113, Field::Ascii("nan"))]))).iter().all(|h| h.is_finite()));
    assert!(refused(&placed(vec![(42113, Field::Ascii("none"))])).starts_with("bad-field GDAL_NODATA: `none`"));
    // Floats have NaN of their own, and what is infinite is no ground.
    let float = |second: f32| {
        encoded::<Gray32Float>(Compression::Uncompressed, Predictor::None, |v| if v == 7 { second } else { v as f32 })
    };
    assert!(heights(&read(&float(f32::NAN)))[1].is_nan());
    let infinite = read(&float(f32::INFINITY));
    assert!(
        infinite.notices.iter().any(|n| n.kind == "terrain-impossible" && n.args["value"] == "inf"),
        "{:?}",
        infinite.notices
    );
}

#[test]
fn pictures_and_broken_tags_are_refused_by_name() {
    let with = |tag: u16, field: Field| {
        let mut fields = integers(2, 2);
        fields.retain(|f| f.0 != tag);
        fields.push((tag, field));
        by_hand(false, fields, &[i16s([1, 2, 3, 4], false)], false)
    };
    let cases: [(Vec<u8>, &str); 9] = [
        (with(262, short(0)), "PhotometricInterpretation: white is zero"),
        (with(258, short(1)), "bad-field BitsPerSample: 1 bits"),
        (with(259, short(7)), "bad-field TIFF"),
        (with(259, short(50000)), "bad-field TIFF"),
        (with(33550, Field::Double(vec![-0.0, 3.0, 0.0])), "ModelPixelScale: cells of 0 × 3"),
        (with(33550, Field::Double(vec![f64::NAN, 3.0, 0.0])), "ModelPixelScale: cells of NaN × 3"),
        (with(33550, Field::Double(vec![3.0])), "ModelPixelScale: 1 numbers"),
        (with(34264, Field::Double(vec![3.0; 4])), "ModelTransformation: 4 numbers"),
        (with(33550, Field::Ascii("30")), "bad-field TIFF"),
    ];
    for (file, message) in cases {
        let found = refused(&file);
        assert!(found.contains(message), "{found} lacks {message}");
    }
    let mut rgb = integers(2, 1);
    rgb.retain(|f| ![258, 262, 277, 339].contains(&f.0));
    rgb.extend([(258, Field::Short(vec![8, 8, 8])), (262, short(2)), (277, short(3))]);
    assert!(refused(&by_hand(false, rgb, &[vec![0; 6]], false)).contains("RGB(8) is a picture"));
}

#[test]
fn absurd_claims_are_refused_without_memory() {
    let claim = |width: u32, height: u32, rows: u32| {
        let mut fields = integers(1, 1);
        fields.retain(|f| f.0 != 256 && f.0 != 257);
        fields.extend([(256, Field::Long(vec![width])), (257, Field::Long(vec![height])), (278, Field::Long(vec![rows]))]);
        by_hand(false, fields, &[i16s([1], false)], false)
    };
    assert!(refused(&claim(u32::MAX, u32::MAX, u32::MAX)).starts_with("too-large"));
    assert!(refused(&claim(65_536, 65_536, 65_536)).starts_with("too-large"));
    assert!(refused(&claim(8000, 8000, 8000)).contains("8000 × 8000 cells in a file of"));
    let tile = |width: u32, height: u32| {
        let mut fields = integers(1, 1);
        fields.extend([(322, Field::Long(vec![width])), (323, Field::Long(vec![height]))]);
        by_hand(false, fields, &[i16s([1], false)], true)
    };
    for side in [0, 1 << 20, u32::MAX] {
        // Refused or read, but never taken at its word.
        let _ = import(&tile(side, 16), "a.tif");
        let _ = import(&tile(16, side), "a.tif");
        let _ = import(&tile(side, side), "a.tif");
    }
    // Zeros deflate a thousandfold: 16 MB in 16 KB are read, since they are there.
    let mut file = Cursor::new(Vec::new());
    let mut tiff = TiffEncoder::new(&mut file).unwrap().with_compression(Compression::Deflate(DeflateLevel::Best));
    tiff.new_image::<Gray8>(4000, 4000).unwrap().write_data(&vec![0u8; 16_000_000]).unwrap();
    assert_eq!(read(&file.into_inner()).grid.len(), 16_000_000);
}

#[test]
fn damaged_files_are_read_or_refused() {
    let more = || {
        let mut fields = integers(20, 3);
        fields.extend([(322, short(16)), (323, short(16)), (42113, Field::Ascii("-32768"))]);
        fields.extend([(33550, Field::Double(vec![30.0, 30.0, 0.0])), (34735, Field::Short(vec![1, 1, 0, 1, 1024, 0, 1, 1]))]);
        fields
    };
    let tiled = by_hand(true, more(), &[i16s(0..256, true), i16s(0..256, true)], true);
    let packed = |packing| encoded::<GrayI16>(packing, Predictor::Horizontal, |v| v as i16);
    let floats = encoded::<Gray32Float>(Compression::Deflate(DeflateLevel::Fast), Predictor::None, |v| v as f32);
    for file in
        [tiled, packed_by_gdal(true), packed_by_gdal(false), packed(Compression::Lzw), packed(Compression::Packbits), floats]
    {
        for length in 0..file.len() {
            let _ = import(&file[..length], "a.tif");
        }
        for at in 0..file.len() {
            for byte in [0, 1, 0x7f, 0xff, file[at] ^ 1, file[at] ^ 0x10, file[at] ^ 0x80] {
                let mut spoiled = file.clone();
                spoiled[at] = byte;
                if let Err(error) = import(&spoiled, "a.tif") {
                    let report = error.report();
                    assert!(!report.message.is_empty() && !report.hint.is_empty());
                }
            }
        }
    }
}

#[test]
fn rows_that_run_northwards_are_turned_over() {
    let mut matrix = vec![0.0; 16];
    (matrix[0], matrix[5], matrix[15]) = (30.0, 30.0, 1.0);
    let transformed = read(&placed(vec![(34264, Field::Double(matrix))]));
    assert_eq!((heights(&transformed), transformed.spec.resolution), (vec![3.0, 4.0, 1.0, 2.0], 30.0));
    assert!(notices(&transformed).contains(&"terrain-south-up"), "{:?}", notices(&transformed));
    // A negative ScaleY is none of this: GDAL takes its amount.
    let tie = (33922, Field::Double(vec![0.0, 0.0, 0.0, 5e5, 4e6, 0.0]));
    let scaled = read(&placed(vec![(33550, Field::Double(vec![30.0, -30.0, 0.0])), tie]));
    assert_eq!(heights(&scaled), [1.0, 2.0, 3.0, 4.0]);
}

#[test]
fn what_would_be_placed_wrongly_is_refused() {
    let keys = |key: u16, value: u16| (34735, Field::Short(vec![1, 1, 0, 1, key, 0, 1, value]));
    let scale = || (33550, Field::Double(vec![30.0, 30.0, 0.0]));
    for (more, message) in [
        (vec![(274, short(4))], "Orientation: 4"),
        (vec![scale(), keys(1024, 3)], "GTModelType: geocentric"),
        (vec![scale(), keys(3076, 32767)], "ProjLinearUnits: a unit of its own"),
        (vec![scale(), keys(3076, 9036)], "ProjLinearUnits: the unit 9036"),
    ] {
        let said = refused(&placed(more));
        assert!(said.contains(message), "{said}");
    }
}
