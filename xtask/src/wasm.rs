//! The engine as WebAssembly: cargo, wasm-bindgen, wasm-opt, pkg/.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use anyhow::{Context, Result};
use wasm_bindgen_cli_support::Bindgen;

use crate::install;
use crate::notices;
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
}

/// One build of the engine: what it is called, its folder in `pkg/`, cargo's features, the profile of what ships, and how much wasm-opt is
/// to do after rustc: for the whole engine more takes far longer and gains nothing.
#[derive(Clone, Copy)]
struct Build {
    name: &'static str,
    folder: &'static str,
    features: &'static [&'static str],
    profile: &'static str,
    wasm_opt: &'static str,
}

/// The whole engine, what a first visit needs (few planners, no file formats, no generators), and the whole engine for the page of one file, small
/// rather than fast.
const BUILDS: [Build; 3] = [
    Build { name: "whole", folder: "", features: &[], profile: "wasm", wasm_opt: "-O2" },
    Build { name: "opening", folder: "core", features: &["--no-default-features"], profile: "opening", wasm_opt: "-O3" },
    Build { name: "small", folder: "small", features: &[], profile: "small", wasm_opt: "-O2" },
];

/// What a mode makes: who develops does without the page of one file.
fn builds(mode: Mode) -> &'static [Build] {
    match mode {
        Mode::Release => &BUILDS,
        Mode::Dev => &BUILDS[..2],
    }
}

/// Leaves `pkg/` up to date; does nothing after cargo when the compiled engine is the same.
///
/// Each build ends with minutes on one core, so they are made side by side, and the npm packages meanwhile.
pub fn build(mode: Mode) -> Result<()> {
    install::wasm_target()?;
    install::node()?;
    println!(
        "engine: compiling its builds side by side, then binding and optimizing them: minutes the first time, seconds later…"
    );
    let compiled = thread::scope(|scope| {
        let packages = scope.spawn(install::npm_packages);
        let compiled = side_by_side(mode, |build| compile(mode, build));
        packages.join().expect("no panic")?;
        compiled
    })?;
    let pkg = root().join("pkg");
    let stamp = stamp(mode, &compiled)?;
    if fs::read_to_string(pkg.join(STAMP)).is_ok_and(|old| old == stamp) {
        return Ok(());
    }
    let staging = root().join("pkg.new");
    side_by_side(mode, |build| package(mode, build, &staging))?;
    fs::copy(root().join("pkg.json"), staging.join("package.json")).context("cannot copy pkg.json")?;
    fs::write(staging.join(notices::NAME), notices::of_engine()?)?;
    run(Command::new("node").args(["--input-type=module", "--eval", FACTS]).arg(&staging))?;
    fs::write(staging.join(STAMP), stamp)?;
    replace(&staging, &pkg)?;
    for build in builds(mode) {
        let path = Path::new("pkg").join(build.folder).join(WASM);
        let size = fs::metadata(root().join(&path))?.len();
        println!("engine: {}, {} KB", path.display(), size.div_ceil(1024));
    }
    Ok(())
}

/// The same for every build at once, in their order.
fn side_by_side<T: Send>(mode: Mode, work: impl Fn(&Build) -> Result<T> + Sync) -> Result<Vec<T>> {
    let work = &work;
    thread::scope(|scope| {
        let started: Vec<_> = builds(mode).iter().map(|build| scope.spawn(move || work(build))).collect();
        started.into_iter().map(|thread| thread.join().expect("no panic")).collect()
    })
}

fn package(mode: Mode, build: &Build, staging: &Path) -> Result<()> {
    let folder = staging.join(build.folder);
    bind(&build.compiled(mode), &folder)?;
    if mode == Mode::Release {
        println!("engine: optimizing the {} build…", build.name);
        optimize(&folder.join(WASM), build.wasm_opt)?;
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

impl Build {
    /// Whether it is the one for which all others wait.
    fn is_first(&self) -> bool {
        self.folder.is_empty()
    }

    fn target_dir(&self) -> PathBuf {
        tools::target_dir().join(self.folder)
    }

    /// Cargo's profile, and its folder for it.
    fn profile(&self, mode: Mode) -> (&'static str, &'static str) {
        match mode {
            Mode::Release => (self.profile, self.profile),
            Mode::Dev => ("dev", "debug"),
        }
    }

    /// Where cargo leaves it.
    fn compiled(&self, mode: Mode) -> PathBuf {
        self.target_dir().join("wasm32-unknown-unknown").join(self.profile(mode).1).join("formicarium.wasm")
    }
}

/// As cdylib alone: beside an rlib, cargo would leave out link-time optimization. Each build has a target folder of its own: all leave
/// `formicarium.wasm`, and in one folder each would make cargo think the others' outdated.
fn compile(mode: Mode, build: &Build) -> Result<PathBuf> {
    let args = ["rustc", "--package", "formicarium", "--lib", "--crate-type", "cdylib", "--target-dir"];
    let target = ["--target", "wasm32-unknown-unknown", "--profile", build.profile(mode).0];
    let quiet = ["--config".to_string(), anonymous_paths()];
    // The others must not hold up the whole one, which takes longest.
    let mut cargo = if build.is_first() { tools::cargo() } else { tools::patient(tools::cargo()) };
    // Two bars of progress on one terminal would write over each other.
    cargo.env("CARGO_TERM_PROGRESS_WHEN", "never");
    run(cargo.args(args).arg(build.target_dir()).args(target).args(build.features).args(quiet))?;
    println!("engine: the {} build is compiled", build.name);
    Ok(build.compiled(mode))
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
    let mut bindgen = Bindgen::new();
    bindgen
        .web(true)?
        .typescript(true)
        .input_path(compiled)
        .out_name("formicarium")
        .omit_default_module_path(true)
        .ts_typed_array_buffers(true);
    bindgen.generate(pkg)
}

fn optimize(wasm: &Path, level: &str) -> Result<()> {
    let mut wasm_opt = node_script("binaryen/bin/wasm-opt");
    run(wasm_opt.arg(level).args(FEATURES).arg(wasm).arg("-o").arg(wasm))
}

/// Changes with whatever pkg/ is made from.
fn stamp(mode: Mode, compiled: &[PathBuf]) -> Result<String> {
    let read = |path: &PathBuf| fs::read(path).with_context(|| format!("no {}", path.display()));
    let mut hasher = DefaultHasher::new();
    let inputs: Vec<Vec<u8>> = compiled.iter().chain([&root().join("pkg.json")]).map(read).collect::<Result<_>>()?;
    (mode, inputs, FEATURES, BUILDS.map(|build| (build.folder, build.wasm_opt)), FACTS).hash(&mut hasher);
    Ok(format!("{:016x}\n", hasher.finish()))
}
