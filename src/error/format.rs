//! What is wrong with a file.

use std::borrow::Cow;

use thiserror::Error;

use super::{ErrorReport, ScenarioError};

/// A file cannot be read.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FormatError {
    /// Nothing in the file tells its format.
    #[error("this is none of the known formats")]
    Unknown {
        /// What the file begins with, shortened.
        begins: String,
    },
    /// A known format that is not read here.
    #[error("this is {found}")]
    Foreign {
        /// What it is, e.g. "a PDF document".
        found: &'static str,
        /// What to do.
        hint: Cow<'static, str>,
    },
    /// A file that is only half of what is needed.
    #[error("this is {found}, which needs `{other}`")]
    Needs {
        /// What it is.
        found: &'static str,
        /// The file that belongs to it.
        other: String,
    },
    /// Two readers are equally sure that the file is theirs.
    #[error("this may be {found}")]
    Ambiguous {
        /// What it may be.
        found: String,
    },
    /// A text with several matrices, and nothing says which of them is meant.
    #[error("the file holds several matrices ({found})")]
    Several {
        /// Each with its number, size and line.
        found: String,
    },
    /// The bytes are no text that can be read.
    #[error("this is {found}, not text in UTF-8")]
    NotText {
        /// What it seems to be, e.g. "a PNG image".
        found: String,
    },
    /// A known file, but none that holds a map.
    #[error("this is {found}, not a map")]
    NotAMap {
        /// What it is.
        found: &'static str,
    },
    /// A known file, but none that holds heights.
    #[error("this is {found}, not a raster of heights")]
    NotATerrain {
        /// What it is.
        found: &'static str,
    },
    /// A raster without a single height.
    #[error("the terrain has no height anywhere")]
    NoHeights,
    /// A part of a binary file that has no lines, or of a text's header, cannot be used.
    #[error("{field}: {what}")]
    Field {
        /// The tag, key or part.
        field: &'static str,
        /// What is wrong.
        what: String,
        /// What the format asks for there.
        expected: String,
    },
    /// A window that does not lie on the map.
    #[error("the window of {columns} × {rows} cells at ({x}, {y}) does not lie within {width} × {height} cells")]
    Window {
        /// First column asked for.
        x: u32,
        /// First row asked for.
        y: u32,
        /// Columns asked for.
        columns: u32,
        /// Rows asked for.
        rows: u32,
        /// Columns there are.
        width: u32,
        /// Rows there are.
        height: u32,
    },
    /// The map is a single obstacle.
    #[error("the map has no free cell")]
    NoFreeCell,
    /// A line (counted from 1) breaks the format's grammar.
    #[error("{}{what}", line_prefix(*.line))]
    Syntax {
        /// Line, from 1; 0 when the whole file is meant.
        line: usize,
        /// What is wrong.
        what: String,
        /// What the format asks for there.
        expected: String,
    },
    /// A field of a table cannot be used.
    #[error("line {line}, column `{column}`: `{value}` cannot be used")]
    Cell {
        /// Line, from 1.
        line: usize,
        /// The column's name in the file.
        column: String,
        /// What stands there, shortened.
        value: String,
        /// What may stand there.
        expected: String,
    },
    /// The file claims or holds more than can be used.
    #[error("{what} is more than the {max} that can be read")]
    TooLarge {
        /// What is too large, with its size.
        what: String,
        /// The limit.
        max: String,
    },
    /// A versioned file is newer than this engine, or of another tool.
    #[error("`format` is `{found}`")]
    Version {
        /// What the file says.
        found: String,
        /// What is understood.
        expected: &'static str,
    },
    /// The file is well-formed, but its scenario is not usable.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
}

/// "line 12: ", or nothing when the whole file is meant.
fn line_prefix(line: usize) -> String {
    if line == 0 { String::new() } else { format!("line {line}: ") }
}

impl FormatError {
    /// Shorthand for a broken line.
    pub fn syntax(line: usize, what: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::Syntax { line, what: what.into(), expected: expected.into() }
    }

    /// Shorthand for a broken field.
    pub fn field(field: &'static str, what: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::Field { field, what: what.into(), expected: expected.into() }
    }

    /// The flat form.
    pub fn report(&self) -> ErrorReport {
        let message = self.to_string();
        match self {
            Self::Unknown { begins } => ErrorReport::new(
                "unknown-format",
                "file",
                message,
                "known are MovingAI .map and .scen, a matrix of 0 and 1, a map drawn with # and ., ROS maps, pictures, rasters of heights (ESRI ASCII, CSV, GeoTIFF, SRTM), and a scenario as JSON",
            )
            .with("begins", begins),
            Self::Foreign { found, hint } => ErrorReport::new("foreign-file", "file", message, hint.as_ref()).with("found", found),
            Self::Needs { found, other } => {
                let hint = "open both together; on the command line, keep them in one folder";
                ErrorReport::new("needs-file", "file", message, hint).with("found", found).with("other", other)
            }
            Self::Ambiguous { found } => {
                let hint = "keep the part that is meant in a file of its own";
                ErrorReport::new("ambiguous-file", "file", message, hint).with("found", found)
            }
            Self::Several { found } => {
                let hint = "say which one: --matrix 1 on the command line";
                ErrorReport::new("several-matrices", "matrix", message, hint).with("found", found)
            }
            Self::NotText { found } => ErrorReport::new(
                "not-text",
                "file",
                message,
                "save it as plain text in UTF-8: a .map, a .csv or a scenario as .json",
            )
            .with("found", found),
            Self::NotAMap { found } => {
                ErrorReport::new("not-a-map", "file", message, "open the map that belongs to it").with("found", found)
            }
            Self::NotATerrain { found } => {
                ErrorReport::new("not-a-terrain", "file", message, "open it as a map").with("found", found)
            }
            Self::NoHeights => {
                let hint = "every cell holds the file's no-data value, or the window lies where there is no data";
                ErrorReport::new("no-heights", "heights", message, hint)
            }
            Self::Field { field, what, expected } => {
                ErrorReport::new("bad-field", *field, message, format!("expected {expected}"))
                    .with("what", what)
                    .with("expected", expected)
            }
            Self::Window { x, y, columns, rows, width, height } => {
                let hint = format!("columns run from 0 to {}, rows from 0 to {}", width - 1, height - 1);
                let report = ErrorReport::new("window", "crop", message, hint).with("width", width).with("height", height);
                report.with("x", x).with("y", y).with("columns", columns).with("rows", rows)
            }
            Self::NoFreeCell => {
                let hint = "clear at least one cell, or invert the map if it means 1 as free";
                ErrorReport::new("no-free-cell", "map", message, hint)
            }
            Self::Syntax { line, what, expected } => {
                let field = if *line == 0 { "file".to_string() } else { format!("line {line}") };
                ErrorReport::new("syntax", field, message, format!("expected {expected}"))
                    .with("line", line)
                    .with("what", what)
                    .with("expected", expected)
            }
            Self::Cell { line, column, value, expected } => {
                ErrorReport::new("bad-cell", format!("line {line}"), message, format!("expected {expected}"))
                    .with("line", line)
                    .with("column", column)
                    .with("value", value)
                    .with("expected", expected)
            }
            Self::TooLarge { what, max } => ErrorReport::new("too-large", "file", message, "crop or resample the map first")
                .with("what", what)
                .with("max", max),
            Self::Version { found, expected } => ErrorReport::new(
                "version",
                "format",
                message,
                format!("this engine reads `{expected}`; a newer file needs a newer version"),
            )
            .with("value", found)
            .with("expected", expected),
            Self::Scenario(e) => e.report(),
        }
    }
}
