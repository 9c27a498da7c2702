//! Shortest paths: the engine natively and in node, beside the crates and the npm package that people take for it.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde_json::{Value, json};

use super::Extent;
use super::interval::{Interval, short};
use super::maps::{self, Listed};
use super::report::{PERFORMANCE, Section, table};
use super::rounds::{Race, Rounds, seconds};
use super::runner::Runner;

const NATIVE: &str = "engine, native";
const NODE: &str = "engine, node";
const CRATE_ASTAR: &str = "crate `pathfinding`, A*";
const CRATE_JPS: &str = "crate `grid_pathfinding`, JPS (cuts corners)";
const NPM_ASTAR: &str = "npm `pathfinding`, A*";
const NPM_JPS: &str = "npm `pathfinding`, JPS";

/// What each is compared with.
const BESIDE: [(&str, &str); 5] =
    [(CRATE_ASTAR, NATIVE), (CRATE_JPS, NATIVE), (NODE, NATIVE), (NPM_ASTAR, NODE), (NPM_JPS, NODE)];

/// MovingAI's maps of five kinds.
const LISTED: [(&str, &str); 5] = [
    ("random", "random512-25-0"),
    ("rooms", "32room_000"),
    ("maze", "maze512-8-0"),
    ("game", "brc202d"),
    ("city", "Berlin_0_1024"),
];
/// Lists have six figures.
const LISTED_TO: f64 = 5.1e-6;
/// Kinds of the generator, where there are no others.
const MADE: [&str; 5] = ["random", "rooms", "maze", "cave", "blocks"];

const NOTE: &str = "\
The length of the shortest path with eight moves, diagonal ones only where both cells beside them are free. Whoever answers gets the map in \
the form that its own documentation asks for, and two cells; timed is everything that a further question on the map costs: natively the engine has scanned its rows before, as `grid_pathfinding` has \
joined its cells to components; in node it makes its scenario anew for each question, and npm's package needs a copy of its grid. All \
lengths are equal, and are those that MovingAI lists; only `grid_pathfinding` passes corners and answers another question: its lengths are \
as large or smaller.";

/// A map with its questions, and what they should be answered, where that is known.
struct Questions {
    name: String,
    map: PathBuf,
    lines: Vec<[u32; 4]>,
    listed: Option<Vec<f64>>,
}

pub fn run(extent: &Extent) -> Result<Section> {
    let formicarium = maps::formicarium(extent.quick)?;
    let mut runners = [Runner::native()?, Runner::node()?, Runner::crates()?];
    let (all, source) = questions(&formicarium, extent)?;
    let (mut rows, mut slower) = (Vec::new(), Vec::new());
    for questions in all {
        println!("bench: exact on {}…", questions.name);
        let rounds = race(&mut runners, &questions)?.run(extent.rounds)?;
        check(&questions, &rounds)?;
        rows.extend(rounds.iter().map(|of| row(&questions, of, &rounds)));
        slower.push(BESIDE.map(|(of, _)| beside(of, &rounds).map_or(f64::NAN, |(_, ratio)| ratio.median)));
    }
    let heads = ["map", "what", "ms a question", "times as long"];
    let text = format!("{NOTE} {source} `cargo xtask bench exact`\n\n{}", table(&heads, &rows));
    Ok(Section { name: "exact", page: PERFORMANCE, text, readme: Some(sentence(&slower)) })
}

/// MovingAI's where they are, else made ones; and a sentence that says so.
fn questions(formicarium: &impl Fn() -> Command, extent: &Extent) -> Result<(Vec<Questions>, String)> {
    let count = if extent.quick { 2 } else { 10 };
    if let (Some(data), false) = (maps::data(), extent.quick) {
        let read = |(kind, name): (&str, &str)| Ok(listed(kind, name, count, maps::movingai(formicarium, &data, name)?));
        let source = format!("{count} lines of each list, spread over all of it.");
        return Ok((LISTED.into_iter().map(read).collect::<Result<_>>()?, source));
    }
    let (side, kinds) = if extent.quick { (64, &MADE[..2]) } else { (512, &MADE[..]) };
    let make = |kind: &&str| {
        let map = maps::made(formicarium, kind, side, &[])?;
        let [x, y, to_x, to_y] = maps::ends(&map)?;
        let lines = vec![[x, y, to_x, to_y], [to_x, to_y, x, y]];
        Ok(Questions { name: format!("made: {kind}, {side}²"), map, lines, listed: None })
    };
    let source = "The maps are made by seed 1, from corner to corner and back: those of MovingAI are not here.".into();
    Ok((kinds.iter().map(make).collect::<Result<_>>()?, source))
}

/// So many lines, spread over the list.
fn listed(kind: &str, name: &str, count: usize, Listed { map, lines }: Listed) -> Questions {
    let picked = (0..count).map(|i| lines[(2 * i + 1) * lines.len() / (2 * count)]);
    let (lines, lengths) = picked.unzip();
    Questions { name: format!("{kind}: {name}"), map, lines, listed: Some(lengths) }
}

fn race<'a>(runners: &'a mut [Runner; 3], questions: &Questions) -> Result<Race<'a>> {
    let job = |who: &str| json!({ "work": "exact", "who": who, "map": questions.map, "lines": questions.lines });
    let mut race = Race::new(runners.iter_mut().collect());
    race.join(NATIVE, 0, &job("engine"))?;
    race.join(CRATE_ASTAR, 2, &job("pathfinding"))?;
    race.join(CRATE_JPS, 2, &job("grid_pathfinding"))?;
    race.join(NODE, 1, &job("engine"))?;
    race.join(NPM_ASTAR, 1, &job("npm-astar"))?;
    race.join(NPM_JPS, 1, &job("npm-jps"))?;
    Ok(race)
}

/// All say the same, and what the list says.
fn check(questions: &Questions, rounds: &[Rounds]) -> Result<()> {
    let ours = lengths(&rounds[0].answers[0])?;
    for (&listed, (length, line)) in questions.listed.iter().flatten().zip(ours.iter().zip(&questions.lines)) {
        ensure!(
            (listed / length - 1.0).abs() < LISTED_TO,
            "{}: {line:?} is listed as {listed}, found as {length}",
            questions.name
        );
    }
    for of in rounds {
        for answer in &of.answers {
            for (length, (ours, line)) in lengths(answer)?.iter().zip(ours.iter().zip(&questions.lines)) {
                let fits = if of.name == CRATE_JPS { length - ours < 1e-6 } else { (length - ours).abs() < 1e-6 };
                ensure!(fits, "{}, {}: {line:?} is {length} and not {ours}", questions.name, of.name);
            }
        }
    }
    Ok(())
}

fn lengths(answer: &Value) -> Result<Vec<f64>> {
    let lengths = answer["lengths"].as_array().context("an answer has lengths")?;
    lengths.iter().map(|length| length.as_f64().context("a length is a number")).collect()
}

fn row(questions: &Questions, of: &Rounds, all: &[Rounds]) -> Vec<String> {
    let ms = of.median(seconds).times(1e3 / questions.lines.len() as f64);
    let ratio = beside(&of.name, all).map_or_else(|| "–".into(), |(than, ratio)| format!("{ratio} of {than}"));
    vec![questions.name.clone(), of.name.clone(), ms.to_string(), ratio]
}

/// How many times as long it takes as whom it is compared with.
fn beside(name: &str, all: &[Rounds]) -> Option<(&'static str, Interval)> {
    let (_, than) = BESIDE.into_iter().find(|(of, _)| *of == name)?;
    let find = |name: &str| all.iter().find(|of| of.name == name);
    Some((than, find(name)?.ratio(find(than)?, seconds)))
}

/// From map to map.
fn sentence(slower: &[[f64; BESIDE.len()]]) -> String {
    let range = |name| {
        let column = BESIDE.iter().position(|(of, _)| *of == name).expect("it is compared");
        let all = || slower.iter().map(|ratios| ratios[column]);
        format!("{} to {}", short(all().fold(f64::INFINITY, f64::min)), short(all().fold(0.0, f64::max)))
    };
    format!(
        "the crate `pathfinding` takes {} times as long for a shortest path, the npm package `pathfinding` {} times as long as the engine \
         in node, its jump points {}",
        range(CRATE_ASTAR),
        range(NPM_ASTAR),
        range(NPM_JPS)
    )
}
