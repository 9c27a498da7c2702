//! The data files of IOHprofiler (`.dat`, `.idat`, `.tdat`, `.cdat`), as IOHanalyzer reads them: a separation line of column names before
//! each run, then one line a record. Function evaluations are constructed paths, and the best-so-far value is that of the best path.
//!
//! COCO's data files (`.dat`, `.tdat`) are alike: `% function evaluation | … | best noise-free fitness - Fopt | …` before each run. What is read
//! of them is that difference to the optimum, as COCO's own figures show it.
//!
//! The older loggers write `"function evaluation" "best-so-far f(x)"`, perhaps with `"current f(x)"` and more columns between; newer ones
//! (IOHexperimenter 0.3) write `evaluations raw_y` and what else was asked for.

use super::{LONGEST_LINE, MAX_ROWS, cell, counted, ended, label, measured, plain, too_many_rows};
use crate::comparison::Spent;
use crate::comparison::imported::{ImportedEntry, ImportedResults, ImportedRun, ImportedStep};
use crate::comparison::names::file_name;
use crate::error::{FormatError, Notice};
use crate::formats::text::{lines, quote};

/// Names of the first column.
const EVALUATIONS: [&str; 4] = ["function evaluation", "evaluations", "evaluation", "f evaluations"];

/// The column of a file of COCO that is read.
const COCO: &str = "best noise-free fitness - fopt";

/// Names of columns that hold a value, the preferred one first, and whether it is the best so far by its name.
const VALUES: [(&str, bool); 7] = [
    (COCO, true),
    ("best-so-far f(x)", true),
    ("raw_y_best", true),
    ("raw_y", false),
    ("current f(x)", false),
    ("current_y_best", true),
    ("current_y", false),
];

/// Names with a blank in them, for headers without quotation marks.
const WITH_BLANKS: [&str; 6] =
    ["function evaluation", "current f(x)", "best-so-far f(x)", "current af(x)+b", "best af(x)+b", "best-so-far af(x)+b"];

/// A separation line.
struct Header {
    /// Column of the value.
    value: usize,
    name: &'static str,
    /// Whether values cannot grow within a run.
    is_best: bool,
}

/// Whether the first line is a separation line.
pub(super) fn looks_like(text: &str) -> bool {
    lines(text).map(|(_, line)| line).find(|line| !line.trim().is_empty()).is_some_and(|line| header(line).is_some())
}

fn header(line: &str) -> Option<Header> {
    if line.len() > LONGEST_LINE {
        return None;
    }
    let names = names(line);
    let (first, others) = names.split_first()?;
    if !EVALUATIONS.contains(&first.as_str()) {
        return None;
    }
    let find = |&(name, is_best): &(&'static str, bool)| {
        let at = others.iter().position(|n| n == name)?;
        Some(Header { value: at + 1, name, is_best })
    };
    VALUES.iter().find_map(find)
}

/// The names of a separation line, in small letters: between quotation marks, else between tabs, else the known ones between blanks.
fn names(line: &str) -> Vec<String> {
    let line = line.trim().to_lowercase();
    if let Some(coco) = line.strip_prefix('%').filter(|coco| coco.contains('|')) {
        let bare = |name: &str| name.split('(').next().unwrap_or("").trim().to_owned();
        return coco.split('|').map(bare).collect();
    }
    if line.contains('"') {
        return line.split('"').skip(1).step_by(2).map(|name| name.trim().into()).collect();
    }
    if line.contains('\t') {
        return line.split('\t').map(|name| name.trim().into()).collect();
    }
    let mut names = Vec::new();
    let mut rest = line.as_str();
    while !rest.is_empty() {
        let word = rest.split_whitespace().next().unwrap_or(rest);
        let name = WITH_BLANKS.into_iter().find(|name| rest.starts_with(name)).unwrap_or(word);
        names.push(name.to_owned());
        rest = rest[name.len()..].trim_start();
    }
    names
}

/// Reads a data file: one entry, named after the file; its runs are counted from 1.
///
/// # Errors
/// [`FormatError`] with the line at fault.
pub(super) fn read(text: &str, name: &str) -> Result<ImportedResults, FormatError> {
    let mut file = File::default();
    for (number, line) in lines(text).filter(|(_, line)| !line.trim().is_empty()) {
        file.take(number, line)?;
    }
    file.refuse_growth()?;
    let label = label("", name);
    let notices = file.notices();
    let runs = file.runs.into_iter().map(|run| ImportedRun { status: ended(&run.steps), ..run }).collect();
    let entries = vec![ImportedEntry { id: plain(&label), label, runs }];
    Ok(ImportedResults { file: file_name(name).into(), instances: Vec::new(), entries, notices })
}

/// A file on its way in.
#[derive(Default)]
struct File {
    runs: Vec<ImportedRun>,
    header: Option<Header>,
    rows: usize,
    /// Records with too few fields.
    incomplete: usize,
    /// The value of the record before, in the same run.
    before: Option<f64>,
    /// Whether a value is below the one before it.
    falls: bool,
    /// Line, column and value of the first that is above the one before it.
    grows: Option<(usize, &'static str, String)>,
}

impl File {
    fn take(&mut self, number: usize, line: &str) -> Result<(), FormatError> {
        self.rows += 1;
        if self.rows > MAX_ROWS {
            return Err(too_many_rows(number));
        }
        // The first line is one, whatever stands before its names: it is what the file was told by.
        if self.header.is_none() || line.trim_start().starts_with(|c: char| matches!(c, '"' | '%') || c.is_alphabetic()) {
            let header = header(line).ok_or_else(|| {
                let expected = "\"function evaluation\" \"best-so-far f(x)\", or evaluations raw_y";
                FormatError::syntax(number, format!("`{}` is no separation line", quote(line)), expected)
            });
            self.header = Some(header?);
            self.before = None;
            let seed = u32::try_from(self.runs.len() + 1).unwrap_or(u32::MAX);
            let status = ended(&[]);
            self.runs.push(ImportedRun { instance: None, seed, status, effort: Spent::default(), steps: Vec::new() });
            return Ok(());
        }
        self.record(number, line)
    }

    /// A record; IOHanalyzer drops those that are cut off, and so do we.
    fn record(&mut self, number: usize, line: &str) -> Result<(), FormatError> {
        let (Some(header), Some(run)) = (&self.header, self.runs.last_mut()) else { return Ok(()) };
        let mut fields = line.split(|c: char| c.is_whitespace() || c == ',').filter(|f| !f.is_empty());
        let (Some(evaluations), Some(value)) = (fields.next(), fields.nth(header.value - 1)) else {
            self.incomplete += 1;
            return Ok(());
        };
        let wrong = |column, value, expected| cell(number, column, value, expected);
        let count = counted(evaluations).and_then(|count| count.ok_or("a whole number"));
        let count = count.map_err(|expected| wrong("function evaluation", evaluations, expected))?;
        if run.effort.constructed_paths.is_some_and(|before| count < before) {
            return Err(wrong("function evaluation", evaluations, "no less than in the record before"));
        }
        run.effort.constructed_paths = Some(count);
        let line = number;
        let number = measured(value).map_err(|expected| wrong(header.name, value, expected))?;
        let best = run.steps.last().and_then(|step| step.value);
        if header.is_best && number.zip(best).is_some_and(|(now, before)| now > before) {
            return Err(wrong(header.name, value, "no more than in the record before: lengths are minimised"));
        }
        if let Some((now, before)) = number.zip(self.before) {
            self.falls |= now < before;
            if now > before && self.grows.is_none() {
                self.grows = Some((line, header.name, value.to_owned()));
            }
        }
        self.before = number.or(self.before);
        if number.is_some_and(|now| best.is_none_or(|before| now < before)) {
            let spent = Spent { constructed_paths: Some(count), ..Spent::default() };
            run.steps.push(ImportedStep { value: number, spent, ..ImportedStep::default() });
        }
        Ok(())
    }

    /// Values of every evaluation rise and fall; where in all of the file they only grow, the problem is one that is maximised.
    fn refuse_growth(&self) -> Result<(), FormatError> {
        match &self.grows {
            Some((line, column, value)) if !self.falls => {
                Err(cell(*line, column, value, "no more than in the record before: values only grow here, lengths are minimised"))
            }
            _ => Ok(()),
        }
    }

    fn notices(&self) -> Vec<Notice> {
        let incomplete = (self.incomplete > 0).then(|| {
            let message = format!("{} records with too few fields were left out", self.incomplete);
            Notice::new("results-incomplete", message).with("records", self.incomplete)
        });
        let coco = self.header.as_ref().filter(|header| header.name == COCO).map(|_| {
            let message = "a data file of COCO: the differences to the optimum were read as lengths";
            Notice::new("results-coco", message)
        });
        incomplete.into_iter().chain(coco).collect()
    }
}
