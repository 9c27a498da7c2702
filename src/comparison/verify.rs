//! Whether recorded runs come out again, and what may be the cause where they do not.
//!
//! A document with its runs is compared row by row, so that any part of it can be tried; one without them, as a link carries it, by digests
//! over the first runs of each entry on each map.

mod deviation;
mod recorded;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;

use serde::Serialize;
use serde_json::Value as Json;

use super::Comparison;
use super::question::Question;
use super::row::{Row, Task};
use crate::params::Values;

pub use deviation::Deviation;
use recorded::{ByTask, by_task, digest, is_same, parameters};
pub use recorded::{Recorded, Runs};

/// How far a result has been verified.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Verification {
    /// Pairs of instance and entry whose runs are all done again and are the same, bit for bit.
    pub same: u32,
    /// Pairs whose runs are not all done again, as far as these do not differ.
    pub open: u32,
    /// Recorded runs that were done again and are the same, bit for bit.
    pub runs: u32,
    /// Recorded runs.
    pub of: u32,
    /// Whether something recorded did not happen: the file's runs were changed, or runs differ though version, question, maps and parameters
    /// are the same.
    pub refuted: bool,
    /// Every difference, possible causes first.
    pub deviations: Vec<Deviation>,
}

/// What a document tells of runs that are done, for comparison with runs here.
#[derive(Debug, Clone)]
pub struct Record {
    recorded: Option<Recorded>,
    /// Digest over question and maps as the document has them.
    comparison: String,
}

impl Record {
    /// `comparison` as the document has it.
    pub(crate) fn new(comparison: &Comparison, recorded: Option<Recorded>) -> Self {
        Self { recorded, comparison: comparison.digest().hex() }
    }

    /// What was recorded with the runs; none where nothing had been run, or a document has runs alone.
    pub fn recorded(&self) -> Option<&Recorded> {
        self.recorded.as_ref()
    }

    /// Compares what was recorded, and the rows that the document has, with rows of runs that were done here, as far as they are.
    /// `comparison` may ask for fewer seeds than the document.
    pub fn verify(&self, comparison: &Comparison, then: &[Row], now: &[Row]) -> Verification {
        let [then, now] = [then, now].map(by_task);
        let mut told = Verification { deviations: self.causes(comparison), ..Verification::default() };
        let explained = !told.deviations.is_empty();
        for instance in 0..comparison.question.instances.len() {
            for entry in 0..comparison.question.entries.len() {
                self.compare(comparison, [&then, &now], (instance, entry), &mut told);
            }
        }
        let is_refuting = |d: &Deviation| matches!(d, Deviation::Edited { .. }) || (!explained && !d.is_cause());
        told.refuted = told.deviations.iter().any(is_refuting);
        told
    }

    fn is_same_question(&self) -> bool {
        self.recorded.as_ref().is_none_or(|then| then.comparison == self.comparison)
    }

    fn causes(&self, comparison: &Comparison) -> Vec<Deviation> {
        let Some(then) = &self.recorded else { return Vec::new() };
        let mut causes = Vec::new();
        let version = env!("CARGO_PKG_VERSION");
        if then.engine != version {
            causes.push(Deviation::Version { recorded: then.engine.clone(), now: version.into() });
        }
        if !self.is_same_question() {
            causes.push(Deviation::Comparison { recorded: then.comparison.clone(), now: self.comparison.clone() });
        }
        let none = Values::new();
        let now = parameters(&comparison.question);
        for ((entry, then), now) in comparison.question.entries.iter().zip(&then.parameters).zip(&now) {
            changed(&entry.id, then.as_ref().unwrap_or(&none), now.as_ref().unwrap_or(&none), &mut causes);
        }
        causes
    }

    fn compare(&self, comparison: &Comparison, [brought, now]: [&ByTask; 2], pair: (usize, usize), told: &mut Verification) {
        let (instance, entry) = pair;
        let of_pair = |seed| Task { instance, entry, seed };
        let then: Vec<&Row> = brought.range(of_pair(0)..=of_pair(u32::MAX)).map(|(_, row)| *row).collect();
        let noted = self.recorded.as_ref().and_then(|r| r.runs(pair));
        told.of += noted.map_or(then.len(), |runs| (runs.count as usize).max(then.len())) as u32;
        let seeds = comparison.question.seeds;
        let is_noted = |runs: &Runs| Runs::first(runs.count, seeds.from, brought, pair).as_ref() == Some(runs);
        let edited = self.is_same_question() && !then.is_empty() && !noted.is_none_or(is_noted);
        if edited {
            let [instance, entry] = names(comparison, pair);
            told.deviations.push(Deviation::Edited { instance, entry });
        }
        match noted {
            Some(runs) if then.is_empty() || edited => told.by_digest(comparison, now, pair, runs),
            _ if then.is_empty() => {}
            _ => told.by_row(comparison, now, pair, &then),
        }
    }
}

fn names(comparison: &Comparison, (instance, entry): (usize, usize)) -> [String; 2] {
    let Question { instances, entries, .. } = &comparison.question;
    [instances[instance].id.clone(), entries[entry].id.clone()]
}

impl Verification {
    fn by_digest(&mut self, comparison: &Comparison, now: &ByTask, pair: (usize, usize), then: &Runs) {
        match Runs::first(then.count, comparison.question.seeds.from, now, pair) {
            Some(now) if now == *then => {
                self.same += 1;
                self.runs += then.count;
            }
            Some(now) if now.count == then.count => {
                let [instance, entry] = names(comparison, pair);
                let [recorded, now] = [then.digest.clone(), now.digest];
                self.deviations.push(Deviation::Bits { instance, entry, seed: None, differing: None, recorded, now });
            }
            _ => self.open += 1,
        }
    }

    fn by_row(&mut self, comparison: &Comparison, now: &ByTask, pair: (usize, usize), then: &[&Row]) {
        let done: Vec<(&Row, &Row)> = then.iter().filter_map(|then| Some((*then, *now.get(&then.task)?))).collect();
        let different: Vec<_> = done.iter().filter(|(then, now)| !is_same(then, now)).collect();
        self.runs += (done.len() - different.len()) as u32;
        match different.first() {
            Some((then, now)) => {
                let [instance, entry] = names(comparison, pair);
                let differing = Some(different.len() as u32);
                let [recorded, now] = [then, now].map(|row| digest(row));
                self.deviations.push(Deviation::Bits { instance, entry, seed: Some(then.task.seed), differing, recorded, now });
            }
            None if done.len() == then.len() => self.same += 1,
            None => self.open += 1,
        }
    }
}

fn changed(entry: &str, then: &Values, now: &Values, out: &mut Vec<Deviation>) {
    let keys: BTreeSet<&String> = then.keys().chain(now.keys()).collect();
    for key in keys.into_iter().filter(|key| then.get(*key) != now.get(*key)) {
        let [recorded, now] = [then, now].map(|values| values.get(key).map_or(Json::Null, |v| serde_json::json!(v)));
        out.push(Deviation::Parameter { entry: entry.into(), key: key.clone(), recorded, now });
    }
}
