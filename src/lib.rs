//! # Formicarium: the colony engine
//!
//! Ant-colony path planning beside exact planners, on one map, under one set of rules, with the same bits on every machine.
//!
//! A reader's way in: a [`map::Grid`] and a [`scenario::ScenarioSpec`] make a validated [`scenario::Scenario`]; the [`catalog`]
//! turns a planner's id, its [`params`] and a seed into a [`planner::Planner`], which advances by moves or iterations and tells
//! its best path, history, effort and layers. [`metrics`] measures a path, [`path::audit`] checks it, [`findings`] tells all that is wrong with it, [`digest`] sums a run up in
//! 64 bits. [`aco`] holds the colonies, [`swarm`] fireworks and particles, [`exact`] the searches with a proof, [`formats`] the files.
//! [`drive`] has a robot drive where things move; [`comparison`] runs many seeds and judges what a publication claims.
//!
//! ```
//! use std::sync::Arc;
//! use formicarium::{catalog, exact, map, params::Values, scenario::Scenario};
//!
//! let made = map::generate(map::Generator::Random, 20, 20, 1, 0.2)?;
//! let spec = made.spec("blocks");
//! let scenario = Arc::new(Scenario::new(made.grid, spec)?);
//!
//! let mut ants = catalog::build(&scenario, "ant-system", None, &Values::new(), 1)?;
//! let mut search = catalog::build(&scenario, "astar", None, &Values::new(), 1)?;
//! ants.run();
//! search.run();
//!
//! let optimum = exact::reference(&scenario, ants.objective()).value().expect("a path exists");
//! assert!((search.best().expect("found").length - optimum).abs() < 1e-9);
//! assert!(ants.best().expect("found").length >= optimum - 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Layers, from the bottom: [`error`], [`rng`], [`digest`] and [`params`]; [`map`]; [`scenario`]; [`path`]; [`metrics`], [`drawn`] and [`smoothing`]; [`planner`] and [`findings`]; [`exact`]
//! and [`swarm`]; [`aco`], whose hybrids use both; [`catalog`]; [`drive`]. A module knows none above it (`tests/layers.rs`).
//!
//! The engine knows no screen, no clock and no randomness of the operating system; only `libm` computes powers, so that results
//! agree natively and in every browser. `wasm/` is the whole browser boundary, `cli/` the command line, which
//! `main.rs` and the Python package start.

#![warn(missing_docs)]
// The library has no unsafe code; only what wasm-bindgen generates for the browser boundary has.
#![cfg_attr(not(target_arch = "wasm32"), forbid(unsafe_code))]

pub mod aco;
pub mod catalog;
#[cfg(all(feature = "whole", not(target_arch = "wasm32")))]
pub mod cli;
#[cfg(feature = "whole")]
pub mod comparison;
pub mod digest;
pub mod drawn;
#[cfg(feature = "whole")]
pub mod drive;
pub mod error;
pub mod exact;
#[cfg(feature = "whole")]
pub mod findings;
#[cfg(feature = "whole")]
pub mod formats;
mod listed;
pub mod map;
pub mod metrics;
pub mod params;
pub mod path;
pub mod planner;
pub mod rng;
pub mod sampling;
pub mod scenario;
#[cfg(feature = "whole")]
pub mod smoothing;
pub mod swarm;

#[cfg(target_arch = "wasm32")]
pub mod wasm;
