//! What there is to say about the journals of a comparison.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::gathered::{Gathered, Source};
use crate::cli::compare::args::Args;
use crate::cli::compare::recheck::in_short;
use crate::cli::text;
use crate::comparison::{Comparison, Shard};
use crate::formats::journal::JournalFault;

/// As many lines of a kind as are shown.
const MOST: usize = 20;

/// Everything that keeps the journals from being one whole comparison; none where nothing does.
pub fn findings(args: &Args, comparison: &Comparison, gathered: &Gathered, folder: &Path) -> Option<String> {
    let mut said = faults(gathered) + &disagreements(comparison, gathered);
    // Of journals that are all of another question nothing is missing: they were asked for otherwise.
    if gathered.sources().iter().any(|source| !source.is_foreign()) {
        said += &missing(args, comparison, gathered, folder);
    }
    (!said.is_empty()).then(|| said + "nothing was written\n")
}

/// How many journals have brought how many runs, and what was done more than once.
pub fn summary(gathered: &Gathered) -> String {
    let sources = gathered.sources();
    let runs: usize = sources.iter().map(|source| source.runs).sum();
    let [journals, runs] = [text::count(sources.len() as u64, "journal", "journals"), text::count(runs as u64, "run", "runs")];
    let mut said = format!("merged {journals}: {runs}\n");
    for source in sources {
        for (&first, &count) in &source.again {
            let runs = text::count(count as u64, "run", "runs");
            said += &format!("  {}: {runs} that {} has too, the same bit for bit\n", source.name, sources[first].name);
        }
    }
    said
}

/// What does not hold, by journal and line, and what is to be done.
fn faults(gathered: &Gathered) -> String {
    let mut said = String::new();
    for Source { name, faults, fault_count, .. } in gathered.sources() {
        for (line, fault) in faults {
            let at = if *line > 1 { format!(" line {line}") } else { String::new() };
            said += &format!("{name}:{at} {fault}\n");
        }
        if *fault_count > faults.len() {
            said += &format!("{name}: and {} more lines\n", fault_count - faults.len());
        }
    }
    said + &advice(gathered)
}

/// What to do about journals that do not hold.
fn advice(gathered: &Gathered) -> String {
    let spoilt = || gathered.sources().iter().filter(|source| source.fault_count > 0);
    let mut said = String::new();
    if spoilt().any(|source| !source.is_foreign()) {
        said += "a shard whose journal is damaged is done again where that lies: it keeps the lines that hold\n";
    }
    let asked_otherwise = |source: &&Source| matches!(source.faults.first(), Some((1, JournalFault::OtherQuestion { .. })));
    if spoilt().any(|source| asked_otherwise(&source)) {
        said += "--seeds, --only, --budget, --map and --results are part of the question: give the shards and --merge the same\n";
    }
    if spoilt().any(Source::is_foreign) {
        said += "what is of something else is to be moved out of the folder\n";
    }
    said
}

/// Runs of which two journals say different things.
fn disagreements(comparison: &Comparison, gathered: &Gathered) -> String {
    let (shown, count) = gathered.disagreements();
    if count == 0 {
        return String::new();
    }
    let mut said = format!("{} two journals do not agree on:\n", text::count(count as u64, "run", "runs"));
    for other in shown {
        let task = gathered.task(comparison, other.place);
        let [first, second] = [gathered.row(other.place), Some(&other.row)].map(|row| row.map_or_else(String::new, in_short));
        said += &format!("  {task}: {} says {first}, {} says {second}\n", gathered.source_of(other.place), other.source);
    }
    if count > shown.len() {
        said += &format!("  and {} more\n", count - shown.len());
    }
    said + "one of them was changed, or a machine computes wrongly: do the run anew on a third one, and remove the wrong journal\n"
}

/// Runs that are missing, and the commands that do them.
fn missing(args: &Args, comparison: &Comparison, gathered: &Gathered, folder: &Path) -> String {
    let missing = gathered.missing();
    if missing.is_empty() {
        return String::new();
    }
    let all = text::count(comparison.task_count() as u64, "run is", "runs are");
    let mut said = format!("{} of {all} missing\n", missing.len());
    for source in gathered.sources().iter().filter(|source| source.is_cut) {
        said +=
            &format!("  {} ends in the middle of a line, as a process leaves it that was killed or is writing\n", source.name);
    }
    match dealt_to(gathered) {
        Some(of) => said += &by_shard(args, comparison, &missing, of, folder),
        None => said += &by_run(comparison, gathered, &missing),
    }
    said
}

/// To how many shards most of the journals say the runs were dealt; of equally many the smaller number.
fn dealt_to(gathered: &Gathered) -> Option<u32> {
    let mut journals: BTreeMap<u32, usize> = BTreeMap::new();
    gathered.sources().iter().filter_map(|source| source.shard).for_each(|shard| *journals.entry(shard.of()).or_default() += 1);
    journals.into_iter().rev().max_by_key(|(_, count)| *count).map(|(of, _)| of)
}

fn by_shard(args: &Args, comparison: &Comparison, missing: &[usize], of: u32, folder: &Path) -> String {
    let open: BTreeSet<usize> = missing.iter().copied().collect();
    let shards = (1..=of).filter_map(|index| Shard::new(index, of).ok());
    let lacking = shards.filter_map(|shard| {
        let dealt = comparison.dealt(shard);
        let lacks = dealt.iter().filter(|place| open.contains(place)).count();
        (lacks > 0).then_some((shard, lacks, dealt.len()))
    });
    let lacking: Vec<_> = lacking.collect();
    let mut said = String::new();
    for (shard, lacks, dealt) in lacking.iter().take(MOST) {
        said += &format!("  shard {shard}: {lacks} of {dealt}: {}\n", args.command_of(*shard, folder));
    }
    if let (true, rest) = (lacking.len() > MOST, &lacking[lacking.len().min(MOST)..]) {
        let numbers: Vec<String> = rest.iter().map(|(shard, ..)| shard.index().to_string()).collect();
        said += &format!("  and of the shards {}\n", numbers.join(", "));
    }
    said
}

fn by_run(comparison: &Comparison, gathered: &Gathered, missing: &[usize]) -> String {
    let mut said: String = missing.iter().take(MOST).map(|&place| format!("  {}\n", gathered.task(comparison, place))).collect();
    if missing.len() > MOST {
        said += &format!("  and {} more\n", missing.len() - MOST);
    }
    said
}
