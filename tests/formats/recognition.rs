//! What people really have: each class of file with the meaning that it must have, or the refusal by name.

use formicarium::formats::{Kind, ReadOptions, import, import_with, list_matrices, recognise, sniff};

use super::{notices, read, refused, rows};

#[test]
fn nothing_is_taken_for_something_else() {
    for (text, kind) in [
        ("image: a.pgm\nresolution: 0.1\norigin: [1, 2, 0]\n", Kind::RosMap),
        ("robots: [ [0, 0], [1, 1] ]\nmap:\n  dimensions: [4, 3]\n  obstacles: []\n", Kind::Mapf),
        ("NAME : five\nTYPE : TSP\nDIMENSION: 5\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n1 1 1\n", Kind::Tsplib),
        ("NAME : five\nTYPE : TOUR\nDIMENSION: 5\nTOUR_SECTION\n1\n2\n3\n4\n5\n-1\n", Kind::TsplibTour),
        ("[(0, 0), (1, 0)]", Kind::Path),
        ("row,col\n0,0\n1,0\n", Kind::Path),
        ("header:\n  frame_id: map\nposes:\n- pose:\n    position:\n      x: 1\n      y: 2\n", Kind::Path),
        ("x,y,x_m,y_m\n0,0,0.5,1.5\n", Kind::Path),
        ("{\"format\": \"formicarium/path@1\", \"cells\": [[0,0]]}", Kind::Path),
        ("{\"type\": \"LineString\", \"coordinates\": [[1.5, 2], [3, 4]]}", Kind::Path),
        ("<svg xmlns='x' data-format=\"formicarium/path@1\"><polyline points=\"0,0\"/></svg>", Kind::Path),
        ("{\"type\": \"Polygon\", \"coordinates\": [[[1, 2], [3, 4], [1, 2]]]}", Kind::Unknown),
        ("..#.\n.#..\n", Kind::Drawing),
        (
            "% function evaluation | noise-free fitness - Fopt (7.9e+01) | best noise-free fitness - Fopt | x1\n1 +2.0e+01 +2.0e+01 +1.0e+00\n",
            Kind::Results,
        ),
        (
            "{\"format\":\"formicarium/journal@2\",\"engine\":\"0.1.0\",\"experiment\":\"cc184c02b8922a1a\"}\n{\"experi",
            Kind::Journal,
        ),
        ("evaluations raw_y\n1 9.5\n", Kind::Results),
        ("P2\n2 1\n255\n0 255\n", Kind::Picture),
        // Keys and values that describe no map hold none, whatever brackets they have.
        ("grid:\n  - [0, 1]\n  - [1, 0]\n", Kind::Unknown),
        ("speed: [0, 1, 0]\n", Kind::Unknown),
        ("{\"grid\": [[0, 1], [1, 0]]}", Kind::Unknown),
        ("<html><body>[[0,1],[1,0]]</body></html>", Kind::Unknown),
        ("The maps of [1] and [2, 3] are shown in [4].\n", Kind::Unknown),
    ] {
        assert_eq!(sniff(text.as_bytes(), "file"), kind, "{text:?}");
    }
}

#[test]
fn what_cannot_be_read_says_what_to_do() {
    for (bytes, found, hint) in [
        (&b"\x93NUMPY\x01\0v\0"[..], "NumPy", "savetxt"),
        (b"MATLAB 5.0 MAT-file, Platform", "MATLAB", "writematrix"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1", "Office", "CSV"),
        (b"%PDF-1.4", "PDF", "screenshot"),
        (b"7z\xbc\xaf\x27\x1c", "7-Zip", "unpack"),
        (b"<!DOCTYPE html><html>", "web", "Raw"),
        (b"<svg xmlns='x'/>", "SVG", "PNG"),
        (b"speed: [0, 1, 0]\n", "keys and values", "map.yaml"),
    ] {
        let report = import(bytes, "file").unwrap_err().report();
        assert_eq!(report.kind, "foreign-file", "{}", report.message);
        assert!(report.message.contains(found) && report.hint.contains(hint), "{} {}", report.message, report.hint);
    }
    assert_eq!(
        refused("NAME : five\nTYPE : TSP\nDIMENSION: 5\nNODE_COORD_SECTION\n1 1 1\n").args["found"],
        "an instance of TSPLIB"
    );
    let denied = import(b"HTTP Basic: Access denied.", "N49E020.hgt").unwrap_err().report();
    assert!(denied.field == "size" && denied.hint.contains("3601"), "{denied:?}");
}

#[test]
fn every_reader_says_why() {
    let found = recognise(b"image: a.pgm\nresolution: 0.1\norigin: [1, 2, 0]\n", "").unwrap();
    assert!(found.is_certain && found.why.contains("image"));
    let drawn = read("### ##\n#   #\n##  ##\n").unwrap();
    assert_eq!((drawn.kind, notices(&drawn)[0]), (Kind::Drawing, "read-as"));
    assert_eq!(rows(&drawn.grid), ["@@@.@@", "@...@.", "@@..@@"]);
}

#[test]
fn a_program_with_two_maps_waits_for_a_choice() {
    let program = b"G=[0 0 0;\n 0 1 0;\n 0 0 0];\n% the second\nH=[0 0 1;\n 0 0 1;\n 0 1 0];\nS=1;\n";
    let report = import(program, "two.m").unwrap_err().report();
    assert_eq!(report.kind, "several-matrices");
    let list = list_matrices(program).unwrap();
    let shown: Vec<_> = list.iter().map(|m| (m.number, m.name.as_str(), m.line, m.width, m.height)).collect();
    assert_eq!(shown, [(1, "G", 1, 3, 3), (2, "H", 5, 3, 3)]);
    let options = ReadOptions { matrix: Some(2), ..ReadOptions::default() };
    let second = import_with(program, "two.m", &options, None).unwrap();
    assert_eq!((rows(&second.grid)[0].as_str(), notices(&second)[0]), ("..@", "matrix-chosen"));
}

#[test]
fn sizes_and_ends_in_the_first_lines() {
    let map = read("3 4\n0 0\n2 3\n0 0 1 0\n0 0 0 0\n1 0 0 0\n").unwrap();
    assert_eq!((map.spec.start.x, map.spec.start.y, map.spec.goals[0].at.x, map.spec.goals[0].at.y), (0, 0, 3, 2));
    assert!(map.notices.iter().any(|n| n.kind == "matrix-stated-ends" && n.args["order"] == "rows"));
    let unsure = read("4 4\n0 1\n3 2\n0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n").unwrap();
    assert!(unsure.ends_were_chosen());
    assert!(unsure.notices.iter().any(|n| n.kind == "matrix-stated-ends" && n.args["order"] == "unsure"));
}

#[test]
fn corner_heights_and_stations_of_maps_are_told() {
    let corner = read("type octile-corner\nheight 3\nwidth 3\nmap\n000\n010\n000\n..\nT.\n").unwrap();
    assert_eq!((rows(&corner.grid), notices(&corner)[0]), (vec!["..".to_owned(), "@.".to_owned()], "map-corners"));
    assert_eq!(refused("type octile-corner\nheight 3\nwidth 3\nmap\n000\n..\n..\n").field, "line 6");
    let robots = read("type octile\nheight 2\nwidth 3\nmap\nE.S\n.@.\n").unwrap();
    assert_eq!((rows(&robots.grid), notices(&robots)[0]), (vec!["...".to_owned(), ".@.".to_owned()], "map-stations"));
}

#[test]
fn what_other_programs_write_is_named() {
    for (text, found) in [
        ("{\"tilewidth\": 32, \"layers\": []}", "JSON of another program"),
        ("{\"grid\": [[0, 1]]}", "JSON of another program"),
        ("{\"suite\": \"unknown\", \"function_id\": 1, \"scenarios\": []}", "data files of IOHprofiler (.json)"),
        ("suite = 'PBO', funcId = 1, DIM = 100, algId = 'x'\n%\ndata_f1/IOHprofiler_f1_DIM100.dat, 1:100|1\n", "(.info)"),
        ("name: a\ndimension: 3\nedge_weight_type: EUC_2D\nnode_coord_section\n1 0 0\n2 1 0\n3 0 1\nEOF\n", "small letters"),
        ("P7\nWIDTH 1\nHEIGHT 1\nENDHDR\n", "PAM"),
        ("Pf\n1 1\n-1.0\nabcd", "PFM"),
        ("DSAA\n2 2\n0 1\n0 1\n0 3\n0 1\n2 3\n", "Surfer"),
        ("north: 10\nsouth: 0\neast: 10\nwest: 0\nrows: 1\ncols: 2\n1 2\n", "GRASS"),
        ("[[True, False], [False, True]]", "true and false"),
    ] {
        let report = refused(text);
        assert!(report.kind == "foreign-file" && report.message.contains(found), "{text:?}: {report:?}");
    }
    let comma = refused("ncols 2\nnrows 1\ncellsize 1\n1,5 2,5\n");
    assert!(comma.message.contains("decimal comma") && comma.field == "line 4", "{comma:?}");
}

#[test]
fn a_scenario_is_one_whatever_its_name_is() {
    let grid = formicarium::map::Grid::open(3, 2).unwrap();
    let ends = [(0, 0), (2, 1)].map(|(x, y)| formicarium::map::Point::new(x, y));
    let mut spec = formicarium::scenario::ScenarioSpec::new(&grid, ends[0], ends[1]);
    for name in ["[(1, 2)]", "x,y", "[\"..#\", \"#..\"]", "[[0,1],[1,0]]", "TOUR_SECTION"] {
        spec.name = name.into();
        let text = formicarium::formats::export(&grid, &spec, formicarium::formats::Export::Scenario);
        assert_eq!(import(text.as_bytes(), "").map(|map| map.spec.name), Ok(name.into()), "{name}");
    }
}
