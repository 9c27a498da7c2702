//! The committed questions: every one can be asked, and its record is what the engine gives today.
#![cfg(not(target_arch = "wasm32"))]

use std::path::{Path, PathBuf};
use std::sync::Arc;

use formicarium::comparison::report::{HEADER, line};
use formicarium::comparison::{Comparison, Question, Task};
use formicarium::formats;
use formicarium::map::CornerRule;
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
    let maps = question.instances.iter().map(|i| scenario(&folder().join(&i.map))).collect();
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
