//! One line a run.

use serde::Serialize;
use serde_json::Value;

use crate::exact::Reference;
use crate::experiment::run::{Experiment, Found, Row};

/// The columns of [`csv`].
pub const HEADER: &str = "instance,entry,seed,status,length,turns,turn_index,weight,iteration_of_best,paths_to_best,ant_moves,\
                          objective,value,reference,proven,gap,digest";

/// One line a run, lengths in cells with six decimals; empty fields where no path was found, or nothing is known.
pub fn csv(experiment: &Experiment, rows: &[Row]) -> String {
    let lines: String = rows.iter().map(|row| line(experiment, row) + "\n").collect();
    format!("{HEADER}\n{lines}")
}

/// The line of one run.
pub fn line(experiment: &Experiment, row: &Row) -> String {
    let (question, task) = (&experiment.question, row.task);
    let instance = question.instances.get(task.instance).map_or("", |i| &i.id);
    let entry = question.entries.get(task.entry).map_or("", |e| &e.id);
    let path = row.found.map_or_else(|| ",,,,,".into(), path_fields);
    let yardstick = experiment.maps.get(task.instance).and_then(|m| m.yardsticks.get(task.entry).copied().flatten());
    let objective = yardstick.map_or_else(String::new, |y| id(y.objective));
    let reference = yardstick.map_or(Reference::Unknown, |y| y.reference);
    let proven = id(matches!(reference, Reference::Proven { .. }));
    let [value, gap] = [row.found.map(|f| f.value), row.found.and_then(|f| f.gap)].map(maybe);
    let (seed, status, moves, digest) = (task.seed, id(row.status), row.ant_moves, &row.digest);
    let best = maybe(reference.value());
    format!("{instance},{entry},{seed},{status},{path},{moves},{objective},{value},{best},{proven},{gap},{digest}")
}

fn path_fields(f: Found) -> String {
    let weight = maybe(f.weight);
    format!("{},{},{},{weight},{},{}", six(f.length), f.turns, six(f.turn_index), f.iteration_of_best, f.paths_to_best)
}

fn maybe(v: Option<f64>) -> String {
    v.map_or_else(String::new, six)
}

fn six(v: f64) -> String {
    format!("{v:.6}")
}

/// As it stands in JSON.
fn id(value: impl Serialize) -> String {
    match serde_json::to_value(value) {
        Ok(Value::String(id)) => id,
        Ok(other) => other.to_string(),
        Err(_) => String::new(),
    }
}
