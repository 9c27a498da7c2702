//! `tracker run`: the project's own entries.

use std::path::PathBuf;

use crate::catalog::{self, CATALOG};
use crate::cli::error::CliError;
use crate::cli::streams::say;
use crate::cli::{Outcome, text};
use crate::comparison::best_known::{Measured, Recipe, RecordedRun, Standing, check_bound, run as run_once, shortest_run};
use crate::comparison::gap::reaches;
use crate::error::BestKnownError;
use crate::formats::session::{Panel, Session};
use crate::params::{Value, Values};
use crate::planner::PlannerEntry;

use super::Where;
use super::check::check;
use super::entry::{self, Entry, Head, outside_name};
use super::folder::{PROJECT, Tracked, Tracker, best};
use super::proof::Proof;

/// Runs planners over seeds and keeps the best run of each
#[derive(clap::Args)]
#[command(after_help = "\
Seeds are taken in order until a run reaches the proven optimum. An entry is written where it is better than the one of its name, or that one
does not hold; with a --by of yours, as PLANNER--NAME, where it is better than every entry of the planner.

Examples:
  formicarium tracker run --seeds 1-100
  formicarium tracker run --only ship-20x20 --planner ant-system --set ants=100 --by 'Ada'")]
pub struct Args {
    #[command(flatten)]
    tracker: Where,
    /// Only these scenarios; may be repeated
    #[arg(long, value_name = "ID")]
    only: Vec<String>,
    /// Only these planners; may be repeated
    #[arg(long, value_name = "ID")]
    planner: Vec<String>,
    /// A parameter other than its default, of one --planner; may be repeated
    #[arg(long, value_name = "KEY=VALUE", requires = "planner", value_parser = crate::cli::planner_args::assignment)]
    set: Vec<(String, Value)>,
    /// First and last seed
    #[arg(long, value_name = "FROM-TO", value_parser = seeds, default_value = "1-100")]
    seeds: (u32, u32),
    /// Who runs them
    #[arg(long, value_name = "NAME", value_parser = entry::one_line, default_value = PROJECT)]
    by: String,
    /// The day [default: today]
    #[arg(long, value_name = "YYYY-MM-DD", value_parser = entry::date)]
    date: Option<String>,
}

fn seeds(text: &str) -> Result<(u32, u32), String> {
    let number = |part: &str| part.trim().parse().ok();
    let pair = text.split_once('-').and_then(|(from, to)| Some((number(from)?, number(to)?)));
    pair.filter(|(from, to)| from <= to)
        .ok_or_else(|| format!("`{text}` are no seeds: write the first and the last such as 1-100"))
}

/// The best run of a planner, and the seed that gave it.
struct Found {
    seed: u32,
    recorded: RecordedRun,
    measured: Measured,
    /// Whether no run can be better.
    optimal: bool,
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let tracker = args.tracker.open()?;
    args.only.iter().try_for_each(|id| tracker.scenario(id).map(drop))?;
    args.planner.iter().try_for_each(|id| catalog::find(id).map(drop))?;
    if !args.set.is_empty() && (args.planner.len() != 1 || args.by == PROJECT) {
        let message = "parameters of one's own are one planner's, and somebody's";
        return Err(CliError::usage(message, "with --set give one --planner, and say who you are: --by NAME"));
    }
    let mut written = 0;
    for tracked in tracker.scenarios.iter().filter(|tracked| args.only.is_empty() || args.only.contains(&tracked.id)) {
        for planner in CATALOG.iter().filter(|p| args.planner.is_empty() || args.planner.iter().any(|id| id == p.id)) {
            written += u64::from(args.keep_best(&tracker, tracked, planner)?);
        }
    }
    Ok(Outcome::fine(format!("{} written\n", text::count(written, "entry", "entries"))))
}

impl Args {
    /// Whether an entry was written.
    fn keep_best(&self, tracker: &Tracker, tracked: &Tracked, planner: &PlannerEntry) -> Result<bool, CliError> {
        let found = match self.best(tracked, planner) {
            Ok(Some(found)) => found,
            Ok(None) => {
                say(format!("{} on {}: no path", planner.id, tracked.id));
                return Ok(false);
            }
            // The catalog refuses planners that do not know how one moves here.
            Err(BestKnownError::Planner(_)) if self.set.is_empty() => return Ok(false),
            Err(error) => return Err(error.into()),
        };
        let (place, known) = self.beside(tracker, tracked, planner, found.measured)?;
        let is_better = Standing::of(found.measured.value, known).wins();
        let how = if is_better { "written" } else { "no better than what is there" };
        say(format!("{} on {}: {} by seed {}, {how}", planner.id, tracked.id, found.measured.value, found.seed));
        if is_better {
            self.entry(tracked, planner, found)?.write(&place)?;
        }
        Ok(is_better)
    }

    /// The entry's file, and the value that it must better.
    fn beside(
        &self,
        tracker: &Tracker,
        tracked: &Tracked,
        planner: &PlannerEntry,
        Measured { objective, .. }: Measured,
    ) -> Result<(PathBuf, Option<f64>), CliError> {
        if self.by != PROJECT {
            let entries = tracker.entries(&tracked.id)?;
            let known = best(entries.iter().filter(|entry| entry.planner == planner.id && entry.objective == objective));
            return Ok((tracker.place(&tracked.id, &outside_name(planner.id, &self.by)?), known.map(|entry| entry.value)));
        }
        let place = tracker.place(&tracked.id, planner.id);
        // What does not hold any more stands in nobody's way.
        let known = if place.exists() { check(&place, tracked).ok().map(|entry| entry.value) } else { None };
        Ok((place, known))
    }

    fn best(&self, tracked: &Tracked, planner: &PlannerEntry) -> Result<Option<Found>, BestKnownError> {
        let params = self.params();
        let (from, to) = if planner.family.needs_no_seed() { (1, 1) } else { self.seeds };
        let mut best: Option<(u32, Measured)> = None;
        for seed in from..=to {
            let recipe = Recipe { planner: planner.id, params: &params, seed };
            let Some(measured) = run_once(&tracked.scenario, recipe, None)?.1 else { continue };
            if Standing::of(measured.value, best.map(|(_, best)| best.value)).wins() {
                best = Some((seed, measured));
            }
            if is_optimal(tracked, measured) {
                break;
            }
        }
        let Some((seed, measured)) = best else { return Ok(None) };
        check_bound(measured.value, tracked.reference(measured.objective))?;
        let (recorded, _) = shortest_run(&tracked.scenario, Recipe { planner: planner.id, params: &params, seed })?;
        Ok(Some(Found { seed, recorded, measured, optimal: is_optimal(tracked, measured) }))
    }

    fn entry(&self, tracked: &Tracked, planner: &PlannerEntry, found: Found) -> Result<Entry, CliError> {
        let Measured { objective, value } = found.measured;
        let entry = Entry::new(Head {
            scenario: tracked.id.clone(),
            planner: planner.id.into(),
            objective,
            value,
            by: self.by.clone(),
            date: self.date.clone().unwrap_or_else(entry::today),
            note: self.note(planner, found.optimal),
        });
        let panel = Panel { planner: planner.id.into(), preset: None, params: self.params(), result: Some(found.recorded) };
        let session = Session {
            engine: env!("CARGO_PKG_VERSION").into(),
            grid: tracked.scenario.drawn.clone(),
            spec: tracked.scenario.spec.clone(),
            origin: tracked.origin,
            changes: 0,
            panels: vec![panel],
            seed: found.seed,
        };
        Proof::Run(Box::new(session)).into_entry(entry)
    }

    fn params(&self) -> Values {
        self.set.iter().cloned().collect()
    }

    /// How the entry was found.
    fn note(&self, planner: &PlannerEntry, optimal: bool) -> String {
        let (from, to) = self.seeds;
        let set: Vec<String> = self.set.iter().map(|(key, value)| format!("{key} = {value}")).collect();
        let with = if set.is_empty() { "default parameters".into() } else { set.join(", ") };
        match (planner.family.needs_no_seed(), optimal) {
            (true, _) => format!("{with}; every run is the same"),
            (false, true) => format!("{with}; the first of the seeds {from} to {to} that reaches the optimum"),
            (false, false) => format!("{with}; the best of the seeds {from} to {to}"),
        }
    }
}

fn is_optimal(tracked: &Tracked, measured: Measured) -> bool {
    let reference = tracked.reference(measured.objective);
    reference.is_proven() && reference.value().is_some_and(|optimum| reaches(measured.value, optimum))
}
