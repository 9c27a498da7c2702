//! Instructions that a move of an ant takes, counted by valgrind: a number that does not drift, so it is held.
//!
//! A run of more iterations less one of fewer: what it costs to start, to read the map and to make the planner is in both.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};

use super::Extent;
use super::interval::short;
use super::maps;
use super::report::{PERFORMANCE, Section, table};
use super::runner::native_program;
use crate::tools::{find, root};

const PLANNERS: [&str; 4] = ["ant-system", "ant-colony-system", "ship", "fire"];
const ITERATIONS: [u32; 2] = [5, 15];
/// More than this beyond the number that is held is a fault.
const TOLERANCE: f64 = 0.05;

const NOTE: &str = "\
Of the engine on 100², 20 % walls by seed 1, each colony with its defaults, iterations 6 to 15 (`valgrind --tool=callgrind`). \
`benches/instructions.json` holds the numbers for this machine's kind of processor; `cargo xtask test bench` fails where one has grown by \
more than 5 %, and `cargo xtask bench instructions --bless` writes them anew. `cargo xtask bench instructions`";

/// By planner.
type Counts = BTreeMap<String, f64>;

pub fn run(extent: &Extent) -> Result<Option<Section>> {
    if find("valgrind").is_none() {
        println!("bench: instructions SKIPPED, valgrind is not here");
        return Ok(None);
    }
    let map = maps::random(&maps::formicarium(extent.quick)?, 100, 20)?;
    let program = native_program()?;
    let count = |id: &str| {
        println!("bench: instructions of {id}…");
        Ok((id.to_owned(), a_move(&program, &map, id)?))
    };
    let counted = PLANNERS.into_iter().map(count).collect::<Result<Counts>>()?;
    let held = held()?;
    if extent.bless {
        bless(&counted)?;
    } else {
        compare(&counted, &held)?;
    }
    let row = |(id, count): (&String, &f64)| {
        let change = held.get(id).map_or_else(|| "–".into(), |held| format!("{:+.1} %", 100.0 * (count / held - 1.0)));
        vec![id.clone(), short(*count), change]
    };
    let rows: Vec<_> = counted.iter().map(row).collect();
    let colonies = table(&["colony", "instructions an ant move", "beside the number held"], &rows);
    let phases = table(&["phase of Ant System", "instructions an ant move", "share"], &phases(&program, &map)?);
    let text = format!("{NOTE}\n\n{colonies}\n{phases}");
    Ok(Some(Section { name: "instructions", page: PERFORMANCE, text, readme: None }))
}

fn a_move(program: &Path, map: &Path, planner: &str) -> Result<f64> {
    let [few, many] = ITERATIONS;
    let (few, many) = (counted(program, map, planner, few)?, counted(program, map, planner, many)?);
    Ok((many.instructions - few.instructions) / (many.moves - few.moves))
}

struct Run {
    instructions: f64,
    moves: f64,
}

/// What an iteration of Ant System is spent on: the functions that do it, and all the rest.
const PHASES: [(&str, &str); 3] = [
    ("walking", "aco::lanes::walk_all"),
    ("weights, where trails have changed or an ant comes by first", "aco::weights::WeightTable"),
    ("ants at the start again, their marks taken back", "Tables::place_ants"),
];
const REST: &str = "the best ant, the record, deposit, evaporation";

/// Each phase with its instructions an ant move, and its share of all.
fn phases(program: &Path, map: &Path) -> Result<Vec<Vec<String>>> {
    let file = maps::folder()?.join("callgrind.out");
    let [few, many] = ITERATIONS.map(|iterations| {
        let run = counted_into(&file, program, map, "ant-system", iterations)?;
        anyhow::Ok((run, inclusive(&file)?))
    });
    let ((few, few_by), (many, many_by)) = (few?, many?);
    let moves = many.moves - few.moves;
    let all = (many.instructions - few.instructions) / moves;
    let of = |function: &str| {
        let sum = |by: &BTreeMap<String, f64>| by.iter().filter(|(name, _)| name.contains(function)).map(|(_, n)| n).sum::<f64>();
        (sum(&many_by) - sum(&few_by)) / moves
    };
    let mut phases: Vec<(&str, f64)> = PHASES.iter().map(|&(phase, function)| (phase, of(function))).collect();
    // An ant that comes by first has the weights learnt while it walks.
    let known: f64 = phases[1].1 - of("WeightTable::refresh");
    phases[0].1 -= known;
    phases.push((REST, all - phases.iter().map(|(_, count)| count).sum::<f64>()));
    let row = |(phase, count): (&str, f64)| vec![phase.to_owned(), short(count), format!("{:.0} %", 100.0 * count / all)];
    Ok(phases.into_iter().map(row).collect())
}

/// Instructions by function, with those of what it calls.
fn inclusive(file: &Path) -> Result<BTreeMap<String, f64>> {
    let mut annotate = Command::new("callgrind_annotate");
    let output = annotate.args(["--inclusive=yes", "--threshold=100", "--show-percs=no"]).arg(file).output()?;
    ensure!(output.status.success(), "callgrind_annotate fails: {}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8_lossy(&output.stdout);
    // A count, then file:function [program].
    let line = |line: &str| {
        let (count, function) = line.trim_start().split_once(' ')?;
        Some((function.trim().to_owned(), count.replace(',', "").parse().ok()?))
    };
    Ok(text.lines().filter_map(line).collect())
}

fn counted(program: &Path, map: &Path, planner: &str, iterations: u32) -> Result<Run> {
    counted_into(Path::new("/dev/null"), program, map, planner, iterations)
}

fn counted_into(file: &Path, program: &Path, map: &Path, planner: &str, iterations: u32) -> Result<Run> {
    let mut valgrind = Command::new("valgrind");
    valgrind.arg("--tool=callgrind").arg(format!("--callgrind-out-file={}", file.display())).arg(program);
    let output = valgrind.args(["count".as_ref(), map.as_os_str(), planner.as_ref()]).arg(iterations.to_string()).output()?;
    let told = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "valgrind fails: {told}");
    let instructions = told.lines().find_map(|line| line.split_once("Collected : ")).map(|(_, number)| number);
    let number = |text: &str| text.trim().parse().with_context(|| format!("no number: {text}"));
    Ok(Run {
        instructions: number(instructions.context("callgrind counts nothing")?)?,
        moves: number(&String::from_utf8_lossy(&output.stdout))?,
    })
}

/// Processors differ in the instructions that compilers choose for them.
fn file() -> PathBuf {
    root().join("benches/instructions.json")
}

fn held() -> Result<Counts> {
    let text = fs::read_to_string(file()).unwrap_or_else(|_| "{}".into());
    let mut all: BTreeMap<String, Counts> = serde_json::from_str(&text).context("benches/instructions.json")?;
    Ok(all.remove(std::env::consts::ARCH).unwrap_or_default())
}

fn bless(counted: &Counts) -> Result<()> {
    let text = fs::read_to_string(file()).unwrap_or_else(|_| "{}".into());
    let mut all: BTreeMap<String, Counts> = serde_json::from_str(&text).context("benches/instructions.json")?;
    let rounded = counted.iter().map(|(id, count)| (id.clone(), (count * 10.0).round() / 10.0));
    all.insert(std::env::consts::ARCH.into(), rounded.collect());
    fs::write(file(), serde_json::to_string_pretty(&all)? + "\n")?;
    println!("bench: wrote benches/instructions.json");
    Ok(())
}

fn compare(counted: &Counts, held: &Counts) -> Result<()> {
    let grown = |(id, count): (&String, &f64)| {
        let held = held.get(id)?;
        (*count > held * (1.0 + TOLERANCE)).then(|| format!("{id}: {} instead of {}", short(*count), short(*held)))
    };
    let grown: Vec<String> = counted.iter().filter_map(grown).collect();
    if !grown.is_empty() {
        bail!("instructions an ant move have grown, {} (`--bless` accepts it)", grown.join(", "));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_beyond_the_tolerance_is_a_fault() {
        let counts = |count: f64| Counts::from([("ant-system".into(), count)]);
        assert!(compare(&counts(104.0), &counts(100.0)).is_ok());
        assert!(compare(&counts(50.0), &counts(100.0)).is_ok());
        assert!(compare(&counts(106.0), &counts(100.0)).is_err());
        assert!(compare(&counts(106.0), &Counts::new()).is_ok());
    }
}
