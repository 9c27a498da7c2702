//! What stands in a journal: `formicarium/journal@2`.
//!
//! ```text
//! {"format":"formicarium/journal@2","engine":"0.1.0","experiment":"cc184c02b8922a1a"}
//! {"experiment":"cc184c02b8922a1a","task":0,"row":{…},"check":"9ae16a3b2f90404f"}
//! ```
//!
//! Every line tells by itself to which comparison it belongs and which of its tasks it is, and carries a check sum. A line counts only if all
//! of that holds and its row, written again, is the row that it has, byte for byte.

use crate::comparison::{Comparison, Row, Task};
use crate::digest::Digest;

/// How the first line of every version begins.
const BEGINS: &str = r#"{"format":"formicarium/journal@"#;

/// How a line of this version begins.
const LINE: &str = r#"{"experiment":""#;

/// The engine that does the runs: another one's are not kept.
const ENGINE: &str = env!("CARGO_PKG_VERSION");

/// How a comparison's runs are written down.
pub struct Lines {
    digest: String,
    tasks: Vec<Task>,
}

/// What a file holds.
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

impl Lines {
    /// Of a comparison.
    pub fn of(comparison: &Comparison) -> Self {
        Self { digest: comparison.digest().hex(), tasks: comparison.tasks() }
    }

    /// The first line.
    pub fn head(&self) -> String {
        format!("{BEGINS}2\",\"engine\":\"{ENGINE}\",\"experiment\":\"{}\"}}\n", self.digest)
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

    /// What a journal holds. Half a line at its end, as a killed process leaves it, is not counted as damage.
    pub fn read(&self, bytes: &[u8]) -> Found {
        let end = bytes.iter().rposition(|&b| b == b'\n').map_or(0, |at| at + 1);
        let head = self.head();
        let mut lines = bytes[..end].split_inclusive(|&b| b == b'\n');
        let has_head = lines.next().is_none_or(|first| first == head.as_bytes());
        let (mut rows, mut damaged) = (Vec::new(), usize::from(!has_head));
        for line in lines {
            match self.row(line) {
                Some(row) => rows.push(row),
                None => damaged += 1,
            }
        }
        if !has_head && rows.is_empty() {
            return if bytes.starts_with(format!("{BEGINS}1\"").as_bytes()) { Found::Unchecked } else { Found::Other };
        }
        rows.sort_by_key(|row: &Row| row.task);
        rows.dedup_by_key(|row| row.task);
        Found::Ours { rows, damaged, whole: if damaged == 0 { end } else { 0 } }
    }

    /// The run of a line that holds.
    fn row(&self, line: &[u8]) -> Option<Row> {
        let text = std::str::from_utf8(line).ok()?.strip_suffix("\"}\n")?;
        let (body, sum) = text.rsplit_once(",\"check\":\"")?;
        let rest = body.strip_prefix(LINE)?.strip_prefix(&self.digest)?.strip_prefix("\",\"task\":")?;
        if sum != check(body) {
            return None;
        }
        let (task, text) = rest.split_once(",\"row\":")?;
        let row: Row = serde_json::from_str(text).ok()?;
        let is_task = self.tasks.get(task.parse::<usize>().ok()?) == Some(&row.task);
        (is_task && row.to_line() == text).then_some(row)
    }
}

/// The check sum over a line up to its own place, and the engine's version.
///
/// It is the engine's own digest, FNV-1a over 64 bits, and needs no further library. Each of its steps maps different states to different
/// states (an exclusive or, a product with an odd number), so that two lines that differ in one byte never have the same sum; of other damage
/// one in 2⁶⁴ passes. CRC-32 would be as sure about a few bits and let one in 2³² of the rest pass. Neither is proof against forgers:
/// whoever wants other results need not damage a journal for it.
fn check(body: &str) -> String {
    let mut digest = Digest::default();
    digest.bytes(ENGINE.as_bytes());
    digest.bytes(body.as_bytes());
    digest.hex()
}

#[cfg(test)]
mod tests;
