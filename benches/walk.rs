//! Ant System's walk: time per ant move beside the naive kernel (pow per neighbour), and whole iterations on larger maps; and A* on a real
//! surface.
//!
//! `cargo bench --bench walk` compares versions of the engine; beside others it is measured by `cargo xtask bench`. Read ratios within one
//! run; times drift with the machine.

use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use formicarium::aco::heuristic::Heuristic;
use formicarium::catalog::CATALOG;
use formicarium::map::{Generator, Grid, Movement, Moves, Point, SliceRules, generate};
use formicarium::params::Values;
use formicarium::planner::playback::Playback;
use formicarium::planner::{Family, Granularity, Ground, Planner, PlannerEntry};
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

#[path = "reference/mod.rs"]
mod reference;

fn random_map(side: u32) -> Arc<Scenario> {
    let made = generate(Generator::Random, side, side, 1, 0.2).expect("a valid size");
    Arc::new(Scenario::on(made.grid, Movement::default(), made.start, made.goal).expect("a valid scenario"))
}

/// Hills, by slices from west to east.
fn terrain(side: u32) -> Arc<Scenario> {
    let made = generate(Generator::Hills, side, side, 1, 0.5).expect("a valid size");
    let rules = SliceRules::fitting_map(&made.grid, 1.0, made.start, made.goal, None);
    let terrain = Some(TerrainSpec { moves: TerrainMoves::Slices(rules), ..TerrainSpec::default() });
    let spec = ScenarioSpec { terrain, ..ScenarioSpec::new(&made.grid, made.start, made.goal) };
    Arc::new(Scenario::new(made.grid, spec).expect("a valid scenario"))
}

/// 50 ants each, so that what an iteration costs for the whole map is spread over as many walks; a hybrid's first stage is over at once.
fn colony(id: &str, scenario: &Arc<Scenario>) -> Box<dyn Planner> {
    let entry = formicarium::catalog::find(id).expect("in the catalog");
    let wanted = [("iterations", 100_000.0), ("ants", 50.0), ("seed_iterations", 1.0)];
    let known = |key: &str| (entry.specs)().iter().any(|s| s.key == key);
    let values = wanted.iter().filter(|(key, _)| known(key));
    let values: Values = values.map(|&(key, value)| (key.to_string(), formicarium::params::Value::Number(value))).collect();
    formicarium::catalog::build(scenario, id, None, &values, 1).expect("valid parameters")
}

/// Time for `moves` ant moves: whole iterations, refresh of weights, deposit and evaporation included.
fn timed(moves: u64, mut iterate: impl FnMut() -> u64) -> Duration {
    let (begin, start) = (iterate(), Instant::now());
    let mut done = begin;
    while done - begin < moves {
        done = iterate();
    }
    start.elapsed().mul_f64(moves as f64 / (done - begin) as f64)
}

/// Time per ant move of a colony on a map, over whole iterations.
fn bench_colony(group: &mut BenchmarkGroup<WallTime>, name: impl Into<String>, id: &str, scenario: &Arc<Scenario>) {
    group.bench_function(name, |b| {
        let mut planner = colony(id, scenario);
        b.iter_custom(|n| {
            timed(n, || {
                planner.advance(Granularity::Iteration);
                planner.effort().ant_moves
            })
        });
    });
}

fn moves(c: &mut Criterion) {
    let mut group = c.benchmark_group("ant move, 100x100, 20 % walls, 50 ants, beta 5");
    group.throughput(Throughput::Elements(1));
    let scenario = random_map(100);
    bench_colony(&mut group, "engine", "ant-system", &scenario);
    group.bench_function("naive", |b| {
        let mut naive = reference::Naive::new(Arc::clone(&scenario), 50, 5.0, 0.5, Heuristic::Detour, 1);
        b.iter_custom(|n| {
            timed(n, || {
                naive.iterate();
                naive.moves
            })
        });
        black_box(naive.digest());
    });
    group.finish();
}

fn sizes(c: &mut Criterion) {
    let mut group = c.benchmark_group("ant move by map size, 20 % walls");
    group.throughput(Throughput::Elements(1));
    for side in [20, 200, 512] {
        let scenario = random_map(side);
        bench_colony(&mut group, format!("{side}x{side}"), "ant-system", &scenario);
    }
    group.finish();
}

/// What it costs that one can look back: the walk with snapshots beside it, within the page's budget, and without.
fn snapshots(c: &mut Criterion) {
    let mut group = c.benchmark_group("ant move with and without snapshots, 50 ants");
    group.throughput(Throughput::Elements(1));
    for side in [24, 100, 300] {
        let scenario = random_map(side);
        for kept in [false, true] {
            group.bench_function(format!("{side}x{side}{}", if kept { ", snapshots" } else { "" }), |b| {
                b.iter_custom(|n| {
                    let mut planner = colony("ant-system", &scenario);
                    let mut playback = Playback::new(&*planner, if kept { 64 << 20 } else { 0 });
                    timed(n, || {
                        planner.advance(Granularity::Iteration);
                        if kept {
                            playback.note(&*planner, Granularity::Iteration);
                        }
                        planner.effort().ant_moves
                    })
                });
            });
        }
    }
    group.finish();
}

/// Ant System on a map of a game.
fn arena2(c: &mut Criterion) {
    let Ok(data) = std::env::var("FORMICARIUM_DATA") else {
        eprintln!("arena2 is skipped: FORMICARIUM_DATA is not set");
        return;
    };
    let read = |name: &str| std::fs::read(format!("{data}/movingai/{name}")).expect("the data folder");
    let grid = formicarium::formats::import(&read("arena2.map"), "arena2.map").expect("a map").grid;
    let lines = formicarium::formats::import_scen(&read("arena2.map.scen")).expect("scenarios").lines;
    let longest = lines.last().expect("a line");
    let scenario = Arc::new(Scenario::on(grid, Movement::default(), longest.start, longest.goal).expect("usable"));
    let mut group = c.benchmark_group("ant move on arena2, 50 ants");
    group.throughput(Throughput::Elements(1));
    bench_colony(&mut group, "engine", "ant-system", &scenario);
    group.finish();
}

/// Every colony of the catalog, otherwise with its defaults, beside Ant System; those that need a terrain, on one.
fn colonies(c: &mut Criterion) {
    for (name, scenario) in [("100x100, 20 % walls", random_map(100)), ("hills 60x60", terrain(60))] {
        let mut group = c.benchmark_group(format!("ant move by colony, {name}, 50 ants"));
        group.throughput(Throughput::Elements(1));
        let ground = Ground::of(&scenario);
        let walks =
            |e: &&&PlannerEntry| e.grounds.contains(&ground) && (ground == Ground::Plane || !e.grounds.contains(&Ground::Plane));
        for entry in CATALOG.iter().filter(|e| e.family == Family::AntColony).filter(walks) {
            bench_colony(&mut group, entry.id, entry.id, &scenario);
        }
        group.finish();
    }
}

/// An ESRI ASCII grid: six lines of names and numbers, then heights.
fn tile(text: &str) -> Grid {
    let number = |line: usize| text.lines().nth(line).and_then(|l| l.split_whitespace().nth(1)).expect("a header");
    let side = |line| number(line).parse().expect("a whole number");
    let heights = text.lines().skip(6).flat_map(str::split_whitespace).map(|h| h.parse().expect("a height")).collect();
    Grid::open(side(0), side(1)).and_then(|grid| grid.with_heights(heights)).expect("a grid")
}

/// A* from corner to corner of a real tile of 144 × 144 heights, and to the middle of its right edge.
fn surface(c: &mut Criterion) {
    let Ok(data) = std::env::var("FORMICARIUM_DATA") else {
        eprintln!("the tile is skipped: FORMICARIUM_DATA is not set");
        return;
    };
    let grid = tile(&std::fs::read_to_string(format!("{data}/dem/srtmgl3_144x144.asc")).expect("the data folder"));
    let mut group = c.benchmark_group("A* on a surface, srtmgl3_144x144");
    for moves in [Moves::Eight, Moves::Sixteen] {
        for goal in [Point::new(143, 143), Point::new(143, 71)] {
            let movement = Movement { moves, ..Movement::default() };
            let spec = ScenarioSpec { movement, resolution: 92.6, ..ScenarioSpec::new(&grid, Point::new(0, 0), goal) };
            let scenario = Arc::new(Scenario::new(grid.clone(), spec).expect("usable"));
            group.bench_function(format!("{moves:?} moves to ({}, {})", goal.x, goal.y), |b| {
                b.iter(|| {
                    let mut search = formicarium::catalog::build(&scenario, "astar", None, &Values::new(), 1).expect("usable");
                    black_box(search.run())
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, moves, sizes, snapshots, colonies, arena2, surface);
criterion_main!(benches);
