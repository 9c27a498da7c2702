//! What a file is.

use serde::{Deserialize, Serialize};

use super::{matrix, movingai, results, scen, scenario_json, table, terrain, text};

/// What a file is. Serialized as `movingai-map`, `movingai-scen`, `matrix`, `esri-ascii`, `height-table`, `geotiff`, `srtm`, `scenario`,
/// `session`, `comparison`, `results`, `unknown`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Kind {
    /// A map of the MovingAI benchmarks.
    MovingaiMap,
    /// A list of scenarios of the MovingAI benchmarks.
    MovingaiScen,
    /// Numbers in rows and columns.
    Matrix,
    /// Heights as an ESRI ASCII grid.
    EsriAscii,
    /// Heights in rows and columns.
    HeightTable,
    /// Heights as a GeoTIFF.
    Geotiff,
    /// Heights as an SRTM tile.
    Srtm,
    /// A scenario with its map, as JSON.
    Scenario,
    /// A race as it is shared (`formicarium/experiment@1`), as JSON.
    Session,
    /// Many runs with their question and maps, as JSON.
    Comparison,
    /// Runs from elsewhere, as a table or a data file of IOHanalyzer.
    Results,
    /// None of these.
    Unknown,
}

impl Kind {
    /// Whether files of this kind are rasters of heights.
    pub const fn is_raster(self) -> bool {
        matches!(self, Self::EsriAscii | Self::HeightTable | Self::Geotiff | Self::Srtm)
    }
}

/// Tells what a file is. Its contents decide; the name only lets a `.scen` pass that lacks its version line.
pub fn sniff(bytes: &[u8], name: &str) -> Kind {
    match kind_of(bytes, name) {
        Kind::Matrix if holds_heights(bytes) => Kind::HeightTable,
        kind => kind,
    }
}

/// The same, except that a table may be a map or hold heights.
pub(super) fn kind_of(bytes: &[u8], name: &str) -> Kind {
    if terrain::geotiff::looks_like(bytes) {
        return Kind::Geotiff;
    }
    let text = text::decode_up_to(bytes, text::MAX_BYTES);
    let called_hgt = name.to_ascii_lowercase().ends_with(".hgt");
    if terrain::srtm::side_of(bytes.len()).is_some() && (called_hgt || text.is_err()) {
        return Kind::Srtm;
    }
    text.map_or(Kind::Unknown, |text| sniff_text(&text, name))
}

fn holds_heights(bytes: &[u8]) -> bool {
    text::decode(bytes).is_ok_and(|text| table::read(&text).is_ok_and(|table| !matrix::is_map(&table)))
}

fn sniff_text(text: &str, name: &str) -> Kind {
    // Blank lines say nothing: they are looked at once, and not by every reader.
    let blank = text.len() - text.trim_start().len();
    let text = &text[text[..blank].rfind(['\n', '\r']).map_or(0, |at| at + 1)..];
    if text.trim_start().starts_with('{') {
        return sniff_json(text);
    }
    let called_scen = name.to_ascii_lowercase().ends_with(".scen");
    if scen::has_version(text) || (called_scen && scen::has_fields(text)) {
        Kind::MovingaiScen
    } else if movingai::looks_like(text) {
        Kind::MovingaiMap
    } else if results::looks_like(text) {
        Kind::Results
    } else if terrain::esri_ascii::looks_like(text) {
        Kind::EsriAscii
    } else if table::looks_like(text) {
        Kind::Matrix
    } else {
        Kind::Unknown
    }
}

fn sniff_json(text: &str) -> Kind {
    // Broken JSON still tells what it was meant to be, so that the error is about the line and not about the format.
    let format = scenario_json::format_of(text).unwrap_or_else(|| text.into());
    let place = |word| format.find(word).unwrap_or(usize::MAX);
    let named = [
        (place("formicarium/scenario@"), Kind::Scenario),
        (place("formicarium/experiment@"), Kind::Session),
        (place("formicarium/comparison@"), Kind::Comparison),
        // Of a single run: the reader of comparisons says so.
        (place("formicarium/result@"), Kind::Comparison),
    ];
    let first = named.into_iter().filter(|(place, _)| *place < usize::MAX).min_by_key(|(place, _)| *place);
    first.map_or(Kind::Unknown, |(_, kind)| kind)
}
