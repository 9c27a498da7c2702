//! MovingAI .map

use formicarium::formats::{Kind, sniff};
use formicarium::map::Point;

use super::{data, notices, read, refused, rows};

const MAP: &str = "type octile\nheight 3\nwidth 4\nmap\n.@.G\nO.TS\n...W\n";

#[test]
fn every_terrain_letter_is_read_and_odd_ones_are_noticed() {
    let map = read(MAP).unwrap();
    assert_eq!(map.kind, Kind::MovingaiMap);
    assert_eq!(rows(&map.grid), [".@..", "@.@.", "...@"]);
    assert_eq!(notices(&map), ["swamp", "water", "ends-chosen"]);
    assert_eq!(map.spec.name, "test");
    assert_eq!(map.spec.start, Point::new(1, 1));
}

#[test]
fn quirks_of_real_files_are_accepted() {
    let quirks = [
        MAP.replace('\n', "\r\n"),
        format!("\u{feff}{MAP}"),
        MAP.to_lowercase(),
        MAP.replace('\n', " \n"),
        format!("\n{MAP}\n\n  \n"),
        MAP.replace("height 3\nwidth 4", "width 4\nheight 3"),
        "width 4\nheight 3\ntype octile\nmap\n.@.G\nO.TS\n...W".to_string(),
        MAP.replace("type octile", "TYPE Octile").replace("\nmap", "\nMAP"),
        MAP.replace("octile", "tile"),
        MAP.replace('\n', "\r"),
    ];
    let wanted = read(MAP).unwrap().grid;
    for text in quirks {
        let map = read(&text).unwrap_or_else(|e| panic!("{text:?}: {e}"));
        assert_eq!(map.grid, wanted, "{text:?}");
    }
    assert_eq!(notices(&read(&MAP.replace("octile", "tile")).unwrap())[0], "map-type");
}

#[test]
fn errors_name_the_line() {
    let cases = [
        (MAP.replace("O.TS", "O.T"), "line 6", "the row has 3 cells where the width is 4"),
        (MAP.replace("O.TS", "O.TSS"), "line 6", "the row has 5 cells"),
        (MAP.replace("O.TS", "O.xS"), "line 6", "`x` in column 2"),
        (MAP.replace("...W\n", ""), "line 7", "ends after 2 of 3 rows"),
        (format!("{MAP}....\n"), "line 8", "after the last of 3 rows"),
        (MAP.replace("height 3", "height three"), "line 2", "`three` is no whole number"),
        (MAP.replace("height 3", "height -3"), "line 2", "`-3` is no whole number"),
        (MAP.replace("height 3", "width 4"), "line 3", "stands twice"),
        (MAP.replace("height 3\n", ""), "line 3", "names no `height`"),
        (MAP.replace("height 3", "depth 3"), "line 2", "`depth 3` is no header line"),
    ];
    for (text, field, message) in cases {
        let report = refused(&text);
        assert_eq!((report.kind.as_str(), report.field.as_str()), ("syntax", field), "{text:?}: {}", report.message);
        assert!(report.message.contains(message), "{text:?}: {}", report.message);
        assert!(report.hint.starts_with("expected "), "{}", report.hint);
    }
}

#[test]
fn absurd_sizes_are_refused_before_anything_is_allocated() {
    for size in ["0", "4097", "4000000000", "99999999999999999999999999"] {
        let report = refused(&MAP.replace("width 4", &format!("width {size}")));
        assert_eq!(report.kind, "map-size", "{size}: {}", report.message);
    }
}

#[test]
fn a_map_of_rock_is_refused_with_a_hint() {
    let report = refused("type octile\nheight 1\nwidth 2\nmap\n@T\n");
    assert_eq!(report.kind, "no-free-cell");
    assert!(report.hint.contains("invert"), "{}", report.hint);
}

#[test]
fn contents_decide_what_a_file_is() {
    for name in ["a.map", "a.csv", "a.json", ""] {
        assert_eq!(sniff(MAP.as_bytes(), name), Kind::MovingaiMap, "{name}");
    }
    for text in ["", "hello", "type octile", "{}", "<html>", "height of the tower\nis unknown"] {
        assert_eq!(sniff(text.as_bytes(), "a.map"), Kind::Unknown, "{text:?}");
    }
    assert_eq!(refused("hello").kind, "unknown-format");
    for (bytes, kind, found) in [
        (&b"%PDF-1.7"[..], "foreign-file", "a PDF document"),
        (b"\x93NUMPY\x01\0", "foreign-file", "a NumPy array (.npy)"),
        (b"GIF89a", "foreign-file", "a GIF image"),
        (b"\xff\xfet\0", "foreign-file", "text in UTF-16"),
    ] {
        let report = formicarium::formats::import(bytes, "a.map").unwrap_err().report();
        assert_eq!((report.kind.as_str(), report.args["found"].as_str()), (kind, found));
    }
    let png = formicarium::formats::import(b"\x89PNG\r\n\x1a\n\0\0", "a.map").unwrap_err().report();
    assert!(png.message.contains("PNG"), "{}", png.message);
}

#[test]
fn published_maps_are_read() {
    let free = [("arena2", 24_311), ("den312d", 2_445), ("Berlin_0_256", 48_147), ("random-32-32-20", 819)];
    for (name, count) in free {
        let Some(bytes) = data(&format!("movingai/{name}.map")) else { return };
        let map = formicarium::formats::import(&bytes, &format!("{name}.map")).unwrap();
        assert_eq!((map.grid.free_count(), map.spec.name.as_str()), (count, name));
    }
    let Some(bytes) = data("movingai/divideandconquer.map") else { return };
    let map = formicarium::formats::import(&bytes, "").unwrap();
    assert_eq!(notices(&map)[..2], ["swamp", "water"]);
}
