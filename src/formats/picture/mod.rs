//! Pictures as maps: PNG, JPEG, BMP, WebP and Netpbm (PBM, PGM, PPM).
//!
//! [`decode`] reads the pixels. docs/formats.md has the rules.

mod decode;
mod pnm;

pub use decode::{MAX_PIXELS, Picture, decode, looks_like};
pub use pnm::write_pgm;
