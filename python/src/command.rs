//! The command line.

use std::ffi::OsString;

use pyo3::prelude::*;

/// Runs the command line with these arguments, without a program's name, and returns its exit code.
#[pyfunction]
pub fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    let whole = std::iter::once("formicarium".into()).chain(arguments);
    py.detach(|| formicarium::cli::run(whole))
}
