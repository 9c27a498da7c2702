//! Maps × entries: median, gap, share of runs with a path and rank of each, as CSV, Markdown and LaTeX.

use serde::Serialize;

use super::escape::{cell, prose};
use super::latex::{self, Table};
use super::names::{MARK, asked_name, impossible_note};
use super::printed::{Cell, sentence};
use super::{length, short};
use crate::comparison::Comparison;
use crate::comparison::analysis::{Analysis, MatrixCell, MatrixRow, Overall, Unranked};
use crate::comparison::measure::RunMeasure;
use crate::planner::Objective;

/// One entry on one map; without a map, over all of them: `rank` and `gap` are means there.
#[derive(Debug, Serialize)]
struct Line<'a> {
    instance: &'a str,
    entry: &'a str,
    measure: Option<RunMeasure>,
    objective: Option<Objective>,
    runs: usize,
    success: Option<f64>,
    median: Option<f64>,
    gap: Option<f64>,
    rank: Option<f64>,
    unranked: Option<Unranked>,
    impossible: usize,
}

/// One line an entry and map, and one an entry over all maps, whose `instance` is empty.
pub fn csv(comparison: &Comparison, analysis: &Analysis) -> String {
    let entries = &comparison.question.entries;
    let matrix = &analysis.matrix;
    let unranked = |entry: usize| matrix.overall[entry].unranked;
    let mut lines = Vec::new();
    for (row, map) in matrix.rows.iter().zip(&analysis.instances) {
        for (place, c) in row.cells.iter().enumerate() {
            let MatrixCell { runs, success, median, gap, rank, impossible } = *c;
            let (entry, objective) = (&entries[place].id, map.entries[place].objective);
            let (measure, unranked) = (Some(row.measure), unranked(place));
            lines.push(Line {
                instance: &row.id,
                entry,
                measure,
                objective,
                runs,
                success,
                median,
                gap,
                rank,
                unranked,
                impossible,
            });
        }
    }
    for (place, all) in matrix.overall.iter().enumerate() {
        let of = |count: fn(&MatrixCell) -> usize| matrix.rows.iter().map(|row| count(&row.cells[place])).sum();
        lines.push(Line {
            instance: "",
            entry: &entries[place].id,
            measure: None,
            objective: None,
            runs: of(|c| c.runs),
            success: all.success,
            median: None,
            gap: all.mean_gap,
            rank: all.mean_rank,
            unranked: all.unranked,
            impossible: of(|c| c.impossible),
        });
    }
    super::csv::of_lines(lines)
}

/// As a table of Markdown: the best ranks of each map are bold.
pub fn markdown(comparison: &Comparison, analysis: &Analysis) -> String {
    let title = prose(&comparison.question.title);
    let [head, rows @ ..] = &fields(comparison, analysis)[..] else { return String::new() };
    let line = |cells: &[Cell]| {
        let text = |c: &Cell| if c.best { format!("**{}**", cell(&c.text)) } else { cell(&c.text).into_owned() };
        format!("| {} |\n", cells.iter().map(text).collect::<Vec<_>>().join(" | "))
    };
    let setting = super::setting_of(comparison, analysis);
    let mut out = format!("# {title}: maps × entries\n\n{setting}\n\n{}.\n\n{}", sentence(&told()), line(head));
    out += &format!("|{}\n", "---|".repeat(head.len()));
    rows.iter().for_each(|row| out += &line(row));
    notes(comparison, analysis).iter().for_each(|note| out += &format!("\n- {}.", prose(note)));
    out.trim_end().to_owned() + "\n"
}

/// As a table of LaTeX.
pub fn latex(comparison: &Comparison, analysis: &Analysis, command: &str) -> String {
    let setting = super::setting_of(comparison, analysis);
    let (title, notes) = (&comparison.question.title, notes(comparison, analysis));
    let about: Vec<String> = std::iter::once(sentence(&told())).chain(notes).collect();
    let caption = format!("{title}. {}. Formicarium, {setting}", about.join(". "));
    let [head, rows @ ..] = &fields(comparison, analysis)[..] else { return String::new() };
    let head: Vec<String> = head.iter().map(|c| c.text.clone()).collect();
    latex::head(command) + &latex::environment(&Table { id: "matrix", head: &head, rows, last_apart: true }, &caption)
}

fn told() -> String {
    "each field: the median over the runs with a path, the gap of that median, the rank by the median of all runs, of which those without a path are \
     the longest, and the share of runs with a path where some have none; last row: the mean rank and the mean gap over all maps"
        .into()
}

/// What must be known beside the table.
fn notes(comparison: &Comparison, analysis: &Analysis) -> Vec<String> {
    let of_map = |map: &crate::comparison::analysis::MapAnalysis| {
        let note = impossible_note(map);
        (!note.is_empty()).then(|| format!("{}, {note}", map.name))
    };
    let mut notes: Vec<String> = analysis.instances.iter().filter_map(of_map).collect();
    let unranked = comparison.question.entries.iter().zip(&analysis.matrix.overall);
    let missing = unranked.filter(|(_, all)| all.unranked == Some(Unranked::NotOnEveryMap));
    let names: Vec<_> = missing.map(|(entry, _)| asked_name(entry)).collect();
    if !names.is_empty() {
        notes.push(format!("Not ranked, without runs on every map: {}", names.join(", ")));
    }
    notes.extend(super::objectives_notes(analysis));
    notes
}

/// Head and rows; the first field of each names it.
fn fields(comparison: &Comparison, analysis: &Analysis) -> Vec<Vec<Cell>> {
    let matrix = &analysis.matrix;
    let entry = |(place, entry): (usize, &crate::comparison::question::Entry)| {
        let mark = if matrix.overall[place].unranked == Some(Unranked::Impossible) { MARK } else { "" };
        Cell::from(format!("{}{mark}", asked_name(entry)))
    };
    let first = |text: &str| Cell::from(text.to_owned());
    let head = std::iter::once(first("map")).chain(comparison.question.entries.iter().enumerate().map(entry)).collect();
    let mut rows = vec![head];
    rows.extend(matrix.rows.iter().map(row));
    rows.push(std::iter::once(first("all maps")).chain(overall(&matrix.overall)).collect());
    rows
}

fn row(row: &MatrixRow) -> Vec<Cell> {
    let best = row.cells.iter().filter_map(|c| c.rank).reduce(f64::min);
    let field = |c: &MatrixCell| Cell { best: best.is_some() && c.rank == best, ..Cell::from(text(c)) };
    std::iter::once(Cell::from(format!("{} ({})", row.name, row.measure_name))).chain(row.cells.iter().map(field)).collect()
}

fn text(c: &MatrixCell) -> String {
    if c.runs == 0 {
        return "not run".into();
    }
    let mut parts = vec![c.median.map_or_else(|| "no path".into(), length)];
    parts.extend(c.gap.map(percent));
    parts.extend(c.rank.map(|rank| format!("rank {}", short(rank))));
    parts.extend(c.success.filter(|&share| share < 1.0).map(|share| format!("path in {}", percent(share))));
    if c.impossible > 0 {
        parts.push(format!("impossible{MARK}"));
    }
    parts.join("; ")
}

/// The last row; the best mean rank is bold.
fn overall(all: &[Overall]) -> Vec<Cell> {
    let best = all.iter().filter_map(|o| o.mean_rank).reduce(f64::min);
    let field = |o: &Overall| {
        let rank = o.mean_rank.map(|rank| format!("rank {}", short(rank)));
        let parts: Vec<String> = rank.into_iter().chain(o.mean_gap.map(percent)).collect();
        let text = if parts.is_empty() { "–".into() } else { parts.join("; ") };
        Cell { best: best.is_some() && o.mean_rank == best, ..Cell::from(text) }
    };
    all.iter().map(field).collect()
}

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}
