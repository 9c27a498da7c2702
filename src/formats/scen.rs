//! MovingAI `.scen`: a version line, then one scenario per line: bucket, map, width, height, start x y, goal x y, optimal length.
//!
//! Fields are separated by tabs or spaces. The optimum of a line holds for 8 moves under the corner rule `both-free`.

use serde::Serialize;

use super::text::{lines, quote};
use crate::error::{FormatError, Notice};
use crate::map::{Grid, Point};
use crate::scenario::ScenarioSpec;

/// What a line holds, for error messages.
const FIELDS: &str = "bucket, map, width, height, start x, start y, goal x, goal y, optimal length";

/// Relative slack for optima that were summed up with a rounded √2.
const SLACK: f64 = 1e-6;

/// One scenario of a `.scen` file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ScenLine {
    /// Its line in the file, from 1.
    pub line: u32,
    /// The optimal length divided by 4, as a class of difficulty.
    pub bucket: u32,
    /// The map's file name, perhaps with folders.
    pub map: String,
    /// Width of the map in cells.
    pub width: u32,
    /// Height of the map in cells.
    pub height: u32,
    /// Start cell.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number]"))]
    pub start: Point,
    /// Goal cell.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number]"))]
    pub goal: Point,
    /// Listed length of the shortest path, in cells; 0 between different cells where it is not known.
    pub optimal: f64,
    /// How far a length may be from the listed one and still be the same: half a unit of its last digit, and 1e-6 of it.
    pub tolerance: f64,
}

impl ScenLine {
    /// Whether the line lists no optimum: 0 between different cells, as generators without a solver write it.
    pub fn is_unlisted(&self) -> bool {
        self.optimal == 0.0 && self.start != self.goal
    }

    /// Whether a length is the listed one within the digits that were printed.
    pub fn fits(&self, length: f64) -> bool {
        (length - self.optimal).abs() <= self.tolerance
    }
}

/// A `.scen` file as read.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ScenFile {
    /// Its scenarios, in file order.
    pub lines: Vec<ScenLine>,
    /// What was accepted with a remark.
    #[serde(rename = "warnings")]
    pub notices: Vec<Notice>,
}

/// Whether the text begins with a version line.
pub(super) fn has_version(text: &str) -> bool {
    first_line(text).is_some_and(|(_, line)| version(line).is_some())
}

/// Whether the first line has the fields of a scenario.
pub(super) fn has_fields(text: &str) -> bool {
    first_line(text).is_some_and(|(number, line)| parse(number, line).is_ok())
}

fn first_line(text: &str) -> Option<(usize, &str)> {
    lines(text).find(|(_, line)| !line.trim().is_empty())
}

/// The version of a line `version 1`.
fn version(line: &str) -> Option<&str> {
    let mut words = line.split_whitespace();
    let key = words.next()?;
    let number = words.next()?;
    (key.eq_ignore_ascii_case("version") && number.starts_with(|c: char| c.is_ascii_digit())).then_some(number)
}

/// Reads a `.scen`.
///
/// # Errors
/// [`FormatError`] with the line at fault, or [`FormatError::Version`].
pub(super) fn read(text: &str) -> Result<ScenFile, FormatError> {
    let mut found = Vec::new();
    let mut notices = Vec::new();
    for (index, (number, line)) in lines(text).filter(|(_, l)| !l.trim().is_empty()).enumerate() {
        match version(line) {
            Some(v) if index == 0 && v.parse() == Ok(1.0) => {}
            Some(v) if index == 0 => {
                return Err(FormatError::Version { found: format!("version {}", quote(v)), expected: "version 1" });
            }
            _ if index == 0 => {
                notices.push(Notice::new("scen-version", "the first line names no version; the file was read as version 1"));
                found.push(parse(number, line)?);
            }
            _ => found.push(parse(number, line)?),
        }
    }
    if found.is_empty() {
        return Err(FormatError::syntax(0, "the file holds no scenario", FIELDS));
    }
    let precision = Precision::of(&found);
    let unlisted = found.iter().filter(|l| l.line.is_unlisted()).count();
    if unlisted > 0 {
        let message = format!("{unlisted} scenarios list an optimum of 0 between different cells: it counts as unknown");
        notices.push(Notice::new("scen-unlisted", message).with("count", unlisted));
    }
    let lines = found.into_iter().map(|l| l.finish(precision)).collect();
    Ok(ScenFile { lines, notices })
}

/// A line before the precision of its file is known.
struct Raw {
    line: ScenLine,
    decimals: u32,
}

impl Raw {
    fn finish(mut self, precision: Precision) -> ScenLine {
        self.line.tolerance = precision.half_unit(&self.line, self.decimals) + SLACK * self.line.optimal;
        self.line
    }
}

/// With how many digits a file prints its optima. Writers either print a fixed number of decimals (`16.00000000`) or a number
/// of significant digits without trailing zeros (`3.41421`, `123.456`, `3`), where few decimals do not mean a rough number.
#[derive(Clone, Copy)]
enum Precision {
    Decimals,
    Significant(u32),
}

impl Precision {
    fn of(lines: &[Raw]) -> Self {
        let fixed = lines[0].decimals;
        if fixed >= 2 && lines.iter().all(|l| l.decimals == fixed) {
            return Self::Decimals;
        }
        let digits = lines.iter().map(|l| l.decimals + whole_digits(l.line.optimal)).max();
        Self::Significant(digits.unwrap_or(0).clamp(6, 15))
    }

    fn half_unit(self, line: &ScenLine, decimals: u32) -> f64 {
        let decimals = match self {
            Self::Decimals => decimals,
            Self::Significant(digits) => digits.saturating_sub(whole_digits(line.optimal)).max(decimals),
        };
        (0..decimals).fold(0.5, |unit, _| unit / 10.0)
    }
}

fn whole_digits(value: f64) -> u32 {
    let mut digits = 1;
    let mut rest = value / 10.0;
    while rest >= 1.0 && digits < 15 {
        digits += 1;
        rest /= 10.0;
    }
    digits
}

/// Reads one line: nine fields between tabs, or between blanks with everything between the first and the last seven as the map.
fn parse(number: usize, line: &str) -> Result<Raw, FormatError> {
    let wrong = |what: String| FormatError::syntax(number, what, FIELDS);
    let mut fields: Vec<&str> = line.split('\t').map(str::trim).filter(|f| !f.is_empty()).collect();
    if fields.len() != 9 {
        fields = line.split_whitespace().collect();
    }
    if fields.len() < 9 {
        return Err(wrong(format!("the line has {} fields where 9 are needed", fields.len())));
    }
    let tail = fields.len() - 7;
    let whole = |i: usize| -> Result<u32, FormatError> {
        fields[i].parse().map_err(|_| wrong(format!("`{}` is no whole number", quote(fields[i]))))
    };
    let point = |i| Ok::<_, FormatError>(Point::new(whole(i)?, whole(i + 1)?));
    let listed = fields[tail + 6];
    let optimal = listed.parse().ok().filter(|v: &f64| v.is_finite() && *v >= 0.0);
    let optimal = optimal.ok_or_else(|| wrong(format!("`{}` is no length", quote(listed))))?;
    let line = ScenLine {
        line: u32::try_from(number).unwrap_or(u32::MAX),
        bucket: whole(0)?,
        map: fields[1..tail].join(" "),
        width: whole(tail)?,
        height: whole(tail + 1)?,
        start: point(tail + 2)?,
        goal: point(tail + 4)?,
        optimal,
        tolerance: 0.0,
    };
    let decimals = listed.split_once('.').map_or(0, |(_, d)| d.len().min(15) as u32);
    Ok(Raw { line, decimals })
}

/// What does not fit between a scenario and its map: another size, or an end outside or on an obstacle.
pub fn misfit(line: &ScenLine, grid: &Grid) -> Option<Notice> {
    let number = line.line;
    if (line.width, line.height) != (grid.width(), grid.height()) {
        let size = format!("{} × {}", line.width, line.height);
        let message = format!("line {number}: made for a map of {size} cells, not of {} × {}", grid.width(), grid.height());
        return Some(Notice::new("scen-size", message).with("line", number).with("size", size));
    }
    for (role, p) in [("start", line.start), ("goal", line.goal)] {
        let place = match grid.is_free_at(i64::from(p.x), i64::from(p.y)) {
            true => continue,
            false if grid.contains(p) => "lies on a blocked cell",
            false => "lies outside the map",
        };
        let message = format!("line {number}: the {role} ({}, {}) {place}", p.x, p.y);
        let kind = if grid.contains(p) { "scen-end-blocked" } else { "scen-end-outside" };
        return Some(Notice::new(kind, message).with("line", number).with("role", role).with("x", p.x).with("y", p.y));
    }
    None
}

/// Checks every scenario of a file against the map: one notice for each that does not fit. Some published files
/// (Warcraft III) have ends on walls.
pub fn check_scen(file: &ScenFile, grid: &Grid) -> Vec<Notice> {
    file.lines.iter().filter_map(|line| misfit(line, grid)).collect()
}

/// One scenario with its exact optimum as a `.scen` file.
pub(super) fn write(spec: &ScenarioSpec, optimal: f64) -> String {
    let goal = spec.goals.first().map_or(spec.start, |g| g.at);
    let name: String = spec.name.chars().map(|c| if c.is_control() { '_' } else { c }).collect();
    let name = name.trim().trim_end_matches(".map");
    let name = if name.is_empty() { "map" } else { name };
    let (start, bucket) = (spec.start, (optimal / 4.0) as u32);
    format!(
        "version 1\n{bucket}\t{name}.map\t{}\t{}\t{}\t{}\t{}\t{}\t{optimal:.8}\n",
        spec.width, spec.height, start.x, start.y, goal.x, goal.y
    )
}
