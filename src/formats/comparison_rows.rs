//! The runs of a comparison's document one by one, so that a million of them need not be in memory together.
//!
//! [`comparison_json::write`] puts each run on a line of its own behind a line `"rows": [`; what stands before it is the document without its
//! runs. A document that is laid out otherwise is read whole.

use std::collections::VecDeque;
use std::io::{self, BufRead, Read};

use super::comparison_json;
use super::journal::{JournalFault, JournalLines};
use super::text::MAX_BYTES;
use crate::comparison::{Comparison, Row, Task};
use crate::digest::Digest;
use crate::error::{Error, FormatError};

/// The line behind which the runs stand.
const ROWS: &[u8] = b"\"rows\": [\n";

/// What goes wrong while runs are read.
#[derive(Debug, thiserror::Error)]
pub enum RowsError {
    /// The file cannot be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// What it holds cannot be used.
    #[error(transparent)]
    Contents(#[from] Error),
}

/// A document whose runs are still to be read.
pub struct StoredRows<R> {
    /// The question with its maps and the imported runs.
    pub comparison: Comparison,
    source: R,
    /// The line that was read last, from 1.
    line: usize,
    /// Runs that are read and wait for their turn.
    waiting: VecDeque<Row>,
    /// How many imported runs have had theirs.
    imported: usize,
    before: Option<Task>,
    is_over: bool,
}

impl<R: BufRead> StoredRows<R> {
    /// Reads all that stands before the runs.
    ///
    /// # Errors
    /// What [`comparison_json::open`] says, and what the source says.
    pub fn open(mut source: R) -> Result<Self, RowsError> {
        let (mut head, mut line, mut is_over) = (Vec::new(), 0, false);
        loop {
            line += 1;
            let begins = head.len();
            if next_line(&mut source, &mut head)? == 0 {
                is_over = true;
                break;
            }
            if head[begins..] == *ROWS {
                head.truncate(begins);
                let end = head.trim_ascii_end().len();
                head.truncate(end - usize::from(head[..end].ends_with(b",")));
                head.push(b'}');
                break;
            }
        }
        let text = String::from_utf8(head).map_err(|_| Error::from(FormatError::NotText { found: "binary data".into() }))?;
        let opened = comparison_json::open(&text)?;
        let waiting = opened.rows.into();
        Ok(Self { comparison: opened.comparison, source, line, waiting, imported: 0, before: None, is_over })
    }

    /// The next run in the order of the tasks, imported ones among them; none at the end. Runs that the question does not ask for are left
    /// out.
    ///
    /// # Errors
    /// A line that is no run, or one that is not behind the run before it.
    pub fn next_row(&mut self) -> Result<Option<Row>, RowsError> {
        if self.waiting.is_empty() {
            self.read_one()?;
        }
        let imported = self.comparison.imported.get(self.imported);
        let is_imported = imported.is_some_and(|i| self.waiting.front().is_none_or(|done| i.task < done.task));
        if is_imported {
            self.imported += 1;
            return Ok(imported.cloned());
        }
        Ok(self.waiting.pop_front())
    }

    /// Reads the next run that is asked for, if there is one.
    fn read_one(&mut self) -> Result<(), RowsError> {
        while !self.is_over && self.waiting.is_empty() {
            let mut bytes = Vec::new();
            self.line += 1;
            if next_line(&mut self.source, &mut bytes)? == 0 {
                return Err(self.wrong("the file ends among its runs"));
            }
            let mut text = bytes.trim_ascii();
            if let Some(last) = text.strip_suffix(b"]}") {
                (text, self.is_over) = (last, true);
            }
            let row: Row =
                serde_json::from_slice(text.strip_suffix(b",").unwrap_or(text)).map_err(|e| self.wrong(e.to_string()))?;
            if self.before.is_some_and(|before| row.task <= before) {
                return Err(self.wrong("the run does not come behind the one before it"));
            }
            self.before = Some(row.task);
            if self.comparison.has_task(row.task) {
                self.waiting.push_back(row);
            }
        }
        Ok(())
    }

    fn wrong(&self, what: impl Into<String>) -> RowsError {
        Error::from(FormatError::syntax(self.line, what, "one run a line, in the order of the tasks")).into()
    }
}

/// The runs of journals, one by one: each once, however many journals have it, and only those whose line holds.
pub struct JournalRows {
    lines: JournalLines,
    /// The digest of the line that each run was first read from; none so far.
    seen: Vec<Option<Digest>>,
    /// Lines that did not hold; half a line at the end of a journal is one.
    pub dropped: usize,
    /// Runs of which two journals say different things.
    pub unlike: usize,
}

impl JournalRows {
    /// Of journals of this comparison.
    pub fn of(comparison: &Comparison) -> Self {
        let lines = JournalLines::of(comparison, None);
        Self { seen: vec![None; lines.tasks().len()], lines, dropped: 0, unlike: 0 }
    }

    /// Runs of the comparison that no journal has had so far.
    pub fn missing(&self) -> usize {
        self.seen.iter().filter(|seen| seen.is_none()).count()
    }

    /// The next run of a journal, in the order in which they were done; none at its end. `source` stands at its beginning, or where the run
    /// before has left it.
    ///
    /// # Errors
    /// What the source says, and a line without an end in sight.
    pub fn next_row(&mut self, source: &mut impl BufRead) -> Result<Option<Row>, RowsError> {
        let mut line = Vec::new();
        while next_line(source, &mut line)? > 0 {
            match self.lines.read_line(&line) {
                Ok((place, row)) => {
                    let mut digest = Digest::default();
                    digest.bytes(row.to_line().as_bytes());
                    match self.seen[place].replace(digest) {
                        None => return Ok(Some(row)),
                        Some(first) => self.unlike += usize::from(first != digest),
                    }
                }
                Err(JournalFault::Cut) => self.dropped += 1,
                Err(_) => self.dropped += usize::from(self.lines.read_head(&line).is_err()),
            }
            line.clear();
        }
        Ok(None)
    }
}

/// Adds the next line with its end, and tells how long it is; 0 at the end. Nothing in memory becomes larger than a file that is read whole.
fn next_line(source: &mut impl BufRead, to: &mut Vec<u8>) -> Result<usize, RowsError> {
    let left = (MAX_BYTES - to.len()) as u64 + 1;
    let read = source.by_ref().take(left).read_until(b'\n', to)?;
    if to.len() > MAX_BYTES {
        let what = "a document with so much in one line or before its runs".into();
        return Err(Error::from(FormatError::TooLarge { what, max: format!("{} MiB", MAX_BYTES >> 20) }).into());
    }
    Ok(read)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::comparison::{Question, question};
    use crate::map::{Grid, Point};
    use crate::scenario::{Scenario, ScenarioSpec};
    use std::sync::Arc;

    fn document() -> (Comparison, Vec<Row>, String) {
        let asked: Question = serde_json::from_value(serde_json::json!({
            "format": question::FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 3 },
            "instances": [{ "id": "open", "map": "open.json" }],
            "entries": [
                { "id": "ants", "label": "ants", "role": "other", "planner": "ant-system", "set": { "iterations": 3, "ants": 4 } },
                { "id": "exact", "label": "exact", "role": "other", "planner": "astar" }
            ]
        }))
        .unwrap();
        let grid = Grid::from_bytes(6, 5, &[0; 30]).unwrap();
        let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(5, 4));
        let comparison = Comparison::new(asked, vec![Arc::new(Scenario::new(grid, spec).unwrap())]).unwrap();
        let rows: Vec<Row> = comparison.tasks().into_iter().map(|task| comparison.run(task, &mut || 0.0).unwrap().row).collect();
        let text = comparison_json::write(&comparison, &rows, true);
        (comparison, rows, text)
    }

    fn read(text: &str) -> Result<Vec<Row>, RowsError> {
        let mut stored = StoredRows::open(text.as_bytes())?;
        let mut rows = Vec::new();
        while let Some(row) = stored.next_row()? {
            rows.push(row);
        }
        Ok(rows)
    }

    #[test]
    fn runs_come_one_by_one_whatever_the_layout() {
        let (comparison, rows, text) = document();
        assert_eq!(read(&text).unwrap(), rows);
        assert_eq!(read(&text.replace('\n', " ")).unwrap(), rows);
        assert_eq!(read(&comparison_json::write(&comparison, &[], true)).unwrap(), []);
    }

    #[test]
    fn what_is_cut_off_spoilt_or_twice_is_refused_with_its_line() {
        let (_, _, text) = document();
        let refused = |text: &str| read(text).unwrap_err().to_string();
        assert!(refused(text.trim_end().strip_suffix("]}").unwrap()).contains("ends among"));
        assert!(refused(&text.replace("budget-spent", "spent")).starts_with("line "));
        let rows = text.rfind("\"rows\": [\n").unwrap() + 10;
        let first = text[rows..].lines().next().unwrap();
        let twice = format!("{}{first}\n{}", &text[..rows], &text[rows..]);
        assert!(refused(&twice).contains("behind the one before"));
    }

    #[test]
    fn journals_give_each_run_that_holds_once() {
        let (comparison, rows, _) = document();
        let lines = JournalLines::of(&comparison, None);
        let written: Vec<String> = rows.iter().map(|row| lines.line(row)).collect();
        let journal = lines.head() + &written[..4].concat() + &written[3].replace("status", "statut") + "{\"experiment\":\"cut";
        let other = lines.head() + &written[2..].concat();
        let mut read = JournalRows::of(&comparison);
        assert_eq!(read.missing(), rows.len());
        let mut all = Vec::new();
        for mut source in [journal.as_bytes(), other.as_bytes()] {
            while let Some(row) = read.next_row(&mut source).unwrap() {
                all.push(row);
            }
        }
        // A changed line, and half a one.
        assert_eq!((all, read.dropped, read.missing(), read.unlike), (rows.clone(), 2, 0, 0));
        let other = Row { digest: "0123456789abcdef".into(), ..rows[0].clone() };
        let changed = lines.head() + &lines.line(&other);
        assert_eq!((read.next_row(&mut changed.as_bytes()).unwrap(), read.unlike), (None, 1));
    }
}
