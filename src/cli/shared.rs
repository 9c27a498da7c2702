//! What other programs that hold the library take from the command line, so that they read, refuse and write as it does: the Python package.

use std::ffi::OsString;
use std::path::Path;

use clap::Parser;

use super::compare;
use super::convert;
pub use super::error::CliError;
pub use super::streams::heard;
use crate::comparison::Comparison;
use crate::error::ScenarioError;
use crate::formats::{Imported, ReadOptions, TerrainOptions};
use crate::map::Generator;

/// Reads a map, or the piece of it that is asked for, as `convert` does; `square`: as its `--square`.
///
/// # Errors
/// As the command line has them.
pub fn read_map(path: &Path, options: &ReadOptions, piece: TerrainOptions, square: bool) -> Result<Imported, CliError> {
    convert::read(path, options, piece, square)
}

/// Writes a map in the format that the ending of its name tells; says what the format does not hold.
///
/// # Errors
/// As the command line has them.
pub fn write_map(path: &Path, map: &Imported) -> Result<(), CliError> {
    super::output::check(Some(path))?;
    convert::write(path, convert::told_by_ending(path, map)?, map)
}

/// Makes a map as `generate` does: `size` in columns and rows; where no density is given, what that takes.
///
/// # Errors
/// [`ScenarioError`] for a size or a density that cannot be.
pub fn generate(kind: Generator, size: (u32, u32), seed: u32, density: Option<f64>) -> Result<Imported, ScenarioError> {
    super::generate::make(kind, size, seed, density)
}

/// The arguments of `compare` alone.
#[derive(Parser)]
#[command(name = "compare", no_binary_name = true)]
struct Alone {
    #[command(flatten)]
    args: compare::Args,
}

/// What `compare` asks with these arguments, and the command that its reports name.
///
/// # Errors
/// As the command line has them.
pub fn read_question(arguments: impl IntoIterator<Item = OsString>) -> Result<(Comparison, String), CliError> {
    let unclear = |error: clap::Error| CliError::usage(error.render().to_string().trim(), "as `formicarium compare --help` says");
    let args = Alone::try_parse_from(arguments).map_err(unclear)?.args;
    Ok((compare::asked(&args)?, args.command()))
}
