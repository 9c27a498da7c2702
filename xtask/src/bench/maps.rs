//! Maps made by seed, and those of MovingAI where they are; all as scenario files that every runner reads.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use serde_json::Value;

use crate::tools::{self, root, target_dir};

/// The command line, built; quickly where nothing of it is timed.
pub fn formicarium(quick: bool) -> Result<impl Fn() -> Command> {
    let (profile, folder) = if quick { ("dev", "debug") } else { ("release", "release") };
    tools::run(tools::cargo().args(["build", "--package", "formicarium", "--bin", "formicarium", "--profile", profile]))?;
    let program = target_dir().join(folder).join("formicarium");
    Ok(move || Command::new(&program))
}

/// Where maps and whatever else is made are kept.
pub fn folder() -> Result<PathBuf> {
    let folder = target_dir().join("bench");
    fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
    Ok(folder)
}

/// A square map by seed 1, walls in per cent.
pub fn random(formicarium: &impl Fn() -> Command, side: u32, walls: u32) -> Result<PathBuf> {
    made(formicarium, "random", side, &["--density", &format!("0.{walls:02}")])
}

/// A square map by seed 1.
pub fn made(formicarium: &impl Fn() -> Command, kind: &str, side: u32, arguments: &[&str]) -> Result<PathBuf> {
    let name = format!("{kind}-{side}{}.json", arguments.concat().replace("--", "-"));
    let file = folder()?.join(name);
    let size = format!("{side}x{side}");
    let generate = ["generate", kind, "--size", &size, "--seed", "1"];
    quietly(formicarium().args(generate).args(arguments).arg("--out").arg(&file))?;
    Ok(file)
}

/// A map of MovingAI as a scenario, and the lines of its list: start, goal, and the listed optimum.
pub struct Listed {
    pub map: PathBuf,
    pub lines: Vec<([u32; 4], f64)>,
}

/// Reads it; the ends in the map's file are those of the last line.
pub fn movingai(formicarium: &impl Fn() -> Command, data: &Path, name: &str) -> Result<Listed> {
    let map = folder()?.join(format!("{name}.json"));
    let source = data.join(format!("{name}.map"));
    let list = data.join(format!("{name}.map.scen"));
    let text = fs::read_to_string(&list).with_context(|| format!("no {}", list.display()))?;
    let lines: Vec<_> = text.lines().skip(1).filter_map(line).collect();
    let ([x, y, to_x, to_y], _) = *lines.last().with_context(|| format!("{} lists nothing", list.display()))?;
    let ends = ["--from".into(), format!("{x},{y}"), "--to".into(), format!("{to_x},{to_y}")];
    quietly(formicarium().arg("convert").arg(source).arg(&map).args(ends))?;
    Ok(Listed { map, lines })
}

/// A line of a list: a bucket, the map and its size, four coordinates, the optimum.
fn line(text: &str) -> Option<([u32; 4], f64)> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let number = |i: usize| words.get(i)?.parse().ok();
    Some(([number(4)?, number(5)?, number(6)?, number(7)?], words.get(8)?.parse().ok()?))
}

/// The ends that a scenario file names.
pub fn ends(map: &Path) -> Result<[u32; 4]> {
    let scenario: Value = serde_json::from_str(&fs::read_to_string(map)?)?;
    let number = |value: &Value| value.as_u64().map(|n| n as u32).context("a coordinate");
    let (from, to) = (&scenario["start"], &scenario["goals"][0]["at"]);
    Ok([number(&from[0])?, number(&from[1])?, number(&to[0])?, number(&to[1])?])
}

/// The folder of MovingAI's maps, where there is one.
pub fn data() -> Option<PathBuf> {
    let data = std::env::var_os("FORMICARIUM_DATA").filter(|data| !data.is_empty())?;
    Some(root().join(data).join("movingai")).filter(|folder| folder.is_dir())
}

/// Runs what reports on standard error only; that is shown where it fails.
pub fn quietly(command: &mut Command) -> Result<()> {
    let output = command.output().with_context(|| format!("cannot start {command:?}"))?;
    anyhow::ensure!(output.status.success(), "{command:?} failed: {}", String::from_utf8_lossy(&output.stderr));
    Ok(())
}
