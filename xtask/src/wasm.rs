//! The engine as WebAssembly: cargo, wasm-bindgen, wasm-opt, pkg/.

use std::ffi::OsString;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

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

/// Leaves `pkg/` up to date; does nothing after cargo when the compiled engine is the same.
pub fn build(mode: Mode) -> Result<()> {
    install::wasm_target()?;
    install::npm_packages()?;
    println!("engine: compiling…");
    let compiled = compile(mode)?;
    let pkg = root().join("pkg");
    let stamp = stamp(mode, &compiled)?;
    if fs::read_to_string(pkg.join(STAMP)).is_ok_and(|old| old == stamp) {
        return Ok(());
    }
    let staging = root().join("pkg.new");
    package(mode, &compiled, &staging)?;
    fs::write(staging.join(STAMP), stamp)?;
    replace(&staging, &pkg)?;
    let size = fs::metadata(pkg.join(WASM))?.len();
    println!("engine: pkg/{WASM}, {} KB", size.div_ceil(1024));
    Ok(())
}

fn package(mode: Mode, compiled: &Path, pkg: &Path) -> Result<()> {
    println!("engine: binding…");
    bind(compiled, pkg)?;
    if mode == Mode::Release {
        println!("engine: optimizing…");
        optimize(&pkg.join(WASM))?;
    }
    fs::copy(root().join("pkg.json"), pkg.join("package.json")).context("cannot copy pkg.json")?;
    Ok(())
}

/// Whoever reads pkg/ meanwhile, a development server say, sees the old or the new one.
fn replace(staging: &Path, pkg: &Path) -> Result<()> {
    if pkg.exists() {
        fs::remove_dir_all(pkg).context("cannot remove the old pkg/")?;
    }
    fs::rename(staging, pkg).context("cannot put the new pkg/ in place")
}

/// As cdylib alone: beside an rlib, cargo would leave out link-time optimization.
fn compile(mode: Mode) -> Result<PathBuf> {
    let args = ["rustc", "--package", "formicarium", "--lib", "--crate-type", "cdylib"];
    let target = ["--target", "wasm32-unknown-unknown", "--profile", mode.profile()];
    run(tools::cargo().args(args).args(target))?;
    let folder = tools::target_dir().join("wasm32-unknown-unknown").join(mode.folder());
    Ok(folder.join("formicarium.wasm"))
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
fn stamp(mode: Mode, compiled: &Path) -> Result<String> {
    let read = |path: &Path| fs::read(path).with_context(|| format!("no {}", path.display()));
    let mut hasher = DefaultHasher::new();
    (mode, read(compiled)?, read(&root().join("pkg.json"))?, FEATURES).hash(&mut hasher);
    Ok(format!("{:016x}\n", hasher.finish()))
}

/// Cargo's runner for wasm test files.
pub fn run_tests(args: Vec<OsString>) -> Result<()> {
    let program = OsString::from("wasm-bindgen-test-runner");
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args([program].into_iter().chain(args))
}
