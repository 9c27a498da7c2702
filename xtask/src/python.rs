//! The Python package: built as a wheel, installed where nothing else is, tested there.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};

use crate::environment::{Environment, folder};
use crate::tools::{root, run, target_dir};

/// Wheel, style, types, tests with the examples.
pub fn test() -> Result<()> {
    let wheel = wheel(&Environment::new("build")?)?;
    let clean = Environment::new("test")?;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_is_installed_has_one_version() {
        let lists = fs::read_dir(root().join("python/requirements")).unwrap().map(|entry| entry.unwrap().path());
        for file in lists {
            let (name, list) = (file.display(), fs::read_to_string(&file).unwrap());
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
