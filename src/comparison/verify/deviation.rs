//! Differences between what was recorded and what comes out.

use std::fmt;

use serde::Serialize;
use serde_json::Value as Json;

/// Where a result is not what was recorded, and what may be the cause.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Deviation {
    /// The engine is another version.
    Version {
        /// The one that was recorded.
        recorded: String,
        /// This one.
        now: String,
    },
    /// Question or maps were changed after the runs had been recorded.
    Comparison {
        /// Digest that was recorded.
        recorded: String,
        /// Digest now.
        now: String,
    },
    /// A parameter has another value: a default has changed, or the question.
    Parameter {
        /// Id of the entry.
        entry: String,
        /// Its key.
        key: String,
        /// The value that was recorded; none where there was no such parameter.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "number | string | boolean | null"))]
        recorded: Json,
        /// Its value now; none where there is no such parameter any more.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "number | string | boolean | null"))]
        now: Json,
    },
    /// The file's own runs are not those that its digest was taken over: they were changed afterwards.
    Edited {
        /// Id of the instance.
        instance: String,
        /// Id of the entry.
        entry: String,
    },
    /// Runs do not have the bits that were recorded.
    Bits {
        /// Id of the instance.
        instance: String,
        /// Id of the entry.
        entry: String,
        /// The first seed whose run differs; none where only a digest over all of them was recorded.
        seed: Option<u32>,
        /// How many of the runs that were done again differ; none where only a digest over all of them was recorded.
        differing: Option<u32>,
        /// Digest that was recorded: over that run's row, or over all rows.
        recorded: String,
        /// The same here and now.
        now: String,
    },
}

impl Deviation {
    /// Whether it can be the cause of others.
    pub(super) fn is_cause(&self) -> bool {
        matches!(self, Self::Version { .. } | Self::Comparison { .. } | Self::Parameter { .. })
    }
}

impl fmt::Display for Deviation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Version { recorded, now } => write!(f, "engine: recorded with version {recorded}, this is {now}"),
            Self::Comparison { recorded, now } => {
                write!(f, "question or maps were changed since: {recorded} was recorded, this is {now}")
            }
            Self::Parameter { entry, key, recorded, now } => {
                write!(f, "parameter {entry}.{key}: recorded with {recorded}, now {now}")
            }
            Self::Edited { instance, entry } => {
                write!(f, "runs of {entry} on {instance}: the file's runs were changed since their digest was taken")
            }
            Self::Bits { instance, entry, seed, differing, recorded, now } => {
                write!(f, "runs of {entry} on {instance}: ")?;
                if let (Some(seed), Some(differing)) = (seed, differing) {
                    write!(f, "{differing} differ, the first with seed {seed}: ")?;
                }
                write!(f, "digest {recorded} was recorded, now {now}")
            }
        }
    }
}
