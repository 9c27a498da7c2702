//! Long work: other Python threads go on meanwhile, and Ctrl-C ends it.

use std::time::{Duration, Instant};

use pyo3::prelude::*;

/// How long nobody looks for Ctrl-C.
pub const GLANCE: Duration = Duration::from_millis(100);

/// Works piece by piece, without Python, until `piece` says that it is done; between pieces looks for signals now and then.
///
/// # Errors
/// What a signal's handler raises, `KeyboardInterrupt` above all.
pub fn work(py: Python<'_>, mut piece: impl FnMut() -> bool + Send) -> PyResult<()> {
    loop {
        let is_done = py.detach(|| {
            let glance = Instant::now() + GLANCE;
            loop {
                if piece() {
                    return true;
                }
                if Instant::now() >= glance {
                    return false;
                }
            }
        });
        py.check_signals()?;
        if is_done {
            return Ok(());
        }
    }
}
