//! One line an improvement: how each run came to its best path.

use std::fmt::Write;

use super::csv::harmless;
use crate::comparison::Comparison;
use crate::comparison::row::Row;

/// The columns of [`trace_lines`]: `value` by the planner's own objective in cells, in full, then what had been spent when it was found.
pub const TRACE_HEADER: &str = "instance,entry,seed,value,iterations,constructed_paths,ant_moves,cell_expansions";

/// The improvements of one run, a line each with its end; a count that is not known is empty.
pub fn trace_lines(comparison: &Comparison, row: &Row) -> String {
    let (question, task) = (&comparison.question, row.task);
    let instance = question.instances.get(task.instance).map_or("", |i| &i.id);
    let entry = question.entries.get(task.entry).map_or("", |e| &e.id);
    let [instance, entry] = [instance, entry].map(harmless);
    let count = |n: Option<u64>| n.map_or_else(String::new, |n| n.to_string());
    let mut out = String::new();
    for improvement in &row.trace {
        let s = improvement.spent;
        let spent = [s.iterations, s.constructed_paths, s.ant_moves, s.cell_expansions].map(count).join(",");
        let _ = writeln!(out, "{instance},{entry},{},{},{spent}", task.seed, improvement.value);
    }
    out
}
