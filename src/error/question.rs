//! What is wrong with a question.

use thiserror::Error;

use super::{ErrorReport, ParamError};

/// A question cannot be asked as it is written.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum QuestionError {
    /// It is of another version, or something else.
    #[error("`format` is `{found}`")]
    Version {
        /// What it says.
        found: String,
        /// What is understood.
        expected: &'static str,
    },
    /// A field does not fit.
    #[error("{field} = {value} cannot be used: it must be {allowed}")]
    Field {
        /// Where it stands, e.g. `claims.shorter.baseline`.
        field: String,
        /// What stands there.
        value: String,
        /// What may stand there.
        allowed: String,
    },
    /// The catalog refuses an entry.
    #[error("entries.{entry}: {error}")]
    Planner {
        /// The entry's id.
        entry: String,
        /// Why.
        error: Box<ParamError>,
    },
}

impl QuestionError {
    /// The catalog refuses the entry of this id.
    pub(crate) fn planner(entry: &str, error: ParamError) -> Self {
        Self::Planner { entry: entry.into(), error: Box::new(error) }
    }

    /// A field does not fit.
    pub(crate) fn field(field: impl Into<String>, value: impl ToString, allowed: impl Into<String>) -> Self {
        Self::Field { field: field.into(), value: value.to_string(), allowed: allowed.into() }
    }

    /// A run that the question does not ask for.
    pub(crate) fn outside(field: &str) -> Self {
        Self::field(format!("task.{field}"), "outside", "one of the question's runs")
    }

    /// The flat form.
    pub fn report(&self) -> ErrorReport {
        let message = self.to_string();
        match self {
            Self::Version { found, expected } => {
                ErrorReport::new("version", "format", message, format!("this engine reads `{expected}`")).with("value", found)
            }
            Self::Field { field, value, allowed } => {
                ErrorReport::new("question-field", field, message, format!("give {allowed}")).with("value", value)
            }
            Self::Planner { entry, error } => {
                let report = error.report();
                let whole = ErrorReport::new(&report.kind, format!("entries.{entry}.{}", report.field), message, report.hint);
                ErrorReport { args: report.args, ..whole }
            }
        }
    }
}
