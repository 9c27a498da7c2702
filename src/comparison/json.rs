//! Plain data as JSON.

use serde::Serialize;

/// A value of this module as JSON, on one line. For plain data alone: numbers, texts, lists, and objects whose keys are texts. Writing them
/// cannot fail, so that a failure is a mistake in the code; it must not be hidden in a digest or a file.
pub(crate) fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("plain data with texts for keys can always be written as JSON")
}
