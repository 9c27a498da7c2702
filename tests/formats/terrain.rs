//! Rasters of heights: what is read, what is refused, what a piece of one is, and what comes back from every format.

use formicarium::error::ErrorReport;
use formicarium::formats::{
    BinaryExport, Export, Imported, Kind, TerrainOptions, export, export_binary, import, import_piece, import_terrain, sniff,
    survey,
};
use formicarium::map::{Grid, Point, SliceRules, Window};
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

use super::{data, notices, read, refused};

const ASC: &str =
    "ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 4000000\ncellsize 10\nNODATA_value -9999\n1 2.5 -9999\n-4 5 6e1\n";

fn heights(map: &Imported) -> Vec<f32> {
    map.grid.heights().unwrap().to_vec()
}

fn bits(heights: &[f32]) -> Vec<u32> {
    heights.iter().map(|h| h.to_bits()).collect()
}

/// A small terrain with a cell that has no data.
fn small() -> (Grid, ScenarioSpec) {
    let grid = Grid::open(3, 2).unwrap().with_heights(vec![1.0, 2.5, f32::NAN, -4.0, 0.1, 1234.5]).unwrap();
    let spec = ScenarioSpec { resolution: 10.0, ..ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(2, 1)) };
    (grid, spec)
}

#[test]
fn an_esri_grid_becomes_a_surface() {
    let map = read(ASC).unwrap();
    assert_eq!((map.kind, map.grid.width(), map.grid.height(), map.spec.resolution), (Kind::EsriAscii, 3, 2, 10.0));
    assert_eq!(bits(&heights(&map)), bits(&[1.0, 2.5, f32::NAN, -4.0, 5.0, 60.0]));
    assert_eq!(map.grid.to_bytes(), [0, 0, 1, 0, 0, 0]);
    let surface = TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Surface { max_slope: 90.0 } };
    assert_eq!((map.spec.terrain, map.spec.start, map.spec.goals[0].at), (Some(surface), Point::new(0, 0), Point::new(2, 1)));
    assert_eq!(notices(&map), ["terrain-no-data", "ends-chosen"]);
    Scenario::new(map.grid, map.spec).unwrap();
}

#[test]
fn esri_headers_come_in_many_spellings() {
    let same = [
        ASC.to_uppercase(),
        ASC.replace('\n', "\r\n"),
        format!("# made by hand\n{ASC}\n\n"),
        ASC.replace("xllcorner", "xllcenter").replace("yllcorner", "YLLCenter"),
        "nrows 2 ncols 3 cellsize 10\n1 2.5\n-9999 -4\n5\n6e1".into(),
        "NROWS 2\nNCOLS 3\nDX 10\nDY 10\n\t1 2.5 -9999.0 -4 5 60".into(),
        ASC.replace("-9999\n1", "-1\n1").replace("2.5 -9999", "2.5 -1.0"),
        ASC.replace("NODATA_value -9999", "NODATA_value nan").replace("2.5 -9999", "2.5 NaN"),
    ];
    for text in same {
        assert_eq!(sniff(text.as_bytes(), "a.txt"), Kind::EsriAscii, "{text}");
        let map = read(&text).unwrap();
        assert_eq!(bits(&heights(&map)), bits(&[1.0, 2.5, f32::NAN, -4.0, 5.0, 60.0]), "{text}");
        assert_eq!(map.spec.resolution, 10.0);
    }
}

#[test]
fn cells_in_degrees_are_told_and_turned_into_metres() {
    let text = "ncols 2\nnrows 2\nxllcorner -105\nyllcorner 59.99\ncellsize 0.01\n1 2\n3 4\n";
    let map = read(text).unwrap();
    // At 60° a degree of longitude is half as long: 1113.2 m high, 556.6 m wide; 787.15 m = √(1113.2 · 556.6).
    assert!((map.spec.resolution - 787.151).abs() < 1e-3, "{}", map.spec.resolution);
    assert_eq!(notices(&map), ["terrain-geographic", "terrain-cells-not-square", "ends-chosen"]);
    let seen = survey(text.as_bytes(), "").unwrap();
    assert!((seen.cell[0] - 556.6).abs() < 1e-6 && (seen.cell[1] - 1113.2).abs() < 1e-6, "{:?}", seen.cell);
    // Half as many columns are as wide as they are high, on the same ground.
    let square = import_terrain(text.as_bytes(), "", TerrainOptions { size: Some((1, 2)), ..TerrainOptions::default() }).unwrap();
    assert!((square.spec.resolution - 1113.2).abs() < 1e-6);
    assert_eq!((heights(&square), notices(&square)), (vec![1.5, 3.5], vec!["terrain-geographic", "ends-chosen"]));
    // A corner that lies nowhere on Earth, or cells of centimetres: no degrees.
    assert_eq!(read(&text.replace("-105", "500000")).unwrap().spec.resolution, 0.01);
}

#[test]
fn broken_esri_grids_are_refused_with_line_or_field() {
    let cases: [(&str, &str, &str, &str); 17] = [
        ("60 ", "", "line 8", "ends after 5 heights, in row 2"),
        ("6e1", "6e1 7", "line 8", "`7` follows the last height"),
        ("2.5", "two", "line 7", "`two` is no number"),
        ("cellsize 10", "cellsize 10 5", "line 5", "`5` stands behind the number of `cellsize`"),
        ("cellsize 10", "cellsize 10\ndx 10\ndy 5", "cellsize", "beside dx or dy"),
        ("cellsize 10", "cellsize 0", "cellsize", "0 × 0"),
        ("cellsize 10", "cellsize -5", "cellsize", "-5 × -5"),
        ("cellsize 10\n", "", "cellsize", "missing"),
        ("ncols 3\n", "", "ncols", "missing"),
        ("ncols 3", "ncols 2.5", "ncols", "2.5"),
        ("ncols 3", "ncols 0", "ncols", "0"),
        ("nrows 2", "ncols 2", "line 2", "`ncols` stands twice"),
        ("nrows 2", "rows 2", "line 2", "`rows` is no key"),
        ("1 2.5 -9999\n-4 5 6e1 \n", "", "line 6", "ends after 0 heights, in row 1"),
        ("-9999\n1 2.5 -9999\n-4 5 6e1 \n", "", "line 6", "nothing follows `nodata_value`"),
        ("cellsize 10", "cellsize 1e300", "cellsize", "000"),
        ("cellsize 10", "cellsize 1e-300", "cellsize", "0."),
    ];
    for (from, to, field, message) in cases {
        let text = ASC.replace("6e1\n", "6e1 \n").replace(if from == "60 " { "6e1 " } else { from }, to);
        let report = refused(&text);
        assert_eq!(report.field, field, "{text}: {}", report.message);
        assert!(report.message.contains(message), "{} lacks {message}", report.message);
    }
    let empty = refused(&ASC.replace("1 2.5 -9999\n-4 5 6e1", "-9999 -9999 -9999 -9999 -9999 -9999"));
    assert_eq!(empty.kind, "no-heights");
}

#[test]
fn words_and_heights_that_no_ground_has_are_without_data() {
    for (word, kind) in [
        ("nan", "terrain-words"),
        ("-nan", "terrain-words"),
        ("NULL", "terrain-words"),
        ("1.#QNAN", "terrain-words"),
        ("-1.#IND00", "terrain-words"),
        ("-inf", "terrain-words"),
        ("1e39", "terrain-impossible"),
        ("-3.4028235e38", "terrain-impossible"),
        ("12000.5", "terrain-impossible"),
    ] {
        let map = read(&ASC.replace("2.5", word)).unwrap();
        assert!(heights(&map)[1].is_nan() && notices(&map).contains(&kind), "{word}: {:?}", map.notices);
    }
    let map = read(&ASC.replace("NODATA_value -9999", "NODATA_value null")).unwrap();
    assert!(notices(&map).contains(&"ends-chosen"));
}

#[test]
fn absurd_claims_cost_nothing() {
    for (columns, rows) in [("1000000000", "1000000000"), ("65536", "65536"), ("1e30", "1"), ("1", "99999999999")] {
        let report = refused(&format!("ncols {columns}\nnrows {rows}\ncellsize 1\n1 2 3\n"));
        assert_eq!(report.kind, "too-large", "{}", report.message);
    }
    // As many as may be read, but the text has three.
    let report = refused("ncols 8192\nnrows 8192\ncellsize 1\n1 2 3\n");
    assert!(report.message.contains("ends after 3 heights"), "{}", report.message);
}

#[test]
fn a_table_of_heights_becomes_a_surface() {
    let map = read("10,20,30\n40,-9999,60\n").unwrap();
    assert_eq!((map.kind, map.spec.resolution), (Kind::HeightTable, 1.0));
    assert_eq!(bits(&heights(&map)), bits(&[10.0, 20.0, 30.0, 40.0, f32::NAN, 60.0]));
    assert_eq!(notices(&map), ["heights-in-table", "terrain-cell-size", "terrain-no-data", "ends-chosen"]);
    assert_eq!(refused("10,20,30\n40,50\n").field, "line 2");
    let impossible = read("10,20,30\n40,1e300,60\n").unwrap();
    assert_eq!(bits(&heights(&impossible)), bits(&[10.0, 20.0, 30.0, 40.0, f32::NAN, 60.0]));
    assert!(notices(&impossible).contains(&"terrain-impossible"));
}

#[test]
fn maps_of_0_to_3_never_become_heights() {
    // Every table of these four numbers with up to 2 × 3 cells.
    for code in 0..4usize.pow(6) {
        let digit = |k: u32| (code / 4usize.pow(k) % 4).to_string();
        let text = format!("{},{},{}\n{},{},{}\n", digit(0), digit(1), digit(2), digit(3), digit(4), digit(5));
        assert_eq!(sniff(text.as_bytes(), "a.csv"), Kind::Matrix, "{text}");
    }
}

#[test]
fn a_window_and_a_size_can_be_asked_for() {
    let text = "ncols 4\nnrows 3\ncellsize 5\n0 1 2 3\n10 11 12 13\n20 21 22 23\n";
    let piece = |crop, size| import_terrain(text.as_bytes(), "", TerrainOptions { crop, size }).unwrap();
    let window = Window { x: 1, y: 1, width: 2, height: 2 };
    assert_eq!(heights(&piece(Some(window), None)), [11.0, 12.0, 21.0, 22.0]);
    assert_eq!(heights(&piece(Some(window), Some((2, 2)))), [11.0, 12.0, 21.0, 22.0]);
    let half = piece(Some(Window { x: 0, y: 0, width: 4, height: 2 }), Some((2, 1)));
    assert_eq!((heights(&half), half.spec.resolution), (vec![5.5, 7.5], 10.0));
    let refuse = |crop, size| import_terrain(text.as_bytes(), "", TerrainOptions { crop, size }).unwrap_err().report();
    let outside = refuse(Some(Window { x: 3, y: 0, width: 2, height: 1 }), None);
    assert_eq!((outside.kind.as_str(), outside.field.as_str()), ("window", "crop"));
    assert_eq!(refuse(None, Some((0, 5))).kind, "map-size");
    assert_eq!(refuse(None, Some((4097, 5))).kind, "map-size");
    for (bytes, found) in [("0,1\n1,0\n", "a matrix"), ("type octile\nheight 1\nwidth 1\nmap\n.\n", "a map of the MovingAI")] {
        let report = import_terrain(bytes.as_bytes(), "", TerrainOptions::default()).unwrap_err().report();
        assert!(report.kind == "not-a-terrain" && report.message.contains(found), "{}", report.message);
    }
}

#[test]
fn a_piece_by_slices_is_a_scenario_again() {
    // A ramp of 10 m a column, levels of 10 m: the start leaves the ground's lowest column and comes to lie higher up.
    let grid = Grid::open(8, 2).unwrap().with_heights((0..16).map(|c| (c % 8) as f32 * 10.0).collect()).unwrap();
    let rules = SliceRules { level: 10.0, levels: 9, start_level: 1, goal_level: 8, ..SliceRules::fitting(70.0, 0.0, 70.0) };
    let terrain = TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Slices(rules) };
    let ends = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(7, 1));
    let file = export(&grid, &ScenarioSpec { terrain: Some(terrain), ..ends }, Export::Scenario);
    let crop = Some(Window { x: 4, y: 0, width: 4, height: 2 });
    let piece = import_piece(file.as_bytes(), "", TerrainOptions { crop, size: None }).unwrap();
    let Some(TerrainSpec { moves: TerrainMoves::Slices(found), .. }) = piece.spec.terrain else { panic!("{piece:?}") };
    assert_eq!((piece.spec.start, found.start_level, found.goal_level), (Point::new(0, 0), 4, 8));
    assert_eq!(read(&export(&piece.grid, &piece.spec, Export::Scenario)).unwrap().spec, piece.spec);
}

#[test]
fn heights_of_a_scenario_beyond_every_float_are_refused() {
    let (grid, spec) = small();
    let file = export(&grid, &spec, Export::Scenario);
    let report = refused(&file.replace("1234.5", "1e39"));
    assert!(report.message.contains("at (2, 1) is no height"), "{}", report.message);
}

#[test]
fn what_is_larger_than_a_map_is_shrunk_by_a_whole_number() {
    let row = |y: u32| (0..5000).map(|x| format!("{}", x + y)).collect::<Vec<_>>().join(" ");
    let text = format!("ncols 5000\nnrows 4\ncellsize 2\n{}\n{}\n{}\n{}\n", row(0), row(1), row(2), row(3));
    let map = read(&text).unwrap();
    assert_eq!((map.grid.width(), map.grid.height(), map.spec.resolution), (2500, 2, 4.0));
    assert_eq!(heights(&map)[..3], [1.0, 3.0, 5.0]);
    assert_eq!(map.notices[0].kind, "terrain-shrunk");
    let seen = survey(text.as_bytes(), "").unwrap();
    assert_eq!((seen.width, seen.height, seen.preview_width, seen.preview_height), (5000, 4, 256, 1));
}

#[test]
fn a_survey_tells_what_is_in_the_file() {
    let seen = survey(ASC.as_bytes(), "a.asc").unwrap();
    assert_eq!((seen.kind, seen.width, seen.height, seen.cell), (Kind::EsriAscii, 3, 2, [10.0, 10.0]));
    assert_eq!((seen.lowest, seen.highest, seen.missing), (-4.0, 60.0, 1));
    assert_eq!((seen.preview_width, seen.preview_height), (3, 2));
    assert_eq!(bits(&seen.preview), bits(&[1.0, 2.5, f32::NAN, -4.0, 5.0, 60.0]));
}

#[test]
fn terrains_survive_every_format_of_heights() {
    let (grid, spec) = small();
    let texts = [
        export(&grid, &spec, Export::EsriAscii),
        export(&grid, &spec, Export::HeightTable),
        export(&grid, &spec, Export::Scenario),
    ];
    let tiff = export_binary(&grid, &spec, BinaryExport::Geotiff).unwrap();
    let files = texts.iter().map(|text| text.as_bytes()).chain([&tiff[..]]);
    for (bytes, kind) in files.zip([Kind::EsriAscii, Kind::HeightTable, Kind::Scenario, Kind::Geotiff]) {
        let back = import(bytes, "a").unwrap();
        assert_eq!((back.kind, &back.grid), (kind, &grid));
        if kind != Kind::HeightTable {
            assert_eq!(back.spec.resolution, 10.0, "{kind:?}");
        }
    }
    // Heights in feet are written in metres.
    let feet = TerrainSpec { vertical_unit: 0.5, ..TerrainSpec::default() };
    let halved = export(&grid, &ScenarioSpec { terrain: Some(feet), ..spec.clone() }, Export::HeightTable);
    assert_eq!(halved, "0.5,1.25,-9999\n-2,0.05,617.25\n");
    // A plane has height 0; its obstacles have none. Cells of 5 cm are not taken for degrees.
    let plane = Grid::from_bytes(2, 1, &[0, 1]).unwrap();
    let plane_spec = ScenarioSpec { resolution: 0.05, ..ScenarioSpec::new(&plane, Point::new(0, 0), Point::new(0, 0)) };
    let back = read(&export(&plane, &plane_spec, Export::EsriAscii)).unwrap();
    assert_eq!((back.grid.to_bytes(), back.spec.resolution), (vec![0, 1], 0.05));
    // Planar formats hold the cells alone.
    assert_eq!(export(&grid, &spec, Export::Matrix), "0,0,1\n0,0,0\n");
    assert_eq!(read(&export(&grid, &spec, Export::MovingaiMap)).unwrap().grid.heights(), None);
}

#[test]
fn a_height_that_is_the_value_for_no_data_stays_a_height() {
    let grid = Grid::open(2, 1).unwrap().with_heights(vec![-9999.0, f32::NAN]).unwrap();
    let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(0, 0));
    let text = export(&grid, &spec, Export::EsriAscii);
    assert!(text.contains("NODATA_value -99999\n"), "{text}");
    assert_eq!(read(&text).unwrap().grid, grid);
    assert_eq!(import(&export_binary(&grid, &spec, BinaryExport::Geotiff).unwrap(), "").unwrap().grid, grid);
}

/// A tile of 1201 × 1201 samples: column − row; none in the upper left corner.
fn tile() -> Vec<u8> {
    let height = |i: i32| if i == 0 { i16::MIN } else { (i % 1201 - i / 1201) as i16 };
    (0..1201 * 1201).flat_map(|i| height(i).to_be_bytes()).collect()
}

#[test]
fn an_srtm_tile_is_told_by_its_size() {
    let bytes = tile();
    assert_eq!((sniff(&bytes, "N60E010.hgt"), sniff(&bytes, "renamed")), (Kind::Srtm, Kind::Srtm));
    let map = import(&bytes, "folder/N60E010.hgt").unwrap();
    assert_eq!((map.grid.width(), map.grid.height()), (1201, 1201));
    let found = heights(&map);
    assert!(found[0].is_nan());
    assert_eq!((found[1], found[1201], found[1201 * 1201 - 1]), (1.0, -1.0, 0.0));
    // 3″ at 60.5° N: 92.767 m high, 45.680 m wide.
    let seen = survey(&bytes, "N60E010.hgt").unwrap();
    assert!((seen.cell[0] - 45.680).abs() < 1e-3 && (seen.cell[1] - 92.767).abs() < 1e-3, "{:?}", seen.cell);
    assert!(notices(&import(&bytes, "renamed").unwrap()).contains(&"terrain-no-latitude"));
    assert_eq!(export_binary(&map.grid, &map.spec, BinaryExport::Srtm).unwrap(), bytes);
    // One byte less is no tile: by its name it was meant to be one, without a name nothing is known.
    assert_eq!((sniff(&bytes[1..], "N60E010.hgt"), sniff(&bytes[1..], "")), (Kind::Srtm, Kind::Unknown));
    let report = import(&bytes[1..], "N60E010.hgt").unwrap_err().report();
    assert!(report.field == "size" && report.hint.contains("25,934,402"), "{report:?}");
    assert_eq!(import(&bytes[1..], "").unwrap_err().report().kind, "not-text");
    let (grid, spec) = small();
    let report: ErrorReport = export_binary(&grid, &spec, BinaryExport::Srtm).unwrap_err().report();
    assert!(report.field == "size" && report.hint.contains("1201"), "{report:?}");
}

#[test]
fn published_terrains_are_read() {
    let files = [
        ("dem/DEM_10m.asc", (67, 53), 10.0, (1660.0, 1711.0), 0),
        ("dem/hugo_site.asc", (76, 55), 10.0, (1660.0, 1711.0), 2028),
        ("dem/srtmgl3_144x144.asc", (144, 144), 81.103, (2186.0, 3345.0), 0),
        ("dem/west_bijou_gully.asc", (43, 89), 3.0, (1680.7794, 1725.4326), 2739),
        ("dem/pysheds_dem.tif", (367, 359), 85.112, (147.0, 298.0), 0),
        ("papers/HeightData_21x21.csv", (21, 21), 1.0, (0.0, 2100.0), 0),
    ];
    for (name, size, resolution, (lowest, highest), missing) in files {
        let Some(bytes) = data(name) else { return };
        let map = import(&bytes, name).unwrap();
        let seen = survey(&bytes, name).unwrap();
        println!("{name}: {} to {} in cells of {:?}", seen.lowest, seen.highest, seen.cell);
        assert_eq!((map.grid.width(), map.grid.height(), seen.missing), (size.0, size.1, missing), "{name}");
        assert!((map.spec.resolution - resolution).abs() < 1e-3, "{name}: {}", map.spec.resolution);
        assert_eq!((seen.lowest, seen.highest), (lowest, highest), "{name}");
        Scenario::new(map.grid, map.spec).unwrap();
    }
}

#[test]
fn damaged_texts_are_read_or_refused() {
    let (grid, spec) = small();
    for text in [ASC.to_string(), "10,20,30\n40,-9999,60\n".into(), export(&grid, &spec, Export::Scenario)] {
        let bytes = text.as_bytes();
        for at in 0..bytes.len() {
            let _ = import(&bytes[..at], "a");
            for letter in [0, b'\n', b' ', b'-', b'.', b'9', b'e', b'n', b'#', 0xff, bytes[at] ^ 1] {
                let mut spoiled = bytes.to_vec();
                spoiled[at] = letter;
                if let Err(error) = import(&spoiled, "a") {
                    assert!(!error.report().hint.is_empty());
                }
            }
        }
    }
}

#[test]
fn what_looks_like_no_data_and_is_not_announced_is_told() {
    let map = read(&ASC.replace("NODATA_value -9999", "NODATA_value -1")).unwrap();
    assert_eq!(heights(&map)[2], -9999.0);
    assert!(notices(&map).contains(&"terrain-9999"), "{:?}", notices(&map));
    assert!(!notices(&read(ASC).unwrap()).contains(&"terrain-9999"));
}
