//! # Formicarium: the colony engine
//!
//! Ant-colony path planning beside exact planners, on one map, under one set of rules, with the same bits on every machine.
//!
//! A reader's way in: a [`map::Grid`] and a [`scenario::ScenarioSpec`] make a validated [`scenario::Scenario`]; the [`catalog`]
//! turns a planner's id, its [`params`] and a seed into a [`planner::Planner`], which advances by moves or iterations and tells
//! its best path, history, effort and layers. [`metrics`] measures a path, [`path::audit`] checks it, [`digest`] sums a run up in
//! 64 bits. [`aco`] holds the colonies, [`swarm`] fireworks and particles, [`exact`] the searches with a proof, [`formats`] the files.
//! [`comparison`] runs many seeds and judges what a publication claims.
//!
//! The engine knows no screen, no clock and no randomness of the operating system; only `libm` computes powers, so that results
//! agree natively and in every browser. `wasm/` is the whole browser boundary, `main.rs` and `cli/` the command line.

#![warn(missing_docs)]

pub mod aco;
pub mod catalog;
pub mod comparison;
pub mod digest;
pub mod error;
pub mod exact;
pub mod formats;
mod listed;
pub mod map;
pub mod metrics;
pub mod params;
pub mod path;
pub mod planner;
pub mod rng;
pub mod scenario;
pub mod swarm;

#[cfg(target_arch = "wasm32")]
pub mod wasm;
