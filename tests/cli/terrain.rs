//! Ground with heights: walked on, moved over by slices, audited, converted and made.
use serde_json::Value;

use super::folder::Folder;
use super::schema;

/// Ground of 10 m with a ridge of 40 m in the middle column, whose lower end has no data.
const RIDGE: &str = "ncols 5\nnrows 3\ncellsize 10\n10 10 40 10 10\n10 10 20 10 10\n10 10 -9999 10 10\n";

#[test]
fn plan_walks_on_terrains() {
    let folder = Folder::with_map("terrain");
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
    let folder = Folder::with_map("slices");
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
    let folder = Folder::with_map("check-terrain");
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
    let folder = Folder::with_map("convert-terrain");
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
fn cells_of_degrees_become_square_ones() {
    let folder = Folder::with_map("square-cells");
    // At 60° a degree of longitude is half as long.
    folder.write("north.asc", "ncols 2\nnrows 2\nxllcorner -105\nyllcorner 59.99\ncellsize 0.01\n1 2\n3 4\n");
    folder.run(&["convert", "north.asc", "kept.json"]).ends(0).says(&["taken for squares of 787.1513 m", "In 2 × 4 cells"]);
    let squared = folder.run(&["convert", "north.asc", "square.json", "--square"]).ends(0);
    assert!(!squared.err.contains("taken for squares"), "{}", squared.err);
    let square: Value = serde_json::from_str(&folder.read("square.json")).unwrap();
    assert_eq!((&square["width"], &square["height"]), (&2.into(), &4.into()));
    assert!((square["resolution"].as_f64().unwrap() - 556.6).abs() < 1e-6);
    folder.run(&["convert", "north.asc", "both.json", "--square", "--size", "3x3"]).ends(2).says(&["--size"]);
}

#[test]
fn generate_makes_terrains() {
    let folder = Folder::with_map("generate-terrain");
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
