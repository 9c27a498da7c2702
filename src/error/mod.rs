//! What an operation answers when its input cannot be used: what is wrong, where, what is allowed, and what to do next.
//!
//! One enum per operation ([`ParamError`], [`ScenarioError`], [`FormatError`], [`QuestionError`]); [`Error`] is their sum, without
//! [`DrawnError`], which concerns nobody but a hand that draws, and [`BestKnownError`], which judges claims. Every variant can
//! be turned into an [`ErrorReport`], the flat form that crosses into the page, where `kind` is the key of a translated message.

#[cfg(feature = "whole")]
mod best_known;
mod drawn;
mod format;
mod param;
#[cfg(feature = "whole")]
mod question;
mod scenario;

use std::collections::BTreeMap;

use serde::Serialize;
use thiserror::Error;

#[cfg(feature = "whole")]
pub use best_known::BestKnownError;
pub use drawn::DrawnError;
pub use format::FormatError;
pub use param::ParamError;
#[cfg(feature = "whole")]
pub use question::QuestionError;
pub use scenario::ScenarioError;

/// The flat form of any error, for the page and for `--format json`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ErrorReport {
    /// Stable key of the message, e.g. `out-of-range`.
    pub kind: String,
    /// The field at fault, e.g. `rho`, `start`, `line 12`.
    pub field: String,
    /// The sentence in English.
    pub message: String,
    /// What to do next, in English.
    pub hint: String,
    /// Values for a translated message.
    pub args: BTreeMap<String, String>,
}

impl ErrorReport {
    /// A report without arguments.
    pub fn new(kind: &str, field: impl Into<String>, message: impl Into<String>, hint: impl Into<String>) -> Self {
        let [field, message, hint] = [field.into(), message.into(), hint.into()].map(shortened);
        Self { kind: kind.into(), field, message, hint, args: BTreeMap::new() }
    }

    /// Adds one argument of the translated message.
    #[must_use]
    pub fn with(mut self, name: &str, value: impl ToString) -> Self {
        self.args.insert(name.into(), shortened(value.to_string()));
        self
    }
}

/// Messages quote what they refuse: of a hostile file that may be a megabyte.
fn shortened(text: String) -> String {
    const LONGEST: usize = 1000;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

/// Any error of the engine.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Error {
    /// See [`ParamError`].
    #[error(transparent)]
    Param(#[from] ParamError),
    /// See [`ScenarioError`].
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// See [`FormatError`].
    #[error(transparent)]
    Format(#[from] FormatError),
    /// See [`QuestionError`].
    #[cfg(feature = "whole")]
    #[error(transparent)]
    Question(#[from] QuestionError),
}

impl Error {
    /// The flat form for the page and for JSON.
    pub fn report(&self) -> ErrorReport {
        match self {
            Self::Param(e) => e.report(),
            Self::Scenario(e) => e.report(),
            Self::Format(e) => e.report(),
            #[cfg(feature = "whole")]
            Self::Question(e) => e.report(),
        }
    }
}

/// Something worth saying about an input that was accepted all the same.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(hashmap_as_object))]
pub struct Notice {
    /// Stable key of the message.
    pub kind: String,
    /// The sentence in English.
    pub message: String,
    /// Values for a translated message.
    pub args: BTreeMap<String, String>,
}

impl Notice {
    /// A notice without arguments.
    pub fn new(kind: &str, message: impl Into<String>) -> Self {
        Self { kind: kind.into(), message: message.into(), args: BTreeMap::new() }
    }

    /// Adds one argument of the translated message.
    #[must_use]
    pub fn with(mut self, name: &str, value: impl ToString) -> Self {
        self.args.insert(name.into(), value.to_string());
        self
    }
}
