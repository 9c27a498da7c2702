//! The built page in Chromium: from an input to the picture that shows it, while panels play, and from the address to the first step.

use anyhow::Result;
use serde_json::{Value, json};

use super::Extent;
use super::maps;
use super::report::{PERFORMANCE, Section, table};
use super::rounds::{Race, Rounds, seconds};
use super::runner::Runner;

/// What a race of six panels shows.
const PLANNERS: [&str; 6] =
    ["ant-system", "elitist-ant-system", "rank-based-ant-system", "max-min-ant-system", "ant-colony-system", "fire"];

/// As `benches/peers/page_race.mjs` calls them, and what they are.
const INPUTS: [(&str, &str); 4] =
    [("hover", "pointer over a cell"), ("zoom", "wheel, zoomed"), ("pan", "drag, moved"), ("press", "first cell of a wall")];

/// How many times slower the page's own thread is made, for the first visit.
const THROTTLING: u32 = 4;

const NOTE: &str = "\
The page as it is built, in headless Chromium without a graphics processor, 1440 × 900. *Playing*: six panels (Ant System, elitist, rank-based, \
MAX–MIN, Ant Colony System, fire, 50 ants each) play an iteration a frame on a map by seed 1, 20 % walls; from the input event, as the \
browser stamps it, until the panel's worker has drawn what it asks for, of the panel that is first and of the one that is last. *A second*: \
iterations that all panels finish meanwhile. *First visit*: nothing in the cache, files packed as static hosts do; the page's own thread \
4 times slower than it is, from the address to the page's first word that a planner has made a step. `cargo xtask bench page`";

pub fn run(extent: &Extent) -> Result<Option<Section>> {
    let Some(mut page) = Runner::page()? else {
        println!("bench: page SKIPPED, Chromium is not here");
        return Ok(None);
    };
    let side = if extent.quick { 64 } else { 1024 };
    let map = maps::random(&maps::formicarium(extent.quick)?, side, 20)?;
    // First, while no other page is open beside it.
    println!("bench: first visits…");
    let mut race = Race::new(vec![&mut page]);
    race.join("first visit: first step", 0, &json!({ "work": "opening", "throttling": THROTTLING }))?;
    let visits = race.run(extent.rounds)?;
    println!("bench: page on {side} × {side}…");
    let mut race = Race::new(vec![&mut page]);
    for (input, name) in INPUTS {
        let job = json!({ "work": "input", "input": input, "map": map, "planners": PLANNERS });
        race.join(&format!("{side}², playing: {name}"), 0, &job)?;
    }
    let playing = race.run(extent.rounds)?;
    let rows: Vec<_> = playing.iter().chain(&visits).map(row).collect();
    let heads = ["what", "ms, last panel", "ms, first panel", "iterations a second"];
    Ok(Some(Section { name: "page", page: PERFORMANCE, text: format!("{NOTE}\n\n{}", table(&heads, &rows)), readme: None }))
}

fn row(of: &Rounds) -> Vec<String> {
    let told = |field: &'static str| of.answers.iter().all(|answer| answer[field].is_number());
    let number = |field: &'static str| move |answer: &Value| answer[field].as_f64().unwrap_or(f64::NAN);
    let median = |field, factor| {
        if told(field) { of.median(number(field)).times(factor).to_string() } else { "–".into() }
    };
    vec![of.name.clone(), of.median(seconds).times(1e3).to_string(), median("first", 1e3), median("iterations", 1.0)]
}
