//! The questions on public maps alone: experiments/public.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

use formicarium::comparison::Comparison;
use formicarium::scenario::Scenario;

use super::{assert_recorded, assert_recorded_in_part, folder, names, question, read, scenario};

/// Of a question with many runs every seventh of the first seed is enough: each entry runs on some maps, and on each map some of them.
const OF_MANY: (usize, usize) = (10_000, 7);

/// What experiments/public/maps.txt says: a map's name, and what makes it, a file of the data folder and arguments of `convert`.
fn public_maps() -> BTreeMap<String, Vec<String>> {
    let list = read(&folder().join("public/maps.txt"));
    let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let lines = list.lines().filter(|line| !line.starts_with('#')).map(words);
    lines.map(|mut words| (words.remove(0), words)).collect()
}

/// One of them, made as its line says.
fn public_map(name: &str, made_by: &[String], data: &Path) -> Arc<Scenario> {
    let to = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("public-{name}.json"));
    let mut convert = Command::new(env!("CARGO_BIN_EXE_formicarium"));
    let output = convert.arg("convert").arg(data.join(&made_by[0])).arg(&to).args(&made_by[1..]).output().expect("the binary");
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    scenario(&to)
}

/// Without the maps, that they can be asked; with them, that the records are what the engine gives.
#[test]
fn questions_on_public_maps_alone_are_answered_by_their_records() {
    let (made_by, data) = (public_maps(), std::env::var_os("FORMICARIUM_DATA"));
    let names = names(&folder().join("public"), "toml");
    assert_eq!(names, ["gazebo", "own-colony"]);
    for name in names {
        let question = question(&format!("public/{name}"));
        question.check().unwrap_or_else(|e| panic!("{name}: {e}"));
        let stem =
            |map: &str| map.strip_prefix("maps/").and_then(|map| map.strip_suffix(".json")).expect("a public map").to_owned();
        let maps: Vec<String> = question.instances.iter().map(|i| stem(&i.map)).collect();
        assert!(maps.iter().all(|map| made_by.contains_key(map)), "{name}: {maps:?}");
        let record = folder().join(format!("records/public/{name}.csv"));
        let runs = question.instances.len() * question.runnable().len() * question.seeds.count as usize;
        assert_eq!(read(&record).lines().count(), 1 + runs, "{name}");
        assert!(read(&record.with_extension("md")).starts_with(&format!("# {}\n", question.title)), "{name}");
        let Some(data) = data.as_ref().map(Path::new) else { continue };
        let scenarios = maps.iter().map(|map| public_map(map, &made_by[map], data)).collect();
        let comparison = Comparison::new(question, scenarios).expect("a comparison");
        if runs < OF_MANY.0 {
            assert_recorded(&comparison, &record, &[1]);
        } else {
            assert_recorded_in_part(&comparison, &record, &[1], OF_MANY.1);
        }
    }
}
