//! Files: what a page or a command line is handed, and what it hands out.
//!
//! [`sniff`] tells what a file is by its contents, [`import`] reads a map, [`import_scen`] a list of scenarios, [`read_path`] a
//! path, [`export`] writes. No bytes make any of them panic; what is accepted with a remark comes with a [`Notice`].
//! docs/formats.md describes each format.

mod ends;
mod matrix;
mod movingai;
mod path_list;
mod scen;
mod scenario_json;
mod table;
mod text;

use serde::{Deserialize, Serialize};

use crate::error::{Error, FormatError, Notice};
use crate::map::{Grid, Point};
use crate::scenario::ScenarioSpec;

pub use path_list::{path_kind, read_path};
pub use scen::{ScenFile, ScenLine, check_scen, misfit};

/// What a file is. Serialized as `movingai-map`, `movingai-scen`, `matrix`, `scenario`, `experiment`, `unknown`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Kind {
    /// A map of the MovingAI benchmarks.
    MovingaiMap,
    /// A list of scenarios of the MovingAI benchmarks.
    MovingaiScen,
    /// Numbers in rows and columns.
    Matrix,
    /// A scenario with its map, as JSON.
    Scenario,
    /// An experiment, as JSON.
    Experiment,
    /// None of these.
    Unknown,
}

/// A map with everything that can be planned on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// What the file was.
    pub kind: Kind,
    /// The map.
    pub grid: Grid,
    /// The question asked on it; its name is the file's where the format has none.
    pub spec: ScenarioSpec,
    /// What was assumed, chosen or left out.
    pub notices: Vec<Notice>,
}

impl Imported {
    /// Whether start or goal had to be chosen because the file names none.
    pub fn ends_were_chosen(&self) -> bool {
        self.notices.iter().any(|n| n.kind == ends::CHOSEN)
    }

    /// Swaps free and blocked cells. Ends that the file names stay free, others are chosen anew.
    ///
    /// # Errors
    /// [`FormatError::NoFreeCell`].
    pub fn invert(mut self) -> Result<Self, FormatError> {
        let chosen = self.ends_were_chosen();
        let goal = self.spec.goals.first().map_or(self.spec.start, |g| g.at);
        for cell in 0..self.grid.len() as u32 {
            let point = self.grid.point(cell);
            let is_end = !chosen && (point == self.spec.start || point == goal);
            let blocked = !is_end && !self.grid.is_blocked(cell);
            self.grid.set_blocked(cell, blocked);
        }
        if chosen {
            let ends = ends::complete(&self.grid, None, None)?;
            self.spec = ScenarioSpec { start: ends.start, ..self.spec };
            self.spec.goals.iter_mut().for_each(|g| g.at = ends.goal);
            self.notices.retain(|n| n.kind != ends::CHOSEN);
            self.notices.extend(ends.notice);
        }
        Ok(self)
    }
}

/// A format that can be written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Export {
    /// The cells alone.
    MovingaiMap,
    /// Start and goal alone, with the exact optimum for 8 moves and `both-free`.
    MovingaiScen {
        /// Its length in cells.
        optimal: f64,
    },
    /// The cells alone, as CSV of 0 and 1.
    Matrix,
    /// Everything, as JSON.
    Scenario,
}

/// Tells what a file is. Its contents decide; the name only lets a `.scen` pass that lacks its version line.
pub fn sniff(bytes: &[u8], name: &str) -> Kind {
    text::decode(bytes).map_or(Kind::Unknown, |text| sniff_text(&text, name))
}

fn sniff_text(text: &str, name: &str) -> Kind {
    if text.trim_start().starts_with('{') {
        return sniff_json(text);
    }
    let called_scen = name.to_ascii_lowercase().ends_with(".scen");
    if scen::has_version(text) || (called_scen && scen::has_fields(text)) {
        Kind::MovingaiScen
    } else if movingai::looks_like(text) {
        Kind::MovingaiMap
    } else if table::looks_like(text) {
        Kind::Matrix
    } else {
        Kind::Unknown
    }
}

fn sniff_json(text: &str) -> Kind {
    // Broken JSON still tells what it was meant to be, so that the error is about the line and not about the format.
    let format = scenario_json::format_of(text).unwrap_or_else(|| text.into());
    let place = |word| format.find(word).unwrap_or(usize::MAX);
    let (scenario, experiment) = (place("formicarium/scenario@"), place("formicarium/experiment@"));
    match scenario.cmp(&experiment) {
        std::cmp::Ordering::Less => Kind::Scenario,
        std::cmp::Ordering::Greater => Kind::Experiment,
        std::cmp::Ordering::Equal => Kind::Unknown,
    }
}

/// Reads a map in any format that holds one. Where the file names no start or goal, the cells nearest the upper-left and the
/// lower-right corner of the largest connected region are taken.
///
/// # Errors
/// [`FormatError`]: what is wrong, in which line or field, and what is expected there.
pub fn import(bytes: &[u8], name: &str) -> Result<Imported, Error> {
    let text = text::decode(bytes)?;
    let kind = sniff_text(&text, name);
    let imported = match kind {
        Kind::MovingaiMap => {
            let file = movingai::read(&text)?;
            complete(kind, name, file.grid, None, None, file.notices)?
        }
        Kind::Matrix => {
            let file = matrix::read(&text)?;
            complete(kind, name, file.grid, file.start, file.goal, file.notices)?
        }
        Kind::Scenario => scenario(&text)?,
        Kind::MovingaiScen => return Err(FormatError::NotAMap { found: "a list of MovingAI scenarios" }.into()),
        Kind::Experiment => return Err(FormatError::NotAMap { found: "an experiment" }.into()),
        // An object without a format: the error names what is missing.
        Kind::Unknown if text.trim_start().starts_with('{') => scenario(&text)?,
        Kind::Unknown => return Err(FormatError::Unknown { begins: text::quote(&text) }.into()),
    };
    Ok(imported)
}

fn scenario(text: &str) -> Result<Imported, FormatError> {
    let (grid, spec) = scenario_json::read(text)?;
    Ok(Imported { kind: Kind::Scenario, grid, spec, notices: Vec::new() })
}

fn complete(
    kind: Kind,
    name: &str,
    grid: Grid,
    start: Option<Point>,
    goal: Option<Point>,
    mut notices: Vec<Notice>,
) -> Result<Imported, FormatError> {
    let ends = ends::complete(&grid, start, goal)?;
    notices.extend(ends.notice);
    let spec = ScenarioSpec { name: text::stem(name).into(), ..ScenarioSpec::new(&grid, ends.start, ends.goal) };
    Ok(Imported { kind, grid, spec, notices })
}

/// Reads a MovingAI `.scen`.
///
/// # Errors
/// [`FormatError`] with the line at fault, or an unknown version.
pub fn import_scen(bytes: &[u8]) -> Result<ScenFile, FormatError> {
    scen::read(&text::decode(bytes)?)
}

/// Writes a scenario, or its map alone, as text.
pub fn export(grid: &Grid, spec: &ScenarioSpec, format: Export) -> String {
    match format {
        Export::MovingaiMap => movingai::write(grid),
        Export::MovingaiScen { optimal } => scen::write(spec, optimal),
        Export::Matrix => matrix::write(grid),
        Export::Scenario => scenario_json::write(grid, spec),
    }
}
