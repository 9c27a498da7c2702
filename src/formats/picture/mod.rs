//! Pictures as maps: PNG, JPEG, BMP, WebP and Netpbm (PBM, PGM, PPM).
//!
//! [`decode`] reads the pixels, [`small`] shows them, [`to_cells`] makes cells of them, [`shrink_worst`] makes fewer cells of any, [`write_pgm`] writes gray.
//! docs/formats.md has the rules.

mod cells;
mod decode;
mod pnm;
mod shrink;
mod small;
mod threshold;

pub(super) use cells::metres;
pub use cells::{Cells, PictureOptions, to_cells};
pub use decode::{MAX_PIXELS, Picture, decode, looks_like};
pub use pnm::write_pgm;
pub use shrink::shrink_worst;
pub use small::{Small, small};
pub(super) use threshold::otsu;
pub use threshold::{luma, over_white};
