//! The real binary: every subcommand, its output, its errors and its exit codes.
#![cfg(not(target_arch = "wasm32"))]

#[path = "../formats/schema.rs"]
mod schema;

mod ablation;
mod again;
mod check;
mod compare;
mod files;
mod folder;
mod interrupted;
mod plan;
mod results;
mod terrain;
