//! Every pair of entries on every map, and all entries over all maps: rank tests with what many of them at once ask for.

use std::fmt::Write;

use serde::Serialize;

use super::escape::prose;
use super::names::{id, impossible_note, named};
use super::numbers::median;
use super::words::Words;
use crate::comparison::Comparison;
use crate::comparison::analysis::{Analysis, MapAnalysis, Pair, RankPair, Ranks};
use crate::comparison::inference::{MIN_RUNS, Test};

/// The page of tests: a table of pairs for each map, then ranks over the maps. Which measure is compared follows from the map.
pub(super) fn tests(words: &Words, comparison: &Comparison, analysis: &Analysis) -> String {
    let title = (words.tests.title)(&prose(&comparison.question.title));
    let mut out = format!("# {title}\n\n{}{}\n", words.tests.about, words.page.how_to_read);
    for map in &analysis.instances {
        let _ = writeln!(out, "\n## {}{}{}\n", map.id, words.signs.comma, (words.names.measure)(map.measure));
        pairs_table(words, &mut out, map);
        let impossible = impossible_note(words, map);
        if !impossible.is_empty() {
            let _ = writeln!(out, "\n{impossible}{}", words.signs.end);
        }
    }
    if let Some(ranks) = &analysis.ranks {
        over_maps(words, &mut out, comparison, ranks);
    }
    out
}

fn pairs_table(words: &Words, out: &mut String, map: &MapAnalysis) {
    if map.pairs.iter().all(|pair| pair.mann_whitney.is_none()) {
        let _ = writeln!(out, "{}", (words.tests.none)(MIN_RUNS));
        return;
    }
    let columns = &words.tests.columns;
    let _ = writeln!(out, "| {} |\n|{}", columns.join(" | "), "---|".repeat(columns.len()));
    map.pairs.iter().for_each(|pair| pair_row(words, out, map, pair));
}

fn pair_row(words: &Words, out: &mut String, map: &MapAnalysis, pair: &Pair) {
    let (first, second) = (&map.entries[pair.first], &map.entries[pair.second]);
    let statistic = |test: Option<Test>| test.map_or_else(|| "–".into(), |t| t.statistic.to_string());
    let p = |p: Option<f64>| p.map_or_else(|| "–".into(), probability);
    let _ = writeln!(
        out,
        "| {} | {} | {} | {} | {:.3} | {} | {} | {} | {} | {} | {} |",
        id(words, first),
        id(words, second),
        median(words, first.median()),
        median(words, second.median()),
        pair.a12,
        statistic(pair.wilcoxon),
        p(pair.wilcoxon.map(|t| t.p)),
        p(pair.wilcoxon_holm),
        statistic(pair.mann_whitney),
        p(pair.mann_whitney.map(|t| t.p)),
        p(pair.mann_whitney_holm),
    );
}

/// Friedman's test over the medians of all maps, and its post-hoc comparisons.
fn over_maps(words: &Words, out: &mut String, comparison: &Comparison, ranks: &Ranks) {
    let said = &words.tests;
    let label = |entry: usize| {
        let asked = &comparison.question.entries[entry];
        named(words, &asked.id, asked.results.is_some())
    };
    let friedman = (said.friedman)(ranks.maps, ranks.statistic, ranks.degrees, &probability(ranks.p));
    let few = if ranks.maps < 10 { said.few_maps } else { "" };
    let _ = writeln!(out, "\n## {}\n\n{friedman}{few}\n", said.over_maps);
    let _ = writeln!(out, "| {} |\n|---|---|", said.rank_columns.join(" | "));
    for (entry, rank) in ranks.entries.iter().zip(&ranks.mean_ranks) {
        let _ = writeln!(out, "| {} | {rank:.2} |", label(*entry));
    }
    let differ = ranks.pairs.iter().filter(|pair| pair.holm < 0.05);
    let of_pair = |pair: &RankPair| (said.differ)([&label(pair.first), &label(pair.second), &probability(pair.holm)]);
    let told: Vec<String> = differ.map(of_pair).collect();
    let told = if told.is_empty() { said.none_differ.into() } else { told.join(words.signs.parts) };
    let _ = writeln!(out, "\n{}", (said.post_hoc)(&told));
}

/// One test. Friedman's own, over all entries and maps, has no entries; it and the comparisons of mean ranks have no instance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct Line<'a> {
    instance: &'a str,
    test: &'a str,
    first: &'a str,
    second: &'a str,
    statistic: Option<f64>,
    p: f64,
    holm: Option<f64>,
    a12: Option<f64>,
}

/// Every test as a line of CSV: `wilcoxon` (W), `mann-whitney` (U of the first), `friedman` (χ²) and `mean-ranks` (the first's less the
/// second's).
pub(super) fn tests_csv(comparison: &Comparison, analysis: &Analysis) -> String {
    let mut lines = Vec::new();
    for map in &analysis.instances {
        for pair in &map.pairs {
            let (first, second) = (&map.entries[pair.first].id, &map.entries[pair.second].id);
            let tests =
                [("wilcoxon", pair.wilcoxon, pair.wilcoxon_holm), ("mann-whitney", pair.mann_whitney, pair.mann_whitney_holm)];
            let line = |(test, result, holm): (&'static str, Option<Test>, Option<f64>)| {
                let Test { statistic, p } = result?;
                Some(Line { instance: &map.id, test, first, second, statistic: Some(statistic), p, holm, a12: Some(pair.a12) })
            };
            lines.extend(tests.into_iter().filter_map(line));
        }
    }
    lines.extend(analysis.ranks.iter().flat_map(|ranks| over_maps_lines(comparison, ranks)));
    super::csv::of_lines(lines)
}

fn over_maps_lines<'a>(comparison: &'a Comparison, ranks: &'a Ranks) -> impl Iterator<Item = Line<'a>> {
    let label = |entry: usize| comparison.question.entries[entry].id.as_str();
    let rank = |entry: usize| ranks.entries.iter().position(|&e| e == entry).and_then(|place| ranks.mean_ranks.get(place));
    let over_all = Line { instance: "", test: "", first: "", second: "", statistic: None, p: 1.0, holm: None, a12: None };
    let friedman = Line { test: "friedman", statistic: Some(ranks.statistic), p: ranks.p, ..over_all };
    let pair = move |pair: &RankPair| Line {
        test: "mean-ranks",
        first: label(pair.first),
        second: label(pair.second),
        statistic: rank(pair.first).zip(rank(pair.second)).map(|(a, b)| a - b),
        p: pair.p,
        holm: Some(pair.holm),
        ..over_all
    };
    std::iter::once(friedman).chain(ranks.pairs.iter().map(pair))
}

/// A probability as people print it.
pub(super) fn probability(p: f64) -> String {
    if p < 0.0001 { "< 0.0001".into() } else { format!("{p:.4}") }
}
