//! `generate`: made-up maps.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use formicarium::formats::{Imported, Kind};
use formicarium::map::{Generator, generate};
use formicarium::scenario::ScenarioSpec;

use super::convert::Format;
use super::error::CliError;
use super::{Outcome, input};

/// Makes a map: random obstacles, a maze, rooms with doors, or a cave
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  formicarium generate maze --size 41x31
  formicarium generate random --size 100x100 --density 0.35 --seed 9 --out random.json
  formicarium generate cave --size 64x48 --as matrix > cave.csv")]
pub struct Args {
    /// What to make
    #[arg(value_parser = kinds())]
    kind: Generator,
    /// Width and height in cells, up to 4096 each
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: (u32, u32),
    /// The same seed gives the same map on every machine
    #[arg(long, default_value_t = 1, allow_negative_numbers = true)]
    seed: u32,
    /// Share of obstacles, 0 to 0.9 (random only)
    #[arg(long, default_value_t = 0.3, allow_negative_numbers = true)]
    density: f64,
    /// File to write; its ending tells the format [default: standard output]
    #[arg(long)]
    out: Option<PathBuf>,
    /// movingai-map, movingai-scen, matrix, or scenario, which keeps start and goal [default: movingai-map]
    #[arg(long = "as", value_enum, hide_possible_values = true, value_name = "FORMAT")]
    format: Option<Format>,
}

fn kinds() -> impl TypedValueParser<Value = Generator> {
    PossibleValuesParser::new(Generator::ALL.map(Generator::id)).map(|id| {
        let found = Generator::ALL.into_iter().find(|k| k.id() == id);
        found.unwrap_or(Generator::Random)
    })
}

fn size(text: &str) -> Result<(u32, u32), String> {
    let wrong = || format!("`{text}` is no size: write WIDTHxHEIGHT such as 40x30");
    let (w, h) = text.split_once(['x', 'X', '×']).ok_or_else(wrong)?;
    Ok((w.trim().parse().map_err(|_| wrong())?, h.trim().parse().map_err(|_| wrong())?))
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let (width, height) = args.size;
    let made = generate(args.kind, width, height, args.seed, args.density)?;
    let name = format!("{}-{width}x{height}-seed{}", args.kind.id(), args.seed);
    let spec = ScenarioSpec { name, ..ScenarioSpec::new(&made.grid, made.start, made.goal) };
    let map = Imported { kind: Kind::Scenario, grid: made.grid, spec, notices: Vec::new() };
    let by_ending = args.out.as_deref().and_then(Format::of);
    let format = args.format.or(by_ending).unwrap_or(Format::MovingaiMap);
    input::write(args.out.as_deref(), format.write(&map)?).map(Outcome::fine)
}
