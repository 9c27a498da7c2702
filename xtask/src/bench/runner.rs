//! Programs that time work for us: a line of JSON in, a line of JSON out (benches/runner/main.rs has the protocol).

use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use anyhow::{Context, Result, anyhow};
use serde_json::{Value, json};

use crate::install;
use crate::page;
use crate::tools::{self, root, target_dir};
use crate::wasm;

/// A program that waits for work; it ends with us.
pub struct Runner {
    name: &'static str,
    child: Child,
    requests: Option<ChildStdin>,
    answers: BufReader<ChildStdout>,
}

impl Runner {
    /// The engine, natively.
    pub fn native() -> Result<Self> {
        Self::start("native", Command::new(native_program()?).arg("serve"))
    }

    /// The engine as WebAssembly, and what is written in JavaScript, in node.
    pub fn node() -> Result<Self> {
        wasm::build(wasm::Mode::Release)?;
        Self::start("node", Command::new("node").arg(root().join("benches/peers/node.mjs")))
    }

    /// The engine in Chromium, where that is here: it is not installed for a measurement.
    pub fn chromium() -> Result<Option<Self>> {
        let Some(program) = install::chromium_program() else { return Ok(None) };
        wasm::build(wasm::Mode::Release)?;
        let mut node = Command::new("node");
        node.arg(root().join("benches/peers/chromium.mjs")).env("CHROMIUM_PATH", program);
        Self::start("Chromium", &mut node).map(Some)
    }

    /// The built page in Chromium, where that is here.
    pub fn page() -> Result<Option<Self>> {
        let Some(program) = install::chromium_program() else { return Ok(None) };
        page::build(None)?;
        let mut node = Command::new("node");
        node.arg(root().join("benches/peers/page.mjs")).env("CHROMIUM_PATH", program);
        Self::start("the page", &mut node).map(Some)
    }

    /// Searches of other crates.
    pub fn crates() -> Result<Self> {
        let target = target_dir().join("peers");
        let mut build = tools::cargo();
        build.args(["build", "--release", "--locked", "--manifest-path", "benches/peers/rust/Cargo.toml"]);
        tools::run(build.arg("--target-dir").arg(&target))?;
        Self::start("crates", &mut Command::new(target.join("release/formicarium-peers")))
    }

    /// A program that speaks the protocol.
    pub fn start(name: &'static str, command: &mut Command) -> Result<Self> {
        let started = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut child = started.with_context(|| format!("cannot start the runner of {name}"))?;
        let (requests, answers) = (child.stdin.take(), child.stdout.take().expect("it is piped"));
        Ok(Self { name, child, requests, answers: BufReader::new(answers) })
    }

    /// Makes a contestant ready; the answer is its number.
    pub fn prepare(&mut self, job: &Value) -> Result<u64> {
        self.ask(&json!({ "prepare": job }))?.as_u64().context("a contestant has a number")
    }

    /// Lets a contestant do its work once.
    pub fn round(&mut self, contestant: u64, seed: u32) -> Result<Value> {
        self.ask(&json!({ "round": contestant, "seed": seed }))
    }

    fn ask(&mut self, request: &Value) -> Result<Value> {
        let ended = || anyhow!("the runner of {} has ended; its message is above", self.name);
        writeln!(self.requests.as_mut().with_context(ended)?, "{request}").with_context(ended)?;
        let mut answer = String::new();
        if self.answers.read_line(&mut answer)? == 0 {
            return Err(ended());
        }
        serde_json::from_str(&answer).with_context(|| format!("{} answers {answer}", self.name))
    }
}

/// It reads the end of its input, and ends.
impl Drop for Runner {
    fn drop(&mut self) {
        self.requests = None;
        let _ = self.child.wait();
    }
}

/// Builds benches/runner as benchmarks are built; its file.
pub fn native_program() -> Result<PathBuf> {
    let mut build = tools::cargo();
    build.args(["bench", "--package", "formicarium", "--bench", "runner", "--no-run"]);
    let output = build.args(["--message-format", "json-render-diagnostics"]).stderr(Stdio::inherit()).output()?;
    let told = String::from_utf8_lossy(&output.stdout);
    let messages = told.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    // The command line is built with it.
    let mut runners = messages.filter(|message| message["target"]["name"] == "runner");
    let program = runners.find_map(|message| message["executable"].as_str().map(PathBuf::from));
    program.filter(|_| output.status.success()).context("benches/runner does not compile")
}
