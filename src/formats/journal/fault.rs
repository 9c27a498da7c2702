//! What is wrong with a journal or one of its lines.

use serde::Serialize;
use thiserror::Error;

/// Why a journal, or a line of one, does not count.
#[derive(Debug, Clone, PartialEq, Eq, Error, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum JournalFault {
    /// The file is something else.
    #[error("is no journal of this program")]
    NoJournal,
    /// A version that this engine does not read.
    #[error("is a journal of another version, `{found}`")]
    OtherVersion {
        /// What it says.
        found: String,
    },
    /// Another engine did the runs.
    #[error("was made by engine {found}, this one is {here}: its runs may have other bits")]
    OtherEngine {
        /// Its version.
        found: String,
        /// The version of the one that reads.
        here: &'static str,
    },
    /// Question or maps are others.
    #[error("is of another question or of other maps: their digest is {found}, here it is {here}")]
    OtherQuestion {
        /// Their digest.
        found: String,
        /// The digest of the comparison that reads.
        here: String,
    },
    /// Its end is missing, as a killed process leaves it.
    #[error("is cut off")]
    Cut,
    /// It ends as lines of Windows do: somebody has copied it as a text.
    #[error("has the line ends of Windows, CR LF: copy the file as it is, not as a text")]
    LineEnds,
    /// It does not have the check sum that it carries.
    #[error("is damaged or was changed: its check sum does not hold")]
    Damaged,
    /// The sum holds, and the run is not written as this engine writes it.
    #[error("was changed: its check sum holds, but no engine writes a run like this")]
    Changed,
    /// It names a run that the comparison does not have.
    #[error("is of a run that the question does not ask for")]
    NoSuchRun,
}
