//! How numbers and tables look in a terminal.

use std::fmt::Write;
use std::io;

use crate::error::Notice;
use crate::map::Point;
use crate::metrics::Metrics;
use crate::planner::Objective;
use crate::scenario::Scenario;
use serde::Serialize;
use serde_json::ser::Formatter;

/// How a command answers.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum TextOrJson {
    Text,
    Json,
}

/// JSON for people and programs: fields in their order, one a line down to a depth, everything deeper on one line.
pub fn json(value: &impl Serialize, depth: usize) -> String {
    let mut out = Vec::new();
    let mut serializer = serde_json::Serializer::with_formatter(&mut out, Layout { open: depth, depth: 0, empty: true });
    value.serialize(&mut serializer).expect("plain data can always be written to memory as JSON");
    out.push(b'\n');
    String::from_utf8_lossy(&out).into_owned()
}

/// Breaks lines down to a depth.
struct Layout {
    open: usize,
    depth: usize,
    empty: bool,
}

impl Layout {
    fn begin<W: ?Sized + io::Write>(&mut self, out: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.depth += 1;
        self.empty = true;
        out.write_all(bracket)
    }

    fn item<W: ?Sized + io::Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.empty = false;
        match (first, self.depth <= self.open) {
            (true, true) => out.write_all(b"\n")?,
            (true, false) => {}
            (false, true) => out.write_all(b",\n")?,
            (false, false) => out.write_all(b", ")?,
        }
        self.indent(out)
    }

    fn end<W: ?Sized + io::Write>(&mut self, out: &mut W, bracket: &[u8]) -> io::Result<()> {
        let broken = self.depth <= self.open && !self.empty;
        self.depth -= 1;
        self.empty = false;
        if broken {
            out.write_all(b"\n")?;
            (0..self.depth).try_for_each(|_| out.write_all(b"  "))?;
        }
        out.write_all(bracket)
    }

    fn indent<W: ?Sized + io::Write>(&self, out: &mut W) -> io::Result<()> {
        let columns = if self.depth <= self.open { self.depth } else { 0 };
        (0..columns).try_for_each(|_| out.write_all(b"  "))
    }
}

impl Formatter for Layout {
    fn begin_array<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.begin(out, b"[")
    }
    fn end_array<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.end(out, b"]")
    }
    fn begin_array_value<W: ?Sized + io::Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.item(out, first)
    }
    fn begin_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.begin(out, b"{")
    }
    fn end_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.end(out, b"}")
    }
    fn begin_object_key<W: ?Sized + io::Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.item(out, first)
    }
    fn begin_object_value<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        out.write_all(b": ")
    }
}

/// One aligned line: a label and what belongs to it.
pub fn row(out: &mut String, label: &str, value: impl std::fmt::Display) {
    let _ = writeln!(out, "  {label:<14}{value}");
}

/// 12345678 as 12,345,678.
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

/// `1 turn`, `2 turns`.
pub fn count(n: u64, one: &str, many: &str) -> String {
    format!("{} {}", grouped(n), if n == 1 { one } else { many })
}

/// A relative gap in per cent.
pub fn percent(gap: f64) -> String {
    format!("{:.2} %", 100.0 * gap)
}

/// The same where it is claimed that nothing is more: rounded up.
pub fn percent_at_most(gap: f64) -> String {
    percent(libm::ceil(1e4 * gap) / 1e4)
}

/// Seconds as people say them.
pub fn seconds(s: f64) -> String {
    if s < 120.0 { format!("{s:.2} s") } else { format!("{:.1} min", s / 60.0) }
}

/// A cell as (x, y).
pub fn cell(p: Point) -> String {
    format!("({}, {})", p.x, p.y)
}

/// What an objective is on a scenario: on weighted ground a cost.
pub fn objective(objective: Objective, scenario: &Scenario) -> &'static str {
    if scenario.moves.weights().is_some() { objective.cost_words() } else { objective.words() }
}

/// A length in cells, and where the map has a scale in metres.
pub fn length(cells: f64, scale: Option<f64>) -> String {
    format!("{cells:.4} cells{}", scale.map_or_else(String::new, |metres| format!(" = {:.4} m", metres * cells)))
}

/// The lines about a path, on a map of this scale (see `ScenarioSpec::scale`).
pub fn metrics(out: &mut String, m: &Metrics, scale: Option<f64>) {
    let by_slices = m.terrain.as_ref().and_then(|terrain| terrain.level_cost);
    let unit = match (&m.terrain, by_slices) {
        (_, Some(_)) => "cells and levels",
        (Some(_), None) => "cells along the ground",
        (None, None) => "cells",
    };
    let metres = scale.map_or_else(String::new, |_| format!(" = {:.4} m", m.length_metres));
    row(out, "length", format!("{:.4} {unit}{metres}", m.length));
    if let Some(cost) = m.cost {
        row(out, "cost", format!("{cost:.4} cells: every stretch counts its length times the factor of its cell"));
    }
    if let Some(cost) = by_slices {
        row(out, "level cost", format!("{cost:.4}: every step's length and the level that it leads to"));
    }
    if let Some(terrain) = &m.terrain {
        row(out, "climb", format!("{:.1} m up, {:.1} m down, at most {:.1}°", terrain.climb, terrain.descent, terrain.steepest));
    }
    row(out, "steps", grouped(m.steps.into()));
    row(
        out,
        "turns",
        format!(
            "{}, turn index V = {}",
            m.turns,
            length(m.turn_index, scale.filter(|_| by_slices.is_none() && m.cost.is_none()))
        ),
    );
    row(out, "clearance", clearance(m.min_clearance, m.mean_clearance, scale));
    row(out, "arrival time", seconds(m.travel_time));
    if let Some(driving) = &m.driving {
        super::driving::metrics(out, driving);
    }
}

/// How near a path comes to walls, in cells.
pub fn clearance(least: f64, mean: f64, scale: Option<f64>) -> String {
    let gaps = |metres: f64| format!("at least {:.2}, on average {:.2}", metres * least, metres * mean);
    let metres = scale.map_or_else(String::new, |metres| format!(" = {} m", gaps(metres)));
    format!("{} cells{metres}", gaps(1.0))
}

/// Remarks on one of several files.
pub fn notes_of(file: &str, notices: &[Notice]) {
    for notice in notices {
        super::streams::say(format!("note: {file}: {}", notice.message));
    }
}

/// Remarks, on the error stream: they are no part of a result.
pub fn notes(notices: &[Notice]) {
    for notice in notices {
        super::streams::say(format!("note: {}", notice.message));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_grouped() {
        assert_eq!([0, 999, 1000, 1_234_567].map(grouped), ["0", "999", "1,000", "1,234,567"]);
        assert_eq!(percent(0.0251), "2.51 %");
        assert_eq!([0.0, 0.000_01, 0.02511].map(percent_at_most), ["0.00 %", "0.01 %", "2.52 %"]);
    }

    #[test]
    fn lengths_have_metres_where_the_map_has_a_scale() {
        assert_eq!(length(12.5, None), "12.5000 cells");
        assert_eq!(length(12.5, Some(0.05)), "12.5000 cells = 0.6250 m");
    }

    #[test]
    fn json_is_one_line_below_its_depth() {
        let value = serde_json::json!({ "a": [[0, 1], [1, 2]], "none": [], "x": { "y": null } });
        let wanted = "{\n  \"a\": [\n    [0, 1],\n    [1, 2]\n  ],\n  \"none\": [],\n  \"x\": {\n    \"y\": null\n  }\n}\n";
        assert_eq!(json(&value, 2), wanted);
        assert_eq!(serde_json::from_str::<serde_json::Value>(wanted).ok(), Some(value));
    }
}
