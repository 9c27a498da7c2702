//! The runs of a stored comparison, some at a time.

use std::collections::VecDeque;
use std::fs::File;
use std::io::BufReader;
use std::sync::{Arc, Mutex, PoisonError};

use formicarium::comparison::report::{HEADER, TRACE_HEADER, line, trace_lines};
use formicarium::comparison::{Comparison, Row};
use formicarium::formats::comparison_rows::{self, JournalRows};
use pyo3::prelude::*;

use super::comparison;
use super::errors::{Refusal, stored};

/// The columns of rows and of traces.
#[pyfunction]
pub fn columns() -> (&'static str, &'static str) {
    (HEADER, TRACE_HEADER)
}

/// Stored runs that are read as they are asked for.
#[pyclass(frozen, module = "formicarium._engine")]
pub struct StoredRows(Mutex<Source>);

/// Where they come from.
enum Source {
    Document { path: String, rows: Box<comparison_rows::StoredRows<BufReader<File>>> },
    Journals { comparison: Arc<Comparison>, rows: JournalRows, open: Option<(String, BufReader<File>)>, left: VecDeque<String> },
}

#[pymethods]
impl StoredRows {
    /// A comparison's document.
    #[new]
    fn of_document(py: Python<'_>, path: String) -> PyResult<Self> {
        let rows = py.detach(|| comparison_rows::StoredRows::open(opened(&path)?).map_err(|error| stored(&path, error)))?;
        Ok(Self(Mutex::new(Source::Document { path, rows: Box::new(rows) })))
    }

    /// Journals of a comparison.
    #[staticmethod]
    fn of_journals(py: Python<'_>, paths: Vec<String>, of: &comparison::Comparison) -> Self {
        let comparison = Arc::clone(&of.comparison);
        let rows = py.detach(|| JournalRows::of(&comparison));
        Self(Mutex::new(Source::Journals { comparison, rows, open: None, left: paths.into() }))
    }

    /// Lines of journals that did not hold, so far.
    #[getter]
    fn dropped(&self, py: Python<'_>) -> usize {
        py.detach(|| match &*self.0.lock().unwrap_or_else(PoisonError::into_inner) {
            Source::Document { .. } => 0,
            Source::Journals { rows, .. } => rows.dropped,
        })
    }

    /// Runs of which two journals say different things, so far.
    #[getter]
    fn unlike(&self, py: Python<'_>) -> usize {
        py.detach(|| match &*self.0.lock().unwrap_or_else(PoisonError::into_inner) {
            Source::Document { .. } => 0,
            Source::Journals { rows, .. } => rows.unlike,
        })
    }

    /// Runs of the comparison that no journal has had so far; 0 of a document.
    #[getter]
    fn missing(&self, py: Python<'_>) -> usize {
        py.detach(|| match &*self.0.lock().unwrap_or_else(PoisonError::into_inner) {
            Source::Document { .. } => 0,
            Source::Journals { rows, .. } => rows.missing(),
        })
    }

    /// The next runs, at most so many: the lines of the table and those of their improvements, without heads, and how many runs they are.
    fn next(&self, py: Python<'_>, most: usize) -> PyResult<(String, String, usize)> {
        let read = py.detach(|| {
            let mut source = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            let (mut lines, mut traces, mut count) = (String::new(), String::new(), 0);
            while count < most {
                let Some(row) = source.next_row()? else { break };
                let comparison = source.comparison();
                lines += &line(comparison, &row);
                lines.push('\n');
                traces += &trace_lines(comparison, &row);
                count += 1;
            }
            Ok::<_, Refusal>((lines, traces, count))
        });
        Ok(read?)
    }
}

impl Source {
    fn comparison(&self) -> &Comparison {
        match self {
            Self::Document { rows, .. } => &rows.comparison,
            Self::Journals { comparison, .. } => comparison,
        }
    }

    fn next_row(&mut self) -> Result<Option<Row>, Refusal> {
        let (rows, open, left) = match self {
            Self::Document { path, rows } => return rows.next_row().map_err(|error| stored(path, error)),
            Self::Journals { rows, open, left, .. } => (rows, open, left),
        };
        loop {
            if open.is_none() {
                let Some(path) = left.pop_front() else { return Ok(None) };
                *open = Some((path.clone(), opened(&path)?));
            }
            let Some((path, source)) = open else { continue };
            match rows.next_row(source).map_err(|error| stored(path, error))? {
                Some(row) => return Ok(Some(row)),
                None => *open = None,
            }
        }
    }
}

fn opened(path: &str) -> Result<BufReader<File>, Refusal> {
    File::open(path).map(BufReader::new).map_err(|error| Refusal::file(path, format!("cannot read {path}: {error}")))
}
