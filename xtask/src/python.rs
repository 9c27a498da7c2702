//! The Python package: built as a wheel, installed where nothing else is, tested there.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::install;
use crate::tools::{root, run, target_dir};

/// Wheel, style, types, tests with the examples.
pub fn test() -> Result<()> {
    let python = install::python()?;
    let wheel = wheel(&Environment::new(&python, "build")?)?;
    let clean = Environment::new(&python, "test")?;
    run(clean.pip().args(["--force-reinstall", "--no-deps"]).arg(&wheel))?;
    style(&clean)?;
    types(&clean)?;
    let mut pytest = clean.program("pytest");
    pytest.arg("--config-file").arg(settings()).arg("--rootdir").arg(package());
    let cache = format!("cache_dir={}", folder().join("pytest").display());
    run(pytest.args(["-o", &cache]).arg(package().join("tests")))
}

fn style(clean: &Environment) -> Result<()> {
    for command in [&["check"][..], &["format", "--check"]] {
        let mut ruff = clean.program("ruff");
        // What its settings say of folders is meant from there.
        ruff.current_dir(package()).args(command).args(["--quiet", "--no-cache", "--config"]).arg(settings());
        run(ruff.arg(".").arg(campaign()))?;
    }
    Ok(())
}

fn types(clean: &Environment) -> Result<()> {
    let mut mypy = clean.program("mypy");
    mypy.arg("--config-file").arg(settings()).arg("--cache-dir").arg(folder().join("mypy")).arg("--no-error-summary");
    run(mypy.args(["formicarium", "tests", "examples"].map(|part| package().join(part))).arg(campaign()))
}

fn package() -> PathBuf {
    root().join("python")
}

fn settings() -> PathBuf {
    package().join("pyproject.toml")
}

/// The driver that deals shards: Python too, and tested with the package.
fn campaign() -> PathBuf {
    root().join("campaigns/dask_shards.py")
}

/// PyO3's macros ask for more of the crate `syn` than ours, so that nothing above it that other stages have compiled is used again. Compiled
/// once more, the library is made quickly rather than fast: its results are the same.
const QUICKLY: [&str; 2] = ["--config", "profile.dev.package.formicarium.opt-level=1"];

/// The one wheel of this system.
fn wheel(build: &Environment) -> Result<PathBuf> {
    let out = folder().join("wheels");
    if out.is_dir() {
        fs::remove_dir_all(&out).with_context(|| format!("cannot empty {}", out.display()))?;
    }
    let mut maturin = build.program("maturin");
    maturin
        .args(["build", "--quiet", "--locked", "--profile", "dev", "--compatibility", "linux"])
        .args(QUICKLY)
        .arg("--out")
        .arg(&out);
    maturin.arg("--manifest-path").arg(root().join("python/Cargo.toml")).env("CARGO_TARGET_DIR", target_dir());
    run(&mut maturin)?;
    let made = fs::read_dir(&out)?.next().with_context(|| format!("maturin has left no wheel in {}", out.display()))??;
    Ok(made.path())
}

/// A virtual environment with what `python/requirements/NAME.txt` lists.
struct Environment(PathBuf);

impl Environment {
    /// Made where it is missing, and anew where its list has changed.
    fn new(python: &Path, name: &str) -> Result<Self> {
        let (environment, list) = (Self(folder().join(name)), root().join("python/requirements").join(format!("{name}.txt")));
        let (wanted, note) = (fs::read_to_string(&list)?, environment.0.join("installed.txt"));
        if fs::read_to_string(&note).is_ok_and(|installed| installed == wanted) {
            return Ok(environment);
        }
        println!("install: Python packages for {name}…");
        run(Command::new(python).args(["-m", "venv", "--clear"]).arg(&environment.0))?;
        if let Err(error) = run(environment.pip().arg("--requirement").arg(&list)) {
            bail!("{error:#}: the packages of {} could not be installed", list.display());
        }
        fs::write(&note, wanted).with_context(|| format!("cannot write {}", note.display()))?;
        Ok(environment)
    }

    /// A program of it, at work where no source of the package is in the way of the installed one.
    fn program(&self, name: &str) -> Command {
        let programs = self.0.join(if cfg!(windows) { "Scripts" } else { "bin" });
        let mut program = Command::new(programs.join(name));
        program.current_dir(folder()).env("VIRTUAL_ENV", &self.0).env_remove("PYTHONPATH");
        program
    }

    fn pip(&self) -> Command {
        let mut pip = self.program("python");
        pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
        pip
    }
}

/// Everything that is made here.
fn folder() -> PathBuf {
    let folder = target_dir().join("python");
    // Where that fails, whatever is put there says so.
    let _ = fs::create_dir_all(&folder);
    folder
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_is_installed_has_one_version() {
        for name in ["build", "test"] {
            let list = fs::read_to_string(root().join("python/requirements").join(format!("{name}.txt"))).unwrap();
            let packages: Vec<&str> = list.lines().filter(|line| !line.starts_with('#')).collect();
            assert!(!packages.is_empty() && packages.iter().all(|package| package.contains("==")), "{name}: {packages:?}");
        }
    }

    #[test]
    fn the_package_has_the_engines_version() {
        let version = |manifest: &str| {
            let text = fs::read_to_string(root().join(manifest)).unwrap();
            text.lines().find_map(|line| line.strip_prefix("version = ").map(str::to_owned)).unwrap()
        };
        assert_eq!(version("python/Cargo.toml"), version("Cargo.toml"));
    }
}
