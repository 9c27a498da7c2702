//! The summary as papers print it: a table a map, for Markdown and LaTeX (`latex`).

use super::escape::{cell, prose};
use super::names::{impossible_note, name};
use super::table::running_time;
use super::{length, middle, moves, short};
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
pub(super) fn printed(comparison: &Comparison, analysis: &Analysis) -> Vec<Printed> {
    let table = |(map, of): (&Map, &MapAnalysis)| {
        let grid = &map.scenario.grid;
        let mut rows: Vec<Vec<Cell>> = of.entries.iter().map(|e| cells(e, of.mixed_objectives)).collect();
        mark(&mut rows, of);
        let objective = of.mixed_objectives.then_some("makes small");
        let head = [
            "runs with a path",
            "best",
            "median (IQR)",
            "mean ± sd",
            "95 % of the mean",
            "median gap",
            "mean gap",
            "turns",
            "iteration of best",
        ];
        let running_time = format!("running time to +{:.0} %", 100.0 * NEAR);
        Printed {
            name: of.name.clone(),
            id: of.id.clone(),
            rule: format!("{} × {}, {}", grid.width(), grid.height(), moves(&map.scenario)),
            told: told(analysis.axis, of),
            head: [""].into_iter().chain(objective).chain(head).map(String::from).chain([running_time]).collect(),
            rows,
        }
    };
    comparison.maps.iter().zip(&analysis.instances).map(table).collect()
}

/// What must be known to read a table.
fn told(axis: Axis, map: &MapAnalysis) -> String {
    let best_known = map
        .targets
        .last()
        .map_or_else(String::new, |best| format!(", to a {} within {:.0} % of {}", map.curve_name, 100.0 * NEAR, length(*best)));
    let impossible = impossible_note(map);
    format!(
        "{} over the runs with a path; gap of a run: value / reference − 1 by the entry's own objective, which makes the median gap the gap of the \
         median; turns and iteration of best: medians; running time: expected, in {}{best_known}{}",
        map.measure_name,
        axis.words(),
        if impossible.is_empty() { impossible } else { format!("; {impossible}") },
    )
}

/// The fields of an entry; `mixed`: with what it makes small.
fn cells(e: &EntryAnalysis, mixed: bool) -> Vec<Cell> {
    let dash = || "–".to_owned();
    let number = |value: f64, text: String| Cell { text, value: Some(value), best: false };
    let measured = |of: Option<f64>, text: fn(&Summary) -> String| match (&e.summary, of) {
        (Some(s), Some(value)) => number(value, text(s)),
        _ => dash().into(),
    };
    let s = e.summary;
    let percent = |share: f64| format!("{:.1} %", 100.0 * share);
    let share = if e.runs > 0 { format!("{} of {}", e.with_path, e.runs) } else { dash() };
    let mut cells = vec![Cell::from(name(e).into_owned())];
    cells.extend(mixed.then(|| e.objective.map_or_else(dash, |o| o.words().into()).into()));
    cells.extend([
        share.into(),
        measured(s.map(|s| s.least), |s| length(s.least)),
        measured(s.map(|s| s.median), |s| format!("{} ({}–{})", length(s.median), length(s.lower), length(s.upper))),
        measured(s.map(|s| s.mean), |s| {
            s.deviation.map_or_else(|| length(s.mean), |sd| format!("{} ± {}", length(s.mean), length(sd)))
        }),
        e.mean_interval.map_or_else(dash, |[low, high]| format!("{}–{}", length(low), length(high))).into(),
        e.gap.map_or_else(dash, |gap| percent(gap.median)).into(),
        e.gap.map_or_else(dash, |gap| percent(gap.mean)).into(),
        e.turns.map_or_else(dash, |t| middle(&t)).into(),
        e.iteration_of_best.map_or_else(dash, |i| middle(&i)).into(),
        time(e).into(),
    ]);
    cells
}

/// The expected running time, or why there is none.
fn time(e: &EntryAnalysis) -> String {
    match (running_time(e, NEAR), e.no_running_time) {
        (Some(time), _) => effort(time),
        (None, Some(why)) => why.words().into(),
        (None, None) => "no run reaches it".into(),
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
        let rounded = |v: f64| length(v);
        let of = |row: &[Cell]| row.get(column).and_then(|cell| cell.value);
        let best = rows.iter().enumerate().filter(|(row, _)| counts(*row)).filter_map(|(_, row)| of(row)).reduce(f64::min);
        let Some(best) = best.map(rounded) else { continue };
        for (_, row) in rows.iter_mut().enumerate().filter(|(row, _)| counts(*row)) {
            let is_best = of(row).is_some_and(|v| rounded(v) == best);
            row[column].best = is_best;
        }
    }
}

/// The printed tables as Markdown; the best number of a column is bold.
pub fn markdown(comparison: &Comparison, analysis: &Analysis) -> String {
    let mut out = format!("# {}\n\n{}\n", prose(&comparison.question.title), super::setting_of(comparison, analysis));
    for table in printed(comparison, analysis) {
        out += &format!("\n## {}\n\n{}. {}.\n\n", prose(&table.name), table.rule, sentence(&table.told));
        out += &format!("| {} |\n|{}\n", table.head.join(" | "), "---|".repeat(table.head.len()));
        for row in table.rows {
            let fields: Vec<String> =
                row.iter().map(|c| if c.best { format!("**{}**", cell(&c.text)) } else { cell(&c.text).into_owned() }).collect();
            out += &format!("| {} |\n", fields.join(" | "));
        }
    }
    out
}

/// With a capital letter.
pub(super) fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
