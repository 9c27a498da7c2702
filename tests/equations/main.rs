//! The numbered equations of publications, each by a tiny case worked by hand; and the paper cards that point to the code.
#![cfg(not(target_arch = "wasm32"))]

mod by_slices;
mod cards;
mod classics;
mod components;
mod f_rrt_star;
mod fire;
mod fireworks;
mod formica;
mod formica_polylines;
mod genetic;
mod iaaco;
mod ihmaco;
mod maaco;
mod pso;
mod ship;
mod tdi_msaco;
mod terrain;
mod threshold;

use formicarium::map::Direction;

const SQRT2: f64 = std::f64::consts::SQRT_2;
const NE: Direction = 2;
const E: Direction = 4;
const SE: Direction = 7;

/// Equal within what numbers worked by hand are printed with.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * b.abs().max(1.0)
}
