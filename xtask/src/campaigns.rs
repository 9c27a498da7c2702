//! Comparisons in shards on engines that exist: Snakemake and Slurm.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;

use crate::environment::Environment;
use crate::install;
use crate::tools::{self, find, root, run, target_dir};

/// `campaigns/` on this machine and, where Slurm is installed, on a cluster of one node.
pub fn test() -> Result<()> {
    run(tools::cargo().args(["build", "--package", "formicarium", "--bin", "formicarium"]))?;
    let (program, snakemake) = (target_dir().join("debug/formicarium"), snakemake()?);
    let scripts = root().join("tests/campaigns");
    run(Command::new("bash").arg(scripts.join("snakemake.sh")).arg(&program).arg(&snakemake))?;
    if env::var_os("CI").is_some_and(|ci| !ci.is_empty()) && find("slurmctld").is_none() {
        // What it cannot have, the script says.
        let _ = install::slurm();
    }
    run(Command::new("bash").arg(scripts.join("slurm.sh")).arg(&program).arg(&snakemake))
}

/// The program `snakemake`, installed.
pub fn snakemake() -> Result<PathBuf> {
    Ok(Environment::new("campaigns")?.path("snakemake"))
}

/// A campaign on two cores of this machine; settings such as `shards=50` may follow.
pub fn local(snakemake: &Path, program: &Path, question: &Path, options: &str, out: &Path) -> Command {
    let campaigns = root().join("campaigns");
    let mut command = Command::new(snakemake);
    command.arg("--snakefile").arg(campaigns.join("Snakefile")).arg("--profile").arg(campaigns.join("profiles/local"));
    command.args(["--cores", "2", "--directory"]).arg(out).arg("--config");
    command.arg(format!("question={}", question.display())).arg(format!("formicarium={}", program.display()));
    command.arg(format!("options={options}")).arg(format!("out={}", out.display()));
    command
}
