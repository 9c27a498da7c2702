//! `drive`: robots that drive where things move.
use serde_json::{Value, json};

use super::folder::Folder;
use super::schema;

/// A corridor of five cells with a room of two rows in its middle, as a scenario with what moves.
fn scenario(drive: &str) -> String {
    format!(
        r#"{{"format":"formicarium/scenario@1","width":5,"height":2,"start":[0,1],"goals":[{{"at":[4,1]}}],
        "drive":{drive},"map":{{"rows":["@@.@@","....."]}}}}"#
    )
}

#[test]
fn a_robot_waits_for_what_is_in_its_way() {
    let folder = Folder::with_map("drive");
    folder.write("still.json", &scenario("{}"));
    let drive = |more: &[&str]| folder.run(&[&["drive", "still.json", "--planner"], more].concat());
    let said = [
        "A drive by A*",
        "0 changes of walls, 0 obstacles",
        "arrived",
        "4.0000 cells",
        "4 moves, 0 waits",
        "1.0000 times as long",
    ];
    drive(&["astar"]).ends(0).says(&said);
    // It comes through the door, stays for three steps on each cell, and goes.
    let visit = ["--obstacle", "2,1:2,0,each=3,end=leave"];
    let said = ["1 obstacle", "4 moves, 3 waits", "(0, 1) · · · (1, 1) (2, 1) (3, 1) (4, 1)", "planned again"];
    drive(&[&["d-star-lite"], &visit[..]].concat()).ends(0).says(&said);
    drive(&[&["ant-system", "--iterations", "3", "--set", "ants=5"], &visit[..]].concat())
        .ends(0)
        .says(&["ant moves", "arrived"]);
    let stays = ["d-star-lite", "--obstacle", "2,1,end=stay", "--patience", "4"];
    let said = ["gave up at (0, 1) after 4 steps: no path leads to the goal", "no drive arrives", "it sees 1.5 cells far"];
    drive(&[&stays[..], &["--sight", "1.5"]].concat()).ends(1).says(&said);
    drive(&stays).ends(1).says(&said[..2]);
    drive(&["astar", "--longest", "2"]).ends(1).says(&["it may drive no longer", "4.0000 cells at best"]);
}

#[test]
fn json_has_every_step() {
    let folder = Folder::with_map("drive-json");
    folder.write("moving.json", &scenario(r#"{"changes":[{"at_step":1,"blocked":[[2,1]]},{"at_step":3,"freed":[[2,1]]}]}"#));
    let json =
        |more: &[&str]| folder.run(&[&["drive", "moving.json", "--format", "json", "--planner"], more].concat()).ends(0).json();
    let first = json(&["d-star-lite", "--seed", "7"]);
    assert_eq!(schema::violations(&schema::load("drive"), &first), Vec::<String>::new());
    assert_eq!(
        (&first["format"], &first["planner"], &first["seed"]),
        (&json!("formicarium/drive@1"), &json!("d-star-lite"), &json!(7))
    );
    assert_eq!((&first["end"], &first["clairvoyant"]), (&json!({"kind": "arrived"}), &json!({"kind": "proven", "value": 4.0})));
    let steps = first["steps"].as_array().expect("a list");
    let did: Vec<&Value> = steps.iter().map(|step| &step["did"]).collect();
    assert_eq!(did, ["start", "move", "wait", "wait", "move", "move", "move"]);
    assert_eq!((&steps[1]["blocked"], &steps[1]["at"], &steps[3]["freed"]), (&json!([[2, 1]]), &json!([1, 1]), &json!([[2, 1]])));
    assert_eq!(first, json(&["d-star-lite", "--seed", "7"]));
    let stuck = folder.run(&["drive", "moving.json", "--format", "json", "--planner", "astar", "--patience", "1"]).ends(1).json();
    assert_eq!(schema::violations(&schema::load("drive"), &stuck), Vec::<String>::new());
    assert_eq!((&stuck["end"], &stuck["ratio"]), (&json!({"kind": "stuck", "why": "no-path"}), &json!(null)));
}

#[test]
fn what_moves_may_stand_in_a_file_of_its_own() {
    let folder = Folder::with_map("drive-file");
    folder.write("still.json", &scenario("{}"));
    folder.write("traffic.json", r#"{"tracks":[{"cells":[[2,1],[2,0]],"steps_per_cell":3,"at_end":"leave"}],"sight":4}"#);
    let drive = |more: &[&str]| folder.run(&[&["drive", "still.json", "--planner", "astar"], more].concat());
    drive(&["--drive", "traffic.json"]).ends(0).says(&["1 obstacle; it sees 4 cells far", "3 waits"]);
    drive(&["--drive", "traffic.json", "--sight", "2", "--obstacle", "2,0"]).ends(0).says(&["2 obstacles; it sees 2 cells far"]);
    folder.run(&["plan", "still.json", "--planner", "astar"]).ends(0).says(&["`drive` has it drive"]);
    folder.run(&["convert", "still.json", "out.map"]).ends(0).says(&["does not hold what moves"]);
    folder.run(&["convert", "still.json", "again.json"]).ends(0);
    assert!(folder.read("again.json").contains(r#""drive": {"changes":[],"tracks":[]}"#));
}

#[test]
fn drive_refuses_by_name() {
    let folder = Folder::with_map("drive-refusals");
    folder.write("still.json", &scenario("{}"));
    folder.write("broken.json", r#"{"tracks":[{"cells":[[2,1]],"speed":2}]}"#);
    let refused = |args: &[&str], said: &[&str]| {
        drop(folder.run(&[&["drive", "still.json", "--planner"], args].concat()).ends(2).says(said))
    };
    refused(&["theta-star"], &["planner = theta-star", "from cell to cell"]);
    refused(&["astar", "--hold", "-1"], &["hold = -1 is outside 0 to 1000"]);
    refused(&["astar", "--replan", "never"], &["changed", "blocked"]);
    refused(&["astar", "--obstacle", "2,1:4,0"], &["`2,1:4,0` is no obstacle"]);
    refused(&["astar", "--obstacle", "2,1:7,1"], &["drive.tracks[0].cells[3] = (5, 1)", "a cell of the map"]);
    refused(&["astar", "--obstacle", "3,1:4,1,end=stay"], &["drive.tracks[0].cells = (4, 1)", "does not end on a goal"]);
    refused(&["astar", "--sight", "-2"], &["drive.sight = -2"]);
    refused(&["astar", "--drive", "broken.json"], &["broken.json", "speed"]);
    refused(&["astar", "--to", "4,1", "--to", "2,0"], &["goals = 2", "one goal"]);
    refused(&["astar", "--smooth"], &["--smooth has no effect", "plan --smooth"]);
    refused(&["astar", "--smooth=2"], &["--smooth has no effect"]);
    refused(&["astar", "--obstacle", "1m,1m:2m,1m"], &["does not say where it lies"]);
    refused(&["astar", "--format", "csv"], &["path-csv", "nav-msgs"]);
    refused(&["astar", "--format", "geojson"], &["the map's place in the world is not known", "path-json"]);
    folder.write("shut.json", &scenario(r#"{"changes":[{"at_step":3,"blocked":[[4,1]]}]}"#));
    folder
        .run(&["drive", "shut.json", "--planner", "astar"])
        .ends(2)
        .says(&["drive.changes = (4, 1)", "every goal free in the end"]);
}

#[test]
fn costs_near_obstacles_are_driven_and_told() {
    let folder = Folder::with_map("drive-costs");
    folder.write("room.csv", "0,0,0,0,0,0,0\n0,0,0,0,0,0,0\n0,0,0,0,0,0,0\n");
    let costs = ["--robot-radius", "0.4", "--cost", "nav2-smac-2d", "--inflation-radius", "2", "--cost-scaling", "0.5"];
    let drive = |more: &[&str]| {
        let args =
            ["drive", "room.csv", "--planner", "d-star-lite", "--from", "0,1", "--to", "6,1", "--obstacle", "3,2,end=stay"];
        folder.run(&[&args[..], &costs, more].concat()).ends(0)
    };
    drive(&[]).says(&["cost", "every move counts its length", "times as much"]);
    let json = drive(&["--format", "json"]).json();
    assert_eq!(schema::violations(&schema::load("drive"), &json), Vec::<String>::new());
    let (cost, length) = (json["cost"].as_f64().expect("a cost"), json["length"].as_f64().expect("a length"));
    assert!(cost > length && length >= 6.0, "{json}");
    assert_eq!((json["steps"][0]["cost"].as_f64(), json["ratio"].as_f64()), (Some(0.0), Some(1.0)), "nothing else moves");
    // The same ground as a plan on the map with the obstacle drawn as a wall.
    folder.write("wall.csv", "0,0,0,0,0,0,0\n0,0,0,0,0,0,0\n0,0,0,1,0,0,0\n");
    let args = ["plan", "wall.csv", "--planner", "astar", "--from", "0,1", "--to", "6,1", "--format", "json"];
    let plan = folder.run(&[&args[..], &costs].concat()).ends(0).json();
    assert!((plan["metrics"]["cost"].as_f64().expect("a cost") - cost).abs() < 1e-9, "{plan}");
}

#[test]
fn a_drive_tells_when_it_arrives() {
    let folder = Folder::with_map("drive-time");
    folder.write("still.json", &scenario("{}"));
    let visit = ["drive", "still.json", "--planner", "d-star-lite", "--obstacle", "2,1:2,0,each=3,end=leave"];
    let time = |more: &[&str]| {
        let json = folder.run(&[&visit[..], &["--format", "json"], more].concat()).ends(0).json();
        assert_eq!((&json["waits"], &json["turns"]), (&json!(3), &json!(0)));
        json["travel_time"].as_f64().expect("seconds")
    };
    // Four moves and three waits of a metre each.
    assert_eq!([time(&[]), time(&["--speed", "2"]), time(&["--speed", "2", "--resolution", "0.5"])], [7.0, 3.5, 1.75]);
    folder.run(&visit).ends(0).says(&["arrival time", "7.00 s"]);
    folder.write("corner.csv", "0,0,0\n1,1,0\n1,1,0\n");
    let corner = ["drive", "corner.csv", "--planner", "astar", "--from", "0,0", "--to", "2,2", "--seconds-per-turn", "1.5"];
    folder.run(&corner).ends(0).says(&["turns", "5.50 s"]);
}

#[test]
fn a_way_that_was_driven_is_written_for_other_programs() {
    let folder = Folder::with_map("drive-path");
    folder.write("still.json", &scenario("{}"));
    let visit = ["drive", "still.json", "--planner", "d-star-lite", "--obstacle", "2,1:2,0,each=3,end=leave", "--format"];
    let written = |format: &str| folder.run(&[&visit[..], &[format]].concat()).ends(0).out;
    assert_eq!(written("path-csv"), "x,y,x_m,y_m\n0,1,0.5,0.5\n1,1,1.5,0.5\n2,1,2.5,0.5\n3,1,3.5,0.5\n4,1,4.5,0.5\n");
    for format in ["path-json", "nav-msgs", "svg"] {
        folder.write("way", &written(format));
        folder.run(&["check", "way", "--map", "still.json"]).ends(0).says(&["4.0000"]);
    }
    folder.write("placed.json", &scenario("{}").replace(r#""width""#, r#""world":{"x":0,"y":0,"frame":"EPSG:25832"},"width""#));
    let line = folder.run(&["drive", "placed.json", "--planner", "astar", "--format", "geojson"]).ends(0).json();
    assert_eq!(line["geometry"]["coordinates"].as_array().map(Vec::len), Some(5));
    // Walls that are there no longer when it passes, and a robot that gives up.
    folder.write("opens.json", &scenario(r#"{"changes":[{"at_step":1,"blocked":[[2,1]]},{"at_step":3,"freed":[[2,1]]}]}"#));
    let opens = ["drive", "opens.json", "--planner", "astar", "--format", "path-csv"];
    folder.run(&opens).ends(0).says(&["4,1,4.5,0.5"]);
    let stuck = folder.run(&[&opens[..], &["--patience", "1"]].concat()).ends(1);
    assert_eq!(stuck.says(&["the robot gave up; this is its way until then"]).out, "x,y,x_m,y_m\n0,1,0.5,0.5\n1,1,1.5,0.5\n");
}
