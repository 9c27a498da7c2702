//! Distances between places, as TSPLIB 95 defines them. Those with their optimum in the library hold for exactly these roundings.

use crate::error::FormatError;

use super::super::text::quote;

/// The values of `EDGE_WEIGHT_TYPE` that are read.
pub(super) const NAMES: &str = "EXPLICIT, EUC_2D, EUC_3D, MAX_2D, MAX_3D, MAN_2D, MAN_3D, CEIL_2D, GEO or ATT";

/// How costs are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Metric {
    /// They stand in the file.
    Explicit,
    /// Straight, rounded; of two or three coordinates.
    Euclidean(usize),
    /// The largest difference of a coordinate, rounded.
    Largest(usize),
    /// The sum of the differences, rounded.
    Manhattan(usize),
    /// Straight, rounded up.
    Ceiling,
    /// On a sphere, in kilometres.
    Geographical,
    /// Pseudo-Euclidean, of the instances att48 and att532.
    Att,
}

impl Metric {
    /// By its name in the file.
    pub fn named(name: &str) -> Result<Self, FormatError> {
        Ok(match name {
            "EXPLICIT" => Self::Explicit,
            "EUC_2D" => Self::Euclidean(2),
            "EUC_3D" => Self::Euclidean(3),
            "MAX_2D" => Self::Largest(2),
            "MAX_3D" => Self::Largest(3),
            "MAN_2D" => Self::Manhattan(2),
            "MAN_3D" => Self::Manhattan(3),
            "CEIL_2D" => Self::Ceiling,
            "GEO" => Self::Geographical,
            "ATT" => Self::Att,
            _ => return Err(FormatError::field("EDGE_WEIGHT_TYPE", format!("`{}` is not read", quote(name)), NAMES)),
        })
    }

    /// How many coordinates a place has; none where they do not matter.
    pub fn axes(self) -> Option<usize> {
        match self {
            Self::Explicit => None,
            Self::Euclidean(axes) | Self::Largest(axes) | Self::Manhattan(axes) => Some(axes),
            Self::Ceiling | Self::Geographical | Self::Att => Some(2),
        }
    }

    /// Between two places; the third coordinate of places in the plane is 0.
    pub fn distance(self, a: [f64; 3], b: [f64; 3]) -> f64 {
        let d = [0, 1, 2].map(|axis| (a[axis] - b[axis]).abs());
        let squares = || d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        match self {
            Self::Explicit => 0.0,
            Self::Euclidean(_) => nint(libm::sqrt(squares())),
            Self::Largest(_) => d.map(nint).into_iter().fold(0.0, f64::max),
            Self::Manhattan(_) => nint(d[0] + d[1] + d[2]),
            Self::Ceiling => libm::ceil(libm::sqrt(squares())),
            Self::Geographical => geographical(a, b),
            Self::Att => att(libm::sqrt(squares() / 10.0)),
        }
    }
}

/// nint of the format: (int) (x + 0.5).
fn nint(x: f64) -> f64 {
    (x + 0.5).trunc()
}

/// ATT: rounded up from √(d² / 10).
fn att(root: f64) -> f64 {
    let rounded = nint(root);
    if rounded < root { rounded + 1.0 } else { rounded }
}

/// Degrees of DDD.MM: degrees and minutes. The listed optima hold for degrees cut off, not rounded as the format's text says.
pub(super) fn degrees(x: f64) -> f64 {
    x.trunc() + 5.0 * (x - x.trunc()) / 3.0
}

/// Latitude and longitude on a sphere.
fn geographical(a: [f64; 3], b: [f64; 3]) -> f64 {
    #[expect(clippy::approx_constant, reason = "the format's own")]
    const PI: f64 = 3.141592;
    const RADIUS: f64 = 6378.388;
    let radians = |x: f64| PI * degrees(x) / 180.0;
    let ([lat_a, lon_a, _], [lat_b, lon_b, _]) = (a.map(radians), b.map(radians));
    let (q1, q2, q3) = (libm::cos(lon_a - lon_b), libm::cos(lat_a - lat_b), libm::cos(lat_a + lat_b));
    let cosine = 0.5 * ((1.0 + q1) * q2 - (1.0 - q1) * q3);
    (RADIUS * libm::acos(cosine.clamp(-1.0, 1.0)) + 1.0).trunc()
}
