//! Drives that can be followed with a pencil: waiting, giving up, seeing.

use std::sync::Arc;

use formicarium::drive::{Did, Drive, DriveParams, Driver, End, Replan, Stuck};
use formicarium::map::{CornerRule, Movement, Moves, Point};
use formicarium::params::Values;
use formicarium::scenario::{AtEnd, DriveChange, DriveSpec, Robot, Scenario, ScenarioSpec, Track};

use super::common::drawn;
use super::moving::{track, with};

const FOUR: Movement = Movement { moves: Moves::Four, corner_rule: CornerRule::BothFree };

fn driven(scenario: &Arc<Scenario>, params: DriveParams) -> (Drive, String) {
    let mut robot = Driver::new(scenario, "d-star-lite", None, &Values::new(), 1, params).expect("it can drive");
    let drive = robot.run();
    let sign = |did: Did| match did {
        Did::Start => 'S',
        Did::Move => 'm',
        Did::Wait => 'w',
    };
    (drive, robot.steps().iter().map(|step| sign(step.did)).collect())
}

fn tracks(scenario: &Scenario, tracks: Vec<Track>) -> Arc<Scenario> {
    with(scenario, DriveSpec { tracks, ..DriveSpec::default() })
}

fn patient(patience: u32) -> DriveParams {
    DriveParams { patience, ..DriveParams::default() }
}

/// A step, cells that get a wall then, and cells that lose theirs.
type Walls<'a> = (u32, &'a [(u32, u32)], &'a [(u32, u32)]);

fn walls(scenario: &Scenario, changes: &[Walls], sight: Option<f64>) -> Arc<Scenario> {
    let points = |cells: &[(u32, u32)]| cells.iter().map(|&(x, y)| Point::new(x, y)).collect();
    let change = |&(at_step, blocked, freed): &Walls| DriveChange { at_step, blocked: points(blocked), freed: points(freed) };
    with(scenario, DriveSpec { changes: changes.iter().map(change).collect(), tracks: Vec::new(), sight })
}

#[test]
fn it_waits_until_a_door_opens_or_gives_up() {
    let corridor = drawn(&["S...G"], FOUR);
    // At step 1 it stands on (1, 0) and the next cell is shut, from step 4 on it is free again.
    let door = walls(&corridor, &[(1, &[(2, 0)], &[]), (4, &[], &[(2, 0)])], None);
    let (drive, steps) = driven(&door, DriveParams::default());
    assert_eq!((drive.end, &*steps, drive.ratio), (Some(End::Arrived), "Smwwwmmm", Some(1.0)));
    // Planned at the start, when the door shut, and when it opened.
    assert_eq!((drive.moves, drive.waits, drive.replans), (4, 3, 2));
    let (drive, steps) = driven(&door, patient(2));
    assert_eq!((drive.end, &*steps, drive.ratio), (Some(End::Stuck(Stuck::NoPath)), "Smww", None));
    let (drive, steps) = driven(&door, patient(0));
    assert_eq!((drive.end, &*steps), (Some(End::Stuck(Stuck::NoPath)), "Sm"));
    let (drive, steps) = driven(&door, DriveParams { longest: 6, ..DriveParams::default() });
    assert_eq!((drive.end, &*steps), (Some(End::Stuck(Stuck::TooLong)), "Smwwwmm"));
}

#[test]
fn on_the_goal_nobody_stays_for_ever() {
    let corridor = drawn(&["S..G"], FOUR);
    let visitor = |steps| tracks(&corridor, vec![track(&[(3, 0)], 0, steps, AtEnd::Leave)]);
    let (drive, steps) = driven(&visitor(4), DriveParams::default());
    assert_eq!((drive.end, &*steps), (Some(End::Arrived), "Swwwwmmm"));
    // Who knows in advance waits beside the goal, and is there sooner: the length is the same.
    assert_eq!(drive.ratio, Some(1.0));
    assert_eq!(driven(&visitor(40), patient(9)).0.end, Some(End::Stuck(Stuck::GoalTaken)));
}

#[test]
fn a_robot_with_a_radius_keeps_it_and_what_moves_keeps_away_from_it() {
    let room = drawn(&[".......", "S.....G", "......."], FOUR);
    // It comes along the middle row; a robot of one cell's radius has to let it pass, and a room of three rows has no place for both.
    let visitor = track(&[(6, 1), (5, 1), (4, 1), (3, 1), (2, 1), (1, 1), (0, 1)], 0, 1, AtEnd::Leave);
    let moving = tracks(&room, vec![visitor]);
    let robot = |radius| {
        let spec = ScenarioSpec { robot: Some(Robot { radius, inflation: None }), ..moving.spec.clone() };
        Arc::new(Scenario::new(moving.drawn.clone(), spec).expect("it fits"))
    };
    let (point, _) = driven(&robot(0.0), patient(20));
    assert_eq!((point.end, point.moves), (Some(End::Arrived), 8), "around it");
    let round = robot(1.0);
    let mut driver = Driver::new(&round, "d-star-lite", None, &Values::new(), 1, patient(20)).expect("it can drive");
    while driver.step().is_some() {
        let (at, map) = (driver.at(), driver.map());
        let touches = |c: u32| map.is_blocked(c) && map.point(c).x.abs_diff(at.x) + map.point(c).y.abs_diff(at.y) <= 1;
        assert!(!(0..map.len() as u32).any(touches), "step {}", driver.last().step);
    }
    let drive = driver.drive();
    assert_eq!(drive.end, Some(End::Arrived), "once the visitor has left by its timetable");
    assert!(drive.waits > 0 && drive.moves >= 6, "{drive:?}");
}

#[test]
fn a_wall_waits_until_the_robot_has_left_its_cell() {
    let corridor = drawn(&["S...G"], FOUR);
    // Both cells are to be blocked when the robot stands on one of them.
    let shut = walls(&corridor, &[(0, &[(0, 0)], &[]), (2, &[(2, 0), (1, 0)], &[])], None);
    let mut robot = Driver::new(&shut, "astar", None, &Values::new(), 1, DriveParams::default()).expect("it can drive");
    let blocked = |robot: &Driver| (0..5).filter(|&x| robot.map().is_blocked(x)).collect::<Vec<_>>();
    let mut seen = vec![blocked(&robot)];
    while robot.step().is_some() {
        seen.push(blocked(&robot));
    }
    assert_eq!(seen, [vec![], vec![0], vec![0, 1], vec![0, 1, 2], vec![0, 1, 2]]);
    assert_eq!(robot.end(), Some(End::Arrived));
}

#[test]
fn an_obstacle_waits_before_the_robot_and_the_robot_before_it() {
    // They meet in a corridor: the obstacle comes from the goal and cannot pass; it waits at (3, 0), and so does the robot, at (2, 0).
    let corridor = drawn(&["S....G"], FOUR);
    let meeting = tracks(&corridor, vec![track(&[(4, 0), (3, 0), (2, 0), (1, 0), (0, 0)], 0, 1, AtEnd::Leave)]);
    let mut robot = Driver::new(&meeting, "astar", None, &Values::new(), 1, patient(50)).expect("it can drive");
    let mut stood = Vec::new();
    loop {
        stood.push((robot.at().x, (0..6).find(|&x| robot.map().is_blocked(x))));
        if robot.step().is_none() {
            break;
        }
    }
    // No path: it waits at the start, and the obstacle stops beside it until it is to leave at step 5.
    let [a, b] = [(0, Some(1)), (0, None)];
    assert_eq!(stood[..6], [(0, Some(4)), (0, Some(3)), (0, Some(2)), a, a, b]);
    assert_eq!((robot.end(), robot.drive().waits, robot.drive().moves), (Some(End::Arrived), 5, 5));
}

#[test]
fn it_goes_around_or_holds_until_the_way_is_free() {
    let room = drawn(&[".....", "S...G", "....."], FOUR);
    let passing = tracks(&room, vec![track(&[(2, 1)], 1, 3, AtEnd::Leave)]);
    let (around, steps) = driven(&passing, DriveParams::default());
    assert_eq!((around.length, &*steps), (6.0, "Smmmmmm"));
    assert_eq!(around.ratio, Some(1.5));
    let (held, steps) = driven(&passing, DriveParams { hold: 5, replan: Replan::Blocked, ..DriveParams::default() });
    assert_eq!((held.length, &*steps, held.replans, held.ratio), (4.0, "Smwwwmmm", 0, Some(1.0)));
    let (held, _) = driven(&passing, DriveParams { hold: 2, replan: Replan::Blocked, ..DriveParams::default() });
    assert_eq!((held.length, held.waits, held.replans), (6.0, 2, 1), "after two waits it goes around");
    let stays = tracks(&room, vec![track(&[(2, 1)], 1, 1, AtEnd::Stay)]);
    let hopeful = DriveParams { hold: 1000, patience: 7, ..DriveParams::default() };
    assert_eq!(driven(&stays, hopeful).0.end, Some(End::Stuck(Stuck::Held)));
}

#[test]
fn it_takes_a_way_that_opens_only_where_it_plans_whenever_it_learns() {
    let room = drawn(&["S###G", ".....", "....."], FOUR);
    let opens = walls(&room, &[(1, &[], &[(1, 0), (2, 0), (3, 0)])], None);
    let by = |replan| driven(&opens, DriveParams { replan, ..DriveParams::default() }).0;
    // From (0, 1) the open row is no shorter than the one below: both drives are as long, one has planned again.
    let (changed, blocked) = (by(Replan::Changed), by(Replan::Blocked));
    assert_eq!((changed.length, changed.replans, blocked.length, blocked.replans), (6.0, 1, 6.0, 0));
    assert_eq!(changed.clairvoyant.value(), Some(4.0), "who knows waits at the start");
    assert_eq!(changed.ratio, Some(1.5));
    assert_ne!(changed.digest, blocked.digest);
}

#[test]
fn what_is_out_of_sight_is_not_known() {
    // A dead end: the upper row is shut at (6, 0) from the beginning of the drive.
    let rows = ["S.......G", ".#######.", "........."];
    let shut = |sight| walls(&drawn(&rows, FOUR), &[(0, &[(6, 0)], &[])], sight);
    let length = |sight| driven(&shut(sight), DriveParams::default()).0.length;
    assert_eq!(length(None), 12.0);
    // It sees the wall from `sight` cells before it, and turns back from there.
    assert_eq!([5.0, 4.0, 3.0, 2.0].map(|sight| length(Some(sight))), [14.0, 16.0, 18.0, 20.0]);
    assert_eq!(length(Some(6.0)), 12.0);
    assert_eq!(length(Some(0.0)), 20.0, "what its next step can touch it always sees");
    // A visitor stands on (4, 0) for two steps: who sees three cells far waits for it to go, who sees two never knew of it.
    let visit = |sight| {
        let tracks = vec![track(&[(4, 0)], 0, 2, AtEnd::Leave)];
        with(&drawn(&["S....G"], FOUR), DriveSpec { tracks, sight: Some(sight), ..DriveSpec::default() })
    };
    assert_eq!(driven(&visit(3.0), patient(9)).1, "Smwmmmm");
    assert_eq!(driven(&visit(2.0), patient(9)).1, "Smmmmm");
}

#[test]
fn what_it_has_seen_it_believes_until_it_sees_it_again() {
    // An obstacle shuts the upper way while the robot is near and is gone once the robot has turned its back: it drives all the way around.
    let rows = drawn(&["S....G", ".####.", ".####.", "......"], FOUR);
    let drive =
        |steps| DriveSpec { tracks: vec![track(&[(3, 0)], 0, steps, AtEnd::Leave)], sight: Some(2.0), ..DriveSpec::default() };
    let (seen, steps) = driven(&with(&rows, drive(2)), DriveParams::default());
    // It plans again where it sees the obstacle, and at the far end where it sees that there is none.
    assert_eq!((seen.length, &*steps, seen.replans), (13.0, "Smmmmmmmmmmmmm", 2));
    let (gone, _) = driven(&with(&rows, drive(1)), DriveParams::default());
    assert_eq!((gone.length, gone.replans), (5.0, 0));
}
