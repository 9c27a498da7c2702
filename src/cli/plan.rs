//! `plan`: one planner on one scenario.

use std::fmt::Write;
use std::num::NonZero;
use std::thread;

use crate::catalog;
use crate::comparison::gap::relative_gap;
use crate::exact::{self, Reference};
use crate::formats::run_result::{self, RunResult};
use crate::planner::{Certificate, Effort, Objective, Planner, Record, Status};
use crate::scenario::{Goal, Scenario, ScenarioSpec};

use super::driving;
use super::error::CliError;
use super::input::ScenarioArgs;
use super::plan_format::{Format, path_file};
use super::planner_args::PlannerArgs;
use super::streams::say;
use super::text::{self, row};
use super::{Outcome, text::grouped};

/// Plans a path and compares it with the exact optimum
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  formicarium plan maze.csv --planner ant-system --from 0,0 --to 19,19 --seed 3
  formicarium plan arena2.map --scen arena2.map.scen:200 --planner astar
  formicarium plan maze.csv --planner fire --from 0,0 --to 19,19 --to 3,17 --to 16,2
  formicarium plan room.json --planner ant-system --set ants=40 --set rho=0.2 --format csv > curve.csv
  formicarium plan dem.asc --planner astar --moves 16 --max-slope 25
  formicarium plan room.json --planner theta-star --smooth=2 --format json
  formicarium plan heights.csv --planner slices-exact --model slices --from 0,9 --from-level 4 --to 20,7 --to-level 5
  formicarium generate rooms --size 80x60 | formicarium plan - --planner dijkstra --format json
  formicarium plan map.yaml --planner any-angle --from -1.5m,2m --to 3m,0.5m --format nav-msgs > path.yaml

Exit code 1 when no path was found.")]
pub struct Args {
    #[command(flatten)]
    scenario: ScenarioArgs,
    #[command(flatten)]
    planner: PlannerArgs,
    /// Threads on which the ants of an iteration walk, 0 for all cores; the run is the same for any number
    #[arg(long, value_name = "N", default_value_t = 1)]
    threads: usize,
    /// text, json (everything) or csv (one row per iteration); or the path for other programs: path-csv, path-json, nav-msgs (ROS 2), geojson, svg
    #[arg(long, value_enum, hide_possible_values = true, default_value_t = Format::Text)]
    format: Format,
}

impl Args {
    pub fn wants_json(&self) -> bool {
        self.format == Format::Json
    }
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let PlannerArgs { preset, seed, .. } = &args.planner;
    let (entry, values) = (args.planner.entry()?, args.planner.values());
    let scenario = args.scenario.load()?;
    args.format.check(&scenario.spec)?;
    if scenario.spec.drive.is_some() {
        say(
            "note: things move in this scenario while a robot drives; this is a plan before its first step, `drive` has it drive",
        );
    }
    let mut planner = catalog::build(&scenario, entry.id, preset.as_deref(), &values, *seed)?;
    if args.threads != 1 && !planner.walk_on(threads(args.threads)) {
        say(format!(
            "note: --threads changes nothing here: {} has no ants, or they share what changes while they walk",
            entry.id
        ));
    }
    planner.run();
    let last = run_result::last(&scenario, planner.as_ref());
    if let Format::Path(format) = args.format {
        return path_file(format, &last, planner.as_ref());
    }
    let result = RunResult::of(entry.id, *seed, &scenario, planner.as_ref());
    let fine = result.metrics.is_some();
    let report = Report { args, scenario: &last, name: entry.name, planner: planner.as_ref(), result };
    let text = match args.format {
        Format::Json => text::json(&report.result, 2),
        Format::Csv => csv(planner.history()),
        _ => report.text(),
    };
    Ok(Outcome { text, fine })
}

/// So many, or one for each core.
fn threads(asked: usize) -> NonZero<usize> {
    NonZero::new(asked).or_else(|| thread::available_parallelism().ok()).unwrap_or(NonZero::<usize>::MIN)
}

/// One finished run.
struct Report<'a> {
    args: &'a Args,
    scenario: &'a Scenario,
    name: &'a str,
    planner: &'a dyn Planner,
    result: RunResult<'a>,
}

impl Report<'_> {
    fn text(&self) -> String {
        let (grid, spec) = (&self.scenario.grid, &self.scenario.spec);
        let on = if spec.name.is_empty() { String::new() } else { format!(" on {}", spec.name) };
        let size = format!("{} × {}, {} free cells", grid.width(), grid.height(), grouped(grid.free_count() as u64));
        let mut out = format!("{}{on} ({size})\n\n", self.name);
        row(&mut out, "from, to", from_to(spec));
        row(&mut out, "status", self.status_text());
        match &self.result.metrics {
            Some(metrics) => {
                self.gap_text(&mut out);
                self.polyline_text(&mut out);
                text::metrics(&mut out, metrics, spec.scale());
                driving::smoothed(&mut out, &spec.vehicle, self.result.smoothed.as_ref(), spec.scale());
            }
            None => {
                if let Some(value) = self.result.reference.value() {
                    let label = if self.result.optimum.is_some() { "optimum" } else { "reference" };
                    row(&mut out, label, format!("{}: a path exists, none was found", self.amount(value)));
                }
            }
        }
        self.tour_text(&mut out);
        self.run_text(&mut out);
        out
    }

    /// A value of the planner's objective.
    fn amount(&self, value: f64) -> String {
        match self.planner.objective() {
            Objective::SliceCost => format!("{value:.4} cells and levels"),
            // What is dear is no longer.
            Objective::Weighted => text::length(value, None),
            _ if self.scenario.moves.weights().is_some() => text::length(value, None),
            _ => self.length(value),
        }
    }

    /// A length in cells, and in metres where the map has a scale.
    fn length(&self, cells: f64) -> String {
        text::length(cells, self.scenario.spec.scale())
    }

    fn gap_text(&self, out: &mut String) {
        if self.planner.tour().is_some() && self.result.reference == Reference::Unknown && self.result.certificate.is_none() {
            row(
                out,
                "gap",
                format!("unknown: the best order of more than {} goals is not always soon proven", exact::order::MAX_ORDERED),
            );
        }
        let (Some(gap), Some(value)) = (self.result.gap, self.result.reference.value()) else { return };
        let of = match self.result.reference {
            Reference::Proven { .. } => format!("the optimum of {}", self.amount(value)),
            _ => format!("{}, a good result without a proof", self.amount(value)),
        };
        row(
            out,
            "gap",
            format!("{} above {of} ({})", text::percent(gap), text::objective(self.planner.objective(), self.scenario)),
        );
    }

    /// What refinement has saved, and the bound that no polyline can beat.
    fn polyline_text(&self, out: &mut String) {
        let Some(best) = self.planner.best().filter(|_| self.planner.objective() == Objective::PolylineLength) else { return };
        if best.refined.is_some() {
            row(out, "unrefined", format!("{} by steps", self.length(best.length)));
        }
        match exact::point_robot(self.scenario) {
            Ok(Some(bound)) => {
                let than = if self.scenario.moves.weights().is_some() { "costs less" } else { "is shorter" };
                row(out, "point robot", format!("{}: no polyline through centres {than}", self.length(bound)));
            }
            Ok(None) => {}
            Err(limit) => row(out, "point robot", limit),
        }
    }

    /// The order of the goals, what it costs, and each leg.
    fn tour_text(&self, out: &mut String) {
        let Some(tour) = self.planner.tour() else { return };
        let (goals, scale) = (&self.scenario.spec.goals, self.scenario.spec.scale());
        let name = |goal: &Goal| if goal.name.is_empty() { text::cell(goal.at) } else { goal.name.clone() };
        let visited: Vec<&Goal> = tour.order.iter().map(|&i| &goals[i as usize]).collect();
        row(out, "order", visited.iter().map(|g| name(g)).collect::<Vec<_>>().join(" → "));
        row(out, "planned", self.tour_sums(tour.planned_length, tour.planned_weight));
        if let Some(weight) = tour.walked_weight {
            row(out, "walked", self.tour_sums(tour.walked.iter().sum(), weight));
        }
        let metres = if scale.is_some() { format!("{:>12}{:>12}", "planned m", "walked m") } else { String::new() };
        row(out, "legs", format!("{:<14}{:>10}{:>10}{:>10}{:>10}{metres}", "to", "planned", "walked", "b", "R walked"));
        for (leg, goal) in visited.iter().enumerate() {
            let walked = tour.walked.get(leg);
            let number = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| format!("{v:.4}"));
            let lengths = [tour.planned.get(leg).copied(), walked.copied()];
            let [planned, on_foot] = lengths;
            let cells = [planned, on_foot, Some(goal.weight()), walked.map(|w| w * goal.weight())];
            let cells = cells.map(|v| format!("{:>10}", number(v))).concat();
            let metres = scale.map(|metres| lengths.map(|v| format!("{:>12}", number(v.map(|v| metres * v)))).concat());
            row(out, "", format!("{:<14}{cells}{}", name(goal), metres.unwrap_or_default()));
        }
    }

    fn tour_sums(&self, length: f64, weight: f64) -> String {
        let metres = |scale: f64| format!(" = {:.4}, {:.4} m", scale * length, scale * weight);
        format!("length {length:.4}, weight R {weight:.4} cells{}", self.scenario.spec.scale().map_or_else(String::new, metres))
    }

    fn status_text(&self) -> String {
        match self.result.status {
            Status::Running => "running".into(),
            Status::Optimal => "optimal (proven)".into(),
            Status::Complete => "complete (not proven)".into(),
            Status::Stagnated => "stagnated".into(),
            Status::BudgetSpent if self.planner.budget().is_none() => "stopped at the limit of its work".into(),
            Status::BudgetSpent => "budget spent".into(),
            Status::NoPath => "no path exists".into(),
        }
    }

    /// What the planner has proven of a result of this value.
    fn proof_text(&self, certificate: Certificate, value: f64) -> String {
        let than = match self.planner.objective() {
            Objective::Length | Objective::PolylineLength | Objective::TourLength if self.scenario.moves.weights().is_none() => {
                "no path is shorter than"
            }
            Objective::TourWeight => "no path weighs less than",
            _ => "no path comes to less than",
        };
        // Rounded down, unless it is the value itself.
        let least = if certificate.complete { value } else { libm::floor(1e4 * certificate.lower_bound) / 1e4 };
        let bound = self.amount(least);
        let expansions = text::count(certificate.expansions, "cell expansion", "cell expansions");
        if certificate.complete {
            return format!("{than} {bound}: {expansions}");
        }
        let gap = text::percent_at_most(relative_gap(value, certificate.lower_bound));
        format!("{than} {bound}, so this one is within {gap}: stopped after {expansions}")
    }

    /// The lines about the run itself.
    fn run_text(&self, out: &mut String) {
        let effort = self.planner.effort();
        if let Some((best, _)) = self.planner.best().zip(self.planner.budget()) {
            row(out, "found in", format!("iteration {} of {}", best.iteration, effort.iterations));
        }
        if let Some(changing) = self.planner.changing() {
            let how = match (changing.adapts(), changing.budget()) {
                (true, Some(_)) => "trails were kept",
                (true, None) => "it repaired its search",
                (false, _) => "it began anew each time",
            };
            row(out, "walls", format!("{}; {how}", text::count(changing.made().into(), "change", "changes")));
        }
        if let Some((certificate, value)) = self.result.certificate.zip(self.result.value) {
            row(out, "proof", self.proof_text(certificate, value));
        }
        row(out, "effort", effort_text(&effort));
        row(out, "seed", self.args.planner.seed);
        row(out, "digest", self.planner.digest().hex());
    }
}

fn from_to(spec: &ScenarioSpec) -> String {
    match spec.goals.as_slice() {
        [goal] => format!("{} → {}", text::cell(spec.start), text::cell(goal.at)),
        goals => format!("{} → {} goals", text::cell(spec.start), goals.len()),
    }
}

/// What was spent, in words.
pub fn effort_text(effort: &Effort) -> String {
    let parts = [
        (effort.constructed_paths, "constructed path", "constructed paths"),
        (effort.ant_moves, "ant move", "ant moves"),
        (effort.cell_expansions, "cell expansion", "cell expansions"),
    ];
    let said: Vec<String> = parts.iter().filter(|p| p.0 > 0).map(|p| text::count(p.0, p.1, p.2)).collect();
    if said.is_empty() { "none".into() } else { said.join(", ") }
}

/// The history, one row per iteration; an empty field where no ant arrived.
fn csv(history: &[Record]) -> String {
    let number = |v: Option<f64>| v.map_or_else(String::new, |v| v.to_string());
    let mut out = String::from("iteration,best_so_far,iteration_best,iteration_mean,iteration_worst,arrived\n");
    for r in history {
        let lengths = [r.best_so_far, r.iteration_best, r.iteration_mean, r.iteration_worst].map(number);
        let _ = writeln!(out, "{},{},{}", r.iteration, lengths.join(","), r.arrived);
    }
    out
}
