//! How time grows with ants and cells, and what more cores give.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread::available_parallelism;
use std::time::Instant;

use anyhow::{Result, ensure};
use serde_json::{Value, json};

use super::Extent;
use super::interval::{Interval, short};
use super::maps;
use super::report::{PERFORMANCE, Section, table};
use super::rounds::{Race, Rounds, nanoseconds_a_move, seconds};
use super::runner::Runner;

const ANTS: [u32; 3] = [10, 50, 200];
const SIDES: [u32; 7] = [20, 50, 100, 200, 512, 1024, 4096];

const NOTE: &str = "\
Ant System natively, 20 % walls by seed 1: with 10, 50 and 200 ants on 100², with 50 ants on larger and larger maps, \
whole iterations after the first, ratios to the first row of each. *First*: the planner with the first iteration; weights are learnt where \
ants come by. *Bytes a cell*: what the planner holds for each cell of the map after these iterations, of which memory is only taken where it \
is written to. Then one large run, `formicarium plan --threads`, on one core and on all of them: the ants of an iteration are shared out, \
and every digest is the same. Then `formicarium compare`, the whole command: runs of Ant System on 100² on one core and on all of them, \
and how many times as fast that is.";

pub fn run(extent: &Extent) -> Result<Section> {
    let formicarium = maps::formicarium(extent.quick)?;
    let (side, sides) = if extent.quick { (24, &SIDES[..2]) } else { (100, &SIDES[..]) };
    let mut native = Runner::native()?;
    let ants = ANTS.map(|ants| (format!("{ants} ants"), side, ants));
    let mut rows = raced(&formicarium, &mut native, extent, &ants)?;
    let cells: Vec<_> = sides.iter().map(|&side| (format!("{side}²"), side, 50)).collect();
    rows.extend(raced(&formicarium, &mut native, extent, &cells)?);
    let walks =
        table(&["what", "ns an ant move", "ms an iteration", "a move takes times as long", "first, ms", "bytes a cell"], &rows);
    let large: &[(u32, u32)] = if extent.quick { &[(48, 8)] } else { &[(512, 200), (1024, 200)] };
    let rows = large.iter().map(|&(side, ants)| threads(&formicarium, side, ants, extent));
    let threads = table(&["one run", "ms an iteration, one core", "cores", "times as fast"], &rows.collect::<Result<Vec<_>>>()?);
    let map = maps::random(&formicarium, side, 20)?;
    let lengths: &[(u32, u32)] = if extent.quick { &[(2, 4)] } else { &[(15, 400), (150, 60), (600, 24)] };
    let rows = lengths.iter().map(|&(iterations, runs)| cores(&formicarium, &map, iterations, runs, extent.rounds));
    let rows = rows.collect::<Result<Vec<_>>>()?;
    let compare = table(&["runs", "ms a run, one core", "cores", "times as fast"], &rows);
    Ok(Section {
        name: "growth",
        page: PERFORMANCE,
        text: format!("{NOTE} `cargo xtask bench growth`\n\n{walks}\n{threads}\n{compare}"),
        readme: None,
    })
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
    let row = |(of, &(_, side, ants)): (&Rounds, &(String, u32, u32))| {
        let ms = of.median(seconds).times(1e3 / f64::from(iterations(side, ants)));
        let ratio = of.ratio(&rounds[0], nanoseconds_a_move);
        let first = of.median(|answer| answer["first"].as_f64().unwrap_or(f64::NAN)).times(1e3);
        let bytes = of.median(|answer| answer["bytes"].as_f64().unwrap_or(f64::NAN)).times(1.0 / f64::from(side * side));
        let ns = of.median(nanoseconds_a_move);
        vec![of.name.clone(), ns.to_string(), ms.to_string(), ratio.to_string(), first.to_string(), short(bytes.median)]
    };
    Ok(rounds.iter().zip(walks).map(row).collect())
}

/// One run on one core and on all, in turn: what so many more iterations take, so that reading and the proof of the optimum do not count.
fn threads(formicarium: &impl Fn() -> Command, side: u32, ants: u32, extent: &Extent) -> Result<Vec<String>> {
    println!("bench: threads, {side}², {ants} ants…");
    let map = maps::random(formicarium, side, 20)?;
    let more = if extent.quick { 2 } else { 60 };
    let all = available_parallelism().map_or(1, usize::from);
    let timed = |threads: usize, iterations: u32| {
        let mut plan = formicarium();
        plan.arg("plan").arg(&map).args(["--planner", "ant-system", "--format", "json", "--threads", &threads.to_string()]);
        plan.args(["--set", &format!("ants={ants}"), "--set", &format!("iterations={iterations}"), "--set", "stagnation=0"]);
        let start = Instant::now();
        let output = plan.output()?;
        ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let result: Value = serde_json::from_slice(&output.stdout)?;
        anyhow::Ok((start.elapsed().as_secs_f64(), result["digest"].to_string()))
    };
    let difference = |threads: usize| {
        let (few, (many, digest)) = (timed(threads, 5)?.0, timed(threads, 5 + more)?);
        anyhow::Ok((many - few, digest))
    };
    let pair = |round: usize| {
        let (first, second) = if round.is_multiple_of(2) { (1, all) } else { (all, 1) };
        let ((a, digest), (b, other)) = (difference(first)?, difference(second)?);
        ensure!(digest == other, "on {all} threads the run is another one");
        Ok(if first == 1 { [a, b] } else { [b, a] })
    };
    let pairs = (0..extent.rounds).map(pair).collect::<Result<Vec<_>>>()?;
    let ms = Interval::of(pairs.iter().map(|pair| pair[0])).times(1e3 / f64::from(more));
    let faster = Interval::of(pairs.iter().map(|pair| pair[0] / pair[1]));
    Ok(vec![format!("{side}², {ants} ants"), ms.to_string(), all.to_string(), faster.to_string()])
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
