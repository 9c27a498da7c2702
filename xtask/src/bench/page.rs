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

/// First visits: how many times slower the page's own thread is made, the network (`benches/peers/page_opening.mjs` knows them), and both in
/// words.
const VISITS: [(u32, Option<&str>, &str); 3] =
    [(1, None, "as it is"), (4, None, "thread 4 × slower"), (4, Some("slow-4g"), "thread 4 × slower, slow 4G")];

const NOTE: &str = "\
The page as it is built, in headless Chromium without a graphics processor, 1440 × 900. *Playing*: six panels (Ant System, elitist, rank-based, \
MAX–MIN, Ant Colony System, fire, 50 ants each) play an iteration a frame on a map by seed 1, 20 % walls; from the input event, as the \
browser stamps it, until the panel's worker has drawn what it asks for, of the panel that is first and of the one that is last. *A second*: \
iterations that all panels finish meanwhile. *First visit*: nothing in the cache, files packed as static hosts do, from the address to the \
page's first word that a planner has made a step, and that a colony has finished an iteration; *longest task* of the page's thread until 3 \
seconds later, 0 where none took 50 ms. Slow 4G: 1.6 Mbit/s, answers after 150 ms, as Lighthouse has it. `cargo xtask bench page`";

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
    for (throttling, network, name) in VISITS {
        race.join(name, 0, &json!({ "work": "opening", "throttling": throttling, "network": network }))?;
    }
    let visits = race.run(extent.rounds)?;
    println!("bench: page on {side} × {side}…");
    let mut race = Race::new(vec![&mut page]);
    for (input, name) in INPUTS {
        let job = json!({ "work": "input", "input": input, "map": map, "planners": PLANNERS });
        race.join(&format!("{side}², playing: {name}"), 0, &job)?;
    }
    let playing = race.run(extent.rounds)?;
    let playing: Vec<_> = playing.iter().map(|of| row(of, [("first", 1e3), ("iterations", 1.0)])).collect();
    let visits: Vec<_> = visits.iter().map(|of| row(of, [("iteration", 1e3), ("task", 1e3)])).collect();
    let playing = table(&["playing", "ms, last panel", "ms, first panel", "iterations a second"], &playing);
    let visits = table(&["first visit", "ms, first step", "ms, first iteration", "ms, longest task"], &visits);
    Ok(Some(Section { name: "page", page: PERFORMANCE, text: format!("{NOTE}\n\n{playing}\n{visits}"), readme: None }))
}

/// Its name, milliseconds, and the medians of two more fields of its answers, each times a factor; a dash where they do not tell.
fn row(of: &Rounds, fields: [(&'static str, f64); 2]) -> Vec<String> {
    let median = |(field, factor): (&'static str, f64)| {
        let number = |answer: &Value| answer[field].as_f64().unwrap_or(f64::NAN);
        let told = of.answers.iter().all(|answer| answer[field].is_number());
        if told { of.median(number).times(factor).to_string() } else { "–".into() }
    };
    let [second, third] = fields.map(median);
    vec![of.name.clone(), of.median(seconds).times(1e3).to_string(), second, third]
}
