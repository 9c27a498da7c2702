//! Why a claim to be the best known is refused.

use thiserror::Error;

use super::{ErrorReport, ParamError};

/// A claimed run or path does not hold. Values are in cells.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum BestKnownError {
    /// The map is none on which values are kept.
    #[error("the map is none of the tracker's scenarios: {difference}")]
    OtherMap {
        /// How it differs from the one that is most like it.
        difference: String,
        /// Ids of the scenarios.
        known: String,
    },
    /// Walls changed during the run.
    #[error("walls changed while the planners ran (changes: {changes})")]
    Changes {
        /// How often.
        changes: usize,
    },
    /// Another version of the engine made the run.
    #[error("the run is of engine {recorded}; this is {now}")]
    Engine {
        /// What the claim says.
        recorded: String,
        /// This engine's.
        now: &'static str,
    },
    /// Nothing was recorded.
    #[error("the session has no recorded run with a path")]
    NoRun,
    /// The planner cannot be made as it is described.
    #[error("the run cannot be repeated: {0}")]
    Planner(#[from] ParamError),
    /// The repeated run has other bits.
    #[error("the digest does not come out again: {recorded} is claimed, {now} came out")]
    Digest {
        /// What the claim says.
        recorded: String,
        /// What came out.
        now: String,
    },
    /// A number beside the digest is not what came out.
    #[error("{field} = {recorded} is claimed, {now} came out")]
    Number {
        /// Its name.
        field: &'static str,
        /// What the claim says.
        recorded: String,
        /// What came out.
        now: String,
    },
    /// Nobody wants to wait for it.
    #[error("the run has {iterations} iterations: runs of up to {most} are repeated")]
    TooLong {
        /// How many the claim says.
        iterations: u32,
        /// How many are allowed.
        most: u32,
    },
    /// The run has no path.
    #[error("the run has found no path")]
    NoPath,
    /// The path is none on the map.
    #[error("{flaw}")]
    Flaw {
        /// What is wrong first.
        flaw: String,
    },
    /// The objective does not fit the path or the map.
    #[error("`{objective}` does not measure this path here")]
    Objective {
        /// What was asked for.
        objective: String,
        /// What may be asked for.
        allowed: String,
    },
    /// The value is below what is proven to be the least.
    #[error("{value} is below the proven optimum of {optimum}")]
    Impossible {
        /// What is claimed.
        value: f64,
        /// The least possible.
        optimum: f64,
    },
    /// A planner of the catalog is claimed by a path alone.
    #[error("a path does not prove that `{planner}` has found it")]
    NeedsRun {
        /// The planner.
        planner: String,
    },
}

impl BestKnownError {
    /// The flat form.
    pub fn report(&self) -> ErrorReport {
        let report = |kind: &str, field: &str, hint: &str| ErrorReport::new(kind, field, self.to_string(), hint);
        match self {
            Self::OtherMap { known, .. } => report("other-map", "scenario", &format!("take one of {known}, unchanged")),
            Self::Changes { .. } => report("changed-walls", "scenario.changes", "begin the run anew on the scenario as it is"),
            Self::Engine { now, .. } => report("engine", "engine", &format!("repeat the run with engine {now}")),
            Self::NoRun => report("no-run", "panels", "let a planner find a path before you share"),
            Self::Planner(error) => {
                let inner = error.report();
                report(&inner.kind, &inner.field, &inner.hint)
            }
            Self::Digest { now, .. } => {
                report("digest", "digest", &format!("{now} is allowed: share the run as the page or `plan` has made it"))
            }
            Self::Number { field, now, .. } => report("number", field, &format!("{now} is allowed")),
            Self::TooLong { most, .. } => {
                report("too-long", "iterations", &format!("up to {most} are allowed: share the run where it has found its path"))
            }
            Self::NoPath => report("no-path", "value", "a run with a path is allowed"),
            Self::Flaw { .. } => report("flaw", "path", "`formicarium check` shows all that is wrong with a path"),
            Self::Objective { allowed, .. } => report("objective", "objective", &format!("{allowed} is allowed")),
            Self::Impossible { optimum, .. } => {
                let hint = format!("{optimum} or more is allowed: the path was measured or found under other rules");
                report("impossible", "value", &hint)
            }
            Self::NeedsRun { .. } => report("needs-run", "planner", "give a session's link, or name a planner that is not ours"),
        }
    }
}
