//! Coordinate systems by the name of a map's frame.

/// WGS 84 in degrees.
pub(super) const WGS_84: u32 = 4326;

/// Well-known systems in degrees: ETRS89, NAD27, NAD83, WGS 84, CGCS2000.
const IN_DEGREES: [u32; 5] = [4258, 4267, 4269, WGS_84, 4490];

/// Whether a code is of a well-known system in degrees: no map in metres can be in it.
pub(super) fn is_in_degrees(code: u32) -> bool {
    IN_DEGREES.contains(&code)
}

/// The EPSG code in a frame's name: `EPSG:25832` or `urn:ogc:def:crs:EPSG::25832`, whatever its letters' case; of `CRS84` that of WGS 84. None
/// for any other name.
pub(super) fn code(frame: &str) -> Option<u32> {
    let name = frame.trim().to_ascii_uppercase();
    if matches!(name.as_str(), "CRS84" | "OGC:CRS84" | "URN:OGC:DEF:CRS:OGC:1.3:CRS84") {
        return Some(WGS_84);
    }
    let rest = name.strip_prefix("EPSG:").or_else(|| name.strip_prefix("URN:OGC:DEF:CRS:EPSG:"))?;
    // A version may stand before the code.
    let digits = rest.rsplit(':').next().unwrap_or(rest);
    digits.parse().ok().filter(|&code| code > 0 && digits.bytes().all(|b| b.is_ascii_digit()))
}

/// The name of a code as GeoJSON of 2008 has it.
pub(super) fn urn(code: u32) -> String {
    format!("urn:ogc:def:crs:EPSG::{code}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_found_in_every_spelling() {
        for name in ["EPSG:25832", "epsg:25832", " EPSG:25832 ", "urn:ogc:def:crs:EPSG::25832", "urn:ogc:def:crs:EPSG:9.8:25832"]
        {
            assert_eq!(code(name), Some(25832), "{name}");
        }
        assert_eq!(code(&urn(32633)), Some(32633));
        assert_eq!(code("urn:ogc:def:crs:OGC:1.3:CRS84"), Some(WGS_84));
        for name in ["", "map", "EPSG", "EPSG:", "EPSG:0", "EPSG:+5", "EPSG:x", "UTM32"] {
            assert_eq!(code(name), None, "{name}");
        }
    }
}
