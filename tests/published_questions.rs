//! The committed questions: every one can be asked, and its record is what the engine gives today.
#![cfg(not(target_arch = "wasm32"))]

#[path = "published_questions/own_colony.rs"]
mod own_colony;
#[path = "published_questions/public_maps.rs"]
mod public_maps;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use formicarium::catalog;
use formicarium::comparison::report::{HEADER, line};
use formicarium::comparison::{Comparison, Instance, Question, Task};
use formicarium::formats;
use formicarium::formats::Export;
use formicarium::map::{CornerRule, Generator, Moves, SliceRules, generate};
use formicarium::params::{Value, Values};
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

/// The maps that were drawn, and the first terrains.
const OTHER_MAPS: [&str; 11] = [
    "criss-cross-20x20",
    "engine-room",
    "fire-20x20",
    "hills-20",
    "hills-30",
    "hills-50",
    "hills-64-surface",
    "ship-20x20",
    "ship-30x30",
    "threshold-1",
    "threshold-2",
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("experiments")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn names(folder: &Path, ending: &str) -> Vec<String> {
    let files = folder.read_dir().expect("a folder").map(|file| file.expect("an entry").path());
    let stem = |path: PathBuf| path.file_stem().expect("a name").to_string_lossy().into_owned();
    let mut names: Vec<String> = files.filter(|p| p.extension().is_some_and(|e| e == ending)).map(stem).collect();
    names.sort();
    names
}

fn question(name: &str) -> Question {
    toml::from_str(&read(&folder().join(format!("{name}.toml")))).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn scenario(path: &Path) -> Arc<Scenario> {
    let bytes = std::fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let map = formats::import(&bytes, &path.display().to_string()).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    Arc::new(Scenario::new(map.grid, map.spec).expect("usable"))
}

fn comparison(name: &str) -> Comparison {
    let question = question(name);
    let path = folder().join(name);
    let beside = path.parent().expect("a folder");
    let maps = question.instances.iter().map(|i| scenario(&beside.join(&i.map))).collect();
    Comparison::new(question, maps).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// A sample of a question's runs, each of which must be the line that its record has.
fn assert_recorded(comparison: &Comparison, record: &Path, seeds: &[u32]) {
    assert_recorded_in_part(comparison, record, seeds, 1);
}

/// The same of each `step`-th of these runs.
fn assert_recorded_in_part(comparison: &Comparison, record: &Path, seeds: &[u32], step: usize) {
    let recorded = read(record);
    let lines: Vec<&str> = recorded.lines().collect();
    let tasks = comparison.tasks();
    assert_eq!((lines[0], lines.len()), (HEADER, 1 + tasks.len()), "{}", record.display());
    let sample = |task: &&(usize, Task)| seeds.contains(&task.1.seed);
    let mut changed = Vec::new();
    for (place, task) in tasks.into_iter().enumerate().collect::<Vec<_>>().iter().filter(sample).step_by(step) {
        let found = line(comparison, &comparison.run(*task, &mut || 0.0).expect("a task of the comparison").row);
        if found != lines[1 + place] {
            changed.push(format!("now      {found}\nrecorded {}", lines[1 + place]));
        }
    }
    assert!(changed.is_empty(), "{}: record again with `cargo xtask record`\n{}", record.display(), changed.join("\n"));
}

#[test]
fn every_record_is_what_the_engine_gives() {
    let names = names(&folder(), "toml");
    assert!(["classics", "ship", "threshold"].iter().all(|n| names.iter().any(|name| name == n)), "{names:?}");
    for name in names {
        let comparison = comparison(&name);
        assert!(comparison.question.seeds.count >= 100, "{name}");
        assert_recorded(&comparison, &folder().join(format!("records/{name}.csv")), &[1, 100]);
        let page = read(&folder().join(format!("records/{name}.md")));
        assert!(page.starts_with(&format!("# {}\n", comparison.question.title)), "{name}");
        assert!(page.contains(&format!("`formicarium compare {name}.toml --out DIR`")), "{name}");
    }
}

/// What experiments/tuning/tuned/NAME.toml says: an entry's planner, preset and values.
#[derive(serde::Deserialize, Debug, PartialEq)]
#[serde(deny_unknown_fields)]
struct Tuned {
    planner: String,
    preset: Option<String>,
    set: Values,
}

#[test]
fn every_record_of_tuned_planners_is_what_the_engine_gives() {
    let names = names(&folder().join("tuning"), "toml");
    assert_eq!(names, ["fire", "fireworks", "ship", "terrain", "threshold"]);
    for name in names {
        let comparison = comparison(&format!("tuning/{name}"));
        assert_recorded(&comparison, &folder().join(format!("tuning/records/{name}.csv")), &[1]);
    }
}

#[test]
fn tuned_entries_have_the_values_of_the_tuning() {
    for name in names(&folder().join("tuning/tuned"), "toml") {
        let tuned: Tuned = toml::from_str(&read(&folder().join(format!("tuning/tuned/{name}.toml")))).expect("an entry's values");
        let (paper, entry) = name.split_once('-').expect("PAPER-ENTRY");
        let entries = question(&format!("tuning/{paper}")).entries;
        let find = |id: &str| entries.iter().find(|e| e.id == id).unwrap_or_else(|| panic!("{paper} has no entry {id}"));
        let (preset, asked) = (find(entry), find(&format!("{entry}-tuned")));
        let asked = Tuned { planner: asked.planner.clone().expect("runs"), preset: asked.preset.clone(), set: asked.set.clone() };
        assert_eq!(asked, tuned, "{name}");
        assert_eq!((preset.planner.as_ref(), &preset.preset), (Some(&tuned.planner), &tuned.preset), "{name}");
        assert!(preset.set.is_empty(), "{name}");
    }
}

/// The search of a tuning has the ranges of the engine, or narrower ones.
#[test]
fn what_may_be_tuned_is_a_parameter_and_in_its_range() {
    let folder = folder().join("tuning");
    let planners: serde_json::Map<String, serde_json::Value> =
        serde_json::from_str(&read(&folder.join("planners.json"))).expect("planners");
    for (name, tuned) in &planners {
        let planner = tuned["planner"].as_str().expect("an id");
        let lines = read(&folder.join(format!("parameters/{name}.txt")));
        let keys: Vec<&str> = lines.lines().map(|line| line.split_once(' ').expect("key and range").0).collect();
        assert_eq!(tuned["keys"], serde_json::json!(keys), "{name}");
        for line in lines.lines() {
            let (key, range) =
                (line.split(' ').next().expect("a key"), &line[line.rfind('(').expect("a range") + 1..line.len() - 1]);
            for end in range.split(", ") {
                let set = Values::from([(key.to_owned(), Value::Number(end.parse().expect("a number")))]);
                catalog::values(planner, None, &set).unwrap_or_else(|e| panic!("{name}: {e}"));
            }
        }
    }
}

#[test]
fn our_maps_have_a_path_without_cut_corners() {
    for name in names(&folder().join("maps"), "json") {
        let scenario = scenario(&folder().join(format!("maps/{name}.json")));
        assert_eq!(scenario.spec.movement.corner_rule, CornerRule::BothFree, "{name}");
        assert!(scenario.reachable() && !scenario.spec.name.is_empty(), "{name}");
        // By slices one goes above the ground: there are no corners.
        if scenario.by_slices().is_some() {
            continue;
        }
        // Around the walls: longer than on an open map, for every goal that is not in sight of the start.
        let (a, b) = (scenario.spec.start, scenario.spec.goals[0].at);
        let optimum = formicarium::exact::optimum(&Arc::new(scenario.leg(scenario.start, scenario.goal)));
        assert!(optimum.is_some_and(|o| o >= formicarium::map::octile(a, b)), "{name}");
    }
}

/// The rows of the suite's table: group, density, seeds.
fn suite() -> Vec<(String, f64, Vec<u32>)> {
    let readme = read(&folder().join("maps/README.md"));
    let table = readme.split("<!-- Made by `cargo xtask maps` -->").nth(1).expect("the suite's table");
    let table = table.split("<!-- End -->").next().unwrap_or_default();
    let row = |line: &str| {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let seeds = cells[4].split(", ").map(|seed| seed.parse().expect("a seed")).collect();
        // Terrains have the generator's own roughness.
        (cells[0].to_owned(), cells[3].parse().unwrap_or(0.5), seeds)
    };
    table.lines().filter(|line| line.starts_with("| ")).skip(1).map(row).collect()
}

#[test]
fn the_suite_is_what_the_generators_make() {
    let suite = suite();
    assert!(suite.len() >= 11, "{suite:?}");
    for (group, density, seeds) in &suite {
        assert!(seeds.len() >= 8 && seeds.is_sorted() && seeds[seeds.len() - 1] <= 1000, "{group}: {seeds:?}");
        for (place, &seed) in seeds.iter().enumerate() {
            let path = folder().join(format!("maps/{group}-{:02}.json", place + 1));
            let committed = scenario(&path);
            let name = &committed.spec.name;
            let (kind, rest) = name.split_once('-').expect("generator, size and seed");
            let kind = Generator::ALL.into_iter().find(|k| k.id() == kind).expect("a generator");
            let made = generate(kind, committed.spec.width, committed.spec.height, seed, *density).expect("a map");
            let (width, height) = (made.grid.width(), made.grid.height());
            assert_eq!(rest, format!("{width}x{height}-seed{seed}"), "{}", path.display());
            let (start, goals) = (committed.spec.start, committed.spec.goals.clone());
            let own = made.spec(name.clone());
            let mut spec = ScenarioSpec { start, goals, ..own };
            if kind.is_terrain() {
                if committed.by_slices().is_some() {
                    let rules = SliceRules::fitting_map(&made.grid, 1.0, start, spec.goals[0].at, None);
                    spec.terrain = Some(TerrainSpec { moves: TerrainMoves::Slices(rules), ..TerrainSpec::default() });
                } else {
                    spec.movement.moves = Moves::Sixteen;
                }
            }
            let bytes = formats::export(&made.grid, &spec, Export::Scenario);
            assert_eq!(read(&path), bytes, "{}: make it again with `cargo xtask maps`", path.display());
        }
    }
    // Every other file is one of those that are no part of it.
    let is_listed = |name: &String| {
        let of = name.rsplit_once('-').and_then(|(group, number)| Some((group, number.parse::<usize>().ok()?)));
        of.is_some_and(|(of, number)| suite.iter().any(|(group, _, seeds)| group == of && (1..=seeds.len()).contains(&number)))
    };
    let others: Vec<String> = names(&folder().join("maps"), "json").into_iter().filter(|name| !is_listed(name)).collect();
    assert_eq!(others, OTHER_MAPS);
}

/// So many maps that a verdict over maps can be given.
#[test]
fn no_claim_rests_on_one_map() {
    for name in names(&folder(), "toml") {
        let question = question(&name);
        for claim in &question.claims {
            let maps = question.instances.iter().filter(|i| claim.is_about(i)).count();
            assert!(maps >= 6, "{name}: {} is about {maps} maps", claim.id);
        }
    }
}

/// On public maps, which are not ours to commit: those that a record names, in the order of its runs.
#[test]
fn the_records_on_public_maps_are_what_the_engine_gives() {
    let Some(data) = std::env::var_os("FORMICARIUM_DATA") else {
        println!("skipped: FORMICARIUM_DATA is not set");
        return;
    };
    for (name, group) in
        [("classics", "plane"), ("fireworks", "criss-cross"), ("ship", "ship-20x20"), ("threshold", "environment-2")]
    {
        let record = folder().join(format!("records/public/{name}.csv"));
        let mut question = question(name);
        let files = grids_of(&read(&record));
        question.instances = files.iter().map(|(id, _)| instance(id, group)).collect();
        let ids: Vec<String> = files.iter().map(|(id, _)| id.clone()).collect();
        question.keep_instances(&ids).expect("instances");
        let papers = Path::new(&data).join("papers");
        let is_reversed = |place: usize| name == "threshold" && place % 2 == 1;
        let maps = files.iter().enumerate().map(|(place, (_, file))| grid(&papers.join(file), is_reversed(place))).collect();
        assert_recorded(&Comparison::new(question, maps).expect("the same entries"), &record, &[1, 100]);
    }
}

/// The maps of a record by their ids, with the files of the data folder that they stand for.
fn grids_of(record: &str) -> Vec<(String, String)> {
    let mut ids: Vec<&str> = record.lines().skip(1).filter_map(|line| line.split(',').next()).collect();
    ids.dedup();
    let file = |id: &str| format!("G{}.csv", id.trim_start_matches('g').replace('-', "_"));
    ids.into_iter().map(|id| (id.to_string(), file(id))).collect()
}

fn instance(id: &str, group: &str) -> Instance {
    Instance { id: id.into(), map: String::new(), note: String::new(), group: Some(group.into()) }
}

/// From corner to corner, or from the goal to the start.
fn grid(path: &Path, is_reversed: bool) -> Arc<Scenario> {
    let bytes = std::fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let mut map = formats::import(&bytes, &path.display().to_string()).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    if is_reversed {
        std::mem::swap(&mut map.spec.start, &mut map.spec.goals[0].at);
    }
    assert_eq!((map.spec.movement.corner_rule, map.grid.width()), (CornerRule::BothFree, 20));
    Arc::new(Scenario::new(map.grid, map.spec).expect("usable"))
}
