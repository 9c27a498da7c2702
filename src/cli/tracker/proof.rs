//! What proves a value: a run that is repeated, or a path that is walked.

use crate::catalog;
use crate::cli::error::CliError;
use crate::comparison::best_known::{ClaimedPath, Measured, Recipe, check_bound, difference, repeat, same};
use crate::error::{BestKnownError, FormatError};
use crate::formats::session::{Panel, Session, read_session_link, write_session_link};
use crate::path::PathKind;
use crate::planner::Objective;
use crate::scenario::Scenario;

use super::entry::Entry;
use super::folder::Tracked;

/// What proves a value.
pub enum Proof {
    /// A session with one panel, whose run is recorded.
    Run(Box<Session>),
    /// A path, and what measures it.
    Path(ClaimedPath, Objective),
}

impl Proof {
    /// The proof that an entry brings.
    pub fn of(entry: &Entry) -> Result<Self, CliError> {
        match (&entry.session, &entry.path) {
            (Some(link), None) => Ok(Self::Run(Box::new(read_session_link(link)?))),
            (None, Some(path)) => {
                let level = |i: usize| entry.levels.as_ref().and_then(|levels| levels.get(i).copied());
                let places = path.iter().enumerate().map(|(i, &at)| (at, level(i))).collect();
                let kind = entry.kind.unwrap_or(PathKind::Steps);
                Ok(Self::Path(ClaimedPath { kind, places }, entry.objective))
            }
            _ => {
                let expected = "`session`, a link, or `path`, a list of cells";
                Err(FormatError::field("session", "an entry has one proof", expected).into())
            }
        }
    }

    /// Puts the proof into an entry.
    pub fn into_entry(self, mut entry: Entry) -> Result<Entry, CliError> {
        match self {
            Self::Run(session) => entry.session = Some(write_session_link(&session)?),
            Self::Path(ClaimedPath { kind, places }, _) => {
                entry.kind = Some(kind);
                entry.levels = places.iter().map(|&(_, level)| level).collect();
                entry.path = Some(places.into_iter().map(|(at, _)| at).collect());
            }
        }
        Ok(entry)
    }

    /// The seed of the run.
    pub fn seed(&self) -> Option<u32> {
        match self {
            Self::Run(session) => Some(session.seed),
            Self::Path(..) => None,
        }
    }

    /// Repeats the run of a planner, or walks its path, and holds what comes out against what is proven.
    pub fn measure(&self, tracked: &Tracked, planner: &str) -> Result<Measured, BestKnownError> {
        let measured = match self {
            Self::Run(session) => repeated(session, tracked, planner)?,
            Self::Path(..) if catalog::find(&planner.to_ascii_lowercase()).is_ok() => {
                return Err(BestKnownError::NeedsRun { planner: planner.into() });
            }
            Self::Path(path, objective) => path.measure(&tracked.scenario, *objective)?,
        };
        check_bound(measured.value, tracked.reference(measured.objective))?;
        Ok(measured)
    }
}

fn repeated(session: &Session, tracked: &Tracked, planner: &str) -> Result<Measured, BestKnownError> {
    check_session(session)?;
    let scenario =
        Scenario::new(session.grid.clone(), session.spec.clone()).map_err(|_| other_map(tracked, "its map differs"))?;
    if let Some(difference) = difference(&scenario, &tracked.scenario) {
        return Err(other_map(tracked, difference));
    }
    let [Panel { planner: raced, params, result: Some(recorded), .. }] = &session.panels[..] else {
        return Err(BestKnownError::NoRun);
    };
    same("planner", &planner, &raced.as_str())?;
    repeat(&tracked.scenario, Recipe { planner, params, seed: session.seed }, recorded)
}

fn other_map(tracked: &Tracked, difference: &str) -> BestKnownError {
    BestKnownError::OtherMap { difference: format!("{difference} from {}", tracked.id), known: tracked.id.clone() }
}

/// Refuses sessions whose runs cannot be repeated here.
pub fn check_session(session: &Session) -> Result<(), BestKnownError> {
    let now = env!("CARGO_PKG_VERSION");
    if session.engine != now {
        return Err(BestKnownError::Engine { recorded: session.engine.clone(), now });
    }
    if session.changes > 0 {
        return Err(BestKnownError::Changes { changes: session.changes });
    }
    Ok(())
}
