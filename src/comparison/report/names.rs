//! How entries are named: that results are from elsewhere, and that some cannot be, stays with the name wherever it stands.

use std::borrow::Cow;

use crate::comparison::analysis::{EntryAnalysis, MapAnalysis, Origin};
use crate::comparison::question::Entry;

/// Behind the name of an entry that has impossible runs on the map; explained below every table that has it.
pub(super) const MARK: &str = " †";

/// An entry's name in tables.
pub(super) fn asked_name(entry: &Entry) -> Cow<'_, str> {
    named(&entry.label, entry.results.is_some())
}

/// The same of an entry on one map, with the mark of what is impossible there.
pub(super) fn name(entry: &EntryAnalysis) -> Cow<'_, str> {
    marked(named(&entry.label, entry.origin == Origin::Results), entry)
}

/// Its id in the same way, for tables that have ids.
pub(super) fn id(entry: &EntryAnalysis) -> Cow<'_, str> {
    marked(named(&entry.id, entry.origin == Origin::Results), entry)
}

pub(super) fn named(name: &str, is_from_elsewhere: bool) -> Cow<'_, str> {
    if is_from_elsewhere { Cow::Owned(format!("{name} (from elsewhere)")) } else { Cow::Borrowed(name) }
}

fn marked<'a>(name: Cow<'a, str>, entry: &EntryAnalysis) -> Cow<'a, str> {
    if entry.impossible > 0 { Cow::Owned(format!("{name}{MARK}")) } else { name }
}

/// What the mark means on a map; empty where nothing is impossible.
pub(super) fn impossible_note(map: &MapAnalysis) -> String {
    let wrong: Vec<String> = map.entries.iter().filter(|e| e.impossible > 0).map(of_entry).collect();
    if wrong.is_empty() {
        return String::new();
    }
    format!(
        "†: impossible on this map, better than the proven optimum: {}; so it is not ranked, tested or set in bold",
        wrong.join(", ")
    )
}

fn of_entry(e: &EntryAnalysis) -> String {
    format!("{} of {} runs of {}", e.impossible, e.runs, named(&e.label, e.origin == Origin::Results))
}
