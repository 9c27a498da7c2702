//! Every colony of the catalog: what a move of its ants takes.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result};
use serde_json::{Map, Value, json};

use super::Extent;
use super::maps;
use super::report::{PERFORMANCE, Section, table};
use super::rounds::{Race, Rounds, nanoseconds_a_move};
use super::runner::Runner;

const NOTE: &str = "\
Every colony of the catalog with 50 ants and otherwise its defaults, natively, on 100², 20 % walls; those that need a terrain by slices on hills of \
60². Whole iterations after the first, walls and ends by seed 1. Ratios are to the first colony of the same map, round by round. \
`cargo xtask bench colonies`";

/// What colonies are asked, where they know it: a hybrid's first stage is over at once.
const PARAMS: [(&str, u32); 3] = [("ants", 50), ("iterations", 100_000), ("seed_iterations", 1)];

/// A map, its name, and the ground that it is.
struct Site {
    name: &'static str,
    ground: &'static str,
    map: PathBuf,
}

pub fn run(extent: &Extent) -> Result<Section> {
    let formicarium = maps::formicarium(extent.quick)?;
    let iterations = if extent.quick { 2 } else { 10 };
    let mut native = Runner::native()?;
    let mut colonies = colonies(&formicarium)?;
    let mut rows = Vec::new();
    for site in sites(&formicarium, extent)? {
        let (here, elsewhere) = colonies.into_iter().partition(|colony| on(colony, site.ground));
        colonies = elsewhere;
        rows.extend(raced(&mut native, &site, &here, iterations, extent.rounds)?);
    }
    let text = format!("{NOTE}\n\n{}", table(&["map", "colony", "ns an ant move", "times as long"], &rows));
    Ok(Section { name: "colonies", page: PERFORMANCE, text, readme: None })
}

/// What the catalog says of planners with ants.
fn colonies(formicarium: &impl Fn() -> Command) -> Result<Vec<Value>> {
    let told = formicarium().args(["catalog", "--json"]).output()?;
    let catalog: Value = serde_json::from_slice(&told.stdout).context("the catalog is no JSON")?;
    let all = catalog["planners"].as_array().context("the catalog lists planners")?;
    Ok(all.iter().filter(|planner| planner["family"] == "ant-colony").cloned().collect())
}

fn on(colony: &Value, ground: &str) -> bool {
    colony["grounds"].as_array().is_some_and(|grounds| grounds.iter().any(|on| on == ground))
}

fn sites(formicarium: &impl Fn() -> Command, extent: &Extent) -> Result<[Site; 2]> {
    let (side, hills) = if extent.quick { (24, 20) } else { (100, 60) };
    let (from, to) = (format!("0,{}", hills / 2), format!("{},{}", hills - 1, hills / 2 - 1));
    let slices = ["--model", "slices", "--from", &from, "--to", &to];
    Ok([
        Site { name: "plane", ground: "plane", map: maps::random(formicarium, side, 20)? },
        Site { name: "hills, slices", ground: "slices", map: maps::made(formicarium, "hills", hills, &slices)? },
    ])
}

fn raced(native: &mut Runner, site: &Site, colonies: &[Value], iterations: u32, rounds: usize) -> Result<Vec<Vec<String>>> {
    let mut race = Race::new(vec![native]);
    for colony in colonies {
        let id = colony["id"].as_str().context("a planner has an id")?;
        println!("bench: {id} on {}…", site.name);
        let job = json!({ "work": "walk", "who": "engine", "map": site.map, "planner": id, "params": params(colony), "iterations": iterations });
        race.join(id, 0, &job)?;
    }
    let rounds = race.run(rounds)?;
    let row = |of: &Rounds| {
        let ratio = of.ratio(&rounds[0], nanoseconds_a_move);
        vec![site.name.into(), of.name.clone(), of.median(nanoseconds_a_move).to_string(), ratio.to_string()]
    };
    Ok(rounds.iter().map(row).collect())
}

fn params(colony: &Value) -> Map<String, Value> {
    let known = |key: &str| colony["params"].as_array().is_some_and(|params| params.iter().any(|param| param["key"] == key));
    PARAMS.iter().filter(|(key, _)| known(key)).map(|&(key, value)| (key.into(), value.into())).collect()
}
