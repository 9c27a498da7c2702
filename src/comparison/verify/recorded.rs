//! What is written down of runs, so that others can tell whether theirs are the same.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::catalog;
use crate::comparison::Comparison;
use crate::comparison::json;
use crate::comparison::question::{Entry, Question};
use crate::comparison::row::{Found, Row, Task};
use crate::digest::Digest;
use crate::params::Values;

/// Between the versions of engines whose runs were put together.
const MIXED: &str = " and ";

/// What the runs were made with, and what came out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Recorded {
    /// The engine's version; more than one where runs of several were put together.
    pub engine: String,
    /// Digest over question and maps, 16 hexadecimal digits; its name in files is older than ours.
    #[serde(rename = "experiment")]
    pub comparison: String,
    /// For each entry every parameter's value, also those that nobody has set; none where nothing is run.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "(Record<string, number | string | boolean> | null)[]"))]
    pub parameters: Vec<Option<Values>>,
    /// For each instance and entry how many runs were done, and the digest over them; none where there is none.
    pub runs: Vec<Vec<Option<Runs>>>,
}

/// The first runs of an entry on a map, told apart from any other ones.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Runs {
    /// How many, from the question's first seed on without a gap: a comparison that was broken off may have others too.
    pub count: u32,
    /// Over their rows, 16 hexadecimal digits.
    pub digest: String,
}

impl Recorded {
    /// What is written down of a comparison and its runs, so that others can tell whether theirs are the same.
    pub fn of(comparison: &Comparison, rows: &[Row]) -> Self {
        let q = &comparison.question;
        let rows = by_task(rows);
        let of_instance = |i| (0..q.entries.len()).map(|e| Runs::first(q.seeds.count, q.seeds.from, &rows, (i, e))).collect();
        Self {
            engine: env!("CARGO_PKG_VERSION").into(),
            comparison: comparison.digest().hex(),
            parameters: parameters(q),
            runs: (0..q.instances.len()).map(of_instance).collect(),
        }
    }

    /// Some of the runs are another's, and nobody has done them again.
    pub fn with_runs_of(self, other: &Recorded) -> Self {
        let mut engine = other.engine.clone();
        if !engine.split(MIXED).any(|version| version == self.engine) {
            engine = [engine.as_str(), &self.engine].join(MIXED);
        }
        Self { engine, ..self }
    }

    pub(super) fn runs(&self, (instance, entry): (usize, usize)) -> Option<&Runs> {
        self.runs.get(instance)?.get(entry)?.as_ref()
    }
}

pub(super) type ByTask<'a> = BTreeMap<Task, &'a Row>;

pub(super) fn by_task(rows: &[Row]) -> ByTask<'_> {
    rows.iter().map(|row| (row.task, row)).collect()
}

pub(super) fn parameters(question: &Question) -> Vec<Option<Values>> {
    let of = |e: &Entry| {
        let planner = e.planner.as_deref()?;
        catalog::values(planner, e.preset.as_deref(), &e.set).ok()
    };
    question.entries.iter().map(of).collect()
}

impl Runs {
    /// The runs of an entry on an instance from a seed on, as far as there is no gap; at most so many.
    pub(super) fn first(most: u32, from: u32, rows: &ByTask, (instance, entry): (usize, usize)) -> Option<Self> {
        let row = |i| rows.get(&Task { instance, entry, seed: from.checked_add(i)? });
        let mut digest = Digest::default();
        let count = (0..most).map_while(row).map(|row| digest.bytes(recorded(row).as_bytes())).count() as u32;
        (count > 0).then(|| Self { count, digest: digest.hex() })
    }
}

pub(super) fn digest(row: &Row) -> String {
    let mut digest = Digest::default();
    digest.bytes(recorded(row).as_bytes());
    digest.hex()
}

/// What digests are over: a row without its clearance, which follows from the path and is not in older records.
fn recorded(row: &Row) -> String {
    json(&without_clearance(row.clone()))
}

fn without_clearance(row: Row) -> Row {
    Row { found: row.found.map(|found| Found { clearance: None, ..found }), ..row }
}

/// Whether a run came out as it was recorded; what the record does not tell is not compared.
pub(super) fn is_same(then: &Row, now: &Row) -> bool {
    let tells = then.found.is_some_and(|found| found.clearance.is_some());
    if tells { then == now } else { *then == without_clearance(now.clone()) }
}
