//! Formica with polylines: its search on maps by hand, and what it proves on small maps beside the shortest polyline.

use std::sync::Arc;

use formicarium::aco::criterion::Judge;
use formicarium::aco::formica::Paths;
use formicarium::aco::formica::merge::{Corridor, Merge};
use formicarium::catalog;
use formicarium::error::ParamError;
use formicarium::exact::{PolylinesWithin, point_robot};
use formicarium::map::{Cell, CornerRule, Generator, Grid, Movement, Moves, Point, generate};
use formicarium::params::{Value, Values};
use formicarium::path::{PathKind, audit, points};
use formicarium::planner::{Certificate, Granularity, Layer, Objective, Planner, Status};
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

use super::close;

fn asked(scenario: &Arc<Scenario>, set: &[(&str, f64)]) -> Result<Box<dyn Planner>, ParamError> {
    let mut values: Values = set.iter().map(|&(key, value)| (key.to_string(), Value::Number(value))).collect();
    values.insert("paths".into(), Value::from("polylines"));
    catalog::build(scenario, "formica", None, &values, 1)
}

fn built(scenario: &Arc<Scenario>, set: &[(&str, f64)]) -> Box<dyn Planner> {
    asked(scenario, set).expect("valid parameters")
}

/// The shortest polyline's length, proven; none where there is none.
fn optimum(scenario: &Arc<Scenario>) -> Option<f64> {
    let mut exact = catalog::build(scenario, "any-angle", None, &Values::new(), 1).expect("a plane");
    assert!(matches!(exact.run(), Status::Optimal | Status::NoPath));
    exact.best().map(|best| best.length)
}

/// 9 × 7 cells from (0, 3) to (8, 3), column 4 blocked but for its ends and, where `has_gap`, (4, 1).
fn wall(has_gap: bool) -> Arc<Scenario> {
    let is_blocked = |x: u32, y: u32| x == 4 && y != 0 && y != 6 && !(has_gap && y == 1);
    let cells: Vec<u8> = (0..63).map(|c| u8::from(is_blocked(c % 9, c / 9))).collect();
    let grid = Grid::from_bytes(9, 7, &cells).expect("a map");
    let ends = (Point::new(0, 3), Point::new(8, 3));
    Arc::new(Scenario::on(grid, Movement::default(), ends.0, ends.1).expect("usable"))
}

fn cell(s: &Scenario, x: u32, y: u32) -> Cell {
    s.grid.cell(Point::new(x, y))
}

#[test]
fn the_search_sees_over_the_whole_map_and_bends_in_its_part() {
    let s = wall(true);
    let mut search = PolylinesWithin::new(&s);
    let first = search.lower_bound();
    assert!(search.best().is_none() && !search.is_proven());
    // The start sees no cell from which the goal is in sight but those around the gaps, and none of them is of the part.
    search.widen(s.start, 0);
    assert!(search.go_on(u64::MAX) && search.best().is_none());
    assert_eq!(search.expansions(), 1);
    // The row of the lower gap, from end to end.
    (0..9).for_each(|x| search.widen(cell(&s, x, 6), 0));
    assert!(search.go_on(u64::MAX));
    let (path, long) = search.best().expect("the lower gap");
    // Column 4 is entered in row 6: four columns and three rows there, and as many on.
    assert_eq!((path, long), (vec![s.start, cell(&s, 4, 6), s.goal], 10.0));
    let bound = search.lower_bound();
    assert!(first <= bound && bound < long && !search.is_proven());
    let before = search.expansions();
    search.widen_to_all();
    assert!(search.go_on(u64::MAX) && search.is_proven());
    let (path, short) = search.best().expect("the upper gap");
    assert_eq!(path, [s.start, cell(&s, 4, 1), s.goal]);
    assert!(close(short, 2.0 * 20f64.sqrt()), "{short}");
    assert!(bound <= short && search.lower_bound() == short && search.expansions() > before);
}

#[test]
fn a_search_that_is_stopped_goes_on_and_tells_what_it_has_proven() {
    let s = wall(false);
    let optimum = 10.0;
    let mut search = PolylinesWithin::new(&s);
    search.widen_to_all();
    let mut bounds = vec![search.lower_bound()];
    while !search.go_on(1) {
        bounds.push(search.lower_bound());
    }
    let point = point_robot(&s).expect("small").expect("a way");
    assert!(bounds.len() > 3 && bounds.iter().all(|&bound| bound > point - 1e-6 && bound <= optimum), "{bounds:?} {point}");
    assert!(bounds.is_sorted() && search.is_proven() && close(search.lower_bound(), optimum), "{bounds:?}");
    let mut whole = PolylinesWithin::new(&s);
    whole.widen_to_all();
    assert!(whole.go_on(u64::MAX) && whole.expansions() == search.expansions());
    let mut known = PolylinesWithin::new(&s);
    known.bound_by(optimum);
    known.widen_to_all();
    assert!(known.go_on(u64::MAX) && known.is_proven() && known.best().is_none());
    assert!(known.expansions() <= whole.expansions());
}

#[test]
fn a_merge_follows_polylines_and_proves_them() {
    let s = wall(true);
    let mut merge = Merge::of(Paths::Polylines, Judge::Length, &s, Corridor { narrow: 0, wide: 0, radius: 0 });
    let lower: Vec<Cell> =
        [(0, 3), (1, 4), (2, 5), (3, 6), (4, 6), (5, 6), (6, 5), (7, 4), (8, 3)].map(|(x, y)| cell(&s, x, y)).into();
    merge.follow(&lower);
    let (path, length) = merge.solve().expect("along it");
    assert_eq!(path, [(0, 3), (4, 6), (8, 3)].map(|(x, y)| cell(&s, x, y)));
    assert!(!merge.certificate(length).complete);
    let (_, better) = merge.prove(length, u64::MAX).expect("by the upper gap");
    assert_eq!((merge.certificate(better).lower_bound, merge.certificate(better).complete), (better, true));
    assert!(better < length);
}

#[test]
fn what_a_point_needs_at_least_is_proof_enough() {
    let open = Grid::open(12, 9).expect("a map");
    let s = Arc::new(Scenario::on(open, Movement::default(), Point::new(0, 0), Point::new(11, 5)).expect("usable"));
    let mut ants = built(&s, &[]);
    assert_eq!(ants.run(), Status::Optimal);
    let straight = 146f64.sqrt();
    assert!(close(ants.best().expect("a segment").length, straight));
    let proof = Certificate { lower_bound: ants.best().expect("a segment").length, expansions: 0, complete: true };
    assert_eq!((ants.certificate(), ants.effort().iterations, ants.objective()), (Some(proof), 1, Objective::PolylineLength));
}

/// Small maps of three kinds under every movement on a plane with neighbouring steps.
fn small_maps(count: u32) -> impl Iterator<Item = Arc<Scenario>> {
    let kinds = [Generator::Random, Generator::Rooms, Generator::Cave];
    (0..count).flat_map(move |seed| {
        let (width, height) = (4 + seed * 11 % 11, 4 + seed * 7 % 11);
        let made = generate(kinds[seed as usize % 3], width, height, seed, [0.15, 0.3, 0.4][seed as usize % 3]);
        let eight = CornerRule::ALL.map(|corner_rule| Movement { moves: Moves::Eight, corner_rule });
        let four = Movement { moves: Moves::Four, corner_rule: CornerRule::BothFree };
        eight.into_iter().chain([four]).filter_map(move |movement| {
            let made = made.as_ref().ok()?;
            Scenario::on(made.grid.clone(), movement, made.start, made.goal).ok().map(Arc::new)
        })
    })
}

#[test]
fn on_small_maps_the_best_is_the_shortest_and_proven() {
    let (mut maps, mut bent) = (0, 0);
    for scenario in small_maps(240) {
        let mut ants = built(&scenario, &[("ants", 4.0)]);
        let status = ants.run();
        let Some(optimum) = optimum(&scenario) else {
            assert_eq!((status, ants.certificate()), (Status::NoPath, None));
            continue;
        };
        let best = ants.best().expect("a polyline");
        assert_eq!(audit(&scenario, &points(&scenario, &best.path), PathKind::Polyline), Ok(()), "{:?}", scenario.spec);
        assert!((best.length - optimum).abs() < 1e-9, "{} {optimum} {:?}", best.length, scenario.spec);
        let is_needed = scenario.start != scenario.goal;
        let proof = ants.certificate().filter(|proof| proof.complete && (proof.lower_bound - optimum).abs() < 1e-9);
        assert!(status == Status::Optimal && proof.is_some() == is_needed, "{proof:?} {:?}", scenario.spec);
        maps += 1;
        let ends = scenario.grid.point(scenario.start).distance(scenario.grid.point(scenario.goal));
        bent += u32::from(optimum > ends + 1e-9);
    }
    assert!(maps > 600 && bent > 200, "{maps} maps, {bent} with bends");
}

#[test]
fn a_proof_that_is_cut_off_leaves_an_interval_with_the_shortest() {
    let (mut cut, mut raised) = (0, 0);
    for scenario in small_maps(120).filter(|scenario| scenario.start != scenario.goal) {
        let Some(optimum) = optimum(&scenario) else { continue };
        let point = point_robot(&scenario).expect("small").expect("a way");
        // Next to nothing is merged: nearly all is left to the proof.
        for most in [0.001, 0.02, 0.05, 0.2] {
            let little = [("widening", 0.0), ("corridor", 0.0), ("corridor_most", 0.0), ("ants", 1.0), ("iterations", 1.0)];
            let set: Vec<_> = little.into_iter().chain([("proof_limit", most)]).collect();
            let mut ants = built(&scenario, &set);
            let status = ants.run();
            let Some(best) = ants.best() else { continue };
            let told = ants.certificate().expect("as far as it goes");
            assert!(best.length > optimum - 1e-9 && told.lower_bound < optimum + 1e-9, "{told:?} {optimum}");
            assert!(told.lower_bound > point - 1e-6 || scenario.spec.movement.moves == Moves::Four, "{told:?} {point}");
            assert_eq!(
                (status == Status::Optimal, told.complete),
                (told.complete, (told.lower_bound - best.length).abs() < 1e-12)
            );
            assert!(!told.complete || (best.length - optimum).abs() < 1e-9, "{told:?} {optimum}");
            cut += u32::from(!told.complete);
            raised += u32::from(!told.complete && told.lower_bound > point + 1e-6);
        }
    }
    assert!(cut > 100 && raised > 10, "{cut} cut off, {raised} of them above what a point needs");
}

#[test]
fn without_merging_the_ways_of_ants_are_pulled_straight() {
    let s = wall(true);
    let values: Values = [
        ("paths".to_string(), Value::from("polylines")),
        ("merge".to_string(), Value::from(false)),
        ("proof_limit".to_string(), Value::Number(0.0)),
        ("iterations".to_string(), Value::Number(10.0)),
    ]
    .into();
    let mut ants = catalog::build(&s, "formica", None, &values, 1).expect("valid parameters");
    assert_eq!((ants.run(), ants.certificate()), (Status::BudgetSpent, None));
    let best = ants.best().expect("an ant arrives");
    assert_eq!(audit(&s, &points(&s, &best.path), PathKind::Polyline), Ok(()));
    assert!(best.path.len() < 9, "{:?} has a joint for every step", best.path);
}

#[test]
fn other_grounds_are_refused_by_name() {
    let flat = Grid::open(6, 5).expect("a map");
    let ends = (Point::new(0, 0), Point::new(5, 4));
    let sixteen = Movement { moves: Moves::Sixteen, ..Movement::default() };
    let many = Scenario::on(flat.clone(), sixteen, ends.0, ends.1).expect("usable");
    let swamp = flat.clone().with_factors(vec![2.0; 30]).expect("factors of every cell");
    let weighted = Scenario::new(swamp.clone(), ScenarioSpec::new(&swamp, ends.0, ends.1)).expect("usable");
    let hills = flat.with_heights((0..30).map(|c| (c % 4) as f32).collect()).expect("heights of every cell");
    let mut spec = ScenarioSpec::new(&hills, ends.0, ends.1);
    spec.terrain = Some(TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Surface { max_slope: 90.0 } });
    let surface = Scenario::new(hills, spec).expect("usable");
    for (scenario, ground) in [(many, "sixteen"), (weighted, "weighted"), (surface, "surface")] {
        let scenario = Arc::new(scenario);
        let refused = asked(&scenario, &[]).err().expect("no polylines there");
        assert!(matches!(&refused, ParamError::ValueOnGround { id, key: "paths", .. } if *id == ground), "{refused}");
        let report = refused.report();
        assert!(report.field == "paths" && report.message.contains("polylines") && report.hint.contains("steps"), "{report:?}");
        assert!(catalog::build(&scenario, "formica", None, &Values::new(), 1).is_ok());
    }
    let grid = Grid::open(1025, 1024).expect("a map");
    let huge = Arc::new(Scenario::on(grid, Movement::default(), ends.0, ends.1).expect("usable"));
    assert!(matches!(asked(&huge, &[]).err(), Some(ParamError::MapTooLarge { most: 1_048_576, .. })));
}

#[test]
fn layers_show_scent_and_what_was_merged() {
    let s = wall(true);
    let mut ants = built(&s, &[("widening", 0.0), ("corridor", 0.0)]);
    let (mut scent, mut merged, mut trail) = (Vec::new(), Vec::new(), Vec::new());
    ants.advance(Granularity::Iteration);
    assert!(
        ants.layer(Layer::Scent, &mut scent) && ants.layer(Layer::Merged, &mut merged) && ants.layer(Layer::Trail, &mut trail)
    );
    assert!(scent[s.goal as usize] == 0.0 && merged[s.start as usize] == 1.0);
    // The trail is stronger beside the polyline than where nobody has been.
    let least = trail.iter().copied().fold(f32::INFINITY, f32::min);
    assert!(trail[s.start as usize] > least, "{trail:?}");
}
