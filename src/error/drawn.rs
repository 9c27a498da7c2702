//! What is wrong with a path that somebody draws.

use thiserror::Error;

use super::ErrorReport;

/// A path that is drawn by hand cannot go there.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum DrawnError {
    /// The cell lies outside the map.
    #[error("({x}, {y}) lies outside the map")]
    Outside {
        /// Column asked for.
        x: u32,
        /// Row asked for.
        y: u32,
    },
    /// The cell is an obstacle.
    #[error("({x}, {y}) is blocked")]
    Blocked {
        /// Column.
        x: u32,
        /// Row.
        y: u32,
    },
    /// No allowed step leads closer.
    #[error("from ({x}, {y}) no allowed step leads closer to ({to_x}, {to_y})")]
    NoWay {
        /// Column where it stops.
        x: u32,
        /// Row where it stops.
        y: u32,
        /// Column asked for.
        to_x: u32,
        /// Row asked for.
        to_y: u32,
    },
    /// Paths by slices have levels, which a pointer on the map does not tell.
    #[error("paths by slices cannot be drawn by hand")]
    Slices,
}

impl DrawnError {
    /// The flat form.
    pub fn report(&self) -> ErrorReport {
        let report = |kind: &str, hint: &str| ErrorReport::new(kind, "path", self.to_string(), hint);
        match self {
            Self::Outside { x, y } => {
                report("drawn-outside", "stay within the columns and rows of the map").with("x", x).with("y", y)
            }
            Self::Blocked { x, y } => {
                report("drawn-blocked", "go around the wall, or take the last piece back").with("x", x).with("y", y)
            }
            Self::NoWay { x, y, to_x, to_y } => report(
                "drawn-no-way",
                "go on cell by cell around what is in the way: the rule of movement may forbid to cut the corner",
            )
            .with("x", x)
            .with("y", y)
            .with("to_x", to_x)
            .with("to_y", to_y),
            Self::Slices => report("drawn-slices", "move along the surface, or draw on a map without heights"),
        }
    }
}
