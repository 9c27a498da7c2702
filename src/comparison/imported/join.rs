//! Imported results, joined to a question: each entry of a file becomes an entry that is compared and never run.

use std::collections::BTreeSet;

use super::{ImportedEntry, ImportedResults, ImportedRun};
use crate::comparison::Comparison;
use crate::comparison::measure::RunMeasure;
use crate::comparison::names::stem;
use crate::comparison::question::{Entry, Role};
use crate::comparison::row::{Found, Improvement, Row, Spent, Task};
use crate::error::QuestionError;

/// Adds every entry of a file that has runs. `instance` says which map runs are on that name none, and the runs of a file that names a single one; without
/// it runs that name none are on the question's only map.
///
/// # Errors
/// [`QuestionError`] for a map that the question does not have, a seed that stands twice, and a length where a cost is asked for.
pub fn join(comparison: Comparison, results: &ImportedResults, instance: Option<usize>) -> Result<Comparison, QuestionError> {
    let places = Places::of(&comparison, results, instance)?;
    let (mut question, mut rows) = (comparison.question.clone(), comparison.imported.clone());
    for entry in results.entries.iter().filter(|entry| !entry.runs.is_empty()) {
        let index = question.entries.len();
        rows.extend(places.rows(&comparison, entry, index)?);
        question.entries.push(joined_entry(entry, &results.file, &question.entries));
    }
    let scenarios = comparison.maps.iter().map(|m| m.scenario.clone()).collect();
    Comparison::new(question, scenarios)?.with_imported(rows)
}

/// The entry of a question that an entry of a file becomes, told apart from those that there are.
fn joined_entry(imported: &ImportedEntry, file: &str, entries: &[Entry]) -> Entry {
    let is_taken = entries.iter().any(|e| e.label == imported.label);
    Entry {
        id: unique(&imported.id, entries),
        label: if is_taken { format!("{} ({file})", imported.label) } else { imported.label.clone() },
        role: Role::Other,
        planner: None,
        missing: None,
        results: Some(file.into()),
        preset: None,
        set: Default::default(),
        first_stage: None,
        published: Default::default(),
    }
}

/// Gives an entry of the question that has `results` its runs: those of the file's entry of the same id or name, or of its only one.
///
/// # Errors
/// As [`join`], and for a file in which several entries stand and none is called like it.
pub fn fill(mut comparison: Comparison, entry: usize, results: &ImportedResults) -> Result<Comparison, QuestionError> {
    let places = Places::of(&comparison, results, None)?;
    let asked = comparison.question.entries.get(entry).ok_or_else(|| QuestionError::outside("entry"))?;
    let called = |e: &&ImportedEntry| e.id == asked.id || alike(&e.label, &asked.id) || alike(&e.label, &asked.label);
    let only = match &results.entries[..] {
        [only] => Some(only),
        _ => None,
    };
    let meant = results.entries.iter().find(called).or(only).ok_or_else(|| {
        let names = results.entries.iter().map(|e| e.label.clone()).collect::<Vec<_>>().join(", ");
        let allowed = format!("a file of one entry, or one in which this entry stands by its id or label; it has {names}");
        QuestionError::field(format!("entries.{}.results", asked.id), &results.file, allowed)
    })?;
    let rows = places.rows(&comparison, meant, entry)?;
    let mut imported = std::mem::take(&mut comparison.imported);
    imported.extend(rows);
    comparison.with_imported(imported)
}

/// On which instance of the question the runs of a file are.
struct Places {
    /// For each name of a map in the file.
    named: Vec<usize>,
    /// Of runs that name none.
    unnamed: Option<usize>,
    /// Ids of the question's instances, for errors.
    known: String,
}

impl Places {
    fn of(comparison: &Comparison, results: &ImportedResults, instance: Option<usize>) -> Result<Self, QuestionError> {
        let known: Vec<&str> = comparison.question.instances.iter().map(|i| i.id.as_str()).collect();
        let known = known.join(", ");
        if instance.is_some_and(|i| i >= comparison.maps.len()) {
            return Err(QuestionError::field("results.instance", "outside", format!("one of {known}")));
        }
        let single = results.instances.len() == 1;
        let place = |name: &String| {
            let found = find(comparison, name).or(instance.filter(|_| single));
            found.ok_or_else(|| QuestionError::field("results.instance", name, format!("one of {known}")))
        };
        let named = results.instances.iter().map(place).collect::<Result<_, _>>()?;
        let unnamed = instance.or((comparison.maps.len() == 1).then_some(0));
        Ok(Self { named, unnamed, known })
    }

    /// The rows of an entry's runs.
    fn rows(&self, comparison: &Comparison, imported: &ImportedEntry, entry: usize) -> Result<Vec<Row>, QuestionError> {
        let mut seen = BTreeSet::new();
        let row = |run: &ImportedRun| {
            let place = run.instance.map_or(self.unnamed, |named| self.named.get(named).copied());
            let allowed = || format!("one of {}: the file does not say on which map its runs are", self.known);
            let instance = place.ok_or_else(|| QuestionError::field("results.instance", "absent", allowed()))?;
            let task = Task { instance, entry, seed: run.seed };
            if !seen.insert(task) {
                let allowed = format!("different for every run of {} on a map", imported.label);
                return Err(QuestionError::field("results.seed", run.seed, allowed));
            }
            let by_cost = comparison.maps[instance].measure() == RunMeasure::Cost;
            row(run, task, by_cost).ok_or_else(|| {
                let allowed = "a column `value` with the cost, which is what counts by slices and on weighted ground";
                QuestionError::field("results.value", "absent", allowed)
            })
        };
        imported.runs.iter().map(row).collect()
    }
}

/// The row of a run; none where a path has a length and no cost, which is what counts.
fn row(run: &ImportedRun, task: Task, by_cost: bool) -> Option<Row> {
    let (mut trace, mut found) = (Vec::new(), None::<Found>);
    for step in &run.steps {
        let value = step.compared(by_cost)?;
        if found.is_some_and(|best| best.value <= value) {
            continue;
        }
        let length = step.length.unwrap_or(value);
        found = Some(Found {
            length,
            turns: step.turns,
            turn_index: step.turn_index,
            weight: step.weight,
            value,
            clearance: None,
            driving: None,
        });
        if step.spent != Spent::default() {
            trace.push(Improvement { value, spent: step.spent });
        }
    }
    Some(Row { task, status: run.status, found, effort: run.effort, trace, digest: String::new() })
}

/// The instance that a name means: its id, its map's name or file, in small or large letters.
pub(super) fn find(comparison: &Comparison, name: &str) -> Option<usize> {
    let instances = &comparison.question.instances;
    let by_id = instances.iter().position(|i| alike(&i.id, name));
    let by_file = || instances.iter().position(|i| alike(&i.map, name) || alike(stem(&i.map), name) || alike(&i.id, stem(name)));
    by_id.or_else(|| comparison.maps.iter().position(|m| alike(&m.scenario.spec.name, name))).or_else(by_file)
}

fn alike(one: &str, other: &str) -> bool {
    !one.is_empty() && one.trim().to_lowercase() == other.trim().to_lowercase()
}

/// The id, or with the first number from 2 on that no entry has.
fn unique(id: &str, entries: &[Entry]) -> String {
    let taken: BTreeSet<&str> = entries.iter().map(|e| e.id.as_str()).collect();
    let free = |id: &String| !taken.contains(id.as_str());
    let numbered = (2..).map(|n| format!("{id}-{n}"));
    std::iter::once(id.to_owned()).chain(numbered).find(free).unwrap_or_else(|| id.to_owned())
}
