//! Numbers that cannot be used are refused with the same words, whichever way they come in.
use serde_json::json;

use super::folder::Folder;

const NUMBERS: [&str; 6] = ["nan", "inf", "-inf", "-1", "0", "1e308"];

/// Ground with heights, walked on or moved over by slices.
fn scenario(field: &str, value: f64) -> String {
    let mut terrain = json!({ "vertical_unit": 1.0 });
    let mut resolution = 10.0;
    let rules = json!({ "level": 10.0, "levels": 20, "max_aside": 2, "max_climb": 2, "start_level": 2, "goal_level": 2, "measure": "cost" });
    match field {
        "--resolution" => resolution = value,
        "--max-slope" => terrain["max_slope"] = value.into(),
        "--vertical-unit" => terrain["vertical_unit"] = value.into(),
        _ => {
            terrain["slices"] = rules;
            terrain["slices"]["level"] = value.into();
        }
    }
    let map = json!({ "rows": ["...", "..."], "heights": [[10, 20, 10], [10, 10, 10]] });
    json!({ "format": "formicarium/scenario@1", "width": 3, "height": 2, "resolution": resolution, "start": [0, 0],
            "goals": [{ "at": [2, 0] }], "terrain": terrain, "map": map })
    .to_string()
}

#[test]
fn options_are_validated_as_the_fields_of_a_scenario_are() {
    let folder = Folder::with_map("quantities");
    folder.write("ground.asc", "ncols 3\nnrows 2\ncellsize 10\n10 20 10\n10 10 10\n");
    folder.write("path.csv", "0,0\n1,0\n2,0\n");
    folder.write("levels.csv", "0,0,2\n1,0,2\n2,0,2\n");
    for option in ["--resolution", "--max-slope", "--vertical-unit", "--level"] {
        let is_by_slices = option == "--level";
        let (path, planner) = if is_by_slices { ("levels.csv", "slices-exact") } else { ("path.csv", "astar") };
        let model = if is_by_slices { "slices" } else { "surface" };
        for number in NUMBERS {
            let value: f64 = number.parse().unwrap();
            let given = format!("{option}={number}");
            let check = folder.run(&["check", path, "--map", "ground.asc", "--model", model, &given]);
            let plan = folder.run(&["plan", "ground.asc", "--planner", planner, "--model", model, &given]);
            assert_eq!(check.code == 2, plan.code == 2, "{given}");
            let message = |said: &str| said.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned();
            assert!(check.code != 2 || message(&check.err) == message(&plan.err), "{given}: {} and {}", check.err, plan.err);
            if !value.is_finite() || value <= 0.0 {
                assert_eq!(check.code, 2, "{given}");
            }
            if !value.is_finite() {
                continue;
            }
            // JSON has no other numbers.
            folder.write("file.json", &scenario(option, value));
            let file = folder.run(&["check", path, "--map", "file.json"]);
            assert_eq!(file.code == 2, check.code == 2, "{given}: {}", file.err);
            // Of the resolution the parser of the arguments says the same in its own words.
            let same = message(&file.err).trim_start_matches("file.json: ") == message(&check.err);
            assert!(option == "--resolution" || check.code != 2 || same, "{given}: {} and {}", file.err, check.err);
        }
    }
}

#[test]
fn what_is_written_can_be_read_again() {
    let folder = Folder::with_map("written");
    folder.write("ground.asc", "ncols 3\nnrows 2\ncellsize 10\n10 20 10\n10 10 10\n");
    for number in NUMBERS.into_iter().chain(["1e-300"]) {
        let given = format!("--resolution={number}");
        for (from, to) in [("ground.asc", "a.json"), ("small.map", "b.json")] {
            if folder.run(&["convert", from, to, &given]).code == 0 {
                folder.run(&["convert", to, "again.json"]).ends(0);
            }
        }
        let density = format!("--density={number}");
        let usable = ["0", "1e-300"].contains(&number);
        folder.run(&["generate", "random", "--size", "9x9", &density]).ends(if usable { 0 } else { 2 });
    }
    folder.run(&["convert", "ground.asc", "c.json", "--resolution", "1e-300"]).ends(2).says(&["height in cells"]);
}
