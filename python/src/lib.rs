//! The native half of the Python package: conversions and calls. What is decided is decided by the engine; what is convenient is in Python.
//!
//! Cells cross as bytes, paths as little-endian numbers, everything else as JSON text: NumPy is Python's to know. Whatever takes long lets other
//! Python threads go on, and looks for Ctrl-C every tenth of a second.

mod check;
mod command;
mod comparison;
mod errors;
mod map;
mod patience;
mod plan;
mod pool;
mod rows;

use pyo3::prelude::*;

/// `formicarium._engine`.
#[pymodule]
#[pyo3(name = "_engine")]
mod engine {
    #[pymodule_export]
    use super::check::check;
    #[pymodule_export]
    use super::command::command;
    #[pymodule_export]
    use super::comparison::{Comparison, ask, read_question};
    #[pymodule_export]
    use super::map::{Map, catalog, generate, read_map};
    #[pymodule_export]
    use super::plan::plan;
    #[pymodule_export]
    use super::rows::{StoredRows, columns};

    use pyo3::prelude::*;

    /// The engine's version.
    #[pyfunction]
    fn version() -> &'static str {
        env!("CARGO_PKG_VERSION")
    }
}
