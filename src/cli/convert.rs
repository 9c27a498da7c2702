//! `convert`: from any map format to any other.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::exact;
use crate::formats::picture::PictureOptions;
use crate::formats::{self, BinaryExport, Export, Imported, Kind, MAX_BYTES, ReadOptions, TerrainOptions, ros};
use crate::map::{Movement, Window};
use crate::scenario::{Scenario, ScenarioSpec};
use clap::ValueEnum;

use super::error::CliError;
use super::input::RouteArgs;
use super::reading::{ReadingArgs, import};
use super::streams::say;
use super::{Outcome, input, output, text};

/// Converts a map to another format, told by the output's ending
#[derive(clap::Args)]
#[command(after_help = "\
Endings: .map and .scen (MovingAI; a .scen lists start and goal with the exact optimum), .csv .txt .m (matrix;
of a terrain a table of heights), .asc (ESRI ASCII grid), .tif (GeoTIFF), .hgt (SRTM), .json (scenario),
.yaml (ROS map, with its .pgm beside it)

Examples:
  formicarium convert grid.m grid.map
  formicarium convert grid.csv grid.json --invert
  formicarium convert arena2.map - --as matrix | head
  formicarium convert plan.png plan.map --threshold 128 --cells 120
  formicarium convert figure.png figure.json --figure
  formicarium convert lab.yaml lab.json --unknown free
  formicarium convert N40W106.hgt valley.json --square
  formicarium convert N40W106.hgt valley.json --crop 400,300,300,200 --size 150x100
  formicarium convert heights.csv question.json --model slices --from 0,9 --from-level 4 --to 20,7 --to-level 5")]
pub struct Args {
    /// The file to read
    input: PathBuf,
    /// The file to write; `-` needs --as
    output: PathBuf,
    /// movingai-map, movingai-scen, matrix, esri-ascii, height-table, geotiff, srtm, scenario or ros-map, whatever the ending
    #[arg(long = "as", value_enum, hide_possible_values = true, value_name = "FORMAT")]
    format: Option<Format>,
    /// Swap free and blocked cells
    #[arg(long)]
    invert: bool,
    /// Only this window of the map, in its cells
    #[arg(long, value_name = "X,Y,W,H", value_parser = input::window)]
    crop: Option<Window>,
    /// The same ground in this number of cells: heights are interpolated, walls taken from the nearest cell
    #[arg(long, value_name = "WxH", value_parser = input::size)]
    size: Option<(u32, u32)>,
    /// Heights whose cells are longer than wide, as in degrees, are interpolated at square ones
    #[arg(long, conflicts_with = "size")]
    square: bool,
    #[command(flatten)]
    route: RouteArgs,
    #[command(flatten)]
    reading: ReadingArgs,
}

/// A format that can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    MovingaiMap,
    MovingaiScen,
    Matrix,
    EsriAscii,
    HeightTable,
    Geotiff,
    Srtm,
    Scenario,
    RosMap,
}

impl Format {
    /// The format of a file name's ending.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "map" => Some(Self::MovingaiMap),
            "scen" => Some(Self::MovingaiScen),
            "csv" | "txt" | "m" => Some(Self::Matrix),
            "asc" => Some(Self::EsriAscii),
            "tif" | "tiff" => Some(Self::Geotiff),
            "hgt" => Some(Self::Srtm),
            "json" => Some(Self::Scenario),
            "yaml" | "yml" => Some(Self::RosMap),
            _ => None,
        }
    }

    /// The same, except that an ending of a table means heights where there are any.
    pub fn suited(self, is_terrain: bool) -> Self {
        if is_terrain && self == Self::Matrix { Self::HeightTable } else { self }
    }

    /// A map in this format.
    pub fn write(self, map: &Imported) -> Result<Vec<u8>, CliError> {
        let export = match self {
            Self::MovingaiMap => Export::MovingaiMap,
            Self::MovingaiScen => Export::MovingaiScen { optimal: listed_optimum(map)? },
            Self::Matrix => Export::Matrix,
            Self::EsriAscii => Export::EsriAscii,
            Self::HeightTable => Export::HeightTable,
            Self::Scenario => Export::Scenario,
            Self::RosMap => {
                return Err(CliError::usage("a ROS map is two files", "name a file: formicarium convert IN map.yaml"));
            }
            Self::Geotiff => return Ok(formats::export_binary(&map.grid, &map.spec, BinaryExport::Geotiff)?),
            Self::Srtm => return Ok(formats::export_binary(&map.grid, &map.spec, BinaryExport::Srtm)?),
        };
        Ok(formats::export(&map.grid, &map.spec, export).into_bytes())
    }

    /// Whether heights alone are written.
    fn is_raster(self) -> bool {
        matches!(self, Self::EsriAscii | Self::HeightTable | Self::Geotiff | Self::Srtm)
    }
}

/// The optimum under the benchmark's rules: 8 moves, both cells beside a diagonal step free, of a point on a plane of plain ground.
fn listed_optimum(map: &Imported) -> Result<f64, CliError> {
    let spec = ScenarioSpec { movement: Movement::default(), terrain: None, robot: None, ..map.spec.clone() };
    let scenario = Arc::new(Scenario::new(map.grid.clone().cells_alone(), spec)?);
    exact::optimum(&scenario).ok_or_else(|| {
        CliError::usage("no path leads from start to goal, so there is no optimum to list", "choose other ends, or write a .map")
    })
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    output::check(Some(&args.output))?;
    let piece = TerrainOptions { crop: args.crop, size: args.size };
    let mut map = read(&args.input, &args.reading.options(None), piece, args.square)?;
    let format = args.format.map_or_else(|| told_by_ending(&args.output, &map), Ok)?;
    if args.invert {
        map = map.invert()?;
    }
    args.route.correct_note(&mut map, false);
    args.route.apply(&mut map)?;
    // What could not be read again is not written.
    map.spec.check(&map.grid)?;
    if args.route.has_ends() {
        Scenario::new(map.grid.clone(), map.spec.clone())?;
    }
    text::notes(&map.notices);
    write(&args.output, format, &map)?;
    Ok(Outcome::fine(String::new()))
}

/// The format that the ending of a file's name tells.
pub fn told_by_ending(path: &Path, map: &Imported) -> Result<Format, CliError> {
    let told = Format::of(path).map(|ending| ending.suited(map.spec.terrain.is_some()));
    told.ok_or_else(|| {
        let message = format!("the ending of `{}` tells no format", path.display());
        CliError::usage(message, "use .map, .scen, .csv, .asc, .tif or .json, or name the format with --as")
    })
}

/// Writes a map, and says what the format does not hold of it.
pub fn write(path: &Path, format: Format, map: &Imported) -> Result<(), CliError> {
    tell_of_losses(format, map);
    if format == Format::RosMap && path != Path::new("-") {
        return write_ros(path, map);
    }
    output::write(Some(path), &format.write(map)?)
}

/// The description, and its picture beside it. The picture first: a description without one is of no use.
fn write_ros(yaml: &Path, map: &Imported) -> Result<(), CliError> {
    let pgm = yaml.with_extension("pgm");
    output::check(Some(&pgm))?;
    let files = ros::write(&map.grid, map.unknown.as_ref(), &map.spec, &input::file_name(&pgm));
    output::write(Some(&pgm), &files.pgm)?;
    output::write(Some(yaml), files.yaml.as_bytes())
}

/// The map, or the piece of it that is asked for: of a picture a window of its pixels, of a figure one of its cells. `square`: heights whose
/// cells are longer than wide are interpolated at square ones.
pub fn read(path: &Path, options: &ReadOptions, mut piece: TerrainOptions, square: bool) -> Result<Imported, CliError> {
    if piece == TerrainOptions::default() && !square {
        return import(path, options);
    }
    if options.figure.is_some() {
        return Ok(import(path, options)?.piece(piece)?);
    }
    let kind = input::in_file(path, MAX_BYTES, |bytes, name| Ok(formats::sniff(bytes, name)))?;
    if kind == Kind::Picture && piece.size.is_none() {
        let picture = PictureOptions { crop: piece.crop, ..options.picture.clone() };
        return import(path, &ReadOptions { picture, ..options.clone() });
    }
    if kind.is_raster() || kind == Kind::Archive {
        if square {
            let survey = input::in_file(path, MAX_BYTES, formats::survey)?;
            piece.size = Some(survey.square_size(piece.crop));
        }
        return input::in_file(path, MAX_BYTES, |bytes, name| formats::import_piece(bytes, name, piece));
    }
    Ok(import(path, options)?.piece(piece)?)
}

/// Tells what the format does not hold.
pub fn tell_of_losses(format: Format, map: &Imported) {
    let is_terrain = map.spec.terrain.is_some();
    let has_ends = matches!(format, Format::MovingaiScen | Format::Scenario);
    if !has_ends && !map.ends_were_chosen() {
        let (start, goal) = (text::cell(map.spec.start), text::cell(map.spec.goals[0].at));
        let what = if format.is_raster() { "heights" } else { "cells" };
        say(format!("note: this format holds the {what} alone, not start {start} and goal {goal}; a .json keeps them"));
    }
    if is_terrain && !format.is_raster() && format != Format::Scenario {
        say("note: this format holds no heights; .asc, .tif and .json do");
    }
    if map.grid.factors().is_some() && format != Format::Scenario {
        say("note: this format holds no factors of cells: what the ground costs is left out; a .json keeps it");
    }
    if map.spec.robot.is_some() && format != Format::Scenario {
        say("note: this format holds no robot: its radius and what cells near obstacles cost are left out; a .json keeps them");
    }
    if !map.spec.changes.is_empty() && format != Format::Scenario {
        say("note: this format holds the map before its walls change; a .json keeps the changes");
    }
    if map.spec.drive.is_some() && format != Format::Scenario {
        say("note: this format does not hold what moves while a robot drives; a .json does");
    }
    let is_impossible = |h: &f32| f64::from(h.abs()) > formats::FARTHEST;
    let impossible = || map.grid.heights().is_some_and(|heights| heights.iter().any(is_impossible));
    if format.is_raster() && impossible() {
        say("note: heights beyond 12 km above or below the sea are read as without data from this format");
    }
    let walls = || {
        (0..map.grid.len() as u32).any(|c| map.grid.is_blocked(c) && map.grid.heights().is_some_and(|h| !h[c as usize].is_nan()))
    };
    if format.is_raster() && walls() {
        say("note: this format holds heights alone, not the walls that stand on them; a .json keeps them");
    }
}
