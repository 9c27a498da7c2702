//! An entry of a tracker: `formicarium/best-known@1`, one TOML file.

use std::fmt::Write as _;
use std::path::Path;

use serde::Deserialize;

use crate::cli::error::CliError;
use crate::cli::input;
use crate::cli::output;
use crate::error::FormatError;
use crate::map::Point;
use crate::path::PathKind;
use crate::planner::Objective;

use super::folder::toml_in;

/// What `format` must say.
const FORMAT: &str = "formicarium/best-known@1";

/// Between the planner and a name, in the names of files.
const BETWEEN: &str = "--";

/// The best value of a planner on a scenario, as far as somebody knows, with what proves it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    format: String,
    /// Id of the scenario.
    pub scenario: String,
    /// Id in the catalog, or the name of a planner from elsewhere.
    pub planner: String,
    /// What is measured.
    pub objective: Objective,
    /// In cells; less is better.
    pub value: f64,
    /// Who has found it.
    pub by: String,
    /// When, as year-month-day.
    pub date: String,
    /// How it was found.
    #[serde(default)]
    pub note: String,
    /// A session's link with one panel: the run.
    pub session: Option<String>,
    /// Of a planner from elsewhere: how the places of its path follow each other.
    pub kind: Option<PathKind>,
    /// Its path, as columns and rows.
    pub path: Option<Vec<Point>>,
    /// By slices the level of each place.
    pub levels: Option<Vec<u32>>,
}

/// An entry's values without their proof.
pub struct Head {
    pub scenario: String,
    pub planner: String,
    pub objective: Objective,
    pub value: f64,
    pub by: String,
    pub date: String,
    pub note: String,
}

impl Entry {
    /// An entry without a proof.
    pub fn new(Head { scenario, planner, objective, value, by, date, note }: Head) -> Self {
        let format = FORMAT.into();
        Self { format, scenario, planner, objective, value, by, date, note, session: None, kind: None, path: None, levels: None }
    }

    /// Reads a file, which must be called by what it says.
    pub fn read(file: &Path) -> Result<Self, CliError> {
        let entry: Self = toml_in(file)?;
        entry.check(file).map_err(|error| CliError::Contents { path: file.display().to_string(), error: error.into() })?;
        Ok(entry)
    }

    fn check(&self, file: &Path) -> Result<(), FormatError> {
        if self.format != FORMAT {
            return Err(FormatError::Version { found: self.format.clone(), expected: FORMAT });
        }
        let name = input::stem(file);
        let planner = name.split_once(BETWEEN).map_or(name.as_str(), |(planner, _)| planner);
        if planner != self.planner {
            let expected = format!("{0}.toml or {0}{BETWEEN}NAME.toml", self.planner);
            return Err(FormatError::field("planner", format!("the file is called {name}.toml"), expected));
        }
        let folder = file.parent().map(input::file_name).unwrap_or_default();
        if folder != self.scenario {
            let expected = format!("a file in the folder {}", self.scenario);
            return Err(FormatError::field("scenario", format!("the file is in the folder {folder}"), expected));
        }
        for (field, text) in [("planner", &self.planner), ("by", &self.by), ("note", &self.note)] {
            one_line(text)
                .map_err(|expected| FormatError::field(field, "it has more than one line, or too many letters", expected))?;
        }
        if !self.value.is_finite() {
            return Err(FormatError::field("value", format!("{} is no length", self.value), "a number of cells"));
        }
        if !is_date(&self.date) {
            return Err(FormatError::field("date", format!("`{}` is no date", self.date), "year-month-day such as 2026-03-21"));
        }
        Ok(())
    }

    /// Writes the file, and the folders that it stands in.
    pub fn write(&self, file: &Path) -> Result<(), CliError> {
        let folder = output::folder(file);
        std::fs::create_dir_all(folder).map_err(|error| output::failure(folder, error))?;
        output::write(Some(file), self.text().as_bytes())
    }

    fn text(&self) -> String {
        let mut out = String::new();
        let mut line = |key: &str, value: String| {
            let _ = writeln!(out, "{key} = {value}");
        };
        line("format", quoted(&self.format));
        line("scenario", quoted(&self.scenario));
        line("planner", quoted(&self.planner));
        line("objective", quoted(self.objective.id()));
        line("value", format!("{:?}", self.value));
        line("by", quoted(&self.by));
        line("date", quoted(&self.date));
        if !self.note.is_empty() {
            line("note", quoted(&self.note));
        }
        let json = |value: serde_json::Value| value.to_string().replace(',', ", ");
        self.session.iter().for_each(|link| line("session", quoted(link)));
        self.kind.iter().for_each(|kind| line("kind", json(serde_json::json!(kind))));
        self.path.iter().for_each(|path| line("path", json(serde_json::json!(path))));
        self.levels.iter().for_each(|levels| line("levels", json(serde_json::json!(levels))));
        out
    }
}

/// The name of an outside entry's file without its ending.
pub fn outside_name(planner: &str, by: &str) -> Result<String, CliError> {
    let letters = |text: &str| -> String {
        let all: String = text.to_lowercase().chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
        all.split('-').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("-")
    };
    const LONGEST: usize = 60;
    let name = letters(by);
    if name.is_empty() || name.len() > LONGEST {
        let hint = format!("say who you are: --by NAME, with a letter or digit, of at most {LONGEST} bytes");
        return Err(CliError::usage("the entry's file needs a name", hint));
    }
    Ok(format!("{planner}{BETWEEN}{name}"))
}

/// A text as TOML has it: control characters, which JSON alone would leave, are refused before.
fn quoted(text: &str) -> String {
    serde_json::json!(text).to_string()
}

/// Reads a word or sentence of an entry: one line that is not too long.
pub fn one_line(text: &str) -> Result<String, String> {
    const LONGEST: usize = 200;
    let text = text.trim();
    let fits = text.chars().count() <= LONGEST && !text.chars().any(char::is_control);
    if fits { Ok(text.into()) } else { Err(format!("write one line of at most {LONGEST} letters")) }
}

/// Reads a date.
pub fn date(text: &str) -> Result<String, String> {
    if is_date(text) { Ok(text.into()) } else { Err(format!("`{text}` is no date: write year-month-day such as 2026-03-21")) }
}

/// The day before which no value was kept.
const BEGINNING: &str = "2026-01-01";

/// A day of the calendar, as TOML has it.
fn is_date(text: &str) -> bool {
    let is_day = |day: toml::value::Datetime| day.date.is_some() && day.time.is_none() && day.offset.is_none();
    text.parse().is_ok_and(is_day) && text.len() == BEGINNING.len() && text >= BEGINNING
}

/// Today in Greenwich.
pub fn today() -> String {
    let seconds = std::time::SystemTime::UNIX_EPOCH.elapsed().map_or(0, |since| since.as_secs());
    civil(seconds / 86_400)
}

/// The date so many days after 1970-01-01, in the Gregorian calendar.
fn civil(days: u64) -> String {
    let is_leap = |year: u64| year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let (mut year, mut left) = (1970, days);
    while left >= 365 + u64::from(is_leap(year)) {
        left -= 365 + u64::from(is_leap(year));
        year += 1;
    }
    let lengths = [31, 28 + u64::from(is_leap(year)), 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let mut month = 0;
    while left >= lengths[month] {
        left -= lengths[month];
        month += 1;
    }
    format!("{year:04}-{:02}-{:02}", month + 1, left + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_those_of_the_calendar() {
        for (days, date) in [(0, "1970-01-01"), (59, "1970-03-01"), (11_016, "2000-02-29"), (20_786, "2026-11-29")] {
            assert_eq!(civil(days), date);
        }
        assert!(["2026-11-29", "2028-02-29"].iter().all(|text| is_date(text)));
        assert!(
            [
                "2026-02-29",
                "2025-12-31",
                "0001-01-01",
                "2026-11-29T10:00:00",
                "2026-13-01",
                "2026-1-1",
                "26-01-01",
                "2026-01",
                "yesterday"
            ]
            .iter()
            .all(|text| !is_date(text))
        );
    }

    #[test]
    fn an_entry_is_read_as_it_was_written() {
        let head = Head {
            scenario: "s".into(),
            planner: "mine".into(),
            objective: Objective::SliceCost,
            value: 0.1 + 0.2,
            by: "Ada \"the\" 蚁".into(),
            date: "2026-03-21".into(),
            note: "C:\\maps".into(),
        };
        let path = Some(vec![Point::new(0, 1), Point::new(2, 3)]);
        let entry = Entry { kind: Some(PathKind::Steps), path, levels: Some(vec![1, 2]), ..Entry::new(head) };
        assert_eq!(toml::from_str::<Entry>(&entry.text()).as_ref(), Ok(&entry));
    }

    #[test]
    fn files_of_outside_entries_are_called_by_planner_and_name() {
        let name = |by| outside_name("fire", by).ok();
        assert_eq!(name("Ada  Lovelace!").as_deref(), Some("fire--ada-lovelace"));
        assert_eq!(name("蚁群").as_deref(), Some("fire--蚁群"));
        assert_eq!(name("../.."), None);
    }
}
