use super::*;
use crate::exact::best_first::Rules;
use crate::map::{CornerRule, Generator, Grid, Movement, Moves, Point, generate};
use crate::planner::Status;

fn made(kind: Generator, side: u32, seed: u32, movement: Movement) -> Arc<Scenario> {
    let made = generate(kind, side, side, seed, 0.25).expect("a map");
    Arc::new(Scenario::on(made.grid, movement, made.start, made.goal).expect("usable"))
}

fn run(scenario: &Arc<Scenario>, rules: impl Rules + 'static) -> Box<dyn Planner> {
    let mut search = Box::new(BestFirst::new(Arc::clone(scenario), rules));
    search.run();
    search
}

#[test]
fn all_that_is_seen_at_once_is_all_pairs_in_sight() {
    let kinds = [Generator::Random, Generator::Cave, Generator::Rooms, Generator::Maze];
    for (seed, corner_rule) in (0..24).zip(CornerRule::ALL.into_iter().cycle()) {
        let moves = if seed % 8 == 7 { Moves::Four } else { Moves::Eight };
        let scenario = made(kinds[seed as usize % 4], 20 + seed, seed, Movement { moves, corner_rule });
        let (found, expected) = (run(&scenario, InSight::new(&scenario, MOST_LOOKED_AT)), run(&scenario, OverGround::default()));
        assert_eq!(found.status(), Status::Optimal, "{:?}", scenario.spec);
        assert_eq!(found.effort(), expected.effort(), "{:?}", scenario.spec);
        assert_eq!(found.digest().hex(), expected.digest().hex(), "{:?}", scenario.spec);
    }
}

#[test]
fn it_ends_at_the_limit_of_its_work() {
    let scenario = made(Generator::Rooms, 50, 3, Movement::default());
    let whole = run(&scenario, InSight::new(&scenario, MOST_LOOKED_AT));
    let stopped = run(&scenario, InSight::new(&scenario, 20_000));
    assert_eq!((whole.status(), stopped.status()), (Status::Optimal, Status::BudgetSpent));
    assert!(stopped.effort().cell_expansions < whole.effort().cell_expansions);
    assert!(stopped.best().is_none_or(|best| best.length >= whole.best().expect("a path").length));
}

/// Maps of all kinds and sizes up to this side, under every movement.
fn all_kinds(count: u32, most: u32) -> impl Iterator<Item = Arc<Scenario>> {
    let kinds = [Generator::Random, Generator::Cave, Generator::Rooms, Generator::Maze];
    (0..count).flat_map(move |seed| {
        let (width, height) = (4 + seed * 11 % (most - 3), 4 + seed * 7 % (most - 3));
        let made = generate(kinds[seed as usize % 4], width, height, seed, [0.1, 0.3, 0.45][seed as usize % 3]);
        let movements =
            [Moves::Four, Moves::Eight, Moves::Sixteen].into_iter().flat_map(|moves| CornerRule::ALL.map(|rule| (moves, rule)));
        movements.filter_map(move |(moves, corner_rule)| {
            let made = made.as_ref().ok()?;
            Scenario::on(made.grid.clone(), Movement { moves, corner_rule }, made.start, made.goal).ok().map(Arc::new)
        })
    })
}

#[test]
fn a_led_search_finds_what_the_unled_one_does() {
    let mut proven = 0;
    for scenario in all_kinds(400, 40) {
        let search = |is_led| run(&scenario, InSight::new(&scenario, MOST_LOOKED_AT).led(is_led));
        let (led, unled) = (search(true), search(false));
        assert_eq!(led.status(), unled.status(), "{:?}", scenario.spec);
        let Some(expected) = unled.best() else { continue };
        let found = led.best().expect("a path");
        assert!((found.length - expected.length).abs() < 1e-9, "{} {} {:?}", found.length, expected.length, scenario.spec);
        let ends = scenario.grid.point(scenario.start).distance(scenario.grid.point(scenario.goal));
        proven += u32::from(expected.length > ends + 1e-9);
    }
    assert!(proven > 3000, "{proven} with bends");
}

#[test]
fn what_is_spent_leaves_an_interval_with_the_optimum() {
    let (mut stopped, mut both) = (0, 0);
    for scenario in all_kinds(60, 40) {
        let whole = run(&scenario, InSight::new(&scenario, MOST_LOOKED_AT));
        let Some(optimum) = whole.best().map(|best| best.length) else {
            assert_eq!(whole.certificate(), None);
            continue;
        };
        let proven = whole.certificate().expect("it has ended");
        assert!(proven.complete && proven.lower_bound == optimum && proven.expansions == whole.effort().cell_expansions);
        for (left, is_led) in [1, 300, 3000, 10_000].into_iter().flat_map(|left| [(left, true), (left, false)]) {
            let search = run(&scenario, InSight::new(&scenario, left).led(is_led));
            let told = search.certificate().expect("it has ended");
            assert!(told.lower_bound <= optimum, "{told:?} {optimum}");
            assert_eq!(told.complete, search.status() == Status::Optimal);
            assert!(search.best().is_none_or(|best| best.length >= optimum - 1e-9));
            let point = crate::exact::point_robot(&scenario).expect("small").expect("a way");
            assert!(!is_led || told.lower_bound >= point - 1e-6, "{told:?} {point}");
            stopped += u32::from(search.status() == Status::BudgetSpent);
            both += u32::from(search.status() == Status::BudgetSpent && search.best().is_some());
        }
    }
    assert!(stopped > 100 && both > 20, "{stopped} stopped, {both} with a way");
}

#[test]
fn a_led_search_knows_at_once_that_no_way_leads_and_where_none_is_needed() {
    let grid = Grid::from_bytes(3, 1, &[0, 1, 0]).expect("a map");
    for (goal, status, length) in [(2, Status::NoPath, None), (0, Status::Optimal, Some(0.0))] {
        let ends = (Point::new(0, 0), Point::new(goal, 0));
        let scenario = Arc::new(Scenario::on(grid.clone(), Movement::default(), ends.0, ends.1).expect("usable"));
        let search = run(&scenario, InSight::new(&scenario, MOST_LOOKED_AT).led(true));
        assert_eq!((search.status(), search.best().map(|best| best.length)), (status, length));
        assert_eq!(search.certificate().map(|told| told.lower_bound), length);
    }
}
