//! The command line: subcommands, one file each. Exit codes: 0 = fine, 1 = no path or a failed check, 2 = unusable input.

mod bench_scen;
mod catalog;
mod check;
mod compare;
mod convert;
mod drive;
mod driving;
mod error;
mod generate;
mod input;
mod order;
mod output;
mod page;
mod plan;
mod plan_format;
mod planner_args;
mod reading;
mod robot;
pub mod shared;
mod streams;
mod submit;
mod terrain;
mod text;
mod tracker;

use std::ffi::OsString;
use std::io::Write as _;

use crate::error::ErrorReport;
use clap::{Parser, Subcommand};
use serde::Serialize;

use error::CliError;

/// Ant-colony path planning beside exact planners, on one map, under one set of rules.
#[derive(Parser)]
#[command(name = "formicarium", version, after_help = EXAMPLES, max_term_width = 110)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  formicarium generate cave --size 60x40 --seed 7 --out cave.json
  formicarium plan cave.json --planner ant-system --set ants=30
  formicarium plan dem.tif --planner astar --moves 16 --max-slope 30
  formicarium plan arena2.map --scen arena2.map.scen:200 --planner astar --format json
  formicarium compare experiments/ship.toml --out results
  formicarium check path.csv --map arena2.map
  formicarium bench-scen arena2.map.scen
  formicarium drive cave.json --planner d-star-lite --obstacle 10,3:10,15
  formicarium order berlin52.tsp --runs 10
  formicarium page race.experiment.json > lesson.html
  formicarium submit race.experiment.json --by Ada

Exit codes: 0 fine, 1 no path or a failed check, 2 unusable input.
Coordinates are column,row from 0; 0,0 is the upper left. `-` stands for standard input or output.";

#[derive(Subcommand)]
enum Command {
    Plan(plan::Args),
    Compare(compare::Args),
    Catalog(catalog::Args),
    Convert(convert::Args),
    Check(check::Args),
    Generate(generate::Args),
    BenchScen(bench_scen::Args),
    Order(order::Args),
    Drive(drive::Args),
    Page(page::Args),
    Submit(submit::Args),
    Tracker(tracker::Args),
}

/// An error as JSON.
#[derive(Serialize)]
struct Failure {
    format: &'static str,
    error: ErrorReport,
}

/// What a subcommand prints, and whether it counts as success.
struct Outcome {
    text: String,
    fine: bool,
}

impl Outcome {
    fn fine(text: String) -> Self {
        Self { text, fine: true }
    }
}

impl Command {
    fn run(&self) -> Result<Outcome, CliError> {
        match self {
            Self::Plan(args) => plan::run(args),
            Self::Compare(args) => compare::run(args),
            Self::Catalog(args) => catalog::run(args),
            Self::Convert(args) => convert::run(args),
            Self::Check(args) => check::run(args),
            Self::Generate(args) => generate::run(args),
            Self::BenchScen(args) => bench_scen::run(args),
            Self::Order(args) => order::run(args),
            Self::Drive(args) => drive::run(args),
            Self::Page(args) => page::run(args),
            Self::Submit(args) => submit::run(args),
            Self::Tracker(args) => tracker::run(args),
        }
    }

    /// Whether the caller reads JSON, and so should get errors in it too.
    fn wants_json(&self) -> bool {
        match self {
            Self::Plan(args) => args.wants_json(),
            Self::Catalog(args) => args.json,
            Self::Check(args) => args.wants_json(),
            Self::BenchScen(args) => args.wants_json(),
            Self::Order(args) => args.wants_json(),
            Self::Drive(args) => args.wants_json(),
            Self::Compare(_) | Self::Convert(_) | Self::Generate(_) | Self::Page(_) | Self::Submit(_) | Self::Tracker(_) => false,
        }
    }
}

/// Runs the command line with these arguments, the program's name first. Prints what comes out, and returns the exit code.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(said) => return say_as_clap(&said),
    };
    match cli.command.run().and_then(|outcome| streams::print(streams::harmless(&outcome.text).as_bytes()).map(|()| outcome.fine))
    {
        Ok(fine) => u8::from(!fine),
        Err(error) => fail(&error, cli.command.wants_json()),
    }
}

/// Help, the version, or what is wrong with the arguments.
fn say_as_clap(said: &clap::Error) -> u8 {
    let printed = said.print().and_then(|()| std::io::stdout().flush());
    match streams::heeded(printed) {
        Ok(()) => u8::try_from(said.exit_code()).unwrap_or(2),
        Err(error) => fail(&error, false),
    }
}

/// Tells what went wrong.
fn fail(error: &CliError, as_json: bool) -> u8 {
    let report = error.report();
    streams::say(format!("error: {}\nhint: {}", report.message, report.hint));
    if as_json {
        let failure = text::json(&Failure { format: "formicarium/error@1", error: report }, 2);
        // The exit code says enough where even that cannot be printed.
        let _ = streams::print(failure.as_bytes());
    }
    2
}
