//! Maps of ROS: counts and corners as an independent reading in Python gives them, and what is refused by name.

use formicarium::error::ErrorReport;
use formicarium::formats::{Companion, Imported, Kind, ReadOptions, TerrainOptions, import_with, ros, sniff};
use formicarium::map::{Point, Window};

use super::{data, refused, rows};

const LAB: &str =
    "image: lab.pgm\nresolution: 0.050000\norigin: [-10.0, -10.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

fn read(yaml: &str, image: &[u8], options: &ReadOptions) -> Result<Imported, ErrorReport> {
    let beside = Companion { name: "image", bytes: image };
    import_with(yaml.as_bytes(), "map.yaml", options, Some(beside)).map_err(|error| error.report())
}

/// A picture of one row.
fn pgm(grays: &[u8]) -> Vec<u8> {
    [format!("P5\n# by hand\n{} 1\n255\n", grays.len()).as_bytes(), grays].concat()
}

fn cells(yaml: &str, grays: &[u8]) -> Vec<u8> {
    read(yaml, &pgm(grays), &ReadOptions::default()).unwrap().grid.to_bytes()
}

/// Free, occupied and unknown cells, as the notice tells them.
fn counts(map: &Imported) -> [String; 3] {
    let notice = map.notices.iter().find(|n| n.kind == "ros-cells").unwrap();
    ["free", "occupied", "unknown"].map(|key| notice.args[key].clone())
}

#[test]
fn published_maps_have_the_cells_and_corners_of_an_independent_reading() {
    // (name, picture, size, free, occupied, unknown, middle of the upper left and of the lower right cell)
    type Known = (&'static str, &'static str, (u32, u32), [u32; 3], [f64; 4]);
    let known: [Known; 6] = [
        ("depot", "depot.pgm", (604, 307), [179_481, 5947, 0], [0.025, 15.325, 30.175, 0.025]),
        ("tb3_sandbox", "tb3_sandbox.pgm", (384, 384), [7903, 870, 138_683], [-9.975, 9.175, 9.175, -9.975]),
        ("turtlebot3_map", "turtlebot3_map.pgm", (384, 384), [7939, 795, 138_722], [-9.975, 9.175, 9.175, -9.975]),
        ("testmap", "testmap.png", (10, 10), [71, 29, 0], [1.227618, 3.555361, 2.471214, 3.826413]),
        ("TenByTen", "TenByTen.pgm", (10, 10), [78, 20, 2], [0.5, 9.5, 9.5, 0.5]),
        ("f1_aut_wide", "f1_aut_wide.png", (2000, 2000), [112_411, 18_522, 3_869_067], [-49.975, 49.975, 49.975, -49.975]),
    ];
    for (name, image, (width, height), numbers, corners) in known {
        let Some(yaml) = data(&format!("rosmap/{name}.yaml")) else { return };
        let picture = data(&format!("rosmap/{image}")).unwrap();
        let map = read(std::str::from_utf8(&yaml).unwrap(), &picture, &ReadOptions::default()).unwrap();
        assert_eq!((map.kind, map.grid.width(), map.grid.height()), (Kind::RosMap, width, height), "{name}");
        assert_eq!(counts(&map), numbers.map(|n| n.to_string()), "{name}");
        assert_eq!(map.grid.free_count(), numbers[0] as usize, "{name}");
        let ends = [Point::new(0, 0), Point::new(width - 1, height - 1)].map(|at| map.spec.to_world(at).unwrap());
        for (found, listed) in ends.iter().flatten().zip(corners) {
            assert!((found - listed).abs() < 1e-6, "{name}: {ends:?}");
        }
        // Written and read again: the same cells, the same place.
        let files = ros::write(&map.grid, map.unknown.as_ref(), &map.spec, "again.pgm");
        let again = read(&files.yaml, &files.pgm, &ReadOptions::default()).unwrap();
        assert_eq!((&again.grid, again.spec.resolution), (&map.grid, map.spec.resolution), "{name}");
        assert_eq!(again.spec.world, map.spec.world, "{name}");
        assert_eq!((counts(&again), &again.unknown), (counts(&map), &map.unknown), "{name}: unknown cells stay unknown");
    }
}

#[test]
fn a_piece_of_a_map_keeps_what_is_unknown_unless_it_is_asked_to_be_free() {
    let description = LAB;
    let picture = pgm(&[0, 205, 254, 254, 205, 254]);
    let map = read(description, &picture, &ReadOptions::default()).unwrap();
    let window = Window { x: 1, y: 0, width: 5, height: 1 };
    let piece = map.clone().piece(TerrainOptions { crop: Some(window), size: None }).unwrap();
    let gray = |map: &Imported| {
        let pgm = ros::write(&map.grid, map.unknown.as_ref(), &map.spec, "a.pgm").pgm;
        pgm[pgm.len() - map.grid.len()..].to_vec()
    };
    assert_eq!(gray(&map), [0, 205, 254, 254, 205, 254]);
    assert_eq!(gray(&piece), [205, 254, 254, 205, 254]);
    let free = ReadOptions { unknown: ros::Unknown::Free, ..ReadOptions::default() };
    assert_eq!(gray(&read(description, &picture, &free).unwrap()), [0, 254, 254, 254, 254, 254]);
    assert_eq!(gray(&map.invert().unwrap()), [254, 254, 0, 0, 254, 0], "what was blocked is free, whatever it was");
}

#[test]
fn modes_thresholds_and_negate_are_nav2s() {
    // 0.196 occupied is gray 205; the thresholds are exclusive.
    assert_eq!(cells(LAB, &[0, 89, 90, 205, 206, 255]), [1, 1, 1, 1, 0, 0]);
    let free = ReadOptions { unknown: ros::Unknown::Free, ..ReadOptions::default() };
    assert_eq!(read(LAB, &pgm(&[0, 89, 90, 205, 206]), &free).unwrap().grid.to_bytes(), [1, 1, 0, 0, 0]);
    assert_eq!(cells(&LAB.replace("negate: 0", "negate: 1"), &[255, 205, 50, 49, 0]), [1, 1, 1, 0, 0]);
    // Raw: the gray is the occupancy in percent, above 100 unknown.
    let raw = LAB.to_owned() + "mode: raw\n";
    assert_eq!(cells(&raw, &[0, 19, 20, 65, 66, 100, 101, 255]), [0, 0, 1, 1, 1, 1, 1, 1]);
    assert_eq!(read(&raw, &pgm(&[0, 19, 20, 65, 66, 100, 101, 255]), &free).unwrap().grid.to_bytes(), [0, 0, 0, 0, 1, 1, 0, 0]);
    assert_eq!(cells(&(LAB.to_owned() + "mode: scale\n"), &[0, 128, 255]), [1, 1, 0]);
}

#[test]
fn the_trap_of_205_is_told() {
    let trapped = LAB.replace("0.196", "0.25");
    let map = read(&trapped, &pgm(&[205, 205, 0]), &ReadOptions::default()).unwrap();
    let notice = map.notices.iter().find(|n| n.kind == "ros-205").unwrap();
    assert_eq!((notice.args["count"].as_str(), map.grid.to_bytes()), ("2", vec![0, 0, 1]));
    let map = read(LAB, &pgm(&[205, 254]), &ReadOptions::default()).unwrap();
    assert!(!map.notices.iter().any(|n| n.kind == "ros-205"));
}

#[test]
fn grays_of_sixteen_bits_are_not_cut() {
    // 1 − 52700 / 65535 = 0.19585 is below 0.196; of the 8 bits it would be 205, which is not.
    let states = |image: &str| read(LAB, image.as_bytes(), &ReadOptions::default()).unwrap().grid.to_bytes();
    assert_eq!(states("P2 3 1 65535 52700 52685 0"), [0, 1, 1]);
    assert_eq!(states("P2 3 1 100 81 80 35"), [0, 1, 1]);
    let trapped = read(&LAB.replace("0.196", "0.25"), b"P2 3 1 65535 52700 52685 0", &ReadOptions::default()).unwrap();
    assert_eq!(trapped.notices.iter().find(|n| n.kind == "ros-205").unwrap().args["count"], "1");
}

#[test]
fn an_opaque_alpha_is_not_told_as_a_threshold() {
    let (mut png, gray_alpha) = (Vec::new(), [205, 255, 0, 255]);
    let encoder = image::codecs::png::PngEncoder::new(&mut png);
    image::ImageEncoder::write_image(encoder, &gray_alpha, 2, 1, image::ExtendedColorType::La8).unwrap();
    let map = read(LAB, &png, &ReadOptions::default()).unwrap();
    let kinds: Vec<_> = map.notices.iter().map(|n| n.kind.as_str()).collect();
    assert!(kinds.contains(&"ros-205-alpha") && !kinds.contains(&"ros-205"), "{kinds:?}");
}

#[test]
fn descriptions_in_any_yaml_are_known() {
    let flow =
        "{image: lab.pgm, resolution: 0.05, origin: [-10.0, -10.0, 0.0], negate: 0, occupied_thresh: 0.65, free_thresh: 0.196}\n";
    let quoted = LAB.replace("image", "\"image\"").replace("resolution", "'resolution'").replace("origin", "\"origin\"");
    for yaml in [flow.to_owned(), quoted, LAB.replace("image: ", "image:\t"), LAB.to_owned() + "mode: Trinary\n"] {
        assert_eq!(sniff(yaml.as_bytes(), "map.yaml"), Kind::RosMap, "{yaml}");
        assert_eq!(cells(&yaml, &[0, 255]), [1, 0], "{yaml}");
    }
    assert_eq!(cells(&(LAB.to_owned() + "mode: RAW\n"), &[0, 100]), [0, 1]);
    let map = read(&LAB.replace("negate: 0\n", ""), &pgm(&[0, 255]), &ReadOptions::default()).unwrap();
    assert!(map.notices.iter().any(|n| n.kind == "ros-no-threshold" && n.args["key"] == "negate"), "{:?}", map.notices);
}

#[test]
fn fewer_cells_are_as_blocked_as_the_worst_and_stay_where_they_are() {
    let image =
        [b"P5\n5 3\n255\n".as_slice(), &[254, 254, 254, 254, 205, 254, 254, 254, 254, 254, 0, 254, 254, 254, 254]].concat();
    let options = ReadOptions { cells: Some(3), ..ReadOptions::default() };
    let map = read(LAB, &image, &options).unwrap();
    assert_eq!(rows(&map.grid), ["..@", "@.."]);
    // Two by two cells of 0.05 m; the upper edge stays at −10 + 3 · 0.05.
    assert_eq!(map.spec.resolution, 0.1);
    let [x, y] = map.spec.to_world(Point::new(0, 0)).unwrap();
    assert!((x - -9.95).abs() < 1e-9 && (y - (-9.85 - 0.05)).abs() < 1e-9, "{x} {y}");
}

#[test]
fn half_of_a_map_says_what_it_needs() {
    assert_eq!(sniff(LAB.as_bytes(), ""), Kind::RosMap);
    let alone = refused(LAB);
    assert_eq!((alone.kind.as_str(), alone.args["other"].as_str()), ("needs-file", "lab.pgm"));
    for (from, to, field) in [
        ("image: lab.pgm\n", "image:\n", "image"),
        ("resolution: 0.050000", "resolution: 0", "resolution"),
        ("resolution: 0.050000", "resolution: fine", "resolution"),
        ("[-10.0, -10.0, 0.0]", "[-10.0, -10.0]", "origin"),
        ("[-10.0, -10.0, 0.0]", "here", "origin"),
        ("0.65", "65", "occupied_thresh"),
        ("0.196", "0.7", "free_thresh"),
        ("negate: 0", "negate: maybe", "negate"),
        ("negate: 0", "negate: 0\nmode: best", "mode"),
        ("negate: 0", "negate: 0\nnegate: 1", "line 5"),
    ] {
        let report = read(&LAB.replace(from, to), &pgm(&[0, 254]), &ReadOptions::default()).unwrap_err();
        assert_eq!(report.field, field, "{}", report.message);
    }
    let no_picture = read(LAB, b"hello", &ReadOptions::default()).unwrap_err();
    assert_eq!(no_picture.kind, "not-a-map");
}

#[test]
fn messages_are_read_from_the_south() {
    let yaml = "header:\n  frame_id: map\ninfo:\n  resolution: 0.5\n  width: 3\n  height: 2\n  origin:\n    position:\n      x: 1.0\n      y: 2.0\n      z: 0.0\n    orientation:\n      x: 0.0\n      y: 0.0\n      z: 0.7071067811865475\n      w: 0.7071067811865476\ndata:\n- 0\n- 100\n- -1\n- 0\n- 30\n- 0\n---\n";
    let map = super::read(yaml).unwrap();
    assert_eq!((map.kind, rows(&map.grid)), (Kind::OccupancyGrid, vec![".@.".to_owned(), ".@@".to_owned()]));
    let world = map.spec.world.clone().unwrap();
    assert_eq!((world.x, world.y, world.frame.as_str()), (1.0, 2.0, "map"));
    assert!((world.yaw - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    let json =
        r#"{"info": {"resolution": 1, "width": 2, "height": 1, "origin": {"position": {"x": 0, "y": 0}}}, "data": [0, 100]}"#;
    assert_eq!(rows(&super::read(json).unwrap().grid), [".@"]);
    let twice = super::read(&yaml.repeat(2)).unwrap();
    assert!(twice.notices.iter().any(|n| n.kind == "ros-first-message") && twice.grid == map.grid, "{:?}", twice.notices);
    assert!(!map.notices.iter().any(|n| n.kind == "ros-first-message"));
    assert_eq!(refused(&yaml.replace("      w: 0.7071067811865476", "      w: 0.0")).field, "orientation");
    assert_eq!(
        refused(
            &yaml.replace("      x: 0.0\n      y: 0.0\n      z: 0.7", "      x: 0.7071\n      y: 0.0\n      z: 0.0\n      #")
        )
        .field,
        "orientation"
    );
    assert!(refused(&yaml.replace("- 0\n---\n", "- '...'\n---\n")).hint.contains("--full-length"));
    assert_eq!(refused(&yaml.replace("width: 3", "width: 4")).field, "data");
    assert_eq!(refused(&yaml.replace("- 100", "- 101")).field, "data");
}

#[test]
fn instances_of_many_agents_ask_the_first_ones_question() {
    let yaml = "agents:\n-   goal: [2, 0]\n    name: agent0\n    start: [0, 0]\n-   goal: [0, 0]\n    start: [2, 0]\nmap:\n    dimensions: [3, 2]\n    obstacles:\n    - !!python/tuple [1, 0]\n";
    let map = super::read(yaml).unwrap();
    assert_eq!((map.kind, rows(&map.grid)), (Kind::Mapf, vec![".@.".to_owned(), "...".to_owned()]));
    assert_eq!((map.spec.start, map.spec.goals[0].at), (Point::new(0, 0), Point::new(2, 0)));
    let robots =
        super::read("robots: [ [0, 0], [1, 1] ]\nmap:\n  dimensions: [4, 3]\n  obstacles: [ [2, 0], [1, 1] ]\n").unwrap();
    assert_eq!((rows(&robots.grid)[0].as_str(), robots.spec.start), ("..@.", Point::new(0, 0)));
    assert_eq!(refused(&yaml.replace("[1, 0]", "[3, 0]")).field, "obstacles");
}
