//! `generate`: made-up maps.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use formicarium::formats::{Imported, Kind};
use formicarium::map::{Generator, generate};

use super::convert::Format;
use super::error::CliError;
use super::{Outcome, input, output};

/// Makes a map: random obstacles, a maze, rooms with doors, a cave, or a terrain (fractal, hills)
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  formicarium generate maze --size 41x31
  formicarium generate random --size 100x100 --density 0.35 --seed 9 --out random.json
  formicarium generate cave --size 64x48 --as matrix > cave.csv
  formicarium generate hills --size 129x129 --roughness 0.6 --out hills.tif

Terrains have cells of 30 m and heights from 0 to 12 % of the longer side.")]
pub struct Args {
    /// What to make
    #[arg(value_parser = kinds())]
    kind: Generator,
    /// Width and height in cells, up to 4096 each
    #[arg(long, value_name = "WxH", value_parser = input::size)]
    size: (u32, u32),
    /// The same seed gives the same map on every machine
    #[arg(long, default_value_t = 1, allow_negative_numbers = true)]
    seed: u32,
    /// Share of obstacles of random, 0 to 0.9 [default: 0.3]; of fractal and hills the roughness [default: 0.5]
    #[arg(long, alias = "roughness", allow_negative_numbers = true)]
    density: Option<f64>,
    /// File to write; its ending tells the format [default: standard output]
    #[arg(long)]
    out: Option<PathBuf>,
    /// movingai-map, movingai-scen, matrix, or scenario, which keeps start and goal; terrains also esri-ascii, height-table, geotiff, srtm
    /// [default: movingai-map, of terrains scenario]
    #[arg(long = "as", value_enum, hide_possible_values = true, value_name = "FORMAT")]
    format: Option<Format>,
}

fn kinds() -> impl TypedValueParser<Value = Generator> {
    PossibleValuesParser::new(Generator::ALL.map(Generator::id)).map(|id| {
        let found = Generator::ALL.into_iter().find(|k| k.id() == id);
        found.unwrap_or(Generator::Random)
    })
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    output::check(args.out.as_deref())?;
    let (width, height) = args.size;
    let is_terrain = args.kind.is_terrain();
    let density = args.density.unwrap_or(if is_terrain { 0.5 } else { 0.3 });
    let made = generate(args.kind, width, height, args.seed, density)?;
    let spec = made.spec(format!("{}-{width}x{height}-seed{}", args.kind.id(), args.seed));
    let map = Imported { kind: Kind::Scenario, grid: made.grid, spec, notices: Vec::new() };
    let by_ending = args.out.as_deref().and_then(Format::of);
    let usual = if is_terrain { Format::Scenario } else { Format::MovingaiMap };
    let format = args.format.or(by_ending).unwrap_or(usual).suited(is_terrain);
    output::write(args.out.as_deref(), &format.write(&map)?)?;
    Ok(Outcome::fine(String::new()))
}
