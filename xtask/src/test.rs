//! `cargo xtask test`: the stages in order, and how long each took.

use std::time::{Duration, Instant};

use anyhow::{Result, bail};
use clap::Args;

use crate::stages::Stage;

#[derive(Args)]
pub struct Options {
    /// Only these stages [default: all but every-screen]
    #[arg(value_enum)]
    stages: Vec<Stage>,
    /// Go on after a stage that fails
    #[arg(long)]
    keep_going: bool,
}

struct Outcome {
    stage: Stage,
    passed: bool,
    took: Duration,
}

pub fn test(options: &Options) -> Result<()> {
    let mut outcomes = Vec::new();
    for stage in Stage::ALL.into_iter().filter(|stage| options.wants(*stage)) {
        let outcome = run(stage);
        let passed = outcome.passed;
        outcomes.push(outcome);
        if !passed && !options.keep_going {
            break;
        }
    }
    summarize(&outcomes);
    let failed: Vec<_> = outcomes.iter().filter(|o| !o.passed).map(|o| o.stage.name()).collect();
    if !failed.is_empty() {
        bail!("failed: {}", failed.join(", "));
    }
    Ok(())
}

impl Options {
    fn wants(&self, stage: Stage) -> bool {
        if self.stages.is_empty() { stage.by_default() } else { self.stages.contains(&stage) }
    }
}

fn run(stage: Stage) -> Outcome {
    println!("\n== {} ==", stage.name());
    let start = Instant::now();
    let result = stage.run();
    let took = start.elapsed();
    match &result {
        Ok(()) => println!("== {}: passed in {:.1} s", stage.name(), took.as_secs_f64()),
        Err(error) => println!("== {}: FAILED in {:.1} s: {error:#}", stage.name(), took.as_secs_f64()),
    }
    Outcome { stage, passed: result.is_ok(), took }
}

fn summarize(outcomes: &[Outcome]) {
    println!("\nstage          seconds");
    for Outcome { stage, passed, took } in outcomes {
        let mark = if *passed { "" } else { "  FAILED" };
        println!("{:<14} {:>7.1}{mark}", stage.name(), took.as_secs_f64());
    }
    let total: Duration = outcomes.iter().map(|outcome| outcome.took).sum();
    println!("{:<14} {:>7.1}", "total", total.as_secs_f64());
}
