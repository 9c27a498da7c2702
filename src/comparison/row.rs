//! What one run has come to: a row of the results.

use std::fmt;

use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::budget::Axis;
use super::json;
use super::measure::RunMeasure;
use crate::metrics::Driving;
use crate::planner::{Effort, Status};

/// One run that is to be done; tasks are in the order of the rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Task {
    /// Which instance of the question.
    pub instance: usize,
    /// Which entry.
    pub entry: usize,
    /// Its seed.
    pub seed: u32,
}

/// One run that is done. A run without a path is a row as well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    /// What was run.
    pub task: Task,
    /// How it ended.
    pub status: Status,
    /// What it found.
    pub found: Option<Found>,
    /// What it has spent when it ended.
    pub effort: Spent,
    /// Every improvement of its best path that counts, in the order in which they came; may be empty for a run from elsewhere.
    pub trace: Vec<Improvement>,
    /// Digest over history and best path, 16 hexadecimal digits; empty for a run from elsewhere. Nothing else is read: it goes into tables.
    #[serde(deserialize_with = "digest_text")]
    pub digest: String,
}

/// Reads [`Row::digest`].
fn digest_text<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    let text = String::deserialize(deserializer)?;
    let is_hex = |b: u8| b.is_ascii_digit() || (b'a'..=b'f').contains(&b);
    if text.is_empty() || (text.len() == 16 && text.bytes().all(is_hex)) {
        return Ok(text);
    }
    Err(D::Error::custom("`digest` is neither empty nor 16 hexadecimal digits"))
}

/// The path of a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Found {
    /// Its length in cells.
    pub length: f64,
    /// Its turns.
    pub turns: Option<u32>,
    /// V(d, r) in cells.
    pub turn_index: Option<f64>,
    /// Σ R in cells, of a tour by several goals.
    pub weight: Option<f64>,
    /// Its value by the planner's own objective, in cells.
    pub value: f64,
    /// How it is to drive, where the question or the map's vehicle asks for it; files of before have none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub driving: Option<Driving>,
    /// How far it keeps from obstacles; none of a run from elsewhere, or of one that was recorded before this was told.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clearance: Option<Clearance>,
}

/// How far a path keeps from obstacles, in cells: as [`crate::metrics::Metrics`] measures it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Clearance {
    /// The smallest distance of a cell that it crosses.
    pub least: f64,
    /// The mean over these cells.
    pub mean: f64,
}

/// A better path than before, by what the planner searches for: of one that refines its best path, the length after refinement may rise. In JSON `[value, iterations, constructed paths, ant moves, cell expansions]`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "(f64, Read, Read, Read, Read)", into = "Numbers")]
pub struct Improvement {
    /// Its value by the planner's own objective, in cells.
    pub value: f64,
    /// The iteration that found it, and what had been spent when that one ended.
    pub spent: Spent,
}

/// Largest count that is read, 2⁵³: above it numbers of JSON and of the page are no longer told apart from their neighbours.
pub const MAX_COUNT: u64 = 1 << 53;

/// An effort, as far as it is known; no count is read that is above [`MAX_COUNT`]. In JSON
/// `[iterations, constructed paths, ant moves, cell expansions]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(try_from = "[Read; 4]", into = "[Option<u64>; 4]")]
pub struct Spent {
    /// Finished iterations.
    pub iterations: Option<u64>,
    /// Walks begun and ended.
    pub constructed_paths: Option<u64>,
    /// Moves of ants.
    pub ant_moves: Option<u64>,
    /// Cells taken from the open list of a search.
    pub cell_expansions: Option<u64>,
}

/// As they stand in JSON.
type Numbers = (f64, Option<u64>, Option<u64>, Option<u64>, Option<u64>);

/// A count on its way in, or none.
type Read = Option<Count>;

/// A whole number, or as it is written where it is above [`MAX_COUNT`].
struct Count(Result<u64, String>);

impl<'de> Deserialize<'de> for Count {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_u64(CountVisitor)
    }
}

struct CountVisitor;

impl Visitor<'_> for CountVisitor {
    type Value = Count;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a whole number of at least 0")
    }

    fn visit_u64<E: Error>(self, count: u64) -> Result<Count, E> {
        Ok(Count(if count <= MAX_COUNT { Ok(count) } else { Err(count.to_string()) }))
    }

    /// What no u64 holds comes as a float.
    fn visit_f64<E: Error>(self, count: f64) -> Result<Count, E> {
        if count > MAX_COUNT as f64 {
            return Ok(Count(Err(count.to_string())));
        }
        Err(E::invalid_type(serde::de::Unexpected::Float(count), &self))
    }
}

impl TryFrom<[Read; 4]> for Spent {
    type Error = String;

    fn try_from([iterations, constructed_paths, ant_moves, cell_expansions]: [Read; 4]) -> Result<Self, String> {
        let known = |name: &str, count: Read| {
            let too_large = |count| format!("`{name}` is {count}: counts are read up to {MAX_COUNT}, which is 2^53");
            count.map(|Count(count)| count.map_err(too_large)).transpose()
        };
        Ok(Self {
            iterations: known("iterations", iterations)?,
            constructed_paths: known("constructed_paths", constructed_paths)?,
            ant_moves: known("ant_moves", ant_moves)?,
            cell_expansions: known("cell_expansions", cell_expansions)?,
        })
    }
}

impl TryFrom<(f64, Read, Read, Read, Read)> for Improvement {
    type Error = String;

    fn try_from((value, a, b, c, d): (f64, Read, Read, Read, Read)) -> Result<Self, String> {
        Ok(Self { value, spent: Spent::try_from([a, b, c, d])? })
    }
}

impl From<Improvement> for Numbers {
    fn from(Improvement { value, spent: s }: Improvement) -> Self {
        (value, s.iterations, s.constructed_paths, s.ant_moves, s.cell_expansions)
    }
}

impl From<Spent> for [Option<u64>; 4] {
    fn from(s: Spent) -> Self {
        [s.iterations, s.constructed_paths, s.ant_moves, s.cell_expansions]
    }
}

impl From<Effort> for Spent {
    fn from(effort: Effort) -> Self {
        Self {
            iterations: Some(effort.iterations.into()),
            constructed_paths: Some(effort.constructed_paths),
            ant_moves: Some(effort.ant_moves),
            cell_expansions: Some(effort.cell_expansions),
        }
    }
}

impl Spent {
    /// What it amounts to on an axis; none where that is not known, and by time.
    pub fn on(&self, axis: Axis) -> Option<f64> {
        self.count(axis).map(|n| n as f64)
    }

    /// The same as a whole number.
    pub fn count(&self, axis: Axis) -> Option<u64> {
        match axis {
            Axis::Iterations => self.iterations,
            Axis::ConstructedPaths => self.constructed_paths,
            Axis::AntMoves => self.ant_moves,
            Axis::CellExpansions => self.cell_expansions,
            Axis::Moves => self.ant_moves.zip(self.cell_expansions).map(|(moves, expansions)| moves.saturating_add(expansions)),
            Axis::Time => None,
        }
    }
}

impl Row {
    /// As one line of JSON without its end: what a journal keeps.
    pub fn to_line(&self) -> String {
        json(self)
    }

    /// A measure of the run, none where it is not known: a run from elsewhere may tell no turns. Without a path it is infinite, except for
    /// shares, which are 0, and for ant moves. [`RunMeasure::Optimal`] and [`RunMeasure::ArrivalTime`] are
    /// [`super::Comparison::value`]'s to tell, and a [`RunMeasure::RunningTime`] is all runs' together.
    pub fn value(&self, measure: RunMeasure) -> Option<f64> {
        let of_path = |value: fn(&Found) -> Option<f64>| self.found.as_ref().map_or(Some(f64::INFINITY), value);
        let of_driving = |value: fn(&Driving) -> f64| match &self.found {
            None => Some(f64::INFINITY),
            Some(found) => found.driving.as_ref().map(value),
        };
        let to_best = |axis| match (&self.found, self.trace.last()) {
            (None, _) => Some(f64::INFINITY),
            (Some(_), last) => last?.spent.on(axis),
        };
        match measure {
            RunMeasure::Length => of_path(|f| Some(f.length)),
            RunMeasure::Cost => of_path(|f| Some(f.value)),
            RunMeasure::Turns => of_path(|f| f.turns.map(f64::from)),
            RunMeasure::TurnIndex => of_path(|f| f.turn_index),
            RunMeasure::Turning => of_driving(|d| d.turning),
            RunMeasure::LargestCurvature => of_driving(|d| d.largest_curvature.unwrap_or(f64::INFINITY)),
            RunMeasure::Smoothness => of_driving(|d| d.smoothness),
            RunMeasure::Energy => of_driving(|d| d.energy),
            RunMeasure::Weight => of_path(|f| Some(f.weight.unwrap_or(f64::INFINITY))),
            RunMeasure::MinClearance => of_path(|f| f.clearance.map(|c| c.least)),
            RunMeasure::MeanClearance => of_path(|f| f.clearance.map(|c| c.mean)),
            RunMeasure::IterationOfBest => to_best(Axis::Iterations),
            RunMeasure::PathsToBest => to_best(Axis::ConstructedPaths),
            RunMeasure::AntMoves => self.effort.on(Axis::AntMoves),
            RunMeasure::Success => Some(f64::from(u8::from(self.found.is_some()))),
            RunMeasure::Optimal | RunMeasure::ArrivalTime | RunMeasure::RunningTime => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_itself_again_after_json() {
        let spent = Spent { iterations: Some(3), constructed_paths: Some(60), ant_moves: None, cell_expansions: Some(0) };
        let found =
            Found { length: 27.6, turns: Some(4), turn_index: None, weight: None, value: 27.6, clearance: None, driving: None };
        let task = Task { instance: 0, entry: 2, seed: 7 };
        let trace = vec![Improvement { value: 0.1 + 0.2, spent }];
        let row = Row {
            task,
            status: Status::BudgetSpent,
            found: Some(found),
            effort: spent,
            trace,
            digest: "00ff00ff00ff00ff".into(),
        };
        let json = serde_json::to_string(&row).unwrap();
        assert!(json.contains(r#""trace":[[0.30000000000000004,3,60,null,0]]"#), "{json}");
        assert_eq!(serde_json::from_str::<Row>(&json).unwrap(), row);
        assert!(!json.contains("driving"), "as it was before there was such a measure: {json}");
        let driving = Driving { turning: 1.5, largest_curvature: None, smoothness: 2.5, energy: 30.0 };
        let driven = Row { found: Some(Found { driving: Some(driving), ..found }), ..row.clone() };
        assert_eq!(serde_json::from_str::<Row>(&driven.to_line()).unwrap(), driven);
        assert_eq!((driven.value(RunMeasure::Turning), row.value(RunMeasure::Turning)), (Some(1.5), None));
        assert_eq!(driven.value(RunMeasure::LargestCurvature), Some(f64::INFINITY));
        let imported = json.replace("00ff00ff00ff00ff", "");
        assert_eq!(serde_json::from_str::<Row>(&imported).unwrap().digest, "");
        for digest in ["00ff", "=HYPERLINK(1)  ", "00FF00FF00FF00FF", "00ff00ff00ff00f\\n"] {
            let spoilt = json.replace("00ff00ff00ff00ff", digest);
            assert!(serde_json::from_str::<Row>(&spoilt).unwrap_err().to_string().contains("digest"), "{digest}");
        }
        assert_eq!((spent.on(Axis::ConstructedPaths), spent.on(Axis::Moves), spent.on(Axis::Time)), (Some(60.0), None, None));
        assert_eq!((row.value(RunMeasure::IterationOfBest), row.value(RunMeasure::TurnIndex)), (Some(3.0), None));
    }

    #[test]
    fn counts_that_numbers_of_json_do_not_hold_are_refused_by_name() {
        let read = |text: &str| serde_json::from_str::<Spent>(text).map_err(|e| e.to_string());
        let most = read("[9007199254740992,0,null,1]").unwrap();
        assert_eq!((most.iterations, most.ant_moves), (Some(MAX_COUNT), None));
        for count in ["9007199254740993", "18446744073709551615", "18446744073709551616", "1e300"] {
            for (at, name) in ["iterations", "constructed_paths", "ant_moves", "cell_expansions"].into_iter().enumerate() {
                let counts: Vec<&str> = (0..4).map(|i| if i == at { count } else { "1" }).collect();
                let (spent, counts) = (read(&format!("[{}]", counts.join(","))), counts.join(","));
                let step = serde_json::from_str::<Improvement>(&format!("[1.5,{counts}]")).map_err(|e| e.to_string());
                for error in [spent.unwrap_err(), step.unwrap_err()] {
                    assert!(error.contains(&format!("`{name}` is")) && error.contains("2^53"), "{error}");
                }
            }
        }
        for wrong in ["[1.5,1,1,1]", "[-1,1,1,1]", "[\"1\",1,1,1]", "[1,1,1]"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }
}
