//! What a file is: every reader says how sure it is that a file is its own, and why. The surest one reads; where two are equally sure, or
//! none is, the file is refused by name.
//!
//! A new format is one line of [`READERS`].

use std::borrow::Cow;

use super::text::{self, lines, quote};
use super::{
    drawing, foreign, matrix, movingai, numbers, path_list, picture, results, ros, scen, scenario_json, terrain, tsplib,
};
use crate::error::FormatError;

pub use super::kind::Kind;

/// How sure a reader is, and why.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Sureness {
    /// It is not its own.
    No,
    /// It may well be.
    Likely(&'static str),
    /// It is.
    Certain(&'static str),
}

/// What a reader may look at.
pub(super) struct Sample<'a> {
    /// The first bytes, at most [`PREFIX`].
    pub head: &'a [u8],
    /// How many bytes the file has.
    pub size: usize,
    /// Its name in small letters.
    pub name: String,
    /// The first bytes as text; empty where they are none.
    pub text: Cow<'a, str>,
    /// Whether they are text.
    pub is_text: bool,
    /// Whether the text is made of `key: value` lines, or is an object of JSON.
    pub has_keys: bool,
}

/// What a file was recognised as.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Recognition {
    /// The format.
    pub kind: Kind,
    /// Whether nothing else could be meant.
    pub is_certain: bool,
    /// By what it was told, in English.
    pub why: &'static str,
}

/// Bytes that a reader sees.
const PREFIX: usize = 1 << 20;

/// A reader: its kind, and how it recognises its own.
struct Reader(Kind, fn(&Sample<'_>) -> Sureness);

const READERS: [Reader; 20] = [
    Reader(Kind::Geotiff, |s| certain_if(terrain::geotiff::looks_like(s.head), "its first bytes")),
    Reader(Kind::Picture, |s| certain_if(picture::looks_like(s.head), "its first bytes")),
    Reader(Kind::Archive, |s| certain_if(foreign::is_archive(s.head), "its first bytes")),
    Reader(Kind::Srtm, srtm),
    Reader(Kind::Scenario, |s| json(s, Kind::Scenario)),
    Reader(Kind::Session, |s| json(s, Kind::Session)),
    Reader(Kind::Comparison, |s| json(s, Kind::Comparison)),
    Reader(Kind::Journal, |s| json(s, Kind::Journal)),
    Reader(Kind::MovingaiScen, movingai_scen),
    Reader(Kind::MovingaiMap, |s| certain_if(movingai::looks_like(&s.text), "the header of a .map")),
    Reader(Kind::Results, |s| certain_if(results::looks_like(&s.text), "the names of its columns")),
    Reader(Kind::EsriAscii, |s| certain_if(terrain::esri_ascii::looks_like(&s.text), "the keys of its header")),
    Reader(Kind::RosMap, |s| certain_if(ros::is_map_description(&s.text), "the keys image, resolution and origin")),
    Reader(Kind::OccupancyGrid, |s| certain_if(ros::is_occupancy_grid(&s.text), "the keys info and data")),
    Reader(Kind::Mapf, |s| certain_if(ros::is_mapf(&s.text), "the keys map and agents")),
    Reader(Kind::Tsplib, |s| tsplib_as(s, tsplib::Looks::Instance)),
    Reader(Kind::TsplibTour, |s| tsplib_as(s, tsplib::Looks::Tour)),
    Reader(Kind::Path, path),
    Reader(Kind::Drawing, |s| drawing::sureness(&s.text)),
    Reader(Kind::Matrix, table),
];

fn certain_if(is_own: bool, why: &'static str) -> Sureness {
    if is_own { Sureness::Certain(why) } else { Sureness::No }
}

impl<'a> Sample<'a> {
    fn of(bytes: &'a [u8], name: &str) -> Self {
        let head = &bytes[..bytes.len().min(PREFIX)];
        let text = text::decode(head);
        let is_text = text.is_ok();
        let text = text.unwrap_or_default();
        let has_keys = has_keys(&text);
        Self { head, size: bytes.len(), name: name.to_ascii_lowercase(), text, is_text, has_keys }
    }
}

/// Whether a text is made of `key: value` lines as YAML is, or begins as an object of JSON or a document of XML.
fn has_keys(text: &str) -> bool {
    let mut said =
        lines(text).map(|(_, line)| line).filter(|line| !line.trim().is_empty() && !line.trim_start().starts_with('#'));
    let Some(first) = said.next() else { return false };
    let is_key = |line: &str| {
        let word = |key: &str| !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || "_-./".contains(c));
        line.trim_start_matches("- ").split_once(':').is_some_and(|(key, rest)| {
            word(key.trim_matches(['"', '\''])) && (rest.is_empty() || rest.starts_with(char::is_whitespace))
        })
    };
    let first = if first.trim_end() == "---" { said.next().unwrap_or("") } else { first };
    // Braces within braces are a matrix of Mathematica or C.
    let is_object = text.trim_start().strip_prefix('{').is_some_and(|rest| !rest.trim_start().starts_with('{'));
    is_key(first) || is_object || first.trim_start().starts_with('<')
}

/// Tells what a file is. Its contents decide; the name only lets a `.scen` pass that lacks its version line, and tells what a tile of the
/// wrong size was meant to be. Only the first million bytes are looked at.
///
/// # Errors
/// [`FormatError::Foreign`] for a known format that cannot be read, with what to do; [`FormatError::Ambiguous`] where two readers are equally
/// sure; [`FormatError::Unknown`].
pub fn recognise(bytes: &[u8], name: &str) -> Result<Recognition, FormatError> {
    let sample = Sample::of(bytes, name);
    let answers: Vec<(Kind, Sureness)> = READERS.iter().map(|Reader(kind, recognise)| (*kind, recognise(&sample))).collect();
    let certain = |answer: &&(Kind, Sureness)| matches!(answer.1, Sureness::Certain(_));
    let likely = |answer: &&(Kind, Sureness)| matches!(answer.1, Sureness::Likely(_));
    let mut best: Vec<_> = answers.iter().filter(certain).collect();
    if best.is_empty() {
        best = answers.iter().filter(likely).collect();
    }
    match best[..] {
        [&(kind, Sureness::Certain(why))] => Ok(Recognition { kind, is_certain: true, why }),
        [&(kind, Sureness::Likely(why))] => Ok(Recognition { kind, is_certain: false, why }),
        [a, b, ..] => Err(FormatError::Ambiguous { found: format!("{} or {}", a.0.name(), b.0.name()) }),
        _ => Err(unknown(bytes, &sample)),
    }
}

/// Why no reader takes a file.
fn unknown(bytes: &[u8], sample: &Sample<'_>) -> FormatError {
    if let Some(error) = foreign::named(sample) {
        return error;
    }
    match text::decode_up_to(bytes, text::MAX_BYTES) {
        Err(error) => error,
        Ok(text) => FormatError::Unknown { begins: quote(&text) },
    }
}

/// What a file is, or [`Kind::Unknown`]; heights in rows and columns are told from maps, for which all of a table is read.
pub fn sniff(bytes: &[u8], name: &str) -> Kind {
    match recognise(bytes, name).map_or(Kind::Unknown, |found| found.kind) {
        Kind::Matrix if holds_heights(bytes) => Kind::HeightTable,
        kind => kind,
    }
}

fn holds_heights(bytes: &[u8]) -> bool {
    let read = |text: Cow<'_, str>| numbers::read(&text, None).is_ok_and(|found| !matrix::is_map(&found.table));
    text::decode(bytes).is_ok_and(read)
}

fn srtm(sample: &Sample<'_>) -> Sureness {
    let called = sample.name.ends_with(".hgt");
    match terrain::srtm::side_of(sample.size) {
        Some(_) if called => Sureness::Certain("its name and its size"),
        // As many bytes may be anything.
        Some(_) if !sample.is_text => Sureness::Likely("its size"),
        None if called && !foreign::is_archive(sample.head) => Sureness::Likely("its name"),
        _ => Sureness::No,
    }
}

fn movingai_scen(sample: &Sample<'_>) -> Sureness {
    if scen::has_version(&sample.text) {
        return Sureness::Certain("its version line");
    }
    certain_if(sample.name.ends_with(".scen") && scen::has_fields(&sample.text), "its name and the fields of its first line")
}

/// By its own `format`, or by its form.
fn path(sample: &Sample<'_>) -> Sureness {
    match json(sample, Kind::Path) {
        Sureness::No => certain_if(path_list::looks_like(&sample.text), "places in brackets, or poses"),
        named => named,
    }
}

fn tsplib_as(sample: &Sample<'_>, looks: tsplib::Looks) -> Sureness {
    certain_if(tsplib::looks_like(&sample.text) == Some(looks), "the keys of its header")
}

fn table(sample: &Sample<'_>) -> Sureness {
    if foreign::is_sparse(&sample.text) {
        return Sureness::No;
    }
    match numbers::looks_like(&sample.text) {
        Some(_) if sample.has_keys || results::looks_like(&sample.text) || path_list::looks_like(&sample.text) => Sureness::No,
        Some(numbers::Shape::Rows) => Sureness::Certain("rows of numbers"),
        Some(numbers::Shape::Brackets) => Sureness::Certain("a bracket of numbers"),
        None => Sureness::No,
    }
}

/// The kind that the field `format` of an object names. Broken JSON still tells what it was meant to be, so that the error is about the
/// line and not about the format.
fn json(sample: &Sample<'_>, kind: Kind) -> Sureness {
    if !sample.text.trim_start().starts_with('{') {
        return Sureness::No;
    }
    let whole = if sample.size <= PREFIX { scenario_json::format_of(&sample.text) } else { None };
    let format = whole.unwrap_or_else(|| sample.text.as_ref().into());
    let place = |word| format.find(word).unwrap_or(usize::MAX);
    let named = [
        (place("formicarium/scenario@"), Kind::Scenario),
        (place("formicarium/experiment@"), Kind::Session),
        (place("formicarium/comparison@"), Kind::Comparison),
        // Of a single run: the reader of comparisons says so.
        (place("formicarium/result@"), Kind::Comparison),
        (place("formicarium/journal@"), Kind::Journal),
        (place("formicarium/path@"), Kind::Path),
    ];
    let first = named.into_iter().filter(|(place, _)| *place < usize::MAX).min_by_key(|(place, _)| *place);
    certain_if(first.is_some_and(|(_, named)| named == kind), "its field `format`")
}
