//! How entries are named: that results are from elsewhere, and that some cannot be, stays with the name wherever it stands.

use std::borrow::Cow;

use super::words::Words;
use crate::comparison::analysis::{EntryAnalysis, MapAnalysis, Origin};
use crate::comparison::question::Entry;

/// Behind the name of an entry that has impossible runs on the map; explained below every table that has it.
pub(super) const MARK: &str = " †";

/// An entry's name in tables.
pub(super) fn asked_name<'a>(words: &Words, entry: &'a Entry) -> Cow<'a, str> {
    named(words, &entry.label, entry.results.is_some())
}

/// The same of an entry on one map, with the mark of what is impossible there.
pub(super) fn name<'a>(words: &Words, entry: &'a EntryAnalysis) -> Cow<'a, str> {
    marked(named(words, &entry.label, entry.origin == Origin::Results), entry)
}

/// Its id in the same way, for tables that have ids.
pub(super) fn id<'a>(words: &Words, entry: &'a EntryAnalysis) -> Cow<'a, str> {
    marked(named(words, &entry.id, entry.origin == Origin::Results), entry)
}

pub(super) fn named<'a>(words: &Words, name: &'a str, is_from_elsewhere: bool) -> Cow<'a, str> {
    if is_from_elsewhere { Cow::Owned((words.names.from_elsewhere)(name)) } else { Cow::Borrowed(name) }
}

fn marked<'a>(name: Cow<'a, str>, entry: &EntryAnalysis) -> Cow<'a, str> {
    if entry.impossible > 0 { Cow::Owned(format!("{name}{MARK}")) } else { name }
}

/// What the mark means on a map; empty where nothing is impossible.
pub(super) fn impossible_note(words: &Words, map: &MapAnalysis) -> String {
    let of_entry = |e: &EntryAnalysis| {
        let name = named(words, &e.label, e.origin == Origin::Results);
        (words.names.impossible_runs)(&(words.signs.part_of)(e.impossible, e.runs), &name)
    };
    let wrong: Vec<String> = map.entries.iter().filter(|e| e.impossible > 0).map(of_entry).collect();
    if wrong.is_empty() { String::new() } else { (words.names.impossible)(&wrong.join(words.signs.list)) }
}
