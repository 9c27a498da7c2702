//! What the arguments say of a map's file where it leaves a choice, and the files that belong to it.

use std::path::{Path, PathBuf};

use crate::error::Notice;
use crate::formats::figure::Lattice;
use crate::formats::picture::PictureOptions;
use crate::formats::ros::{self, Costs, Unknown};
use crate::formats::{self, Companion, FigureOptions, Imported, Kind, MAX_BYTES, ReadOptions};
use crate::map::Window;
use crate::scenario::CostRule;
use clap::ValueEnum;

use super::error::CliError;
use super::input;

/// How to read a map's file where it leaves a choice.
#[derive(clap::Args, Clone, Default)]
#[command(next_help_heading = "Programs, pictures and ROS maps")]
pub struct ReadingArgs {
    /// Which matrix, from 1, of a program or text that holds several
    #[arg(long, value_name = "N")]
    matrix: Option<u32>,
    /// Pictures: gray from 0 to 255 below which a pixel is dark; auto parts dark from light best [default: 128]
    #[arg(long, value_name = "N|auto", value_parser = threshold)]
    threshold: Option<Threshold>,
    /// Pictures: light pixels are walls, not dark ones
    #[arg(long)]
    light_is_blocked: bool,
    /// Pictures and ROS maps: most cells of the longer side; a cell is blocked if anything under it is
    #[arg(long, value_name = "N")]
    cells: Option<u32>,
    /// Pictures: metres of a pixel
    #[arg(long, value_name = "M", value_parser = input::metres, allow_negative_numbers = true)]
    metres_per_pixel: Option<f64>,
    /// Pictures: metres of a cell; with --metres-per-pixel it says how many cells there are
    #[arg(long, value_name = "M", value_parser = input::metres, allow_negative_numbers = true)]
    metres_per_cell: Option<f64>,
    /// ROS maps: cells that nobody has seen are blocked or free [default: blocked]
    #[arg(long, value_enum, value_name = "blocked|free", hide_possible_values = true)]
    unknown: Option<UnknownAs>,
    /// ROS maps and OccupancyGrid messages that are costmaps: values from 1 to 98 are costs, which make cells dearer by the rule nav2-smac-2d
    /// or nav2-navfn [default: thresholds tell free from occupied]
    #[arg(long, value_name = "RULE", hide_possible_values = true, value_parser = input::cost_rules(), conflicts_with = "cost")]
    costs: Option<CostRule>,
    /// With --costs nav2-smac-2d: its cost_travel_multiplier, 0 to 500 [default: 2; newer versions of Nav2 have 1]
    #[arg(long, value_name = "M", requires = "costs", allow_negative_numbers = true)]
    costs_multiplier: Option<f64>,
    /// MovingAI maps: how many times its length a way through swamp (S) costs, 1 to 1000 [default: as free as any other cell]
    #[arg(long, value_name = "F", allow_negative_numbers = true)]
    swamp_factor: Option<f32>,
    /// Pictures: the figure of a grid, whose cells are read, not its pixels; start and goal by its markers
    #[arg(long, conflicts_with_all = ["matrix", "threshold", "light_is_blocked", "cells", "metres_per_pixel", "unknown"])]
    figure: bool,
    /// Figures: the upper left corner and the size of a cell in pixels, columns and rows, and how far a row lies to the right of the one
    /// above and a column below the one to its left, if they do [default: what is found]
    #[arg(long, value_name = "X,Y,DX,DY,COLUMNS,ROWS[,SX,SY]", value_parser = lattice, allow_hyphen_values = true, requires = "figure")]
    lattice: Option<Lattice>,
}

/// A threshold that was asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Threshold {
    Gray(u8),
    Auto,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum UnknownAs {
    Blocked,
    Free,
}

fn threshold(text: &str) -> Result<Threshold, String> {
    match text {
        "auto" => Ok(Threshold::Auto),
        _ => text.parse().map(Threshold::Gray).map_err(|_| format!("`{text}` is no gray: write a number from 0 to 255, or auto")),
    }
}

fn lattice(text: &str) -> Result<Lattice, String> {
    let wrong = || format!("`{text}` is no lattice: write X,Y,DX,DY,COLUMNS,ROWS such as 40,12,15.5,15.5,20,20");
    let numbers: Vec<&str> = text.split(',').map(str::trim).collect();
    let [x0, y0, dx, dy, columns, rows, ref lean @ ..] = numbers[..] else { return Err(wrong()) };
    let [shear_x, shear_y] = match lean {
        [] => ["0", "0"],
        [x, y] => [*x, *y],
        _ => return Err(wrong()),
    };
    let real = |number: &str| number.parse().map_err(|_| wrong());
    let whole = |number: &str| number.parse().map_err(|_| wrong());
    let (x0, y0, dx, dy) = (real(x0)?, real(y0)?, real(dx)?, real(dy)?);
    let (shear_x, shear_y) = (real(shear_x)?, real(shear_y)?);
    let lattice = Lattice { x0, y0, dx, dy, shear_x, shear_y, columns: whole(columns)?, rows: whole(rows)? };
    lattice.check().map_err(|error| {
        let report = error.report();
        format!("{}; {}", report.message, report.hint)
    })?;
    Ok(lattice)
}

impl ReadingArgs {
    /// The same as the engine has it; of a picture only the window.
    pub fn options(&self, crop: Option<Window>) -> ReadOptions {
        let usual = PictureOptions::default();
        let picture = PictureOptions {
            threshold: match self.threshold {
                None => usual.threshold,
                Some(Threshold::Auto) => None,
                Some(Threshold::Gray(gray)) => Some(gray),
            },
            light_is_blocked: self.light_is_blocked,
            crop,
            cells: self.cells,
            metres_per_pixel: self.metres_per_pixel,
            metres_per_cell: self.metres_per_cell,
        };
        let unknown = if self.unknown == Some(UnknownAs::Free) { Unknown::Free } else { Unknown::Blocked };
        let figure = self.figure.then_some(FigureOptions { lattice: self.lattice });
        let costs = self.costs.map(|rule| {
            let usual = Costs::by(rule);
            Costs { multiplier: self.costs_multiplier.unwrap_or(usual.multiplier), ..usual }
        });
        let swamp_factor = self.swamp_factor;
        ReadOptions { matrix: self.matrix, picture, unknown, costs, swamp_factor, cells: self.cells, figure }
    }

    /// By which rule values of the file are costs.
    pub fn costs(&self) -> Option<CostRule> {
        self.costs
    }

    /// Reads a map; the picture of a ROS map is looked for beside its description.
    pub fn import(&self, path: &Path) -> Result<Imported, CliError> {
        import(path, &self.options(None))
    }

    /// The same, for a command that knows one map alone: walls that change are refused.
    pub fn import_still(&self, path: &Path) -> Result<Imported, CliError> {
        let map = self.import(path)?;
        if map.spec.changes.is_empty() {
            return Ok(map);
        }
        let message = format!("the walls of this map change {} times; this command knows one map alone", map.spec.changes.len());
        Err(CliError::usage(message, "run it with `plan`, or leave `changes` out of the file"))
    }
}

/// Reads a map; the picture of a ROS map is looked for beside its description.
pub fn import(path: &Path, options: &ReadOptions) -> Result<Imported, CliError> {
    let image = image_beside(path)?;
    let beside = image.as_ref().map(|image| Companion { name: &image.name, bytes: &image.bytes });
    let mut map = input::in_file(path, MAX_BYTES, |bytes, name| formats::import_with(bytes, name, options, beside))?;
    map.notices.extend(image.and_then(|image| image.moved));
    Ok(map)
}

/// The picture that the description of a ROS map names.
struct Image {
    /// As the description writes it.
    name: String,
    bytes: Vec<u8>,
    /// That it was taken from beside the description.
    moved: Option<Notice>,
}

/// The picture that the description of a ROS map names; none for any other file.
fn image_beside(path: &Path) -> Result<Option<Image>, CliError> {
    /// A description is a few lines.
    const MOST: u64 = 1 << 20;
    // What is no file on a disk can be read only once.
    if path == Path::new("-") || std::fs::metadata(path).is_ok_and(|file| !file.is_file() || file.len() > MOST) {
        return Ok(None);
    }
    let image = input::in_file(path, MAX_BYTES, |bytes, name| match formats::recognise(bytes, name) {
        Ok(found) if found.kind == Kind::RosMap => ros::image_of(bytes).map(Some),
        _ => Ok(None),
    })?;
    let Some(image) = image else { return Ok(None) };
    // As it is written, else of this name beside the description: packages move.
    let beside = path.with_file_name(&image);
    let file = PathBuf::from(image.replace('\\', "/"));
    let moved = path.with_file_name(file.file_name().unwrap_or_default());
    let found = [&beside, &moved].into_iter().find(|candidate| candidate.is_file()).unwrap_or(&beside);
    if found.exists() && !found.is_file() {
        let message = format!("`{}`, which the description names as its picture, is no file", found.display());
        return Err(CliError::usage(message, "name a .pgm or .png beside the description"));
    }
    let bytes = input::bytes(found, MAX_BYTES as u64)?;
    let moved = (found != &beside).then(|| {
        let file = input::file_name(found);
        let message = format!("{image} was not found: the picture {file} beside the description was read");
        Notice::new("ros-image-beside", message).with("image", &image).with("file", file)
    });
    Ok(Some(Image { name: image, bytes, moved }))
}
