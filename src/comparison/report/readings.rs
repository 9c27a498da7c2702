//! Claims by the reading of the publication: a row a claim, a column a reading.

use std::fmt::Write;

use super::claims::median_effect;
use super::escape::cell;
use super::printed::Cell;
use super::verdicts::measure_name;
use super::words::Words;
use crate::comparison::Comparison;
use crate::comparison::analysis::Analysis;
use crate::comparison::by_reading::ReadingRow;
use crate::comparison::over_maps::{FEWEST_MAPS, OverMaps};

/// As Markdown; nothing where no claim names a reading.
pub(super) fn table(words: &Words, out: &mut String, comparison: &Comparison, analysis: &Analysis) {
    let Some((head, rows)) = fields(words, comparison, analysis) else { return };
    let _ = writeln!(out, "\n## {}\n\n| {} |\n|{}", words.claims.readings_title, head.join(" | "), "---|".repeat(head.len()));
    for row in rows {
        let row: Vec<_> = row.iter().map(|field| cell(field).into_owned()).collect();
        let _ = writeln!(out, "| {} |", row.join(" | "));
    }
}

/// The columns of the printed table and its rows; none where no claim names a reading.
pub(super) fn printed(words: &Words, comparison: &Comparison, analysis: &Analysis) -> Option<(Vec<String>, Vec<Vec<Cell>>)> {
    let (head, rows) = fields(words, comparison, analysis)?;
    let plain = |row: Vec<String>| row.into_iter().map(|field| Cell::from(field.replace("**", ""))).collect();
    Some((head, rows.into_iter().map(plain).collect()))
}

fn fields(words: &Words, comparison: &Comparison, analysis: &Analysis) -> Option<(Vec<String>, Vec<Vec<String>>)> {
    let (said, table) = (&words.claims, &analysis.by_reading);
    let readings = table.readings.iter().map(|reading| (said.reading)(*reading));
    let head = said.readings_columns.into_iter().chain(readings).map(String::from).collect();
    let row = |row: &ReadingRow| {
        let claim = comparison.question.claims.get(row.first());
        let named = claim.map_or_else(Vec::new, |claim| vec![claim.says.clone(), measure_name(words, claim)]);
        let found = |place: &Option<usize>| place.and_then(|place| analysis.over_maps.get(place));
        let cells = row.claims.iter().map(|place| found(place).map_or_else(|| "–".into(), |over| outcome(words, over)));
        named.into_iter().chain(cells).collect()
    };
    let is_judged = !analysis.over_maps.is_empty() && !table.rows.is_empty();
    is_judged.then(|| (head, table.rows.iter().map(row).collect()))
}

/// What became of a claim, on how many maps, and the median effect.
fn outcome(words: &Words, over: &OverMaps) -> String {
    let verdict = (words.claims.overall)(over.verdict, over.claimed.is_some(), FEWEST_MAPS);
    if over.maps == 0 {
        return verdict;
    }
    [verdict, (words.claims.on_maps)(over.better, over.maps), median_effect(words, over)].join(words.signs.parts)
}
