//! Files that are known but not read: what to call them, and what to do with them.

use std::borrow::Cow;

use super::picture;
use super::recognise::Sample;
use crate::error::FormatError;

/// First bytes, what they tell, and what to do.
type Known = (&'static [u8], &'static str, &'static str);

/// Text in UTF-16, with or without its mark.
pub(super) const UTF_16: FormatError = FormatError::Foreign {
    found: "text in UTF-16",
    hint: Cow::Borrowed("save it as UTF-8: in Notepad or Excel, choose UTF-8 where it is saved"),
};

const PICTURE: &str = "open it as a picture, with a threshold between free and blocked";
const ARRAY: &str = "write it as text: np.savetxt(\"map.csv\", a, fmt=\"%d\", delimiter=\",\")";
const MATLAB: &str = "write it as text: writematrix(G, \"map.csv\") in MATLAB";
const SHEET: &str = "save the sheet as CSV";
const UNPACK: &str = "unpack it, and open the file within";
const BAG: &str = "write the map out of it: ros2 run nav2_map_server map_saver_cli, or ros2 topic echo --once /map";

/// Archives that are unpacked.
const ARCHIVES: [Known; 2] = [(b"PK\x03\x04", "a ZIP archive", UNPACK), (b"\x1f\x8b", "a gzip archive", UNPACK)];

const FOREIGN: [Known; 25] = [
    (b"GIF8", "a GIF image", "save it as PNG, and open it as a picture"),
    (b"P7\n", "a picture in PAM (P7)", "save it as PNG or PGM, and open it as a picture"),
    (b"PF\n", "a picture of floats (PFM)", "write heights as GeoTIFF, or save it as PNG"),
    (b"Pf\n", "a picture of floats (PFM)", "write heights as GeoTIFF, or save it as PNG"),
    (b"DSAA", "a grid of Surfer (DSAA)", "write it as GeoTIFF: gdal_translate in.grd out.tif"),
    (b"%PDF", "a PDF document", "take a screenshot of the figure, and open that"),
    (b"\x93NUMPY", "a NumPy array (.npy)", ARRAY),
    (b"\x80\x04\x95", "a pickle of Python", ARRAY),
    (b"\x80\x05\x95", "a pickle of Python", ARRAY),
    (b"MATLAB 5.0 MAT-file", "a binary MATLAB .mat file", MATLAB),
    (b"\x89HDF", "an HDF5 file (a .mat of MATLAB 7.3, perhaps)", MATLAB),
    (b"CDF\x01", "a NetCDF file", "write the heights as GeoTIFF: gdal_translate in.nc out.tif"),
    (b"\xd0\xcf\x11\xe0", "a sheet or document of old Microsoft Office (.xls)", SHEET),
    (b"7z\xbc\xaf", "a 7-Zip archive", UNPACK),
    (b"Rar!", "a RAR archive", UNPACK),
    (b"\xfd7zXZ", "an xz archive", UNPACK),
    (b"BZh", "a bzip2 archive", UNPACK),
    (b"\x28\xb5\x2f\xfd", "a zstd archive", UNPACK),
    (b"SQLite format 3", "a SQLite database (a ROS 2 bag, perhaps)", BAG),
    (b"#ROSBAG", "a ROS bag", BAG),
    (b"\x89MCAP", "an MCAP recording", BAG),
    (b"# .PCD", "a cloud of points (.pcd)", "project it onto a grid first, for example with octomap_server"),
    (b"ply\n", "a mesh or cloud of points (.ply)", "project it onto a grid first"),
    (b"{\\rtf", "a document in RTF", "save it as plain text"),
    (b"\0asm", "WebAssembly", "open a map"),
];

/// Whether a file begins as an archive that can be unpacked does.
pub(super) fn is_archive(bytes: &[u8]) -> bool {
    ARCHIVES.iter().any(|(magic, ..)| bytes.starts_with(magic))
}

/// The refusal of a file that is no text, by its first bytes.
pub(super) fn by_first_bytes(bytes: &[u8]) -> Option<FormatError> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Some(UTF_16);
    }
    if picture::looks_like(bytes) {
        return Some(FormatError::Foreign { found: "a picture", hint: PICTURE.into() });
    }
    if bytes.get(257..262) == Some(b"ustar") {
        return Some(FormatError::Foreign { found: "a tar archive", hint: UNPACK.into() });
    }
    let known = FOREIGN.iter().chain(&ARCHIVES).find(|(magic, ..)| bytes.starts_with(magic));
    known.map(|&(_, found, hint)| FormatError::Foreign { found, hint: hint.into() })
}

/// The refusal of a file that no reader takes, by how it begins.
pub(super) fn named(sample: &Sample<'_>) -> Option<FormatError> {
    by_first_bytes(sample.head).or_else(|| sample.is_text.then(|| by_first_words(sample)).flatten())
}

/// Whether a text is a matrix of which only what is not 0 is listed: Matrix Market's, or Octave's.
pub(super) fn is_sparse(text: &str) -> bool {
    let begin = text.trim_start();
    let line = begin.lines().next().unwrap_or("");
    line.starts_with("%%MatrixMarket") && line.contains("coordinate")
        || begin.starts_with('#')
            && begin.lines().take_while(|line| line.starts_with('#')).any(|line| line.contains("type: sparse"))
}

/// The refusal of a text that belongs to results or instances, or in which numbers are written otherwise.
fn by_words(text: &str) -> Option<(&'static str, &'static str)> {
    const FEW: usize = 40;
    let begin: String = text.chars().take(4096).collect::<String>().to_lowercase();
    let keys: Vec<&str> = begin.lines().take(FEW).map(|line| line.split([':', ' ', '\t']).next().unwrap_or("")).collect();
    let has = |key: &str| keys.contains(&key);
    let bare = begin.trim_start_matches(|c: char| c.is_whitespace() || "[({".contains(c));
    let bare = ["np.array(", "array("].iter().find_map(|word| bare.strip_prefix(word)).unwrap_or(bare);
    let bare = bare.trim_start_matches(|c: char| c.is_whitespace() || "[({".contains(c));
    let is_truth = |word: &str| bare.strip_prefix(word).is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric()));
    if has("dimension") && (has("edge_weight_type") || has("node_coord_section")) {
        Some(("an instance of TSPLIB with keys in small letters", "write its keys in capitals: DIMENSION, EDGE_WEIGHT_TYPE, …"))
    } else if has("north") && has("south") && has("rows") && has("cols") {
        Some(("an ASCII grid of GRASS", "write it as GeoTIFF: r.out.gdal, or as ESRI ASCII: r.out.gdal format=AAIGrid"))
    } else if (begin.starts_with("suite =") || begin.starts_with("funcid =")) && begin.contains(".dat") {
        Some(("the list of the data files of COCO or IOHprofiler (.info)", "open the .dat files that it names"))
    } else if text.starts_with('{') && begin.contains("\"function_id\"") && begin.contains("\"scenarios\"") {
        Some(("the list of the data files of IOHprofiler (.json)", "open the .dat files that it names"))
    } else if text.strip_prefix('{').is_some_and(|rest| rest.trim_start().starts_with('"')) && !text.contains("\"format\"") {
        Some(("JSON of another program", "write the map as a matrix [[0, 1], …], or as formicarium/scenario@1"))
    } else if is_truth("true") || is_truth("false") {
        Some(("an array of true and false", "write it as 0 and 1: a.astype(int)"))
    } else {
        None
    }
}

/// The refusal of a text in a language that holds no map.
fn by_first_words(sample: &Sample<'_>) -> Option<FormatError> {
    let text = sample.text.trim_start();
    let starts = |word: &str| text.get(..word.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(word));
    let (found, hint) = if is_sparse(text) {
        ("a sparse matrix", "write all of it: writematrix(full(G), \"map.csv\") in MATLAB, np.savetxt of .toarray() in Python")
    } else if let Some(named) = by_words(text) {
        named
    } else if starts("<!doctype html") || starts("<html") {
        ("a page of the web", "download the file itself: behind a link of GitHub, choose Raw")
    } else if text.starts_with('<') && text.contains("<svg") {
        ("a drawing in SVG", "save it as PNG, and open it as a picture")
    } else if starts("<?xml") || text.starts_with('<') {
        ("a document in XML", "open the map as a matrix, a picture or a .map")
    } else if text.starts_with('{') {
        return None;
    } else if text.starts_with("\\") {
        ("a text in LaTeX", "keep the rows of numbers alone")
    } else if sample.has_keys {
        (
            "a list of keys and values (YAML, perhaps) that describes no map known here",
            "open a ROS map.yaml, an OccupancyGrid message, or the map as a matrix",
        )
    } else if ["zeros(", "ones("].iter().any(|made| text.contains(made)) {
        ("a program that computes its map", "run it, and write the map out: writematrix(G, \"map.csv\"), or np.savetxt in Python")
    } else {
        return None;
    };
    Some(FormatError::Foreign { found, hint: hint.into() })
}
