//! `check`: audits of paths that somebody else has found.
use serde_json::Value;

use super::folder::Folder;

#[test]
fn check_audits_and_measures() {
    let folder = Folder::with_map("check");
    folder.write("good.csv", "x,y\n0,0\n1,0\n2,0\n3,0\n4,0\n4,1\n4,2\n4,3\n");
    folder.run(&["check", "good.csv", "--map", "small.map"]).ends(0).says(&["a valid path", "7.0000 cells", "turns         1"]);

    folder.write("bad.json", "[[0,3],[1,3],[2,2],[3,2],[4,2],[4,4],[0,0]]");
    let found = folder.run(&["check", "bad.json", "--map", "small.map", "--format", "json"]).ends(1).json();
    let count = |key: &str| found[key].as_array().unwrap().len();
    assert_eq!((count("collisions"), count("outside"), count("jumps"), count("corner_cuts")), (1, 1, 2, 1));
    assert_eq!((&found["ok"], &found["metrics"]), (&false.into(), &Value::Null));

    folder.write("cut.m", "path = [4 1; 4 2; 3 3];");
    let cut = ["check", "cut.m", "--map", "small.map", "--one-based", "--rows-first"];
    folder.run(&cut).ends(1).says(&["corner cuts   1, first at step 1 (1, 3) → (2, 2)", "length        2.4142"]);
    folder.run(&[&cut[..], &["--corner-rule", "one-free"]].concat()).ends(0);

    folder.run(&["convert", "small.map", "small.json"]).ends(0);
    folder.run(&["check", "good.csv", "--map", "small.json", "--moves", "4"]).ends(0);
    folder.run(&["check", "cut.m", "--map", "small.json"]).ends(1).says(&["not at the start (0, 0)"]);
    folder.write("words.csv", "0,0\none,1\n");
    folder.run(&["check", "words.csv", "--map", "small.map"]).ends(2).says(&["words.csv: line 2: `one` is no number"]);
    folder.run(&["check", "good.csv", "--map", "small.map", "--one-based"]).ends(2).says(&["does not count from 1"]);
}

#[test]
fn lengths_are_in_metres_too_where_the_map_has_a_scale() {
    let folder = Folder::with_map("check-metres");
    folder.write("good.csv", "x,y\n0,0\n1,0\n2,0\n3,0\n4,0\n4,1\n4,2\n4,3\n");
    folder.run(&["convert", "small.map", "small.json"]).ends(0);
    let scaled = folder
        .read("small.json")
        .replace("\"resolution\": 1.0", "\"resolution\": 0.5")
        .replace("\"speed\":1.0", "\"speed\":0.25");
    folder.write("scaled.json", &scaled);
    folder.run(&["check", "good.csv", "--map", "scaled.json"]).ends(0).says(&[
        "length        7.0000 cells = 3.5000 m\n",
        "turn index V = 7.2000 cells = 3.6000 m\n",
        "clearance     at least 1.00, on average 1.00 cells = at least 0.50, on average 0.50 m\n",
        "arrival time  14.00 s\n",
    ]);
    folder.run(&["check", "good.csv", "--map", "small.json"]).ends(0).says(&["7.0000 cells\n", "on average 1.00 cells\n"]);
    let plan = folder.run(&["plan", "scaled.json", "--moves", "4", "--planner", "astar"]).ends(0);
    plan.says(&["the optimum of 7.0000 cells = 3.5000 m (length by steps)"]);
}

#[test]
fn names_in_the_file_are_not_turned() {
    let folder = Folder::with_map("check-named");
    for (name, path) in [
        ("named.csv", "row,col\n0,0\n0,1\n"),
        ("named.json", r#"[{"row": 0, "col": 0}, {"row": 0, "col": 1}]"#),
        ("xy.csv", "x,y\n0,0\n1,0\n"),
    ] {
        folder.write(name, path);
        folder.run(&["check", name, "--map", "small.map", "--rows-first"]).ends(2).says(&["leave out --rows-first"]);
        folder.run(&["check", name, "--map", "small.map", "--polyline"]).says(&["2 points"]);
    }
}

#[test]
fn check_audits_polylines() {
    let folder = Folder::with_map("check-polyline");
    let check = ["check", "corners.csv", "--map", "small.map"];
    folder.write("corners.csv", "0,0\n4,0\n4,3\n");
    folder.run(&check).ends(1).says(&["jumps         2, first at step 0 (0, 0) → (4, 0)", "add --polyline"]);
    let polyline = |more: &[&str]| folder.run(&[&check[..], &["--polyline"], more].concat());
    let said =
        ["3 points of a polyline", "a valid polyline", "out of sight  none", "length        7.0000 cells", "turns         1"];
    polyline(&[]).ends(0).says(&said);
    folder.write("corners.csv", "0,0\n4,3\n3,3\n9,3\n0,3\n");
    polyline(&[]).ends(1).says(&[
        "not a valid polyline",
        "out of sight  1, first at segment 0 (0, 0) → (4, 3)",
        "first at cell 2 (3, 3)",
    ]);
    let found = polyline(&["--format", "json"]).ends(1).json();
    let count = |key: &str| found[key].as_array().unwrap().len();
    assert_eq!(
        (count("outside"), count("collisions"), count("out_of_sight"), count("jumps"), &found["kind"]),
        (1, 1, 1, 0, &"polyline".into())
    );
}

#[test]
fn check_asks_for_every_goal() {
    let folder = Folder::with_map("check-goals");
    let goals = r#"[{"at": [2, 0]}, {"at": [0, 1]}]"#;
    let map = r#"{"rows": ["...", "..."]}"#;
    folder.write(
        "two.json",
        &format!(
            r#"{{"format": "formicarium/scenario@1", "width": 3, "height": 2, "map": {map}, "start": [0, 0], "goals": {goals}}}"#
        ),
    );
    let check = |path: &str| {
        folder.write("path.csv", path);
        folder.run(&["check", "path.csv", "--map", "two.json", "--polyline"])
    };
    check("0,0\n2,0\n0,1\n").ends(0);
    check("0,0\n0,1\n").ends(1).says(&["the path misses the goal (2, 0)"]);
    check("0,0\n2,0\n0,1\n1,1\n").ends(1).says(&["not at the goal (2, 0) or (0, 1)"]);
}

#[test]
fn what_plan_prints_check_accepts() {
    let folder = Folder::with_map("plan-check");
    for kind in ["random", "maze", "rooms", "cave"] {
        folder.run(&["generate", kind, "--size", "30x20", "--seed", "4", "--out", "made.json"]).ends(0);
        for planner in ["astar", "ant-system", "ship", "theta-star", "any-angle", "turn-aware"] {
            let run = folder.run(&["plan", "made.json", "--planner", planner, "--format", "json"]);
            if run.code == 0 {
                folder.write("path.json", &run.out);
                folder.run(&["check", "path.json", "--map", "made.json"]).ends(0);
            }
        }
    }
}
