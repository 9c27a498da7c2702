//! The committed questions: every one can be asked, and its record is what the engine gives today.
#![cfg(not(target_arch = "wasm32"))]

use std::path::{Path, PathBuf};
use std::sync::Arc;

use formicarium::catalog;
use formicarium::comparison::report::{HEADER, line};
use formicarium::comparison::{Comparison, Question, Task};
use formicarium::formats;
use formicarium::map::CornerRule;
use formicarium::params::{Value, Values};
use formicarium::scenario::Scenario;

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
    let recorded = read(record);
    let lines: Vec<&str> = recorded.lines().collect();
    let tasks = comparison.tasks();
    assert_eq!((lines[0], lines.len()), (HEADER, 1 + tasks.len()), "{}", record.display());
    let sample = |task: &&(usize, Task)| seeds.contains(&task.1.seed);
    let mut changed = Vec::new();
    for (place, task) in tasks.into_iter().enumerate().collect::<Vec<_>>().iter().filter(sample) {
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
        // Around the walls: longer than on an open map, for every goal that is not in sight of the start.
        let (a, b) = (scenario.spec.start, scenario.spec.goals[0].at);
        let optimum = formicarium::exact::optimum(&Arc::new(scenario.leg(scenario.start, scenario.goal)));
        assert!(optimum.is_some_and(|o| o >= formicarium::map::octile(a, b)), "{name}");
    }
}

/// On a public grid that is not ours to commit.
#[test]
fn the_records_on_the_classic_grid_are_what_the_engine_gives() {
    let Some(data) = std::env::var_os("FORMICARIUM_DATA") else {
        println!("skipped: FORMICARIUM_DATA is not set");
        return;
    };
    let grid = scenario(&Path::new(&data).join("papers/G20_classic.csv"));
    assert_eq!((grid.spec.movement.corner_rule, grid.grid.width()), (CornerRule::BothFree, 20));
    let asked = [("ship", "ship-20x20"), ("threshold", "threshold-2"), ("classics", "criss-cross"), ("fireworks", "criss-cross")];
    for (name, instance) in asked {
        let mut question = question(name);
        question.keep_instances(&[instance.into()]).expect("an instance");
        let comparison = Comparison::new(question, vec![Arc::clone(&grid)]).expect("the same entries");
        assert_recorded(&comparison, &folder().join(format!("records/G20_classic/{name}.csv")), &[1, 2, 50]);
    }
}
