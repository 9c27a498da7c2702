//! Ant System's walk: natively, in node and in Chromium; beside the naive one, and beside JavaScript of the same rules.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Result, ensure};
use serde_json::{Value, json};

use super::Extent;
use super::interval::{Interval, short};
use super::maps;
use super::report::{PERFORMANCE, Section, table};
use super::rounds::{Race, Rounds, nanoseconds_a_move, seconds};
use super::runner::Runner;

/// Side, and iterations of a round, after the first.
const SIZES: [(u32, u32); 4] = [(20, 100), (100, 20), (512, 8), (1024, 4)];
const QUICK: [(u32, u32); 2] = [(20, 5), (48, 2)];
const WALLS: [u32; 3] = [0, 20, 30];
/// The map that the README speaks of.
const README: (u32, u32) = (100, 20);

const NATIVE: &str = "engine, native";
const NODE: &str = "engine, node";
const CHROMIUM: &str = "engine, Chromium";
const NAIVE: &str = "naive walk, native";
const JAVASCRIPT: &str = "JavaScript, typed arrays, node";

/// What each is compared with.
const BESIDE: [(&str, &str); 4] = [(NAIVE, NATIVE), (NODE, NATIVE), (JAVASCRIPT, NODE), (CHROMIUM, NATIVE)];

const NOTE: &str = "\
Ant System with its defaults and 50 ants, from corner to corner of maps made by seed 1 (`formicarium generate random`). An ant makes at most \
8 × side moves. *First*: the planner with its tables and the first iteration. The other columns: the iterations after it, whole, with walks, \
deposit, evaporation, weights. Every round has another seed. The engine and the naive walk (`benches/reference`: a power for each neighbour of each step) end with equal digests; the \
JavaScript (`benches/peers/typed_arrays.mjs`) has the same rules and another random stream, and its paths are checked.";

pub fn run(extent: &Extent) -> Result<Section> {
    let formicarium = maps::formicarium(extent.quick)?;
    let mut runners = vec![Runner::native()?, Runner::node()?];
    runners.extend(Runner::chromium()?);
    let (sizes, walls) = if extent.quick { (&QUICK[..], &WALLS[1..2]) } else { (&SIZES[..], &WALLS[..]) };
    let (mut rows, mut readme) = (Vec::new(), None);
    for (&(side, iterations), &walls) in sizes.iter().flat_map(|size| walls.iter().map(move |walls| (size, walls))) {
        println!("bench: walk on {side} × {side}, {walls} % walls…");
        let map = maps::random(&formicarium, side, walls)?;
        let rounds = race(&mut runners, &map, iterations)?.run(extent.rounds)?;
        check(&formicarium, &map, &rounds)?;
        rows.extend(rounds.iter().map(|of| row(&format!("{side}², {walls} %"), of, &rounds, iterations)));
        if (side, walls) == README {
            readme = Some(sentence(&rounds));
        }
    }
    let heads = [
        "map, walls",
        "what",
        "ns an ant move",
        "million moves a second",
        "ms an iteration",
        "a move takes times as long",
        "first, ms",
    ];
    let left_out = if runners.len() > 2 { "" } else { " Chromium is left out: it is not here." };
    let text = format!("{NOTE}{left_out} `cargo xtask bench walk`\n\n{}", table(&heads, &rows));
    Ok(Section { name: "walk", page: PERFORMANCE, text, readme })
}

fn race<'a>(runners: &'a mut [Runner], map: &Path, iterations: u32) -> Result<Race<'a>> {
    let job = |who: &str| {
        let params = json!({ "iterations": 100_000, "ants": 50 });
        json!({ "work": "walk", "who": who, "map": map, "planner": "ant-system", "params": params, "iterations": iterations })
    };
    let mut race = Race::new(runners.iter_mut().collect());
    race.join(NATIVE, 0, &job("engine"))?;
    race.join(NAIVE, 0, &job("naive"))?;
    race.join(NODE, 1, &job("engine"))?;
    race.join(JAVASCRIPT, 1, &job("typed-arrays"))?;
    if race.runners() > 2 {
        race.join(CHROMIUM, 2, &job("engine"))?;
    }
    Ok(race)
}

/// Equal digests mean the same steps of every ant; of the JavaScript the command line says whether its path is one.
fn check(formicarium: &impl Fn() -> Command, map: &Path, rounds: &[Rounds]) -> Result<()> {
    let native = &rounds[0];
    for of in rounds.iter().filter(|of| of.name != JAVASCRIPT) {
        let same = native.answers.iter().zip(&of.answers).all(|(a, b)| a["digest"] == b["digest"]);
        ensure!(same, "{} does not end as {} does", of.name, native.name);
    }
    let paths = rounds.iter().filter(|of| of.name == JAVASCRIPT).flat_map(|of| &of.answers).map(|answer| &answer["path"]);
    let file = maps::folder()?.join("path.json");
    for path in paths {
        fs::write(&file, path.to_string())?;
        let checked = formicarium().arg("check").arg(&file).arg("--map").arg(map).output()?;
        ensure!(checked.status.success(), "the path of the JavaScript is none: {}", String::from_utf8_lossy(&checked.stdout));
    }
    Ok(())
}

fn row(map: &str, of: &Rounds, all: &[Rounds], iterations: u32) -> Vec<String> {
    let ns = of.median(nanoseconds_a_move);
    let ms = of.median(seconds).times(1e3 / f64::from(iterations));
    let first = of.median(|answer| answer["first"].as_f64().unwrap_or(f64::NAN)).times(1e3);
    let ratio = beside(&of.name, all).map_or_else(|| "–".into(), |(than, ratio)| format!("{ratio} of {than}"));
    vec![map.into(), of.name.clone(), ns.to_string(), short(1e3 / ns.median), ms.to_string(), ratio, first.to_string()]
}

/// How many times as long a move takes as one of whom it is compared with.
fn beside(name: &str, all: &[Rounds]) -> Option<(&'static str, Interval)> {
    let (_, than) = BESIDE.into_iter().find(|(of, _)| *of == name)?;
    let find = |name: &str| all.iter().find(|of| of.name == name);
    Some((than, find(name)?.ratio(find(than)?, nanoseconds_a_move)))
}

fn sentence(rounds: &[Rounds]) -> String {
    let per_second = |name| {
        let rate = |answer: &Value| 1e3 / nanoseconds_a_move(answer);
        rounds.iter().find(|of| of.name == name).map_or(f64::NAN, |of| of.median(rate).median)
    };
    let ratio = |name| beside(name, rounds).map_or(f64::NAN, |(_, ratio)| ratio.median);
    format!(
        "{} million ant moves a second on one core, {} million in node; a walk that computes every power anew takes {} times as long, \
         careful JavaScript of the same rules {} times",
        short(per_second(NATIVE)),
        short(per_second(NODE)),
        short(ratio(NAIVE)),
        short(ratio(JAVASCRIPT))
    )
}
