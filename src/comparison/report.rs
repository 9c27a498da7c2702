//! What a comparison says: a CSV with one row a run, and a page of tables. Every number in one fixed form, every word in the reader's language
//! (`words`).

mod ablation;
mod claims;
mod csv;
mod escape;
mod file;
mod fronts;
mod latex;
mod matrix;
mod names;
mod numbers;
mod printed;
mod readings;
mod table;
mod tests;
mod traces;
mod verdicts;
mod words;

use std::fmt::Write;

use self::escape::{cell, prose};
use self::names::{asked_name, name, named};
use self::numbers::{length, middle, short};
use self::words::Words;
use super::ablation::effects;
use super::analysis::{Analysis, EntryAnalysis, MapAnalysis, Origin};
use super::measure::RunMeasure;
use super::question::{Entry, Published};
use super::row::Row;
use super::samples::{Samples, Seen};
use super::{Comparison, Map, Yardstick};
use crate::exact::Reference;
use crate::map::{CornerRule, Movement, Moves};
use crate::scenario::Scenario;

pub use ablation::components;
pub use csv::{HEADER, line};
pub use file::{Reports, ResultFile};
pub use fronts::FRONTS_BEGIN;
pub use traces::{TRACE_HEADER, trace_lines};
pub use verdicts::verdicts;
pub use words::ReportLanguage;

/// The page: what was asked, a table for each map, what became of each claim, and of an ablation what each component does. `command` repeats
/// it.
fn markdown(words: &Words, comparison: &Comparison, rows: &[Row], analysis: &Analysis, command: &str) -> String {
    let mut out = head(words, comparison, analysis, command);
    entries(words, &mut out, comparison);
    claims::tables(words, &mut out, comparison, analysis);
    for (map, of) in comparison.maps.iter().zip(&analysis.instances) {
        map_table(words, &mut out, comparison, map, of);
    }
    ablation::tables(words, &mut out, comparison, &effects(&Samples::new(comparison, rows.iter().map(Seen::from))));
    out
}

fn head(words: &Words, comparison: &Comparison, analysis: &Analysis, command: &str) -> String {
    let (q, said) = (&comparison.question, &words.page);
    let paper = if q.paper.is_empty() { String::new() } else { (said.paper)(&prose(&q.paper)) + "\n\n" };
    let setting = (said.made_with)(&setting_of(words, comparison, analysis));
    let (title, asks, command) = (prose(&q.title), prose(&q.asks), prose(command));
    format!("# {title}\n\n{asks}\n\n{paper}{}`{command}`{setting}{}\n", said.made_by, said.how_to_read)
}

/// What numbers depend on beside the question: engine, seeds, budget.
fn setting_of(words: &Words, comparison: &Comparison, analysis: &Analysis) -> String {
    let q = &comparison.question;
    let last = q.seeds.from.saturating_add(q.seeds.count.saturating_sub(1));
    (words.names.setting)([q.seeds.from, last], analysis.counts, q.budget)
}

/// Which entries of a map, called by this, make what small.
fn objectives(words: &Words, map: &MapAnalysis, called: fn(&str) -> String) -> String {
    let of = |yardstick: &Yardstick| {
        let by = map.entries.iter().filter(|e| (e.objective, e.sum) == (Some(yardstick.objective), yardstick.sum));
        let by: Vec<_> = by.map(|e| called(&e.label)).collect();
        (words.signs.beside)((words.names.objective)(yardstick.objective, yardstick.measure), &by.join(words.signs.list))
    };
    map.references.iter().map(of).collect::<Vec<_>>().join(words.signs.parts)
}

/// What each entry runs.
fn entries(words: &Words, out: &mut String, comparison: &Comparison) {
    let _ = writeln!(out, "\n| {} | | {} |\n|---|---|---|", words.page.entry, words.page.runs);
    for e in &comparison.question.entries {
        let role = (words.names.role)(e.role);
        let _ = writeln!(out, "| {} | {role} | {} |", cell(&asked_name(words, e)), cell(&recipe(words, e)));
    }
}

/// An entry as arguments of `formicarium plan`.
fn recipe(words: &Words, entry: &Entry) -> String {
    let said = &words.page;
    if let Some(file) = &entry.results {
        return (said.results_from)(file);
    }
    let Some(planner) = &entry.planner else {
        return (said.cannot_run)(entry.missing.as_deref().unwrap_or(said.no_planner));
    };
    let preset = entry.preset.as_ref().map_or_else(String::new, |p| format!(" --preset {p}"));
    let set: String = entry.set.iter().map(|(key, value)| format!(" --set {key}={value}")).collect();
    format!("`--planner {planner}{preset}{set}`")
}

fn map_table(words: &Words, out: &mut String, comparison: &Comparison, map: &Map, of: &MapAnalysis) {
    let signs = &words.signs;
    let _ = writeln!(out, "\n## {}\n", prose(&of.name));
    let _ = writeln!(out, "`{}`{}{}{}{}\n", of.id, signs.comma, rule(words, map), signs.next, prose(&of.note));
    let published_head = (words.page.published)((words.names.measure)(of.measure));
    let columns = words.page.columns.join(" | ");
    let _ = writeln!(out, "| | {published_head} | {columns} |\n|{}", "---|".repeat(2 + words.page.columns.len()));
    let instance = comparison.question.instances.iter().find(|i| i.id == of.id);
    for (entry, asked) in of.entries.iter().zip(&comparison.question.entries) {
        let row = instance.and_then(|instance| asked.published_for(instance));
        let published = row.map_or_else(|| "–".into(), |row| published(of.measure, row));
        let _ = writeln!(out, "| {} | {published} | {} |", cell(&name(words, entry)), ours(words, entry));
    }
    of.references.iter().for_each(|yardstick| reference(words, out, of, yardstick));
    if of.references.iter().any(|yardstick| of.mixed_objectives || yardstick.measure != of.measure) {
        let small = (words.names.makes_small)(&objectives(words, of, |label| format!("“{label}”")));
        let _ = writeln!(out, "\n{}{}", prose(&printed::sentence(&small)), signs.end);
    }
    impossible(words, out, of);
}

/// The best there is by an objective; where nothing is proven, the best of these runs stands in.
fn reference(words: &Words, out: &mut String, map: &MapAnalysis, yardstick: &Yardstick) {
    let (said, name) = (&words.page, (words.names.objective)(yardstick.objective, yardstick.measure));
    let by = map.entries.iter().filter(|e| (e.objective, e.sum) == (Some(yardstick.objective), yardstick.sum));
    let best = by.filter_map(|e| e.best).reduce(f64::min);
    let (name, value) = match yardstick.reference {
        Reference::Proven { value } => ((said.exact_optimum)(name), length(value)),
        Reference::Unproven { value } => ((said.best_known)(name), length(best.map_or(value, |best| best.min(value)))),
        Reference::NoPath => (said.exact.into(), said.no_path_exists.into()),
        Reference::Unknown => ((said.best_of_runs)(name), best.map_or(said.none.into(), length)),
    };
    let _ = writeln!(out, "| {name} | | | {value} | | | | | | | |");
}

/// Names what no path on this map can have.
fn impossible(words: &Words, out: &mut String, map: &MapAnalysis) {
    let (said, about) = (&words.page, words.signs.about);
    let mut told = Vec::new();
    for e in &map.entries {
        if let Some((value, optimum)) = e.published.filter(|p| p.impossible).and_then(|p| p.value.zip(p.optimum)) {
            told.push(about(&prose(&e.label), &(said.published_impossible)(&value.to_string(), &length(optimum))));
        }
        if e.impossible > 0 {
            let name = named(words, &e.label, e.origin == Origin::Results);
            told.push(about(&prose(&name), &(said.runs_impossible)(e.impossible, e.runs)));
        }
    }
    if !told.is_empty() {
        let _ = writeln!(out, "\n- {}\n\n{}", told.join("\n- "), said.stand_in);
    }
}

/// Its size, and how one moves on it.
fn rule(words: &Words, map: &Map) -> String {
    let grid = &map.scenario.grid;
    format!("{} × {}{}{}", grid.width(), grid.height(), words.signs.comma, moves(words, &map.scenario))
}

fn moves(words: &Words, scenario: &Scenario) -> String {
    let said = &words.names;
    if let Some(slices) = scenario.by_slices() {
        let r = slices.rules();
        let numbers = [r.levels.to_string(), r.level.to_string(), r.max_aside.to_string(), r.max_climb.to_string()];
        return (said.by_slices)(numbers);
    }
    let Movement { moves, corner_rule } = scenario.spec.movement;
    let rule = match (moves, corner_rule) {
        (Moves::Four, _) => None,
        (_, CornerRule::Always) => Some("`always`"),
        (_, CornerRule::OneFree) => Some("`one-free`"),
        (_, CornerRule::BothFree) => Some("`both-free`"),
    };
    let rule = rule.map_or_else(String::new, |rule| format!("{}{rule}", words.signs.comma));
    let surface = if scenario.moves.relief().is_some() { said.on_surface } else { "" };
    let weighted = if scenario.moves.weights().is_some() { said.on_weighted } else { "" };
    let robot = scenario.spec.robot.map_or_else(String::new, |robot| (said.robot)(&robot.radius.to_string()));
    (said.moves)(&u8::from(moves).to_string()) + &rule + surface + weighted + &robot
}

fn published(main: RunMeasure, row: &Published) -> String {
    let number = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| v.to_string());
    let also = |name: &str, v: Option<f64>| v.map_or_else(String::new, |v| format!(", {name} = {v}"));
    let extra =
        also("V", row.turn_index) + &also("R", row.weight) + &row.arrival_time.map_or_else(String::new, |v| format!(", {v} s"));
    format!("{} / {} / {}{extra}", number(main.published(row)), number(row.turns), number(row.iterations))
}

/// The cells of a table from our runs, best to deviation by the main measure; of paths, over the runs that found one.
fn ours(words: &Words, e: &EntryAnalysis) -> String {
    const NONE: &str = "– | – | – | – | – | – | – | –";
    if e.runs == 0 {
        return format!("{} | {NONE}", words.names.not_run);
    }
    let share = (words.signs.part_of)(e.with_path, e.runs);
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
