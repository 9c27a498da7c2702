//! The real binary: every subcommand, its output, its errors and its exit codes.
#![cfg(not(target_arch = "wasm32"))]

#[path = "formats/schema.rs"]
mod schema;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

const MAP: &str = "type octile\nheight 4\nwidth 5\nmap\n.....\n.@@@.\n.@.@.\n...@.\n";
const SCEN: &str = "version 1\n1\tmaps/small.map\t5\t4\t0\t0\t4\t3\t7.00000\n0\tmaps/small.map\t5\t4\t0\t3\t2\t2\t3.00000\n";

/// A folder of its own for each test, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("formicarium-cli-{}-{test}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        let folder = Self(path);
        folder.write("small.map", MAP);
        folder.write("small.map.scen", SCEN);
        folder
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.join(name), text).unwrap();
    }

    fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.join(name)).unwrap()
    }

    /// Runs the binary in the folder.
    fn run(&self, args: &[&str]) -> Run {
        let output = Command::new(env!("CARGO_BIN_EXE_formicarium")).args(args).current_dir(&self.0).output().unwrap();
        Run::new(args, output)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// What a run said.
struct Run {
    code: i32,
    out: String,
    err: String,
}

impl Run {
    fn new(args: &[&str], output: Output) -> Self {
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        let (out, err) = (text(output.stdout), text(output.stderr));
        println!("formicarium {}\n{out}{err}", args.join(" "));
        Self { code: output.status.code().unwrap(), out, err }
    }

    fn ends(self, code: i32) -> Self {
        assert_eq!(self.code, code, "{}{}", self.out, self.err);
        self
    }

    fn json(&self) -> Value {
        serde_json::from_str(&self.out).unwrap_or_else(|e| panic!("{e}: {}", self.out))
    }

    fn says(self, wanted: &[&str]) -> Self {
        for text in wanted {
            assert!(self.out.contains(text) || self.err.contains(text), "`{text}` is not in\n{}{}", self.out, self.err);
        }
        self
    }
}

#[test]
fn plan_prints_text_json_and_csv() {
    let folder = Folder::new("plan");
    let plan = ["plan", "small.map", "--from", "0,0", "--to", "4,3", "--planner"];
    let with = |more: &[&str]| folder.run(&[&plan[..], more].concat());
    with(&["astar"]).ends(0).says(&["A* on small (5 × 4, 14 free cells)", "optimal (proven)", "7.0000 cells", "0.00 %"]);

    let result = with(&["ant-system", "--seed", "5", "--set", "ants=10", "--format", "json"]).ends(0).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!((&result["seed"], &result["optimum"], &result["length"]), (&5.into(), &7.0.into(), &7.0.into()));
    assert_eq!((&result["path"][0], &result["path"][7]), (&serde_json::json!([0, 0]), &serde_json::json!([4, 3])));

    let csv = with(&["ant-system", "--set", "iterations=7", "--set", "stagnation=0", "--format", "csv"]).ends(0).out;
    let rows: Vec<&str> = csv.lines().collect();
    assert_eq!(rows[0], "iteration,best_so_far,iteration_best,iteration_mean,iteration_worst,arrived");
    assert_eq!(rows.len(), 8);
}

#[test]
fn plan_shows_what_refinement_saves_and_what_no_polyline_can_beat() {
    let folder = Folder::new("refined");
    folder.write("open.csv", &"0,0,0,0,0,0,0,0\n".repeat(4));
    let plan = ["plan", "open.csv", "--from", "0,0", "--to", "7,3", "--planner"];
    let with = |more: &[&str]| folder.run(&[&plan[..], more].concat()).ends(0);
    // √(49 + 9) where nothing is in the way; 3√2 + 4 by steps, and V is 0.2 more when one straight step turns.
    let said = [
        "7.6158 cells (length of a polyline)",
        "unrefined     8.2426 cells by steps",
        "point robot   7.6158 cells",
        "steps         1",
    ];
    with(&["ship", "--set", "iterations=3"]).says(&said);
    with(&["ship", "--preset", "cells", "--set", "iterations=3"]).says(&["8.2426 cells (length by steps)"]);
    with(&["any-angle"]).says(&["optimal (proven)", "0.00 % above the optimum of 7.6158 cells"]);
    with(&["theta-star"]).says(&["complete (not proven)", "0.00 % above the optimum of 7.6158 cells"]);
    with(&["turn-aware"]).says(&["optimal (proven)", "turn index V = 8.4426 cells", "(turn index V)"]);

    let result = with(&["ship", "--set", "iterations=3", "--format", "json"]).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!((&result["objective"], &result["path"]), (&"polyline-length".into(), &serde_json::json!([[0, 0], [7, 3]])));
    let theta = with(&["theta-star", "--format", "json"]).json();
    assert_eq!(schema::violations(&schema::load("result"), &theta), Vec::<String>::new());

    folder.run(&["generate", "random", "--size", "65x65", "--out", "large.map"]).ends(0);
    let large = |planner| folder.run(&["plan", "large.map", "--planner", planner]);
    large("any-angle").ends(2).says(&["up to 4096 cells", "theta-star"]);
    large("theta-star").ends(0).says(&["a good result without a proof", "this one has 4225"]);
}

#[test]
fn plan_visits_several_goals_and_tells_their_order() {
    let folder = Folder::new("goals");
    folder.write("open.csv", &"0,0,0,0,0,0,0,0\n".repeat(4));
    let plan = ["plan", "open.csv", "--from", "3,0", "--to", "7,0", "--to", "0,0", "--planner"];
    let with = |more: &[&str]| folder.run(&[&plan[..], more].concat());
    // 3 to the left, then 7 to the right; the other way round 4 + 7.
    let said = ["(3, 0) → 2 goals", "order         (0, 0) → (7, 0)", "length 10.0000, weight R 10.0000 cells", "0.00 % above"];
    with(&["tour-exact"]).ends(0).says(&said);
    with(&["fire", "--set", "iterations=5"]).ends(0).says(&said);
    with(&["ant-system"]).ends(2).says(&["`ant-system` plans for 1 goal(s) at most; the scenario has 2"]);

    let result = with(&["fire", "--set", "iterations=5", "--set", "order=distance", "--format", "json"]).ends(0).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!((&result["objective"], &result["optimum"]), (&"tour-length".into(), &10.0.into()));
    assert_eq!(
        (&result["tour"]["order"], &result["tour"]["walked"]),
        (&serde_json::json!([1, 0]), &serde_json::json!([3.0, 7.0]))
    );

    // As many goals as the scenario has are moved and keep their names and weights, b = 1/8 and 1.
    let goals = r#"[{"at":[7,0],"name":"hall","area":8,"strength":1,"danger":1},{"at":[0,0],"name":"door"}]"#;
    let rows = r#"{"rows": ["........", "........"]}"#;
    let head = r#""format": "formicarium/scenario@1", "width": 8, "height": 2, "start": [3,1]"#;
    folder.write("named.json", &format!("{{{head}, \"goals\": {goals}, \"map\": {rows}}}"));
    // hall first: 3.4142/8 + 6.4142 = 6.84; door first: 3 + 6.4142/8 = 3.80.
    let named = folder.run(&["plan", "named.json", "--to", "6,0", "--to", "0,1", "--planner", "tour-exact"]);
    named.ends(0).says(&["order         door → hall", "3.0000    1.0000    3.0000", "0.1250"]);

    // More goals than can be ordered exactly.
    let many: Vec<String> = (0..17).map(|k| format!("{},{}", k % 8, k / 8 + 1)).collect();
    let to: Vec<&str> = many.iter().flat_map(|cell| ["--to", cell]).collect();
    let all =
        folder.run(&[&["plan", "open.csv", "--from", "0,0", "--planner", "fire", "--set", "iterations=5"], &to[..]].concat());
    all.ends(0).says(&["unknown: the best order is proven for up to 16 goals"]);
}

#[test]
fn the_same_seed_prints_the_same_bytes() {
    let folder = Folder::new("seed");
    let plan =
        |seed| folder.run(&["plan", "small.map", "--planner", "ant-system", "--seed", seed, "--format", "json"]).ends(0).out;
    assert_eq!(plan("3"), plan("3"));
    assert_ne!(plan("3"), plan("4"));
}

#[test]
fn plan_takes_its_scenario_from_four_places() {
    let folder = Folder::new("places");
    let length = |args: &[&str]| {
        folder.run(&[args, &["--planner", "dijkstra", "--format", "json"]].concat()).ends(0).json()["length"].clone()
    };
    assert_eq!(length(&["plan", "small.map", "--scen", "small.map.scen:3"]), 3.0);
    assert_eq!(length(&["plan", "small.map"]), 7.0);
    folder.run(&["convert", "small.map", "small.json"]).ends(0);
    assert_eq!(length(&["plan", "--scenario", "small.json"]), 7.0);
    assert_eq!(length(&["plan", "small.json", "--to", "2,2"]), 6.0);
    assert_eq!(
        length(&["plan", "small.json", "--from", "0,3", "--to", "2,2", "--corner-rule", "one-free"]),
        1.0 + std::f64::consts::SQRT_2
    );
    folder.write("open.csv", "0,0\n0,0\n");
    assert_eq!(length(&["plan", "open.csv", "--moves", "4"]), 2.0);
}

#[test]
fn a_scen_line_for_a_map_of_another_size_is_noticed() {
    let folder = Folder::new("size");
    folder.write("other.scen", &SCEN.replace("\t5\t4\t", "\t6\t4\t"));
    let said = &["made for a map of 6 × 4 cells, not of 5 × 4"];
    folder.run(&["plan", "small.map", "--scen", "other.scen:2", "--planner", "astar"]).ends(0).says(said);
}

#[test]
fn no_path_is_an_answer_with_code_1() {
    let folder = Folder::new("none");
    folder.write("wall.csv", "0,1,0\n0,1,0\n");
    let plan = ["plan", "wall.csv", "--from", "0,0", "--to", "2,0", "--planner"];
    let result = folder.run(&[&plan[..], &["astar", "--format", "json"]].concat()).ends(1).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!((&result["status"], &result["length"]), (&"no-path".into(), &Value::Null));
    folder.run(&[&plan[..], &["ant-system"]].concat()).ends(1).says(&["note: no path leads from start to goal"]);
}

#[test]
fn unusable_input_ends_with_code_2_and_a_hint() {
    let folder = Folder::new("errors");
    folder.write("broken.map", &MAP.replace(".@@@.", ".@@."));
    let cases: [(&[&str], &str, &str); 12] = [
        (&["plan", "none.map", "--planner", "astar"], "cannot read none.map", "check the name"),
        (&["plan", "broken.map", "--planner", "astar"], "broken.map: line 6: the row has 4 cells", "expected 5 terrain letters"),
        (&["plan", "small.map", "--planner", "bee"], "there is no planner `bee`", "ant-system"),
        (
            &["plan", "small.map", "--planner", "ant-system", "--set", "rho=1.5"],
            "rho = 1.5 is outside 0 to 1",
            "choose rho between",
        ),
        (&["plan", "small.map", "--planner", "ant-system", "--set", "rhoo=1"], "no parameter `rhoo`", "rho"),
        (&["plan", "small.map", "--planner", "ant-system", "--preset", "mine"], "no preset `mine`", "its presets are"),
        (&["plan", "small.map", "--planner", "astar", "--from", "1,1"], "start (1, 1) lies on a blocked cell", "move it"),
        (&["plan", "small.map", "--planner", "astar", "--to", "5,0"], "goal (5, 0) lies outside", "columns run from 0 to 4"),
        (&["plan", "small.map", "--planner", "astar", "--scen", "small.map.scen:1"], "no scenario in line 1", "FILE:LINE"),
        (&["bench-scen", "small.map.scen", "--planner", "ant-system"], "proves no optimum", "dijkstra, astar"),
        (&["convert", "small.map", "small.xyz"], "tells no format", "--as"),
        (&["plan", "small.map.scen", "--planner", "astar"], "a list of MovingAI scenarios, not a map", "open the map"),
    ];
    for (args, message, hint) in cases {
        let run = folder.run(args).ends(2);
        assert!(run.err.contains("error: ") && run.err.contains("\nhint: "), "{}", run.err);
        run.says(&[message, hint]);
    }
    for args in [&["plan", "small.map"][..], &["plan", "small.map", "--planner", "astar", "--from", "1"], &["fly"], &[]] {
        folder.run(args).ends(2);
    }
}

#[test]
fn errors_come_as_json_where_json_was_asked_for() {
    let folder = Folder::new("json-errors");
    let run = folder.run(&["plan", "small.map", "--planner", "ant-system", "--set", "rho=2", "--format", "json"]).ends(2);
    let error = &run.json()["error"];
    assert_eq!((&error["kind"], &error["field"], &error["args"]["max"]), (&"out-of-range".into(), &"rho".into(), &"1".into()));
    assert!(run.err.contains("error: rho = 2"));
}

#[test]
fn catalog_is_a_table_and_json() {
    let folder = Folder::new("catalog");
    folder.run(&["catalog"]).ends(0).says(&["ant-system · Ant System", "rho", "dijkstra", "--preset"]);
    let all = folder.run(&["catalog", "--json"]).ends(0).json();
    assert_eq!(schema::violations(&schema::load("catalog"), &all), Vec::<String>::new());
    let one = folder.run(&["catalog", "astar", "--json"]).ends(0).json();
    assert_eq!((one["planners"].as_array().unwrap().len(), &one["planners"][0]["id"]), (1, &"astar".into()));
    folder.run(&["catalog", "bee"]).ends(2).says(&["there is no planner `bee`"]);
}

#[test]
fn convert_goes_through_every_format_and_back() {
    let folder = Folder::new("convert");
    for (from, to) in [("small.map", "a.csv"), ("a.csv", "b.json"), ("b.json", "c.map")] {
        folder.run(&["convert", from, to]).ends(0);
    }
    assert_eq!(folder.read("c.map"), MAP);
    assert_eq!(folder.run(&["convert", "small.map", "-", "--as", "matrix"]).ends(0).out.lines().next(), Some("0,0,0,0,0"));
    folder.run(&["convert", "small.map", "s.scen"]).ends(0);
    assert_eq!(folder.read("s.scen"), "version 1\n1\tsmall.map\t5\t4\t0\t0\t4\t3\t7.00000000\n");
    folder.run(&["convert", "small.map", "inverted.csv", "--invert"]).ends(0);
    assert_eq!(folder.read("inverted.csv").lines().next(), Some("1,1,1,1,1"));
    folder.write("ends.csv", "2,1\n1,3\n");
    folder.run(&["convert", "ends.csv", "ends.json", "--invert"]).ends(0);
    let ends: Value = serde_json::from_str(&folder.read("ends.json")).unwrap();
    assert_eq!((&ends["map"]["rows"][0], &ends["goals"][0]["at"]), (&"..".into(), &serde_json::json!([1, 1])));
    folder.run(&["convert", "ends.csv", "wall.scen"]).ends(2).says(&["no path leads from start to goal"]);
}

#[test]
fn check_audits_and_measures() {
    let folder = Folder::new("check");
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
fn check_audits_polylines() {
    let folder = Folder::new("check-polyline");
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
    let folder = Folder::new("check-goals");
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
    let folder = Folder::new("plan-check");
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

#[test]
fn generate_repeats_itself_and_checks_its_arguments() {
    let folder = Folder::new("generate");
    let make = |seed| folder.run(&["generate", "cave", "--size", "40x30", "--seed", seed]).ends(0).out;
    assert_eq!(make("1"), make("1"));
    assert_ne!(make("1"), make("2"));
    assert!(make("1").starts_with("type octile\nheight 30\nwidth 40\nmap\n"));
    folder.run(&["generate", "maze", "--size", "9x9", "--out", "maze.csv"]).ends(0);
    assert_eq!(folder.read("maze.csv").lines().count(), 9);
    folder.run(&["generate", "random", "--size", "9x9", "--density", "0.95"]).ends(2).says(&["density = 0.95"]);
    folder.run(&["generate", "random", "--size", "5000x9"]).ends(2).says(&["a map of 5000 × 9 cells"]);
    folder.run(&["generate", "forest", "--size", "9x9"]).ends(2).says(&["random, maze, rooms, cave, fractal, hills"]);
    folder.run(&["generate", "maze", "--size", "9"]).ends(2).says(&["40x30"]);
}

/// Ground of 10 m with a ridge of 40 m in the middle column, whose lower end has no data.
const RIDGE: &str = "ncols 5\nnrows 3\ncellsize 10\n10 10 40 10 10\n10 10 20 10 10\n10 10 -9999 10 10\n";

#[test]
fn plan_walks_on_terrains() {
    let folder = Folder::new("terrain");
    folder.write("ridge.asc", RIDGE);
    let plan = |more: &[&str]| {
        folder.run(&[&["plan", "ridge.asc", "--from", "0,1", "--to", "4,1", "--planner", "astar"], more].concat())
    };
    // Two flat steps, and two of 10 m over 10 m: 2 + 2·√2.
    plan(&[]).ends(0).says(&["4.8284 cells along the ground = 48.2843 m", "10.0 m up, 10.0 m down, at most 45.0°"]);
    plan(&["--moves", "16"]).ends(0);
    // Cells of 20 m: two flat steps, and two of 10 m over 20 m, 2 + 2·√1.25.
    plan(&["--resolution", "20"]).ends(0).says(&["4.2361 cells along the ground = 84.7214 m"]);
    folder.run(&["convert", "ridge.asc", "wide.asc", "--resolution", "30"]).ends(0);
    assert!(folder.read("wide.asc").contains("cellsize 30"));
    plan(&["--resolution", "0"]).ends(2).says(&["a positive number of metres"]);
    plan(&["--max-slope", "34"]).ends(1).says(&["no path leads from start to goal"]);
    plan(&["--vertical-unit", "0.5"]).ends(0).says(&["5.0 m up", "at most 26.6°"]);
    let result = plan(&["--format", "json"]).ends(0).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!((&result["altitudes"], &result["levels"]), (&serde_json::json!([10.0, 10.0, 20.0, 10.0, 10.0]), &Value::Null));
    for (more, message, hint) in [
        (&["--max-slope", "0"][..], "max_slope = 0", "above 0"),
        (&["--level", "5"], "--level says nothing about moving on the surface", "--model slices"),
        (&["--model", "slices", "--max-slope", "30"], "--max-slope says nothing", "--model surface"),
        (&["--model", "slices"], "`astar` does not plan", ""),
    ] {
        plan(more).ends(2).says(&[message, hint]);
    }
    folder.run(&["plan", "small.map", "--planner", "astar", "--model", "slices"]).ends(2).says(&["--model is for terrains"]);
}

#[test]
fn plan_moves_by_slices() {
    let folder = Folder::new("slices");
    folder.write("ridge.asc", RIDGE);
    let plan = |more: &[&str]| {
        let slices = ["plan", "ridge.asc", "--from", "0,1", "--to", "4,1", "--planner", "slices-exact", "--model", "slices"];
        folder.run(&[&slices[..], more].concat())
    };
    // Levels of 10 m, start and goal at level 2 above the ground of 10 m. The ridge lies at level 2 in the row, so level 3 is free there:
    // 1 + √2 + √2 + 1, and the levels 2 + 3 + 2 + 2.
    let flat = ["--level", "10", "--measure", "cost"];
    plan(&flat).ends(0).says(&["optimal (proven)", "level cost    13.8284"]);
    let result = plan(&[&flat[..], &["--format", "json"]].concat()).ends(0).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!((&result["objective"], &result["levels"]), (&"slice-cost".into(), &serde_json::json!([2, 2, 3, 2, 2])));
    assert_eq!(result["altitudes"], serde_json::json!([20.0, 20.0, 30.0, 20.0, 20.0]));
    plan(&["--level", "10", "--levels", "2"]).ends(1).says(&["no path"]);
    plan(&["--level", "10", "--from-level", "1", "--max-aside", "0"]).ends(0);
    plan(&["--level", "20", "--from-level", "0"]).ends(2).says(&["start_level = 0"]);
    plan(&["--level", "4", "--from-level", "1"])
        .ends(2)
        .says(&["the start at level 1 lies below the ground", "the lowest level there is 3"]);

    folder.write("path.json", &result.to_string());
    let check = |more: &[&str]| folder.run(&[&["check", "path.json", "--map", "ridge.asc"], more].concat());
    check(&["--model", "slices", "--level", "10"]).ends(0).says(&["5 places on ridge (by slices)", "a valid path", "13.8284"]);
    check(&["--model", "slices", "--level", "15"]).ends(0);
    check(&["--model", "slices", "--level", "6"])
        .ends(1)
        .says(&["not a valid path", "step 1 of the path, from (1, 1) to (2, 1)"]);
    check(&[]).ends(2).says(&["the path has levels, and here one moves on the ground", "--model slices"]);
}

#[test]
fn check_audits_paths_on_the_ground() {
    let folder = Folder::new("check-terrain");
    folder.write("ridge.asc", RIDGE);
    folder.write("over.csv", "0,0\n1,0\n2,0\n3,0\n4,0\n");
    let check = |more: &[&str]| folder.run(&[&["check", "over.csv", "--map", "ridge.asc"], more].concat());
    check(&[]).ends(0).says(&["too steep     none", "30.0 m up, 30.0 m down, at most 71.6°"]);
    check(&["--max-slope", "60"]).ends(1).says(&["too steep     2, first at step 1 (1, 0) → (2, 0)"]);
    check(&["--model", "slices"]).ends(2).says(&["the path has no levels", "--model surface"]);
    folder.write("over.csv", "0,2\n1,2\n2,2\n");
    check(&["--max-slope", "60"]).ends(1).says(&["collisions    1", "too steep     none"]);
    folder.write("over.csv", "0,1\n2,0\n");
    check(&["--moves", "16"]).ends(0).says(&["16 moves"]);
    check(&["--moves", "8"]).ends(1);
}

#[test]
fn convert_carries_heights_and_takes_pieces() {
    let folder = Folder::new("convert-terrain");
    folder.write("ridge.asc", RIDGE);
    for (from, to) in [("ridge.asc", "a.tif"), ("a.tif", "b.json"), ("b.json", "c.csv"), ("c.csv", "d.csv"), ("b.json", "e.asc")]
    {
        folder.run(&["convert", from, to]).ends(0);
    }
    assert_eq!(folder.read("d.csv"), "10,10,40,10,10\n10,10,20,10,10\n10,10,-9999,10,10\n");
    assert!(folder.read("e.asc").contains("cellsize 10\nNODATA_value -9999\n10 10 40 10 10\n"), "{}", folder.read("e.asc"));
    folder.run(&["convert", "ridge.asc", "piece.csv", "--crop", "1,0,3,2"]).ends(0);
    assert_eq!(folder.read("piece.csv"), "10,40,10\n10,20,10\n");
    folder.run(&["convert", "b.json", "piece.json", "--crop", "0,0,4,2", "--size", "2x1"]).ends(0);
    let piece: Value = serde_json::from_str(&folder.read("piece.json")).unwrap();
    assert_eq!((&piece["resolution"], &piece["map"]["heights"]), (&20.0.into(), &serde_json::json!([[10.0, 20.0]])));
    folder.run(&["convert", "small.map", "window.map", "--crop", "1,1,3,2"]).ends(0);
    assert_eq!(folder.read("window.map"), "type octile\nheight 2\nwidth 3\nmap\n@@@\n@.@\n");
    folder.run(&["convert", "ridge.asc", "plane.map"]).ends(0).says(&["this format holds no heights"]);
    folder.run(&["convert", "ridge.asc", "plane.csv", "--as", "matrix"]).ends(0);
    assert_eq!(folder.read("plane.csv").lines().last(), Some("0,0,1,0,0"));
    folder.run(&["convert", "ridge.asc", "flat.scen"]).ends(0);
    folder.run(&["convert", "ridge.asc", "a.hgt"]).ends(2).says(&["size: 5 × 3 cells", "1201 × 1201"]);
    folder.run(&["convert", "ridge.asc", "b.csv", "--crop", "4,0,2,1"]).ends(2).says(&["does not lie within 5 × 3 cells"]);
    folder.run(&["convert", "ridge.asc", "b.csv", "--crop", "4,0,2"]).ends(2).says(&["10,20,40,30"]);
    folder.run(&["convert", "ridge.asc", "b.csv", "--size", "0x2"]).ends(2).says(&["a map of 0 × 2 cells"]);
}

#[test]
fn generate_makes_terrains() {
    let folder = Folder::new("generate-terrain");
    for kind in ["fractal", "hills"] {
        let make = |more: &[&str]| folder.run(&[&["generate", kind, "--size", "21x15"], more].concat()).ends(0).out;
        assert_eq!(make(&[]), make(&["--roughness", "0.5"]));
        assert_ne!(make(&[]), make(&["--density", "0.8"]));
        folder.write("made.json", &make(&["--seed", "3"]));
        folder.run(&["plan", "made.json", "--planner", "astar"]).ends(0).says(&["cells along the ground"]);
        folder.run(&["plan", "made.json", "--planner", "slices-exact", "--model", "slices"]).ends(0);
        folder.run(&["generate", kind, "--size", "21x15", "--seed", "3", "--out", "made.tif"]).ends(0);
        folder.run(&["convert", "made.tif", "back.csv"]).ends(0);
        folder.run(&["generate", kind, "--size", "21x15", "--seed", "3", "--out", "made.csv"]).ends(0);
        assert_eq!(folder.read("made.csv"), folder.read("back.csv"));
    }
    folder.run(&["generate", "hills", "--size", "9x9", "--roughness", "0.95"]).ends(2).says(&["roughness = 0.95"]);
}

#[test]
fn bench_scen_finds_the_map_and_names_what_does_not_fit() {
    let folder = Folder::new("bench");
    for planner in ["dijkstra", "astar"] {
        folder.run(&["bench-scen", "small.map.scen", "--planner", planner]).ends(0).says(&["2 of 2 scenarios, 100.0 %"]);
    }
    let one = folder.run(&["bench-scen", "small.map.scen", "--sample", "1", "--seed", "3", "--format", "json"]).ends(0).json();
    assert_eq!((&one["run"], &one["scenarios"], &one["matched"]), (&1.into(), &2.into(), &1.into()));

    let bad = SCEN.replace("7.00000", "6.99990").replace("\t0\t3\t2\t2\t", "\t1\t1\t2\t2\t");
    folder.write("bad.scen", &bad);
    let said = [
        "0 of 2",
        "line 2: listed 6.9999, found 7.00000: the listed optimum is shorter",
        "line 3: the start (1, 1) lies on a blocked cell",
    ];
    folder.run(&["bench-scen", "bad.scen"]).ends(1).says(&said);
    folder.run(&["bench-scen", "small.map.scen", "--corner-rule", "one-free"]).ends(1).says(&["the listed optimum is longer"]);

    folder.write("lost.scen", &SCEN.replace("small.map", "other.map"));
    folder.run(&["bench-scen", "lost.scen"]).ends(2).says(&["`other.map` is not beside", "--map"]);
    folder.run(&["bench-scen", "lost.scen", "--map", "small.map"]).ends(0);
}

#[test]
fn help_has_examples() {
    let folder = Folder::new("help");
    folder.run(&["--help"]).ends(0).says(&["Examples:", "Exit codes"]);
    for command in ["plan", "catalog", "convert", "check", "generate", "bench-scen"] {
        folder.run(&[command, "--help"]).ends(0).says(&["Examples:", &format!("formicarium {command}")]);
    }
    assert!(Path::new(&folder.0).is_dir());
}
