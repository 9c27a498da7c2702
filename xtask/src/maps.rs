//! `cargo xtask maps`: makes the suite of maps in experiments/maps, and the table of it in their README.
//!
//! Seeds are tried in order. A seed is left out only where start or goals lie on a wall or are not connected, or where a proven optimum
//! contradicts what the publication says of its map. No colony runs here.

mod groups;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use anyhow::{Context, Result, anyhow, bail};
use clap::Args;

use crate::tools::{self, root, run};
use groups::{Fact, GROUPS, Group};

#[derive(Args)]
pub struct Options {
    /// Also tell of this many first seeds of every group how many are fit
    #[arg(long, value_name = "N")]
    census: Option<u32>,
}

/// A suite that finds no map among so many seeds is not worth its name.
const MOST_SEEDS: u32 = 1000;

/// Where the table stands in the README.
const TABLE: [&str; 2] = ["<!-- Made by `cargo xtask maps` -->\n", "<!-- End -->\n"];

/// What became of a seed: its optima, one for each fact, or why it is left out.
type Tried = Result<Vec<f64>, Unfit>;

/// Why a seed is left out.
enum Unfit {
    OnAWall,
    NotConnected,
    /// The optimum of a fact, by its place, is above what is published.
    TooLong(usize, f64),
}

/// The maps of a group.
struct Made<'a> {
    group: &'a Group,
    taken: Vec<(u32, Vec<f64>)>,
    skipped: Vec<(u32, Unfit)>,
}

pub fn maps(options: &Options) -> Result<()> {
    run(tools::cargo().args(["build", "--package", "formicarium", "--bin", "formicarium"]))?;
    fs::create_dir_all(trial().parent().unwrap_or(Path::new("")))?;
    let mut rows = String::new();
    for group in &GROUPS {
        let made = make(group)?;
        println!("maps: {} of {}, {} seeds left out", made.taken.len(), group.name, made.skipped.len());
        rows += &made.row();
        if let Some(seeds) = options.census {
            census(group, seeds)?;
        }
    }
    let readme = folder().join("README.md");
    let text = fs::read_to_string(&readme)?;
    let place = text.split_once(TABLE[0]).and_then(|(before, rest)| Some((before, rest.split_once(TABLE[1])?.1)));
    let (before, after) = place.ok_or_else(|| anyhow!("{} has no place for the table", readme.display()))?;
    fs::write(&readme, [before, TABLE[0], HEAD, &rows, TABLE[1], after].concat())?;
    Ok(())
}

const HEAD: &str = "\
| group | generator | size | density | seeds taken | seeds left out, and why | optimum |
|---|---|---|---|---|---|---|
";

fn folder() -> PathBuf {
    root().join("experiments/maps")
}

/// A map that has not been found fit yet.
fn trial() -> PathBuf {
    tools::target_dir().join("maps/trial.json")
}

/// Makes the maps of a group, from its first seed on.
fn make(group: &Group) -> Result<Made<'_>> {
    let mut made = Made { group, taken: Vec::new(), skipped: Vec::new() };
    for seed in group.first_seed..group.first_seed + MOST_SEEDS {
        let number = made.taken.len() + 1;
        match try_seed(group, seed, number)? {
            Ok(optima) => {
                fs::copy(trial(), folder().join(format!("{}-{number:02}.json", group.name)))?;
                made.taken.push((seed, optima));
            }
            Err(unfit) => made.skipped.push((seed, unfit)),
        }
        if made.taken.len() == group.maps {
            return Ok(made);
        }
    }
    bail!("{}: only {} maps by {MOST_SEEDS} seeds", group.name, made.taken.len())
}

/// How many of the first seeds are fit, and the optima of all.
fn census(group: &Group, seeds: u32) -> Result<()> {
    let mut fit = 0;
    let mut told = String::new();
    for seed in group.first_seed..group.first_seed + seeds {
        told += &match try_seed(group, seed, 1)? {
            Ok(optima) => {
                fit += 1;
                format!(" {optima:.3?}")
            }
            Err(Unfit::TooLong(place, found)) => format!(" ({} {found:.3})", group.facts[place].what),
            Err(Unfit::OnAWall) => " wall".into(),
            Err(Unfit::NotConnected) => " no-path".into(),
        };
    }
    println!("  {fit} of the first {seeds} are fit:{told}");
    Ok(())
}

/// Makes a map, and proves what is asked of it.
fn try_seed(group: &Group, seed: u32, number: usize) -> Result<Tried> {
    let (width, height) = group.size;
    let mut command = formicarium(["generate", group.generator, "--size", &format!("{width}x{height}")]);
    command.args(["--seed", &seed.to_string()]).args(group.density.iter().flat_map(|share| ["--density", share]));
    command.args(group.ends(number)).args(["--as", "scenario", "--out"]).arg(trial());
    let made = output(&mut command)?;
    if !made.status.success() {
        let said = String::from_utf8_lossy(&made.stderr).into_owned();
        return if said.contains("lies on a blocked cell") { Ok(Err(Unfit::OnAWall)) } else { bail!("{}: {said}", group.name) };
    }
    let mut optima = Vec::new();
    for (place, fact) in group.facts.iter().enumerate() {
        match optimum(fact)? {
            None => return Ok(Err(Unfit::NotConnected)),
            Some(found) if fact.is_above(found)? => return Ok(Err(Unfit::TooLong(place, found))),
            Some(found) => optima.push(found),
        }
    }
    Ok(Ok(optima))
}

/// The proven optimum of the map; none where no path exists.
fn optimum(fact: &Fact) -> Result<Option<f64>> {
    let mut command = formicarium(["plan"]);
    command.arg(trial()).args(["--format", "json", "--planner"]).args(fact.planner);
    let found = output(&mut command)?;
    match found.status.code() {
        Some(0) => {}
        Some(1) => return Ok(None),
        _ => bail!("{}", String::from_utf8_lossy(&found.stderr)),
    }
    let result: serde_json::Value = serde_json::from_slice(&found.stdout).context("no result of `plan`")?;
    if result["status"] != "optimal" {
        bail!("{:?} proves nothing: {}", fact.planner, result["status"]);
    }
    result["value"].as_f64().map(Some).context("a result without a value")
}

fn formicarium<'a>(args: impl IntoIterator<Item = &'a str>) -> Command {
    let mut command = Command::new(tools::target_dir().join("debug/formicarium"));
    command.current_dir(root()).args(args);
    command
}

fn output(command: &mut Command) -> Result<Output> {
    command.output().with_context(|| format!("cannot start {}", command.get_program().display()))
}

impl Fact {
    /// Whether an optimum is above the published length by more than half a unit of its last digit.
    fn is_above(&self, found: f64) -> Result<bool> {
        let Some(printed) = self.most else { return Ok(false) };
        let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        Ok(found > printed.parse::<f64>()? + 0.5 / 10f64.powi(decimals as i32))
    }
}

impl Made<'_> {
    /// Its line of the table.
    fn row(&self) -> String {
        let Group { name, generator, size: (width, height), density, facts, .. } = self.group;
        let density = density.unwrap_or("");
        let taken = list(self.taken.iter().map(|(seed, _)| seed.to_string()));
        let range = |(place, fact): (usize, &Fact)| {
            let all = || self.taken.iter().map(|(_, optima)| optima[place]);
            let (least, most) = (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max));
            format!("{} {least:.3} to {most:.3}", fact.what)
        };
        let optimum = list(facts.iter().enumerate().map(range));
        format!("| {name} | {generator} | {width} × {height} | {density} | {taken} | {} | {optimum} |\n", self.reasons())
    }

    /// The seeds that are left out, by reason.
    fn reasons(&self) -> String {
        let seeds = |is: &dyn Fn(&Unfit) -> bool| {
            list(self.skipped.iter().filter(|(_, unfit)| is(unfit)).map(|(seed, _)| seed.to_string()))
        };
        let of_ends = [
            ("start or goal on a wall", seeds(&|unfit| matches!(unfit, Unfit::OnAWall))),
            ("not connected", seeds(&|unfit| matches!(unfit, Unfit::NotConnected))),
        ];
        let mut reasons: Vec<String> =
            of_ends.into_iter().filter(|(_, seeds)| !seeds.is_empty()).map(|(why, seeds)| format!("{why}: {seeds}")).collect();
        for (place, fact) in self.group.facts.iter().enumerate() {
            let too_long = list(self.skipped.iter().filter_map(|(seed, unfit)| match unfit {
                Unfit::TooLong(of, found) if *of == place => Some(format!("{seed} ({found:.3})")),
                _ => None,
            }));
            if !too_long.is_empty() {
                reasons.push(format!("{} above {}: {too_long}", fact.what, fact.most.unwrap_or_default()));
            }
        }
        if reasons.is_empty() { "none".into() } else { reasons.join("; ") }
    }
}

fn list(words: impl Iterator<Item = String>) -> String {
    words.collect::<Vec<_>>().join(", ")
}
