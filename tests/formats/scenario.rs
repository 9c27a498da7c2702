//! The scenario as JSON, and its schema.

use formicarium::formats::{Export, Kind, export, sniff};
use formicarium::map::{CornerRule, Moves, Point};
use formicarium::scenario::{AtEnd, EnergyRule, SmoothingRule};
use serde_json::{Value, json};

use super::schema::{load, violations};
use super::{read, refused, rows};

const FULL: &str = r#"{
  "format": "formicarium/scenario@1",
  "name": "two rooms",
  "width": 3,
  "height": 2,
  "resolution": 0.05,
  "movement": {"moves":8,"corner_rule":"one-free"},
  "start": [0,0],
  "goals": [{"at":[2,1],"name":"door","area":2.5,"strength":1.0,"danger":0.25}],
  "vehicle": {"speed":0.25,"seconds_per_turn":2.5},
  "map": {"rows": [
    "..@",
    "..."
  ]}
}
"#;

/// A terrain; the other way of moving on it has `max_slope` in place of `slices`.
const TERRAIN: &str = r#"{
  "format": "formicarium/scenario@1",
  "name": "",
  "width": 3,
  "height": 2,
  "resolution": 30.0,
  "movement": {"moves":16,"corner_rule":"both-free"},
  "start": [0,0],
  "goals": [{"at":[2,1],"name":"","area":1.0,"strength":1.0,"danger":1.0}],
  "vehicle": {"speed":1.0,"seconds_per_turn":0.0,"energy":{"per_metre":2.0,"per_radian":0.5,"per_metre_up":9.0},"smoothing":{"max_curvature":0.5}},
  "terrain": {"vertical_unit":0.5,"slices":{"level":10.0,"levels":4,"max_aside":2,"max_climb":1,"start_level":1,"goal_level":3,"measure":"cost"}},
  "world": {"x":-10.0,"y":2.5,"yaw":0.5,"frame":"map"},
  "changes": [{"at":12,"blocked":[[1,0]],"freed":[]}],
  "drive": {"changes":[{"at_step":3,"blocked":[[1,1]],"freed":[]}],"tracks":[{"cells":[[1,0],[1,1]],"size":1,"from_step":2,"steps_per_cell":3,"at_end":"loop"}],"sight":4.5},
  "map": {"rows": [
    "...",
    "@.."
  ], "heights": [
    [1.5,2.25,0.1],
    [null,-4.0,33.0]
  ]}
}
"#;

/// Weighted ground, and a robot on it.
const WEIGHTED: &str = r#"{
  "format": "formicarium/scenario@1",
  "name": "",
  "width": 3,
  "height": 2,
  "resolution": 0.5,
  "movement": {"moves":8,"corner_rule":"always"},
  "start": [0,0],
  "goals": [{"at":[2,1],"name":"","area":1.0,"strength":1.0,"danger":1.0}],
  "vehicle": {"speed":1.0,"seconds_per_turn":0.0},
  "robot": {"radius":0.25,"inflation":{"radius":0.55,"cost_scaling":10.0,"rule":"nav2-navfn","multiplier":2.0}},
  "map": {"rows": [
    "..@",
    "..."
  ], "factors": [
    [1.0,2.5,1.0],
    [1.1,1000.0,1.0]
  ]}
}
"#;

fn edited(edit: impl Fn(&mut Value)) -> String {
    let mut value: Value = serde_json::from_str(FULL).unwrap();
    edit(&mut value);
    value.to_string()
}

#[test]
fn a_file_comes_out_as_it_went_in() {
    let scenario = read(FULL).unwrap();
    assert_eq!(scenario.kind, Kind::Scenario);
    assert_eq!(rows(&scenario.grid), ["..@", "..."]);
    assert_eq!(scenario.spec.movement.corner_rule, CornerRule::OneFree);
    assert_eq!(export(&scenario.grid, &scenario.spec, Export::Scenario), FULL);
}

#[test]
fn a_terrain_comes_out_as_it_went_in() {
    let surface = TERRAIN
        .replace(&TERRAIN[TERRAIN.find("\"slices\"").unwrap()..TERRAIN.find("},\n  \"world\"").unwrap()], "\"max_slope\":30.0");
    let weighted = read(WEIGHTED).unwrap();
    assert_eq!(weighted.grid.factors().unwrap()[..], [1.0, 2.5, 1.0, 1.1, 1000.0, 1.0]);
    assert_eq!(export(&weighted.grid, &weighted.spec, Export::Scenario), WEIGHTED);
    for text in [TERRAIN, &surface] {
        let scenario = read(text).unwrap();
        let heights = scenario.grid.heights().unwrap();
        assert_eq!((heights[2], heights[3].is_nan(), heights[5]), (0.1, true, 33.0));
        assert_eq!(export(&scenario.grid, &scenario.spec, Export::Scenario), text);
    }
}

#[test]
fn errors_of_terrains_name_the_field() {
    type Edit = fn(&mut Value);
    let cases: [(Edit, &str, &str); 12] = [
        (|v| v["terrain"]["slope"] = json!(3), "syntax", "`terrain.slope`"),
        (|v| v["terrain"]["slices"]["level"] = json!(0), "quantity", "level = 0"),
        (|v| v["terrain"]["slices"]["levels"] = json!(256), "quantity", "levels = 256"),
        (|v| v["terrain"]["slices"]["max_climb"] = json!(6), "quantity", "max_climb = 6"),
        (|v| v["terrain"]["slices"]["goal_level"] = json!(1), "goal-below-ground", "level 1"),
        (|v| v["terrain"]["slices"]["measure"] = json!("time"), "syntax", "time"),
        (|v| v["terrain"] = json!({"vertical_unit": 1, "max_slope": 91}), "quantity", "max_slope = 91"),
        (|v| v["terrain"]["vertical_unit"] = json!(-1), "quantity", "vertical_unit = -1"),
        (|v| drop(v.as_object_mut().unwrap().remove("terrain")), "terrain-missing", "no terrain"),
        (|v| drop(v["map"].as_object_mut().unwrap().remove("heights")), "heights-missing", "no heights"),
        (|v| v["map"]["heights"][1] = json!([1, 2]), "syntax", "row 1 of the heights is no list of 3"),
        (|v| v["map"]["heights"][0][1] = json!("high"), "syntax", "at (1, 0) is no height"),
    ];
    for (edit, kind, message) in cases {
        let mut value: Value = serde_json::from_str(TERRAIN).unwrap();
        edit(&mut value);
        let report = refused(&value.to_string());
        assert_eq!(report.kind, kind, "{}", report.message);
        assert!(report.message.contains(message), "{} lacks {message}", report.message);
    }
}

#[test]
fn what_is_left_out_takes_its_default() {
    let text = edited(|v| {
        for key in ["name", "resolution", "movement", "vehicle"] {
            v.as_object_mut().unwrap().remove(key);
        }
    });
    let spec = read(&text).unwrap().spec;
    assert_eq!((spec.resolution, spec.movement.moves, spec.start), (1.0, Moves::Eight, Point::new(0, 0)));
    assert_eq!(spec.movement.corner_rule, CornerRule::BothFree);
}

#[test]
fn half_a_vehicle_takes_the_other_half() {
    let vehicle = read(&edited(|v| v["vehicle"] = json!({"energy": {"per_metre": 3}}))).unwrap().spec.vehicle;
    assert_eq!((vehicle.speed, vehicle.seconds_per_turn, vehicle.energy.unwrap().per_metre), (1.0, 0.0, 3.0));
}

#[test]
fn errors_name_the_field() {
    type Edit = fn(&mut Value);
    let cases: [(Edit, &str, &str); 26] = [
        (|v| v["robot"] = json!([0.5]), "syntax", "`robot` is a list"),
        (|v| v["movement"] = json!([4, "always"]), "syntax", "`movement` is a list"),
        (|v| v["vehicle"] = json!([0.5, 1]), "syntax", "`vehicle` is a list"),
        (|v| v["goals"] = json!([[[2, 1], "a", 1, 1, 1]]), "syntax", "`goals` is a list"),
        (|v| v["drive"] = json!([[], [], 4]), "syntax", "`drive` is a list"),
        (|v| v["drive"] = json!({"tracks": [[[[1, 1]], 2, 0, 1, "stay"]]}), "syntax", "`drive.tracks` is a list"),
        (|v| v["drive"] = json!(null), "syntax", "`drive` is null"),
        (|v| v["colour"] = json!("red"), "syntax", "`colour`"),
        (|v| v["movement"]["diagonal"] = json!(true), "syntax", "`movement.diagonal`"),
        (|v| v["goals"][0]["weight"] = json!(1), "syntax", "`goals.weight`"),
        (|v| v["map"]["cells"] = json!([]), "syntax", "`map.cells`"),
        (|v| v["map"] = json!(null), "syntax", "`map.rows`"),
        (|v| v["width"] = json!(4), "syntax", "row 0 of the map has 3 cells"),
        (|v| v["height"] = json!(3), "syntax", "2 rows where `height` is 3"),
        (|v| v["map"]["rows"][1] = json!(".x."), "syntax", "`x` at (1, 1)"),
        (|v| v["movement"]["moves"] = json!(6), "syntax", "moves = 6"),
        (|v| v["width"] = json!(5000), "map-size", "5000 × 2"),
        (|v| v["start"] = json!([2, 0]), "start-blocked", "(2, 0)"),
        (|v| v["resolution"] = json!(0), "quantity", "resolution = 0"),
        (|v| v["goals"] = json!([]), "goal-count", "0 goals"),
        (|v| v["goals"] = json!([{"at": [2, 1]}, {"at": [2, 1]}]), "goal-twice", "(2, 1)"),
        (|v| v["goals"][0]["danger"] = json!(0), "quantity", "danger = 0"),
        (|v| v["vehicle"]["energy"] = json!({"per_metre": -1}), "quantity", "vehicle.energy.per_metre = -1"),
        (|v| v["vehicle"]["energy"] = json!({"per_mile": 1}), "syntax", "`per_mile`"),
        (|v| v["vehicle"]["smoothing"] = json!({"max_curvature": -0.5}), "quantity", "vehicle.smoothing.max_curvature = -0.5"),
        (|v| v["vehicle"]["smoothing"] = json!({"radius": 2}), "syntax", "`radius`"),
    ];
    for (edit, kind, message) in cases {
        let report = refused(&edited(edit));
        assert_eq!(report.kind, kind, "{}", report.message);
        assert!(report.message.contains(message), "{} lacks {message}", report.message);
    }
}

#[test]
fn other_versions_and_other_files_are_refused() {
    for (format, kind) in [
        (json!("formicarium/scenario@2"), "version"),
        (json!("formicarium/experiment@1"), "not-a-map"),
        (json!("somebody/else@1"), "version"),
        (json!(1), "version"),
    ] {
        let report = refused(&edited(|v| v["format"] = format.clone()));
        assert_eq!(report.kind, kind, "{format}: {}", report.message);
    }
    let report = refused(&edited(|v| v["format"] = json!("formicarium/scenario@2")));
    assert!(report.hint.contains("formicarium/scenario@1"), "{}", report.hint);
    assert_eq!(refused("{}").kind, "version");
    let broken = refused(&FULL.replace("\"width\": 3,", "\"width\": 3"));
    assert_eq!(broken.field, "line 5", "{}", broken.message);
}

#[test]
fn sniffing_tells_scenario_from_session() {
    assert_eq!(sniff(FULL.as_bytes(), "a.map"), Kind::Scenario);
    assert_eq!(sniff(&FULL.as_bytes()[..80], ""), Kind::Scenario);
    let session = format!("{{\"format\": \"formicarium/experiment@1\", \"scenario\": {FULL}}}");
    assert_eq!(sniff(session.as_bytes(), ""), Kind::Session);
}

#[test]
fn the_schema_accepts_what_is_written_and_refuses_what_is_refused() {
    let schema = load("scenario");
    for text in [FULL, TERRAIN, WEIGHTED] {
        assert_eq!(violations(&schema, &serde_json::from_str(text).unwrap()), Vec::<String>::new());
    }
    let wrong: [fn(&mut Value); 11] = [
        |v| v["colour"] = json!("red"),
        |v| v["format"] = json!("formicarium/scenario@2"),
        |v| v["movement"]["moves"] = json!(6),
        |v| v["map"]["rows"][1] = json!(".x."),
        |v| v["resolution"] = json!(0),
        |v| v["goals"] = json!([]),
        |v| v["map"]["factors"] = json!([[1, 0.5, 1], [1, 1, 1]]),
        |v| v["map"]["factors"] = json!([[1, null, 1], [1, 1, 1]]),
        |v| v["robot"] = json!({"radius": -1}),
        |v| v["robot"] = json!({"radius": 0, "inflation": {"radius": 1, "cost_scaling": 0}}),
        |v| v["robot"] = json!({"radius": 0, "inflation": {"radius": 1, "cost_scaling": 3, "rule": "mine"}}),
    ];
    for edit in wrong {
        let text = edited(edit);
        assert!(!violations(&schema, &serde_json::from_str(&text).unwrap()).is_empty(), "{text}");
        refused(&text);
    }
}

#[test]
fn what_a_rule_of_driving_leaves_out_has_its_default() {
    let text = edited(|v| {
        v["vehicle"]["energy"] = json!({"per_radian": 3});
        v["vehicle"]["smoothing"] = json!({});
    });
    let vehicle = read(&text).unwrap().spec.vehicle;
    assert_eq!(vehicle.energy, Some(EnergyRule { per_radian: 3.0, ..EnergyRule::default() }));
    assert_eq!(vehicle.smoothing, Some(SmoothingRule { max_curvature: 0.0 }));
    let plain = read(FULL).unwrap().spec.vehicle;
    assert_eq!((plain.energy, plain.smoothing), (None, None));
}

#[test]
fn the_schema_names_every_field() {
    let schema = load("scenario");
    let mut full: Value = serde_json::from_str(TERRAIN).unwrap();
    let weighted: Value = serde_json::from_str(WEIGHTED).unwrap();
    full["robot"] = weighted["robot"].clone();
    full["map"]["factors"] = weighted["map"]["factors"].clone();
    let keys = |v: &Value| v.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys(&schema["properties"]), keys(&full));
    assert_eq!(keys(&schema["properties"]["map"]["properties"]), keys(&full["map"]));
    let rules = &schema["properties"]["terrain"]["properties"]["slices"]["properties"];
    assert_eq!(keys(rules), keys(&full["terrain"]["slices"]));
    let robot = &schema["properties"]["robot"]["properties"];
    assert_eq!(keys(robot), keys(&full["robot"]));
    assert_eq!(keys(&robot["inflation"]["properties"]), keys(&full["robot"]["inflation"]));
    assert_eq!(keys(&schema["properties"]["changes"]["items"]["properties"]), keys(&full["changes"][0]));
    let vehicle = &schema["properties"]["vehicle"]["properties"];
    assert_eq!(keys(vehicle), keys(&full["vehicle"]));
    for rule in ["energy", "smoothing"] {
        assert_eq!(keys(&vehicle[rule]["properties"]), keys(&full["vehicle"][rule]));
    }
    let drive = &schema["properties"]["drive"]["properties"];
    assert_eq!(keys(drive), keys(&full["drive"]));
    for list in ["changes", "tracks"] {
        assert_eq!(keys(&drive[list]["items"]["properties"]), keys(&full["drive"][list][0]));
    }
}

#[test]
fn what_moves_may_leave_out_what_is_usual_and_is_refused_by_name() {
    let driving = |drive: &str| edited(|v| v["drive"] = serde_json::from_str(drive).unwrap());
    let spec = read(&driving(r#"{"tracks":[{"cells":[[1,1]]}],"changes":[{"at_step":4,"blocked":[[0,1]]}]}"#)).unwrap().spec;
    let drive = spec.drive.expect("things move");
    let track = &drive.tracks[0];
    assert_eq!((track.size, track.from_step, track.steps_per_cell, track.at_end, drive.sight), (1, 0, 1, AtEnd::Stay, None));
    assert!(drive.changes[0].freed.is_empty());
    for (drive, said) in [
        (r#"{"speed":1}"#, "speed"),
        (r#"{"tracks":[{"cells":[[1,1]],"at_end":"turn"}]}"#, "turn"),
        (r#"{"tracks":[{"cells":[[0,0],[2,0]]}]}"#, "drive.tracks[0].cells[1]"),
        (r#"{"tracks":[{"size":2}]}"#, "cells"),
        (r#"{"changes":[{"at_step":4,"blocked":[[2,1]]}]}"#, "drive.changes"),
        (r#"{"changes":[{"at_step":4,"freed":[[1,1]]}]}"#, "drive.changes[0].freed[0]"),
        (r#"{"changes":[{"at_step":4,"blocked":[[1,1]]},{"at_step":3,"freed":[[1,1]]}]}"#, "drive.changes[1].at_step"),
        (r#"{"sight":-1}"#, "drive.sight"),
    ] {
        let message = refused(&driving(drive)).message;
        assert!(message.contains(said), "{drive}: {message}");
    }
}
