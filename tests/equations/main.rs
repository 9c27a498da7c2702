//! The numbered equations of publications, each by a tiny case worked by hand; and the paper cards that point to the code.
#![cfg(not(target_arch = "wasm32"))]

mod cards;
mod classics;
mod components;
mod fire;
mod fireworks;
mod pso;
mod ship;
mod terrain;
mod threshold;
