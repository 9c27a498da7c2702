//! The journal of a comparison's runs, `formicarium/journal@2`: what one process, one shard or one browser tab has done of them.
//!
//! ```text
//! {"format":"formicarium/journal@2","engine":"0.1.0","experiment":"cc184c02b8922a1a","shard":"3/30"}
//! {"experiment":"cc184c02b8922a1a","task":0,"row":{…},"check":"9ae16a3b2f90404f"}
//! ```
//!
//! `shard` stands only in the journal of one. Every line tells by itself to which comparison it belongs and which of its tasks it is, and
//! carries a check sum. A line counts only if all of that holds and its row, written again, is the row that it has, byte for byte.

mod fault;

use serde::Deserialize;

use crate::comparison::{Comparison, Row, Shard, Task};
use crate::digest::Digest;

pub use fault::JournalFault;

/// How the first line of every version begins.
const BEGINS: &str = r#"{"format":"formicarium/journal@"#;

/// How a line of this version begins.
const LINE: &str = r#"{"experiment":""#;

/// The engine that does the runs: another one's are not kept.
const ENGINE: &str = env!("CARGO_PKG_VERSION");

/// How a comparison's runs are written down, and read.
pub struct JournalLines {
    digest: String,
    tasks: Vec<Task>,
    shard: Option<Shard>,
}

/// What a file holds for whoever goes on with it.
#[derive(Debug, PartialEq)]
pub enum Found {
    /// Runs of this comparison, in the order in which they were done.
    Ours {
        /// The runs, none of them twice.
        rows: Vec<Row>,
        /// Lines that do not hold.
        damaged: usize,
        /// How many of the file's bytes are the head and lines that hold; 0 where these do not stand together at its beginning.
        whole: usize,
    },
    /// Runs of another comparison or engine.
    Other,
    /// A journal of a version that has no check sums.
    Unchecked,
}

/// The first line.
#[derive(Deserialize)]
struct Head {
    format: String,
    engine: String,
    experiment: String,
    shard: Option<String>,
}

impl JournalLines {
    /// Of a comparison, or of one shard of it.
    pub fn of(comparison: &Comparison, shard: Option<Shard>) -> Self {
        Self { digest: comparison.digest().hex(), tasks: comparison.tasks(), shard }
    }

    /// Digest over question and maps.
    pub fn digest(&self) -> &str {
        &self.digest
    }

    /// The comparison's tasks, in their order.
    pub fn tasks(&self) -> &[Task] {
        &self.tasks
    }

    /// The first line.
    pub fn head(&self) -> String {
        let shard = self.shard.map_or_else(String::new, |shard| format!(",\"shard\":\"{shard}\""));
        format!("{BEGINS}2\",\"engine\":\"{ENGINE}\",\"experiment\":\"{}\"{shard}}}\n", self.digest)
    }

    /// The line of a run; nothing for a run that is none of the comparison's.
    pub fn line(&self, row: &Row) -> String {
        let Ok(task) = self.tasks.binary_search(&row.task) else { return String::new() };
        let body = format!("{LINE}{}\",\"task\":{task},\"row\":{}", self.digest, row.to_line());
        let check = check(&body);
        format!("{body},\"check\":\"{check}\"}}\n")
    }

    /// Whether a file that begins like this is a journal, be it damaged.
    pub fn is_journal(&self, begins: &[u8]) -> bool {
        let head = self.head().into_bytes();
        let differing = begins.iter().zip(&head).filter(|(a, b)| a != b).count();
        let has_line = || begins.windows(LINE.len() + 1).any(|w| w[0] == b'\n' && w[1..] == *LINE.as_bytes());
        // A head with one damaged byte, or a part of one.
        (differing == 0 || (differing == 1 && begins.len() >= head.len())) || begins.starts_with(BEGINS.as_bytes()) || has_line()
    }

    /// What a journal of this very comparison or shard holds, which is gone on with. Half a line at its end, as a killed process leaves it, is
    /// not counted as damage.
    pub fn read(&self, bytes: &[u8]) -> Found {
        let end = bytes.iter().rposition(|&b| b == b'\n').map_or(0, |at| at + 1);
        let head = self.head();
        let mut lines = bytes[..end].split_inclusive(|&b| b == b'\n');
        let has_head = lines.next().is_none_or(|first| first == head.as_bytes());
        let (mut rows, mut damaged) = (Vec::new(), usize::from(!has_head));
        for line in lines {
            match self.read_line(line) {
                Ok((_, row)) => rows.push(row),
                Err(_) => damaged += 1,
            }
        }
        if !has_head && rows.is_empty() {
            return if bytes.starts_with(format!("{BEGINS}1\"").as_bytes()) { Found::Unchecked } else { Found::Other };
        }
        rows.sort_by_key(|row: &Row| row.task);
        rows.dedup_by_key(|row| row.task);
        Found::Ours { rows, damaged, whole: if damaged == 0 { end } else { 0 } }
    }

    /// The first line of a journal that may be anybody's: which shard's it is; none for a journal of all runs.
    ///
    /// # Errors
    /// [`JournalFault`] where none of its lines can be of this comparison.
    pub fn read_head(&self, line: &[u8]) -> Result<Option<Shard>, JournalFault> {
        if !line.starts_with(BEGINS.as_bytes()) {
            return Err(JournalFault::NoJournal);
        }
        let text = whole_line(line)?;
        let head: Head = serde_json::from_str(text).map_err(|_| JournalFault::Damaged)?;
        if head.format != "formicarium/journal@2" {
            return Err(JournalFault::OtherVersion { found: short(&head.format) });
        }
        if head.engine != ENGINE {
            return Err(JournalFault::OtherEngine { found: short(&head.engine), here: ENGINE });
        }
        if head.experiment != self.digest {
            return Err(JournalFault::OtherQuestion { found: short(&head.experiment), here: self.digest.clone() });
        }
        let shard = head.shard.map(|shard| shard.parse()).transpose().map_err(|_| JournalFault::Damaged)?;
        let written = Self { digest: head.experiment, tasks: Vec::new(), shard }.head();
        if written.as_bytes() == line { Ok(shard) } else { Err(JournalFault::Damaged) }
    }

    /// The run of a line, and its place among the tasks.
    ///
    /// # Errors
    /// [`JournalFault`] for a line that does not hold.
    pub fn read_line(&self, line: &[u8]) -> Result<(usize, Row), JournalFault> {
        let (body, sum) = parts(whole_line(line)?).ok_or(JournalFault::Damaged)?;
        if sum != check(body) {
            return Err(JournalFault::Damaged);
        }
        let rest = body.strip_prefix(LINE).ok_or(JournalFault::Damaged)?;
        let (experiment, rest) = rest.split_once("\",\"task\":").ok_or(JournalFault::Damaged)?;
        if experiment != self.digest {
            return Err(JournalFault::OtherQuestion { found: short(experiment), here: self.digest.clone() });
        }
        let (task, text) = rest.split_once(",\"row\":").ok_or(JournalFault::Damaged)?;
        let row: Row = serde_json::from_str(text).map_err(|_| JournalFault::Changed)?;
        let place = task.parse().ok().filter(|place: &usize| place.to_string() == task);
        let place = place.filter(|&place| self.tasks.get(place) == Some(&row.task));
        let place = place.ok_or(JournalFault::NoSuchRun)?;
        if row.to_line() == text { Ok((place, row)) } else { Err(JournalFault::Changed) }
    }
}

/// The digest of the comparison whose runs a journal says to have; none where its first line does not tell.
pub fn digest_in(journal: &[u8]) -> Option<String> {
    let line = journal.split(|&byte| byte == b'\n').next()?;
    let head: Head = serde_json::from_slice(line).ok()?;
    head.format.starts_with("formicarium/journal@").then(|| short(&head.experiment))
}

/// A line without its end.
fn whole_line(line: &[u8]) -> Result<&str, JournalFault> {
    let text = line.strip_suffix(b"\n").ok_or(JournalFault::Cut)?;
    if text.ends_with(b"\r") {
        return Err(JournalFault::LineEnds);
    }
    std::str::from_utf8(text).map_err(|_| JournalFault::Damaged)
}

/// What a line's check sum is over, and the sum.
fn parts(line: &str) -> Option<(&str, &str)> {
    line.strip_suffix("\"}")?.rsplit_once(",\"check\":\"")
}

/// As much of what a file says as a message shows.
fn short(text: &str) -> String {
    text.chars().take(60).map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect()
}

/// The check sum over a line up to its own place, and the engine's version.
///
/// It is the engine's own digest, FNV-1a over 64 bits, and needs no further library. Each of its steps maps different states to different
/// states (an exclusive or, a product with an odd number), so that two lines that differ in one byte never have the same sum; of other damage
/// one in 2⁶⁴ passes. CRC-32 would be as sure about a few bits and let one in 2³² of the rest pass. Neither is proof against forgers:
/// whoever wants other results can write other sums too. Runs that are done again find those (`compare --merge --recheck`).
fn check(body: &str) -> String {
    let mut digest = Digest::default();
    digest.bytes(ENGINE.as_bytes());
    digest.bytes(body.as_bytes());
    digest.hex()
}

#[cfg(test)]
mod tests;
