//! Maps × entries: median, gap, share of runs with a path and rank of each, as CSV, Markdown and LaTeX.

use serde::Serialize;

use super::escape::prose;
use super::latex::{self, Table};
use super::names::{MARK, asked_name, impossible_note};
use super::numbers::{gap, median, percent, short};
use super::printed::{Cell, markdown_row, sentence};
use super::words::Words;
use crate::comparison::Comparison;
use crate::comparison::analysis::{Analysis, MapAnalysis, MatrixCell, MatrixRow, Overall, Unranked};
use crate::comparison::measure::RunMeasure;
use crate::comparison::question::Entry;
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
pub(super) fn csv(comparison: &Comparison, analysis: &Analysis) -> String {
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
pub(super) fn markdown(words: &Words, comparison: &Comparison, analysis: &Analysis) -> String {
    let title = (words.matrix.title)(&prose(&comparison.question.title));
    let [head, rows @ ..] = &fields(words, comparison, analysis)[..] else { return String::new() };
    let (setting, end) = (super::setting_of(words, comparison, analysis), words.signs.end);
    let mut out = format!("# {title}\n\n{setting}\n\n{}{end}\n\n{}", sentence(words.matrix.about), markdown_row(head));
    out += &format!("|{}\n", "---|".repeat(head.len()));
    rows.iter().for_each(|row| out += &markdown_row(row));
    notes(words, comparison, analysis).iter().for_each(|note| out += &format!("\n- {}{end}", prose(note)));
    out.trim_end().to_owned() + "\n"
}

/// As a table of LaTeX.
pub(super) fn latex(words: &Words, comparison: &Comparison, analysis: &Analysis, command: &str) -> String {
    let (title, about) = (comparison.question.title.clone(), sentence(words.matrix.about));
    let said = [title, about].into_iter().chain(notes(words, comparison, analysis)).collect();
    let caption = latex::caption(words, said, &super::setting_of(words, comparison, analysis));
    let [head, rows @ ..] = &fields(words, comparison, analysis)[..] else { return String::new() };
    let head: Vec<String> = head.iter().map(|c| c.text.clone()).collect();
    latex::head(words, command) + &latex::environment(&Table { id: "matrix", head: &head, rows, last_apart: true }, &caption)
}

/// What must be known beside the table.
fn notes(words: &Words, comparison: &Comparison, analysis: &Analysis) -> Vec<String> {
    let said = &words.matrix;
    let of_map = |map: &MapAnalysis| {
        let note = impossible_note(words, map);
        (!note.is_empty()).then(|| (said.note)(&map.name, &note))
    };
    let mut notes: Vec<String> = analysis.instances.iter().filter_map(of_map).collect();
    let unranked = comparison.question.entries.iter().zip(&analysis.matrix.overall);
    let missing = unranked.filter(|(_, all)| all.unranked == Some(Unranked::NotOnEveryMap));
    let names: Vec<_> = missing.map(|(entry, _)| asked_name(words, entry)).collect();
    if !names.is_empty() {
        notes.push((said.not_ranked)(&names.join(words.signs.list)));
    }
    let mixed = analysis.instances.iter().filter(|map| map.mixed_objectives);
    notes.extend(mixed.map(|map| (said.objectives)(&map.name, &super::objectives(words, map, str::to_owned))));
    notes
}

/// Head and rows; the first field of each names it.
fn fields(words: &Words, comparison: &Comparison, analysis: &Analysis) -> Vec<Vec<Cell>> {
    let matrix = &analysis.matrix;
    let entry = |(place, entry): (usize, &Entry)| {
        let mark = if matrix.overall[place].unranked == Some(Unranked::Impossible) { MARK } else { "" };
        Cell::from(format!("{}{mark}", asked_name(words, entry)))
    };
    let first = |text: &str| Cell::from(text.to_owned());
    let head =
        std::iter::once(first(words.matrix.map)).chain(comparison.question.entries.iter().enumerate().map(entry)).collect();
    let mut rows = vec![head];
    rows.extend(matrix.rows.iter().map(|of| row(words, of)));
    rows.push(std::iter::once(first(words.matrix.all_maps)).chain(overall(words, &matrix.overall)).collect());
    rows
}

fn row(words: &Words, row: &MatrixRow) -> Vec<Cell> {
    let best = row.cells.iter().filter_map(|c| c.rank).reduce(f64::min);
    let field = |c: &MatrixCell| Cell { best: best.is_some() && c.rank == best, ..Cell::from(text(words, c)) };
    let name = (words.signs.beside)(&row.name, (words.names.measure)(row.measure));
    std::iter::once(Cell::from(name)).chain(row.cells.iter().map(field)).collect()
}

fn text(words: &Words, c: &MatrixCell) -> String {
    let said = &words.matrix;
    if c.runs == 0 {
        return words.names.not_run.into();
    }
    let mut parts = vec![median(words, c.median)];
    parts.extend(c.gap.map(|of| gap(words, of)));
    parts.extend(c.rank.map(|rank| (said.rank)(&short(rank))));
    parts.extend(c.success.filter(|&share| share < 1.0).map(|share| (said.path_in)(&percent(words, share))));
    if c.impossible > 0 {
        parts.push(format!("{}{MARK}", said.impossible));
    }
    parts.join(words.signs.parts)
}

/// The last row; the best mean rank is bold.
fn overall(words: &Words, all: &[Overall]) -> Vec<Cell> {
    let best = all.iter().filter_map(|o| o.mean_rank).reduce(f64::min);
    let field = |o: &Overall| {
        let rank = o.mean_rank.map(|rank| (words.matrix.rank)(&short(rank)));
        let parts: Vec<String> = rank.into_iter().chain(o.mean_gap.map(|of| gap(words, of))).collect();
        let text = if parts.is_empty() { "–".into() } else { parts.join(words.signs.parts) };
        Cell { best: best.is_some() && o.mean_rank == best, ..Cell::from(text) }
    };
    all.iter().map(field).collect()
}
