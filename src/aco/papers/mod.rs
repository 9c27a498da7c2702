//! Published variants, one file per paper, each to be read beside its PDF; what we measured with them is in `docs/papers`.

pub mod fire;
pub mod fireworks;
pub mod iaaco;
pub mod ihmaco;
pub mod maaco;
pub mod ship;
pub mod tdi_msaco;
pub mod terrain;
pub mod threshold;
