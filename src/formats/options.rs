//! How to read a file that leaves a choice.

use serde::{Deserialize, Serialize};

use super::Kind;
use super::figure::Lattice;
use super::picture::PictureOptions;
use super::ros::{Costs, Unknown};
use crate::error::FormatError;

/// How to read a file that leaves a choice. Fields that are left out are as in [`ReadOptions::default`]; those that do not concern the file's
/// format count for nothing, but for `figure`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReadOptions {
    /// Which matrix, from 1, of a text that holds several.
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub matrix: Option<u32>,
    /// How a picture becomes a map.
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub picture: PictureOptions,
    /// How unknown cells of a ROS map count.
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub unknown: Unknown,
    /// ROS maps and OccupancyGrid messages: their values from 1 to 98 are costs, the others free or occupied; none: thresholds tell which.
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub costs: Option<Costs>,
    /// MovingAI maps: the factor of a cell of swamp, 1 to [`crate::map::MAX_FACTOR`]; none: as free as any other.
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub swamp_factor: Option<f32>,
    /// Most cells a side of a ROS map: every n × n cells become one, as blocked as the worst of them.
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub cells: Option<u32>,
    /// The picture is the figure of a grid: its cells are read, not its pixels. Any other file is refused then, and of `picture` only
    /// `metres_per_cell` may be given.
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub figure: Option<FigureOptions>,
}

/// How the figure of a grid is read.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FigureOptions {
    /// Where its cells lie; none: it is looked for.
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub lattice: Option<Lattice>,
}

impl ReadOptions {
    /// Refuses to read as a figure what is none; in an archive it may be one.
    pub(super) fn check(&self, kind: Kind) -> Result<(), FormatError> {
        if self.figure.is_none() || matches!(kind, Kind::Picture | Kind::Archive) {
            return Ok(());
        }
        let what = format!("the file is no picture but this: {}", kind.name());
        Err(FormatError::field("figure", what, "a picture of a grid, or another file without `figure`"))
    }
}
