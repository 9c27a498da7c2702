//! A tracker's folder: its scenarios, its entries, and what is best among them.

use std::cell::OnceCell;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Deserialize;

use crate::cli::error::CliError;
use crate::cli::input;
use crate::comparison::best_known::{Standing, difference};
use crate::error::{BestKnownError, FormatError};
use crate::exact::{self, Reference};
use crate::formats::session::Origin;
use crate::formats::{MAX_BYTES, MAX_TEXT_BYTES, read_scenario};
use crate::planner::Objective;
use crate::scenario::Scenario;

use super::entry::Entry;

/// Who runs the project's own entries, which have the default parameters.
pub const PROJECT: &str = "Formicarium";

/// The ending of scenarios and entries.
const ENDING: &str = "toml";

/// What `scenarios/ID.toml` says.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ScenarioFile {
    /// The map's file, seen from this one.
    map: PathBuf,
    /// Why values are kept on it, in a sentence for the table.
    about: String,
    /// The call that makes the map, where one does: links are short then.
    origin: Option<Origin>,
}

/// A scenario on which values are kept.
pub struct Tracked {
    /// The name of its file.
    pub id: String,
    /// Why values are kept on it.
    pub about: String,
    /// What is asked.
    pub scenario: Arc<Scenario>,
    /// The call that makes its map.
    pub origin: Option<Origin>,
    references: [OnceCell<Reference>; Objective::ALL.len()],
}

impl Tracked {
    fn read(file: &Path) -> Result<Self, CliError> {
        let ScenarioFile { map, about, origin } = toml_in(file)?;
        let map = file.parent().unwrap_or(Path::new("")).join(map);
        let (grid, spec) = input::in_file(&map, MAX_BYTES, |bytes, _| Ok(read_scenario(&String::from_utf8_lossy(bytes))?))?;
        if origin.is_some_and(|origin| origin.make(&spec).as_ref() != Ok(&grid)) {
            let message = format!("{}: `origin` makes another map than {}", file.display(), map.display());
            return Err(CliError::usage(message, "leave it out, or name the call that made the map"));
        }
        let scenario = Arc::new(Scenario::new(grid, spec)?);
        Ok(Self { id: input::stem(file), about, scenario, origin, references: Default::default() })
    }

    /// What values by an objective are held against; computed once.
    pub fn reference(&self, objective: Objective) -> Reference {
        let index = Objective::ALL.iter().position(|&one| one == objective).unwrap_or(0);
        *self.references[index].get_or_init(|| exact::reference(&self.scenario, objective))
    }
}

/// A tracker's folder.
pub struct Tracker {
    folder: PathBuf,
    /// In the order of their names.
    pub scenarios: Vec<Tracked>,
}

impl Tracker {
    /// Reads the scenarios.
    pub fn open(folder: &Path) -> Result<Self, CliError> {
        let scenarios = folder.join("scenarios");
        if !scenarios.is_dir() {
            let message = format!("{} is no tracker: it has no folder `scenarios`", folder.display());
            return Err(CliError::usage(
                message,
                "name a tracker's folder by --tracker DIR, such as a clone's experiments/tracker",
            ));
        }
        let files = files_in(&scenarios)?;
        let scenarios = files.iter().map(|file| Tracked::read(file)).collect::<Result<Vec<_>, _>>()?;
        if scenarios.is_empty() {
            let message = format!("{} has no scenarios", folder.display());
            return Err(CliError::usage(message, "name a tracker's folder by --tracker"));
        }
        Ok(Self { folder: folder.to_owned(), scenarios })
    }

    /// The scenario of an id.
    pub fn scenario(&self, id: &str) -> Result<&Tracked, CliError> {
        self.scenarios.iter().find(|tracked| tracked.id == id).ok_or_else(|| {
            CliError::usage(format!("the tracker has no scenario `{id}`"), format!("its scenarios are {}", self.ids()))
        })
    }

    /// The scenario that asks the same.
    pub fn same_as(&self, scenario: &Scenario) -> Result<&Tracked, BestKnownError> {
        let differences = || self.scenarios.iter().map(|tracked| (tracked, difference(scenario, &tracked.scenario)));
        if let Some((same, _)) = differences().find(|(_, difference)| difference.is_none()) {
            return Ok(same);
        }
        // Only where the cells are the same is it of use to know what else differs.
        let is_close = |tracked: &Tracked| tracked.scenario.drawn == scenario.drawn;
        let close = differences().find_map(|(tracked, what)| what.filter(|_| is_close(tracked)).map(|what| (tracked, what)));
        let difference = match close {
            Some((tracked, what)) => format!("it has the cells of {}, but {what}", tracked.id),
            None => format!("its {} × {} cells are those of none", scenario.grid.width(), scenario.grid.height()),
        };
        Err(BestKnownError::OtherMap { difference, known: self.ids() })
    }

    fn ids(&self) -> String {
        self.scenarios.iter().map(|tracked| tracked.id.as_str()).collect::<Vec<_>>().join(", ")
    }

    /// Where an entry stands.
    pub fn place(&self, scenario: &str, name: &str) -> PathBuf {
        self.folder.join("entries").join(scenario).join(format!("{name}.{ENDING}"))
    }

    /// The files of a scenario's entries, in the order of their names.
    pub fn files(&self, scenario: &str) -> Result<Vec<PathBuf>, CliError> {
        let folder = self.folder.join("entries").join(scenario);
        if folder.is_dir() { files_in(&folder) } else { Ok(Vec::new()) }
    }

    /// The entries of a scenario.
    pub fn entries(&self, scenario: &str) -> Result<Vec<Entry>, CliError> {
        self.files(scenario)?.iter().map(|file| Entry::read(file)).collect()
    }

    /// Folders of entries that belong to no scenario.
    pub fn strays(&self) -> Vec<String> {
        let folders = fs::read_dir(self.folder.join("entries")).into_iter().flatten().flatten();
        let names = folders.map(|folder| folder.file_name().to_string_lossy().into_owned());
        let mut strays: Vec<String> = names.filter(|name| self.scenarios.iter().all(|tracked| &tracked.id != name)).collect();
        strays.sort();
        strays
    }
}

/// The best of a planner's entries: the least value, and of equal ones the project's own, or else the first by date.
pub fn best<'a>(entries: impl IntoIterator<Item = &'a Entry>) -> Option<&'a Entry> {
    let age = |entry: &Entry| (entry.by != PROJECT, entry.date.clone());
    entries.into_iter().reduce(|best, entry| {
        let wins = match Standing::of(entry.value, Some(best.value)) {
            Standing::Equal => age(entry) < age(best),
            standing => standing.wins(),
        };
        if wins { entry } else { best }
    })
}

/// Reads a file of a tracker.
pub fn toml_in<T: for<'de> Deserialize<'de>>(file: &Path) -> Result<T, CliError> {
    input::in_file(file, MAX_TEXT_BYTES, |bytes, _| {
        let text = String::from_utf8_lossy(bytes);
        let line = |e: &toml::de::Error| e.span().map_or(0, |span| text[..span.start].lines().count().max(1));
        let wrong = |e: toml::de::Error| FormatError::syntax(line(&e), e.message(), "the fields of docs/tracker.md");
        Ok(toml::from_str(&text).map_err(wrong)?)
    })
}

fn files_in(folder: &Path) -> Result<Vec<PathBuf>, CliError> {
    let failed = |error| CliError::File { action: "read", path: folder.display().to_string(), error };
    let files = fs::read_dir(folder).map_err(failed)?.collect::<Result<Vec<_>, _>>().map_err(failed)?;
    let mut paths: Vec<PathBuf> = files.into_iter().map(|file| file.path()).collect();
    paths.retain(|path| path.is_file() && path.extension().is_some_and(|ending| ending == ENDING));
    paths.sort();
    Ok(paths)
}
