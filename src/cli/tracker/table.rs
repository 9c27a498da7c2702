//! `tracker table`: what is best known, as Markdown.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use crate::catalog::CATALOG;
use crate::cli::error::CliError;
use crate::cli::{Outcome, input, text};
use crate::comparison::gap::relative_gap;
use crate::exact::Reference;
use crate::planner::Objective;

use super::Where;
use super::entry::Entry;
use super::folder::{Tracked, best};
use super::proof::Proof;

/// Lists the best known values as Markdown: the tracker's README.md
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    tracker: Where,
}

const HEAD: &str = "\
# Best known values

Made by `formicarium tracker table` from the files beside it; what they mean, and how to add one: [docs/tracker.md](../../docs/tracker.md).
Values are in cells, less is better. A gap is the distance to the optimum that an exact planner has proven for the same measure; without a proof
it is marked by ≈. The link opens the entry, whose `session` behind the page's address repeats the run.
";

const COLUMNS: &str = "\
| planner | measure | best known | optimum | gap | seed | by | date | entry |
|---|---|---|---|---|---|---|---|---|
";

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let tracker = args.tracker.open()?;
    let mut out = String::from(HEAD);
    for tracked in &tracker.scenarios {
        let entries = tracker.entries(&tracked.id)?;
        let names: Vec<String> = tracker.files(&tracked.id)?.iter().map(|file| input::file_name(file)).collect();
        let _ = write!(out, "\n## {}\n\n{}\n\n{COLUMNS}", tracked.id, tracked.about);
        for (planner, objective) in planners(&entries).into_iter().flat_map(|planner| Objective::ALL.map(|one| (planner, one))) {
            let is_of = |entry: &&Entry| entry.planner == planner && entry.objective == objective;
            let Some(best) = best(entries.iter().filter(is_of)) else { continue };
            let name = entries.iter().position(|entry| entry == best).map_or("", |index| &names[index]);
            out += &row(tracked, best, name)?;
        }
    }
    Ok(Outcome::fine(out))
}

/// Those of the catalog in its order, then the others by name.
fn planners(entries: &[Entry]) -> Vec<&str> {
    let named: BTreeSet<&str> = entries.iter().map(|entry| entry.planner.as_str()).collect();
    let ours = CATALOG.iter().map(|planner| planner.id).filter(|id| named.contains(id));
    let others = named.iter().copied().filter(|name| CATALOG.iter().all(|planner| planner.id != *name));
    ours.chain(others).collect()
}

/// A name as Markdown shows it, whatever signs it has.
fn plain(text: &str) -> String {
    let means_something = |c: char| c.is_ascii_punctuation() && !matches!(c, '.' | ',' | '-' | '\'');
    text.chars().flat_map(|c| means_something(c).then_some('\\').into_iter().chain([c])).collect()
}

fn row(tracked: &Tracked, entry: &Entry, file: &str) -> Result<String, CliError> {
    let (reference, seed) = (tracked.reference(entry.objective), Proof::of(entry)?.seed());
    let optimum = |value: f64| if reference.is_proven() { format!("{value:.4}") } else { format!("≈ {value:.4}") };
    let gap = |value: f64| match reference {
        Reference::Proven { .. } => text::percent(relative_gap(entry.value, value)),
        _ => format!("≈ {}", text::percent(relative_gap(entry.value, value))),
    };
    let none = || String::from("–");
    let cells = [
        format!("`{}`", entry.planner),
        text::objective(entry.objective, &tracked.scenario).into(),
        format!("{:.4}", entry.value),
        reference.value().map_or_else(none, optimum),
        reference.value().map_or_else(none, gap),
        seed.map_or_else(none, |seed| seed.to_string()),
        plain(&entry.by),
        entry.date.clone(),
        format!("[{}](entries/{}/{file})", if seed.is_some() { "run" } else { "path" }, tracked.id),
    ];
    Ok(format!("| {} |\n", cells.join(" | ")))
}
