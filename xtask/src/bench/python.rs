//! Ant colonies of PyPI, in an environment of their own.

use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;
use serde_json::json;

use super::Extent;
use super::interval::short;
use super::maps;
use super::report::{PERFORMANCE, Section, table};
use super::rounds::{Race, Rounds, nanoseconds_a_move, seconds};
use super::runner::Runner;
use crate::tools::{output, root, run as run_command, target_dir};

/// Pinned; networkx is what aco-routing imports without naming it.
const PACKAGES: [&str; 3] = ["python-motion-planning==1.1.1", "aco-routing==1.2.1", "networkx==3.6.1"];

const NOTE: &str = "\
Colonies of two packages of PyPI with their defaults and 50 ants on 50², 20 % walls by seed 1, beside Ant System with 50 ants: other \
algorithms for the same task, so their speed is compared by choices of a next cell. `cargo xtask bench python`";

/// Iterations of a round: ours and theirs.
const ITERATIONS: [u32; 2] = [50, 2];

pub fn run(extent: &Extent) -> Result<Option<Section>> {
    if extent.quick {
        println!("bench: python SKIPPED, the quick mode needs neither Python nor PyPI");
        return Ok(None);
    }
    let Some(python) = environment() else {
        println!("bench: python SKIPPED, python3 with venv and pip or their packages are not to be had");
        return Ok(None);
    };
    let map = maps::random(&maps::formicarium(false)?, 50, 20)?;
    let mut python = Runner::start("python", Command::new(python).arg(root().join("benches/peers/python.py")))?;
    let mut native = Runner::native()?;
    let mut race = Race::new(vec![&mut native, &mut python]);
    let job = |who: &str, iterations: u32| json!({ "work": "walk", "who": who, "map": map, "planner": "ant-system", "params": { "iterations": 100_000 }, "iterations": iterations });
    println!("bench: python…");
    race.join("engine, native", 0, &job("engine", ITERATIONS[0]))?;
    race.join("PyPI `python-motion-planning` 1.1.1", 1, &job("python-motion-planning", ITERATIONS[1]))?;
    race.join("PyPI `aco-routing` 1.2.1", 1, &job("aco-routing", ITERATIONS[1]))?;
    let rounds = race.run(extent.rounds)?;
    let rows: Vec<_> = rounds.iter().enumerate().map(|(i, of)| row(of, &rounds[0], ITERATIONS[i.min(1)])).collect();
    let text =
        format!("{NOTE}\n\n{}", table(&["what", "thousand moves a second", "ms an iteration", "times as long a move"], &rows));
    Ok(Some(Section { name: "python", page: PERFORMANCE, text, readme: None }))
}

fn row(of: &Rounds, ours: &Rounds, iterations: u32) -> Vec<String> {
    let rate = of.median(|answer| 1e6 / nanoseconds_a_move(answer));
    let ms = of.median(seconds).times(1e3 / f64::from(iterations));
    vec![of.name.clone(), short(rate.median), ms.to_string(), of.ratio(ours, nanoseconds_a_move).to_string()]
}

/// The interpreter that has the packages, below target/.
fn environment() -> Option<PathBuf> {
    let folder = target_dir().join("bench/venv");
    let python = folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if output(&python, &["-c", "import aco_routing, networkx, python_motion_planning"]).is_some() {
        return Some(python);
    }
    println!("install: {}…", PACKAGES.join(", "));
    run_command(Command::new("python3").args(["-m", "venv"]).arg(&folder)).ok()?;
    run_command(Command::new(&python).args(["-m", "pip", "install", "--quiet"]).args(PACKAGES)).ok()?;
    Some(python)
}
