//! What the tags of GDAL and the keys of GeoTIFF say of heights: their unit, their scale and offset, and the value that stands for none.

use super::super::text::quote;
use crate::error::{FormatError, Notice};

/// Metres of a foot: the international one, and that of the survey of the United States.
pub(super) const FOOT: f64 = 0.3048;
pub(super) const SURVEY_FOOT: f64 = 1200.0 / 3937.0;

/// What a height in metres is made of: file value · scale + offset, each of them so many metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Values {
    pub scale: f64,
    pub offset: f64,
    /// Metres of a height of 1.
    pub unit: f64,
}

impl Values {
    /// From GDAL's metadata and the keys of the vertical coordinates.
    pub fn of(metadata: &str, vertical_unit: Option<u16>, vertical_system: Option<u16>) -> Result<Self, FormatError> {
        let number = |role: &'static str, otherwise: f64| match item(metadata, role) {
            None => Ok(otherwise),
            Some(text) => text.trim().parse().ok().filter(|v: &f64| v.is_finite()).ok_or_else(|| {
                FormatError::field("GDAL_METADATA", format!("the {role} `{}` is no number", quote(text)), "a number")
            }),
        };
        let unit = unit_of_key(vertical_unit).or_else(|| unit_of_system(vertical_system));
        let unit = unit.or_else(|| item(metadata, "unittype").and_then(unit_of_name)).unwrap_or(1.0);
        let scale = number("scale", 1.0)?;
        if scale == 0.0 {
            return Err(FormatError::field("GDAL_METADATA", "the scale is 0: all heights would be the same", "another scale"));
        }
        Ok(Self { scale, offset: number("offset", 0.0)?, unit })
    }

    /// Whether file values are heights as they stand.
    pub fn is_plain(self) -> bool {
        self.scale == 1.0 && self.offset == 0.0
    }

    /// What was applied.
    pub fn notices(self) -> Vec<Notice> {
        let Self { scale, offset, unit } = self;
        let mut notices = Vec::new();
        if !self.is_plain() {
            let message = format!("heights are {scale} times the file's numbers, plus {offset}, as the file says");
            notices.push(Notice::new("terrain-scaled", message).with("scale", scale).with("offset", offset));
        }
        if unit != 1.0 {
            let message = format!("heights are in feet of {unit:.7} m, as the file says");
            notices.push(Notice::new("terrain-feet", message).with("unit", format!("{unit:.7}")));
        }
        notices
    }
}

/// The unit of key VerticalUnits.
fn unit_of_key(key: Option<u16>) -> Option<f64> {
    match key? {
        9001 => Some(1.0),
        9002 => Some(FOOT),
        9003 => Some(SURVEY_FOOT),
        _ => None,
    }
}

/// The unit of a vertical coordinate system: NGVD29 and NAVD88 in feet, by their EPSG codes.
fn unit_of_system(key: Option<u16>) -> Option<f64> {
    match key? {
        5702 | 6360 | 6358 | 6359 => Some(SURVEY_FOOT),
        8228 | 8050 | 8052 => Some(FOOT),
        _ => None,
    }
}

/// The unit that GDAL names.
fn unit_of_name(name: &str) -> Option<f64> {
    match name.trim().to_ascii_lowercase().as_str() {
        "ft" | "foot" | "feet" => Some(FOOT),
        "us-ft" | "ftus" | "us survey foot" | "us survey feet" | "sfoot" => Some(SURVEY_FOOT),
        "m" | "metre" | "meter" | "metres" | "meters" => Some(1.0),
        _ => None,
    }
}

/// The text of the first band's item of a role: `<Item name="SCALE" sample="0" role="scale">0.1</Item>`.
fn item<'a>(metadata: &'a str, role: &str) -> Option<&'a str> {
    metadata.split("<Item").skip(1).find_map(|item| {
        let (attributes, rest) = item.split_once('>')?;
        let is = |name: &str, value: &str| attributes.contains(&format!("{name}=\"{value}\""));
        let of_first = is("sample", "0") || !attributes.contains("sample=");
        (is("role", role) && of_first).then(|| rest.split('<').next().unwrap_or(""))
    })
}

/// A value for no data that the numbers of the file cannot have.
pub(super) fn unused(no_data: f64, range: Option<(f64, f64)>) -> Option<Notice> {
    let (low, high) = range?;
    let fits = no_data.fract() == 0.0 && (low..=high).contains(&no_data);
    (!fits).then(|| {
        let message = format!(
            "the file says that {no_data} stands for no data, but its numbers are whole, from {low} to {high}: no cell is without data by it"
        );
        Notice::new("terrain-no-data-unused", message).with("value", no_data).with("low", low).with("high", high)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scale_offset_and_units_are_found() {
        let items = "<GDALMetadata>\n <Item name=\"SCALE\" sample=\"1\" role=\"scale\">7</Item>\n <Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.1</Item>\n <Item name=\"OFFSET\" sample=\"0\" role=\"offset\">-100</Item>\n</GDALMetadata>";
        assert_eq!(Values::of(items, None, None), Ok(Values { scale: 0.1, offset: -100.0, unit: 1.0 }));
        assert_eq!(Values::of("", Some(9002), None).map(|v| v.unit), Ok(FOOT));
        assert_eq!(Values::of("", None, Some(6360)).map(|v| v.unit), Ok(SURVEY_FOOT));
        let named = "<Item name=\"UNITTYPE\" sample=\"0\" role=\"unittype\">ft</Item>";
        assert_eq!(Values::of(named, None, None).map(|v| v.unit), Ok(FOOT));
        for wrong in ["x", "nan", "0"] {
            assert!(Values::of(&items.replace("0.1", wrong), None, None).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_value_that_cannot_occur_is_told() {
        for (value, told) in [(f64::NAN, true), (-9999.0, true), (0.5, true), (0.0, false), (65535.0, false)] {
            assert_eq!(unused(value, Some((0.0, 65535.0))).is_some(), told, "{value}");
        }
        assert!(unused(f64::NAN, None).is_none());
    }
}
