//! Figures of papers as maps: from a picture of a grid to its lattice and its cells.
//!
//! [`find`] looks for the lattice and reads its cells; [`read`] reads them anew after somebody has set the lattice right; [`to_map`] makes a
//! map of them. docs/formats.md has the rules, and how well they do.

mod cells;
mod colours;
mod extent;
mod find;
mod fit;
mod lattice;
mod look;
mod map;
mod period;
mod plane;

pub use cells::{FigureCells, class, read};
pub use lattice::Lattice;
pub(super) use map::import;
pub use map::to_map;

use super::picture::Picture;
use crate::error::FormatError;

/// A figure that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Where its cells lie in the picture.
    pub lattice: Lattice,
    /// What they are.
    pub cells: FigureCells,
}

/// Looks for a lattice of at least 4 × 4 cells of one size (5 pixels or more a side) and reads its cells. The lattice may lean by three
/// pixels in a hundred; the picture has at most 8192 pixels a side.
///
/// # Errors
/// [`FormatError::Field`] `figure`: there is no lattice. [`FormatError::TooLarge`]: the picture has longer sides.
pub fn find(picture: &Picture) -> Result<Figure, FormatError> {
    let lattice = find::lattice(&plane::Plane::new(picture))?;
    Ok(Figure { lattice, cells: read(picture, &lattice)? })
}
