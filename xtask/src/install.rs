//! What a fresh machine lacks: installed where that is safe, else named in the message.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, anyhow, bail};

use crate::tools::{self, find, output, run, www};

const TARGET: &str = "wasm32-unknown-unknown";
const NODE: (u32, u32) = (20, 19);
const PYTHON: (u32, u32) = (3, 11);

/// The compiler's standard library for WebAssembly.
pub fn wasm_target() -> Result<()> {
    let libdir = output("rustc", &["--print", "target-libdir", "--target", TARGET]);
    if libdir.is_some_and(|folder| PathBuf::from(folder).is_dir()) {
        return Ok(());
    }
    if find("rustup").is_none() {
        bail!(
            "the Rust target {TARGET} is missing and rustup is not installed: install Rust from \
             https://rustup.rs, or your distribution's package of that target \
             (Debian: libstd-rust-dev-wasm32)"
        );
    }
    println!("install: the Rust target {TARGET}…");
    run(Command::new("rustup").args(["target", "add", TARGET]).current_dir(tools::root()))
}

/// node_modules as package-lock.json has it.
pub fn npm_packages() -> Result<()> {
    node()?;
    if npm_packages_are_current() {
        return Ok(());
    }
    println!("install: npm packages…");
    let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
    run(Command::new(npm).args(["ci", "--no-audit", "--no-fund"]).current_dir(www()))
}

fn npm_packages_are_current() -> bool {
    let changed = |path: &str| fs::metadata(www().join(path)).and_then(|file| file.modified()).ok();
    changed("node_modules/.package-lock.json") >= changed("package-lock.json")
}

/// Node.js, which nobody can install for others.
pub fn node() -> Result<()> {
    let (major, minor) = NODE;
    let wanted = format!(
        "Node.js {major}.{minor} or newer with npm: install it from https://nodejs.org or with \
         your package manager (Debian 13, Ubuntu 25.04 or newer: `sudo apt-get install nodejs npm`)"
    );
    let version = output("node", &["--version"]).with_context(|| format!("no node: needs {wanted}"))?;
    if parse_version(&version).is_none_or(|found| found < NODE) {
        bail!("node is {version}: needs {wanted}");
    }
    find(if cfg!(windows) { "npm.cmd" } else { "npm" }).map(drop).with_context(|| format!("no npm: needs {wanted}"))
}

/// "v20.19.4" → (20, 19)
fn parse_version(version: &str) -> Option<(u32, u32)> {
    let mut numbers = version.trim_start_matches('v').split('.').map(|part| part.parse().ok());
    Some((numbers.next()??, numbers.next()??))
}

/// Python with what makes virtual environments.
pub fn python() -> Result<PathBuf> {
    let (major, minor) = PYTHON;
    let wanted = format!("the Python package is tested with Python {major}.{minor} or newer, its venv and its pip");
    let by_hand = || format!("{wanted}: `sudo apt-get install python3-venv`, or https://www.python.org");
    if find_python().is_none() {
        apt_install(&["python3-venv"], by_hand)?;
    }
    find_python().with_context(by_hand)
}

/// The interpreter in PATH that can do all that.
fn find_python() -> Option<PathBuf> {
    let check = format!("import ensurepip, venv, sys; assert sys.version_info >= {PYTHON:?}");
    ["python3", "python"].into_iter().filter_map(find).find(|python| output(python, &["-c", &check]).is_some())
}

/// Slurm, for a cluster of one node; what tests it does without where it cannot be had.
pub fn slurm() -> Result<()> {
    apt_install(&["slurm-wlm"], || "`sudo apt-get install slurm-wlm`".into())
}

/// The browser of the tests, and what drives it.
pub fn chromium() -> Result<()> {
    let programs = [chromium_program(), program("CHROMEDRIVER", &["chromedriver"])];
    if programs.iter().all(Option::is_some) {
        return Ok(());
    }
    apt_install(&["chromium", "chromium-driver"], || {
        "the browser stages need Chromium and ChromeDriver: `sudo apt-get install chromium \
         chromium-driver`, or set CHROMIUM_PATH and CHROMEDRIVER to your own"
            .to_owned()
    })
}

/// The browser of the tests, where it is here.
pub fn chromium_program() -> Option<PathBuf> {
    program("CHROMIUM_PATH", &["chromium"])
}

/// The browsers beside Chromium.
pub struct OtherBrowsers {
    pub firefox: PathBuf,
    /// The driver of WebKitGTK, which knows where its browser is.
    pub webkit_driver: PathBuf,
}

/// Firefox, and WebKitGTK with the screen that it is given.
pub fn other_browsers() -> Result<OtherBrowsers> {
    if let Ok(found) = find_other_browsers() {
        return Ok(found);
    }
    apt_install(&["firefox-esr", "webkit2gtk-driver", "xvfb"], || {
        let missing = find_other_browsers().err().unwrap_or_default();
        format!(
            "other-browsers does not find {}: `sudo apt-get install firefox-esr webkit2gtk-driver xvfb`, or your \
             system's packages of them; FIREFOX_PATH and WEBKIT_DRIVER may name your own",
            missing.join(", ")
        )
    })?;
    find_other_browsers().map_err(|missing| anyhow!("still not found: {}", missing.join(", ")))
}

/// Or the names of what is missing.
fn find_other_browsers() -> Result<OtherBrowsers, Vec<&'static str>> {
    let firefox = program("FIREFOX_PATH", &["firefox", "firefox-esr"]);
    let webkit_driver = program("WEBKIT_DRIVER", &["WebKitWebDriver"]);
    match (firefox, webkit_driver, find("Xvfb")) {
        (Some(firefox), Some(webkit_driver), Some(_)) => Ok(OtherBrowsers { firefox, webkit_driver }),
        (firefox, webkit_driver, screen) => {
            let all = [(firefox, "Firefox"), (webkit_driver, "WebKitWebDriver"), (screen, "Xvfb")];
            Err(all.into_iter().filter_map(|(found, name)| found.is_none().then_some(name)).collect())
        }
    }
}

/// The program that a variable names, else the first of these names in PATH.
fn program(variable: &str, names: &[&str]) -> Option<PathBuf> {
    let named = std::env::var_os(variable).map(PathBuf::from);
    named.or_else(|| names.iter().find_map(|name| find(name))).filter(|path| path.is_file())
}

/// Packages of Debian and Ubuntu, where we may install them; the message tells others what they need.
fn apt_install(packages: &[&str], message: impl FnOnce() -> String) -> Result<()> {
    if output("id", &["-u"]).as_deref() != Some("0") || find("apt-get").is_none() {
        bail!(message());
    }
    println!("install: {}…", packages.join(", "));
    run(apt_get().arg("update"))?;
    run(apt_get().args(["install", "--yes", "--no-install-recommends"]).args(packages))
}

fn apt_get() -> Command {
    let mut apt = Command::new("apt-get");
    apt.arg("-qq").env("DEBIAN_FRONTEND", "noninteractive");
    apt
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn node_versions_compare_by_number() {
        assert_eq!(parse_version("v20.19.4"), Some((20, 19)));
        assert!(parse_version("v9.99.0") < Some(NODE));
        assert_eq!(parse_version("unknown"), None);
    }
}
