//! The frozen results, natively. `tests/wasm.rs` runs the very same list in node and in a browser.
#![cfg(not(target_arch = "wasm32"))]

#[path = "golden_cases/mod.rs"]
mod golden;

#[test]
fn results_are_the_frozen_ones() {
    golden::check_all();
}
