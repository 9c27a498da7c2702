//! What a file of results has to do with a question, before it is joined: whose runs, on which of its maps, and which on none of them.

use serde::Serialize;

use super::join::find;
use super::{ImportedEntry, ImportedResults};
use crate::comparison::Comparison;

/// What of a file belongs where.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Matched {
    /// Runs in the file.
    pub runs: u32,
    /// Whose runs they are.
    pub entries: Vec<MatchedEntry>,
    /// Maps that stand in the file; empty where it names none.
    pub maps: Vec<MatchedMap>,
    /// Runs that name no map.
    pub unnamed: u32,
}

/// An entry of the file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatchedEntry {
    /// Its name in the file.
    pub label: String,
    /// Its runs.
    pub runs: u32,
    /// Those that found a path.
    pub with_path: u32,
}

/// A map that the file names.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatchedMap {
    /// Its name in the file.
    pub name: String,
    /// Runs on it.
    pub runs: u32,
    /// The id of the question's instance that is meant; none where no instance is called so.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "string | null"))]
    pub instance: Option<String>,
}

/// Looks for the maps of a file among those of a comparison.
pub fn matched(comparison: &Comparison, results: &ImportedResults) -> Matched {
    let runs = || results.entries.iter().flat_map(|entry| &entry.runs);
    let mut counts = vec![0; results.instances.len()];
    runs().filter_map(|run| run.instance).for_each(|instance| counts[instance] += 1);
    let map = |(name, runs): (&String, u32)| {
        let instance = find(comparison, name).map(|place| comparison.question.instances[place].id.clone());
        MatchedMap { name: name.clone(), runs, instance }
    };
    Matched {
        runs: results.runs() as u32,
        entries: results.entries.iter().map(entry).collect(),
        maps: results.instances.iter().zip(counts).map(map).collect(),
        unnamed: runs().filter(|run| run.instance.is_none()).count() as u32,
    }
}

fn entry(entry: &ImportedEntry) -> MatchedEntry {
    let with_path = entry.runs.iter().filter(|run| !run.steps.is_empty()).count() as u32;
    MatchedEntry { label: entry.label.clone(), runs: entry.runs.len() as u32, with_path }
}
