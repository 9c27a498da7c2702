//! Maps and how one moves on them.

mod contours;
#[cfg(feature = "whole")]
mod distance;
mod generate;
mod grid;
mod movement;
mod plane_length;
mod relief;
#[cfg(feature = "whole")]
pub mod resample;
mod shading;
mod slices;
mod weights;

pub use contours::{ContourLine, Contours};
#[cfg(feature = "whole")]
pub use distance::squared_distances;
pub use generate::{Generated, Generator, MAX_DENSITY, generate};
pub use grid::{Cell, Grid, MAX_SIDE, Point, check_size};
pub use movement::{
    ALL_DIRECTIONS, CornerRule, DIRECTIONS, Direction, FAR, MoveSet, Movement, Moves, OFFSETS, is_diagonal, octile, offset,
    opposite, step_length,
};
pub(crate) use plane_length::{PlaneLength, displacement};
pub use plane_length::{counted_length, length_on_plane};
pub use relief::{Relief, Stretch};
#[cfg(feature = "whole")]
pub use resample::Window;
pub use shading::{LEVEL_LIGHT, Shading};
pub use slices::{MAX_LEVELS, MAX_REACH, Measure, SliceRules, Slices, Way};
pub use weights::{Charge, MAX_FACTOR, Weights, mean_factor};
