//! The claims: over maps first, then map by map, and the maps that cannot stand for the publication's.

use std::fmt::Write;

use serde::Serialize;

use super::escape::{cell, prose};
use super::names::asked_name;
use super::numbers::{hundredths, percent};
use super::printed::Cell;
use super::readings;
use super::tests::probability;
use super::verdicts::{change, claims_by_map, effect, in_words};
use super::words::Words;
use crate::comparison::Comparison;
use crate::comparison::analysis::{Analysis, VerdictKind, VerdictLine};
use crate::comparison::claim::{Direction, Statistic};
use crate::comparison::facts::{Unfit, UnfitMap};
use crate::comparison::measure::RunMeasure;
use crate::comparison::over_maps::{FEWEST_MAPS, OverMaps, OverallVerdict};
use crate::comparison::statistics::CONFIDENCE;
use crate::planner::PaperReading;

/// All that Markdown says of them.
pub(super) fn tables(words: &Words, out: &mut String, comparison: &Comparison, analysis: &Analysis) {
    unfit_table(words, out, comparison, &analysis.unfit);
    if analysis.judged.is_empty() {
        return;
    }
    readings::table(words, out, comparison, analysis);
    let columns = (words.claims.over_columns)(100.0 * CONFIDENCE);
    let _ = writeln!(out, "\n## {}\n\n| {} |\n|{}", words.claims.title, columns.join(" | "), "---|".repeat(columns.len()));
    for over in &analysis.over_maps {
        let fields = fields(words, comparison, over);
        let _ = writeln!(out, "| {} |", fields.map(|field| cell(&field).into_owned()).join(" | "));
    }
    claims_by_map(words, out, comparison, &analysis.judged);
}

/// What is told of a claim over maps, in the order of its columns.
fn fields(words: &Words, comparison: &Comparison, over: &OverMaps) -> [String; 6] {
    let said = &words.claims;
    let claim = comparison.question.claims.iter().find(|claim| claim.id == over.claim);
    let [low, high] = over.share_interval.map(|end| hundredths(words, end));
    let share = if over.maps > 0 { format!("{} [{low}, {high}]", (said.on_maps)(over.better, over.maps)) } else { "–".into() };
    let p = over.sign_p.map_or_else(String::new, |p| format!("{}p = {}", words.signs.comma, probability(p)).replace("= <", "<"));
    [
        claim.map_or_else(String::new, |claim| in_words(words, comparison, claim)),
        share,
        (said.counts)(&over.counts),
        format!("{} / {} / {}{p}", over.above, over.level, over.below),
        median_effect(words, over),
        (said.overall)(over.verdict, over.claimed.is_some(), FEWEST_MAPS),
    ]
}

pub(super) fn median_effect(words: &Words, over: &OverMaps) -> String {
    let Some(median) = over.median else { return "–".into() };
    match over.low.zip(over.high) {
        Some((low, high)) => effect(words, over.measure, over.direction, [median, low, high]),
        None => change(words, over.measure, over.direction, median),
    }
}

/// The columns of the printed table over maps.
pub(super) fn printed_head(words: &Words) -> Vec<String> {
    (words.claims.over_columns)(100.0 * CONFIDENCE).into()
}

/// Its rows; none where nothing is claimed.
pub(super) fn printed(words: &Words, comparison: &Comparison, analysis: &Analysis) -> Option<Vec<Vec<Cell>>> {
    let row = |over: &OverMaps| fields(words, comparison, over).map(|field| Cell::from(field.replace("**", ""))).into();
    let rows: Vec<Vec<Cell>> = analysis.over_maps.iter().map(row).collect();
    (!rows.is_empty()).then_some(rows)
}

fn unfit_table(words: &Words, out: &mut String, comparison: &Comparison, unfit: &[UnfitMap]) {
    if unfit.is_empty() {
        return;
    }
    let columns = words.claims.unfit_columns.join(" | ");
    let _ = writeln!(out, "\n## {}\n\n| {columns} |\n|---|---|---|", words.claims.unfit_title);
    for of_map in unfit.chunk_by(|a, b| a.instance == b.instance && a.says == b.says) {
        let why: Vec<_> = of_map.iter().map(|map| unfit_words(words, comparison, map)).collect();
        let (map, why) = (&of_map[0], cell(&why.join(words.signs.parts)).into_owned());
        let _ = writeln!(out, "| {} | {why} | {} |", map.instance, cell(&prose(&map.says)));
    }
}

/// What a map contradicts.
fn unfit_words(words: &Words, comparison: &Comparison, map: &UnfitMap) -> String {
    let said = &words.claims;
    match (map.why, map.found) {
        (Unfit::Optimum, Some(optimum)) => (said.optimum_above)(&super::length(optimum), &map.demanded.to_string()),
        (Unfit::Optimum, None) => (said.no_path)(&map.demanded.to_string()),
        (Unfit::Arrives, found) => {
            let entry = map.entry.as_deref().and_then(|id| comparison.question.entry(id));
            let entry = entry.map_or_else(String::new, |entry| asked_name(words, entry).into_owned());
            let [share, least] = [found.unwrap_or(0.0), map.demanded].map(|share| percent(words, share));
            (said.does_not_arrive)([&entry, &share, &least])
        }
    }
}

/// A claim on one map, or with an empty instance over maps: there the effect is the median of the maps' effects. Numbers that nobody knows,
/// and infinite ones, are empty.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
struct Line<'a> {
    instance: &'a str,
    claim: &'a str,
    improved: &'a str,
    baseline: &'a str,
    measure: Option<RunMeasure>,
    direction: Option<Direction>,
    claimed: Option<f64>,
    relevant: f64,
    statistic: Option<Statistic>,
    paired: Option<bool>,
    improved_runs: Option<usize>,
    baseline_runs: Option<usize>,
    improved_value: Option<f64>,
    baseline_value: Option<f64>,
    effect: Option<f64>,
    effect_low: Option<f64>,
    effect_high: Option<f64>,
    better: Option<f64>,
    p: Option<f64>,
    maps: Option<usize>,
    better_maps: Option<usize>,
    worse_maps: Option<usize>,
    share_low: Option<f64>,
    share_high: Option<f64>,
    above: Option<usize>,
    level: Option<usize>,
    below: Option<usize>,
    confidence: Option<f64>,
    verdict: Option<VerdictKind>,
    overall: Option<OverallVerdict>,
    why: &'a str,
    /// Empty of a claim without one; none, and then no column, where no claim has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    reading: Option<&'a str>,
}

/// One line a claim and map, and one a claim over its maps, where p is of the sign test.
pub(super) fn csv(analysis: &Analysis) -> String {
    let has_readings = !analysis.by_reading.readings.is_empty();
    let reading = |of: Option<PaperReading>| has_readings.then(|| of.map_or("", PaperReading::id));
    let by_map = analysis.verdicts.iter().map(|line| Line { reading: reading(line.reading), ..of_map(line) });
    let over_maps = analysis.over_maps.iter().map(|over| Line { reading: reading(over.reading), ..of_maps(over) });
    super::csv::of_lines(by_map.chain(over_maps))
}

fn of_map(line: &VerdictLine) -> Line<'_> {
    Line {
        instance: &line.instance,
        claim: &line.claim,
        improved: &line.improved,
        baseline: &line.baseline,
        measure: Some(line.measure),
        direction: Some(line.direction),
        claimed: line.claimed,
        relevant: line.relevant,
        statistic: Some(line.statistic),
        paired: Some(line.paired),
        improved_runs: Some(line.improved_runs),
        baseline_runs: Some(line.baseline_runs),
        improved_value: line.improved_value,
        baseline_value: line.baseline_value,
        effect: line.found,
        effect_low: line.effect.map(|e| e.low),
        effect_high: line.effect.map(|e| e.high),
        better: line.better,
        p: line.p,
        verdict: Some(line.verdict),
        why: &line.why,
        ..Line::default()
    }
}

fn of_maps(over: &OverMaps) -> Line<'_> {
    let finite = |v: Option<f64>| v.filter(|v| v.is_finite());
    Line {
        claim: &over.claim,
        improved: &over.improved,
        baseline: &over.baseline,
        measure: Some(over.measure),
        direction: Some(over.direction),
        claimed: over.claimed,
        relevant: over.relevant,
        effect: finite(over.median),
        effect_low: finite(over.low),
        effect_high: finite(over.high),
        p: over.sign_p,
        maps: Some(over.maps),
        better_maps: Some(over.better),
        worse_maps: Some(over.counts.opposite),
        share_low: Some(over.share_interval[0]),
        share_high: Some(over.share_interval[1]),
        above: Some(over.above),
        level: Some(over.level),
        below: Some(over.below),
        confidence: over.confidence,
        overall: Some(over.verdict),
        ..Line::default()
    }
}

#[cfg(test)]
mod tests;
