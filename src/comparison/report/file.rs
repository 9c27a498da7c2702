//! The files of a comparison's results.

use serde::Deserialize;

use super::words::ReportLanguage;
use super::{claims, csv, fronts, latex, matrix, printed, table, tests};
use crate::comparison::analysis::Analysis;
use crate::comparison::pareto::{self, FrontQuestion, MapFronts};
use crate::comparison::row::Row;
use crate::comparison::{Comparison, Samples, Seen};

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
    /// The claims, one line a map and one over all maps.
    ClaimsCsv,
    /// Maps × entries, one line each with median, gap, share of runs with a path and rank.
    MatrixCsv,
    /// The same as a table of Markdown.
    MatrixMarkdown,
    /// The same as LaTeX.
    MatrixLatex,
    /// What runs trade off: one line a point of an entry on a map.
    FrontsCsv,
    /// Fronts and hypervolumes, a table a map, as Markdown.
    FrontsMarkdown,
    /// The same as LaTeX.
    FrontsLatex,
    /// Question, maps and all runs: opens again.
    Json,
    /// Question, maps and digests of the runs, for a link.
    Link,
}

impl ResultFile {
    /// All that the command line can write, with their ids and the endings of their names.
    pub const NAMED: [(&'static str, &'static str, Self); 16] = [
        ("csv", "csv", Self::Csv),
        ("markdown", "md", Self::Markdown),
        ("tests", "tests.md", Self::Tests),
        ("tests-csv", "tests.csv", Self::TestsCsv),
        ("summary-csv", "summary.csv", Self::SummaryCsv),
        ("summary-json", "summary.json", Self::SummaryJson),
        ("summary-markdown", "summary.md", Self::SummaryMarkdown),
        ("latex", "tex", Self::Latex),
        ("claims-csv", "claims.csv", Self::ClaimsCsv),
        ("matrix-csv", "matrix.csv", Self::MatrixCsv),
        ("matrix-markdown", "matrix.md", Self::MatrixMarkdown),
        ("matrix-latex", "matrix.tex", Self::MatrixLatex),
        ("fronts-csv", "fronts.csv", Self::FrontsCsv),
        ("fronts-markdown", "fronts.md", Self::FrontsMarkdown),
        ("fronts-latex", "fronts.tex", Self::FrontsLatex),
        ("json", "json", Self::Json),
    ];
}

impl ResultFile {
    /// Whether a text begins as a file of this kind for people does in a language; false of a kind for programs.
    pub fn is_begun_by(self, language: ReportLanguage, text: &str) -> bool {
        let words = language.words();
        let page = |tells: &str| text.starts_with("# ") && text.contains(tells);
        let setting = words.names.engine;
        match self {
            Self::Markdown => page(&format!("\n{}`", words.page.made_by)) && page(words.page.how_to_read),
            Self::Tests => page(&format!("\n\n{}", words.tests.about)),
            Self::SummaryMarkdown => page(&format!("\n\n{setting}")),
            Self::MatrixMarkdown => page(&format!("{}\n\n{setting}", (words.matrix.title)(""))),
            Self::FrontsMarkdown => page(&format!("{}\n\n{setting}", (words.fronts.title)(""))),
            Self::Latex | Self::MatrixLatex | Self::FrontsLatex => text.starts_with(&format!("{}`", words.latex.made_by)),
            _ => false,
        }
    }
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
    /// What those for people are written in.
    pub language: ReportLanguage,
    /// Over which measures runs are traded off.
    pub fronts: &'a FrontQuestion,
    /// The document, with its runs or without.
    pub document: &'a dyn Fn(bool) -> String,
}

impl Reports<'_> {
    /// The contents of a file: the same bytes wherever it is made.
    pub fn contents(&self, file: ResultFile) -> String {
        let Self { comparison, rows, analysis, command, language, document, .. } = self;
        let words = language.words();
        match file {
            ResultFile::Csv => csv::csv(comparison, rows),
            ResultFile::Markdown => super::markdown(words, comparison, rows, analysis, command),
            ResultFile::Tests => tests::tests(words, comparison, analysis),
            ResultFile::TestsCsv => tests::tests_csv(comparison, analysis),
            ResultFile::SummaryCsv => table::csv(comparison, analysis),
            ResultFile::SummaryJson => table::json(comparison, analysis),
            ResultFile::SummaryMarkdown => printed::markdown(words, comparison, analysis),
            ResultFile::Latex => latex::latex(words, comparison, analysis, command),
            ResultFile::ClaimsCsv => claims::csv(analysis),
            ResultFile::MatrixCsv => matrix::csv(comparison, analysis),
            ResultFile::MatrixMarkdown => matrix::markdown(words, comparison, analysis),
            ResultFile::MatrixLatex => matrix::latex(words, comparison, analysis, command),
            ResultFile::FrontsCsv => fronts::csv(comparison, &self.traded_off()),
            ResultFile::FrontsMarkdown => fronts::markdown(words, comparison, analysis, &self.traded_off()),
            ResultFile::FrontsLatex => fronts::latex(words, comparison, analysis, &self.traded_off(), command),
            ResultFile::Json => document(true),
            ResultFile::Link => document(false),
        }
    }
    fn traded_off(&self) -> Vec<MapFronts> {
        pareto::fronts(&Samples::new(self.comparison, self.rows.iter().map(Seen::from)), self.fronts)
    }
}
