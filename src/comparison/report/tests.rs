//! Every pair of entries on every map, and all entries over all maps: rank tests with what many of them at once ask for.

use std::fmt::Write;

use serde::Serialize;

use super::escape::prose;
use super::names::{id, impossible_note, named};
use crate::comparison::Comparison;
use crate::comparison::analysis::{Analysis, MapAnalysis, Pair, Ranks};
use crate::comparison::inference::{MIN_RUNS, Test};

/// The page of tests: a table of pairs for each map, then ranks over the maps. Which measure is compared follows from the map.
pub fn tests(comparison: &Comparison, analysis: &Analysis) -> String {
    let mut out = format!(
        "# {}: tests\n\nTwo-sided rank tests of every pair of entries, runs without a path ranked last. W: Wilcoxon's signed ranks over pairs of \
         equal seed; U: Mann and Whitney's, seeds not paired; p by Holm is adjusted for all pairs of the map. A: how likely a run of the first \
         entry is the better (smaller) one, ties counted half. How to read it: docs/methodology.md.\n",
        prose(&comparison.question.title)
    );
    for map in &analysis.instances {
        let _ = writeln!(out, "\n## {}, {}\n", map.id, map.measure_name);
        pairs_table(&mut out, map);
        let impossible = impossible_note(map);
        if !impossible.is_empty() {
            let _ = writeln!(out, "\n{impossible}.");
        }
    }
    if let Some(ranks) = &analysis.ranks {
        over_maps(&mut out, comparison, ranks);
    }
    out
}

fn pairs_table(out: &mut String, map: &MapAnalysis) {
    if map.pairs.iter().all(|pair| pair.mann_whitney.is_none()) {
        let _ = writeln!(out, "No two entries with {MIN_RUNS} runs or more: no tests.");
        return;
    }
    out.push_str("| first | second | median, first | second | A | W | p | p by Holm | U | p | p by Holm |\n");
    out.push_str("|---|---|---|---|---|---|---|---|---|---|---|\n");
    map.pairs.iter().for_each(|pair| pair_row(out, map, pair));
}

fn pair_row(out: &mut String, map: &MapAnalysis, pair: &Pair) {
    let (first, second) = (&map.entries[pair.first], &map.entries[pair.second]);
    let statistic = |test: Option<Test>| test.map_or_else(|| "–".into(), |t| t.statistic.to_string());
    let p = |p: Option<f64>| p.map_or_else(|| "–".into(), probability);
    let median = |median: Option<f64>| median.filter(|v| v.is_finite()).map_or_else(|| "no path".into(), super::length);
    let _ = writeln!(
        out,
        "| {} | {} | {} | {} | {:.3} | {} | {} | {} | {} | {} | {} |",
        id(first),
        id(second),
        median(first.median()),
        median(second.median()),
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
fn over_maps(out: &mut String, comparison: &Comparison, ranks: &Ranks) {
    let label = |entry: usize| {
        let asked = &comparison.question.entries[entry];
        named(&asked.id, asked.results.is_some())
    };
    let (statistic, degrees, p) = (ranks.statistic, ranks.degrees, probability(ranks.p));
    let few = if ranks.maps < 10 { " So few maps can hardly show a difference." } else { "" };
    let _ = writeln!(
        out,
        "\n## Over all maps\n\nFriedman's test over the medians of {} maps: χ² = {statistic:.3} with {degrees} degrees of freedom, p = {p}.{few}\n",
        ranks.maps,
    );
    out.push_str("| entry | mean rank |\n|---|---|\n");
    for (entry, rank) in ranks.entries.iter().zip(&ranks.mean_ranks) {
        let _ = writeln!(out, "| {} | {rank:.2} |", label(*entry));
    }
    let differ = ranks.pairs.iter().filter(|pair| pair.holm < 0.05);
    let told: Vec<String> =
        differ.map(|pair| format!("{} and {} (p = {})", label(pair.first), label(pair.second), probability(pair.holm))).collect();
    let said = if told.is_empty() { "no two entries are shown to differ".into() } else { told.join("; ") };
    let _ = writeln!(out, "\nPost hoc, adjusted by Holm, at 5 %: {said}.");
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
pub fn tests_csv(comparison: &Comparison, analysis: &Analysis) -> String {
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
    let pair = move |pair: &crate::comparison::analysis::RankPair| Line {
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
