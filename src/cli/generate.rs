//! `generate`: made-up maps.

use std::path::PathBuf;

use crate::error::ScenarioError;
use crate::formats::{Imported, Kind};
use crate::map::{Generator, generate};
use crate::scenario::Scenario;
use clap::builder::{PossibleValuesParser, TypedValueParser};

use super::convert::{Format, tell_of_losses};
use super::error::CliError;
use super::input::RouteArgs;
use super::reading::ReadingArgs;
use super::{Outcome, input, output, text};

/// Makes a map: random obstacles, a maze, rooms with doors, a cave, blocks, bars, or a terrain (fractal, hills)
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  formicarium generate maze --size 41x31
  formicarium generate random --size 100x100 --density 0.35 --seed 9 --out random.json
  formicarium generate blocks --size 40x30 --density 0.2 --from 0,29 --to 39,0 > engine-room.json
  formicarium generate bars --size 20x20 --ends-of fires.json --out fires-7.json --seed 7
  formicarium generate cave --size 64x48 --as matrix > cave.csv
  formicarium generate hills --size 129x129 --roughness 0.6 --out hills.tif
  formicarium generate hills --size 21x21 --model slices --from 0,10 --to 20,8 --out slices.json

Start and goal lie near the upper-left and the lower-right corner and are connected. Of those that are given here that is not so: on a wall
they are refused, and no wall is opened between them.
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
    /// Share of obstacles of random, blocks and bars, 0 to 0.9 [default: 0.3]; of fractal and hills the roughness [default: 0.5]
    #[arg(long, alias = "roughness", allow_negative_numbers = true)]
    density: Option<f64>,
    /// Start and goals, with their names and weights, of this scenario
    #[arg(long, value_name = "F.json", conflicts_with_all = ["from", "to"])]
    ends_of: Option<PathBuf>,
    /// File to write; its ending tells the format [default: standard output]
    #[arg(long)]
    out: Option<PathBuf>,
    /// movingai-map, movingai-scen, matrix, or scenario, which keeps start, goals and moves; terrains also esri-ascii, height-table, geotiff,
    /// srtm [default: movingai-map; scenario of terrains, and where ends or moves are given]
    #[arg(long = "as", value_enum, hide_possible_values = true, value_name = "FORMAT")]
    format: Option<Format>,
    #[command(flatten)]
    route: RouteArgs,
}

fn kinds() -> impl TypedValueParser<Value = Generator> {
    PossibleValuesParser::new(Generator::ALL.map(Generator::id)).map(|id| {
        let found = Generator::ALL.into_iter().find(|k| k.id() == id);
        found.unwrap_or(Generator::Random)
    })
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    output::check(args.out.as_deref())?;
    let is_terrain = args.kind.is_terrain();
    let mut map = make(args.kind, args.size, args.seed, args.density)?;
    let is_asked = ask(args, &mut map)?;
    let by_ending = args.out.as_deref().and_then(Format::of);
    let usual = if is_terrain || is_asked { Format::Scenario } else { Format::MovingaiMap };
    let format = args.format.or(by_ending).unwrap_or(usual).suited(is_terrain);
    if is_asked {
        tell_of_losses(format, &map);
    }
    output::write(args.out.as_deref(), &format.write(&map)?)?;
    Ok(Outcome::fine(String::new()))
}

/// Makes a map, named after what made it; `size` in columns and rows, `density` 0.3 or of terrains 0.5 where none is given.
pub fn make(kind: Generator, size: (u32, u32), seed: u32, density: Option<f64>) -> Result<Imported, ScenarioError> {
    let (width, height) = size;
    let made = generate(kind, width, height, seed, density.unwrap_or(if kind.is_terrain() { 0.5 } else { 0.3 }))?;
    let spec = made.spec(format!("{}-{width}x{height}-seed{seed}", kind.id()));
    Ok(Imported { kind: Kind::Scenario, grid: made.grid, spec, notices: Vec::new(), unknown: None })
}

/// Puts the ends and the moves that are given in the place of the generator's, and tells whether any are.
fn ask(args: &Args, map: &mut Imported) -> Result<bool, CliError> {
    let own = map.spec.clone();
    if let Some(file) = &args.ends_of {
        let ends = ReadingArgs::default().import(file)?;
        text::notes(&ends.notices);
        (map.spec.start, map.spec.goals) = (ends.spec.start, ends.spec.goals);
    }
    args.route.apply(map)?;
    let is_asked = args.ends_of.is_some() || args.route.has_ends() || map.spec != own;
    if is_asked {
        // The generator's own ends are free and connected.
        let scenario = Scenario::new(map.grid.clone(), map.spec.clone())?;
        text::notes(&scenario.notices());
    }
    Ok(is_asked)
}
