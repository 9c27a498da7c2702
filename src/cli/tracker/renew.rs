//! `tracker renew`: entries of earlier engines, by this one.

use std::fmt::Write as _;
use std::path::Path;

use crate::cli::error::CliError;
use crate::cli::input;
use crate::cli::{Outcome, text};
use crate::comparison::best_known::same;

use super::Where;
use super::entry::Entry;
use super::folder::Tracked;
use super::proof::Proof;

/// Repeats the runs of entries of another engine, and names this one in those that come out again
#[derive(clap::Args)]
#[command(after_help = "\
After the engine's version has changed. An entry whose run does not come out again stays as it is, and `tracker check` refuses it.")]
pub struct Args {
    #[command(flatten)]
    tracker: Where,
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let tracker = args.tracker.open()?;
    let (mut out, mut renewed, mut fine) = (String::new(), 0, true);
    for tracked in &tracker.scenarios {
        for file in tracker.files(&tracked.id)? {
            match renew(&file, tracked) {
                Ok(is_new) => renewed += u64::from(is_new),
                Err(error) => {
                    fine = false;
                    let _ = writeln!(out, "refused: {}/{}: {error}", tracked.id, input::file_name(&file));
                }
            }
        }
    }
    let _ = writeln!(out, "{} renewed", text::count(renewed, "entry", "entries"));
    Ok(Outcome { text: out, fine })
}

/// Whether the entry was of another engine.
fn renew(file: &Path, tracked: &Tracked) -> Result<bool, CliError> {
    let entry = Entry::read(file)?;
    let now = env!("CARGO_PKG_VERSION");
    let mut session = match Proof::of(&entry)? {
        Proof::Run(session) if session.engine != now => session,
        _ => return Ok(false),
    };
    session.engine = now.into();
    let proof = Proof::Run(session);
    let measured = proof.measure(tracked, &entry.planner)?;
    same("value", &entry.value, &measured.value)?;
    proof.into_entry(entry)?.write(file)?;
    Ok(true)
}
