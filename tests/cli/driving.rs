//! Curves and driving measures of `plan`, `check` and `compare`.
use serde_json::Value;

use super::folder::{Folder, QUESTION};
use super::schema;

const PLAN: [&str; 8] = ["plan", "small.map", "--planner", "astar", "--from", "0,0", "--to", "4,3"];

#[test]
fn plan_tells_how_the_path_is_to_drive() {
    let folder = Folder::with_map("driving");
    folder.run(&PLAN).ends(0).says(&["turning       ", "largest curvature ", "smoothness    ", "energy        "]);
    let result = folder.run(&[&PLAN[..], &["--format", "json"]].concat()).ends(0).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    let driving = &result["metrics"]["driving"];
    assert!(driving["turning"].as_f64() > Some(0.0) && driving["energy"].as_f64() > result["metrics"]["length_metres"].as_f64());
    assert_eq!(result.get("smoothed"), None, "nobody has asked for a curve");
}

#[test]
fn smooth_gives_a_curve_and_changes_nothing_else() {
    let folder = Folder::with_map("smooth");
    let json = |more: &[&str]| folder.run(&[&PLAN[..], &["--format", "json"], more].concat()).ends(0).json();
    let (plain, free, bound) = (json(&[]), json(&["--smooth"]), json(&["--smooth=1.5"]));
    for curved in [&free, &bound] {
        assert_eq!(schema::violations(&schema::load("result"), curved), Vec::<String>::new());
        let mut rest = curved.clone();
        let curve = rest.as_object_mut().expect("an object").remove("smoothed").expect("a curve");
        assert_eq!(rest, plain, "digest, path and measures stay");
        assert_eq!(curve["points"][0], serde_json::json!([0.0, 0.0]));
        assert_eq!((&curve["meets_bound"], &curve["is_curve"]), (&true.into(), &true.into()));
    }
    assert!(bound["smoothed"]["largest_curvature"].as_f64() <= Some(1.5));
    let text = |smooth: &str| folder.run(&[&PLAN[..], &[smooth]].concat()).ends(0);
    text("--smooth").says(&["smoothed      ", "less than the path", "without a bound"]);
    text("--smooth=1.5").says(&["within the bound of 1.5"]);
    text("--smooth=0.01").says(&["above the bound of 0.01: no wider turn is free"]);
    for wrong in ["--smooth=-1", "--smooth=wide", "--smooth=NaN"] {
        folder.run(&[&PLAN[..], &[wrong]].concat()).ends(2).says(&["is no curvature"]);
    }
}

#[test]
fn the_maps_own_rule_counts_where_no_curvature_is_given() {
    let folder = Folder::with_map("own-rule");
    folder.run(&["convert", "small.map", "small.json", "--from", "0,0", "--to", "4,3"]).ends(0);
    let with_rule = folder
        .read("small.json")
        .replace("\"seconds_per_turn\":0.0", "\"seconds_per_turn\":0.0,\"smoothing\":{\"max_curvature\":0.01}");
    folder.write("rule.json", &with_rule);
    for more in [&[][..], &["--smooth"]] {
        folder.run(&[&["plan", "rule.json", "--planner", "astar"], more].concat()).ends(0).says(&["above the bound of 0.01"]);
    }
    folder.run(&["plan", "rule.json", "--planner", "astar", "--smooth=0"]).ends(0).says(&["without a bound"]);
}

#[test]
fn check_gives_the_curve_of_a_path_without_a_flaw() {
    let folder = Folder::with_map("check-smooth");
    folder.write("good.csv", "x,y\n0,0\n1,0\n2,0\n3,0\n4,0\n4,1\n4,2\n4,3\n");
    let check = ["check", "good.csv", "--map", "small.map"];
    folder.run(&[&check[..], &["--smooth=2"]].concat()).ends(0).says(&["turning       1.5708 rad = 90°", "smoothed      "]);
    let json = |more: &[&str]| folder.run(&[&check[..], &["--format", "json"], more].concat()).json();
    let found = json(&["--smooth"]);
    assert_eq!(found["smoothed"]["points"][0], serde_json::json!([0.0, 0.0]));
    assert_eq!(json(&[]).get("smoothed"), None);
    folder.write("good.csv", "x,y\n0,0\n1,0\n2,2\n");
    assert_eq!(json(&["--smooth"]).get("smoothed"), None);
}

#[test]
fn rows_tell_how_a_path_is_to_drive_where_that_is_asked_for() {
    let folder = Folder::with_question("driving-rows");
    let rows = |file: &str| -> Vec<Value> {
        let document: Value = serde_json::from_str(&folder.read(file)).expect("JSON");
        document["rows"].as_array().expect("rows").clone()
    };
    assert_eq!(folder.compare(&["q.toml", "--out", "out", "--seeds", "2"]).0, 0);
    let before = rows("out/q.json");
    assert!(before.iter().all(|row| row["found"].get("driving").is_none()), "a question of before keeps its bytes");
    folder.write("q.toml", &QUESTION.replacen("measure = \"length\"", "measure = \"turning\"", 1));
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--seeds", "2"]);
    assert!(code == 0 && said.contains("turning angle"), "{said}");
    for (mut row, before) in rows("out/q.json").into_iter().zip(before) {
        if let Some(found) = row["found"].as_object_mut() {
            let driving = found.remove("driving").expect("a claim asks for it");
            assert!(driving["turning"].as_f64() >= Some(0.0) && driving["energy"].as_f64() > Some(0.0));
        }
        assert_eq!(row, before, "everything else stays");
    }
}
