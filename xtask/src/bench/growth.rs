//! How time grows with ants and cells, and what more cores give.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread::available_parallelism;
use std::time::Instant;

use anyhow::{Result, ensure};
use serde_json::json;

use super::Extent;
use super::interval::Interval;
use super::maps;
use super::report::{Section, table};
use super::rounds::{Race, Rounds, nanoseconds_a_move, seconds};
use super::runner::Runner;

const ANTS: [u32; 3] = [10, 50, 200];
const SIDES: [u32; 6] = [20, 50, 100, 200, 512, 1024];

const NOTE: &str = "\
Ant System natively, 20 % walls by seed 1: with 10, 50 and 200 ants on 100², with 50 ants on larger and larger maps, \
whole iterations after the first, ratios to the first row of each. Then `formicarium compare`, the whole command: runs of Ant System on 100² on one core and on all of them, \
and how many times as fast that is.";

pub fn run(extent: &Extent) -> Result<Section> {
    let formicarium = maps::formicarium(extent.quick)?;
    let (side, sides) = if extent.quick { (24, &SIDES[..2]) } else { (100, &SIDES[..]) };
    let mut native = Runner::native()?;
    let ants = ANTS.map(|ants| (format!("{ants} ants"), side, ants));
    let mut rows = raced(&formicarium, &mut native, extent, &ants)?;
    let cells: Vec<_> = sides.iter().map(|&side| (format!("{side}²"), side, 50)).collect();
    rows.extend(raced(&formicarium, &mut native, extent, &cells)?);
    let walks = table(&["what", "ns an ant move", "ms an iteration", "a move takes times as long"], &rows);
    let map = maps::random(&formicarium, side, 20)?;
    let lengths: &[(u32, u32)] = if extent.quick { &[(2, 4)] } else { &[(15, 400), (150, 60)] };
    let rows = lengths.iter().map(|&(iterations, runs)| cores(&formicarium, &map, iterations, runs, extent.rounds));
    let rows = rows.collect::<Result<Vec<_>>>()?;
    let compare = table(&["runs", "ms a run, one core", "cores", "times as fast"], &rows);
    Ok(Section { name: "growth", text: format!("{NOTE} `cargo xtask bench growth`\n\n{walks}\n{compare}"), readme: None })
}

/// Walks with a name, on a map of this side, with so many ants.
fn raced(
    formicarium: &impl Fn() -> Command,
    native: &mut Runner,
    extent: &Extent,
    walks: &[(String, u32, u32)],
) -> Result<Vec<Vec<String>>> {
    let mut race = Race::new(vec![native]);
    let iterations = |side: u32, ants: u32| (100_000 / (side * ants)).clamp(2, 50);
    for (name, side, ants) in walks {
        println!("bench: growth, {name}…");
        let map = maps::random(formicarium, *side, 20)?;
        let params = json!({ "iterations": 100_000, "ants": ants });
        let iterations = iterations(*side, *ants);
        let job = json!({ "work": "walk", "who": "engine", "map": map, "planner": "ant-system", "params": params, "iterations": iterations });
        race.join(name, 0, &job)?;
    }
    let rounds = race.run(extent.rounds)?;
    let row = |(of, (_, side, ants)): (&Rounds, &(String, u32, u32))| {
        let ms = of.median(seconds).times(1e3 / f64::from(iterations(*side, *ants)));
        let ratio = of.ratio(&rounds[0], nanoseconds_a_move);
        vec![of.name.clone(), of.median(nanoseconds_a_move).to_string(), ms.to_string(), ratio.to_string()]
    };
    Ok(rounds.iter().zip(walks).map(row).collect())
}

/// The same comparison on one core and on all, in turn.
fn cores(formicarium: &impl Fn() -> Command, map: &Path, iterations: u32, runs: u32, rounds: usize) -> Result<Vec<String>> {
    let folder = maps::folder()?;
    let question = folder.join("cores.toml");
    fs::write(&question, text(map, iterations, runs))?;
    let all = available_parallelism().map_or(1, usize::from);
    let timed = |jobs: usize| {
        let mut compare = formicarium();
        compare.arg("compare").arg(&question).args(["--replace", "--files", "csv", "--jobs", &jobs.to_string()]);
        let out = folder.join("cores");
        // It would take finished runs over.
        let _ = fs::remove_dir_all(&out);
        let start = Instant::now();
        let output = compare.arg("--out").arg(out).output()?;
        ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        anyhow::Ok(start.elapsed().as_secs_f64())
    };
    println!("bench: compare, {runs} runs of {iterations} iterations…");
    let pair = |round: usize| {
        if round.is_multiple_of(2) {
            return anyhow::Ok([timed(1)?, timed(all)?]);
        }
        let many = timed(all)?;
        Ok([timed(1)?, many])
    };
    let pairs = (0..rounds).map(pair).collect::<Result<Vec<_>>>()?;
    let ms = Interval::of(pairs.iter().map(|pair| pair[0])).times(1e3 / f64::from(runs));
    let faster = Interval::of(pairs.iter().map(|pair| pair[0] / pair[1]));
    Ok(vec![format!("{runs} of {iterations} iterations"), ms.to_string(), all.to_string(), faster.to_string()])
}

fn text(map: &Path, iterations: u32, runs: u32) -> String {
    format!(
        r#"format = "formicarium/question@1"
title = "Cores"
asks = "What do more cores give?"
seeds = {{ from = 1, count = {runs} }}
instances = [{{ id = "map", map = {map:?} }}]

[[entries]]
id = "ant-system"
label = "Ant System"
role = "baseline"
planner = "ant-system"
set = {{ iterations = {iterations} }}
"#
    )
}
