//! Each planner on the grounds that it claims, and on no other.

use std::sync::Arc;

use formicarium::catalog::{self, CATALOG};
use formicarium::error::ParamError;
use formicarium::map::{Grid, Measure, Movement, Point};
use formicarium::planner::{Ground, PlannerEntry, Status};
use formicarium::scenario::{Goal, Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

use super::common::{drawn, movements, swamp};
use super::terrains::{hilly, hilly_slices, rules, sixteen, slices, surface, without};
use super::{planner, scenarios, short, takes};

/// One scenario of each ground.
fn grounds() -> [Arc<Scenario>; 6] {
    let plane = drawn(&["S...", "...G"], Movement::default());
    let sixteen = drawn(&["S...", "...G"], sixteen()[0]);
    let weighted = [Movement::default(), super::terrains::sixteen()[0]].map(swamp);
    let [few, many] = weighted;
    [plane, hilly(5, 4, 1, 3.0, Movement::default(), 90.0), sixteen, hilly_slices(5, 4, 1, rules(Measure::Cost)), few, many]
}

#[test]
fn a_planner_refuses_the_other_grounds_and_names_who_can() {
    for scenario in grounds() {
        let knows_all = |e: &PlannerEntry| Ground::all_of(&scenario).all(|ground| e.grounds.contains(&ground));
        for entry in CATALOG {
            let built = catalog::build(&scenario, entry.id, None, &short(entry), 1);
            let Some(ground) = Ground::all_of(&scenario).find(|ground| !entry.grounds.contains(ground)) else {
                assert!(built.is_ok(), "{} on {:?}", entry.id, Ground::of(&scenario));
                continue;
            };
            let error = built.err().unwrap_or_else(|| panic!("{} on {ground:?} was accepted", entry.id));
            let ParamError::Ground { planner, others, id, .. } = &error else { panic!("{}: {error}", entry.id) };
            assert_eq!((planner.as_str(), *id), (entry.id, ground.words().0));
            let able: Vec<_> = CATALOG.iter().filter(|e| knows_all(e)).map(|e| e.id).collect();
            assert_eq!(others.split(", ").collect::<Vec<_>>(), able);
            let report = error.report();
            assert!(able.iter().all(|id| report.hint.contains(id)) && report.message.contains(entry.id), "{report:?}");
        }
    }
}

#[test]
fn every_ground_has_a_proven_yardstick_and_a_colony_or_a_swarm() {
    use formicarium::planner::Family;
    for scenario in grounds() {
        let able = |wanted: &[Family]| CATALOG.iter().any(|e| wanted.contains(&e.family) && takes(e, &scenario));
        // With 16 moves and factors at once nobody but the searches knows both.
        let both = Ground::all_of(&scenario).count() > 1 && Ground::of(&scenario) == Ground::Sixteen;
        assert!(able(&[Family::Exact]) && (both || able(&[Family::AntColony, Family::Swarm])), "{:?}", Ground::of(&scenario));
    }
}

/// Scenarios of every ground without a path, each for another reason.
fn unreachable() -> Vec<(String, Arc<Scenario>)> {
    let mut all = Vec::new();
    for movement in movements().into_iter().chain(sixteen()) {
        let mut add = |name: &str, scenario| all.push((format!("{name} with {movement:?}"), scenario));
        add("a corner walled off", drawn(&["S.##..", "..##..", "####..", "####.G"], movement));
        let open = || Grid::open(6, 3).expect("6 × 3");
        let ends = (Point::new(0, 0), Point::new(5, 2));
        let gap: Vec<(u32, u32)> = (0..3).flat_map(|y| [(2, y), (3, y)]).collect();
        add("a band without data", surface(open(), without(vec![1.0; 18], 6, &gap), movement, 90.0, ends));
        let cliff: Vec<f32> = (0..18).map(|c| if c % 6 < 3 { 0.0 } else { 9.0 }).collect();
        add("a cliff", surface(open(), cliff, movement, 60.0, ends));
    }
    let over = |height: f32, goal: (u32, u32), measure| {
        let heights = (0..30).map(|c| if c % 6 == 3 { height } else { 0.0 }).collect();
        let grid = Grid::open(6, 5).and_then(|g| g.with_heights(heights)).expect("6 × 5");
        slices(grid, rules(measure), (0, 0), goal)
    };
    for measure in [Measure::Cost, Measure::Length] {
        all.push(("a wall of ground".into(), over(700.0, (5, 0), measure)));
        all.push(("too far aside".into(), over(0.0, (1, 4), measure)));
        all.push(("in the same column".into(), over(0.0, (0, 3), measure)));
    }
    all
}

#[test]
fn an_unreachable_goal_is_an_answer_on_every_ground() {
    for (name, scenario) in unreachable() {
        assert!(!scenario.reachable(), "{name}");
        for entry in CATALOG.iter().filter(|e| takes(e, &scenario)) {
            let mut planner = planner(entry, &scenario, 1);
            assert_eq!(planner.run(), Status::NoPath, "{} on {name}", entry.id);
            assert!(planner.best().is_none(), "{} on {name}", entry.id);
        }
    }
}

/// The same scenario with the start as its goal.
fn to_itself(scenario: &Scenario) -> Arc<Scenario> {
    let mut spec = ScenarioSpec { goals: vec![Goal::new(scenario.spec.start, "")], ..scenario.spec.clone() };
    if let Some(TerrainSpec { moves: TerrainMoves::Slices(rules), .. }) = &mut spec.terrain {
        rules.goal_level = rules.start_level;
    }
    Arc::new(Scenario::new(scenario.grid.clone(), spec).expect("usable"))
}

#[test]
fn start_on_the_goal_is_a_path_of_length_zero_on_every_ground() {
    for scenario in grounds().map(|s| to_itself(&s)) {
        let place = scenario.slices.as_ref().map_or(scenario.start, |slices| slices.start());
        for entry in CATALOG.iter().filter(|e| takes(e, &scenario)) {
            let mut planner = planner(entry, &scenario, 1);
            assert_eq!(planner.run(), Status::Optimal, "{} on {:?}", entry.id, Ground::of(&scenario));
            let best = planner.best().map(|b| (b.path.clone(), b.length));
            assert_eq!(best, Some((vec![place], 0.0)), "{} on {:?}", entry.id, Ground::of(&scenario));
        }
    }
}

#[test]
fn the_scenarios_of_these_tests_cover_every_ground_and_can_be_solved() {
    let covered =
        |entry: &PlannerEntry, ground| scenarios().iter().any(|(_, s)| Ground::all_of(s).any(|g| g == ground) && takes(entry, s));
    for entry in CATALOG {
        assert!(entry.grounds.iter().all(|&ground| covered(entry, ground)), "{}", entry.id);
    }
    for (name, scenario) in scenarios().iter().filter(|(_, s)| s.grid.heights().is_some()) {
        assert!(scenario.reachable(), "{name}");
    }
}
