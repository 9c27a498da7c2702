//! What Cargo.lock brings in, by cargo-deny and deny.toml: licences, sources, versions; known faults where their list can be fetched.

use std::env;
use std::path::PathBuf;
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

use anyhow::Result;

use crate::tools::{self, find, root, run, target_dir};

/// Pinned: its configuration changes with its versions.
const VERSION: &str = "0.20.2";

/// Longest that is waited for its installation.
const PATIENCE: Duration = Duration::from_secs(360);

/// Checks what can be checked here, and says what cannot.
pub fn check() -> Result<()> {
    let Some(program) = program()? else {
        println!("deny: SKIPPED, cargo-deny is not installed: `cargo install --locked cargo-deny@{VERSION}`");
        return Ok(());
    };
    let deny = || {
        let mut command = Command::new(&program);
        command.current_dir(root()).args(["--workspace", "--locked"]);
        command
    };
    // What other systems would need is read too, and no build here has brought it yet.
    run(tools::cargo().current_dir(root()).args(["fetch", "--locked", "--quiet"]))?;
    let check = ["check", "--hide-inclusion-graph"];
    run(deny().arg("--offline").args(check).args(["bans", "licenses", "sources"]))?;
    if !fetched(deny().args(["fetch", "db"])) {
        println!(
            "deny: advisories SKIPPED, their list cannot be fetched from here: run `cargo deny check advisories` where github.com is"
        );
        return Ok(());
    }
    run(deny().args(check).args(["--disable-fetch", "advisories"]))
}

/// What it says about a list that cannot be had is no error of ours.
fn fetched(command: &mut Command) -> bool {
    command.output().is_ok_and(|output| output.status.success())
}

/// cargo-deny from PATH or target/tools. A machine that only runs tests gets it: a few minutes, once.
fn program() -> Result<Option<PathBuf>> {
    let tools = target_dir().join("tools");
    let ours = tools.join("bin").join(if cfg!(windows) { "cargo-deny.exe" } else { "cargo-deny" });
    if let Some(program) = find("cargo-deny").or_else(|| ours.is_file().then(|| ours.clone())) {
        return Ok(Some(program));
    }
    if env::var_os("CI").is_none_or(|ci| ci.is_empty()) {
        return Ok(None);
    }
    println!("install: cargo-deny…");
    let package = format!("cargo-deny@{VERSION}");
    // Without optimization it is there sooner, and fast enough for one lock file.
    let mut install = tools::cargo();
    install.args(["install", "--locked", "--debug", "--root"]).arg(&tools).arg(&package);
    Ok(in_time(&mut install).then_some(ours))
}

/// Whether a command succeeds within its time; it is ended otherwise.
fn in_time(command: &mut Command) -> bool {
    let Ok(mut child) = command.spawn() else { return false };
    let end = Instant::now() + PATIENCE;
    while Instant::now() < end {
        match child.try_wait() {
            Ok(Some(status)) => return status.success(),
            _ => thread::sleep(Duration::from_millis(200)),
        }
    }
    println!("install: cargo-deny takes more than {} minutes here; the rest does without", PATIENCE.as_secs() / 60);
    let _ = child.kill().and_then(|()| child.wait().map(drop));
    false
}
