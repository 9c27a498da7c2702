//! MovingAI's files, which may not be redistributed: those of the data folder that the environment variable FORMICARIUM_DATA names.

use std::path::{Path, PathBuf};

use formicarium::formats::{ScenLine, import, import_scen};
use formicarium::map::Movement;
use formicarium::scenario::Scenario;

/// The folder; without the variable none, which is said.
pub fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("FORMICARIUM_DATA").map(|f| PathBuf::from(f).join("movingai"));
    if folder.is_none() {
        println!("skipped: FORMICARIUM_DATA is not set, so there are no MovingAI files to plan on");
    }
    folder
}

/// The longer half of a map's scenarios, and one of them.
pub fn load(scen: &Path) -> (Vec<ScenLine>, Scenario) {
    let mut lines = import_scen(&std::fs::read(scen).expect("the file")).expect("a list").lines;
    let name = lines[0].map.rsplit('/').next().expect("a name").to_string();
    let map = import(&std::fs::read(scen.with_file_name(&name)).expect("its map"), &name).expect("a map");
    lines.sort_by(|a, b| a.optimal.total_cmp(&b.optimal));
    let half = lines.split_off(lines.len() / 2);
    let scenario = Scenario::on(map.grid, Movement::default(), half[0].start, half[0].goal).expect("usable");
    (half, scenario)
}
