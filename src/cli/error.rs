//! What goes wrong on a command line.

use std::io;

use crate::error::{BestKnownError, Error, ErrorReport, FormatError, ParamError, ScenarioError};
use thiserror::Error;

/// Any failure that ends with exit code 2.
#[derive(Debug, Error)]
pub enum CliError {
    /// The engine refuses its input.
    #[error(transparent)]
    Engine(#[from] Error),
    /// A claim to be the best known does not hold.
    #[error(transparent)]
    BestKnown(#[from] BestKnownError),
    /// A file's contents cannot be used.
    #[error("{path}: {error}")]
    Contents {
        /// The file.
        path: String,
        /// What is wrong in it.
        error: Error,
    },
    /// A file cannot be read or written.
    #[error("cannot {action} {path}: {error}")]
    File {
        /// `read` or `write`.
        action: &'static str,
        /// The file.
        path: String,
        /// What the system says.
        error: io::Error,
    },
    /// The arguments do not go together.
    #[error("{message}")]
    Usage {
        /// What is wrong.
        message: String,
        /// What to do instead.
        hint: String,
    },
}

impl CliError {
    /// The arguments do not go together.
    pub fn usage(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::Usage { message: message.into(), hint: hint.into() }
    }

    /// The flat form, with the sentence as the command line says it.
    pub fn report(&self) -> ErrorReport {
        let message = self.to_string();
        let report = match self {
            Self::Engine(error) | Self::Contents { error, .. } => error.report(),
            Self::BestKnown(error) => error.report(),
            Self::File { path, action, .. } => {
                let hint = if *action == "read" {
                    "check the name, and that the file may be read"
                } else {
                    "check that the folder exists and may be written, and that there is space left"
                };
                ErrorReport::new("file", path, "", hint)
            }
            Self::Usage { hint, .. } => ErrorReport::new("usage", "arguments", "", hint),
        };
        ErrorReport { message, ..report }
    }
}

impl From<ParamError> for CliError {
    fn from(error: ParamError) -> Self {
        Self::Engine(error.into())
    }
}

impl From<ScenarioError> for CliError {
    fn from(error: ScenarioError) -> Self {
        Self::Engine(error.into())
    }
}

impl From<FormatError> for CliError {
    fn from(error: FormatError) -> Self {
        Self::Engine(error.into())
    }
}
