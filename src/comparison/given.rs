//! Results from elsewhere, joined to a question: each entry of a file becomes an entry that is compared and never run.
//!
//! What a row holds is what the file tells: nothing is run again, and nobody can tell here whether its lengths follow the scenario's rules,
//! except where one is shorter than the exact optimum ([`Comparison::impossible`]). Seeds keep their numbers; runs are treated as pairs only
//! where both entries have the seed.

use std::collections::BTreeSet;

use super::check::QuestionError;
use super::question::{Entry, Role};
use super::row::{Found, Improvement, Row, Spent, Task};
use super::setting::Comparison;
use crate::formats::{ImportedEntry, ImportedResults, ImportedRun};

/// Adds every entry of a file. `instance` says which map runs are on that name none, and the runs of a file that names a single one; without
/// it runs that name none are on the question's only map.
///
/// # Errors
/// [`QuestionError`] for a map that the question does not have, a seed that stands twice, and a length where a cost by slices is asked for.
pub fn join(comparison: Comparison, results: &ImportedResults, instance: Option<usize>) -> Result<Comparison, QuestionError> {
    let places = Places::of(&comparison, results, instance)?;
    let (mut question, mut given) = (comparison.question.clone(), comparison.given.clone());
    for own in &results.entries {
        let index = question.entries.len();
        given.extend(places.rows(&comparison, own, index)?);
        let taken = |text: &str| question.entries.iter().any(|e| e.label == text);
        let label = if taken(&own.label) { format!("{} ({})", own.label, results.file) } else { own.label.clone() };
        let id = unique(&own.id, &question.entries);
        question.entries.push(Entry {
            id,
            label,
            role: Role::Other,
            planner: None,
            missing: None,
            results: Some(results.file.clone()),
            preset: None,
            set: Default::default(),
            published: Default::default(),
        });
    }
    let scenarios = comparison.maps.iter().map(|m| m.scenario.clone()).collect();
    Comparison::new(question, scenarios)?.with_given(given)
}

/// Gives an entry of the question that has `results` its runs: those of the file's entry of the same id or name, or of its only one.
///
/// # Errors
/// As [`join`], and for a file in which several entries stand and none is called like it.
pub fn fill(mut comparison: Comparison, entry: usize, results: &ImportedResults) -> Result<Comparison, QuestionError> {
    let places = Places::of(&comparison, results, None)?;
    let asked = comparison.question.entries.get(entry).ok_or_else(|| QuestionError::outside("entry"))?;
    let called = |own: &&ImportedEntry| own.id == asked.id || alike(&own.label, &asked.id) || alike(&own.label, &asked.label);
    let only = match &results.entries[..] {
        [only] => Some(only),
        _ => None,
    };
    let own = results.entries.iter().find(called).or(only).ok_or_else(|| {
        let names = results.entries.iter().map(|e| e.label.clone()).collect::<Vec<_>>().join(", ");
        let allowed = format!("a file of one entry, or one in which this entry stands by its id or label; it has {names}");
        QuestionError::field(format!("entries.{}.results", asked.id), &results.file, allowed)
    })?;
    let rows = places.rows(&comparison, own, entry)?;
    let mut given = std::mem::take(&mut comparison.given);
    given.extend(rows);
    comparison.with_given(given)
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
    fn rows(&self, comparison: &Comparison, own: &ImportedEntry, entry: usize) -> Result<Vec<Row>, QuestionError> {
        let mut seen = BTreeSet::new();
        let row = |run: &ImportedRun| {
            let place = run.instance.map_or(self.unnamed, |named| self.named.get(named).copied());
            let allowed = || format!("one of {}: the file does not say on which map its runs are", self.known);
            let instance = place.ok_or_else(|| QuestionError::field("results.instance", "absent", allowed()))?;
            let task = Task { instance, entry, seed: run.seed };
            if !seen.insert(task) {
                let allowed = format!("different for every run of {} on a map", own.label);
                return Err(QuestionError::field("results.seed", run.seed, allowed));
            }
            let by_slices = comparison.maps[instance].scenario.by_slices().is_some();
            row(run, task, by_slices).ok_or_else(|| {
                let allowed = "a column `value` with the cost by slices, which is what counts on this terrain";
                QuestionError::field("results.value", "absent", allowed)
            })
        };
        own.runs.iter().map(row).collect()
    }
}

/// The row of a run; none where a path has a length and no cost by slices.
fn row(run: &ImportedRun, task: Task, by_slices: bool) -> Option<Row> {
    let (mut trace, mut found) = (Vec::new(), None::<Found>);
    for step in &run.steps {
        let value = step.compared(by_slices)?;
        if found.is_some_and(|best| best.value <= value) {
            continue;
        }
        let length = step.length.unwrap_or(value);
        found = Some(Found { length, turns: step.turns, turn_index: step.turn_index, weight: step.weight, value });
        if step.spent != Spent::default() {
            trace.push(Improvement { value, spent: step.spent });
        }
    }
    Some(Row { task, status: run.status, found, effort: run.effort, trace, digest: String::new() })
}

/// The instance that a name means: its id, its map's name or file, in small or large letters.
fn find(comparison: &Comparison, name: &str) -> Option<usize> {
    let instances = &comparison.question.instances;
    let by_id = instances.iter().position(|i| alike(&i.id, name));
    let by_file = || instances.iter().position(|i| alike(&i.map, name) || alike(stem(&i.map), name) || alike(&i.id, stem(name)));
    by_id.or_else(|| comparison.maps.iter().position(|m| alike(&m.scenario.spec.name, name))).or_else(by_file)
}

fn alike(one: &str, other: &str) -> bool {
    !one.is_empty() && one.trim().to_lowercase() == other.trim().to_lowercase()
}

/// A file's name without folders and ending.
fn stem(file: &str) -> &str {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

/// The id, or with the first number from 2 on that no entry has.
fn unique(id: &str, entries: &[Entry]) -> String {
    let free = |id: &String| entries.iter().all(|e| e.id != *id);
    let numbered = (2..).map(|n| format!("{id}-{n}"));
    std::iter::once(id.to_owned()).chain(numbered).find(free).unwrap_or_else(|| id.to_owned())
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::question::{FORMAT, Measure, Question};
    use super::*;
    use crate::formats::import_results;
    use crate::map::{Grid, Point};
    use crate::planner::Status;
    use crate::scenario::{Scenario, ScenarioSpec};
    use serde_json::json;

    /// Two open maps, 6 × 5 and 9 × 1: their optima are 1 + 4√2 = 6.656854… and 8.
    fn comparison() -> Comparison {
        let question: Question = serde_json::from_value(json!({
            "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 2 },
            "instances": [{ "id": "open", "map": "open.json" }, { "id": "lane", "map": "long-lane.map" }],
            "entries": [
                { "id": "ants", "label": "Ants", "role": "other", "planner": "ant-system" },
                { "id": "mine", "label": "mine", "role": "other", "results": "m.csv" }
            ]
        }))
        .unwrap();
        let map = |width, height| {
            let grid = Grid::open(width, height).unwrap();
            let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(width - 1, height - 1));
            Arc::new(Scenario::new(grid, spec).unwrap())
        };
        Comparison::new(question, vec![map(6, 5), map(9, 1)]).unwrap()
    }

    fn results(text: &str) -> ImportedResults {
        import_results(text.as_bytes(), "folder/own.csv").unwrap()
    }

    fn refused(text: &str) -> String {
        join(comparison(), &results(text), None).unwrap_err().to_string()
    }

    #[test]
    fn entries_of_a_file_become_entries_with_rows() {
        let text = "entry,instance,seed,length,turns,iterations\nAnts,open,7,7.5,3,12\nAnts,LANE,7,8,0,1\nants,long-lane,3,,,\n";
        let joined = join(comparison(), &results(text), None).unwrap();
        let entries: Vec<_> = joined.question.entries.iter().map(|e| (e.id.as_str(), e.label.as_str())).collect();
        assert_eq!(entries, [("ants", "Ants"), ("mine", "mine"), ("ants-2", "Ants (own.csv)"), ("ants-3", "ants")]);
        assert_eq!(joined.question.entries[2].results.as_deref(), Some("own.csv"));
        let tasks: Vec<_> = joined.given.iter().map(|r| (r.task.instance, r.task.entry, r.task.seed)).collect();
        assert_eq!(tasks, [(0, 2, 7), (1, 2, 7), (1, 3, 3)]);
        let row = &joined.given[0];
        assert_eq!((row.value(Measure::Length), row.value(Measure::Turns)), (Some(7.5), Some(3.0)));
        assert_eq!((row.value(Measure::IterationOfBest), row.value(Measure::AntMoves)), (Some(12.0), None));
        assert_eq!((joined.given[2].found, joined.given[2].status), (None, Status::BudgetSpent));
        // Nothing of it is to be run, and what was to be run still is.
        assert_eq!(joined.tasks(), comparison().tasks());
    }

    #[test]
    fn an_entry_of_the_question_takes_its_runs_from_a_file() {
        let one = fill(comparison(), 1, &results("instance,length\nopen,7\nopen,8\n")).unwrap();
        assert_eq!(one.given.iter().map(|r| (r.task.entry, r.task.seed)).collect::<Vec<_>>(), [(1, 1), (1, 2)]);
        let several = "entry,instance,length\nother,open,7\nMine,open,9\n";
        let two = fill(one, 1, &results(several)).unwrap();
        assert_eq!(two.given.len(), 3);
        let error = fill(comparison(), 1, &results(&several.replace("Mine", "yours"))).unwrap_err().to_string();
        assert!(error.contains("entries.mine.results") && error.contains("other, yours"), "{error}");
    }

    #[test]
    fn where_runs_belong_is_said_or_asked_for() {
        assert!(
            refused("instance,length\ncave,7\n").contains("results.instance = cave cannot be used: it must be one of open, lane")
        );
        assert!(refused("length\n7\n").contains("the file does not say on which map its runs are"));
        let place = |text: &str, instance| join(comparison(), &results(text), instance).unwrap().given[0].task.instance;
        assert_eq!((place("length\n7\n", Some(1)), place("instance,length\ncave,7\n", Some(1))), (1, 1));
        // A name that is known wins.
        assert_eq!(place("instance,length\nopen.json,7\n", Some(1)), 0);
        let twice = "instance,seed,length\nopen,1,7\nopen.json,1,8\n";
        assert!(refused(twice).contains("results.seed = 1"));
        assert!(join(comparison(), &results("length\n7\n"), Some(2)).is_err());
    }

    #[test]
    fn the_optimum_is_met_within_the_printed_digits_and_beaten_by_none() {
        let given = |text: &str| join(comparison(), &results(text), Some(0)).unwrap();
        let one = |length: &str| {
            let comparison = given(&format!("length\n{length}\n"));
            let row = comparison.given[0].clone();
            (comparison.gap(&row), comparison.value(&row, Measure::Optimal), comparison.impossible(&row))
        };
        // 6.656854…: with six digits, three, one and as f32; 6.65 is not a rounded one.
        for printed in ["6.656854", "6.657", "6.7", "6.656854249492381", "6.6568541"] {
            assert_eq!(one(printed), (Some(0.0), Some(1.0), false), "{printed}");
        }
        for printed in ["6.65", "6.6567", "6"] {
            assert!(one(printed).2, "{printed}");
            assert_eq!(one(printed).1, Some(0.0), "{printed}");
        }
        assert!(!one("6.658").2 && one("6.658").1 == Some(0.0) && one("nan").1 == Some(0.0) && !one("nan").2);
        // The digits are those of all runs of the entry: 7 beside 6.656854 is 7.000000.
        let both = given("seed,length\n1,6.656854\n2,7\n");
        assert!(both.gap(&both.given[1]).unwrap() > 0.05);
    }

    #[test]
    fn values_are_ranked_in_the_digits_that_both_have() {
        let joined = join(comparison(), &results("entry,length\nA,6.66\nB,6.6568543\nC,7\n"), Some(0)).unwrap();
        let ours = 6.656_854_249_492_381;
        let common = |entries: &[usize]| joined.in_common_digits(entries, Measure::Length, ours);
        // Entry 0 is run here, 2 to 4 are A, B and C with two, seven and no decimals.
        assert_eq!([common(&[0]), common(&[0, 1])], [ours, ours]);
        assert_eq!([common(&[0, 2]), common(&[3, 0]), common(&[0, 2, 3, 4])], [6.66, 6.656_854_2, 7.0]);
        assert_eq!(joined.in_common_digits(&[0, 2], Measure::TurnIndex, ours), ours);
        assert_eq!(joined.in_common_digits(&[0, 2], Measure::Length, f64::INFINITY), f64::INFINITY);
        // As many digits as a double has: the last ones depend on the order of a sum.
        let full = join(comparison(), &results("length\n6.656854249492380\n6.656854249492382\n"), Some(0)).unwrap();
        let values = full.given.iter().map(|row| full.in_common_digits(&[0, 2], Measure::Length, row.found.unwrap().value));
        assert_eq!(values.collect::<Vec<_>>(), [6.656_854_249; 2]);
    }

    #[test]
    fn a_target_is_reached_within_the_printed_digits() {
        use crate::comparison::analysis::{Intervals, Samples, whole};
        let text = "evaluations,length\n40,6.657\n";
        let joined = join(comparison(), &results(text), Some(0)).unwrap();
        let rows = joined.given.clone();
        let analysis = whole(&Samples::new(&joined, rows.iter().map(Into::into)), &mut Intervals::default());
        let (map, mine) = (&analysis.instances[0], &analysis.instances[0].entries[2]);
        assert_eq!((mine.optimal, mine.impossible, mine.ecdf.last().map(|p| p.share)), (1, 0, Some(1.0)));
        let last = mine.running_times.last().unwrap();
        assert_eq!((last.successes, last.target), (1, *map.targets.last().unwrap()));
    }

    #[test]
    fn improvements_become_a_trace_of_what_is_better() {
        let text = "seed,evaluations,length,turns\n1,10,9,5\n1,30,8.5,4\n1,50,8.5,3\n1,70,7,2\n1,100,7,2\n";
        let joined = join(comparison(), &results(text), Some(0)).unwrap();
        let row = &joined.given[0];
        let trace: Vec<_> = row.trace.iter().map(|i| (i.value, i.spent.constructed_paths)).collect();
        assert_eq!(trace, [(9.0, Some(10)), (8.5, Some(30)), (7.0, Some(70))]);
        assert_eq!((row.found.unwrap().turns, row.effort.constructed_paths), (Some(2), Some(100)));
        assert_eq!(row.value(Measure::PathsToBest), Some(70.0));
    }
}
