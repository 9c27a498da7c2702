//! Virtual environments of Python below target/, with pinned packages.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::install;
use crate::tools::{root, run, target_dir};

/// A virtual environment with what `python/requirements/NAME.txt` lists.
pub struct Environment(PathBuf);

impl Environment {
    /// Made where it is missing, and anew where its list has changed.
    pub fn new(name: &str) -> Result<Self> {
        let (environment, list) = (Self(folder().join(name)), root().join("python/requirements").join(format!("{name}.txt")));
        let (wanted, note) = (fs::read_to_string(&list)?, environment.0.join("installed.txt"));
        if fs::read_to_string(&note).is_ok_and(|installed| installed == wanted) {
            return Ok(environment);
        }
        let python = install::python()?;
        println!("install: Python packages for {name}…");
        run(Command::new(python).args(["-m", "venv", "--clear"]).arg(&environment.0))?;
        if let Err(error) = run(environment.pip().arg("--requirement").arg(&list)) {
            bail!("{error:#}: the packages of {} could not be installed", list.display());
        }
        fs::write(&note, wanted).with_context(|| format!("cannot write {}", note.display()))?;
        Ok(environment)
    }

    /// A program of it, at work where no source of the package is in the way of the installed one.
    pub fn program(&self, name: &str) -> Command {
        let mut program = Command::new(self.path(name));
        program.current_dir(folder()).env("VIRTUAL_ENV", &self.0).env_remove("PYTHONPATH");
        program
    }

    /// Where a program of it is.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.join(if cfg!(windows) { "Scripts" } else { "bin" }).join(name)
    }

    /// pip, about to install.
    pub fn pip(&self) -> Command {
        let mut pip = self.program("python");
        pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
        pip
    }
}

/// Everything that is made here.
pub fn folder() -> PathBuf {
    let folder = target_dir().join("python");
    // Where that fails, whatever is put there says so.
    let _ = fs::create_dir_all(&folder);
    folder
}
