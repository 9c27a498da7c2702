//! `catalog`, `convert`, `generate` and `bench-scen`.
use std::path::Path;

use serde_json::Value;

use super::folder::{Folder, MAP, SCEN};
use super::schema;

#[test]
fn catalog_is_a_table_and_json() {
    let folder = Folder::with_map("catalog");
    folder.run(&["catalog"]).ends(0).says(&["ant-system · Ant System", "rho", "dijkstra", "--preset"]);
    let all = folder.run(&["catalog", "--json"]).ends(0).json();
    assert_eq!(schema::violations(&schema::load("catalog"), &all), Vec::<String>::new());
    folder.run(&["catalog", "fwa"]).ends(0).says(&["reading: as-read", "reading: printed", "reading: second-reading"]);
    let one = folder.run(&["catalog", "astar", "--json"]).ends(0).json();
    assert_eq!((one["planners"].as_array().unwrap().len(), &one["planners"][0]["id"]), (1, &"astar".into()));
    folder.run(&["catalog", "bee"]).ends(2).says(&["there is no planner `bee`"]);
}

#[test]
fn convert_goes_through_every_format_and_back() {
    let folder = Folder::with_map("convert");
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
fn generate_repeats_itself_and_checks_its_arguments() {
    let folder = Folder::with_map("generate");
    let make = |seed| folder.run(&["generate", "cave", "--size", "40x30", "--seed", seed]).ends(0).out;
    assert_eq!(make("1"), make("1"));
    assert_ne!(make("1"), make("2"));
    assert!(make("1").starts_with("type octile\nheight 30\nwidth 40\nmap\n"));
    folder.run(&["generate", "maze", "--size", "9x9", "--out", "maze.csv"]).ends(0);
    assert_eq!(folder.read("maze.csv").lines().count(), 9);
    folder.run(&["generate", "random", "--size", "9x9", "--density", "0.95"]).ends(2).says(&["density = 0.95"]);
    folder.run(&["generate", "random", "--size", "5000x9"]).ends(2).says(&["a map of 5000 × 9 cells"]);
    folder
        .run(&["generate", "forest", "--size", "9x9"])
        .ends(2)
        .says(&["random, maze, rooms, cave, blocks, bars, hills, fractal"]);
    folder.run(&["generate", "maze", "--size", "9"]).ends(2).says(&["40x30"]);
}

#[test]
fn generate_takes_ends_and_moves() {
    let folder = Folder::with_map("generate-ends");
    let make = |kind: &str, more: &[&str]| {
        folder.run(&[&["generate", kind, "--size", "20x20", "--density", "0.2", "--seed", "2"], more].concat())
    };
    let plain = make("blocks", &[]).ends(0).out;
    assert!(plain.starts_with("type octile\n"), "{plain}");
    // A scenario where something is asked, on the same map.
    let asked = make("blocks", &["--from", "19,19", "--to", "0,0", "--to", "3,10", "--moves", "4"]).ends(0).json();
    assert_eq!((&asked["start"], &asked["movement"]["moves"]), (&serde_json::json!([19, 19]), &4.into()));
    assert_eq!((&asked["goals"][1]["at"], &asked["name"]), (&serde_json::json!([3, 10]), &"blocks-20x20-seed2".into()));
    let rows: Vec<&str> = asked["map"]["rows"].as_array().unwrap().iter().map(|row| row.as_str().unwrap()).collect();
    assert_eq!(plain.lines().skip(4).collect::<Vec<_>>(), rows);
    folder.write("two.json", &serde_json::to_string(&asked).unwrap());
    let same = make("blocks", &["--ends-of", "two.json"]).ends(0).json();
    assert_eq!((&same["goals"], &same["start"], &same["movement"]["moves"]), (&asked["goals"], &asked["start"], &8.into()));
    make("blocks", &["--from", "19,19", "--as", "matrix"]).ends(0).says(&["not start (19, 19) and goal (19, 19)"]);
    // What is asked is not made fit.
    make("blocks", &["--from", "5,0"]).ends(2).says(&["the start (5, 0) lies on a blocked cell"]);
    make("blocks", &["--to", "20,0"]).ends(2).says(&["the goal (20, 0)"]);
    make("blocks", &["--ends-of", "two.json", "--from", "0,0"]).ends(2).says(&["cannot be used with"]);
    make("blocks", &["--model", "slices"]).ends(2).says(&["--model is for terrains"]);
    folder.run(&["generate", "maze", "--size", "9x9", "--from", "1,1", "--to", "1,1"]).ends(0).says(&["the same cell"]);
    let slices = ["--model", "slices", "--from", "0,10", "--to", "19,8", "--levels", "12"];
    let terrain = make("hills", &slices).ends(0).json();
    assert_eq!((&terrain["terrain"]["slices"]["levels"], &terrain["start"]), (&12.into(), &serde_json::json!([0, 10])));
}

#[test]
fn bench_scen_finds_the_map_and_names_what_does_not_fit() {
    let folder = Folder::with_map("bench");
    for planner in ["dijkstra", "astar", "formica"] {
        folder.run(&["bench-scen", "small.map.scen", "--planner", planner]).ends(0).says(&["2 of 2 scenarios, 100.0 %"]);
    }
    let unproven = folder.run(&["bench-scen", "small.map.scen", "--planner", "ant-system"]);
    unproven.ends(2).says(&["`ant-system` proves no optimum", "the planners that prove one are", "astar", "formica"]);
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
    folder.run(&["bench-scen", "lost.scen", "--map", "small.map"]).ends(0).says(&["of the map maps/other.map"]);

    // The second of the two scenarios is of another map.
    let (one, other) = SCEN.rsplit_once("small.map").unwrap();
    folder.write("mixed.scen", &format!("{one}other.map{other}"));
    let mixed = folder.run(&["bench-scen", "mixed.scen", "--map", "small.map"]).ends(0);
    mixed.says(&["passed over: 1 scenario of other maps (maps/other.map)", "1 of 1"]);
}

#[test]
fn bench_scen_without_a_planner_computes_lengths_alone() {
    let folder = Folder::with_map("bench-optimum");
    folder.run(&["bench-scen", "small.map.scen"]).ends(0).says(&["Optimum on small.map.scen", "2 of 2 scenarios, 100.0 %"]);
    let alone = folder.run(&["bench-scen", "small.map.scen", "--format", "json"]).ends(0).json();
    assert_eq!((&alone["planner"], &alone["matched"]), (&serde_json::Value::Null, &2.into()));
    let astar = folder.run(&["bench-scen", "small.map.scen", "--planner", "astar", "--format", "json"]).ends(0).json();
    assert_eq!((&astar["planner"], &astar["matched"]), (&"astar".into(), &2.into()));
    folder.run(&["bench-scen", "small.map.scen", "--planner", "astar"]).ends(0).says(&["A* on small.map.scen"]);
    assert_eq!(astar.get("proofs"), None);
}

#[test]
fn bench_scen_tells_what_is_proven_of_polylines() {
    let folder = Folder::with_map("bench-polylines");
    let bench = ["bench-scen", "small.map.scen", "--planner", "any-angle"];
    folder.run(&bench).ends(0).says(&["2 of 2 scenarios, 100.0 %", "proven        2 scenarios, 100.0 %; within a second"]);
    let told = folder.run(&[&bench[..], &["--format", "json"]].concat()).ends(0).json();
    assert_eq!((&told["proofs"]["proven"], &told["proofs"]["intervals"], &told["matched"]), (&2.into(), &0.into(), &2.into()));
    // Longer than the listed path by steps no polyline can be.
    folder.write("bad.scen", &SCEN.replace("7.00000", "1.00000"));
    folder
        .run(&["bench-scen", "bad.scen", "--map", "small.map", "--planner", "any-angle"])
        .ends(1)
        .says(&["the listed optimum is shorter"]);
}

#[test]
fn help_has_examples() {
    let folder = Folder::with_map("help");
    folder.run(&["--help"]).ends(0).says(&["Examples:", "Exit codes"]);
    for command in ["plan", "catalog", "convert", "check", "generate", "bench-scen", "submit", "tracker"] {
        folder.run(&[command, "--help"]).ends(0).says(&["Examples:", &format!("formicarium {command}")]);
    }
    assert!(Path::new(&folder.0).is_dir());
}
