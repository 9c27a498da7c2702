//! What each stage of `cargo xtask test` runs.

use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;
use clap::ValueEnum;

use crate::tools::{self, node_script, root, run, with_data};
use crate::{bench, campaigns, deny, fuzz, install, page, python};

const WASM: [&str; 2] = ["--target", "wasm32-unknown-unknown"];

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum Stage {
    /// rustfmt
    Fmt,
    /// clippy, natively and for WebAssembly
    Clippy,
    /// Licences, sources and versions of all crates
    Deny,
    /// The Rust tests: engine, command line, build helper
    Engine,
    /// The Python package: wheel, types, tests, examples
    Python,
    /// Comparisons in shards by Snakemake and Slurm
    Campaigns,
    /// Spoiled inputs for everything that reads, for a minute
    Fuzz,
    /// tests/wasm.rs in Node.js
    WasmNode,
    /// tests/wasm.rs in Chromium
    WasmChromium,
    /// The page: engine, bundle, types, lint
    Page,
    /// Every benchmark once
    Bench,
    /// The page in Chromium, by Playwright
    Browser,
    /// The page in Firefox and WebKitGTK
    OtherBrowsers,
    /// Strokes on many screens in Firefox and WebKitGTK; runs only when it is named
    EveryScreen,
}

impl Stage {
    pub const ALL: [Self; 14] = [
        Self::Fmt,
        Self::Clippy,
        Self::Deny,
        Self::Engine,
        Self::Python,
        Self::Campaigns,
        Self::Fuzz,
        Self::WasmNode,
        Self::WasmChromium,
        Self::Page,
        Self::Bench,
        Self::Browser,
        Self::OtherBrowsers,
        Self::EveryScreen,
    ];

    /// Whether it runs when no stage is named.
    pub fn by_default(self) -> bool {
        self != Self::EveryScreen
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Fmt => "fmt",
            Self::Clippy => "clippy",
            Self::Deny => "deny",
            Self::Engine => "engine",
            Self::Python => "python",
            Self::Campaigns => "campaigns",
            Self::Fuzz => "fuzz",
            Self::WasmNode => "wasm-node",
            Self::WasmChromium => "wasm-chromium",
            Self::Page => "page",
            Self::Bench => "bench",
            Self::Browser => "browser",
            Self::OtherBrowsers => "other-browsers",
            Self::EveryScreen => "every-screen",
        }
    }

    pub fn run(self) -> Result<()> {
        match self {
            Self::Fmt => run(tools::cargo().args(["fmt", "--all", "--check"])),
            Self::Clippy => clippy(),
            Self::Deny => deny::check(),
            Self::Engine => engine(),
            Self::Python => python::test(),
            Self::Campaigns => campaigns::test(),
            Self::Fuzz => fuzz::stage(),
            Self::WasmNode => wasm_tests(&mut tools::cargo()),
            Self::WasmChromium => {
                install::chromium()?;
                wasm_tests(tools::cargo().env("WASM_BINDGEN_USE_BROWSER", "1"))
            }
            Self::Page => page::check(),
            Self::Bench => bench(),
            Self::Browser => browser(),
            Self::OtherBrowsers => other_browsers("--grep-invert"),
            Self::EveryScreen => other_browsers("--grep"),
        }
    }
}

fn clippy() -> Result<()> {
    const DENY: [&str; 3] = ["--", "--deny", "warnings"];
    install::wasm_target()?;
    run(tools::cargo().args(["clippy", "--workspace", "--all-targets"]).args(DENY))?;
    let library = ["clippy", "--package", "formicarium", "--lib"];
    run(tools::cargo().args(library).args(WASM).args(DENY))
}

/// One package after the other: together, their features would be joined and half of the build
/// helper's dependencies compiled again.
fn engine() -> Result<()> {
    run(with_data(tools::cargo().args(["test", "--package", "formicarium"])))?;
    run(tools::cargo().args(["test", "--package", "xtask"]))
}

fn wasm_tests(cargo: &mut Command) -> Result<()> {
    install::wasm_target()?;
    cargo.env("WASM_BINDGEN_TEST_TIMEOUT", "600");
    run(cargo.args(["test", "--package", "formicarium", "--test", "wasm"]).args(WASM))
}

/// They are run, not measured.
fn bench() -> Result<()> {
    run(with_data(tools::cargo().args(["bench", "--package", "formicarium", "--bench", "walk", "--", "--test"])))?;
    bench::stage()
}

fn browser() -> Result<()> {
    install::chromium()?;
    page::build(None)?;
    let mut tests = playwright("playwright.config.ts");
    tests.env("FORMICARIUM_CLI", command_line()?);
    run(with_data(&mut tests))
}

/// The command line, with whose results those of the page are compared, bit for bit.
fn command_line() -> Result<PathBuf> {
    run(tools::cargo().args(["build", "--package", "formicarium", "--bin", "formicarium"]))?;
    Ok(tools::target_dir().join("debug/formicarium"))
}

/// Chromium runs beside them: what it reaches is what they must reach. `option` says what is to become of the tests on every screen.
fn other_browsers(option: &str) -> Result<()> {
    install::chromium()?;
    let browsers = install::other_browsers()?;
    page::build(None)?;
    let mut tests = playwright("other/playwright.config.ts");
    tests.args([option, "@every-screen"]).env("FORMICARIUM_CLI", command_line()?);
    run(with_data(tests.env("FIREFOX_PATH", browsers.firefox).env("WEBKIT_DRIVER", browsers.webkit_driver)))
}

/// The specs of a configuration below tests/browser/.
fn playwright(config: &str) -> Command {
    let mut tests = node_script("@playwright/test/cli.js");
    tests.args(["test", "--config"]).arg(root().join("tests/browser").join(config));
    tests
}
