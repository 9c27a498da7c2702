//! The runs of a stored comparison, some at a time.

use std::fs::File;
use std::io::BufReader;
use std::sync::Mutex;

use formicarium::comparison::report::{HEADER, TRACE_HEADER, line, trace_lines};
use formicarium::formats::comparison_rows;
use pyo3::prelude::*;

use super::errors::{Refusal, stored};

/// The columns of rows and of traces.
#[pyfunction]
pub fn columns() -> (&'static str, &'static str) {
    (HEADER, TRACE_HEADER)
}

/// A comparison's document whose runs are read as they are asked for.
#[pyclass(frozen, module = "formicarium._engine")]
pub struct StoredRows {
    path: String,
    rows: Mutex<comparison_rows::StoredRows<BufReader<File>>>,
}

#[pymethods]
impl StoredRows {
    #[new]
    fn open(py: Python<'_>, path: String) -> PyResult<Self> {
        let rows = py.detach(|| {
            let file = File::open(&path).map_err(|error| Refusal::file(&path, format!("cannot read {path}: {error}")))?;
            comparison_rows::StoredRows::open(BufReader::new(file)).map_err(|error| stored(&path, error))
        })?;
        Ok(Self { path, rows: Mutex::new(rows) })
    }

    /// The next runs, at most so many: the lines of the table and those of their improvements, without heads, and how many runs they are.
    fn next(&self, py: Python<'_>, most: usize) -> PyResult<(String, String, usize)> {
        let read = py.detach(|| {
            let mut rows = self.rows.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            let (mut lines, mut traces, mut count) = (String::new(), String::new(), 0);
            while count < most {
                let Some(row) = rows.next_row().map_err(|error| stored(&self.path, error))? else { break };
                lines += &line(&rows.comparison, &row);
                lines.push('\n');
                traces += &trace_lines(&rows.comparison, &row);
                count += 1;
            }
            Ok::<_, Refusal>((lines, traces, count))
        });
        Ok(read?)
    }
}
