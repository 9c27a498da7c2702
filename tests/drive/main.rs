//! Robots that drive where things move: by hand, against brute force, and what must hold for every drive.
#![cfg(not(target_arch = "wasm32"))]

mod by_hand;
mod clairvoyant;
#[path = "../common/mod.rs"]
mod common;
mod dear;
mod every_drive;
mod moving;
mod planners;
