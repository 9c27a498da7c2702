//! Runs whose courses are written down here.

use super::*;
use crate::comparison::course::{end, to_best};
use crate::comparison::row::{Found, Improvement, Row, Spent, Task};
use crate::planner::Status;

/// A run with improvements (constructed paths, value) that ends after some paths.
fn run(steps: &[(u64, f64)], end: u64) -> Row {
    let spent = |paths| Spent { constructed_paths: Some(paths), ..Spent::default() };
    let found = |&(_, v): &(u64, f64)| Found {
        length: v,
        turns: None,
        turn_index: None,
        weight: None,
        value: v,
        clearance: None,
        driving: None,
    };
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
    [run(&[(10, 12.0), (30, 10.5), (50, 10.0)], 100), run(&[(20, 11.5), (60, 10.1)], 100), run(&[], 80), run(&[(40, 10.0)], 40)]
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

/// The band as it is defined: at each point the quartiles of what all runs would have answered.
fn by_definition(courses: &[Course], points: &[BandPoint]) -> Vec<BandPoint> {
    let answer = |course: &Course, x| {
        let known = course.steps.iter().rev().find(|step| step.0 <= x);
        known.map_or(f64::INFINITY, |step| step.1)
    };
    let point = |x| {
        let sample = sorted(courses.iter().map(|course| answer(course, x)).collect());
        let at = |p| crate::comparison::statistics::quantile(&sample, p).filter(|v| v.is_finite());
        BandPoint { x, lower: at(0.25), median: at(0.5), upper: at(0.75) }
    };
    points.iter().map(|told| point(told.x)).collect()
}

#[test]
fn a_band_of_many_runs_is_what_it_is_by_definition() {
    let mut dice = 7u64;
    let mut next = |below: u64| {
        dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (dice >> 33) % below
    };
    for runs in [1, 2, 3, 50, 400] {
        let mut rows = Vec::new();
        for _ in 0..runs {
            let (mut spent, mut value) = (0, 60.0);
            let mut steps = Vec::new();
            for _ in 0..next(6) {
                // Some improvements come at once, and some answers get worse.
                spent += next(4) * next(300);
                value -= next(40) as f64 / 4.0 - 2.0;
                steps.push((spent, value));
            }
            rows.push(run(&steps, spent + next(50) + 1));
        }
        let seen: Vec<Seen> = rows.iter().map(Seen::from).collect();
        let all: Option<Vec<Course>> = seen.iter().map(|&s| Course::of(s, Axis::ConstructedPaths, f64::INFINITY)).collect();
        let courses = all.unwrap();
        let told = band(&courses);
        assert_eq!(told, by_definition(&courses, &told), "{runs} runs");
    }
}
