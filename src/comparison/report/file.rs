//! The files of a comparison's results.

use serde::Deserialize;

use crate::comparison::Comparison;
use crate::comparison::analysis::Analysis;
use crate::comparison::row::Row;

/// One of them; in kebab case on the command line and in the browser.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ResultFile {
    /// One line a run.
    Csv,
    /// Tables and verdicts, as Markdown.
    Markdown,
    /// Rank tests of every pair, as Markdown.
    Tests,
    /// The same, one line a test.
    TestsCsv,
    /// One line an entry and map, with every statistic.
    SummaryCsv,
    /// The same with tests and verdicts, as JSON.
    SummaryJson,
    /// The statistics that papers print, as Markdown.
    SummaryMarkdown,
    /// The same as LaTeX.
    Latex,
    /// Maps × entries, one line each with median, gap, share of runs with a path and rank.
    MatrixCsv,
    /// The same as a table of Markdown.
    MatrixMarkdown,
    /// The same as LaTeX.
    MatrixLatex,
    /// Question, maps and all runs: opens again.
    Json,
    /// Question, maps and digests of the runs, for a link.
    Link,
}

impl ResultFile {
    /// All that the command line can write, with their ids and the endings of their names.
    pub const NAMED: [(&'static str, &'static str, Self); 12] = [
        ("csv", "csv", Self::Csv),
        ("markdown", "md", Self::Markdown),
        ("tests", "tests.md", Self::Tests),
        ("tests-csv", "tests.csv", Self::TestsCsv),
        ("summary-csv", "summary.csv", Self::SummaryCsv),
        ("summary-json", "summary.json", Self::SummaryJson),
        ("summary-markdown", "summary.md", Self::SummaryMarkdown),
        ("latex", "tex", Self::Latex),
        ("matrix-csv", "matrix.csv", Self::MatrixCsv),
        ("matrix-markdown", "matrix.md", Self::MatrixMarkdown),
        ("matrix-latex", "matrix.tex", Self::MatrixLatex),
        ("json", "json", Self::Json),
    ];
}

/// What the files are made from.
pub struct Reports<'a> {
    /// What was asked.
    pub comparison: &'a Comparison,
    /// All runs, those from elsewhere among them, in their order.
    pub rows: &'a [Row],
    /// What they say, with intervals.
    pub analysis: &'a Analysis,
    /// The command that repeats them, for the reader.
    pub command: &'a str,
    /// The document, with its runs or without.
    pub document: &'a dyn Fn(bool) -> String,
}

impl Reports<'_> {
    /// The contents of a file: the same bytes wherever it is made.
    pub fn contents(&self, file: ResultFile) -> String {
        let Self { comparison, rows, analysis, command, document } = self;
        match file {
            ResultFile::Csv => super::csv(comparison, rows),
            ResultFile::Markdown => super::markdown(comparison, rows, analysis, command),
            ResultFile::Tests => super::tests(comparison, analysis),
            ResultFile::TestsCsv => super::tests_csv(comparison, analysis),
            ResultFile::SummaryCsv => super::summary_csv(comparison, analysis),
            ResultFile::SummaryJson => super::summary_json(comparison, analysis),
            ResultFile::SummaryMarkdown => super::summary_markdown(comparison, analysis),
            ResultFile::Latex => super::latex(comparison, analysis, command),
            ResultFile::MatrixCsv => super::matrix_csv(comparison, analysis),
            ResultFile::MatrixMarkdown => super::matrix_markdown(comparison, analysis),
            ResultFile::MatrixLatex => super::matrix_latex(comparison, analysis, command),
            ResultFile::Json => document(true),
            ResultFile::Link => document(false),
        }
    }
}
