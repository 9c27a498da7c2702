//! Everything that is said about the runs of a comparison, as numbers: what the page draws and what reports print. Every statistic with its
//! formula and source stands in docs/methodology.md.
//!
//! Partial results are fine: whatever is known so far is told. A run without a path is never left out of what can tell of it: it is
//! infinitely long, which is null here.

mod counts;
mod curves;
mod entry;
mod matrix;
mod pairs;
mod published;
mod ranks;
mod verdicts;

use serde::Serialize;

use super::ablation::roles;
use super::budget::Axis;
use super::by_reading::ByReading;
use super::facts::{UnfitMap, unfit};
use super::intervals::Intervals;
use super::judge::{JudgedClaim, judge};
use super::maps::{Map, Yardstick};
use super::measure::RunMeasure;
use super::over_maps::{OverMaps, over_maps};
use super::samples::Samples;

#[cfg(test)]
mod tests;

pub use counts::RunCounts;
pub use curves::{BandPoint, EcdfPoint, RunningTime};
pub use entry::{EntryAnalysis, NoRunningTime, Origin};
pub use matrix::{Matrix, MatrixCell, MatrixRow, Overall, Unranked};
pub use pairs::Pair;
pub use published::PublishedAnalysis;
pub use ranks::{RankPair, Ranks};
pub use verdicts::{VerdictKind, VerdictLine};

/// What the runs of a comparison say.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Analysis {
    /// What effort is counted in.
    pub axis: Axis,
    /// How many runs all that is said is about.
    pub counts: RunCounts,
    /// The maps, in the order of the question.
    pub instances: Vec<MapAnalysis>,
    /// Maps × entries in one table.
    pub matrix: Matrix,
    /// All entries over all maps; null where there is one map or one entry.
    pub ranks: Option<Ranks>,
    /// What became of the claims; none where no intervals were asked for.
    pub verdicts: Vec<VerdictLine>,
    /// The same claims over all of their maps; none where no intervals were asked for.
    pub over_maps: Vec<OverMaps>,
    /// Claims that name a reading of the publication, one row for those that say the same.
    pub by_reading: ByReading,
    /// The maps that contradict what the publication says of its own, as far as the runs tell.
    pub unfit: Vec<UnfitMap>,
    /// What the verdicts follow from.
    #[serde(skip)]
    pub judged: Vec<JudgedClaim>,
}

/// What the runs on one map say.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MapAnalysis {
    /// Id of the instance.
    pub id: String,
    /// The map's name, or the id.
    pub name: String,
    /// What it stands for, and whose it is.
    pub note: String,
    /// What paths are compared by: their length, by slices their cost.
    pub measure: RunMeasure,
    /// The best there is by each objective of an entry, in the order of the entries, with the measure that the objective belongs to.
    pub references: Vec<Yardstick>,
    /// What curves, targets and running times are about: the measure, or where no planner of the map minimises it, what the first one does.
    pub curve_measure: RunMeasure,
    /// Values to be reached, easiest first: the best known value times 1 + each of `target_gaps`. None where no value is known.
    pub targets: Vec<f64>,
    /// Relative distances of the targets from the best known value.
    pub target_gaps: Vec<f64>,
    /// Where the bins of `gap_counts` begin; each ends where the next one begins, the last one never.
    pub gap_edges: Vec<f64>,
    /// Whether the entries make different things small here.
    pub mixed_objectives: bool,
    /// One for each entry of the question.
    pub entries: Vec<EntryAnalysis>,
    /// Every two entries that have runs here, none of them impossible.
    pub pairs: Vec<Pair>,
}

/// Relative distances of the targets from the best known value.
pub const TARGET_GAPS: [f64; 6] = [0.2, 0.1, 0.05, 0.02, 0.01, 0.0];

/// What all runs so far say, the imported ones among them. Intervals and verdicts take long, and are told where there is a place to keep
/// them.
pub fn analyse(samples: &Samples, axis: Axis, mut intervals: Option<&mut Intervals>) -> Analysis {
    let comparison = samples.comparison();
    let on_map = |map| on_map(samples, map, axis, intervals.as_deref_mut());
    let instances: Vec<MapAnalysis> = (0..comparison.maps.len()).map(on_map).collect();
    let ranked = matrix::Ranked::of(samples);
    let unfit = unfit(samples);
    let judged = intervals.map(|intervals| judge(samples, intervals, &unfit));
    let over_maps = judged.as_ref().map_or_else(Vec::new, |judged| over_maps(&comparison.question, judged));
    let judged = judged.unwrap_or_default();
    let verdicts = judged.iter().filter_map(|c| verdicts::line(&comparison.question, c)).collect();
    let matrix = matrix::matrix(samples, &instances, &ranked);
    Analysis {
        axis,
        counts: RunCounts::of(&instances),
        instances,
        matrix,
        ranks: ranks::over_maps(&ranked),
        verdicts,
        over_maps,
        by_reading: ByReading::of(&comparison.question.claims),
        unfit,
        judged,
    }
}

fn on_map(samples: &Samples, index: usize, axis: Axis, mut intervals: Option<&mut Intervals>) -> MapAnalysis {
    let comparison = samples.comparison();
    let (map, instance) = (&comparison.maps[index], &comparison.question.instances[index]);
    let curve_measure = curve_measure(map, comparison.question.entries.len());
    let targets = samples.best_known(index, curve_measure).map_or_else(Vec::new, curves::targets);
    let gap_edges = entry::gap_edges(samples, index);
    let roles = roles(&comparison.question);
    let about =
        entry::About { samples, map: index, axis, curve_measure, targets: &targets, gap_edges: &gap_edges, roles: &roles };
    let entry = |entry| about.entry(entry, intervals.as_deref_mut());
    let entries = (0..comparison.question.entries.len()).map(entry).collect();
    let named = !map.scenario.spec.name.is_empty();
    MapAnalysis {
        id: instance.id.clone(),
        name: if named { map.scenario.spec.name.clone() } else { instance.id.clone() },
        note: instance.note.clone(),
        measure: map.measure(),
        references: map.yardsticks().to_vec(),
        mixed_objectives: map.yardsticks().len() > 1,
        curve_measure,
        target_gaps: if targets.is_empty() { Vec::new() } else { TARGET_GAPS.to_vec() },
        targets,
        gap_edges,
        entries,
        pairs: pairs::all(samples, index),
    }
}

fn curve_measure(map: &Map, entries: usize) -> RunMeasure {
    let mut all = (0..entries).filter_map(|entry| map.objective(entry)).map(|objective| map.measure_of(objective));
    let first = all.next();
    if first.is_none_or(|m| m == map.measure()) || all.any(|m| m == map.measure()) {
        map.measure()
    } else {
        first.unwrap_or(map.measure())
    }
}

/// What result files are made from: intervals and all, with effort counted as the budget counts it, else in constructed paths.
pub fn whole(samples: &Samples, intervals: &mut Intervals) -> Analysis {
    let budget = samples.comparison().question.budget;
    analyse(samples, budget.map_or(Axis::ConstructedPaths, |b| b.axis), Some(intervals))
}
