//! The parts of a file: `KEY: value` lines, then sections of data, then EOF.

use super::super::text::{lines, quote};
use super::type_word;
use crate::error::FormatError;

/// Keys of the specification part.
const KEYS: [&str; 10] = [
    "NAME",
    "TYPE",
    "COMMENT",
    "DIMENSION",
    "CAPACITY",
    "EDGE_WEIGHT_TYPE",
    "EDGE_WEIGHT_FORMAT",
    "EDGE_DATA_FORMAT",
    "NODE_COORD_TYPE",
    "DISPLAY_DATA_TYPE",
];

/// Sections of the library's files, read or not.
const SECTIONS: [&str; 8] = [
    "NODE_COORD_SECTION",
    "DISPLAY_DATA_SECTION",
    "EDGE_WEIGHT_SECTION",
    "TOUR_SECTION",
    "FIXED_EDGES_SECTION",
    "EDGE_DATA_SECTION",
    "DEMAND_SECTION",
    "DEPOT_SECTION",
];

const ONLY: &str = "only problems of a single tour are read: TYPE TSP or ATSP";
/// What else the library has: the word of its TYPE, what it is, and what to do.
const FOREIGN: [(&str, &str, &str); 3] = [
    ("CVRP", "a vehicle routing problem (CVRP) of TSPLIB", ONLY),
    ("SOP", "a sequential ordering problem (SOP) of TSPLIB", ONLY),
    ("HCP", "a Hamiltonian cycle problem (HCP) of TSPLIB", ONLY),
];

/// A section: where it begins, and its lines as they stand.
#[derive(Debug, Clone, Copy)]
pub(super) struct Section<'a> {
    pub name: &'a str,
    /// Of its name.
    pub line: usize,
    pub data: &'a str,
}

impl<'a> Section<'a> {
    /// (line, words) of every line that has any.
    pub fn rows(self) -> impl Iterator<Item = (usize, std::str::SplitWhitespace<'a>)> {
        let numbered = lines(self.data).map(move |(line, text)| (self.line + line, text));
        numbered.filter(|(_, text)| !text.trim().is_empty()).map(|(line, text)| (line, text.split_whitespace()))
    }
}

/// A file in its parts. Nothing is copied but the comment.
#[derive(Debug, Default)]
pub(super) struct Parts<'a> {
    values: Vec<(&'a str, &'a str)>,
    pub comment: String,
    sections: Vec<Section<'a>>,
}

/// Longest comment that is kept.
const LONGEST_COMMENT: usize = 1000;

impl<'a> Parts<'a> {
    /// Takes a file apart.
    ///
    /// # Errors
    /// [`FormatError::Foreign`] for a type that is not read, [`FormatError::Syntax`] for what is no line of the format.
    pub fn of(text: &'a str) -> Result<Self, FormatError> {
        let mut parts = Self::default();
        let mut all = lines(text);
        while let Some((number, line)) = all.next() {
            let said = line.trim();
            if said == "EOF" {
                parts.close(text, line);
                parts.check_end(all)?;
                return Ok(parts);
            }
            if said.starts_with(|c: char| c.is_ascii_alphabetic()) {
                parts.close(text, line);
                parts.take(number, said, text, line)?;
            } else if parts.sections.is_empty() && !said.is_empty() {
                return Err(FormatError::syntax(number, format!("`{}` is no key", quote(said)), "KEY: value, or a section"));
            }
        }
        Ok(parts)
    }

    /// A line with a key or the name of a section.
    fn take(&mut self, number: usize, said: &'a str, text: &'a str, line: &str) -> Result<(), FormatError> {
        let (key, rest) = said.split_at(said.find(|c: char| c == ':' || c.is_whitespace()).unwrap_or(said.len()));
        let rest = rest.trim();
        if SECTIONS.contains(&key) && (rest.is_empty() || rest == ":") {
            if self.section(key).is_some() {
                return Err(FormatError::syntax(number, format!("{key} a second time"), "every section once"));
            }
            let begins = (offset(text, line) + line.len()).min(text.len());
            self.sections.push(Section { name: key, line: number, data: after_break(&text[begins..]) });
            return Ok(());
        }
        let Some(value) = rest.strip_prefix(':').map(str::trim).filter(|_| KEYS.contains(&key)) else {
            let expected = format!("a number, a section, or one of {} in capitals with a colon", KEYS.join(", "));
            return Err(FormatError::syntax(number, format!("`{}` is no key", quote(said)), expected));
        };
        if let Some(section) = self.sections.last() {
            let what = format!("{key} stands behind {}", section.name);
            return Err(FormatError::syntax(number, what, "all keys before the data"));
        }
        self.put(number, key, value)
    }

    fn put(&mut self, number: usize, key: &'a str, value: &'a str) -> Result<(), FormatError> {
        if key == "COMMENT" {
            let room = LONGEST_COMMENT.saturating_sub(self.comment.len());
            let gap = if self.comment.is_empty() || room == 0 { "" } else { " " };
            self.comment.extend(gap.chars().chain(value.chars().take(room)));
            return Ok(());
        }
        if self.value(key).is_some() {
            return Err(FormatError::syntax(number, format!("{key} a second time"), "every key once"));
        }
        self.values.push((key, value));
        let word = if key == "TYPE" { type_word(self)? } else { "" };
        if let Some(&(_, found, hint)) = FOREIGN.iter().find(|(foreign, ..)| *foreign == word) {
            return Err(FormatError::Foreign { found, hint: hint.into() });
        }
        if key == "TYPE" && !["TSP", "ATSP", "TOUR"].contains(&word) {
            return Err(FormatError::field("TYPE", format!("`{}` is not known", quote(value)), "TSP or ATSP, in capitals"));
        }
        Ok(())
    }

    /// The section that is open ends before this line.
    fn close(&mut self, text: &'a str, line: &str) {
        if let Some(section) = self.sections.last_mut() {
            let begins = offset(text, section.data);
            let ends = offset(text, line);
            // Only the last one is open: the others end before it.
            if begins + section.data.len() > ends {
                section.data = text.get(begins..ends).unwrap_or("");
            }
        }
    }

    /// Behind EOF nothing may stand; some tours of the library have the end of their data twice.
    fn check_end(&self, rest: impl Iterator<Item = (usize, &'a str)>) -> Result<(), FormatError> {
        let is_tour = self.section("TOUR_SECTION").is_some();
        let is_end = |said: &str| said.is_empty() || (is_tour && (said == "-1" || said == "EOF"));
        match rest.map(|(number, line)| (number, line.trim())).find(|(_, said)| !is_end(said)) {
            Some((number, said)) => {
                Err(FormatError::syntax(number, format!("`{}` stands behind EOF", quote(said)), "nothing there"))
            }
            None => Ok(()),
        }
    }

    /// The value of a key.
    pub fn value(&self, key: &str) -> Option<&'a str> {
        self.values.iter().find(|(found, _)| *found == key).map(|&(_, value)| value)
    }

    /// A section by its name.
    pub fn section(&self, name: &str) -> Option<Section<'a>> {
        self.sections.iter().find(|section| section.name == name).copied()
    }

    /// Refuses other sections than these, and keys of other problems.
    pub fn only(&self, known: &[&str]) -> Result<(), FormatError> {
        if let Some(section) = self.sections.iter().find(|section| !known.contains(&section.name)) {
            let what = format!("{} is not read", quote(section.name));
            return Err(FormatError::syntax(section.line, what, format!("no sections but {}", known.join(", "))));
        }
        match ["CAPACITY", "EDGE_DATA_FORMAT"].into_iter().find(|key| self.value(key).is_some()) {
            Some(key) => Err(FormatError::field(key, "is of no single tour", "a TSP or ATSP without it")),
            None => Ok(()),
        }
    }
}

/// The error for a key or section that is missing.
pub(super) fn missing(what: &'static str, expected: &str) -> FormatError {
    FormatError::field(what, "is missing", expected)
}

/// Where a piece of a text begins in it.
fn offset(text: &str, piece: &str) -> usize {
    piece.as_ptr() as usize - text.as_ptr() as usize
}

/// What follows one line break.
fn after_break(text: &str) -> &str {
    text.strip_prefix("\r\n").or_else(|| text.strip_prefix(['\n', '\r'])).unwrap_or(text)
}

/// A number of a file: finite, and of a size whose sums are finite too.
pub(super) fn number(word: &str, line: usize) -> Result<f64, FormatError> {
    const LARGEST: f64 = 1e12;
    let read = word.parse::<f64>().ok().filter(|x| x.abs() <= LARGEST);
    read.ok_or_else(|| FormatError::syntax(line, format!("`{}` is no number", quote(word)), "a number from −10¹² to 10¹²"))
}
