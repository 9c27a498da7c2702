//! How to read a file that leaves a choice.

use serde::{Deserialize, Serialize};

use super::picture::PictureOptions;
use super::ros::Unknown;

/// How to read a file that leaves a choice. Fields that are left out are as in [`ReadOptions::default`]; those that do not concern the file's
/// format count for nothing.
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
    /// Most cells a side of a ROS map: every n × n cells become one, as blocked as the worst of them.
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub cells: Option<u32>,
}
