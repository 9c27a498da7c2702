//! `cargo xtask record`: runs the questions in experiments/, experiments/public/ and experiments/tuning/ and leaves their records beside them.
//! Broken off, it goes on where it was when it is started again: every finished run is kept in NAME.partial.

mod public;

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use anyhow::{Context, Result, bail};
use clap::Args;

use crate::cards;
use crate::tools::{self, root, run};

#[derive(Args)]
pub struct Options {
    /// Only these questions, by their file names without `.toml`: `ship`, `public/gazebo`, `tuning/ship`
    names: Vec<String>,
}

/// The public grids on which questions are asked as well, without their ending. They are not ours to commit: these records are made where
/// the data folder is.
const GRIDS: [&str; 6] =
    ["G20_classic", "G20_idx32291551799_xunlu", "G20_idx7911825111", "G20_maaco_fig7", "G20_search_dense", "G20_winsleo_walls"];

/// A question that is asked on public maps, and the group of its instances that these join.
struct OnPublicMaps {
    question: &'static str,
    group: &'static str,
    maps: Maps,
}

enum Maps {
    /// [`GRIDS`] from corner to corner.
    Grids,
    /// The same, every other one walked from its goal to its start.
    GridsBothWays,
    /// The terrain of the textbook, with the ends and levels of the paper.
    Textbook,
}

const ON_PUBLIC_MAPS: [OnPublicMaps; 5] = [
    OnPublicMaps { question: "classics", group: "plane", maps: Maps::Grids },
    OnPublicMaps { question: "fireworks", group: "criss-cross", maps: Maps::Grids },
    OnPublicMaps { question: "ship", group: "ship-20x20", maps: Maps::Grids },
    OnPublicMaps { question: "terrain", group: "hills-20", maps: Maps::Textbook },
    OnPublicMaps { question: "threshold", group: "environment-2", maps: Maps::GridsBothWays },
];

pub fn record(options: &Options) -> Result<()> {
    let names = if options.names.is_empty() { questions()? } else { options.names.clone() };
    if let Some(unknown) = names.iter().find(|name| !root().join(question(name)).is_file()) {
        bail!("there is no {}: the questions are {}", question(unknown), questions()?.join(", "));
    }
    run(tools::cargo().args(["build", "--release", "--package", "formicarium", "--bin", "formicarium"]))?;
    let data = env::var_os("FORMICARIUM_DATA").filter(|data| !data.is_empty()).map(|data| root().join(data));
    let start = Instant::now();
    for name in &names {
        if name.starts_with(public::FOLDER) {
            match &data {
                Some(data) => timed(name, || public::record(name, data))?,
                None => left(name),
            }
            continue;
        }
        timed(name, || run(compare(name).args(["--out", &records(name)])))?;
        let Some(public) = ON_PUBLIC_MAPS.iter().find(|public| public.question == name) else { continue };
        match &data {
            Some(data) => timed(&format!("{name} on public maps"), || on_public_maps(public, &data.join("papers")))?,
            None => left(&format!("{name} on public maps")),
        }
    }
    println!("record: {:.0} s in all", start.elapsed().as_secs_f64());
    cards::update()
}

fn timed(what: &str, of: impl FnOnce() -> Result<()>) -> Result<()> {
    let start = Instant::now();
    of()?;
    println!("record: {what} took {:.0} s", start.elapsed().as_secs_f64());
    Ok(())
}

fn left(what: &str) {
    println!("record: {what} is left as it is, because FORMICARIUM_DATA is not set");
}

fn question(name: &str) -> String {
    format!("experiments/{name}.toml")
}

/// The folder of a question's record: `records` beside the question.
fn records(name: &str) -> String {
    let folder = name.rfind('/').map_or("", |slash| &name[..=slash]);
    format!("experiments/{folder}records")
}

/// Every question, in the order of the names; those on public maps alone and of planners that were tuned are last.
fn questions() -> Result<Vec<String>> {
    Ok([questions_in("")?, questions_in(public::FOLDER)?, questions_in("tuning/")?].concat())
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

fn formicarium() -> Command {
    let mut command = Command::new(tools::target_dir().join("release/formicarium"));
    command.current_dir(root());
    command
}

fn compare(name: &str) -> Command {
    let mut command = formicarium();
    command.args(["compare", &question(name), "--files", "csv,markdown"]);
    command
}

fn on_public_maps(public: &OnPublicMaps, papers: &Path) -> Result<()> {
    let maps = match public.maps {
        Maps::Grids => grids(papers),
        Maps::GridsBothWays => both_ways(papers)?,
        Maps::Textbook => vec![("textbook".into(), textbook(papers)?)],
    };
    let mut command = compare(public.question);
    command.args(["--out", public::RECORDS]);
    for (id, map) in &maps {
        command.args(["--only", id, "--map", &format!("{}/{id}={}", public.group, map.display())]);
    }
    run(&mut command)
}

fn grids(papers: &Path) -> Vec<(String, PathBuf)> {
    GRIDS.map(|name| (id_of(name), papers.join(format!("{name}.csv")))).into()
}

fn id_of(grid: &str) -> String {
    grid.to_lowercase().replace('_', "-")
}

fn both_ways(papers: &Path) -> Result<Vec<(String, PathBuf)>> {
    let mut maps = grids(papers);
    for (_, map) in maps.iter_mut().skip(1).step_by(2) {
        *map = converted(map, &["--from", "19,19", "--to", "0,0"])?;
    }
    Ok(maps)
}

fn textbook(papers: &Path) -> Result<PathBuf> {
    let moves = ["--model", "slices", "--level", "200", "--levels", "19"];
    let ends = ["--from", "0,9", "--from-level", "4", "--to", "20,7", "--to-level", "5"];
    converted(&papers.join("HeightData_21x21.csv"), &[&moves[..], &ends[..]].concat())
}

/// A map as a scenario of the same name, with these ends and rules.
fn converted(map: &Path, arguments: &[&str]) -> Result<PathBuf> {
    let folder = tools::target_dir().join("public-maps");
    std::fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
    let to = folder.join(map.file_name().context("a map has a name")?).with_extension("json");
    run(formicarium().arg("convert").arg(map).arg(&to).args(arguments))?;
    Ok(to)
}
