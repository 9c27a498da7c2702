//! `cargo xtask fuzz`: spoiled inputs for everything that reads, in the engine (tests/fuzz) and in the page (tests/fuzz/links.mjs).

use std::process::Command;

use anyhow::Result;
use clap::Args;

use crate::tools::{self, root, run, target_dir, with_data};
use crate::wasm;

#[derive(Args)]
pub struct Options {
    /// How long; a fifth of it goes to the page's links
    #[arg(long, default_value_t = 10.0)]
    minutes: f64,
    /// As many files for every reader, however long that takes; a tenth as many links
    #[arg(long, conflicts_with = "minutes")]
    files: Option<u32>,
    /// Which inputs: equal seeds, equal inputs
    #[arg(long, default_value_t = 1)]
    seed: u32,
}

pub fn fuzz(options: &Options) -> Result<()> {
    if let Some(files) = options.files {
        return each(options.seed, files / 3 * 4, files / 10);
    }
    let minutes = |share: f64| ["--minutes".into(), (options.minutes * share).to_string()];
    // Both, whatever the first has found.
    let results = [engine(options.seed, &minutes(0.8)), links(options.seed, &minutes(0.2))];
    results.into_iter().collect()
}

/// The same inputs every time, about a minute in all.
pub fn stage() -> Result<()> {
    each(1, 30_000, 4_000)
}

/// So many inputs of the engine, three of four of them files, and so many links.
fn each(seed: u32, inputs: u32, addresses: u32) -> Result<()> {
    let extent = |count: u32| ["--inputs".into(), count.to_string()];
    engine(seed, &extent(inputs))?;
    links(seed, &extent(addresses))
}

fn engine(seed: u32, extent: &[String]) -> Result<()> {
    let test = ["test", "--package", "formicarium", "--test", "fuzz", "--", "--seed", &seed.to_string()].map(String::from);
    run(with_data(tools::cargo().args(test).args(extent)))
}

fn links(seed: u32, extent: &[String]) -> Result<()> {
    // The page's code asks the engine's facts, which the build writes.
    wasm::build(wasm::Mode::Release)?;
    let mut node = Command::new("node");
    // Less than what one link may unfold to many times over.
    node.arg("--max-old-space-size=512").arg(root().join("tests/fuzz/links.mjs"));
    run(node.args(["--seed", &seed.to_string()]).args(extent).env("CARGO_TARGET_DIR", target_dir()))
}
