//! What a comparison says: a CSV with one row a run, and a page of tables. Every number in one fixed form.

mod ablation;
mod csv;
mod escape;
mod file;
mod latex;
mod matrix;
mod names;
mod printed;
mod table;
mod tests;
mod verdicts;

use std::fmt::Write;

use self::escape::{cell, prose};
use self::names::{asked_name, name, named};
use super::ablation::effects;
use super::analysis::{Analysis, EntryAnalysis, MapAnalysis, Origin};
use super::measure::RunMeasure;
use super::question::{Entry, Published, Role};
use super::row::Row;
use super::samples::{Samples, Seen};
use super::statistics::Summary;
use super::{Comparison, Map, Yardstick};
use crate::exact::Reference;
use crate::map::{CornerRule, Movement, Moves};
use crate::scenario::Scenario;

pub use ablation::components;
pub use csv::{HEADER, csv, line};
pub use file::{Reports, ResultFile};
pub use latex::latex;
pub use matrix::{csv as matrix_csv, latex as matrix_latex, markdown as matrix_markdown};
pub use printed::markdown as summary_markdown;
pub use table::{csv as summary_csv, json as summary_json};
pub use tests::{tests, tests_csv};
pub use verdicts::verdicts;

/// The page: what was asked, a table for each map, what became of each claim, and of an ablation what each component does. `command` repeats
/// it.
pub fn markdown(comparison: &Comparison, rows: &[Row], analysis: &Analysis, command: &str) -> String {
    let mut out = head(comparison, analysis, command);
    entries(&mut out, comparison);
    for (map, of) in comparison.maps.iter().zip(&analysis.instances) {
        map_table(&mut out, comparison, map, of);
    }
    verdicts::claims_table(&mut out, comparison, &analysis.judged);
    ablation::tables(&mut out, comparison, &effects(&Samples::new(comparison, rows.iter().map(Seen::from))));
    out
}

fn head(comparison: &Comparison, analysis: &Analysis, command: &str) -> String {
    let q = &comparison.question;
    let paper = if q.paper.is_empty() { String::new() } else { format!("Paper: {}.\n\n", prose(&q.paper)) };
    let setting = setting_of(comparison, analysis);
    let (title, asks, command) = (prose(&q.title), prose(&q.asks), prose(command));
    format!("# {title}\n\n{asks}\n\n{paper}Made by `{command}` with {setting} How to read it: docs/methodology.md.\n")
}

/// What numbers depend on beside the question: engine, seeds, budget.
fn setting_of(comparison: &Comparison, analysis: &Analysis) -> String {
    let q = &comparison.question;
    let runs = analysis.counts.words();
    let last = q.seeds.from.saturating_add(q.seeds.count.saturating_sub(1));
    let seeds = format!("seeds {} to {last} of every entry on every map, {runs}", q.seeds.from);
    let budget = q.budget.map_or_else(String::new, |b| format!(", of each at most {} {} count", b.amount, b.axis.words()));
    format!("engine version {}: {seeds}{budget}.", env!("CARGO_PKG_VERSION"))
}

/// Which entries make what small, on each map where they differ in that.
fn objectives_notes(analysis: &Analysis) -> impl Iterator<Item = String> {
    analysis.instances.iter().filter(|map| map.mixed_objectives).map(|map| {
        let of = |objective| {
            let by: Vec<_> = map.entries.iter().filter(|e| e.objective == Some(objective)).map(|e| e.label.as_str()).collect();
            format!("{} ({})", objective.words(), by.join(", "))
        };
        let all: Vec<String> = map.references.iter().map(|yardstick| of(yardstick.objective)).collect();
        format!("{}, the entries make different things small, by which their gaps go: {}", map.name, all.join("; "))
    })
}

/// What each entry runs.
fn entries(out: &mut String, comparison: &Comparison) {
    out.push_str("\n| entry | | runs |\n|---|---|---|\n");
    for e in &comparison.question.entries {
        let role = match e.role {
            Role::Baseline => "baseline",
            Role::Improved => "improved",
            Role::Other => "",
        };
        let _ = writeln!(out, "| {} | {role} | {} |", cell(&asked_name(e)), cell(&recipe(e)));
    }
}

/// An entry as arguments of `formicarium plan`.
fn recipe(entry: &Entry) -> String {
    if let Some(file) = &entry.results {
        return format!("results from {file}");
    }
    let Some(planner) = &entry.planner else {
        return format!("not run: {}", entry.missing.as_deref().unwrap_or("no planner"));
    };
    let preset = entry.preset.as_ref().map_or_else(String::new, |p| format!(" --preset {p}"));
    let set: String = entry.set.iter().map(|(key, value)| format!(" --set {key}={value}")).collect();
    format!("`--planner {planner}{preset}{set}`")
}

fn map_table(out: &mut String, comparison: &Comparison, map: &Map, of: &MapAnalysis) {
    let grid = &map.scenario.grid;
    let _ = writeln!(out, "\n## {}\n", prose(&of.name));
    let _ = writeln!(out, "`{}`, {} × {}, {}. {}\n", of.id, grid.width(), grid.height(), moves(&map.scenario), prose(&of.note));
    let _ = write!(out, "| | published: {} / turns / iterations ", of.measure_name);
    out.push_str("| found a path | best | median | IQR | mean ± sd [95 %] | iteration of best: median (IQR) ");
    out.push_str(
        "| constructed paths to best: median | turns: median (IQR) | optimal |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    for (entry, asked) in of.entries.iter().zip(&comparison.question.entries) {
        let published = asked.published.get(&of.id).map_or_else(|| "–".into(), |row| published(of.measure, row));
        let _ = writeln!(out, "| {} | {published} | {} |", cell(&name(entry)), ours(entry));
    }
    of.references.iter().for_each(|yardstick| reference(out, of, yardstick));
    impossible(out, of);
}

/// The best there is by an objective; where nothing is proven, the best of these runs stands in.
fn reference(out: &mut String, map: &MapAnalysis, yardstick: &Yardstick) {
    let name = yardstick.objective.words();
    let by = map.entries.iter().filter(|e| e.objective == Some(yardstick.objective));
    let best = by.filter_map(|e| e.best).reduce(f64::min);
    let (name, value) = match yardstick.reference {
        Reference::Proven { value } => (format!("exact optimum, {name}"), length(value)),
        Reference::Unproven { value } => {
            (format!("best known, not proven, {name}"), length(best.map_or(value, |best| best.min(value))))
        }
        Reference::NoPath => ("exact".into(), "no path exists".into()),
        Reference::Unknown => (format!("best of these runs, nothing is proven, {name}"), best.map_or("none".into(), length)),
    };
    let _ = writeln!(out, "| {name} | | | {value} | | | | | | | |");
}

/// Names what no path on this map can have.
fn impossible(out: &mut String, map: &MapAnalysis) {
    let mut told = Vec::new();
    for e in &map.entries {
        if let Some((value, optimum)) = e.published.filter(|p| p.impossible).and_then(|p| p.value.zip(p.optimum)) {
            let what = format!("the published {value} is impossible on this map under its rule");
            told.push(format!("{}: {what}: the exact optimum is {}.", prose(&e.label), length(optimum)));
        }
        if e.impossible > 0 {
            let what = format!("{} of {} runs are impossible on this map under its rule", e.impossible, e.runs);
            let why = "they are better than the exact optimum, or there is no path; so the entry is not ranked or tested";
            told.push(format!("{}: {what}: {why}.", prose(&named(&e.label, e.origin == Origin::Results))));
        }
    }
    if !told.is_empty() {
        let _ = writeln!(
            out,
            "\n- {}\n\nOf a map that only stands for the publication's, this says that the two differ.",
            told.join("\n- ")
        );
    }
}

/// How one moves on a map.
fn moves(scenario: &Scenario) -> String {
    if let Some(slices) = scenario.by_slices() {
        let r = slices.rules();
        return format!("by slices, {} levels of {} m, |Δy| ≤ {}, |Δh| ≤ {}", r.levels, r.level, r.max_aside, r.max_climb);
    }
    let Movement { moves, corner_rule } = scenario.spec.movement;
    let rule = match (moves, corner_rule) {
        (Moves::Four, _) => "",
        (_, CornerRule::Always) => ", `always`",
        (_, CornerRule::OneFree) => ", `one-free`",
        (_, CornerRule::BothFree) => ", `both-free`",
    };
    let surface = if scenario.moves.relief().is_some() { ", on the surface" } else { "" };
    format!("{} moves{rule}{surface}", u8::from(moves))
}

fn published(main: RunMeasure, row: &Published) -> String {
    let number = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| v.to_string());
    let also = |name: &str, v: Option<f64>| v.map_or_else(String::new, |v| format!(", {name} = {v}"));
    let extra = also("V", row.turn_index) + &also("R", row.weight);
    format!("{} / {} / {}{extra}", number(main.published(row)), number(row.turns), number(row.iterations))
}

/// The cells of a table from our runs, best to deviation by the main measure; of paths, over the runs that found one.
fn ours(e: &EntryAnalysis) -> String {
    const NONE: &str = "– | – | – | – | – | – | – | –";
    if e.runs == 0 {
        return format!("not run | {NONE}");
    }
    let share = format!("{} of {}", e.with_path, e.runs);
    let Some(l) = &e.summary else { return format!("{share} | {NONE}") };
    let spread = l.deviation.map_or_else(|| length(l.mean), |sd| format!("{} ± {}", length(l.mean), length(sd)));
    let range = e.mean_interval.map_or_else(String::new, |[low, high]| format!(" [{}, {}]", length(low), length(high)));
    let known = |text: Option<String>| text.unwrap_or_else(|| "–".into());
    format!(
        "{share} | {} | {} | {}–{} | {spread}{range} | {} | {} | {} | {}",
        length(l.least),
        length(l.median),
        length(l.lower),
        length(l.upper),
        known(e.iteration_of_best.as_ref().map(middle)),
        known(e.paths_to_best.map(|paths| short(paths.median))),
        known(e.turns.as_ref().map(middle)),
        if e.proven { e.optimal.to_string() } else { "–".into() },
    )
}

fn middle(s: &Summary) -> String {
    format!("{} ({}–{})", short(s.median), short(s.lower), short(s.upper))
}

fn length(v: f64) -> String {
    format!("{v:.3}")
}

/// Up to two decimals.
fn short(v: f64) -> String {
    let text = format!("{v:.2}");
    text.trim_end_matches('0').trim_end_matches('.').into()
}
