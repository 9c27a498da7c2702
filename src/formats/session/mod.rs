//! A session as the page saves it: a file (`formicarium/experiment@1`, `@2` or `@3`), or the text of a link behind `#x=`. Read is what its runs
//! depend on; how they were looked at is left to the page. docs/formats.md describes both.

mod bytes;
mod cell_numbers;
mod container;
mod document;
mod envelope;
mod link_text;
mod rows;
mod told_length;

use serde::{Deserialize, Serialize};

use crate::comparison::best_known::RecordedRun;
use crate::error::{Error, FormatError, ScenarioError};
use crate::map::{Generator, Grid, generate};
use crate::params::Values;
use crate::scenario::ScenarioSpec;

/// What stands before the text of a session's link, in an address of the page.
pub const LINK_PREFIX: &str = "#x=";

/// A session, as far as its runs depend on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Session {
    /// Version of the engine that wrote it.
    pub engine: String,
    /// The map before all changes.
    pub grid: Grid,
    /// What is asked on the map.
    pub spec: ScenarioSpec,
    /// The call that made the map, before anybody edited it.
    pub origin: Option<Origin>,
    /// How often walls changed while the planners ran.
    pub changes: usize,
    /// The planners that race.
    pub panels: Vec<Panel>,
    /// The seed of every panel.
    pub seed: u32,
}

/// The call that makes a map.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Origin {
    /// Which generator.
    pub generator: Generator,
    /// Its seed.
    pub seed: u32,
    /// Density of obstacles, or roughness: 0 to [`crate::map::MAX_DENSITY`].
    pub density: f64,
}

impl Origin {
    /// The map that it makes, in the size of a scenario.
    ///
    /// # Errors
    /// [`ScenarioError::Quantity`] for a density that the generator does not take.
    pub fn make(&self, spec: &ScenarioSpec) -> Result<Grid, ScenarioError> {
        generate(self.generator, spec.width, spec.height, self.seed, self.density).map(|made| made.grid)
    }
}

/// One planner of a session.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Panel {
    /// Its id in the catalog.
    pub planner: String,
    /// The preset that `params` are from: a name alone, for `params` has its values.
    pub preset: Option<String>,
    /// All values that differ from the planner's defaults.
    pub params: Values,
    /// What its run had come to; none where nothing is recorded.
    pub result: Option<RecordedRun>,
}

/// Reads a session's file.
///
/// # Errors
/// [`FormatError`] with the line of broken JSON or the field at fault, [`crate::error::ScenarioError`] for a scenario that cannot be used.
pub fn read_session(text: &str) -> Result<Session, Error> {
    rows::read(text)
}

/// Reads a session's link: an address or any text with [`LINK_PREFIX`] in it, or what stands behind it alone. What mail and chat make of
/// links is understood: signs as codes, broken lines, what follows an address.
///
/// # Errors
/// [`FormatError`] for a damaged link, which says how much is missing where it can, one of a newer version, or one that holds something
/// else; as [`read_session`] for what is in it.
pub fn read_session_link(text: &str) -> Result<Session, Error> {
    let text = text.trim();
    let words = match link_text::words_of_link(text) {
        Some(words) => words,
        None if text.contains(['#', '/']) => {
            let expected = format!("an address with `{LINK_PREFIX}`, as the page's share dialog makes it");
            return Err(FormatError::field("link", "it holds no session", expected).into());
        }
        None => text.split_whitespace().map(String::from).collect(),
    };
    container::unpack(&envelope::open(&words)?)
}

/// A session's link and what it holds: from [`LINK_PREFIX`] on, as it was before programs broke it, without what stands around it.
///
/// # Errors
/// As [`read_session_link`].
pub fn session_link_in(text: &str) -> Result<(String, Session), Error> {
    let words = link_text::words_of_link(text).unwrap_or_default();
    let whole = (1..=words.len()).find_map(|count| {
        let link = words[..count].concat();
        read_session_link(&link).ok().map(|session| (format!("{LINK_PREFIX}{link}"), session))
    });
    whole.map_or_else(|| read_session_link(text).map(|session| (text.trim().to_owned(), session)), Ok)
}

/// Whether a text has a session's link in it, as [`read_session_link`] finds it.
#[must_use]
pub fn has_session_link(text: &str) -> bool {
    link_text::words_of_link(text).is_some()
}

/// A session as the text of a link, from [`LINK_PREFIX`] on. The map is its generator call where that makes it, else all of its cells.
///
/// # Errors
/// [`FormatError::TooLarge`] for a map with more heights or factors than a link carries.
pub fn write_session_link(session: &Session) -> Result<String, FormatError> {
    Ok(format!("{LINK_PREFIX}{}", envelope::seal(&container::pack(session)?)))
}

const CHANGED: &str = "its checksum says that it is not the same as when it was made";

/// A link that is not what it was when it was made.
fn damaged(what: &str) -> FormatError {
    FormatError::field("link", format!("it is damaged: {what}"), "the whole address, as the share dialog copies it")
}

#[cfg(test)]
mod tests;
