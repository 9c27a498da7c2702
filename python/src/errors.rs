//! Errors of the engine as exceptions of `formicarium.errors`.

use formicarium::cli::shared::CliError;
use formicarium::error::{Error, ErrorReport};
use formicarium::formats::comparison_rows::RowsError;
use pyo3::prelude::*;

/// What was refused, and the exception that says so.
pub struct Refusal {
    class: &'static str,
    report: Box<ErrorReport>,
}

impl Refusal {
    /// An argument that is none.
    pub fn argument(field: &str, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self { class: "ArgumentError", report: ErrorReport::new("bad-argument", field, message, hint).into() }
    }

    /// A file that cannot be read or written.
    pub fn file(path: &str, message: impl ToString) -> Self {
        let hint = "check the name, and that the file may be read";
        Self { class: "FileError", report: ErrorReport::new("file", path, message.to_string(), hint).into() }
    }
}

impl<E: Into<Error>> From<E> for Refusal {
    fn from(error: E) -> Self {
        let error = error.into();
        Self { class: class(&error), report: error.report().into() }
    }
}

/// The exception of an engine's error.
fn class(error: &Error) -> &'static str {
    match error {
        Error::Param(_) => "ParamError",
        Error::Scenario(_) => "ScenarioError",
        Error::Format(_) => "FormatError",
        Error::Question(_) => "QuestionError",
    }
}

/// What the command line says.
pub fn said(error: &CliError) -> Refusal {
    let class = match error {
        CliError::Engine(error) | CliError::Contents { error, .. } => class(error),
        CliError::File { .. } => "FileError",
        // Arguments that do not go together, and what only single commands say.
        _ => "ArgumentError",
    };
    Refusal { class, report: error.report().into() }
}

/// What a stored comparison says.
pub fn stored(path: &str, error: RowsError) -> Refusal {
    match error {
        RowsError::Io(error) => Refusal::file(path, format!("cannot read {path}: {error}")),
        RowsError::Contents(error) => {
            let mut refusal = Refusal::from(error);
            refusal.report.message = format!("{path}: {}", refusal.report.message);
            refusal
        }
    }
}

impl From<Refusal> for PyErr {
    fn from(Refusal { class, report }: Refusal) -> Self {
        let ErrorReport { kind, field, message, hint, .. } = *report;
        Python::attach(|py| {
            let made = || {
                let class = py.import("formicarium.errors")?.getattr(class)?;
                class.call1((kind, field, message, hint))
            };
            made().map_or_else(|error| error, PyErr::from_value)
        })
    }
}
