//! Files to begin with: small ones of every format, made here or committed; more where FORMICARIUM_DATA is set.

use std::path::{Path, PathBuf};
use std::{env, fs};

use formicarium::comparison::{Comparison, Shard};
use formicarium::formats::journal::JournalLines;
use formicarium::formats::{BinaryExport, Export, PathFormat, PlannedPath, comparison_json, export, export_binary};
use formicarium::map::{Grid, Measure, Point};
use formicarium::path::PathKind;
use formicarium::scenario::{Goal, Inflation, Robot, Scenario, ScenarioSpec, World};

use crate::{common, terrains};

#[derive(Clone)]
pub struct File {
    pub name: String,
    pub bytes: Vec<u8>,
}

/// Larger ones are left out: they would be read a few times a second.
const LARGEST: u64 = 24 << 10;

pub fn corpus() -> Vec<File> {
    let mut files: Vec<File> =
        written().into_iter().chain(exported()).chain(paths()).map(|(name, bytes)| File { name: name.into(), bytes }).collect();
    for folder in ["tests/fixtures", "experiments/maps"] {
        add_folder(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), &mut files);
    }
    files
}

/// What is too large to commit; says so where it is missing.
pub fn add_data(files: &mut Vec<File>) {
    let Some(data) = env::var_os("FORMICARIUM_DATA").filter(|data| !data.is_empty()).map(PathBuf::from) else {
        return println!("fuzz: FORMICARIUM_DATA is not set; without its files");
    };
    add_folder(&data, files);
    let cases = data.parent().map(|folder| folder.join("cases")).filter(|folder| folder.is_dir());
    match cases {
        Some(cases) => add_folder(&cases, files),
        None => println!("fuzz: no folder `cases` beside FORMICARIUM_DATA"),
    }
}

fn add_folder(folder: &Path, files: &mut Vec<File>) {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        // Links and pictures are the page's: links.mjs.
        let of_page = path.extension().is_some_and(|end| end == "link" || end == "png");
        if path.is_dir() {
            add_folder(&path, files);
        } else if of_page {
            continue;
        } else if path.metadata().is_ok_and(|file| file.len() <= LARGEST) {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            files.extend(fs::read(&path).map(|bytes| File { name, bytes }));
        }
    }
}

const QUESTION: &str = r#""question": {"format": "formicarium/question@1", "title": "t", "asks": "?", "seeds": {"from": 1, "count": 2},
"instances": [{"id": "open", "map": "open.json", "group": "one"}], "budget": {"axis": "iterations", "amount": 20},
"entries": [{"id": "ants", "label": "ants", "role": "improved", "planner": "ant-system", "set": {"iterations": 5, "ants": 4}},
{"id": "exact", "label": "A*", "role": "other", "planner": "astar", "published": {"open": {"length": 3.4, "turns": 1}}},
{"id": "mine", "label": "mine", "role": "other", "results": "mine.csv"}],
"claims": [{"id": "c", "says": "shorter", "improved": "ants", "baseline": "exact", "measure": "length", "direction": "less", "relevant": 0.02},
{"id": "d", "says": "sooner", "improved": "ants", "baseline": "mine", "measure": "running-time", "direction": "less", "target": 0.1, "axis": "moves"}],
"facts": [{"group": "one", "optimum_at_most": 3.5, "optimum_of": "exact", "arrives": ["ants"], "in_at_least": 0.9, "says": "table 1"}]}"#;

/// A comparison of which there is a journal.
pub fn small() -> Comparison {
    let document = comparison(QUESTION);
    comparison_json::open(&String::from_utf8_lossy(&document)).expect("a question that can be asked").comparison
}

/// Its journal.
fn journal() -> Vec<u8> {
    let comparison = small();
    let lines = JournalLines::of(&comparison, Shard::new(1, 2).ok());
    let row = |task| comparison.run(task, &mut || 0.0).map(|timed| lines.line(&timed.row)).unwrap_or_default();
    let tasks = lines.tasks().iter().copied();
    (lines.head() + &tasks.take(4).map(row).collect::<String>()).into_bytes()
}

fn comparison(question: &str) -> Vec<u8> {
    let map = r#"{"format": "formicarium/scenario@1", "name": "", "width": 3, "height": 2, "start": [0,0], "goals": [{"at": [2,1]}],
"map": {"rows": ["..@", "..."]}}"#;
    format!("{{\"format\": \"formicarium/comparison@1\",\n{question},\n\"maps\": [\n{map}]}}\n").into_bytes()
}

/// An instance of TSPLIB.
pub const FIVE_PLACES: &str = "NAME: five\nTYPE: TSP (a pentagon)\nDIMENSION: 5\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n\
1 10 0\n2 3.1 9.5\n3 -8.1 5.9\n4 -8.1 -5.9\n5 3.1 -9.5\nEOF\n";

fn written() -> Vec<(&'static str, Vec<u8>)> {
    let texts = [
        ("five.tsp", FIVE_PLACES),
        (
            "three.atsp",
            "NAME: three\nTYPE: ATSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FULL_MATRIX\n\
EDGE_WEIGHT_SECTION\n9999 1 2\n3 9999 4\n5 6 9999\nEOF\n",
        ),
        (
            "four.tsp",
            "NAME: four\nTYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: LOWER_DIAG_ROW\n\
DISPLAY_DATA_TYPE: TWOD_DISPLAY\nEDGE_WEIGHT_SECTION\n0 1 0 2 3 0 4 5 6 0\nDISPLAY_DATA_SECTION\n1 0 0\n2 1 0\n3 1 1\n4 0 1\nEOF\n",
        ),
        (
            "driven.json",
            r#"{"format": "formicarium/scenario@1", "width": 4, "height": 2, "start": [0,0], "goals": [{"at": [3,1]}],
"drive": {"changes": [{"at_step": 2, "blocked": [[1,1]]}, {"at_step": 5, "freed": [[1,1]]}],
"tracks": [{"cells": [[1,0],[2,0],[2,1]], "size": 2, "from_step": 1, "steps_per_cell": 3, "at_end": "back-and-forth"}], "sight": 2.5},
"map": {"rows": ["....", "...."]}}"#,
        ),
        ("five.opt.tour", "NAME: five.opt.tour\nTYPE: TOUR\nDIMENSION: 5\nTOUR_SECTION\n1\n2\n3\n4\n5\n-1\nEOF\n"),
        ("a.m", "G = [0 1 0; ... first\n 1 0 2; % second\n 3 0 0;];\nx = size(G);\n"),
        ("a.py", "import numpy as np\ng = np.array([[0, 1],\n [1, 0]])\n"),
        ("a.txt", "001\n010\n"),
        ("a.csv", "0;0;1\n0;1;0\n2;0;3\n"),
        ("b.csv", "0,255,1\n0,1,7\n"),
        ("s.scen", "version 1.0\r\n3 a b.map 4 3 0 0 3 2 4.50\r\n3\ta b.map\t4\t3\t0\t0\t2\t2\t3.41421\r\n"),
        ("old.scen", "0\tmaps/dao/arena.map\t49\t49\t1\t13\t4\t12\t3.41421\n"),
        ("swamp.map", "height 3\nTYPE octile\nwidth 4\nmap\n.@.G\nO.TS\n...W\n"),
        (
            "d.asc",
            "NCOLS 3\r\nnrows 2\nxllcorner -105.5\nyllcorner 40\ncellsize 0.01\nNODATA_value -9999\n1 2 -9999\n4.5 5 6e1\n",
        ),
        ("e.asc", "ncols 2\nnrows 2\ndx 10\ndy 20\nNODATA_value nan\n# a comment\n1 nan 3\n4\n"),
        ("h.csv", "10,20,30\n40,-9999,60\n7,8,9\n"),
        ("r.csv", "entry,instance,seed,length,turns,evaluations\nA,m,1,34.5,3,10\nA,m,1,33.0,3,20\n\"B, b\",m,2,,,\n"),
        ("q.csv", "seed;value;status\r\n1;34,5;optimal\r\n2;nan;\r\n"),
        ("t.csv", "run\tcost\titerations\titeration of best\tant_moves\n1\t7.5\t100\t20\t3000\n"),
        ("i.dat", "\"function evaluation\" \"best-so-far f(x)\"\n1  +2.95e+02\n9 inf\nevaluations raw_y\n3 4\n"),
        (
            "p.json",
            r#"{"format": "formicarium/result@1", "objective": "polyline-length", "path": [[0,0],[1,1],[2,1]], "levels": [1,2,2]}"#,
        ),
        ("p.csv", "x,y\n0,0\n1,1\n2,1\n"),
        ("p.m", "[1 1; 2 2; 3 2]"),
        ("l.csv", "0,0,1\n1,0,2\n"),
        (
            "lab.yaml",
            "image: lab.pgm\nresolution: 0.05\norigin: [-10.0, 3.5, 0.2]\nnegate: 0\nmode: scale\noccupied_thresh: 0.65\nfree_thresh: 0.25\n",
        ),
        (
            "grid.yaml",
            "header:\n  frame_id: map\ninfo:\n  resolution: 0.5\n  width: 2\n  height: 2\n  origin:\n    position: {x: 1.0, y: 2.0, z: 0.0}\n    orientation: {x: 0.0, y: 0.0, z: 0.5, w: 0.8}\ndata:\n- 0\n- 100\n- -1\n- 30\n---\n",
        ),
        ("mapf.yaml", "agents:\n- {name: a, start: [0, 0], goal: [2, 1]}\nmap:\n  dimensions: [3, 2]\n  obstacles: [ [1, 0] ]\n"),
        ("path.yaml", "poses:\n- pose:\n    position: {x: 1.0, y: 2.0}\n- pose:\n    position: {x: 1.5, y: 2.0}\n"),
        ("maze.txt", "S.#.\n.#.G\n....\n"),
        ("sized.txt", "3 4\n0 0\n2 3\n0 0 1 0\n0 0 0 0\n1 0 0 0\n"),
        ("frame.csv", ",0,1,2,3\n0,0,0,1,1\n1,0,1,0,0\n2,1,0,0,0\n"),
        ("two.m", "%{\nG=[1]\n%}\nG=[0 0;\n 0 1];\nH=[0 1;\n 1 0];\nd=[0 1;0 -1];\n"),
        ("a.cpp", "#define N 2\nint g[N][N] = {{0, 1}, /* wall */ {1, 0}};\nint main() { return g[0][1]; }\n"),
        ("shown.txt", "G =\n\n  Columns 1 through 2\n\n   0   1\n   1   0\n\n  Column 3\n\n   0\n   0\n"),
        ("t.py", "[(0, 0), (np.int64(1), 1), (2, 1)]"),
        ("t.json", "[{'x': 0, 'y': 0}, {'y': 1, 'x': 1}]"),
        ("rc.csv", "step;Row;Col\n0;0;0\n1;1;1\n"),
        ("five.tsp", "NAME : five\nTYPE : TSP\nDIMENSION: 2\nNODE_COORD_SECTION\n1 1 1\n2 5 1\nEOF\n"),
        (
            "coco.dat",
            "% function evaluation | noise-free fitness - Fopt (7.9e+01) | best noise-free fitness - Fopt | x1\n1 +2.0e+01 +2.0e+01 +1.0e+00\n4 +1.2e+01 +1.2e+01 +1.0e+00\n",
        ),
        ("corner.map", "type octile-corner\nheight 3\nwidth 3\nmap\n000\n010\n000\n.E\nTS\n"),
        ("p2.pgm", "P2\n# by hand\n3 2\n9\n0 3 9\n9 9 1\n"),
        ("words.asc", "ncols 2\nnrows 2\ncellsize 2\nnodata null\nnan 1.#QNAN\n3 -3.4e38\n"),
    ];
    let mut all: Vec<_> = texts.into_iter().map(|(name, text)| (name, text.as_bytes().to_vec())).collect();
    all.push(("q.json", comparison(QUESTION)));
    all.push(("q.journal", journal()));
    all
}

/// What the exporters write: planes, tours, surfaces, slices.
fn exported() -> Vec<(&'static str, Vec<u8>)> {
    let grid = Grid::from_bytes(4, 3, &[0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0]).expect("a rectangle");
    let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(3, 2));
    let text = |format| export(&grid, &spec, format).into_bytes();
    let mut all = vec![
        ("plane.map", text(Export::MovingaiMap)),
        ("plane.map.scen", text(Export::MovingaiScen { optimal: 4.5 })),
        ("plane.csv", text(Export::Matrix)),
        ("plane.json", text(Export::Scenario)),
    ];
    let goals = vec![Goal { area: 0.3, ..Goal::new(Point::new(3, 2), "a") }, Goal::new(Point::new(3, 0), "b")];
    let dear = grid.clone().with_factors((0..12u8).map(|i| 1.0 + f32::from(i % 5) / 4.0).collect()).expect("factors");
    let robot = Some(Robot { radius: 0.25, inflation: Some(Inflation::NAV2) });
    all.push(("weighted.json", export(&dear, &ScenarioSpec { robot, ..spec.clone() }, Export::Scenario).into_bytes()));
    all.push(("goals.json", export(&grid, &ScenarioSpec { goals, ..spec }, Export::Scenario).into_bytes()));
    let mut add = |names: [&'static str; 4], scenario: &Scenario| {
        let text = |format| export(&scenario.grid, &scenario.spec, format).into_bytes();
        let [json, asc, csv, tif] = names;
        all.push((json, text(Export::Scenario)));
        all.push((asc, text(Export::EsriAscii)));
        all.push((csv, text(Export::HeightTable)));
        all.extend(export_binary(&scenario.grid, &scenario.spec, BinaryExport::Geotiff).map(|bytes| (tif, bytes)));
    };
    add(["hilly.json", "hilly.asc", "hilly.csv", "hilly.tif"], &terrains::hilly(9, 7, 3, 6.0, terrains::sixteen()[2], 60.0));
    let slices = terrains::hilly_slices(8, 5, 7, terrains::rules(Measure::Cost));
    add(["slices.json", "slices.asc", "slices.csv", "slices.tif"], &slices);
    let random = common::random(12, 0.25, 5, formicarium::map::Movement::default());
    all.push(("random.map", export(&random.grid, &random.spec, Export::MovingaiMap).into_bytes()));
    all
}

/// A map with a place in the world.
pub fn placed() -> Scenario {
    let plain = common::drawn(&["S.#G", "...."], formicarium::map::Movement::default());
    let world = World { frame: "EPSG:25832".into(), yaw: 0.5, ..World::at(1e5, 5e6) };
    Scenario::new(plain.grid.clone(), ScenarioSpec { world: Some(world), ..plain.spec.clone() }).expect("usable")
}

/// A path of it in every format, and one by slices.
fn paths() -> Vec<(&'static str, Vec<u8>)> {
    let placed = placed();
    let slices = terrains::hilly_slices(8, 5, 7, terrains::rules(Measure::Cost));
    let by_slices = common::solve(&slices, "slices-exact");
    let path = PlannedPath::new(&placed, &[0, 5, 6, 7, 3], PathKind::Steps).expect("it has places");
    let levels = by_slices.best().and_then(|best| PlannedPath::new(&slices, best.result().0, PathKind::Steps)).expect("a path");
    let file = |name, path, format: PathFormat| (name, format.write(path).expect("it can be written").text.into_bytes());
    vec![
        file("out.path.csv", &path, PathFormat::PathCsv),
        file("out.path.json", &path, PathFormat::PathJson),
        file("out.path.yaml", &path, PathFormat::NavMsgs),
        file("out.geojson", &path, PathFormat::Geojson),
        file("out.path.svg", &path, PathFormat::Svg),
        file("slices.path.json", &levels, PathFormat::PathJson),
        file("slices.path.svg", &levels, PathFormat::Svg),
    ]
}

/// A tile of fixed size, of which only bytes can be spoiled; half a second each, so it is rare.
pub fn tile() -> File {
    let heights = terrains::hills(1201, 1201, 2, 900.0);
    File { name: "N40W106.hgt".into(), bytes: heights.iter().flat_map(|height| (*height as i16).to_be_bytes()).collect() }
}
