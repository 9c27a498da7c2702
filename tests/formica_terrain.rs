//! Formica on terrain, on its surface with 8 and 16 moves and by slices: what it proves is right, and it comes to the best path. Real terrain
//! is that of the data folder that the environment variable FORMICARIUM_DATA names; without it those tests are skipped, aloud.
//!
//! `cargo test --release --test formica_terrain -- --nocapture` prints the tables.
#![cfg(not(target_arch = "wasm32"))]

#[path = "common/terrains.rs"]
mod terrains;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use formicarium::catalog;
use formicarium::exact::{SliceEstimate, SlicesWithin};
use formicarium::formats::{Imported, import};
use formicarium::map::{Cell, CornerRule, Measure, Movement, Moves, Point, SliceRules, Slices, Way};
use formicarium::params::{Value, Values};
use formicarium::planner::{Planner, Status};
use formicarium::scenario::{Goal, Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

/// Files, and the steepest slope that is allowed, in degrees.
const TERRAINS: [(&str, f64); 5] = [
    ("DEM_10m.asc", 90.0),
    ("hugo_site.asc", 30.0),
    ("srtmgl3_144x144.asc", 25.0),
    ("west_bijou_gully.asc", 40.0),
    ("pysheds_dem.tif", 12.0),
];

/// Pairs of ends on each.
const PAIRS: u32 = 8;

/// Iterations after which the best path is looked at, and a limit of the proof that is spent before its end, in parts of the cells.
const ITERATIONS: f64 = 10.0;
const SOON_SPENT: f64 = 0.05;

const SAME: f64 = 1e-6;

fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("FORMICARIUM_DATA").map(|f| PathBuf::from(f).join("dem"));
    if folder.is_none() {
        println!("skipped: FORMICARIUM_DATA is not set, so there is no terrain to plan on");
    }
    folder
}

fn read(file: &Path) -> Imported {
    let name = file.file_name().expect("a name").to_string_lossy();
    import(&std::fs::read(file).expect("the file"), &name).expect("a terrain")
}

/// A terrain by these rules, with some ends.
fn load(file: &Path, moves: Moves, max_slope: f64) -> Scenario {
    let map = read(file);
    let terrain = Some(TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Surface { max_slope } });
    let movement = Movement { moves, corner_rule: CornerRule::BothFree };
    Scenario::new(map.grid, ScenarioSpec { movement, terrain, ..map.spec }).expect("usable")
}

/// A free cell for a number, the same everywhere.
fn place(map: &Scenario, number: u32) -> Point {
    let free: Vec<u32> = (0..map.grid.len() as u32).filter(|&cell| !map.grid.is_blocked(cell)).collect();
    map.grid.point(free[drawn(number, free.len())])
}

/// A number below another one, the same everywhere.
fn drawn(number: u32, below: usize) -> usize {
    (f64::from(terrains::noise(number, 0, 0)) * below as f64) as usize
}

fn run(scenario: &Arc<Scenario>, planner: &str, values: &[(&str, f64)]) -> Box<dyn Planner> {
    let values: Values = values.iter().map(|&(key, value)| (key.to_string(), Value::Number(value))).collect();
    let mut planner = catalog::build(scenario, planner, None, &values, 1).expect("valid parameters");
    planner.run();
    planner
}

/// What pairs of ends come to.
#[derive(Default)]
struct Tally {
    pairs: u32,
    exact: u32,
    proven: u32,
    intervals: u32,
    /// Σ of expansions over those of A*.
    ratio: f64,
}

impl Tally {
    /// Runs a planner whose results are proven, and a colony that proves its own.
    fn take(&mut self, scenario: &Arc<Scenario>, (exact, colony): (&str, &str)) {
        let search = run(scenario, exact, &[]);
        let Some(optimum) = search.best().map(|best| best.length) else { return };
        self.pairs += 1;
        let bare = run(scenario, colony, &[("proof_limit", 0.0), ("iterations", ITERATIONS)]);
        self.exact += u32::from(bare.best().is_some_and(|best| best.length < optimum + SAME));
        let full = run(scenario, colony, &[]);
        let (best, certificate) = (full.best().expect("a path").length, full.certificate().expect("a proof"));
        let is_right = |value: f64| (value - optimum).abs() < SAME;
        let is_complete = full.status() == Status::Optimal && certificate.complete;
        self.proven += u32::from(is_complete && is_right(best) && is_right(certificate.lower_bound));
        let short = run(scenario, colony, &[("proof_limit", SOON_SPENT), ("iterations", 1.0)]);
        let bound = short.certificate().expect("a bound").lower_bound;
        self.intervals += u32::from(bound < optimum + SAME && optimum < short.best().expect("a path").length + SAME);
        self.ratio += full.effort().cell_expansions as f64 / search.effort().cell_expansions as f64;
    }

    /// Prints a row of the table; all that was proven is right.
    fn told(&self, name: &str, how: &str) {
        let Self { pairs, exact, proven, intervals, ratio } = *self;
        println!("| {name} | {how} | {pairs} | {exact} | {proven} | {intervals} | {:.2} |", ratio / f64::from(pairs));
        assert!(pairs > 2, "{name}: some pairs are joined by a way");
        assert_eq!((proven, intervals), (pairs, pairs), "{name}: a proof is not complete, or not right");
    }
}

#[test]
fn what_is_proven_on_surfaces_is_right() {
    let Some(folder) = folder() else { return };
    println!("| terrain | moves | pairs | exact after 10 | proven | bounds hold | expansions / A* |");
    for (name, max_slope) in TERRAINS {
        for moves in [Moves::Eight, Moves::Sixteen] {
            let map = load(&folder.join(name), moves, max_slope);
            let mut tally = Tally::default();
            for pair in 0..PAIRS {
                let (start, goal) = (place(&map, 2 * pair + 1), place(&map, 2 * pair + 2));
                let ends = map.with_ends(start, vec![Goal::new(goal, "")]).expect("usable");
                tally.take(&Arc::new(ends), ("astar", "formica"));
            }
            tally.told(name, &format!("{moves:?}"));
        }
    }
}

#[test]
fn what_is_proven_by_slices_is_right() {
    let Some(folder) = folder() else { return };
    println!("| terrain | measure | pairs | cheapest after 10 | proven | bounds hold | expansions / dynamic programming |");
    for (name, _) in TERRAINS {
        for measure in [Measure::Cost, Measure::Length] {
            let mut tally = Tally::default();
            let map = read(&folder.join(name));
            let asked = (0..20 * PAIRS).filter_map(|pair| across(&map, measure, pair));
            asked.take(PAIRS as usize).for_each(|scenario| tally.take(&scenario, ("slices-exact", "formica-slices")));
            tally.told(name, &format!("{measure:?}"));
        }
    }
}

#[test]
fn where_ants_cannot_go_the_search_can() {
    // Steps of two cells at once pass where the two that they stand for are too steep.
    let movement = Movement { moves: Moves::Sixteen, corner_rule: CornerRule::BothFree };
    let mut apart = 0;
    for (seed, slope) in (1..40).flat_map(|seed| [8.0, 12.0, 20.0, 30.0].map(|slope| (seed, slope))) {
        let scenario = terrains::hilly(12, 12, seed, 3.0, movement, slope);
        let near = terrains::hilly(12, 12, seed, 3.0, Movement { moves: Moves::Eight, ..movement }, slope);
        if near.reachable() || !scenario.reachable() {
            continue;
        }
        let optimum = run(&scenario, "astar", &[]).best().expect("a path").length;
        let colony = run(&scenario, "formica", &[]);
        assert_eq!(colony.status(), Status::Optimal, "seed {seed}");
        assert!(colony.best().is_some_and(|best| (best.length - optimum).abs() < SAME), "seed {seed}");
        apart += 1;
    }
    assert!(apart > 0, "some hills are crossed by long steps alone");
}

/// By slices between two cells with heights that a number tells, a quarter of the map's width apart at least; none where no way leads there.
fn across(map: &Imported, measure: Measure, number: u32) -> Option<Arc<Scenario>> {
    let known: Vec<u32> =
        map.grid.heights()?.iter().zip(0..).filter(|(height, _)| height.is_finite()).map(|(_, cell)| cell).collect();
    let ends = [2 * number + 1, 2 * number + 2].map(|n| map.grid.point(known[drawn(n, known.len())]));
    if ends[0].x.abs_diff(ends[1].x) < map.grid.width() / 4 {
        return None;
    }
    let fitting = SliceRules::fitting_map(&map.grid, 1.0, ends[0], ends[1], None);
    let moves = TerrainMoves::Slices(SliceRules { measure, ..fitting });
    let terrain = Some(TerrainSpec { vertical_unit: 1.0, moves });
    let spec = ScenarioSpec { terrain, start: ends[0], goals: vec![Goal::new(ends[1], "")], ..map.spec.clone() };
    Scenario::new(map.grid.clone(), spec).ok().map(Arc::new)
}

/// Small hills by slices, of many kinds.
fn small_slices() -> impl Iterator<Item = Arc<Scenario>> {
    let rules = |n: u32| {
        let measure = if n.is_multiple_of(2) { Measure::Cost } else { Measure::Length };
        SliceRules { max_aside: 1 + n % 3, max_climb: n % 4, ..terrains::rules(measure) }
    };
    (0..120).map(move |n| terrains::hilly_slices(4 + n % 9, 3 + n % 7, n, rules(n)))
}

#[test]
fn small_hills_by_slices_are_proven_and_bounded() {
    let mut tally = Tally::default();
    small_slices().for_each(|scenario| tally.take(&scenario, ("slices-exact", "formica-slices")));
    assert!(tally.pairs > 60, "{} of the hills can be crossed", tally.pairs);
    tally.told("small hills", "both");
}

#[test]
fn no_step_lowers_the_estimate_by_more_than_it_costs() {
    let mut steps = 0;
    for scenario in small_slices() {
        let slices = slices(&scenario);
        let estimate = SliceEstimate::new(slices);
        assert_eq!(estimate.of(slices, slices.goal()), 0.0);
        for from in (0..slices.places() as Cell).filter(|&place| slices.is_free(place)) {
            for to in (0..slices.directions()).filter_map(|k| slices.step(from, k, Way::Forward)) {
                let (here, there) = (estimate.of(slices, from), estimate.of(slices, to));
                assert!(here <= slices.cost(from, to) + there + SAME, "{from} to {to}: {here} and {there}");
                steps += 1;
            }
        }
    }
    assert!(steps > 1000);
}

fn slices(scenario: &Scenario) -> &Slices {
    scenario.slices.as_ref().expect("by slices")
}

#[test]
fn a_search_by_slices_goes_on_where_it_had_to_stop() {
    let scenario = terrains::hilly_slices(12, 9, 3, terrains::rules(Measure::Cost));
    let slices = Arc::clone(scenario.slices.as_ref().expect("by slices"));
    let optimum = run(&scenario, "slices-exact", &[]).best().expect("a path").length;
    let mut search = SlicesWithin::new(&slices);
    assert!(search.go_on(u64::MAX) && search.best().is_none(), "nothing is of the part yet");
    search.widen_to_all();
    let (mut last, mut rounds) = (search.lower_bound(), 0);
    while !search.go_on(5) {
        let bound = search.lower_bound();
        assert!(last <= bound + SAME && bound <= optimum + SAME, "{last}, {bound}, {optimum}");
        (last, rounds) = (bound, rounds + 1);
    }
    let (path, cost) = search.best().expect("a path");
    assert!(rounds > 3 && search.is_proven() && (cost - optimum).abs() < SAME);
    assert_eq!((path[0], path[path.len() - 1], cost), (slices.start(), slices.goal(), slices.value(&path)));
}
