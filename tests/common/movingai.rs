//! Scenarios of MovingAI's maps. The files are those of the data folder that the environment variable FORMICARIUM_DATA names; they may not be
//! redistributed, so without the variable tests that need them are skipped, aloud.
#![allow(dead_code, reason = "every test file uses a part of it")]

use std::path::{Path, PathBuf};
use std::sync::Arc;

use formicarium::formats::{ScenLine, import, import_scen};
use formicarium::map::Movement;
use formicarium::scenario::{Goal, Scenario};

/// Random cells, rooms, mazes, games, a city, a warehouse.
pub const MAPS: [&str; 13] = [
    "random-32-32-20-random-1",
    "room-64-64-16-random-1",
    "maze-128-128-10-random-1",
    "32room_000.map",
    "maze512-8-0.map",
    "random512-25-0.map",
    "den312d.map",
    "lak303d.map",
    "brc202d.map",
    "arena.map",
    "arena2.map",
    "Berlin_0_256.map",
    "warehouse-10-20-10-2-1-random-1",
];

/// The folder of MovingAI's files; none where nobody says where it is.
pub fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("FORMICARIUM_DATA").map(|f| PathBuf::from(f).join("movingai"));
    if folder.is_none() {
        println!("skipped: FORMICARIUM_DATA is not set, so there are no MovingAI files to plan on");
    }
    folder
}

/// The longer half of a map's scenarios, and one of them.
fn load(scen: &Path) -> (Vec<ScenLine>, Scenario) {
    let mut lines = import_scen(&std::fs::read(scen).expect("the file")).expect("a list").lines;
    let name = lines[0].map.rsplit('/').next().expect("a name").to_string();
    let map = import(&std::fs::read(scen.with_file_name(&name)).expect("its map"), &name).expect("a map");
    lines.sort_by(|a, b| a.optimal.total_cmp(&b.optimal));
    let half = lines.split_off(lines.len() / 2);
    let scenario = Scenario::on(map.grid, Movement::default(), half[0].start, half[0].goal).expect("usable");
    (half, scenario)
}

/// So many scenarios of a map, or as many as there are, spread evenly over its longer half.
pub fn spread(folder: &Path, map: &str, count: usize) -> impl Iterator<Item = Arc<Scenario>> {
    let (lines, scenario) = load(&folder.join(format!("{map}.scen")));
    let count = count.min(lines.len());
    (0..count).map(move |k| {
        let line = &lines[k * lines.len() / count];
        Arc::new(scenario.with_ends(line.start, vec![Goal::new(line.goal, "")]).expect("usable"))
    })
}
