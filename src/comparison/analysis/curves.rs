//! What becomes of runs while effort is spent: the band of their best so far, the share of targets that they have reached (ECDF), and the
//! expected running time of each target.

use serde::Serialize;

use super::TARGET_GAPS;
use crate::comparison::budget::Axis;
use crate::comparison::gap::reaches;
use crate::comparison::samples::Seen;
use crate::comparison::statistics::{quantile, sorted};

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

/// The effort until a run found its best path; none without one, or where it is not told.
pub(super) fn to_best(seen: Seen, axis: Axis) -> Option<f64> {
    seen.row.found?;
    at(seen, seen.row.trace.len().checked_sub(1)?, axis)
}

/// The effort of a whole run.
pub(super) fn end(seen: Seen, axis: Axis) -> Option<f64> {
    if axis == Axis::Time { seen.seconds.last().copied() } else { seen.row.effort.on(axis) }
}

/// The effort until an improvement.
fn at(seen: Seen, improvement: usize, axis: Axis) -> Option<f64> {
    if axis == Axis::Time {
        // The last one is the end of the run.
        return seen.seconds.get(improvement).copied().filter(|_| improvement + 1 < seen.seconds.len());
    }
    seen.row.trace.get(improvement)?.spent.on(axis)
}

/// The improvements of one run as (effort, value), and its whole effort.
struct Course {
    steps: Vec<(f64, f64)>,
    end: Option<f64>,
}

impl Course {
    /// None where the run found a path and does not tell when, and where it spends nothing on this axis. Of an effort beyond the budget only
    /// what the budget allows counts: what the last iteration found does not, either.
    fn of(seen: Seen, axis: Axis, most: f64) -> Option<Self> {
        let (trace, end) = (&seen.row.trace, end(seen, axis).map(|end| end.min(most)));
        if end == Some(0.0) && axis != Axis::Time {
            return None;
        }
        if seen.row.found.is_none() {
            return Some(Self { steps: Vec::new(), end });
        }
        let steps: Option<Vec<_>> = trace.iter().enumerate().map(|(i, step)| Some((at(seen, i, axis)?, step.value))).collect();
        steps.filter(|steps| !steps.is_empty()).map(|steps| Self { steps, end })
    }

    /// The value of what the run would have answered after some effort.
    fn value(&self, x: f64) -> f64 {
        let known = self.steps.partition_point(|step| step.0 <= x);
        known.checked_sub(1).and_then(|last| self.steps.get(last)).map_or(f64::INFINITY, |step| step.1)
    }

    /// The effort until a target is reached for good: a planner that chooses by length before refinement may give up a better answer.
    fn hit(&self, target: f64) -> Option<f64> {
        let reaching = self.steps.iter().rev().take_while(|step| reaches(step.1, target));
        reaching.last().map(|step| step.0)
    }

    /// The effort to the end, or as much of it as is known.
    fn last(&self) -> Option<f64> {
        self.end.or_else(|| self.steps.last().map(|step| step.0))
    }
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

/// Quartiles over all runs, those without a path so far and those that have ended among them.
fn band(courses: &[Course]) -> Vec<BandPoint> {
    let events = courses.iter().flat_map(|c| c.steps.iter().map(|step| step.0));
    let mut sample = vec![0.0; courses.len()];
    let mut point = |x: f64| {
        courses.iter().zip(&mut sample).for_each(|(course, value)| *value = course.value(x));
        sample.sort_unstable_by(f64::total_cmp);
        let at = |p| quantile(&sample, p).filter(|v| v.is_finite());
        BandPoint { x, lower: at(0.25), median: at(0.5), upper: at(0.75) }
    };
    thinned(events.chain(longest(courses)).collect(), BAND_POINTS).into_iter().map(&mut point).collect()
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
    let spent = |course: &Course| course.hit(target).or(course.end);
    let total = courses.and_then(|courses| courses.iter().map(spent).sum::<Option<f64>>());
    RunningTime { target, gap, successes, expected: total.filter(|_| successes > 0).map(|total| total / successes as f64) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::comparison::row::{Found, Improvement, Row, Spent, Task};
    use crate::planner::Status;

    /// A run with improvements (constructed paths, value) that ends after some paths.
    fn run(steps: &[(u64, f64)], end: u64) -> Row {
        let spent = |paths| Spent { constructed_paths: Some(paths), ..Spent::default() };
        let found = |&(_, v): &(u64, f64)| Found { length: v, turns: None, turn_index: None, weight: None, value: v };
        Row {
            task: Task { instance: 0, entry: 0, seed: 1 },
            status: Status::BudgetSpent,
            found: steps.last().map(found),
            effort: spent(end),
            trace: steps.iter().map(|&(paths, value)| Improvement { value, spent: spent(paths) }).collect(),
            digest: String::new(),
        }
    }

    fn four() -> [Row; 4] {
        [
            run(&[(10, 12.0), (30, 10.5), (50, 10.0)], 100),
            run(&[(20, 11.5), (60, 10.1)], 100),
            run(&[], 80),
            run(&[(40, 10.0)], 40),
        ]
    }

    fn curves(rows: &[Row]) -> Curves {
        let runs: Vec<Seen> = rows.iter().map(Seen::from).collect();
        Curves::of(&runs, Axis::ConstructedPaths, &targets(10.0), f64::INFINITY)
    }

    #[test]
    fn expected_running_times_by_hand() {
        // Until 12: (10 + 20 + 80 + 40) / 3. Until 11 and 10.5: (30 + 60 + 80 + 40) / 3. Until 10.2 and 10.1: (50 + 60 + 80 + 40) / 3.
        // Until 10: (50 + 100 + 80 + 40) / 2. The run without a path spends its 80 in each.
        let times = curves(&four()).running_times;
        let expected: Vec<f64> = times.iter().map(|t| t.expected.unwrap()).collect();
        assert_eq!(expected, [50.0, 70.0, 70.0, 230.0 / 3.0, 230.0 / 3.0, 135.0]);
        assert_eq!(times.iter().map(|t| t.successes).collect::<Vec<_>>(), [3, 3, 3, 3, 3, 2]);
        assert_eq!(times.iter().map(|t| t.gap).collect::<Vec<_>>(), TARGET_GAPS);
        // Nobody arrives: no expectation. Nobody tells the effort of one run: none either.
        assert_eq!(curves(&[run(&[], 80)]).running_times[0].expected, None);
        let silent = Row { effort: Spent::default(), ..run(&[], 0) };
        assert_eq!(
            curves(&[run(&[(10, 10.0)], 20), silent]).running_times[0],
            RunningTime { target: 12.0, gap: 0.2, successes: 1, expected: None }
        );
    }

    #[test]
    fn an_answer_that_is_given_up_reaches_nothing() {
        // Refined after each improvement: 10.1 at 20 is given up at 40 for 10.6, which stays.
        let times = curves(&[run(&[(10, 11.5), (20, 10.1), (40, 10.6)], 100)]).running_times;
        // Targets 12, 11, 10.5: for good at 10, at 20, never.
        let expected: Vec<_> = times[..3].iter().map(|t| (t.successes, t.expected)).collect();
        assert_eq!(expected, [(1, Some(10.0)), (1, Some(20.0)), (0, None)]);
    }

    #[test]
    fn effort_counts_up_to_the_budget_and_only_where_there_is_any() {
        let rows = [run(&[(10, 10.0)], 90), run(&[(10, 13.0)], 120)];
        let runs: Vec<Seen> = rows.iter().map(Seen::from).collect();
        let curves = Curves::of(&runs, Axis::ConstructedPaths, &targets(10.0), 100.0);
        // (10 + 100) / 1: the second run's last iteration went beyond.
        assert_eq!((curves.running_times[0].expected, curves.band.last().map(|p| p.x)), (Some(110.0), Some(100.0)));
        let idle = [run(&[(0, 10.0)], 0)];
        let runs: Vec<Seen> = idle.iter().map(Seen::from).collect();
        let curves = Curves::of(&runs, Axis::ConstructedPaths, &targets(10.0), f64::INFINITY);
        assert_eq!((curves.running_times[0].successes, curves.running_times[0].expected, curves.band.len()), (1, None, 0));
    }

    #[test]
    fn shares_of_targets_by_hand() {
        // 4 runs and 6 targets: at 10 and 20 the easiest one; at 30 two more of the first run; at 40 all six of the last; …
        let steps: Vec<(f64, f64)> = curves(&four()).ecdf.iter().map(|p| (p.x, p.share * 24.0)).collect();
        assert_eq!(steps, [(10.0, 1.0), (20.0, 2.0), (30.0, 4.0), (40.0, 10.0), (50.0, 13.0), (60.0, 17.0), (100.0, 17.0)]);
        let nothing = curves(&[run(&[], 80)]);
        assert_eq!(nothing.ecdf, [EcdfPoint { x: 80.0, share: 0.0 }]);
    }

    #[test]
    fn the_band_by_hand() {
        // Sorted: at 20 11.5, 12, ∞, ∞: lower 11.5 + 0.75 · 0.5. At 40 10, 10.5, 11.5, ∞: median 11; the upper quartile lies towards ∞.
        let band: Vec<_> = curves(&four()).band.iter().map(|p| (p.x, p.lower, p.median, p.upper)).collect();
        assert_eq!(
            band,
            [
                (10.0, None, None, None),
                (20.0, Some(11.875), None, None),
                (30.0, Some(11.25), None, None),
                (40.0, Some(10.375), Some(11.0), None),
                (50.0, Some(10.0), Some(10.75), None),
                (60.0, Some(10.0), Some(10.05), None),
                (100.0, Some(10.0), Some(10.05), None),
            ]
        );
    }

    #[test]
    fn runs_that_do_not_tell_when_have_no_curves() {
        let silent = Row { trace: Vec::new(), ..run(&[(10, 10.0)], 20) };
        let of = curves(&[run(&[(10, 12.0)], 20), silent]);
        assert!(of.band.is_empty() && of.ecdf.is_empty());
        // But whether it has reached a target it does tell.
        assert_eq!(of.running_times.iter().map(|t| t.successes).collect::<Vec<_>>(), [2, 1, 1, 1, 1, 1]);
        assert!(of.running_times.iter().all(|t| t.expected.is_none()));
        let empty = curves(&[]);
        assert!(empty.band.is_empty() && empty.ecdf.is_empty() && empty.running_times.iter().all(|t| t.successes == 0));
    }

    #[test]
    fn by_time_the_last_second_is_the_end() {
        let row = run(&[(10, 12.0), (30, 10.0)], 100);
        let seen = Seen { row: &row, seconds: &[0.5, 1.5, 4.0] };
        assert_eq!((to_best(seen, Axis::Time), end(seen, Axis::Time)), (Some(1.5), Some(4.0)));
        let unknown = Seen::from(&row);
        assert_eq!((to_best(unknown, Axis::Time), end(unknown, Axis::Time)), (None, None));
        assert_eq!(to_best(unknown, Axis::ConstructedPaths), Some(30.0));
        assert!(Curves::of(&[unknown], Axis::Time, &targets(10.0), f64::INFINITY).band.is_empty());
    }

    #[test]
    fn many_places_are_thinned_on_a_logarithmic_scale() {
        let thin = thinned((0..=10_000).map(f64::from).collect(), 200);
        assert!((100..=200).contains(&thin.len()) && thin.is_sorted_by(|a, b| a < b), "{}", thin.len());
        assert_eq!((thin[0], thin[1], thin[thin.len() - 1]), (0.0, 1.0, 10_000.0));
        assert_eq!(thinned(vec![3.0, 1.0, 3.0, 2.0], 200), [1.0, 2.0, 3.0]);
        assert!(thinned(vec![], 3).is_empty());
    }
}
