//! Maps as matrices.

use formicarium::formats::{Export, Kind, export, import, sniff};
use formicarium::map::Point;

use super::{data, notices, read, refused, rows};

#[test]
fn two_is_the_start_and_three_the_goal() {
    let map = read("2,0,1\n0,0,3\n").unwrap();
    assert_eq!(map.kind, Kind::Matrix);
    assert_eq!(rows(&map.grid), ["..@", "..."]);
    assert_eq!((map.spec.start, map.spec.goals[0].at), (Point::new(0, 0), Point::new(2, 1)));
    assert_eq!(notices(&map), ["matrix-one-is-blocked", "matrix-ends"]);
    assert!(!map.ends_were_chosen());
}

#[test]
fn a_lone_end_gets_its_counterpart() {
    let map = read("[0 0 1; 0 2 1; 1 1 0]").unwrap();
    assert_eq!((map.spec.start, map.spec.goals[0].at), (Point::new(1, 1), Point::new(1, 1)));
    assert!(map.ends_were_chosen());
    let map = read("0 0 0\n0 0 3\n").unwrap();
    assert_eq!((map.spec.start, map.spec.goals[0].at), (Point::new(0, 0), Point::new(2, 1)));
}

#[test]
fn other_numbers_are_told() {
    let map = read("0,255,0\n0,255,0\n0,0,0\n").unwrap();
    assert_eq!(rows(&map.grid), [".@.", ".@.", "..."]);
    assert!(map.notices[1].message.contains("2 cells hold 255"), "{}", map.notices[1].message);
    let several_starts = read("2,2,0\n0,0,0\n").unwrap();
    assert_eq!(rows(&several_starts.grid), ["@@.", "..."]);
    assert_eq!(read("0,10,20,30\n10,1,0,30\n").unwrap().kind, Kind::Matrix);
}

#[test]
fn many_different_numbers_are_heights() {
    for (text, kind) in [
        ("0,10,20,30\n40,0,0,0\n", Kind::HeightTable),
        ("0,10,20,30\n0,0,0,0\n", Kind::Matrix),
        ("2,1,0,3\n4,5,6,1\n", Kind::Matrix),
        ("2,1,0,3\n4,5,6,2\n", Kind::HeightTable),
        ("0,1,2,3\n3,2,1,0\n", Kind::Matrix),
        ("0.5,1.5\n2.5,3.5\n", Kind::HeightTable),
    ] {
        assert_eq!((sniff(text.as_bytes(), ""), read(text).map(|map| map.kind)), (kind, Ok(kind)), "{text}");
    }
}

#[test]
fn ragged_rows_are_named() {
    for (text, line, row) in
        [("0,0\n\n0\n", "line 3", "row 2"), ("G=[0 0;1 1;\n0 0 1]", "line 2", "row 3"), ("00\n000\n", "line 2", "row 2")]
    {
        let report = refused(text);
        assert_eq!(report.field, line, "{}", report.message);
        assert!(report.message.contains(row), "{}", report.message);
    }
}

#[test]
fn too_long_rows_are_refused() {
    let report = refused(&"0,".repeat(4097));
    assert_eq!(report.kind, "map-size");
}

#[test]
fn a_matlab_program_gives_its_map() {
    let program = "%% 蚁群算法\nfunction main()\nclc; clear all;\nG=[0 1 0;\n 0 1 0; % wall\n 0 0 0;];\nMM=size(G,1);\nTau=ones(MM*MM,MM*MM);\n";
    let (gbk, _) = program.split_at(program.find('蚁').unwrap());
    let mut bytes = gbk.as_bytes().to_vec();
    bytes.extend(b"\xd2\xcf\xc8\xba"); // the comment in GBK, as such files come
    bytes.extend(&program.as_bytes()[program.find("\nfunction").unwrap()..]);
    for bytes in [program.as_bytes(), &bytes] {
        let map = import(bytes, "ant.m").unwrap();
        assert_eq!(rows(&map.grid), [".@.", ".@.", "..."]);
        assert_eq!(map.notices[1].kind, "matrix-rest-ignored");
    }
}

#[test]
fn export_is_plain_csv() {
    let map = read("2 1\n0 3").unwrap();
    assert_eq!(export(&map.grid, &map.spec, Export::Matrix), "0,1\n0,0\n");
}

#[test]
fn maps_of_papers_are_read() {
    let Some(bytes) = data("papers/G12_antran_map2.csv") else { return };
    let map = import(&bytes, "G12_antran_map2.csv").unwrap();
    assert_eq!((map.spec.start, map.spec.goals[0].at), (Point::new(0, 0), Point::new(10, 7)));
    for name in ["G20_classic", "G20_search_dense", "G20_winsleo_walls", "G256_maaco_image5"] {
        let Some(bytes) = data(&format!("papers/{name}.csv")) else { return };
        let map = import(&bytes, name).unwrap();
        assert!([20, 256].contains(&map.grid.width()), "{name}: {:?}", map.notices);
    }
}
