//! Open maps, rows by hand, and fronts against brute force.

use std::sync::Arc;

use rand::RngExt;
use serde_json::json;

use super::front::{Point, Space, distinct, dominates, undominated};
use super::*;
use crate::comparison::row::{Clearance, Found, Row, Spent, Task};
use crate::comparison::{Comparison, Question};
use crate::map::{Grid, Movement, Point as Cell};
use crate::planner::Status;
use crate::rng::Streams;
use crate::scenario::Scenario;

const TURNS: [RunMeasure; 2] = [RunMeasure::Length, RunMeasure::Turns];

/// Three colonies on a corridor whose optimum is 5.
fn comparison() -> Comparison {
    let entry = |id: &str| json!({ "id": id, "label": id, "role": "other", "planner": "ant-system" });
    let question: Question = serde_json::from_value(json!({
        "format": "formicarium/question@1", "title": "t", "asks": "?", "seeds": { "from": 1, "count": 9 },
        "instances": [{ "id": "m", "map": "m.json" }], "entries": [entry("a"), entry("b"), entry("c")]
    }))
    .unwrap();
    let map = Scenario::on(Grid::open(6, 1).unwrap(), Movement::default(), Cell::new(0, 0), Cell::new(5, 0)).unwrap();
    Comparison::new(question, vec![Arc::new(map)]).unwrap()
}

/// Length, turns and mean clearance of a path.
type Path = (f64, u32, f64);

/// A run of an entry, perhaps without a path.
fn row(entry: usize, seed: u32, path: Option<Path>) -> Row {
    let found = path.map(|(length, turns, mean)| Found {
        driving: None,
        length,
        turns: Some(turns),
        turn_index: None,
        weight: None,
        value: length,
        clearance: Some(Clearance { least: 1.0, mean }),
    });
    Row {
        task: Task { instance: 0, entry, seed },
        status: Status::BudgetSpent,
        found,
        effort: Spent::default(),
        trace: Vec::new(),
        digest: String::new(),
    }
}

fn rows(of: &[(usize, &[Path])]) -> Vec<Row> {
    let entry = |&(entry, paths): &(usize, &[Path])| {
        paths.iter().zip(1..).map(|(&path, seed)| row(entry, seed, Some(path))).collect::<Vec<_>>()
    };
    of.iter().flat_map(entry).collect()
}

fn told(rows: &[Row], measures: &[RunMeasure], reference: Option<Vec<f64>>) -> MapFronts {
    let asked = FrontQuestion { measures: measures.to_vec(), reference };
    asked.check().expect("usable");
    let comparison = comparison();
    fronts(&Samples::new(&comparison, rows.iter().map(Seen::from)), &asked).remove(0)
}

fn near(a: Option<f64>, b: f64) -> bool {
    a.is_some_and(|a| (a - b).abs() < 1e-12)
}

#[test]
fn fronts_of_two_measures_by_hand() {
    let rows = rows(&[
        (0, &[(10.0, 4, 1.0), (12.0, 2, 1.0), (12.0, 4, 1.0), (10.0, 4, 1.0)]),
        (1, &[(10.0, 4, 1.0), (14.0, 0, 1.0), (20.0, 9, 1.0)]),
    ]);
    let map = told(&rows, &TURNS, None);
    // Best 10 and 0, worst 20 and 9, a tenth of the way more.
    assert_eq!((map.best.as_slice(), map.more_is_better.as_slice()), (&[10.0, 0.0][..], &[false, false][..]));
    assert!((map.reference[0] - 21.0).abs() < 1e-12 && (map.reference[1] - 9.9).abs() < 1e-12, "{:?}", map.reference);
    assert_eq!(map.joint_points, 3, "(10, 4), (12, 2), (14, 0)");
    let [a, b, c] = &map.entries[..] else { panic!("three entries") };
    assert_eq!((a.told, a.points.len(), a.own, a.joint, a.alone), (4, 3, 2, 2, 1));
    assert_eq!((b.told, b.points.len(), b.own, b.joint, b.alone), (3, 3, 2, 2, 1));
    assert!(near(a.share, 2.0 / 3.0) && near(b.share, 2.0 / 3.0), "(10, 4) counts for both");
    assert_eq!(a.points[0], FrontPoint { values: vec![10.0, 4.0], runs: 2, own: true, joint: true });
    let is_off = |p: &FrontPoint| p.values == [12.0, 4.0] && !p.own && !p.joint;
    assert!(a.points.iter().any(is_off), "dominated by (10, 4) and by (12, 2)");
    // Of a box of 11 × 9.9: (21 − 10)(9.9 − 4) + (21 − 12)(4 − 2), and so on.
    let area = 11.0 * 9.9;
    assert!(near(a.hypervolume, (11.0 * 5.9 + 9.0 * 2.0) / area));
    assert!(near(b.hypervolume, (11.0 * 5.9 + 7.0 * 4.0) / area));
    assert!(near(map.joint_hypervolume, (11.0 * 5.9 + 9.0 * 2.0 + 7.0 * 2.0) / area));
    assert_eq!((c.runs, c.share, c.hypervolume), (0, None, None), "not run");
}

#[test]
fn more_clearance_is_better() {
    let rows = rows(&[(0, &[(10.0, 1, 1.5)]), (1, &[(10.0, 1, 2.5), (9.0, 1, 1.0)])]);
    let map = told(&rows, &[RunMeasure::Length, RunMeasure::MeanClearance], None);
    assert_eq!((map.best.as_slice(), map.more_is_better.as_slice()), (&[9.0, 2.5][..], &[false, true][..]));
    assert!((map.reference[0] - 10.1).abs() < 1e-12 && (map.reference[1] - 0.85).abs() < 1e-12);
    assert_eq!((map.entries[0].joint, map.entries[1].joint, map.joint_points), (0, 2, 2));
    let points: Vec<_> = map.entries[1].points.iter().map(|p| p.values.clone()).collect();
    assert_eq!(points, [vec![9.0, 1.0], vec![10.0, 2.5]], "in their own units");
}

#[test]
fn three_measures_keep_what_two_would_drop() {
    let rows = rows(&[(0, &[(10.0, 2, 1.0)]), (1, &[(11.0, 3, 4.0)])]);
    let measures = [RunMeasure::Length, RunMeasure::Turns, RunMeasure::MeanClearance];
    assert_eq!(told(&rows, &TURNS, None).joint_points, 1);
    let map = told(&rows, &measures, Some(vec![12.0, 4.0, 0.0]));
    assert_eq!((map.joint_points, map.reference.as_slice()), (2, &[12.0, 4.0, 0.0][..]));
    // A box of 2 × 2 × 4.
    assert!(near(map.entries[0].hypervolume, 2.0 * 2.0 * 1.0 / 16.0));
    assert!(near(map.entries[1].hypervolume, 1.0 * 1.0 * 4.0 / 16.0));
    assert!(near(map.joint_hypervolume, (4.0 + 4.0 - 1.0) / 16.0));
}

#[test]
fn a_given_reference_may_leave_points_out() {
    let rows = rows(&[(0, &[(10.0, 4, 1.0), (14.0, 0, 1.0)])]);
    let map = told(&rows, &TURNS, Some(vec![12.0, 8.0]));
    assert_eq!((map.entries[0].own, map.entries[0].beyond), (2, 1));
    assert!(near(map.entries[0].hypervolume, 2.0 * 4.0 / (2.0 * 8.0)));
    // Not worse than the best there is: no box.
    let none = told(&rows, &TURNS, Some(vec![10.0, 8.0]));
    assert_eq!((none.entries[0].hypervolume, none.joint_hypervolume), (None, None));
}

#[test]
fn runs_that_are_all_alike_cover_the_whole_box() {
    let rows = rows(&[(0, &[(10.0, 0, 1.0), (10.0, 0, 1.0)]), (1, &[(10.0 + 1e-13, 0, 1.0)])]);
    let map = told(&rows, &TURNS, None);
    assert_eq!((map.reference.as_slice(), map.joint_points), (&[11.0, 0.1][..], 1), "one point but for a rounding");
    assert!(map.entries[..2].iter().all(|e| e.hypervolume == Some(1.0) && e.share == Some(1.0) && e.alone == 0));
}

#[test]
fn who_never_arrives_covers_nothing_and_who_cannot_be_is_left_out() {
    let mut all = rows(&[(0, &[(10.0, 4, 1.0)]), (2, &[(4.0, 0, 1.0), (10.0, 1, 1.0)])]);
    all.push(row(1, 1, None));
    let map = told(&all, &TURNS, None);
    assert_eq!((map.entries[1].told, map.entries[1].hypervolume, map.entries[1].share), (0, Some(0.0), Some(0.0)));
    let c = &map.entries[2];
    assert_eq!((c.impossible, c.told, c.hypervolume), (1, 0, None), "4 is below the optimum, which is 5");
    assert_eq!((map.best.as_slice(), map.joint_points), (&[10.0, 4.0][..], 1));
    // A measure that no run tells has no points.
    let none = told(&all, &[RunMeasure::TurnIndex, RunMeasure::Turns], None);
    assert_eq!((none.joint_points, none.best.len(), none.joint_hypervolume), (0, 0, None));
    assert_eq!(none.entries[0].share, None);
}

#[test]
fn what_cannot_be_asked_is_refused() {
    let refused = |measures: &[RunMeasure], reference: Option<Vec<f64>>| {
        let asked = FrontQuestion { measures: measures.to_vec(), reference };
        asked.check().expect_err("not usable").report().field
    };
    use RunMeasure::{Length, RunningTime, Success, Turns};
    assert_eq!(refused(&[Length], None), "measures");
    assert_eq!(refused(&[Length, Length], None), "measures");
    assert_eq!(refused(&[Length, Success], None), "measures");
    assert_eq!(refused(&[RunningTime, Turns], None), "measures");
    assert_eq!(refused(&TURNS, Some(vec![1.0])), "reference");
    assert_eq!(refused(&TURNS, Some(vec![1.0, f64::NAN])), "reference");
    assert!(FrontQuestion::default().check().is_ok());
}

#[test]
fn measures_are_offered_where_runs_can_differ_by_them() {
    let offered = FrontQuestion::measures_of(&comparison());
    assert!(!offered.contains(&RunMeasure::Cost) && !offered.contains(&RunMeasure::Weight));
    assert!(FrontQuestion::default().measures.iter().all(|measure| offered.contains(measure)));
    assert_eq!(offered.len(), FrontQuestion::MEASURES.len() - 2);
}

#[test]
fn ids_are_those_of_files() {
    for measure in FrontQuestion::MEASURES {
        assert_eq!(serde_json::to_string(&measure).unwrap(), format!("\"{}\"", measure.id()));
    }
}

#[test]
fn a_front_agrees_with_brute_force() {
    for number in 0..40 {
        let mut stream = Streams::new(1, "fronts", number).daemon(1);
        let places = 2 + number as usize % 2;
        // Few values, so that many are equal.
        let mut place = |i: usize| if i < places { f64::from(stream.random_range(0u32..6)) } else { 0.0 };
        let points: Vec<Point> = (0..25).map(|_| std::array::from_fn(&mut place)).collect();
        let all = distinct(points.clone());
        assert_eq!(all.iter().map(|(_, runs)| *runs).sum::<u32>(), 25);
        let front = undominated(all.iter().map(|(point, _)| *point));
        let mut brute: Vec<Point> = points.iter().copied().filter(|p| !points.iter().any(|q| dominates(q, p))).collect();
        brute.sort_by(|a, b| a.partial_cmp(b).unwrap());
        brute.dedup();
        assert_eq!(front, brute, "{number}");
    }
}

#[test]
fn a_measure_of_which_more_is_better_is_turned_and_back() {
    let measures = [RunMeasure::MeanClearance, RunMeasure::Length];
    let space = Space::new(&measures);
    let point = space.point(|m| Some(if m == RunMeasure::Length { 3.0 } else { 0.0 })).expect("known");
    assert!(point[0].is_sign_positive() && point == [0.0, 3.0, 0.0], "no −0");
    assert_eq!(space.natural([-2.0, 3.0, 0.0]), [2.0, 3.0]);
    assert_eq!(space.point(|m| (m == RunMeasure::Length).then_some(1.0)), None);
    assert_eq!(space.point(|_| Some(f64::INFINITY)), None);
}
