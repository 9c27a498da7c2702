//! The summary: one line an entry and map. As CSV and JSON with every number, as Markdown and LaTeX (`latex`) with those that a paper has.

use serde::Serialize;

use super::{length, middle, moves, short};
use crate::comparison::analysis::{Analysis, EntryAnalysis, MapAnalysis, Origin, Pair, Ranks, RunningTime, VerdictLine};
use crate::comparison::budget::{Axis, Budget};
use crate::comparison::measure::RunMeasure;
use crate::comparison::question::{Question, Role, Seeds};
use crate::comparison::{Comparison, Map};

/// What `format` says in JSON.
const FORMAT: &str = "formicarium/summary@1";

/// The relative distance from the best known value whose running time the printed tables have.
const NEAR: f64 = 0.01;

/// One entry on one map, with every number. In CSV these are the columns; numbers that nobody knows are empty there and null in JSON.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Line<'a> {
    instance: &'a str,
    entry: &'a str,
    label: &'a str,
    role: Role,
    origin: Origin,
    measure: RunMeasure,
    runs: usize,
    with_path: usize,
    success_low: f64,
    success_high: f64,
    best: Option<f64>,
    lower_quartile: Option<f64>,
    median: Option<f64>,
    upper_quartile: Option<f64>,
    worst: Option<f64>,
    mean: Option<f64>,
    deviation: Option<f64>,
    mean_low: Option<f64>,
    mean_high: Option<f64>,
    median_low: Option<f64>,
    median_high: Option<f64>,
    reference: Option<f64>,
    proven: bool,
    optimal: Option<usize>,
    impossible: usize,
    mean_gap: Option<f64>,
    median_turns: Option<f64>,
    median_iteration_of_best: Option<f64>,
    median_paths_to_best: Option<f64>,
    axis: Axis,
    median_effort_to_best: Option<f64>,
    median_effort: Option<f64>,
    /// Expected running time to a value within 5 % of the best known one.
    running_time_5: Option<f64>,
    /// Within 1 %.
    running_time_1: Option<f64>,
    /// To that value.
    running_time_0: Option<f64>,
    published: Option<f64>,
    published_impossible: bool,
}

/// All lines, in the order of the question.
pub fn lines<'a>(comparison: &Comparison, analysis: &'a Analysis) -> Vec<Line<'a>> {
    let of_map = |(index, map): (usize, &'a MapAnalysis)| {
        let reference = move |entry| comparison.maps[index].reference(entry);
        map.entries.iter().enumerate().map(move |(place, entry)| {
            let reference = reference(place);
            let line = line(analysis.axis, map, entry);
            Line { reference: reference.value(), proven: reference.is_proven(), ..line }
        })
    };
    analysis.instances.iter().enumerate().flat_map(of_map).collect()
}

fn line<'a>(axis: Axis, map: &'a MapAnalysis, e: &'a EntryAnalysis) -> Line<'a> {
    let (of, end) = (e.summary.as_ref(), |interval: Option<[f64; 2]>, end: usize| interval.map(|i| i[end]));
    let [success_low, success_high] = e.success_interval;
    Line {
        instance: &map.id,
        entry: &e.id,
        label: &e.label,
        role: e.role,
        origin: e.origin,
        measure: map.measure,
        runs: e.runs,
        with_path: e.with_path,
        success_low,
        success_high,
        best: of.map(|s| s.least),
        lower_quartile: of.map(|s| s.lower),
        median: of.map(|s| s.median),
        upper_quartile: of.map(|s| s.upper),
        worst: of.map(|s| s.greatest),
        mean: of.map(|s| s.mean),
        deviation: of.and_then(|s| s.deviation),
        mean_low: end(e.mean_interval, 0),
        mean_high: end(e.mean_interval, 1),
        median_low: end(e.median_interval, 0),
        median_high: end(e.median_interval, 1),
        reference: None,
        proven: false,
        optimal: e.proven.then_some(e.optimal),
        impossible: e.impossible,
        mean_gap: e.gap.map(|s| s.mean),
        median_turns: e.turns.map(|s| s.median),
        median_iteration_of_best: e.iteration_of_best.map(|s| s.median),
        median_paths_to_best: e.paths_to_best.map(|s| s.median),
        axis,
        median_effort_to_best: e.effort_to_best.map(|s| s.median),
        median_effort: e.total_effort.map(|s| s.median),
        running_time_5: running_time(e, 0.05),
        running_time_1: running_time(e, 0.01),
        running_time_0: running_time(e, 0.0),
        published: e.published.and_then(|p| p.value),
        published_impossible: e.published.is_some_and(|p| p.impossible),
    }
}

fn running_time(entry: &EntryAnalysis, gap: f64) -> Option<f64> {
    let near = |time: &&RunningTime| (time.gap - gap).abs() < f64::EPSILON;
    entry.running_times.iter().find(near).and_then(|time| time.expected)
}

/// As CSV, all numbers with as many digits as tell them apart from any other.
pub fn csv(comparison: &Comparison, analysis: &Analysis) -> String {
    super::csv::of_lines(lines(comparison, analysis))
}

/// The summary as JSON.
#[derive(Serialize)]
struct Whole<'a> {
    format: &'a str,
    engine: &'a str,
    title: &'a str,
    seeds: Seeds,
    budget: Option<Budget>,
    lines: Vec<Line<'a>>,
    pairs: Vec<PairsOf<'a>>,
    ranks: &'a Option<Ranks>,
    verdicts: &'a [VerdictLine],
}

/// The tests of one map.
#[derive(Serialize)]
struct PairsOf<'a> {
    instance: &'a str,
    entries: Vec<&'a str>,
    pairs: &'a [Pair],
}

/// As JSON: what was asked, the lines, the tests of all pairs, the ranks over all maps and the verdicts.
pub fn json(comparison: &Comparison, analysis: &Analysis) -> String {
    let Question { title, seeds, budget, .. } = &comparison.question;
    let whole = Whole {
        format: FORMAT,
        engine: env!("CARGO_PKG_VERSION"),
        title,
        seeds: *seeds,
        budget: *budget,
        lines: lines(comparison, analysis),
        pairs: analysis.instances.iter().map(|map| PairsOf { instance: &map.id, entries: ids(map), pairs: &map.pairs }).collect(),
        ranks: &analysis.ranks,
        verdicts: &analysis.verdicts,
    };
    serde_json::to_string_pretty(&whole).expect("plain data can always be written as JSON") + "\n"
}

/// The entries that the tests of a map count from 0.
fn ids(map: &MapAnalysis) -> Vec<&str> {
    map.entries.iter().map(|e| e.id.as_str()).collect()
}

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
        let mut rows: Vec<Vec<Cell>> = of.entries.iter().map(cells).collect();
        mark(&mut rows, of);
        let head = [
            "",
            "runs with a path",
            "best",
            "median (IQR)",
            "mean ± sd",
            "95 % of the mean",
            "gap",
            "turns",
            "iteration of best",
        ];
        let running_time = format!("running time to +{:.0} %", 100.0 * NEAR);
        Printed {
            name: of.name.clone(),
            id: of.id.clone(),
            rule: format!("{} × {}, {}", grid.width(), grid.height(), moves(&map.scenario)),
            told: told(analysis.axis, of),
            head: head.map(String::from).into_iter().chain([running_time]).collect(),
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
    format!(
        "{} over the runs with a path; gap: mean distance from the reference of the entry's objective; turns and iteration of best: medians; \
         running time: expected, in {}{best_known}",
        map.measure_name,
        axis.words()
    )
}

const COLUMNS: usize = 10;

/// The fields of an entry.
fn cells(e: &EntryAnalysis) -> Vec<Cell> {
    let mut cells = vec![Cell::from("–".to_owned()); COLUMNS];
    cells[0] = e.label.clone().into();
    if e.runs > 0 {
        cells[1] = format!("{} of {}", e.with_path, e.runs).into();
    }
    let Some(s) = &e.summary else { return cells };
    let number = |value: f64, text: String| Cell { text, value: Some(value), best: false };
    cells[2] = number(s.least, length(s.least));
    cells[3] = number(s.median, format!("{} ({}–{})", length(s.median), length(s.lower), length(s.upper)));
    cells[4] = number(s.mean, s.deviation.map_or_else(|| length(s.mean), |sd| format!("{} ± {}", length(s.mean), length(sd))));
    let dash = || "–".to_owned();
    cells[5] = e.mean_interval.map_or_else(dash, |[low, high]| format!("{}–{}", length(low), length(high))).into();
    cells[6] = e.gap.map_or_else(dash, |gap| format!("{:.1} %", 100.0 * gap.mean)).into();
    cells[7] = e.turns.map_or_else(dash, |t| middle(&t)).into();
    cells[8] = e.iteration_of_best.map_or_else(dash, |i| middle(&i)).into();
    cells[9] = running_time(e, NEAR).map_or_else(dash, effort).into();
    cells
}

/// An effort, without decimals where they say nothing.
fn effort(v: f64) -> String {
    if v < 100.0 { short(v) } else { format!("{v:.0}") }
}

/// Marks the best number of each column. Entries whose runs did not all find a path take part only where that is so of every one: a mean over
/// the runs that happened to arrive would favour whoever fails where it is hard.
fn mark(rows: &mut [Vec<Cell>], map: &MapAnalysis) {
    let whole: Vec<bool> = map.entries.iter().map(|e| e.runs > 0 && e.with_path == e.runs).collect();
    let counts = |row: usize| !whole.contains(&true) || whole[row];
    for column in 0..COLUMNS {
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
    let mut out = format!("# {}\n\n{}\n", comparison.question.title, super::setting_of(comparison, analysis));
    for table in printed(comparison, analysis) {
        out += &format!("\n## {}\n\n{}. {}.\n\n", table.name, table.rule, sentence(&table.told));
        out += &format!("| {} |\n|{}\n", table.head.join(" | "), "---|".repeat(table.head.len()));
        for row in table.rows {
            let fields: Vec<String> =
                row.iter().map(|c| if c.best { format!("**{}**", c.text) } else { c.text.clone() }).collect();
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
