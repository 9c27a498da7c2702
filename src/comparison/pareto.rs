//! Trade-offs: which runs no other run beats in every measure, and how much of what can be reached they cover.
//!
//! Of each map: the Pareto front of every entry and of all of them together, over two or three measures that the reader chooses; the
//! hypervolume of each (Zitzler and Thiele 1999) against a stated reference point, as a part of the box between that point and the best
//! value of each measure, so that entries compare; and the part of the joint front that each entry reaches.
//!
//! - A run is a point where it has a path and tells every measure. Values are taken to nine decimals, so that equal paths whose lengths were
//!   added in different orders are one point.
//! - A point dominates another one if it is at least as good in every measure and better in one. Equal points do not dominate each other:
//!   they are one point of the front, and count as reached by every entry that has it.
//! - An entry with an impossible run is left out on that map, as in tests and ranks: its rules were others.

mod asked;
mod front;
mod hypervolume;
#[cfg(test)]
mod tests;

use serde::Serialize;

use super::measure::RunMeasure;
use super::samples::{Samples, Seen};

pub use asked::FrontQuestion;
use front::{Space, distinct, undominated};

/// What the runs on one map trade off.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct MapFronts {
    /// Which instance of the question.
    pub instance: usize,
    /// What is traded off: two or three.
    pub measures: Vec<RunMeasure>,
    /// Of each measure whether more is better.
    pub more_is_better: Vec<bool>,
    /// The best value of each measure over all points; empty where there is none.
    pub best: Vec<f64>,
    /// The reference point; empty where there are no points and none is given.
    pub reference: Vec<f64>,
    /// One for each entry of the question.
    pub entries: Vec<EntryFront>,
    /// Points of the joint front.
    pub joint_points: usize,
    /// Its hypervolume; null where there are no points, or the reference is not worse than the best value in some measure.
    pub joint_hypervolume: Option<f64>,
}

/// What the runs of one entry trade off on a map.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct EntryFront {
    /// Its place in the question.
    pub entry: usize,
    /// Runs that are done.
    pub runs: usize,
    /// Runs that are points: with a path, and every measure known.
    pub told: usize,
    /// Impossible runs: where there are any, the entry has no points.
    pub impossible: usize,
    /// Its points, each once, the best by the first measure first.
    pub points: Vec<FrontPoint>,
    /// Points of its own front.
    pub own: usize,
    /// Of these the points of the joint front.
    pub joint: usize,
    /// Of these the points that no other entry has.
    pub alone: usize,
    /// The part of the joint front that it reaches, 0 to 1; those of all entries can come to more than 1. Null where nothing can
    /// be told.
    pub share: Option<f64>,
    /// Part of the box that its front dominates, 0 to 1; 0 where all its runs are without a path. Null where nothing can be told.
    pub hypervolume: Option<f64>,
    /// Points of its front that are not better than the reference in every measure, and so add nothing to the hypervolume.
    pub beyond: usize,
}

/// What one or more runs came to.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FrontPoint {
    /// By each measure, in its unit.
    pub values: Vec<f64>,
    /// Runs of the entry that came to it.
    pub runs: u32,
    /// Whether it is on the entry's own front.
    pub own: bool,
    /// Whether it is on the joint front.
    pub joint: bool,
}

/// The fronts of every map.
pub fn fronts(samples: &Samples, asked: &FrontQuestion) -> Vec<MapFronts> {
    (0..samples.comparison().maps.len()).map(|map| on_map(samples, asked, map)).collect()
}

fn on_map(samples: &Samples, asked: &FrontQuestion, map: usize) -> MapFronts {
    let entries = samples.comparison().question.entries.len();
    let space = Space::new(&asked.measures);
    let clouds: Vec<Vec<[f64; 3]>> = (0..entries).map(|entry| cloud(samples, &space, map, entry)).collect();
    let all = distinct(clouds.concat());
    let joint = undominated(all.iter().map(|(point, _)| *point));
    let span = space.span(all.iter().map(|(point, _)| *point), asked.reference.as_deref());
    let of_entry = |entry: usize| {
        let mut told = entry_front(&space, &clouds[entry], &joint, span.as_ref());
        told.entry = entry;
        told.runs = samples.of(map, entry).len();
        told.impossible = samples.impossible(map, entry);
        let failed = samples.of(map, entry).iter().filter(|seen| seen.row.found.is_none()).count();
        // Who never arrives reaches nothing, and covers nothing.
        if told.runs > 0 && failed == told.runs {
            told.hypervolume = Some(0.0);
            told.share = (!joint.is_empty()).then_some(0.0);
        }
        told
    };
    let mut of_entries: Vec<EntryFront> = (0..entries).map(of_entry).collect();
    count_alone(&space, &mut of_entries, &joint);
    MapFronts {
        instance: map,
        measures: asked.measures.clone(),
        more_is_better: asked.measures.iter().map(|m| m.more_is_better()).collect(),
        best: span.as_ref().map_or_else(Vec::new, |span| space.natural(span.best)),
        reference: span
            .as_ref()
            .map_or_else(|| asked.reference.clone().unwrap_or_default(), |span| space.natural(span.reference)),
        entries: of_entries,
        joint_points: joint.len(),
        joint_hypervolume: span.as_ref().and_then(|span| span.hypervolume(&joint)),
    }
}

/// The points of an entry's runs, each run for itself; none of an entry that has impossible ones.
fn cloud(samples: &Samples, space: &Space, map: usize, entry: usize) -> Vec<[f64; 3]> {
    if samples.impossible(map, entry) > 0 {
        return Vec::new();
    }
    let comparison = samples.comparison();
    let point = |seen: &Seen| {
        seen.row.found?;
        space.point(|measure| comparison.value(seen.row, measure))
    };
    samples.of(map, entry).iter().filter_map(point).collect()
}

fn entry_front(space: &Space, cloud: &[[f64; 3]], joint: &[[f64; 3]], span: Option<&front::Span>) -> EntryFront {
    let points = distinct(cloud.to_vec());
    let own = undominated(points.iter().map(|(point, _)| *point));
    let on_joint = own.iter().filter(|point| joint.contains(point)).count();
    let some = (!own.is_empty()).then_some(());
    EntryFront {
        entry: 0,
        runs: 0,
        told: cloud.len(),
        impossible: 0,
        own: own.len(),
        joint: on_joint,
        alone: 0,
        share: some.map(|()| on_joint as f64 / joint.len() as f64),
        hypervolume: some.and_then(|()| span?.hypervolume(&own)),
        beyond: span.map_or(0, |span| span.beyond(&own)),
        points: points
            .into_iter()
            .map(|(point, runs)| FrontPoint {
                values: space.natural(point),
                runs,
                own: own.contains(&point),
                joint: joint.contains(&point),
            })
            .collect(),
    }
}

/// How many points of the joint front only one entry has.
fn count_alone(space: &Space, entries: &mut [EntryFront], joint: &[[f64; 3]]) {
    for point in joint {
        let values = space.natural(*point);
        let mut having = entries.iter_mut().filter(|entry| entry.points.iter().any(|p| p.joint && p.values == values));
        if let (Some(only), None) = (having.next(), having.next()) {
            only.alone += 1;
        }
    }
}
