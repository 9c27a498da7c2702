//! `--recheck`: runs that somebody else has done are done again, and must be the same, bit for bit.

use std::hash::{BuildHasher, Hasher, RandomState};
use std::str::FromStr;

use rand::Rng;

use super::args::Args;
use super::merge::Gathered;
use super::runs;
use crate::cli::error::CliError;
use crate::cli::text;
use crate::comparison::{Comparison, Row, Task};
use crate::rng::Streams;

/// A part of the runs in per cent, above 0 and at most 100; written `2%`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share(f64);

impl FromStr for Share {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let percent = text.strip_suffix('%').and_then(|number| number.parse().ok());
        let share = percent.filter(|percent: &f64| *percent > 0.0 && *percent <= 100.0);
        share.map(Self).ok_or_else(|| format!("`{text}` is no share: write a number above 0 and up to 100 with %, such as 2%"))
    }
}

impl Share {
    /// How many of so many, rounded up: never none of some.
    fn of(self, count: usize) -> usize {
        ((count as f64 * self.0 / 100.0).ceil() as usize).min(count)
    }
}

/// So many of these, evenly spread: the same ones each time, so that a shard that was broken off goes on with them.
pub fn spread(places: &[usize], share: Share) -> Vec<usize> {
    let count = share.of(places.len());
    (0..count).map(|k| places[k * places.len() / count]).collect()
}

/// Repeats some runs of each journal; says that all are the same, or which are not. A forger who knew which would leave those as they
/// are: they are others each time, unless a seed is named.
pub fn recheck(
    args: &Args,
    comparison: &Comparison,
    share: Share,
    gathered: &Gathered,
) -> Result<Result<String, String>, CliError> {
    let seed = args.recheck_seed.unwrap_or_else(|| RandomState::new().build_hasher().finish());
    let places = sample(gathered, share, seed);
    let tasks: Vec<Task> = places.iter().filter_map(|&place| Some(gathered.row(place)?.task)).collect();
    let mut wrong = Vec::new();
    runs::run_all(args, comparison, &tasks, 0, |row| {
        let is_same = |place: usize| gathered.row(place).is_some_and(|then| then.to_line() == row.to_line());
        wrong.extend(gathered.place(&row).filter(|&place| !is_same(place)).map(|place| (place, row)));
        Ok(())
    })?;
    let repeated = text::count(tasks.len() as u64, "run", "runs");
    if wrong.is_empty() {
        return Ok(Ok(format!("recheck: {repeated} done again, the same bit for bit (--recheck-seed {seed})\n")));
    }
    wrong.sort_by_key(|(place, _)| *place);
    let mut said =
        format!("recheck: {} of {repeated} done again did not come out as they stand (--recheck-seed {seed}):\n", wrong.len());
    wrong.iter().for_each(|(place, row)| said += &unlike(comparison, gathered, *place, row));
    said +=
        "either these rows were changed, or the machine that did them or this one computes otherwise: see docs/campaigns.md\n";
    Ok(Err(said))
}

fn unlike(comparison: &Comparison, gathered: &Gathered, place: usize, row: &Row) -> String {
    let [then, now] = [gathered.row(place), Some(row)].map(|row| row.map_or_else(String::new, in_short));
    format!("  {}: {}: it says {then}, here it is {now}\n", gathered.source_of(place), gathered.task(comparison, place))
}

/// What tells a row from another one.
pub fn in_short(row: &Row) -> String {
    let length = row.found.map_or_else(|| "no path".into(), |found| format!("length {}", found.length));
    format!("{length} (digest {})", row.digest)
}

/// The places of the rows that are repeated, in their order.
fn sample(gathered: &Gathered, share: Share, seed: u64) -> Vec<usize> {
    let mut chosen = Vec::new();
    for (number, mut places) in gathered.by_source().into_iter().enumerate() {
        let mut stream = Streams::new(seed, "recheck", number as u32).daemon(0);
        for k in 0..share.of(places.len()) {
            let left = (places.len() - k) as u64;
            places.swap(k, k + (stream.next_u64() % left) as usize);
            chosen.push(places[k]);
        }
    }
    chosen.sort_unstable();
    chosen
}
