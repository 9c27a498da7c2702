//! Published variants, one file per paper, each to be read beside its PDF; what we measured with them is in `docs/papers`.

pub mod fire;
pub mod fireworks;
pub mod ship;
pub mod terrain;
pub mod threshold;
