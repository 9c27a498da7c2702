//! `bench-scen`: our optima, or those of a planner that proves them, against the listed ones of a MovingAI `.scen`.

mod proofs;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use crate::catalog;
use crate::error::Notice;
use crate::exact::Optima;
use crate::formats::{self, MAX_TEXT_BYTES, ScenFile, ScenLine, misfit};
use crate::map::{CornerRule, Grid, Movement, Point};
use crate::params::Values;
use crate::planner::{Certificate, Objective, PlannerEntry, Status};
use crate::rng::Streams;
use crate::scenario::{Goal, Scenario};
use rand::Rng;
use serde::Serialize;

use self::proofs::Proofs;
use super::error::CliError;
use super::reading::ReadingArgs;
use super::{Outcome, input, text, text::TextOrJson, text::row};

/// Compares the listed optima of a MovingAI .scen with ours, or with what a planner finds and proves
#[derive(clap::Args)]
#[command(after_help = "\
A length fits when it differs from the listed one by no more than half a unit of the last printed
digit plus 1e-6 of the length (older files were summed up with a rounded √2).

any-angle finds polylines: they fit when they are no longer than the listed path of steps. What
share is proven, and within a second, is told; where the limit of work was reached before, the
mean width of the interval that is left.

Without --planner only the lengths are computed, the fastest way there is: by jump points with
8 moves on a plane, by A* elsewhere. With it the planner of the catalog runs as it does everywhere.

Examples:
  formicarium bench-scen arena2.map.scen
  formicarium bench-scen scen/maze512-8-0.map.scen --map maps/maze512-8-0.map --sample 100 --planner dijkstra
  formicarium bench-scen lak303d.map.scen --sample 100 --planner any-angle

Exit code 1 when a scenario does not fit.")]
pub struct Args {
    /// The .scen file
    scen: PathBuf,
    /// The map [default: beside the .scen]
    #[arg(long)]
    map: Option<PathBuf>,
    /// A planner that proves the shortest path, to run and time, such as astar [default: the optimum alone, without a planner]
    #[arg(long, value_name = "ID")]
    planner: Option<String>,
    /// How many scenarios, drawn by the seed [default: all]
    #[arg(long, value_name = "N")]
    sample: Option<usize>,
    /// Seed of the sample
    #[arg(long, default_value_t = 1)]
    seed: u32,
    /// always, one-free or both-free; the benchmark's is both-free
    #[arg(long, value_name = "RULE", default_value = "both-free", hide_possible_values = true, value_parser = input::corner_rules())]
    corner_rule: CornerRule,
    /// text or json
    #[arg(long, value_enum, hide_possible_values = true, default_value_t = TextOrJson::Text)]
    format: TextOrJson,
}

impl Args {
    pub fn wants_json(&self) -> bool {
        self.format == TextOrJson::Json
    }
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let entry = args.planner.as_deref().map(proving).transpose()?;
    let scen = input::in_file(&args.scen, MAX_TEXT_BYTES, |bytes, _| Ok(formats::import_scen(bytes)?))?;
    let map_path = find_map(args, &scen)?;
    let map = ReadingArgs::default().import_still(&map_path)?;
    if map.grid.factors().is_some() || map.spec.robot.is_some() {
        let message = "the listed optima are lengths of a point's ways on plain ground; this map has factors of cells or a robot";
        return Err(CliError::usage(message, "leave `factors` and `robot` out of the map's file"));
    }
    text::notes(&scen.notices);
    let mut spec = map.spec;
    spec.movement.corner_rule = args.corner_rule;
    let scenario = Arc::new(Scenario::new(map.grid, spec)?);
    let lines = of_map(scen.lines, &map_path)?;
    let mut bench = Bench::new(args, &map_path, entry, lines.len());
    let mut by = entry.map_or_else(|| By::Optimum(Box::new(Optima::new(&scenario))), By::Planner);
    for line in sample(lines, args.sample, args.seed) {
        bench.run(&mut by, &scenario, &line)?;
    }
    let text = match args.format {
        TextOrJson::Text => bench.text(entry.map_or("Optimum", |e| e.name), &scenario),
        TextOrJson::Json => text::json(&bench, 2),
    };
    Ok(Outcome { text, fine: bench.misfits.is_empty() })
}

/// What finds the lengths.
enum By {
    /// A planner of the catalog, with its path.
    Planner(&'static PlannerEntry),
    /// The lengths alone.
    Optimum(Box<Optima>),
}

impl By {
    /// What it finds on a scenario.
    fn find(&mut self, scenario: &Arc<Scenario>) -> Result<Found, CliError> {
        match self {
            Self::Planner(entry) => {
                let mut planner = (entry.build)(scenario, &Values::new(), 0)?;
                planner.run();
                let (length, expansions) = (planner.best().map(|b| b.length), planner.effort().cell_expansions);
                Ok(Found { length, expansions, certificate: planner.certificate() })
            }
            Self::Optimum(optima) => {
                let before = optima.expansions();
                let length = optima.between(scenario.start, scenario.goal);
                Ok(Found { length, expansions: optima.expansions() - before, certificate: None })
            }
        }
    }
}

/// What was found on a scenario.
struct Found {
    /// Of the shortest path; none where there is none.
    length: Option<f64>,
    expansions: u64,
    certificate: Option<Certificate>,
}

fn proving(id: &str) -> Result<&'static PlannerEntry, CliError> {
    let entry = catalog::find(id)?;
    if proves_length(entry) {
        return Ok(entry);
    }
    let known: Vec<_> = catalog::CATALOG.iter().filter(|e| proves_length(e)).map(|e| e.id).collect();
    let message = format!("`{id}` proves no optimum of the length, so it cannot be compared with the listed ones");
    Err(CliError::usage(message, format!("the planners that prove one are {}", known.join(", "))))
}

/// Whether a planner's result is the shortest path of steps, proven by itself, which is what a `.scen` lists, or the shortest polyline.
fn proves_length(entry: &PlannerEntry) -> bool {
    objective(entry).is_some_and(|objective| matches!(objective, Objective::Length | Objective::PolylineLength))
}

/// What a planner makes small that proves what it has found.
fn objective(entry: &PlannerEntry) -> Option<Objective> {
    let ends = (Point::new(0, 0), Point::new(1, 0));
    let smallest = Grid::open(2, 1).ok().and_then(|grid| Scenario::on(grid, Movement::default(), ends.0, ends.1).ok());
    let planner = smallest.and_then(|scenario| catalog::build(&Arc::new(scenario), entry.id, None, &Values::new(), 1).ok());
    let mut planner = planner?;
    let objective = planner.objective();
    (planner.run() == Status::Optimal).then_some(objective)
}

/// The map beside the `.scen`: the file that its first line names, or the `.scen`'s own name without its ending.
fn find_map(args: &Args, scen: &ScenFile) -> Result<PathBuf, CliError> {
    if let Some(map) = &args.map {
        return Ok(map.clone());
    }
    let listed = scen.lines.first().map_or("", |l| l.map.as_str());
    let listed = listed.rsplit(['/', '\\']).next().unwrap_or_default();
    let beside = [args.scen.with_file_name(listed), args.scen.with_extension("")];
    beside.into_iter().find(|p| p.is_file()).ok_or_else(|| {
        let message = format!("the map `{listed}` is not beside {}", args.scen.display());
        CliError::usage(message, "name it with --map FILE")
    })
}

/// The scenarios of a map. Those of other maps are passed over where the file mixes several; where all name one other map, they are taken.
fn of_map(lines: Vec<ScenLine>, map: &Path) -> Result<Vec<ScenLine>, CliError> {
    let names: BTreeSet<&str> = lines.iter().map(|line| line.map.as_str()).collect();
    if names.len() <= 1 {
        text::notes(&names.first().and_then(|listed| input::other_map(listed, map)).into_iter().collect::<Vec<_>>());
        return Ok(lines);
    }
    let others: Vec<&str> = names.into_iter().filter(|listed| !input::is_of_map(listed, map)).collect();
    let shown = others.iter().take(5).copied().collect::<Vec<_>>().join(", ");
    let count = lines.iter().filter(|line| !input::is_of_map(&line.map, map)).count();
    if count == lines.len() {
        let message = format!("the scenarios are of several maps ({shown}), none of {}", input::file_name(map));
        return Err(CliError::usage(message, "name one of them with --map FILE"));
    }
    if count > 0 {
        let message = format!("passed over: {} of other maps ({shown})", text::count(count as u64, "scenario", "scenarios"));
        text::notes(&[Notice::new("scen-other-maps", message)]);
    }
    Ok(lines.into_iter().filter(|line| input::is_of_map(&line.map, map)).collect())
}

/// `count` of the lines, drawn without replacement and put back in file order; all without a count.
fn sample(mut lines: Vec<ScenLine>, count: Option<usize>, seed: u32) -> Vec<ScenLine> {
    let count = count.unwrap_or(lines.len()).min(lines.len());
    let mut dice = Streams::new(u64::from(seed), "bench-scen", 0).ant(0, 0);
    for i in 0..count {
        let left = (lines.len() - i) as u64;
        let pick = (u64::from(dice.next_u32()) * left) >> 32;
        lines.swap(i, i + pick as usize);
    }
    lines.truncate(count);
    lines.sort_by_key(|l| l.line);
    lines
}

/// A scenario that does not fit.
#[derive(Serialize)]
struct Misfit {
    line: u32,
    kind: String,
    message: String,
    listed: f64,
    found: Option<f64>,
}

/// What has been run so far.
#[derive(Serialize)]
struct Bench {
    format: &'static str,
    scen: String,
    map: String,
    /// None where the lengths alone were computed.
    planner: Option<&'static str>,
    corner_rule: CornerRule,
    scenarios: usize,
    run: usize,
    matched: usize,
    unlisted: usize,
    mean_milliseconds: f64,
    slowest_milliseconds: f64,
    cell_expansions: u64,
    /// Of a planner of polylines.
    #[serde(skip_serializing_if = "Option::is_none")]
    proofs: Option<Proofs>,
    #[serde(skip)]
    timed: u32,
    misfits: Vec<Misfit>,
}

impl Bench {
    fn new(args: &Args, map: &Path, entry: Option<&'static PlannerEntry>, scenarios: usize) -> Self {
        Self {
            format: "formicarium/bench-scen@1",
            // Names alone: folders are this machine's.
            scen: input::file_name(&args.scen),
            map: input::file_name(map),
            planner: entry.map(|e| e.id),
            corner_rule: args.corner_rule,
            scenarios,
            run: 0,
            matched: 0,
            unlisted: 0,
            mean_milliseconds: 0.0,
            slowest_milliseconds: 0.0,
            cell_expansions: 0,
            proofs: entry.filter(|e| objective(e) == Some(Objective::PolylineLength)).map(|_| Proofs::default()),
            timed: 0,
            misfits: Vec::new(),
        }
    }

    /// Runs one line on the scenario's map.
    fn run(&mut self, by: &mut By, scenario: &Scenario, line: &ScenLine) -> Result<(), CliError> {
        self.run += 1;
        if let Some(notice) = misfit(line, &scenario.grid) {
            self.add(line, &notice.kind, notice.message, None);
            return Ok(());
        }
        let scenario = Arc::new(scenario.with_ends(line.start, vec![Goal::new(line.goal, "")])?);
        let begin = Instant::now();
        let found = by.find(&scenario)?;
        let milliseconds = begin.elapsed().as_secs_f64() * 1e3;
        self.timed += 1;
        self.mean_milliseconds += (milliseconds - self.mean_milliseconds) / f64::from(self.timed);
        self.slowest_milliseconds = self.slowest_milliseconds.max(milliseconds);
        self.cell_expansions += found.expansions;
        if let Some(proofs) = &mut self.proofs {
            proofs.add(&found, milliseconds);
        }
        self.compare(line, found.length);
        Ok(())
    }

    fn compare(&mut self, line: &ScenLine, found: Option<f64>) {
        let (number, listed) = (line.line, line.optimal);
        match found {
            _ if line.is_unlisted() => self.unlisted += 1,
            None => self.add(line, "no-path", format!("line {number}: listed {listed}, but no path exists"), None),
            Some(length) if line.fits(length) || (self.proofs.is_some() && length < listed) => self.matched += 1,
            Some(length) => {
                let (kind, word) = if listed < length { ("listed-shorter", "shorter") } else { ("listed-longer", "longer") };
                let message = format!("line {number}: listed {listed}, found {length:.5}: the listed optimum is {word}");
                self.add(line, kind, message, found);
            }
        }
    }

    fn add(&mut self, line: &ScenLine, kind: &str, message: String, found: Option<f64>) {
        self.misfits.push(Misfit { line: line.line, kind: kind.into(), message, listed: line.optimal, found });
    }

    fn text(&self, name: &str, scenario: &Scenario) -> String {
        let grid = &scenario.grid;
        let rule = input::rule_id(self.corner_rule);
        let mut out = format!("{name} on {} ({} × {}, {rule})\n\n", self.scen, grid.width(), grid.height());
        let listed = self.run - self.unlisted;
        let share = if listed == 0 { 0.0 } else { self.matched as f64 / listed as f64 };
        row(
            &mut out,
            "matched",
            format!("{} of {listed} scenarios, {:.1} % ({} in the file)", self.matched, 100.0 * share, self.scenarios),
        );
        if self.unlisted > 0 {
            row(&mut out, "unknown", format!("{} scenarios list no optimum", self.unlisted));
        }
        row(
            &mut out,
            "time",
            format!("{:.3} ms per scenario, the slowest {:.3} ms", self.mean_milliseconds, self.slowest_milliseconds),
        );
        if let Some(proofs) = &self.proofs {
            proofs.text(&mut out);
        }
        let mean = self.cell_expansions / self.run.max(1) as u64;
        row(&mut out, "expansions", format!("{}, {} per scenario", text::grouped(self.cell_expansions), text::grouped(mean)));
        if !self.misfits.is_empty() {
            out.push('\n');
            row(&mut out, "misfits", self.misfits.len());
            for misfit in &self.misfits {
                out.push_str(&format!("    {}\n", misfit.message));
            }
        }
        out
    }
}
