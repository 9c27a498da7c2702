//! What becomes of runs while effort is spent: the band of their best so far, the share of targets that they have reached (ECDF), and the
//! expected running time of each target.

use serde::Serialize;

use super::TARGET_GAPS;
use crate::comparison::budget::Axis;
use crate::comparison::course::Course;
use crate::comparison::gap::reaches;
use crate::comparison::samples::Seen;
use crate::comparison::statistics::{quantile_of, sorted};

/// Most points of a band.
const BAND_POINTS: usize = 200;

/// Most points of an ECDF.
const ECDF_POINTS: usize = 400;

/// Quartiles of what runs would have answered, after some effort. A run without a path so far is infinitely long: null.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct BandPoint {
    /// Effort on the axis; the values hold from here to the next point.
    pub x: f64,
    /// First quartile.
    pub lower: Option<f64>,
    /// The middle.
    pub median: Option<f64>,
    /// Third quartile.
    pub upper: Option<f64>,
}

/// A step of an empirical distribution function.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EcdfPoint {
    /// Effort on the axis.
    pub x: f64,
    /// Share of all (run, target) pairs whose target is reached by then, from here to the next point.
    pub share: f64,
}

/// What reaching a target takes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct RunningTime {
    /// The value.
    pub target: f64,
    /// Its relative distance from the best known one.
    pub gap: f64,
    /// Runs that reached it.
    pub successes: usize,
    /// Expected running time on the axis: the effort of all runs, until they reach it or end, divided by the successes. Null where no run
    /// reaches it, or one does not tell its effort.
    pub expected: Option<f64>,
}

/// The values to be reached.
pub(super) fn targets(best_known: f64) -> Vec<f64> {
    TARGET_GAPS.iter().map(|gap| best_known * (1.0 + gap)).collect()
}

/// What the runs of an entry have come to over the axis.
#[derive(Default)]
pub(super) struct Curves {
    pub band: Vec<BandPoint>,
    pub ecdf: Vec<EcdfPoint>,
    pub running_times: Vec<RunningTime>,
}

impl Curves {
    /// `most`: the budget on this axis; infinite without one.
    pub(super) fn of(runs: &[Seen], axis: Axis, targets: &[f64], most: f64) -> Self {
        let courses: Option<Vec<Course>> = runs.iter().map(|&seen| Course::of(seen, axis, most)).collect();
        let times = |(&target, gap)| running_time(runs, courses.as_deref(), target, gap);
        let running_times = targets.iter().zip(TARGET_GAPS).map(times).collect();
        let known = courses.as_deref().unwrap_or_default();
        Self { band: band(known), ecdf: ecdf(known, targets), running_times }
    }
}

/// Quartiles over all runs, those without a path so far and those that have ended among them. In O(n log n) of all improvements: from point to
/// point only what changes is taken out and put in.
fn band(courses: &[Course]) -> Vec<BandPoint> {
    let events = courses.iter().flat_map(|c| c.steps.iter().map(|step| step.0));
    let points = thinned(events.chain(longest(courses)).collect(), BAND_POINTS);
    let mut values = sorted(courses.iter().flat_map(|c| c.steps.iter().map(|step| step.1)).chain([f64::INFINITY]).collect());
    values.dedup_by(|a, b| a.total_cmp(b).is_eq());
    let place = |value: f64| values.partition_point(|v| v.total_cmp(&value).is_lt());
    let mut now = Ordered::new(values.len());
    now.add(place(f64::INFINITY), courses.len());
    let mut changes: Vec<(usize, usize, usize)> = Vec::new();
    for course in courses {
        let mut before = place(f64::INFINITY);
        let mut at = 0;
        while at < course.steps.len() {
            // The first point at which the step counts, and the last step that counts there.
            let point = points.partition_point(|&x| x < course.steps[at].0);
            let Some(&x) = points.get(point) else { break };
            at += course.steps[at..].iter().take_while(|step| step.0 <= x).count().max(1);
            let after = place(course.steps[at - 1].1);
            changes.push((point, before, after));
            before = after;
        }
    }
    changes.sort_unstable();
    let mut changes = changes.into_iter().peekable();
    let mut told = Vec::with_capacity(points.len());
    for (point, &x) in points.iter().enumerate() {
        while let Some((_, before, after)) = changes.next_if(|change| change.0 <= point) {
            now.remove(before, 1);
            now.add(after, 1);
        }
        let at = |p| quantile_of(courses.len(), p, |k| values[now.nth(k)]).filter(|v| v.is_finite());
        told.push(BandPoint { x, lower: at(0.25), median: at(0.5), upper: at(0.75) });
    }
    told
}

/// How often each of `n` places in an order is taken (Fenwick 1994): counts change, and the k-th is found, in O(log n).
struct Ordered(Vec<usize>);

impl Ordered {
    fn new(places: usize) -> Self {
        Self(vec![0; places.next_power_of_two() + 1])
    }

    fn add(&mut self, place: usize, count: usize) {
        self.change(place, |sum| sum + count);
    }

    fn remove(&mut self, place: usize, count: usize) {
        self.change(place, |sum| sum - count);
    }

    fn change(&mut self, place: usize, to: impl Fn(usize) -> usize) {
        let mut at = place + 1;
        while at < self.0.len() {
            self.0[at] = to(self.0[at]);
            at += at & at.wrapping_neg();
        }
    }

    /// The place of the k-th, from 0.
    fn nth(&self, k: usize) -> usize {
        let (mut place, mut left, mut step) = (0, k, self.0.len() - 1);
        while step > 0 {
            if place + step < self.0.len() && self.0[place + step] <= left {
                place += step;
                left -= self.0[place];
            }
            step /= 2;
        }
        place
    }
}

/// The whole effort of the run that went on longest.
fn longest(courses: &[Course]) -> Option<f64> {
    courses.iter().filter_map(Course::last).reduce(f64::max)
}

/// Over all pairs of a run and a target, as COCO and IOHanalyzer have it.
fn ecdf(courses: &[Course], targets: &[f64]) -> Vec<EcdfPoint> {
    let hits = sorted(courses.iter().flat_map(|c| targets.iter().filter_map(|&t| c.hit(t))).collect());
    let pairs = (courses.len() * targets.len()) as f64;
    if pairs == 0.0 {
        return Vec::new();
    }
    let point = |x| EcdfPoint { x, share: hits.partition_point(|&hit| hit <= x) as f64 / pairs };
    thinned(hits.iter().copied().chain(longest(courses)).collect(), ECDF_POINTS).into_iter().map(point).collect()
}

/// Each place once, ascending. Of more than `most` those before the points of a logarithmic scale, the first and the last among them.
fn thinned(places: Vec<f64>, most: usize) -> Vec<f64> {
    let mut places = sorted(places);
    places.dedup();
    let (Some(&first), Some(&last)) = (places.iter().find(|&&x| x > 0.0), places.last()) else { return places };
    if places.len() <= most {
        return places;
    }
    let (low, high) = (libm::log(first), libm::log(last));
    let before = |i: usize| {
        let x = libm::exp(low + (high - low) * i as f64 / (most - 2) as f64);
        places[places.partition_point(|&place| place <= x).saturating_sub(1)]
    };
    let mut kept: Vec<f64> = places.first().copied().into_iter().chain((0..most - 2).map(before)).chain([last]).collect();
    kept.dedup();
    kept
}

fn running_time(runs: &[Seen], courses: Option<&[Course]>, target: f64, gap: f64) -> RunningTime {
    let reached = |seen: &&Seen| seen.row.found.is_some_and(|f| reaches(f.value, target));
    let successes = runs.iter().filter(reached).count();
    let total = courses.and_then(|courses| courses.iter().map(|course| course.spent(target)).sum::<Option<f64>>());
    RunningTime { target, gap, successes, expected: total.filter(|_| successes > 0).map(|total| total / successes as f64) }
}

#[cfg(test)]
mod tests;
