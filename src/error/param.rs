//! What is wrong with the choice of a planner or with its parameters.

use thiserror::Error;

use super::ErrorReport;

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
    /// The planner does not know how one moves here.
    #[error("`{planner}` does not plan {ground}")]
    Ground {
        /// The planner.
        planner: String,
        /// How one moves, as a phrase.
        ground: &'static str,
        /// Its stable name.
        id: &'static str,
        /// Ids of the planners that can, comma-separated.
        others: String,
    },
    /// A value of a parameter does not go with how one moves here, or with several goals.
    #[cfg(feature = "whole")]
    #[error("{key} = {value} cannot be planned {ground}")]
    ValueOnGround {
        /// The parameter.
        key: &'static str,
        /// Its value.
        value: &'static str,
        /// How one moves, as a phrase.
        ground: &'static str,
        /// Its stable name.
        id: &'static str,
        /// A value that goes with it.
        instead: &'static str,
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
            Self::Ground { planner, id, others, .. } => {
                ErrorReport::new("ground", "planner", message, format!("planners that do are {others}"))
                    .with("planner", planner)
                    .with("ground", id)
                    .with("others", others)
            }
            #[cfg(feature = "whole")]
            Self::ValueOnGround { key, value, id, instead, .. } => {
                ErrorReport::new("value-on-ground", *key, message, format!("choose {key} = {instead}"))
                    .with("value", value)
                    .with("ground", id)
                    .with("instead", instead)
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
