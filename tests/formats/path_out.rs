//! Paths for other programs: what is written, that it is read back to the same cells, and what is refused by name.

use std::sync::Arc;

use formicarium::error::ErrorReport;
use formicarium::formats::{
    Companion, Kind, PathFormat, PathOnMap, PlannedPath, ReadOptions, TerrainOptions, import_piece, import_with, path_kind,
    read_path_on, read_places, recognise,
};
use formicarium::map::{Cell, Measure, Movement, Point};
use formicarium::metrics::WayMetrics;
use formicarium::path::{Path, PathKind};
use formicarium::scenario::{Goal, Scenario, ScenarioSpec, SmoothingRule, World};
use formicarium::smoothing::Smoothed;
use serde_json::{Value, json};

use super::{common, data, schema, terrains};

/// In the middle of Germany, turned, as a robot's map may be.
fn in_germany() -> World {
    World { yaw: 0.7, frame: "EPSG:25832".into(), ..World::at(-412_345.25, 5_654_321.5) }
}

fn placed(scenario: &Scenario, world: World, resolution: f64) -> Arc<Scenario> {
    let spec = ScenarioSpec { world: Some(world), resolution, name: "yard".into(), ..scenario.spec.clone() };
    Arc::new(Scenario::new(scenario.grid.clone(), spec).unwrap())
}

/// The places of a path, by slices with their levels.
fn places(scenario: &Scenario, path: &[Cell]) -> Vec<(Point, Option<u32>)> {
    let level = |&place: &Cell| scenario.by_slices().map(|slices| slices.at(place).2);
    let points = scenario.cells_of(path).into_iter().map(|cell| scenario.grid.point(cell));
    points.zip(path.iter().map(level)).collect()
}

fn write(scenario: &Scenario, path: &[Cell], kind: PathKind, format: PathFormat) -> String {
    format.write(&PlannedPath::new(scenario, path, kind).unwrap()).unwrap().text
}

fn read(text: &str, spec: &ScenarioSpec) -> PathOnMap {
    read_path_on(text.as_bytes(), spec).unwrap_or_else(|e| panic!("{e}: {text}"))
}

/// Every format that the map can give tells what it is, and gives the same places back.
fn come_back(scenario: &Scenario, path: &[Cell], kind: PathKind) {
    for format in PathFormat::ALL.into_iter().filter(|format| format.check(&scenario.spec).is_ok()) {
        let text = write(scenario, path, kind, format);
        let told = recognise(text.as_bytes(), "file").unwrap();
        assert_eq!((told.kind, told.is_certain), (Kind::Path, true), "{}", format.id());
        let back = read(&text, &scenario.spec);
        assert_eq!(back.places, places(scenario, path), "{}", format.id());
        // A table and a message of ROS have no word for it.
        let tells = matches!(format, PathFormat::PathJson | PathFormat::Geojson | PathFormat::Svg);
        assert_eq!(back.kind, if tells { kind } else { PathKind::Steps }, "{}", format.id());
        assert!(back.names_columns, "{}", format.id());
    }
}

/// The best path of a planner comes back, if there is one.
fn planned_comes_back(scenario: &Arc<Scenario>, planner: &str) -> bool {
    let planner = common::solve(scenario, planner);
    let Some(best) = planner.best() else { return false };
    come_back(scenario, best.result().0, planner.objective().path_kind());
    true
}

#[test]
fn fifty_random_maps_come_back_with_and_without_a_place() {
    let mut found = 0;
    for seed in 0..50 {
        let movement = common::movements()[seed as usize % 4];
        let plain = common::random(6 + seed % 30, 0.2, seed, movement);
        let world = World { yaw: f64::from(seed) * 0.3 - 4.0, ..in_germany() };
        let real = placed(&plain, world, 0.05 * f64::from(1 + seed % 7));
        for planner in ["astar", "theta-star"] {
            found += usize::from(planned_comes_back(&plain, planner)) + usize::from(planned_comes_back(&real, planner));
        }
    }
    assert!(found > 100, "{found} paths of 200");
}

#[test]
fn a_ros_map_with_origin_and_yaw_comes_back() {
    let (Some(yaml), Some(image)) = (data("rosmap/testmap.yaml"), data("rosmap/testmap.png")) else { return };
    let beside = Companion { name: "testmap.png", bytes: &image };
    let map = import_with(&yaml, "testmap.yaml", &ReadOptions::default(), Some(beside)).unwrap();
    assert_eq!(map.spec.world.as_ref().map(|world| world.yaw), Some(1.0));
    let scenario = Arc::new(Scenario::new(map.grid, map.spec).unwrap());
    assert!(planned_comes_back(&scenario, "astar") && planned_comes_back(&scenario, "any-angle"));
    let report = PathFormat::Geojson.check(&scenario.spec).unwrap_err().report();
    assert_eq!((report.kind.as_str(), report.field.as_str()), ("bad-field", "world.frame"));
}

#[test]
fn a_terrain_comes_back_with_its_altitudes() {
    let hilly = placed(&terrains::hilly(9, 7, 3, 6.0, terrains::sixteen()[2], 60.0), in_germany(), 10.0);
    assert!(planned_comes_back(&hilly, "astar"));
    let planner = common::solve(&hilly, "astar");
    let path = planner.best().unwrap().result().0;
    let altitudes = hilly.altitudes(path);
    let json: Value = serde_json::from_str(&write(&hilly, path, PathKind::Steps, PathFormat::PathJson)).unwrap();
    let csv = write(&hilly, path, PathKind::Steps, PathFormat::PathCsv);
    let yaml = write(&hilly, path, PathKind::Steps, PathFormat::NavMsgs);
    assert!(csv.starts_with("x,y,x_m,y_m,z_m\n"));
    for (index, altitude) in altitudes.iter().enumerate() {
        assert_eq!(json["metres"][index][2], json!(altitude));
        let last = csv.lines().nth(index + 1).and_then(|line| line.rsplit(',').next()).map(str::parse);
        assert_eq!(last, Some(Ok(*altitude)));
        assert!(yaml.contains(&format!("      z: {altitude}\n")), "{altitude}");
    }

    let Some(dem) = data("dem/DEM_10m.asc") else { return };
    let map = import_piece(&dem, "DEM_10m.asc", TerrainOptions { crop: None, size: Some((40, 30)) }).unwrap();
    let scenario = Arc::new(Scenario::new(map.grid, map.spec).unwrap());
    assert!(planned_comes_back(&scenario, "astar"));
}

#[test]
fn a_path_by_slices_comes_back_with_its_levels() {
    let plain = terrains::hilly_slices(8, 5, 7, terrains::rules(Measure::Cost));
    let real = placed(&plain, in_germany(), 50.0);
    assert!(planned_comes_back(&plain, "slices-exact") && planned_comes_back(&real, "slices-exact"));
    let planner = common::solve(&plain, "slices-exact");
    let path = planner.best().unwrap().result().0;
    assert!(write(&plain, path, PathKind::Steps, PathFormat::PathCsv).starts_with("x,y,level,x_m,y_m,z_m\n0,2,5,0.5,2.5,500\n"));
    let json: Value = serde_json::from_str(&write(&plain, path, PathKind::Steps, PathFormat::PathJson)).unwrap();
    assert_eq!((&json["kind"], &json["levels"][0], json["metres"][0][2].as_f64()), (&json!("slices"), &json!(5), Some(500.0)));
}

/// A map of 3 × 2 cells of 2 m, its lower left corner at (10, 20), and the way around its wall.
fn small(frame: &str) -> (Arc<Scenario>, Vec<Cell>) {
    let movement = Movement::default();
    let plain = common::drawn(&["S#G", "..."], movement);
    let world = World { frame: frame.into(), ..World::at(10.0, 20.0) };
    (placed(&plain, world, 2.0), vec![0, 3, 4, 5, 2])
}

#[test]
fn a_path_message_is_what_ros_prints() {
    let (scenario, path) = small("");
    let text = write(&scenario, &path[..2], PathKind::Steps, PathFormat::NavMsgs);
    // Southwards: a quarter turn clockwise about z.
    let half = libm::sin(std::f64::consts::FRAC_PI_4);
    let turned = format!("x: 0.0\n      y: 0.0\n      z: -{half}\n      w: {}\n", libm::cos(std::f64::consts::FRAC_PI_4));
    let pose = |y: &str| {
        format!(
            "- header:\n    stamp:\n      sec: 0\n      nanosec: 0\n    frame_id: \"map\"\n  pose:\n    position:\n      x: 11.0\n      y: {y}\n      z: 0.0\n    orientation:\n      {turned}"
        )
    };
    let head = "header:\n  stamp:\n    sec: 0\n    nanosec: 0\n  frame_id: \"map\"\nposes:\n";
    assert_eq!(text, format!("{head}{}{}", pose("23.0"), pose("21.0")));
    assert_eq!(scenario.spec.to_world(scenario.spec.start), Some([11.0, 23.0]), "the first pose is the start");
    let (named, path) = small("odom/2 \"x\": y");
    let text = write(&named, &path, PathKind::Steps, PathFormat::NavMsgs);
    assert!(text.contains(r#"frame_id: "odom/2 \"x\": y""#));
    let kinds = |text: &str| read(text, &scenario.spec).notices.into_iter().map(|n| n.kind).collect::<Vec<_>>();
    assert_eq!(kinds(&text), ["path-frame-unnamed"], "the map names no frame, and map_server calls it `map`");
    for usual in ["map", "/map", ""] {
        assert_eq!(kinds(&text.replace(r#""odom/2 \"x\": y""#, &format!("{usual:?}"))), Vec::<String>::new(), "{usual}");
    }
    let other = read(&text, &small("EPSG:25832").0.spec);
    assert_eq!(other.notices.iter().map(|n| n.kind.as_str()).collect::<Vec<_>>(), ["path-frame"]);
}

#[test]
fn a_map_without_a_place_lies_at_zero_and_that_is_said() {
    let plain = common::drawn(&["S.G"], Movement::default());
    let path = PlannedPath::new(&plain, &[0, 1, 2], PathKind::Steps).unwrap();
    let file = PathFormat::NavMsgs.write(&path).unwrap();
    assert_eq!(file.notices.iter().map(|n| n.kind.as_str()).collect::<Vec<_>>(), ["path-unplaced"]);
    assert!(file.text.contains("x: 0.5\n      y: 0.5\n"));
    let back = read(&file.text, &plain.spec);
    assert_eq!(back.notices.iter().map(|n| n.kind.as_str()).collect::<Vec<_>>(), ["path-map-unplaced"]);
    // The ROS map of it lies there too.
    let ros = formicarium::formats::ros::write(&plain.grid, None, &plain.spec, "a.pgm");
    assert!(ros.yaml.contains("origin: [0.0, 0.0, 0.0]"));
    let json: Value = serde_json::from_str(&PathFormat::PathJson.write(&path).unwrap().text).unwrap();
    assert_eq!((&json["frame"], &json["metres"][0]), (&Value::Null, &json!([0.5, 0.5])));
}

#[test]
fn geojson_names_its_system_or_is_refused() {
    let (scenario, path) = small("EPSG:25832");
    let planned = PlannedPath::new(&scenario, &path, PathKind::Steps).unwrap();
    let file = PathFormat::Geojson.write(&planned).unwrap();
    let feature: Value = serde_json::from_str(&file.text).unwrap();
    assert_eq!(feature["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::25832");
    assert_eq!((&feature["type"], &feature["geometry"]["type"]), (&json!("Feature"), &json!("LineString")));
    let line = json!([[11.0, 23.0], [11.0, 21.0], [13.0, 21.0], [15.0, 21.0], [15.0, 23.0]]);
    assert_eq!(feature["geometry"]["coordinates"], line);
    assert_eq!((&feature["properties"]["name"], &feature["properties"]["length_metres"]), (&json!("yard"), &json!(8.0)));
    assert_eq!(file.notices[0].kind, "geojson-crs");
    let refused = |world: Option<World>| {
        let scenario = Scenario::new(scenario.grid.clone(), ScenarioSpec { world, ..scenario.spec.clone() }).unwrap();
        let planned = PlannedPath::new(&scenario, &path, PathKind::Steps).unwrap();
        PathFormat::Geojson.write(&planned).unwrap_err().report()
    };
    let at = |x, frame: &str| Some(World { frame: frame.into(), ..World::at(x, 20.0) });
    for (world, field, says) in [
        (None, "world", "not known"),
        (at(10.0, ""), "world.frame", "names no coordinate system"),
        (at(10.0, "map"), "world.frame", "`map` is no coordinate system"),
        (at(10.0, "EPSG:4326"), "world.frame", "in degrees"),
        (at(10.0, "urn:ogc:def:crs:EPSG::4258"), "world.frame", "in degrees"),
    ] {
        let report = refused(world);
        assert!(report.field == field && report.message.contains(says) && !report.hint.is_empty(), "{report:?}");
    }
}

const OPEN: [&str; 4] = ["S.......", "........", "........", ".......G"];

/// A corner that a vehicle rounds, on a map with a place.
fn rounded(rows: [&str; 4], rule: Option<SmoothingRule>) -> (Arc<Scenario>, Path) {
    let open = common::drawn(&rows, Movement::default());
    let world = World { yaw: 0.7, frame: "EPSG:25832".into(), ..World::at(10.0, 20.0) };
    let mut spec = ScenarioSpec { world: Some(world), resolution: 0.5, ..open.spec.clone() };
    spec.vehicle.smoothing = rule;
    // Along the upper row, then down.
    (Arc::new(Scenario::new(open.grid.clone(), spec).unwrap()), vec![0, 7, 31])
}

#[test]
fn a_smooth_curve_is_written_and_comes_back_as_it_is() {
    let (scenario, path) = rounded(OPEN, Some(SmoothingRule { max_curvature: 1.0 }));
    let curve = Smoothed::of(&scenario, &path).unwrap();
    let measured = curve.metrics.unwrap();
    assert!(curve.is_curve && (measured.length - curve.length).abs() < 1e-9);
    for format in [PathFormat::PathCsv, PathFormat::PathJson, PathFormat::NavMsgs, PathFormat::Geojson] {
        let file = format.write(&PlannedPath::new(&scenario, &path, PathKind::Polyline).unwrap()).unwrap();
        assert_eq!(file.notices[0].kind, "path-curve", "{}", format.id());
        assert!(recognise(file.text.as_bytes(), "file").unwrap().kind == Kind::Path, "{}", format.id());
        let back = read(&file.text, &scenario.spec).metres.unwrap().between_centres(&scenario.spec).unwrap();
        assert_eq!(back.len(), curve.points.len(), "{}", format.id());
        let near = |(a, b): (&[f64; 2], &[f64; 2])| (a[0] - b[0]).abs() < 1e-9 && (a[1] - b[1]).abs() < 1e-9;
        assert!(back.iter().zip(&curve.points).all(near), "{}", format.id());
        let again = WayMetrics::of(&scenario, &back);
        assert!((again.length - curve.length).abs() < 1e-9 && (again.turning - measured.turning).abs() < 1e-6, "{again:?}");
        // A reader that asks for cells alone is told what it has.
        assert!(
            read_places(file.text.as_bytes()).unwrap_err().report().message.contains("metres") || format == PathFormat::Geojson,
            "{}",
            format.id()
        );
    }
    let drawing = write(&scenario, &path, PathKind::Polyline, PathFormat::Svg);
    let report = read_path_on(drawing.as_bytes(), &scenario.spec).unwrap_err().report();
    assert!(report.message.contains("drawing of a curve"), "{report:?}");
    let json: Value = serde_json::from_str(&write(&scenario, &path, PathKind::Polyline, PathFormat::PathJson)).unwrap();
    assert_eq!(schema::violations(&schema::load("path"), &json), Vec::<String>::new());
}

#[test]
fn a_curve_that_is_too_tight_is_told() {
    let (scenario, path) = rounded(["S.......", "#######.", "#######.", "#######G"], Some(SmoothingRule { max_curvature: 0.01 }));
    let file = PathFormat::NavMsgs.write(&PlannedPath::new(&scenario, &path, PathKind::Polyline).unwrap()).unwrap();
    assert_eq!(file.notices.iter().map(|n| n.kind.as_str()).collect::<Vec<_>>(), ["path-curve", "path-tight"]);
    let (scenario, path) = rounded(OPEN, None);
    let file = PathFormat::NavMsgs.write(&PlannedPath::new(&scenario, &path, PathKind::Polyline).unwrap()).unwrap();
    assert_eq!(file.notices, []);
}

#[test]
fn tables_of_metres_are_read_by_their_names() {
    let (scenario, _) = small("");
    let back = read("time;x_m;y_m\n0;11;23\n1;11.4;23.2\n", &scenario.spec);
    assert_eq!(back.metres.unwrap().places, [[11.0, 23.0, 0.0], [11.4, 23.2, 0.0]]);
    let report = read_path_on(b"x_m,y_m\n1,2\n1,east\n", &scenario.spec).unwrap_err().report();
    assert!(report.field == "line 3" && report.message.contains("`1,east`"), "{report:?}");
}

#[test]
fn a_line_of_another_program_is_read_and_no_other_shape() {
    let (scenario, _) = small("EPSG:25832");
    let crs = r#""crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}}"#;
    let line = r#"{"type":"LineString","coordinates":[[11,23,5],[11.4,23.2],[14.9,20.1]]}"#;
    let feature = format!(r#"{{"type":"Feature","properties":null,"geometry":{line}}}"#);
    let cells = [(Point::new(0, 0), None), (Point::new(2, 1), None)];
    for text in [
        line.to_owned(),
        format!(r#"{{"type":"FeatureCollection",{crs},"features":[{feature}]}}"#),
        format!(
            r#"{{"type":"FeatureCollection","features":[{}]}}"#,
            feature.replace("\"properties\"", &format!("{crs},\"properties\""))
        ),
        feature.replace("\"properties\"", &format!("{crs},\"properties\"")),
    ] {
        let back = read(&text, &scenario.spec);
        assert_eq!((&back.places[..], back.kind), (&cells[..], PathKind::Steps), "{text}");
        assert_eq!(back.notices.len(), usize::from(!text.contains("crs")), "degrees on a map of another system: {text}");
    }
    for (text, says) in [
        (format!(r#"{{"type":"FeatureCollection","features":[{feature},{feature}]}}"#), "2 features"),
        (feature.replace("LineString", "Polygon"), "`Polygon`"),
        (feature.replace("[11,23,5]", "[11]"), "position 0"),
        (feature.replace("11.4", "900"), "beside the map"),
        (line.replace("}", r#","crs":{"type":"name","properties":{"name":"mine"}}}"#), "names no code"),
    ] {
        let report = read_path_on(text.as_bytes(), &scenario.spec).unwrap_err().report();
        assert!(report.message.contains(says) && !report.hint.is_empty(), "{report:?}");
    }
}

fn refused(text: &str) -> ErrorReport {
    read_path_on(text.as_bytes(), &small("").0.spec).unwrap_err().report()
}

#[test]
fn a_path_as_json_follows_its_schema_and_other_versions_are_refused() {
    let (scenario, path) = small("EPSG:25832");
    let text = write(&scenario, &path, PathKind::Steps, PathFormat::PathJson);
    let document: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(schema::violations(&schema::load("path"), &document), Vec::<String>::new());
    let slices = terrains::hilly_slices(8, 5, 7, terrains::rules(Measure::Cost));
    let planner = common::solve(&slices, "slices-exact");
    let by_slices = write(&slices, planner.best().unwrap().result().0, PathKind::Steps, PathFormat::PathJson);
    let by_slices: Value = serde_json::from_str(&by_slices).unwrap();
    assert_eq!(schema::violations(&schema::load("path"), &by_slices), Vec::<String>::new());

    let svg = write(&scenario, &path, PathKind::Steps, PathFormat::Svg);
    for text in [&text, &svg] {
        let report = refused(&text.replace("path@1", "path@2"));
        assert_eq!((report.kind.as_str(), report.args["value"].as_str()), ("version", "formicarium/path@2"));
        assert!(report.hint.contains("formicarium/path@1"));
    }
    for (wrong, field) in [
        (text.replace("[0,0],", "[0,-1],"), "cells"),
        (text.replace("\"cells\"", "\"cell\""), "cells"),
        (text.replace("\"kind\"", "\"levels\": [1], \"kind\""), "levels"),
        (svg.replace("0,0 ", "0,0.5 "), "polyline"),
        (svg.replace("points", "dots"), "polyline"),
        (svg.replace("<polyline", "<line"), "polyline"),
        (svg.replace("points=", "data-levels=\"1 x\" points="), "polyline"),
    ] {
        assert_eq!(refused(&wrong).field, field, "{wrong}");
    }
}

#[test]
fn a_drawing_shows_walls_ends_and_a_scale() {
    let (scenario, path) = small("");
    let spec = ScenarioSpec { name: "a <yard> & more".into(), ..scenario.spec.clone() };
    let spec = ScenarioSpec { goals: vec![Goal::new(Point::new(2, 0), "bay \"1\"")], ..spec };
    let scenario = Scenario::new(scenario.grid.clone(), spec).unwrap();
    let svg = write(&scenario, &path, PathKind::Polyline, PathFormat::Svg);
    for part in [
        "<title>a &lt;yard&gt; &amp; more</title>",
        "d=\"M1 0h1v1h-1z\"",
        "data-kind=\"polyline\" points=\"0,0 0,1 1,1 2,1 2,0\"",
        "<circle cx=\"0\" cy=\"0\"",
        "<circle cx=\"2\" cy=\"0\"",
        "<title>bay &quot;1&quot;</title>",
        // A third of 6 m.
        "h1v-",
        ">2 m</text>",
    ] {
        assert!(svg.contains(part), "{part} is not in {svg}");
    }
    assert_eq!(path_kind(svg.as_bytes()), PathKind::Polyline);
}

#[test]
fn a_path_as_the_page_holds_it_is_the_same_file() {
    let (plane, path) = small("EPSG:25832");
    let slices = terrains::hilly_slices(8, 5, 7, terrains::rules(Measure::Cost));
    let by_slices = common::solve(&slices, "slices-exact");
    let by_slices = by_slices.best().unwrap().result().0.clone();
    for (scenario, path) in [(&plane, path), (&slices, by_slices)] {
        let points: Vec<Point> = places(scenario, &path).into_iter().map(|(at, _)| at).collect();
        let altitudes: Vec<f32> = scenario.altitudes(&path).into_iter().map(|metres| metres as f32).collect();
        let held = PlannedPath::of_points(scenario, &points, &altitudes, PathKind::Steps).unwrap();
        let text = PathFormat::PathJson.write(&held).unwrap().text;
        assert_eq!(text, write(scenario, &path, PathKind::Steps, PathFormat::PathJson));
        for wrong in [&points[..0], &points[1..], &points[..2], &[Point::new(1, 0); 3], &[Point::new(99, 99)]] {
            let report = PlannedPath::of_points(scenario, wrong, &altitudes, PathKind::Steps).unwrap_err().report();
            assert_eq!((report.kind.as_str(), report.field.as_str()), ("bad-field", "path"), "{report:?}");
        }
    }
}

#[test]
fn one_place_is_a_path_and_none_is_not() {
    let (scenario, _) = small("EPSG:25832");
    assert!(PlannedPath::new(&scenario, &[], PathKind::Steps).is_none());
    come_back(&scenario, &[0], PathKind::Steps);
}

#[test]
fn cells_that_metres_do_not_tell_apart_are_refused() {
    let (scenario, path) = small("");
    let far = placed(&scenario, World { frame: "EPSG:25832".into(), ..World::at(1e9, 1e9) }, 1e-9);
    let planned = PlannedPath::new(&far, &path, PathKind::Steps).unwrap();
    for format in [PathFormat::NavMsgs, PathFormat::Geojson] {
        let report = format.write(&planned).unwrap_err().report();
        assert!(report.field == "world" && report.message.contains("not told apart"), "{report:?}");
    }
    assert_eq!(read(&PathFormat::PathJson.write(&planned).unwrap().text, &far.spec).places.len(), path.len());
}
