use super::*;
use crate::map::{Grid, Movement};
use crate::scenario::{Goal, Robot, ScenarioSpec};

/// A wall with a gap below.
fn scenario() -> Arc<Scenario> {
    let grid = Grid::from_bytes(4, 3, &[0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0]).expect("a rectangle");
    Arc::new(Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(3, 0)).expect("usable"))
}

fn colony(params: &Values) -> Recipe<'_> {
    Recipe { planner: "ant-system", params, seed: 3 }
}

#[test]
fn ids_are_those_of_files() {
    for objective in Objective::ALL {
        assert_eq!(serde_json::to_value(objective).expect("a word"), objective.id());
    }
}

#[test]
fn a_run_comes_out_again() {
    let (scenario, params) = (scenario(), Values::new());
    let (whole, measured) = run(&scenario, colony(&params), None).expect("runs");
    assert_eq!(repeat(&scenario, colony(&params), &whole).ok(), measured);
    let (short, same) = shortest_run(&scenario, colony(&params)).expect("runs");
    assert!(short.iterations < whole.iterations && same == measured, "{short:?}");
    assert_eq!(repeat(&scenario, colony(&params), &short).ok(), measured);
}

#[test]
fn changed_numbers_are_refused_by_name() {
    let (scenario, params) = (scenario(), Values::new());
    let (run, _) = shortest_run(&scenario, colony(&params)).expect("runs");
    let refusal = |spoil: &dyn Fn(&mut RecordedRun)| {
        let mut spoiled = run.clone();
        spoil(&mut spoiled);
        repeat(&scenario, colony(&params), &spoiled).expect_err("spoiled").report().field
    };
    assert_eq!(refusal(&|run| run.digest = "feedfacecafebeef".into()), "digest");
    assert_eq!(refusal(&|run| run.iterations += 1), "digest");
    assert_eq!(refusal(&|run| run.status = Status::Optimal), "status");
    assert_eq!(refusal(&|run| run.length = Some(1.0)), "length");
    let other = Recipe { seed: 4, ..colony(&params) };
    assert!(matches!(repeat(&scenario, other, &run), Err(BestKnownError::Digest { .. })));
}

fn path(cells: &[(u32, u32)], kind: PathKind) -> ClaimedPath {
    ClaimedPath { kind, places: cells.iter().map(|&(x, y)| (Point::new(x, y), None)).collect() }
}

#[test]
fn paths_are_walked_and_measured() {
    let scenario = scenario();
    let around = path(&[(0, 0), (0, 1), (0, 2), (1, 2), (2, 2), (3, 1), (3, 0)], PathKind::Steps);
    assert_eq!(around.usual_objective(&scenario), Objective::Length);
    let measured = around.measure(&scenario, Objective::Length).expect("a path");
    assert!((measured.value - (5.0 + 2.0_f64.sqrt())).abs() < 1e-12, "{measured:?}");
    assert!(around.measure(&scenario, Objective::TurnIndex).expect("a path").value > measured.value);
    let refused = around.measure(&scenario, Objective::TourLength).expect_err("one goal").report();
    assert_eq!((refused.field.as_str(), refused.hint.as_str()), ("objective", "length or turn-index is allowed"));
    let through = path(&[(0, 0), (1, 0), (2, 0), (3, 0)], PathKind::Steps);
    assert!(matches!(through.measure(&scenario, Objective::Length), Err(BestKnownError::Flaw { .. })));
    let corners = path(&[(0, 0), (0, 2), (2, 2), (3, 0)], PathKind::Polyline);
    assert_eq!(corners.usual_objective(&scenario), Objective::PolylineLength);
    assert!(corners.measure(&scenario, Objective::PolylineLength).is_ok());
}

#[test]
fn nothing_is_below_what_is_proven() {
    let proven = Reference::Proven { value: 10.0 };
    assert_eq!(check_bound(10.0 - 1e-10, proven), Ok(()));
    assert_eq!(check_bound(9.9, proven), Err(BestKnownError::Impossible { value: 9.9, optimum: 10.0 }));
    assert_eq!(check_bound(9.9, Reference::Unproven { value: 10.0 }), Ok(()));
    assert_eq!(check_bound(9.9, Reference::NoPath), Err(BestKnownError::NoPath));
}

#[test]
fn scenarios_differ_by_what_runs_depend_on() {
    let one = scenario();
    let with = |spoil: &dyn Fn(&mut ScenarioSpec)| {
        let mut spec = one.spec.clone();
        spoil(&mut spec);
        difference(&one, &Scenario::new(one.grid.clone(), spec).expect("usable"))
    };
    assert_eq!(with(&|spec| spec.name = "other".into()), None);
    assert_eq!(with(&|spec| spec.goals[0].name = "door".into()), None);
    assert_eq!(with(&|spec| spec.goals.push(Goal::new(Point::new(2, 2), ""))), Some("its goals differ"));
    assert_eq!(with(&|spec| spec.start = Point::new(0, 1)), Some("its start differs"));
    assert_eq!(with(&|spec| spec.resolution = 2.0), Some("its metres a cell differ"));
    assert_eq!(with(&|spec| spec.robot = Some(Robot { radius: 0.5, inflation: None })), Some("its robot differs"));
    let dear = one.grid.clone().with_factors(vec![2.0; one.grid.len()]).expect("factors");
    assert_eq!(difference(&one, &Scenario::new(dear, one.spec.clone()).expect("usable")), Some("its cells differ"));
}

#[test]
fn on_weighted_ground_a_path_is_measured_by_its_cost() {
    let grid = Grid::open(3, 1).expect("a row").with_factors(vec![1.0, 3.0, 1.0]).expect("factors");
    let scenario = Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(2, 0)).expect("usable");
    let places = (0..3).map(|x| (Point::new(x, 0), None)).collect();
    let measured = ClaimedPath { kind: PathKind::Steps, places }.measure(&scenario, Objective::Length).expect("a path");
    assert_eq!((measured.objective, measured.value), (Objective::Length, 4.0));
}
