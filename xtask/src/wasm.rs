//! The engine as WebAssembly: cargo, wasm-bindgen, wasm-opt, pkg/.

use std::ffi::OsString;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::install;
use crate::tools::{self, node_script, root, run};

#[derive(Clone, Copy, PartialEq, Hash)]
pub enum Mode {
    /// What ships: optimized by rustc, then by wasm-opt.
    Release,
    /// Debug assertions and quick rebuilds.
    Dev,
}

const WASM: &str = "formicarium_bg.wasm";
const STAMP: &str = ".stamp";

/// Asks the whole engine for what it knows besides its planners, and writes it beside it: the page reads it before an engine is there.
const FACTS: &str = include_str!("facts.mjs");

/// The WebAssembly that the engine is compiled to; wasm-opt has to be told.
const FEATURES: [&str; 8] = [
    "--enable-simd",
    "--enable-bulk-memory",
    "--enable-bulk-memory-opt",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
];

impl Mode {
    pub fn from_dev(dev: bool) -> Self {
        if dev { Self::Dev } else { Self::Release }
    }

    fn profile(self) -> &'static str {
        match self {
            Self::Release => "wasm",
            Self::Dev => "dev",
        }
    }

    /// Cargo's folder for the profile.
    fn folder(self) -> &'static str {
        match self {
            Self::Release => "wasm",
            Self::Dev => "debug",
        }
    }
}

/// One build of the engine: its folder in `pkg/`, and cargo's features.
#[derive(Clone, Copy)]
struct Build {
    folder: &'static str,
    features: &'static [&'static str],
}

/// The whole engine, and what a first visit needs: few planners, no file formats, no generators.
const BUILDS: [Build; 2] = [Build { folder: "", features: &[] }, Build { folder: "core", features: &["--no-default-features"] }];

/// Leaves `pkg/` up to date; does nothing after cargo when the compiled engine is the same.
pub fn build(mode: Mode) -> Result<()> {
    install::wasm_target()?;
    install::npm_packages()?;
    println!("engine: compiling…");
    let compiled: Vec<PathBuf> = BUILDS.iter().map(|build| compile(mode, build)).collect::<Result<_>>()?;
    let pkg = root().join("pkg");
    let stamp = stamp(mode, &compiled)?;
    if fs::read_to_string(pkg.join(STAMP)).is_ok_and(|old| old == stamp) {
        return Ok(());
    }
    let staging = root().join("pkg.new");
    for (build, compiled) in BUILDS.iter().zip(&compiled) {
        package(mode, compiled, &staging.join(build.folder))?;
    }
    fs::copy(root().join("pkg.json"), staging.join("package.json")).context("cannot copy pkg.json")?;
    run(Command::new("node").args(["--input-type=module", "--eval", FACTS]).arg(&staging))?;
    fs::write(staging.join(STAMP), stamp)?;
    replace(&staging, &pkg)?;
    for build in &BUILDS {
        let path = Path::new("pkg").join(build.folder).join(WASM);
        let size = fs::metadata(root().join(&path))?.len();
        println!("engine: {}, {} KB", path.display(), size.div_ceil(1024));
    }
    Ok(())
}

fn package(mode: Mode, compiled: &Path, folder: &Path) -> Result<()> {
    println!("engine: binding…");
    bind(compiled, folder)?;
    if mode == Mode::Release {
        println!("engine: optimizing…");
        optimize(&folder.join(WASM))?;
    }
    Ok(())
}

/// Whoever reads pkg/ meanwhile, a development server say, sees the old or the new one.
fn replace(staging: &Path, pkg: &Path) -> Result<()> {
    if pkg.exists() {
        fs::remove_dir_all(pkg).context("cannot remove the old pkg/")?;
    }
    fs::rename(staging, pkg).context("cannot put the new pkg/ in place")
}

/// As cdylib alone: beside an rlib, cargo would leave out link-time optimization. Each build has a target folder of its own: both leave
/// `formicarium.wasm`, and in one folder each would make cargo think the other's outdated.
fn compile(mode: Mode, build: &Build) -> Result<PathBuf> {
    let target_dir = tools::target_dir().join(build.folder);
    let args = ["rustc", "--package", "formicarium", "--lib", "--crate-type", "cdylib", "--target-dir"];
    let target = ["--target", "wasm32-unknown-unknown", "--profile", mode.profile()];
    let quiet = ["--config".to_string(), anonymous_paths()];
    run(tools::cargo().args(args).arg(&target_dir).args(target).args(build.features).args(quiet))?;
    Ok(target_dir.join("wasm32-unknown-unknown").join(mode.folder()).join("formicarium.wasm"))
}

/// Panics name source files: the folders of the machine that builds are no business of who reads the library. Cargo adds these flags to
/// those of its own configuration.
fn anonymous_paths() -> String {
    let home =
        std::env::var("CARGO_HOME").map_or_else(|_| std::env::home_dir().unwrap_or_default().join(".cargo"), PathBuf::from);
    let remap = |from: &Path, to: &str| format!("--remap-path-prefix={}={to}", from.display());
    format!("target.wasm32-unknown-unknown.rustflags={:?}", [remap(&home, "cargo"), remap(&root(), ".")])
}

fn bind(compiled: &Path, pkg: &Path) -> Result<()> {
    let args: [OsString; 9] = [
        "wasm-bindgen".into(),
        compiled.into(),
        "--target=web".into(),
        "--omit-default-module-path".into(),
        "--ts-typed-array-buffers".into(),
        "--out-dir".into(),
        pkg.into(),
        "--out-name".into(),
        "formicarium".into(),
    ];
    wasm_bindgen_cli::wasm_bindgen::run_cli_with_args(args)
}

fn optimize(wasm: &Path) -> Result<()> {
    let mut wasm_opt = node_script("binaryen/bin/wasm-opt");
    run(wasm_opt.arg("-O3").args(FEATURES).arg(wasm).arg("-o").arg(wasm))
}

/// Changes with whatever pkg/ is made from.
fn stamp(mode: Mode, compiled: &[PathBuf]) -> Result<String> {
    let read = |path: &PathBuf| fs::read(path).with_context(|| format!("no {}", path.display()));
    let mut hasher = DefaultHasher::new();
    let inputs: Vec<Vec<u8>> = compiled.iter().chain([&root().join("pkg.json")]).map(read).collect::<Result<_>>()?;
    (mode, inputs, FEATURES, FACTS).hash(&mut hasher);
    Ok(format!("{:016x}\n", hasher.finish()))
}

/// Cargo's runner for wasm test files.
pub fn run_tests(args: Vec<OsString>) -> Result<()> {
    let program = OsString::from("wasm-bindgen-test-runner");
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args([program].into_iter().chain(args))
}
