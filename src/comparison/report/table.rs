//! The summary: one line an entry and map, as CSV and JSON with every number. `printed` has those that a paper prints.

use serde::Serialize;

use crate::comparison::Comparison;
use crate::comparison::analysis::{
    Analysis, EntryAnalysis, MapAnalysis, NoRunningTime, Origin, Pair, Ranks, RunningTime, VerdictLine,
};
use crate::comparison::budget::{Axis, Budget};
use crate::comparison::facts::UnfitMap;
use crate::comparison::measure::RunMeasure;
use crate::comparison::over_maps::OverMaps;
use crate::comparison::question::{Question, Role, Seeds};
use crate::planner::Objective;

/// What `format` says in JSON.
const FORMAT: &str = "formicarium/summary@1";

/// One entry on one map, with every number. In CSV these are the columns; numbers that nobody knows are empty there and null in JSON.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Line<'a> {
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
    median_gap: Option<f64>,
    objective: Option<Objective>,
    needs_no_seed: bool,
    no_running_time: Option<NoRunningTime>,
}

/// All lines, in the order of the question.
fn lines<'a>(comparison: &Comparison, analysis: &'a Analysis) -> Vec<Line<'a>> {
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
        median_gap: e.gap.map(|s| s.median),
        objective: e.objective,
        needs_no_seed: e.needs_no_seed,
        no_running_time: e.no_running_time,
    }
}

pub(super) fn running_time(entry: &EntryAnalysis, gap: f64) -> Option<f64> {
    let near = |time: &&RunningTime| (time.gap - gap).abs() < f64::EPSILON;
    entry.running_times.iter().find(near).and_then(|time| time.expected)
}

/// As CSV, all numbers with as many digits as tell them apart from any other.
pub(super) fn csv(comparison: &Comparison, analysis: &Analysis) -> String {
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
    over_maps: &'a [OverMaps],
    unfit: &'a [UnfitMap],
}

/// The tests of one map.
#[derive(Serialize)]
struct PairsOf<'a> {
    instance: &'a str,
    entries: Vec<&'a str>,
    pairs: &'a [Pair],
}

/// As JSON: what was asked, the lines, the tests of all pairs, the ranks over all maps and the verdicts.
pub(super) fn json(comparison: &Comparison, analysis: &Analysis) -> String {
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
        over_maps: &analysis.over_maps,
        unfit: &analysis.unfit,
    };
    serde_json::to_string_pretty(&whole).expect("plain data can always be written as JSON") + "\n"
}

/// The entries that the tests of a map count from 0.
fn ids(map: &MapAnalysis) -> Vec<&str> {
    map.entries.iter().map(|e| e.id.as_str()).collect()
}
