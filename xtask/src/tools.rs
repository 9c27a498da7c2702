//! Where things are, and how other programs are started.

use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};

/// The repository's root: the folder above `xtask/`.
pub fn root() -> PathBuf {
    let xtask = env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
    xtask.parent().expect("xtask/ lies in the repository").to_path_buf()
}

pub fn www() -> PathBuf {
    root().join("www")
}

/// The cargo that runs us, in the repository's root, with the target folder we were built in.
pub fn cargo() -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(root()).env("CARGO_TARGET_DIR", target_dir());
    cargo
}

/// We are `<target>/debug/xtask`.
pub fn target_dir() -> PathBuf {
    let program = env::current_exe().expect("a running program has a path");
    program.ancestors().nth(2).expect("cargo builds into <target>/debug").to_path_buf()
}

/// A script of an npm package, started by node itself so that ending it ends the program.
pub fn node_script(script: &str) -> Command {
    let mut node = Command::new("node");
    node.arg(www().join("node_modules").join(script)).current_dir(www());
    node
}

pub fn vite() -> Command {
    node_script("vite/bin/vite.js")
}

/// The same command for a core that nothing else wants, where the system has such a thing.
pub fn patient(command: Command) -> Command {
    if find("nice").is_none() {
        return command;
    }
    let mut nice = Command::new("nice");
    nice.args(["-n", "19"]).arg(command.get_program()).args(command.get_args());
    nice.envs(command.get_envs().filter_map(|(name, value)| Some((name, value?))));
    if let Some(folder) = command.get_current_dir() {
        nice.current_dir(folder);
    }
    nice
}

/// Runs to the end; anything but success is an error that names the command.
pub fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("cannot start {}", line(command)))?;
    if !status.success() {
        bail!("{} failed ({status})", line(command));
    }
    Ok(())
}

/// What a program prints, or `None` when it is missing or fails.
pub fn output(program: impl AsRef<Path>, args: &[&str]) -> Option<String> {
    let mut command = Command::new(program.as_ref());
    let output = command.args(args).stdin(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// The program's full path when PATH has it.
pub fn find(program: &str) -> Option<PathBuf> {
    env::split_paths(&env::var_os("PATH")?).map(|folder| folder.join(program)).find(|p| p.is_file())
}

/// Tests run in other folders: the data folder is told from the repository's root.
pub fn with_data(command: &mut Command) -> &mut Command {
    let Some(data) = env::var_os("FORMICARIUM_DATA").filter(|data| !data.is_empty()) else {
        return command;
    };
    command.env("FORMICARIUM_DATA", root().join(PathBuf::from(data)))
}

/// The command as one would type it, paths shortened to the repository.
fn line(command: &Command) -> String {
    let root = format!("{}/", root().display());
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    let words: Vec<_> = words.map(|word| word.to_string_lossy().replace(&root, "")).collect();
    format!("`{}`", words.join(" "))
}
