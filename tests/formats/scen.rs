//! MovingAI .scen

use formicarium::error::FormatError;
use formicarium::formats::{Kind, ScenFile, check_scen, import_scen, sniff};
use formicarium::map::{Grid, Point};

use super::{data, refused};

const SCEN: &str =
    "version 1\n0\tmaps/dao/arena.map\t49\t48\t1\t11\t1\t12\t1\n0\tmaps/dao/arena.map\t49\t48\t1\t13\t4\t12\t3.41421\n";

fn read(text: &str) -> ScenFile {
    import_scen(text.as_bytes()).unwrap_or_else(|e| panic!("{text:?}: {e}"))
}

#[test]
fn fields_are_where_they_belong() {
    let file = read(SCEN);
    let line = &file.lines[1];
    assert_eq!((line.line, line.bucket, line.map.as_str()), (3, 0, "maps/dao/arena.map"));
    assert_eq!((line.width, line.height), (49, 48));
    assert_eq!((line.start, line.goal), (Point::new(1, 13), Point::new(4, 12)));
    assert_eq!(line.optimal, 3.41421);
    assert_eq!(sniff(SCEN.as_bytes(), "x.map"), Kind::MovingaiScen);
    assert_eq!(refused(SCEN).kind, "not-a-map");
}

#[test]
fn quirks_of_real_files_are_accepted() {
    let wanted = read(SCEN);
    let quirks = [
        SCEN.replace('\n', "\r\n"),
        SCEN.replace("version 1\n", "version 1.0\n"),
        SCEN.replace('\t', " "),
        SCEN.replace('\t', "\t\t"),
        format!("\u{feff}\n{}\n\n", SCEN.replace('\n', " \n")),
    ];
    for text in quirks {
        let lines = read(&text).lines;
        let same = |i: usize| ScenLineKey::of(&lines[i]) == ScenLineKey::of(&wanted.lines[i]);
        assert!(lines.len() == 2 && same(0) && same(1), "{text:?}: {lines:?}");
    }
    for separated in [SCEN.replace("dao/arena", "a b c"), SCEN.replace("dao/arena", "a b c").replace('\t', " ")] {
        assert_eq!(read(&separated).lines[0].map, "maps/a b c.map");
    }
}

/// What must not depend on the spelling.
#[derive(PartialEq)]
struct ScenLineKey(String, [u32; 2], Point, Point, f64);

impl ScenLineKey {
    fn of(line: &formicarium::formats::ScenLine) -> Self {
        Self(line.map.clone(), [line.width, line.height], line.start, line.goal, line.optimal)
    }
}

#[test]
fn a_missing_version_is_noticed_and_a_newer_one_refused() {
    let bare = SCEN.replace("version 1\n", "");
    let file = read(&bare);
    assert_eq!((file.lines.len(), file.notices[0].kind.as_str()), (2, "scen-version"));
    assert_eq!(sniff(bare.as_bytes(), "a.scen"), Kind::MovingaiScen);
    let error = import_scen(SCEN.replace("version 1", "version 2").as_bytes()).unwrap_err();
    assert!(matches!(error, FormatError::Version { .. }), "{error}");
}

#[test]
fn errors_name_the_line() {
    let cases = [
        (SCEN.replace("\t3.41421", ""), 3, "8 fields"),
        (SCEN.replace("3.41421", "x"), 3, "`x` is no length"),
        (SCEN.replace("3.41421", "-1"), 3, "`-1` is no length"),
        (SCEN.replace("3.41421", "nan"), 3, "no length"),
        (SCEN.replacen("\t49\t", "\t4x9\t", 1), 2, "`4x9` is no whole number"),
        ("version 1\n".to_string(), 0, "holds no scenario"),
    ];
    for (text, line, message) in cases {
        let Err(FormatError::Syntax { line: got, what, .. }) = import_scen(text.as_bytes()) else { panic!("{text:?}") };
        assert_eq!(got, line, "{text:?}");
        assert!(what.contains(message), "{what}");
    }
}

#[test]
fn tolerance_follows_the_printed_digits() {
    // Six significant digits without trailing zeros: a printed 3 is 3.00000.
    let file = read(SCEN);
    assert!(file.lines[0].fits(1.0) && !file.lines[0].fits(1.001));
    assert!(file.lines[1].fits(2.0 + std::f64::consts::SQRT_2) && !file.lines[1].fits(3.4143));
    let long = read(&SCEN.replace("3.41421", "1234.56"));
    assert!(long.lines[1].fits(1234.564) && !long.lines[1].fits(1234.57));
    // Fixed decimals: as many as are printed.
    let fixed = read(&SCEN.replace("\t1\n", "\t1.00\n").replace("3.41421", "3.41"));
    assert!(fixed.lines[1].fits(2.0 + std::f64::consts::SQRT_2) && !fixed.lines[1].fits(3.42));
}

#[test]
fn ends_are_checked_against_the_map() {
    let mut grid = Grid::open(49, 48).unwrap();
    assert!(check_scen(&read(SCEN), &grid).is_empty());
    grid.set_blocked(grid.cell(Point::new(4, 12)), true);
    let outside = SCEN.replace("\t1\t11\t", "\t1\t48\t");
    let found: Vec<_> = check_scen(&read(&outside), &grid).into_iter().map(|n| (n.kind, n.message)).collect();
    assert_eq!(found[0], ("scen-end-outside".into(), "line 2: the start (1, 48) lies outside the map".into()));
    assert_eq!(found[1], ("scen-end-blocked".into(), "line 3: the goal (4, 12) lies on a blocked cell".into()));
    let other = check_scen(&read(SCEN), &Grid::open(5, 5).unwrap());
    assert!(other.len() == 2 && other[0].kind == "scen-size");
}

#[test]
fn published_lists_are_read() {
    for (name, count) in [("arena2.map.scen", 910), ("divideandconquer.map.scen", 1280), ("room-64-64-16-random-1.scen", 1000)] {
        let Some(bytes) = data(&format!("movingai/{name}")) else { return };
        let lines = import_scen(&bytes).unwrap().lines.len();
        assert!(lines >= count, "{name}: {lines}");
    }
}
