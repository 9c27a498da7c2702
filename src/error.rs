//! What an operation answers when its input cannot be used: what is wrong, where, what is allowed, and what to do next.
//!
//! One enum per operation ([`ParamError`], [`ScenarioError`], [`FormatError`], [`QuestionError`]); [`Error`] is their sum. Every variant can
//! be turned into an [`ErrorReport`], the flat form that crosses into the page, where `kind` is the key of a translated message.

use std::collections::BTreeMap;

use serde::Serialize;
use thiserror::Error;

use crate::experiment::QuestionError;

/// The flat form of any error, for the page and for `--format json`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ErrorReport {
    /// Stable key of the message, e.g. `out-of-range`.
    pub kind: String,
    /// The field at fault, e.g. `rho`, `start`, `line 12`.
    pub field: String,
    /// The sentence in English.
    pub message: String,
    /// What to do next, in English.
    pub hint: String,
    /// Values for a translated message.
    pub args: BTreeMap<String, String>,
}

impl ErrorReport {
    /// A report without arguments.
    pub fn new(kind: &str, field: impl Into<String>, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self { kind: kind.into(), field: field.into(), message: message.into(), hint: hint.into(), args: BTreeMap::new() }
    }

    /// Adds one argument of the translated message.
    #[must_use]
    pub fn with(mut self, name: &str, value: impl ToString) -> Self {
        self.args.insert(name.into(), value.to_string());
        self
    }
}

/// A planner or one of its parameters cannot be used as asked.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ParamError {
    /// No planner has this id.
    #[error("there is no planner `{id}`")]
    UnknownPlanner {
        /// The id asked for.
        id: String,
        /// All ids of the catalog, comma-separated.
        known: String,
    },
    /// The planner has no such parameter.
    #[error("`{planner}` has no parameter `{key}`")]
    UnknownKey {
        /// The planner.
        planner: String,
        /// The key asked for.
        key: String,
        /// All keys of the planner, comma-separated.
        known: String,
    },
    /// The planner has no such preset.
    #[error("`{planner}` has no preset `{name}`")]
    UnknownPreset {
        /// The planner.
        planner: String,
        /// The name asked for.
        name: String,
        /// All presets of the planner, comma-separated.
        known: String,
    },
    /// A number lies outside its range.
    #[error("{key} = {value} is outside {min} to {max} ({meaning})")]
    OutOfRange {
        /// The parameter.
        key: String,
        /// The refused value.
        value: String,
        /// Smallest allowed value.
        min: f64,
        /// Largest allowed value.
        max: f64,
        /// What the parameter means.
        meaning: String,
    },
    /// The value is of another type, or names no option.
    #[error("{key} = {value} is not {expected} ({meaning})")]
    WrongType {
        /// The parameter.
        key: String,
        /// The refused value.
        value: String,
        /// What is expected, e.g. "a whole number" or "one of die, backtrack".
        expected: String,
        /// What the parameter means.
        meaning: String,
    },
    /// The planner cannot visit that many goals.
    #[error("`{planner}` plans for {most} goal(s) at most; the scenario has {got}")]
    TooManyGoals {
        /// The planner.
        planner: String,
        /// Most goals it can visit.
        most: u32,
        /// Goals of the scenario.
        got: usize,
        /// Ids of the planners that can, comma-separated.
        others: String,
    },
    /// The map is too large for an exact method.
    #[error("`{planner}` plans on maps of up to {most} cells; this one has {width} × {height}")]
    MapTooLarge {
        /// The planner.
        planner: String,
        /// Width in cells.
        width: u32,
        /// Height in cells.
        height: u32,
        /// Most cells that it takes.
        most: u32,
        /// A planner for larger maps.
        instead: &'static str,
    },
    /// The tables of a planner would not fit into the address space of WebAssembly; the same limit natively, so that a link runs everywhere.
    #[error("{count} {field} on this map need {megabytes} MB, more than {limit}")]
    Memory {
        /// The parameter that counts what needs them, e.g. `ants`.
        field: &'static str,
        /// How many of it were asked for.
        count: u32,
        /// What they and the map's tables need.
        megabytes: u64,
        /// What there is.
        limit: u64,
    },
}

/// A scenario cannot be planned on.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ScenarioError {
    /// The map has no cells or more than [`crate::map::MAX_SIDE`] a side.
    #[error("a map of {width} × {height} cells cannot be used")]
    MapSize {
        /// Width in cells.
        width: u64,
        /// Height in cells.
        height: u64,
    },
    /// The cell list does not have width × height entries.
    #[error("the map has {got} cells where {width} × {height} = {} are needed", u64::from(*.width) * u64::from(*.height))]
    CellCount {
        /// Width in cells.
        width: u32,
        /// Height in cells.
        height: u32,
        /// Entries found.
        got: usize,
    },
    /// Start or goal lies outside the map.
    #[error("the {role} ({x}, {y}) lies outside the map of {width} × {height} cells")]
    OutsideMap {
        /// `start` or `goal`.
        role: &'static str,
        /// Column asked for.
        x: i64,
        /// Row asked for.
        y: i64,
        /// Width in cells.
        width: u32,
        /// Height in cells.
        height: u32,
    },
    /// Start or goal lies on an obstacle.
    #[error("the {role} ({x}, {y}) lies on a blocked cell")]
    Blocked {
        /// `start` or `goal`.
        role: &'static str,
        /// Column.
        x: u32,
        /// Row.
        y: u32,
    },
    /// The scenario has no goal, or more than [`crate::scenario::MAX_GOALS`].
    #[error("the scenario has {got} goals where 1 to {} are possible", crate::scenario::MAX_GOALS)]
    GoalCount {
        /// Goals found.
        got: usize,
    },
    /// Two goals share a cell.
    #[error("two goals lie on the cell ({x}, {y})")]
    GoalTwice {
        /// Column.
        x: u32,
        /// Row.
        y: u32,
    },
    /// A physical quantity is not a positive, finite number (or not in its set).
    #[error("{field} = {value} cannot be used: it must be {allowed}")]
    Quantity {
        /// The field.
        field: &'static str,
        /// The refused value.
        value: String,
        /// What is allowed.
        allowed: &'static str,
    },
}

/// A file cannot be read.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FormatError {
    /// Nothing in the file tells its format.
    #[error("this is none of the known formats")]
    Unknown {
        /// What the file begins with, shortened.
        begins: String,
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

/// Any error of the engine.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Error {
    /// See [`ParamError`].
    #[error(transparent)]
    Param(#[from] ParamError),
    /// See [`ScenarioError`].
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// See [`FormatError`].
    #[error(transparent)]
    Format(#[from] FormatError),
    /// See [`QuestionError`].
    #[error(transparent)]
    Question(#[from] QuestionError),
}

impl Error {
    /// The flat form for the page and for JSON.
    pub fn report(&self) -> ErrorReport {
        match self {
            Self::Param(e) => e.report(),
            Self::Scenario(e) => e.report(),
            Self::Format(e) => e.report(),
            Self::Question(e) => e.report(),
        }
    }
}

impl ParamError {
    /// Refuses tables of more than 3000 MB: `bytes` for `count` of the parameter `field`.
    ///
    /// # Errors
    /// [`ParamError::Memory`].
    pub fn check_memory(field: &'static str, count: u32, bytes: u64) -> Result<(), Self> {
        const LIMIT_MB: u64 = 3000;
        let megabytes = bytes / 1_000_000;
        if megabytes > LIMIT_MB { Err(Self::Memory { field, count, megabytes, limit: LIMIT_MB }) } else { Ok(()) }
    }

    /// The flat form.
    pub fn report(&self) -> ErrorReport {
        let message = self.to_string();
        match self {
            Self::UnknownPlanner { id, known } => {
                ErrorReport::new("unknown-planner", "planner", message, format!("the planners are {known}"))
                    .with("value", id)
                    .with("known", known)
            }
            Self::UnknownKey { planner, key, known } => {
                ErrorReport::new("unknown-parameter", key, message, format!("its parameters are {known}"))
                    .with("planner", planner)
                    .with("known", known)
            }
            Self::UnknownPreset { planner, name, known } => {
                ErrorReport::new("unknown-preset", "preset", message, format!("its presets are {known}"))
                    .with("planner", planner)
                    .with("value", name)
                    .with("known", known)
            }
            Self::OutOfRange { key, value, min, max, .. } => {
                ErrorReport::new("out-of-range", key, message, format!("choose {key} between {min} and {max}"))
                    .with("value", value)
                    .with("min", min)
                    .with("max", max)
            }
            Self::TooManyGoals { most, got, others, .. } => {
                let instead = if others.is_empty() { String::new() } else { format!(", or choose one of {others}") };
                let hint = format!("remove goals{instead}");
                ErrorReport::new("too-many-goals", "goals", message, hint).with("value", got).with("max", most)
            }
            Self::MapTooLarge { width, height, most, instead, .. } => {
                let hint = format!("use `{instead}`, which has no such limit, or crop or resample the map");
                ErrorReport::new("map-too-large", "map", message, hint)
                    .with("width", width)
                    .with("height", height)
                    .with("max", most)
                    .with("instead", instead)
            }
            Self::Memory { field, count, megabytes, limit } => {
                ErrorReport::new("memory", *field, message, format!("use fewer {field}, or crop or resample the map"))
                    .with("value", count)
                    .with("megabytes", megabytes)
                    .with("max", limit)
            }
            Self::WrongType { key, value, expected, .. } => {
                ErrorReport::new("wrong-type", key, message, format!("{key} takes {expected}"))
                    .with("value", value)
                    .with("expected", expected)
            }
        }
    }
}

impl ScenarioError {
    /// The flat form.
    pub fn report(&self) -> ErrorReport {
        let message = self.to_string();
        match self {
            Self::MapSize { width, height } => {
                ErrorReport::new("map-size", "map", message, format!("use 1 to {} cells a side", crate::map::MAX_SIDE))
                    .with("width", width)
                    .with("height", height)
                    .with("max", crate::map::MAX_SIDE)
            }
            Self::CellCount { got, .. } => {
                ErrorReport::new("cell-count", "cells", message, "give one cell for each place of the map").with("value", got)
            }
            Self::OutsideMap { role, x, y, width, height } => ErrorReport::new(
                "outside-map",
                *role,
                message,
                format!("columns run from 0 to {}, rows from 0 to {}", width - 1, height - 1),
            )
            .with("x", x)
            .with("y", y),
            Self::Blocked { role, x, y } => {
                ErrorReport::new(&format!("{role}-blocked"), *role, message, "move it to a free cell or clear the wall under it")
                    .with("x", x)
                    .with("y", y)
            }
            Self::GoalCount { got } => {
                let hint = format!("use 1 to {} goals", crate::scenario::MAX_GOALS);
                ErrorReport::new("goal-count", "goals", message, hint).with("value", got).with("max", crate::scenario::MAX_GOALS)
            }
            Self::GoalTwice { x, y } => {
                ErrorReport::new("goal-twice", "goals", message, "move one of them, or remove it").with("x", x).with("y", y)
            }
            Self::Quantity { field, value, allowed } => {
                ErrorReport::new("quantity", *field, message, format!("give {allowed}")).with("value", value)
            }
        }
    }
}

impl FormatError {
    /// Shorthand for a broken line.
    pub fn syntax(line: usize, what: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::Syntax { line, what: what.into(), expected: expected.into() }
    }

    /// The flat form.
    pub fn report(&self) -> ErrorReport {
        let message = self.to_string();
        match self {
            Self::Unknown { begins } => ErrorReport::new(
                "unknown-format",
                "file",
                message,
                "known are MovingAI .map and .scen, a matrix of 0 and 1, and a scenario as JSON",
            )
            .with("begins", begins),
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

/// Something worth saying about an input that was accepted all the same.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(hashmap_as_object))]
pub struct Notice {
    /// Stable key of the message.
    pub kind: String,
    /// The sentence in English.
    pub message: String,
    /// Values for a translated message.
    pub args: BTreeMap<String, String>,
}

impl Notice {
    /// A notice without arguments.
    pub fn new(kind: &str, message: impl Into<String>) -> Self {
        Self { kind: kind.into(), message: message.into(), args: BTreeMap::new() }
    }

    /// Adds one argument of the translated message.
    #[must_use]
    pub fn with(mut self, name: &str, value: impl ToString) -> Self {
        self.args.insert(name.into(), value.to_string());
        self
    }
}
