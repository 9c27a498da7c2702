//! For all files: no bytes make a reader panic, and every map survives every format.

use formicarium::formats::session::{Session, read_session_link, write_session_link};
use formicarium::formats::{
    BinaryExport, Export, TerrainOptions, export, export_binary, import, import_piece, import_results, import_scen, read_places,
    sniff, survey,
};
use formicarium::map::{CornerRule, Grid, Movement, Moves, Point, Window};
use formicarium::scenario::{Goal, Inflation, Robot, ScenarioSpec, Vehicle};
use proptest::prelude::*;

use super::data;

/// Reads bytes as everything; what is accepted must be usable.
fn read_all(bytes: &[u8]) {
    for name in ["a.map", "a.scen"] {
        sniff(bytes, name);
        match import(bytes, name) {
            Ok(map) => {
                assert_eq!((map.spec.width, map.spec.height), (map.grid.width(), map.grid.height()));
                for end in [map.spec.start, map.spec.goals[0].at] {
                    assert!(map.grid.contains(end) && !map.grid.is_blocked(map.grid.cell(end)));
                }
            }
            Err(error) => {
                let report = error.report();
                assert!(!report.kind.is_empty() && !report.message.is_empty() && !report.hint.is_empty());
            }
        }
    }
    let _ = import_scen(bytes);
    let _ = read_places(bytes);
    let _ = survey(bytes, "a.hgt");
    match import_results(bytes, "a.csv") {
        Ok(results) => assert!(results.runs() > 0 && results.entries.iter().all(|e| !e.id.is_empty() && !e.label.is_empty())),
        Err(error) => assert!(!error.report().message.is_empty() && !error.report().hint.is_empty()),
    }
    let window = Window { x: 1, y: 0, width: 2, height: 2 };
    let _ = import_piece(bytes, "a.asc", TerrainOptions { crop: Some(window), size: Some((3, 1)) });
}

fn maps() -> impl Strategy<Value = Grid> {
    (1u32..20, 1u32..20).prop_flat_map(|(w, h)| {
        // The first cell is free, so that there is one.
        proptest::collection::vec(0u8..2, (w * h) as usize).prop_map(move |mut cells| {
            cells[0] = 0;
            Grid::from_bytes(w, h, &cells).unwrap()
        })
    })
}

/// Any finite heights, and cells without; the first cell has one.
fn terrains() -> impl Strategy<Value = Grid> {
    let height = prop_oneof![4 => -500.0f32..9000.0, 1 => Just(f32::NAN), 1 => Just(-9999.0f32), 1 => -12e3f32..12e3, 1 => -1e-20f32..1e-20];
    (1u32..12, 1u32..12).prop_flat_map(move |(w, h)| {
        proptest::collection::vec(height.clone(), (w * h) as usize).prop_map(move |mut heights| {
            heights[0] = 1.0;
            Grid::open(w, h).unwrap().with_heights(heights).unwrap()
        })
    })
}

/// Maps with any factors; of all 1 there are none.
fn weighted() -> impl Strategy<Value = Grid> {
    let factor = prop_oneof![2 => Just(1.0f32), 2 => 1.0f32..1000.0, 1 => Just(1000.0f32), 1 => (4u8..40).prop_map(|n| f32::from(n) / 4.0)];
    maps().prop_flat_map(move |grid| {
        let factors = proptest::collection::vec(factor.clone(), grid.len());
        factors.prop_map(move |factors| grid.clone().with_factors(factors).unwrap())
    })
}

fn specs() -> impl Strategy<Value = (Grid, ScenarioSpec)> {
    let rules = prop::sample::select(&CornerRule::ALL[..]);
    let moves = prop_oneof![Just(Moves::Four), Just(Moves::Eight)];
    // Decimals as people write them.
    let decimal = (1u32..1_000_000, 0i32..6).prop_map(|(n, e)| f64::from(n) / 10f64.powi(e));
    (maps(), "\\PC{0,12}", decimal.clone(), decimal, moves, rules).prop_map(
        |(grid, name, resolution, speed, moves, corner_rule)| {
            let goal = Goal { area: resolution, ..Goal::new(Point::new(0, 0), name.clone()) };
            let spec = ScenarioSpec {
                name,
                resolution,
                movement: Movement { moves, corner_rule },
                goals: vec![goal],
                vehicle: Vehicle { speed, ..Vehicle::default() },
                ..ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(0, 0))
            };
            (grid, spec)
        },
    )
}

/// Valid files, to be spoiled.
fn samples() -> Vec<Vec<u8>> {
    let grid = Grid::from_bytes(4, 3, &[0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0]).unwrap();
    let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(3, 2));
    let formats = [Export::MovingaiMap, Export::MovingaiScen { optimal: 4.5 }, Export::Matrix, Export::Scenario];
    let mut samples: Vec<Vec<u8>> = formats.iter().map(|&f| export(&grid, &spec, f).into_bytes()).collect();
    samples.push(b"G = [0 1 0; ... first\n 1 0 2; % second\n 3 0 0;];\nx = size(G);\n".to_vec());
    samples.push(b"[[0, 1],\n [1, 0]]".to_vec());
    samples.push(b"version 1.0\r\n3 a b.map 4 3 0 0 3 2 4.50\r\n".to_vec());
    samples.push(
        b"NCOLS 3\r\nnrows 2\nxllcorner -105.5\nyllcorner 40\ncellsize 0.01\nNODATA_value -9999\n1 2 -9999\n4.5 5 6e1\n".to_vec(),
    );
    samples.push(b"entry,instance,seed,length,turns,evaluations\nA,m,1,34.5,3,10\nA,m,1,33.0,3,20\n\"B, b\",m,2,,,\n".to_vec());
    samples.push(b"seed;value;status\r\n1;34,5;optimal\r\n2;nan;\r\n".to_vec());
    samples.push(b"\"function evaluation\" \"best-so-far f(x)\"\n1  +2.95e+02\n9 inf\nevaluations raw_y\n3 4\n".to_vec());
    samples.push(b"10,20,30\n40,-9999,60\n7,8,9\n".to_vec());
    let dear = grid.clone().with_factors((1..=12u8).map(f32::from).collect()).unwrap();
    samples.push(export(&dear, &spec, Export::Scenario).into_bytes());
    let heights = vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, f32::NAN, 11.0, 12.0];
    let terrain = grid.with_heights(heights).unwrap();
    let spec = ScenarioSpec::new(&terrain, Point::new(0, 0), Point::new(3, 2));
    samples.push(export(&terrain, &spec, Export::Scenario).into_bytes());
    samples.push(export_binary(&terrain, &spec, BinaryExport::Geotiff).unwrap());
    samples
}

#[derive(Debug, Clone)]
enum Spoil {
    Cut(usize),
    Remove(usize),
    Put(usize, u8),
    Repeat(usize, usize),
}

impl Spoil {
    fn apply(&self, bytes: &mut Vec<u8>) {
        let len = bytes.len().max(1);
        match *self {
            Self::Cut(at) => bytes.truncate(at % len),
            Self::Remove(at) if !bytes.is_empty() => drop(bytes.remove(at % len)),
            Self::Put(at, byte) => bytes.insert(at % len, byte),
            Self::Repeat(from, to) if !bytes.is_empty() => {
                let (a, b) = ((from % len).min(to % len), (from % len).max(to % len));
                let piece = bytes[a..b].to_vec();
                bytes.splice(b..b, piece);
            }
            _ => {}
        }
    }
}

fn spoils() -> impl Strategy<Value = Vec<Spoil>> {
    let at = 0usize..400;
    let telling = prop::sample::select(&b"\0\t\n\r \"%#,-./0123;@GSTW[]{}\xef\xff"[..]);
    let one = prop_oneof![
        1 => at.clone().prop_map(Spoil::Cut),
        4 => at.clone().prop_map(Spoil::Remove),
        4 => (at.clone(), prop_oneof![telling, any::<u8>()]).prop_map(|(a, b)| Spoil::Put(a, b)),
        2 => (at.clone(), at).prop_map(|(a, b)| Spoil::Repeat(a, b)),
    ];
    proptest::collection::vec(one, 1..6)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        read_all(&bytes);
    }

    #[test]
    fn any_text_of_telling_letters_is_read_or_refused(text in "(version 1|type octile|height 3|width 4|map|length|seed,value|evaluations raw_y|[\\[\\]{};,.%#=\" \\t\\r\\n0-9eE@GSTWx-]){0,60}") {
        read_all(text.as_bytes());
    }

    #[test]
    fn tables_of_results_are_read_or_refused(
        header in prop::sample::select(&["length", "entry,seed,length", "seed;value;iterations", "run\tcost\tevaluations\tstatus"][..]),
        body in "(1|2|3|7|0.5|1e3|nan|inf|,|;|\t|\n|\r\n|\"|#| |a|-|optimal){0,80}",
    ) {
        read_all(format!("{header}\n{body}").as_bytes());
        read_all(format!("evaluations raw_y\n{body}").as_bytes());
    }

    #[test]
    fn spoiled_files_are_read_or_refused(which in 0usize..15, spoils in spoils()) {
        let mut bytes = samples().swap_remove(which);
        spoils.iter().for_each(|s| s.apply(&mut bytes));
        read_all(&bytes);
    }

    #[test]
    fn spoiled_published_files_are_read_or_refused(which in 0usize..5, at in 0usize..8000, spoils in spoils()) {
        const FILES: [&str; 5] =
            ["movingai/den312d.map", "movingai/arena.map.scen", "movingai/Berlin_0_256.map", "papers/G12_antran_map2.csv", "papers/G20_classic.csv"];
        if let Some(mut bytes) = data(FILES[which]) {
            // The damage goes anywhere in the file, not only into its beginning.
            let mut tail = bytes.split_off(at % bytes.len());
            spoils.iter().for_each(|s| s.apply(&mut tail));
            bytes.extend(tail);
            read_all(&bytes);
        }
    }

    #[test]
    fn maps_survive_every_format((grid, spec) in specs()) {
        // A single number is no matrix.
        let formats = [Export::MovingaiMap, Export::Scenario, Export::Matrix].into_iter().take(if grid.len() > 1 { 3 } else { 2 });
        for format in formats {
            let text = export(&grid, &spec, format);
            let back = import(text.as_bytes(), "").unwrap();
            prop_assert_eq!(&back.grid, &grid);
            prop_assert_eq!(export(&back.grid, &back.spec, format), text);
        }
    }

    #[test]
    fn weighted_ground_survives_its_files_and_links(grid in weighted(), radius in 0.0f64..5.0, cost_scaling in 0.1f64..20.0) {
        let inflation = Some(Inflation { radius, cost_scaling, ..Inflation::NAV2 });
        let robot = Some(Robot { radius: 0.0, inflation });
        let spec = ScenarioSpec { robot, ..ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(0, 0)) };
        let back = import(export(&grid, &spec, Export::Scenario).as_bytes(), "").unwrap();
        prop_assert_eq!((&back.grid, &back.spec), (&grid, &spec));
        let session = Session { engine: String::new(), grid, spec, origin: None, changes: 0, panels: Vec::new(), seed: 1 };
        let link = write_session_link(&session).unwrap();
        prop_assert_eq!(read_session_link(&link), Ok(session));
    }

    #[test]
    fn terrains_survive_every_format(grid in terrains()) {
        let spec = ScenarioSpec { resolution: 12.5, ..ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(0, 0)) };
        for format in [Export::EsriAscii, Export::Scenario] {
            let back = import(export(&grid, &spec, format).as_bytes(), "").unwrap();
            prop_assert_eq!((&back.grid, back.spec.resolution), (&grid, 12.5));
        }
        let back = import(&export_binary(&grid, &spec, BinaryExport::Geotiff).unwrap(), "").unwrap();
        prop_assert_eq!((&back.grid, back.spec.resolution), (&grid, 12.5));
    }

    #[test]
    fn scenarios_survive_json((grid, spec) in specs()) {
        let back = import(export(&grid, &spec, Export::Scenario).as_bytes(), "").unwrap();
        prop_assert_eq!(back.spec, spec);
    }

    #[test]
    fn scenarios_survive_scen((grid, spec) in specs(), optimal in 0.0f64..5000.0) {
        let file = import_scen(export(&grid, &spec, Export::MovingaiScen { optimal }).as_bytes()).unwrap();
        let line = &file.lines[0];
        prop_assert_eq!((line.start, line.goal), (spec.start, spec.goals[0].at));
        prop_assert_eq!((line.width, line.height), (spec.width, spec.height));
        prop_assert!(line.fits(optimal));
    }
}
