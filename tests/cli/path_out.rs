//! Paths for other programs: what `plan` writes `check` reads, and what is refused.
use super::folder::Folder;

const FORMATS: [&str; 5] = ["path-csv", "path-json", "nav-msgs", "geojson", "svg"];

/// A map in the world.
fn placed(frame: &str) -> String {
    placed_map(frame, r#"[".....", ".@@@.", ".@.@.", "...@."]"#)
}

fn placed_map(frame: &str, rows: &str) -> String {
    let head = r#""format": "formicarium/scenario@1", "name": "yard", "width": 5, "height": 4, "resolution": 0.5"#;
    let ends = r#""start": [0, 0], "goals": [{"at": [4, 3]}]"#;
    let world = format!(r#""world": {{"x": -20, "y": 3.5, "yaw": 0.3, "frame": "{frame}"}}"#);
    format!(r#"{{{head}, {ends}, {world}, "map": {{"rows": {rows}}}}}"#)
}

#[test]
fn what_plan_writes_in_any_format_check_accepts() {
    let folder = Folder::with_map("path-out");
    folder.write("yard.json", &placed("EPSG:25832"));
    folder.write("slopes.csv", &"9,3,4,5,2,1\n2,3,9,4,3,2\n1,4,5,6,7,3\n".repeat(2));
    folder.write("open.csv", &"0,0,0,0,0,0,0,0\n".repeat(4));
    let sliced = ["--model", "slices", "--from", "0,2", "--to", "5,2"];
    // Where the map names no ends, those of the path are taken.
    let cases: [(&str, &str, &[&str], &[&str]); 4] = [
        ("yard.json", "astar", &[], &[]),
        ("open.csv", "any-angle", &["--from", "0,0", "--to", "7,3"], &["--polyline"]),
        ("slopes.csv", "astar", &["--from", "0,0", "--to", "5,5", "--moves", "16"], &["--moves", "16"]),
        ("slopes.csv", "slices-exact", &sliced, &sliced[..2]),
    ];
    for (map, planner, planned, checked) in cases {
        for format in FORMATS.into_iter().filter(|&format| format != "geojson" || map == "yard.json") {
            let run = folder.run(&[&["plan", map, "--planner", planner, "--format", format], planned].concat()).ends(0);
            folder.write("path", &run.out);
            folder.run(&[&["check", "path", "--map", map], checked].concat()).ends(0).says(&["a valid p"]);
        }
    }
}

#[test]
fn the_kind_of_a_path_is_told_by_the_file_where_it_can() {
    let folder = Folder::with_map("path-kind");
    folder.write("yard.json", &placed_map("EPSG:25832", r#"[".....", ".....", ".....", "....."]"#));
    for format in FORMATS {
        let run = folder.run(&["plan", "yard.json", "--planner", "any-angle", "--format", format]).ends(0);
        folder.write("path", &run.out);
        let check = folder.run(&["check", "path", "--map", "yard.json"]);
        match format {
            "path-csv" | "nav-msgs" => check.ends(1).says(&["jumps", "add --polyline"]),
            _ => check.ends(0).says(&["a valid polyline"]),
        };
    }
}

#[test]
fn without_a_path_there_is_no_file_and_without_a_system_no_geojson() {
    let folder = Folder::with_map("path-none");
    folder.write("wall.csv", "0,1,0\n0,1,0\n");
    for format in FORMATS.into_iter().filter(|&format| format != "geojson") {
        let run = folder.run(&["plan", "wall.csv", "--from", "0,0", "--to", "2,0", "--planner", "astar", "--format", format]);
        let run = run.ends(1);
        assert_eq!(run.out, "", "{format}");
        run.says(&["no path was found, so there is none to write"]);
    }
    let geojson = |map: &str| folder.run(&["plan", map, "--planner", "astar", "--format", "geojson"]);
    geojson("small.map").ends(2).says(&["world: the map's place in the world is not known", "EPSG:25832"]);
    folder.write("yard.json", &placed("odom"));
    geojson("yard.json").ends(2).says(&["world.frame: `odom` is no coordinate system with a code", "path-json"]);
}

#[test]
fn what_is_assumed_is_said() {
    let folder = Folder::with_map("path-said");
    folder.write("yard.json", &placed("EPSG:25832"));
    let plan = |map: &str, format: &str| folder.run(&["plan", map, "--planner", "astar", "--format", format]).ends(0);
    plan("yard.json", "geojson").says(&["note: the coordinates are of EPSG:25832"]);
    let path = plan("small.map", "nav-msgs");
    folder.write("path.yaml", &path.out);
    path.says(&["note: the map's place in the world is not known: its lower left corner is (0, 0)"]);
    let check = |map: &str| folder.run(&["check", "path.yaml", "--map", map]);
    check("small.map").ends(0).says(&["note: the map's place in the world is not known", "a valid path"]);
    check("yard.json").ends(2).says(&["pose 0 (0.5, 3.5) lies beside the map"]);
}

#[test]
fn another_version_is_refused_and_nothing_is_turned() {
    let folder = Folder::with_map("path-version");
    let plan = |format: &str| folder.run(&["plan", "small.map", "--planner", "astar", "--format", format]).ends(0).out;
    for format in ["path-json", "svg"] {
        folder.write("path", &plan(format).replace("path@1", "path@2"));
        let run = folder.run(&["check", "path", "--map", "small.map"]).ends(2);
        run.says(&["`format` is `formicarium/path@2`", "this engine reads `formicarium/path@1`"]);
    }
    for format in ["path-csv", "path-json", "nav-msgs", "svg"] {
        folder.write("path", &plan(format));
        let run = folder.run(&["check", "path", "--map", "small.map", "--rows-first"]).ends(2);
        run.says(&["--rows-first would turn them once more"]);
    }
    folder.run(&["plan", "path", "--planner", "astar"]).ends(2).says(&["this is a path, not a map"]);
}

#[test]
fn metres_lie_in_the_same_cells_of_a_piece_of_a_map() {
    let Some(data) = std::env::var_os("FORMICARIUM_DATA").map(std::path::PathBuf::from) else {
        return println!("skipped: FORMICARIUM_DATA is not set, so there is no map of TurtleBot3");
    };
    let folder = Folder::with_map("path-crop");
    let whole = data.join("rosmap/turtlebot3_map.yaml").display().to_string();
    folder.run(&["convert", &whole, "crop.yaml", "--crop", "140,130,120,110"]).ends(0);
    let plan = |map: &str, more: &[&str]| {
        let args = ["plan", map, "--planner", "astar", "--from", "-2m,-0.5m", "--to", "2m,0.5m", "--format", "json"];
        folder.run(&[&args[..], more].concat()).ends(0)
    };
    let places = |map: &str| {
        let json = plan(map, &[]).json();
        (json["optimum"].as_f64().expect("an optimum"), json["path"].as_array().map(Vec::len))
    };
    assert_eq!(places("crop.yaml"), places(&whole));
    let unknown = |map: &str| plan(map, &[]).err;
    assert!(unknown(&whole).contains("138722 unknown"));
    assert!(!unknown("crop.yaml").contains(" 0 unknown"), "what nobody has looked at is no wall in a ROS map either");
}
