//! The curve of a run's best path.

use tsify::Ts;
use wasm_bindgen::prelude::*;

use super::object;
use super::run::Run;
use crate::smoothing::Smoothed;

#[wasm_bindgen]
impl Run {
    /// The best path as a smooth curve, refined where the planner does so; undefined while there is none, by slices, and where the scenario's
    /// vehicle has no rule of smoothing. It is worked out anew by each call.
    pub fn smoothed(&self) -> Option<Ts<Smoothed>> {
        let best = self.shown().best()?;
        Smoothed::of(self.map(), best.result().0).as_ref().map(object)
    }
}
