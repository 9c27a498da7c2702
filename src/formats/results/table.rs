//! A table of results: CSV with a header, one line a run, or one line an improvement with what had been spent by then.

use std::collections::BTreeMap;

use csv::{ReaderBuilder, StringRecord, Trim};

use super::columns::{self, Column, Columns};
use super::run::{Run, goes_back};
use super::{MAX_ENTRIES, MAX_INSTANCES, MAX_ROWS, cell, counted, label, measured, plain, quote, too_many_rows};
use crate::comparison::Spent;
use crate::comparison::imported::{ImportedEntry, ImportedResults, ImportedRun, ImportedStep};
use crate::comparison::names::file_name;
use crate::error::{FormatError, Notice};
use crate::formats::text::lines;
use crate::planner::Status;

/// Reads a table.
///
/// # Errors
/// [`FormatError`] with the line at fault.
pub(super) fn read(text: &str, name: &str) -> Result<ImportedResults, FormatError> {
    let separator = columns::separator(columns::header(text).unwrap_or(""));
    let mut reader = ReaderBuilder::new();
    let reader = reader.delimiter(separator).trim(Trim::All).flexible(true).comment(Some(b'#')).has_headers(false);
    let mut records = reader.from_reader(text.as_bytes()).into_records();
    let mut next = || records.next().transpose().map_err(|e| FormatError::syntax(0, e.to_string(), "text in UTF-8"));
    let Some(header) = next()? else {
        return Err(FormatError::syntax(0, "the file is empty", "a line of column names, then one line a run"));
    };
    let columns = Columns::of(&header.iter().collect::<Vec<_>>(), line_of(text, &header))?;
    let mut table = Table { text, file: name, columns, decimal_comma: separator == b';', ..Table::default() };
    while let Some(record) = next()? {
        if record.iter().any(|field| !field.is_empty()) {
            table.take(&record)?;
        }
    }
    table.finish()
}

/// The line of a record, from 1. The reader's own count stands before the blank lines and comments that it has skipped.
fn line_of(text: &str, record: &StringRecord) -> usize {
    let begins = record.position().map_or(0, |p| p.byte()) as usize;
    let before = text.as_bytes()[..begins.min(text.len())].iter().filter(|&&b| b == b'\n').count();
    let skipped = |line: &&str| line.trim().is_empty() || line.starts_with('#');
    let rest = text.get(begins..).unwrap_or("");
    1 + before + lines(rest).map(|(_, line)| line).take_while(skipped).count()
}

/// A table on its way in.
#[derive(Default)]
struct Table<'a> {
    text: &'a str,
    file: &'a str,
    columns: Columns,
    decimal_comma: bool,
    /// Names of maps.
    instances: Vec<String>,
    /// Names of entries, each with its runs.
    entries: Vec<(String, Vec<Run>)>,
    /// The places of names as they are written.
    entry_of: BTreeMap<String, usize>,
    instance_of: BTreeMap<String, usize>,
    /// Where a run is among those of its entry, by entry, instance and seed.
    places: BTreeMap<(usize, Option<usize>, u32), usize>,
    /// Runs without a seed of their own, by entry and instance.
    unseeded: BTreeMap<(usize, Option<usize>), u32>,
    rows: usize,
    /// Lines that go on with a run.
    repeated: usize,
    /// Words for how a run ended that are none of ours.
    strange: Vec<String>,
}

impl Table<'_> {
    fn take(&mut self, record: &StringRecord) -> Result<(), FormatError> {
        self.rows += 1;
        if self.rows > MAX_ROWS {
            return Err(too_many_rows(line_of(self.text, record)));
        }
        let given = record.len();
        if given < self.columns.width || record.iter().skip(self.columns.width).any(|extra| !extra.is_empty()) {
            let what = format!("{given} fields where the header has {}", self.columns.width);
            let expected = "one field for each column; where numbers have decimal commas, semicolons between fields";
            return Err(FormatError::syntax(line_of(self.text, record), what, expected));
        }
        let entry = self.entry(record)?;
        let instance = self.instance(record)?;
        let seed = self.seed(record, entry, instance)?;
        match self.places.get(&(entry, instance, seed)).copied() {
            Some(place) => self.go_on(record, entry, place),
            None => self.begin(record, entry, instance, seed),
        }
    }

    fn begin(&mut self, record: &StringRecord, entry: usize, instance: Option<usize>, seed: u32) -> Result<(), FormatError> {
        let last = self.spent(record)?;
        let steps = self.step(record, last)?.into_iter().collect();
        let to_best = [self.count(record, Column::IterationOfBest)?, self.count(record, Column::PathsToBest)?];
        let counted = [self.count(record, Column::Iterations)?, self.count(record, Column::Evaluations)?];
        let status = self.status(record);
        let run = ImportedRun { instance, seed, status: Status::Complete, effort: Spent::default(), steps };
        let runs = &mut self.entries[entry].1;
        self.places.insert((entry, instance, seed), runs.len());
        runs.push(Run { run, status, last, to_best, counted });
        Ok(())
    }

    /// Another line of a run that is known.
    fn go_on(&mut self, record: &StringRecord, entry: usize, place: usize) -> Result<(), FormatError> {
        let spent = self.spent(record)?;
        let step = self.step(record, spent)?;
        let status = self.status(record);
        let known = &self.entries[entry].1[place];
        if !self.columns.tell_effort() {
            let seed = known.run.seed;
            let expected = "each run once, or a column such as `evaluations` that says what had been spent by each line";
            return Err(cell(line_of(self.text, record), self.name(Column::Seed), &seed.to_string(), expected));
        }
        if let Some((column, value)) = goes_back(known.last, spent) {
            let expected = "no less than in the line before of the same run";
            return Err(cell(line_of(self.text, record), column, &value.to_string(), expected));
        }
        self.repeated += 1;
        let known = &mut self.entries[entry].1[place];
        known.last = spent;
        known.status = status.or(known.status);
        known.run.steps.extend(step.filter(|s| known.run.steps.last().is_none_or(|last| s.improves(last))));
        Ok(())
    }

    fn entry(&mut self, record: &StringRecord) -> Result<usize, FormatError> {
        let written = self.field(record, Column::Entry);
        if let Some(&known) = self.entry_of.get(written) {
            return Ok(known);
        }
        let name = label(written, self.file);
        let known = self.entries.iter().position(|(entry, _)| *entry == name);
        let place = known.unwrap_or(self.entries.len());
        if place == MAX_ENTRIES {
            return Err(self.too_many(record, Column::Entry, &name, format!("at most {MAX_ENTRIES} entries in a file")));
        }
        self.entry_of.insert(written.to_owned(), place);
        self.entries.extend(known.is_none().then(|| (name, Vec::new())));
        Ok(place)
    }

    fn instance(&mut self, record: &StringRecord) -> Result<Option<usize>, FormatError> {
        let written = self.field(record, Column::Instance);
        if written.is_empty() {
            return Ok(None);
        }
        if let Some(&known) = self.instance_of.get(written) {
            return Ok(Some(known));
        }
        let name = label(written, "");
        let known = self.instances.iter().position(|instance| *instance == name);
        let place = known.unwrap_or(self.instances.len());
        if place == MAX_INSTANCES {
            return Err(self.too_many(record, Column::Instance, &name, format!("at most {MAX_INSTANCES} maps in a file")));
        }
        self.instance_of.insert(written.to_owned(), place);
        self.instances.extend(known.is_none().then_some(name));
        Ok(Some(place))
    }

    fn too_many(&self, record: &StringRecord, column: Column, name: &str, expected: String) -> FormatError {
        cell(line_of(self.text, record), self.name(column), name, &expected)
    }

    fn seed(&mut self, record: &StringRecord, entry: usize, instance: Option<usize>) -> Result<u32, FormatError> {
        if self.columns.has(Column::Seed) {
            let value = self.field(record, Column::Seed);
            let seed = counted(value).ok().flatten().and_then(|s| u32::try_from(s).ok());
            return seed.ok_or_else(|| {
                let expected = format!("a whole number from 0 to {}", u32::MAX);
                cell(line_of(self.text, record), self.name(Column::Seed), value, &expected)
            });
        }
        let count = self.unseeded.entry((entry, instance)).or_insert(0);
        *count += 1;
        Ok(*count)
    }

    /// What had been spent by a line, where each line of a run is an improvement.
    fn spent(&self, record: &StringRecord) -> Result<Spent, FormatError> {
        let either = |own, other| Ok::<_, FormatError>(self.count(record, own)?.or(self.count(record, other)?));
        Ok(Spent {
            iterations: either(Column::Iterations, Column::IterationOfBest)?,
            constructed_paths: either(Column::Evaluations, Column::PathsToBest)?,
            ant_moves: self.count(record, Column::AntMoves)?,
            cell_expansions: self.count(record, Column::CellExpansions)?,
        })
    }

    /// The path of a line; none for a run that has none (yet).
    fn step(&self, record: &StringRecord, spent: Spent) -> Result<Option<ImportedStep>, FormatError> {
        let number = |column| self.number(record, column);
        let (length, value) = (number(Column::Length)?, number(Column::Value)?);
        let turns = self.count(record, Column::Turns)?.map(|turns| self.turns(record, turns)).transpose()?;
        let (turn_index, weight) = (number(Column::TurnIndex)?, number(Column::Weight)?);
        let step = ImportedStep { length, value, turns, turn_index, weight, spent };
        Ok((length.is_some() || value.is_some()).then_some(step))
    }

    fn turns(&self, record: &StringRecord, turns: u64) -> Result<u32, FormatError> {
        u32::try_from(turns).map_err(|_| {
            let expected = format!("a whole number from 0 to {}", u32::MAX);
            cell(line_of(self.text, record), self.name(Column::Turns), self.field(record, Column::Turns), &expected)
        })
    }

    fn status(&mut self, record: &StringRecord) -> Option<Status> {
        let word = self.field(record, Column::Status);
        let known = serde_json::from_value(word.to_lowercase().into()).ok().filter(|s: &Status| s.is_finished());
        if known.is_none() && !word.is_empty() && self.strange.len() < 5 {
            let word = quote(word);
            if !self.strange.contains(&word) {
                self.strange.push(word);
            }
        }
        known
    }

    fn field<'r>(&self, record: &'r StringRecord, column: Column) -> &'r str {
        self.columns.place(column).and_then(|(at, _)| record.get(at)).unwrap_or("")
    }

    fn name(&self, column: Column) -> &str {
        self.columns.place(column).map_or("entry", |(_, name)| name)
    }

    fn number(&self, record: &StringRecord, column: Column) -> Result<Option<f64>, FormatError> {
        self.read(record, column, measured)
    }

    fn count(&self, record: &StringRecord, column: Column) -> Result<Option<u64>, FormatError> {
        self.read(record, column, counted)
    }

    fn read<T>(
        &self,
        record: &StringRecord,
        column: Column,
        read: impl Fn(&str) -> Result<Option<T>, &'static str>,
    ) -> Result<Option<T>, FormatError> {
        let text = self.field(record, column);
        let with_point = if self.decimal_comma { text.replacen(',', ".", 1) } else { String::new() };
        let read = read(if self.decimal_comma { &with_point } else { text });
        read.map_err(|expected| cell(line_of(self.text, record), self.name(column), text, expected))
    }

    fn finish(mut self) -> Result<ImportedResults, FormatError> {
        if self.rows == 0 {
            return Err(FormatError::syntax(0, "the file has no line below its header", "one line a run"));
        }
        let by_line = self.repeated == 0;
        let entries = std::mem::take(&mut self.entries).into_iter();
        let finished = |run: Run| if by_line { run.of_one_line(&self.columns) } else { run.of_improvements() };
        let entry = |(label, runs): (String, Vec<Run>)| ImportedEntry {
            id: plain(&label),
            label,
            runs: runs.into_iter().map(finished).collect(),
        };
        let entries = entries.map(entry).collect();
        Ok(ImportedResults { file: file_name(self.file).into(), entries, notices: self.notices(), instances: self.instances })
    }

    fn notices(&self) -> Vec<Notice> {
        let mut notices = Vec::new();
        if !self.columns.unknown.is_empty() {
            let names = self.columns.unknown.join(", ");
            let message = format!("columns that say nothing here were left out: {names}");
            notices.push(Notice::new("results-columns", message).with("columns", names));
        }
        if self.repeated > 0 {
            let (rows, runs) = (self.rows, self.rows - self.repeated);
            let message = format!("{rows} lines of {runs} runs were read as their improvements, one a line");
            notices.push(Notice::new("results-improvements", message).with("lines", rows).with("runs", runs));
        }
        if !self.strange.is_empty() {
            let words = self.strange.join(", ");
            let message = format!("ways to end that are not known here were left out: {words}");
            notices.push(Notice::new("results-status", message).with("words", words));
        }
        notices
    }
}
