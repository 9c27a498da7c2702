//! One line a run.

use std::borrow::Cow;

use serde::Serialize;

use crate::comparison::Comparison;
use crate::comparison::budget::Axis;
use crate::comparison::json;
use crate::comparison::row::{Found, Row};
use crate::exact::Reference;

/// The columns of [`csv`].
pub const HEADER: &str = "instance,entry,seed,status,length,turns,turn_index,weight,iteration_of_best,paths_to_best,ant_moves,\
                          objective,value,reference,proven,gap,digest";

/// One line a run, lengths in cells with six decimals; empty fields where no path was found, or nothing is known.
pub(super) fn csv(comparison: &Comparison, rows: &[Row]) -> String {
    let lines: String = rows.iter().map(|row| line(comparison, row) + "\n").collect();
    format!("{HEADER}\n{lines}")
}

/// The line of one run.
pub fn line(comparison: &Comparison, row: &Row) -> String {
    let (question, task) = (&comparison.question, row.task);
    let instance = question.instances.get(task.instance).map_or("", |i| &i.id);
    let entry = question.entries.get(task.entry).map_or("", |e| &e.id);
    let path = row.found.map_or_else(|| ",,,".into(), path_fields);
    let best = row.found.and(row.trace.last()).map(|improvement| improvement.spent).unwrap_or_default();
    let iteration = best.on(Axis::Iterations).filter(|_| !comparison.needs_no_seed(task.entry));
    let effort = [iteration, best.on(Axis::ConstructedPaths), row.effort.on(Axis::AntMoves)].map(count).join(",");
    let map = comparison.maps.get(task.instance);
    let objective = map.and_then(|m| m.objective(task.entry)).map_or_else(String::new, id);
    let reference = map.map_or(Reference::Unknown, |m| m.reference(task.entry));
    let proven = matches!(reference, Reference::Proven { .. });
    let [value, gap] = [row.found.map(|f| f.value), comparison.gap(row)].map(maybe);
    let (seed, status, digest) = (task.seed, id(row.status), &row.digest);
    let best = maybe(reference.value());
    // Ids are plain, but may begin with a `-`.
    let [instance, entry] = [instance, entry].map(harmless);
    format!("{instance},{entry},{seed},{status},{path},{effort},{objective},{value},{best},{proven},{gap},{digest}")
}

/// Lines of equal columns, named by their fields.
pub(super) fn of_lines(lines: impl IntoIterator<Item = impl Serialize>) -> String {
    let mut writer = csv::WriterBuilder::new().from_writer(Vec::new());
    const PLAIN: &str = "plain data can always be written to memory as CSV";
    lines.into_iter().try_for_each(|line| writer.serialize(line)).expect(PLAIN);
    let written = writer.into_inner().expect(PLAIN);
    let mut guarded = csv::WriterBuilder::new().from_writer(Vec::new());
    for record in csv::ReaderBuilder::new().has_headers(false).from_reader(&written[..]).records() {
        let record = record.expect(PLAIN);
        let cells: Vec<Cow<'_, str>> = record.iter().map(harmless).collect();
        guarded.write_record(cells.iter().map(|cell| cell.as_bytes())).expect(PLAIN);
    }
    String::from_utf8(guarded.into_inner().expect(PLAIN)).expect("texts are UTF-8")
}

/// Spreadsheets take a text that begins like this for a formula. A quote before it makes it a text; numbers stay numbers.
pub(super) fn harmless(cell: &str) -> Cow<'_, str> {
    let begins = cell.starts_with(['=', '+', '-', '@', '\t', '\r']);
    if begins && cell.parse::<f64>().is_err() { Cow::Owned(format!("'{cell}")) } else { Cow::Borrowed(cell) }
}

fn path_fields(f: Found) -> String {
    let turns = count(f.turns.map(f64::from));
    format!("{},{turns},{},{}", six(f.length), maybe(f.turn_index), maybe(f.weight))
}

fn count(v: Option<f64>) -> String {
    v.map_or_else(String::new, |v| format!("{v}"))
}

fn maybe(v: Option<f64>) -> String {
    v.map_or_else(String::new, six)
}

fn six(v: f64) -> String {
    format!("{v:.6}")
}

/// The name of a variant, as it stands in JSON.
fn id(value: impl Serialize) -> String {
    json(&value).trim_matches('"').into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_id_is_a_formula() {
        assert_eq!(["-a1", "-1", "a-1", ""].map(|id| harmless(id).into_owned()), ["'-a1", "-1", "a-1", ""]);
    }

    #[test]
    fn no_cell_is_a_formula_and_numbers_stay() {
        let lines = [("=HYPERLINK(\"x\")", -0.5, "a,b"), ("@x", 1e-7, "-3"), ("\tx", 2.0, "plain\nline"), ("–", -1.0, "-x")];
        let written = of_lines(lines);
        assert_eq!(written, "\"'=HYPERLINK(\"\"x\"\")\",-0.5,\"a,b\"\n'@x,1e-7,-3\n'\tx,2.0,\"plain\nline\"\n–,-1.0,'-x\n");
    }
}
