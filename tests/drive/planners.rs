//! Who can drive, and what a planner keeps from one planning to the next.

use std::sync::Arc;

use formicarium::drive::{DriveParams, Driver, End};
use formicarium::map::Movement;
use formicarium::params::{Value, Values};
use formicarium::planner::{Layer, Planner};
use formicarium::scenario::{AtEnd, DriveSpec, Scenario};

use super::common::{drawn, random, with_goals};
use super::moving::{track, with};

fn drive(scenario: &Arc<Scenario>, planner: &str, params: DriveParams) -> Driver {
    Driver::new(scenario, planner, None, &Values::new(), 3, params).expect("it can drive")
}

#[test]
fn what_cannot_drive_is_refused_by_name() {
    let scenario = random(12, 0.1, 3, Movement::default());
    let refused = |scenario: &Arc<Scenario>, planner: &str, values: &[(&str, f64)]| {
        let values = values.iter().map(|&(key, value)| (key.to_owned(), Value::from(value))).collect();
        let made = Driver::new(scenario, planner, None, &values, 1, DriveParams::default());
        made.err().map(|error| error.report()).map_or_else(|| "none".into(), |report| format!("{} {}", report.kind, report.field))
    };
    for planner in ["any-angle", "theta-star", "f-rrt-star", "tdi-msaco"] {
        assert_eq!(refused(&scenario, planner, &[]), "drive planner");
    }
    let polylines = [("paths".to_owned(), Value::from("polylines"))].into();
    let bent = Driver::new(&scenario, "formica", None, &polylines, 1, DriveParams::default()).err().expect("no steps");
    assert_eq!((bent.report().kind.as_str(), bent.report().field.as_str()), ("drive", "planner"));
    for planner in ["astar", "formica", "turn-aware", "ship", "acost", "pso", "custom", "fwa-aco"] {
        assert_eq!(refused(&scenario, planner, &[]), "none", "{planner}");
    }
    assert_eq!(refused(&scenario, "ant-system", &[("rho", 2.0)]), "out-of-range rho");
    assert_eq!(refused(&scenario, "a-star", &[]), "unknown-planner planner");
    let two = with_goals(&drawn(&["S.G", "..."], Movement::default()), &[(2, 0), (2, 1)]);
    assert_eq!(refused(&two, "fire", &[]), "drive goals");
}

/// A robot whose colony has planned twice: at the start and after the obstacle has appeared in its way.
fn twice_planned(keep: bool) -> (Driver, f32) {
    let scenario = random(16, 0.0, 5, Movement::default());
    let row: Vec<(u32, u32)> = (4..12).map(|x| (x, 15 - x)).collect();
    let scenario = with(&scenario, DriveSpec { tracks: vec![track(&row, 3, 50, AtEnd::Stay)], ..DriveSpec::default() });
    let mut robot = drive(&scenario, "ant-system", DriveParams { keep, iterations: 8, ..DriveParams::default() });
    while robot.drive().replans == 0 {
        robot.step().expect("it goes on");
    }
    let strongest = strongest(robot.planner().expect("it has planned"));
    (robot, strongest)
}

/// The strongest trail of all.
fn strongest(planner: &dyn Planner) -> f32 {
    let mut trails = Vec::new();
    assert!(planner.layer(Layer::Trail, &mut trails));
    trails.into_iter().fold(0.0, f32::max)
}

#[test]
fn trails_are_kept_from_a_start_that_has_moved_or_are_not() {
    let [(kept, more), (anew, less)] = [true, false].map(twice_planned);
    let iterations = |robot: &Driver| robot.planner().expect("it has planned").effort().iterations;
    assert_eq!((iterations(&kept), iterations(&anew)), (16, 8), "it counts on, or begins with 1");
    assert_eq!(kept.drive().effort.iterations, 16);
    assert_eq!(anew.drive().effort.iterations, 16);
    assert!(more != less, "{more} and {less}");
    let planner = kept.planner().expect("it has planned");
    assert_eq!(planner.best().expect("a path").path.first(), Some(&kept.map().cell(kept.steps()[kept.steps().len() - 2].at)));
}

#[test]
fn a_colony_that_has_spent_all_its_iterations_begins_anew() {
    // Each wait plans once more: 3 plannings of 40,000 iterations are more than a colony counts.
    let scenario = drawn(&["S.#.G"], Movement::default());
    let shut = track(&[(1, 0)], 0, 1, AtEnd::Stay);
    let scenario = with(&scenario, DriveSpec { tracks: vec![shut], ..DriveSpec::default() });
    let params = DriveParams { iterations: 40_000, patience: 3, ..DriveParams::default() };
    let end = drive(&scenario, "ant-system", params).run().end;
    assert_eq!(end, Some(End::Stuck(formicarium::drive::Stuck::NoPath)), "no ant need walk to tell that");
}

#[test]
fn d_star_lite_repairs_where_astar_begins_anew() {
    let scenario = random(60, 0.25, 8, Movement::default());
    let patrol = |y| (20..40).map(|x| (x, y)).collect::<Vec<_>>();
    let tracks = [14, 28, 42].map(|y| track(&patrol(y), 0, 1, AtEnd::BackAndForth)).to_vec();
    let scenario = with(&scenario, DriveSpec { tracks, ..DriveSpec::default() });
    let [repaired, anew, without] = [("d-star-lite", true), ("astar", true), ("d-star-lite", false)].map(|(planner, keep)| {
        let drive = drive(&scenario, planner, DriveParams { keep, ..DriveParams::default() }).run();
        assert_eq!(drive.end, Some(End::Arrived), "{planner}");
        drive
    });
    assert!(repaired.replans > 3, "{} times", repaired.replans);
    let expansions = [&repaired, &anew, &without].map(|drive| drive.effort.cell_expansions);
    assert!(expansions[0] < expansions[1] && 2 * expansions[0] < expansions[2], "{expansions:?}");
    // Without what it keeps it is a search from the goal: of equal paths it may take another.
    assert!((repaired.length - without.length).abs() < 5.0);
}
