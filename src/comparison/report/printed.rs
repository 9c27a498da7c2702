//! The summary as papers print it: a table a map, for Markdown and LaTeX (`latex`).

use super::escape::{cell, prose};
use super::names::{impossible_note, name};
use super::numbers::{gap, hundredths, length, middle, short};
use super::table::running_time;
use super::words::Words;
use crate::comparison::analysis::{Analysis, EntryAnalysis, MapAnalysis};
use crate::comparison::budget::Axis;
use crate::comparison::statistics::Summary;
use crate::comparison::{Comparison, Map};

/// The relative distance from the best known value whose running time the printed tables have.
const NEAR: f64 = 0.01;

/// A printed table of one map.
pub(super) struct Printed {
    /// What it is called.
    pub name: String,
    /// Its id.
    pub id: String,
    /// How one moves on it, and its size.
    pub rule: String,
    /// What is measured, and what else the columns need to be told.
    pub told: String,
    /// The columns.
    pub head: Vec<String>,
    /// The entries.
    pub rows: Vec<Vec<Cell>>,
}

/// One field of a printed table.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Cell {
    pub text: String,
    /// The number that the text shows rounded, where smaller is better.
    pub value: Option<f64>,
    /// Whether no other one of the column is better, as far as the digits tell.
    pub best: bool,
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self { text, ..Self::default() }
    }
}

/// The printed tables of all maps.
pub(super) fn printed(words: &Words, comparison: &Comparison, analysis: &Analysis) -> Vec<Printed> {
    let table = |(map, of): (&Map, &MapAnalysis)| {
        let mut rows: Vec<Vec<Cell>> = of.entries.iter().map(|e| cells(words, e, of)).collect();
        mark(&mut rows, of);
        let objective = of.mixed_objectives.then_some(words.summary.makes_small);
        let head = words.summary.columns;
        let running_time = (words.summary.running_time)(&hundredths(words, NEAR));
        Printed {
            name: of.name.clone(),
            id: of.id.clone(),
            rule: super::rule(words, map),
            told: told(words, analysis.axis, of),
            head: [""].into_iter().chain(objective).chain(head).map(String::from).chain([running_time]).collect(),
            rows,
        }
    };
    comparison.maps.iter().zip(&analysis.instances).map(table).collect()
}

/// What must be known to read a table.
fn told(words: &Words, axis: Axis, map: &MapAnalysis) -> String {
    let [measure, curve] = [map.measure, map.curve_measure].map(words.names.measure);
    let best = map.targets.last().map(|best| [hundredths(words, NEAR), length(*best)]);
    let target = best.as_ref().map(|[near, best]| [curve, near, best]);
    (words.summary.about)(measure, (words.names.axis)(axis), target, &impossible_note(words, map))
}

/// The fields of an entry on a map; where entries make different things small, with what it does.
fn cells(words: &Words, e: &EntryAnalysis, of: &MapAnalysis) -> Vec<Cell> {
    let dash = || "–".to_owned();
    let number = |value: f64, text: String| Cell { text, value: Some(value), best: false };
    let measured = |of: Option<f64>, text: fn(&Summary) -> String| match (&e.summary, of) {
        (Some(s), Some(value)) => number(value, text(s)),
        _ => dash().into(),
    };
    let s = e.summary;
    let share = if e.runs > 0 { (words.signs.part_of)(e.with_path, e.runs) } else { dash() };
    let mut cells = vec![Cell::from(name(words, e).into_owned())];
    let small = || e.objective.map_or_else(dash, |o| (words.names.objective)(o, of.measure).into());
    cells.extend(of.mixed_objectives.then(|| small().into()));
    cells.extend([
        share.into(),
        measured(s.map(|s| s.least), |s| length(s.least)),
        measured(s.map(|s| s.median), |s| format!("{} ({}–{})", length(s.median), length(s.lower), length(s.upper))),
        measured(s.map(|s| s.mean), |s| {
            s.deviation.map_or_else(|| length(s.mean), |sd| format!("{} ± {}", length(s.mean), length(sd)))
        }),
        e.mean_interval.map_or_else(dash, |[low, high]| format!("{}–{}", length(low), length(high))).into(),
        e.gap.map_or_else(dash, |of| gap(words, of.median)).into(),
        e.gap.map_or_else(dash, |of| gap(words, of.mean)).into(),
        e.turns.map_or_else(dash, |t| middle(&t)).into(),
        e.iteration_of_best.map_or_else(dash, |i| middle(&i)).into(),
        time(words, e).into(),
    ]);
    cells
}

/// The expected running time, or why there is none.
fn time(words: &Words, e: &EntryAnalysis) -> String {
    match (running_time(e, NEAR), e.no_running_time) {
        (Some(time), _) => effort(time),
        (None, Some(why)) => (words.names.no_running_time)(why).into(),
        (None, None) => words.summary.not_reached.into(),
    }
}

/// An effort, without decimals where they say nothing.
fn effort(v: f64) -> String {
    if v < 100.0 { short(v) } else { format!("{v:.0}") }
}

/// Marks the best number of each column. Entries whose runs did not all find a path take part only where that is so of every one: a mean over
/// the runs that happened to arrive would favour the entry that fails on the hard ones. What is impossible is never the best.
fn mark(rows: &mut [Vec<Cell>], map: &MapAnalysis) {
    let possible: Vec<bool> = map.entries.iter().map(|e| e.impossible == 0).collect();
    let whole: Vec<bool> = map.entries.iter().map(|e| e.runs > 0 && e.with_path == e.runs && e.impossible == 0).collect();
    let counts = |row: usize| possible[row] && (!whole.contains(&true) || whole[row]);
    for column in 0..rows.first().map_or(0, Vec::len) {
        let of = |row: &[Cell]| row.get(column).and_then(|cell| cell.value);
        let best = rows.iter().enumerate().filter(|(row, _)| counts(*row)).filter_map(|(_, row)| of(row)).reduce(f64::min);
        let Some(best) = best.map(length) else { continue };
        for (_, row) in rows.iter_mut().enumerate().filter(|(row, _)| counts(*row)) {
            let is_best = of(row).is_some_and(|v| length(v) == best);
            row[column].best = is_best;
        }
    }
}

/// The printed tables as Markdown; the best number of a column is bold.
pub(super) fn markdown(words: &Words, comparison: &Comparison, analysis: &Analysis) -> String {
    let (signs, setting) = (&words.signs, super::setting_of(words, comparison, analysis));
    let mut out = format!("# {}\n\n{setting}\n", prose(&comparison.question.title));
    for table in printed(words, comparison, analysis) {
        let about = [&table.rule, signs.next, &sentence(&table.told), signs.end].concat();
        out += &format!("\n## {}\n\n{about}\n\n", prose(&table.name));
        out += &format!("| {} |\n|{}\n", table.head.join(" | "), "---|".repeat(table.head.len()));
        table.rows.iter().for_each(|row| out += &markdown_row(row));
    }
    out
}

/// A row of a table of Markdown.
pub(super) fn markdown_row(row: &[Cell]) -> String {
    let text = |c: &Cell| if c.best { format!("**{}**", cell(&c.text)) } else { cell(&c.text).into_owned() };
    format!("| {} |\n", row.iter().map(text).collect::<Vec<_>>().join(" | "))
}

/// With a capital letter.
pub(super) fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
