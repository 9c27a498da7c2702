//! `cargo xtask record`: runs the questions in experiments/ and experiments/tuning/ and leaves their records beside them.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};
use clap::Args;

use crate::tools::{self, root, run};

#[derive(Args)]
pub struct Options {
    /// Only these questions, by their file names without `.toml`: `ship`, `tuning/ship`
    names: Vec<String>,
}

/// The public grid on which the questions are asked as well: (question, the instance it stands in for). The grid itself is not ours to
/// commit, so these records are made where the data folder is.
const GRID: &str = "papers/G20_classic.csv";
const ON_GRID: [(&str, &str); 4] =
    [("ship", "ship-20x20"), ("threshold", "threshold-2"), ("classics", "criss-cross"), ("fireworks", "criss-cross")];

pub fn record(options: &Options) -> Result<()> {
    let names = if options.names.is_empty() { questions()? } else { options.names.clone() };
    run(tools::cargo().args(["build", "--release", "--package", "formicarium", "--bin", "formicarium"]))?;
    let grid = env::var_os("FORMICARIUM_DATA").filter(|data| !data.is_empty()).map(|data| root().join(data).join(GRID));
    for name in &names {
        if !root().join(question(name)).is_file() {
            bail!("there is no {}: the questions are {}", question(name), questions()?.join(", "));
        }
        run(compare(name).args(["--out", &records(name)]))?;
        match (&grid, ON_GRID.iter().find(|(question, _)| question == name)) {
            (Some(grid), Some((_, instance))) => on_grid(name, instance, grid)?,
            (None, Some(_)) => println!("record: {name} on {GRID} is left as it is, because FORMICARIUM_DATA is not set"),
            _ => {}
        }
    }
    Ok(())
}

fn question(name: &str) -> String {
    format!("experiments/{name}.toml")
}

/// The folder of a question's record: `records` beside the question.
fn records(name: &str) -> String {
    let folder = name.rfind('/').map_or("", |slash| &name[..=slash]);
    format!("experiments/{folder}records")
}

/// Every question, in the order of the names; those of planners that were tuned are last.
fn questions() -> Result<Vec<String>> {
    Ok([questions_in("")?, questions_in("tuning/")?].concat())
}

fn questions_in(part: &str) -> Result<Vec<String>> {
    let folder = root().join("experiments").join(part);
    let files = folder.read_dir().with_context(|| format!("cannot read {}", folder.display()))?;
    let paths: Vec<PathBuf> = files.map(|file| Ok(file?.path())).collect::<Result<_>>()?;
    let name = |path: &PathBuf| path.file_stem().map(|stem| format!("{part}{}", stem.to_string_lossy()));
    let mut names: Vec<String> = paths.iter().filter(|p| p.extension().is_some_and(|e| e == "toml")).filter_map(name).collect();
    names.sort();
    Ok(names)
}

fn compare(name: &str) -> Command {
    let mut command = Command::new(tools::target_dir().join("release/formicarium"));
    command.current_dir(root()).args(["compare", &question(name), "--files", "csv,markdown,tests"]);
    command
}

fn on_grid(name: &str, instance: &str, grid: &Path) -> Result<()> {
    let map = format!("{instance}={}", grid.display());
    run(compare(name).args(["--out", "experiments/records/G20_classic", "--only", instance, "--map", &map]))
}
