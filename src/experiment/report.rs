//! What an experiment says: a CSV with one row a run, and a page of tables. Every number in one fixed form.

mod csv;
mod tests;
mod verdicts;

use std::fmt::Write;

use super::claims::Comparison;
use super::question::{Contender, Instance, Measure, Published, Role};
use super::row::Row;
use super::setting::{Experiment, Map};
use super::statistics::Summary;
use crate::exact::Reference;
use crate::map::{CornerRule, Movement, Moves};
use crate::planner::Objective;
use crate::scenario::Scenario;

pub use csv::{HEADER, csv, line};
pub use tests::tests;
pub use verdicts::verdicts;

/// The page: what was asked, a table for each map, and what became of each claim. `command` repeats it.
pub fn markdown(experiment: &Experiment, rows: &[Row], comparisons: &[Comparison], command: &str) -> String {
    let mut out = head(experiment, rows.len(), command);
    entries(&mut out, experiment);
    for (index, instance) in experiment.question.instances.iter().enumerate() {
        map_table(&mut out, experiment, rows, index, instance);
    }
    verdicts::claims_table(&mut out, experiment, comparisons);
    out
}

fn head(experiment: &Experiment, runs: usize, command: &str) -> String {
    let q = &experiment.question;
    let paper = if q.paper.is_empty() { String::new() } else { format!("Paper: {}.\n\n", q.paper) };
    let last = q.seeds.from.saturating_add(q.seeds.count.saturating_sub(1));
    let seeds = format!("seeds {} to {last} of every entry on every map, {runs} runs", q.seeds.from);
    format!(
        "# {}\n\n{}\n\n{paper}Made by `{command}` with engine version {}: {seeds}. How to read it: docs/methodology.md.\n",
        q.title,
        q.asks,
        env!("CARGO_PKG_VERSION"),
    )
}

/// What each entry runs.
fn entries(out: &mut String, experiment: &Experiment) {
    out.push_str("\n| entry | | runs |\n|---|---|---|\n");
    for e in &experiment.question.entries {
        let role = match e.role {
            Role::Baseline => "baseline",
            Role::Improved => "improved",
            Role::Other => "",
        };
        let _ = writeln!(out, "| {} | {role} | {} |", e.label, recipe(e));
    }
}

/// An entry as arguments of `formicarium plan`.
fn recipe(entry: &Contender) -> String {
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

fn map_table(out: &mut String, experiment: &Experiment, rows: &[Row], index: usize, instance: &Instance) {
    let Some(map) = experiment.maps.get(index) else { return };
    let (grid, spec) = (&map.scenario.grid, &map.scenario.spec);
    let name = if spec.name.is_empty() { &instance.id } else { &spec.name };
    let _ = writeln!(out, "\n## {name}\n");
    let _ =
        writeln!(out, "`{}`, {} × {}, {}. {}\n", instance.id, grid.width(), grid.height(), moves(&map.scenario), instance.note);
    let main = map.measure();
    let _ = write!(out, "| | published: {} / turns / iterations ", main.name());
    out.push_str("| found a path | best | median | IQR | mean ± sd | iteration of best: median (IQR) ");
    out.push_str(
        "| constructed paths to best: median | turns: median (IQR) | optimal |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    for (entry, contender) in experiment.question.entries.iter().enumerate() {
        let of: Vec<&Row> = rows.iter().filter(|r| (r.task.instance, r.task.entry) == (index, entry)).collect();
        let published = contender.published.get(&instance.id).map_or_else(|| "–".into(), |row| published(main, row));
        let _ = writeln!(out, "| {} | {published} | {} |", contender.label, ours(experiment, main, &of));
    }
    references(out, map, |objective| best_of_runs(map, rows, index, objective));
}

/// The best value that any of the runs on a map has reached by an objective.
fn best_of_runs(map: &Map, rows: &[Row], instance: usize, objective: Objective) -> Option<f64> {
    let by = |r: &&Row| map.objective(r.task.entry) == Some(objective);
    let found = rows.iter().filter(|r| r.task.instance == instance).filter(by).filter_map(|r| Some(r.found.as_ref()?.value));
    found.reduce(f64::min)
}

/// The best there is, by each objective that some entry has; where nothing is proven, the best of these runs stands in.
fn references(out: &mut String, map: &Map, best_of_runs: impl Fn(Objective) -> Option<f64>) {
    for yardstick in map.yardsticks() {
        let name = yardstick.objective.words();
        let (name, value) = match yardstick.reference {
            Reference::Proven { value } => (format!("exact optimum, {name}"), length(value)),
            Reference::Unproven { value } => {
                let best = best_of_runs(yardstick.objective).map_or(value, |best| best.min(value));
                (format!("best known, not proven, {name}"), length(best))
            }
            Reference::NoPath => ("exact".into(), "no path exists".into()),
            Reference::Unknown => {
                let best = best_of_runs(yardstick.objective).map_or("none".into(), length);
                (format!("best of these runs, nothing is proven, {name}"), best)
            }
        };
        let _ = writeln!(out, "| {name} | | | {value} | | | | | | | |");
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

fn published(main: Measure, row: &Published) -> String {
    let number = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| v.to_string());
    let also = |name: &str, v: Option<f64>| v.map_or_else(String::new, |v| format!(", {name} = {v}"));
    let extra = also("V", row.turn_index) + &also("R", row.weight);
    format!("{} / {} / {}{extra}", number(main.published(row)), number(row.turns), number(row.iterations))
}

/// The cells of a table from our runs, best to deviation by the main measure; of paths, over the runs that found one.
fn ours(experiment: &Experiment, main: Measure, rows: &[&Row]) -> String {
    const NONE: &str = "– | – | – | – | – | – | – | –";
    if rows.is_empty() {
        return format!("not run | {NONE}");
    }
    let found: Vec<&&Row> = rows.iter().filter(|r| r.found.is_some()).collect();
    let share = format!("{} of {}", found.len(), rows.len());
    let of = |measure| Summary::of(&found.iter().filter_map(|r| r.value(measure)).collect::<Vec<_>>());
    let all = (of(main), of(Measure::IterationOfBest), of(Measure::PathsToBest), of(Measure::Turns));
    let (Some(l), Some(iteration), Some(paths), Some(turns)) = all else { return format!("{share} | {NONE}") };
    let spread = l.deviation.map_or_else(|| length(l.mean), |sd| format!("{} ± {}", length(l.mean), length(sd)));
    let optimal = rows.iter().filter(|r| experiment.value(r, Measure::Optimal) == Some(1.0)).count();
    format!(
        "{share} | {} | {} | {}–{} | {spread} | {} | {} | {} | {optimal}",
        length(l.least),
        length(l.median),
        length(l.lower),
        length(l.upper),
        middle(&iteration),
        short(paths.median),
        middle(&turns),
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
