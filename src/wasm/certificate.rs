//! What a run has proven.

use tsify::Ts;
use wasm_bindgen::prelude::*;

use super::object;
use super::run::Run;
use crate::planner::Certificate;

#[wasm_bindgen]
impl Run {
    /// What the planner has proven of its result, or had at the iteration that is looked at; undefined where it proves nothing, before its first
    /// step, and where there is no path. It looks at all that is open: not for every frame.
    pub fn certificate(&self) -> Option<Ts<Certificate>> {
        self.shown().certificate().as_ref().map(object)
    }
}
